"""The inputs of an app: one table, from which the command's options and their documentation are made.

Names, variables and defaults are those of docker-ros (https://github.com/ika-rwth-aachen/docker-ros), so that its users keep their files.
Values come from the command line, else from the environment, else from a file `.env` in the folder. An empty value counts on the command
line alone, as in `${VARIABLE:-default}`.

A repository's `.env` may be a stranger's, such as a pull request's. It decides what is built. Only the user decides about their rights and
secrets.
"""

from __future__ import annotations

import contextlib
import re
import shlex
from collections.abc import Iterator, Mapping
from dataclasses import Field, dataclass, field, fields
from pathlib import Path
from typing import Any

from rosml.base.errors import RosmlError
from rosml.containerize import env_file

YES, NO = "yes", "no"
"""Whether `.env` may set an input."""

UNPUSHED = "if nothing is pushed; a name without `/`"
"""The same for names of images that are pushed, or that other builds and Docker find."""

WITH_SECRET = "with its secret, or without one"
"""The same for a server that gets a secret: the user who has the secret names the server."""


@dataclass(frozen=True)
class Input:
    name: str  # of the command's option and the action's input, such as `base-image`
    help: str = ""
    default: str = ""
    flag: bool = False
    gone: str = ""  # why an input of docker-ros is not used here, for users
    in_repository: str = YES  # whether `.env` may set it
    repeatable: str = ""  # another name of the option, if it may be repeated

    @property
    def variable(self) -> str:
        return self.name.upper().replace("-", "_")


_RECURSIVE = "take every file of that name in the repository and its upstream sources"


def _text(help: str, default: str | bool = "", in_repository: str = YES, repeatable: str = "") -> Any:
    return field(default=default, metadata={"help": help, "in_repository": in_repository, "repeatable": repeatable})


def _flag(help: str, default: bool = False, in_repository: str = YES) -> Any:
    return _text(help, default, in_repository)


