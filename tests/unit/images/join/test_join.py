"""Images joined from tiny parts, in a registry in this process: the results, and everything that is refused.
The real registry and real images: tests/e2e/test_join.py."""

from __future__ import annotations

import gzip
import itertools
import json
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest

from fakes.http_registry import DROP, Fault, local_registry
from fakes.joins import AMD64, BOTH, GRAPH, TENSORFLOW, TORCH, Place, joining
from rosml.base.errors import RosmlError
from rosml.cli import command
from rosml.cli.images import join as script
from rosml.images.image_set import labels
from rosml.images.join import facts, file_lists
from rosml.images.join.joiner import Joiner
from rosml.images.scan.sbom import MEDIA_TYPE
from rosml.registry import oci, references, retries
from rosml.registry.client import Registry
from rosml.registry.references import Reference
from tests.e2e import parts
from tests.e2e.parts import PARTS, Tiny, part, ros


@pytest.fixture
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Place]:
    with joining(tmp_path, monkeypatch) as place:
        yield place


# ---- Results ---------------------------------------------------------------------------------------------------------


def test_an_image(place: Place) -> None:
    images = [place.ros(), *place.stack()]
    before = place.registry.uploaded
    report = place.join(*images)
    manifest, config = place.image(report)
    assert [layer["digest"] for layer in manifest["layers"]] == place.layers(*images)
    assert (manifest["mediaType"], manifest["config"]["mediaType"]) == (oci.IMAGE, oci.CONFIG)
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
    ours = {"component": "core", "distribution": "ros1-bookworm", "framework": "torch", "os": "bookworm", "ros": "1"}
    ours |= {"python": "3.11", "stack": "cu128", "cuda": "12.8.90", "cudnn": "9.10.2.21", "torch": "2.10.0"}
    ours |= {"parts": "cuda common torch", "gpu.driver": "525", "gpu.torch.amd64": "sm_80 sm_90"}
    assert config["config"]["Labels"] == {
        "org.opencontainers.image.title": "ros1-bookworm-core-torch-cu128",
        "org.opencontainers.image.description": "ROS 1 core (ros1-bookworm), PyTorch 2.10.0, CUDA 12.8.90",
        "org.opencontainers.image.version": "ros1-bookworm-core-cu128-torch2.10.0",
        "org.opencontainers.image.licenses": "Apache-2.0",
        **{f"io.rosml.{name}": text for name, text in ours.items()},
    }
    assert (report.layers, report.mounted, report.copied, report.unlisted) == (4, 4, 0, [])
    assert report.uploaded == place.registry.uploaded - before < 10_000
    index = place.manifest("me/mine", "mine")
    assert index.digest == report.digest
    annotations = index.content["annotations"]
    assert annotations[labels.TITLE] == "ros1-bookworm-core-torch-cu128"
    assert not any(name.startswith("io.rosml.") for name in annotations)


def test_arguments_of_builds_are_left_out_of_the_history(place: Place) -> None:
    argument = {"created_by": "ARG ROS_TOOLS=vcstool", "empty_layer": True}
    steps = [{"created_by": "RUN |1 ROS_TOOLS=vcstool install"}, {"created_by": "CMD bash", "empty_layer": True}]
    base = ros(config={"history": [argument, *steps]}).put(place.registry, "me/ros", "arguments")
    _, config = place.image(place.join(base, *place.stack()))
    assert config["history"][:2] == steps and len(config["history"]) == 5


def test_an_addon_without_a_framework(place: Place) -> None:
    texts = place.labels(place.join(place.ros(), *place.stack(("common", *GRAPH), "cpu")))
    assert texts["org.opencontainers.image.title"] == "ros1-bookworm-core-graph-cpu"
    assert texts["org.opencontainers.image.version"] == "ros1-bookworm-core-cpu-graph1.23.2"
    names = ("framework", "addons", "graph", "parts")
    assert [texts[f"io.rosml.{name}"] for name in names] == ["none", "graph", "1.23.2", "common graph-cc graph"]


