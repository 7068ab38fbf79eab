"""Reads images for one question: their SBOMs, the base images below apps, and VEX."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field, replace
from functools import cache

from rosml.base.errors import RosmlError
from rosml.containerize.affected.causes import Cause, Causes
from rosml.containerize.affected.inventory import Contents, Inventory
from rosml.containerize.rebase.attachments import base_of
from rosml.images.dossier.bill import Bill
from rosml.images.image_set.labels import APP, BASE_NAME
from rosml.images.join import facts
from rosml.images.join.layers import Source, platform
from rosml.images.join.transfer import MEMBERS, Transfer
from rosml.images.scan import attached, vex
from rosml.images.scan.attached import Attached
from rosml.images.scan.sbom import Sbom
from rosml.images.scan.vex import Statement
from rosml.registry.client import Registry
from rosml.registry.oci import Manifest
from rosml.registry.references import Reference

LARGEST = 32 << 20
"""The most bytes of an SBOM. That of a desktop image with all frameworks has some MB."""


@dataclass(frozen=True)
class Image:
    """An image for one platform. `why` says why its contents are unknown; else it is empty."""

    name: str  # as people call it
    place: Reference  # by digest
    platform: str
    contents: Contents = field(default_factory=lambda: Contents(frozenset()))
    manifest: Manifest | None = field(default=None, compare=False)  # if it was read already
    why: str = ""
    remedy: str = ""


class Images:
    """Reads each image once. Safe to share among threads."""

    def __init__(self, registries: Callable[[str], Registry], where: Callable[[str], Reference]) -> None:
        self.inventory = Inventory()
        self._registries, self._where = registries, where
        self._transfer = Transfer(registries, lambda _: None)
        self.contents = cache(self._contents)
        self.statements = cache(self._statements)
        self.base = cache(self._base)

    def __enter__(self) -> Images:
        return self

    def __exit__(self, failed: object, *_: object) -> None:
        self._transfer.close(failed)

    def read(self, name: str, platforms: Iterable[str] = ()) -> list[Image]:
        """An image, for each of its platforms or for some of them. An error is the reason why it is unknown."""
        place, requested = self._where(name), {*platforms}
        try:
            manifest = self._registries(place.host).manifest(place.repository, place.reference)
            if manifest is None:
                raise RosmlError("it is gone", "check its name")
            if len(manifest.members) > MEMBERS:
                text = f"it is an index of {len(manifest.members):,} images, and at most {MEMBERS} are read"
                raise RosmlError(text, "name another image")
        except RosmlError as error:
            return [Image(name, place, "", why=error.message, remedy=error.remedy)]
        if not manifest.is_index:  # nobody asks for its platform, unless it is affected
            image = Image(name, place._replace(reference=manifest.digest), "", manifest=manifest)
            return [self._with_contents(image, {})]
        members = {platform(entry.platform): entry for entry in manifest.members}
        return [
            self._with_contents(Image(name, place._replace(reference=entry.digest), key), entry.annotations)
            for key, entry in members.items()
            if "unknown" not in key and (not requested or key in requested)
        ]

    def _with_contents(self, image: Image, annotations: Mapping[str, str]) -> Image:
        try:
            return replace(image, contents=self.contents(image.place, tuple(sorted(annotations.items()))))
        except RosmlError as error:
            return replace(image, why=error.message, remedy=error.remedy)

    def _contents(self, place: Reference, annotations: tuple[tuple[str, str], ...]) -> Contents:
        """By its own SBOM, or else by those of the images that it is joined from. RosmlError if there is none."""
        registry, sboms = self._registries(place.host), self._attached(place)
        ignored = tuple(f"an attached SBOM does not count: {it.why}" for it in sboms.ignored)
        if not sboms.sboms:
            parts = facts.components(registry, place.repository, place.reference, dict(annotations))
            if not parts:
                sboms.first(str(place))  # raises
            return Contents.together(self.contents(Reference(place.host, *part), ()) for part in parts)
        contents = self.inventory.read(sboms.sboms[0])
        return Contents(contents.numbers, (*contents.notes, *ignored))

    def _attached(self, place: Reference) -> Attached:
        return attached.read(self._registries(place.host), place.repository, place.reference, LARGEST, Sbom.seems_of)

    # ---- What only affected images are asked for -----------------------------------------------------------------------

    def source(self, image: Image) -> Source:
        return self._transfer.source(image.name, image.place, image.manifest)

    def causes(self, image: Image, purls: Iterable[str]) -> dict[str, tuple[Cause, ...]]:
        """Which packages of an app need components of it, by their package URLs; empty if its SBOM is gone by now."""
        sboms = self._attached(image.place).sboms
        return Causes(Bill(sboms[0].raw)).of_all(purls) if sboms else {}

    def _base(self, name: str, key: str) -> Image | None:
        """A base image for one platform, by its tag or digest; None if it is gone, or cannot be read."""
        try:
            images = self.read(name)
        except RosmlError:
            return None
        return next((it for it in images if not it.why and it.platform in (key, "")), None)

    def below(self, source: Source, key: str) -> tuple[Image | None, Image | None]:
        """The base image of an app: as it was, and where its tag is now."""
        name, pinned = source.labels.get(BASE_NAME, ""), base_of(source)
        if not source.labels.get(APP) or not name:
            return None, None
        return (self.base(pinned, key) if pinned else None), self.base(name.partition("@")[0], key)

    def _statements(self, place: Reference) -> tuple[Statement, ...]:
        """The newest VEX of an image; empty if there is none, or it is damaged."""
        try:
            return vex.read(self._registries(place.host), place.repository, place.reference)
        except RosmlError:
            return ()
