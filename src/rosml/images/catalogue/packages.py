"""The packages in published images, from the SBOMs that their indexes name."""

from __future__ import annotations

from rosml.base.errors import RosmlError
from rosml.base.side_by_side import side_by_side
from rosml.images.catalogue.model import Published, Sbom
from rosml.images.scan import sbom
from rosml.images.scan.trivy import ScannerFailed
from rosml.registry.place import Place

Package = tuple[str, str, str]
"""Name, version and kind of a package. The kind is that of its package URL: `deb`, `pypi`."""

NIGHTS = 2
"""The builds of each image whose packages are read: the present one, and the one before."""


def read(place: Place, published: Published) -> tuple[dict[str, list[Package]], list[str]]:
    """The packages in the newest builds, by the digest of the SBOM; and what was left out, and why. Each SBOM is read
    once, although many images share it."""
    positions = dict.fromkeys(
        position
        for image in published.images
        for build in image.builds[:NIGHTS]
        for platform in build.platforms
        for position in platform.sboms
    )
    sboms = [published.sboms[position] for position in positions]
    answers = side_by_side(lambda item: _packages(place, item), sboms, title="SBOMs")
    read = {item.digest: packages for item, packages in zip(sboms, answers, strict=True) if isinstance(packages, list)}
    return read, [reason for reason in answers if isinstance(reason, str)]


def _packages(place: Place, listed: Sbom) -> list[Package] | str:
    """The packages in an SBOM; or why it is left out."""
    path = place.path(listed.repository)
    try:
        artifact = place.client.manifest(path, listed.digest)
        subject = artifact.subject if artifact else ""
        content = sbom.Shelf(place.client, {subject: listed.digest}).load(path, subject)
        return sorted({_package(component) for component in content.packages})
    except RosmlError as error:
        if not isinstance(error, ScannerFailed):
            place.client.head(path, listed.digest)  # raises if the registry does not answer any more
        return f"the SBOM of {listed.part} is left out: {error.message}"


def _package(component: sbom.Component) -> Package:
    return component.name, component.version or "", component.purl.removeprefix("pkg:").partition("/")[0]
