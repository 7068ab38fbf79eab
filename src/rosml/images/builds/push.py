"""Builds from an excerpt of the bake file, and pushes by digest."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from pathlib import Path

from rosml.base import files
from rosml.base.errors import RosmlError
from rosml.images.bake import bake_file
from rosml.images.image_set.model import ImageSet
from rosml.machine import buildx
from rosml.machine.services import Services
from rosml.registry import references
from rosml.registry.client import Registry

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


@dataclass(frozen=True)
class Push:
    """A call of bake that pushes its target into a repository. `compression`: as in matrix.yaml."""

    call: buildx.Bake
    repository: str
    compression: str = ""


def push(services: Services, it: Push) -> str:
    """Builds and pushes a target. Returns the digest."""
    facts = buildx.run(services, replace(it.call, sets=(_output(services, it), *it.call.sets)))[1]
    return _pushed(services, it, facts)


def push_together(services: Services, pushes: Sequence[Push], file: Path, name: str) -> dict[str, str]:
    """Makes several pushes by one call, so that downloads, installations and uploads overlap. Returns the digests by target."""
    first, *others = (it.call for it in pushes)
    sets = [item for it in pushes for item in (_output(services, it), *it.call.sets)]
    variables = {key: value for it in pushes for key, value in it.call.variables.items()}
    beside = tuple(call.target for call in others)
    whole = replace(first, file=file, name=name, sets=sets, variables=variables, beside=beside)
    facts = buildx.run_all(services, whole)[1]
    return {it.call.target: _pushed(services, it, facts.get(it.call.target, {})) for it in pushes}


def _output(services: Services, it: Push) -> str:
    place = buildx.output(services, it.repository, it.call.target)
    return f"{it.call.target}.output={place},{compression(it.compression)}"


def _pushed(services: Services, it: Push, facts: Mapping[str, str]) -> str:
    """The digest of what was pushed, from buildx's facts. The tag that Docker's own BuildKit needed goes."""
    digest = facts.get("containerimage.digest", "")
    if not digest:
        raise RosmlError(f"buildx did not say which digest it pushed for {it.call.target}", "run it again")
    if services.is_docker_itself:
        place = references.parse(it.repository)
        with suppress(RosmlError), Registry(place.host, ca_bundle=services.ca_bundle) as registry:
            registry.delete(place.repository, buildx.passing_tag(it.call.target))  # not all registries can
    return digest
