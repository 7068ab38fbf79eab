"""What the publisher knows of images, kept in the registry, so that any machine can continue.

The repository `records` has one artifact for each image and architecture, under the tag `<target>.<architecture>`. Its
annotation has all that a plan needs, so that one request reads it. Its layer has also the inputs by name, which explain
why an image is rebuilt. Only the present artifact of a tag is kept. When an image is promoted, its entry is also
attached to the image itself, for the catalogue's history.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from contextlib import suppress
from dataclasses import dataclass, field, fields, replace
from typing import Any, ClassVar

from pydantic import ConfigDict, ValidationError

from rosml.base import untrusted
from rosml.base.errors import RosmlError
from rosml.base.shapes import Shape, adapter
from rosml.base.side_by_side import side_by_side
from rosml.registry.oci import Manifest
from rosml.registry.place import Place

INPUTS = "io.rosml.inputs"
DATE = "io.rosml.date"
ARTIFACT = "application/vnd.rosml.records.v1+json"
ANNOTATION = "io.rosml.records"
LAYER = "application/json"
REPOSITORY = "records"

FEW = 100
"""So many entries are asked for one by one: a list of tags would be no shorter."""

INDEX = "index"
"""The architecture in the entry of an image's index."""

CREATED = "org.opencontainers.image.created"
"""The annotation with the time of an artifact, which decides which of several is the newest."""


@dataclass(frozen=True)
class Entry:
    """An image, or part, on one architecture. A field is empty if nothing is known about it."""

    __pydantic_config__: ClassVar[ConfigDict] = ConfigDict(extra="forbid")

    target: str  # bake target
    architecture: str  # such as `amd64`, or INDEX
    inputs: str = ""  # the inputs digest
    package_state: str = ""  # state of the package repositories that its packages came from
    repository: str = ""  # without the registry's prefix
    digest: str = ""  # of the image manifest or index; empty if nothing was made yet
    # Digests by target of what the image was joined from or built on; of an index, its images by architecture.
    parts: Mapping[str, str] = field(default_factory=dict)
    size: int = 0  # bytes of the layers, compressed
    unpacked: int = 0  # bytes of the root file system
    tested: str = ""  # digest of the tests that ran
    passed: int = 0  # how many tests passed
    failures: tuple[str, ...] = ()
    provenance: Mapping[str, str] = field(default_factory=dict)  # digests of the provenance statements, by builder
    sbom: str = ""  # digest of the artifact with its SBOM; none of an index
    vex: str = ""  # digest of the artifact with its VEX; of an index, those that it names of its images
    described: str = ""  # `contents.FORMAT` of what is attached to it
    scanned: str = ""  # outcome of the scan
    scan: Mapping[str, Any] = field(default_factory=dict)  # what the policy and the database said
    versions: Mapping[str, str] = field(default_factory=dict)  # of packages and programs found in the image
    seconds: Mapping[str, float] = field(default_factory=dict)  # wall time by step
    date: str = ""  # of the run that made it
    changed: str = ""  # date of the run that wrote this entry
    held: str = ""  # for an index, when its tags were moved back. It gets no more tags.
    failed: Mapping[str, str] = field(default_factory=dict)  # the step that failed last, and why
    superseded: tuple[str, ...] = ()  # earlier digests, which may still be in the registry
    signed: Mapping[str, str] = field(
        default_factory=dict
    )  # of an index or of an image's VEX: when, by the signature's identity

    @property
    def tag(self) -> str:
        return tag(self.target, self.architecture)

    def with_digest(self, digest: str, **facts: Any) -> Entry:
        """The entry after a build, join or index. With the same digest as before, the earlier facts about it stay."""
        if digest == self.digest:
            return replace(self, failed={}, **facts)
        earlier = (*self.superseded, *((self.digest,) if self.digest else ()))
        superseded = tuple(each for each in earlier if each != digest)
        return replace(Entry(self.target, self.architecture, digest=digest, superseded=superseded), **facts)

    def to_json(self) -> dict[str, Any]:
        # Its values are plain already; dataclasses.asdict would copy each of them.
        return {item.name: value for item in fields(self) if (value := getattr(self, item.name))}


def tag(target: str, architecture: str) -> str:
    """The tag of an entry."""
    return f"{target}.{architecture}"


def parse(content: Any) -> Entry | None:
    """The entry in plain data; None if there is none, or a later version of this program wrote it."""
    if isinstance(content, dict) and "upstream" in content:  # from an older version of this program
        content = {**content, "package_state": content["upstream"]}
        del content["upstream"]
    try:
        return _ADAPTER.validate_python(content)
    except ValidationError:
        return None


