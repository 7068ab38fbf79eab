"""Shards: estimates worked out by hand from the small matrix, and properties that hold for every plan."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from typing import Any

import pytest
from conftest import changed, parse

from fakes.counting import calls
from rosml.base.errors import RosmlError
from rosml.images.builds import disk
from rosml.images.image_set.model import ImageSet
from rosml.images.publish import shards as dealing
from tests import synthetic


@pytest.fixture(scope="module")
def big() -> ImageSet:
    """Ten distributions on eight operating systems, five stacks, two architectures."""
    return parse(synthetic.matrix(10 * synthetic.IMAGES))


def everything(image_set: ImageSet, **more: Any) -> dealing.Work:
    """All images and parts are built, and all images tested."""
    images = frozenset((image.target, name) for image in image_set.images for name in image.architectures)
    parts = frozenset((part.target, name) for part in image_set.parts for name in part.architectures)
    return dealing.Work(images, images | parts, images, **more)


def deal(image_set: ImageSet, shards: int) -> tuple[dealing.Shard, ...]:
    return dealing.deal(image_set, shards, everything(image_set))


# ---- Estimates -------------------------------------------------------------------------------------------------------


def test_a_shard(small: ImageSet) -> None:
    shards = deal(small, 4)
    assert [shard.name for shard in shards] == ["amd64-1", "amd64-2", "arm64-1", "arm64-2"]
    first = shards[0]
    assert (first.architecture, first.platform, first.runner) == ("amd64", "linux/amd64", "amd")
    assert first.distributions == ("alpha",)
    assert first.targets[:4] == ("alpha-core", "alpha-base", "alpha-desktop", "alpha-core-cuda-cu1")
    assert len(first.targets) == 12
    assert first.parts == (
        "cuda-cu1",
        "common-cu1-py312",
        "torch-cu1-py312",
        "tensorflow-cc-cu1",
        "tensorflow-cu1-py312",
    )
    # The operating system, three components, and the parts cuda, common, torch and tensorflow.
    assert first.estimates.download_mb == 10 + 3 * 2 + 100 + 30 + 200 + 150
    parts = (1000 + 100) + (300 + 30) + (2000 + 200) + (1500 + 150)
    assert first.estimates.disk_mb == (100 + 2 * 10) + 3 * (20 + 2 * 2) + 2 * parts + disk.RESERVE_MB
    assert first.estimates.seconds == (100 + 3 * 20) // 10 + (1000 + 300 + 2000 + 1500) // 100 + 12 * 5 + 2 == 126
    assert [shard.estimates.seconds for shard in shards] == [126, 79 - 10, 76, 44], "CUDA is built once"
    assert [shard.elsewhere for shard in shards] == [(), ("cuda-cu1",), (), ()]


def test_what_took_longer_the_last_time_counts_so(small: ImageSet) -> None:
    seconds = {("alpha-core", "amd64"): {"test": 105.2, "build": 0.4}, ("part-cuda-cu1", "amd64"): {"build": 1010.0}}
    before, after = deal(small, 1)[0], dealing.deal(small, 1, everything(small, seconds=seconds))[0]
    assert after.estimates.seconds - before.estimates.seconds == (106 - 6) + (1010 - 10)


def test_what_a_shard_has_already_costs_nothing(small: ImageSet) -> None:
    apart, together = deal(small, 4), deal(small, 2)
    names = {number: [shard.name for shard in deal(small, number)] for number in (1, 3)}
    assert names == {1: ["amd64-1", "arm64-1"], 3: ["amd64-1", "amd64-2", "arm64-1"]}, "the longer one gets the third"
    assert [shard.estimates.seconds for shard in together] == [126 + 79 - 10, 76 + 44]
    assert together[0].parts.count("cuda-cu1") == 1
    saved = apart[0].estimates.disk_mb + apart[1].estimates.disk_mb - together[0].estimates.disk_mb
    assert saved == 2 * 1000 + 2 * 100 + disk.RESERVE_MB
    assert apart[0].estimates.download_mb + apart[1].estimates.download_mb - together[0].estimates.download_mb == 100


def test_only_what_is_included(small: ImageSet) -> None:
    work = everything(small)
    requested = frozenset(key for key in work.images if key[0] == "alpha-desktop-torch-cpu")
    shards = dealing.deal(small, 4, dataclasses.replace(work, images=requested))
    assert [(shard.name, shard.targets) for shard in shards] == [
        ("arm64-1", ("alpha-core", "alpha-base", "alpha-desktop", "alpha-desktop-torch-cpu"))
    ]
    assert shards[0].parts == ("common-cpu-py312", "torch-cpu-py312")


def test_distributions_that_share_come_together() -> None:
    image_set = parse(synthetic.matrix(16 * synthetic.IMAGES))
    system = {name: row.os for name, row in image_set.matrix.distributions.items()}
    for shard in deal(image_set, 16):
        assert len(shard.distributions) == 2
        assert len({system[name] for name in shard.distributions}) == 1


# ---- Properties ------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("number", [2, 7, 12, 99])
def test_every_plan(big: ImageSet, number: int) -> None:
    shards = deal(big, number)
    assert len(shards) == min(number, 20)
    require_whole(big, shards)


def require_whole(image_set: ImageSet, shards: Sequence[dealing.Shard]) -> None:
    """Every image is built once, after what it stands on, and so is every part; the longest shards of an architecture come first."""
    expected = {(image.target, architecture) for image in image_set.images for architecture in image.architectures}
    built = [(target, shard.architecture) for shard in shards for target in shard.targets]
    assert len(built) == len(set(built)), "an image is built twice"
    assert set(built) == expected
    parts = [(name, shard.architecture) for shard in shards for name in shard.parts if name not in shard.elsewhere]
    assert len(parts) == len(set(parts)), "a part is built twice"
    assert set(parts) == {(name, shard.architecture) for shard in shards for name in shard.parts}
    for shard in shards:
        place = {target: index for index, target in enumerate(shard.targets)}
        for target in shard.targets:
            image = image_set.by_target[target]
            assert place.get(image.parent, -1) < place[target], "an image stands before what it stands on"
            assert set(image.parts) <= set(shard.parts)
    for architecture in ("amd64", "arm64"):
        seconds = [shard.estimates.seconds for shard in shards if shard.architecture == architecture]
        assert seconds == sorted(seconds, reverse=True)


@pytest.mark.parametrize("number", [4, 8, 12])
def test_balanced(big: ImageSet, number: int) -> None:
    """No shard takes longer than its fair share of all the work and the longest unit together."""
    units = deal(big, 99)
    longest = max(unit.estimates.seconds for unit in units)
    shards = deal(big, number)
    assert (
        max(shard.estimates.seconds for shard in shards)
        <= sum(unit.estimates.seconds for unit in units) / number + longest
    )


def test_work_grows_with_the_images_and_not_with_their_square() -> None:
    """Ten times the images; with their square it would be 100 times the work."""
    few, many = (parse(synthetic.matrix(images)) for images in (400, 4_000))
    assert calls(lambda: deal(many, 20)) < 12 * calls(lambda: deal(few, 20))


# ---- Disk ------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("number", [2, 24])
def test_each_machine_has_enough_disk(number: int, real: ImageSet) -> None:
    shards = deal(real, number)
    limits = {name: facts.runner_disk for name, facts in real.matrix.architectures.items()}
    assert all(limits.values()) and len(shards) >= number
    require_whole(real, shards)
    for shard in shards:
        assert shard.estimates.disk_mb <= (limits[shard.architecture] or 0)
        others = {name for it in shards if it.architecture == shard.architecture and it != shard for name in it.targets}
        assert others.issuperset(shard.ros_elsewhere)
    assert any(shard.ros_elsewhere for shard in shards), "one distribution is larger than a disk"
    assert not [*dealing.too_large(real, shards)]


def test_an_image_that_alone_is_larger_than_a_disk_is_named() -> None:
    small = parse(changed("runner: amd}", "runner: amd, runner_disk: 10000}"))
    shards = deal(small, 2)
    large = [shard for shard in shards if shard.estimates.disk_mb > 10_000]
    lines = [*dealing.too_large(small, shards)]
    assert large and len(lines) == len(large)
    assert "too little for alpha-core-ml-cu1 (12.7 GB)" in lines[0] and "alpha-core-torch-cu1" not in lines[0]
    assert "runner_disk" in lines[0]


# ---- What the matrix does not say ------------------------------------------------------------------------------------


def test_nobody_says_where_an_architecture_is_built() -> None:
    with pytest.raises(RosmlError, match=r"architectures.arm64: 'runner' is missing") as caught:
        deal(parse(changed(", runner: arm", "")), 2)
    assert "runner: ubuntu-24.04" in caught.value.remedy
    assert caught.value.exit_code == 2


def test_an_architecture_that_nothing_is_built_for_needs_no_runner() -> None:
    text = changed(", runner: arm", "", changed("default_stack: cpu", "default_stack: cu1"))
    text = text.replace("architectures: [amd64, arm64]", "architectures: [amd64]")
    assert [shard.architecture for shard in deal(parse(text), 1)] == ["amd64"]
