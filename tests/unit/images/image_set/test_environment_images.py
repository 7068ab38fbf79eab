"""Environments in the image set and in a publishing run: an image with one, its lock, its tags. Joins: test_environments.py."""

from __future__ import annotations

from pathlib import Path

import pytest
from conftest import SMALLER, changed, parse, write_locks

from fakes.memory_registry import DAY, NEXT, Bytes, Publisher, publisher, steps
from fakes.scanning import World, advisory, rules
from fakes.stubs import services
from rosml.base.errors import RosmlError
from rosml.images.bake import targets
from rosml.images.environments.lock import Lock
from rosml.images.image_set import explain, labels, locked, missing_locks
from rosml.images.image_set.model import Environment, ImageSet
from rosml.images.locks.resolve import Pin
from rosml.images.matrix import extends, source
from rosml.images.publish import status
from rosml.images.publish.steps import STEPS
from rosml.images.publish.steps.scan import policy_digest, scan

ENTRY = """environments:
  grasp:
    images: [alpha-base-torch-cu1]
    architectures: [amd64]
    tests: [grasp]
    disk: {unpacked: 30, compressed: 10}
"""
MATRIX = changed("\nreleases:\n", f"\n{ENTRY}releases:\n", SMALLER)
IMAGE, PART = "alpha-base-torch-cu1-env-grasp", "env:grasp-py312"
PLACE = "environments/grasp/3.12/amd64.txt"


def lock(torch: str = "2.10.0", python: str = "3.12", more: str = "torch") -> str:
    takes = {"torch": torch}
    return str(
        Lock(
            "grasp",
            python,
            "amd64",
            39,
            {more: "1.0", **takes},
            takes,
            (Pin("gym", "1.0", ("sha256:" + "0" * 64,), frozenset()),),
        )
    )


def with_lock(root: Path, text: str | None) -> ImageSet:
    """The image set with this lock of its environment."""
    image_set = parse(MATRIX)
    write_locks(root, image_set)
    if text is not None:
        (root / PLACE).parent.mkdir(parents=True, exist_ok=True)
        (root / PLACE).write_text(text)
    image_set = locked.with_environments(image_set, root)
    present = locked.current_locks(image_set, root)
    return locked.with_locks(image_set, present, locked.unusable_locks(image_set, root, present))


@pytest.fixture
def image_set(project: Path) -> ImageSet:
    for name in ("grasp", "environment"):
        (project / f"tests/structure/{name}.yaml").write_text("schemaVersion: 2.0.0\n")
    (project / "components/environment").mkdir(exist_ok=True)
    (project / "components/environment/assemble.sh").write_text("")
    return with_lock(project, lock())


@pytest.fixture
def registry(project: Path, monkeypatch: pytest.MonkeyPatch) -> Publisher:
    return publisher(project, services(project), monkeypatch)


def test_an_image_is_there_once_more(image_set: ImageSet) -> None:
    image, plain = image_set.by_target[IMAGE], image_set.by_target["alpha-base-torch-cu1"]
    assert image.locked and image.tags == tuple(f"{tag}-env-grasp" for tag in plain.tags)
    assert image.parts == (*plain.parts, PART) and image.budgeted == plain.budgeted
    assert image.disk.compressed == plain.disk.compressed + 10
    assert (image.tests, image.proven_by) == (("contract", "environment", "grasp"), ("alpha-base", plain.target))
    assert {*image.shared} == {*plain.tests, *plain.shared} - {"contract"}
    assert set(image.groups) == {"alpha", "base", "grasp", "cu1", "all"}
    assert [it.target for it in image_set.images if it.environment] == [IMAGE]
    part = image_set.part_by_name[PART]
    assert isinstance(part, Environment)
    assert (part.target, part.repository, part.tag) == ("part-env-grasp-py312", "env", "grasp-py312")
    assert (part.os, dict(part.takes), part.glibc) == (image.os, {"torch": "2.10.0"}, 39)
    assert f"environment grasp is below {labels.ENVIRONMENTS_FOLDER}" in explain.explained(image_set, IMAGE).text
    assert "environment grasp, built from" in explain.explained(image_set, PART).text
    assert "grasp: a group of 1 target" in explain.explained(image_set, "env:grasp").text
    other = explain.explained(image_set, "ros-torch:omega-base-cu1-env-grasp").text
    assert "rosml join REGISTRY/ros-torch:omega-base-cu1 env:grasp --tag" in other


