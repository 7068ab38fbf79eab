"""Facts of images that are attached to them in a registry."""

from __future__ import annotations

import gzip
import json
from typing import Any

import pytest
from registry_stand_in import StandIn

from rosml.base.errors import RosmlError
from rosml.images.join import facts
from rosml.images.join.facts import Facts, Library
from rosml.registry import oci
from rosml.registry.client import Registry

DIGEST = f"sha256:{'1' * 64}"
ROS, TORCH = "me/rosml/ros", "me/rosml/ros-torch"
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


def attached(client: Registry, repository: str, number: int, **more: object) -> tuple[str, str]:
    """An image with facts that name its number, and an artifact that has the place of its SBOM; the digests of both."""
    config = oci.encoded({"os": "linux", "architecture": "amd64", "created": str(number)})
    client.put_blob(repository, config)
    content = {"schemaVersion": 2, "mediaType": oci.IMAGE, "config": oci.descriptor(oci.CONFIG, config), "layers": []}
    digest = client.put_manifest(repository, "", content)
    subject = oci.descriptor(oci.IMAGE, oci.encoded(content))
    package = {"name": f"p{number}", "architecture": "all", "version": "1"}
    said = {"packages": [package], "libraries": [LIBRARY], **more}
    client.attach(
        repository, subject, facts.ARTIFACT, gzip.compress(json.dumps(said).encode(), mtime=0), facts.MEDIA_TYPE
    )
    return digest, client.attach(repository, subject, "application/vnd.cyclonedx+json", b"{}", "application/json")


def names(found: Facts | None) -> list[str]:
    return sorted(item.name for item in found.packages) if found else []


def test_the_facts_of_an_image_and_of_a_joined_one(stand_in: StandIn) -> None:
    with Registry(stand_in.address) as client:
        ros, ros_sbom = attached(client, ROS, 1)
        torch, torch_sbom = attached(client, "me/rosml/part", 2, files=["a"])
        config = oci.encoded({"os": "linux", "architecture": "amd64"})
        client.put_blob(TORCH, config)
        joined = client.put_manifest(
            TORCH,
            "",
            {"schemaVersion": 2, "mediaType": oci.IMAGE, "config": oci.descriptor(oci.CONFIG, config), "layers": []},
        )
        said = {"io.rosml.sbom.alpha": f"ros@{ros_sbom}", "io.rosml.sbom.torch": f"part@{torch_sbom}", "other": "x"}
        assert names(facts.of(client, ROS, ros)) == ["p1"] and facts.of(client, TORCH, joined) is None
        assert facts.components(client, TORCH, said) == [(ROS, ros), ("me/rosml/part", torch)]
        found = facts.of_member(client, TORCH, joined, said)
        assert names(found) == ["p1", "p2"] and found and len(found.libraries) == 1 and found.files == ["a"]
        assert names(facts.of_member(client, ROS, ros, {"io.rosml.sbom.alpha": f"ros@{ros_sbom}"})) == ["p1"]
        # What the annotations do not say, or say of nothing that is there, is not known.
        for wrong in ({}, {"io.rosml.sbom.a": f"ros@sha256:{'0' * 64}"}, {"io.rosml.sbom.a": "../x@y"}):
            assert facts.of_member(client, TORCH, joined, said | wrong if wrong else {}) is None
        assert facts.of_member(client, ROS, f"sha256:{'0' * 64}", {}) is None


def test_a_part_without_facts_makes_an_image_without_facts(stand_in: StandIn) -> None:
    """It would look like an image that lacks what the part has."""
    with Registry(stand_in.address) as client:
        _, with_facts = attached(client, ROS, 1)
        content = {"schemaVersion": 2, "mediaType": oci.IMAGE, "layers": []}
        client.put_manifest("me/rosml/part", "", content)
        part = oci.descriptor(oci.IMAGE, oci.encoded(content))
        without = client.attach("me/rosml/part", part, "application/vnd.cyclonedx+json", b"{}", "application/json")
        said = {"io.rosml.sbom.alpha": f"ros@{with_facts}", "io.rosml.sbom.torch": f"part@{without}"}
        assert len(facts.components(client, TORCH, said)) == 2
        assert facts.of_member(client, TORCH, DIGEST, said) is None


def test_facts_of_several_publishers_count_together(stand_in: StandIn, monkeypatch: pytest.MonkeyPatch) -> None:
    with Registry(stand_in.address) as client:
        digest, _ = attached(client, ROS, 1)
        manifest = client.manifest(ROS, digest)
        assert manifest
        data = gzip.compress(json.dumps({"packages": [], "libraries": [LIBRARY | {"path": "b.so"}]}).encode())
        client.attach(ROS, manifest.descriptor, facts.ARTIFACT, data, facts.MEDIA_TYPE)
        found = facts.of(client, ROS, digest)
        assert names(found) == ["p1"] and found and sorted(item.path for item in found.libraries) == ["a.so", "b.so"]
        monkeypatch.setattr(facts, "ATTACHED", 1)
        with pytest.raises(RosmlError, match="facts from 2 publishers"):
            facts.of(client, ROS, digest)
