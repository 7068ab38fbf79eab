"""Publishing runs on the real builder and registry, with images that hold next to nothing; and how they end when something
goes wrong: no tag points at what is untested or partial, and the next run goes on where the last one was."""

from __future__ import annotations

import json
import random
import shutil
import signal
import subprocess
import time
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import Any

import pytest

from rosml.base.clock import TIME
from tests.e2e.calls import HANGS
from tests.e2e.images import NATIVE
from tests.e2e.mini import OTHER, Mini, begun

LIVES = [(0.6, 5.0)] * 6 + [(5.0, 20.0)] * 2
"""Seconds that the runs of one night live, if they do not end before; the one after them is left alone, however long other
builds in the same builder make it wait."""
IMAGES = [
    "ros1-bookworm-core",
    "ros1-bookworm-base",
    "ros1-bookworm-core-tensorflow-cpu",
    "ros1-bookworm-base-tensorflow-cpu",
]


def did(result: dict[str, Any], step: str) -> list[str]:
    return [item["target"] for item in result["outcomes"] if item["step"] == step and item["state"] == "done"]


def test_all_then_nothing_then_what_changed(mini: Mini) -> None:
    """One image is there once more with an environment, which the real scripts build."""
    mini.with_environment(IMAGES[-1])
    joined = [*IMAGES[2:], f"{IMAGES[-1]}-env-empty"]
    first = mini.all()
    assert did(first, "build")[:2] == IMAGES[:2] and did(first, "join") == joined
    assert did(first, "test") == [*IMAGES[:2], *joined]
    mini.check()
    tags = mini.tags()
    assert {
        "ros:ros1-bookworm-core",
        "ros:ros1-bookworm",
        "ros-tf:ros1-bookworm-base-cpu",
        "part:tensorflow-cpu-py311",
        "env:empty-py311",
        "ros-tf:ros1-bookworm-base-cpu-env-empty",
        "ros-tf:ros1-bookworm-env-empty",
    } <= tags.keys()
    client = mini.client()
    again = mini.all()
    assert (again["outcomes"], again["uploaded"]) == ([], 0)
    assert mini.tags() == tags
    mini.mark(part="2")
    changed = mini.all()
    parts = {name for name in did(first, "build") if name.startswith("part-")}
    assert {*did(changed, "build")} == parts - {"part-env-empty-py311"}
    assert did(changed, "join") == joined == did(changed, "test")
    assert 0 < changed["uploaded"] < 0.05 * first["uploaded"]
    now = mini.tags()
    assert now["ros:ros1-bookworm-core"] == tags["ros:ros1-bookworm-core"]
    assert now["ros-tf:ros1-bookworm-core-cpu"] != tags["ros-tf:ros1-bookworm-core-cpu"]
    index = client.manifest(f"{mini.prefix}/ros-tf", "ros1-bookworm-core-cpu")
    assert index and index.content["annotations"]["io.rosml.date"] == changed["date"]
    mini.says("undo")
    back = mini.tags()
    assert all(back[name] == digest for name, digest in tags.items())


def test_a_poisoned_image_keeps_its_tags(mini: Mini) -> None:
    first = mini.all()
    tags = mini.tags()
    mini.mark(ros="2")
    mini.poison()
    outcome = mini.publish("all", "--serve", NATIVE, "--json")
    assert outcome.code == 1
    mini.check()
    now = mini.tags()
    stay = [name for name in tags if "-base" in name or name == "ros:ros1-bookworm"]
    assert {name: now[name] for name in stay} == {name: tags[name] for name in stay}
    assert now["ros:ros1-bookworm-core"] != tags["ros:ros1-bookworm-core"], "another image's fault"
    assert "tests failed" in outcome.out
    changed = json.loads(outcome.out)
    assert set(did(changed, "build")) == set(IMAGES[:2]), "only ROS images changed"
    assert 0 < changed["uploaded"] < 0.05 * first["uploaded"], "what did not change was uploaded"
    mini.poison(poisoned=False)
    mended = mini.all()
    assert did(mended, "build") == did(mended, "join") == []
    assert mini.tags()["ros:ros1-bookworm-base"] != tags["ros:ros1-bookworm-base"]


