"""What a publishing run has the builder do: the overrides and variables of its calls."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from fakes.memory_registry import BASE as PINNED
from fakes.memory_registry import NEXT, PREFIX, Publisher, Run, publisher, put_image
from fakes.stubs import services
from rosml.base.errors import RosmlError
from rosml.images.builds import base_images, contents, sync
from rosml.images.builds.maker import BuildKitMaker
from rosml.images.image_set.model import Image, ImageSet, Part
from rosml.images.matrix import names
from rosml.images.publish import run as running
from rosml.images.publish.steps import STEPS
from rosml.images.records import store
from rosml.machine import buildx
from rosml.machine.services import Services

RunAll = Callable[[Services, buildx.Bake], tuple[None, dict[str, dict[str, str]]]]


@pytest.fixture
def registry(project: Path, monkeypatch: pytest.MonkeyPatch) -> Publisher:
    monkeypatch.setattr(contents, "attach", lambda *facts: {digest: "sha256:sbom" for _, digest in facts[3]})
    monkeypatch.setattr(
        base_images, "reference", lambda _services, systems, name, *_: f"base-of-{systems[name].python}"
    )
    monkeypatch.setattr(base_images, "assembler", lambda *_: base_images.Assembler(PINNED, ""))
    monkeypatch.setattr(Services, "require_builder", lambda *_: None)
    return publisher(project, services(project), monkeypatch)


def bake(registry: Publisher, image_set: ImageSet, build: Callable[[buildx.Bake], object]) -> RunAll:
    """Puts an empty image into the registry for each target of a call."""

    def run_all(_services: Services, call: buildx.Bake) -> tuple[None, dict[str, dict[str, str]]]:
        build(call)
        every: list[Image | Part] = [*image_set.images, *image_set.parts]
        things = {thing.target: thing for thing in every}
        architecture = base_images.native_architecture()
        digests = {
            target: put_image(
                registry.registry, f"{PREFIX}/{things[target].repository}", architecture, {}, [target.encode()]
            )
            for target in (call.target, *call.beside)
        }
        return None, {target: {"containerimage.digest": digest} for target, digest in digests.items()}

    return run_all


def call_of(run: Run, target: str, registry: Publisher, monkeypatch: pytest.MonkeyPatch) -> buildx.Bake:
    """The call that builds a ROS image on this machine's own architecture."""
    calls: list[buildx.Bake] = []
    monkeypatch.setattr(buildx, "run_all", bake(registry, run.state.image_set, calls.append))
    monkeypatch.setattr(sync, "published", lambda *_: pytest.fail("all steps take packages to be of the plan's moment"))
    architecture = base_images.native_architecture()
    for name in run.state.image_set.by_target[target].architectures:
        run.state.entries[target, name] = store.Entry(target, name, package_state="sunday")
    real = BuildKitMaker(
        registry.services, run.state.image_set, run.state.place, lambda line: None, run.state.request.force
    )
    STEPS["build"](running.Run(run.state, real, lambda line: None))
    (call,) = [call for call in calls if call.name == f"build-{target}-{architecture}"]
    where = run.state.place.reference("ros")
    assert call.sets[0].startswith(f"{target}.output=type=image,name={where},push=true,push-by-digest=true,")
    return call


def test_a_set_may_choose_gzip(registry: Publisher, image_set: ImageSet, monkeypatch: pytest.MonkeyPatch) -> None:
    """And what it had as zstd is built again."""
    calls = {}
    for compression in ("zstd", "gzip"):
        matrix = image_set.matrix.model_copy(update={"compression": compression})
        run = registry.run(replace(image_set, matrix=matrix), only=["alpha-core"])
        calls[compression] = call_of(run, "alpha-core", registry, monkeypatch).sets[0]
    assert "compression=zstd" in calls["zstd"] and "compression=gzip,force-compression=true" in calls["gzip"]


