"""The texts of the files that `rosml init` writes."""

from __future__ import annotations

import json
import re
import shlex
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field

from rosml.base.errors import RosmlError
from rosml.containerize import ignored_files
from rosml.containerize import inputs as app_inputs
from rosml.containerize.packages import workspace
from rosml.images.matrix.model import Matrix
from rosml.run import defaults

DOCKERFILE = "Dockerfile"
GITHUB = ".github/workflows/images.yml"
GITLAB = ".gitlab-ci.yml"

INSTALLED = "/docker-ros/ws/install"

CATKIN = "devel devel_isolated install_isolated"
"""Folders that catkin makes beside those that every build makes."""

PAGE = "docs/containerize.md"

FORGES = {"github": GITHUB, "gitlab": GITLAB}

AS_IT_IS = ("command",)
"""The inputs in which containerize/gitlab.yml lets GitLab expand no variable. In others, `$$` is one `$`."""


@dataclass(frozen=True)
class Project:
    """What the files say. `place` is the registry with the path before the base image's `tag`, empty if only this machine has it; `images`
    is where CI pushes, empty for the repository's own place. `source` and `revision` are rosml's on that forge. Paths are relative. `locked`
    is the base image as the lock file names it, if it is this one."""

    name: str
    tag: str
    place: str
    ros: int
    gpu: bool
    command: str
    ended: bool
    pip: tuple[str, ...]
    repos: str
    is_one_of_several: bool
    packages: tuple[str, ...]
    forge: str
    source: str
    revision: str
    images: str = ""
    keys: tuple[str, ...] = ()
    addons: tuple[str, ...] = ()
    additional: Mapping[str, str] = field(default_factory=dict)
    locked: str = ""

    @property
    def base_image(self) -> str:
        if self.locked:
            return self.locked
        return f"{self.place}/{self.tag}" if self.place else self.tag

    @property
    def dev_image(self) -> str:
        return f"{self.name}:{app_inputs.default('image-tag')}-dev"


def image_name(folder: str) -> str:
    """The name of a folder as the name of an image: small letters and digits, with single separators."""
    text = re.sub(r"[^a-z0-9._-]+", "-", folder.lower())
    return re.sub(r"([._-])[._-]*", r"\1", text).strip("._-") or "app"


def repos_of(lists: Sequence[str], matrix: Matrix, distribution: str) -> str:
    """The path of the list of upstream repositories for a distribution: the one with its name, or the only one without a name of any;
    empty if there is none, or more than one."""

    def names(rows: Iterable[str]) -> set[str]:
        return {word for row in rows for word in (row, matrix.distributions[row].ros_distro) if word}

    words = {path: set(re.split(r"[^a-z0-9]+", path.rpartition("/")[2].lower())) for path in lists}
    with_name = [path for path in lists if words[path].intersection(names([distribution]))]
    without_any = [path for path in lists if not words[path].intersection(names(matrix.distributions))]
    fitting = with_name or without_any
    return fitting[0] if len(fitting) == 1 else ""


def texts(project: Project) -> dict[str, str]:
    """The texts of the files, by their paths in the folder. A name with a line break or another control character is refused."""
    _require_lines(project)
    by_path = {
        DOCKERFILE: _dockerfile(project),
        ".dockerignore": _lines(_dockerignore(project)),
        app_inputs.FILE: _lines(_env(project)),
        defaults.PROJECT: _lines(_defaults(project)),
    }
    if project.forge in FORGES:
        by_path[FORGES[project.forge]] = _lines(_github(project) if project.forge == "github" else _gitlab(project))
    return by_path


def _require_lines(project: Project) -> None:
    for value in vars(project).values():
        for text in [*value.values()] if isinstance(value, dict) else value if isinstance(value, tuple) else (value,):
            if isinstance(text, str) and (odd := re.search(r"[\x00-\x1f\x7f\x85\u2028\u2029]", text)):
                message = f"{text[:100]!a} has the character {odd[0]!a}, and a file has one line for it"
                raise RosmlError(message, "rename it in the repository", exit_code=2)


