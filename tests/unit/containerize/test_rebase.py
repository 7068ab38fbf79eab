"""Apps on other base images, of a few bytes each, in a registry in this process. Real ones: tests/e2e/test_rebase.py."""

from __future__ import annotations

import gzip
import json
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import pytest
from registry_stand_in import StandIn, standing_in

from rosml.base.errors import RosmlError
from rosml.containerize.app_bake_file import BASE_DIGEST, BASE_NAME, LOCK, REPLACED
from rosml.containerize.lock import Image, Lock
from rosml.containerize.rebase import image
from rosml.containerize.rebase.rebaser import Plan, Rebased, Rebaser
from rosml.images.image_set.labels import APP, REVISION, TITLE
from rosml.images.join import facts, file_lists
from rosml.images.scan import sbom
from rosml.machine.services import Services
from rosml.registry import failures, oci, references
from rosml.registry.client import Registries, Registry
from tests.e2e.parts import archive, ros

BOTH = ("linux/amd64", "linux/arm64")
WHEN = "2026-11-20T10:00:00Z"
X86 = [2, 1, 62]


def library(path: str, symbols: Sequence[str] = (), needed: Sequence[str] = (), **more: Any) -> dict[str, Any]:
    """A library or program as facts have it."""
    groups = sorted({facts.hashed(name) for name in symbols})
    own = {"soname": path.rpartition("/")[2] if ".so" in path else "", "id": "0" * 40, "names": [], "machine": X86}
    return {"path": path, **own, "needed": list(needed), "symbols": "".join(groups), "uses": [], **more}


def package(name: str, version: str = "1.0", **more: Any) -> dict[str, Any]:
    said = {"architecture": "amd64", "provides": "", "depends": "", "conflicts": ""}
    return {"name": name, "version": version, **said, **more}


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


@dataclass
class App:
    """An app as BuildKit joins it.

    Attributes:
        base: its base image. facts: of its layer; None for none. labels, environment: beside the usual ones.
        history: the instructions after the layer.
    """

    base: str
    facts: Mapping[str, Any] | None = field(default_factory=lambda: OWN)
    labels: Mapping[str, str] = field(default_factory=dict)
    target: str = "run"
    name: str = "robot"

    def put(self, registry: Registry, tag: str, platforms: Sequence[str] = BOTH[:1], index: bool = False) -> str:
        """Puts it under a tag of `me/robot`; gives its reference."""
        where = references.parse(self.base)
        found = registry.manifest(where.repository, where.reference)
        assert found
        by_platform = {f"linux/{entry.platform.architecture}": entry for entry in found.members if entry.platform}
        made = [self._image(registry, where.repository, found.digest, by_platform[name].digest) for name in platforms]
        if not index and len(platforms) == 1:
            registry.put_manifest(f"me/{self.name}", tag, made[0])
        else:
            places = [{"architecture": name.partition("/")[2], "os": "linux"} for name in platforms]
            entries = [
                {**oci.descriptor(oci.IMAGE, manifest), "platform": place}
                for manifest, place in zip(made, places, strict=True)
            ]
            content = {"schemaVersion": 2, "mediaType": oci.INDEX, "manifests": entries}
            registry.put_manifest(f"me/{self.name}", tag, image.as_buildkit(content, indent=2), oci.INDEX)
        return f"{registry.host}/me/{self.name}:{tag}"

    def _image(self, registry: Registry, repository: str, index: str, digest: str) -> bytes:
        base = registry.manifest(repository, digest)
        assert base and base.config
        known = registry.json_blob(repository, base.config.digest)
        layer = archive(["docker-ros/ws/install/lib/node"], self.name)
        for blob in base.content["layers"]:
            registry.put_blob(f"me/{self.name}", registry.blob(repository, blob["digest"]))
        registry.put_blob(f"me/{self.name}", layer)
        lock = Lock(base_image=Image(name=self.base, digest=index)).line()
        own = {TITLE: self.name, BASE_NAME: self.base, BASE_DIGEST: index, REVISION: "", APP: self.target, LOCK: lock}
        said = {**known["config"]["Labels"], **own, **self.labels}
        values = dict(entry.partition("=")[::2] for entry in known["config"]["Env"])
        values |= {"WORKSPACE": "/docker-ros/ws", "DEFAULT_CMD": "a <b> & c"}
        lines = ["COPY / / # buildkit", "ARG APP_WORKSPACE=/docker-ros/ws", "ENV WORKSPACE=/docker-ros/ws"]
        lines += ["ARG APP_DEFAULT_CMD=a <b> & c", "ENV DEFAULT_CMD=a <b> & c", 'CMD ["bash"]']
        history = [{"created": WHEN, "created_by": line, "comment": "buildkit.dockerfile.v0",
                    **({} if line.startswith("COPY") else {"empty_layer": True})} for line in lines]  # fmt: skip
        config = {
            "architecture": known["architecture"],
            "config": {
                "Env": [f"{name}={value}" for name, value in values.items()],
                "Entrypoint": known["config"]["Entrypoint"],
                "Cmd": ["bash", "-c", 'exec bash -c "$DEFAULT_CMD"'],
                "Labels": dict(sorted(said.items())),
                "ArgsEscaped": True,
            },
            "created": WHEN,
            "history": [*known["history"], *history],
            "os": "linux",
            "rootfs": {
                "type": "layers",
                "diff_ids": [*known["rootfs"]["diff_ids"], oci.digest_of(gzip.decompress(layer))],
            },
        }
        text = image.as_buildkit(config)
        registry.put_blob(f"me/{self.name}", text)
        content = {
            "schemaVersion": 2,
            "mediaType": oci.IMAGE,
            "config": oci.descriptor(oci.CONFIG, text),
            "layers": [
                *map(_ordered, base.content["layers"]),
                oci.descriptor("application/vnd.oci.image.layer.v1.tar+gzip", layer),
            ],
        }
        manifest = image.as_buildkit(content, indent=2)
        registry.put_manifest(f"me/{self.name}", "", manifest)
        if self.facts is not None:
            attach(registry, f"me/{self.name}", oci.descriptor(oci.IMAGE, manifest), self.facts)
        return manifest


