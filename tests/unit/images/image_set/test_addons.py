"""Add-ons in the image set and in a publishing run: images without tags test them, and a few get tags. Joins: test_join.py."""

from __future__ import annotations

from pathlib import Path

import pytest
from click.testing import CliRunner
from conftest import SMALLER, changed, parse, write_locks

from fakes.memory_registry import DAY, NEXT, Publisher, publisher, steps
from fakes.scanning import World, advisory, rules
from fakes.stubs import services
from rosml.base.errors import RosmlError
from rosml.cli.images import listing
from rosml.images.bake import targets
from rosml.images.builds import structure_tests
from rosml.images.catalogue import tags_page
from rosml.images.image_set import addons, explain, locked
from rosml.images.image_set.model import ImageSet
from rosml.images.locks import requests
from rosml.images.publish import status
from rosml.images.publish.steps import STEPS
from rosml.images.publish.steps.scan import policy_digest, scan

ENTRY = "addons:\n  extra: {parts: [extra], beside: [torch], tags: {distributions: [alpha], components: [base], stacks: [cu1]}}\n"
MATRIX = SMALLER
for before, after in (
    ("\nreleases:\n", f"\n{ENTRY}releases:\n  extra:\n    1.5.0: {{python: ['3.12', '3.14'], wheels: {{cu1: [amd64], cpu: [amd64, arm64]}}}}\n"),
    ("cudnn: 9.10.2.21, releases: {torch: 2.10.0,", "cudnn: 9.10.2.21, releases: {extra: 1.5.0, torch: 2.10.0,"),
    ("      {torch: 2.10.0, tensorflow: 2.20.0}", "      {extra: 1.5.0, torch: 2.10.0, tensorflow: 2.20.0}"),
    ("      tensorflow: {unpacked: 500, compressed: 50}", "      tensorflow: {unpacked: 500, compressed: 50}\n      extra: {unpacked: 1, compressed: 1}"),
    ("      tensorflow: {unpacked: 100, compressed: 10}", "      tensorflow: {unpacked: 100, compressed: 10}\n      extra: {unpacked: 1, compressed: 1}"),
):  # fmt: skip
    MATRIX = changed(before, after, MATRIX)
MATRIX += "  - {name: extra, title: Extra, release: extra, needs: [common], slot: 4}\n"

TRIALS = {"alpha-core-extra-cu1", "alpha-core-torch-extra-cu1", "alpha-core-extra-cpu", "alpha-core-torch-extra-cpu",
          "omega-core-extra-cu1", "omega-core-torch-extra-cu1", "omega-core-extra-cpu",
          "omega-core-torch-extra-cpu"}  # fmt: skip


@pytest.fixture
def image_set(project: Path) -> ImageSet:
    for name in ("components/extra/prune.txt", "tests/structure/extra.yaml"):
        (project / name).parent.mkdir(exist_ok=True)
        (project / name).write_text("schemaVersion: 2.0.0\n")
    image_set = parse(MATRIX)
    write_locks(project, image_set)
    for lock in (project / "locks").rglob("extra.txt"):
        lock.write_text(lock.read_text().replace("torch==2.10.0", "extra==1.5.0"))
    return locked.with_locks(image_set, locked.current_locks(image_set, project))


@pytest.fixture
def registry(project: Path, monkeypatch: pytest.MonkeyPatch) -> Publisher:
    return publisher(project, services(project), monkeypatch)


def test_a_release_may_need_variables_and_a_newer_glibc(real: ImageSet) -> None:
    """Images have the variables, parts say them for joins, and locks and builds take wheels for that glibc."""
    text = changed("    1.5.0: {", "    1.5.0: {glibc: '2.34', environment: {EXTRA_SENDS: '0'}, ", MATRIX)
    image_set = parse(text)
    assert structure_tests.expected_environment(image_set.image("alpha-base-extra-cu1"))["EXTRA_SENDS"] == "0"
    assert "EXTRA_SENDS" not in structure_tests.expected_environment(image_set.image("alpha-base-torch-cu1"))
    bake_targets = targets.of(image_set)
    joined, part = bake_targets["alpha-base-extra-cu1"].join, bake_targets["part-extra-cu1-py312"]
    assert joined and joined.environment["EXTRA_SENDS"] == "0"
    assert (part.labels["io.rosml.extra.environment"], part.arguments["GLIBC"]) == ("EXTRA_SENDS=0", "2.34")
    assert "GLIBC" not in bake_targets["part-torch-cu1-py312"].arguments
    libraries = targets.of(real)["part-tensorrt-rtx-cc-cu130"]  # it takes packages beside the release, and is none
    assert libraries.arguments["GLIBC"] == real.matrix.release("cu130", "tensorrt-rtx").glibc
    wheels = {item.architecture: item.wheels for item in requests.requests(image_set) if item.stack == "cpu"}
    assert wheels == {"amd64": "x86_64-manylinux_2_34", "arm64": "aarch64-manylinux_2_34"}


