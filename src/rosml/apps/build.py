"""An app built: its part, and the images that are joined from it and a base image."""

from __future__ import annotations

import json
import re
import shutil
import subprocess
import time
from collections.abc import Callable, Iterator, Mapping
from dataclasses import asdict, dataclass, field
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from rosml import ROOT
from rosml.apps import base as bases
from rosml.apps import junit, sources, workspace
from rosml.apps.git import Access
from rosml.base import files
from rosml.base.errors import RosmlError
from rosml.base.units import duration
from rosml.build.push import COMPRESSION
from rosml.images.labels import PREFIX, REVISION, TITLE
from rosml.machine import buildx
from rosml.machine.base_images import native_architecture
from rosml.machine.services import Services

TARGETS = ("run", "dev")
"""Images that an app can have: to run it, and to work on it."""

BASE_NAME = "org.opencontainers.image.base.name"
BASE_DIGEST = "org.opencontainers.image.base.digest"

TIME = 1767225600
"""2026-01-01T00:00:00Z: of images whose sources are in no commit."""


@dataclass(frozen=True)
class Made:
    """An image that was made. `digest` is that in the registry, or its id in Docker."""

    target: str
    reference: str
    digest: str


@dataclass
class Built:
    """What building an app came to.

    Attributes:
        base: the base image by its digest.
        images: what was made.
        packages: ROS packages of the app. keys: what each key of rosdep became.
        installed: packages of the operating system that the run image has beyond its base.
        changed: files of the base image that these packages change.
        upstream: repositories that were imported.
        tests: of the packages. reports: folder of their JUnit files.
        seconds: what it took.
    """

    base: str
    images: list[Made] = field(default_factory=list)
    packages: list[str] = field(default_factory=list)
    keys: dict[str, Any] = field(default_factory=dict)
    installed: list[str] = field(default_factory=list)
    changed: list[str] = field(default_factory=list)
    upstream: list[Any] = field(default_factory=list)
    tests: junit.Tests = field(default_factory=junit.Tests)
    reports: str = ""
    seconds: float = 0.0

    def to_json(self) -> dict[str, Any]:
        """For `--json`."""
        return asdict(self)

    def summary(self) -> Iterator[tuple[str, str]]:
        """What people are told at the end: what about, and a sentence."""
        yield (
            "app",
            f"{_count(len(self.packages), 'ROS package')}, {_count(len(self.installed), 'package')} that the base lacks",
        )
        tests = self.tests
        if tests.count:
            yield "tests", f"{tests.count - tests.skipped} passed, {tests.skipped} skipped; reports: {self.reports}"
        yield "time", duration(self.seconds)


