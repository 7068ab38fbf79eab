"""Images and payloads that follow from the facts, and the reasons for those that do not."""

from __future__ import annotations

import pytest
from conftest import ROOT, changed, parse

from rosml import names, rules
from rosml.errors import RosmlError
from rosml.expand import Catalogue, combinations, with_locks
from rosml.explain import explain, why_not
from rosml.listing import facts


def test_every_axis(real: Catalogue) -> None:
    """The axes of the design, and as many images as it asks for."""
    ubuntu = ["noetic", "foxy", "humble", "iron", "jazzy", "kilted", "lyrical", "rolling"]
    assert list(real.matrix.distributions) == [*ubuntu, "bookworm", "trixie"]
    assert list(real.matrix.components) == ["core", "base", "robot", "perception", "desktop", "desktop-full"]
    assert list(real.matrix.frameworks) == ["none", "cuda", "torch", "tensorflow", "ml"]
    assert list(real.matrix.stacks) == ["cu128", "cu130", "cu121", "cpu", "cpu38"]
    assert len(real.images) == 485
    both = [image for image in real.images if len(image.platforms) == 2]
    assert len([tag for image in both for tag in image.tags]) > 300


def test_every_distribution_has_every_framework_that_its_facts_allow(real: Catalogue) -> None:
    kinds: dict[str, set[str]] = {}
    for image in real.images:
        kinds.setdefault(image.distribution, set()).add("-".join(filter(None, [image.framework, image.stack])))
    cuda = {"none", "cuda-cu121", "cuda-cu128", "cuda-cu130"}
    torch = cuda | {"torch-cu128", "torch-cu130", "torch-cpu"}
    ml = torch | {"tensorflow-cu128", "tensorflow-cpu", "ml-cu128", "ml-cpu"}
    for name in ("humble", "iron", "jazzy", "kilted", "bookworm", "trixie"):
        assert kinds[name] == ml
    for name in ("lyrical", "rolling"):  # no TensorFlow for Python 3.14
        assert kinds[name] == torch
    for name in ("noetic", "foxy"):  # Python 3.8; torch and TensorFlow contradict each other there
        assert kinds[name] == cuda | {"torch-cu121", "torch-cpu38", "tensorflow-cpu38"}


def test_image_facts(real: Catalogue) -> None:
    assert facts(real.image("bookworm-base-ml-cu128")) == {
        "target": "bookworm-base-ml-cu128",
        "distribution": "bookworm",
        "component": "base",
        "framework": "ml",
        "stack": "cu128",
        "os": "bookworm",
        "python": "3.11",
        "ros": 1,
        "ros_distro": "Debian",
        "platforms": ["linux/amd64"],
        "versions": {
            "torch": "2.10.0",
            "tensorflow": "2.20.0",
            "cuda": "12.8.90",
            "cudnn": "9.10.2.21",
            "nccl": "2.27.5",
        },
        "repository": "ros-ml",
        "tags": [
            "ros-ml:bookworm-base-cu128",
            "ros-ml:bookworm-base-cu128-torch2.10.0-tf2.20.0",
            "ros-ml:bookworm",
        ],
        "groups": ["bookworm", "base", "ml", "cu128", "all"],
        "parent": "bookworm-base",
        "packages": [],
        "parts": ["cuda-cu128", "common-cu128-py311", "torch-cu128-py311", "tensorflow-cu128-py311"],
        "locks": [
            "locks/cu128/amd64/any/cuda.txt",
            "locks/cu128/amd64/3.11/common.txt",
            "locks/cu128/amd64/3.11/torch.txt",
            "locks/cu128/amd64/3.11/tensorflow.txt",
        ],
        "tests": ["contract", "ros1", "ros1-core", "ros1-base", "cuda", "torch", "tensorflow", "ml"],
        "locked": True,
        "disk": {
            key: sum(
                getattr(size, key)
                for size in (
                    real.matrix.disk.os,
                    real.matrix.disk.components["core"],
                    real.matrix.disk.components["base"],
                    *real.matrix.disk.parts["cu128"].values(),
                )
            )
            for key in ("unpacked", "compressed")
        },
    }


