"""Apps of a few bytes each, with facts about them, and a registry in this process in which they move to other base images."""

from __future__ import annotations

import gzip
import json
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import pytest

from fakes.http_registry import LocalRegistry, local_registry
from rosml.base.errors import RosmlError
from rosml.containerize.lock import Image, Lock
from rosml.containerize.rebase import image
from rosml.containerize.rebase.plan import Plan, Rebased
from rosml.containerize.rebase.rebaser import Rebaser
from rosml.images.image_set.labels import APP, BASE_DIGEST, BASE_NAME, LOCK, REVISION, TITLE
from rosml.images.join import facts
from rosml.images.join.joiner import Joiner
from rosml.images.scan import sbom
from rosml.machine.services import Services
from rosml.registry import oci, references, retries
from rosml.registry.client import Registries, Registry
from rosml.registry.oci import Manifest
from tests.e2e import parts
from tests.e2e.parts import archive, part, ros

BOTH = ("linux/amd64", "linux/arm64")
WHEN = "2026-11-20T10:00:00Z"
X86 = [2, 1, 62]

FILES = ("usr/bin/env", "bin", "usr/bin/new")
"""Files of a base image that is not the usual one, and with which all apps run."""


def library(path: str, symbols: Sequence[str] = (), needed: Sequence[str] = (), **more: Any) -> dict[str, Any]:
    """A library or program as facts have it."""
    groups = sorted({facts.hashed(name) for name in symbols})
    usual = {"soname": path.rpartition("/")[2] if ".so" in path else "", "id": "0" * 40, "names": [], "machine": X86}
    return {"path": path, **usual, "needed": list(needed), "symbols": "".join(groups), "uses": [], **more}


def package(name: str, version: str = "1.0", **more: Any) -> dict[str, Any]:
    usual = {"architecture": "amd64", "provides": "", "depends": "", "conflicts": ""}
    return {"name": name, "version": version, **usual, **more}


LIBC = library("usr/lib/libc.so.6", ("printf",))
ROSCPP = library("opt/ros/lib/librclcpp.so", ("spin", "shutdown"), ["libc.so.6"])
PYTHON = library("usr/bin/python3.11", ("PyObject_Call",), soname="")
BASE_FACTS: dict[str, Any] = {"packages": [package("python3", "3.11.2-1")], "libraries": [LIBC, ROSCPP, PYTHON]}
OWN: dict[str, Any] = {
    "packages": [package("python3-angles", "1.16", depends="python3 (<< 3.12)", files=["usr/lib/python3/angles.py"])],
    "libraries": [
        library("docker-ros/ws/install/lib/node", needed=["librclcpp.so"], uses=["printf", "spin"]),
        library("docker-ros/ws/install/lib/ext.so", needed=["libc.so.6"], uses=["PyObject_Call", "printf"]),
    ],
    "files": ["docker-ros/ws/install/setup.bash", "docker-ros/ws/install/lib/node", "docker-ros/ws/install/lib/ext.so"],
}
OTHER_BUILD = library("opt/ros/lib/librclcpp.so", ("spin", "shutdown", "more"), ["libc.so.6"], id="1" * 40)


def changed(document: Mapping[str, Any], **more: Any) -> dict[str, Any]:
    """Facts with other values."""
    return {**document, **more}


def require(manifest: Manifest | None) -> Manifest:
    assert manifest
    return manifest


