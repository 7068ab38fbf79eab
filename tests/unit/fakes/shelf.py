"""A registry in memory with any number of published images, for the catalogue: as many layers, tags, records and entries of
the records as nights of publishing leave, and no content."""

from __future__ import annotations

import hashlib
import json
import zlib
from collections.abc import Collection, Mapping
from dataclasses import dataclass, field, replace
from typing import Any

from fakes.memory_registry import IMAGE, INDEX, LAYER, PREFIX, MemoryRegistry
from rosml.images.image_set import model as sets
from rosml.images.image_set.labels import COVERED, of_environment, of_part
from rosml.images.image_set.model import Environment, ImageSet, Part
from rosml.images.matrix.tags import dated
from rosml.images.records import tag_moves
from rosml.images.records.store import ANNOTATION, DATE, Entry, Records
from rosml.images.records.store import INDEX as INDEX_ENTRY
from rosml.images.scan import cyclonedx, packages, sbom
from rosml.images.scan.judge import Finding, Outcome, Scanned
from rosml.registry import oci
from rosml.registry.place import Place

FIRST = "2026-11-20T03:00:00Z"
SECOND = "2026-11-21T03:00:00Z"
THIRD = "2026-11-22T03:00:00Z"

Thing = sets.Image | Part


def layer_digest(text: str) -> str:
    return f"sha256:{hashlib.sha256(text.encode()).hexdigest()}"


