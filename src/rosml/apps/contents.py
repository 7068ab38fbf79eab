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

FOLDER = "contents"
"""Of a build's report: a folder for each image."""

PACKAGES = "packages.json"
"""The packages of an image, as components/containerize/contents.py writes them."""

FILES = "files.gz"
"""The list of its files."""

KINDS = (PACKAGES, FILES)


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
    if system.name:
        whole = f"{system.name}-{system.version}"
        yield {"bom-ref": whole, "type": "operating-system", "name": system.name, "version": system.version}
    for package in found.apt:
        qualifiers = f"arch={package.architecture}&distro={system.name}-{system.version}"
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
            made["externalReferences"] = [
                {"type": "vcs", "url": source.url, "comment": f"{source.version} {source.commit}".strip()}
            ]
        yield _library(ros.name, ros.version, "generic/ros", **made)


def _library(name: str, version: str, kind: str, qualifiers: str = "", **more: Any) -> dict[str, Any]:
    called = name.lower().replace("_", "-") if kind == "pypi" else name
    url = f"pkg:{kind}/{quote(called, safe='')}@{quote(version, safe='')}" + (f"?{qualifiers}" if qualifiers else "")
    return {"bom-ref": url, "type": "library", "name": name, "version": version, "purl": url, **more}


def attach(
    registry: oci.Registry,
    repository: str,
    digest: str,
    load: Callable[[str, str], bytes | None],
    sources: Mapping[str, Repository],
) -> bool:
    """Attaches an SBOM and a list of files to an image, for each of its platforms. What is there stays.

    Args:
        digest: of the image, or of an index.
        load: what a build said of it: from a platform, and `PACKAGES` or `FILES`.
        sources: as `sbom` has them.

    Returns:
        Whether it has both now. It has not if nobody knows what a build said.

    Raises:
        RosmlError: the registry does not answer or refuses.
    """
    complete = True
    for manifest in file_list.manifests(registry, repository, digest):
        config: dict[str, Any] = {}
        for kind, artifact_type, media_type in (
            (PACKAGES, MEDIA_TYPE, MEDIA_TYPE),
            (FILES, file_lists.ARTIFACT, file_lists.MEDIA_TYPE),
        ):
            if registry.referrers(repository, manifest.digest, artifact_type):
                continue
            config = config or registry.json_blob(repository, manifest.content["config"]["digest"])
            data = load(platform(config), kind)
            if data is None:
                complete = False
                continue
            reference = f"{registry.host}/{repository}@{manifest.digest}"
            part = sbom(data, reference, sources) if kind == PACKAGES else data
            registry.attach(repository, manifest.descriptor, artifact_type, part, media_type)
    return complete
