"""A publishing run: what is done, what is left alone, and that no tag points at what is untested, partial or older."""

from __future__ import annotations

import itertools
import json
import threading
from collections.abc import Callable
from dataclasses import replace
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import Any

import pytest
from conftest import SMALLER, parse

from fakes.memory_registry import BASE as PINNED
from fakes.memory_registry import (
    DAY,
    LATER,
    NEXT,
    PREFIX,
    Bytes,
    Killed,
    MemoryRegistry,
    Pen,
    Publisher,
    Run,
    publisher,
    put_image,
    steps,
    waiting,
)
from fakes.projects import BASE
from fakes.stubs import services
from rosml.base import clock as moments
from rosml.base import side_by_side
from rosml.base.errors import RosmlError
from rosml.cli.images import report, tables
from rosml.images.bake.inputs import Inputs
from rosml.images.builds import base_images, contents, maker, sync
from rosml.images.builds.maker import BuildKitMaker
from rosml.images.image_set import locked, selection
from rosml.images.image_set import model as sets
from rosml.images.image_set.model import Image, ImageSet
from rosml.images.matrix import names
from rosml.images.publish import run as running
from rosml.images.publish import status
from rosml.images.publish.plan import make_plan, read_plan
from rosml.images.publish.steps import STEPS, build, images, promote
from rosml.images.records import store
from rosml.machine import buildx
from rosml.machine.services import Services
from rosml.registry import oci
from rosml.registry.place import Place


@pytest.fixture
def registry(project: Path, monkeypatch: pytest.MonkeyPatch) -> Publisher:
    return publisher(project, services(project), monkeypatch)


def test_everything_is_published_once(registry: Publisher, image_set: ImageSet) -> None:
    run = registry.publish(image_set)
    assert not run.failed
    registry.check(image_set)
    assert registry.tagged("ros").keys() >= {"alpha-core", "alpha-core-20261122", "alpha", "latest", "omega-base"}
    assert registry.tagged("ros-torch").keys() >= {"alpha-base-cu1", "alpha-base-cu1-torch2.10.0", "alpha", "latest"}
    assert registry.tagged("part").keys() >= {"torch-cu1-py312", "cuda-cu1", "torch-cpu-py314"}
    assert len({registry.tagged("ros-torch")[name] for name in ("alpha-base-cu1", "alpha", "latest")}) == 1
    before = registry.registry.writes
    again = registry.publish(image_set, date=NEXT)
    assert (again.made, again.outcomes, registry.registry.writes) == ([], [], before)


def test_a_change_makes_anew_what_it_reaches_and_nothing_else(
    registry: Publisher, image_set: ImageSet, project: Path
) -> None:
    registry.publish(image_set)
    before = registry.tagged("ros")
    script = project / "components/torch/files.sh"
    script.write_text(script.read_text() + "# a change\n")
    run = registry.publish(image_set, date=NEXT)
    assert steps(run, "build") == {
        (part.target, name) for part in image_set.parts if part.kind == "torch" for name in part.architectures
    }
    assert {target for target, _ in steps(run, "join")} == {
        image.target for image in image_set.images if "torch" in image.versions
    }
    assert registry.tagged("ros") == before
    assert f"{BASE.replace('-torch', '')}-20261123" in registry.tagged("ros-torch")
    registry.check(image_set)


def test_a_changed_test_runs_again_and_builds_nothing(registry: Publisher, image_set: ImageSet, project: Path) -> None:
    registry.publish(image_set)
    tags = registry.tagged("ros-torch")
    test = project / "tests/structure/torch.yaml"
    test.write_text(test.read_text() + "# another\n")
    run = registry.publish(image_set, date=NEXT)
    assert steps(run, "build") == steps(run, "join") == set()
    with_torch = {image.target for image in image_set.images if "torch" in image.versions}
    assert {target for target, _ in steps(run, "test")} == with_torch
    assert registry.tagged("ros-torch") == tags


def test_packages_that_moved_are_installed_anew(registry: Publisher, image_set: ImageSet) -> None:
    """Where they turn out to be the same ones, nothing else happens."""
    registry.publish(image_set)
    tags = registry.tagged("ros"), registry.tagged("ros-torch")
    registry.packages["alpha"] = "tuesday"
    run = registry.publish(image_set, date=NEXT)
    assert {target for target, _ in steps(run, "build")} == {"alpha-core", "alpha-base"}
    assert steps(run, "join") == steps(run, "test") == set()
    assert (registry.tagged("ros"), registry.tagged("ros-torch")) == tags
    registry.packages["alpha"] = "wednesday"
    run = registry.publish(image_set, date=NEXT, packages="2")
    assert {target for target, _ in steps(run, "join")} == {
        image.target for image in image_set.images if image.distribution == "alpha" and image.stack
    }
    assert registry.tagged("ros")["alpha-core"] != tags[0]["alpha-core"]
    assert registry.tagged("ros")["omega-core"] == tags[0]["omega-core"]
    registry.check(image_set)


def test_repositories_that_do_not_answer_change_nothing(registry: Publisher, image_set: ImageSet) -> None:
    registry.publish(image_set)
    registry.packages["alpha"] = "down"
    run = registry.publish(image_set, date=NEXT)
    assert run.made == []
    assert any("alpha" in remark and "does not answer" in remark for remark in run.state.remarks)


def test_a_poisoned_image_keeps_its_tags_and_stops_nobody_else(
    registry: Publisher, image_set: ImageSet, project: Path
) -> None:
    registry.publish(image_set)
    before = registry.tagged("ros-torch")
    for name in ("torch", "ros"):
        for script in sorted((project / f"components/{name}").glob("*.sh")):
            script.write_text(script.read_text() + "# a change\n")
    run = registry.publish(image_set, date=NEXT, packages="2", poisoned={BASE})
    assert run.failed
    after = registry.tagged("ros-torch")
    mine = {name for name in before if name.startswith("alpha-base") or name in ("alpha", "latest")}
    assert {name: after[name] for name in mine if "-cpu" not in name} == {
        name: before[name] for name in mine if "-cpu" not in name
    }
    assert after["alpha-core-cu1"] != before["alpha-core-cu1"]
    assert any("tests failed" in reason for reason in waiting(run, BASE))
    mended = registry.publish(image_set, date=NEXT, packages="2")
    assert mended.made == [("test", BASE, "amd64")]
    assert registry.tagged("ros-torch")["latest"] != before["latest"]
    registry.check(image_set)


def ran(run: Run) -> dict[str, tuple[str, ...]]:
    """What each image was tested with in a run."""
    assert isinstance(run.maker, Bytes)
    return run.maker.tests


def of_parts(image: Image) -> tuple[str, ...]:
    """The tests of its parts that an image shares with others."""
    return tuple(name for name in image.shared if name in image.carried)


def test_what_images_of_a_row_share_is_tested_in_one_of_them(registry: Publisher, image_set: ImageSet) -> None:
    found = ran(registry.publish(image_set))
    assert all(found[target] == image_set.by_target[target].tests for target in found)
    assert {target for target, names in found.items() if "pip" in names and target.startswith("alpha")} == {
        *("alpha-core", "alpha-core-ml-cu1", "alpha-core-ml-cpu"),
    }
    registry.check(image_set)