def _ordered(layer: Mapping[str, Any]) -> dict[str, Any]:
    """A descriptor in BuildKit's order."""
    return {name: layer[name] for name in ("mediaType", "digest", "size")}


def attach(registry: Registry, repository: str, subject: Mapping[str, Any], said: Mapping[str, Any]) -> None:
    data = gzip.compress(json.dumps(said).encode(), mtime=0)
    registry.attach(repository, subject, facts.ARTIFACT, data, facts.MEDIA_TYPE)


class Place:
    """A registry, and who moves apps in it."""

    def __init__(self, server: StandIn, folder: Path) -> None:
        self.server, self.said = server, list[str]()
        self.registry = Registry(server.address)
        self.services = replace(Services.load(folder, required=False), registry=server.address)

    def base(
        self,
        tag: str = "core",
        said: Mapping[str, Any] | None = BASE_FACTS,
        platforms: Sequence[str] = BOTH,
        **more: Any,
    ) -> str:
        made = ros(salt=tag, **more)
        reference = made.put(self.registry, "rosml/ros", tag, platforms)
        found = self.registry.manifest("rosml/ros", tag)
        assert found
        for entry in found.members if said is not None else ():
            subject = {"mediaType": entry.mediaType, "digest": entry.digest, "size": entry.size}
            attach(self.registry, "rosml/ros", subject, said or {})
        return reference

    def app(self, base: str, tag: str = "latest", **more: Any) -> str:
        platforms = more.pop("platforms", BOTH[:1])
        return App(base, **more).put(self.registry, tag, platforms)

    def plan(
        self, app: str, base: str, tag: str = "", platforms: Sequence[str] = (), registry: Registry | None = None
    ) -> tuple[Rebaser, Plan]:
        clients: Callable[[str], Registry] = (lambda _: registry) if registry else Registries()
        rebaser = Rebaser(self.services, clients, self.said.append)
        return rebaser, rebaser.plan(app, base, tag, platforms)

    def rebase(self, app: str, base: str, tag: str = "", platforms: Sequence[str] = (), **more: Any) -> Rebased:
        rebaser, plan = self.plan(app, base, tag, platforms)
        with rebaser:
            found = rebaser.push(plan, **more)
            rebaser.move(plan, found)
        return found

    def refused(self, *arguments: Any, code: int = 2) -> str:
        """The message with which a move is refused; no manifest was written."""
        before = self._content()
        with pytest.raises(RosmlError) as caught:
            self.rebase(*arguments)
        assert caught.value.exit_code == code and caught.value.remedy
        assert self._content() == before, "nothing was written"
        return caught.value.message

    def _content(self) -> tuple[set[tuple[str, str]], dict[str, dict[str, str]]]:
        return {*self.server.manifests}, {name: dict(tags) for name, tags in self.server.tags.items() if tags}

    def layers(self, reference: str) -> list[dict[str, Any]]:
        where = references.parse(reference)
        found = self.registry.manifest(where.repository, where.reference)
        if found and found.is_index:
            found = self.registry.manifest(where.repository, found.members[0].digest)
        assert found
        layers: list[dict[str, Any]] = found.content["layers"]
        return layers

    def sbom(self, repository: str, reference: str, packages: Sequence[str]) -> None:
        """Attaches an SBOM to an image for one platform, or to the first of an index."""
        found = self.registry.manifest(repository, references.parse(reference).reference)
        assert found
        if found.is_index:
            found = self.registry.manifest(repository, found.members[0].digest)
            assert found
        components = [
            {"bom-ref": item, "type": "library", "name": name, "version": version, "purl": f"pkg:deb/debian/{item}"}
            for item in packages
            for name, _, version in (item.partition("@"),)
        ]
        about = {"component": {"name": f"x@{found.digest}"}}
        data = oci.encoded({"bomFormat": "CycloneDX", "metadata": about, "components": components})
        self.registry.attach(repository, found.descriptor, sbom.MEDIA_TYPE, data, sbom.MEDIA_TYPE, sbom.FORMAT)

    def digest(self, reference: str) -> str:
        where = references.parse(reference)
        return self.registry.head(where.repository, where.reference)


