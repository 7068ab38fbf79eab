"""Which tests each image runs itself, and which count that ran in another image with the same ROS image or parts."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from fakes.memory_registry import LATER, NEXT, Bytes, Publisher, Run, publisher, waiting
from fakes.projects import BASE
from fakes.stubs import services
from rosml.images.image_set.model import Image, ImageSet


@pytest.fixture
def registry(project: Path, monkeypatch: pytest.MonkeyPatch) -> Publisher:
    return publisher(project, services(project), monkeypatch)


def names_run(run: Run) -> dict[str, tuple[str, ...]]:
    """What each image was tested with in a run."""
    assert isinstance(run.maker, Bytes)
    return run.maker.tests


def of_parts(image: Image) -> tuple[str, ...]:
    """The tests of its parts that an image shares with others."""
    return tuple(name for name in image.shared if name in image.carried)


def test_what_images_of_a_distribution_share_is_tested_in_one_of_them(registry: Publisher, image_set: ImageSet) -> None:
    tests = names_run(registry.publish(image_set))
    assert all(tests[target] == image_set.by_target[target].tests for target in tests)
    with_pip = {target for target, names in tests.items() if "pip" in names and target.startswith("alpha")}
    assert with_pip == {"alpha-core", "alpha-core-ml-cu1", "alpha-core-ml-cpu"}
    registry.check(image_set)


def test_an_image_alone_runs_all_tests_that_must_hold_in_it(registry: Publisher, image_set: ImageSet) -> None:
    image = image_set.by_target[BASE]
    run = registry.publish(image_set, only=[BASE])
    assert names_run(run)[BASE] == (*image.tests, *of_parts(image)), "its ROS image runs those of ROS"
    assert {*image.shared} - {*of_parts(image)} <= {*names_run(run)["alpha-base"], *names_run(run)["alpha-core"]}
    assert "latest" in registry.tagged("ros-torch")
    assert BASE not in names_run(registry.publish(image_set, date=NEXT))
    registry.check(image_set)


def test_tests_that_passed_with_the_same_parts_are_not_repeated(registry: Publisher, image_set: ImageSet) -> None:
    registry.publish(image_set, only=["alpha-core-ml-cu1", "alpha-base"])
    image = image_set.by_target[BASE]
    assert names_run(registry.publish(image_set, date=NEXT, only=[BASE]))[BASE] == image.tests
    registry.packages["alpha"] = "tuesday"
    run = registry.publish(image_set, date=NEXT, only=[BASE], packages="2")
    assert names_run(run)[BASE] == (*image.tests, *of_parts(image)), "the others stand on other packages"
    registry.check(image_set)


def test_all_tests_run_if_that_is_asked_for(registry: Publisher, image_set: ImageSet) -> None:
    first, second = (image_set.by_target[name] for name in ("alpha-core-torch-cu1", BASE))
    assert {*of_parts(first)} <= {*names_run(registry.publish(image_set, only=[first.target]))[first.target]}
    assert names_run(registry.publish(image_set, date=NEXT, only=[BASE]))[BASE] == second.tests
    everything = registry.publish(image_set, date=NEXT, only=[BASE], all_tests=True)
    assert names_run(everything) == {BASE: (*second.tests, *second.shared)}
    assert names_run(registry.publish(image_set, date=LATER, only=[BASE], all_tests=True)) == {}


def test_neither_a_failure_nor_a_higher_component_proves_anything(registry: Publisher, image_set: ImageSet) -> None:
    first, image = (image_set.by_target[name] for name in ("alpha-core-torch-cu1", BASE))
    registry.publish(image_set, only=[first.target], poisoned={first.target}, failing="pip")
    assert names_run(registry.publish(image_set, date=NEXT, only=[BASE]))[BASE] == (*image.tests, *of_parts(image))
    run = registry.publish(image_set, date=LATER, only=[first.target])
    assert names_run(run)[first.target] == (*first.tests, *of_parts(first))


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
    repeated = registry.publish(image_set, date=NEXT)
    assert {name for _, name, _ in repeated.actions} == {target}
    assert {"alpha-core-cu1", "alpha-base-cu1"} <= registry.tagged("ros-torch").keys()
    registry.check(image_set)


def test_an_image_in_which_no_test_ran_gets_no_tag(
    registry: Publisher, image_set: ImageSet, monkeypatch: pytest.MonkeyPatch
) -> None:
    real = Bytes.test
    monkeypatch.setattr(Bytes, "test", lambda *words: replace(real(*words), passed=0))
    run = registry.publish(image_set, only=["alpha-core"])
    assert registry.tagged("ros") == {}
    assert any("tested, and no test ran" in reason for reason in waiting(run, "alpha-core"))
