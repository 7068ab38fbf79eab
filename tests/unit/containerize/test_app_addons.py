"""Add-ons on the base image of an app: which parts, and what the builder gets. Real ones: tests/e2e/test_addons.py."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from rebasing import BOTH, Place, moving

from rosml.base.errors import RosmlError
from rosml.containerize import addons, app_base
from rosml.containerize.app_base import Base
from rosml.images.join.joiner import Joiner
from tests.e2e.parts import part, stack

CPU = {"common-cpu-py311": "common", "graph-cc-cpu": "graph-cc", "graph-cpu-py311": "graph"}


@pytest.fixture
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Place]:
    with moving(tmp_path, monkeypatch) as found:
        for tag, kind in CPU.items():
            part(kind, "cpu").put(found.registry, "rosml/part", tag, BOTH)
        yield found


def plain(place: Place) -> Base:
    return app_base.find(place.base(), place.services, BOTH)


def with_stack(place: Place, *parts: str, name: str = "cpu") -> Base:
    with Joiner(lambda _: place.registry) as joiner:
        found = joiner.join(
            place.base(), stack(place.registry, "rosml/part", parts, name), f"{place.server.address}/rosml/ros-x:x"
        )
    return app_base.find(found.reference, place.services, BOTH[:1])


def test_parts_are_joined_in_their_order_by_digest(place: Place) -> None:
    found = addons.onto(plain(place), "graph-cpu", place.services, BOTH).addons
    assert found
    assert [name.rpartition(":")[2] for name in found.parts] == [*CPU]
    for tag, reference in zip(CPU, found.parts.values(), strict=True):
        digest = place.registry.head("rosml/part", tag)
        assert reference == f"{place.server.address}/rosml/part@{digest}"
    assert found.environment == {"GRAPH_VERSION": "1.23.2"}
    assert found.labels["io.rosml.addons"] == "graph" and found.labels["io.rosml.parts"] == "common graph-cc graph"
    assert found.dockerfile("without").splitlines() == [
        "FROM without",
        *(f"COPY --link --from=part-{number} / /" for number in range(3)),
        'ENV GRAPH_VERSION="1.23.2"',
    ]


def test_only_what_the_base_image_lacks_is_joined(place: Place) -> None:
    base = with_stack(place, "common", "torch")
    found = addons.onto(base, " graph, graph", place.services, BOTH[:1]).addons
    assert found and [name.rpartition(":")[2] for name in found.parts] == [*CPU][1:]
    assert found.labels["org.opencontainers.image.title"] == "ros1-bookworm-core-torch-graph-cpu"


def test_a_base_image_that_has_the_addon_stays(place: Place) -> None:
    base = with_stack(place, "common", "graph-cc", "graph")
    assert addons.onto(base, "graph", place.services, BOTH[:1]) is base


def test_a_lock_decides_which_parts(place: Place) -> None:
    base = plain(place)
    before = addons.onto(base, "graph-cpu", place.services, BOTH).addons
    assert before
    known = {name: reference.rpartition("@")[2] for name, reference in before.parts.items()}
    part("graph", "cpu", salt="tonight").put(place.registry, "rosml/part", "graph-cpu-py311", BOTH)
    now, locked = (addons.onto(base, "graph-cpu", place.services, BOTH, said).addons for said in (None, known))
    assert locked == before != now


def test_without_addons_nothing_is_asked(place: Place) -> None:
    base = Base("nowhere.invalid/x", "", {})
    assert addons.onto(base, " ", place.services, BOTH) is base


@pytest.mark.parametrize(
    ("wanted", "says", "remedy"),
    [
        ("onnx", "there is no add-on onnxruntime: neither", "ros:core has no stack: name one, such as onnx-cpu"),
        ("onnx-cu130", "there is no add-on onnxruntime-cu130: neither", "ros1-bookworm-core-onnx-cu130' says"),
        ("graphx-cpu", "there is no add-on graphx-cpu: neither", "no add-on named 'graphx-cpu'; known: onnx"),
        ("common-cpu", "common-cpu-py311 is no add-on", "such as onnx"),
        ("../x", "'../x' is no name", "such as onnx"),
    ],
)
def test_what_is_no_addon(wanted: str, says: str, remedy: str, place: Place) -> None:
    with pytest.raises(RosmlError) as caught:
        addons.onto(plain(place), wanted, place.services, BOTH)
    assert says in caught.value.message and remedy in caught.value.remedy and caught.value.exit_code == 2


@pytest.mark.parametrize(
    ("base", "says"),
    [
        (Base("robot", "sha256:0", {}, labels={"io.rosml.python": "3.11"}, local=True), "robot is in Docker alone"),
        (Base("docker.io/library/ubuntu:24.04", "sha256:0", {}), "is none of rosml's images"),
    ],
)
def test_a_base_image_that_takes_none(base: Base, says: str, place: Place) -> None:
    with pytest.raises(RosmlError, match=says):
        addons.onto(base, "graph", place.services, BOTH)