def test_each_stack_and_python_is_tested_on_the_lowest_component(image_set: ImageSet) -> None:
    images = {image.target: image for image in image_set.images if image.addons}
    assert {*images} == TRIALS | {"alpha-base-extra-cu1"}
    assert {target for target, image in images.items() if not image.tags} == TRIALS
    assert images["alpha-core-extra-cpu"].architectures == ("amd64", "arm64")
    assert images["alpha-core-torch-extra-cpu"].architectures == ("arm64",), "as the framework has wheels"
    assert {image.groups for image in images.values() if not image.tags} == {("extra",)}
    tagged = images["alpha-base-extra-cu1"]
    tags = ("alpha-base-cu1", "alpha-base-cu1-extra1.5.0", "alpha", "latest")
    assert tagged.tags == tuple(f"ros-extra:{tag}" for tag in tags)
    assert tagged.carriers == ("alpha-core-extra-cu1",)
    assert all(image_set.by_target[image.target] == image for image in parse(SMALLER).images), "nothing else changes"


def test_a_budget_counts_what_no_framework_has(image_set: ImageSet) -> None:
    """So it holds for the part itself, beside a framework as well, although no image has a tag."""
    image_set = parse(
        changed("  parts:\n    cu1:", "  budgets: {cpu: {extra: 1, torch: 9}}\n  parts:\n    cu1:", MATRIX)
    )
    for target in ("alpha-core-extra-cpu", "alpha-core-torch-extra-cpu"):
        image = image_set.image(target)
        assert not image.tags and (image.budget, image.budgeted) == (1, ("extra-cpu-py312",)), target
    torch = image_set.image("alpha-core-torch-cpu")
    assert (torch.budget, torch.budgeted) == (9, torch.parts)


def test_images_that_only_test_get_no_tag_and_no_index(registry: Publisher, image_set: ImageSet) -> None:
    run = registry.publish(image_set)
    assert not run.failed
    registry.check(image_set)
    assert {target for target, _ in steps(run, "test")} >= TRIALS
    tags = registry.tagged("ros-extra").keys()
    assert tags >= {"alpha-base-cu1", "latest"} and not [tag for tag in tags if "core" in tag]
    assert registry.tagged("ros-torch-extra") == {}
    assert {"extra-cu1-py312", "extra-cpu-py314"} <= registry.tagged("part").keys()
    before = registry.registry.writes
    again = registry.publish(image_set, date=NEXT)
    assert (again.actions, again.outcomes, registry.registry.writes) == ([], [], before)


def test_a_part_whose_test_failed_gets_no_tag(registry: Publisher, image_set: ImageSet) -> None:
    poisoned = {"omega-core-extra-cpu", "omega-core-torch-extra-cpu"}
    run = registry.publish(image_set, poisoned=poisoned)
    assert run.failed
    assert "extra-cpu-py312" in registry.tagged("part") and "extra-cpu-py314" not in registry.tagged("part")
    statuses = {it.target: it for it in status.read(registry.run(image_set, date=NEXT).state, NEXT)}
    assert statuses["part-extra-cpu-py312"].state == "published"
    part = statuses["part-extra-cpu-py314"]
    tester = "omega-core-extra-cpu: tests failed: contract: it is poisoned"
    assert (part.state, part.reason) == ("failed", f"amd64: {tester}; arm64: {tester}")
    assert "Expected 0, got 1" in part.log, "no image with a row has it"


