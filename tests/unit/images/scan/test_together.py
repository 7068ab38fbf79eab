"""SBOMs of images that are joined in a registry, or built on one: each component says whose it is."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import replace
from functools import partial
from pathlib import Path

import pytest

from fakes.joins import AMD64, Place, joining
from fakes.memory_registry import packages_of, sbom_of
from rosml.images.image_set import labels
from rosml.images.join.joiner import Joiner
from rosml.images.scan import attached, cyclonedx, together
from rosml.images.scan.sbom import FORMAT, MEDIA_TYPE
from rosml.registry import references
from tests.e2e.parts import part, ros

CUDA = "cuda-cu128"


@pytest.fixture
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Place]:
    with joining(tmp_path, monkeypatch) as place:
        yield place


def sbom(place: Place, image: str, *names: str, system: str = "") -> str:
    """Attaches an SBOM to the image of an index. Returns the image."""
    where = references.parse(image)
    (member,) = place.manifest(where.repository, where.reference).members
    document = sbom_of(f"{where.host}/{where.repository}@{member.digest}", names, system)
    subject = place.manifest(where.repository, member.digest).descriptor
    place.registry.attach(where.repository, subject, MEDIA_TYPE, document, MEDIA_TYPE, FORMAT)
    return image


def base(place: Place) -> str:
    image = replace(ros(), labels={**ros().labels, labels.TITLE: "core"})
    return sbom(place, image.put(place.registry, "me/ros", "core"), "bash", "libc6", system="12")


def join(place: Place, *images: str, tag: str) -> str:
    describe = partial(together.attach, place.clients.__getitem__, place.lines.append)
    target = f"{place.server.address}/me/mine:{tag}"
    with Joiner(place.clients.__getitem__, describe=describe) as joiner:
        return f"{target}@{joiner.join(images[0], images[1:], target).digest}"


def owners(place: Place, image: str) -> dict[str, str]:
    """The part of each component of the SBOM of a joined image; empty if it has none."""
    where = references.parse(image)
    (member,) = place.manifest(where.repository, where.reference).members
    sboms = attached.read(place.registry, where.repository, member.digest).sboms
    components = [component for item in sboms for component in json.loads(item.content)["components"]]
    return {component["name"]: cyclonedx.part(component) for component in components}


def test_a_join_has_the_sboms_of_what_it_was_joined_from(place: Place) -> None:
    """Also if that was joined before, and each time the same."""
    cuda = sbom(place, place.put(part("cuda", "cu128"), "cuda"), "nvcc-runtime")
    graph = sbom(place, place.put(part("devel", "cu128"), "devel"), "nvcc")
    first = join(place, base(place), cuda, tag="cuda")
    names = {"debian": "core", "bash": "core", "libc6": "core", "nvcc-runtime": CUDA}
    assert owners(place, first) == names and place.lines == []
    both = join(place, first, graph, tag="both")
    assert owners(place, both) == names | {"nvcc": "devel-cu128"}
    pushed = len(place.server.manifests)
    assert join(place, first, graph, tag="both") == both and len(place.server.manifests) == pushed


def test_a_join_with_an_image_without_an_sbom_has_none(place: Place) -> None:
    """It would look as if the image had nothing more."""
    cuda = place.put(part("cuda", "cu128"), "cuda")
    assert owners(place, join(place, base(place), cuda, tag="x")) == {}
    assert place.lines == [f"no SBOM for {AMD64}, because none of rosml is attached to {cuda}"]


def test_whose_a_component_of_an_app_is(place: Place) -> None:
    """By the SBOMs of its base image and the add-ons on it; nobody knows if one is missing, is for another platform, or is gone."""
    images = [base(place), sbom(place, place.put(part("cuda", "cu128"), "cuda"), "nvcc-runtime")]
    read = partial(together.parts, place.clients.__getitem__)
    parts = {
        "debian-12": "core",
        "apt:bash:amd64@1.0": "core",
        "apt:libc6:amd64@1.0": "core",
        "pypi:nvcc-runtime@1.0": CUDA,
    }
    assert read(images, AMD64) == parts
    assert read([*images, place.put(part("devel", "cu128"), "devel")], AMD64) == {}
    assert read(images, "linux/arm64") == {} and read([f"{place.server.address}/me/gone:x"], AMD64) == {}
    document = json.loads(cyclonedx.document(packages_of(("bash", "tree"), "12"), "me/app@sha256:0", parts=parts))
    whose = {component["name"]: cyclonedx.part(component) for component in document["components"]}
    assert whose == {"debian": "core", "bash": "core", "tree": cyclonedx.APP}
