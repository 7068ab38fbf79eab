"""Images and parts that follow from the facts, and the reasons for those that do not."""

from __future__ import annotations

import json
from collections.abc import Callable
from itertools import product
from pathlib import Path

import pytest
from conftest import ROOT, SMALL, changed, parse, write_locks

from rosml.base.errors import RosmlError
from rosml.images.image_set import selection
from rosml.images.image_set.explain import explained, why_not
from rosml.images.image_set.explain import image as image_of
from rosml.images.image_set.load import load
from rosml.images.image_set.locked import with_locks
from rosml.images.image_set.model import ImageSet
from rosml.images.matrix import names


def test_image_facts(small: ImageSet) -> None:
    facts = json.loads(json.dumps(small.image("alpha-base-ml-cu1").to_json()))
    assert facts == {
        "target": "alpha-base-ml-cu1",
        "distribution": "alpha",
        "component": "base",
        "framework": "ml",
        "addons": [],
        "environment": "",
        "stack": "cu1",
        "os": "ubuntu-24.04",
        "python": "3.12",
        "ros": 2,
        "ros_distro": "alpha",
        "platforms": ["linux/amd64"],
        "versions": {"torch": "2.10.0", "tensorflow": "2.20.0", "cuda": "12.8.90", "cudnn": "9.10.2.21"},
        "repository": "ros-ml",
        "tags": [
            f"ros-ml:{tag}" for tag in ("alpha-base-cu1", "alpha-base-cu1-torch2.10.0-tf2.20.0", "alpha", "latest")
        ],
        "groups": ["alpha", "base", "ml", "cu1", "all"],
        "parent": "alpha-base",
        "packages": [],
        "wheels": [],
        "parts": ["cuda-cu1", "common-cu1-py312", "torch-cu1-py312", "tensorflow-cc-cu1", "tensorflow-cu1-py312"],
        "locks": [
            "locks/cu1/amd64/any/cuda.txt",
            "locks/cu1/amd64/3.12/common.txt",
            "locks/cu1/amd64/3.12/torch.txt",
            "locks/cu1/amd64/any/tensorflow-cc.txt",
            "locks/cu1/amd64/3.12/tensorflow.txt",
        ],
        "tests": ["contract", "tools", "ros2", "ros2-beside", "cuda", "torch", "tensorflow"],
        "locked": True,
        "disk": {"unpacked": 100 + 2 * 20 + 1000 + 300 + 2000 + 1500, "compressed": 10 + 2 * 2 + 100 + 30 + 200 + 150},
    }


CHANNELS = {
    "live": "packages come from ROS's live apt repository, http://ros.test/ros2/ubuntu",
    "final": "packages come from ROS's apt snapshot: final, which gets no updates",
    "snapshot, date: 2026-10-01": "packages come from ROS's apt snapshot: of 2026-10-01",
}


@pytest.mark.parametrize("channel", CHANNELS)
def test_where_packages_come_from(channel: str) -> None:
    ended = changed("eol: 2029-05-31", "eol: 2025-05-31")
    image_set = parse(changed("apt: {channel: live}", f"apt: {{channel: {channel}}}", ended))
    assert CHANNELS[channel] in explained(image_set, "alpha-core").text


DAY = {"ROS_CHANNEL": "snapshot", "ROS_SNAPSHOT": "2026-08-07"}


@pytest.mark.parametrize(
    ("target", "environment", "source"),
    [
        ("jazzy-core", DAY, "ROS's apt snapshot: of 2026-08-07, http"),
        ("jazzy-base-torch-cu128", DAY, "ROS's apt snapshot: of 2026-08-07, http"),
        ("foxy-core", {"ROS_CHANNEL": "live"}, "ROS's live apt repository, http"),
    ],
)
def test_where_packages_come_from_this_time(
    real: ImageSet, target: str, environment: dict[str, str], source: str
) -> None:
    assert f"\n  - this time, packages come from {source}" in explained(real, target, environment).text


def test_what_no_channel_can_change(real: ImageSet) -> None:
    with pytest.raises(RosmlError, match="the ROS packages of ros1-bookworm are bookworm's own"):
        explained(real, "ros1-bookworm-core", DAY)


