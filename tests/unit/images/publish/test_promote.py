"""Indexes and tags: what moves, in which order, and what somebody who may push cannot make a run do."""

from __future__ import annotations

import threading
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from fakes.memory_registry import DAY, LATER, NEXT, PREFIX, Killed, Publisher, publisher, waiting
from fakes.projects import BASE
from fakes.stubs import services
from rosml.base import clock, side_by_side
from rosml.base.errors import RosmlError
from rosml.images.bake.inputs import Inputs
from rosml.images.image_set.model import ImageSet
from rosml.images.publish import status
from rosml.images.publish.steps import STEPS, promote
from rosml.images.records import store
from rosml.registry import oci


@pytest.fixture
def registry(project: Path, monkeypatch: pytest.MonkeyPatch) -> Publisher:
    return publisher(project, services(project), monkeypatch)


def test_a_tag_never_loses_an_architecture(registry: Publisher, image_set: ImageSet) -> None:
    registry.publish(image_set)
    before = registry.tagged("ros")
    registry.change()
    run = registry.publish(image_set, architectures=("amd64",), serving=("amd64",), date=NEXT, packages="2")
    assert registry.tagged("ros")["alpha-core"] == before["alpha-core"]
    assert any("would lose arm64" in reason for reason in waiting(run, "alpha-core"))


def test_a_tag_never_moves_to_something_older(registry: Publisher, image_set: ImageSet) -> None:
    registry.publish(image_set, date=NEXT)
    before = registry.tagged("ros")
    registry.change()
    run = registry.publish(image_set, date=DAY, packages="2")
    assert registry.tagged("ros")["latest"] == before["latest"]
    assert any("something newer" in reason for reason in waiting(run, "alpha-base"))


def test_architectures_that_differ_get_no_index(registry: Publisher, image_set: ImageSet) -> None:
    run = registry.publish(image_set, odd={("alpha-core", "arm64"): {"io.rosml.python": "3.10"}})
    assert "alpha-core" not in registry.tagged("ros")
    (failed,) = [outcome for outcome in run.outcomes if outcome.state == "failed"]
    assert "python is nothing on amd64, 3.10 on arm64" in failed.reason


def test_the_second_tag_of_a_day_has_another_name(registry: Publisher, image_set: ImageSet) -> None:
    registry.publish(image_set)
    registry.change()
    first = registry.tagged("ros")["alpha-core-20261122"]
    registry.publish(image_set, date=DAY.replace("03:", "05:"), packages="2")
    tags = registry.tagged("ros")
    assert tags["alpha-core-20261122"] == first, "a dated tag moved"
    assert tags["alpha-core-20261122.2"] == tags["alpha-core"] != first


def test_tags_move_from_the_lasting_ones_to_the_floating_ones(
    registry: Publisher, image_set: ImageSet, monkeypatch: pytest.MonkeyPatch
) -> None:
    moved: list[str] = []

    def tag(repository: str, target: str, name: str) -> None:
        if repository.endswith("/ros-torch"):
            moved.append(name)
        move(repository, target, name)

    move = registry.registry.tag
    monkeypatch.setattr(registry.registry, "tag", tag)
    registry.publish(image_set, only=[BASE])
    assert moved == ["alpha-base-cu1-20261122", "alpha-base-cu1-torch2.10.0", "alpha-base-cu1", "alpha", "latest"]


@pytest.mark.parametrize(
    ("method", "kind"), [("tag", None), ("put_manifest", oci.INDEX), ("attach", store.ARTIFACT)], ids=str
)
def test_images_are_promoted_side_by_side(
    registry: Publisher, image_set: ImageSet, monkeypatch: pytest.MonkeyPatch, method: str, kind: str | None
) -> None:
    """One after the other, hundreds of images take longer than a job may on a registry that is far away."""
    both, met = threading.Barrier(2, timeout=20), threading.local()

    def meeting(repository: str, *words: Any, **options: Any) -> Any:
        if not repository.endswith("/records") and (kind is None or kind in words) and not hasattr(met, "once"):
            met.once = True
            both.wait()
        return real(repository, *words, **options)

    real = getattr(registry.registry, method)
    monkeypatch.setattr(registry.registry, method, meeting)
    monkeypatch.setattr(side_by_side, "AT_ONCE", 2)
    run = registry.publish(image_set, only=["alpha-core", "alpha-base"])
    assert not run.failed and {"alpha-core", "alpha-base"} <= registry.tagged("ros").keys()


def test_tags_of_the_first_images_move_before_the_last_ones_are_prepared(
    registry: Publisher, image_set: ImageSet, monkeypatch: pytest.MonkeyPatch
) -> None:
    def attach(repository: str, subject: Any, artifact_type: str, *rest: Any) -> str:
        if artifact_type == store.ARTIFACT and registry.tagged("ros"):
            raise Killed
        return real(repository, subject, artifact_type, *rest)

    real = registry.registry.attach
    monkeypatch.setattr(registry.registry, "attach", attach)
    monkeypatch.setattr(promote, "BATCH", 2)
    with pytest.raises(Killed):
        registry.publish(image_set)
    assert {"alpha-core", "alpha-base"} <= registry.tagged("ros").keys()
    monkeypatch.undo()
    registry.undo()
    assert registry.tagged("ros") == {}


