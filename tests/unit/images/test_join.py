"""Images put together from tiny parts, in a registry in this process: what comes of it, and everything that is refused.
The real registry and real images: tests/e2e/test_join.py."""

from __future__ import annotations

import gzip
import itertools
import json
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from fakes.http_registry import DROP, Fault, StandIn, standing_in
from rosml.base.errors import RosmlError
from rosml.cli import command
from rosml.cli.images import join as script
from rosml.images.image_set import labels
from rosml.images.join import facts, file_lists
from rosml.images.join.file_lists import Files
from rosml.images.join.joiner import Joiner, JoinReport
from rosml.images.scan.sbom import MEDIA_TYPE
from rosml.registry import failures, oci, references
from rosml.registry.client import Registry
from rosml.registry.references import Reference
from tests.e2e import parts
from tests.e2e.parts import PARTS, Tiny, part, ros

BOTH = ("linux/amd64", "linux/arm64")
TORCH: tuple[str, ...] = ("cuda", "common", "torch")
TENSORFLOW: tuple[str, ...] = ("common", "tensorflow-cc", "tensorflow")


class Place:
    """A registry, and who joins in it."""

    def __init__(self, server: StandIn) -> None:
        self.server, self.said = server, list[str]()
        self.registry = Registry(server.address)
        self.others: dict[str, Registry] = {server.address: self.registry}

    def ros(self, tag: str = "ros1-bookworm-core", platforms: Sequence[str] = BOTH[:1], **facts: Any) -> str:
        return ros(**facts).put(self.registry, "me/ros", tag, platforms)

    def stack(self, wanted: Sequence[str] = TORCH, name: str = "cu128", **facts: Any) -> list[str]:
        return parts.stack(self.registry, "me/part", wanted, name, **facts)

    def put(self, image: Tiny, tag: str, platforms: Sequence[str] = BOTH[:1]) -> str:
        return image.put(self.registry, "me/part", tag, platforms)

    def join(
        self,
        *images: str,
        tag: str = "mine",
        repository: str = "me/mine",
        platforms: Sequence[str] = (),
        allow: bool = False,
    ) -> JoinReport:
        with Joiner(self.others.__getitem__, allow_unlisted=allow, say=self.said.append) as joiner:
            return joiner.join(images[0], images[1:], f"{self.server.address}/{repository}:{tag}", platforms)

    def image(self, digest: str) -> tuple[dict[str, Any], dict[str, Any]]:
        """Manifest and config of an image of `me/mine`."""
        found = self.registry.manifest("me/mine", digest)
        assert found
        return found.content, self.registry.json_blob("me/mine", found.content["config"]["digest"])

    def layers(self, reference: str) -> list[str]:
        """Layers of an image for one platform, through its index."""
        where = references.parse(reference)
        index = self.registry.manifest(where.repository, where.reference)
        assert index
        found = self.registry.manifest(where.repository, index.content["manifests"][0]["digest"])
        assert found
        return [layer["digest"] for layer in found.content["layers"]]

    def refused(self, *images: str, **options: Any) -> RosmlError:
        """The error that joining ends with; nothing was pushed, no tag was made."""
        with pytest.raises(RosmlError) as caught:
            self.join(*images, **options)
        assert self.registry.tags("me/mine") == []
        assert not [name for repository, name in self.server.manifests if repository == "me/mine"]
        assert "\n" not in caught.value.message, "one sentence"
        assert caught.value.remedy
        return caught.value


@pytest.fixture
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Place]:
    monkeypatch.setattr(failures, "WAIT", 0.001)
    monkeypatch.setattr(failures, "LONGEST_WAIT", 0.01)
    monkeypatch.setenv("DOCKER_CONFIG", str(tmp_path / "docker"))
    with standing_in() as server:
        found = Place(server)
        yield found
        for registry in found.others.values():
            registry.close()


# ---- What comes of it ------------------------------------------------------------------------------------------------