def test_chain_skips_components_that_a_distribution_lacks(small: ImageSet) -> None:
    image = small.image("alpha-desktop")  # desktop builds on robot, which ROS 2 does not have
    assert (image.parent, image.packages) == ("alpha-base", "ros-alpha-desktop")
    assert image.tests == ("contract", "tools", "ros2", "ros2-beside", "ros2-desktop", "ros2-components")
    assert image.shared == ("ros2-core", "ros2-base", "ros2-workspace", "pip")
    assert image.proven_by == ("alpha-base", "alpha-core")
    assert small.image("alpha-core").parent == "_os-ubuntu-24-04"


def test_an_index_lists_only_architectures_with_the_same_content(small: ImageSet) -> None:
    assert small.image("alpha-core").platforms == ("linux/amd64", "linux/arm64")
    assert small.image("alpha-core-torch-cu1").platforms == ("linux/amd64",)
    assert small.image("alpha-core-torch-cpu").platforms == ("linux/arm64",)
    assert small.image("alpha-core-ml-cpu").platforms == ("linux/arm64",)


def test_parts_are_made_for_every_architecture_that_needs_them(small: ImageSet) -> None:
    part = small.part_by_name["tensorflow-cpu-py312"]
    assert part.architectures == ("arm64",)  # ml is the only framework with TensorFlow, and torch is for arm64 only
    wheels = "wheels: {cu1: [amd64], cpu: [arm64]}"
    part = parse(changed(wheels, wheels.replace("cu1: [amd64]", "cu1: [amd64, arm64]"))).part_by_name["cuda-cu1"]
    assert part.architectures == ("amd64", "arm64")
    assert part.locks == ("locks/cu1/amd64/any/cuda.txt", "locks/cu1/arm64/any/cuda.txt")
    assert part.os == "ubuntu-24.04" and small.part_by_name["torch-cu1-py314"].os == "ubuntu-26.04"
    assert [name for name in small.part_by_name if name.startswith("cuda")] == ["cuda-cu1"]


def test_floating_tags(small: ImageSet) -> None:
    assert small.image("alpha-base").tags == ("ros:alpha-base", "ros:alpha", "ros:latest")
    assert small.image("alpha-core").tags == ("ros:alpha-core",)
    assert small.image("alpha-base-torch-cpu").tags[-1] == "ros-torch:alpha-base-cpu-torch2.10.0"
    assert small.image("omega-base-torch-cpu").tags[-1] == "ros-torch:omega"
    assert small.image("alpha-base-cuda-cu1").tags[1] == "ros-cuda:alpha-base-cu1-cuda12.8.90"


def test_a_name_that_a_distribution_had(small: ImageSet) -> None:
    renamed = parse(changed("  alpha:\n    os:", "  alpha:\n    aliases: [old]\n    os:"))
    assert renamed.image("alpha-core").tags == ("ros:alpha-core", "ros:old-core")
    versions = ("alpha-base-cu1", "alpha-base-cu1-torch2.10.0", "old-base-cu1", "old-base-cu1-torch2.10.0")
    tags = tuple(f"ros-torch:{tag}" for tag in (*versions, "alpha", "old", "latest"))
    assert renamed.image("alpha-base-torch-cu1").tags == tags
    assert [image.target for image in renamed.images] == [image.target for image in small.images]
    assert why_not(renamed, "old-base-torch-cu1") == "old-base-torch-cu1 is called alpha-base-torch-cu1."
    assert why_not(renamed, "old") == "old is called alpha."
    assert why_not(small, "old-base-torch-cu1") is None and why_not(small, "old") is None


def test_no_long_term_release_no_latest() -> None:
    without = parse(changed("    lts: true\n", ""))
    assert not [tag for image in without.images for tag in image.tags if tag.endswith(":latest")]


def test_latest_is_of_a_distribution_that_has_the_component_of_the_short_tags() -> None:
    newer = parse(changed("components: [core, base]\n    default_stack: cpu\n",
                          "components: [core]\n    default_stack: cpu\n    eol: 2040-01-01\n    lts: true\n"))  # fmt: skip
    assert [image.target for image in newer.images if "ros:latest" in image.tags] == ["alpha-base"]


def test_latest_is_of_a_distribution_that_has_every_framework() -> None:
    """The newer one has no TensorFlow, until a release of it has that Python."""
    newer = changed("    apt: {channel: snapshot", "    eol: 2031-05-31\n    lts: true\n    apt: {channel: snapshot")
    wheels = "python: [%s], wheels: {cu1: [amd64], cpu: [amd64, arm64]}"
    for text, row in ((newer, "alpha"), (changed(wheels % '"3.12"', wheels % '"3.12", "3.14"', newer), "omega")):
        assert [image.target for image in parse(text).images if "ros:latest" in image.tags] == [f"{row}-base"]


