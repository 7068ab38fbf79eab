"""A publishing run: what it builds, what it leaves alone, and that no tag points at an untested, partial or older image."""

from __future__ import annotations

import itertools
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import Any

import pytest
from conftest import SMALLER, parse

from fakes.memory_registry import (
    NEXT,
    PREFIX,
    Killed,
    Pen,
    Publisher,
    Run,
    publisher,
    steps,
    waiting,
)
from fakes.projects import BASE
from fakes.stubs import services
from rosml.base import clock, side_by_side
from rosml.base.errors import RosmlError
from rosml.cli.images import report
from rosml.images.bake.inputs import Inputs
from rosml.images.builds import maker
from rosml.images.image_set import locked
from rosml.images.image_set.model import Image, ImageSet
from rosml.images.publish import run as running
from rosml.images.publish.plan import make_plan, read_plan
from rosml.images.publish.steps import STEPS, build, images, promote
from rosml.images.records import store
from rosml.machine import buildx


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
    assert (again.actions, again.outcomes, registry.registry.writes) == ([], [], before)


def test_a_change_rebuilds_only_what_it_reaches(registry: Publisher, image_set: ImageSet) -> None:
    registry.publish(image_set)
    before = registry.tagged("ros")
    registry.change("components/torch/files.sh")
    run = registry.publish(image_set, date=NEXT)
    assert steps(run, "build") == {
        (part.target, name) for part in image_set.parts if part.kind == "torch" for name in part.architectures
    }
    with_torch = {image.target for image in image_set.images if "torch" in image.versions}
    assert {target for target, _ in steps(run, "join")} == with_torch
    assert registry.tagged("ros") == before
    assert f"{BASE.replace('-torch', '')}-20261123" in registry.tagged("ros-torch")
    registry.check(image_set)


def test_a_changed_test_builds_nothing(registry: Publisher, image_set: ImageSet) -> None:
    registry.publish(image_set)
    registry.change("tests/structure/torch.yaml")
    run = registry.publish(image_set, date=NEXT)
    assert {step for step, *_ in run.actions} == {"test"}
    assert {target for target, _ in steps(run, "test")} == {i.target for i in image_set.images if "torch" in i.versions}


def test_packages_that_moved_rebuild_ros_images_and_join_only_if_they_differ(
    registry: Publisher, image_set: ImageSet
) -> None:
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
    assert run.actions == []
    assert any("alpha" in remark and "does not answer" in remark for remark in run.state.remarks)


def test_a_poisoned_image_keeps_its_tags_and_stops_no_other(registry: Publisher, image_set: ImageSet) -> None:
    registry.publish(image_set)
    before = registry.tagged("ros-torch")
    registry.change()
    run = registry.publish(image_set, date=NEXT, packages="2", poisoned={BASE})
    assert run.failed
    after = registry.tagged("ros-torch")
    kept = {"alpha-base-cu1", "alpha", "latest"}
    assert {name: after[name] for name in kept} == {name: before[name] for name in kept}
    assert after["alpha-core-cu1"] != before["alpha-core-cu1"]
    assert any("tests failed" in reason for reason in waiting(run, BASE))
    repeated = registry.publish(image_set, date=NEXT, packages="2")
    assert repeated.actions == [("test", BASE, "amd64")]
    assert registry.tagged("ros-torch")["latest"] != before["latest"]
    registry.check(image_set)


# ---- The order of work -----------------------------------------------------------------------------------------------


def test_each_image_is_tested_as_soon_as_it_is_built(registry: Publisher, image_set: ImageSet) -> None:
    """One stack after the other, so that the builder fetches its parts once. Images that test what others of their stack
    share come first, so that a run that ends early leaves whole images."""
    run = registry.run(image_set)
    images(run)
    actions = [(step, target) for step, target, _ in run.actions]
    assert actions[:4] == [("build", "alpha-core"), ("test", "alpha-core")] * 2, "on both architectures"
    joins = [image_set.by_target[target] for step, target in actions if step == "join"]
    for _, of_stack in itertools.groupby(joins, lambda image: image.stack):
        carries = [image.carriers[0] == image.target for image in of_stack]
        assert carries == sorted(carries, reverse=True)
    stacks = [image.stack or "" for image in joins]
    assert stacks == sorted(stacks) and len({*stacks}) > 1
    assert all(actions[i + 1] == ("test", target) for i, (step, target) in enumerate(actions) if step == "join")
    other = Publisher(registry.services, packages=registry.packages)
    assert sorted(run.actions) == sorted(other.publish(image_set).actions)


