"""Add-ons on the base image of an app: which parts, and what the builder gets. Real ones: tests/e2e/test_addons.py."""

from __future__ import annotations

import json
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
from rosml.containerize.build import verdict
from rosml.containerize.inputs import Values
from rosml.images.join.joiner import Joiner
from rosml.machine.services import Services
from tests.e2e.parts import Tiny, part, ros, stack

CPU = {"common-cpu-py311": "common", "graph-cc-cpu": "graph-cc", "graph-cpu-py311": "graph"}


@pytest.fixture
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Place]:
    with moving(tmp_path, monkeypatch) as place:
        for tag, kind in CPU.items():
            part(kind, "cpu").put(place.registry, "rosml/part", tag, BOTH)
        yield place


def plain(place: Place) -> Base:
    return app_base.find(place.base(), place.services, BOTH)


def with_parts(place: Place, *parts: str) -> Base:
    parts_of_stack = stack(place.registry, "rosml/part", parts, "cpu")
    with Joiner(lambda _: place.registry) as joiner:
        image = joiner.join(place.base(), parts_of_stack, f"{place.server.address}/rosml/ros-x:x")
    return app_base.find(image.reference, place.services, BOTH[:1])


def refusal(
    place: Place, base: Base, text: str, locked: dict[str, str] | None = None, platforms: tuple[str, ...] = BOTH
) -> RosmlError:
    with pytest.raises(RosmlError) as caught:
        addons.onto(base, text, place.services, platforms, locked)
    return caught.value


def test_parts_are_joined_in_their_order_by_digest(place: Place) -> None:
    joined = addons.onto(plain(place), "graph-cpu", place.services, BOTH).addons
    assert joined
    repository = f"{place.server.address}/rosml/part"
    digests = {f"{repository}:{tag}": f"{repository}@{place.registry.head('rosml/part', tag)}" for tag in CPU}
    assert [*joined.parts.items()] == [*digests.items()]
    assert joined.environment == {"GRAPH_VERSION": "1.23.2"}
    assert joined.labels["io.rosml.addons"] == "graph" and joined.labels["io.rosml.parts"] == "common graph-cc graph"
    assert joined.dockerfile("without").splitlines() == [
        "FROM without",
        *(f"COPY --link --from=part-{number} / /" for number in range(3)),
        'ENV GRAPH_VERSION="1.23.2"',
    ]


def test_only_parts_that_the_base_image_lacks_are_joined(place: Place) -> None:
    joined = addons.onto(with_parts(place, "common", "torch"), " graph, graph", place.services, BOTH[:1]).addons
    assert joined and [name.rpartition(":")[2] for name in joined.parts] == [*CPU][1:]
    assert joined.labels["org.opencontainers.image.title"] == "ros1-bookworm-core-torch-graph-cpu"
    whole = with_parts(place, "common", "graph-cc", "graph")
    elsewhere = replace(whole, name=f"{place.server.address}/robot:1")  # with no parts beside it
    for base, text in ((whole, "graph"), (elsewhere, "graph-cpu"), (Base("nowhere.invalid/x", "", {}), " ")):
        assert addons.onto(base, text, place.services, BOTH[:1]) is base


def test_a_lock_decides_which_parts(place: Place) -> None:
    base = plain(place)
    first = addons.onto(base, "graph-cpu", place.services, BOTH).addons
    assert first
    digests = {name: reference.rpartition("@")[2] for name, reference in first.parts.items()}
    part("graph", "cpu", salt="tonight").put(place.registry, "rosml/part", "graph-cpu-py311", BOTH)
    newest, locked = (addons.onto(base, "graph-cpu", place.services, BOTH, pins).addons for pins in (None, digests))
    assert locked == first != newest
    tag = f"{place.server.address}/rosml/part:graph-cpu-py311"
    error = refusal(place, base, "graph-cpu", {tag: f"sha256:{'0' * 64}"})
    assert "of the lock file" in error.message and error.remedy == lock.RENEW