_ADAPTER = adapter(Entry)


class _Inputs(Shape):
    inputs: dict[str, str]


class Records:
    """The entries of a registry. `repository` is the path of the repository that has them."""

    def __init__(self, place: Place) -> None:
        self.place = place
        self.registry = place.client
        self.repository = place.path(REPOSITORY)

    def read(self, target: str, architecture: str) -> Entry | None:
        """The entry of an image on an architecture; None if there is none, or it cannot be read."""
        manifest = self.registry.manifest(self.repository, tag(target, architecture))
        if manifest is None:
            return None
        try:
            entry = parse(untrusted.json_value(manifest.annotations.get(ANNOTATION, "")))
        except ValueError:
            return None
        return entry if entry and (entry.target, entry.architecture) == (target, architecture) else None

    def read_all(self, keys: Iterable[tuple[str, str]]) -> dict[tuple[str, str], Entry]:
        """Entries by target and architecture. If many are asked for, a list of tags says first which are missing."""
        keys = list(keys)
        if len(keys) > FEW:
            tags = {*self.registry.tags(self.repository)}
            keys = [key for key in keys if tag(*key) in tags]
        entries = side_by_side(lambda key: self.read(*key), keys)
        return {key: entry for key, entry in zip(keys, entries, strict=True) if entry}

    def inputs(self, target: str, architecture: str) -> dict[str, str]:
        """The inputs of an entry by name; empty if unknown."""
        manifest = self.registry.manifest(self.repository, tag(target, architecture))
        if manifest is None:
            return {}
        try:
            (layer,) = manifest.layers
            content = untrusted.json_value(self.registry.part(self.repository, layer))
            return _Inputs.model_validate(content).inputs
        except (KeyError, TypeError, ValueError, RosmlError):
            return {}

    def write(self, entry: Entry, inputs: Mapping[str, str] | None = None) -> str:
        """Writes an entry in place of the earlier one, whose inputs stay if there are no new ones. Returns its manifest's digest."""
        if inputs is None:
            inputs = self.inputs(entry.target, entry.architecture)
        text = json.dumps(entry.to_json(), sort_keys=True)
        data = json.dumps({**entry.to_json(), "inputs": dict(inputs)}, sort_keys=True).encode()
        return self.artifact(entry.tag, data, {ANNOTATION: text})

    def attach(self, entry: Entry, inputs: Mapping[str, str]) -> None:
        """Attaches an entry to its image, so that it stays when a newer one replaces it. The same entry again changes nothing."""
        path = self.place.path(entry.repository)
        subject = self.registry.manifest(path, entry.digest)
        if subject is None:
            raise RosmlError(f"{path}@{entry.digest} is not in the registry any more", "publish it again")
        data = json.dumps({"entry": entry.to_json(), "inputs": dict(inputs)}, sort_keys=True).encode()
        self.registry.attach(path, subject.descriptor, ARTIFACT, data, LAYER, {CREATED: entry.changed})

    def attached(self, repository: str, digest: str) -> Entry | None:
        """The newest readable entry that is attached to an image and is about this image; None if there is none."""
        path = self.place.path(repository)
        entries = []
        for item in self.registry.referrers(path, digest, ARTIFACT):
            try:
                manifest = self.registry.manifest(path, item["digest"])
                (layer,) = manifest.layers if manifest else []
                entry = parse(untrusted.json_value(self.registry.part(path, layer))["entry"])
            except (KeyError, TypeError, ValueError, RosmlError):
                continue
            if entry and (entry.repository, entry.digest) == (repository, digest):
                entries.append(entry)
        return max(entries, key=lambda entry: entry.changed, default=None)

    def artifact(self, name: str, data: bytes, annotations: Mapping[str, str]) -> str:
        """Puts an artifact of JSON under a tag, and removes the tag's earlier one, if the registry can do that. Returns its digest."""
        before = self.registry.head(self.repository, name)
        digest = self.registry.put_artifact(self.repository, name, ARTIFACT, data, LAYER, annotations)
        if before not in ("", digest):
            with suppress(RosmlError):  # the new artifact is written, even if the earlier one cannot be removed
                if self.registry.head(self.repository, name) != before:  # otherwise somebody moved the tag back to it
                    self.registry.discard(self.repository, before)
        return digest


def date_of(manifest: Manifest | None) -> str:
    """The date of the run that made an index; empty if its annotation is missing. Anybody may write anything there."""
    return manifest.annotations.get(DATE, "") if manifest else ""
