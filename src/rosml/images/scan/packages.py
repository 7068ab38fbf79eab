"""Makes an SBOM in CycloneDX 1.5 from a build's report about an image's packages."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Annotated, Any

from packageurl import PackageURL
from pydantic import ConfigDict, Field

from rosml.base import untrusted
from rosml.base.errors import RosmlError
from rosml.base.shapes import Shape
from rosml.registry import oci

Name = Annotated[str, Field(pattern=r"[^/\s\x00-\x1f]")]
"""A name that a package URL can have: not of slashes and blanks alone, which it leaves out."""


class _Model(Shape):
    model_config = ConfigDict(strict=True, extra="forbid")


class System(_Model):
    """As /etc/os-release names it."""

    name: str
    version: str


class Apt(_Model):
    """A package of the operating system, and the source package that it was built from."""

    name: Name
    version: str
    architecture: str
    source: str
    source_version: str


class Python(_Model):
    name: Name
    version: str


class Ros(_Model):
    """A ROS package of an app."""

    name: Name
    version: str
    licenses: list[str]


class Packages(_Model):
    system: System
    apt: list[Apt]
    python: list[Python]
    ros: list[Ros]


def read(data: bytes) -> Packages:
    """Reads the file of components/containerize/contents.py."""
    try:
        return Packages.model_validate_json(untrusted.json_text(data))
    except ValueError:
        raise RosmlError("what the build says of the packages is damaged", "run it again") from None


def cyclonedx(
    contents: Packages, reference: str, of_ros: Callable[[str], Mapping[str, Any]] = lambda name: {}
) -> bytes:
    """The SBOM of an image. The same packages give the same bytes. `of_ros` gives further fields of a ROS package, by its name.

    Versions and sources of Debian packages are in package URLs, and in properties with trivy's names:
    https://github.com/package-url/purl-spec/blob/main/types-doc/deb-definition.md
    """
    document = {
        "$schema": "http://cyclonedx.org/schema/bom-1.5.schema.json",
        "bomFormat": "CycloneDX",
        "specVersion": "1.5",
        "version": 1,
        "metadata": {"component": {"bom-ref": reference, "type": "container", "name": reference}},
        "components": list({item["bom-ref"]: item for item in _components(contents, of_ros)}.values()),
    }
    return oci.encoded(document)


def _components(contents: Packages, of_ros: Callable[[str], Mapping[str, Any]]) -> Iterator[dict[str, Any]]:
    system = contents.system
    whole = "-".join(filter(None, (system.name, system.version)))
    if whole:
        yield {"bom-ref": whole, "type": "operating-system", "name": system.name, "version": system.version}
    for package in contents.apt:
        url = PackageURL(
            "deb", system.name, package.name, package.version, {"arch": package.architecture, "distro": whole}
        )
        facts = {"PkgType": system.name, "SrcName": package.source, "SrcVersion": package.source_version}
        properties = [{"name": f"aquasecurity:trivy:{name}", "value": value} for name, value in facts.items()]
        yield _library(url, package, properties=properties)
    for wheel in contents.python:
        yield _library(PackageURL("pypi", None, wheel.name, wheel.version), wheel)
    for ros in contents.ros:
        licenses = [{"license": {"name": name}} for name in ros.licenses]
        yield _library(PackageURL("generic", "ros", ros.name, ros.version), ros, licenses=licenses, **of_ros(ros.name))


def _library(purl: PackageURL, package: Apt | Python | Ros, **more: Any) -> dict[str, Any]:
    url = purl.to_string()
    return {"bom-ref": url, "type": "library", "name": package.name, "version": package.version, "purl": url, **more}