class App:
    """One repository with ROS packages, on its way to images.

    Args:
        folder: the repository.
        values: of all inputs, as `inputs.values` gives them.
        environment: of the process.
        services: builder and registry of this machine.
        say: tells people what begins now.
    """

    def __init__(
        self,
        folder: Path,
        values: Mapping[str, str],
        environment: Mapping[str, str],
        services: Services,
        say: Callable[[str], None],
    ) -> None:
        self._folder, self._values, self._environment = folder, values, environment
        self._services, self._say = services, say
        self._targets = _listed(values["target"], TARGETS, "target")
        self._platforms = listed_platforms(values["platform"])
        self._name = _image_name(values["image-name"] or folder.name.lower())
        if "run" in self._targets and not values["command"]:
            raise RosmlError(
                "there is no command for the run image", "add --command 'ros2 launch …', or --target dev", exit_code=2
            )
        if not values["base-image"]:
            raise RosmlError("there is no base image", "add --base-image, such as ros:jazzy-base", exit_code=2)
        self._require_place()
        self._state = services.state / "containerize" / re.sub(r"[/:]", "-", self._name)

    @property
    def report(self) -> Path:
        """Folder of what the build says of the app, with `results` of its tests; one for each platform if there are several."""
        return self._state / "report"

    def build(self) -> Built:
        """Builds the images.

        Raises:
            RosmlError: an input is wrong, or a step failed.
        """
        started = time.monotonic()
        base = bases.find(self._values["base-image"], self._services, self._platforms)
        distribution = self._values["ros-distro"] or base.environment.get("ROS_DISTRO", "")
        if not distribution:
            raise RosmlError(
                f"{base.name} does not say which ROS it has", "add --ros-distro, such as jazzy", exit_code=2
            )
        self._say(f"base image {base.name}")
        built = Built(base.reference)
        upstream = self._state / "upstream"
        built.upstream = self._import(upstream)
        count = workspace.write_manifests({"target": self._folder, "upstream": upstream}, self._state / "manifests")
        workspace.write_requests(self._values, self._folder, upstream, base.environment, self._state / "requests")
        self._say(f"{_count(count, 'package')} for {', '.join(self._platforms)}")
        file = self._write_bake(base, distribution, upstream)
        report = self.report
        shutil.rmtree(report, ignore_errors=True)
        buildx.run(self._services, buildx.Bake("report", f"containerize-{self._state.name}", file))
        self._read(report, built)
        self._require_passed(built)
        for target in self._targets:
            call = buildx.Bake(target, f"containerize-{self._state.name}-{target}", file)
            _progress, metadata = buildx.run(self._services, call)
            built.images.append(Made(target, self._reference(target), metadata.get("containerimage.digest", "")))
        built.seconds = time.monotonic() - started
        return built

    def _import(self, out: Path) -> list[Any]:
        values = self._values
        access = Access(
            https_server=values["git-https-server"],
            https_user=values["git-https-user"],
            https_password=values["git-https-password"],
            ssh_key=values["git-ssh-private-key"],
            ssh_known_hosts=values["git-ssh-known-host-keys"],
        )
        out.mkdir(parents=True, exist_ok=True)
        return sources.fetch(
            self._folder,
            out,
            self._services.state / "cache" / "git",
            access,
            recursive=values["enable-recursive-vcs-import"] == "true",
            file=values["vcs-import-file"],
            say=self._say,
        )

    def _reference(self, target: str) -> str:
        """The full name of an image, with its tag."""
        values = self._values
        name, tag = self._name, values["image-tag"]
        if target == "dev":
            name = _image_name(values["dev-image-name"]) if values["dev-image-name"] else name
            tag = values["dev-image-tag"] or f"{tag}-dev"
        if not re.fullmatch(r"[A-Za-z0-9_][A-Za-z0-9_.-]{0,127}", tag):
            raise RosmlError(f"{tag!r} is no tag of an image", "take letters, digits, points and hyphens", exit_code=2)
        return f"{name}:{tag}" if has_registry(name) or self._loads else f"{self._services.registry}/{name}:{tag}"

    @property
    def _loads(self) -> bool:
        """Whether images go to Docker, and to no registry."""
        return self._values["push"] == "false" and self._services.builder_kind != "buildkitd"

    def _require_place(self) -> None:
        """Checks that the images have a place to go to.

        Raises:
            RosmlError: they have none (exit code 2).
        """
        names = [self._reference(target).rpartition(":")[0] for target in self._targets]
        local = f"{self._services.registry}/"
        if self._values["push"] == "true":
            for name in names:
                if not has_registry(name):
                    raise RosmlError(f"{name} names no registry", "name one, such as ghcr.io/me/robot", exit_code=2)
        elif self._loads and len(self._platforms) > 1:
            raise RosmlError("Docker holds images of one platform", "name one platform, or add --push", exit_code=2)
        elif not self._loads:
            for name in names:
                if not name.startswith(local):
                    text = f"there is no Docker here that could hold {name}"
                    raise RosmlError(text, "add --push, or leave the registry out of the name", exit_code=2)

    def _tags(self, target: str) -> list[str]:
        tags = [self._reference(target)]
        if self._values["enable-push-as-latest"] == "true":
            latest = "latest" if target == "run" else "latest-dev"
            tags.append(f"{tags[0].rpartition(':')[0]}:{latest}")
        return list(dict.fromkeys(tags))

    def _write_bake(self, base: bases.Base, distribution: str, upstream: Path) -> Path:
        """The bake file of this app."""
        values, scripts = self._values, ROOT / "components"
        empty = self._state / "empty"
        empty.mkdir(parents=True, exist_ok=True)
        additional = self._folder / values["additional-files-dir"]
        index = Path(values["rosdep-index"]).expanduser() if values["rosdep-index"] else empty
        if not index.is_dir():
            raise RosmlError(
                f"rosdep-index: there is no folder {index}", "name a checkout of ros/rosdistro", exit_code=2
            )
        hooked = (self._state / "requests/identification.sh").stat().st_size > 0
        secrets = [
            f"type=env,id={name},env={variable}"
            for name, variable in (("os-apt-mirror", "OS_APT_MIRROR"), ("ros-apt-mirror", "ROS_APT_MIRROR"))
            if self._environment.get(variable)
        ]
        if self._services.ca_bundle:
            secrets.append(f"type=file,id=ca-bundle,src={self._services.ca_bundle}")
        contexts = {
            "base": f"docker-image://{base.reference}",
            "scripts": str(scripts),
            "manifests": str(self._state / "manifests"),
            "target": str(self._folder),
            "upstream": str(upstream),
            "requests": str(self._state / "requests"),
            "additional": str(additional if additional.is_dir() else empty),
            "rosdep": str(index),
        }
        common = {
            "context": str(empty),
            "dockerfile": str(scripts / "containerize/Dockerfile"),
            "platforms": list(self._platforms),
            "secret": secrets,
            "contexts": contexts,
            "args": {
                "CMAKE_ARGS": values["cmake-args"],
                "SKIP_KEYS": values["skip-keys"],
                "ROSDEP_DAY": f"{datetime.now(UTC):%F}",
                "ROS_DISTRO": distribution,
                "MANIFESTS": "changed" if hooked else "manifests",
                "TESTS": "results" if values["tests"] == "true" else "untested",
            },
        }
        output = "type=docker" if self._loads else f"type=image,push=true,{COMPRESSION}"
        report = {"target": "report", "output": [f"type=local,dest={self.report}"]}
        targets: dict[str, Any] = {"report": {**common, **report}}
        for stage in ("app", "workspace"):
            targets[stage] = {**common, "target": stage}
        for target in self._targets:
            targets[target] = {
                "context": str(empty),
                "dockerfile-inline": self._dockerfile(target),
                "platforms": list(self._platforms),
                "contexts": {
                    "base": contexts["base"],
                    "app": "target:app",
                    "workspace": "target:workspace",
                },
                "args": {"SOURCE_DATE_EPOCH": str(self._time())},
                "labels": self._labels(base, target),
                "tags": self._tags(target),
                "output": [output],
            }
        file = self._state / "bake.json"
        files.write(file, json.dumps({"target": targets}, indent=2) + "\n")
        return file

    def _dockerfile(self, target: str) -> str:
        """How an image is joined: nothing runs."""
        lines = ["FROM base", "COPY --link --from=app / /"] if target == "run" else ["FROM workspace"]
        variables = {"WORKSPACE": "/docker-ros/ws"}
        if self._values["ros-distro"]:
            variables["ROS_DISTRO"] = self._values["ros-distro"]
        if self._values["rmw-implementation"]:
            variables["RMW_IMPLEMENTATION"] = self._values["rmw-implementation"]
        command = ["bash"]
        if target == "run":
            variables["DEFAULT_CMD"] = self._values["command"]
            # bash becomes a simple command, so that this gets the signals.
            command = ["bash", "-c", 'exec bash -c "$DEFAULT_CMD"']
        lines += [f"ENV {name}={_quoted(value)}" for name, value in variables.items()]
        return "\n".join([*lines, f"CMD {json.dumps(command)}", ""])

    def _labels(self, base: bases.Base, target: str) -> dict[str, str]:
        return {
            TITLE: self._name if target == "run" else f"{self._name} ({target})",
            BASE_NAME: base.name,
            BASE_DIGEST: base.digest,
            REVISION: self._git("rev-parse", "HEAD"),
            f"{PREFIX}app": target,
        }

    def _time(self) -> int:
        """Of the commit that is checked out."""
        return int(self._git("log", "-1", "--format=%ct") or TIME)

    def _git(self, *arguments: str) -> str:
        """What git says of the folder; nothing where it is in no repository."""
        try:
            done = subprocess.run(
                ["git", "-C", str(self._folder), *arguments], capture_output=True, text=True, check=False
            )
        except OSError:
            return ""
        return done.stdout.strip() if done.returncode == 0 else ""

    def _read(self, report: Path, built: Built) -> None:
        """What the build says of the app; of the first platform where there are several."""
        folder = report if len(self._platforms) == 1 else report / self._platforms[0].replace("/", "_")
        try:
            dependencies = json.loads((folder / "dependencies.json").read_text())
            app = json.loads((folder / "app.json").read_text())
        except (OSError, ValueError) as error:
            raise RosmlError(f"the build left no report: {error}", "run it again") from None
        built.packages, built.keys = list(dependencies["packages"]), dependencies["keys"]
        built.installed, built.changed = app["packages"], app["changed"]
        for one in [report] if len(self._platforms) == 1 else sorted(report.iterdir()):
            built.tests = junit.add(built.tests, junit.read(one / "results"))
        built.reports = str(report / "results")

    def _require_passed(self, built: Built) -> None:
        """Checks that no test failed.

        Raises:
            RosmlError: one did; no image is made.
        """
        tests = built.tests
        if tests.failures:
            shown = "".join(f"\n    {line}" for line in tests.failures)
            raise RosmlError(
                f"{len(tests.failures)} of {tests.count} tests failed; no image was made{shown}\n  reports: {built.reports}",
                "correct the packages or their tests; --no-tests makes the images without asking them",
            )