@pytest.fixture
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Place]:
    monkeypatch.setattr(failures, "WAIT", 0.001)
    monkeypatch.setattr(failures, "LONGEST_WAIT", 0.01)
    monkeypatch.setenv("DOCKER_CONFIG", str(tmp_path / "docker"))
    with standing_in() as server:
        found = Place(server, tmp_path)
        yield found
        found.registry.close()


# ---- What comes of it ------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("platforms", [BOTH[:1], BOTH])
def test_it_is_what_a_build_gives(place: Place, platforms: Sequence[str]) -> None:
    old, new = place.base(), place.base("newer", environment=("ROS_SYNC_DATE=2026-11-26", "WORKSPACE=/other"))
    app = place.app(old, platforms=platforms)
    built = place.digest(App(new).put(place.registry, "built", platforms))
    found = place.rebase(app, new, f"{place.server.address}/me/robot:moved")
    assert found.digest == built == place.digest(found.reference)
    assert (found.verdict, found.reasons, found.moved) == ("safe", [], True)
    assert place.rebase(app, new, found.reference).moved is False, "again"
    back = place.rebase(found.reference, old)
    assert back.digest == place.digest(app) and back.before == built, "and back, with its own tag"


def test_no_layer_is_pulled_and_little_is_sent(place: Place) -> None:
    old, new = place.base(), place.base("newer")
    app = place.app(old)
    start, before = len(place.server.requests), place.registry.uploaded
    found = place.rebase(app, new, with_sbom=False)
    requests, headers = place.server.requests[start:], place.server.headers[start:]
    layers = {layer["digest"] for name in (old, new, app) for layer in place.layers(name)}
    pulled = [line for line in requests if line.startswith("GET") and line.rpartition("/")[2] in layers]
    assert not pulled and place.registry.uploaded == before
    assert sum(int(item.get("content-length", 0)) for item in headers) == found.uploaded < 10_000
    assert (found.mounted, found.present, found.copied) == (1, 1, 0)
    assert len(requests) <= 60, "in a registry without the API of referrers, which takes 14 more"


