"""What the publisher knows of an image on one architecture, kept in the registry: any machine can carry on.

One artifact for each image and architecture in the repository `records`, under the tag `<target>.<architecture>`. What a
plan needs stands in its annotation, so that one request reads it; the inputs by name, which say why an image is to be
built anew, are its layer. Of each tag the present artifact alone is kept. The same is attached to the image itself when it
is promoted, for whoever has only that; a run that finds the repository `records` empty carries on from there.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from contextlib import suppress
from dataclasses import asdict, dataclass, field, replace
from typing import Any, ClassVar

from pydantic import BaseModel, ConfigDict, TypeAdapter, ValidationError

from rosml.base import untrusted
from rosml.base.errors import RosmlError
from rosml.base.side_by_side import side_by_side
from rosml.registry.oci import Manifest
from rosml.registry.place import Place

INPUTS = "io.rosml.inputs"

DATE = "io.rosml.date"


ARTIFACT = "application/vnd.rosml.records.v1+json"
ANNOTATION = "io.rosml.records"
LAYER = "application/json"
REPOSITORY = "records"

INDEX = "index"
"""Stands for an architecture in the entry of an image's index."""

CREATED = "org.opencontainers.image.created"
"""The annotation with the time by which the newest of several artifacts is known."""


@dataclass(frozen=True)
class Entry:
    """An image, or part, on one architecture.

    Attributes:
        target: bake target. architecture: under BuildKit's name.
        inputs: digest of what it is made from; empty where nothing was made yet.
        package_state: of the repositories that its packages came from; empty where no repository decides.
        repository: without the registry's prefix. digest: of the image manifest; empty where nothing was made yet.
        parts: of an image that was put together, the digests of its parts by target.
        size: bytes of its layers, compressed. unpacked: bytes of its root file system; 0 where nobody counted.
        tested: digest of the tests that ran, empty before. passed: how many passed. failures: those that did not.
        provenance: digests of the statements of where it came from that were attached when it was made, by builder.
        sbom: of a ROS image or part, digest of the artifact with its SBOM.
        scanned: outcome of the scan, empty before. scan: what it found by severity, the database's date, the policy's digest.
        versions: what was found inside the image.
        seconds: wall time by step.
        date: of the run that made it. changed: of the run that wrote this.
        held: of an index, when its tags were moved back; it gets none any more.
        failed: the step that failed last, and why; empty where none did.
        superseded: digests that were in its place and may still be in the registry.
        signed: of an index, when it was signed, by whose signature.
    """

    __pydantic_config__: ClassVar[ConfigDict] = ConfigDict(extra="forbid")

    target: str
    architecture: str
    inputs: str = ""
    package_state: str = ""
    repository: str = ""
    digest: str = ""
    parts: Mapping[str, str] = field(default_factory=dict)
    size: int = 0
    unpacked: int = 0
    tested: str = ""
    passed: int = 0
    failures: tuple[str, ...] = ()
    provenance: Mapping[str, str] = field(default_factory=dict)
    sbom: str = ""
    scanned: str = ""
    scan: Mapping[str, Any] = field(default_factory=dict)
    versions: Mapping[str, str] = field(default_factory=dict)
    seconds: Mapping[str, float] = field(default_factory=dict)
    date: str = ""
    changed: str = ""
    held: str = ""
    failed: Mapping[str, str] = field(default_factory=dict)
    superseded: tuple[str, ...] = ()
    signed: Mapping[str, str] = field(default_factory=dict)

    @property
    def tag(self) -> str:
        """Its tag in the repository of the records."""
        return tag(self.target, self.architecture)

    def made(self, digest: str, **facts: Any) -> Entry:
        """The entry after something was made in its place. What was found out about the same digest before holds on."""
        if digest == self.digest:
            return replace(self, failed={}, **facts)
        old = (*self.superseded, *((self.digest,) if self.digest else ()))
        fresh = Entry(self.target, self.architecture, digest=digest, superseded=tuple(x for x in old if x != digest))
        return replace(fresh, **facts)

    def to_json(self) -> dict[str, Any]:
        """As plain data, without what is empty."""
        return {name: value for name, value in asdict(self).items() if value}


def tag(target: str, architecture: str) -> str:
    """The tag of an entry."""
    return f"{target}.{architecture}"


def parse(content: Any) -> Entry | None:
    """An entry of its plain data; None if that is no entry, or of a later version of this program."""
    if isinstance(content, dict) and "upstream" in content:  # what older versions of this program wrote
        content = {**content, "package_state": content["upstream"]}
        del content["upstream"]
    try:
        return _ADAPTER.validate_python(content)
    except ValidationError:
        return None