def test_a_build_that_failed_on_another_machine_is_tried_here(registry: Publisher, image_set: ImageSet) -> None:
    run = registry.run(image_set)
    item = next(item for item in run.state.items if item.kind == "part")
    run.state.present.add(item.key)
    failed = {"step": "build", "reason": "it broke"}
    run.records.write(store.Entry(*item.key, repository=item.repository, failed=failed), {})
    run.state.look_again(item)
    assert run.state.entries[item.key].failed and item.key not in run.state.present
    assert run.state.reasons(item) == ["it was never made"]


def test_a_test_that_fails_is_not_repeated_in_the_same_run(registry: Publisher, image_set: ImageSet) -> None:
    run = registry.run(image_set, poisoned={"alpha-core"})
    images(run)
    assert [o.state for o in run.outcomes if (o.step, o.target) == ("test", "alpha-core")] == ["failed"] * 2


def test_a_run_whose_time_is_over_leaves_tested_images(
    registry: Publisher, image_set: ImageSet, monkeypatch: pytest.MonkeyPatch
) -> None:
    ticks = iter(range(10_000))
    monkeypatch.setattr("rosml.images.publish.run.time.monotonic", lambda: float(next(ticks)))
    run = registry.run(image_set)
    images(run, minutes=1)
    STEPS["index"](run)
    promote.promote(run)
    assert not run.failed and run.actions
    assert any(outcome.reason == "the time of this run is over" for outcome in run.outcomes)
    assert registry.tagged("ros") and not registry.tagged("ros-torch")
    registry.check(image_set)
    rest = registry.publish(image_set, date=NEXT)
    assert not set(rest.actions) & set(run.actions)
    registry.check(image_set)


def test_the_wait_for_another_build_does_not_count_as_work(
    registry: Publisher, image_set: ImageSet, monkeypatch: pytest.MonkeyPatch
) -> None:
    waits = itertools.count(step=85)
    monkeypatch.setattr(buildx, "waited", lambda: float(next(waits)))
    run = registry.publish(image_set)
    build = next(outcome for outcome in run.outcomes if outcome.step == "build")
    entry = run.state.entries[build.target, build.architecture]
    assert build.waited == 85
    assert entry.seconds["build"] == round(build.seconds - 85, 2)
    assert "(1 min 25 s of it waiting for another build)" in report.markdown(run)


def test_an_index_waits_for_all_architectures(registry: Publisher, image_set: ImageSet) -> None:
    first = registry.publish(image_set, architectures=("amd64",))
    assert "alpha-core" not in registry.tagged("ros")
    assert "alpha-base-cu1" in registry.tagged("ros-torch"), "it is for amd64 alone"
    assert waiting(first, "alpha-core")
    second = registry.publish(image_set, architectures=("arm64",), date=NEXT)
    assert not [key for key in second.actions if key in first.actions]
    assert "alpha-core" in registry.tagged("ros")
    registry.check(image_set)


def test_a_distribution_whose_packages_are_not_published_is_left_out(registry: Publisher, image_set: ImageSet) -> None:
    registry.publish(image_set, only=["alpha-core"])
    registry.absent = {("omega", name, "ros-omega-ros-core") for name in ("amd64", "arm64")}
    registry.absent |= {("alpha", "amd64", "ros-alpha-ros-base")}
    run = registry.publish(image_set, date=NEXT)
    assert not run.failed
    reason = "the archive has no ros-omega-ros-core for ubuntu-26.04, amd64"
    assert reason in waiting(run, "omega-core") and f"{reason} (for omega-core)" in waiting(run, "omega-base")
    assert {name for name, _ in steps(run, "build")} == {"alpha-base"} | {x.target for x in image_set.parts}
    assert "alpha-core" in registry.tagged("ros") and "alpha-base" not in registry.tagged("ros")
    registry.absent.clear()
    registry.publish(image_set, date=NEXT)
    assert "omega-core" in registry.tagged("ros")
    registry.check(image_set)