@dataclass(frozen=True, kw_only=True)
class Values:
    """The values of all inputs, in the order of their documentation."""

    base_image: str = _text("the image to build on; without a registry, one of the local registry or of Docker Hub")
    addons: str = _text("add-ons for the base image, separated by commas, such as onnx; onnx-cpu if it has no stack")
    environments: str = _text(
        "environments of Python packages beside ROS, separated by commas, such as lerobot", repeatable="env"
    )
    command: str = _text("what the run image starts, as a shell reads it")
    target: str = _text("images to build, separated by commas: run, dev", "run,dev")
    platform: str = _text("platforms, separated by commas, such as linux/arm64; this machine's own if left out")
    image_name: str = _text("name of the run image; the folder's name if left out", in_repository=UNPUSHED)
    image_tag: str = _text("its tag", "latest", in_repository=UNPUSHED)
    dev_image_name: str = _text("name of the dev image; that of the run image if left out", in_repository=UNPUSHED)
    dev_image_tag: str = _text("its tag; that of the run image with -dev if left out", in_repository=UNPUSHED)
    enable_slim: bool = _flag("also build a slim image to run: on a base image without compilers and headers")
    slim_base_image: str = _text(
        "its base image; the one with -run in its name that belongs to the base image if left out"
    )
    slim_image_name: str = _text("name of the slim image; that of the run image if left out", in_repository=UNPUSHED)
    slim_image_tag: str = _text("its tag; that of the run image with -slim if left out", in_repository=UNPUSHED)
    push: bool = _flag("push the images to the registry that their names begin with", in_repository=NO)
    enable_push_as_latest: bool = _flag("also give the tags latest, latest-dev and latest-slim", in_repository=UNPUSHED)
    ros_distro: str = _text(
        "the ROS distribution, if the base image does not say it; on Debian's ROS 1, the one that conditions in package.xml compare with"
    )
    ros_component: str = _text(
        "what is installed if the base image has no ROS: core, base and others of its distribution", "core"
    )
    disable_ros_installation: bool = _flag(
        "install no ROS on a base image that seems to have none, such as one with a ROS built from its sources"
    )
    base_entrypoint: bool = _flag(
        'call the entrypoint of a base image without ROS before the command, if it is a script that ends in exec "$@"',
        True,
    )
    rmw_implementation: str = _text("the middleware, such as rmw_cyclonedds_cpp: installs it and sets the variable")
    tests: bool = _flag("run the tests of your packages, and make no image if one fails", True)
    downstream_workspace: str = _text(
        "a .repos file with packages that use yours: they are built and tested with yours, and are in no image"
    )
    cmake_args: str = _text("arguments of CMake for all packages", "-DCMAKE_BUILD_TYPE=Release")
    colcon_args: str = _text("arguments of colcon build, such as --executor sequential")
    parallel_jobs: str = _text(
        "how many compilers run at the same time; if left out, as many as cores, and fewer if the builder has less than 2 GB"
        " of memory for each"
    )
    cache: str = _text(
        "repository in a registry that keeps finished stages, for machines that have none; such as ghcr.io/me/robot-cache",
        in_repository=NO,
    )
    skip_keys: str = _text("keys of rosdep that are left out, separated by blanks or commas")
    rosdep_index: str = _text(
        "rosdep's lists: of a registry, such as ghcr.io/me/rosml/rosdep:latest, or of a checkout of ros/rosdistro; the newest"
        " beside the base image if left out",
        in_repository=NO,
    )
    sbom: bool = _flag(
        "attach SBOMs to the images, and lists of files to those to run; in a registry, not in Docker", True
    )
    lock_file: str = _text("what the images are built from, if it is there; --lock writes it", "containerize.lock")
    additional_debs_file: str = _text("packages for apt, one a line", "docker/additional-debs.txt")
    enable_recursive_additional_debs: bool = _flag(_RECURSIVE)
    additional_pip_file: str = _text("requirements for pip, one a line", "docker/additional-pip-requirements.txt")
    enable_recursive_additional_pip: bool = _flag(_RECURSIVE)
    additional_files_dir: str = _text(
        "where the path of files begins that become /docker-ros/additional-files", "docker/additional-files"
    )
    before_dependency_identification_script: str = _text(
        "script that may change the sources before their dependencies are read",
        "docker/before_dependency_identification.sh",
    )
    before_dependency_installation_script: str = _text(
        "script that runs before dependencies are installed", "docker/before_dependency_installation.sh"
    )
    enable_recursive_before_dependency_installation_script: bool = _flag(_RECURSIVE)
    after_dependency_installation_script: str = _text(
        "script that runs after dependencies are installed", "docker/custom.sh"
    )
    enable_recursive_after_dependency_installation_script: bool = _flag(_RECURSIVE)
    blacklisted_packages_file: str = _text("names of ROS packages to leave out", "docker/blacklisted-packages.txt")
    enable_recursive_blacklisted_packages: bool = _flag(_RECURSIVE)
    enable_recursive_vcs_import: bool = _flag("import every .repos file, also of what was imported", True)
    vcs_import_file: str = _text("the .repos file, if not every one is imported", ".repos")
    allow_file_urls: bool = _flag(
        "let your .repos files name repositories of this machine, such as file:///srv/git/driver", in_repository=NO
    )
    allow_mirror_password: bool = _flag(
        "let steps that run code of the repository have the password in the address of your apt mirror",
        in_repository=NO,
    )
    allow_script_secrets: bool = _flag(
        "let the scripts before and after the installation of dependencies have git-https-server, git-https-user and"
        " git-https-password, as variables",
        in_repository=NO,
    )
    git_https_server: str = _text(
        "server of private repositories, without https://", "github.com", in_repository=WITH_SECRET
    )
    git_https_user: str = _text("user on it")
    git_https_password: str = _text("password or token on it; name it in the environment, not on the command line")
    git_ssh_private_key: str = _text("key for private repositories over ssh; name it in the environment")
    git_ssh_known_host_keys: str = _text("what ssh-keyscan says of their servers", in_repository=WITH_SECRET)

    def text(self, name: str) -> str:
        """The text of an input, such as `dev-image-tag`."""
        return _text_of(getattr(self, name.replace("-", "_")))


