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
from rosml.images.image_set.labels import JOINED
from rosml.images.image_set.restricted import Declared
from rosml.images.join import facts, file_lists
from rosml.images.join.file_lists import COPY, Files, Lists
from rosml.images.join.layers import Joined, Source, join
from rosml.images.join.transfer import Transfer, Transferred
from rosml.images.matrix import names
from rosml.registry import oci, references
from rosml.registry.client import Registry
from rosml.registry.references import Reference

UNLISTED = f"use one that has it: for an app, the run image, built without --no-sbom; {COPY}; or continue with --allow-unlisted"
"""The remedy for an image without a list of its files."""


@dataclass
class JoinReport(Transferred):
    """The result of a join.

    Attributes:
        reference: what to put after FROM; with the tag, if one was moved.
        digest: of the index, or of the manifest if there is no index.
        unlisted: images without a list of files, which may carry the same file as another image.
    """

    reference: str = ""
    digest: str = ""
    unlisted: list[str] = field(default_factory=list)

    def to_json(self) -> dict[str, Any]:
        """For `--json`."""
        return asdict(self)


class Joiner:
    """Joins images. It reads each ROS image and part once. Safe to share among threads.

    Attributes:
        allow_unlisted: continue if an image has no list of files.
    """

    def __init__(
        self,
        registries: Callable[[str], Registry],
        *,
        allow_unlisted: bool = False,
        say: Callable[[str], None] = lambda _: None,
        declared: Callable[[], Declared] = restricted.of_this_machine,
        unlisted: str = UNLISTED,
    ) -> None:
        """
        Args:
            registries: gives the client of a host.
            allow_unlisted: continue if an image has no list of files.
            say: prints a line for people.
            declared: gives where restricted parts may go.
            unlisted: the remedy for an image without a list of files.
        """
        self.allow_unlisted = allow_unlisted
        self._unlisted = unlisted
        self._transfer = Transfer(registries, say, declared)
        self._lists = Lists()
        self._say = say

    def __enter__(self) -> Joiner:
        return self

    def __exit__(self, failed: object, *_: object) -> None:
        self._transfer.close(failed)

    def join(self, ros: str, parts: Sequence[str], target: str, platforms: Sequence[str] = ()) -> JoinReport:
        """Joins an image for every platform that a ROS image and parts have in common, and tags it.

        Args:
            ros: complete reference of an index or manifest.
            parts: complete references of indexes or manifests.
            target: complete reference with the tag to move.
            platforms: only these, such as `linux/arm64`; all common ones if empty.

        Raises:
            RosmlError: they do not fit together (exit code 2), or a registry does not answer or refuses. No tag was
                moved.
        """
        started = time.monotonic()
        where = references.parse(target)
        if references.is_digest(where.reference):
            raise RosmlError(f"{target} is a digest, but the target must be a tag", "write it with a tag", exit_code=2)
        if str(where) in {str(references.parse(source)) for source in (ros, *parts)}:
            text = f"{target} is one of the images to join, and would be overwritten"
            raise RosmlError(text, "choose another tag", exit_code=2)
        named = [ros, *parts]
        read = self._transfer.pool.map(self._transfer.platforms, named)
        found = list(zip(named, read, strict=True))
        wanted = _common(found, platforms)
        self._say_what_is_left_out(found, wanted, platforms)
        result = JoinReport()
        members = [[item[name] for _, item in found] for name in wanted]
        images = [self._joined(sources, result) for sources in members]
        for image in images:  # before the first one is pushed
            self._transfer.require_allowed(image.labels, target, where)
        for image in images:
            result.manifests[image.platform] = self._transfer.push(image, where.host, where.repository, result)
        origins = {
            image.platform: sorted({digest for source in sources for _, digest in self._places(source, sources)})
            for image, sources in zip(images, members, strict=True)
        }
        index = oci.encoded(_index(images, origins))
        result.digest = self._transfer.registries(where.host).put_manifest(
            where.repository, where.reference, index, oci.INDEX
        )
        result.uploaded += len(index)
        result.reference = str(where)
        result.seconds = time.monotonic() - started
        return result

    def check(self, ros: str, parts: Sequence[str], platforms: Sequence[str]) -> dict[str, Joined]:
        """The joined images for some platforms, of which nothing is pushed.

        Args:
            ros: complete reference of an index or manifest.
            parts: complete references of indexes or manifests.
            platforms: such as `linux/arm64`.

        Raises:
            RosmlError: as in `join`.
        """
        named = [ros, *parts]
        found = list(zip(named, self._transfer.pool.map(self._transfer.platforms, named), strict=True))
        wanted = _common(found, platforms)
        return {name: self._joined([item[name] for _, item in found], JoinReport()) for name in wanted}

    def manifest(self, ros: Reference, parts: Sequence[Reference], host: str, repository: str) -> JoinReport:
        """Joins an image from manifests for one platform, without an index or a tag.

        Args:
            ros: the ROS image, by digest.
            parts: by digest.
            host: the registry for the image.
            repository: the path for the image.

        Raises:
            RosmlError: as in `join`.
        """
        started = time.monotonic()
        sources = list(self._transfer.pool.map(lambda item: self._transfer.source(str(item), item), (ros, *parts)))
        result = JoinReport()
        image = self._joined(sources, result)
        digest = self._transfer.push(image, host, repository, result)
        result.manifests[image.platform] = result.digest = digest
        result.reference = str(Reference(host, repository, digest))
        result.seconds = time.monotonic() - started
        return result

    def _say_what_is_left_out(
        self, found: Sequence[tuple[str, Mapping[str, Source]]], wanted: Sequence[str], asked: Sequence[str]
    ) -> None:
        first, known = found[0]
        if left := [name for name in known if name not in wanted and not asked]:
            without = [name for name, other in found if any(item not in other for item in left)]
            self._say(f"left out: {first} is also for {listed(left)}, but {listed(without)} is not")

    # ---- Joining -----------------------------------------------------------------------------------------------------

    def _joined(self, sources: Sequence[Source], result: JoinReport) -> Joined:
        image = join(sources[0], sources[1:])
        self._compare(sources, result)
        return image

    def _compare(self, sources: Sequence[Source], result: JoinReport) -> None:
        """Checks by their lists that no two images carry the same file.

        Raises:
            RosmlError: two carry the same file, or an image has no list, unless `allow_unlisted` is set (exit code 2).
        """
        lists = list(self._transfer.pool.map(lambda source: self._files(source, sources), sources))
        if unlisted := [source.name for source, files in zip(sources, lists, strict=True) if files is None]:
            text = f"{listed(unlisted)} has no list of its files, so it may carry the same file as another image"
            if not self.allow_unlisted:
                raise RosmlError(text, self._unlisted, exit_code=2)
            self._say(text)
            result.unlisted += [name for name in unlisted if name not in result.unlisted]
        known: list[tuple[Source, Files]] = [
            (source, files) for source, files in zip(sources, lists, strict=True) if files is not None
        ]
        for (one, files), (other, others) in combinations(known, 2):
            if name := self._lists.clash(files, others):
                text = f"{one.name} and {other.name} both carry /{name}: one would hide the other's"
                raise RosmlError(
                    text,
                    "remove the file, or the package that has it, from one of them, and publish that image again",
                    exit_code=2,
                )

    def _files(self, source: Source, beside: Sequence[Source]) -> Files | None:
        """The files of an image: by its own list, or by those of the images that it was joined from.

        Args:
            beside: the images of the present join, in whose repositories those may be as well.
        """
        registry = self._transfer.registries(source.host)
        if own := self._lists.of(registry, source.repository, source.digest):
            return own
        lists = [self._lists.of(registry, *place) for place in self._places(source, beside)]
        known = [files for files in lists if files]
        return file_lists.together(known) if known and len(known) == len(lists) else None

    def _places(self, source: Source, beside: Sequence[Source]) -> list[tuple[str, str]]:
        """Repositories and digests of the images with lists of an image's files."""
        registry = self._transfer.registries(source.host)
        if self._lists.of(registry, source.repository, source.digest):
            return [(source.repository, source.digest)]
        near = [item.repository for item in beside if item.host == source.host]
        near += [f"{path.rpartition('/')[0]}/{names.ROS}".lstrip("/") for path in near]
        return facts.components(registry, source.repository, source.digest, source.annotations, near)


