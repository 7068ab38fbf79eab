"""Builds from an excerpt of the bake file, and pushes by digest."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from rosml.base import files
from rosml.base.errors import RosmlError
from rosml.images.bake import bake_file
from rosml.images.image_set.model import ImageSet
from rosml.machine import buildx
from rosml.machine.services import Services

COMPRESSION = "compression=zstd,compression-level=7,oci-mediatypes=true"
"""Level 7 makes parts a seventh smaller than level 3, and takes several times longer. Parts are pulled often."""

GZIP_COMPRESSION = "compression=gzip,force-compression=true,oci-mediatypes=true"
"""For Docker before 23. By force, as the builder's cache may have the same layers as zstd."""


def write_excerpt(services: Services, image_set: ImageSet, target: str, *others: str) -> Path:
    """Writes the piece of the bake file that targets need into a file with the name of the first target."""
    folder = services.state / "bake"
    folder.mkdir(parents=True, exist_ok=True)
    file = folder / f"{target}.hcl"
    files.write(file, bake_file.excerpt(image_set, (target, *others)))
    return file


def compression(kind: str) -> str:
    """The builder's options for layers of a set, or on an image with a label, that asks for this compression."""
    return GZIP_COMPRESSION if kind == "gzip" else COMPRESSION


def pushing(call: buildx.Bake, repository: str, kind: str = "") -> buildx.Bake:
    """The call that also pushes its target into a repository by digest. Without a tag, nobody sees it yet. `kind`: of compression."""
    output = f"{call.target}.output=type=image,name={repository},push=true,push-by-digest=true,{compression(kind)}"
    return replace(call, sets=(output, *call.sets))


def push(services: Services, call: buildx.Bake) -> str:
    """Builds and pushes a target by a call of `pushing`. Returns the digest."""
    return _pushed(call, buildx.run(services, call)[1])


def _pushed(call: buildx.Bake, metadata: Mapping[str, str]) -> str:
    """The digest of what a call pushed, from buildx's facts."""
    if digest := metadata.get("containerimage.digest", ""):
        return digest
    raise RosmlError(f"buildx did not say which digest it pushed for {call.target}", "run it again")


def push_together(services: Services, calls: Sequence[buildx.Bake], file: Path, name: str) -> dict[str, str]:
    """Makes several calls of `pushing` in one, so that downloads, installations and uploads overlap. Returns the digests by target."""
    first, *others = calls
    sets = [item for call in calls for item in call.sets]
    variables = {key: value for call in calls for key, value in call.variables.items()}
    beside = tuple(call.target for call in others)
    whole = replace(first, file=file, name=name, sets=sets, variables=variables, beside=beside)
    metadata = buildx.run_all(services, whole)[1]
    return {call.target: _pushed(call, metadata.get(call.target, {})) for call in calls}