def test_an_image_alone_is_tested_with_all_that_must_hold_in_it(registry: Publisher, image_set: ImageSet) -> None:
    """Nothing is tested twice: its ROS image runs the tests of ROS."""
    image = image_set.by_target[BASE]
    run = registry.publish(image_set, only=[BASE])
    assert ran(run)[BASE] == (*image.tests, *of_parts(image))
    assert {*image.shared} - {*of_parts(image)} <= {*ran(run)["alpha-base"], *ran(run)["alpha-core"]}
    assert "latest" in registry.tagged("ros-torch")
    assert BASE not in ran(registry.publish(image_set, date=NEXT))
    registry.check(image_set)


def test_an_image_alone_is_tested_with_less_if_others_of_the_same_parts_passed(
    registry: Publisher, image_set: ImageSet
) -> None:
    registry.publish(image_set, only=["alpha-core-ml-cu1", "alpha-base"])
    image = image_set.by_target[BASE]
    assert ran(registry.publish(image_set, date=NEXT, only=[BASE]))[BASE] == image.tests
    assert "alpha-base-cu1" in registry.tagged("ros-torch")
    registry.packages["alpha"] = "tuesday"
    run = registry.publish(image_set, date=NEXT, only=[BASE], packages="2")
    assert ran(run)[BASE] == (*image.tests, *of_parts(image)), "the others stand on other packages"
    registry.check(image_set)


def test_a_second_image_with_the_same_parts_is_tested_with_what_is_new_in_it(
    registry: Publisher, image_set: ImageSet
) -> None:
    """The first one, on a lower component, has run all tests of the parts: there is none with more frameworks."""
    first, second = (image_set.by_target[name] for name in ("alpha-core-torch-cu1", BASE))
    assert {*of_parts(first)} <= {*ran(registry.publish(image_set, only=[first.target]))[first.target]}
    assert ran(registry.publish(image_set, date=NEXT, only=[second.target]))[BASE] == second.tests
    assert "alpha-base-cu1" in registry.tagged("ros-torch")
    everything = registry.publish(image_set, date=NEXT, only=[BASE], all_tests=True)
    assert ran(everything) == {BASE: (*second.tests, *second.shared)}
    assert ran(registry.publish(image_set, date=LATER, only=[BASE], all_tests=True)) == {}
    registry.check(image_set)


def test_what_failed_in_the_first_image_is_run_again_in_the_second(registry: Publisher, image_set: ImageSet) -> None:
    """Nor does a higher component prove anything for a lower one."""
    registry.publish(image_set, only=["alpha-core-torch-cu1"], poisoned={"alpha-core-torch-cu1"}, failing="pip")
    image = image_set.by_target[BASE]
    assert ran(registry.publish(image_set, date=NEXT, only=[BASE]))[BASE] == (*image.tests, *of_parts(image))
    first = image_set.by_target["alpha-core-torch-cu1"]
    run = registry.publish(image_set, date=LATER, only=[first.target])
    assert ran(run)[first.target] == (*first.tests, *of_parts(first))


def test_the_owner_sees_each_cause_once(registry: Publisher, image_set: ImageSet) -> None:
    """What failed, with the last lines of its log, and all that it keeps from being published; what a further run would do."""
    part = "part-torch-cu1-py312"
    registry.publish(image_set, broken={part}, poisoned={"alpha-core"})
    run = registry.run(image_set, date=NEXT)
    entry = run.state.entries[part, "amd64"]
    run.state.entries[part, "amd64"] = replace(
        entry, failed={**entry.failed, "reason": "it broke\n@somebody `at` line 7"}
    )
    found = list(status.read(run.state, LATER))
    causes = status.causes(found, image_set.matrix.architectures)
    assert [cause.state for cause in causes[:2]] == ["failed", "failed"]
    by_reason = {cause.reason: cause for cause in causes}
    assert by_reason["it broke"].targets == (part,)
    poisoned = by_reason["tests failed: contract: it is poisoned"]
    assert poisoned.targets == ("alpha-core",), "of both architectures"
    assert poisoned.log.splitlines()[1:] == ["    contract: it is poisoned", "      Expected 0, got 1"]
    (waits,) = [cause for cause in causes if cause.reason == f"build of {part} failed"]
    assert {"alpha-core-torch-cu1", "alpha-base-torch-cu1", "alpha-core-ml-cu1", "alpha-base-ml-cu1"} == {
        *waits.targets
    }
    ahead = status.ahead(run.state)
    assert ahead == {"build": 1, "join": 4, "test": 6}
    text = tables.status_markdown("registry.example/rosml", found, causes, ahead)
    assert (
        text.startswith("## Images of registry.example/rosml\n")
        and "A further run would build 1, join 4, test 6." in text
    )
    assert "````\nit broke\n@somebody `at` line 7\n````" in text
    mended = registry.publish(image_set, date=NEXT)
    assert {step: len(steps(mended, step)) for step in ahead} == ahead


def test_a_row_whose_packages_nobody_published_is_left_out(registry: Publisher, image_set: ImageSet) -> None:
    """Before a build is tried, with the reason; the other rows are built, and what was there stays."""
    registry.publish(image_set, only=["alpha-core"])
    registry.absent = {("omega", name, "ros-omega-ros-core") for name in ("amd64", "arm64")}
    registry.absent |= {("alpha", "amd64", "ros-alpha-ros-base")}
    run = registry.publish(image_set, date=NEXT)
    assert not run.failed
    reason = "the archive has no ros-omega-ros-core for ubuntu-26.04, amd64"
    assert reason in waiting(run, "omega-core") and f"{reason} (for omega-core)" in waiting(run, "omega-base")
    assert {name for name, _ in steps(run, "build")} == {"alpha-base"} | {x.target for x in image_set.parts}
    assert "alpha-core" in registry.tagged("ros") and "alpha-base" not in registry.tagged("ros")
    found = {x.target: x for x in status.read(run.state, LATER)}
    assert found["omega-core"].state == "missing" and reason in found["omega-core"].reason
    registry.absent.clear()
    registry.publish(image_set, date=NEXT)
    assert "omega-core" in registry.tagged("ros")
    registry.check(image_set)


def test_each_image_is_tested_as_soon_as_it_is_there(registry: Publisher, image_set: ImageSet) -> None:
    """One stack after the other, whose parts the builder then fetches once. Those that test what others of their stack share come first,
    so that a run that ends early leaves whole images."""
    run = registry.run(image_set)
    images(run)
    made = [(step, target) for step, target, _ in run.made]
    assert made[:4] == [("build", "alpha-core"), ("test", "alpha-core")] * 2, "on both architectures"
    joins = [image_set.by_target[target] for step, target in made if step == "join"]
    for _, of_stack in itertools.groupby(joins, lambda image: image.stack):
        carries = [image.carriers[0] == image.target for image in of_stack]
        assert carries == sorted(carries, reverse=True)
    stacks = [image.stack or "" for image in joins]
    assert stacks == sorted(stacks) and len({*stacks}) > 1
    assert all(made[place + 1] == ("test", target) for place, (step, target) in enumerate(made) if step == "join")
    assert sorted(run.made) == sorted(place_of(registry).publish(image_set).made)


def test_a_build_that_failed_on_another_machine_is_tried_here(registry: Publisher, image_set: ImageSet) -> None:
    """A record without a digest says that nothing was made."""
    run = registry.run(image_set)
    item = next(item for item in run.state.items if item.kind == "part")
    run.state.present.add(item.key)
    failed = {"step": "build", "reason": "it broke"}
    run.records.write(store.Entry(*item.key, repository=item.repository, failed=failed), {})
    run.state.look_again(item)
    assert run.state.entries[item.key].failed and item.key not in run.state.present
    assert run.state.reasons(item) == ["it was never made"]