def test_a_group_without_a_lock_is_explained(small: ImageSet) -> None:
    locks = {lock for part in small.parts if part.stack != "cpu" for lock in part.locks}
    assert explained(with_locks(small, locks), "cpu").text.startswith(
        "cpu: a group of no targets: none of its images has a lock; run 'rosml locks'"
    )


def test_an_image_named_like_a_part() -> None:
    """Both are keys of DIGESTS."""
    text = (
        SMALL.replace("  cu1:", "  a-b:")
        .replace("cu1", "a-b")
        .replace("  alpha:", "  common-a:")
        .replace("alpha-", "common-a-")
    )
    text = changed("  robot: {builds_on: base}", "  robot: {builds_on: base}\n  b-py312: {builds_on: base}", text)
    text = changed("    robot: {unp", "    b-py312: {unpacked: 1, compressed: 1}\n    robot: {unp", text)
    with pytest.raises(
        RosmlError,
        match=r"stacks\.a-b: the part common of a-b and Python 3.12 and .* would both be called common-a-b-py312",
    ):
        parse(changed("components: [core, base, desktop]", "components: [core, base, b-py312, desktop]", text))


@pytest.mark.parametrize(
    ("text", "problem"),
    [
        (SMALL.replace("  omega:", "  alpha-core:"), "the group alpha-core and .* would both be called alpha-core"),
        (SMALL.replace("ubuntu-26.04", "ubuntu-24-04"), "would both be called _os-ubuntu-24-04; rename one"),
        (SMALL.replace('python: "3.14"\n', 'python: "3.12"\n'), "have Python 3.12 and so the same parts"),
        (
            SMALL.replace("architectures: [amd64, arm64]", "architectures: [amd64]"),
            r"omega\.default_stack: no framework exists for omega on stack cpu; there is cu1",
        ),
    ],
)
def test_what_contradicts_itself_is_refused(text: str, problem: str) -> None:
    with pytest.raises(RosmlError, match=problem) as caught:
        parse(text)
    assert caught.value.exit_code == 2


def test_names_and_tags_are_unique(real: ImageSet) -> None:
    tags = [tag for image in real.images for tag in image.tags]
    assert len(tags) == len(set(tags))
    assert all(len(tag.split(":")[1]) <= 128 for tag in tags)


def test_every_test_has_a_file(real: ImageSet) -> None:
    tests = {test for image in real.images for test in (*image.tests, *image.shared)}
    assert {test for test in tests if not (ROOT / "tests/structure" / f"{test}.yaml").is_file()} == set()


def test_explain_names_an_image_that_tests_for_it_once(real: ImageSet) -> None:
    """The ROS image below it may also be the one that runs shared tests."""
    tested = "what it shares with others is tested in jazzy-core: ros2-core, ros2-workspace and pip"
    assert tested in explained(real, "jazzy-base").reasons
    assert [image.target for image in real.images if len({*image.proven_by}) < len(image.proven_by)] == []


def test_images_without_a_lock_are_in_no_group(small: ImageSet) -> None:
    locks = {lock for part in small.parts for lock in part.locks}
    torch = "locks/cu1/amd64/3.12/torch.txt"
    image_set = with_locks(small, locks - {torch})
    unlocked = [image for image in image_set.images if not image.locked]
    assert {image.target for image in unlocked} == {
        f"alpha-{component}-{framework}-cu1"
        for component in ("core", "base", "desktop")
        for framework in ("torch", "ml")
    }
    assert all(image.unlocked == (torch,) for image in unlocked)
    grouped = {target for targets in image_set.groups.values() for target in targets}
    assert not grouped & {name for image in unlocked for name in (image.target, image.test_target)}
    assert "part-torch-cu1-py312" not in grouped
    assert "part-torch-cu1-py314" in grouped
    text = explained(image_set, "alpha-core-torch-cu1").text
    assert text.startswith("alpha-core-torch-cu1 exists, but cannot be built yet:\n")
    assert text.endswith(f"\n  - {torch} is missing; run 'rosml locks'")
    assert with_locks(small, locks) == small


