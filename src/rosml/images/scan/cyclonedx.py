"""Makes an SBOM in CycloneDX 1.6 of an image's packages: https://cyclonedx.org/docs/1.6/json/"""

from __future__ import annotations

import re
import uuid
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass, field
from datetime import UTC, datetime
from typing import Any

from cyclonedx.model import ExternalReference, Property, XsUri
from cyclonedx.model.bom import Bom, BomMetaData
from cyclonedx.model.component import Component, ComponentType
from cyclonedx.model.contact import OrganizationalContact, OrganizationalEntity
from cyclonedx.model.license import DisjunctiveLicense, License, LicenseExpression
from cyclonedx.model.tool import ToolRepository
from cyclonedx.output.json import JsonV1Dot6
from cyclonedx.schema.schema import SchemaVersion1Dot6
from packageurl import PackageURL

from rosml import __version__
from rosml.base import untrusted
from rosml.images.image_set.lock_file import package_name
from rosml.images.image_set.model import ENVIRONMENTS
from rosml.images.scan import deployed, needs, spdx
from rosml.images.scan.deployed import Deployed
from rosml.images.scan.packages import Apt, Packages, Python, Ros, System
from rosml.images.scan.sbom import Sbom
from rosml.registry import oci
from rosml.registry.documents import Config

PART = "io.rosml.part"
"""The property of a component with the name of the image or part that brought it, if an image is made of several."""

APP = "app"
"""The name for what an app brings itself."""

LONGEST_NAME = 200
"""The most characters of a person's name."""

_PERSON = re.compile(r'\s*"?([^"<>]*[^"<>\s])"?\s*<([^<>@\s]{1,100}@[^<>@\s]{1,100})>')


@dataclass(frozen=True)
class Origin:
    """Where a ROS package of an app comes from."""

    properties: Mapping[str, str] = field(default_factory=dict)
    references: tuple[ExternalReference, ...] = ()


def document(
    contents: Packages,
    reference: str,
    created: float = 0.0,
    of_ros: Callable[[str], Origin] = lambda name: Origin(),
    parts: Mapping[str, str] | None = None,
    home: str = "",
) -> bytes:
    """The SBOM of an image. The same packages and time give the same bytes.

    Versions and sources of Debian packages are in package URLs, and in properties with trivy's names:
    https://github.com/package-url/purl-spec/blob/main/types-doc/deb-definition.md

    Args:
        reference: of the image, with its digest.
        created: when the image was made, in seconds since 1970.
        of_ros: the origin of a ROS package, by its name.
        parts: of an app, the names of the parts of its base image, by references of the components there.
        home: the address of the project that publishes the image, if it names one.
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
        manufacturer=OrganizationalEntity(urls=[XsUri(home)]) if home else None,
    )
    components = _Components(contents, of_ros)
    empty = Bom(metadata=about, serial_number=serial(reference))
    # Each for itself: Bom compares all with all.
    texts = (it.as_json(SchemaVersion1Dot6) for it in components.all())  # type: ignore[attr-defined] # a decorator adds it
    written = map(untrusted.json_value, texts)
    by_ref = {component["bom-ref"]: component for component in written}
    if parts:
        by_ref = {ref: _of_part(component, parts.get(ref, APP)) for ref, component in by_ref.items()}
    whole = untrusted.json_value(JsonV1Dot6(empty).output_as_string())
    return oci.encoded(needs.completed(whole, by_ref, components.needs(), _environments(by_ref)))


def serial(reference: str) -> uuid.UUID:
    """The serial number of an image's SBOM, by which other documents name its components."""
    return uuid.uuid5(uuid.NAMESPACE_URL, reference)


def joined(reference: str, created: float, sboms: Iterable[tuple[str, Sbom]], home: str = "") -> bytes:
    """The SBOM of an image that was joined from others, by theirs, the lowest first: no layer is read.

    Args:
        sboms: those of the parts, each with the part's name. Its components get the name as a property, unless it is empty or they have one.
        home: as of `document`.
    """
    components, needed = dict[str, dict[str, Any]](), dict[str, set[str]]()
    for name, sbom in sboms:
        for component in sbom.components:
            ref = str(component["bom-ref"])
            components.setdefault(ref, _of_part(component, name))
            needed.setdefault(ref, set()).update(needs.of(component))
        for dependency in sbom.document.dependencies:
            needed.setdefault(dependency.ref, set()).update(dependency.dependsOn)
    empty = Packages(system=System(name="", version=""), apt=[], python=[], ros=[])
    whole = untrusted.json_value(document(empty, reference, created, home=home))
    return oci.encoded(needs.completed(whole, components, needed, _environments(components)))


def created(config: Config) -> float:
    """When an image was made, in seconds since 1970; 0 if its config does not say."""
    return moment(config.created or "").timestamp()


def moment(text: str) -> datetime:
    """A time as others write it, in UTC; that of 1970 if it is none. One without a zone is UTC's."""
    with suppress(ValueError, OverflowError):
        time = datetime.fromisoformat(text)
        return (time if time.tzinfo else time.replace(tzinfo=UTC)).astimezone(UTC)
    return datetime.fromtimestamp(0, UTC)