_ADAPTER = TypeAdapter(Entry)


class _Inputs(BaseModel):
    """What the layer of an entry says of its inputs."""

    inputs: dict[str, str]


class Records:
    """The entries of a registry.

    Attributes:
        place: where they are.
        registry: the client of that place.
        repository: the path of the repository with the records.
    """

    def __init__(self, place: Place) -> None:
        self.place = place
        self.registry = place.client
        self.repository = place.path(REPOSITORY)

    def read(self, target: str, architecture: str) -> Entry | None:
        """The entry of an image on an architecture; None where there is none, or none that can be read."""
        found = self.registry.manifest(self.repository, tag(target, architecture))
        if found is None:
            return None
        try:
            entry = parse(untrusted.json_value(found.annotations.get(ANNOTATION, "")))
        except ValueError:
            return None
        return entry if entry and (entry.target, entry.architecture) == (target, architecture) else None

    def read_all(self, wanted: Iterable[tuple[str, str]]) -> dict[tuple[str, str], Entry]:
        """Entries by target and architecture; those that are not there are left out."""
        keys = list(wanted)
        found = side_by_side(lambda key: self.read(*key), keys)
        return {key: entry for key, entry in zip(keys, found, strict=True) if entry}

    def inputs(self, target: str, architecture: str) -> dict[str, str]:
        """The inputs by name of what an entry is about; empty where they are not known."""
        found = self.registry.manifest(self.repository, tag(target, architecture))
        if found is None:
            return {}
        try:
            (layer,) = found.layers
            content = untrusted.json_value(self.registry.part(self.repository, layer))
            return _Inputs.model_validate(content).inputs
        except (KeyError, TypeError, ValueError, RosmlError):
            return {}

    def write(self, entry: Entry, inputs: Mapping[str, str] | None = None) -> str:
        """Writes an entry in the place of the one before; gives its manifest's digest.

        Args:
            entry: the facts.
            inputs: by name; those that were written before if left out.
        """
        if inputs is None:
            inputs = self.inputs(entry.target, entry.architecture)
        text = json.dumps(entry.to_json(), sort_keys=True)
        data = json.dumps({**entry.to_json(), "inputs": dict(inputs)}, sort_keys=True).encode()
        return self.artifact(entry.tag, data, {ANNOTATION: text})

    def attach(self, entry: Entry, inputs: Mapping[str, str]) -> None:
        """Attaches an entry to the image that it is about, for the time when another one is in its place. The same one again
        changes nothing.

        Raises:
            RosmlError: the image is not there; the registry does not answer or refuses.
        """
        path = self.place.path(entry.repository)
        subject = self.registry.manifest(path, entry.digest)
        if subject is None:
            raise RosmlError(f"{path}@{entry.digest} is not in the registry any more", "publish it again")
        data = json.dumps({"entry": entry.to_json(), "inputs": dict(inputs)}, sort_keys=True).encode()
        self.registry.attach(path, subject.descriptor, ARTIFACT, data, LAYER, {CREATED: entry.changed})

    def attached(self, repository: str, digest: str) -> Entry | None:
        """The newest entry that is attached to an image; None where there is none that can be read and is about that image.

        Args:
            repository: without the registry's prefix. digest: of the manifest.
        """
        path = self.place.path(repository)
        found = []
        for item in self.registry.referrers(path, digest, ARTIFACT):
            try:
                manifest = self.registry.manifest(path, item["digest"])
                (layer,) = manifest.layers if manifest else []
                entry = parse(untrusted.json_value(self.registry.part(path, layer))["entry"])
            except (KeyError, TypeError, ValueError, RosmlError):
                continue
            if entry and (entry.repository, entry.digest) == (repository, digest):
                found.append(entry)
        return max(found, key=lambda entry: entry.changed, default=None)

    def artifact(self, name: str, data: bytes, annotations: Mapping[str, str]) -> str:
        """Puts an artifact with one layer of JSON under a tag of the records, in the place of the one before.

        That one is removed where the registry can: nobody would find it any more. Its blobs are the registry's to collect.
        """
        before = self.registry.head(self.repository, name)
        digest = self.registry.put_artifact(self.repository, name, ARTIFACT, data, LAYER, annotations)
        if before not in ("", digest):
            with suppress(RosmlError):  # the artifact is written by now, whatever becomes of the one before
                if self.registry.head(self.repository, name) != before:  # or somebody moved the tag back to it
                    self.registry.discard(self.repository, before)
        return digest


def date_of(manifest: Manifest | None) -> str:
    """What an index says of the date of the run that made it: anybody may write anything there. Empty where it says none."""
    return manifest.annotations.get(DATE, "") if manifest else ""
