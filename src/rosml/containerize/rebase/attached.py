"""What is attached to the images of apps and base images: it is read before an app moves, and attached to the result.

A list of files, and facts: see `images/join`. The SBOM of the result has the components of the base image's and of the app's own.
"""

from __future__ import annotations

import gzip
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from typing import Any

from rosml.base import untrusted
from rosml.base.errors import RosmlError
from rosml.containerize.build.bake_file import BASE_DIGEST, BASE_NAME
from rosml.images.image_set.labels import APP
from rosml.images.join import facts, file_lists
from rosml.images.join.facts import Facts
from rosml.images.join.file_lists import Lists
from rosml.images.join.layers import Source
from rosml.images.join.transfer import Transfer
from rosml.images.scan import sbom
from rosml.registry import oci, references
from rosml.registry.client import Registry
from rosml.registry.oci import Manifest
from rosml.registry.references import Reference

DEPTH = 10
"""Most apps on one another."""

_PYTHON = re.compile(r"(?:.*/)?([^/-]+)-([^/-]+)(?:-py[0-9.]+)?\.(?:dist-info|egg-info)(?:/.*)?")
"""The folder or file in which a package of Python says its name and version."""


@dataclass(frozen=True)
class Place:
    """The manifest of an image for one platform, in its registry."""

    host: str
    repository: str
    digest: str


@dataclass(frozen=True)
class Known:
    """What is known of a base image.

    Attributes:
        places: the images that it is joined from, by which lists and SBOMs are found; itself if it was built.
        facts: of all of them together.
        files, folders: of all of them.
    """

    places: tuple[Place, ...]
    facts: Facts
    files: frozenset[str]
    folders: frozenset[str]


def together(found: Sequence[Known]) -> Known:
    """What is known of several images that are joined."""
    if len(found) == 1:
        return found[0]
    return Known(
        tuple(place for item in found for place in item.places),
        facts.together(item.facts for item in found),
        frozenset[str]().union(*(item.files for item in found)),
        frozenset[str]().union(*(item.folders for item in found)),
    )