def test_a_tag_that_does_not_move_keeps_no_other_image_back(
    registry: Publisher, image_set: ImageSet, monkeypatch: pytest.MonkeyPatch
) -> None:
    def tag(repository: str, target: str, name: str) -> None:
        if name.startswith("alpha-core"):
            raise RosmlError(f"the tag {name} is protected")
        move(repository, target, name)

    move = registry.registry.tag
    monkeypatch.setattr(registry.registry, "tag", tag)
    run = registry.publish(image_set)
    failed = {outcome.target for outcome in run.outcomes if outcome.state == "failed"}
    assert "alpha-core" in failed and all(target.startswith("alpha-core") for target in failed)
    assert {"alpha-base", "omega-core"} <= registry.tagged("ros").keys()
    monkeypatch.undo()
    assert not registry.publish(image_set).actions and "alpha-core" in registry.tagged("ros")


def test_a_registry_that_is_down_is_not_asked_for_every_image(
    registry: Publisher, image_set: ImageSet, monkeypatch: pytest.MonkeyPatch
) -> None:
    requests = []

    def down(*arguments: Any) -> None:
        requests.append(arguments)
        monkeypatch.setattr(registry.registry, "head", down)
        raise RosmlError("the registry does not answer")

    monkeypatch.setattr(registry.registry, "tag", down)
    monkeypatch.setattr(side_by_side, "AT_ONCE", 2)
    with pytest.raises(RosmlError, match="does not answer"):
        registry.publish(image_set)
    assert len(requests) < len(image_set.images)


# ---- Dates, and entries, that somebody wrote -------------------------------------------------------------------------