def lacking(path: str, text: str, project: Project) -> Iterator[tuple[str, str]]:
    """What a file with this text lacks, and what to write into it."""
    if path == DOCKERFILE:
        start_line = rf"^\s*(ARG|FROM)\b.*({re.escape(project.tag)}|\bBASE_IMAGE\b)"
        if not re.search(start_line, text, re.MULTILINE | re.IGNORECASE):
            start = f"FROM {project.base_image}" if project.place else "ARG BASE_IMAGE and FROM ${BASE_IMAGE}"
            yield f"does not start from {project.base_image}", f"write {start}"
        if not re.search(r"\brosdep\s+(\\\s+)*install\b", text):
            yield "does not call rosdep install", "let a RUN call it"
        elif lost := [key for key in project.keys if key not in text]:
            keys = shlex.quote(" ".join(project.keys))
            yield f"lets rosdep install {' '.join(lost)}, which the base image has", f"add --skip-keys {keys}"
    elif path in FORGES.values() and "containerize" not in text:
        step, include = f"the step uses: {project.source}/containerize", "an include of containerize/gitlab.yml"
        yield "does not use rosml containerize", f"add {step if path == GITHUB else include}"


def _lines(lines: Iterator[str]) -> str:
    return "".join(f"{line}\n" for line in lines)


# ---- What rosml reads ------------------------------------------------------------------------------------------------


def variables(project: Project) -> dict[str, str]:
    values = {"BASE_IMAGE": project.base_image, "COMMAND": project.command, "IMAGE_NAME": project.name}
    if project.addons:
        values["ADDONS"] = ",".join(project.addons)
    for name, path in project.additional.items():
        if path != app_inputs.default(name):
            values[name.upper().replace("-", "_")] = path
    if project.pip and project.additional.get("additional-pip-file", project.pip[0]) in project.pip:
        values["ADDITIONAL_PIP_FILE"] = project.pip[0]
        if len(project.pip) > 1:
            values |= {"ADDITIONAL_PIP_FILE": workspace.PIP, "ENABLE_RECURSIVE_ADDITIONAL_PIP": "true"}
    if project.keys:
        values["SKIP_KEYS"] = " ".join(project.keys)
    if project.repos and project.is_one_of_several:
        values |= {"ENABLE_RECURSIVE_VCS_IMPORT": "false", "VCS_IMPORT_FILE": project.repos}
    return values


def _env(project: Project) -> Iterator[str]:
    yield f"# Inputs of rosml containerize ({PAGE}). Each can be an option instead: --base-image."
    for name, value in variables(project).items():
        yield assigned(name, value)


def assigned(name: str, value: str) -> str:
    """A line of `.env`, which a shell and `env_file.read` read alike."""
    return f"{name}={shlex.quote(value)}"


def _defaults(project: Project) -> Iterator[str]:
    yield "# Defaults of rosml run in this folder (docs/run/defaults.md): it enters the image to work in, with the folder as"
    yield "# /docker-ros/ws/src/target. rosml containerize makes that image. rosml asks you once whether to allow this file."
    yield f"image = {json.dumps(project.dev_image)}"
    yield 'options = ["--mws"]'


# ---- What Docker reads -----------------------------------------------------------------------------------------------


def _dockerignore(project: Project) -> Iterator[str]:
    yield "# What neither rosml containerize nor docker build gets."
    yield from (".git", "**/__pycache__", ".venv", ".vscode")
    tops = {folder.split("/")[0] for folder in project.packages}
    yield from sorted({*ignored_files.OUTPUT_FOLDERS, *CATKIN.split()} - tops)
    yield "# Files that change no image: without them here, each change would build everything again."
    yield from (app_inputs.FILE, defaults.PROJECT, DOCKERFILE, ".dockerignore", ".github", GITLAB)


_CACHES = (
    "--mount=type=cache,target=/var/cache/apt,sharing=locked",
    "--mount=type=cache,target=/var/lib/apt/lists,sharing=locked",
    "--mount=type=cache,target=/root/.ros/rosdep,sharing=locked",
    "--mount=type=cache,target=/root/.cache/pip,sharing=locked",
)
"""Folders that are kept for the next build, and are in no layer."""