def test_what_takes_long_is_tested_where_it_can_be_built(small: ImageSet) -> None:
    """In an image with both frameworks, unless that one has no lock, or is not for all architectures."""
    locks = {lock for part in small.parts for lock in part.locks}
    long = {"ros2-workspace", "pip"}

    def tested(image_set: ImageSet, target: str) -> bool:
        run = long.intersection(image_set.image(target).tests)
        assert run in (set(), long)
        return bool(run)

    without = with_locks(small, locks - {"locks/cu1/amd64/any/tensorflow-cc.txt"})
    for image_set, alone in ((small, False), (with_locks(small, locks), False), (without, True)):
        assert tested(image_set, "alpha-core-ml-cu1")
        assert tested(image_set, "alpha-core-torch-cu1") == alone
    torch_alone = changed("cpu: [arm64]}", "cpu: [amd64, arm64]}")
    tensorflow = '["3.12"], wheels: {cu1: [amd64], cpu: [amd64, arm64]}'
    assert tensorflow in torch_alone
    wider = parse(torch_alone.replace(tensorflow, '["3.12"], wheels: {cu1: [amd64], cpu: [arm64]}'))
    for image_set, alone in ((small, False), (wider, True)):
        assert image_set.image("alpha-core-ml-cpu").architectures == ("arm64",)
        assert tested(image_set, "alpha-core-torch-cpu") == alone


def lock_of_cuda(package: str) -> Callable[[str], str]:
    return lambda text: f"{text.splitlines()[0]}\n{package} \\\n    --hash=sha256:{'0' * 64}\n"


EDITS_OF_LOCKS: tuple[tuple[str, Callable[[str], str], bool], ...] = (
    ("3.12/torch", lambda text: text, True),
    ("3.12/torch", lambda text: text.replace("torch==2.10.0", "torch==2.10.0+cpu"), True),
    ("3.12/torch", lambda text: text.replace("torch==2.10.0", "torch==2.9.1"), False),
    ("3.12/torch", lambda text: text.replace("3.12", "3.14"), False),
    ("3.12/torch", lambda text: text[:-20], False),
    ("3.12/torch", lambda text: f"{text}-r /etc/passwd\n", False),
    ("3.12/torch", lambda text: f"{text}x @ https://example.org/x.whl\n", False),
    ("3.12/torch", lambda text: text.replace("--hash=sha256:", "#"), False),
    ("3.12/torch", lambda text: "\x00\ufffd", False),
    ("any/cuda", lock_of_cuda("nvidia-cuda-runtime-cu12==12.8.90"), True),
    ("any/cuda", lock_of_cuda("nvidia-cuda-runtime-cu12==12.8.93"), False),
    ("any/cuda", lock_of_cuda("nvidia-cudnn==9.10.2.22"), False),
    ("any/cuda", lock_of_cuda("nvidia-cublas-cu12==1"), True),
)


@pytest.mark.parametrize(("name", "edit", "counts"), EDITS_OF_LOCKS)
def test_a_lock_that_is_not_of_its_part_is_none(
    name: str, edit: Callable[[str], str], counts: bool, small: ImageSet, tmp_path: Path
) -> None:
    """One of another release, Python or CUDA; one that was cut or edited."""
    (tmp_path / "matrix.yaml").write_text(SMALL)
    write_locks(tmp_path, small)
    lock = tmp_path / f"locks/cu1/amd64/{name}.txt"
    lock.write_text(edit(lock.read_text()))
    assert load(tmp_path / "matrix.yaml", tmp_path).image("alpha-core-torch-cu1").locked == counts


SIZES = ", ".join(f"{part}: {{unpacked: 1, compressed: 1}}" for part in ("cuda", "common", "torch"))
CU2 = SMALL
for place, more in {
    "  cpu:\n    accelerator": "  cu2: {accelerator: cuda, cuda: 13.0.96, cudnn: 9.24.0.43, releases: {torch: 2.14.1}}\n",
    "  tensorflow:\n    2.20.0": '    2.14.1: {python: ["3.12"], wheels: {cu2: [amd64, arm64]}}\n',
    "    cpu:\n      common": f"    cu2: {{{SIZES}}}\n",
}.items():
    CU2 = changed(place, more + place, CU2)
"""The small matrix and a second stack with CUDA, which has no TensorFlow."""