def test_what_the_policy_stops_in_an_addon_gets_no_tag(
    registry: Publisher, image_set: ImageSet, tmp_path: Path
) -> None:
    """Its part is scanned in the images that test it, although none of them has a tag. Others have no part in that."""
    world = World(tmp_path, advisories={"extra": [advisory("CVE-2026-3", "CRITICAL", "3.0")]})
    run = registry.run(image_set, scanning=policy_digest(rules(), DAY))
    for step in ("build", "join", "test"):
        STEPS[step](run)
    scan(run, rules(), world.ready())
    for step in ("index", "promote"):
        STEPS[step](run)
    stopped = {key[0] for key, entry in run.state.entries.items() if entry.scan.get("failing") == ["CVE-2026-3"]}
    assert stopped == TRIALS | {"alpha-base-extra-cu1"}
    assert not [tag for tag in registry.tagged("part") if tag.startswith("extra-")]
    assert "alpha-base-cu1" in registry.tagged("ros-torch") and registry.tagged("ros-extra") == {}


def test_it_is_explained(image_set: ImageSet) -> None:
    assert "tags: none; it tests extra" in explain.explained(image_set, "alpha-core-torch-extra-cpu").reasons
    reasons = {
        "alpha-robot-extra-cu1": "alpha (ROS 2) has no robot metapackage",
        "alpha-base-torch-extra-cu1": "extra is an add-on; take ros-torch:alpha-base-cu1, and --addons extra, or join",
        "ros-extra:omega-base-cpu": "take ros:omega-base, and --addons extra-cpu",
        "omega-base-ml-extra-cu1": "no release of tensorflow has a wheel for Python 3.14",
    }
    for name, words in reasons.items():
        assert words in (explain.why_not(image_set, name) or ""), name


def test_what_an_image_can_take(image_set: ImageSet) -> None:
    """With the parts that it lacks: one with a framework has some. Not what it has, nor what its Python or its stack lacks."""
    images, matrix = image_set.by_target, image_set.matrix
    (torch,) = addons.fitting(matrix, images["alpha-base-torch-cu1"])
    assert (torch.called, torch.parts, torch.platforms) == ("extra", ("extra-cu1-py312",), ("linux/amd64",))
    assert torch.joins("ros-torch:alpha") == (
        "rosml join REGISTRY/ros-torch:alpha REGISTRY/part:extra-cu1-py312 --tag REGISTRY/NAME:TAG"
    )
    plain = {item.called: item for item in addons.fitting(matrix, images["alpha-base"])}
    assert {*plain} == {"extra-cu1", "extra-cpu"}
    assert plain["extra-cu1"].parts == ("cuda-cu1", "common-cu1-py312", "extra-cu1-py312")
    assert "part:{cuda-cu1,common-cu1-py312,extra-cu1-py312} --tag" in plain["extra-cu1"].joins("ros:alpha")
    assert plain["extra-cpu"].platforms == ("linux/amd64", "linux/arm64")
    assert not [*addons.fitting(matrix, images["alpha-base-extra-cu1"])]
    secret = parse(changed("slot: 4}", "slot: 4, distribution: restricted}", MATRIX))
    assert {item.restricted for item in addons.fitting(secret.matrix, secret.by_target["alpha-base"])} == {True}


@pytest.mark.parametrize("name", ["extra", "Extra"])
def test_an_addon_is_explained_by_any_of_its_names(image_set: ImageSet, name: str) -> None:
    explanation = explain.explained(image_set, name)
    assert (explanation.target, explanation.exists) == ("extra", True) and explanation.head.startswith(
        "extra is an add-on: "
    )
    reasons = "\n".join(explanation.reasons)
    assert "cu1: Extra 1.5.0 for linux/amd64, Python 3.12 and 3.14\n" in reasons
    assert "tags with it: ros-extra:alpha-base-cu1\n" in reasons
    assert "rosml containerize --base-image ros" in reasons and "rosml join REGISTRY/ros" in reasons


def test_the_list_has_tags_first_and_says_who_has_none(real: ImageSet) -> None:
    done = CliRunner().invoke(listing.main, ["onnx"])
    tagged = [image for image in real.images if "onnx" in image.addons and image.tags]
    assert f"{len(tagged)} images, " in done.output and "none: a test" not in done.output
    assert "more images without a tag, which test onnx: ./rosml explain onnx" in done.output.splitlines()[-1]
    done = CliRunner().invoke(listing.main, ["devel"])
    assert (
        "none: a test" in done.output
        and "these have no tag, and test devel: ./rosml explain devel" in done.output.splitlines()[-1]
    )