def test_the_variables_that_software_needs(place: Place) -> None:
    graph = part("graph", "cpu")
    graph = replace(graph, labels={**graph.labels, "io.rosml.graph.environment": "GRAPH_SENDS=0 GRAPH_LOGS=no"})
    images = [place.ros(), *place.stack(("common", "graph-cc"), "cpu"), place.put(graph, "graph-cpu-py311")]
    _, config = place.image(place.join(*images))
    assert config["config"]["Env"][1:] == ["GRAPH_VERSION=1.23.2", "GRAPH_SENDS=0", "GRAPH_LOGS=no"]


def test_addons_onto_an_image_that_has_a_framework(place: Place) -> None:
    """One after the other, or all at once with the framework: layers have the same order."""
    devel, *graph = place.stack(("devel", *GRAPH))
    base = place.join(place.ros(), *(torch := place.stack()), tag="torch")
    before = place.registry.uploaded
    first = place.join(base.reference, *graph, tag="first")
    assert place.registry.uploaded - before < 10_000 and (first.layers, first.copied) == (6, 0)
    texts = place.labels(first)
    assert texts[labels.TITLE] == "ros1-bookworm-core-torch-graph-cu128"
    assert texts["org.opencontainers.image.description"].endswith("PyTorch 2.10.0, CUDA 12.8.90, GRAPH 1.23.2")
    assert texts["org.opencontainers.image.version"] == "ros1-bookworm-core-cu128-torch2.10.0-graph1.23.2"
    names = ("framework", "addons", "torch", "parts")
    expected = ["torch", "graph", "2.10.0", "cuda common torch graph-cc graph"]
    assert [texts[f"io.rosml.{name}"] for name in names] == expected
    assert {labels.GPU + name for name in ("driver", "torch.amd64", "graph.amd64")} <= texts.keys()
    environment = {*place.image(first)[1]["config"]["Env"]}
    assert {"TORCH_VERSION=2.10.0", "GRAPH_VERSION=1.23.2", "CUDA_VERSION=12.8.90"} <= environment

    second = place.labels(place.join(first.reference, devel, tag="second"))
    assert (second["io.rosml.addons"], second["io.rosml.parts"].split()[-1]) == ("devel graph", "devel")
    assert second[labels.TITLE] == "ros1-bookworm-core-torch-devel-graph-cu128"
    once = place.labels(place.join(place.ros(), *reversed([devel, *graph]), *torch, tag="once"))
    assert once["io.rosml.parts"] == "cuda common torch devel graph-cc graph"
    assert once["io.rosml.addons"] == "devel graph"


def test_the_index_of_a_join_leads_to_the_sboms_of_all_that_is_in_it(place: Place) -> None:
    """By the digests of the ROS image, of the framework's parts and of the add-on's, to each of which one is attached."""
    graph = place.stack(GRAPH)
    base = place.join(place.ros(), *(torch := place.stack()), tag="torch")
    place.join(base.reference, *graph, tag="both")
    described = set()
    for name in (f"{place.server.address}/me/ros:ros1-bookworm-core", *torch, *graph):
        item = references.parse(name)
        (member,) = place.manifest(item.repository, item.reference).members
        image = place.manifest(item.repository, member.digest)
        place.registry.attach(item.repository, image.descriptor, MEDIA_TYPE, b"{}", MEDIA_TYPE)
        described.add((item.repository, member.digest))
    (member,) = place.manifest("me/mine", "both").members
    components = facts.components(place.registry, "me/mine", member.digest, member.annotations)
    assert {*components} == described and len(components) == 6


def test_an_app_keeps_its_title(place: Place) -> None:
    app = place.labelled_ros(title="robot", app="run")
    report = place.join(app, *place.stack())
    assert (place.labels(report)[labels.TITLE], place.labels(report)["io.rosml.framework"]) == ("robot", "torch")
    texts = place.labels(place.join(report.reference, *place.stack(GRAPH), tag="with-graph"))
    assert (texts[labels.TITLE], texts["io.rosml.addons"]) == ("robot", "graph")


@pytest.mark.parametrize(
    ("kinds", "stack", "framework"),
    [(("cuda",), "cu128", "cuda"), (TORCH, "cu128", "torch"), (TORCH[1:], "cpu", "torch"),
     (TENSORFLOW, "cpu", "tensorflow"), (PARTS, "cu128", "ml"), (PARTS[1:], "cpu", "ml")],
)  # fmt: skip
def test_frameworks(place: Place, kinds: tuple[str, ...], stack: str, framework: str) -> None:
    """Layers in the order of the Dockerfile, whatever the order of the arguments."""
    base, images = place.ros(), place.stack(kinds, stack)
    manifest, config = place.image(place.join(base, *reversed(images)))
    assert config["config"]["Labels"]["io.rosml.framework"] == framework
    assert [layer["digest"] for layer in manifest["layers"]] == place.layers(base, *images)


