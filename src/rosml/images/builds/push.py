"""Builds from an excerpt of the bake file, and pushes by digest."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from rosml.base import files
from rosml.base.errors import RosmlError
from rosml.images.bake import bake_file
from rosml.images.image_set.model import ImageSet
from rosml.machine import buildx
from rosml.machine.progress import BuildProgress
from rosml.machine.services import Services

COMPRESSION = "compression=zstd,compression-level=7,oci-mediatypes=true"
"""Level 7 makes parts a seventh smaller than level 3. It takes several times longer, but parts are compressed once and
pulled often."""


def write_excerpt(services: Services, image_set: ImageSet, target: str, *others: str) -> Path:
    """Writes the piece of the bake file that targets need into a file with the name of the first target."""
    folder = services.state / "bake"
    folder.mkdir(parents=True, exist_ok=True)
    file = folder / f"{target}.hcl"
    files.write(file, bake_file.excerpt(image_set, (target, *others)))
    return file


def push_by_digest(services: Services, call: buildx.Bake, repository: str) -> tuple[BuildProgress, str]:
    """Builds a target and pushes it into a repository by digest, without a tag, so that nobody sees it yet.

    Returns:
        The progress with all steps, and the digest.

    Raises:
        RosmlError: the build failed, or buildx does not say what it pushed.
    """
    output = f"{call.target}.output=type=image,name={repository},push=true,push-by-digest=true,{COMPRESSION}"
    progress, metadata = buildx.run(services, replace(call, sets=(output, *call.sets)))
    digest = metadata.get("containerimage.digest", "")
    if not digest:
        raise RosmlError(f"buildx did not say which digest it pushed for {call.target}", "run it again")
    return progress, digest
