"""Makes an SBOM in CycloneDX 1.6 of an image's packages: https://cyclonedx.org/docs/1.6/json/"""

from __future__ import annotations

import re
import uuid
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from datetime import UTC, datetime
from email.utils import parseaddr
from typing import Any

from cyclonedx.model import ExternalReference, Property, XsUri
from cyclonedx.model.bom import Bom, BomMetaData
from cyclonedx.model.component import Component, ComponentType
from cyclonedx.model.contact import OrganizationalContact, OrganizationalEntity
from cyclonedx.model.dependency import Dependency
from cyclonedx.model.license import DisjunctiveLicense, License, LicenseExpression
from cyclonedx.model.tool import ToolRepository
from cyclonedx.output.json import JsonV1Dot6
from packageurl import PackageURL

from rosml import __version__
from rosml.base import untrusted
from rosml.images.scan import spdx
from rosml.images.scan.packages import Apt, Packages, Python, Ros, System
from rosml.images.scan.sbom import Sbom
from rosml.registry import oci

FILENAME = "bsi:component:filename"
"""The property with the name of the file that was installed: https://github.com/BSI-Bund/tr-03183-cyclonedx-property-taxonomy"""

PART = "io.rosml.part"
"""The property of a component of a joined image with the name of the part that has it."""

LONGEST = 200
"""The most characters of a person's name."""


@dataclass(frozen=True)
class Origin:
    """Where a ROS package of an app comes from."""

    properties: Mapping[str, str] = field(default_factory=dict)
    references: tuple[ExternalReference, ...] = ()


def document(
    contents: Packages, reference: str, created: float = 0.0, of_ros: Callable[[str], Origin] = lambda name: Origin()
) -> bytes:
    """The SBOM of an image. The same packages and time give the same bytes.

    Versions and sources of Debian packages are in package URLs, and in properties with trivy's names:
    https://github.com/package-url/purl-spec/blob/main/types-doc/deb-definition.md

    Args:
        reference: of the image, with its digest.
        created: when the image was made, in seconds since 1970.
        of_ros: the origin of a ROS package, by its name.
    """
    repository, _, digest = reference.partition("@")
    purl = PackageURL("oci", None, repository.rpartition("/")[2], digest, {"repository_url": repository})
    image = Component(name=reference, type=ComponentType.CONTAINER, bom_ref=reference, purl=purl)
    tool = Component(name="rosml", version=__version__, type=ComponentType.APPLICATION)
    about = BomMetaData(
        component=image,
        timestamp=datetime.fromtimestamp(created, UTC),
        tools=ToolRepository(components=[tool]),
        authors=[OrganizationalContact(name="rosml")],
    )
    components = _Components(contents, of_ros)
    every = [*components.all()]
    bom = Bom(
        components=every,
        metadata=about,
        serial_number=serial(reference),
        dependencies=[_needs(image, every), *(_needs(component, needs) for component, needs in components.needs())],
    )
    return JsonV1Dot6(bom).output_as_string().encode()


def serial(reference: str) -> uuid.UUID:
    """The serial number of an image's SBOM, by which other documents name its components."""
    return uuid.uuid5(uuid.NAMESPACE_URL, reference)


def _needs(component: Component, needs: Iterable[Component]) -> Dependency:
    """What a component needs. Bom's own method looks through all dependencies for each of them."""
    return Dependency(component.bom_ref, [Dependency(need.bom_ref) for need in needs])


def joined(reference: str, created: float, sboms: Iterable[tuple[str, Sbom]]) -> bytes:
    """The SBOM of an image that was joined from others, by theirs, the lowest first: no layer is read.

    Args:
        sboms: those of the parts, each with the part's name. Its components get the name as a property, unless it is empty or they have one.
    """
    components, needs = dict[str, dict[str, Any]](), dict[str, set[str]]()
    for part, sbom in sboms:
        for component in sbom.components:
            components.setdefault(str(component["bom-ref"]), _of_part(component, part))
        for dependency in sbom.document.dependencies:
            needs.setdefault(dependency.ref, set()).update(dependency.dependsOn)
    empty = Packages(system=System(name="", version=""), apt=[], python=[], ros=[])
    whole = untrusted.json_value(document(empty, reference, created))
    needs = {
        reference: {*components},
        **{ref: refs & components.keys() for ref, refs in needs.items() if ref in components},
    }
    whole["components"] = [components[ref] for ref in sorted(components)]
    whole["dependencies"] = [{"ref": ref, "dependsOn": sorted(refs)} for ref, refs in sorted(needs.items())]
    return oci.encoded(whole)


def _of_part(component: dict[str, Any], part: str) -> dict[str, Any]:
    properties = component.get("properties", [])
    if not part or any(it.get("name") == PART for it in properties):
        return component
    return {**component, "properties": [*properties, {"name": PART, "value": part}]}


