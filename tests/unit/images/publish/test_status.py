"""`rosml status`: how images stand in a registry, and what keeps them from being published."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from conftest import SMALLER, changed, parse, write_locks

from fakes.memory_registry import DAY, LATER, NEXT, Publisher, Run, publisher, steps
from fakes.projects import BASE
from fakes.stubs import OFFLINE, services
from rosml.cli.images import tables
from rosml.images.image_set import locked
from rosml.images.image_set.model import ImageSet
from rosml.images.publish import status
from rosml.images.publish.status import Ahead, ImageStatus

AMD64: dict[str, Any] = {"architectures": ("amd64",)}


@pytest.fixture
def registry(project: Path, monkeypatch: pytest.MonkeyPatch) -> Publisher:
    return publisher(project, services(project), monkeypatch)


def states(registry: Publisher, image_set: ImageSet, now: str = LATER, **options: Any) -> dict[str, ImageStatus]:
    return {image.target: image for image in status.read(registry.run(image_set, **options).state, now)}


def state(registry: Publisher, image_set: ImageSet, target: str, **options: Any) -> tuple[str, str]:
    image = states(registry, image_set, **options)[target]
    return image.state, image.reason


def test_each_state(registry: Publisher, image_set: ImageSet) -> None:
    registry.publish(image_set, only=["alpha"])
    images = states(registry, image_set)
    assert (images["alpha-core"].state, images["alpha-core"].age) == ("published", 2 * 86400)
    assert images["alpha-core"].platforms == ("amd64", "arm64")
    never = "amd64: it was never made; arm64: it was never made"
    assert (images["omega-core"].state, images["omega-core"].reason) == ("missing", never)
    registry.packages["alpha"] = "tuesday"
    images = states(registry, image_set)
    assert images["alpha-core"].state == "outdated" and "packages moved" in images["alpha-core"].reason
    assert images[BASE].state == "outdated"
    registry.publish(image_set, only=["alpha"], date=NEXT, packages="7", poisoned={BASE})
    images = states(registry, image_set)
    assert images[BASE].state == "failed" and "tests failed" in images[BASE].reason
    assert '"failed": 1' in status.as_json(list(images.values()))
    assert state(registry, image_set, "alpha-core") == ("published", "")
    assert state(registry, image_set, "alpha-core", **AMD64) == ("published", ""), "another machine's work is no fault"
    registry.publish(image_set, only=["omega-core"], **AMD64, serving=("amd64",))
    assert state(registry, image_set, "omega-core", serving=("amd64",))[0] == "published"
    assert state(registry, image_set, "omega-core")[0] == "outdated"
    assert [status.age(seconds) for seconds in (None, 59, 7300)] == ["", "59 s", "2 h"]


def test_a_machine_of_one_architecture(
    registry: Publisher, image_set: ImageSet, capsys: pytest.CaptureFixture[str]
) -> None:
    registry.publish(image_set, only=["alpha"])
    assert state(registry, image_set, "omega-core-torch-cpu", **AMD64) == (
        "waiting for a builder",
        "of its architecture",
    )
    registry.publish(image_set, only=["omega-core"], date=NEXT, serving=("amd64",), **AMD64)
    assert state(registry, image_set, "omega-core", **AMD64) == ("published", "not published: arm64")
    registry.packages["alpha"] = "tuesday"
    registry.publish(image_set, only=["alpha"], date=NEXT, packages="7", **AMD64)
    for target, expected in (
        ("alpha-core", ("outdated", "arm64: packages moved from monday to tuesday")),
        ("alpha-core-torch-cpu", ("outdated", "arm64: alpha-core is rebuilt")),
        ("alpha-core-torch-cu1", ("published", "")),
    ):
        assert state(registry, image_set, target, **AMD64) == expected
    ahead = status.ahead(registry.run(image_set, only=["alpha"], **AMD64).state)
    assert [it for it in ahead if it.architecture != "arm64"] == [], "its own are up to date"
    tables.print_status([], [], ahead)
    assert capsys.readouterr().out == "0 images; a further run would build 2 for arm64, test 2 for arm64\n"


def test_a_missing_lock_and_a_missing_base_image(
    registry: Publisher,
    image_set: ImageSet,
    project: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    registry.publish(image_set, only=["alpha-core"], date="2026-11-19T03:00:00Z")
    registry.services = services(project, docker_hub=False, bases=OFFLINE)
    lock = next(name for name in image_set.by_target[BASE].locks if name.endswith("/torch.txt"))
    lacking = locked.with_locks(image_set, image_set.locks - {lock})
    (project / lock).unlink()
    run = registry.run(lacking, only=["alpha-core", "alpha-base", BASE, "alpha-core-ml-cu1"])
    images = list(status.read(run.state, DAY))
    why = "docker.io/library/ubuntu:24.04 is on Docker Hub, which does not answer"
    unlocked = ("lock missing", "1 of its locks are missing")
    expected = {"alpha-core": ("published", ""), "alpha-base": ("waiting for a builder", why)}
    expected |= dict.fromkeys((BASE, "alpha-core-ml-cu1", "part-torch-cu1-py312"), unlocked)
    assert {it.target: (it.state, it.reason) for it in images if it.target in expected} == expected
    counts = json.loads(status.as_json(images))["counts"]
    assert (counts["published"], counts["waiting for a builder"], counts["lock missing"]) == (1, 1, 3)
    monkeypatch.setattr(tables, "FEW", len(images))
    tables.print_status(images, [], [Ahead("join", 2)])
    *rows, summary = capsys.readouterr().out.splitlines()
    lines = {line.split()[0]: " ".join(line.split()[1:]) for line in rows if line}
    assert lines["alpha-core"] == "published 3 d amd64, arm64"
    assert lines["alpha-base"] == f"waiting for a builder {why}"
    of_images, of_parts, further = summary.split("; ")
    assert of_images == "4 images: 1 published, 2 without a lock, 1 waiting for a builder"
    assert of_parts.startswith(f"{len(images) - 4} parts: ") and "1 without a lock" in of_parts
    assert further == "a further run would join 2"
    causes = status.causes(images, image_set.matrix.architectures)
    [head] = [
        line for line in tables.status_markdown("", images, causes, []).splitlines() if "lock" in line and "#" in line
    ]
    assert head == "### 2 images and 1 part without a lock"
    monkeypatch.setattr(tables, "FEW", 1)
    tables.print_status(images, [], [])
    assert [line.split()[0] for line in capsys.readouterr().out.splitlines()[:-1]] == ["image", "alpha-core"]


def test_a_missing_lock_hides_no_failure(project: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A lock for one architecture is missing, and the tests on the other one failed. A lock for an architecture that is not
    served does not count."""
    target, image_set = "alpha-core-torch-cpu", parse(changed("cpu: [arm64]}", "cpu: [amd64, arm64]}", SMALLER))
    write_locks(project, image_set)
    here = publisher(project, services(project), monkeypatch)
    (lock,) = (name for name in image_set.by_target[target].locks if name.endswith("arm64/3.12/torch.txt"))
    lacking = locked.with_locks(image_set, image_set.locks - {lock})

    def causes(run: Run) -> dict[str, tuple[str, str]]:
        grouped = status.causes(list(status.read(run.state, LATER)), image_set.matrix.architectures)
        return {name: (cause.state, cause.reason) for cause in grouped for name in cause.targets}

    assert causes(here.run(lacking, only=[target]))[target] == ("lock missing", "")
    run = here.publish(lacking, only=[target], poisoned={target})
    assert causes(run)[target] == ("failed", "tests failed: contract: it is poisoned")
    assert status.ahead(run.state) == [Ahead("test", 1)], "on the architecture that has its lock"
    run = here.publish(lacking, only=[target], date=LATER, serving=("amd64",))
    assert target not in causes(run) and status.ahead(run.state) == []
    other = lock.replace("arm64", "amd64")
    (project / other).unlink()
    without = locked.with_locks(image_set, image_set.locks - {lock, other})
    run = here.run(without, only=[target], date=LATER, serving=("amd64",))
    assert causes(run)[target] == ("outdated", "lock missing")


