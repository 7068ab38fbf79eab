"""Joins images in a registry: pushes a new manifest and config for existing layers, and pulls no layer.

The tag moves last: before, only somebody who knows its digest can see the image. If a call is interrupted, the next one
finds by digest what was pushed, and costs next to nothing.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, dataclass, field
from itertools import combinations
from typing import Any

from rosml.base.errors import RosmlError
from rosml.base.problems import listed
from rosml.images.image_set import restricted
from rosml.images.image_set.labels import ENVIRONMENT, JOINED, OCI
from rosml.images.image_set.restricted import Declared
from rosml.images.join import facts, file_lists, short_names
from rosml.images.join.environments import join, require_apart, require_packages, require_python
from rosml.images.join.file_lists import COPY, Files, Lists
from rosml.images.join.layers import Joined, Source
from rosml.images.join.transfer import Transfer, Transferred
from rosml.images.matrix import names
from rosml.registry import oci, references
from rosml.registry.client import Registry
from rosml.registry.references import Reference

UNLISTED = f"use one that has it: for an app, the run image, built without --no-sbom; {COPY}; or continue with --allow-unlisted"
"""The remedy for an image without a list of its files."""


@dataclass
class JoinReport(Transferred):
    """The result of a join."""

    reference: str = ""  # for FROM; with the tag, if one was moved
    digest: str = ""  # of the index, or of the manifest if there is no index
    unlisted: list[str] = field(default_factory=list)  # images without a list of files, which may hide another's file

    def to_json(self) -> dict[str, Any]:
        return asdict(self)


class Joiner:
    """Joins images. It reads each ROS image and part once. Safe to share among threads."""

    def __init__(
        self,
        registries: Callable[[str], Registry],
        *,
        allow_unlisted: bool = False,
        say: Callable[[str], None] = lambda _: None,
        declared: Callable[[], Declared] = restricted.of_this_machine,
        unlisted: str = UNLISTED,
        describe: Callable[[Sequence[Source], Joined, Reference], None] = lambda *_: None,
    ) -> None:
        """`declared` gives where restricted parts may go; `unlisted` is the remedy for an image without a list of files. `describe` is called
        with what an image was joined from, the image, and where it is, before a tag moves to it."""
        self.allow_unlisted = allow_unlisted
        self._remedy = unlisted
        self._transfer = Transfer(registries, say, declared)
        self._lists = Lists()
        self._say = say
        self._describe = describe

    def __enter__(self) -> Joiner:
        return self

    def __exit__(self, failed: object, *_: object) -> None:
        self._transfer.close(failed)

    def join(
        self, ros: str, parts: Sequence[str], target: str, platforms: Sequence[str] = (), local: str = ""
    ) -> JoinReport:
        """Joins an image for every platform that all have in common, or some of these, and moves the tag `target` to it.

        Args:
            parts: references, and short names of environments, such as `env:lerobot`.
            local: the place of images in the local registry, if there is one: environments may be there.
        """
        started = time.monotonic()
        place = references.parse(target)
        if references.is_digest(place.reference):
            raise RosmlError(f"{target} is a digest, but the target must be a tag", "write it with a tag", exit_code=2)
        parts = [self._in_full(part, ros, local) for part in parts]
        if str(place) in {str(references.parse(source)) for source in (ros, *parts)}:
            text = f"{target} is one of the images to join, and would be overwritten"
            raise RosmlError(text, "choose another tag", exit_code=2)
        sources = self._read([ros, *parts])
        common = _common(sources, platforms)
        if not platforms:
            self._say_left_out(sources, common)
        members = [[by_platform[name] for _, by_platform in sources] for name in common]
        joined = [self._joined(group) for group in members]
        images, unlisted = [image for image, _ in joined], dict.fromkeys(name for _, names in joined for name in names)
        for image in images:  # before the first one is pushed
            self._transfer.require_allowed(image.labels, target, place)
        report = JoinReport(reference=str(place), unlisted=[*unlisted])
        for image, group in zip(images, members, strict=True):
            report.manifests[image.platform] = self._transfer.push(image, place.host, place.repository, report)
            self._describe(group, image, place)
        origins = {
            image.platform: sorted({digest for source in group for _, digest in self._places(source, group)})
            for image, group in zip(images, members, strict=True)
        }
        index = oci.encoded(_index(images, origins))
        registry = self._transfer.registries(place.host)
        report.digest = registry.put_manifest(place.repository, place.reference, index, oci.INDEX)
        report.uploaded += len(index)
        report.seconds = time.monotonic() - started
        return report

    def _in_full(self, part: str, ros: str, local: str) -> str:
        """The reference of a part. An environment with a short name is beside the ROS image, or in the local registry."""
        name = short_names.environment(part)
        if not name:
            return part
        image = self._transfer.one(ros)
        places = short_names.beside(image.host, image.repository), local
        return short_names.find(self._transfer, name, require_python(image), places)

    def check(self, ros: str, parts: Sequence[str], platforms: Sequence[str]) -> dict[str, Joined]:
        """The joined images for some platforms, of which nothing is pushed."""
        sources = self._read([ros, *parts])
        return {
            name: self._joined([by_platform[name] for _, by_platform in sources])[0]
            for name in _common(sources, platforms)
        }

    def manifest(self, ros: Reference, parts: Sequence[Reference], host: str, repository: str) -> JoinReport:
        """Joins an image from manifests for one platform, without an index or a tag."""
        started = time.monotonic()
        sources = list(self._transfer.pool.map(lambda item: self._transfer.source(str(item), item), (ros, *parts)))
        image, unlisted = self._joined(sources)
        place = str(Reference(host, repository, image.digest))
        report = JoinReport({image.platform: image.digest}, reference=place, digest=image.digest, unlisted=unlisted)
        self._transfer.push(image, host, repository, report)
        report.seconds = time.monotonic() - started
        return report

    def _read(self, names: Sequence[str]) -> _ByName:
        return list(zip(names, self._transfer.pool.map(self._transfer.platforms, names), strict=True))

    def _say_left_out(self, sources: _ByName, common: Sequence[str]) -> None:
        first, platforms = sources[0]
        if extra := [name for name in platforms if name not in common]:
            without = [name for name, other in sources if any(item not in other for item in extra)]
            self._say(f"left out: {first} is also for {listed(extra)}, but {listed(without)} is not")

    # ---- Joining -----------------------------------------------------------------------------------------------------

    def _joined(self, sources: Sequence[Source]) -> tuple[Joined, list[str]]:
        """A joined image, and which of its sources have no list of files."""
        return join(sources[0], sources[1:]), self._unlisted(sources)

    def _unlisted(self, sources: Sequence[Source]) -> list[str]:
        """Checks by their lists that no two images carry the same file. Returns those without a list, if that is allowed."""
        lists = list(self._transfer.pool.map(lambda source: self._files(source, sources), sources))
        if unlisted := [source.name for source, files in zip(sources, lists, strict=True) if files is None]:
            text = f"{listed(unlisted)} has no list of its files, so it may carry the same file as another image"
            if not self.allow_unlisted:
                raise RosmlError(text, self._remedy, exit_code=2)
            self._say(text)
        pairs = [(source.name, files) for source, files in zip(sources, lists, strict=True) if files is not None]
        for (name, files), (other, others) in combinations(pairs, 2):
            if path := self._lists.clash(files, others):
                text = f"{name} and {other} both carry /{path}: one would hide the other's"
                remedy = "remove the file, or the package that has it, from one of them, and publish that image again"
                raise RosmlError(text, remedy, exit_code=2)
        environments = {source.name: source for source in sources if source.labels.get(ENVIRONMENT)}
        beside = {name: files.entries for name, files in pairs if name not in environments}
        for name, files in pairs:
            if name in environments:
                require_apart(environments[name], files.entries, beside)
                if not unlisted:
                    require_packages(environments[name], beside)
        return unlisted

    def _files(self, source: Source, beside: Sequence[Source]) -> Files | None:
        """The files of an image, by its own list or those of what it was joined from, which may lie beside the images of this join."""
        registry = self._transfer.registries(source.host)
        if files := self._lists.of(registry, source.repository, source.digest):
            return files
        lists = [self._lists.of(registry, *place) for place in self._places(source, beside)]
        present = [files for files in lists if files]
        return file_lists.together(present) if present and len(present) == len(lists) else None

    def _places(self, source: Source, beside: Sequence[Source]) -> list[tuple[str, str]]:
        """Repositories and digests of the images with lists of an image's files."""
        registry = self._transfer.registries(source.host)
        if self._lists.of(registry, source.repository, source.digest):
            return [(source.repository, source.digest)]
        near = [item.repository for item in beside if item.host == source.host]
        near += [f"{path.rpartition('/')[0]}/{names.ROS}".lstrip("/") for path in near]
        return facts.components(registry, source.repository, source.digest, source.annotations, near)


