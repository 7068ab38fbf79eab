"""What is in an image, as CycloneDX: made canonical, and kept in the registry beside the image.

The SBOM of a part depends on nothing but the part: no time, no random number, no address of a registry is in it. So
every machine that makes it makes the same bytes.
"""

from __future__ import annotations

import json
import uuid
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from rosml.registry.protocol import Client
from rosml.scan.trivy import ScannerFailed

MEDIA_TYPE = "application/vnd.cyclonedx+json"
"""Also the type of the artifact, by which trivy and others find it beside an image."""

FORMAT = "1"
"""Raised when what is made of trivy's output changes: SBOMs of before are made anew."""

FORMAT_ANNOTATION = "io.rosml.sbom.format"
SCANNER_ANNOTATION = "io.rosml.sbom.scanner"

NAMES = uuid.UUID("6a1c9a4e-3d0b-5f0c-9a57-1f6d0c1a7b21")
"""Namespace of the identifiers that take the place of random ones."""

ADDRESSES = ("aquasecurity:trivy:RepoDigest", "aquasecurity:trivy:RepoTag", "aquasecurity:trivy:Reference")
"""Properties that say where the image was read: it may be anywhere."""


@dataclass(frozen=True)
class Sbom:
    """A canonical SBOM.

    Attributes:
        content: the bytes that are kept.
    """

    content: bytes

    @classmethod
    def of(cls, written: Mapping[str, Any], digest: str) -> Sbom:
        """The canonical form of what trivy wrote about an image.

        Raises:
            ScannerFailed: it is no SBOM, or one of another image.
        """
        try:
            return cls(_text(_canonical(written, digest)))
        except (KeyError, TypeError, AttributeError, ValueError) as error:
            raise ScannerFailed(f"trivy's SBOM of {digest} cannot be read: {error!r}") from None

    @cached_property
    def document(self) -> dict[str, Any]:
        """The content as data.

        Raises:
            ScannerFailed: it is no CycloneDX, e.g. because somebody else put it into the registry.
        """
        try:
            document = json.loads(self.content)
            if document["bomFormat"] == "CycloneDX" and all(
                isinstance(item["bom-ref"], str) and isinstance(item["type"], str) for item in document["components"]
            ):
                return dict(document)
        except (ValueError, KeyError, TypeError, RecursionError):
            pass
        raise ScannerFailed("what is kept as an SBOM is none", "delete that artifact in the registry")

    @property
    def packages(self) -> list[dict[str, Any]]:
        """Its packages."""
        return [item for item in self.document["components"] if item["type"] == "library"]

    @property
    def system(self) -> str:
        """Its operating system, such as `debian 12.12`; empty where it has none."""
        found = [item for item in self.document["components"] if item["type"] == "operating-system"]
        return f"{found[0]['name']} {found[0]['version']}" if found else ""

    @property
    def sources(self) -> list[str]:
        """Names of the advisories' sources, as trivy's database calls them, that its packages need."""
        family, _, version = self.system.partition(" ")
        release = version.partition(".")[0] if family == "debian" else version
        wheels = any(item.get("purl", "").startswith("pkg:pypi/") for item in self.packages)
        return [*([f"{family} {release}"] if family else []), *(["pip::"] if wheels else [])]

    def require(self, name: str, ros: bool) -> None:
        """Checks that it can be all that is in a part: an SBOM that misses most would look like a clean image.

        Raises:
            ScannerFailed: it lacks the operating system, or its packages.
        """
        debian = sum(item.get("purl", "").startswith("pkg:deb/") for item in self.packages)
        if ros and not (self.system and debian):
            raise ScannerFailed(
                f"{name}: trivy found {'no operating system' if not self.system else 'no Debian package'} in it",
                "the pinned trivy may not know this operating system, or the image lacks /var/lib/dpkg/status",
            )


