"""Images of a few bytes with all that rosml attaches to real ones, and dossiers of them."""

from __future__ import annotations

import contextlib
import json
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import cache
from pathlib import Path
from typing import Any

from fakes.http_registry import LocalRegistry, local_registry
from fakes.rebasing import App, require
from rosml import MATRIX
from rosml.images.dossier.gather import Dossier, Request, gather
from rosml.images.image_set import load
from rosml.images.image_set.labels import REVISION, SBOM, SOURCE
from rosml.images.join.transfer import Transfer
from rosml.images.matrix.model import Matrix
from rosml.images.publish import provenance
from rosml.images.scan import cyclonedx, sbom
from rosml.images.scan.packages import Apt, Packages, Python, Ros, System
from rosml.registry import oci
from rosml.registry.client import Registries, Registry
from tests.e2e.parts import ros

NOW = "2026-11-29T12:00:00Z"

HOSTILE = '<img src=x onerror="document.title=1">\u202e'
"""What a stranger may write anywhere."""

FILES = (
    "usr/share/common-licenses/GPL-3",
    "usr/share/doc/bash/copyright",
    "usr/share/doc/libc6",  # a link to a folder
    "usr/lib/python3/dist-packages/torch-2.10.0.dist-info/licenses/LICENSE",
    "usr/lib/python3/dist-packages/torch-2.10.0.dist-info/METADATA",
)


@cache
def matrix() -> Matrix:
    return load.without_locks(MATRIX).matrix


def apt(name: str, version: str, **more: Any) -> Apt:
    usual = {"architecture": "amd64", "source": name, "source_version": version, "maintainer": f"{name} <{name}@d.org>"}
    return Apt(name=name, version=version, **{**usual, **more})


def contents(*more: Ros, system: str = "debian") -> Packages:
    """The packages of an image: of a system, of Python, and those of an app."""
    return Packages(
        system=System(name=system, version="12"),
        apt=[
            apt("bash", "5.2.15-2", depends="libc6", licenses=["GPL-3+"]),
            apt("libc6", "2.36-9", source="glibc", licenses=["LGPL-2.1"]),
            apt("python3", "3.11.2-1+b1", licenses=["Python"]),
        ],
        python=[
            Python(name="torch", version="2.10.0", licenses=["BSD-3-Clause"], requires=["numpy"]),
            Python(name="numpy", version="1.26.4", author="Travis", licenses=[HOSTILE]),
            Python(name="nvidia-cuda-runtime-cu12", version="12.8.90", licenses=["NVIDIA Proprietary"]),
        ],
        ros=[*more],
    )


ROBOT = Ros(name="robot", version="1.0.0", maintainer="Ada <ada@example.com>", licenses=["Apache-2.0"])


@dataclass
class Shop:
    """A registry with images, and who asks for dossiers of them."""

    server: LocalRegistry
    root: Path
    registry: Registry = field(init=False)
    messages: list[str] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.registry = Registry(self.server.address)

    def base(
        self,
        tag: str = "core",
        annotations: Mapping[str, str] | None = None,
        with_sbom: bool = True,
        labels: Mapping[str, str] | None = None,
    ) -> str:
        """Puts a published ROS image for one platform; gives its reference."""
        tiny = ros(salt=tag, files=FILES)
        more = {REVISION: "0" * 39 + "1", SOURCE: "https://example.com/me/rosml"}
        tiny = replace(tiny, labels={**tiny.labels, **more, **(labels or {})})
        digest, size = tiny.put_manifest(self.registry, "rosml/ros")
        annotations_of_image = (
            {provenance.COVERED: self.statement("rosml/ros", digest)} if annotations is None else {**annotations}
        )
        if with_sbom:
            annotations_of_image[f"{SBOM}.core"] = f"rosml/ros@{self.sbom('rosml/ros', digest, contents())}"
        self.index("rosml/ros", tag, digest, size, annotations_of_image)
        return f"{self.server.address}/rosml/ros:{tag}"

    def index(self, repository: str, tag: str, digest: str, size: int, annotations: Mapping[str, str]) -> None:
        place = {"os": "linux", "architecture": "amd64"}
        entry = {"mediaType": oci.IMAGE, "digest": digest, "size": size, "platform": place, "annotations": annotations}
        content = {"schemaVersion": 2, "mediaType": oci.INDEX, "manifests": [entry]}
        self.registry.put_manifest(repository, tag, content, oci.INDEX)

    def app(self, base: str) -> str:
        """Puts an app, as `rosml containerize` makes it."""
        reference = App(base, labels={REVISION: "0" * 39 + "2"}).put(self.registry, "latest")
        digest = self.registry.head("me/robot", "latest")
        self.sbom("me/robot", digest, contents(ROBOT))
        return reference

    def sbom(self, repository: str, digest: str, of: Packages) -> str:
        data = cyclonedx.document(of, f"{self.server.address}/{repository}@{digest}", 1_700_000_000.0)
        return self.attach(repository, digest, sbom.MEDIA_TYPE, data, sbom.FORMAT)

    def statement(self, repository: str, digest: str) -> str:
        made_from = [{"name": "source", "uri": f"git+https://{HOSTILE}", "digest": {"gitCommit": "0" * 40}}]
        definition = provenance.definition({"target": "ros1-bookworm-core"}, "sha256:1", made_from)
        machine = provenance.Machine(provenance.OWN_MACHINE, NOW)
        about = provenance.Statement(f"{self.server.address}/{repository}", digest, definition, machine, NOW, NOW)
        return provenance.attach(self.registry, replace(about, repository=repository))

    def attach(
        self, repository: str, digest: str, kind: str, data: bytes, annotations: Mapping[str, str] | None = None
    ) -> str:
        subject = require(self.registry.manifest(repository, digest)).descriptor
        return self.registry.attach(repository, subject, kind, data, kind, annotations)

    def only(self, reference: str) -> tuple[str, str]:
        """The repository and the digest of an image for one platform."""
        repository, _, tag = reference.partition("/")[2].rpartition(":")
        manifest = require(self.registry.manifest(repository, tag))
        return repository, manifest.members[0].digest if manifest.is_index else manifest.digest

    def dossier(self, reference: str, **more: Any) -> Dossier:
        usual = {"platform": "linux/amd64", "form": "cyclonedx", "signer": ""}
        request = Request(
            name=reference, root=self.root, matrix=matrix(), now=NOW, say=self.messages.append, **{**usual, **more}
        )
        with Registries() as registries, Transfer(registries, self.messages.append) as transfer:
            return gather(request, transfer)


@contextlib.contextmanager
def shop(root: Path) -> Iterator[Shop]:
    with local_registry() as server:
        opened = Shop(server, root)
        yield opened
        opened.registry.close()


def vex(*statements: Mapping[str, Any]) -> bytes:
    """OpenVEX with some statements."""
    return json.dumps({"author": "us", "timestamp": NOW, "statements": list(statements)}).encode()


def components(*items: Mapping[str, Any], **more: Any) -> dict[str, Any]:
    """An SBOM with some components."""
    usual = {"bomFormat": "CycloneDX", "specVersion": "1.6", "metadata": {"component": {"bom-ref": "image"}}}
    return {**usual, "components": list(items), **more}