def _common(found: Sequence[tuple[str, Mapping[str, Source]]], asked: Sequence[str]) -> list[str]:
    """The platforms that all images have, or the requested ones.

    Raises:
        RosmlError: an image lacks a requested platform, or no platform is common to all images (exit code 2).
    """
    for name, known in found:
        for wanted in asked:
            if wanted not in known:
                text = f"{name} is for {listed(sorted(known)) or 'no platform'}, not for {wanted}"
                raise RosmlError(text, "choose a platform that all of them have", exit_code=2)
    common = [name for name in sorted(found[0][1]) if all(name in known for _, known in found)]
    if not common:
        text = "; ".join(f"{name} is for {listed(sorted(known)) or 'no platform'}" for name, known in found)
        raise RosmlError(f"no platform in common: {text}", "use images for one platform", exit_code=2)
    return list(dict.fromkeys(asked)) or common


def _index(images: Sequence[Joined], origins: Mapping[str, Sequence[str]]) -> dict[str, Any]:
    """The index of an image's manifests, with their labels of OCI as annotations.

    Args:
        origins: the digests of the images from which each was joined, by its platform.
    """
    entries = []
    for image in sorted(images, key=lambda item: item.platform):
        os, architecture, *variant = image.platform.split("/")
        place = {"os": os, "architecture": architecture, **({"variant": variant[0]} if variant else {})}
        noted = {"annotations": {JOINED: " ".join(found)}} if (found := origins[image.platform]) else {}
        entries.append({**oci.descriptor(oci.IMAGE, image.manifest), "platform": place, **noted})
    said = {key: text for key, text in images[0].labels.items() if key.startswith("org.opencontainers.image.")}
    return {"schemaVersion": 2, "mediaType": oci.INDEX, "manifests": entries, "annotations": said}
