"""SBOMs in CycloneDX, which the registry keeps beside images."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Literal

from pydantic import Field, ValidationError

from rosml.base import untrusted
from rosml.base.problems import first_of
from rosml.images.scan.trivy import Model, ScannerFailed
from rosml.registry.client import Registry

MEDIA_TYPE = "application/vnd.cyclonedx+json"
"""The media type, also of the artifact, by which trivy and others find it beside an image."""

FORMAT = {"io.rosml.sbom.format": "3"}
"""The annotation of our SBOMs. With another number all images get a new one, although their digests stay the same."""

OF_A_SYSTEM = re.compile(r"pkg:(?:deb|rpm|apk)/([^/]+)/")
"""The package URL of an operating system's package. The group is the system."""

REMEDY = "build it again: rosml publish build --force --only NAME"


class Component(Model):
    """A package, or an operating system."""

    ref: str = Field(alias="bom-ref")
    type: str
    name: str = ""
    version: str | None = None
    purl: str = ""


class Dependency(Model):
    ref: str
    dependsOn: list[str] = []


class Subject(Model):
    name: str = ""


class About(Model):
    component: Subject | None = None


class _Head(Model):
    """What says of which image it is."""

    bomFormat: Literal["CycloneDX"]
    metadata: About | None = None


class Document(Model):
    """The part of an SBOM that we read."""

    bomFormat: Literal["CycloneDX"]
    metadata: About | None = None
    components: list[Component] = []
    dependencies: list[Dependency] = []


LARGEST = 200_000_000
"""The most bytes of an SBOM. Those of parts have some MB."""


@dataclass(frozen=True)
class Sbom:
    """`counts` says of each component whether it is the image's; all are if it is None."""

    content: bytes
    counts: Callable[[Mapping[str, Any]], bool] | None = None

    def is_of(self, digest: str) -> bool:
        return _is_about(self.document.metadata, digest)

    def seems_of(self, digest: str) -> bool:
        """As `is_of`, several times faster: its components may be anything. Raises ScannerFailed if it is no SBOM at all."""
        with _well_formed():
            names = _Head.model_fields.keys() & self._texts.keys()
            head = {name: untrusted.json_quick(self._texts[name]) for name in names}
            return _is_about(_Head.model_validate(head).metadata, digest)

    @cached_property
    def _texts(self) -> dict[str, bytes]:
        """Its fields, not parsed."""
        with _well_formed():
            return untrusted.json_fields(self.content, LARGEST)

    @property
    def component_texts(self) -> list[bytes]:
        """What it says of each component, in JSON, whatever it is. Raises ScannerFailed if it is no SBOM."""
        with _well_formed():
            return untrusted.json_items(self._texts.get("components", b"[]"))

    @cached_property
    def raw(self) -> dict[str, Any]:
        """All that it says, whatever it is; empty if it is no JSON object. Raises ScannerFailed if it is no JSON."""
        return _object(self.content, LARGEST)

    @cached_property
    def components(self) -> list[dict[str, Any]]:
        """All that it says of its components."""
        assert self.document, "it is read, to check it"
        return [*filter(self.counts, self._value.get("components", []))]

    @cached_property
    def _value(self) -> Any:
        return untrusted.json_value(self.content, LARGEST)

    @cached_property
    def document(self) -> Document:
        with _well_formed():
            return Document.model_validate(self._value)

    @property
    def packages(self) -> list[Component]:
        """Its packages, without those of another operating system, which no advisory of this system covers.

        A wheel's SBOM names the packages from which the wheel's libraries were copied.
        """
        family = self.system.partition(" ")[0]
        libraries = [item for item in self.document.components if item.type == "library"]
        origins = [OF_A_SYSTEM.match(item.purl) for item in libraries]
        return [item for item, origin in zip(libraries, origins, strict=True) if not origin or origin[1] == family]

    @property
    def system(self) -> str:
        """Its operating system, such as `debian 12.12`; empty if it has none. One without a version is from a wheel's SBOM."""
        systems = [item for item in self.document.components if item.type == "operating-system" and item.version]
        return f"{systems[0].name} {systems[0].version}" if systems else ""

    @property
    def sources(self) -> list[str]:
        """The sources of advisories that its packages need, by their names in trivy's database."""
        family, _, version = self.system.partition(" ")
        release = version.partition(".")[0] if family == "debian" else version
        wheels = any(item.purl.startswith("pkg:pypi/") for item in self.packages)
        return [*([f"{family} {release}"] if family else []), *(["pip::"] if wheels else [])]

    def require(self, name: str, ros: bool) -> None:
        """Checks that it can be complete: an SBOM that lacks most packages would look like a clean image.

        A ROS image has Debian packages. Any other part is made of wheels.
        """
        if not ros and not self.packages:
            raise ScannerFailed(
                f"{name}: its SBOM names no package, and a part is made of wheels",
                "check whether the part has the dist-info of its wheels",
            )
        debian = sum(item.purl.startswith("pkg:deb/") for item in self.packages)
        if ros and not (self.system and debian):
            raise ScannerFailed(
                f"{name}: its SBOM names {'no operating system' if not self.system else 'no Debian package'}",
                "check whether the image has /usr/lib/os-release and /var/lib/dpkg/status",
            )


def component_of(text: bytes) -> dict[str, Any]:
    """One of `Sbom.component_texts`, whatever it is; empty if it is no JSON object. Raises ScannerFailed if it is no JSON."""
    return _object(text, untrusted.SIZE)


def _object(text: bytes, limit: int) -> dict[str, Any]:
    with _well_formed():
        value = untrusted.json_quick(text, limit)
    return value if isinstance(value, dict) else {}


def _is_about(about: About | None, digest: str) -> bool:
    return bool(about and about.component and about.component.name.endswith(f"@{digest}"))


@contextmanager
def _well_formed() -> Iterator[None]:
    """Turns a ValueError about a text that should be an SBOM into ScannerFailed."""
    try:
        yield
    except ValueError as error:
        reason = first_of(error) if isinstance(error, ValidationError) else error
        text = f"what is kept as an SBOM is none: {reason}"
        raise ScannerFailed(text, "delete that artifact in the registry") from None


class Shelf:
    """SBOMs in the registry. A build attaches each to the manifest that it made.

    Everybody who may push into a repository can attach a false SBOM. So a shelf ignores what is attached, and takes only the artifact
    that the publisher's records name by digest.
    """

    def __init__(self, client: Registry, recorded: Mapping[str, str]) -> None:
        """`recorded` is from the records: digests of artifacts with SBOMs, by the digests of their manifests."""
        self.client, self.recorded = client, recorded

    def load(self, repository: str, digest: str) -> Sbom:
        """The SBOM of a manifest, if the records name one that is there, ours, and of this image."""
        artifact = self.recorded.get(digest)
        manifest = self.client.manifest(repository, artifact) if artifact else None
        if manifest is None:
            raise ScannerFailed("the records name no SBOM of it" if not artifact else "its SBOM is not there", REMEDY)
        if manifest.subject == digest and len(manifest.layers) == 1 and manifest.annotations.items() >= FORMAT.items():
            document = Sbom(self.client.part(repository, manifest.layers[0]))
            if document.is_of(digest):
                return document
        raise ScannerFailed("what the records name as its SBOM is another thing", REMEDY)