def test_chain_skips_components_that_a_distribution_lacks(small: Catalogue) -> None:
    image = small.image("alpha-desktop")  # desktop builds on robot, which ROS 2 does not have
    assert image.parent == "alpha-base"
    assert image.tests == ("contract", "ros2", "ros2-core", "ros2-base", "ros2-desktop")
    assert image.packages == "ros-alpha-desktop"
    assert small.image("alpha-core").parent == "_os-ubuntu-24-04"


def test_an_index_lists_only_architectures_with_the_same_content(small: Catalogue) -> None:
    assert small.image("alpha-core").platforms == ("linux/amd64", "linux/arm64")
    assert small.image("alpha-core-torch-cu1").platforms == ("linux/amd64",)
    assert small.image("alpha-core-torch-cpu").platforms == ("linux/arm64",)
    assert small.image("alpha-core-ml-cpu").platforms == ("linux/arm64",)


def test_payloads_are_made_for_every_architecture_that_needs_them(small: Catalogue) -> None:
    payload = small.payload_by_name["tensorflow-cpu-py312"]
    assert payload.architectures == ("arm64",)  # ml is the only framework with TensorFlow, and torch is for arm64 only
    payload = parse(changed("wheels: {cu1: [amd64], cpu: [arm64]}", "wheels: {cu1: [amd64, arm64], cpu: [arm64]}"))\
        .payload_by_name["cuda-cu1"]  # fmt: skip
    assert payload.architectures == ("amd64", "arm64")
    assert payload.locks == ("locks/cu1/amd64/any/cuda.txt", "locks/cu1/arm64/any/cuda.txt")
    assert payload.os == "ubuntu-24.04"
    assert small.payload_by_name["torch-cu1-py314"].os == "ubuntu-26.04"
    assert [name for name in small.payload_by_name if name.startswith("cuda")] == ["cuda-cu1"]


def test_floating_tags(small: Catalogue) -> None:
    assert small.image("alpha-base").tags == ("ros:alpha-base", "ros:alpha", "ros:latest")
    assert small.image("alpha-core").tags == ("ros:alpha-core",)
    assert small.image("alpha-base-torch-cpu").tags[-1] == "ros-torch:alpha-base-cpu-torch2.10.0"
    assert small.image("omega-base-torch-cpu").tags[-1] == "ros-torch:omega"
    assert small.image("alpha-base-cuda-cu1").tags[1] == "ros-cuda:alpha-base-cu1-cuda12.8.90"


def test_latest_is_the_newest_long_term_release(real: Catalogue) -> None:
    latest = {tag: image.target for image in real.images for tag in image.tags if tag.endswith(":latest")}
    assert latest == {
        "ros:latest": "lyrical-base",
        "ros-cuda:latest": "lyrical-base-cuda-cu128",
        "ros-torch:latest": "lyrical-base-torch-cu128",
    }


def test_no_long_term_release_no_latest() -> None:
    without = parse(changed("    lts: true\n", ""))
    assert not [tag for image in without.images for tag in image.tags if tag.endswith(":latest")]


def test_names_and_tags_are_unique(real: Catalogue) -> None:
    tags = [tag for image in real.images for tag in image.tags]
    assert len(tags) == len(set(tags))
    assert all(len(tag.split(":")[1]) <= 128 for tag in tags)


def test_every_test_has_a_file(real: Catalogue) -> None:
    wanted = {test for image in real.images for test in image.tests}
    assert {test for test in wanted if not (ROOT / "tests/structure" / f"{test}.yaml").is_file()} == set()


def test_every_lock_is_there_but_those_that_pytorchs_own_index_knows(real: Catalogue) -> None:
    wanted = {lock for payload in real.payloads for lock in payload.locks}
    assert {lock for lock in wanted if not (ROOT / lock).is_file()} == {
        "locks/cpu/amd64/3.11/torch.txt",
        "locks/cpu/amd64/3.14/common.txt",
        "locks/cpu/amd64/3.14/torch.txt",
        "locks/cpu38/amd64/3.8/torch.txt",
    }


