"""A registry in memory with the interface of `Registry`, and a publishing run whose maker makes images of a few bytes each."""

from __future__ import annotations

import hashlib
import json
import threading
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import httpx
import pytest

from rosml.base import web
from rosml.base.errors import RosmlError
from rosml.images.builds import package_state
from rosml.images.builds.maker import BuildRequest, Maker, NewImage, Verdict
from rosml.images.image_set.labels import title
from rosml.images.image_set.model import Image, ImageSet, Part
from rosml.images.publish import provenance, run, undo
from rosml.images.publish.cosign import SignerFailed
from rosml.images.publish.run import Outcome
from rosml.images.publish.state import Request, State
from rosml.images.publish.steps import STEPS
from rosml.images.publish.survey import survey
from rosml.images.records import store, tag_moves
from rosml.images.scan import cyclonedx, packages, sbom
from rosml.machine.services import Services
from rosml.registry import oci, retries
from rosml.registry.client import BLOB_BYTES, Registry
from rosml.registry.oci import Manifest
from rosml.registry.place import Place

HOST = "registry.example"
PREFIX = "rosml"
DAY = "2026-11-22T03:00:00Z"
NEXT = "2026-11-23T03:00:00Z"
LATER = "2026-11-24T03:00:00Z"
IMAGE = "application/vnd.oci.image.manifest.v1+json"
INDEX = "application/vnd.oci.image.index.v1+json"
LAYER = "application/vnd.oci.image.layer.v1.tar+gzip"


BASE = f"debian:alpha@sha256:{'0' * 64}"


class Killed(BaseException):
    """The process ends here, as by SIGKILL: nothing catches it."""


def digest(data: bytes) -> str:
    """As registries name content."""
    return f"sha256:{hashlib.sha256(data).hexdigest()}"


@dataclass
class MemoryRegistry(Registry):
    """Repositories by path."""

    manifests: dict[str, dict[str, Manifest]] = field(default_factory=dict)
    blobs: dict[str, dict[str, bytes]] = field(default_factory=dict)
    names: dict[str, dict[str, str]] = field(default_factory=dict)
    writes: int = 0
    reads: int = 0  # requests; those for attached artifacts count twice, as a registry without the API gets them
    uploaded: int = 0  # bytes
    die_at: int = 0  # the write, counted from 1, at which the process ends; before it takes effect, or after
    die_after: bool = False
    refuses: set[str] = field(default_factory=set)  # methods that fail
    lock: Any = field(default_factory=threading.RLock)
    host: str = HOST

    def close(self) -> None:
        """It has no connections."""

    def copy(self) -> MemoryRegistry:
        """A registry with the same content; what is written into one is not in the other."""
        manifests = {repository: dict(content) for repository, content in self.manifests.items()}
        blobs = {repository: dict(content) for repository, content in self.blobs.items()}
        names = {repository: dict(content) for repository, content in self.names.items()}
        return MemoryRegistry(manifests, blobs, names, self.writes, self.reads, self.uploaded)

    @contextmanager
    def writing(self, what: str) -> Iterator[None]:
        with self.lock:
            if what in self.refuses:
                raise RosmlError(f"the registry refuses to {what}", "ask who runs it")
            self.writes += 1
            dying = self.writes == self.die_at
            if dying and not self.die_after:
                raise Killed
            yield
            if dying:
                raise Killed

    def _read(self, requests: int = 1) -> None:
        with self.lock:
            self.reads += requests

    def manifest(self, repository: str, reference: str) -> Manifest | None:
        self._read()
        name = self.names.get(repository, {}).get(reference, reference)
        return self.manifests.get(repository, {}).get(name)

    def _put(
        self, repository: str, reference: str, content: bytes | Mapping[str, Any], media_type: str
    ) -> tuple[str, httpx.Headers]:
        data = content if isinstance(content, bytes) else oci.encoded(content)
        if b'"subject"' in data and "attach" in self.refuses:
            raise RosmlError("the registry refuses to attach", "ask who runs it")
        with self.writing("put a manifest"):
            name = digest(data)
            self.uploaded += len(data)
            self.manifests.setdefault(repository, {})[name] = Manifest(json.loads(data), name, media_type, len(data))
            if reference and not reference.startswith("sha256:"):
                self.names.setdefault(repository, {})[reference] = name
            subject = json.loads(data).get("subject")
            return name, httpx.Headers({"OCI-Subject": subject["digest"]} if subject else {})

    def head(self, repository: str, reference: str) -> str:
        manifest = self.manifest(repository, reference)
        return manifest.digest if manifest else ""

    def blob(self, repository: str, digest: str, limit: int = BLOB_BYTES) -> bytes:
        self._read()
        if digest not in self.blobs.get(repository, {}):
            raise RosmlError(f"{repository}: there is no blob {digest}", "check the reference that leads there")
        return self.blobs[repository][digest]

    def put_blob(self, repository: str, data: bytes) -> str:
        with self.lock:
            if digest(data) in self.blobs.get(repository, {}):
                return digest(data)
            with self.writing("put a blob"):
                self.blobs.setdefault(repository, {})[digest(data)] = data
                self.uploaded += len(data)
                return digest(data)

    def tag(self, repository: str, digest: str, name: str) -> None:
        if digest not in self.manifests.get(repository, {}):
            raise RosmlError(f"{repository}@{digest} is not there, so no tag can point at it")
        with self.writing("move a tag"):
            self.names.setdefault(repository, {})[name] = digest

    def may_push(self, _repository: str) -> None:
        if "push" in self.refuses:
            raise RosmlError("the registry lets nobody push", "docker login")

    def tags(self, repository: str) -> list[str]:
        self._read()
        return sorted(self.names.get(repository, {}))

    def delete(self, repository: str, reference: str) -> None:
        manifests, names = self.manifests.get(repository, {}), self.names.get(repository, {})
        if reference not in manifests and reference not in names:
            return
        with self.writing("delete a manifest" if reference in manifests else "delete a tag"):
            manifests.pop(reference, None)
            for name in [name for name, target in names.items() if reference in (name, target)]:
                del names[name]

    def discard(self, repository: str, name: str) -> None:
        with suppress(RosmlError):
            if name in self.manifests.get(repository, {}):
                self.delete(repository, name)

    def referrers(self, repository: str, subject: str, artifact_type: str = "") -> list[dict[str, Any]]:
        self._read(2)
        keys = ("artifactType", "annotations")
        return [
            {**manifest.descriptor, **{key: manifest.content[key] for key in keys if key in manifest.content}}
            for name, manifest in list(self.manifests.get(repository, {}).items())
            if (manifest.content.get("subject") or {}).get("digest") == subject
            and artifact_type in ("", manifest.content["artifactType"])
        ]

    def forget(self, repository: str, subject: str) -> None:
        assert subject not in self.manifests[repository]