def test_a_build_and_a_join_give_the_same_labels(image_set: ImageSet) -> None:
    every = targets.of(image_set)
    plain, joined = (
        {k: v for k, v in every[name].labels.items() if isinstance(v, str)} for name in ("alpha-base-torch-cu1", IMAGE)
    )
    assert joined == plain | labels.with_environments(plain, (), ["grasp"])
    assert joined[labels.TITLE] == IMAGE
    assert every["part-env-grasp-py312"].labels == labels.of_environment(
        "grasp", "3.12", {"torch": "2.10.0"}, ["torch"]
    )


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        (None, f"{PLACE} is missing"),
        (lock(torch="2.9.0"), f"{PLACE} takes torch 2.9.0, and alpha-base-torch-cu1 has torch 2.10.0"),
        (lock(more="pillow"), f"{PLACE} takes pillow of its image, and alpha-base-torch-cu1 does not have that"),
        (lock(python="3.11"), f"{PLACE} is damaged, or not of"),
        (lock().removesuffix("0\n"), f"{PLACE} is damaged, or not of"),
    ],
)  # fmt: skip
def test_a_lock_that_does_not_fit(text: str | None, reason: str, project: Path) -> None:
    image_set = with_lock(project, text)
    image = image_set.by_target[IMAGE]
    assert not image.locked and missing_locks.reason(image).startswith(reason)
    remedy = "run 'rosml env add grasp --image alpha-base-torch-cu1'"
    remedy += "; if another image needs the present lock: there is one for each Python" * bool(image.misfit)
    assert missing_locks.remedy(image).startswith(remedy)
    error = missing_locks.lost(image_set)
    assert error and (error.remedy or "").startswith(remedy) and reason.split(" is damaged")[0] in error.message
    assert all(it.locked for it in image_set.images if it is not image)
    assert IMAGE not in image_set.groups["all"] and "grasp" not in image_set.groups


@pytest.mark.parametrize(
    ("before", "after", "problem"),
    [
        ("[alpha-base-torch-cu1]", "[alpha-base-torch-cu9]", "alpha-base-torch-cu9"),
        ("[alpha-base-torch-cu1]", "[alpha-base]", "alpha-base has no framework"),
        ("architectures: [amd64]\n    tests", "architectures: [arm64]\n    tests", "alpha-base-torch-cu1 is for amd64, and the environment has locks for arm64"),
        ("architectures: [amd64]\n    tests", "architectures: [amd46]\n    tests", "no architecture named 'amd46'; did you mean"),
        ("  grasp:\n", "  torch:\n", "the name 'torch' is taken"),
        ("  grasp:\n", "  arm64:\n", "arm64 is an architecture"),
        ("  grasp:\n", "  grasp-20261130:\n", "ends like the tag of a day"),
        ("{name: torch,", "{name: env-grasp,", "'env-grasp' begins with env-"),
        ("images: [alpha-base-torch-cu1]", "images: []", "add at least one entry"),
    ],
)  # fmt: skip
def test_a_mistake_is_named(before: str, after: str, problem: str) -> None:
    with pytest.raises(RosmlError) as caught:
        parse(changed(before, after, MATRIX))
    assert problem in str(caught.value)


def test_a_set_names_its_environments() -> None:
    """It has none by itself, since the images may not be there."""
    for text, names in (("", set()), ("environments: {grasp: }\n", {"grasp"})):
        document = extends.extended(source.parse(f"extends: rosml\n{text}".encode()), source.parse(MATRIX.encode()))
        assert {*document.data["environments"]} == names


def test_a_night(registry: Publisher, image_set: ImageSet, project: Path) -> None:
    """It is built, joined, tested and tagged; a newer lock makes it and its image anew, and nothing else."""
    run = registry.publish(image_set)
    assert not run.failed
    registry.check(image_set)
    assert "grasp-py312" in registry.tagged("env") and "alpha-base-cu1-env-grasp" in registry.tagged("ros-torch")
    assert isinstance(run.maker, Bytes) and run.maker.tests[IMAGE] == ("contract", "environment", "grasp")
    statuses = {it.target: it.state for it in status.read(registry.run(image_set, date=NEXT).state, NEXT)}
    assert statuses[IMAGE] == statuses["part-env-grasp-py312"] == "published"
    newer = with_lock(project, lock().replace("gym==1.0", "gym==1.1"))
    again = registry.publish(newer, date=NEXT)
    assert {it for it, _ in steps(again, "build")} == {"part-env-grasp-py312"}
    assert {it for it, _ in steps(again, "join")} == {it for it, _ in steps(again, "test")} == {IMAGE}


def test_an_environment_whose_image_failed_gets_no_tag(registry: Publisher, image_set: ImageSet) -> None:
    assert registry.publish(image_set, poisoned={IMAGE}).failed
    assert registry.tagged("env") == {} and "alpha-base-cu1" in registry.tagged("ros-torch")


@pytest.mark.parametrize(
    ("failing", "target"),
    [
        ("torch", "alpha-base-torch-cu1"),
        ("ros2-base", "alpha-base"),
        ("torch-build", "alpha-core-ml-cu1"),
    ],
)
def test_what_failed_without_it_keeps_it_from_its_tag(
    failing: str, target: str, registry: Publisher, image_set: ImageSet
) -> None:
    assert registry.publish(image_set, poisoned={target}, failing=failing).failed
    assert not [tag for tag in registry.tagged("ros-torch") if tag.endswith("-env-grasp")]


def test_what_the_policy_stops_in_it_stops_its_image_alone(
    registry: Publisher, image_set: ImageSet, tmp_path: Path
) -> None:
    world = World(tmp_path, advisories={"env-grasp": [advisory("CVE-2026-3", "CRITICAL", "3.0")]})
    run = registry.run(image_set, scanning=policy_digest(rules(), DAY))
    for step in ("build", "join", "test"):
        STEPS[step](run)
    scan(run, rules(), world.ready())
    for step in ("index", "promote"):
        STEPS[step](run)
    stopped = {key[0] for key, entry in run.state.entries.items() if entry.scan.get("failing") == ["CVE-2026-3"]}
    assert stopped == {IMAGE}
    assert registry.tagged("env") == {} and "alpha-base-cu1" in registry.tagged("ros-torch")
