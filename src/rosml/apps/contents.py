"""What is in an app's images, attached to them in a registry: an SBOM, and the list of their files.

Whoever has the name of an image knows its packages without pulling it, and `rosml join` knows whether a part has the same files.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Any
from urllib.parse import quote

from pydantic import BaseModel, ConfigDict, ValidationError

from rosml.apps.sources import Repository
from rosml.base.errors import RosmlError
from rosml.build import file_list
from rosml.join import file_lists
from rosml.join.layers import platform
from rosml.registry import oci
from rosml.scan.sbom import MEDIA_TYPE

PACKAGES = "packages.json"
"""The packages of an image, as components/containerize/contents.py writes them."""

FILES = "files.gz"
"""The list of its files."""

KINDS = (PACKAGES, FILES)

FORMAT = {"io.rosml.sbom.format": "1"}
"""The annotation of our SBOMs. With another number all images get a new one, although their digests stay the same."""

COMMIT = "io.rosml.commit"
"""The property of a ROS package that says which commit of its repository it was built from."""


class _Model(BaseModel):
    model_config = ConfigDict(strict=True, extra="forbid")


class _System(_Model):
    name: str
    version: str


class _Apt(_Model):
    name: str
    version: str
    architecture: str
    source: str
    source_version: str


class _Python(_Model):
    name: str
    version: str


class _Ros(_Model):
    name: str
    version: str
    licenses: list[str]


class Packages(_Model):
    """The packages of an image: of its operating system, of Python, and the ROS packages of apps."""

    system: _System
    apt: list[_Apt]
    python: list[_Python]
    ros: list[_Ros]


def sbom(data: bytes, reference: str, sources: Mapping[str, Repository]) -> bytes:
    """An SBOM in CycloneDX 1.5. The same packages give the same bytes.

    Versions and sources of Debian packages are written as package URLs, and in properties as trivy writes them:
    https://github.com/package-url/purl-spec/blob/main/types-doc/deb-definition.md

    Args:
        data: the packages of the image, as `PACKAGES` has them.
        reference: of the image, by its digest.
        sources: upstream repositories of ROS packages, by the package's name.

    Raises:
        RosmlError: the data is damaged.
    """
    try:
        found = Packages.model_validate_json(data)
    except ValidationError:
        raise RosmlError("what the build says of the packages is damaged", "run it again") from None
    document = {
        "$schema": "http://cyclonedx.org/schema/bom-1.5.schema.json",
        "bomFormat": "CycloneDX",
        "specVersion": "1.5",
        "version": 1,
        "metadata": {"component": {"bom-ref": reference, "type": "container", "name": reference}},
        "components": list({item["bom-ref"]: item for item in _components(found, sources)}.values()),
    }
    return oci.encoded(document)


def _components(found: Packages, sources: Mapping[str, Repository]) -> Iterator[dict[str, Any]]:
    system = found.system
    whole = "-".join(filter(None, (system.name, system.version)))
    if whole:
        yield {"bom-ref": whole, "type": "operating-system", "name": system.name, "version": system.version}
    for package in found.apt:
        qualifiers = f"arch={package.architecture}&distro={whole}"
        yield _library(
            package.name,
            package.version,
            f"deb/{system.name}",
            qualifiers,
            properties=[
                {"name": f"aquasecurity:trivy:{name}", "value": value}
                for name, value in (
                    ("PkgType", system.name),
                    ("SrcName", package.source),
                    ("SrcVersion", package.source_version),
                )
            ],
        )
    for wheel in found.python:
        yield _library(wheel.name, wheel.version, "pypi")
    for ros in found.ros:
        made: dict[str, Any] = {"licenses": [{"license": {"name": name}} for name in ros.licenses]}
        if source := sources.get(ros.name):
            made["properties"] = [{"name": COMMIT, "value": source.commit}]
            if url := _public(source.url):
                made["externalReferences"] = [{"type": "vcs", "url": url, "comment": source.version}]
        yield _library(ros.name, ros.version, "generic/ros", **made)


def _public(url: str) -> str:
    """The URL of a repository as CycloneDX takes it; empty for one of this machine."""
    if "://" in url:
        return "" if url.startswith("file:") else quote(url, safe=":/?#[]@!$&'()*+,;=~%")
    host, colon, path = url.partition(":")
    return f"ssh://{host}/{quote(path.lstrip('/'))}" if colon and not url.startswith("/") else ""


def _library(name: str, version: str, kind: str, qualifiers: str = "", **more: Any) -> dict[str, Any]:
    called = name.lower().replace("_", "-") if kind == "pypi" else name
    url = f"pkg:{kind}/{quote(called, safe='')}"
    url += f"@{quote(version, safe=':')}" if version else ""
    url += f"?{qualifiers}" if qualifiers else ""
    return {"bom-ref": url, "type": "library", "name": name, "version": version, "purl": url, **more}


def attach(
    registry: oci.Registry,
    repository: str,
    digest: str,
    load: Callable[[str, str], bytes],
    sources: Mapping[str, Repository],
) -> None:
    """Attaches an SBOM and a list of files to an image, for each of its platforms. What is there stays.

    Args:
        digest: of the image, or of an index.
        load: what a build said of it: from a platform, and `PACKAGES` or `FILES`.
        sources: as `sbom` has them.

    Raises:
        RosmlError: the registry does not answer or refuses.
    """
    for manifest in file_list.manifests(registry, repository, digest):
        has_files = bool(registry.referrers(repository, manifest.digest, file_lists.ARTIFACT))
        has_sbom = _has_sbom(registry, repository, manifest.digest)
        if has_files and has_sbom:
            continue
        name = platform(registry.config(repository, manifest).facts)
        subject = manifest.descriptor
        if not has_files:
            data = load(name, FILES)
            registry.attach(repository, subject, file_lists.ARTIFACT, data, file_lists.MEDIA_TYPE)
        if not has_sbom:
            data = sbom(load(name, PACKAGES), f"{registry.host}/{repository}@{manifest.digest}", sources)
            registry.attach(repository, subject, MEDIA_TYPE, data, MEDIA_TYPE, FORMAT)


def _has_sbom(registry: oci.Registry, repository: str, digest: str) -> bool:
    """Whether an SBOM of ours is attached; others may attach theirs."""
    for entry in registry.referrers(repository, digest, MEDIA_TYPE):
        manifest = registry.manifest(repository, entry["digest"])
        if manifest and manifest.annotations.items() >= FORMAT.items():
            return True
    return False