def sbom_of(reference: str, names: Iterable[str], system: str = "") -> bytes:
    """The SBOM of an image of Debian, or of a part without a system."""
    return cyclonedx.document(packages_of(names, system), reference)


def packages_of(names: Iterable[str], system: str = "") -> packages.Packages:
    apt = [
        packages.Apt(name=name, version="1.0", architecture="amd64", source=name, source_version="1.0")
        for name in names
        if system
    ]
    wheels = [packages.Python(name=name, version="1.0") for name in names if not system]
    of = packages.System(name="debian" if system else "", version=system)
    return packages.Packages(system=of, apt=apt, python=wheels, ros=[])


@dataclass
class Bytes(Maker):
    """Makes images and parts of a few bytes each.

    Attributes:
        actions: what was built, joined and tested, in order: (step, target, architecture).
        poisoned: targets whose tests fail; those of the file `failing`. broken: targets whose build fails. packages: what is in the ROS images.
        odd: labels that an image has on an architecture. tests: what each image was tested with.
    """

    state: State
    registry: Any
    actions: list[tuple[str, str, str]] = field(default_factory=list)
    poisoned: set[str] = field(default_factory=set)
    failing: str = "contract"
    broken: set[str] = field(default_factory=set)
    packages: str = "1"
    odd: dict[tuple[str, str], dict[str, str]] = field(default_factory=dict)
    tests: dict[str, tuple[str, ...]] = field(default_factory=dict)

    def build_part(self, part: Part, architecture: str) -> NewImage:
        self._require_whole(part.target)
        inputs = self.state.inputs.digest(part.target, architecture)
        digest = self._put("build", part, architecture, [f"{part.target} {inputs}".encode()])
        return NewImage(digest, base=BASE, sbom=self._sbom(part, digest))

    def build_image(self, image: Image, architecture: str, parts: Mapping[str, str], packages: str) -> NewImage:
        self._require_whole(image.target)
        layer = f"{image.target} {self.packages} {architecture}".encode()
        digest = self._put("build", image, architecture, [*self._layers(parts, architecture), layer])
        return NewImage(digest, parts, packages, "" if parts else BASE, self._sbom(image, digest))

    def build_together(self, builds: Sequence[BuildRequest]) -> None:
        """Each is built when its turn comes."""

    def describe(self, thing: Image | Part, digest: str) -> str:
        self.actions.append(("describe", thing.target, ""))
        return self._sbom(thing, digest)

    def join(self, image: Image, architecture: str, parts: Mapping[str, str]) -> str:
        return self._put("join", image, architecture, self._layers(parts, architecture))

    def test(
        self, image: Image, architecture: str, digest: str, parts: Mapping[str, str], names: tuple[str, ...]
    ) -> Verdict:
        self.tests[image.target] = names
        self.actions.append(("test", image.target, architecture))
        failures = (f"{self.failing}: it is poisoned",) if image.target in self.poisoned else ()
        log = "".join(f"    {failure}\n      Expected 0, got 1" for failure in failures)
        return Verdict(5, failures, versions={"torch": "2.10.0"}, output=log)

    def _require_whole(self, target: str) -> None:
        if target in self.broken:
            raise RosmlError(f"building {target} failed", "mend it")

    def _put(self, step: str, thing: Image | Part, architecture: str, layers: Sequence[bytes]) -> str:
        self.actions.append((step, thing.target, architecture))
        sent = self.registry.uploaded
        labels = {"org.opencontainers.image.title": title(thing), **self.odd.get((thing.target, architecture), {})}
        name = put_image(self.registry, f"{PREFIX}/{thing.repository}", architecture, labels, layers)
        if step == "build":  # buildx sends it, and not the run's client
            getattr(self.registry, "transport", self.registry).uploaded = sent
        return name

    def _sbom(self, thing: Image | Part, digest: str) -> str:
        """A package of Debian is in each ROS image, and a wheel of its name in each part."""
        sent, path = self.registry.uploaded, f"{PREFIX}/{thing.repository}"
        names, system = ([thing.kind], "") if isinstance(thing, Part) else (["bash"], "12.15")
        document = sbom_of(f"{HOST}/{path}@{digest}", names, system)
        descriptor = self.registry.manifest(path, digest).descriptor
        artifact: str = self.registry.attach(path, descriptor, sbom.MEDIA_TYPE, document, sbom.MEDIA_TYPE, sbom.FORMAT)
        getattr(self.registry, "transport", self.registry).uploaded = sent
        return artifact

    def _layers(self, parts: Mapping[str, str], architecture: str) -> list[bytes]:
        layers = []
        for target, name in parts.items():
            repository = f"{PREFIX}/{self.state.by_key[target, architecture].repository}"
            content = self.registry.manifest(repository, name).content
            layers += [self.registry.blob(repository, layer["digest"]) for layer in content["layers"]]
        return layers