def test_a_tag_of_the_future_moves_only_when_forced(
    registry: Publisher, image_set: ImageSet, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(clock, "now", lambda: NEXT)
    registry.publish(image_set, only=["alpha-core"], date="2029-01-01T00:00:00Z")
    before = registry.tagged("ros")["alpha-core"]
    registry.change()
    run = registry.publish(image_set, only=["alpha-core"], date=NEXT, packages="2")
    assert registry.tagged("ros")["alpha-core"] == before
    assert any("of 2029-01-01T00:00:00Z, which is in the future" in reason for reason in waiting(run, "alpha-core"))
    (image,) = status.read(run.state, NEXT)
    assert image.reason.endswith("its date 2029-01-01T00:00:00Z is in the future")
    registry.publish(image_set, only=["alpha-core"], date=LATER, packages="2", force=True)
    assert registry.tagged("ros")["alpha-core"] != before


@pytest.mark.parametrize("date", ["yesterday", "2026-11-22", 5, ["x"]])
def test_an_invalid_date_is_reported_and_holds_no_tag(registry: Publisher, image_set: ImageSet, date: Any) -> None:
    registry.publish(image_set, only=["alpha-core"])
    index = registry.registry.manifest(f"{PREFIX}/ros", "alpha-core")
    assert index
    content = index.content | {"annotations": index.content["annotations"] | {store.DATE: date}}
    digest = registry.registry.put_manifest(f"{PREFIX}/ros", "alpha-core", content, index.media_type)
    registry.change()
    run = registry.run(image_set, only=["alpha-core"], date=NEXT, packages="2")
    (image,) = status.read(run.state, NEXT)
    assert "its date is not valid" in image.reason and image.age is None
    lines: list[str] = []
    run.say = lines.append
    for step in STEPS:
        STEPS[step](run)
    assert not run.failed
    assert registry.tagged("ros")["alpha-core"] != digest
    assert any("and is taken for older" in line for line in lines)


def forge(registry: Publisher, target: str, architecture: str, **facts: Any) -> None:
    """Writes an entry of the records by hand."""
    book = store.Records(registry.place)
    entry = book.read(target, architecture)
    assert entry
    book.write(replace(entry, **facts))


@pytest.mark.parametrize(("target", "architecture"), [("alpha-core", "amd64"), ("alpha-base", "arm64")])
def test_the_digest_of_another_image_gets_no_index(
    registry: Publisher, image_set: ImageSet, target: str, architecture: str
) -> None:
    registry.publish(image_set)
    before = registry.tagged("ros")
    other = store.Records(registry.place).read(target, architecture)
    assert other
    forge(registry, "alpha-base", "amd64", digest=other.digest)
    run = registry.run(image_set, date=NEXT, only=["alpha-base"])
    STEPS["index"](run)
    STEPS["promote"](run)
    (failed,) = [outcome for outcome in run.outcomes if outcome.state == "failed"]
    assert f"alpha-base.amd64 names {other.digest}, which is {target} for {architecture}" in failed.reason
    assert registry.tagged("ros") == before


@pytest.mark.parametrize(
    ("what", "reason"),
    [("title", "that of alpha-base"), ("members", "of other images"), ("gone", "not in the registry any more")],
)
def test_the_index_of_another_image_gets_no_tag(
    registry: Publisher, image_set: ImageSet, what: str, reason: str
) -> None:
    registry.publish(image_set)
    book = store.Records(registry.place)
    entry, other = book.read("alpha-core", "index"), book.read("alpha-base", "index")
    assert entry and other
    digest = {"title": other.digest, "gone": "sha256:" + "0" * 64}.get(what, "")
    if what == "members":
        whole = registry.registry.manifest(f"{PREFIX}/ros", entry.digest)
        assert whole
        part = whole.content | {"manifests": whole.content["manifests"][:1]}
        digest = registry.registry.put_manifest(f"{PREFIX}/ros", "odd", part, whole.media_type)
    forge(registry, "alpha-core", "index", digest=digest)
    run = registry.run(image_set, date=NEXT, only=["alpha-core"])
    run.state.present.add(("alpha-core", "index"))
    before = registry.tagged("ros")
    STEPS["promote"](run)
    assert run.failed and registry.tagged("ros") == before
    assert reason in next(outcome.reason for outcome in run.outcomes if outcome.state == "failed")


# ---- Undo ------------------------------------------------------------------------------------------------------------


def second_night(registry: Publisher, image_set: ImageSet, **options: Any) -> None:
    registry.packages["alpha"] = "tuesday"
    registry.publish(image_set, date=NEXT, packages="2", **options)


def test_undo_brings_tags_back(registry: Publisher, image_set: ImageSet) -> None:
    registry.publish(image_set)
    before = registry.tagged("ros")
    registry.change()
    registry.publish(image_set, date=NEXT, packages="2")
    registry.registry.tag(f"{PREFIX}/ros", before["alpha-core"], "omega-core")  # somebody's
    registry.undo(date=NEXT)
    after = registry.tagged("ros")
    assert after.pop("omega-core") == before["alpha-core"], "a tag that somebody else moved was moved"
    assert after == {name: target for name, target in before.items() if name != "omega-core"}
    held = registry.publish(image_set, date=LATER, packages="2")
    assert {**registry.tagged("ros"), "omega-core": ""} == {**before, "omega-core": ""}, "undone in vain"
    assert any("moved back on 2026-11-23" in reason for reason in waiting(held, "alpha-core"))
    registry.change()
    registry.publish(image_set, date=LATER, packages="3")
    assert registry.tagged("ros")["alpha-core"] not in (before["alpha-core"], "")


def test_undo_brings_back_what_was_before_the_first_run_of_a_date(registry: Publisher, image_set: ImageSet) -> None:
    registry.publish(image_set)
    before = registry.tagged("ros")["alpha-core"]
    for number in ("2", "3"):
        registry.change()
        registry.publish(image_set, date=NEXT, packages=number)
    assert registry.tagged("ros")["alpha-core"] != before
    registry.undo(date=NEXT)
    assert registry.tagged("ros")["alpha-core"] == before
    assert [(o.state, o.reason) for o in registry.undo(NEXT)] == [("done", "nothing was left to move back")]


def test_an_undo_that_was_killed_goes_on(project: Path, image_set: ImageSet, monkeypatch: pytest.MonkeyPatch) -> None:
    """Every write of it is the last one once; the next night does not move anything there again."""
    options: dict[str, Any] = {"only": ["alpha-core", "alpha-base"], "inputs": Inputs(project, image_set)}
    number, killed = 0, True
    while killed:
        number += 1
        here = publisher(project, services(project), monkeypatch)
        here.publish(image_set, **options)
        before = here.tagged("ros")
        second_night(here, image_set, **options)
        here.registry.die_at = here.registry.writes + number
        try:
            here.undo()
            killed = False
        except Killed:
            here.registry.die_at = 0
            here.undo()
        assert here.tagged("ros") == before
        here.publish(image_set, date="2026-11-25T03:00:00Z", packages="2", **options)
        assert here.tagged("ros") == before, f"write {number}: undone in vain"
    assert number > 4


def test_force_releases_what_was_moved_back(registry: Publisher, image_set: ImageSet) -> None:
    registry.publish(image_set)
    second_night(registry, image_set)
    held = registry.tagged("ros")["alpha-core"]
    registry.undo()
    forced = registry.publish(image_set, date=LATER, packages="2", force=True)
    assert not forced.failed and not waiting(forced, "alpha-core")
    assert registry.tagged("ros")["alpha-core"] not in ("", held)
    now, then = (registry.registry.manifest(f"{PREFIX}/ros", name) for name in ("alpha-core", held))
    assert now and then and now.content["manifests"] == then.content["manifests"], "the same images"
