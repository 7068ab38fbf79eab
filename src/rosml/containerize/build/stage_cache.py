"""A cache of finished stages of an app's build, in a registry, for machines that have none of them.

Each slow stage is an image, whose tag is a digest of everything that decides its content. A build takes the images that exist instead of
their stages. Once its tests have passed, a build's report is kept beside them.
"""

from __future__ import annotations

import functools
import hashlib
import json
import os
import stat
from collections.abc import Container, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from pydantic import ConfigDict, Field

from rosml.base import untrusted
from rosml.base.errors import RosmlError
from rosml.base.shapes import Shape
from rosml.containerize.build import bake_file
from rosml.containerize.build.bake_file import BASE, Inputs
from rosml.containerize.build.junit import Tests
from rosml.containerize.build.outcome import Outcome
from rosml.containerize.within import SECRET
from rosml.registry import bases, oci, references
from rosml.registry.client import Registry
from rosml.registry.documents import Descriptor

IDENTIFIED = "identified"
"""The stage that finds the packages that the sources need."""

REPORT = "report"

_TYPE = "application/vnd.rosml.app.report.v1+json"
_DETAIL = "application/octet-stream"
_TITLE = "org.opencontainers.image.title"


@dataclass(frozen=True)
class Keys:
    """Digests of the inputs of stages."""

    environment: str  # for the installed dependencies
    upstream: str  # for the built upstream packages
    app: str  # for the whole app
    slim: bool  # there are stages of a slim image
    base: str = ""  # for a base on which ROS was installed; empty if it had ROS

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
        return f"{REPORT}-{self.app}"


def keys(inputs: Inputs, platforms: tuple[str, ...]) -> Keys:
    """The keys of a build's stages."""
    values, contexts = inputs.values, inputs.contexts
    decisive: dict[str, object] = {
        "base": inputs.base.digest,
        "platforms": platforms,
        "ros": inputs.distribution,
        "skip-keys": values.skip_keys,
        "conditions": inputs.conditions,
        **({"script-secrets": True} if values.allow_script_secrets else {}),
        **({"middleware": values.rmw_implementation} if values.rmw_implementation else {}),
        **({"adopted": inputs.base.adopted.inputs} if inputs.base.adopted else {}),
        **({"slim": inputs.slim.digest} if inputs.slim else {}),
        **({"addons": [*inputs.base.addons.parts.values()]} if inputs.base.addons else {}),
    }
    # Other lists of rosdep than those that the user names are the newest, and change every day for nothing.
    names = ("manifests", "requests", "additional", *(["rosdep"] if values.rosdep_index else []))
    folders = [
        *(contexts[name] for name in names),
        *(bake_file.SCRIPTS / name for name in ("containerize", "build", "ros")),
    ]
    upstream, target = (tree(contexts[name], SECRET) for name in ("upstream", "target"))
    # A script may change sources before their dependencies are read: then all sources decide the dependencies.
    hooked = [upstream, target] if inputs.hooked else []
    environment = _digest(decisive, [tree(folder) for folder in folders], hooked)
    arguments = f"{values.cmake_args}\0{values.colcon_args}" if values.colcon_args else values.cmake_args
    built = _digest(environment, upstream, arguments, target if inputs.hooked else "")
    app = _digest(built, target, tree(contexts["downstream"], SECRET), str(values.tests))
    base = _digest([decisive.get(name) for name in ("base", "platforms", "adopted")]) if inputs.base.adopted else ""
    return Keys(environment, built, app, inputs.slim is not None, base)


def tree(folder: Path, without: Container[str] = ()) -> str:
    """The digest of a folder and everything below it, without these names: names, modes, contents and links. Times do not count."""
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
    """A folder and everything below it, in an order that does not depend on the disk; a file alone."""
    if folder.is_file():
        yield folder
    for path, folders, names in os.walk(folder):
        folders[:] = sorted(name for name in folders if name not in without)
        links = [name for name in folders if Path(path, name).is_symlink()]
        yield Path(path)
        yield from (Path(path, name) for name in sorted([*names, *links]) if name not in without)


def _digest(*parts: object) -> str:
    return hashlib.sha256(json.dumps(parts, sort_keys=True).encode()).hexdigest()[:32]


class Report(Shape):
    model_config = ConfigDict(strict=True, extra="forbid")

    form: str  # of the fields: a release of rosml with others passes it over
    outcome: Outcome
    tests: list[int] = Field(min_length=2, max_length=2)

    @property
    def passed(self) -> Tests:
        count, skipped = self.tests
        return Tests(count, skipped)


@functools.cache
def form() -> str:
    """The present form of reports: the fields of their models, and not what docstrings say of them."""
    return _digest(_without_descriptions(Report.model_json_schema()))


def _without_descriptions(schema: Any) -> Any:
    if isinstance(schema, dict):
        # A description is a text; a field of that name has a schema.
        texts = {key: value for key, value in schema.items() if key != "description" or not isinstance(value, str)}
        return {key: _without_descriptions(value) for key, value in texts.items()}
    return [*map(_without_descriptions, schema)] if isinstance(schema, list) else schema


class Cache:
    """The repository with the stages. Use it in a `with`."""

    def __init__(self, name: str, ca_bundle: str) -> None:
        self._place = references.parse(name)
        if not name.endswith(self._place.repository):
            remedy = "name a repository alone, such as ghcr.io/me/cache"
            raise RosmlError(f"cache: {name} has a tag", remedy, exit_code=2)
        self._registry = Registry(self._place.host, ca_bundle=ca_bundle)

    def __enter__(self) -> Cache:
        return self

    def __exit__(self, *_: object) -> None:
        self._registry.close()

    def reference(self, tag: str) -> str:
        return f"{self._place.host}/{self._place.repository}:{tag}"

    def stages(self, keys: Keys) -> dict[str, str]:
        """References by digest of the stages that the repository has. A build may start from each."""
        present = {}
        for stage, tag in keys.stages.items():
            if manifest := self._registry.manifest(self._place.repository, tag):
                bases.configs(self._registry, self._place.repository, manifest, self.reference(tag))
                present[stage] = f"{self._place.host}/{self._place.repository}@{manifest.digest}"
        return present

    def report(self, keys: Keys) -> Report | None:
        """The report of a build from the same inputs; None if there is none in the present form."""
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
        """A detail of a build from the same inputs, by a name as in `keep`."""
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
