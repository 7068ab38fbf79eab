"""Reads manifests and configs of images, and pushes new ones for existing layers. Pulls no layer but from another registry."""

from __future__ import annotations

import threading
from collections.abc import Callable, Mapping
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from typing import Any

from rosml.base.errors import RosmlError
from rosml.base.problems import near, some
from rosml.images.image_set import restricted
from rosml.images.image_set.labels import TITLE
from rosml.images.image_set.restricted import Declared
from rosml.images.join.layers import Joined, Source, platform
from rosml.registry import oci, references
from rosml.registry.client import Registry
from rosml.registry.references import Reference

THREADS = 8
"""How many requests are sent at a time: a distant registry takes a tenth of a second for each."""

MEMBERS = 200
"""The most images of an index, with attestations. Each takes two requests."""


@dataclass
class Transferred:
    """Counts of a push."""

    manifests: dict[str, str] = field(default_factory=dict)  # digest of the image manifest for each platform
    layers: int = 0  # on all platforms
    mounted: int = 0  # layers that the registry mounted from another repository
    present: int = 0  # layers that the repository had already
    copied: int = 0  # layers from another registry
    uploaded: int = 0  # bytes sent to the registry
    seconds: float = 0.0


class Transfer:
    """Reads and pushes images. It reads each manifest and config once. Safe to share among threads."""

    def __init__(
        self,
        registries: Callable[[str], Registry],
        say: Callable[[str], None] = lambda _: None,
        declared: Callable[[], Declared] = restricted.of_this_machine,
    ) -> None:
        """`declared` gives where restricted parts may go."""
        self.registries = registries
        self._say, self._notices, self._declared = say, set[str](), declared
        self.pool = ThreadPoolExecutor(THREADS)
        self._sources: dict[Reference, Source] = {}
        self._manifests: dict[Reference, oci.Manifest] = {}
        self._lock = threading.Lock()

    def __enter__(self) -> Transfer:
        return self

    def __exit__(self, failed: object, *_: object) -> None:
        self.close(failed)

    def close(self, failed: object = None) -> None:
        """Waits for requests that are under way, unless something failed: after Ctrl-C, nobody waits for a registry."""
        self.pool.shutdown(wait=not failed, cancel_futures=True)

    def platforms(self, name: str) -> Mapping[str, Source]:
        where = references.parse(name)
        registry, manifest = self.registries(where.host), self.manifest(where)
        if manifest is None:
            raise RosmlError(f"{name} is not there", _near(registry, where), 2)
        return self.members(name, where, manifest)

    def manifest(self, where: Reference) -> oci.Manifest | None:
        """The manifest of a place; None if there is none. One that is named by its digest is read once."""
        if manifest := self._manifests.get(where):
            return manifest
        manifest = self.registries(where.host).manifest(where.repository, where.reference)
        if manifest and references.is_digest(where.reference):
            self._manifests[where] = manifest
        return manifest

    def members(self, name: str, where: Reference, manifest: oci.Manifest) -> Mapping[str, Source]:
        """The image of a manifest or index that was read already, by platform. `name` is the user's name of it."""
        if len(manifest.members) > MEMBERS:
            text = f"{name} is an index of {len(manifest.members):,} images, and at most {MEMBERS} are read"
            raise RosmlError(text, "name another image", exit_code=2)
        if not manifest.is_index:
            source = self.source(name, where._replace(reference=manifest.digest), manifest)
            return {source.platform: source}
        entries = {platform(entry.platform): entry for entry in manifest.members}
        return {
            key: self.source(name, where._replace(reference=entry.digest), annotations=entry.annotations)
            for key, entry in entries.items()
            if "unknown" not in key  # attestations of buildx
        }

    def one(self, name: str, manifest: oci.Manifest | None = None) -> Source:
        """The image of a complete reference for one platform, whichever it is. `manifest` saves reading it again."""
        members = self.members(name, references.parse(name), manifest) if manifest else self.platforms(name)
        for source in members.values():
            return source
        raise RosmlError(f"{name} is for no platform", "publish it again", exit_code=2)

    def source(
        self,
        name: str,
        where: Reference,
        manifest: oci.Manifest | None = None,
        annotations: Mapping[str, str] | None = None,
    ) -> Source:
        """An image for one platform, by its digest. `name` is the user's name of it, for messages."""
        if where not in self._sources:
            registry = self.registries(where.host)
            manifest = manifest or self.manifest(where)
            if manifest is None:
                raise RosmlError(f"{where} is not there any more", "check its name", exit_code=2)
            config = registry.config(where.repository, manifest, str(where))
            source = Source(name, where.host, where.repository, manifest.digest, manifest, config, annotations or {})
            with self._lock:
                self._sources.setdefault(where, source)
        return self._sources[where]

    def require_allowed(self, labels: Mapping[str, str], name: str, where: Reference) -> None:
        """Checks that an image may go to a place: it may have restricted parts."""
        if parts := restricted.parts_of(labels):
            notice = restricted.require(parts, name, where.host, where.repository, self._declared())
            with self._lock:
                is_new = notice not in self._notices
                self._notices.add(notice)
            if notice and is_new:
                self._say(notice)

    def push(self, image: Joined, host: str, repository: str, counts: Transferred) -> str:
        """Pushes an image by digest, without a tag. Returns the digest. The counters of `counts` grow."""
        self.require_allowed(image.labels, image.labels.get(TITLE, repository), Reference(host, repository, ""))
        registry = self.registries(host)
        counts.layers += len(image.layers)
        if registry.head(repository, image.digest):  # then all its layers are there, too
            counts.present += len(image.layers)
            return image.digest
        unique = {layer["digest"]: (layer, source) for layer, source in image.layers}
        ways = self.pool.map(lambda item: self._bring(registry, repository, *item), unique.values())
        by_digest = dict(zip(unique, ways, strict=True))
        for layer, _ in image.layers:
            way = by_digest[layer["digest"]]
            setattr(counts, way, getattr(counts, way) + 1)
        copied = sum(layer["size"] for layer, _ in unique.values() if by_digest[layer["digest"]] == "copied")
        registry.put_blob(repository, image.config)
        registry.put_manifest(repository, "", image.manifest, oci.IMAGE)
        counts.uploaded += copied + len(image.config) + len(image.manifest)
        return image.digest

    def _bring(self, registry: Registry, repository: str, layer: Mapping[str, Any], source: Source) -> str:
        """Adds a layer to the repository. Returns the name of the counter for its way there."""
        digest = layer["digest"]
        if source.host == registry.host:
            if source.repository == repository:
                return "present"
            if registry.mount(repository, digest, source.repository):
                return "mounted"
        if registry.has_blob(repository, digest):
            return "present"
        registry.copy_blob(repository, digest, layer["size"], self.registries(source.host), source.repository)
        return "copied"


def _near(registry: Registry, where: Reference) -> str:
    """The remedy for a missing image: names of tags near its own, or some of those that its repository has."""
    if references.is_digest(where.reference):
        return references.GONE
    tags = [tag for tag in registry.tags(where.repository) if not tag.startswith("sha256-")]  # lists of attached things
    if close := near(where.reference, tags):
        return f"check its name: {close}"
    present = f"its tags are {some(sorted(tags))}" if tags else f"{where.host}/{where.repository} has no tags"
    return f"check its name: {present}"
