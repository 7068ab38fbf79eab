"""Add-ons on the base image of an app: which parts, and what the builder gets. Real ones: tests/e2e/test_addons.py."""

from __future__ import annotations

import json
import re
import shlex
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest
from click.testing import CliRunner

from fakes.rebasing import BOTH, Place, moving
from rosml.base.errors import RosmlError
from rosml.cli.images import explain, join
from rosml.containerize import lock
from rosml.containerize.base_image import addons
from rosml.containerize.base_image import base as app_base
from rosml.containerize.base_image.base import AddOns, Base
from rosml.containerize.build import app as build
from rosml.images.join.joiner import Joiner
from rosml.machine.services import Services
from tests.e2e.parts import Tiny, part, ros, stack

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


NOWHERE = "neither {host}/rosml/part:{part}-py311 nor {host}/rosml/part:{part}"


@pytest.mark.parametrize(
    ("wanted", "says", "remedy"),
    [
        ("onnx", "ros:core has no stack, so the add-on needs one", "--addons onnx-cu128, onnx-cu130 or onnx-cu132"),
        ("onnx-gpu", "no stack named 'gpu'", "--addons onnx-cu128, onnx-cu130 or onnx-cu132"),
        ("devel-cu128", "part devel is for CUDA 13, and stack cu128 has", "--addons devel-cu130 or devel-cu132"),
        ("graphx-cpu", f"there is no add-on graphx-cpu: {NOWHERE}", "no add-on named 'graphx-cpu'; known: onnx"),
        ("common-cpu", "common-cpu-py311 is no add-on", "such as onnx"),
        ("../x", "'../x' is no name", "such as onnx"),
        ("x" * 300, "is no name", "such as onnx"),
        ("triton-cpu", f"there is no add-on triton-cpu: {NOWHERE}",
         "build it: rosml part common-cpu-py311 grpc-cpu-py311 tritonclient-cpu-py311"),
    ],
)  # fmt: skip
def test_what_is_no_addon(wanted: str, says: str, remedy: str, place: Place) -> None:
    says = says.format(host=place.server.address, part=wanted.replace("triton-", "tritonclient-"))
    with pytest.raises(RosmlError) as caught:
        addons.onto(plain(place), wanted, place.services, BOTH)
    assert says in caught.value.message and remedy in caught.value.remedy and caught.value.exit_code == 2


@pytest.mark.parametrize(
    ("repository", "parts", "local", "remedy"),
    [
        ("team/ros", "team/part", True, "tritonclient-cpu-py311 --namespace team"),
        ("team/ros", "team/part", False,
         "rosml publish all --registry {host}/team --only ros1-bookworm-core-triton-cpu --serve amd64 --serve arm64"),
        ("team/robot", "", False,
         "rosml join {host}/team/robot:1 <registry>/part:common-cpu-py311 <registry>/part:grpc-cpu-py311 "
         "<registry>/part:tritonclient-cpu-py311 --tag {host}/team/robot:1-with-addons --allow-unlisted"),
    ],
)  # fmt: skip
def test_how_parts_get_beside_a_base_image(repository: str, parts: str, local: bool, remedy: str, place: Place) -> None:
    ros().put(place.registry, repository, "1", BOTH)
    if parts:
        part("common", "cpu").put(place.registry, parts, "common-cpu-py311", BOTH)
    services = place.services if local else replace(place.services, registry="")
    base = app_base.find(f"{place.server.address}/{repository}:1", services, BOTH)
    with pytest.raises(RosmlError) as caught:
        addons.onto(base, "triton-cpu", services, BOTH)
    assert remedy.format(host=place.server.address) in caught.value.remedy


def test_an_addon_that_the_systems_of_a_distribution_break(place: Place) -> None:
    """The part is for any Python, and does not say where its compiler works."""
    for kind in ("cuda", "devel"):
        part(kind, "cu130").put(place.registry, "rosml/part", f"{kind}-cu130", BOTH)
    ros("lyrical", python="3.14").put(place.registry, "rosml/ros", "lyrical-core", BOTH)
    base = app_base.find("ros:lyrical-core", place.services, BOTH)
    with pytest.raises(RosmlError, match="add-on devel of stack cu130 works on bookworm") as caught:
        addons.onto(base, "devel-cu130", place.services, BOTH)
    assert caught.value.remedy == "name a stack that has it: --addons devel-cu132"