def _of_part(component: dict[str, Any], name: str) -> dict[str, Any]:
    if not name or part(component):
        return component
    return {**component, "properties": [*needs.properties(component), {"name": PART, "value": name}]}


def _environments(components: Mapping[str, Mapping[str, Any]]) -> dict[str, str]:
    """The parts of components that are environments, by the references of the components."""
    names = {ref: part(component) for ref, component in components.items()}
    return {ref: name for ref, name in names.items() if name.startswith(f"{ENVIRONMENTS}:")}


def part(component: Mapping[str, Any]) -> str:
    """The name of the part that brought a component; empty if it does not say."""
    return next((it["value"] for it in needs.properties(component) if it["name"] == PART), "")


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
            yield Component(
                name=system.name,
                version=system.version,
                type=ComponentType.OPERATING_SYSTEM,
                bom_ref=self._whole,
                supplier=_organization(system.vendor, system.home),
                licenses=[DisjunctiveLicense(name="as its packages say")],
                properties=_properties(deployed.SYSTEM.properties()),
            )
        pairs = (*self._apt, *self._python, *self._ros)
        yield from {component.bom_ref.value: component for component, _ in pairs}.values()

    def needs(self) -> dict[str, list[str]]:
        """What each component needs: references of others of its kind, or names."""
        provided = self._provided()
        needed = {_ref(component): [*_of_relations(it.depends, provided)] for component, it in self._apt}
        needed |= {_ref(component): [*_of_requirements(it.requires)] for component, it in self._python}
        return needed | {_ref(component): [f"ros:{name}" for name in it.depends] for component, it in self._ros}

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
        properties = {f"aquasecurity:trivy:{name}": value for name, value in facts.items()}
        licenses = _licenses(spdx.of_debian(package.licenses), f"file:///usr/share/doc/{package.name}/copyright")
        purl = PackageURL("deb", system, package.name, package.version, qualifiers)
        ref = f"apt:{package.name}:{package.architecture}@{package.version}"
        return _library(ref, purl, package, licenses, deployed.of_apt(package), Origin(properties))


def _of_python(wheel: Python) -> Component:
    licenses = _licenses(spdx.of_wheel(wheel.licenses), "")
    purl = PackageURL("pypi", None, wheel.name, wheel.version)
    return _library(f"pypi:{purl.name}@{wheel.version}", purl, wheel, licenses, deployed.of_python(wheel), Origin())


def _of_ros(ros: Ros, origin: Origin) -> Component:
    licenses = _licenses(spdx.of_debian(ros.licenses), "")
    purl = PackageURL("generic", "ros", ros.name, ros.version)
    return _library(f"ros:{ros.name}@{ros.version}", purl, ros, licenses, deployed.of_ros(ros), origin)


def _library(
    ref: str,
    purl: PackageURL,
    package: Apt | Python | Ros,
    licenses: Iterable[License],
    file: Deployed,
    origin: Origin,
) -> Component:
    """A component. `ref` is what others call it: short, since each of them does."""
    return Component(
        name=package.name,
        version=package.version,
        type=ComponentType.LIBRARY,
        bom_ref=ref,
        purl=purl,
        supplier=_organization(package.author if isinstance(package, Python) else package.maintainer),
        licenses=licenses,
        hashes=file.hashes,
        properties=_properties((*origin.properties.items(), *file.properties())),
        external_references=(*origin.references, *file.references),
    )


def _organization(text: str, home: str = "") -> OrganizationalEntity | None:
    """A name, perhaps with an address: `Ada <ada@example.org>`."""
    both = _PERSON.match(text)
    name = (both[1] if both else text).strip()[:LONGEST_NAME]
    contacts = [OrganizationalContact(email=both[2])] if both else []
    urls = [XsUri(home)] if re.fullmatch(r"https?://[\w./~-]{1,200}", home) else []
    return OrganizationalEntity(name=name, contacts=contacts, urls=urls) if name else None


def _properties(pairs: Iterable[tuple[str, str]]) -> list[Property]:
    return [Property(name=name, value=value) for name, value in pairs]


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


def _ref(component: Component) -> str:
    return component.bom_ref.value or ""


def _of_requirements(texts: Iterable[str]) -> Iterator[str]:
    """The names in requirements of a wheel, without those of its extras."""
    for text in texts:
        name, condition = package_name(text), text.partition(";")[2]
        if name and not re.search(r"\bextra\b", condition):
            yield f"pypi:{name}{needs.CONDITION if condition else ''}"


def _of_relations(text: str, provided: Mapping[str, Component]) -> Iterator[str]:
    """Of each relation of Debian, `a | b (>= 1), c:any`, the first package that is there, or else the first name."""
    for relation in filter(str.strip, text.split(",")):
        names = [re.split(r"[\s:(]", other.strip(), maxsplit=1)[0] for other in relation.split("|")]
        yield next((_ref(provided[name]) for name in names if name in provided), f"apt:{names[0]}")