def test_images_without_a_lock_are_in_no_group(small: Catalogue) -> None:
    locks = {lock for payload in small.payloads for lock in payload.locks}
    torch = "locks/cu1/amd64/3.12/torch.txt"
    catalogue = with_locks(small, locks - {torch})
    unlocked = [image for image in catalogue.images if not image.locked]
    assert {image.target for image in unlocked} == {
        f"alpha-{component}-{framework}-cu1"
        for component in ("core", "base", "desktop")
        for framework in ("torch", "ml")
    }
    assert all(image.unlocked == (torch,) for image in unlocked)
    grouped = {target for targets in catalogue.groups.values() for target in targets}
    assert not grouped & {name for image in unlocked for name in (image.target, image.test_target)}
    assert "payload-torch-cu1-py312" not in grouped
    assert "payload-torch-cu1-py314" in grouped
    assert f"there is no {torch}; run 'make locks'" in explain(catalogue, "alpha-core-torch-cu1")
    assert with_locks(small, locks) == small


def test_the_default_group_can_be_built(real: Catalogue) -> None:
    assert all(real.image(target).locked for target in (real.matrix.default.target, *real.matrix.default.group))


def test_every_combination_exists_or_has_a_reason(small: Catalogue, real: Catalogue) -> None:
    for catalogue in (small, real):
        for wanted in combinations(catalogue.matrix):
            target = names.image_target(*wanted)
            reason = why_not(catalogue, target)
            assert (target in catalogue.by_target) == (reason is None)
            assert reason is None or (reason.startswith(f"{target} does not exist: ") and reason.count("\n") == 0)


def test_colliding_targets() -> None:
    row = "{os: ubuntu-24.04, ros: 2, packages: x, components: [core], default_stack: cpu}"
    text = changed("distributions:\n", f"distributions:\n  alpha-core: {row}\n")
    text = changed("\ncomponents:\n", "\ncomponents:\n  core-core: {}\n", text)
    text = changed("    core: {un", "    core-core: {unpacked: 1, compressed: 1}\n    core: {un", text)
    text = changed("components: [core, base, desktop]", "components: [core, base, desktop, core-core]", text)
    with pytest.raises(RosmlError, match="alpha-core-core and alpha-core-core would both be the target") as caught:
        parse(text)
    assert caught.value.exit_code == 2


REASONS = {
    "alpha-robot": "alpha-robot does not exist: alpha (ROS 2) has no robot metapackage; it has core, base and desktop.",
    "alpha-robot-torch": "alpha-robot-torch does not exist: alpha (ROS 2) has no robot metapackage; "
    "it has core, base and desktop.",
    "omega-base-ml-cpu": "omega-base-ml-cpu does not exist: no release of tensorflow has a wheel for Python 3.14, "
    "the Python of ubuntu-26.04.",
    "omega-base-ml": "omega-base-ml does not exist on any stack: no release of tensorflow has a wheel for Python 3.14, "
    "the Python of ubuntu-26.04.",
    "alpha-base-cuda-cpu": "alpha-base-cuda-cpu does not exist: framework cuda needs accelerator cuda, "
    "and stack cpu has cpu.",
    "alpha-base-none-cpu": "alpha-base-none-cpu does not exist: framework none adds nothing to a ROS image, "
    "so it has no stack.",
    "alpha-base-torch": "alpha-base-torch names no stack; there is alpha-base-torch-cu1 and alpha-base-torch-cpu.",
    "alpha-base-none": "alpha-base-none is called alpha-base.",
    "cu1": "cu1: a group of 13 targets; see them with --list",
    "payload-cuda-cu1": "cuda-cu1: cuda of stack cu1, assembled from locks/cu1/amd64/any/cuda.txt, in 13 images",
}


@pytest.mark.parametrize("name", REASONS)
def test_reasons(small: Catalogue, name: str) -> None:
    assert explain(small, name) == REASONS[name]