def test_a_registry_that_mounts_nothing(place: Place) -> None:
    old, new = place.base(), place.base("newer")
    app = place.app(old)
    place.server.mounts = False
    found = place.rebase(app, new, with_sbom=False)
    assert found.copied == 1 and found.digest == place.digest(App(new).put(place.registry, "built"))


def test_what_is_attached_is_of_the_new_image(place: Place) -> None:
    old, new = place.base(), place.base("newer", files=("usr/bin/env", "bin", "usr/bin/new"))
    app = place.app(old)
    place.sbom("me/robot", app, ["python3@3.11.2-1", "old@1", "python3-angles@1.16"])
    place.sbom("rosml/ros", new, ["python3@3.11.2-2", "fresh@2"])
    found = place.rebase(app, new)
    [name] = found.manifests.values()
    listed = file_lists.Lists().of(place.registry, "me/robot", name)
    assert listed and listed.entries == {
        *OWN["files"],
        "usr/lib/python3/angles.py",
        "usr/bin/env",
        "bin",
        "usr/bin/new",
    }
    assert facts.of(place.registry, "me/robot", name) == facts.Facts.model_validate(OWN)
    [entry] = place.registry.referrers("me/robot", name, sbom.MEDIA_TYPE)
    artifact = place.registry.manifest("me/robot", entry["digest"])
    assert artifact
    document = place.registry.json_blob("me/robot", artifact.layers[0].digest)
    assert document["metadata"]["component"]["name"].endswith(name)
    assert [item["name"] for item in document["components"]] == ["python3", "fresh", "python3-angles"]
    last = place.rebase(found.reference, place.base("last"))
    assert last.moved, "the result can move again"


def test_an_app_on_an_app(place: Place) -> None:
    old, new = place.base(), place.base("newer")
    lower = App(old, name="lower").put(place.registry, "a", index=True)
    own = {**OWN, "packages": [], "files": ["docker-ros/ws/install/lib/upper"], "libraries": []}
    upper = App(lower, own, name="upper").put(place.registry, "a")
    moved = place.rebase(lower, new, f"{place.server.address}/me/lower:b")
    found = place.rebase(upper, moved.reference)
    built = App(moved.reference, own, name="upper").put(place.registry, "built")
    assert found.digest == place.digest(built)


def test_one_platform_of_two(place: Place) -> None:
    old, new = place.base(), place.base("newer")
    app = place.app(old, platforms=BOTH)
    found = place.rebase(app, new, f"{place.server.address}/me/robot:arm", ["linux/arm64"])
    assert [*found.manifests] == ["linux/arm64"]
    assert "is for linux/amd64 and linux/arm64, not for linux/riscv64" in place.refused(app, new, "", ["linux/riscv64"])


# ---- What is refused -------------------------------------------------------------------------------------------------


def changed(said: Mapping[str, Any], **more: Any) -> dict[str, Any]:
    return {**said, **more}


WITHOUT_SPIN = library("opt/ros/lib/librclcpp.so", ("shutdown",), ["libc.so.6"], id="1" * 40)
OTHER_BUILD = library("opt/ros/lib/librclcpp.so", ("spin", "shutdown", "more"), ["libc.so.6"], id="1" * 40)


