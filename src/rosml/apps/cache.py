"""Finished stages of an app's build, in a registry, for a machine that has none of them.

Each stage that takes time is an image under a tag that says what it was made from: everything that decides its content, and
nothing else. Whoever builds computes these tags, asks the registry for them, and takes what is there in the place of the
stage. What a build came to is kept beside them, as soon as its tests have passed.
"""

from __future__ import annotations

import hashlib
import json
import os
import stat
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from rosml.base.errors import RosmlError
from rosml.registry import oci

REPORT = "report"
"""The tag of what a build came to begins with this."""

_TYPE = "application/vnd.rosml.app.report.v1+json"
_LEFT_OUT = {".git", ".env"}


@dataclass(frozen=True)
class Keys:
    """What stages are made from, each as a digest.

    Attributes:
        environment: of the installed dependencies. upstream: of the upstream packages, built. app: of all.
    """

    environment: str
    upstream: str
    app: str

    @property
    def stages(self) -> Mapping[str, str]:
        """The tag of each stage, by its name in the Dockerfile."""
        environment = ("identified", "environment", "runtime")
        return {
            **{name: f"{name}-{self.environment}" for name in environment},
            "upstream-built": f"upstream-{self.upstream}",
            **{name: f"{name}-{self.app}" for name in ("app", "workspace")},
        }


def keys(
    given: Mapping[str, Any],
    dependencies: Iterable[Path],
    upstream: Path,
    target: Path,
    cmake: str,
    tests: str,
    hooked: bool,
) -> Keys:
    """The keys of an app.

    Args:
        given: values that decide which packages are installed, and from what.
        dependencies: folders that do so.
        upstream, target: folders with sources.
        cmake: arguments of CMake. tests: whether they run.
        hooked: a script changes the sources before their dependencies are read, so that all of them count for these.
    """
    sources = [tree(upstream), tree(target)]
    environment = _digest(given, [tree(folder) for folder in dependencies], sources if hooked else [])
    built = _digest(environment, sources[0], cmake, sources[1] if hooked else "")
    return Keys(environment, built, _digest(built, sources[1], tests))


def tree(folder: Path) -> str:
    """The digest of all files below a folder: names, contents, links, and whether they can be run. Times do not count, nor
    what never reaches an image."""
    total = hashlib.sha256()
    for path in _files(folder):
        facts = path.lstat()
        total.update(os.fsencode(path.relative_to(folder)) + b"\0")
        if stat.S_ISLNK(facts.st_mode):
            total.update(b"link " + os.fsencode(os.readlink(path)) + b"\0")
        elif stat.S_ISREG(facts.st_mode):
            with path.open("rb") as file:
                content = hashlib.file_digest(file, "sha256").hexdigest()
            total.update(f"{bool(facts.st_mode & stat.S_IXUSR)} {content}".encode() + b"\0")
    return total.hexdigest()


def _files(folder: Path) -> Iterator[Path]:
    for path, folders, names in os.walk(folder):
        folders[:] = sorted(name for name in folders if name not in _LEFT_OUT)
        links = [name for name in folders if Path(path, name).is_symlink()]
        yield from (Path(path, name) for name in sorted([*names, *links]) if name not in _LEFT_OUT)


def _digest(*parts: object) -> str:
    """A short digest, for a tag."""
    return hashlib.sha256(json.dumps(parts, sort_keys=True).encode()).hexdigest()[:32]


class Cache:
    """The repository that keeps stages. Use it in a `with`.

    Args:
        name: of the repository, with its registry. ca_bundle: certificates beside the system's.

    Raises:
        RosmlError: it names no repository (exit code 2).
    """

    def __init__(self, name: str, ca_bundle: str) -> None:
        self._place = oci.parse(name)
        if not name.endswith(self._place.repository):
            raise RosmlError(
                f"cache: {name} has a tag", "name a repository alone, such as ghcr.io/me/cache", exit_code=2
            )
        self._registry = oci.Registry(self._place.host, ca_bundle=ca_bundle)

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

    def report(self, keys: Keys) -> dict[str, Any] | None:
        """What a build from the same came to; None if none passed."""
        manifest = self._registry.manifest(self._place.repository, f"{REPORT}-{keys.app}")
        if manifest is None:
            return None
        [layer] = manifest.content["layers"]
        return self._registry.json_blob(self._place.repository, layer["digest"])

    def keep(self, keys: Keys, report: Mapping[str, Any]) -> None:
        """Keeps what a build came to.

        Raises:
            RosmlError: the registry refuses.
        """
        content = oci.encoded(report)
        for blob in (content, oci.EMPTY_BLOB):
            self._registry.put_blob(self._place.repository, blob)
        manifest = oci.artifact(_TYPE, content, "application/json")
        self._registry.put_manifest(self._place.repository, f"{REPORT}-{keys.app}", manifest)