def test_an_image(place: Place) -> None:
    images = [place.ros(), *place.stack()]
    before = place.registry.uploaded
    found = place.join(*images)
    manifest, config = place.image(found.manifests["linux/amd64"])
    assert [layer["digest"] for layer in manifest["layers"]] == [d for image in images for d in place.layers(image)]
    assert manifest["mediaType"] == oci.IMAGE
    assert manifest["config"]["mediaType"] == oci.CONFIG
    assert len(config["rootfs"]["diff_ids"]) == len(config["history"]) == 4
    assert config["history"][-1] == {
        "created": parts.CREATED,
        "created_by": "COPY --link --from=part:torch-cu128-py311 / /",
        "comment": "joined in the registry",
    }
    assert config["config"]["Env"] == [
        "PATH=/usr/sbin:/usr/bin",
        "TORCH_VERSION=2.10.0",
        "CUDA_VERSION=12.8.90",
        "CUDNN_VERSION=9.10.2.21",
        "NVIDIA_REQUIRE_CUDA=cuda>=12.0",
    ]
    assert config["config"]["Entrypoint"] == ["/tini", "--", "/entrypoint.sh"]
    assert config["config"]["Labels"] == {
        "org.opencontainers.image.title": "ros1-bookworm-core-torch-cu128",
        "org.opencontainers.image.description": "ROS 1 core (ros1-bookworm), PyTorch 2.10.0, CUDA 12.8.90",
        "org.opencontainers.image.version": "ros1-bookworm-core-cu128-torch2.10.0",
        "org.opencontainers.image.licenses": "Apache-2.0",
        "io.rosml.component": "core",
        "io.rosml.distribution": "ros1-bookworm",
        "io.rosml.framework": "torch",
        "io.rosml.os": "bookworm",
        "io.rosml.python": "3.11",
        "io.rosml.ros": "1",
        "io.rosml.stack": "cu128",
        "io.rosml.cuda": "12.8.90",
        "io.rosml.cudnn": "9.10.2.21",
        "io.rosml.torch": "2.10.0",
        "io.rosml.parts": "cuda common torch",
        "io.rosml.gpu.driver": "525",
        "io.rosml.gpu.torch.amd64": "sm_80 sm_90",
    }
    assert config["created"] == parts.CREATED
    assert (found.layers, found.mounted, found.copied, found.unlisted) == (4, 4, 0, [])
    assert found.uploaded == place.registry.uploaded - before < 10_000
    index = place.registry.manifest("me/mine", "mine")
    assert index
    assert index.digest == found.digest
    assert index.content["annotations"]["org.opencontainers.image.title"] == "ros1-bookworm-core-torch-cu128"
    assert not any(name.startswith("io.rosml.") for name in index.content["annotations"])


def test_arguments_of_builds_are_left_out_of_the_history(place: Place) -> None:
    """The steps after them repeat them: a join onto an app would send more than 10 kB."""
    argument = {"created_by": "ARG ROS_TOOLS=vcstool", "empty_layer": True}
    steps = [{"created_by": "RUN |1 ROS_TOOLS=vcstool install"}, {"created_by": "CMD bash", "empty_layer": True}]
    base = ros(config={"history": [argument, *steps]}).put(place.registry, "me/ros", "arguments")
    _, config = place.image(place.join(base, *place.stack()).manifests["linux/amd64"])
    assert config["history"][:2] == steps
    assert [entry for entry in config["history"] if not entry.get("empty_layer")] == [steps[0], *config["history"][2:]]


GRAPH: tuple[str, ...] = ("cuda", "common", "graph-cc", "graph")


def told(place: Place, found: JoinReport) -> dict[str, str]:
    _, config = place.image(found.manifests["linux/amd64"])
    labels: dict[str, str] = config["config"]["Labels"]
    return labels


def test_an_addon_without_a_framework(place: Place) -> None:
    images = [place.ros(), *place.stack(GRAPH[1:], "cpu")]
    found = told(place, place.join(*images))
    assert found["org.opencontainers.image.title"] == "ros1-bookworm-core-graph-cpu"
    assert found["org.opencontainers.image.version"] == "ros1-bookworm-core-cpu-graph1.23.2"
    assert (found["io.rosml.framework"], found["io.rosml.addons"], found["io.rosml.graph"]) == (
        "none",
        "graph",
        "1.23.2",
    )
    assert found["io.rosml.parts"] == "common graph-cc graph"


def test_the_variables_that_software_needs(place: Place) -> None:
    quiet = part("graph", "cpu")
    quiet = replace(quiet, labels={**quiet.labels, "io.rosml.graph.environment": "GRAPH_SENDS=0 GRAPH_LOGS=no"})
    images = [place.ros(), *place.stack(GRAPH[1:-1], "cpu"), place.put(quiet, "graph-cpu-py311")]
    for wrong in ("GRAPH_SENDS", "PATH=/tmp", "GRAPH_SENDS=0=1"):
        damaged = replace(quiet, labels={**quiet.labels, "io.rosml.graph.environment": wrong})
        error = place.refused(*images[:-1], place.put(damaged, "damaged"))
        assert "is damaged" in error.message and "publish it again" in error.remedy
    _, config = place.image(place.join(*images).manifests["linux/amd64"])
    assert config["config"]["Env"][1:] == ["GRAPH_VERSION=1.23.2", "GRAPH_SENDS=0", "GRAPH_LOGS=no"]