@pytest.mark.parametrize(
    ("new", "says"),
    [
        ({"distribution": "jazzy"}, "was built on ROS distribution ros1-bookworm, and"),
        ({"python": "3.12"}, "was built on Python 3.11, and"),
        ({"platforms": BOTH[1:]}, "is not for linux/amd64"),
        ({"said": None}, "has no facts about its packages, libraries and files"),
        ({"unlisted": True}, "has no facts about its packages, libraries and files"),
        (
            {"said": changed(BASE_FACTS, packages=[package("python3", "3.12.1-1")])},
            "python3-angles needs python3 (<< 3.12), and the base image has python3 3.12.1-1",
        ),
        (
            {"said": changed(BASE_FACTS, packages=[])},
            "python3-angles needs python3 (<< 3.12), and the base image has none",
        ),
        (
            {"said": changed(BASE_FACTS, packages=[package("python3", "3.11.2-1"), package("python3-angles", "1.17")])},
            "the app has python3-angles 1.16, and the base image has 1.17",
        ),
        (
            {"said": changed(BASE_FACTS, packages=[package("python3", "3.11.2-1", conflicts="python3-angles (<< 2)")])},
            "python3 of the base image cannot stand beside python3-angles (<< 2), and the app has python3-angles",
        ),
        (
            {"files": ("usr/bin/env", "docker-ros/ws/install/lib/node")},
            "the app and the base image both have /docker-ros/ws/install/lib/node",
        ),
        ({"files": ("usr/lib/python3/angles.py",)}, "the app and the base image both have /usr/lib/python3/angles.py"),
        (
            {"said": changed(BASE_FACTS, libraries=[LIBC, PYTHON])},
            "lib/node needs librclcpp.so, which the base image lacks",
        ),
        (
            {"said": changed(BASE_FACTS, libraries=[LIBC, PYTHON, WITHOUT_SPIN])},
            "lib/node uses spin, which no library of the base image has any more",
        ),
        (
            {"said": changed(BASE_FACTS, libraries=[LIBC, ROSCPP, library("usr/bin/python3.11", soname="")])},
            "lib/ext.so uses PyObject_Call, which no library of the base image has any more",
        ),
    ],
)
def test_another_base_image_is_refused(place: Place, new: dict[str, Any], says: str) -> None:
    old = place.base()
    app = place.app(old)
    assert says in place.refused(app, place.base("newer", **new))


@pytest.mark.parametrize(
    ("app", "says"),
    [
        ({"facts": None}, "has no facts about its packages and libraries"),
        ({"target": "dev"}, "is an image to work on"),
        ({"target": ""}, "is no app that rosml containerize built"),
        ({"labels": {REPLACED: "less:amd64"}}, "replaces what its base image has: less:amd64"),
        ({"labels": {LOCK: "{}"}}, "its label io.rosml.lock is damaged"),
    ],
)
def test_an_image_that_is_no_such_app_is_refused(place: Place, app: dict[str, Any], says: str) -> None:
    assert says in place.refused(place.app(place.base(), **app), place.base("newer"))


def test_what_is_no_app(place: Place) -> None:
    old, new = place.base(), place.base("newer")
    app = place.app(old)
    assert "is no app" in place.refused(old, new)
    assert "there is no app me/other:x" in place.refused("me/other:x", new)
    assert "there is no image" in place.refused(app, f"{place.server.address}/rosml/ros:none")
    by_digest = f"{app.rpartition(':')[0]}@{place.digest(app)}"
    assert "names the app by its digest" in place.refused(by_digest, new)
    assert "is a digest" in place.refused(app, new, by_digest)


def test_platforms_on_different_images(place: Place) -> None:
    one, other = place.base(), place.base("torch")
    first, second = (place.digest(place.app(name, tag)) for name, tag in ((one, "a"), (other, "b")))
    entries = []
    for digest, architecture in ((first, "amd64"), (second, "arm64")):
        found = place.registry.manifest("me/robot", digest)
        assert found
        entries.append({**found.descriptor, "platform": {"os": "linux", "architecture": architecture}})
    content = {"schemaVersion": 2, "mediaType": oci.INDEX, "manifests": entries}
    place.registry.put_manifest("me/robot", "mixed", content, oci.INDEX)
    text = place.refused(f"{place.server.address}/me/robot:mixed", place.base("newer"))
    assert "its platforms are on different images: linux/amd64 on" in text


