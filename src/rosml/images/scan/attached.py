"""The SBOMs of an image in a registry: those that rosml attached to its manifest.

Everybody who may push into a repository can attach an SBOM, also one that looks like ours. What counts where a false one could let an
image pass is read by `sbom.Shelf`.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from rosml.base import units
from rosml.base.errors import RosmlError
from rosml.images.scan.sbom import FORMAT, LARGEST, MEDIA_TYPE, Sbom
from rosml.registry.client import Registry
from rosml.registry.oci import Manifest

MOST = 32
"""The most artifacts that are read. An image has one of each publisher and format; further ones are somebody else's."""

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
    listed = sorted({entry["digest"] for entry in registry.referrers(repository, digest, MEDIA_TYPE)})
    ignored = [Ignored(name, f"only {MOST} are read") for name in listed[MOST:]]
    candidates = list[tuple[int, str, Manifest]]()
    for name in listed[:MOST]:
        artifact = registry.manifest(repository, name)
        why = _refused(artifact, digest, largest)
        if artifact and not why:
            candidates.append((artifact.layers[0].size, name, artifact))
        else:
            ignored.append(Ignored(name, why))
    newest, older, total = dict[str, Sbom](), dict[str, Sbom](), 0
    for size, name, artifact in sorted(candidates, key=lambda it: it[:2]):
        total += size
        if total > largest:
            why = f"at most {units.size(largest)} of SBOMs are read of an image, the smallest first"
            ignored.append(Ignored(name, why))
            continue
        sbom = Sbom(registry.part(repository, artifact.layers[0], largest))
        if why := _of_another(sbom, digest, is_of):
            ignored.append(Ignored(name, why))
        else:
            (newest if artifact.annotations.items() >= FORMAT.items() else older)[name] = sbom
    ours = dict(sorted((newest or older).items()))
    return Attached(tuple(ours.values()), tuple(ignored), tuple(ours))


def _refused(artifact: Manifest | None, digest: str, largest: int) -> str:
    """Why an artifact is none of ours; empty if it may be one."""
    if artifact is None:
        return "it is gone"
    if not artifact.annotations.keys() >= FORMAT.keys():
        return "somebody else attached it"
    if artifact.subject != digest or len(artifact.layers) != 1:
        return "it is not attached as rosml attaches SBOMs"
    if artifact.layers[0].size > largest:
        return f"it has {units.size(artifact.layers[0].size)}, and at most {units.size(largest)} are read"
    return ""


def _of_another(sbom: Sbom, digest: str, is_of: Callable[[Sbom, str], bool]) -> str:
    try:
        return "" if is_of(sbom, digest) else "it is of another image"
    except RosmlError as error:
        return error.message
