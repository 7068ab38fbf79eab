"""SBOMs of an image that is made of others in a registry, by theirs: no layer is read, and each component says whose it is."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence

from rosml.base import untrusted
from rosml.base.errors import RosmlError
from rosml.base.problems import listed
from rosml.images.image_set.labels import TITLE
from rosml.images.join import facts, layers
from rosml.images.join.layers import Joined, Source
from rosml.images.scan import attached, cyclonedx
from rosml.images.scan.sbom import Sbom
from rosml.registry import documents, oci, references
from rosml.registry.client import Registry
from rosml.registry.references import Reference

Named = tuple[str, Sbom]
"""An SBOM with the name of the part that it is of."""


def of_image(registry: Registry, repository: str, digest: str, annotations: Mapping[str, str]) -> list[Named]:
    """The SBOMs of an image for one platform: its own, or those of what it was joined from; none if one is missing.

    Args:
        annotations: of its entry in its index, which may name what it was joined from.
    """
    if sboms := of_manifest(registry, repository, digest):
        return sboms
    each = [of_manifest(registry, *place) for place in facts.components(registry, repository, digest, annotations)]
    return [item for sboms in each for item in sboms] if all(each) else []


def of_manifest(registry: Registry, repository: str, digest: str) -> list[Named]:
    """The SBOMs that are attached to an image or part itself, with its title."""
    sboms = attached.read(registry, repository, digest).sboms
    manifest = registry.manifest(repository, digest) if sboms else None
    name = registry.config(repository, manifest).labels.get(TITLE, "") if manifest else ""
    return [(name or repository.rpartition("/")[2], sbom) for sbom in sboms]


def parts(registries: Callable[[str], Registry], images: Iterable[str], platform: str) -> dict[str, str]:
    """The names of the parts that components of images are of, by the components' references; empty if an image has no SBOM."""
    read = [_of_platform(registries, references.parse(image), platform) for image in images]
    if not all(read):
        return {}
    pairs = [(name, component) for sboms in read for name, sbom in sboms for component in sbom.components]
    return {str(component["bom-ref"]): cyclonedx.part(component) or name for name, component in pairs}


def _of_platform(registries: Callable[[str], Registry], place: Reference, platform: str) -> list[Named]:
    registry = registries(place.host)
    manifest = registry.manifest(place.repository, place.reference)
    if manifest is None or not manifest.is_index:
        return of_image(registry, place.repository, manifest.digest, {}) if manifest else []
    entries = [it for it in manifest.members if layers.platform(it.platform) == platform]
    return of_image(registry, place.repository, entries[0].digest, entries[0].annotations) if entries else []


def attach(
    registries: Callable[[str], Registry],
    say: Callable[[str], None],
    sources: Sequence[Source],
    image: Joined,
    place: Reference,
) -> None:
    """Attaches its SBOM to a joined image in a repository. An image without one is said, and so is a registry that refuses it."""
    try:
        read = [of_image(registries(it.host), it.repository, it.digest, it.annotations) for it in sources]
        if without := [source.name for source, sboms in zip(sources, read, strict=True) if not sboms]:
            say(f"no SBOM for {image.platform}, because none of rosml is attached to {listed(without)}")
            return
        content = _content(f"{place.host}/{place.repository}@{image.digest}", image.config, read)
        subject = oci.descriptor(oci.IMAGE, image.manifest)
        attached.attach(registries(place.host), place.repository, subject, content)
    except RosmlError as error:
        say(f"{place} lacks its SBOM: {error.message}")


def _content(reference: str, config: bytes, read: Iterable[Sequence[Named]]) -> bytes:
    created = cyclonedx.created(documents.Config.model_validate(untrusted.json_value(config)))
    return cyclonedx.joined(reference, created, (item for sboms in read for item in sboms))