def test_of_several_default_stacks_each_framework_takes_the_first_that_it_exists_on() -> None:
    image_set = parse(changed("default_stack: cu1", "default_stack: [cu2, cu1]", CU2))
    short = {
        tag: image.target for image in image_set.images for tag in image.tags if tag.endswith((":alpha", ":latest"))
    }
    ends = {"ros": "", "ros-cuda": "-cuda-cu2", "ros-torch": "-torch-cu2", "ros-ml": "-ml-cu1"}
    assert short == {f"{name}:{tag}": f"alpha-base{end}" for name, end in ends.items() for tag in ("alpha", "latest")}
    assert "short ones are for stack cu1 alone; take ros-ml:alpha-base-cu1" in (
        why_not(image_set, "ros-ml:alpha-cu1") or ""
    )


def test_a_framework_that_no_default_stack_has_gets_no_short_tag() -> None:
    image_set = parse(changed("default_stack: cu1", "default_stack: cu2", CU2))
    assert image_set.image("alpha-base-ml-cu1").tags == (
        "ros-ml:alpha-base-cu1",
        "ros-ml:alpha-base-cu1-torch2.10.0-tf2.20.0",
    )
    assert "the distribution's default stack has no such framework" in str(why_not(image_set, "ros-ml:alpha-cu1"))


def test_one_of_several_default_stacks_that_nothing_has() -> None:
    lacking = changed("{cu2: [amd64, arm64]}", "{cu2: [arm64]}", CU2).replace("[amd64, arm64]\n", "[amd64]\n")
    with pytest.raises(
        RosmlError, match=r"alpha\.default_stack: no framework exists for alpha on stack cu2; there is cu1"
    ):
        parse(changed("default_stack: cu1", "default_stack: [cu1, cu2]", lacking))
    with pytest.raises(RosmlError, match=r"default_stack\[1\]: no stack named 'cu3'"):
        parse(changed("default_stack: cu1", "default_stack: [cu1, cu3]", CU2))


def test_the_default_group_can_be_built(real: ImageSet) -> None:
    assert all(real.image(target).locked for target in (*real.matrix.default.targets, *real.matrix.default.group))


def test_every_combination_exists_or_has_a_reason(small: ImageSet, real: ImageSet) -> None:
    for image_set in (small, real):
        matrix = image_set.matrix
        kinds = [
            (framework, stack)
            for framework, facts in matrix.frameworks.items()
            for stack in (matrix.stacks if facts.parts else [None])
        ]
        for distribution, component, kind in product(matrix.distributions, matrix.components, kinds):
            target = names.image_target(distribution, component, *kind)
            reason = why_not(image_set, target)
            assert (target in image_set.by_target) == (reason is None)
            assert reason is None or (reason.startswith(f"{target} does not exist: ") and reason.count("\n") == 0)


TENSORFLOW = "no release of tensorflow has a wheel for Python 3.14, the Python of ubuntu-26.04."
STACKS = "names no stack; there is alpha-base-torch-cu1 and alpha-base-torch-cpu."
REASONS = {
    "alpha-robot": "does not exist: alpha (ROS 2) has no robot metapackage; it has core, base and desktop.",
    "alpha-robot-torch": "does not exist: alpha (ROS 2) has no robot metapackage",
    "omega-base-ml-cpu": f"does not exist: {TENSORFLOW}",
    "omega-base-ml": f"does not exist on any stack: {TENSORFLOW}",
    "omega-ml": f"does not exist on any stack: {TENSORFLOW}",
    "ros-ml:omega-base-cpu": f"does not exist: {TENSORFLOW}",
    "x.org:5000/y/ros-ml:omega": f"does not exist on any stack: {TENSORFLOW}",
    "alpha-base-cuda-cpu": "framework cuda needs accelerator cuda, and stack cpu has cpu",
    "alpha-base-none-cpu": "framework none adds nothing to a ROS image",
    "alpha-base-torch": STACKS,
    "alpha-torch": STACKS,
    "ros-torch:alpha-base": STACKS,
    "alpha-base-none": "is called alpha-base.",
    "alpha-torch-cpu": "is called alpha-base-torch-cpu.",
    "ros-torch:alpha-cpu": "short ones are for stack cu1 alone; take ros-torch:alpha-base-cpu.",
    "cu1": "a group of 13 targets; see them with: rosml list cu1",
    "default": "a group of 1 target",
    "parts": "a group of 13 targets; see them with: rosml list",
    **dict.fromkeys(("part-cuda-cu1", "part:cuda-cu1", "ghcr.io/me/rosml/part:cuda-cu1"), "built from locks/cu1/amd64/any/cuda.txt, in 13 images; rosml part cuda-cu1 builds it"),
}  # fmt: skip


