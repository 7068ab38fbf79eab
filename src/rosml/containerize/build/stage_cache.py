"""A cache of finished stages of an app's build, in a registry, for machines that have none of them.

Each slow stage is an image. Its tag is a digest of everything that decides its content. A build computes these tags and takes
the images that exist instead of their stages. Once its tests have passed, a build's report is kept beside them.
"""

from __future__ import annotations

import functools
import hashlib
import json
import os
import stat
from collections.abc import Container, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from pydantic import ConfigDict, Field

from rosml.base import untrusted
from rosml.base.errors import RosmlError
from rosml.base.shapes import Shape
from rosml.containerize.build.junit import Tests
from rosml.containerize.build.outcome import Outcome
from rosml.containerize.within import SECRET
from rosml.registry import bases, oci, references
from rosml.registry.client import Registry
from rosml.registry.documents import Descriptor

IDENTIFIED = "identified"
"""The stage that finds the packages that the sources need."""

BASE = "base"
"""The stage that installs ROS on an image without it."""

ADOPTED = "adopted"
"""The value that decides this stage."""

REPORT = "report"
"""The beginning of a report's tag."""

_TYPE = "application/vnd.rosml.app.report.v1+json"
_DETAIL = "application/octet-stream"
_TITLE = "org.opencontainers.image.title"


@dataclass(frozen=True)
class Keys:
    """Digests of the inputs of stages.

    Attributes:
        environment: for the installed dependencies.
        upstream: for the built upstream packages.
        app: for the whole app.
        slim: there are stages of a slim image.
        base: for a base on which ROS was installed; empty if it had ROS.
    """

    environment: str
    upstream: str
    app: str
    slim: bool
    base: str = ""

    @property
    def stages(self) -> Mapping[str, str]:
        """The tag of each stage, by its name in the Dockerfile."""
        environment = (IDENTIFIED, "environment", "runtime", *(["slim-runtime"] if self.slim else []))
        return {
            **({BASE: f"{BASE}-{self.base}"} if self.base else {}),
            **{name: f"{name}-{self.environment}" for name in environment},
            "upstream-built": f"upstream-{self.upstream}",
            **{name: f"{name}-{self.app}" for name in ("app", "workspace", *(["slim-app"] if self.slim else []))},
        }

    @property
    def report(self) -> str:
        """The tag of the report."""
        return f"{REPORT}-{self.app}"


@dataclass(frozen=True)
class StageInputs:
    """All that decides the content of stages.

    Attributes:
        values: values that decide which packages are installed, and from where.
        dependencies: folders that decide the same.
        upstream, target, downstream: folders with sources.
        arguments: the arguments of CMake and of colcon.
        tests: whether tests run, as text.
        hooked: a script changes the sources before their dependencies are read, so all sources decide the dependencies.
    """

    values: Mapping[str, Any]
    dependencies: Sequence[Path]
    upstream: Path
    target: Path
    downstream: Path
    arguments: str
    tests: str
    hooked: bool

    def keys(self) -> Keys:
        upstream, target = (tree(folder, SECRET) for folder in (self.upstream, self.target))
        dependencies = [tree(folder) for folder in self.dependencies]
        environment = _digest(self.values, dependencies, [upstream, target] if self.hooked else [])
        built = _digest(environment, upstream, self.arguments, target if self.hooked else "")
        app = _digest(built, target, tree(self.downstream, SECRET), self.tests)
        base = _digest([self.values.get(name) for name in ("base", "platforms", ADOPTED)])
        return Keys(environment, built, app, bool(self.values.get("slim")), base if self.values.get(ADOPTED) else "")


def tree(folder: Path, without: Container[str] = ()) -> str:
    """The digest of a folder and everything below it: names, modes, contents and links. Times do not count.

    Args:
        without: names of files and folders to leave out, at any depth.
    """
    total = hashlib.sha256()
    for path in _paths(folder, without):
        facts = path.lstat()
        total.update(os.fsencode(path.relative_to(folder)) + b"\0")
        if stat.S_ISLNK(facts.st_mode):
            total.update(b"link " + os.fsencode(os.readlink(path)) + b"\0")
            continue
        total.update(f"{stat.S_IFMT(facts.st_mode):o} {stat.S_IMODE(facts.st_mode):o}".encode() + b"\0")
        if stat.S_ISREG(facts.st_mode):
            with path.open("rb") as file:
                total.update(hashlib.file_digest(file, "sha256").digest())
    return total.hexdigest()