REAL_REASONS = {
    "lyrical-base-tensorflow-cpu": "no release of tensorflow has a wheel for Python 3.14, the Python of ubuntu-26.04",
    "jazzy-robot": "jazzy (ROS 2) has no robot metapackage; it has core, base, perception, desktop and desktop-full",
    "bookworm-core-tensorflow-cu130": "stack cu130 has no release of tensorflow",
    "noetic-base-torch-cu128": "torch 2.10.0 has no wheel for Python 3.8, the Python of ubuntu-20.04 (2.4.1 has)",
    "noetic-base-ml-cpu38": "what framework ml needs of stack cpu38 does not go together (tensorflow 2.13.1 needs "
    "typing-extensions below 4.6, torch 2.4.1 needs 4.8)",
    "jazzy-base-cuda-cpu": "framework cuda needs accelerator cuda, and stack cpu has cpu",
}


@pytest.mark.parametrize("name", REAL_REASONS)
def test_reasons_of_the_real_matrix(real: Catalogue, name: str) -> None:
    assert why_not(real, name) == f"{name} does not exist: {REAL_REASONS[name]}."


def test_a_wheel_elsewhere_counts() -> None:
    small = parse(changed("cpu: [arm64]}}", "cpu: [arm64]}, elsewhere: {cpu: {amd64: {}}}, requires: [jinja2]}"))
    assert small.image("alpha-core-torch-cpu").platforms == ("linux/amd64", "linux/arm64")
    assert small.image("alpha-core-ml-cpu").platforms == ("linux/amd64", "linux/arm64")


def test_no_wheel_for_any_architecture() -> None:
    end = "\n    tools: colcon\n    codename: noble"
    small = parse(changed(f"[amd64, arm64]{end}", f"[amd64]{end}"))
    assert why_not(small, "alpha-core-torch-cpu") == (
        "alpha-core-torch-cpu does not exist: torch 2.10.0 has cpu wheels for arm64 only, "
        "and ubuntu-24.04 is built for amd64."
    )


def test_an_older_release_that_would_do() -> None:
    line = '    2.9.0: {python: ["3.14"], wheels: {}}\n'
    small = parse(changed("  tensorflow:\n    2.20.0", f"  tensorflow:\n{line}    2.20.0"))
    assert why_not(small, "omega-core-ml-cu1") == (
        "omega-core-ml-cu1 does not exist: tensorflow 2.20.0 has no wheel for Python 3.14, "
        "the Python of ubuntu-26.04 (2.9.0 has)."
    )


def test_why_an_image_exists(small: Catalogue) -> None:
    text = explain(small, "alpha-core-torch-cu1")
    assert "not for arm64: torch 2.10.0 has cu1 wheels for amd64 only" in text
    assert "it is alpha-core joined with cuda-cu1, common-cu1-py312 and torch-cu1-py312" in text
    assert explain(small, "alpha-core-torch-cu1-test") == text


def test_unknown_names(small: Catalogue) -> None:
    for ask in (lambda: explain(small, "alfa-core"), lambda: small.image("alfa-core")):
        with pytest.raises(RosmlError, match="no image named 'alfa-core'; did you mean 'alpha-core'") as caught:
            ask()
        assert caught.value.exit_code == 2
        assert "make list" in caught.value.remedy


def test_asking_for_what_cannot_be_gives_the_reason(small: Catalogue) -> None:
    with pytest.raises(RosmlError, match="has no robot metapackage"):
        small.image("alpha-robot")


def test_select(small: Catalogue) -> None:
    assert [image.target for image in small.select("alpha-core")] == ["alpha-core"]
    assert [image.target for image in small.select("default")] == ["alpha-core"]
    assert len(small.select("all")) == len(small.images)
    assert {image.component for image in small.select("desktop")} == {"desktop"}
    with pytest.raises(RosmlError):
        small.select("tests")


def test_architecture_reasons(small: Catalogue) -> None:
    matrix = small.matrix
    assert rules.architecture_reason(matrix, "ubuntu-24.04", "torch", "cu1", "amd64") is None
    assert rules.architecture_reason(matrix, "ubuntu-24.04", "torch", "cu1", "s390x") == (
        "images of ubuntu-24.04 are built for amd64 and arm64 only"
    )