class Shelf:
    """SBOMs in the registry, each attached to the manifest that it is of."""

    def __init__(self, client: Client, scanner: str) -> None:
        """Keeps SBOMs with a registry.

        Args:
            client: of that registry.
            scanner: name and version of what makes them; those of another version are made anew.
        """
        self.client = client
        self.annotations = {FORMAT_ANNOTATION: FORMAT, SCANNER_ANNOTATION: scanner}

    def load(self, repository: str, digest: str) -> Sbom | None:
        """The SBOM of a manifest; None where there is none of our format and scanner.

        Raises:
            RosmlError: the registry fails.
        """
        for descriptor in self.client.referrers(repository, digest, MEDIA_TYPE):
            manifest = self.client.manifest(repository, descriptor["digest"])
            if manifest is None:  # deleted since; its entry may stay in a list that stands in for the API
                continue
            found = manifest.content.get("annotations") or {}
            if all(found.get(name) == text for name, text in self.annotations.items()):
                return Sbom(self.client.blob(repository, manifest.content["layers"][0]["digest"]))
        return None

    def store(self, repository: str, digest: str, sbom: Sbom) -> None:
        """Attaches an SBOM to a manifest.

        Raises:
            RosmlError: there is no such manifest, or the registry fails.
        """
        manifest = self.client.manifest(repository, digest)
        if manifest is None:
            raise ScannerFailed(f"{repository}@{digest} is not in the registry", "build it again")
        self.client.attach(repository, manifest.descriptor, MEDIA_TYPE, sbom.content, MEDIA_TYPE, self.annotations)


def _canonical(written: Mapping[str, Any], digest: str) -> dict[str, Any]:
    """Without what differs from call to call, and from place to place."""
    top = written["metadata"]["component"]
    if digest not in top["name"]:
        raise ValueError(f"it is of {top['name']}")
    repository = top["name"].partition("@")[0].partition("/")[2]
    root = _identifier(digest, "root")
    new = {top["bom-ref"]: root}
    components = []
    for item in written["components"]:
        if _random(item["bom-ref"]):
            facts = [item["type"], item["name"], item.get("version", ""), item.get("purl", "")]
            facts += sorted(f"{fact['name']}={fact['value']}" for fact in item.get("properties", []))
            name, number = _identifier(digest, *facts), 0
            while name in new.values():
                number += 1
                name = _identifier(digest, *facts, str(number))
            new[item["bom-ref"]] = name
        components.append({**item, "bom-ref": new.get(item["bom-ref"], item["bom-ref"])})
    dependencies = [
        {
            "ref": new.get(item["ref"], item["ref"]),
            "dependsOn": sorted(new.get(reference, reference) for reference in item.get("dependsOn", [])),
        }
        for item in written.get("dependencies", [])
    ]
    properties = [fact for fact in top.get("properties", []) if fact["name"] not in ADDRESSES]
    return {
        **{key: written[key] for key in ("$schema", "bomFormat", "specVersion") if key in written},
        "serialNumber": f"urn:uuid:{_identifier(digest, 'document')}",
        "version": 1,
        "metadata": {
            "tools": _tools(written["metadata"]["tools"]),
            "component": {
                "bom-ref": root,
                "type": top["type"],
                "name": f"{repository}@{digest}",
                "purl": _purl(repository, digest),
                "properties": properties,
            },
        },
        "components": sorted(components, key=lambda item: str(item["bom-ref"])),
        "dependencies": sorted(dependencies, key=lambda item: str(item["ref"])),
    }


def _purl(repository: str, digest: str) -> str:
    """A package URL of an image, without a registry."""
    return f"pkg:oci/{repository.rpartition('/')[2]}@{digest.replace(':', '%3A')}"


def _random(reference: str) -> bool:
    try:
        return str(uuid.UUID(reference)) == reference
    except ValueError:
        return False


def _identifier(*facts: str) -> str:
    return str(uuid.uuid5(NAMES, "\n".join(facts)))


def _text(document: Mapping[str, Any]) -> bytes:
    return json.dumps(document, separators=(",", ":"), ensure_ascii=False, sort_keys=True).encode()


def _tools(written: Mapping[str, Any]) -> dict[str, Any]:
    """Programs with their versions as their publishers write them: 0.65.0, where one that we built says v0.65.0."""
    return {
        "components": [
            {**item, "version": str(item.get("version", "")).removeprefix("v")} for item in written["components"]
        ]
    }