@dataclass
class App:
    """An app as BuildKit joins it. `facts` are of its layer, None for none; `labels` are beside the usual ones."""

    base: str
    facts: Mapping[str, Any] | None = field(default_factory=lambda: OWN)
    labels: Mapping[str, str] = field(default_factory=dict)
    target: str = "run"
    name: str = "robot"
    annotations: Mapping[str, str] = field(default_factory=dict)

    def put(self, registry: Registry, tag: str, platforms: Sequence[str] = BOTH[:1], index: bool = False) -> str:
        """Puts it under a tag of `me/NAME`; gives its reference."""
        where = references.parse(self.base)
        base = require(registry.manifest(where.repository, where.reference))
        by_platform = {f"linux/{entry.platform.architecture}": entry for entry in base.members if entry.platform}
        images = [self._image(registry, where.repository, base.digest, by_platform[name].digest) for name in platforms]
        if not index and len(platforms) == 1:
            registry.put_manifest(f"me/{self.name}", tag, images[0])
        else:
            entries = [
                {
                    **oci.descriptor(oci.IMAGE, manifest),
                    "platform": {"architecture": name.partition("/")[2], "os": "linux"},
                }
                for manifest, name in zip(images, platforms, strict=True)
            ]
            content = {"schemaVersion": 2, "mediaType": oci.INDEX, "manifests": entries, **self._annotated()}
            registry.put_manifest(f"me/{self.name}", tag, image.as_buildkit(content, indent=2), oci.INDEX)
        return f"{registry.host}/me/{self.name}:{tag}"

    def _annotated(self) -> dict[str, Any]:
        return {"annotations": dict(self.annotations)} if self.annotations else {}

    def _image(self, registry: Registry, repository: str, index: str, digest: str) -> bytes:
        base, target = require(registry.manifest(repository, digest)), f"me/{self.name}"
        assert base.config
        of_base = registry.json_blob(repository, base.config.digest)
        layer = archive(["docker-ros/ws/install/lib/node"], self.name)
        for blob in base.content["layers"]:
            registry.put_blob(target, registry.blob(repository, blob["digest"]))
        registry.put_blob(target, layer)
        lock = Lock(base_image=Image(name=self.base, digest=index)).line()
        usual = {TITLE: self.name, BASE_NAME: self.base, BASE_DIGEST: index, REVISION: "", APP: self.target, LOCK: lock}
        values = dict(entry.partition("=")[::2] for entry in of_base["config"]["Env"])
        values |= {"WORKSPACE": "/docker-ros/ws", "DEFAULT_CMD": "a <b> & c"}
        lines = ["COPY / / # buildkit", "ARG APP_WORKSPACE=/docker-ros/ws", "ENV WORKSPACE=/docker-ros/ws"]
        lines += ["ARG APP_DEFAULT_CMD=a <b> & c", "ENV DEFAULT_CMD=a <b> & c", 'CMD ["bash"]']
        history = [{"created": WHEN, "created_by": line, "comment": "buildkit.dockerfile.v0",
                    **({} if line.startswith("COPY") else {"empty_layer": True})} for line in lines]  # fmt: skip
        diff_ids = [*of_base["rootfs"]["diff_ids"], oci.digest_of(gzip.decompress(layer))]
        config = image.as_buildkit(
            {
                "architecture": of_base["architecture"],
                "config": {
                    "Env": [f"{name}={value}" for name, value in values.items()],
                    "Entrypoint": of_base["config"]["Entrypoint"],
                    "Cmd": ["bash", "-c", 'exec bash -c "$DEFAULT_CMD"'],
                    "Labels": dict(sorted({**of_base["config"]["Labels"], **usual, **self.labels}.items())),
                    "ArgsEscaped": True,
                },
                "created": WHEN,
                "history": [*of_base["history"], *history],
                "os": "linux",
                "rootfs": {"type": "layers", "diff_ids": diff_ids},
            }
        )
        registry.put_blob(target, config)
        # A descriptor has BuildKit's order.
        layers = [{name: blob[name] for name in ("mediaType", "digest", "size")} for blob in base.content["layers"]]
        content = {
            "schemaVersion": 2,
            "mediaType": oci.IMAGE,
            "config": oci.descriptor(oci.CONFIG, config),
            "layers": [*layers, oci.descriptor("application/vnd.oci.image.layer.v1.tar+gzip", layer)],
            **self._annotated(),
        }
        manifest = image.as_buildkit(content, indent=2)
        registry.put_manifest(target, "", manifest)
        if self.facts is not None:
            attach(registry, target, oci.descriptor(oci.IMAGE, manifest), self.facts)
        return manifest


def attach(registry: Registry, repository: str, subject: Mapping[str, Any], document: Mapping[str, Any]) -> None:
    data = gzip.compress(json.dumps(document).encode(), mtime=0)
    registry.attach(repository, subject, facts.ARTIFACT, data, facts.MEDIA_TYPE)