def test_the_owner_sees_each_cause_once(registry: Publisher, image_set: ImageSet) -> None:
    part = "part-torch-cu1-py312"
    registry.publish(image_set, broken={part}, poisoned={"alpha-core"})
    run = registry.run(image_set, date=NEXT)
    entry = run.state.entries[part, "amd64"]
    failed = {**entry.failed, "reason": "it broke\n@somebody `at` line 7"}
    run.state.entries[part, "amd64"] = replace(entry, failed=failed)
    images = list(status.read(run.state, LATER))
    causes = status.causes(images, image_set.matrix.architectures)
    assert [cause.state for cause in causes[:2]] == ["failed", "failed"]
    by_reason = {cause.reason: cause for cause in causes}
    assert by_reason["it broke"].targets == (part,)
    poisoned = by_reason["tests failed: contract: it is poisoned"]
    assert poisoned.targets == ("alpha-core",), "of both architectures"
    assert poisoned.log.splitlines()[1:] == ["    contract: it is poisoned", "      Expected 0, got 1"]
    assert {*by_reason[f"build of {part} failed"].targets} == {
        f"alpha-{component}-{framework}-cu1" for component in ("core", "base") for framework in ("torch", "ml")
    }
    ahead = status.ahead(run.state)
    assert ahead == [Ahead("build", 1), Ahead("join", 4), Ahead("test", 6)]
    text = tables.status_markdown("registry.example/rosml", images, causes, ahead)
    assert "A further run would build 1, join 4, test 6." in text
    assert "````\nit broke\n@somebody `at` line 7\n````" in text
    repeated = registry.publish(image_set, date=NEXT)
    assert [Ahead(it.step, len(steps(repeated, it.step))) for it in ahead] == ahead


def test_a_failure_is_over_when_its_change_is_reverted(registry: Publisher, image_set: ImageSet, project: Path) -> None:
    registry.publish(image_set, only=["alpha-core"])
    before = (project / "components/ros/install.sh").read_text()
    registry.change()
    registry.publish(image_set, only=["alpha-core"], date=NEXT, broken={"alpha-core"})
    assert state(registry, image_set, "alpha-core")[0] == "failed"
    (project / "components/ros/install.sh").write_text(before)
    assert state(registry, image_set, "alpha-core") == ("published", "")


def test_an_index_that_cannot_be_made_has_failed(registry: Publisher, image_set: ImageSet) -> None:
    odd = {("alpha-core", "arm64"): {"org.opencontainers.image.version": "another"}}
    registry.publish(image_set, only=["alpha-core"], odd=odd)
    name, reason = state(registry, image_set, "alpha-core", only=["alpha-core"])
    assert name == "failed" and "not the same on all" in reason
