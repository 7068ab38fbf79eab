"""Finished stages of an app's build, in a registry, for a machine that has none of them.

Each stage that takes time is an image under a tag that says what it was made from: everything that decides its content, and
nothing else. Whoever builds computes these tags, asks the registry for them, and takes what is there in the place of the
stage. What a build came to is kept beside them, as soon as its tests have passed.
"""

from __future__ import annotations

import functools
import hashlib
import json
import os
import stat
from collections.abc import Container, Iterable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from pydantic import BaseModel, ConfigDict, Field

from rosml.base import untrusted
from rosml.base.errors import RosmlError
from rosml.containerize.junit import Tests
from rosml.containerize.outcome import Outcome
from rosml.containerize.within import SECRET
from rosml.registry import oci, references
from rosml.registry.client import Registry
from rosml.registry.documents import Descriptor

IDENTIFIED = "identified"
"""The stage that says which packages the sources need."""

BASE = "base"
"""The stage that is ROS on an image that has none."""

ADOPTED = "adopted"
"""The value that decides it."""

REPORT = "report"
"""The tag of what a build came to begins with this."""

_TYPE = "application/vnd.rosml.app.report.v1+json"
_DETAIL = "application/octet-stream"
_TITLE = "org.opencontainers.image.title"


@dataclass(frozen=True)
class Keys:
    """What stages are made from, each as a digest.

    Attributes:
        environment: of the installed dependencies. upstream: of the upstream packages, built. app: of all.
        slim: there are the stages of a slim image.
        base: of a base on which ROS was installed; empty if it had ROS.
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


def keys(
    given: Mapping[str, Any],
    dependencies: Iterable[Path],
    upstream: Path,
    target: Path,
    downstream: Path,
    arguments: str,
    tests: str,
    hooked: bool,
) -> Keys:
    """The keys of an app.

    Args:
        given: values that decide which packages are installed, and from what.
        dependencies: folders that do so.
        upstream, target, downstream: folders with sources.
        arguments: of CMake and of colcon. tests: whether they run.
        hooked: a script changes the sources before their dependencies are read, so that all of them count for these.
    """
    sources = [tree(folder, SECRET) for folder in (upstream, target)]
    environment = _digest(given, [tree(folder) for folder in dependencies], sources if hooked else [])
    built = _digest(environment, sources[0], arguments, sources[1] if hooked else "")
    app = _digest(built, sources[1], tree(downstream, SECRET), tests)
    parts = [given.get(name) for name in ("base", "platforms", ADOPTED)]
    return Keys(environment, built, app, bool(given.get("slim")), _digest(parts) if given.get(ADOPTED) else "")


def tree(folder: Path, without: Container[str] = ()) -> str:
    """The digest of a folder and all below it: names, modes, contents and links. Times do not count.

    Args:
        without: names of files and folders that are left out, at any depth.
    """
    total = hashlib.sha256()
    for path in _found(folder, without):
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


def _found(folder: Path, without: Container[str]) -> Iterator[Path]:
    """A folder and all below it, in an order that does not depend on the disk."""
    for path, folders, names in os.walk(folder):
        folders[:] = sorted(name for name in folders if name not in without)
        links = [name for name in folders if Path(path, name).is_symlink()]
        yield Path(path)
        yield from (Path(path, name) for name in sorted([*names, *links]) if name not in without)


def _digest(*parts: object) -> str:
    """A short digest, for a tag."""
    return hashlib.sha256(json.dumps(parts, sort_keys=True).encode()).hexdigest()[:32]


class Report(BaseModel):
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
    """The form of reports, now."""
    return _digest(Report.model_json_schema())


class Cache:
    """The repository that keeps stages. Use it in a `with`.

    Args:
        name: of the repository, with its registry. ca_bundle: certificates beside the system's.

    Raises:
        RosmlError: it names no repository (exit code 2).
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
        """Where a stage goes."""
        return f"{self._place.host}/{self._place.repository}:{tag}"

    def found(self, keys: Keys) -> dict[str, str]:
        """The stages that are there, by name, each with its reference by digest."""
        there = {}
        for stage, tag in keys.stages.items():
            if digest := self._registry.head(self._place.repository, tag):
                there[stage] = f"{self._place.host}/{self._place.repository}@{digest}"
        return there

    def report(self, keys: Keys) -> Report | None:
        """What a build from the same came to. None if none passed, or if what is there cannot be read or has another form."""
        try:
            layers = self._layers(keys)
            if not layers:
                return None
            content = untrusted.json_object(self._registry.part(self._place.repository, layers[0])) or {}
            found = Report.model_validate(content)
            return found if found.form == form() else None
        except (RosmlError, ValueError):
            return None

    def detail(self, keys: Keys, name: str) -> bytes:
        """What a build from the same said besides.

        Args:
            name: as in `keep`.

        Raises:
            RosmlError: it said nothing of that name; or the registry does not answer or refuses.
        """
        for layer in self._layers(keys):
            if layer.annotations.get(_TITLE) == name:
                return self._registry.part(self._place.repository, layer)
        raise RosmlError(f"{self.reference(_tag(keys))} has no {name}", "delete that tag, and build again")

    def _layers(self, keys: Keys) -> list[Descriptor]:
        """The layers of a report: what it came to, and details; none if there is no report."""
        manifest = self._registry.manifest(self._place.repository, _tag(keys))
        return manifest.layers if manifest and manifest.artifact_type == _TYPE else []

    def keep(self, keys: Keys, outcome: Outcome, tests: Tests, details: Mapping[str, bytes]) -> None:
        """Keeps what a build came to.

        Args:
            tests: which passed. details: what it said besides, by name.

        Raises:
            RosmlError: the registry refuses.
        """
        report = Report(form=form(), outcome=outcome, tests=[tests.count, tests.skipped])
        content = oci.encoded(report.model_dump())
        manifest = oci.artifact(_TYPE, content, "application/json")
        for name, data in details.items():
            manifest["layers"].append(oci.descriptor(_DETAIL, data) | {"annotations": {_TITLE: name}})
        for data in (oci.EMPTY_BLOB, content, *details.values()):
            self._registry.put_blob(self._place.repository, data)
        self._registry.put_manifest(self._place.repository, _tag(keys), manifest)


def _tag(keys: Keys) -> str:
    return f"{REPORT}-{keys.app}"