def test_a_lock_of_another_version_builds_nothing(registry: Publisher, image_set: ImageSet, project: Path) -> None:
    lock = next(name for name in image_set.by_target[BASE].locks if name.endswith("amd64/3.12/torch.txt"))
    (project / lock).write_text((project / lock).read_text().replace("torch==2.10.0", "torch==2.9.1"))
    stale = locked.with_locks(image_set, locked.current_locks(image_set, project))
    run = registry.publish(stale, architectures=("amd64",))
    assert ("part-torch-cu1-py312", "amd64") not in steps(run, "build")
    for target in ("part-torch-cu1-py312", BASE):
        assert run.state.hindrance(run.state.by_key[target, "amd64"]) == f"lock missing: {lock}"


def test_what_is_gone_from_the_registry_is_rebuilt(registry: Publisher, image_set: ImageSet) -> None:
    registry.publish(image_set)
    entry = store.Records(registry.place).read("alpha-core", "amd64")
    assert entry
    del registry.registry.manifests[f"{PREFIX}/ros"][entry.digest]
    run = registry.publish(image_set, date=NEXT)
    assert steps(run, "build") == {("alpha-core", "amd64")}


def test_force_rebuilds_everything_once(registry: Publisher, image_set: ImageSet) -> None:
    first = registry.publish(image_set)
    run = registry.publish(image_set, date=NEXT, force=True)
    assert sorted(steps(run, "build")) == sorted(steps(first, "build"))
    assert len(run.actions) == len(set(run.actions))


# ---- Runs that end early, and other machines -------------------------------------------------------------------------


@pytest.mark.parametrize("after", [False, True], ids=["before", "after"])
def test_killed_at_any_write(project: Path, image_set: ImageSet, monkeypatch: pytest.MonkeyPatch, after: bool) -> None:
    """Every fifth write of a run is the last one once. Nothing partial has a tag, and the next run finishes the work."""
    small = parse(SMALLER.replace("components: [core, base]", "components: [core]"))
    small = locked.with_locks(small, locked.current_locks(small, project))
    inputs = Inputs(project, small)
    options: dict[str, Any] = {"only": ["alpha-core", "alpha-core-torch-cu1"], "inputs": inputs}

    def signing() -> Publisher:
        place = publisher(project, services(project), monkeypatch)
        place.pen = Pen(place.registry)
        return place

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
    assert {step for step, *_ in reference.actions} == {"build", "join", "test"}


def test_side_by_side_costs_no_request_and_changes_no_order(
    project: Path, image_set: ImageSet, monkeypatch: pytest.MonkeyPatch
) -> None:
    results = []
    for number in (1, 16):
        monkeypatch.setattr(side_by_side, "AT_ONCE", number)
        here = publisher(project, services(project), monkeypatch)
        run = here.publish(image_set)
        outcomes = [(outcome.step, outcome.target, outcome.state, outcome.reason) for outcome in run.outcomes]
        results.append((here.registry.reads, here.registry.writes, outcomes))
    assert results[0] == results[1]


def test_a_run_past_midnight_has_one_date(
    registry: Publisher, image_set: ImageSet, monkeypatch: pytest.MonkeyPatch
) -> None:
    moment = datetime(2026, 11, 22, 23, 59, 58, tzinfo=UTC)
    times: list[str] = []

    def tick() -> str:
        times.append((moment + timedelta(seconds=len(times))).strftime(clock.TIME))
        return times[-1]

    monkeypatch.setattr(build, "now", tick)
    date = tick()
    run = registry.publish(image_set, date=date)
    assert date.startswith("2026-11-22") and times[-1].startswith("2026-11-23"), "nobody looked at the clock"
    assert {entry.date for entry in run.state.entries.values()} == {date}
    for repository in ("ros", "ros-torch", "part"):
        tags = registry.tagged(repository)
        dated = {name for name in tags if "-2026" in name}
        assert dated and all(name.endswith("-20261122") for name in dated)
        for name in tags.values():
            index = registry.registry.manifest(f"{PREFIX}/{repository}", name)
            assert index and index.content["annotations"][store.DATE] == date