@dataclass
class Shelf:
    """Publishes without building.

    Attributes:
        image_set: what exists. registry: where it goes.
        ros: state of ROS's packages, which a night may change. torch: the same of PyTorch's part.
    """

    image_set: ImageSet
    registry: MemoryRegistry = field(default_factory=lambda: MemoryRegistry(host="ghcr.io/me"))
    ros: str = "1"
    torch: str = "1"

    def night(self, date: str, distributions: Collection[str], architectures: tuple[str, ...] = ()) -> None:
        """Publishes all images of some distributions that can be built; moves tags where something changed."""
        images = [i for i in self.image_set.images if i.distribution in distributions and i.locked]
        names = {name for image in images for name in image.parts}
        parts = [part for part in self.image_set.parts if part.name in names]
        moves: list[tag_moves.Move] = []
        things: list[Thing] = [*parts, *images]
        for thing in things:
            kept = tuple(a for a in thing.architectures if not architectures or a in architectures)
            if kept and (isinstance(thing, Part) or thing.tags):
                moves += self._publish(thing, date, kept)
        text = json.dumps({"date": date, "moves": [move.to_json() for move in moves]})
        Records(Place(self.registry, PREFIX)).artifact(tag_moves.record_name(date), text.encode(), {ANNOTATION: "{}"})

    def _publish(self, thing: Thing, date: str, architectures: tuple[str, ...]) -> list[tag_moves.Move]:
        book, repository = Records(Place(self.registry, PREFIX)), f"{PREFIX}/{thing.repository}"
        members = {architecture: self._manifest(thing, architecture) for architecture in architectures}
        platforms = [
            {
                "mediaType": IMAGE,
                "digest": digest,
                "size": 1000,
                "platform": {"os": "linux", "architecture": architecture},
                "annotations": self._sboms(thing, architecture),
            }
            for architecture, digest in members.items()
        ]
        main = thing.name if isinstance(thing, Part) else thing.tags[0].split(":")[1]
        before = book.read(thing.target, INDEX_ENTRY)
        if before and before.parts == members:
            return []
        content = {"schemaVersion": 2, "mediaType": INDEX, "manifests": platforms, "annotations": {DATE: date}}
        digest = self.registry.put_manifest(repository, "", content, INDEX)
        tags = [main] if isinstance(thing, Part) else [tag.split(":")[1] for tag in thing.tags]
        previous = self.registry.head(repository, main)
        for tag in (*tags, dated(main, date)):
            self.registry.names.setdefault(repository, {})[tag] = digest
        for architecture, member in members.items():
            entry = self._entry(thing, architecture, member, date)
            book.write(entry, {})
            book.attach(entry, {})
        facts = Entry(thing.target, INDEX_ENTRY, repository=thing.repository, digest=digest, parts=members)
        book.write(facts, {})
        return [tag_moves.Move(thing.repository, tag, previous, digest) for tag in tags]

    def _sboms(self, thing: Thing, architecture: str) -> dict[str, str]:
        """The annotations of an index that name the SBOMs of an image: those of its ROS image and parts."""
        if isinstance(thing, Part) or not thing.stack:
            of: list[Thing] = [thing]
        else:
            of = [self.image_set.by_target[thing.parent], *(self.image_set.part_by_name[name] for name in thing.parts)]
        return {COVERED + item.target: self._sbom(item, architecture) for item in of}

    def _sbom(self, thing: Thing, architecture: str) -> str:
        """Attaches the SBOM of a ROS image or part to it: repository and digest."""
        repository, digest = f"{PREFIX}/{thing.repository}", self._manifest(thing, architecture)
        if isinstance(thing, Part):
            state = self.torch if thing.kind == "torch" else "1"
            wheels = {thing.kind: f"2.{state}", **({"pillow": "11.0"} if thing.kind == "torch" else {})}
            system, apt = packages.System(name="", version=""), {}
        else:
            wheels, system = {}, packages.System(name="debian", version="12.15")
            apt = {"bash": "5.2", f"ros-{thing.component}": f"1.{self.ros}"}
            apt |= {"tzdata": "1"} if self.ros == "1" else {}
        content = packages.Packages(
            system=system,
            apt=[
                packages.Apt(name=name, version=version, architecture=architecture, source=name, source_version=version)
                for name, version in apt.items()
            ],
            python=[packages.Python(name=name, version=version) for name, version in wheels.items()],
            ros=[],
        )
        document = cyclonedx.document(content, f"{self.registry.host}/{repository}@{digest}")
        manifest = self.registry.manifest(repository, digest)
        assert manifest
        artifact = self.registry.attach(
            repository, manifest.descriptor, sbom.MEDIA_TYPE, document, sbom.MEDIA_TYPE, sbom.FORMAT
        )
        return f"{thing.repository}@{artifact}"

    def _layers(self, thing: Thing, architecture: str) -> list[tuple[str, int]]:
        """Digests and sizes, lowest first; sizes are the matrix's forecast."""
        if isinstance(thing, Part):
            state = self.torch if thing.kind == "torch" else "1"
            size = thing.disk.compressed * 1_000_000 + zlib.crc32(thing.name.encode()) % 1_000_000
            return [(layer_digest(f"{thing.name} {architecture} {state}"), size)]
        if thing.stack:
            parts = [self.image_set.part_by_name[name] for name in thing.parts]
            below = self._layers(self.image_set.by_target[thing.parent], architecture)
            return [*below, *(layer for part in parts for layer in self._layers(part, architecture))]
        if parent := self.image_set.by_target.get(thing.parent):
            below = self._layers(parent, architecture)
        else:
            sizes = enumerate((48_000_000, 1_200_000))
            below = [(layer_digest(f"{thing.os} {architecture} {number}"), size) for number, size in sizes]
        size = self.image_set.matrix.disk.components[thing.component].compressed * 1_000_000 + 10_000 * int(self.ros)
        return [*below, (layer_digest(f"{thing.target} {architecture} {self.ros}"), size)]

    def _manifest(self, thing: Thing, architecture: str) -> str:
        repository = f"{PREFIX}/{thing.repository}"
        if isinstance(thing, Environment):
            labels = of_environment(thing.environment, thing.python, thing.takes)
        elif isinstance(thing, Part):
            labels = of_part(self.image_set.matrix.part[thing.kind], thing.stack, thing.python, (), {})
        else:
            labels = {f"io.rosml.{name}": version for name, version in thing.versions.items()}
            labels |= {"io.rosml.distribution": thing.distribution, "io.rosml.python": thing.python}
            if self.image_set.matrix.distributions[thing.distribution].apt:
                labels["io.rosml.ros.sync"] = f"2026-11-{10 + int(self.ros)}T00:00:00Z"
        config = json.dumps({"os": "linux", "architecture": architecture, "config": {"Labels": labels}}).encode()
        self.registry.put_blob(repository, config)
        layers = [
            {"mediaType": LAYER, "digest": digest, "size": size} for digest, size in self._layers(thing, architecture)
        ]
        content = {"schemaVersion": 2, "layers": layers, "config": oci.descriptor(oci.CONFIG, config)}
        return self.registry.put_manifest(repository, "", content, IMAGE)

    def _entry(self, thing: Thing, architecture: str, digest: str, date: str) -> Entry:
        facts = Entry(
            thing.target,
            architecture,
            inputs=layer_digest(f"{thing.target} {self.ros} {self.torch}").removeprefix("sha256:"),
            repository=thing.repository,
            digest=digest,
            date=date,
            package_state=f"lists-{self.ros}",
            size=sum(size for _, size in self._layers(thing, architecture)),
        )
        if isinstance(thing, Part):
            return facts
        versions = {
            "image-os": thing.os,
            "image-python": f"{thing.python}.9",
            "ros-distro": thing.ros_distro,
            "ros-version": str(thing.ros),
            "numpy": f"1.26.{3 + int(self.torch)}" if thing.stack else "1.24.2",
            **thing.versions,
        }
        ros = self.image_set.by_target[thing.parent] if thing.stack else thing
        disks = [ros.disk, *(self.image_set.part_by_name[name].disk for name in thing.parts)]
        findings = {"high": 2, "medium": 27} if thing.stack else {"medium": 3}
        scan = {"updated": "2026-11-22T00:10:00Z", "packages": 525, "findings": findings, "failing": []}
        scan["named"] = self._vulnerabilities(thing, findings)
        return replace(
            facts,
            unpacked=sum(disk.unpacked for disk in disks) * 1_000_000,
            tested="t",
            passed=20 + len(thing.tests),
            versions=versions,
            scanned="clean",
            scan=scan,
        )

    def _vulnerabilities(self, image: sets.Image, findings: Mapping[str, int]) -> list[dict[str, Any]]:
        """What the records name of findings: the first one is accepted, a newer package mends the second."""
        severities = [severity for severity, number in findings.items() for _ in range(number)]
        vulnerabilities = [
            Finding(f"CVE-2026-{1000 + number}", severity, "libexample1", "1:1.0-1+deb12u1", "", image.parent or "")
            for number, severity in enumerate(severities)
        ]
        first, second, *others = vulnerabilities
        first = replace(first, fixed="1:1.0-1+deb12u2", ignored="it is compiled out", until="2027-03-31")
        vulnerabilities = [first, replace(second, fixed="1:1.1~rc1"), *others]
        return Scanned(image.target, "amd64", Outcome.CLEAN, "", tuple(vulnerabilities)).recorded


def shown(image_set: ImageSet) -> Shelf:
    """Three nights of two distributions: after the first, ROS's packages move; after the second, PyTorch."""
    shelf = Shelf(image_set)
    everything = ("ros1-bookworm", "ros1-trixie")
    shelf.night(FIRST, everything)
    shelf.ros = "2"
    shelf.night(SECOND, everything)
    shelf.torch = "2"
    shelf.night(THIRD, everything)
    return shelf
