"""Images of a few bytes with the labels of real ones: ROS images and parts, put into a registry without a builder."""

from __future__ import annotations

import gzip
import io
import json
import tarfile
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

from rosml.images.image_set import labels
from rosml.images.join import file_lists
from rosml.images.matrix import combinations
from rosml.images.matrix.model import ANY_PYTHON, PartEntry
from rosml.registry import oci
from rosml.registry.client import Registry

CREATED = "2026-01-01T00:00:00Z"
PLATFORMS = ("linux/amd64",)
ENTRIES = {
    part.name: part
    for part in (
        PartEntry(name="cuda", title="CUDA", versions=("cuda", "cudnn"), accelerator="cuda", any_python=True),
        PartEntry(name="common", needs=("cuda",), shared=True),
        PartEntry(name="torch", title="PyTorch", release="torch", needs=("common",)),
        PartEntry(name="tensorflow-cc", release="tensorflow", any_python=True, needs=("tensorflow",)),
        PartEntry(name="tensorflow", title="TensorFlow", short="tf", release="tensorflow", needs=("common",)),
        PartEntry(name="graph-cc", release="graph", any_python=True, needs=("graph",)),
        PartEntry(name="graph", title="GRAPH", release="graph", needs=("common", "graph-cc")),
        PartEntry(name="devel", any_python=True, needs=("cuda",)),
    )
}
PARTS = tuple(ENTRIES)[:5]
ADDONS = {"graph": ("cuda", "common", "graph-cc", "graph"), "devel": ("cuda", "devel")}
ADDON_OF = {"graph-cc": "graph", "graph": "graph", "devel": "devel"}
"""The add-on of each part that is its own."""
GPU = {
    "cuda": {"driver": "525"},
    "torch": {"torch.amd64": "sm_80 sm_90"},
    "graph": {"graph.amd64": "sm_80 sm_90a"},
}
"""What parts with CUDA say of GPUs."""
FRAMEWORKS = {
    "cuda": ("cuda",),
    "torch": ("cuda", "common", "torch"),
    "tensorflow": ("cuda", "common", "tensorflow-cc", "tensorflow"),
    "ml": PARTS,
}
VERSIONS = {"cuda": "12.8.90", "cudnn": "9.10.2.21", "torch": "2.10.0", "tensorflow": "2.20.0", "graph": "1.23.2"}


@dataclass(frozen=True)
class Tiny:
    """An image to be put into a registry.

    Attributes:
        labels: of its config. files: what its one layer holds.
        listed: the list of its files; the same as `files` if None. unlisted: without a list.
        environment: beside PATH. salt: makes another image of the same.
    """

    labels: Mapping[str, str]
    files: Sequence[str] = ()
    listed: Sequence[str] | None = None
    unlisted: bool = False
    environment: Sequence[str] = ()
    salt: str = ""
    config: Mapping[str, object] = field(default_factory=dict)

    def put(self, registry: Registry, repository: str, tag: str, platforms: Sequence[str] = PLATFORMS) -> str:
        """Puts it under a tag, for some platforms; gives its reference."""
        entries = []
        for platform in platforms:
            digest, size = self.put_manifest(registry, repository, platform)
            os, architecture = platform.split("/")
            place = {"os": os, "architecture": architecture}
            entries.append({"mediaType": oci.IMAGE, "digest": digest, "size": size, "platform": place})
        registry.put_manifest(
            repository, tag, {"schemaVersion": 2, "mediaType": oci.INDEX, "manifests": entries}, oci.INDEX
        )
        return f"{registry.host}/{repository}:{tag}"

    def put_manifest(self, registry: Registry, repository: str, platform: str = PLATFORMS[0]) -> tuple[str, int]:
        """Puts it for one platform, by its digest alone; gives the manifest's digest and size."""
        os, architecture = platform.split("/")
        layer = archive([*self.files, f"made/{self.labels.get(labels.TITLE, 'nothing')}"], f"{platform} {self.salt}")
        config = {
            "os": os,
            "architecture": architecture,
            "created": CREATED,
            "config": {
                "Env": ["PATH=/usr/sbin:/usr/bin", *self.environment],
                "Entrypoint": ["/tini", "--", "/entrypoint.sh"],
                "Labels": dict(self.labels),
            },
            "rootfs": {"type": "layers", "diff_ids": [oci.digest_of(gzip.decompress(layer))]},
            "history": [{"created": CREATED, "created_by": "COPY / /"}],
            **self.config,
        }
        data = json.dumps(config).encode()
        for blob in (layer, data):
            registry.put_blob(repository, blob)
        manifest = oci.encoded(
            {
                "schemaVersion": 2,
                "mediaType": oci.IMAGE,
                "config": oci.descriptor(oci.CONFIG, data),
                "layers": [oci.descriptor("application/vnd.oci.image.layer.v1.tar+gzip", layer)],
            }
        )
        digest = registry.put_manifest(repository, "", manifest)
        if not self.unlisted:
            names = sorted(self.files if self.listed is None else self.listed)
            text = "".join(f"{name}\n" for name in names).encode(errors="surrogateescape")
            subject = oci.descriptor(oci.IMAGE, manifest)
            registry.attach(
                repository, subject, file_lists.ARTIFACT, gzip.compress(text, mtime=0), file_lists.MEDIA_TYPE
            )
        return digest, len(manifest)


