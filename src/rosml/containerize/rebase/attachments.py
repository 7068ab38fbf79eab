"""What is attached to the images of apps and base images: lists of files and facts (see `images/join`), and SBOMs. It is read before an
app moves, and attached to the new image. The new SBOM has the components of the base image's and of the app's own."""

from __future__ import annotations

import gzip
import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache, lru_cache
from typing import Any

from rosml.base.errors import RosmlError
from rosml.images.image_set.labels import APP, BASE_DIGEST, BASE_NAME
from rosml.images.image_set.lock_file import package_name
from rosml.images.join import facts, file_lists
from rosml.images.join.facts import Facts
from rosml.images.join.file_lists import Lists
from rosml.images.join.layers import Source
from rosml.images.join.transfer import Transfer
from rosml.images.scan import attached, cyclonedx, sbom
from rosml.images.scan import together as sboms_of
from rosml.images.scan.attached import Attached
from rosml.images.scan.together import Named
from rosml.registry import oci, references
from rosml.registry.client import Registry
from rosml.registry.oci import Manifest
from rosml.registry.references import Reference

DEPTH = 10  # most apps on one another

LIKELY_AGAIN = 8
"""So many images' SBOMs are kept: many apps have the same base image. Each takes some ten MB."""

_PYTHON = re.compile(r"(?:.*/)?([^/-]+)-([^/-]+)(?:-py[0-9.]+)?\.(?:dist-info|egg-info)(?:/.*)?")
"""The folder or file in which a package of Python says its name and version."""


@dataclass(frozen=True)
class BaseContents:
    """For one platform. `places` are the images that it is joined from, which have lists and SBOMs; itself if it was built."""

    places: tuple[Reference, ...]
    facts: Facts
    files: frozenset[str]
    folders: frozenset[str]


def together(contents: Sequence[BaseContents]) -> BaseContents:
    if len(contents) == 1:
        return contents[0]
    return BaseContents(
        tuple(place for item in contents for place in item.places),
        facts.together(item.facts for item in contents),
        frozenset[str]().union(*(item.files for item in contents)),
        frozenset[str]().union(*(item.folders for item in contents)),
    )


