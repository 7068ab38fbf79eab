"""Facts of images that are attached to them in a registry."""

from __future__ import annotations

import gzip
import json
from collections.abc import Iterator
from typing import Any

import pytest

from fakes.http_registry import LocalRegistry
from rosml.base.errors import RosmlError
from rosml.images.join import facts, file_lists
from rosml.images.join.facts import Facts, Library
from rosml.registry import oci
from rosml.registry.client import Registry

ROS, TORCH, PART = "me/rosml/ros", "me/rosml/ros-torch", "me/rosml/part"
LAYER = "application/vnd.oci.image.layer.v1.tar+gzip"
LIBRARY = {"id": "0" * 40, "path": "a.so", "soname": "", "machine": [2, 1, 62], "needed": [], "symbols": "AAAABBBB"}


@pytest.mark.parametrize(
    "document",
    [
        [],
        {"packages": [{"name": "a"}], "libraries": []},
        {"packages": [], "libraries": [LIBRARY | {"symbols": "AA/A"}]},
        {"packages": [], "libraries": [LIBRARY | {"machine": [2, 1]}]},
        {"packages": [], "libraries": [LIBRARY | {"path": "x" * 5000}]},
        {"packages": [], "libraries": [], "files": [1]},
        {"packages": [], "libraries": [], "x": "x" * 1000},
    ],
)
def test_damaged_facts(document: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    if "x" in document:
        monkeypatch.setattr(facts, "LARGEST", 1000)
    with pytest.raises(RosmlError, match="facts of an image are damaged"):
        facts.parse(gzip.compress(json.dumps(document).encode()))


def test_a_symbol_counts_only_at_its_place() -> None:
    """Four characters of two symbols that follow each other are none."""
    group = facts.hashed("it")
    for text, exported in ((f"A{group}AAA", False), (f"AAAA{group}", True), (f"A{group}AAA{group}", True), ("", False)):
        library = Library.model_validate(LIBRARY | {"symbols": text})
        assert facts.exports(library, "it") is exported
        assert facts.lacking(["it"], [library]) == ([] if exported else ["it"])


@pytest.fixture
def client(server: LocalRegistry) -> Iterator[Registry]:
    with Registry(server.address) as registry:
        yield registry


def put(client: Registry, repository: str, *layers: bytes) -> dict[str, Any]:
    """Puts an image of some layers into a registry. Returns its descriptor."""
    config = oci.encoded({"os": "linux", "architecture": "amd64"})
    for data in (config, *layers):
        client.put_blob(repository, data)
    entries = [oci.descriptor(LAYER, data) for data in layers]
    content = {"mediaType": oci.IMAGE, "config": oci.descriptor(oci.CONFIG, config), "layers": entries}
    document = oci.encoded({"schemaVersion": 2, **content})
    client.put_manifest(repository, "", document, oci.IMAGE)
    return oci.descriptor(oci.IMAGE, document)


def attach(client: Registry, repository: str, subject: dict[str, Any], path: str, *names: str) -> None:
    packages = [{"name": name, "architecture": "all", "version": "1"} for name in names]
    content = {"packages": packages, "libraries": [LIBRARY | {"path": path}], "files": names}
    data = gzip.compress(json.dumps(content).encode(), mtime=0)
    client.attach(repository, subject, facts.ARTIFACT, data, facts.MEDIA_TYPE)


def image(client: Registry, repository: str, name: str, has_facts: bool = True) -> tuple[str, str]:
    """An image whose layer, package and file have a name, with an SBOM. Returns the digests of both."""
    subject = put(client, repository, name.encode())
    if has_facts:
        attach(client, repository, subject, "a.so", name)
    return subject["digest"], client.attach(repository, subject, "application/x", name.encode(), "application/x")


def names(image_facts: Facts | None) -> list[str]:
    return sorted(item.name for item in image_facts.packages) if image_facts else []


def test_the_facts_of_an_image_and_of_a_joined_one(client: Registry) -> None:
    ros, ros_sbom = image(client, ROS, "ros")
    torch, torch_sbom = image(client, PART, "torch")
    _, cuda_sbom = image(client, PART, "cuda")
    joined = put(client, TORCH, b"ros", b"torch")["digest"]
    by_ros = {"io.rosml.sbom.alpha": f"ros@{ros_sbom}"}
    both = by_ros | {"io.rosml.sbom.torch": f"part@{torch_sbom}", "other": "x"}
    assert names(facts.of(client, ROS, ros)) == ["ros"] and facts.of(client, TORCH, joined) is None
    assert facts.components(client, TORCH, joined, both) == [(ROS, ros), (PART, torch)]
    together = facts.of_member(client, TORCH, joined, both)
    assert names(together) == ["ros", "torch"] and together
    assert len(together.libraries) == 1 and together.files == ["ros", "torch"]
    assert facts.components(client, ROS, ros, by_ros) == [(ROS, ros)]
    assert names(facts.of_member(client, ROS, ros, by_ros)) == ["ros"]
    more = (f"ros@sha256:{'0' * 64}", "../x@y", f"part@{cuda_sbom}")
    for others in ({}, by_ros, *(both | {"io.rosml.sbom.more": text} for text in more)):
        assert facts.of_member(client, TORCH, joined, others) is None, "of other layers, too few or nothing"
    assert facts.of_member(client, ROS, f"sha256:{'0' * 64}", both) is None


def test_a_part_without_facts_makes_an_image_without_facts(client: Registry) -> None:
    """It would look like an image that lacks what the part has."""
    _, ros_sbom = image(client, ROS, "ros")
    _, torch_sbom = image(client, PART, "torch", has_facts=False)
    joined = put(client, TORCH, b"ros", b"torch")["digest"]
    annotations = {"io.rosml.sbom.alpha": f"ros@{ros_sbom}", "io.rosml.sbom.torch": f"part@{torch_sbom}"}
    assert len(facts.components(client, TORCH, joined, annotations)) == 2
    assert facts.of_member(client, TORCH, joined, annotations) is None


def test_facts_of_several_publishers_count_together(client: Registry, monkeypatch: pytest.MonkeyPatch) -> None:
    subject = put(client, ROS, b"ros")
    attach(client, ROS, subject, "a.so", "ros")
    attach(client, ROS, subject, "b.so")
    together = facts.of(client, ROS, subject["digest"])
    assert names(together) == ["ros"]
    assert together and sorted(item.path for item in together.libraries) == ["a.so", "b.so"]
    monkeypatch.setattr(file_lists, "ATTACHED", 1)
    with pytest.raises(RosmlError, match="2 documents of facts"):
        facts.of(client, ROS, subject["digest"])