_ByName = Sequence[tuple[str, Mapping[str, Source]]]
"""Images by the user's names, each by platform."""


def _common(sources: _ByName, requested: Sequence[str]) -> list[str]:
    """The platforms that all images have, or the requested ones."""
    offers = {name: listed(sorted(platforms)) or "no platform" for name, platforms in sources}
    for name, platforms in sources:
        for platform in requested:
            if platform not in platforms:
                text = f"{name} is for {offers[name]}, not for {platform}"
                raise RosmlError(text, "choose a platform that all of them have", exit_code=2)
    common = [name for name in sorted(sources[0][1]) if all(name in platforms for _, platforms in sources)]
    if not common:
        text = "; ".join(f"{name} is for {offers[name]}" for name, _ in sources)
        raise RosmlError(f"no platform in common: {text}", "use images for one platform", exit_code=2)
    return list(dict.fromkeys(requested)) or common


def _index(images: Sequence[Joined], origins: Mapping[str, Sequence[str]]) -> dict[str, Any]:
    """The index, with labels of OCI as annotations. `origins` are digests of joined images, by platform."""
    entries = []
    for image in sorted(images, key=lambda item: item.platform):
        os, architecture, *variant = image.platform.split("/")
        place = {"os": os, "architecture": architecture, **({"variant": variant[0]} if variant else {})}
        digests = " ".join(origins[image.platform])
        joined = {"annotations": {JOINED: digests}} if digests else {}
        entries.append({**oci.descriptor(oci.IMAGE, image.manifest), "platform": place, **joined})
    annotations = {key: text for key, text in images[0].labels.items() if key.startswith(OCI)}
    return {"schemaVersion": 2, "mediaType": oci.INDEX, "manifests": entries, "annotations": annotations}