def test_addons_onto_an_image_that_has_a_framework(place: Place) -> None:
    """One after the other, or all at once with the framework: layers have the same order."""
    own = [
        part(kind).put(place.registry, "me/part", f"{kind}-cu128", BOTH[:1]) for kind in ("devel", "graph-cc", "graph")
    ]
    base = place.join(place.ros(), *(torch := place.stack()), tag="torch")
    before = place.registry.uploaded
    first = place.join(base.reference, *own[1:], tag="first")
    assert place.registry.uploaded - before < 10_000
    assert (first.layers, first.copied) == (6, 0)
    found = told(place, first)
    assert found["org.opencontainers.image.title"] == "ros1-bookworm-core-torch-graph-cu128"
    assert found["org.opencontainers.image.description"].endswith("PyTorch 2.10.0, CUDA 12.8.90, GRAPH 1.23.2")
    assert found["org.opencontainers.image.version"] == "ros1-bookworm-core-cu128-torch2.10.0-graph1.23.2"
    assert (found["io.rosml.framework"], found["io.rosml.addons"]) == ("torch", "graph")
    assert found["io.rosml.torch"] == "2.10.0"
    assert {name.removeprefix(labels.GPU): text for name, text in found.items() if name.startswith(labels.GPU)} == {
        "driver": "525",
        "torch.amd64": "sm_80 sm_90",
        "graph.amd64": "sm_80 sm_90a",
    }
    assert found["io.rosml.parts"] == "cuda common torch graph-cc graph"
    _, config = place.image(first.manifests["linux/amd64"])
    assert {"TORCH_VERSION=2.10.0", "GRAPH_VERSION=1.23.2", "CUDA_VERSION=12.8.90"} <= {*config["config"]["Env"]}

    second = told(place, place.join(first.reference, own[0], tag="second"))
    assert (second["io.rosml.addons"], second["io.rosml.parts"].split()[-1]) == ("devel graph", "devel")
    assert second["org.opencontainers.image.title"] == "ros1-bookworm-core-torch-devel-graph-cu128"

    once = place.join(place.ros(), *reversed(own), *torch, tag="once")
    assert told(place, once)["io.rosml.parts"] == "cuda common torch devel graph-cc graph"
    assert told(place, once)["io.rosml.addons"] == "devel graph"


def test_the_index_of_a_join_leads_to_the_sboms_of_all_that_is_in_it(place: Place) -> None:
    """By the digests of the ROS image, of the framework's parts and of the add-on's, to each of which one is attached."""
    own = [part(kind).put(place.registry, "me/part", f"{kind}-cu128") for kind in ("graph-cc", "graph")]
    base = place.join(place.ros(), *(torch := place.stack()), tag="torch")
    place.join(base.reference, *own, tag="both")
    made = set()
    for name in (f"{place.server.address}/me/ros:ros1-bookworm-core", *torch, *own):
        where = references.parse(name)
        index = place.registry.manifest(where.repository, where.reference)
        assert index
        (member,) = index.members
        image = place.registry.manifest(where.repository, member.digest)
        assert image
        place.registry.attach(where.repository, image.descriptor, MEDIA_TYPE, b"{}", MEDIA_TYPE)
        made.add((where.repository, member.digest))
    index = place.registry.manifest("me/mine", "both")
    assert index
    (member,) = index.members
    found = facts.components(place.registry, "me/mine", member.digest, member.annotations)
    assert {*found} == made and len(found) == 6
    assert all(place.registry.referrers(*component, MEDIA_TYPE) for component in found)


def test_an_addon_onto_an_app(place: Place) -> None:
    base = place.join(place.ros(), *place.stack())
    app = replace(ros(), labels={**told(place, base), labels.TITLE: "robot", labels.APP: "run"})
    made = app.put(place.registry, "me/robot", "latest", BOTH[:1])
    found = told(place, place.join(made, *place.stack(GRAPH[2:]), tag="with-graph"))
    assert (found[labels.TITLE], found["io.rosml.addons"]) == ("robot", "graph")


@pytest.mark.parametrize(
    ("there", "wanted", "says", "remedy"),
    [
        ((), ("graph",), "cannot do without", "add cuda-cu128, common-cu128-py311 and graph-cc-cu128: add-on graph"),
        (("cuda",), ("graph-cc", "graph"), "cannot do without common of stack cu128", "add common-cu128-py311"),
        (TORCH, ("graph",), "cannot do without graph-cc of stack cu128", "add graph-cc-cu128"),
        (TORCH, ("common", "graph-cc", "graph"), "has the part common already", "leave it out"),
        (TORCH, TENSORFLOW[1:], "has framework torch of stack cu128 already", "take the ROS image below it"),
        (("cuda",), ("tensorflow", "graph-cc", "graph", "common"), "has framework cuda of stack cu128 already", "take"),
    ],
)
def test_an_addon_that_does_not_fit(
    there: tuple[str, ...], wanted: tuple[str, ...], says: str, remedy: str, place: Place
) -> None:
    with_parts = [part(kind).put(place.registry, "me/part", kind, BOTH[:1]) for kind in wanted]
    below = place.ros()
    if there:
        with Joiner(place.others.__getitem__) as joiner:
            below = joiner.join(below, place.stack(there), f"{place.server.address}/me/below:x").reference
    refused = place.refused(below, *with_parts)
    assert says in refused.message and remedy in refused.remedy and refused.exit_code == 2