def _dockerfile(project: Project) -> str:
    default = f"={project.base_image}" if project.place else ""
    head = [
        *([] if default else ["# check=skip=InvalidDefaultArgInFrom"]),
        "# Builds with Docker alone. rosml containerize does not read this file.",
        f"#   docker build {'' if default else '--build-arg BASE_IMAGE=… '}-t {project.name} .",
        f"#   docker run --rm -it {'--gpus all ' if project.gpu else ''}-e DOCKER_UID=$(id -u) -e DOCKER_GID=$(id -g) {project.name}",
        f"ARG BASE_IMAGE{default}",
    ]
    build = [
        "FROM ${BASE_IMAGE} AS build",
        _install(project, ""),
        "COPY --from=sources /src /docker-ros/ws/src",
        "RUN /entrypoint.sh colcon build --cmake-args -DCMAKE_BUILD_TYPE=Release",
    ]
    tests = "colcon test && colcon test-result --verbose"
    if project.ros == 1:  # catkin builds them by a target of their own
        tests = f"colcon build --cmake-target tests --cmake-target-skip-unavailable && /entrypoint.sh {tests}"
    test = ["# docker build --target test .", "FROM build AS test", f"RUN /entrypoint.sh {tests}"]
    needs_shell = re.search(r"[;&|<>$`(){}*?#~\n\\]", project.command)
    words = ["bash", "-c", project.command] if needs_shell else shlex.split(project.command)
    run = [
        "# The image to run: without what only the build needs.",
        "FROM ${BASE_IMAGE} AS run",
        _install(project, " --dependency-types exec"),
        f"COPY --from=build {INSTALLED} {INSTALLED}",
        f"CMD {json.dumps(words)}",
    ]
    stages = [head, *_source_stages(project), build, test, run]
    return "\n\n".join("\n".join(stage) for stage in stages) + "\n"


def _source_stages(project: Project) -> Iterator[list[str]]:
    if project.repos:
        yield [
            "FROM ${BASE_IMAGE} AS upstream",
            f"COPY {json.dumps([_of_docker(project.repos), '/upstream.repos'])}",
            "RUN mkdir /upstream && vcs import --input /upstream.repos /upstream",
        ]
        yield ["FROM scratch AS sources", "COPY --from=upstream /upstream /src/upstream", "COPY . /src/target"]
    else:
        yield ["FROM scratch AS sources", "COPY . /src/target"]
    names = sorted({file.rpartition("/")[2] for file in (*_pip(project), *_debs(project))})
    kept = " ".join(f"! -name {shlex.quote(name)}" for name in ("package.xml", "*_IGNORE", *names))
    yield [
        "# Only the files that name dependencies: a change of any other file installs nothing again.",
        "FROM ${BASE_IMAGE} AS manifests",
        "COPY --from=sources /src /src",
        f"RUN find /src ! -type d {kept} -delete && find /src -type d -empty -delete",
    ]


def _pip(project: Project) -> list[str]:
    return list(dict.fromkeys((*project.pip, *_list_of(project, "additional-pip-file"))))


def _debs(project: Project) -> list[str]:
    return _list_of(project, "additional-debs-file")


def _list_of(project: Project, name: str) -> list[str]:
    return [project.additional[name]] if name in project.additional else []


def _of_docker(path: str) -> str:
    """A path in COPY, of which Docker expands variables."""
    return re.sub(r"([\\$])", r"\\\1", path)


_PLAIN = r"-e 's/(^|[[:space:]])#.*//' " r'-e "s/[$]([{]ROS_DISTRO[}]|ROS_DISTRO\b)/$ROS_DISTRO/g"'
"""What sed does to a list of packages for apt: it has no comments, and the distribution's name."""


def _copied(file: str) -> str:
    return shlex.quote(f"/run/src/target/{file}")


