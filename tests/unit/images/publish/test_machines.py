"""Two machines of a night that share a distribution: one builds its ROS images, and the other one waits for them."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from fakes.memory_registry import Publisher, Run, publisher
from fakes.projects import BASE
from fakes.stubs import services
from rosml.images.image_set.model import ImageSet
from rosml.images.publish import steps
from rosml.images.publish.steps import build

ROS = ("alpha-core", "alpha-base")
AMD64: dict[str, Any] = {"architectures": ("amd64",)}


@pytest.fixture
def registry(project: Path, monkeypatch: pytest.MonkeyPatch) -> Publisher:
    return publisher(project, services(project), monkeypatch)


class Clock:
    """The clock of the machine that waits. `work` is what the other one does meanwhile."""

    def __init__(self, work: Callable[[], object]) -> None:
        self.work, self.now = work, 0.0

    def monotonic(self) -> float:
        return self.now

    def sleep(self, seconds: float) -> None:
        self.now += seconds
        self.work()


def second(registry: Publisher, image_set: ImageSet) -> Run:
    return registry.run(image_set, only=[BASE], elsewhere=frozenset(ROS), **AMD64)


def test_ros_images_of_another_machine_are_taken_from_it(
    registry: Publisher, image_set: ImageSet, monkeypatch: pytest.MonkeyPatch
) -> None:
    first, other = (registry.run(image_set, only=ROS, elsewhere=frozenset(), **AMD64), second(registry, image_set))
    clock = Clock(lambda: steps.images(first))
    monkeypatch.setattr(build, "time", clock)
    steps.images(other)
    assert {("build", target, "amd64") for target in ROS} <= {*first.actions}
    assert clock.now == build.LOOK_SECONDS
    assert not {target for _, target, _ in other.actions}.intersection(ROS), "neither built nor tested again"
    assert {("join", BASE, "amd64"), ("test", BASE, "amd64")} <= {*other.actions}


@pytest.mark.parametrize("broken", ["", "alpha-core"], ids=["it died", "its build failed"])
def test_a_machine_that_died_is_not_waited_for_for_ever(
    broken: str, registry: Publisher, image_set: ImageSet, monkeypatch: pytest.MonkeyPatch
) -> None:
    if broken:
        steps.images(registry.run(image_set, only=ROS, broken={broken}, **AMD64))
    run, clock = second(registry, image_set), Clock(lambda: None)
    monkeypatch.setattr(build, "time", clock)
    steps.images(run)
    assert clock.now == (0 if broken else build.PATIENCE_SECONDS)
    assert {("build", "alpha-core", "amd64"), ("test", BASE, "amd64")} <= {*run.actions}