class Contents:
    """Reads and attaches. It reads each image once. Safe to share among threads."""

    def __init__(self, transfer: Transfer) -> None:
        self._transfer = transfer
        self._lists = Lists()
        self.base = cache(self._base)
        self.facts = cache(self._facts)
        self._of = cache(self._read)
        self._artifacts = cache(self._listed)

    def own(self, app: Source) -> Facts:
        """The facts of an app's own layer.

        Raises:
            RosmlError: there are none (exit code 2), or the registry does not answer or refuses.
        """
        if found := self._of(Place(app.host, app.repository, app.digest)):
            return found
        text = f"{app.name} has no facts about its packages and libraries"
        raise RosmlError(text, f"build it once more with this rosml, and without --no-sbom; {file_lists.COPY}", 2)

    def _base(self, reference: str, platform: str) -> Known:
        """What is known of a base image.

        Args:
            reference: complete, by its digest.
            platform: such as `linux/amd64`.

        Raises:
            RosmlError: something is not attached (exit code 2), or the registry does not answer or refuses.
        """
        places, found = self.places(reference, platform), self.facts(reference, platform)
        lists = [self._lists.of(self._registry(place), place.repository, place.digest) for place in places]
        if not places or not found or not all(lists):
            text = f"{reference} has no facts about its packages, libraries and files"
            remedy = f"name a base image that this rosml or a later one has published; {file_lists.COPY}"
            raise RosmlError(text, remedy, exit_code=2)
        known = [files for files in lists if files]
        paths = frozenset(path for files in known for path in _shown(files.entries))
        return Known(places, found, paths, frozenset(path for files in known for path in _shown(files.folders)))

    def _facts(self, reference: str, platform: str, depth: int = 0) -> Facts | None:
        """The facts of a base image; of an app those of all below it, too. None if it is gone, or has none."""
        source, annotations = self.member(reference, platform)
        if source is None or depth > DEPTH:
            return None
        registry = self._transfer.registries(source.host)
        if not source.labels.get(APP):
            return facts.of_member(registry, source.repository, source.digest, annotations)
        own, below = self._of(Place(source.host, source.repository, source.digest)), base_of(source)
        found = self._facts(below, platform, depth + 1) if own and below else None
        return facts.together([found, own]) if found and own else None

    def places(self, reference: str, platform: str) -> tuple[Place, ...]:
        """The images that a base image is joined from; itself if it has a list of its own."""
        source, annotations = self.member(reference, platform)
        if source is None:
            return ()
        registry, own = self._transfer.registries(source.host), Place(source.host, source.repository, source.digest)
        if self._lists.of(registry, own.repository, own.digest):
            return (own,)
        return tuple(
            Place(own.host, *item) for item in facts.components(registry, own.repository, own.digest, annotations)
        )

    def member(self, reference: str, platform: str) -> tuple[Source | None, Mapping[str, str]]:
        """An image for one platform, with the annotations of its entry in its index. None if it is gone.

        Raises:
            RosmlError: the registry does not answer or refuses.
        """
        where = references.parse(reference)
        manifest = self._transfer.manifest(where)
        if manifest is None:
            return None, {}
        source = self._transfer.members(reference, where, manifest).get(platform)
        entries = [item for item in manifest.members if source and item.digest == source.digest]
        return source, entries[0].annotations if entries else {}

    def _read(self, place: Place) -> Facts | None:
        return facts.of(self._registry(place), place.repository, place.digest)

    def _registry(self, place: Place) -> Registry:
        return self._transfer.registries(place.host)

    # ---- Attaching ---------------------------------------------------------------------------------------------------

    def attach(self, app: Source, base: Known, host: str, repository: str, manifest: bytes, with_sbom: bool) -> int:
        """Attaches the app's facts, a list of files and an SBOM to a new image. Those that it has stay.

        Args:
            app: the app's present image.
            base: its new base image.
            host: the registry of the new image.
            repository: its path.
            manifest: the new image's manifest.
            with_sbom: attach an SBOM, too.

        Returns:
            Bytes sent to the registry.

        Raises:
            RosmlError: a registry does not answer or refuses.
        """
        registry, subject = self._transfer.registries(host), oci.descriptor(oci.IMAGE, manifest)
        there = {entry.get("artifactType") for entry in registry.referrers(repository, subject["digest"])}
        before, own = registry.sent_by_this_thread, self.own(app)
        if facts.ARTIFACT not in there:
            for layer in self._artifacts(
                Place(app.host, app.repository, app.digest), facts.ARTIFACT
            ):  # all count, as in `own`
                data = self._transfer.registries(app.host).part(app.repository, layer.layers[0], facts.PACKED)
                registry.attach(repository, subject, facts.ARTIFACT, data, facts.MEDIA_TYPE)
        if file_lists.ARTIFACT not in there:
            paths = sorted({*own.files, *(path for package in own.packages for path in package.files)})
            text = "".join(f"{path}\n" for path in paths).encode()
            more = [
                layer
                for place in base.places
                for layer in file_lists.mounted(
                    self._registry(place), place.repository, place.digest, registry, repository
                )
            ]
            data = gzip.compress(text, mtime=0)
            registry.attach(repository, subject, file_lists.ARTIFACT, data, file_lists.MEDIA_TYPE, more=more)
        if with_sbom and sbom.MEDIA_TYPE not in there:
            reference = f"{host}/{repository}@{subject['digest']}"
            data = self.sbom(app, base, reference)
            registry.attach(repository, subject, sbom.MEDIA_TYPE, data, sbom.MEDIA_TYPE, sbom.FORMAT)
        return registry.sent_by_this_thread - before

    def _listed(self, place: Place, kind: str) -> list[Manifest]:
        """What is attached to an image, of one kind."""
        registry = self._registry(place)
        digests = sorted({entry["digest"] for entry in registry.referrers(place.repository, place.digest, kind)})
        found = [self._transfer.manifest(Reference(place.host, place.repository, name)) for name in digests]
        return [item for item in found if item and item.layers]

    def sbom_of(self, app: Source) -> bytes:
        """The SBOM of an app.

        Raises:
            RosmlError: it has none (exit code 2), or the registry does not answer or refuses.
        """
        place = Place(app.host, app.repository, app.digest)
        for item in self._artifacts(place, sbom.MEDIA_TYPE):
            if item.annotations.items() >= sbom.FORMAT.items():
                return self._registry(place).part(place.repository, item.layers[0])
        remedy = f"build it again, or move it once, without --no-sbom; {file_lists.COPY}"
        raise RosmlError(f"{app.name} has no SBOM", remedy, exit_code=2)

    def sbom(self, app: Source, base: Known, reference: str) -> bytes:
        """The SBOM of an app on another base image: the base image's components, and the app's own.

        Args:
            reference: the new image, by its digest.

        Raises:
            RosmlError: an SBOM is damaged, or the registry does not answer or refuses.
        """
        own = _Own(self.own(app))
        there = [*self._components(Place(app.host, app.repository, app.digest))]
        known = [item for place in base.places for item in self._components(place)]
        every = {_key(item): item for item in (*known, *(item for item in there if own.has(item)))}
        document = {
            "$schema": "http://cyclonedx.org/schema/bom-1.5.schema.json",
            "bomFormat": "CycloneDX",
            "specVersion": "1.5",
            "version": 1,
            "metadata": {"component": {"bom-ref": reference, "type": "container", "name": reference}},
            "components": [*every.values()],
        }
        return oci.encoded(document)

    def _components(self, place: Place) -> Iterator[dict[str, Any]]:
        """The components of an image's SBOM, as they are.

        Raises:
            RosmlError: its SBOM is damaged.
        """
        for item in self._artifacts(place, sbom.MEDIA_TYPE):
            if item.annotations.items() >= sbom.FORMAT.items():
                content = self._registry(place).part(place.repository, item.layers[0])
                whole = sbom.Sbom(content)
                assert whole.document, "it is read, to check it"
                yield from untrusted.json_value(content, sbom.LARGEST)["components"]