NOWHERE = "neither {host}/rosml/part:{part}-py311 nor {host}/rosml/part:{part}"


@pytest.mark.parametrize(
    ("name", "text", "remedy"),
    [
        ("onnx", "ros:core has no stack, so the add-on needs one", "--addons onnx-cu128, onnx-cu130 or onnx-cu132"),
        ("onnx-gpu", "no stack named 'gpu'", "--addons onnx-cu128, onnx-cu130 or onnx-cu132"),
        ("devel-cu128", "part devel is for CUDA 13, and stack cu128 has", "--addons devel-cu130 or devel-cu132"),
        ("common-cpu", "common-cpu-py311 is no add-on", "such as onnx"),
        ("x" * 300, "is no name", "such as onnx"),
        ("triton-cpu", f"there is no add-on triton-cpu: {NOWHERE}",
         "build it: rosml part common-cpu-py311 grpc-cpu-py311 tritonclient-cpu-py311"),
    ],
)  # fmt: skip
def test_an_addon_that_is_refused(name: str, text: str, remedy: str, place: Place) -> None:
    text = text.format(host=place.server.address, part=name.replace("triton-", "tritonclient-"))
    error = refusal(place, plain(place), name)
    assert text in error.message and remedy in error.remedy and error.exit_code == 2


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
    error = refusal(place, app_base.find("ros:lyrical-core", place.services, BOTH), "devel-cu130")
    assert "add-on devel of stack cu130 works on bookworm" in error.message and "--addons devel-cu132" in error.remedy


def test_an_image_without_a_list_of_files_is_joined_by_a_command(place: Place) -> None:
    ros(unlisted=True).put(place.registry, "rosml/robot", "1", BOTH)
    error = refusal(place, app_base.find(f"{place.server.address}/rosml/robot:1", place.services, BOTH), "graph-cpu")
    assert "has no list of its files" in error.message and "add them in its Dockerfile" in error.remedy
    words = shlex.split(error.remedy.partition("rosml join ")[2])
    done = CliRunner().invoke(join.main, words)
    assert done.exit_code == 0, done.output
    joined = app_base.find(words[words.index("--tag") + 1], place.services, BOTH)
    assert addons.onto(joined, "graph", place.services, BOTH) is joined
    app = app_base.find(place.app(place.base()), place.services, BOTH[:1])
    assert "take the app's run image, built" in refusal(place, app, "graph-cpu", platforms=BOTH[:1]).remedy


@pytest.mark.parametrize(
    ("claims", "problem"),
    [
        ({"part": "graph-cc"}, "graph-cpu-py311 is no such part: its labels say graph-cc cpu 3.11"),
        ({"stack": "cu128"}, "graph-cpu-py311 is no such part: its labels say graph cu128 3.11"),
        ({"addons": "graph=../../x,graph"}, "its label io.rosml.addons is damaged"),
        (None, "graph-cpu-py311 is for no platform"),
    ],
)
def test_a_part_that_is_another_one(claims: dict[str, str] | None, problem: str, place: Place) -> None:
    graph = part("graph", "cpu")
    labels = {f"io.rosml.{name}": value for name, value in (claims or {}).items()}
    platforms = () if claims is None else BOTH
    replace(graph, labels={**graph.labels, **labels}).put(place.registry, "rosml/part", "graph-cpu-py311", platforms)
    assert problem in refusal(place, plain(place), "graph-cpu").message


OURS = {"io.rosml.python": "3.11"}


@pytest.mark.parametrize(
    ("base", "problem"),
    [
        (Base("robot", "sha256:0", {}, labels=OURS, local=True), "robot is in Docker alone"),
        (Base("docker.io/library/ubuntu:24.04", "sha256:0", {}), "is none of rosml's images"),
        (Base("x/y:1", "sha256:0", {}, labels=OURS | {"io.rosml.parts": "a a"}), "its label io.rosml.parts is damaged"),
    ],
)
def test_a_base_image_that_takes_none(base: Base, problem: str, place: Place) -> None:
    assert problem in refusal(place, base, "graph").message