def test_all_steps_use_the_plans_package_state(registry: Publisher, image_set: ImageSet, tmp_path: Path) -> None:
    file = tmp_path / "plan.json"
    file.write_text(make_plan(registry.run(image_set).state, 2).text())
    package_state = read_plan(file).package_state
    assert package_state == registry.packages
    for number, step in enumerate(STEPS):
        run = registry.run(image_set, package_state=package_state)
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
    """A run whose builds fail, as `require_sync` does, if ROS's repository has another date than the run.

    `syncs`: what the repository of alpha becomes when a target is first about to be built.
    """
    real = run.maker.build_image

    def build_image(image: Image, architecture: str, parts: dict[str, str], moment: str) -> maker.NewImage:
        if sync := syncs.pop(image.target, ""):
            registry.packages["alpha"] = sync
        if registry.packages[image.distribution] != moment:
            raise RosmlError(f"{image.target}: http://packages.example is of another time", "run it again")
        return real(image, architecture, parts, moment)

    monkeypatch.setattr(run.maker, "build_image", build_image)
    return run


def test_a_sync_between_plan_and_build_rebuilds_the_distribution_on_each_machine(
    registry: Publisher, image_set: ImageSet, monkeypatch: pytest.MonkeyPatch
) -> None:
    registry.packages = {"alpha": BEFORE, "omega": BEFORE}
    planned = dict(registry.run(image_set).state.package_state)
    for architecture, syncs in (("amd64", {"alpha-base": AFTER}), ("arm64", {})):
        run = registry.run(image_set, package_state=planned, architectures=(architecture,))
        live(registry, run, syncs, monkeypatch)
        for step in ("build", "join", "test"):
            STEPS[step](run)
        assert not run.failed
        builds = [target for step, target, _ in run.actions if step == "build" and target.startswith("alpha")]
        again = ["alpha-core"] if architecture == "amd64" else []
        assert builds == [*again, "alpha-core", "alpha-base"]
        assert {outcome.reason for outcome in run.outcomes if outcome.state == "waits"} <= {"it is not made yet"}
    rest = registry.run(image_set, package_state=planned)
    for step in ("index", "promote"):
        STEPS[step](rest)
    assert [outcome for outcome in rest.outcomes if outcome.state != "done"] == []
    book = store.Records(registry.place)
    for target, moment in (("alpha-core", AFTER), ("alpha-base", AFTER), ("omega-base", BEFORE)):
        for architecture in ("amd64", "arm64"):
            entry = book.read(target, architecture)
            assert entry and entry.package_state == moment
    assert registry.publish(image_set, date=NEXT).actions == []


def test_a_repository_that_never_rests_fails_its_distribution_alone(
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


def test_a_run_that_may_not_push_ends_before_its_first_work(registry: Publisher, image_set: ImageSet) -> None:
    registry.registry.refuses.add("push")
    run = registry.run(image_set)
    with pytest.raises(RosmlError, match="nobody push"):
        STEPS["build"](run)
    assert run.actions == [] and registry.registry.writes == 0
    registry.registry.refuses.clear()
    registry.publish(image_set)
    registry.registry.refuses.add("push")
    assert registry.publish(image_set, date=NEXT).outcomes == [], "with nothing to do nothing is asked"


def test_superseded_digests_are_forgotten_when_they_are_gone(
    registry: Publisher, image_set: ImageSet, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(running, "SUPERSEDED", 3)
    book = store.Records(registry.place)

    def night(number: int) -> store.Entry:
        registry.packages["alpha"] = f"day {number}"
        registry.publish(image_set, only=["alpha-core"], date=f"2026-11-0{number}T03:00:00Z", packages=str(number))
        entry = book.read("alpha-core", "amd64")
        assert entry
        return entry

    many = [night(number) for number in range(1, 7)][-1]
    assert len(many.superseded) == 5, "what is in the registry stays: prune removes it"
    for digest in many.superseded[:4]:
        del registry.registry.manifests[f"{PREFIX}/ros"][digest]
    assert night(7).superseded == (many.superseded[4], many.digest)