@pytest.mark.parametrize("kills", [8, pytest.param(30, marks=pytest.mark.full(proof="kills"))])
def test_killed_at_random_points(mini: Mini, tmp_path: Path, kills: int) -> None:
    """SIGKILL, again and again; every night's work is finished by the runs that are left alone, and none of it twice."""
    worked = False
    chance = random.Random(6)
    killed = night = runs = 0
    first = datetime(2026, 1, 1, 3, tzinfo=UTC)  # in the past: a run's date in the future is refused
    while killed < kills:
        night += 1
        date = (first + timedelta(days=night)).strftime(TIME)
        mini.mark(ros=str(night), part=str(night // 2))
        before = mini.tags()
        recorded: set[tuple[str, str]] = set()
        tonight = 0
        while killed < kills:
            runs += 1
            log = tmp_path / f"run-{runs}"
            process = mini.start("--date", date, log=log)
            try:
                process.wait(timeout=chance.uniform(*LIVES[tonight]) if tonight < len(LIVES) else None)
            except subprocess.TimeoutExpired:
                process.send_signal(signal.SIGKILL)
                process.wait()
                killed, tonight = killed + 1, tonight + 1
                mini.check()
                assert not begun(log.read_text()) & recorded, f"run {runs} does again what the records had"
                recorded = mini.recorded(date)
                worked |= bool(recorded)
                continue
            assert process.returncode == 0, log.read_text()
            assert not begun(log.read_text()) & recorded, f"run {runs} does again what the records had"
            break
    assert worked, "no run was killed after it had done something"
    last = mini.all("--date", (first + timedelta(days=night + 1)).strftime(TIME))
    assert not {(step, target) for step in ("build", "join") for target in did(last, step)} & recorded
    mini.check()
    assert all(mini.tags().get(name) for name in before), "a tag was lost"
    assert mini.all()["outcomes"] == []
    assert killed >= kills and night >= kills // len(LIVES), f"{killed} kills in {night} nights"


def test_two_publishers_at_the_same_time(mini: Mini, tmp_path: Path) -> None:
    """Of two checkouts, as on two machines: both end well, and what one of them did the other one need not."""
    logs = [tmp_path / "one", tmp_path / "other"]
    elsewhere = Mini(tmp_path / "checkout", mini.services, mini.prefix)
    shutil.copytree(mini.folder, elsewhere.folder, symlinks=True)
    processes = [place.start(log=log) for place, log in zip((mini, elsewhere), logs, strict=True)]
    codes = [process.wait(timeout=HANGS) for process in processes]
    mini.check()
    assert codes == [0, 0], [log.read_text() for log in logs]
    result = mini.all()
    assert not any(did(result, step) for step in ("build", "join", "test")), "two publishers left something to do"
    mini.check()


def platforms(mini: Mini, tag: str) -> dict[str, str]:
    """Digests by architecture of what a tag points at."""
    repository, _, name = tag.partition(":")
    index = mini.client().manifest(f"{mini.prefix}/{repository}", name)
    assert index
    return {item["platform"]["architecture"]: item["digest"] for item in index.content["manifests"]}


def test_a_tag_has_both_architectures_or_stays(mini: Mini) -> None:
    """Without --serve an image's index is for all that the matrix has. The other one comes from another machine."""
    only = ("--only", "ros1-bookworm-core", "--json")

    def publish(*steps: str) -> list[int]:
        return [mini.publish(step, *only).code for step in steps]

    outcome = mini.publish("all", *only)
    assert outcome.code == 0
    assert mini.tags() == {}
    assert f"{OTHER} is missing: waiting for a builder of its architecture" in outcome.out
    mini.put_other(python="3.12")
    refused = mini.publish("index", *only)
    assert refused.code == 1 and "python is " in refused.out
    assert f"3.11 on {NATIVE}" in refused.out and f"3.12 on {OTHER}" in refused.out
    assert publish("promote") == [0] and mini.tags() == {}
    arm = mini.put_other()
    assert publish("index", "promote") == [0, 0]
    mini.check()
    tags, both = mini.tags(), platforms(mini, "ros:ros1-bookworm-core")
    assert both.keys() == {NATIVE, OTHER} and both[OTHER] == arm != both[NATIVE]
    mini.mark(ros="2")
    assert publish("all") == [0]
    assert mini.tags() == tags, "a tag moved to one architecture alone"
    arm = mini.put_other()
    assert publish("index", "promote") == [0, 0]
    mini.check()
    moved = platforms(mini, "ros:ros1-bookworm-core")
    assert moved[OTHER] == arm and not set(moved.values()) & set(both.values())


def test_the_steps_one_by_one_on_several_machines(mini: Mini, tmp_path: Path) -> None:
    """What CI does: a plan, each step in a job of its own; nothing is shared but the registry and the plan."""
    plan = tmp_path / "plan.json"
    assert mini.publish("plan", "--output", str(plan)).code == 0
    content = json.loads(plan.read_text())
    shards = [shard["name"] for shard in content["shards"] if shard["architecture"] == NATIVE]
    assert shards
    for shard in shards:
        assert mini.publish("build", "--plan", str(plan), "--shard", shard).code == 0
    time.sleep(1.1)  # the date is the plan's, not that of the day
    for step in ("join-images", "test", "index", "promote"):
        outcome = mini.publish(step, "--plan", str(plan), "--serve", NATIVE)
        assert outcome.code == 0, outcome.err
    mini.check()
    index = mini.client().manifest(f"{mini.prefix}/ros-tf", "ros1-bookworm-base-cpu")
    assert index and index.content["annotations"]["io.rosml.date"] == content["date"]