def test_same_parts_same_bytes(place: Place) -> None:
    """In any order, by digest, from another repository: the same digest."""
    images = place.stack()
    first = place.join(place.ros(), *images, tag="first")
    places = [references.parse(name) for name in images]
    heads = [place.registry.head(item.repository, item.reference) for item in places]
    by_digest = [str(item._replace(reference=digest)) for item, digest in zip(places, heads, strict=True)]
    elsewhere = [part(kind).put(place.registry, "elsewhere", kind) for kind in TORCH]
    for others in (*itertools.permutations(images), by_digest, elsewhere):
        assert place.join(place.ros(), *others, tag="second").digest == first.digest


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
    report = place.join(*images)
    assert list(report.manifests) == list(BOTH) and place.lines == []
    entries = place.manifest("me/mine", "mine").content["manifests"]
    assert [entry["digest"] for entry in entries] == [*report.manifests.values()]
    assert [entry["platform"] for entry in entries] == [
        {"os": "linux", "architecture": name} for name in ("amd64", "arm64")
    ]
    assert place.image(report, "linux/arm64")[1]["architecture"] == "arm64"
    arm64 = place.join(*images, platforms=["linux/arm64"], tag="arm64").manifests
    assert arm64 == {"linux/arm64": report.manifests["linux/arm64"]}


def test_a_platform_that_some_lack_is_left_out_with_a_message(place: Place) -> None:
    assert list(place.join(place.ros(platforms=BOTH), *place.stack()).manifests) == [AMD64]
    (line,) = place.lines
    assert "also for linux/arm64" in line and "cuda-cu128" in line


def test_manifests_without_an_index(place: Place) -> None:
    digest, _ = ros().put_manifest(place.registry, "me/ros")
    (cuda,) = place.stack(("cuda",))
    assert place.join(f"{place.server.address}/me/ros@{digest}", cuda).digest == place.join(place.ros(), cuda).digest


def test_attestations_are_no_platform(place: Place) -> None:
    base = references.parse(place.ros())
    content = place.manifest(base.repository, base.reference).content
    digest = place.registry.put_manifest(base.repository, "", {"schemaVersion": 2})
    unknown = {"os": "unknown", "architecture": "unknown"}
    attestation = {"platform": unknown, "digest": digest, "mediaType": oci.IMAGE, "size": 1}
    content = {**content, "manifests": [*content["manifests"], attestation]}
    place.registry.put_manifest(base.repository, base.reference, content, oci.INDEX)
    assert list(place.join(str(base), *place.stack()).manifests) == [AMD64]


def test_a_publishing_run_joins_digests_without_a_tag(place: Place) -> None:
    def put(image: Tiny, repository: str) -> Reference:
        return Reference(place.server.address, repository, image.put_manifest(place.registry, repository)[0])

    images = [put(ros(), "me/ros"), *(put(part(kind), "me/part") for kind in TORCH)]
    with Joiner(place.clients.__getitem__) as joiner:
        report = joiner.manifest(images[0], images[1:], place.server.address, "me/mine")
    assert place.registry.tags("me/mine") == []
    assert report.digest == place.join(place.ros(), *place.stack()).manifests[AMD64]


# ---- Layers ----------------------------------------------------------------------------------------------------------


def test_layers_are_copied_where_mounts_are_refused(place: Place) -> None:
    images = [place.ros(), *place.stack()]
    place.server.mounts = False
    report = place.join(*images)
    assert (report.mounted, report.copied) == (0, 4)
    again = place.join(place.ros(salt="2"), *images[1:], tag="two")
    assert (again.copied, again.present) == (1, 3), "what is there is not copied again"
    assert place.server.aborted >= 4