def test_an_addon_of_another_stack(place: Place) -> None:
    with Joiner(place.others.__getitem__) as joiner:
        base = joiner.join(place.ros(), place.stack(), f"{place.server.address}/me/below:x").reference
    refused = place.refused(base, *place.stack(GRAPH[2:], "cpu"))
    assert "an image carries one stack" in refused.message


def test_an_app_keeps_its_title(place: Place) -> None:
    app = ros()
    app = replace(app, labels={**app.labels, labels.TITLE: "robot", labels.APP: "run"})
    found = place.join(app.put(place.registry, "me/robot", "latest", BOTH[:1]), *place.stack())
    _, config = place.image(found.manifests["linux/amd64"])
    told = config["config"]["Labels"]
    assert (told[labels.TITLE], told["io.rosml.framework"]) == ("robot", "torch")


@pytest.mark.parametrize(
    ("wanted", "stack", "framework"),
    [(("cuda",), "cu128", "cuda"), (TORCH, "cu128", "torch"), (TORCH[1:], "cpu", "torch"),
     (TENSORFLOW, "cpu", "tensorflow"), (PARTS, "cu128", "ml"), (PARTS[1:], "cpu", "ml")],
)  # fmt: skip
def test_frameworks(place: Place, wanted: tuple[str, ...], stack: str, framework: str) -> None:
    """Layers in the order of the Dockerfile, whatever the order of the arguments."""
    base, own = place.ros(), place.stack(wanted, stack)
    found = place.join(base, *reversed(own))
    manifest, config = place.image(found.manifests["linux/amd64"])
    assert config["config"]["Labels"]["io.rosml.framework"] == framework
    there = [layer["digest"] for layer in manifest["layers"]]
    assert there == [d for image in (base, *own) for d in place.layers(image)]