def test_an_image_that_has_the_addon_needs_no_parts_beside_it(place: Place) -> None:
    base = with_stack(place, "common", "graph-cc", "graph")
    elsewhere = replace(base, name=f"{place.server.address}/robot:1")
    for name in ("graph", "graph-cpu"):
        assert addons.onto(elsewhere, name, place.services, BOTH[:1]) is elsewhere


def test_an_image_without_a_list_of_files_is_joined_by_a_command(place: Place) -> None:
    ros(unlisted=True).put(place.registry, "rosml/robot", "1", BOTH)
    base = app_base.find(f"{place.server.address}/rosml/robot:1", place.services, BOTH)
    with pytest.raises(RosmlError, match=r"rosml/robot:1@sha256:\w+ has no list of its files") as caught:
        addons.onto(base, "graph-cpu", place.services, BOTH)
    assert caught.value.remedy.startswith("add them in its Dockerfile (docs/addons.md); or join them")
    words = shlex.split(caught.value.remedy.partition("rosml join ")[2])
    done = CliRunner().invoke(join.main, words)
    assert done.exit_code == 0, done.output
    again = app_base.find(words[words.index("--tag") + 1], place.services, BOTH)
    assert addons.onto(again, "graph", place.services, BOTH) is again


def test_an_app_without_a_list_of_files(place: Place) -> None:
    base = app_base.find(place.app(place.base()), place.services, BOTH[:1])
    with pytest.raises(RosmlError, match="has no list of its files") as caught:
        addons.onto(base, "graph-cpu", place.services, BOTH[:1])
    assert caught.value.remedy.startswith("take the app's run image, built without --no-sbom; or join them")


@pytest.mark.parametrize(
    ("said", "why"),
    [
        ({"part": "graph-cc"}, "graph-cpu-py311 is no such part: its labels say graph-cc cpu 3.11"),
        ({"stack": "cu128"}, "graph-cpu-py311 is no such part: its labels say graph cu128 3.11"),
        ({"addons": "graph=../../x,graph"}, "its label io.rosml.addons is damaged"),
    ],
)
def test_a_part_that_is_another_one(said: dict[str, str], why: str, place: Place) -> None:
    own = part("graph", "cpu")
    other = replace(own, labels={**own.labels, **{f"io.rosml.{name}": value for name, value in said.items()}})
    other.put(place.registry, "rosml/part", "graph-cpu-py311", BOTH)
    with pytest.raises(RosmlError, match=re.escape(why)):
        addons.onto(plain(place), "graph-cpu", place.services, BOTH)


def test_a_part_for_no_platform(place: Place) -> None:
    part("graph", "cpu").put(place.registry, "rosml/part", "graph-cpu-py311", ())
    with pytest.raises(RosmlError, match="graph-cpu-py311 is for no platform"):
        addons.onto(plain(place), "graph-cpu", place.services, BOTH)


def test_a_digest_of_a_lock_file_that_is_gone(place: Place) -> None:
    tag = f"{place.server.address}/rosml/part:graph-cpu-py311"
    with pytest.raises(RosmlError, match="of the lock file") as caught:
        addons.onto(plain(place), "graph-cpu", place.services, BOTH, {tag: f"sha256:{'0' * 64}"})
    assert caught.value.remedy == lock.RENEW


SLIM = Base("slim", "sha256:1", {}, addons=AddOns({"part:common": "x", "part:graph": "x"}, {}, {}))
NONE = Base("base", "sha256:0", {})
PIN = lock.Image(name="", digest=f"sha256:{'0' * 64}")