def _key(component: Mapping[str, Any]) -> str:
    """What is the same for the same component of two SBOMs. CycloneDX does not ask for a `bom-ref`."""
    return str(component.get("bom-ref") or oci.digest_of(oci.encoded(component)))


def base_of(app: Source) -> str:
    """The base image of an app, by its digest; empty if the labels name none."""
    name, digest = app.labels.get(BASE_NAME, ""), app.labels.get(BASE_DIGEST, "")
    if not references.is_digest(digest):
        return ""
    try:
        where = references.parse(name)
    except RosmlError:
        return ""
    return str(where._replace(reference=digest))


def _shown(paths: Iterable[str]) -> Iterator[str]:
    """Paths of a list, as facts have them."""
    return (path.encode("utf-8", "backslashreplace").decode() for path in paths)


class _Own:
    """The packages of an app, by name and version, to find its components among those of its base image."""

    def __init__(self, facts: Facts) -> None:
        self._apt = {(item.name, item.version) for item in facts.packages}
        paths = (*facts.files, *(path for package in facts.packages for path in package.files))
        matches = (_PYTHON.fullmatch(path) for path in paths if "-info" in path)
        self._python = {(_plain(found[1]), found[2]) for found in matches if found}

    def has(self, component: Mapping[str, Any]) -> bool:
        """Whether a component of an SBOM is of the app, and not of its base image."""
        purl, name, version = (str(component.get(key, "")) for key in ("purl", "name", "version"))
        if purl.startswith("pkg:deb/"):
            return (name, version) in self._apt
        return purl.startswith("pkg:generic/ros/") or (_plain(name), version) in self._python


def _plain(name: str) -> str:
    """The name of a package of Python as all spellings of it come to."""
    return re.sub("[-_.]+", "-", name).lower()