def put_image(
    registry: Any, repository: str, architecture: str, labels: Mapping[str, str], layers: Sequence[bytes]
) -> str:
    """Puts an image of some layers into a registry; gives the digest of its manifest."""
    config = json.dumps({"architecture": architecture, "config": {"Labels": labels}}).encode()
    for data in (config, *layers):
        registry.put_blob(repository, data)
    entries = [oci.descriptor(LAYER, data) for data in layers]
    content = {"schemaVersion": 2, "layers": entries, "config": oci.descriptor(oci.CONFIG, config)}
    return str(registry.put_manifest(repository, "", content, IMAGE))


class Run(run.Run):
    """A run whose images are a few bytes each."""

    @property
    def actions(self) -> list[tuple[str, str, str]]:
        assert isinstance(self.maker, Bytes)
        return self.maker.actions


@dataclass
class Pen:
    """Signs as `Signer` does; `broken` says why it fails. A signature counts as a write of the registry."""

    registry: MemoryRegistry
    identity: str = "sha256:pen"
    signed: set[str] = field(default_factory=set)
    calls: int = 0
    broken: str = ""

    def ensure(self, reference: str) -> bool:
        self.calls += 1
        if self.broken:
            raise SignerFailed(self.broken, "mend it")
        if reference in self.signed:
            return False
        with self.registry.writing("sign"):
            self.signed.add(reference)
        return True