class Place:
    """A registry, and who moves apps in it."""

    def __init__(self, server: LocalRegistry, folder: Path) -> None:
        self.server, self.messages = server, list[str]()
        self.registry = Registry(server.address)
        self.services = replace(Services.load(folder, required=False), registry=server.address)

    def manifest(self, repository: str, reference: str) -> Manifest:
        return require(self.registry.manifest(repository, reference))

    def base(
        self,
        tag: str = "core",
        base_facts: Mapping[str, Any] | None = BASE_FACTS,
        platforms: Sequence[str] = BOTH,
        labels: Mapping[str, str] | None = None,
        repository: str = "rosml/ros",
        **more: Any,
    ) -> str:
        """Puts a base image with facts, or without if they are None."""
        base = ros(salt=tag, **more)
        reference = replace(base, labels={**base.labels, **(labels or {})}).put(
            self.registry, repository, tag, platforms
        )
        if base_facts is not None:
            self.attach_facts(repository, tag, base_facts)
        return reference

    def attach_facts(self, repository: str, tag: str, document: Mapping[str, Any]) -> None:
        for entry in self.manifest(repository, tag).members:
            subject = {"mediaType": entry.mediaType, "digest": entry.digest, "size": entry.size}
            attach(self.registry, repository, subject, document)

    def app(self, base: str, tag: str = "latest", **more: Any) -> str:
        platforms = more.pop("platforms", BOTH[:1])
        return App(base, **more).put(self.registry, tag, platforms)

    def index(self, tag: str, *images: tuple[str, str]) -> str:
        """Puts an index over images of `me/robot`, by tag or digest and architecture."""
        entries = [
            {
                **self.manifest("me/robot", reference).descriptor,
                "platform": {"os": "linux", "architecture": architecture},
            }
            for reference, architecture in images
        ]
        content = {"schemaVersion": 2, "mediaType": oci.INDEX, "manifests": entries}
        self.registry.put_manifest("me/robot", tag, content, oci.INDEX)
        return f"{self.server.address}/me/robot:{tag}"

    def rebaser(self) -> Rebaser:
        return Rebaser(self.services, Registries(), self.messages.append)

    def plan(
        self, app: str, base: str, tag: str = "", platforms: Sequence[str] = (), registry: Registry | None = None
    ) -> tuple[Rebaser, Plan]:
        clients: Callable[[str], Registry] = (lambda _: registry) if registry else Registries()
        rebaser = Rebaser(self.services, clients, self.messages.append)
        return rebaser, rebaser.plan(app, base, tag, platforms)

    def rebase(self, app: str, base: str, tag: str = "", platforms: Sequence[str] = (), **more: Any) -> Rebased:
        rebaser, plan = self.plan(app, base, tag, platforms)
        with rebaser:
            return rebaser.move(plan, rebaser.push(plan, **more))

    def refused(self, *arguments: Any, code: int = 2) -> str:
        """The message with which a move is refused; no manifest was written."""
        before = self.content()
        with pytest.raises(RosmlError) as caught:
            self.rebase(*arguments)
        assert caught.value.exit_code == code and caught.value.remedy
        assert self.content() == before, "nothing was written"
        return caught.value.message

    def content(self) -> tuple[set[tuple[str, str]], dict[str, dict[str, str]]]:
        """All manifests and tags."""
        return {*self.server.manifests}, {name: dict(tags) for name, tags in self.server.tags.items() if tags}

    def image(self, repository: str, reference: str) -> Manifest:
        """An image for one platform, or the first of an index."""
        manifest = self.manifest(repository, reference)
        return self.manifest(repository, manifest.members[0].digest) if manifest.is_index else manifest

    def layers(self, reference: str) -> list[dict[str, Any]]:
        where = references.parse(reference)
        layers: list[dict[str, Any]] = self.image(where.repository, where.reference).content["layers"]
        return layers

    def labels(self, repository: str, tag: str) -> dict[str, str]:
        config = self.image(repository, tag).config
        assert config
        return dict(self.registry.json_blob(repository, config.digest)["config"]["Labels"])

    def sbom(self, repository: str, reference: str, packages: Sequence[str], version: str = "") -> None:
        """Attaches an SBOM to an image for one platform, or to the first of an index; perhaps one of an older version of our format."""
        subject = self.image(repository, references.parse(reference).reference)
        components = [
            {"bom-ref": item, "type": "library", "name": name, "version": version, "purl": f"pkg:deb/debian/{item}"}
            for item in packages
            for name, _, version in (item.partition("@"),)
        ]
        about = {"component": {"name": f"x@{subject.digest}"}}
        data = oci.encoded({"bomFormat": "CycloneDX", "metadata": about, "components": components})
        form = dict.fromkeys(sbom.FORMAT, version) if version else sbom.FORMAT
        self.registry.attach(repository, subject.descriptor, sbom.MEDIA_TYPE, data, sbom.MEDIA_TYPE, form)

    def digest(self, reference: str) -> str:
        where = references.parse(reference)
        return self.registry.head(where.repository, where.reference)