# ---- What the facts do not decide ------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("library_now", "verdict"),
    [
        (ROSCPP, "safe"),
        (OTHER_BUILD, "check by link"),
        (library("usr/lib/libc.so.6", ("printf",), id="2" * 40), "safe"),
    ],
)
def test_a_library_changed(place: Place, library_now: dict[str, Any], verdict: str) -> None:
    others = [item for item in BASE_FACTS["libraries"] if item["path"] != library_now["path"]]
    new = place.base("newer", changed(BASE_FACTS, libraries=[*others, library_now]))
    _, plan = place.plan(place.app(place.base()), new)
    assert place.rebase(plan.named, new).verdict == verdict
    assert all("librclcpp.so changed" in reason for reason in plan.judgement.reasons)


def test_the_old_base_image_is_gone(place: Place) -> None:
    old, new = place.base(), place.base("newer")
    app = place.app(old)
    place.registry.delete("rosml/ros", place.digest(old))
    found = place.rebase(app, new)
    assert found.verdict == "check by link" and "is gone" in found.reasons[0]


def test_a_part_of_another_release(place: Place) -> None:
    torch = library("usr/local/lib/libtorch.so", ("spin",))
    said = changed(BASE_FACTS, libraries=[*BASE_FACTS["libraries"], torch])
    uses = [library("docker-ros/ws/install/lib/node", needed=["libtorch.so"], uses=["spin"])]
    old = place.base(said=said)
    app = place.app(old, facts=changed(OWN, libraries=uses), labels={"io.rosml.torch": "2.14.0"})
    labels = {"io.rosml.torch": "2.15.0"}
    made = replace(ros(salt="newer"), labels={**ros().labels, **labels})
    new = made.put(place.registry, "rosml/ros", "newer", BOTH[:1])
    found = place.registry.manifest("rosml/ros", "newer")
    assert found
    [entry] = found.members
    attach(
        place.registry, "rosml/ros", {"mediaType": entry.mediaType, "digest": entry.digest, "size": entry.size}, said
    )
    assert "the app was built with torch 2.14.0 (libtorch.so), and the base image has 2.15.0" in place.refused(app, new)


# ---- Others, and the end of the process ------------------------------------------------------------------------------


def test_a_tag_that_moved_meanwhile_stays(place: Place) -> None:
    old, new = place.base(), place.base("newer")
    app = place.app(old)
    rebaser, plan = place.plan(app, new)
    place.app(place.base("third"))  # somebody else pushes the same tag
    with rebaser, pytest.raises(RosmlError, match="has moved since it was read, and stays") as caught:
        rebaser.move(plan, rebaser.push(plan))
    assert caught.value.exit_code == 1 and place.digest(app) != plan.digest


def test_it_is_interrupted_at_any_request_that_writes(place: Place) -> None:
    """The old tag stands until the last one; the next call ends as an undisturbed one."""
    old, new = place.base(), place.base("newer")
    app = place.app(old)
    before, expected = place.digest(app), place.digest(App(new).put(place.registry, "built"))
    content = dict(place.server.manifests), dict(place.server.blobs), {k: dict(v) for k, v in place.server.tags.items()}
    count = 0
    while True:
        place.server.manifests, place.server.blobs = dict(content[0]), dict(content[1])
        place.server.tags = {name: dict(tags) for name, tags in content[2].items()}
        rebaser, plan = place.plan(app, new, registry=Dying(place.server.address, count))
        try:
            with rebaser:
                rebaser.move(plan, rebaser.push(plan))
        except KeyboardInterrupt:
            assert place.digest(app) == before, "the old tag stands"
            assert place.rebase(app, new).digest == expected == place.digest(app)
            count += 1
        else:
            break
    assert count > 5


class Dying(Registry):
    """A client whose process ends at a write."""

    def __init__(self, host: str, left: int) -> None:
        super().__init__(host)
        self.left = left

    def _ask(self, method: str, *arguments: Any, **more: Any) -> Any:
        if method in ("PUT", "POST"):
            self.left -= 1
            if self.left < 0:
                raise KeyboardInterrupt
        return super()._ask(method, *arguments, **more)