@dataclass
class Publisher:
    """A registry, and runs that publish into it; with a pen, they sign."""

    services: Services
    registry: MemoryRegistry = field(default_factory=MemoryRegistry)
    packages: dict[str, str] = field(default_factory=lambda: {"alpha": "monday", "omega": "monday"})
    pen: Any = None
    absent: set[tuple[str, str, str]] = field(default_factory=set)
    """Packages that a distribution's repository does not have for an architecture."""

    @property
    def place(self) -> Place:
        return Place(self.registry, PREFIX)

    def run(self, image_set: ImageSet, date: str = DAY, serving: tuple[str, ...] = (), **options: Any) -> Run:
        """A run for both architectures, unless told otherwise; nothing is done yet."""
        faults = ("poisoned", "failing", "broken", "packages", "odd")
        of_maker = {name: options.pop(name) for name in faults if name in options}
        architectures = options.pop("architectures", ("amd64", "arm64"))
        only = tuple(options.pop("only", ()))
        places = tuple(architectures), tuple(serving)
        state = survey(Request(self.services, image_set, self.place, date, only, *places, **options))
        return Run(state, Bytes(state, self.registry, **of_maker), lambda line: None, signer=self.pen)

    def publish(self, image_set: ImageSet, **options: Any) -> Run:
        """A run with all its steps."""
        run = self.run(image_set, **options)
        for step in STEPS:
            STEPS[step](run)
        return run

    def change(self, file: str = "components/ros/install.sh") -> None:
        """Changes a file of the checkout, so that some images have other inputs."""
        path = self.services.root / file
        path.write_text(path.read_text() + "# a change\n")

    def undo(self, run: str = "", date: str = LATER) -> list[Outcome]:
        """Moves tags back to where they were before a run, the last one if empty."""
        records = store.Records(self.place)
        return undo.undo(records, date, undo.find(records, run))

    def tagged(self, repository: str) -> dict[str, str]:
        """Tags of a repository and where they point."""
        return dict(self.registry.names.get(f"{PREFIX}/{repository}", {}))

    def check(self, image_set: ImageSet, poisoned: Sequence[str] = ()) -> None:
        """What must hold at any time: tags point at whole, tested images, and nothing that is there is in pieces."""
        entries = {}
        for name in self.registry.tags(f"{PREFIX}/{store.REPOSITORY}"):
            if not name.startswith(tag_moves.UNDO):
                target, _, architecture = name.rpartition(".")
                entries[target, architecture] = store.Records(self.place).read(target, architecture)
        passed = {entry.digest for entry in entries.values() if entry and entry.passed and not entry.failures}
        passed |= {digest for entry in entries.values() if entry and not entry.failures for digest in entry.superseded}
        for repository in {image.repository for image in image_set.images}:
            path = f"{PREFIX}/{repository}"
            for tag, target in self.tagged(repository).items():
                index = self.registry.manifest(path, target)
                assert index is not None and index.media_type == INDEX, f"{tag} points at nothing whole"
                assert not self.pen or f"{HOST}/{path}@{target}" in self.pen.signed, f"{tag} is not signed"
                image = next(
                    i for i in image_set.images if any(tag.startswith(t.split(":")[1]) for t in reversed(i.tags))
                )
                members = {item["platform"]["architecture"]: item["digest"] for item in index.content["manifests"]}
                assert members, f"{tag} ({image.target}) has no architecture"
                for name in members.values():
                    assert self.registry.referrers(path, name, store.ARTIFACT), f"{tag}: no entry is attached"
                    assert self.registry.referrers(path, name, provenance.MEDIA_TYPE), f"{tag}: nobody knows whence"
                for member in members.values():
                    assert member in passed, f"{repository}:{tag} points at an untested image"
                    manifest = self.registry.manifest(path, member)
                    assert manifest is not None
                    for layer in manifest.content["layers"]:
                        assert self.registry.blob(path, layer["digest"])


def steps(run: Run, step: str) -> set[tuple[str, str]]:
    """Targets and architectures with which a run did a step."""
    return {(target, architecture) for name, target, architecture in run.actions if name == step}


def waiting(run: Run, target: str) -> list[str]:
    """What keeps a target waiting."""
    return [outcome.reason for outcome in run.outcomes if outcome.target == target and outcome.state == "waits"]


def publisher(folder: Path, services: Services, monkeypatch: pytest.MonkeyPatch) -> Publisher:
    """A place whose repositories of packages are in memory as well. No hosts are waited for."""
    place = Publisher(services)

    def state(_services: object, _matrix: object, distribution: str) -> str:
        answer = place.packages[distribution]
        if answer == "down":
            raise RosmlError("http://packages.example does not answer", "check the network")
        return answer

    def lacking(_services: object, _matrix: object, row: str, architecture: str, packages: list[str]) -> list[str]:
        return [name for name in packages if (row, architecture, name) in place.absent]

    monkeypatch.setattr(package_state, "state", state)
    monkeypatch.setattr(package_state, "lacking", lacking)
    for module in (retries, web):
        monkeypatch.setattr(module, "WAIT", 0.001)
    return place