ADDON = ("common-cpu-py311", "graph-cc-cpu", "graph-cpu-py311")
"""The tags of an add-on's parts on the stack cpu."""


def addon(place: Place, salt: str, stack: str = "cpu") -> list[str]:
    """The parts of an add-on on a stack; each has facts."""
    names, cuda = [], [] if stack.startswith("cpu") else ["cuda-cpu"]
    for kind, end in (name.split("-cpu") for name in (*cuda, *ADDON)):
        tag = f"{kind}-{stack}{end}"
        names.append(part(kind, stack, salt=salt).put(place.registry, "rosml/part", tag))
        libraries = [library("usr/lib/libgraphruntime.so.1", ("OrtGetApiBase",))] if "cc" in kind else []
        place.attach_facts("rosml/part", tag, {"packages": [], "libraries": libraries})
    return names


def app_with_addon(place: Place, base: str, parts_of_it: Sequence[str]) -> str:
    """As `containerize --addons` makes it: its base image's name is that without the add-on."""
    with Joiner(lambda _: place.registry) as joiner:
        joined = joiner.join(base, parts_of_it, f"{place.server.address}/me/joined:x", BOTH[:1]).reference
    uses = library("docker-ros/ws/install/lib/node", needed=["libgraphruntime.so.1"], uses=["OrtGetApiBase"])
    app_facts = changed(OWN, libraries=[uses])
    return place.app(joined, facts=app_facts, labels={BASE_NAME: base, BASE_DIGEST: place.digest(base)})


def environment(
    place: Place, salt: str = "", takes: str = "", python: str = "3.11", repository: str = "rosml/env", **more: Any
) -> str:
    """Puts the environment `policy` with facts. Gives its reference."""
    tag = f"policy-py{python.replace('.', '')}"
    image = parts.environment(takes=takes, python=python, salt=salt, **more)
    reference = image.put(place.registry, repository, tag, BOTH)
    place.attach_facts(repository, tag, {"packages": [], "libraries": []})
    return reference


def app_with_environment(place: Place, base: str, policy: str) -> str:
    """As `containerize --env` makes it: its lock has the environment's digest."""
    with Joiner(lambda _: place.registry) as joiner:
        joined = joiner.join(base, [policy], f"{place.server.address}/me/joined:x", BOTH[:1]).reference
    digest = place.digest(base)
    lock = Lock(base_image=Image(name=base, digest=digest), addons={policy: place.digest(policy)}).line()
    return place.app(joined, labels={BASE_NAME: base, BASE_DIGEST: digest, LOCK: lock})


def on_stack(place: Place, stack: str, base_facts: Mapping[str, Any] = BASE_FACTS, driver: str = "") -> str:
    """Puts a base image with a framework."""
    labels = {"io.rosml.stack": stack, "io.rosml.framework": "torch"}
    labels |= {"io.rosml.gpu.driver": driver} if driver else {}
    return place.base(f"ros1-bookworm-core-{stack}", base_facts, BOTH[:1], labels, "rosml/ros-torch")


@pytest.fixture
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Place]:
    with moving(tmp_path, monkeypatch) as place:
        yield place


@contextmanager
def moving(folder: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Place]:
    """A place for a test."""
    monkeypatch.setattr(retries, "WAIT", 0.001)
    monkeypatch.setattr(retries, "LONGEST_WAIT", 0.01)
    monkeypatch.setenv("DOCKER_CONFIG", str(folder / "docker"))
    with local_registry() as server:
        place = Place(server, folder)
        yield place
        place.registry.close()