def _install(project: Project, options: str) -> str:
    mounts = ("--mount=type=bind,from=manifests,source=/src,target=/run/src", *_CACHES)
    update = "rosdep update --include-eol-distros" if project.ended else "rosdep update"
    skipped = f" --skip-keys {shlex.quote(' '.join(project.keys))}" if project.keys else ""
    steps = [
        "export DEBIAN_FRONTEND=noninteractive",
        "apt-get update",
        update,
        f"rosdep install --from-paths /run/src --ignore-src -y{options}{skipped}",
        *(
            f"sed -E {_PLAIN} {_copied(file)} | xargs -r apt-get install -y --no-install-recommends"
            for file in _debs(project)
        ),
        *(f"pip install -r {_copied(file)}" for file in _pip(project)),
    ]
    return " \\\n    ".join([f"RUN {mounts[0]}", *mounts[1:], " \\\n && ".join(steps)])


# ---- CI --------------------------------------------------------------------------------------------------------------


def _github(project: Project) -> Iterator[str]:
    yield f"# Builds and tests the packages of this repository, and pushes their images ({PAGE}, On GitHub)."
    yield "name: images"
    yield "on: [push, pull_request]"
    yield "permissions: {}"
    yield "jobs:"
    yield "  images:"
    yield "    runs-on: ubuntu-24.04"
    yield "    permissions:"
    yield "      contents: read # the checkout"
    yield "      packages: write # the images"
    yield "    steps:"
    loose = "" if len(project.revision) == 40 else " # better: a commit"
    yield f"      - uses: {project.source}/containerize@{project.revision}{loose}"
    yield "        with:"
    yield f"          base-image: {json.dumps(project.base_image)}"
    yield from (f"          {name}: {json.dumps(value)}" for name, value in _pushed(project))
    for name, value in _inputs(project).items():
        yield f"          {name}: {json.dumps(_of_github(value))}"
    yield "          push: ${{ github.event_name != 'pull_request' }} # a fork's job may not push"


def _gitlab(project: Project) -> Iterator[str]:
    yield f"# Builds and tests the packages of this repository, and pushes their images ({PAGE}, On GitLab)."
    yield "include:"
    yield f"  - project: {json.dumps(project.source)}"
    yield "    file: containerize/gitlab.yml"
    yield f"    ref: {json.dumps(project.revision)}"
    yield "    inputs:"
    yield f"      rosml-url: {json.dumps('$CI_SERVER_URL/' + project.source + '.git')}"
    yield f"      rosml-ref: {json.dumps(project.revision)}"
    yield f"      base-image: {json.dumps(project.base_image)}"
    yield from (f"      {name}: {json.dumps(value)}" for name, value in _pushed(project))
    for name, value in _inputs(project).items():
        yield f"      {name}: {json.dumps(value if name in AS_IT_IS else value.replace('$', '$$'))}"


def _of_github(value: str) -> str:
    """A text of the repository in which GitHub finds no expression: https://docs.github.com/actions/reference/workflows-and-actions/expressions"""
    return value.replace("${{", "${{ '${{' }}")


def other_registry(project: Project) -> str:
    """The registry to which CI pushes if the forge's own token is not for it; else empty."""
    host = project.images.partition("/")[0]
    return host if project.forge in FORGES and not (project.forge == "github" and host == "ghcr.io") else ""


def _pushed(project: Project) -> Iterator[tuple[str, str]]:
    """The inputs that say where CI pushes, if it is not the repository's own place. GitLab takes variables by themselves."""
    if project.images:
        yield "image-name", project.images
    if host := other_registry(project):
        yield "registry", host
        if project.forge == "github":
            yield "registry-user", "${{ secrets.REGISTRY_USER }}"
            yield "registry-password", "${{ secrets.REGISTRY_PASSWORD }}"


def _inputs(project: Project) -> dict[str, str]:
    """The inputs beside the base image and the run image's name, which CI or the user chooses. Their texts are the repository's."""
    values = {name.lower().replace("_", "-"): value for name, value in variables(project).items()}
    return {name: value for name, value in values.items() if name not in ("base-image", "image-name")}