@given(data=st.data())
@settings(max_examples=10, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_same_parts_same_bytes(place: Place, data: st.DataObject) -> None:
    """In any order, by whatever names, from another repository, in another registry: the same digest."""
    wanted = data.draw(st.sampled_from([TORCH, PARTS, ("cuda",)]))
    first = place.join(place.ros(), *place.stack(wanted), tag="first")
    own = data.draw(st.permutations(place.stack(wanted)))
    if data.draw(st.booleans()):  # as a digest
        own = [_by_digest(place, name) for name in own]
    if data.draw(st.booleans()):
        own = [part(kind).put(place.registry, "elsewhere", kind) for kind in wanted]
    assert place.join(place.ros(), *own, tag="second").digest == first.digest


def _by_digest(place: Place, name: str) -> str:
    where = references.parse(name)
    return str(where._replace(reference=place.registry.head(where.repository, where.reference)))


def test_a_second_call_moves_nothing_but_the_tag(place: Place) -> None:
    images = [place.ros(), *place.stack()]
    first = place.join(*images)
    requests = len(place.server.requests)
    second = place.join(*images, tag="another")
    assert (second.digest, second.present, second.mounted) == (first.digest, 4, 0)
    writes = [line for line in place.server.requests[requests:] if not line.startswith(("GET", "HEAD"))]
    assert writes == ["PUT /v2/me/mine/manifests/another"]


def test_every_platform_that_all_have(place: Place) -> None:
    images = [place.ros(platforms=BOTH), *(place.put(part(kind), kind, BOTH) for kind in TORCH)]
    found = place.join(*images)
    assert list(found.manifests) == list(BOTH)
    index = place.registry.manifest("me/mine", "mine")
    assert index
    assert [(e["platform"], e["digest"]) for e in index.content["manifests"]] == [
        ({"os": "linux", "architecture": name}, found.manifests[f"linux/{name}"]) for name in ("amd64", "arm64")
    ]
    assert place.image(found.manifests["linux/arm64"])[1]["architecture"] == "arm64"
    assert place.said == []
    one = place.join(*images, platforms=["linux/arm64"], tag="one")
    assert one.manifests == {"linux/arm64": found.manifests["linux/arm64"]}


def test_a_platform_that_some_lack_is_left_out_and_said(place: Place) -> None:
    found = place.join(place.ros(platforms=BOTH), *place.stack())
    assert list(found.manifests) == ["linux/amd64"]
    (said,) = place.said
    assert "also for linux/arm64" in said
    assert "cuda-cu128" in said


def test_manifests_without_an_index(place: Place) -> None:
    digest, _ = ros().put_manifest(place.registry, "me/ros")
    (cuda,) = place.stack(("cuda",))
    assert place.join(f"{place.server.address}/me/ros@{digest}", cuda).digest == place.join(place.ros(), cuda).digest


def test_attestations_are_no_platform(place: Place) -> None:
    base = references.parse(place.ros())
    index = place.registry.manifest(base.repository, base.reference)
    assert index
    attestation = place.registry.put_manifest(base.repository, "", {"schemaVersion": 2})
    unknown = {"platform": {"os": "unknown", "architecture": "unknown"}, "digest": attestation}
    content = {
        **index.content,
        "manifests": [*index.content["manifests"], {**unknown, "mediaType": oci.IMAGE, "size": 1}],
    }
    place.registry.put_manifest(base.repository, base.reference, content, oci.INDEX)
    assert list(place.join(str(base), *place.stack()).manifests) == ["linux/amd64"]


def test_for_a_publishing_run(place: Place) -> None:
    """From digests, for one platform: by its digest alone."""

    def put(image: Tiny, repository: str) -> Reference:
        return Reference(place.server.address, repository, image.put_manifest(place.registry, repository)[0])

    images = [put(ros(), "me/ros"), *(put(part(kind), "me/part") for kind in TORCH)]
    with Joiner(place.others.__getitem__) as joiner:
        found = joiner.manifest(images[0], images[1:], place.server.address, "me/mine")
    assert place.registry.tags("me/mine") == []
    assert found.digest == place.join(place.ros(), *place.stack()).manifests["linux/amd64"]


# ---- Where layers come from ------------------------------------------------------------------------------------------


def test_layers_are_copied_where_mounts_are_refused(place: Place) -> None:
    images = [place.ros(), *place.stack()]
    place.server.mounts = False
    found = place.join(*images)
    assert (found.mounted, found.copied) == (0, 4)
    again = place.join(place.ros(salt="2"), *images[1:], tag="two")
    assert (again.copied, again.present) == (1, 3), "what is there is not copied again"
    assert place.server.aborted >= 4


def test_layers_are_copied_from_another_registry(place: Place) -> None:
    with standing_in() as far:
        place.others[far.address] = Registry(far.address)
        own = [part(kind).put(place.others[far.address], "x/part", kind) for kind in TORCH]
        far.fault("GET", "/blobs/", DROP, 2)
        before = place.registry.uploaded
        found = place.join(place.ros(), *own)
        assert (found.mounted, found.copied) == (1, 3)
        assert found.uploaded <= place.registry.uploaded - before
        assert not any(line.startswith(("PUT", "POST")) for line in far.requests[-40:] if "/me/" in line)
    assert all(
        ("me/mine", layer["digest"]) in place.server.blobs
        for layer in place.image(found.manifests["linux/amd64"])[0]["layers"]
    )


def test_parts_in_the_same_repository(place: Place) -> None:
    images = [ros().put(place.registry, "me/mine", "ros"), *place.stack(("cuda",))]
    found = place.join(*images)
    assert (found.present, found.mounted) == (1, 1)


def test_dockers_media_types_become_ocis(place: Place) -> None:
    base = references.parse(place.ros())
    index = place.registry.manifest(base.repository, base.reference)
    assert index
    manifest = place.registry.manifest(base.repository, index.content["manifests"][0]["digest"])
    assert manifest
    docker = "application/vnd.docker.image.rootfs.diff.tar.gzip"
    content = {
        "schemaVersion": 2,
        "mediaType": oci.DOCKER_IMAGE,
        "config": {**manifest.content["config"], "mediaType": oci.DOCKER_CONFIG},
        "layers": [{**layer, "mediaType": docker} for layer in manifest.content["layers"]],
    }
    place.registry.put_manifest(base.repository, "docker", content, oci.DOCKER_IMAGE)
    digest = place.registry.head(base.repository, "docker")
    subject = place.registry.manifest(base.repository, digest)
    assert subject
    listed = gzip.compress(b"usr/bin/env\n")
    place.registry.attach(base.repository, subject.descriptor, file_lists.ARTIFACT, listed, file_lists.MEDIA_TYPE)
    found = place.join(str(base._replace(reference="docker")), *place.stack())
    layers = place.image(found.manifests["linux/amd64"])[0]["layers"]
    assert {layer["mediaType"] for layer in layers} == {"application/vnd.oci.image.layer.v1.tar+gzip"}


def test_a_connection_that_ends_anywhere_leaves_no_tag(place: Place, monkeypatch: pytest.MonkeyPatch) -> None:
    """Whichever request is the first that gets no answer, of every third; and the next call finishes it."""
    monkeypatch.setattr(failures, "ATTEMPTS", 1)
    images = [place.ros(), *place.stack()]
    digest = place.join(*images).digest
    due = place.server.due
    for number in itertools.count(step=3):
        seen, repository = itertools.count(), f"me/try{number}"

        def broken(method: str, path: str, seen: Iterator[int] = seen, number: int = number) -> Fault | None:
            return Fault(method, path, DROP) if next(seen) >= number else due(method, path)

        monkeypatch.setattr(place.server, "due", broken)
        try:
            place.join(*images, repository=repository)
            break
        except RosmlError:
            pass
        monkeypatch.setattr(place.server, "due", due)
        assert [tag for tag in place.registry.tags(repository) if not tag.startswith("sha256-")] == []
        assert place.join(*images, repository=repository).digest == digest
    assert number > 30


# ---- What does not go together ---------------------------------------------------------------------------------------


def test_another_python(place: Place) -> None:
    error = place.refused(place.ros(python="3.13"), *place.stack())
    assert "common-cu128 is for Python 3.11, and" in error.message
    assert "has Python 3.13" in error.message
    assert error.remedy == "use the part common-cu128-py313"
    assert error.exit_code == 2
    (cuda,) = place.stack(("cuda",))
    assert place.join(place.ros(python="3.13"), cuda).layers == 2, "what is for any Python fits all"


def test_another_platform(place: Place) -> None:
    own = [place.put(part(kind), kind, ["linux/arm64"]) for kind in TORCH]
    error = place.refused(place.ros(), *own)
    assert "no platform in common" in error.message
    assert "ros1-bookworm-core is for linux/amd64" in error.message
    error = place.refused(place.ros(platforms=BOTH), *own, platforms=["linux/amd64"])
    assert "for linux/arm64, not for linux/amd64" in error.message


def test_two_stacks(place: Place) -> None:
    common, torch = place.stack(("common",), "cpu"), place.stack(("torch",))
    error = place.refused(place.ros(), *common, *torch)
    assert "one stack: " in error.message
    assert "common-cpu is of stack cpu" in error.message
    assert "torch-cu128 is of stack cu128" in error.message


def test_a_part_twice(place: Place) -> None:
    another = place.put(part("torch", salt="2"), "another")
    error = place.refused(place.ros(), *place.stack(), another)
    assert "part torch is there twice" in error.message
    assert "another" in error.message and "torch-cu128" in error.message


def test_an_image_of_somebody_else_with_cuda(place: Place) -> None:
    own = replace(ros(), labels={**ros().labels, "io.rosml.own": "CUDA_VERSION"})
    error = place.refused(own.put(place.registry, "me/ros-cuda", "x"), *place.stack())
    assert "has CUDA or a framework from its base image: CUDA_VERSION" in error.message


def test_an_image_that_has_it_already(place: Place) -> None:
    images = [place.ros(), *place.stack()]
    full = ros()
    full = replace(full, labels={**full.labels, "io.rosml.framework": "torch", "io.rosml.stack": "cu128"})
    error = place.refused(full.put(place.registry, "me/ros-torch", "x"), *images[1:])
    assert "has framework torch of stack cu128 already" in error.message
    assert error.remedy.endswith("ros:ros1-bookworm-core")


@pytest.mark.parametrize(
    ("given", "stack", "lacking"),
    [
        (("torch",), "cpu", "common-cpu-py311"),
        (("torch",), "cu128", "cuda-cu128 and common-cu128-py311"),
        (("common", "torch"), "cu128", "cuda-cu128"),
        (("common", "tensorflow"), "cpu", "tensorflow-cc-cpu"),
        (("common", "tensorflow-cc"), "cpu", "tensorflow-cpu-py311"),
        (("common",), "cpu", "torch-cpu-py311"),
    ],
)
def test_a_part_that_is_missing(place: Place, given: tuple[str, ...], stack: str, lacking: str) -> None:
    error = place.refused(place.ros(), *place.stack(given, stack))
    assert error.remedy.startswith(f"add {lacking}: framework ")
    assert "cannot do without" in error.message


def test_frameworks_that_do_not_go_together(place: Place) -> None:
    alone = {name: parts.FRAMEWORKS[name] for name in ("torch", "tensorflow")}
    error = place.refused(place.ros(), *place.stack(PARTS[1:], "cpu38", frameworks=alone))
    assert "no framework of stack cpu38 takes common, tensorflow, tensorflow-cc and torch together" in error.message


def test_parts_of_different_releases(place: Place) -> None:
    own = place.stack(TENSORFLOW, "cpu")
    newer = place.put(part("tensorflow", "cpu", versions={"tensorflow": "2.21.0"}), "newer")
    error = place.refused(place.ros(), *own[:2], newer)
    assert "has tensorflow 2.20.0, and" in error.message and "has 2.21.0" in error.message
    more = {**parts.FRAMEWORKS, "tensorflow": ("common", "jax", "tensorflow-cc", "tensorflow")}
    other = place.put(part("tensorflow", "cpu", frameworks=more), "other")
    assert "are of different releases" in place.refused(place.ros(), *own[:2], other).message


def test_what_is_no_ros_image(place: Place) -> None:
    own = place.stack()
    strange = Tiny({"maintainer": "somebody"}).put(place.registry, "me/strange", "x")
    assert "is no ROS image of this project" in place.refused(strange, *own).message
    assert "is a part" in place.refused(own[0], *own).message
    assert "is a ROS image" in place.refused(place.ros(), *own, place.ros()).message
    assert "is no part: it has no label io.rosml.part" in place.refused(place.ros(), *own, strange).message
    assert "there are no parts to join" in place.refused(place.ros()).message
    for name in (f"{place.server.address}/me/ros:none", f"{place.server.address}/none:x"):
        assert f"{name} is not there" in place.refused(name, *own).message


@pytest.mark.parametrize(
    ("which", "label", "value"),
    [
        ("ros", "parts", "common common"),
        ("ros", "stack", "../x"),
        ("part", "brings", "a:b"),
        ("part", "torch", '1"\nRUN x'),
    ],
)
def test_labels_that_are_damaged(which: str, label: str, value: str, place: Place) -> None:
    """What else may be wrong with them: test_told.py."""
    images = {"ros": ros(), "part": part("torch")}
    images[which] = replace(images[which], labels={**images[which].labels, f"io.rosml.{label}": value})
    others = place.stack(("cuda", "common"))
    error = place.refused(place.put(images["ros"], "ros"), *others, place.put(images["part"], "torch"))
    assert "is damaged" in error.message and error.exit_code == 2


def test_what_is_no_image(place: Place) -> None:
    subject = references.parse(_by_digest(place, place.ros())).reference
    entries = [name for name in place.server.tags["me/ros"] if name.startswith("sha256-")]
    assert entries, "the index of lists is there"
    digest = place.registry.attach("me/ros", {"mediaType": oci.INDEX, "digest": subject, "size": 1}, "x/y", b"z", "x/y")
    error = place.refused(f"{place.server.address}/me/ros@{digest}", *place.stack())
    assert "is an artifact of another kind" in error.message


def test_an_image_in_pieces(place: Place) -> None:
    broken = ros(config={"rootfs": {"type": "layers", "diff_ids": []}}).put(place.registry, "me/ros", "broken")
    assert "is incomplete" in place.refused(broken, *place.stack()).message
    triggers = {"config": {"Labels": dict(ros().labels), "OnBuild": ["ADD http://127.0.0.1:8099/secret /"]}}
    asking = ros(config=triggers).put(place.registry, "me/ros", "asking")
    assert "has ONBUILD" in place.refused(asking, *place.stack()).message
    damaged = part("cuda")
    damaged = replace(damaged, labels={**damaged.labels, "io.rosml.frameworks": "torch"})
    assert "io.rosml.frameworks is damaged" in place.refused(place.ros(), place.put(damaged, "damaged")).message


def test_the_order_of_the_arguments_does_not_count_for_errors(place: Place) -> None:
    own = [
        *place.stack(("torch", "common")),
        *place.stack(("torch",), "cpu"),
        place.put(part("common"), "again"),
    ]
    base = place.ros()
    said = {place.refused(base, *order).message for order in itertools.permutations(own)}
    assert len(said) == 1, said


@pytest.mark.parametrize("tag", ["me/mine", "ghcr.io", "127.0.0.1:1/me@sha256:" + "1" * 64])
def test_a_tag_that_is_none(place: Place, tag: str) -> None:
    with Joiner(place.others.__getitem__) as joiner, pytest.raises(RosmlError) as caught:
        joiner.join(place.ros(), place.stack(), tag)
    assert caught.value.exit_code == 2


# ---- Files -----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("one", "other", "named"),
    [
        (["usr/lib/x.so", "a"], ["usr/lib/x.so"], "usr/lib/x.so"),
        (["lib/x.so"], ["usr/lib/x.so"], "usr/lib/x.so"),
        (["usr/sbin/x"], ["sbin/x"], "usr/sbin/x"),
        (["lib"], ["lib/x.so"], "lib"),
        (["usr/share/doc"], ["usr/share/doc/x/y"], "usr/share/doc"),
        (["usr/share/doc/x/y"], ["usr/share/doc"], "usr/share/doc"),
        (["b", "a"], ["a", "b"], "a"),
        (["library/x"], ["usr/library/x"], ""),
        (["usr/lib/x"], ["usr/lib/y", "usr/libx"], ""),
        (["lib", "bin"], ["usr/lib/x"], ""),
        ([], [], ""),
    ],
)
def test_the_same_file(one: list[str], other: list[str], named: str) -> None:
    found, others = (Files.parse("\n".join(names).encode()) for names in (one, other))
    assert file_lists.clash(found, others) == file_lists.clash(others, found) == named


