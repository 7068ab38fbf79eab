"""The nights around the end of life of a distribution: the day `eol` is its last one with support."""

from __future__ import annotations

from pathlib import Path

import pytest
from conftest import SMALLER, changed, smaller

from fakes.memory_registry import DAY, Publisher, publisher
from fakes.stubs import services
from rosml.base import clock, github
from rosml.cli.images import report, tables
from rosml.images.image_set.model import ImageSet
from rosml.images.publish import status
from rosml.images.publish.plan import make_plan

LAST, AFTER = "2029-05-31T02:17:00Z", "2029-06-01T02:17:00Z"
FINAL = changed("apt: {channel: live}", "apt: {channel: final}", SMALLER)


@pytest.fixture
def registry(project: Path, monkeypatch: pytest.MonkeyPatch) -> Publisher:
    return publisher(project, services(project), monkeypatch)


def moved(registry: Publisher, image_set: ImageSet, date: str, **options: bool) -> set[str]:
    """The tags of ROS images that a night moves after packages of all distributions changed."""
    registry.publish(image_set, date=DAY)
    before = registry.tagged("ros")
    registry.packages.update(alpha="tuesday", omega="tuesday")
    assert not registry.publish(image_set, date=date, packages="2", **options).failed
    return {tag for tag, digest in registry.tagged("ros").items() if before.get(tag) != digest}


@pytest.mark.parametrize(
    ("text", "date", "moves"), [(SMALLER, LAST, True), (SMALLER, AFTER, False), (FINAL, AFTER, True)]
)
def test_a_night_after_the_end_of_life_moves_no_tag(
    text: str, date: str, moves: bool, registry: Publisher, project: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Unless the matrix asks for the distribution's last packages. Other distributions go on."""
    monkeypatch.setattr(clock, "now", lambda: date)
    tags = moved(registry, smaller(project, text), date)
    assert {"omega-core", f"omega-core-{date[:10].replace('-', '')}"} <= tags
    assert ("alpha-core" in tags) is moves
    assert moves or not [tag for tag in tags if tag.startswith("alpha")]


def test_a_person_still_builds_what_has_ended(registry: Publisher, image_set: ImageSet) -> None:
    assert "alpha-core" in moved(registry, image_set, AFTER, even_ended=True)


def test_the_plan_and_the_status_say_why(
    registry: Publisher, image_set: ImageSet, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setenv(github.SUMMARY, str(tmp_path / "summary.md"))
    registry.publish(image_set, only=["alpha-core"], date=DAY)
    state = registry.run(image_set, date=AFTER).state
    alphas = {image.target for image in image_set.images if image.distribution == "alpha"}
    plan = make_plan(state, 4)
    assert {task.target for task in plan.tasks if task.hindered.startswith("ended: ")} == alphas
    assert not alphas.intersection(target for shard in plan.shards for target in shard.targets)
    [remark] = plan.remarks
    assert remark.startswith("alpha had its end of life on 2029-05-31; take omega") and "channel: final" in remark
    report.plan_to_ci(plan, image_set, "")
    assert f"### {len(alphas)} left out: `ended: alpha had" in (tmp_path / "summary.md").read_text()

    statuses = list(status.read(state, AFTER))
    assert {image.target for image in statuses if image.state == "ended"} == alphas
    assert "ended" not in status.OPEN, "it would keep an issue open for good"
    causes = status.causes(statuses, image_set.matrix.architectures)
    text = tables.status_markdown("registry.example", statuses, causes, status.ahead(state))
    assert text.count("alpha had its end of life on 2029-05-31") == 1
    alone = registry.run(image_set, only=["alpha"], date=AFTER).state
    assert not [task for task in alone.tasks() if task.steps], "parts for it alone are not built either"
    run = registry.publish(image_set, date=AFTER)
    assert {outcome.step for outcome in run.outcomes if "end of life" in outcome.reason} == {"index", "promote"}
    assert status.ahead(run.state) == [], "a further run has nothing to do"
