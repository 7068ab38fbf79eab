"""Attaches the contents of an app's images to them in a registry: an SBOM, the list of their files, and facts.

With an image's name, you can read its packages without pulling it, and `rosml join` can see whether a part has the same files.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass
from urllib.parse import quote

from cyclonedx.model import ExternalReference, ExternalReferenceType, XsUri

from rosml.base.errors import RosmlError
from rosml.containerize.base_image.base import Base
from rosml.containerize.sources.fetch import Repository
from rosml.images.builds.contents import FACTS, FILES, LISTS, PACKAGES, manifests
from rosml.images.join.layers import platform
from rosml.images.scan import attached, cyclonedx, packages, together
from rosml.images.scan.sbom import FORMAT, MEDIA_TYPE
from rosml.registry.client import Registry

KINDS = (PACKAGES, FILES, FACTS)

COMMIT = "io.rosml.commit"
"""The property of a ROS package with the commit of its repository."""


@dataclass(frozen=True)
class Origins:
    """Where the components of an app come from."""

    sources: Mapping[str, Repository]
    """Upstream repositories of ROS packages, by the package's name."""

    parts: Callable[[str], Mapping[str, str]] = lambda platform: {}
    """Gives the names of the parts of its base image, by the references of their components, for a platform."""


def parts_of(registries: Callable[[str], Registry], base: Base, platform: str) -> Mapping[str, str]:
    """As in `Origins`, of a base image and its add-ons; empty if one has no SBOM, or is in no registry."""
    if base.local or base.adopted:
        return {}
    images = [base.reference, *(base.addons.parts.values() if base.addons else ())]
    try:
        return together.parts(registries, images, platform)
    except RosmlError:  # what a registry has there may be anything
        return {}


def sbom(
    data: bytes,
    reference: str,
    created: float,
    origins: Origins,
    platform: str = "",
) -> bytes:
    """An SBOM in CycloneDX. The same packages and time give the same bytes.

    Args:
        data: the packages of the image, from `PACKAGES`.
        created: when the image was made, in seconds since 1970.
    """
    contents, parts = packages.read(data), origins.parts(platform)
    return cyclonedx.document(contents, reference, created, lambda name: _origin(origins.sources.get(name)), parts)


def with_sources(data: bytes, of_run: bytes) -> bytes:
    """The packages of an image to work on, with those of the app, of which it has the sources. Both are from `PACKAGES`."""
    contents = packages.read(data)
    built = {it.name for it in contents.ros}  # by an app below this one
    sources = [
        it.model_copy(update={"folder": "", "digest": "", "executable": False, "is_source": True})
        for it in packages.read(of_run).ros
        if it.name not in built
    ]
    return contents.model_copy(update={"ros": [*contents.ros, *sources]}).model_dump_json().encode()


def _origin(source: Repository | None) -> cyclonedx.Origin:
    if not source:
        return cyclonedx.Origin()
    url, kind = _public(source.url), ExternalReferenceType.VCS
    references = [ExternalReference(type=kind, url=XsUri(url), comment=source.version)] if url else []
    return cyclonedx.Origin({COMMIT: source.commit}, tuple(references))


def _public(url: str) -> str:
    """The URL of a repository in CycloneDX's form; empty if it is of this machine."""
    if "://" in url:
        return "" if url.startswith("file:") else quote(url, safe=":/?#[]@!$&'()*+,;=~%")
    host, colon, path = url.partition(":")
    return f"ssh://{host}/{quote(path.lstrip('/'))}" if colon and not url.startswith("/") else ""


def attach(
    registry: Registry,
    repository: str,
    digest: str,
    load: Callable[[str, str], bytes],
    origins: Origins,
    kinds: Collection[str] = KINDS,
) -> None:
    """Attaches an SBOM, a list of files and facts to an image or to each image of an index. Those that it has already stay.

    Args:
        load: reads the contents that a build reported, from a platform and a kind of `KINDS`.
        kinds: what a build reported of the image. An app that is no layer on its base image has no facts.
    """
    for manifest in manifests(registry, repository, digest):
        missing = [
            item for item in LISTS if item[0] in kinds and not registry.referrers(repository, manifest.digest, item[1])
        ]
        has_sbom = _has_sbom(registry, repository, manifest.digest)
        if has_sbom and not missing:
            continue
        config = registry.config(repository, manifest).facts
        name = platform(config)
        subject = manifest.descriptor
        for kind, artifact, media_type in missing:
            registry.attach(repository, subject, artifact, load(name, kind), media_type)
        if not has_sbom:
            image = f"{registry.host}/{repository}@{manifest.digest}"
            data = sbom(load(name, PACKAGES), image, cyclonedx.created(config), origins, name)
            attached.attach(registry, repository, subject, data)


def _has_sbom(registry: Registry, repository: str, digest: str) -> bool:
    """Whether our SBOM is attached; others may attach theirs."""
    for entry in registry.referrers(repository, digest, MEDIA_TYPE):
        manifest = registry.manifest(repository, entry["digest"])
        if manifest and manifest.annotations.items() >= FORMAT.items():
            return True
    return False