def test_layers_are_copied_from_another_registry(place: Place) -> None:
    with local_registry() as far:
        place.clients[far.address] = Registry(far.address)
        images = [part(kind).put(place.clients[far.address], "x/part", kind) for kind in TORCH]
        far.fault("GET", "/blobs/", DROP, 2)
        before = place.registry.uploaded
        report = place.join(place.ros(), *images)
        assert (report.mounted, report.copied) == (1, 3)
        assert report.uploaded <= place.registry.uploaded - before
        assert not any(line.startswith(("PUT", "POST")) for line in far.requests[-40:] if "/me/" in line)
    layers = place.image(report)[0]["layers"]
    assert all(("me/mine", layer["digest"]) in place.server.blobs for layer in layers)


def test_parts_in_the_same_repository(place: Place) -> None:
    report = place.join(ros().put(place.registry, "me/mine", "ros"), *place.stack(("cuda",)))
    assert (report.present, report.mounted) == (1, 1)


def test_dockers_media_types_become_ocis(place: Place) -> None:
    base = references.parse(place.ros())
    (member,) = place.manifest(base.repository, base.reference).members
    manifest = place.manifest(base.repository, member.digest).content
    docker = "application/vnd.docker.image.rootfs.diff.tar.gzip"
    content = {
        "schemaVersion": 2,
        "mediaType": oci.DOCKER_IMAGE,
        "config": {**manifest["config"], "mediaType": oci.DOCKER_CONFIG},
        "layers": [{**layer, "mediaType": docker} for layer in manifest["layers"]],
    }
    place.registry.put_manifest(base.repository, "docker", content, oci.DOCKER_IMAGE)
    subject = place.manifest(base.repository, "docker").descriptor
    files = gzip.compress(b"usr/bin/env\n")
    place.registry.attach(base.repository, subject, file_lists.ARTIFACT, files, file_lists.MEDIA_TYPE)
    layers = place.image(place.join(str(base._replace(reference="docker")), *place.stack()))[0]["layers"]
    assert {layer["mediaType"] for layer in layers} == {"application/vnd.oci.image.layer.v1.tar+gzip"}


def test_a_connection_that_ends_anywhere_leaves_no_tag(place: Place, monkeypatch: pytest.MonkeyPatch) -> None:
    """Whichever request is the first without an answer, of every third; and the next call finishes it."""
    monkeypatch.setattr(retries, "ATTEMPTS", 1)
    images = [place.ros(), *place.stack()]
    digest = place.join(*images).digest
    due = place.server.due
    for number in itertools.count(step=3):
        requests, repository = itertools.count(), f"me/try{number}"

        def broken(method: str, path: str, requests: Iterator[int] = requests, number: int = number) -> Fault | None:
            return Fault(method, path, DROP) if next(requests) >= number else due(method, path)

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


# ---- The command -----------------------------------------------------------------------------------------------------


def call(capsys: pytest.CaptureFixture[str], *arguments: str) -> tuple[int, str, str]:
    code = command.run(script.main, arguments=arguments)
    return code, *capsys.readouterr()


def test_command(place: Place, capsys: pytest.CaptureFixture[str]) -> None:
    images = [place.ros(), *place.stack()]
    tag = f"{place.server.address}/me/mine:x"
    code, out, err = call(capsys, *images, "--tag", tag)
    assert code == 0 and f"no SBOM for linux/amd64, because none of rosml is attached to {images[0]}, " in err
    lines = out.splitlines()
    assert lines[0] == f"{tag}@{place.registry.head('me/mine', 'x')}"
    assert lines[1] == "linux/amd64: 4 layers (4 mounted)" and "uploaded in" in lines[2]
    code, out, _ = call(capsys, *images, "--tag", tag, "--json", "--platform", AMD64)
    assert (code, json.loads(out)["present"]) == (0, 4)


def test_errors_of_the_command(place: Place, capsys: pytest.CaptureFixture[str]) -> None:
    images, tag = [place.ros(), *place.stack(("common",), "cpu")], f"{place.server.address}/me/mine:x"
    code, out, err = call(capsys, *images, "--tag", tag)
    assert (code, out) == (2, "") and "remedy: add torch-cpu-py311" in err
    images = [place.ros(), *place.stack(("cuda",))]
    place.server.fault("PUT", "/manifests/", 400)
    assert call(capsys, *images, "--tag", tag)[0] == 1