def _count(number: int, what: str) -> str:
    return f"{number} {what}{'' if number == 1 else 's'}"


def _listed(text: str, known: tuple[str, ...], what: str) -> tuple[str, ...]:
    found = [word.strip() for word in text.split(",") if word.strip()]
    for word in found:
        if word not in known:
            raise RosmlError(f"{word!r} is no {what}", f"there are: {', '.join(known)}", exit_code=2)
    return tuple(name for name in known if name in found)


def listed_platforms(text: str) -> tuple[str, ...]:
    """Platforms as BuildKit names them; docker-ros' users write only the architecture."""
    names = [word.strip() for word in text.split(",") if word.strip()] or [native_architecture()]
    return tuple(dict.fromkeys(name if "/" in name else f"linux/{name}" for name in names))


def has_registry(name: str) -> bool:
    """Whether the name of an image begins with a registry."""
    host = name.split("/")[0]
    return "/" in name and (re.search(r"[.:]", host) is not None or host == "localhost")


def _image_name(text: str) -> str:
    """A name of an image without its tag.

    Raises:
        RosmlError: it is none (exit code 2).
    """
    if not re.fullmatch(r"[a-z0-9.:-]+(/[a-z0-9._-]+)*|[a-z0-9._-]+", text) or re.search(r":[^/]*$", text):
        raise RosmlError(
            f"{text!r} is no name of an image", "add --image-name: small letters, digits, and hyphens", exit_code=2
        )
    return text


def _quoted(text: str) -> str:
    """A value as ENV of a Dockerfile takes it, with nothing expanded."""
    return '"' + re.sub(r'(["\\$])', r"\\\1", text).replace("\n", "\\\n") + '"'