def test_a_test_that_fails_is_not_run_again_in_the_same_run(registry: Publisher, image_set: ImageSet) -> None:
    run = registry.run(image_set, poisoned={"alpha-core"})
    images(run)
    assert len(steps(run, "test")) == len({*steps(run, "test")})
    assert [o.state for o in run.outcomes if (o.step, o.target) == ("test", "alpha-core")] == ["failed"] * 2


def place_of(registry: Publisher) -> Publisher:
    """Another registry for the same runs."""
    return Publisher(registry.services, packages=registry.packages)


def test_a_run_whose_time_is_over_leaves_tested_images(
    registry: Publisher, image_set: ImageSet, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Nothing fails; the images that were tested get their tags, and the next run makes the rest."""
    clock = iter(range(10_000))
    monkeypatch.setattr("rosml.images.publish.run.time.monotonic", lambda: float(next(clock)))
    run = registry.run(image_set)
    images(run, minutes=1)
    STEPS["index"](run)
    promote.promote(run)
    assert not run.failed and run.made
    assert any(outcome.reason == "the time of this run is over" for outcome in run.outcomes)
    assert registry.tagged("ros") and not registry.tagged("ros-torch")
    registry.check(image_set)
    rest = registry.publish(image_set, date=NEXT)
    assert not set(rest.made) & set(run.made)
    registry.check(image_set)


@pytest.mark.parametrize(
    ("target", "failing", "held"),
    [
        ("alpha-core-ml-cu1", "pip", {"alpha-core-cu1", "alpha-base-cu1"}),
        ("alpha-core-ml-cu1", "ros2", set()),
        ("alpha-core", "ros2-components", {"alpha-core-cu1"}),
        ("alpha-core", "ros2-core", {"alpha-core-cu1", "alpha-base-cu1"}),
        ("alpha-core", "contract", set()),
    ],
)
def test_a_failure_holds_all_images_back_that_share_what_failed(
    registry: Publisher, image_set: ImageSet, target: str, failing: str, held: set[str]
) -> None:
    run = registry.publish(image_set, poisoned={target}, failing=failing)
    tags = registry.tagged("ros-torch")
    assert {"alpha-core-cu1", "alpha-base-cu1"} - tags.keys() == held
    assert "omega-core-cpu" in tags
    if held:
        assert f"tests that it shares with {target} failed: {failing}: it is" in waiting(run, "alpha-core-torch-cu1")[0]
        found = {x.target: x for x in status.read(run.state, LATER)}
        assert "it shares with" in found["alpha-core-torch-cu1"].reason
    mended = registry.publish(image_set, date=NEXT)
    assert {name for _, name, _ in mended.made} == {target}
    assert {"alpha-core-cu1", "alpha-base-cu1"} <= registry.tagged("ros-torch").keys()
    registry.check(image_set)


def test_a_build_that_fails_is_told_with_what_waits_for_it(registry: Publisher, image_set: ImageSet) -> None:
    run = registry.publish(image_set, broken={"alpha-base"})
    assert run.failed
    assert "alpha-base" not in registry.tagged("ros") and "alpha-core" in registry.tagged("ros")
    assert any("alpha-base" in reason for reason in waiting(run, BASE))
    entry = store.Records(registry.place).read("alpha-base", "amd64")
    assert entry and entry.failed["step"] == "build" and not entry.digest
    done = set(run.made)
    mended = registry.publish(image_set)
    assert not mended.failed
    assert not done & set(mended.made)


def test_the_wait_for_another_build_is_told_and_does_not_count_as_work(
    registry: Publisher, image_set: ImageSet, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Estimates of the next run are made from the records, and the next run may not have to wait."""
    waits = itertools.count(step=85)
    monkeypatch.setattr(buildx, "waited", lambda: float(next(waits)))
    run = registry.publish(image_set)
    built = next(outcome for outcome in run.outcomes if outcome.step == "build")
    entry = run.state.entries[built.target, built.architecture]
    assert built.waited == 85
    assert entry.seconds["build"] == round(built.seconds - 85, 2)
    assert "(1 min 25 s of it waiting for another build)" in report.markdown(run)


def test_an_index_waits_for_all_architectures(registry: Publisher, image_set: ImageSet) -> None:
    first = registry.publish(image_set, architectures=("amd64",))
    assert "alpha-core" not in registry.tagged("ros")
    assert "alpha-base-cu1" in registry.tagged("ros-torch"), "it is for amd64 alone"
    assert waiting(first, "alpha-core")
    second = registry.publish(image_set, architectures=("arm64",), date=NEXT)
    assert not [key for key in second.made if key in first.made]
    assert "alpha-core" in registry.tagged("ros")
    registry.check(image_set)


def test_a_registry_may_serve_one_architecture(registry: Publisher, image_set: ImageSet) -> None:
    run = registry.publish(image_set, architectures=("amd64",), serving=("amd64",))
    assert not run.failed
    assert "alpha-core" in registry.tagged("ros") and "latest" in registry.tagged("ros")


def test_a_tag_never_loses_an_architecture(registry: Publisher, image_set: ImageSet, project: Path) -> None:
    registry.publish(image_set)
    before = registry.tagged("ros")
    script = project / "components/ros/install.sh"
    script.write_text(script.read_text() + "# a change\n")
    run = registry.publish(image_set, architectures=("amd64",), serving=("amd64",), date=NEXT, packages="2")
    assert registry.tagged("ros")["alpha-core"] == before["alpha-core"]
    assert any("would lose arm64" in reason for reason in waiting(run, "alpha-core"))


def test_a_tag_never_moves_to_something_older(registry: Publisher, image_set: ImageSet, project: Path) -> None:
    registry.publish(image_set, date=NEXT)
    before = registry.tagged("ros")
    script = project / "components/ros/install.sh"
    script.write_text(script.read_text() + "# a change\n")
    run = registry.publish(image_set, date=DAY, packages="2")
    assert registry.tagged("ros")["latest"] == before["latest"]
    assert any("something newer" in reason for reason in waiting(run, "alpha-base"))


def test_one_index_has_one_content(registry: Publisher, image_set: ImageSet) -> None:
    odd = {("alpha-core", "arm64"): {"io.rosml.python": "3.10"}}
    run = registry.publish(image_set, odd=odd)
    assert run.failed
    assert "alpha-core" not in registry.tagged("ros")
    (failed,) = [outcome for outcome in run.outcomes if outcome.state == "failed"]
    assert "python is nothing on amd64, 3.10 on arm64" in failed.reason


def test_a_day_has_one_date_and_its_second_tag_another_name(
    registry: Publisher, image_set: ImageSet, project: Path
) -> None:
    registry.publish(image_set)
    script = project / "components/ros/install.sh"
    script.write_text(script.read_text() + "# a change\n")
    first = registry.tagged("ros")["alpha-core-20261122"]
    registry.publish(image_set, date=DAY.replace("03:", "05:"), packages="2")
    tags = registry.tagged("ros")
    assert tags["alpha-core-20261122"] == first, "a dated tag moved"
    assert tags["alpha-core-20261122.2"] == tags["alpha-core"] != first


def test_tags_move_from_the_lasting_ones_to_the_floating_ones(
    registry: Publisher, image_set: ImageSet, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Whoever pulls a floating tag finds what it spells out as well, wherever a run ends."""
    moved: list[str] = []

    def tag(repository: str, target: str, name: str) -> None:
        if repository.endswith("/ros-torch"):
            moved.append(name)
        move(repository, target, name)

    move = registry.registry.tag
    monkeypatch.setattr(registry.registry, "tag", tag)
    registry.publish(image_set, only=[BASE])
    assert moved == ["alpha-base-cu1-20261122", "alpha-base-cu1-torch2.10.0", "alpha-base-cu1", "alpha", "latest"]


def test_tags_of_images_move_side_by_side(
    registry: Publisher, image_set: ImageSet, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Hundreds of images have thousands of tags: none waits for another image's."""
    both = threading.Barrier(2, timeout=20)

    def tag(repository: str, target: str, name: str) -> None:
        if name in ("alpha-core-20261122", "alpha-base-20261122"):
            both.wait()
        move(repository, target, name)

    move = registry.registry.tag
    monkeypatch.setattr(registry.registry, "tag", tag)
    run = registry.publish(image_set, only=["alpha-core", "alpha-base"])
    assert not run.failed and {"alpha-core", "alpha-base"} <= registry.tagged("ros").keys()


@pytest.mark.parametrize("what", ["index", "record"])
def test_indexes_are_made_and_records_attached_side_by_side(
    registry: Publisher, image_set: ImageSet, monkeypatch: pytest.MonkeyPatch, what: str
) -> None:
    """One after the other, those of hundreds of images take longer than a job may on a registry that is far away."""
    both, met = threading.Barrier(2, timeout=20), threading.local()

    def meet() -> None:
        if not hasattr(met, "once"):
            met.once = True
            both.wait()

    def put(repository: str, reference: str, content: Any, media_type: str = oci.IMAGE) -> str:
        if what == "index" and media_type == oci.INDEX:
            meet()
        return put_manifest(repository, reference, content, media_type)

    def attach(repository: str, subject: Any, artifact_type: str, *rest: Any) -> str:
        if what == "record" and artifact_type == store.ARTIFACT:
            meet()
        return attached(repository, subject, artifact_type, *rest)

    put_manifest, attached = registry.registry.put_manifest, registry.registry.attach
    monkeypatch.setattr(registry.registry, "put_manifest", put)
    monkeypatch.setattr(registry.registry, "attach", attach)
    monkeypatch.setattr(side_by_side, "AT_ONCE", 2)
    run = registry.publish(image_set, only=["alpha-core", "alpha-base"])
    assert not run.failed and {"alpha-core", "alpha-base"} <= registry.tagged("ros").keys()


def test_side_by_side_nothing_more_is_asked_for(
    project: Path, image_set: ImageSet, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Nor told in another order."""
    found = []
    for number in (1, 16):
        monkeypatch.setattr(side_by_side, "AT_ONCE", number)
        here = publisher(project, services(project), monkeypatch)
        run = here.publish(image_set)
        told = [(outcome.step, outcome.target, outcome.state, outcome.reason) for outcome in run.outcomes]
        found.append((here.registry.reads, here.registry.writes, told))
    assert found[0] == found[1]


def test_tags_of_the_first_images_move_before_the_last_ones_are_prepared(
    registry: Publisher, image_set: ImageSet, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A run that is ended by a limit of time has moved theirs, and undo knows them."""

    def attach(repository: str, subject: Any, artifact_type: str, *rest: Any) -> str:
        if artifact_type == store.ARTIFACT and registry.tagged("ros"):
            raise Killed
        return attached(repository, subject, artifact_type, *rest)

    attached = registry.registry.attach
    monkeypatch.setattr(registry.registry, "attach", attach)
    monkeypatch.setattr(promote, "BATCH", 2)
    with pytest.raises(Killed):
        registry.publish(image_set)
    assert {"alpha-core", "alpha-base"} <= registry.tagged("ros").keys()
    monkeypatch.undo()
    registry.undo()
    assert registry.tagged("ros") == {}


def test_a_run_past_midnight_has_one_date(
    registry: Publisher, image_set: ImageSet, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The clock goes on with every look at it; what the run is called does not."""
    moment = datetime(2026, 11, 22, 23, 59, 58, tzinfo=UTC)
    looked: list[str] = []

    def clock() -> str:
        looked.append((moment + timedelta(seconds=len(looked))).strftime(moments.TIME))
        return looked[-1]

    monkeypatch.setattr(build, "now", clock)
    date = clock()
    run = registry.publish(image_set, date=date)
    assert date.startswith("2026-11-22") and looked[-1].startswith("2026-11-23"), "nobody looked at the clock"
    assert {entry.date for entry in run.state.entries.values()} == {date}
    for repository in ("ros", "ros-torch", "part"):
        tags = registry.tagged(repository)
        dated = {name for name in tags if "-2026" in name}
        assert dated and all(name.endswith("-20261122") for name in dated)
        for name in tags.values():
            index = registry.registry.manifest(f"{PREFIX}/{repository}", name)
            assert index and index.content["annotations"][store.DATE] == date
    again = registry.publish(image_set, date=clock())
    assert (again.made, again.outcomes) == ([], [])


def test_an_image_in_which_no_test_ran_gets_no_tag(
    registry: Publisher, image_set: ImageSet, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Files of tests that have none, such as after a wrong edit."""
    real = Bytes.test
    monkeypatch.setattr(Bytes, "test", lambda *words: replace(real(*words), passed=0))
    run = registry.publish(image_set, only=["alpha-core"])
    assert registry.tagged("ros") == {}
    assert any("tested, and no test ran" in reason for reason in waiting(run, "alpha-core"))


def test_undo_brings_tags_back(registry: Publisher, image_set: ImageSet, project: Path) -> None:
    registry.publish(image_set)
    before = registry.tagged("ros")
    script = project / "components/ros/install.sh"
    script.write_text(script.read_text() + "# a change\n")
    registry.publish(image_set, date=NEXT, packages="2")
    registry.registry.tag(f"{PREFIX}/ros", before["alpha-core"], "omega-core")  # somebody's
    registry.undo(date=NEXT)
    after = registry.tagged("ros")
    assert after.pop("omega-core") == before["alpha-core"], "a tag that somebody else moved was moved"
    assert after == {name: target for name, target in before.items() if name != "omega-core"}
    held = registry.publish(image_set, date=LATER, packages="2")
    assert {**registry.tagged("ros"), "omega-core": ""} == {**before, "omega-core": ""}, "undone in vain"
    assert any("moved back on 2026-11-23" in reason for reason in waiting(held, "alpha-core"))
    script.write_text(script.read_text() + "# mended\n")
    registry.publish(image_set, date=LATER, packages="3")
    assert registry.tagged("ros")["alpha-core"] not in (before["alpha-core"], "")
    with pytest.raises(RosmlError, match="no record of a run of 2020"):
        registry.undo("2020-01-01T00:00:00Z")


def test_undo_brings_back_what_was_before_the_first_run_of_a_date(
    registry: Publisher, image_set: ImageSet, project: Path
) -> None:
    registry.publish(image_set)
    before = registry.tagged("ros")["alpha-core"]
    script = project / "components/ros/install.sh"
    for number in ("2", "3"):
        script.write_text(script.read_text() + "# a change\n")
        registry.publish(image_set, date=NEXT, packages=number)
    assert registry.tagged("ros")["alpha-core"] != before
    registry.undo(date=NEXT)
    assert registry.tagged("ros")["alpha-core"] == before


def test_undo_goes_on_after_a_tag_that_the_registry_keeps(registry: Publisher, image_set: ImageSet) -> None:
    """As on a registry that deletes no tags: every run has dated ones, which were nowhere before."""
    registry.publish(image_set)
    before = registry.tagged("ros")
    registry.packages["alpha"] = "tuesday"
    registry.publish(image_set, date=NEXT, packages="2")
    assert registry.tagged("ros")["alpha-core"] != before["alpha-core"]
    registry.registry.refuses.add("delete a tag")
    outcomes = registry.undo()
    after = registry.tagged("ros")
    assert {name: after[name] for name in before} == before
    assert "failed" in {outcome.state for outcome in outcomes} and "alpha-core-20261123" in after


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


def test_a_registry_that_is_down_is_not_asked_for_every_image(
    registry: Publisher, image_set: ImageSet, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked = []

    def down(*arguments: Any) -> None:
        asked.append(arguments)
        monkeypatch.setattr(registry.registry, "head", down)
        raise RosmlError("the registry does not answer")

    monkeypatch.setattr(registry.registry, "tag", down)
    with pytest.raises(RosmlError, match="does not answer"):
        registry.publish(image_set)
    assert len(asked) <= 2 * side_by_side.AT_ONCE < 2 * len(image_set.images), "those that were asked side by side"


def test_what_is_gone_from_the_registry_is_made_anew(registry: Publisher, image_set: ImageSet) -> None:
    registry.publish(image_set)
    entry = store.Records(registry.place).read("alpha-core", "amd64")
    assert entry
    del registry.registry.manifests[f"{PREFIX}/ros"][entry.digest]
    run = registry.publish(image_set, date=NEXT)
    assert steps(run, "build") == {("alpha-core", "amd64")}


def test_with_a_scan_required_only_what_it_found_clean_gets_tags(registry: Publisher, image_set: ImageSet) -> None:
    """A part is not scanned by itself: it goes with an image that has it."""
    policy = "sha256:1"
    registry.publish(image_set, scanning=policy)
    assert not any(registry.tagged(name) for name in ("ros", "ros-torch", "part"))
    run = registry.run(image_set, date=NEXT, scanning=policy)
    for key, item in run.state.by_key.items():
        if item.kind != "part" and item.target != "omega-core":
            entry = replace(run.state.entries[key], scanned="clean", scan={"policy": policy})
            run.records.write(entry, run.state.inputs.of(*key))
    registry.publish(image_set, date=NEXT, scanning=policy)
    assert "alpha-core" in registry.tagged("ros") and "omega-core" not in registry.tagged("ros")
    assert "torch-cu1-py312" in registry.tagged("part")
    again = registry.publish(image_set, date="2026-11-24T03:00:00Z", scanning=policy)
    assert {outcome.target for outcome in again.outcomes} == {"omega-core"}


def test_a_lock_of_another_version_makes_nothing(registry: Publisher, image_set: ImageSet, project: Path) -> None:
    """A stack was given a new release, and nobody ran 'rosml locks': its part waits, as its images do."""
    lock = next(name for name in image_set.by_target[BASE].locks if name.endswith("amd64/3.12/torch.txt"))
    (project / lock).write_text((project / lock).read_text().replace("torch==2.10.0", "torch==2.9.1"))
    stale = locked.with_locks(image_set, locked.current_locks(image_set, project))
    run = registry.publish(stale, architectures=("amd64",))
    assert ("part-torch-cu1-py312", "amd64") not in steps(run, "build")
    assert "torch-cu1-py312" not in registry.tagged("part")
    found = run.state.hindrance(run.state.by_key["part-torch-cu1-py312", "amd64"])
    assert found == run.state.hindrance(run.state.by_key[BASE, "amd64"]) == f"lock missing: {lock}"


def test_force_makes_everything_anew_once(registry: Publisher, image_set: ImageSet) -> None:
    first = registry.publish(image_set)
    run = registry.publish(image_set, date=NEXT, force=True)
    assert sorted(steps(run, "build")) == sorted(steps(first, "build"))
    assert len(run.made) == len(set(run.made))


@pytest.mark.parametrize("after", [False, True], ids=["before", "after"])
def test_killed_at_any_write(project: Path, image_set: ImageSet, monkeypatch: pytest.MonkeyPatch, after: bool) -> None:
    """Every fifth write of a run is the last one once. Nothing partial has a tag, and the next run finishes the work."""
    small = parse(SMALLER.replace("components: [core, base]", "components: [core]"))
    small = locked.with_locks(small, locked.current_locks(small, project))
    inputs = Inputs(project, small)
    options: dict[str, Any] = {"only": ["alpha-core", "alpha-core-torch-cu1"], "inputs": inputs}

    def signing() -> Publisher:
        found = publisher(project, services(project), monkeypatch)
        found.pen = Pen(found.registry)
        return found

    whole = signing()
    reference = whole.publish(small, **options)
    assert whole.registry.writes > 80
    for number in range(1, whole.registry.writes + 1, 5):
        here = signing()
        here.registry.die_at, here.registry.die_after = number, after
        run = here.run(small, **options)
        with pytest.raises(Killed):
            for step in STEPS:
                STEPS[step](run)
        here.check(small)
        recorded = {
            key for key, entry in here.run(small, **options).state.entries.items() if entry.digest and not entry.failed
        }
        again = here.publish(small, date=NEXT, **options)
        here.check(small)
        assert not again.failed
        assert not (steps(again, "build") | steps(again, "join")) & recorded, "what was done is done again"
        for repository in ("ros", "ros-torch", "part"):
            undated = {name for name in whole.tagged(repository) if "-2026" not in name}
            assert undated <= here.tagged(repository).keys(), f"write {number}: tags are missing"
    assert {step for step, *_ in reference.made} == {"build", "join", "test"}


def test_a_registry_that_refuses_leaves_the_others_alone(registry: Publisher, image_set: ImageSet) -> None:
    registry.publish(image_set, only=["alpha-core"])
    before = registry.tagged("ros")
    registry.registry.refuses.add("move a tag")
    refused = registry.publish(image_set)
    assert refused.failed and any("refuses to move a tag" in outcome.reason for outcome in refused.outcomes)
    assert registry.tagged("ros") == before
    registry.registry.refuses.clear()
    run = registry.publish(image_set)
    assert not run.made
    assert "alpha-base" in registry.tagged("ros")


def test_selection(image_set: ImageSet) -> None:
    assert [image.target for image in selection.select(image_set, ["alpha-core"])] == ["alpha-core"]
    tagged = selection.select(image_set, ["ros-torch:*-cu1"])
    assert {(image.framework, image.stack) for image in tagged} == {("torch", "cu1")}
    assert all(image.distribution == "omega" for image in selection.select(image_set, ["omega"]))
    assert {image.framework for image in selection.select(image_set, ["*-torch-*"])} == {"torch"}
    with pytest.raises(RosmlError, match="no image named 'alpha-cor'; did you mean 'alpha-core'"):
        selection.select(image_set, ["alpha-cor"])


@pytest.mark.parametrize(
    "text",
    (
        *("", "ghcr.io", "ghcr.io/", "ghcr.io/Me/x", "https://ghcr.io/me", "ghcr.io//x", "a b/c"),
        *("[:::]/x", "../x", "a..b/x", "-/x", "localhost:70000/x", "localhost:0/x", "localhost:\u0665/x"),
    ),
)
def test_a_place_that_is_none(text: str) -> None:
    with pytest.raises(RosmlError, match="no place for images"):
        Place.at(text)


@pytest.mark.parametrize(
    "text",
    ["", "today", "9999-99-99T99:99:99Z", "\u0662\u0660\u0662\u0666-11-22T03:00:00Z", "2026-1-2T3:4:5Z", f"{DAY}\n"],
)
def test_a_date_that_is_none(text: str) -> None:
    assert moments.checked_date(DAY) == DAY
    with pytest.raises(RosmlError, match="is no time"):
        moments.checked_date(text)


def test_an_architecture_that_is_none(image_set: ImageSet) -> None:
    selection.require_architectures(image_set, ["amd64", "arm64"])
    with pytest.raises(RosmlError, match="no architecture named 'amd46'; did you mean 'amd64'"):
        selection.require_architectures(image_set, ["amd46"])


def test_places() -> None:
    for text, host, prefix in (
        ("[::1]:5000/x", "[::1]:5000", "x"),
        ("127.0.0.1:5000/rosml", "127.0.0.1:5000", "rosml"),
        ("ghcr.io/me/ros-ml/", "ghcr.io", "me/ros-ml"),
    ):
        place = Place.at(text)
        assert (place.client.host, place.prefix, str(place)) == (host, prefix, text.rstrip("/"))


def test_a_damaged_entry_is_as_good_as_none() -> None:
    registry = MemoryRegistry()
    book = store.Records(Place(registry, PREFIX))
    for content in (
        "",
        "[]",
        '{"target": "x"}',
        '{"target": "x", "architecture": "amd64", "later": 1}',
        '{"target": 1}',
    ):
        book.artifact("x.amd64", b"{}", {store.ANNOTATION: content})
        assert book.read("x", "amd64") is None
    entry = store.Entry(
        "x", "amd64", digest="sha256:1", parts={"a": "b"}, superseded=("sha256:0",), seconds={"build": 1.5}
    )
    book.write(entry, {"argument A": "1"})
    assert book.read("x", "amd64") == entry
    assert book.inputs("x", "amd64") == {"argument A": "1"}
    book.write(entry.with_digest("sha256:2"))
    assert book.inputs("x", "amd64") == {"argument A": "1"}
    assert book.read("x", "amd64").superseded == ("sha256:0", "sha256:1")  # type: ignore[union-attr]


# ---- Dates, and entries, that somebody wrote -------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("date", "clock", "fine"),
    [
        ("2026-11-23T02:00:00Z", DAY, True),
        (NEXT, DAY, True),
        ("2026-11-23T03:00:01Z", DAY, False),
        ("2099-01-01T00:00:00Z", DAY, False),
        ("1999-01-01T00:00:00Z", DAY, True),
    ],
)
def test_a_run_of_the_future(date: str, clock: str, fine: bool) -> None:
    if fine:
        moments.require_not_ahead(date, clock)
        return
    with pytest.raises(RosmlError, match=rf"{date} is in the future \(it is {clock}\)") as caught:
        moments.require_not_ahead(date, clock)
    assert caught.value.exit_code == 2 and "--force" in caught.value.remedy


def test_a_tag_of_the_future_says_so_and_moves_when_forced(
    registry: Publisher, image_set: ImageSet, project: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(moments, "now", lambda: NEXT)
    registry.publish(image_set, only=["alpha-core"], date="2099-01-01T00:00:00Z")
    pinned = registry.tagged("ros")["alpha-core"]
    script = project / "components/ros/install.sh"
    script.write_text(script.read_text() + "# a change\n")
    run = registry.publish(image_set, only=["alpha-core"], date=NEXT, packages="2")
    assert registry.tagged("ros")["alpha-core"] == pinned
    assert any("of 2099-01-01T00:00:00Z, which is in the future" in reason for reason in waiting(run, "alpha-core"))
    (found,) = status.read(run.state, NEXT)
    assert found.reason.endswith("its date 2099-01-01T00:00:00Z is in the future")
    registry.publish(image_set, only=["alpha-core"], date=LATER, packages="2", force=True)
    assert registry.tagged("ros")["alpha-core"] != pinned


def odd_index(registry: Publisher, tag: str, **annotations: Any) -> str:
    """Gives what a tag points at other annotations, as somebody may who can push."""
    path = f"{PREFIX}/ros"
    found = registry.registry.manifest(path, tag)
    assert found
    content = found.content | {"annotations": found.content["annotations"] | annotations}
    return registry.registry.put_manifest(path, tag, content, found.media_type)


@pytest.mark.parametrize("date", ["yesterday", "2026-11-22", "zzz", 5, ["x"]])
def test_a_date_that_is_none_is_told_and_holds_no_tag(
    registry: Publisher, image_set: ImageSet, project: Path, date: Any
) -> None:
    registry.publish(image_set, only=["alpha-core"])
    there = odd_index(registry, "alpha-core", **{store.DATE: date})
    script = project / "components/ros/install.sh"
    script.write_text(script.read_text() + "# a change\n")
    run = registry.run(image_set, only=["alpha-core"], date=NEXT, packages="2")
    (found,) = status.read(run.state, NEXT)
    assert "its date is not valid" in found.reason and found.age is None
    said: list[str] = []
    run.say = said.append
    for step in STEPS:
        STEPS[step](run)
    assert not run.failed
    assert registry.tagged("ros")["alpha-core"] != there
    assert any("and is taken for older" in line for line in said)


def forge(registry: Publisher, target: str, architecture: str, **facts: Any) -> None:
    """Writes an entry of the records by hand."""
    book = store.Records(registry.place)
    entry = book.read(target, architecture)
    assert entry
    book.write(replace(entry, **facts))


def test_the_digest_of_another_image_gets_no_index(registry: Publisher, image_set: ImageSet, project: Path) -> None:
    registry.publish(image_set)
    before = registry.tagged("ros")
    core = store.Records(registry.place).read("alpha-core", "amd64")
    assert core
    forge(registry, "alpha-base", "amd64", digest=core.digest)
    run = registry.run(image_set, date=NEXT, only=["alpha-base"])
    STEPS["index"](run)
    STEPS["promote"](run)
    (failed,) = [outcome for outcome in run.outcomes if outcome.state == "failed"]
    assert f"the records' entry alpha-base.amd64 names {core.digest}, which is alpha-core for amd64" in failed.reason
    assert registry.tagged("ros") == before


def test_the_digest_of_another_architecture_gets_no_index(registry: Publisher, image_set: ImageSet) -> None:
    registry.publish(image_set)
    other = store.Records(registry.place).read("alpha-core", "arm64")
    assert other
    forge(registry, "alpha-core", "amd64", digest=other.digest)
    run = registry.run(image_set, date=NEXT, only=["alpha-core"])
    STEPS["index"](run)
    assert any("which is alpha-core for arm64" in outcome.reason for outcome in run.outcomes)


@pytest.mark.parametrize("what", ["title", "members", "gone"])
def test_the_index_of_another_image_gets_no_tag(registry: Publisher, image_set: ImageSet, what: str) -> None:
    registry.publish(image_set)
    book = store.Records(registry.place)
    own, other = book.read("alpha-core", "index"), book.read("alpha-base", "index")
    assert own and other
    digest = {"title": other.digest, "gone": "sha256:" + "0" * 64}.get(what, "")
    if what == "members":
        whole = registry.registry.manifest(f"{PREFIX}/ros", own.digest)
        assert whole
        part = whole.content | {"manifests": whole.content["manifests"][:1]}
        digest = registry.registry.put_manifest(f"{PREFIX}/ros", "odd", part, whole.media_type)
    forge(registry, "alpha-core", "index", digest=digest)
    run = registry.run(image_set, date=NEXT, only=["alpha-core"])
    run.state.present.add(("alpha-core", "index"))
    before = registry.tagged("ros")
    STEPS["promote"](run)
    assert run.failed and registry.tagged("ros") == before
    reason = next(outcome.reason for outcome in run.outcomes if outcome.state == "failed")
    says = {"title": "that of alpha-base", "members": "of other images", "gone": "not in the registry any more"}
    assert says[what] in reason


def test_a_second_undo_says_that_nothing_is_left(registry: Publisher, image_set: ImageSet) -> None:
    registry.publish(image_set)
    registry.packages["alpha"] = "tuesday"
    registry.publish(image_set, date=NEXT, packages="2")
    assert {outcome.state for outcome in registry.undo()} == {"done"}
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
        here.packages["alpha"] = "tuesday"
        here.publish(image_set, date=NEXT, packages="2", **options)
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
    registry.packages["alpha"] = "tuesday"
    registry.publish(image_set, date=NEXT, packages="2")
    there = registry.tagged("ros")["alpha-core"]
    registry.undo()
    forced = registry.publish(image_set, date=LATER, packages="2", force=True)
    assert not forced.failed and not waiting(forced, "alpha-core")
    assert registry.tagged("ros")["alpha-core"] not in ("", there)
    now, then = (registry.registry.manifest(f"{PREFIX}/ros", name) for name in ("alpha-core", there))
    assert now and then and now.content["manifests"] == then.content["manifests"], "the same images"


# ---- Others at work --------------------------------------------------------------------------------------------------


def test_what_moves_between_two_steps_is_the_next_runs(
    registry: Publisher, image_set: ImageSet, tmp_path: Path
) -> None:
    """Each step on a machine of its own asks nobody anew of when packages are."""
    file = tmp_path / "plan.json"
    file.write_text(make_plan(registry.run(image_set).state, 2).text())
    known = read_plan(file).package_state
    assert known == registry.packages
    for number, step in enumerate(STEPS):
        run = registry.run(image_set, package_state=known)
        STEPS[step](run)
        assert not run.failed
        assert not [outcome for outcome in run.outcomes if outcome.state == "waits"]
        registry.packages["alpha"] = f"after step {number}"
    assert registry.tagged("ros").keys() >= {"alpha-core", "alpha", "omega-base"}
    following = registry.publish(image_set, date=NEXT, packages="2")
    assert ("alpha-core", "amd64") in steps(following, "build")


BEFORE = "2026-11-20T21:14:09Z, ubuntu noble 0123456789abcdef"
AFTER = "2026-11-22T03:30:00Z, ubuntu noble 0123456789abcdef"


def live(registry: Publisher, run: Run, syncs: dict[str, str], monkeypatch: pytest.MonkeyPatch) -> Run:
    """A run whose builds fail, as `require_sync` does, where ROS's repository is of another time than they are told.

    Args:
        syncs: what the repository of alpha becomes when a target is first about to be built.
    """
    assert run.maker
    build = run.maker.build_image

    def build_image(image: sets.Image, architecture: str, parts: dict[str, str], moment: str) -> maker.Made:
        if when := syncs.pop(image.target, ""):
            registry.packages["alpha"] = when
        if registry.packages[image.distribution] != moment:
            raise RosmlError(f"{image.target}: http://packages.example is of another time", "run it again")
        return build(image, architecture, parts, moment)

    monkeypatch.setattr(run.maker, "build_image", build_image)
    return run


def test_a_sync_between_plan_and_build_costs_no_night(
    registry: Publisher, image_set: ImageSet, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The row is begun anew: all of its components are of one moment, on each of two machines."""
    registry.packages = {"alpha": BEFORE, "omega": BEFORE}
    known = dict(registry.run(image_set).state.package_state)
    for architecture, syncs in (("amd64", {"alpha-base": AFTER}), ("arm64", {})):
        run = live(
            registry, registry.run(image_set, package_state=known, architectures=(architecture,)), syncs, monkeypatch
        )
        for step in ("build", "join", "test"):
            STEPS[step](run)
        assert not run.failed
        built = [target for step, target, _ in run.made if step == "build" and target.startswith("alpha")]
        again = ["alpha-core"] if syncs == {} and architecture == "amd64" else []
        assert built == [*again, "alpha-core", "alpha-base"]
        assert {outcome.reason for outcome in run.outcomes if outcome.state == "waits"} <= {"it is not made yet"}
    rest = registry.run(image_set, package_state=known)
    for step in ("index", "promote"):
        STEPS[step](rest)
    assert [outcome for outcome in rest.outcomes if outcome.state != "done"] == []
    assert registry.tagged("ros").keys() >= {"alpha-core", "alpha", "omega-base"}
    book = store.Records(registry.place)
    for target, moment in (("alpha-core", AFTER), ("alpha-base", AFTER), ("omega-base", BEFORE)):
        for architecture in ("amd64", "arm64"):
            entry = book.read(target, architecture)
            assert entry and entry.package_state == moment
    assert registry.publish(image_set, date=NEXT).made == []


def test_a_repository_that_never_rests_fails_its_row_alone(
    registry: Publisher, image_set: ImageSet, monkeypatch: pytest.MonkeyPatch
) -> None:
    registry.packages = {"alpha": BEFORE, "omega": BEFORE}
    run = live(registry, registry.run(image_set), {}, monkeypatch)
    hours = iter(range(10))
    monkeypatch.setattr(
        "rosml.images.builds.package_state.state",
        lambda _services, _matrix, name: f"2026-11-22T0{next(hours)}:00:00Z" if name == "alpha" else BEFORE,
    )
    registry.packages["alpha"] = "2026-11-23T00:00:00Z"
    STEPS["build"](run)
    assert {outcome.target for outcome in run.outcomes if outcome.state == "failed"} == {"alpha-core"}
    assert {target for target, _ in steps(run, "build")} >= {"omega-core", "omega-base"}


def test_a_run_that_may_not_push_is_told_before_its_first_work(registry: Publisher, image_set: ImageSet) -> None:
    registry.registry.refuses.add("push")
    run = registry.run(image_set)
    with pytest.raises(RosmlError, match="nobody push"):
        STEPS["build"](run)
    assert run.made == [] and registry.registry.writes == 0
    registry.registry.refuses.clear()
    registry.publish(image_set)
    registry.registry.refuses.add("push")
    assert registry.publish(image_set, date=NEXT).outcomes == [], "with nothing to do nothing is asked"


def test_what_was_in_an_images_place_is_forgotten_when_it_is_gone(
    registry: Publisher, image_set: ImageSet, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(running, "SUPERSEDED", 3)
    for number in range(6):
        registry.packages["alpha"] = f"day {number}"
        registry.publish(image_set, only=["alpha-core"], date=f"2026-11-0{number + 1}T03:00:00Z", packages=str(number))
    book = store.Records(registry.place)
    many = book.read("alpha-core", "amd64")
    assert many and len(many.superseded) == 5, "what is there stays known: prune removes it"
    for digest in many.superseded[:4]:
        del registry.registry.manifests[f"{PREFIX}/ros"][digest]
    registry.packages["alpha"] = "another day"
    registry.publish(image_set, only=["alpha-core"], date="2026-11-07T03:00:00Z", packages="7")
    few = book.read("alpha-core", "amd64")
    assert few and few.superseded == (many.superseded[4], many.digest)


# ---- What the builder is told ----------------------------------------------------------------------------------------


def told(
    run: Run, target: str, monkeypatch: pytest.MonkeyPatch, asked: Callable[[], str]
) -> tuple[list[str], dict[str, str]]:
    """The overrides and variables with which a ROS image is built on this machine's own architecture."""
    calls: list[buildx.Bake] = []

    def run_all(_services: Services, call: buildx.Bake) -> tuple[None, dict[str, dict[str, str]]]:
        calls.append(call)
        digest = put_image(run.state.place.client, f"{PREFIX}/ros", architecture, {}, [])
        return None, {call.target: {"containerimage.digest": digest}}

    monkeypatch.setattr(buildx, "run_all", run_all)
    monkeypatch.setattr(contents, "attach", lambda *facts: {digest: "sha256:sbom" for _, digest in facts[3]})
    monkeypatch.setattr(
        base_images, "reference", lambda _services, systems, name, *_: f"base-of-{systems[name].python}"
    )
    monkeypatch.setattr(Services, "require_builder", lambda *_: None)
    monkeypatch.setattr(sync, "published", lambda *_: asked())
    architecture = base_images.native_architecture()
    item = run.state.by_key[target, architecture]
    assert isinstance(item.thing, sets.Image)
    for name in item.thing.architectures:
        run.state.entries[target, name] = store.Entry(target, name, package_state="sunday")
    services, silent = run.state.request.services, lambda line: None
    real = BuildKitMaker(services, run.state.image_set, run.state.place, silent, run.state.request.force)
    STEPS["build"](running.Run(run.state, real, silent))
    (call,) = [call for call in calls if call.target == target and call.name == f"build-{target}-{architecture}"]
    where = run.state.place.reference("ros")
    assert call.sets[0].startswith(f"{target}.output=type=image,name={where},push=true,push-by-digest=true,")
    return list(call.sets[1:]), dict(call.variables)


@pytest.mark.parametrize("broken", [False, True])
def test_what_an_image_is_made_of_is_built_by_one_call(
    registry: Publisher, image_set: ImageSet, monkeypatch: pytest.MonkeyPatch, broken: bool
) -> None:
    """And listed by one call. If the build fails, one after the other, so that each says why."""
    image = next(image for image in image_set.images if len(image.parts) > 1 and image.parent == "alpha-base")
    calls: list[tuple[str, ...]] = []
    said: list[str] = []
    described: list[int] = []
    run = registry.run(image_set, only=[image.target])

    def run_all(_services: Services, call: buildx.Bake) -> tuple[None, dict[str, dict[str, str]]]:
        targets = call.target, *call.beside
        calls.append(targets)
        assert all(any(item.startswith(f"{name}.output=") for item in call.sets) for name in targets)
        if broken and call.beside:
            raise RosmlError("a step failed")
        found = {}
        for target in targets:
            [thing] = [item.thing for item in run.state.items if item.target == target]
            repository = f"{PREFIX}/{sets.repository_of(thing)}"
            found[target] = put_image(registry.registry, repository, architecture, {}, [target.encode()])
        return None, {target: {"containerimage.digest": digest} for target, digest in found.items()}

    monkeypatch.setattr(buildx, "run_all", run_all)

    def attach(*facts: Any) -> dict[str, str]:
        described.append(len(facts[3]))
        return {digest: "sha256:sbom" for _, digest in facts[3]}

    monkeypatch.setattr(contents, "attach", attach)
    monkeypatch.setattr(
        base_images, "reference", lambda _services, systems, name, *_: f"base-of-{systems[name].python}"
    )
    monkeypatch.setattr(base_images, "assembler", lambda *_: base_images.Assembler("base-of-3.12", "3.12"))
    monkeypatch.setattr(Services, "require_builder", lambda *_: None)
    architecture = base_images.native_architecture()
    run.state.items = tuple(item for item in run.state.items if item.architecture == architecture)
    real = BuildKitMaker(registry.services, image_set, run.state.place, said.append)
    STEPS["build"](running.Run(run.state, real, said.append, whole=True))
    first, *others = (item.target for item in run.state.items if isinstance(item.thing, Image) and not item.thing.stack)
    parts = {item.target for item in run.state.items if item.kind == "part"}
    assert {*calls[0]} == {first, *parts} and others
    separate = {(target,) for target in ({first, *parts, *others} if broken else others)}
    assert {*calls[1:]} == separate and len(calls[1:]) == len(separate)
    assert "a step failed\nnow one after the other" in said or not broken
    assert described == [1] * len(separate) if broken else described == [1 + len(parts), *[1] * len(others)]
    assert all(run.state.is_current((target, architecture)) for target in {first, *parts, *others})


def never() -> str:
    raise AssertionError("all steps take packages to be of the plan's moment")


def test_packages_are_of_the_plans_moment(
    registry: Publisher, image_set: ImageSet, monkeypatch: pytest.MonkeyPatch
) -> None:
    """With the first component the essentials as well, which the builder would keep for ever."""
    folder = registry.services.state / "package-state/alpha"
    registry.packages["alpha"] = "monday, ubuntu noble 0123456789abcdef"
    [system] = {image.os for image in image_set.images if image.target == "alpha-core"}
    for target, targets in (("alpha-core", {names.os_target(system), "alpha-core"}), ("alpha-base", {"alpha-base"})):
        sets, variables = told(registry.run(image_set, only=[target]), target, monkeypatch, never)
        assert set(sets) == {f"{target}.tags=", *(f"{name}.contexts.upstream={folder}" for name in targets)}
        assert (folder / "moment").read_text() == "monday, ubuntu noble 0123456789abcdef\n"
        assert json.loads(variables["ROS_SYNC_DATES"]) == {"alpha": "monday"}
        sets, _ = told(registry.run(image_set, date=NEXT, force=True, only=[target]), target, monkeypatch, never)
        assert set(sets) == {f"{target}.tags=", *(f"{name}.no-cache=true" for name in targets)}


def test_a_repository_that_did_not_answer_the_plan(
    registry: Publisher, image_set: ImageSet, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Its packages are taken for those of the last build."""
    registry.packages["alpha"] = "down"
    _, variables = told(registry.run(image_set, only=["alpha-core"]), "alpha-core", monkeypatch, never)
    assert json.loads(variables["ROS_SYNC_DATES"]) == {"alpha": "sunday"}


def test_a_part_is_assembled_anew_when_that_is_asked_for(
    registry: Publisher, image_set: ImageSet, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Past the builder's cache."""
    seen: list[bool] = []
    wanted = image_set.parts[0].target

    def run_all(_services: Services, call: buildx.Bake) -> tuple[None, dict[str, dict[str, str]]]:
        seen.append(f"{wanted}.no-cache=true" in call.sets)
        digest = put_image(registry.registry, f"{PREFIX}/part", "amd64", {}, [])
        return None, {wanted: {"containerimage.digest": digest}}

    monkeypatch.setattr(buildx, "run_all", run_all)
    monkeypatch.setattr(base_images, "assembler", lambda *_: base_images.Assembler(PINNED, ""))
    monkeypatch.setattr(contents, "attach", lambda *facts: {digest: "sha256:sbom" for _, digest in facts[3]})
    for force in (False, True):
        made = BuildKitMaker(registry.services, image_set, registry.place, lambda line: None, force)
        made.build_part(image_set.parts[0], "amd64")
    assert seen == [False, True]