@pytest.mark.parametrize(
    ("known", "wanted", "base", "slim", "fits"),
    [
        (["part:common", "part:graph"], "graph", SLIM, None, True),
        (["part:common", "part:graph"], "graph", NONE, SLIM, True),  # the base image has them already
        (["part:common", "part:graph"], "graph", NONE, None, True),  # without the slim image, this time
        (["part:common", "part:graph"], "", NONE, None, False),
        (["part:common"], "graph", SLIM, None, False),
        ([], "graph", NONE, SLIM, False),
    ],
)
def test_a_lock_file_of_the_same_addons(
    known: list[str], wanted: str, base: Base, slim: Base | None, fits: bool
) -> None:
    digests = dict.fromkeys(known, PIN.digest)
    locked = lock.Lock(base_image=PIN, slim_base_image=PIN, addons=digests or None)
    if fits:
        build.require_locked(locked, wanted, base, slim)
        return
    with pytest.raises(RosmlError, match="the lock file is of"):
        build.require_locked(locked, wanted, base, slim)


def test_a_lock_file_of_thousands(place: Place) -> None:
    locked = lock.Lock(base_image=PIN, addons={f"part:p{number}": PIN.digest for number in range(5000)})
    with pytest.raises(RosmlError) as caught:
        build.require_locked(locked, "", NONE, None)
    assert len(caught.value.message) < 200 and caught.value.remedy == lock.RENEW


def explained(place: Place, monkeypatch: pytest.MonkeyPatch, *words: str) -> tuple[int, str]:
    monkeypatch.setattr(Services, "load", lambda *_, **__: place.services)
    done = CliRunner().invoke(explain.main, [*words])
    if isinstance(done.exception, RosmlError):
        return done.exception.exit_code, done.exception.message
    return done.exit_code, done.stdout


def test_explain_asks_the_registry_about_an_image(place: Place, monkeypatch: pytest.MonkeyPatch) -> None:
    own, host = place.base(), place.server.address
    code, text = explained(place, monkeypatch, own, "--addons", "graph-cpu")
    assert code == 0 and f"{own} can have graph-cpu:\n" in text
    assert f"rosml containerize --base-image {own} --addons graph-cpu\n" in text
    every = "{common-cpu-py311,graph-cc-cpu,graph-cpu-py311}"
    assert f"rosml join {own} {host}/rosml/part:{every} --tag {own}-with-graph-cpu\n" in text
    has = f"{host}/rosml/ros-x:x"
    with_stack(place, "common", "graph-cc", "graph")
    assert explained(place, monkeypatch, has, "--addons", "graph") == (0, f"{has} has graph already\n")
    code, text = explained(place, monkeypatch, has, "--addons", "onnx-cu130")
    assert code == 0 and "is of stack cpu, and takes no add-on of cu130; name it without a stack: --addons onnx" in text


def test_explain_tells_what_is_none_of_ours(place: Place, monkeypatch: pytest.MonkeyPatch) -> None:
    Tiny({}).put(place.registry, "ubuntu", "24.04")
    name = f"{place.server.address}/ubuntu:24.04"
    code, text = explained(place, monkeypatch, name, "--addons", "onnx-cpu", "--json")
    assert code == 0 and json.loads(text)["exists"] is False and "is none of rosml's images" in text
    code, text = explained(place, monkeypatch, f"{name}x", "--addons", "onnx-cpu")
    assert code == 2 and "there is no image" in text
    code, text = explained(place, monkeypatch, "ros:jazzy-base", "--addons", "onnx-cpu")
    assert code == 0 and "ros:jazzy-base can have onnx-cpu" in text, "the matrix has it"
    unpublished = f"{place.server.address}/rosml/ros:jazzy-base"
    code, text = explained(place, monkeypatch, unpublished, "--addons", "onnx-cpu")
    assert code == 0 and f"{unpublished} can have onnx-cpu" in text


@pytest.mark.parametrize(
    ("base", "says"),
    [
        (Base("robot", "sha256:0", {}, labels={"io.rosml.python": "3.11"}, local=True), "robot is in Docker alone"),
        (Base("docker.io/library/ubuntu:24.04", "sha256:0", {}), "is none of rosml's images"),
        (
            Base("x/y:1", "sha256:0", {}, labels={"io.rosml.python": "3.11", "io.rosml.parts": "a a"}),
            "its label io.rosml.parts is damaged",
        ),
    ],
)
def test_a_base_image_that_takes_none(base: Base, says: str, place: Place) -> None:
    with pytest.raises(RosmlError, match=says):
        addons.onto(base, "graph", place.services, BOTH)
