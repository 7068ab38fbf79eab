"""Facts about an image from others: the owners of its layers, and the unpacked sizes of its parts."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from rosml.images.catalogue.indexes import Index, Member, Thing
from rosml.images.catalogue.model import Layer, Platform, Sbom, Size, Tests
from rosml.images.catalogue.scans import scan_of
from rosml.images.image_set.labels import PREFIX
from rosml.images.image_set.model import Image, ImageSet, Part

_SYNC = f"{PREFIX}ros.sync"

Positions = tuple[int, ...]


class LayerTable:
    """The layers and SBOMs of a catalogue, by position."""

    def __init__(self, image_set: ImageSet, indexes: Mapping[str, Sequence[Index]]) -> None:
        self.layers: list[Layer] = []
        self.sboms: dict[Sbom, int] = {}
        self._position: dict[str, int] = {}
        self._labels = ["python", *dict.fromkeys(name for part in image_set.matrix.parts for name in part.brings)]
        # Parts first, then ROS images from the lowest up: a layer belongs to the lowest image that has it.
        ros = sorted((image for image in image_set.images if not image.stack), key=lambda i: _height(image_set, i))
        things: list[Thing] = [*image_set.parts, *ros]
        for thing in things:
            for index in indexes.get(thing.target, ()):
                for member in index.members:
                    self._add(member.layers, thing.name if isinstance(thing, Part) else thing.target)
        self._unpacked = self._measure(image_set, indexes)

    def platform(self, thing: Thing, member: Member) -> Platform:
        """The facts of an image for one platform."""
        self._add(member.layers, thing.name if isinstance(thing, Part) else "")
        entry = member.entry
        versions = dict(entry.versions) if entry else {}
        promised = {name: member.labels[PREFIX + name] for name in self._labels if PREFIX + name in member.labels}
        total = sum(size for _, size in member.layers)
        tested = isinstance(thing, Image) and entry and (entry.passed or entry.failures)
        return Platform(
            platform=member.platform,
            digest=member.digest,
            inputs=entry.inputs if entry else "",
            ros_sync=member.labels.get(_SYNC, "") or (entry.package_state if entry else ""),
            size=Size(compressed=total, unpacked=(entry.unpacked if entry else 0) or None),
            parts=self._sizes(member),
            layers=tuple(self._position[digest] for digest, _ in member.layers),
            sboms=tuple(self.sboms.setdefault(item, len(self.sboms)) for item in member.sboms),
            versions=versions or promised,
            found_inside=bool(versions),
            tests=Tests(passed=entry.passed, failures=entry.failures) if entry and tested else None,
            scan=scan_of(entry) if entry and entry.scanned else None,
        )

    def _add(self, layers: Iterable[tuple[str, int]], part: str) -> None:
        for digest, size in layers:
            if digest not in self._position:
                self._position[digest] = len(self.layers)
                self.layers.append(Layer(digest=digest, compressed=size, part=part))

    def _measure(self, image_set: ImageSet, indexes: Mapping[str, Sequence[Index]]) -> dict[Positions, int]:
        """The unpacked sizes of parts, by their layers: a ROS image without the one below it, and a part if all others
        in an image are known."""
        totals = []
        for image in image_set.images:
            for member in indexes[image.target][0].members if indexes.get(image.target) else ():
                self._add(member.layers, "")
                if member.entry and member.entry.unpacked:
                    totals.append((list(self._by_part(member).values()), member.entry.unpacked))
        sizes: dict[Positions, int] = {}
        count = -1
        while count < len(sizes):
            count = len(sizes)
            for parts, unpacked in totals:
                unknown = [part for part in parts if part not in sizes]
                if len(unknown) == 1:
                    sizes[unknown[0]] = max(0, unpacked - sum(sizes[part] for part in parts if part in sizes))
        return sizes

    def _by_part(self, member: Member) -> dict[str, Positions]:
        """The layers of an image by their part, in their order."""
        parts: dict[str, Positions] = {}
        for digest, _ in member.layers:
            position = self._position[digest]
            part = self.layers[position].part
            parts[part] = (*parts.get(part, ()), position)
        return parts

    def _sizes(self, member: Member) -> dict[str, Size]:
        return {
            part: Size(
                compressed=sum(self.layers[position].compressed for position in positions),
                unpacked=self._unpacked.get(positions),
            )
            for part, positions in self._by_part(member).items()
        }


def _height(image_set: ImageSet, image: Image) -> int:
    """How many ROS images are below an image, and its parts."""
    below = image_set.by_target.get(image.parent)
    return len(image.parts) + (1 + _height(image_set, below) if below else 0)
