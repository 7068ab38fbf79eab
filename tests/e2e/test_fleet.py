"""Builders by name: two of them build two shards side by side into one registry; and what happens when one of them dies,
or its disk is full, or the registry answers as registries do on a bad day."""

from __future__ import annotations

import copy
import json
import os
import re
import shutil
import signal
import subprocess
import time
from contextlib import ExitStack
from pathlib import Path

import pytest
import yaml

from rosml.base.clock import now
from rosml.machine.services import Services
from tests.e2e.builders import builder
from tests.e2e.calls import HANGS, Run, run
from tests.e2e.images import NATIVE
from tests.e2e.mini import NOTHING, Mini, begun, use
from tests.e2e.moody import moody

pytestmark = pytest.mark.usefixtures("own_builders")


@pytest.fixture(scope="module")
def project(project: Mini) -> Mini:
    """The small project with two distributions."""
    matrix = project.folder / "matrix.yaml"
    content = yaml.safe_load(matrix.read_text())
    content["distributions"]["other"] = copy.deepcopy(content["distributions"]["ros1-bookworm"]) | {"aliases": []}
    matrix.write_text(yaml.safe_dump(content, sort_keys=False))
    return project


def on(mini: Mini, folder: Path, **changes: object) -> Mini:
    """The same project in another folder, with other services: another machine that publishes into the same place."""
    shutil.copytree(mini.folder, folder, symlinks=True)
    return Mini(folder, use(folder, **changes), mini.prefix)


def test_two_builders_build_two_shards_side_by_side(mini: Mini, services: Services, tmp_path: Path) -> None:
    mini = on(mini, tmp_path / "bare")  # builders without a cache: only Debian's base image, and nothing is tested
    for name in ("base/install.sh", "base/contract.sh", "part/install-assembler.sh"):
        (mini.folder / "components" / name).write_text(NOTHING)
    plan = tmp_path / "plan.json"
    assert mini.publish("plan", "--output", str(plan), "--shards", "4").code == 0
    shards = [shard for shard in json.loads(plan.read_text())["shards"] if shard["architecture"] == NATIVE]
    assert [shard["distributions"] for shard in shards] in (
        [["ros1-bookworm"], ["other"]],
        [["other"], ["ros1-bookworm"]],
    )
    with ExitStack() as stack:
        machines = []
        for number, shard in enumerate(shards):
            name = f"fleet-{os.getpid()}-{number}"
            stack.enter_context(builder(name, tmp_path / name, services))
            machine = on(mini, tmp_path / f"machine-{number}", builder=name, builder_kind="user")
            arguments = ("build", "--plan", str(plan), "--shard", shard["name"], "--registry", mini.registry, "--json")
            machines.append(
                subprocess.Popen(machine.command(*arguments), stdout=subprocess.PIPE, stderr=subprocess.PIPE)
            )
        built = list[str]()
        for process, shard in zip(machines, shards, strict=True):
            out, err = process.communicate(timeout=HANGS)
            assert process.returncode == 0, err.decode()
            done = {item["target"] for item in json.loads(out)["outcomes"] if item["state"] == "done"}
            built += done
            (distribution,) = shard["distributions"]
            assert {f"{distribution}-core", f"{distribution}-base"} <= done
            assert not any(
                name.startswith("other" if distribution == "ros1-bookworm" else "ros1-bookworm") for name in done
            )
    assert len(built) == len({*built}), "work was done twice"
    assert any(name.startswith("part-") for name in built), "both distributions have these parts"
    for step in ("join-images", "index", "promote"):
        assert mini.publish(step, "--plan", str(plan), "--serve", NATIVE).code == 0
    assert mini.tags() == {}, "nothing was tested"
    tasks = {entry["target"] for entry in mini.says("plan")["tasks"] if "test" in entry["steps"]}
    assert {"ros1-bookworm-core", "other-base"} <= tasks, "something is to be built again"


def published(mini: Mini, *only: str) -> dict[str, str]:
    """Publishes images, then changes what ROS images hold; the tags, of which none may be lost."""
    mini.all(*(word for name in only for word in ("--only", name)))
    mini.mark(ros="2")
    tags = mini.tags()
    assert "ros:ros1-bookworm-core" in tags
    return tags


def finished(mini: Mini, tags: dict[str, str]) -> None:
    """Asserts that a run that failed lost nothing good, and that the next one does its work."""
    assert mini.tags() == tags
    mini.check()
    mini.all("--only", "ros1-bookworm-core")
    mini.check()
    moved = mini.tags()
    assert moved.keys() >= tags.keys() and moved["ros:ros1-bookworm-core"] != tags["ros:ros1-bookworm-core"]