SLIM = Base("slim", "sha256:1", {}, addons=AddOns({"part:common": "x", "part:graph": "x"}, {}, {}))
NONE = Base("base", "sha256:0", {})
PIN = lock.Image(name="", digest=f"sha256:{'0' * 64}")


@pytest.mark.parametrize(
    ("parts", "text", "base", "slim", "fits"),
    [
        (["part:common", "part:graph"], "graph", SLIM, None, True),
        (["part:common", "part:graph"], "graph", NONE, SLIM, True),  # the base image has them already
        (["part:common", "part:graph"], "graph", NONE, None, True),  # without the slim image, this time
        (["part:common", "part:graph"], "", NONE, None, False),
        (["env:a-py311"], "", replace(NONE, labels={"io.rosml.environments": "a"}), None, True),
        (["part:common"], "graph", SLIM, None, False),
        ([f"part:p{number}" for number in range(5000)], "", NONE, None, False),
    ],
)
def test_a_lock_file_of_the_same_addons(parts: list[str], text: str, base: Base, slim: Base | None, fits: bool) -> None:
    locked = lock.Lock(base_image=PIN, slim_base_image=PIN, addons=dict.fromkeys(parts, PIN.digest) or None)
    values = Values(addons=text)
    if fits:
        verdict.require_same_addons(locked, values, base, slim)
        return
    with pytest.raises(RosmlError, match="the lock file is of") as caught:
        verdict.require_same_addons(locked, values, base, slim)
    assert len(caught.value.message) < 200 and caught.value.remedy == lock.RENEW


def explained(place: Place, monkeypatch: pytest.MonkeyPatch, *words: str) -> tuple[int, str]:
    monkeypatch.setattr(Services, "load", lambda *_, **__: place.services)
    done = CliRunner().invoke(explain.main, [*words])
    if isinstance(done.exception, RosmlError):
        return done.exception.exit_code, done.exception.message
    return done.exit_code, done.stdout


def test_explain_asks_the_registry_about_an_image(place: Place, monkeypatch: pytest.MonkeyPatch) -> None:
    image, host = place.base(), place.server.address
    code, text = explained(place, monkeypatch, image, "--addons", "graph-cpu")
    assert code == 0 and f"{image} can have graph-cpu:\n" in text
    assert f"rosml containerize --base-image {image} --addons graph-cpu\n" in text
    every = "{common-cpu-py311,graph-cc-cpu,graph-cpu-py311}"
    assert f"rosml join {image} {host}/rosml/part:{every} --tag {image}-with-graph-cpu\n" in text
    whole = f"{host}/rosml/ros-x:x"
    with_parts(place, "common", "graph-cc", "graph")
    assert explained(place, monkeypatch, whole, "--addons", "graph") == (0, f"{whole} has graph already\n")
    code, text = explained(place, monkeypatch, whole, "--addons", "onnx-cu130")
    assert code == 0 and "is of stack cpu, and takes no add-on of cu130" in text


def test_explain_tells_of_other_images(place: Place, monkeypatch: pytest.MonkeyPatch) -> None:
    Tiny({}).put(place.registry, "ubuntu", "24.04")
    name = f"{place.server.address}/ubuntu:24.04"
    code, text = explained(place, monkeypatch, name, "--addons", "onnx-cpu", "--json")
    assert code == 0 and json.loads(text)["exists"] is False and "is none of rosml's images" in text
    code, text = explained(place, monkeypatch, f"{name}x", "--addons", "onnx-cpu")
    assert code == 2 and "there is no image" in text
    for unpublished in ("ros:jazzy-base", f"{place.server.address}/rosml/ros:jazzy-base"):  # the matrix has it
        code, text = explained(place, monkeypatch, unpublished, "--addons", "onnx-cpu")
        assert code == 0 and f"{unpublished} can have onnx-cpu" in text