def _paths(folder: Path, without: Container[str]) -> Iterator[Path]:
    """A folder and everything below it, in an order that does not depend on the disk."""
    for path, folders, names in os.walk(folder):
        folders[:] = sorted(name for name in folders if name not in without)
        links = [name for name in folders if Path(path, name).is_symlink()]
        yield Path(path)
        yield from (Path(path, name) for name in sorted([*names, *links]) if name not in without)


def _digest(*parts: object) -> str:
    """A short digest, for a tag."""
    return hashlib.sha256(json.dumps(parts, sort_keys=True).encode()).hexdigest()[:32]


class Report(Shape):
    """What a build came to, as it is kept.

    Attributes:
        form: digest of the fields that there are: a release of rosml with others passes it over.
        tests: how many there are, and how many of them were skipped.
    """

    model_config = ConfigDict(strict=True, extra="forbid")

    form: str
    outcome: Outcome
    tests: list[int] = Field(min_length=2, max_length=2)

    @property
    def passed(self) -> Tests:
        """The tests, of which none failed."""
        count, skipped = self.tests
        return Tests(count, skipped)


@functools.cache
def form() -> str:
    """The present form of reports. The docstrings of their models count: if you change one, kept reports are dropped."""
    return _digest(Report.model_json_schema())


class Cache:
    """The repository with the stages. Use it in a `with`.

    Raises:
        RosmlError: the name is no repository (exit code 2).
    """

    def __init__(self, name: str, ca_bundle: str) -> None:
        self._place = references.parse(name)
        if not name.endswith(self._place.repository):
            raise RosmlError(
                f"cache: {name} has a tag", "name a repository alone, such as ghcr.io/me/cache", exit_code=2
            )
        self._registry = Registry(self._place.host, ca_bundle=ca_bundle)

    def __enter__(self) -> Cache:
        return self

    def __exit__(self, *_: object) -> None:
        self._registry.close()

    def reference(self, tag: str) -> str:
        return f"{self._place.host}/{self._place.repository}:{tag}"

    def stages(self, keys: Keys) -> dict[str, str]:
        """The stages that the repository has: names, and references by digest.

        Raises:
            RosmlError: a stage is no image from which a build may start (exit code 2); the registry does not answer or refuses.
        """
        present = {}
        for stage, tag in keys.stages.items():
            if manifest := self._registry.manifest(self._place.repository, tag):
                bases.configs(self._registry, self._place.repository, manifest, self.reference(tag))
                present[stage] = f"{self._place.host}/{self._place.repository}@{manifest.digest}"
        return present

    def report(self, keys: Keys) -> Report | None:
        """The report of a build from the same inputs. None if none passed, or if it is unreadable or has another form."""
        try:
            layers = self._layers(keys)
            if not layers:
                return None
            content = untrusted.json_object(self._registry.part(self._place.repository, layers[0])) or {}
            report = Report.model_validate(content)
            return report if report.form == form() else None
        except (RosmlError, ValueError):
            return None

    def detail(self, keys: Keys, name: str) -> bytes:
        """A detail of a build from the same inputs, by a name as in `keep`.

        Raises:
            RosmlError: there is no such detail; or the registry does not answer or refuses.
        """
        for layer in self._layers(keys):
            if layer.annotations.get(_TITLE) == name:
                return self._registry.part(self._place.repository, layer)
        raise RosmlError(f"{self.reference(keys.report)} has no {name}", "delete that tag, and build again")

    def _layers(self, keys: Keys) -> list[Descriptor]:
        """The layers of a report: the report itself, then details; none if there is no report."""
        manifest = self._registry.manifest(self._place.repository, keys.report)
        return manifest.layers if manifest and manifest.artifact_type == _TYPE else []

    def keep(self, keys: Keys, outcome: Outcome, tests: Tests, details: Mapping[str, bytes]) -> None:
        """Keeps the report of a build whose tests passed, and other files of the build, by name."""
        report = Report(form=form(), outcome=outcome, tests=[tests.count, tests.skipped])
        content = oci.encoded(report.model_dump())
        manifest = oci.artifact(_TYPE, content, "application/json")
        for name, data in details.items():
            manifest["layers"].append(oci.descriptor(_DETAIL, data) | {"annotations": {_TITLE: name}})
        for data in (oci.EMPTY_BLOB, content, *details.values()):
            self._registry.put_blob(self._place.repository, data)
        self._registry.put_manifest(self._place.repository, keys.report, manifest)
