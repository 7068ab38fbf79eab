"""The packages in published images, from the SBOMs that their indexes name."""

from __future__ import annotations

from collections.abc import Iterable

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
    """The packages in the newest builds, by the digest of the SBOM; and what was left out, and why. Each SBOM is read once, although
    many images share it.

    Raises:
        RosmlError: the registry does not answer.
    """
    positions = dict.fromkeys(
        position
        for image in published.images
        for build in image.builds[:NIGHTS]
        for platform in build.platforms
        for position in platform.sboms
    )
    wanted = [published.sboms[position] for position in positions]
    found = side_by_side(lambda item: _packages(place, item), wanted, title="SBOMs")
    read = {item.digest: packages for item, packages in zip(wanted, found, strict=True) if isinstance(packages, list)}
    return read, [reason for reason in found if isinstance(reason, str)]


def _packages(place: Place, wanted: Sbom) -> list[Package] | str:
    """The packages in an SBOM; or why it is left out."""
    path = place.path(wanted.repository)
    try:
        artifact = place.client.manifest(path, wanted.digest)
        subject = artifact.subject if artifact else ""
        found = sbom.Shelf(place.client, {subject: wanted.digest}).load(path, subject)
        return sorted(set(_described(found.packages)))
    except ScannerFailed as error:
        return f"the SBOM of {wanted.part} is left out: {error.message}"
    except RosmlError as error:
        place.client.head(path, wanted.digest)  # raises if the registry does not answer any more
        return f"the SBOM of {wanted.part} is left out: {error.message}"


def _described(components: Iterable[sbom.Component]) -> Iterable[Package]:
    for item in components:
        yield item.name, item.version or "", item.purl.removeprefix("pkg:").partition("/")[0]