def _text_of(value: Any) -> str:
    return str(value).lower() if isinstance(value, bool) else str(value)


def _input(item: Field[Any]) -> Input:
    name = item.name.replace("_", "-")
    return Input(name, default=_text_of(item.default), flag=isinstance(item.default, bool), **item.metadata)


_USED = tuple(map(_input, fields(Values)))

_UNUSED = {
    "custom-script-file": "it is after-dependency-installation-script",
    "slim-build-args": "no program is watched to find out what an image needs",
    "additional-slim-build-args": "no program is watched to find out what an image needs",
    "enable-industrial-ci": "tests run here without it; its ROSDEP_SKIP_KEYS, NOT_TEST_BUILD, CMAKE_ARGS and"
    " DOWNSTREAM_WORKSPACE count",
    "buildx-attestations": "an SBOM is attached to images, and is not in them, so that the same sources have the same digest",
    "docker-ros-git-ref": "the version of rosml decides",
}

TABLE = (*_USED, *(Input(name, gone=reason) for name, reason in _UNUSED.items()))
"""All inputs, in the order of their documentation."""

_BY_NAME = {item.name: item for item in _USED}

SECRET = ("git-https-password", "git-ssh-private-key")
"""Inputs that are no options, because other users of the machine can see command lines."""

_SECRET_OF = {"git-https-server": "git-https-password", "git-ssh-known-host-keys": "git-ssh-private-key"}
"""The secrets that servers get, by the inputs that name these."""

_IMAGE = "IMAGE"
"""image-name and image-tag in one, as in docker-ros' local script."""

_INDUSTRIAL_CI = ("ROSDEP_SKIP_KEYS", "NOT_TEST_BUILD")
"""Variables of industrial_ci with another name here."""

FILE = env_file.NAME

_NAMES = {item.variable for item in TABLE} | {_IMAGE, *_INDUSTRIAL_CI}
"""The variables of a file that count, or that are answered."""

_PATTERNS = {
    "ros-distro": ("[a-z][a-z0-9]*|Debian", "name one, such as jazzy"),
    "rmw-implementation": ("rmw_[a-z0-9_]+", "name one, such as rmw_cyclonedds_cpp"),
    "parallel-jobs": ("[1-9][0-9]{0,3}", "name a number, such as 1"),
}
"""Inputs that become part of package names, or numbers in a script: the pattern of their values, and a remedy."""


def default(name: str) -> str:
    return _BY_NAME[name].default


def of_file(folder: Path) -> dict[str, str]:
    """The variables of a folder's `.env`."""
    return env_file.read(folder / FILE, _NAMES)


def values(typed: Mapping[str, str | None], folder: Path, environment: Mapping[str, str]) -> Values:
    """The values of all inputs: from the command line, the environment, or the folder's `.env`."""
    file = folder / FILE
    variables = of_file(folder)
    options = {name: value for name, value in typed.items() if value is not None}
    # If one of them is typed, the other one has its default.
    splits_image = options.keys().isdisjoint(("image-name", "image-tag"))
    of_repository = _by_name(_of_industrial_ci(environment, variables) | variables, splits_image)
    of_person = _by_name(environment, splits_image) | options
    texts = {
        item.name: _checked(item, of_person.get(item.name, of_repository.get(item.name, item.default)))
        for item in _USED
    }
    for name in of_repository:
        if name not in of_person:
            _require_allowed(_BY_NAME[name], texts, of_person, file, variables)
    chosen: dict[str, Any] = {name: text == "true" if _BY_NAME[name].flag else text for name, text in texts.items()}
    return Values(**{name.replace("-", "_"): value for name, value in chosen.items()})


def first_look(name: str, typed: Mapping[str, str], folder: Path, environment: Mapping[str, str]) -> str:
    """The text of one input before any is checked. A `.env` that cannot be read does not count."""
    item = _BY_NAME[name]
    variables: dict[str, str] = {}
    with contextlib.suppress(RosmlError):
        variables = of_file(folder)
    return typed.get(name) or environment.get(item.variable) or variables.get(item.variable) or item.default