def test_two_parts_that_carry_the_same_file(place: Place) -> None:
    own = place.stack(("cuda", "common"))
    torch = place.put(part("torch", files=("usr/local/share/common", "x")), "torch")
    error = place.refused(place.ros(), *own, torch)
    assert "both carry /usr/local/share/common: one would hide the other's" in error.message
    (cuda,) = [place.put(part("cuda", files=("bin/env",)), "c")]
    error = place.refused(place.ros(), cuda)
    assert "both carry /bin" in error.message, "a folder over the link would hide all that is behind it"


def test_without_a_list(place: Place) -> None:
    own = [*place.stack(("cuda", "common")), place.put(part("torch", unlisted=True), "torch")]
    error = place.refused(place.ros(), *own)
    assert "part:torch has no list of its files" in error.message
    assert "--allow-unlisted" in error.remedy
    found = place.join(place.ros(), *own, allow=True)
    assert found.unlisted == [own[2]]
    assert any("no list of its files" in line for line in place.said)
    clashing = place.put(part("common", files=("usr/bin/env",)), "common")
    with pytest.raises(RosmlError, match="both carry /usr/bin/env"):
        place.join(place.ros(), own[0], clashing, own[2], allow=True)


def test_a_list_of_somebody_else_hides_no_file(place: Place) -> None:
    own = [*place.stack(("cuda", "common")), place.put(part("torch", files=("usr/bin/env",)), "torch")]
    where = references.parse(own[-1])
    index = place.registry.manifest(where.repository, where.reference)
    assert index

    def attach(data: bytes) -> None:
        for member in index.members:
            subject = {"mediaType": oci.IMAGE, "digest": member.digest, "size": member.size}
            place.registry.attach(where.repository, subject, file_lists.ARTIFACT, data, file_lists.MEDIA_TYPE)

    for number in range(30, 33):  # one of them has a lower digest than the list of the part itself
        attach(gzip.compress(f"usr/nothing/{number}".encode(), mtime=0))
    assert "both carry /usr/bin/env" in place.refused(place.ros(), *own).message
    attach(b"one more")
    assert "has 5 lists of files" in place.refused(place.ros(), *own).message


