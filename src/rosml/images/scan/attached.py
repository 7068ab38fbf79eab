"""The SBOMs of an image in a registry: those that rosml attached to its manifest.

Everybody who may push into a repository can attach an SBOM, also one that looks like ours. What counts where a false one could let an
image pass is read by `sbom.Shelf`.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from rosml.base import units
from rosml.base.errors import RosmlError
from rosml.images.scan.sbom import FORMAT, LARGEST, MEDIA_TYPE, Sbom
from rosml.registry import documents
from rosml.registry.client import Registry
from rosml.registry.documents import Descriptor
from rosml.registry.oci import digest_of

MOST = 32
"""The most artifacts that are read. An image has one of each publisher and format; further ones are somebody else's."""

BLOB = "io.rosml.sbom.blob"
"""The annotation with the digest and the size of the SBOM itself. So it is read without its artifact, since lists of artifacts have annotations."""

REMEDY = "build it again with this rosml, and without --no-sbom; of a copy, copy what is attached to it as well: regctl image copy --referrers"


@dataclass(frozen=True)
class Ignored:
    """An SBOM that does not count."""

    digest: str  # of the artifact
    why: str


@dataclass(frozen=True)
class Attached:
    sboms: tuple[Sbom, ...]
    """Ours, by the digests of their artifacts: of the newest format; of older ones if there is no other."""

    ignored: tuple[Ignored, ...]
    artifacts: tuple[str, ...] = ()
    """The digests of the artifacts with `sboms`."""

    def first(self, image: str) -> Sbom:
        """The SBOM that counts. RosmlError with exit code 2 if there is none; `image` is the name in its message."""
        for sbom in self.sboms:
            return sbom
        others = "; ".join(f"{it.digest} does not count: {it.why}" for it in self.ignored[:3])
        raise RosmlError(f"{image} has no SBOM of rosml{f' ({others})' if others else ''}", REMEDY, exit_code=2)


def attach(registry: Registry, repository: str, subject: Mapping[str, Any], content: bytes) -> str:
    """Attaches our SBOM to the manifest of a descriptor. Returns the digest of its artifact."""
    annotations = {**FORMAT, BLOB: f"{digest_of(content)} {len(content)}"}
    return registry.attach(repository, subject, MEDIA_TYPE, content, MEDIA_TYPE, annotations)


def read(
    registry: Registry,
    repository: str,
    digest: str,
    largest: int = LARGEST,
    is_of: Callable[[Sbom, str], bool] = Sbom.is_of,
) -> Attached:
    """The SBOMs of the manifest of an image for one platform, of at most `largest` bytes together. If it is gone, there are none.

    The smallest are read first, so that a large one of somebody else does not take the place of ours.
    """
    entries = {entry["digest"]: entry for entry in registry.referrers(repository, digest, MEDIA_TYPE)}
    listed = sorted(entries)
    ignored = [Ignored(name, f"only {MOST} are read") for name in listed[MOST:]]
    candidates = list[tuple[int, str, Descriptor]]()
    for name in listed[:MOST]:
        blob = _blob(registry, repository, digest, Descriptor.model_validate(entries[name]))
        if isinstance(blob, str):
            ignored.append(Ignored(name, blob))
        elif blob.size > largest:
            why = f"it has {units.size(blob.size)}, and at most {units.size(largest)} are read"
            ignored.append(Ignored(name, why))
        else:
            candidates.append((blob.size, name, blob))
    newest, older, total = dict[str, Sbom](), dict[str, Sbom](), 0
    for size, name, blob in sorted(candidates, key=lambda it: it[:2]):
        total += size
        if total > largest:
            why = f"at most {units.size(largest)} of SBOMs are read of an image, the smallest first"
            ignored.append(Ignored(name, why))
            continue
        sbom = Sbom(registry.part(repository, blob, largest))
        if why := _of_another(sbom, digest, is_of):
            ignored.append(Ignored(name, why))
        else:
            (newest if blob.annotations.items() >= FORMAT.items() else older)[name] = sbom
    ours = dict(sorted((newest or older).items()))
    return Attached(tuple(ours.values()), tuple(ignored), tuple(ours))


def _blob(registry: Registry, repository: str, digest: str, entry: Descriptor) -> Descriptor | str:
    """The descriptor of an SBOM, with the annotations of its artifact; or why the artifact is none of ours."""
    size = re.fullmatch(rf"({documents.DIGEST}) ([0-9]{{1,15}})", entry.annotations.get(BLOB, ""))
    if size and entry.annotations.keys() >= FORMAT.keys():
        return Descriptor(mediaType=MEDIA_TYPE, digest=size[1], size=int(size[2]), annotations=entry.annotations)
    artifact = registry.manifest(repository, entry.digest)
    if artifact is None:
        return "it is gone"
    if not artifact.annotations.keys() >= FORMAT.keys():
        return "somebody else attached it"
    if artifact.subject != digest or len(artifact.layers) != 1:
        return "it is not attached as rosml attaches SBOMs"
    return artifact.layers[0].model_copy(update={"annotations": artifact.annotations})


def _of_another(sbom: Sbom, digest: str, is_of: Callable[[Sbom, str], bool]) -> str:
    try:
        return "" if is_of(sbom, digest) else "it is of another image"
    except RosmlError as error:
        return error.message