class Attachments:
    """Reads and attaches. It reads each image once. Safe to share among threads."""

    def __init__(self, transfer: Transfer) -> None:
        self._transfer = transfer
        self._lists = Lists()
        self.base = cache(self._base)
        self.base_facts = cache(self._base_facts)
        self._facts = cache(lambda place: facts.of(self._registry(place), place.repository, place.reference))
        self._artifacts = cache(self._list)
        self._sboms = lru_cache(LIKELY_AGAIN)(self._read_sboms)
        self._sboms_of_base = lru_cache(LIKELY_AGAIN)(self._read_sboms_of_base)

    def app_facts(self, app: Source) -> Facts:
        if app_facts := self._facts(_place(app)):
            return app_facts
        text = f"{app.name} has no facts about its packages and libraries"
        raise RosmlError(text, f"build it once more with this rosml, and without --no-sbom; {file_lists.COPY}", 2)

    def _base(self, reference: str, platform: str) -> BaseContents:
        """The contents of a base image, by its digest. RosmlError with exit code 2 if something is not attached."""
        places, base_facts = self._places(reference, platform), self.base_facts(reference, platform)
        lists = [self._lists.of(self._registry(place), place.repository, place.reference) for place in places]
        present = [files for files in lists if files]
        if not places or not base_facts or len(present) < len(lists):
            text = f"{reference} has no facts about its packages, libraries and files"
            remedy = f"name a base image that this rosml or a later one has published; {file_lists.COPY}"
            raise RosmlError(text, remedy, exit_code=2)
        paths = frozenset(path for files in present for path in _as_in_facts(files.entries))
        folders = frozenset(path for files in present for path in _as_in_facts(files.folders))
        return BaseContents(places, base_facts, paths, folders)

    def _base_facts(self, reference: str, platform: str, depth: int = 0) -> Facts | None:
        """The facts of a base image; of an app those of all below it, too. None if it is gone, or has none."""
        source, annotations = self.member(reference, platform)
        if source is None or depth > DEPTH:
            return None
        if not source.labels.get(APP):
            return facts.of_member(self._registry(source), source.repository, source.digest, annotations)
        app_facts, below = self._facts(_place(source)), base_of(source)
        facts_below = self._base_facts(below, platform, depth + 1) if app_facts and below else None
        return facts.together([facts_below, app_facts]) if facts_below and app_facts else None

    def _places(self, reference: str, platform: str) -> tuple[Reference, ...]:
        """The images that a base image is joined from; itself if it has a list of its own."""
        source, annotations = self.member(reference, platform)
        if source is None:
            return ()
        registry, place = self._registry(source), _place(source)
        if self._lists.of(registry, place.repository, place.reference):
            return (place,)
        components = facts.components(registry, place.repository, place.reference, annotations)
        return tuple(Reference(place.host, *component) for component in components)

    def member(self, reference: str, platform: str) -> tuple[Source | None, Mapping[str, str]]:
        """An image for one platform, with the annotations of its entry in its index. None if it is gone."""
        where = references.parse(reference)
        manifest = self._transfer.manifest(where)
        if manifest is None:
            return None, {}
        source = self._transfer.members(reference, where, manifest).get(platform)
        entries = [item for item in manifest.members if source and item.digest == source.digest]
        return source, entries[0].annotations if entries else {}

    def _registry(self, place: Reference | Source) -> Registry:
        return self._transfer.registries(place.host)

    # ---- Attaching ---------------------------------------------------------------------------------------------------

    def attach(
        self, app: Source, base: BaseContents, host: str, repository: str, manifest: bytes, with_sbom: bool
    ) -> int:
        """Attaches the app's facts, a list of files and an SBOM to a new image, unless it has them. Returns the bytes that it sent."""
        registry, subject = self._transfer.registries(host), oci.descriptor(oci.IMAGE, manifest)
        present = {entry.get("artifactType") for entry in registry.referrers(repository, subject["digest"])}
        before, app_facts = registry.sent_by_this_thread, self.app_facts(app)
        if facts.ARTIFACT not in present:
            for artifact in self._artifacts(_place(app), facts.ARTIFACT):  # all count, as in `app_facts`
                data = self._registry(app).part(app.repository, artifact.layers[0], facts.PACKED)
                registry.attach(repository, subject, facts.ARTIFACT, data, facts.MEDIA_TYPE)
        if file_lists.ARTIFACT not in present:
            paths = sorted({*app_facts.files, *(path for package in app_facts.packages for path in package.files)})
            data = gzip.compress("".join(f"{path}\n" for path in paths).encode(), mtime=0)
            below = [
                layer
                for place in base.places
                for layer in file_lists.mounted(
                    self._registry(place), place.repository, place.reference, registry, repository
                )
            ]
            content = oci.artifact(file_lists.ARTIFACT, data, file_lists.MEDIA_TYPE, subject=subject)
            registry.attach_with_layers(repository, data, content, below)
        if with_sbom and sbom.MEDIA_TYPE not in present:
            data = self.new_sbom(app, base, f"{host}/{repository}@{subject['digest']}")
            attached.attach(registry, repository, subject, data)
        return registry.sent_by_this_thread - before

    def _list(self, place: Reference, kind: str) -> list[Manifest]:
        digests = {
            entry["digest"] for entry in self._registry(place).referrers(place.repository, place.reference, kind)
        }
        manifests = [self._transfer.manifest(place._replace(reference=digest)) for digest in sorted(digests)]
        return [manifest for manifest in manifests if manifest and manifest.layers]

    # ---- SBOMs -------------------------------------------------------------------------------------------------------

    def _read_sboms_of_base(self, place: Reference) -> list[Named]:
        return sboms_of.of_manifest(self._registry(place), place.repository, place.reference)

    def _read_sboms(self, place: Reference) -> Attached:
        return attached.read(self._registry(place), place.repository, place.reference)

    def sbom(self, app: Source) -> bytes:
        return self._sboms(_place(app)).first(app.name).content

    def new_sbom(self, app: Source, base: BaseContents, reference: str) -> bytes:
        """The SBOM of the new image `reference`: the base image's components, and the app's own."""
        of_base = (item for place in base.places for item in self._sboms_of_base(place))
        is_own = _is_of_app(self.app_facts(app))
        of_app = ((cyclonedx.APP, sbom.Sbom(item.content, is_own)) for item in self._sboms(_place(app)).sboms)
        return cyclonedx.joined(reference, cyclonedx.created(app.config.facts), (*of_base, *of_app))


def _place(source: Source) -> Reference:
    return Reference(source.host, source.repository, source.digest)


def base_of(app: Source) -> str:
    """The base image of an app, by its digest; empty if the labels name none."""
    name, digest = app.labels.get(BASE_NAME, ""), app.labels.get(BASE_DIGEST, "")
    if not references.is_digest(digest):
        return ""
    try:
        return str(references.parse(name)._replace(reference=digest))
    except RosmlError:
        return ""


def _as_in_facts(paths: Iterable[str]) -> Iterator[str]:
    return (path.encode("utf-8", "backslashreplace").decode() for path in paths)


def _is_of_app(app_facts: Facts) -> Callable[[Mapping[str, Any]], bool]:
    """Whether a component of an app's SBOM is not its base image's."""
    apt = {(package.name, package.version) for package in app_facts.packages}
    paths = (*app_facts.files, *(path for package in app_facts.packages for path in package.files))
    matches = (_PYTHON.fullmatch(path) for path in paths if "-info" in path)
    python = {(package_name(match[1]), match[2]) for match in matches if match}

    def is_own(component: Mapping[str, Any]) -> bool:
        purl, name, version = (str(component.get(key, "")) for key in ("purl", "name", "version"))
        if purl.startswith("pkg:deb/"):
            return (name, version) in apt
        return purl.startswith("pkg:generic/ros/") or (package_name(name), version) in python

    return is_own