@pytest.mark.parametrize("broken", [False, True])
def test_what_an_image_is_made_of_is_built_by_one_call(
    registry: Publisher, image_set: ImageSet, monkeypatch: pytest.MonkeyPatch, broken: bool
) -> None:
    """And listed by one call. If the build fails, one after the other, so that each says why."""
    image = next(image for image in image_set.images if len(image.parts) > 1 and image.parent == "alpha-base")
    calls: list[tuple[str, ...]] = []
    lines: list[str] = []
    described: list[int] = []
    run = registry.run(image_set, only=[image.target])

    def build(call: buildx.Bake) -> None:
        targets = call.target, *call.beside
        calls.append(targets)
        assert all(any(item.startswith(f"{name}.output=") for item in call.sets) for name in targets)
        if broken and call.beside:
            raise RosmlError("a step failed")

    def attach(*facts: Any) -> dict[str, str]:
        described.append(len(facts[3]))
        return {digest: "sha256:sbom" for _, digest in facts[3]}

    monkeypatch.setattr(buildx, "run_all", bake(registry, image_set, build))
    monkeypatch.setattr(contents, "attach", attach)
    monkeypatch.setattr(base_images, "assembler", lambda *_: base_images.Assembler("base-of-3.12", "3.12"))
    architecture = base_images.native_architecture()
    run.state.items = tuple(item for item in run.state.items if item.architecture == architecture)
    real = BuildKitMaker(registry.services, image_set, run.state.place, lines.append)
    STEPS["build"](running.Run(run.state, real, lines.append, whole=True))
    first, *others = (item.target for item in run.state.items if isinstance(item.thing, Image) and not item.thing.stack)
    parts = {item.target for item in run.state.items if item.kind == "part"}
    assert {*calls[0]} == {first, *parts} and others
    separate = {(target,) for target in ({first, *parts, *others} if broken else others)}
    assert {*calls[1:]} == separate and len(calls[1:]) == len(separate)
    assert "a step failed\nnow one after the other" in lines or not broken
    assert described == ([1] * len(separate) if broken else [1 + len(parts), *[1] * len(others)])
    assert all(run.state.is_current((target, architecture)) for target in {first, *parts, *others})


def test_packages_are_of_the_plans_moment(
    registry: Publisher, image_set: ImageSet, monkeypatch: pytest.MonkeyPatch
) -> None:
    """With the first component the essentials as well, which the builder would keep for ever."""
    folder = registry.services.state / "package-state/alpha"
    registry.packages["alpha"] = "monday, ubuntu noble 0123456789abcdef"
    system = image_set.by_target["alpha-core"].os
    for target, targets in (("alpha-core", {names.os_target(system), "alpha-core"}), ("alpha-base", {"alpha-base"})):
        call = call_of(registry.run(image_set, only=[target]), target, registry, monkeypatch)
        assert {*call.sets[1:]} == {f"{target}.tags=", *(f"{name}.contexts.upstream={folder}" for name in targets)}
        assert (folder / "moment").read_text() == "monday, ubuntu noble 0123456789abcdef\n"
        assert json.loads(dict(call.variables)["ROS_SYNC_DATES"]) == {"alpha": "monday"}
        forced = registry.run(image_set, date=NEXT, force=True, only=[target])
        call = call_of(forced, target, registry, monkeypatch)
        assert {*call.sets[1:]} == {f"{target}.tags=", *(f"{name}.no-cache=true" for name in targets)}


def test_packages_of_a_repository_that_did_not_answer_are_those_of_the_last_build(
    registry: Publisher, image_set: ImageSet, monkeypatch: pytest.MonkeyPatch
) -> None:
    registry.packages["alpha"] = "down"
    call = call_of(registry.run(image_set, only=["alpha-core"]), "alpha-core", registry, monkeypatch)
    assert json.loads(dict(call.variables)["ROS_SYNC_DATES"]) == {"alpha": "sunday"}


def test_force_builds_a_part_past_the_builders_cache(
    registry: Publisher, image_set: ImageSet, monkeypatch: pytest.MonkeyPatch
) -> None:
    uncached: list[bool] = []
    part = image_set.parts[0]
    monkeypatch.setattr(
        buildx,
        "run_all",
        bake(registry, image_set, lambda call: uncached.append(f"{part.target}.no-cache=true" in call.sets)),
    )
    for force in (False, True):
        BuildKitMaker(registry.services, image_set, registry.place, lambda line: None, force).build_part(part, "amd64")
    assert uncached == [False, True]