def _by_name(variables: Mapping[str, str], splits_image: bool) -> dict[str, str]:
    """The inputs that variables set. With `splits_image`, IMAGE counts before those for its name and tag."""
    texts = {item.name: text for item in _USED if (text := variables.get(item.variable, ""))}
    if splits_image and (image := variables.get(_IMAGE, "")):
        name, colon, tag = image.rpartition(":")
        if not colon or "/" in tag:
            name, tag = image, ""
        texts |= {"image-name": name} | ({"image-tag": tag} if tag else {})
    return texts


def _require_allowed(
    item: Input, values: Mapping[str, str], of_person: Mapping[str, str], file: Path, variables: Mapping[str, str]
) -> None:
    """Checks that a repository's file with these variables may set an input."""
    value, secret = values[item.name], _SECRET_OF.get(item.name, "")
    allowed = {
        YES: True,
        NO: False,
        UNPUSHED: values["push"] == "false" and not ("/" in value and item.name.endswith("-name")),
        WITH_SECRET: not (secret in of_person and values[secret]),
    }
    if allowed[item.in_repository] or value == item.default:
        return
    variable = item.variable if item.variable in variables else _IMAGE
    text = f"{file}:{env_file.line_of(file, variable)}: {variable} is not for a repository to say"
    if secret:
        text += f": {_BY_NAME[secret].variable} is yours, and goes to servers that you name"
    elif values["push"] == "true":
        text += ", as the images are pushed"
    elif item.in_repository == UNPUSHED:
        text += ", as it names a place of its own: a name without / is enough here"
    typed = "" if item.flag else f" {shlex.quote(value)}"
    raise RosmlError(text, f"if you want it, type --{item.name}{typed}; or remove the line", exit_code=2)


def _of_industrial_ci(environment: Mapping[str, str], file: Mapping[str, str]) -> dict[str, str]:
    """The variables of industrial_ci, by our names, if the user has switched it on."""
    variables = {**file, **environment}
    if variables.get("ENABLE_INDUSTRIAL_CI", "").lower() != "true":
        return {}
    untested = variables.get("NOT_TEST_BUILD", "").lower() == "true"
    return {"SKIP_KEYS": variables.get("ROSDEP_SKIP_KEYS", ""), "TESTS": "false" if untested else ""}


def _checked(item: Input, value: str) -> str:
    """A value, which may become words of a shell, or part of a package name."""
    if item.flag:
        if value.lower() not in ("true", "false"):
            raise RosmlError(f"{item.name} is true or false, not {value!r}", f"check {item.variable}", exit_code=2)
        return value.lower()
    if item.name in ("cmake-args", "colcon-args"):
        problem, remedy = _problem_of_words(value), "write it as a shell reads it, such as -DNAME='a;b'"
    else:
        pattern, remedy = _PATTERNS.get(item.name, ("(?s:.*)", ""))
        problem = "" if not value or re.fullmatch(pattern, value) else "that is none"
    if problem:
        raise RosmlError(f"{item.name}: {value!r}: {problem}", remedy, exit_code=2)
    return value


def _problem_of_words(text: str) -> str:
    """Why a shell cannot read a text as plain words; empty if it can."""
    place = 0
    while place < len(text):
        if text[place] in env_file.BLANKS:
            place += 1
            continue
        piece = env_file.PIECE.match(text, place)
        if piece is None:
            return "its quotation has no end"
        begins = place == 0 or text[place - 1] in env_file.BLANKS
        if special := re.search(r"^#|[;|&()<>`]" if begins else "[;|&()<>`]", piece[4] or ""):
            return f"{special[0]} needs quotes"
        place = piece.end()
    return ""


def answers(folder: Path, environment: Mapping[str, str]) -> Iterator[str]:
    """A sentence for each set variable that has no effect: an input of docker-ros, or an unknown name in the file."""
    variables = of_file(folder)
    for item in TABLE:
        if item.gone and (environment.get(item.variable) or variables.get(item.variable)):
            yield f"{item.variable} is not used: {item.gone}"
    yield from (f"{name} in {FILE} is not used: there is no such input" for name in variables if name not in _NAMES)