def test_a_builder_that_dies(mini: Mini, services: Services, tmp_path: Path) -> None:
    """Tags stay where they were, at whole images; the next run makes what is missing."""
    tags = published(mini, "ros1-bookworm-core")
    name = f"mortal-{os.getpid()}"
    with builder(name, tmp_path / name, services) as mortal:
        machine = on(mini, tmp_path / "machine", builder=name, builder_kind="user")
        (machine.folder / "components/base/install.sh").write_text(NOTHING + "sleep 60\n")
        command = machine.command("build", "--only", "ros1-bookworm-core", "--registry", mini.registry)
        process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        time.sleep(5)  # wherever it is then
        assert process.poll() is None
        os.killpg(mortal.process.pid, signal.SIGKILL)
        mortal.process.wait()
        _out, err = process.communicate(timeout=HANGS)
    assert process.returncode == 1
    assert "Traceback" not in err and f"builder '{name}'" in err, err
    finished(mini, tags)


def test_a_builder_without_room(mini: Mini, services: Services, tmp_path: Path) -> None:
    disk = tmp_path / "disk"
    disk.mkdir()
    if os.geteuid() != 0:
        assert services.builder_kind != "buildkitd", "without Docker, set-up and tests need root"
        pytest.skip("Docker is the builder here, and only root may mount a file system")
    subprocess.run(["mount", "-t", "tmpfs", "-o", "size=60m", "tmpfs", str(disk)], check=True)
    tags = published(mini, "ros1-bookworm-core")
    try:
        name = f"no-room-{os.getpid()}"
        with builder(name, tmp_path / name, services, disk / "root"):
            machine = on(mini, tmp_path / "machine", builder=name, builder_kind="user")
            outcome = machine.publish("build", "--only", "ros1-bookworm-core")
    finally:
        subprocess.run(["umount", "--lazy", str(disk)], check=True)
    assert outcome.code == 1
    assert "no space left on device" in outcome.err and "Traceback" not in outcome.err
    assert mini.says("status", "--only", "ros1-bookworm-core")["images"][0]["state"] == "failed"
    finished(mini, tags)


# ---- A registry on a bad day -----------------------------------------------------------------------------------------


def through(address: str, mini: Mini, *arguments: str) -> Run:
    """A publishing command that reaches the registry by another address."""
    return run(*mini.command(*arguments, "--registry", f"{address}/{mini.prefix}"), cwd=mini.folder)


def test_a_registry_that_fails_now_and_then(mini: Mini, services: Services) -> None:
    """Every seventh answer is none: the run works on, or ends with an error and the next one finishes."""
    tags = published(mini, "ros1-bookworm-core*")
    faults, recorded, date = ("500", "429", "hang up"), set[tuple[str, str]](), now()
    with moody(services.registry, lambda number, _: faults[number // 7 % 3] if number % 7 == 0 else "") as address:
        for _attempt in range(4):
            outcome = through(address, mini, "all", "--only", "ros1-bookworm-core*", "--serve", NATIVE, "--date", date)
            assert "Traceback" not in outcome.err
            mini.check()
            assert mini.tags().keys() >= tags.keys(), "a tag was lost"
            assert not begun(outcome.err) & recorded, "what the records had was done again"
            recorded = mini.recorded(date)
            if outcome.code == 0:
                break
        assert outcome.code == 0, outcome.err
    assert {("build", "ros1-bookworm-core"), ("join", "ros1-bookworm-core-tensorflow-cpu")} <= recorded
    moved = mini.tags()
    assert all(moved[name] != tags[name] for name in ("ros:ros1-bookworm-core", "ros-tf:ros1-bookworm-core-cpu"))


def test_a_push_that_is_refused_for_a_moment(mini: Mini, services: Services) -> None:
    """As ghcr.io does while a repository is being made, or is busy. BuildKit asks once more in no time, or never.
    What was built is pushed again, and not built again, also where all is built anew."""
    install = mini.folder / "components/ros/install.sh"
    install.write_text(install.read_text() + "date +%N >/opt/mini/now\n")
    mini.all("--only", "ros1-bookworm-core")
    faults = {
        "POST .*/blobs/uploads/.* buildkit/": ["503"],
        "PUT .*/manifests/.* buildkit/": ["403", "403", *["429"] * 6],
    }

    def mood(_number: int, request: str) -> str:
        return next((codes.pop(0) for pattern, codes in faults.items() if codes and re.match(pattern, request)), "")

    with moody(services.registry, mood) as address:
        outcome = through(address, mini, "build", "--only", "ros1-bookworm-core", "--force")
    assert faults == {pattern: [] for pattern in faults}, outcome.err
    assert outcome.code == 0, outcome.err
    attempts = re.findall(r"failed: (.*); attempt (\d)", outcome.err)
    assert attempts == [("403 Forbidden", "2"), ("403 Forbidden", "3"), ("429 Too Many Requests", "4")]
    log = (mini.folder / f".state/log/build-ros1-bookworm-core-{NATIVE}.log").read_text()
    assert len(re.findall(r"^[\d.]+ s .*/ros/install\.sh", log, re.MULTILINE)) == 1
    refused = re.findall(r"ERROR: .*/manifests/(sha256:\w+): 4", log)
    assert len(refused) == 3 and len({*refused}) == 1 and refused[0] in outcome.err.rpartition("attempt 4")[2]
