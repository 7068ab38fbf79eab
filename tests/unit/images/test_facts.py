"""Facts of images that are attached to them in a registry."""

from __future__ import annotations

import gzip
import json
from typing import Any

import pytest

from fakes.http_registry import StandIn
from rosml.base.errors import RosmlError
from rosml.images.join import facts
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
        {"packages": []},
        {"packages": [{"name": "a"}], "libraries": []},
        {"packages": [], "libraries": [LIBRARY | {"symbols": "AAA"}]},
        {"packages": [], "libraries": [LIBRARY | {"symbols": "AA/A"}]},
        {"packages": [], "libraries": [LIBRARY | {"machine": [2, 1]}]},
        {"packages": [], "libraries": [LIBRARY | {"path": "x" * 5000}]},
        {"packages": [], "libraries": [], "files": [1]},
    ],
)
def test_damaged_facts(document: Any) -> None:
    with pytest.raises(RosmlError, match="facts of an image are damaged") as caught:
        facts.parse(gzip.compress(json.dumps(document).encode()))
    assert caught.value.remedy


def test_facts_that_are_too_large(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(facts, "LARGEST", 1000)
    with pytest.raises(RosmlError, match="damaged"):
        facts.parse(gzip.compress(json.dumps({"packages": [], "libraries": [], "x": "x" * 1000}).encode()))


def test_a_symbol_stands_only_at_its_place() -> None:
    """Four characters of two symbols that follow each other are none."""
    group = facts.hashed("it")
    for text, found in ((f"A{group}AAA", False), (f"AAAA{group}", True), (f"A{group}AAA{group}", True), ("", False)):
        library = Library.model_validate(LIBRARY | {"symbols": text})
        assert facts.exports(library, "it") is found and facts.lacking(["it"], [library]) == ([] if found else ["it"])


def put(client: Registry, repository: str, *layers: bytes) -> dict[str, Any]:
    """Puts an image of some layers into a registry; gives its descriptor."""
    config = oci.encoded({"os": "linux", "architecture": "amd64"})
    for data in (config, *layers):
        client.put_blob(repository, data)
    entries = [oci.descriptor(LAYER, data) for data in layers]
    content = {"mediaType": oci.IMAGE, "config": oci.descriptor(oci.CONFIG, config), "layers": entries}
    document = oci.encoded({"schemaVersion": 2, **content})
    client.put_manifest(repository, "", document, oci.IMAGE)
    return oci.descriptor(oci.IMAGE, document)


def attached(client: Registry, repository: str, name: str, has_facts: bool = True) -> tuple[str, str]:
    """An image whose layer, package and file have a name, and what stands for its SBOM; the digests of both."""
    subject = put(client, repository, name.encode())
    said = {
        "packages": [{"name": name, "architecture": "all", "version": "1"}],
        "libraries": [LIBRARY],
        "files": [name],
    }
    if has_facts:
        data = gzip.compress(json.dumps(said).encode(), mtime=0)
        client.attach(repository, subject, facts.ARTIFACT, data, facts.MEDIA_TYPE)
    return subject["digest"], client.attach(repository, subject, "application/x", name.encode(), "application/x")


def names(found: Facts | None) -> list[str]:
    return sorted(item.name for item in found.packages) if found else []


def test_the_facts_of_an_image_and_of_a_joined_one(stand_in: StandIn) -> None:
    with Registry(stand_in.address) as client:
        ros, ros_sbom = attached(client, ROS, "ros")
        torch, torch_sbom = attached(client, PART, "torch")
        _, cuda_sbom = attached(client, PART, "cuda")
        joined = put(client, TORCH, b"ros", b"torch")["digest"]
        by_ros = {"io.rosml.sbom.alpha": f"ros@{ros_sbom}"}
        said = by_ros | {"io.rosml.sbom.torch": f"part@{torch_sbom}", "other": "x"}
        assert names(facts.of(client, ROS, ros)) == ["ros"] and facts.of(client, TORCH, joined) is None
        assert facts.components(client, TORCH, joined, said) == [(ROS, ros), (PART, torch)]
        found = facts.of_member(client, TORCH, joined, said)
        assert names(found) == ["ros", "torch"] and found
        assert len(found.libraries) == 1 and found.files == ["ros", "torch"]
        assert facts.components(client, ROS, ros, by_ros) == [(ROS, ros)]
        assert names(facts.of_member(client, ROS, ros, by_ros)) == ["ros"]
        # What the annotations do not say, or say of other layers or of nothing, is not known.
        nothing = f"ros@sha256:{'0' * 64}"
        for more in (nothing, "../x@y", f"part@{cuda_sbom}"):
            assert facts.of_member(client, TORCH, joined, said | {"io.rosml.sbom.more": more}) is None
        for less in ({}, by_ros):
            assert facts.of_member(client, TORCH, joined, less) is None
        assert facts.of_member(client, ROS, f"sha256:{'0' * 64}", said) is None


def test_a_part_without_facts_makes_an_image_without_facts(stand_in: StandIn) -> None:
    """It would look like an image that lacks what the part has."""
    with Registry(stand_in.address) as client:
        _, ros_sbom = attached(client, ROS, "ros")
        _, torch_sbom = attached(client, PART, "torch", has_facts=False)
        joined = put(client, TORCH, b"ros", b"torch")["digest"]
        said = {"io.rosml.sbom.alpha": f"ros@{ros_sbom}", "io.rosml.sbom.torch": f"part@{torch_sbom}"}
        assert len(facts.components(client, TORCH, joined, said)) == 2
        assert facts.of_member(client, TORCH, joined, said) is None


def test_facts_of_several_publishers_count_together(stand_in: StandIn, monkeypatch: pytest.MonkeyPatch) -> None:
    with Registry(stand_in.address) as client:
        digest, _ = attached(client, ROS, "ros")
        manifest = client.manifest(ROS, digest)
        assert manifest
        data = gzip.compress(json.dumps({"packages": [], "libraries": [LIBRARY | {"path": "b.so"}]}).encode())
        client.attach(ROS, manifest.descriptor, facts.ARTIFACT, data, facts.MEDIA_TYPE)
        found = facts.of(client, ROS, digest)
        assert names(found) == ["ros"] and found and sorted(item.path for item in found.libraries) == ["a.so", "b.so"]
        monkeypatch.setattr(facts, "ATTACHED", 1)
        with pytest.raises(RosmlError, match="facts from 2 publishers"):
            facts.of(client, ROS, digest)