class _Components:
    """The components of an image, each with what its package says. An image may have several versions of a wheel."""

    def __init__(self, contents: Packages, of_ros: Callable[[str], Origin]) -> None:
        system = contents.system
        self._whole = "-".join(filter(None, (system.name, system.version)))
        self._contents = contents
        self._apt = [(self._of_apt(it), it) for it in contents.apt]
        self._python = [(_of_python(it), it) for it in contents.python]
        self._ros = [(_of_ros(it, of_ros(it.name)), it) for it in contents.ros]

    def all(self) -> Iterator[Component]:
        system = self._contents.system
        if self._whole:
            kind = ComponentType.OPERATING_SYSTEM
            yield Component(name=system.name, version=system.version, type=kind, bom_ref=self._whole)
        pairs = (*self._apt, *self._python, *self._ros)
        yield from {component.bom_ref.value: component for component, _ in pairs}.values()

    def needs(self) -> Iterator[tuple[Component, list[Component]]]:
        """What each component needs of the others."""
        provided = self._provided()
        for component, package in self._apt:
            yield component, _others(component, _of_relations(package.depends, provided))
        wheels = {_normalised(wheel.name): component for component, wheel in self._python}
        for component, wheel in self._python:
            texts = [text for text in wheel.requires if "extra" not in text]
            names = (_normalised(re.split(r"[^\w.-]", text.strip(), maxsplit=1)[0]) for text in texts)
            yield component, _others(component, map(wheels.get, names))
        packages = {ros.name: component for component, ros in self._ros}
        for component, ros in self._ros:
            yield component, _others(component, map(packages.get, ros.depends))

    def _provided(self) -> dict[str, Component]:
        """The packages of the system by name, and by the names that they provide."""
        virtual = {
            words[0]: component
            for component, package in self._apt
            for words in map(str.split, filter(str.strip, package.provides.split(",")))
        }
        return virtual | {package.name: component for component, package in self._apt}

    def _of_apt(self, package: Apt) -> Component:
        system = self._contents.system.name
        qualifiers = {"arch": package.architecture, "distro": self._whole}
        facts = {"PkgType": system, "SrcName": package.source, "SrcVersion": package.source_version}
        version = package.version.partition(":")[2] or package.version
        properties = {f"aquasecurity:trivy:{name}": value for name, value in facts.items()}
        properties[FILENAME] = f"{package.name}_{version}_{package.architecture}.deb"
        licenses = _licenses(spdx.of_debian(package.licenses), f"file:///usr/share/doc/{package.name}/copyright")
        purl = PackageURL("deb", system, package.name, package.version, qualifiers)
        ref = f"apt:{package.name}:{package.architecture}@{package.version}"
        return _library(ref, purl, package, package.maintainer, licenses, Origin(properties))


def _of_python(wheel: Python) -> Component:
    licenses = _licenses(spdx.of_wheel(wheel.licenses), "")
    purl = PackageURL("pypi", None, wheel.name, wheel.version)
    return _library(f"pypi:{purl.name}@{wheel.version}", purl, wheel, wheel.author, licenses, Origin())


def _of_ros(ros: Ros, origin: Origin) -> Component:
    licenses = _licenses(spdx.of_debian(ros.licenses), "")
    purl = PackageURL("generic", "ros", ros.name, ros.version)
    return _library(f"ros:{ros.name}@{ros.version}", purl, ros, ros.maintainer, licenses, origin)


def _library(
    ref: str, purl: PackageURL, package: Apt | Python | Ros, supplier: str, licenses: Iterable[License], origin: Origin
) -> Component:
    """A component. `ref` is what others call it: short, since each of them does."""
    name, address = parseaddr(supplier)
    title = (name or address or supplier).strip()[:LONGEST]
    contacts = [OrganizationalContact(email=address)] if name and "@" in address else []
    return Component(
        name=package.name,
        version=package.version,
        type=ComponentType.LIBRARY,
        bom_ref=ref,
        purl=purl,
        supplier=OrganizationalEntity(name=title, contacts=contacts) if title else None,
        licenses=licenses,
        properties=[Property(name=key, value=value) for key, value in origin.properties.items()],
        external_references=origin.references,
    )


def _licenses(licenses: list[spdx.License], place: str) -> list[License]:
    """CycloneDX 1.6 takes one expression alone, or else identifiers and names. `place`: of a text in the image."""
    url = XsUri(place) if place else None
    if one := spdx.together(licenses):
        return [LicenseExpression(one.text) if one.is_compound else DisjunctiveLicense(id=one.text)]
    if not licenses and place:
        return [DisjunctiveLicense(name="as its copyright file says", url=url)]
    return [
        DisjunctiveLicense(id=it.text)
        if it.is_spdx and not it.is_compound
        else DisjunctiveLicense(name=it.text, url=url)
        for it in licenses
    ]


def _normalised(name: str) -> str:
    """A wheel's name as its requirements may write it: https://packaging.python.org/specifications/name-normalization/"""
    return re.sub(r"[-_.]+", "-", name).lower()


def _of_relations(text: str, provided: Mapping[str, Component]) -> Iterator[Component | None]:
    """Of each relation of Debian, `a | b (>= 1), c:any`, the first package that is there."""
    for relation in filter(str.strip, text.split(",")):
        names = (re.split(r"[\s:(]", other.strip(), maxsplit=1)[0] for other in relation.split("|"))
        yield next((provided[name] for name in names if name in provided), None)


def _others(component: Component, needs: Iterable[Component | None]) -> list[Component]:
    """These without the component itself, each once."""
    by_ref = {it.bom_ref.value: it for it in needs if it is not None}
    return [it for ref, it in by_ref.items() if ref != component.bom_ref.value]