def archive(files: Sequence[str], content: str) -> bytes:
    """A layer with some files, all with the same content; the same bytes for the same files."""
    stream = io.BytesIO()
    with tarfile.open(fileobj=stream, mode="w") as tar:
        for name in files:
            entry = tarfile.TarInfo(name)
            entry.size = len(content.encode())
            tar.addfile(entry, io.BytesIO(content.encode()))
    return gzip.compress(stream.getvalue(), mtime=0)


def ros(distribution: str = "ros1-bookworm", component: str = "core", python: str = "3.11", **more: object) -> Tiny:
    """A ROS image. `more`: what else `Tiny` has."""
    texts = {
        **labels.about_image(labels.ImageKind(distribution, component, "1"), []),
        "org.opencontainers.image.licenses": "Apache-2.0",
        "io.rosml.distribution": distribution,
        "io.rosml.framework": "none",
        "io.rosml.os": "bookworm",
        "io.rosml.python": python,
        "io.rosml.ros": "1",
    }
    facts = {"files": ("usr/bin/env", "bin", "lib", "opt/ros/setup.bash"), **more}
    return Tiny(texts, **facts)  # type: ignore[arg-type]


def part(
    kind: str,
    stack: str = "cu128",
    python: str = "3.11",
    versions: Mapping[str, str] = VERSIONS,
    frameworks: Mapping[str, Sequence[str]] | None = None,
    **more: object,
) -> Tiny:
    """A part of a stack with CUDA, or of one whose name begins with `cpu`. `more`: what else `Tiny` has."""

    def entries(parts: Sequence[str]) -> list[PartEntry]:
        present = [other for other in parts if other != "cuda" or not stack.startswith("cpu")]
        return [ENTRIES.get(other) or PartEntry(name=other) for other in present]

    taking = {name: entries(parts) for name, parts in (frameworks or FRAMEWORKS).items() if kind in parts}
    adding = {ADDON_OF[kind]: entries(ADDONS[ADDON_OF[kind]])} if kind in ADDON_OF else {}
    entry = ENTRIES[kind]
    python = ANY_PYTHON if entry.any_python else python
    brought = [
        replace(item, version=versions[item.name]) for item in combinations.brought_by(entry) if item.name in versions
    ]
    gpu = {} if stack.startswith("cpu") else GPU.get(kind)
    texts = labels.of_part(entry, stack, python, brought, taking, adding) | labels.about_gpus(gpu or {})
    return Tiny(texts, **{"files": (f"usr/local/share/{kind}",), **more})  # type: ignore[arg-type]


def environment(name: str = "policy", takes: str = "", python: str = "3.11", **more: object) -> Tiny:
    """An environment. `takes`: the releases of its image, such as `torch=2.10.0`. `more`: what else `Tiny` has."""
    title = f"env:{name}-py{python.replace('.', '')}"
    texts = {labels.TITLE: title, labels.ENVIRONMENT: name, f"{labels.PREFIX}python": python, labels.TAKES: takes}
    return Tiny(texts, **{"files": (f"opt/env/{name}/pyvenv.cfg",), "salt": name, **more})  # type: ignore[arg-type]


def stack(registry: Registry, repository: str, parts: Sequence[str], name: str = "cu128", **more: object) -> list[str]:
    """Puts parts of a stack into a repository; gives their references. `more`: what else `part` has."""
    return [part(kind, name, **more).put(registry, repository, f"{kind}-{name}") for kind in parts]  # type: ignore[arg-type]