@pytest.mark.parametrize(("name", "reason"), REASONS.items())
def test_reasons(small: ImageSet, name: str, reason: str) -> None:
    assert reason in explained(small, name).text


def test_a_part_for_one_generation_of_cuda() -> None:
    """Stacks of another one have no images with it, and need no forecast of its size."""
    text = changed(
        "  - {name: common,",
        '  - {name: nvcc, accelerator: cuda, any_python: true, takes: [nvcc], adds: {"13": [nvcc]}, tested: false}\n  - {name: common,',
        changed("parts: [cuda], acc", "parts: [cuda, nvcc], acc"),
    )
    image_set = parse(text)
    reason = "part nvcc is for CUDA 13, and stack cu1 has CUDA 12.8.90."
    assert explained(image_set, "alpha-base-cuda-cu1").text.endswith(reason)
    assert image_set.image("alpha-base-torch-cu1").parts == ("cuda-cu1", "common-cu1-py312", "torch-cu1-py312")


@pytest.mark.parametrize(
    ("name", "says"),
    [
        ("part:cuda", "no part named 'cuda'; there is cuda-cu1$"),
        ("x.org/part:cda-cu1", "no part named 'cda-cu1'; did you mean 'cuda-cu1'"),
    ],
)
def test_a_part_that_there_is_not(small: ImageSet, name: str, says: str) -> None:
    with pytest.raises(RosmlError, match=says) as caught:
        explained(small, name)
    assert caught.value.remedy == "see all with: rosml part"


def test_a_platform_is_an_architecture(small: ImageSet) -> None:
    for platform in ("linux/arm64", "arm64", "aarch64", "linux/arm64/v8"):
        assert selection.architecture_of(small, platform) == "arm64"
    with pytest.raises(RosmlError, match="no platform named 'arm'") as caught:
        selection.architecture_of(small, "arm")
    assert caught.value.remedy == "take linux/amd64 or linux/arm64"


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


@pytest.mark.parametrize(
    ("versions", "hint"), [(["2.9.0"], "(2.9.0 has)"), (["2.8.0", "2.9.0"], "(2.8.0 and 2.9.0 have)")]
)
def test_older_releases_that_would_do(versions: list[str], hint: str) -> None:
    lines = "".join(f'    {version}: {{python: ["3.14"], wheels: {{}}}}\n' for version in versions)
    small = parse(changed("  tensorflow:\n    2.20.0", f"  tensorflow:\n{lines}    2.20.0"))
    reason = why_not(small, "omega-core-ml-cu1") or ""
    assert "tensorflow 2.20.0 has no wheel for Python 3.14" in reason and hint in reason


def test_why_an_image_exists(small: ImageSet) -> None:
    text = explained(small, "alpha-core-torch-cu1").text
    assert "not for arm64: torch 2.10.0 has cu1 wheels for amd64 only" in text
    assert "it is alpha-core joined with cuda-cu1, common-cu1-py312 and torch-cu1-py312" in text
    assert explained(small, "alpha-core-torch-cu1-test").text == text


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("alfa-core", "no image named 'alfa-core'; did you mean 'alpha-core'"),
        ("ros-torch:alpha-core-cu9", "did you mean 'ros-torch:alpha-core-cu1', 'ros-torch:alpha-core-cpu'"),
        ("ros:beta", "no image named 'ros:beta'"),
    ],
)
def test_unknown_names(small: ImageSet, name: str, words: str) -> None:
    with pytest.raises(RosmlError) as caught:
        explained(small, name)
    assert words in caught.value.message and caught.value.exit_code == 2 and "rosml list" in caught.value.remedy
    with pytest.raises(RosmlError, match=f"no image named '{name}'"):
        image_of(small, name)


def test_an_image_that_cannot_be_is_refused_with_the_reason(small: ImageSet) -> None:
    with pytest.raises(RosmlError, match="has no robot metapackage"):
        image_of(small, "alpha-robot")


@pytest.mark.parametrize("name", ["ros:alpha-base", "localhost:5000/ros:alpha", "https://x.org/y/ros:latest"])
def test_a_tag_is_a_name_as_well(small: ImageSet, name: str) -> None:
    assert small.image(name).target == "alpha-base"