def test_a_part_that_cannot_be_is_explained(image_set: ImageSet) -> None:
    explanation = explain.explained(image_set, "part:tensorflow-cu1-py314")
    assert not explanation.exists and "no release of tensorflow has a wheel for Python 3.14" in explanation.reasons[0]
    with pytest.raises(RosmlError, match="no part named 'extra-cu9'"):
        explain.explained(image_set, "part:extra-cu9")


@pytest.mark.parametrize(
    ("name", "names", "exists", "words"),
    [
        ("ros-torch:alpha-base-cu1", "extra", True, "--base-image ros-torch:alpha-base-cu1 --addons extra"),
        ("alpha-base", "extra-cpu", True, "REGISTRY/part:{common-cpu-py312,extra-cpu-py312} --tag REGISTRY/ros:alpha-base-with-"),
        ("alpha-base", "extra-cu1", True, "not for arm64: extra 1.5.0 has cu1 wheels for amd64 only"),
        ("alpha-base-extra-cu1", "extra", True, "has extra already"),
        ("alpha-base", "extra", False, "has no stack, so the add-on needs one; name a stack that has it: --addons extra-cu1 or extra-cpu"),
        ("alpha-base-torch-cu1", "extra-cpu", False, "is of stack cu1, and takes no add-on of cpu; name it without a stack"),
        ("alpha-base", "extra-cu1,extra-cpu", False, "an image has one stack, and these are of cpu and cu1"),
        ("alpha-base", "extr", False, "no add-on named 'extr'; did you mean 'extra'?"),
    ],
)  # fmt: skip
def test_whether_an_image_can_have_addons(name: str, names: str, exists: bool, words: str, image_set: ImageSet) -> None:
    image = image_set.by_tag(name) or image_set.by_target[name]
    explanation = explain.with_addons(image_set.matrix, image, name, names.split(","))
    assert explanation.exists is exists and words in explanation.text


@pytest.mark.parametrize(
    ("name", "distribution", "framework", "remedy"),
    [
        ("ghcr.io/me/ros-torch:alpha-base-cu9", "alpha", "torch",
         "take ghcr.io/me/ros-torch:alpha-base-cu1 or ghcr.io/me/ros-torch:alpha-base-cpu, with --addons extra"),
        ("ghcr.io/me/ros-ml:omega-base-cu9", "omega", "ml",
         "it goes without ml: take ghcr.io/me/ros:omega-base, with --addons extra-cu1"),
        ("ghcr.io/me/robot:1", "alpha", "none", "take ros:alpha-base, with --addons extra-cu1 or extra-cpu"),
    ],
)  # fmt: skip
def test_what_to_take_instead(name: str, distribution: str, framework: str, remedy: str, image_set: ImageSet) -> None:
    onto = addons.Onto(name, distribution, "base", framework, "cu9")
    assert addons.instead(image_set.matrix, onto, "extra") == remedy


@pytest.mark.parametrize(
    ("before", "after", "problem"),
    [
        ("beside: [torch]", "beside: [torsh]", "no framework named 'torsh'; did you mean 'torch'?"),
        (ENTRY, ENTRY + "  torch: {parts: [torch, extra]}\n", "extra is a part of add-on extra"),
    ],
)
def test_a_mistake_is_named(before: str, after: str, problem: str) -> None:
    with pytest.raises(RosmlError) as caught:
        parse(changed(before, after, MATRIX))
    assert problem in str(caught.value)


def test_parts_come_after_those_of_frameworks() -> None:
    *others, last = MATRIX.rstrip().split("\n")
    first = next(number for number, line in enumerate(others) if line.startswith("  - {name: torch"))
    with pytest.raises(
        RosmlError, match="extra comes before torch in 'parts', which framework torch takes; move it behind"
    ):
        parse("\n".join([*others[:first], last, *others[first:], ""]))


def test_the_page_of_tags_has_addons(image_set: ImageSet) -> None:
    """Each with its stacks; and tags with one, by their component if that is the only one."""
    table = tags_page.tables(image_set)
    assert "| `extra` | Extra 1.5.0 | `cu1` | 3.12, 3.14 | linux/amd64 | any registry |" in table
    assert "| `extra` | Extra 1.5.0 | `cpu` | 3.12, 3.14 | linux/amd64, linux/arm64 | any registry |" in table
    assert "| `ros-extra:<distribution>-base-cu1` | " in table and "ros-torch-extra" not in table