def test_lists_are_downloaded_once(place: Place) -> None:
    """However many images a run joins from the same ones."""
    images = [place.ros(), *place.stack()]
    with Joiner(place.others.__getitem__) as joiner:
        for tag in ("one", "two"):
            before = len(place.server.requests)
            joiner.join(images[0], images[1:], f"{place.server.address}/me/mine:{tag}")
            asked = [line for line in place.server.requests[before:] if line.startswith("GET") and "/blobs/" in line]
            assert bool(asked) == (tag == "one")


def test_lists_that_are_damaged() -> None:
    for data in (b"", b"text", gzip.compress(b"a\n" * 1000)[:-9]):
        with pytest.raises(RosmlError, match="damaged"):
            file_lists.unpacked(data)


def test_a_list_that_never_ends(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(file_lists, "LARGEST", 1000)
    assert len(file_lists.unpacked(gzip.compress(b"a" * 1000))) == 1000
    with pytest.raises(RosmlError, match="damaged"):
        file_lists.unpacked(gzip.compress(b"a" * 1001))


# ---- The command -----------------------------------------------------------------------------------------------------


@pytest.fixture
def call(place: Place, capsys: pytest.CaptureFixture[str]) -> Callable[..., tuple[int, str, str]]:
    def run(*arguments: str) -> tuple[int, str, str]:
        code = command.run(script.main, arguments=arguments)
        said = capsys.readouterr()
        return code, said.out, said.err

    return run


def test_command(place: Place, call: Callable[..., tuple[int, str, str]]) -> None:
    images = [place.ros(), *place.stack()]
    tag = f"{place.server.address}/me/mine:x"
    code, out, err = call(*images, "--tag", tag)
    assert (code, err) == (0, "")
    lines = out.splitlines()
    assert lines[0] == f"{tag}@{place.registry.head('me/mine', 'x')}"
    assert lines[1] == "linux/amd64: 4 layers (4 mounted)"
    assert "uploaded in" in lines[2]
    code, out, _ = call(*images, "--tag", tag, "--json", "--platform", "linux/amd64")
    assert code == 0
    assert json.loads(out)["present"] == 4


def test_command_says_what_is_wrong(place: Place, call: Callable[..., tuple[int, str, str]]) -> None:
    images = [place.ros(), *place.stack(("common",), "cpu")]
    code, out, err = call(*images, "--tag", f"{place.server.address}/me/mine:x")
    assert (code, out) == (2, "")
    assert "remedy: add torch-cpu-py311" in err
    whole = [place.ros(), *place.stack(("cuda",))]
    place.server.fault("PUT", "/manifests/", 400)
    code, _, err = call(*whole, "--tag", f"{place.server.address}/me/mine:x")
    assert code == 1
    assert "Traceback" not in err
    for wrong in ([images[0]], [*images], [*images, "--tag", "x"]):
        assert call(*wrong)[0] == 2
