"""What is in an image, as CycloneDX: read once, and kept in the registry beside the image."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from rosml.registry.oci import Registry
from rosml.scan.trivy import ScannerFailed

MEDIA_TYPE = "application/vnd.cyclonedx+json"
"""Also the type of the artifact, by which trivy and others find it beside an image."""

SCANNER_ANNOTATION = "io.rosml.sbom.scanner"

OF_A_SYSTEM = re.compile(r"pkg:(?:deb|rpm|apk)/([^/]+)/")
"""The package URL of an operating system's package; its group is that system."""


@dataclass(frozen=True)
class Sbom:
    """An SBOM.

    Attributes:
        content: the bytes that are kept.
    """

    content: bytes

    @classmethod
    def of(cls, written: Mapping[str, Any], digest: str) -> Sbom:
        """What trivy wrote about an image.

        Raises:
            ScannerFailed: it is no SBOM, or one of another image.
        """
        made = cls(json.dumps(written, separators=(",", ":"), ensure_ascii=False).encode())
        if not made.is_of(digest):
            raise ScannerFailed(f"trivy's SBOM of {digest} is of something else")
        return made

    def is_of(self, digest: str) -> bool:
        """Whether it says that it is of an image.

        Raises:
            ScannerFailed: it is no CycloneDX.
        """
        try:
            return digest in self.document["metadata"]["component"]["name"]
        except (KeyError, TypeError):
            return False

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
        """Its packages, without those of another operating system: a wheel's SBOM names the packages that its libraries were
        copied from, which no advisory of this system speaks of."""
        family = self.system.partition(" ")[0]
        libraries = [item for item in self.document["components"] if item["type"] == "library"]
        origins = [OF_A_SYSTEM.match(item.get("purl", "")) for item in libraries]
        return [item for item, origin in zip(libraries, origins, strict=True) if not origin or origin[1] == family]

    @property
    def system(self) -> str:
        """Its operating system, such as `debian 12.12`; empty where it has none. One without a version is none of its own: a
        wheel's SBOM says where the libraries in it came from."""
        found = [
            item for item in self.document["components"] if item["type"] == "operating-system" and "version" in item
        ]
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

    def __init__(self, client: Registry, scanner: str) -> None:
        """Keeps SBOMs with a registry.

        Args:
            client: of that registry.
            scanner: name and version of what makes them; those of another version are made anew.
        """
        self.client, self.scanner = client, scanner

    def load(self, repository: str, digest: str) -> Sbom | None:
        """The SBOM of a manifest; None where there is none of our scanner.

        Raises:
            RosmlError: the registry fails.
        """
        for descriptor in self.client.referrers(repository, digest, MEDIA_TYPE):
            manifest = self.client.manifest(repository, descriptor["digest"])
            if manifest is None:  # deleted since; its entry may stay in a list that stands in for the API
                continue
            if (manifest.content.get("annotations") or {}).get(SCANNER_ANNOTATION) == self.scanner:
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
        annotations = {SCANNER_ANNOTATION: self.scanner}
        self.client.attach(repository, manifest.descriptor, MEDIA_TYPE, sbom.content, MEDIA_TYPE, annotations)
