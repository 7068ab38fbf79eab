"""`rosml list`: all images, or those that are in all of some groups; for people and for machines."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import pytest
from click.testing import CliRunner
from conftest import SMALL, changed

from rosml.base.errors import RosmlError
from rosml.cli.images import listing, tables
from rosml.images.image_set import selection
from rosml.images.image_set.locked import with_locks
from rosml.images.image_set.model import ImageSet


def targets(image_set: ImageSet, *groups: str) -> list[str]:
    return [image.target for image in selection.members(image_set, groups)]


def test_groups_narrow_the_list_down(small: ImageSet) -> None:
    assert targets(small) == [image.target for image in small.images]
    assert targets(small, "omega", "none") == ["omega-core", "omega-base"]
    assert targets(small, "alpha", "torch", "cu1") == [
        "alpha-core-torch-cu1",
        "alpha-base-torch-cu1",
        "alpha-desktop-torch-cu1",
    ]
    assert targets(small, "alpha", "core", "arm64") == ["alpha-core", "alpha-core-torch-cpu", "alpha-core-ml-cpu"]
    assert targets(small, "alpha", "omega") == []
    assert targets(with_locks(small, ()), "omega", "base", "cpu") == ["omega-base-torch-cpu"], "without a lock"


def test_groups_without_a_common_image(tmp_path: Path) -> None:
    robot = changed("components: [core, base]\n", "components: [core, base, robot]\n")
    (tmp_path / "matrix.yaml").write_text(robot)
    done = CliRunner().invoke(listing.main, ["--matrix", str(tmp_path / "matrix.yaml"), "alpha", "robot"])
    assert (done.exit_code, done.stdout) == (0, "")
    assert done.stderr == "no image is in all of alpha and robot; see why: ./rosml explain alpha-robot\n"


@pytest.mark.parametrize("width", [60, 120])
def test_tag_and_size_are_never_cut(
    real: ImageSet, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, width: int
) -> None:
    monkeypatch.setenv("COLUMNS", str(width))
    monkeypatch.setattr(sys.stdout, "isatty", lambda: True)
    images = selection.members(real, ["ros1-trixie", "torch"])
    tables.print_images(images)
    lines = capsys.readouterr().out.splitlines()
    rows = [line.split() for line in lines[1 : 1 + len(images)]]
    parts = {name for image in images for name in image.parts}
    assert any(f"{len(images)} images, {len(parts)} parts; GB: unpacked, a forecast" in line for line in lines)
    assert [row[0] for row in rows] == [image.tags[0] for image in images]
    assert [row[1] for row in rows] == [f"{image.disk.unpacked / 1000:.1f}" for image in images]


@pytest.mark.parametrize(
    ("words", "advice"),
    [
        (["rolling", "tensorflow"], "see why: rosml explain rolling-tensorflow"),
        (["cpu38"], "rosml explain <distribution>-<component>-<framework>"),
        (["jazzy", "torch", "cuda"], "torch and cuda are different images"),
    ],
)
def test_advice_about_groups_that_share_no_image(real: ImageSet, words: list[str], advice: str) -> None:
    assert advice in selection.none_in(real, words)


def test_a_group_that_does_not_exist(small: ImageSet) -> None:
    with pytest.raises(RosmlError, match="no group named 'omga'; did you mean 'omega'") as caught:
        selection.members(small, ["omga"])
    assert caught.value.exit_code == 2 and "alpha, amd64, arm64, base, core, cpu" in caught.value.remedy


@pytest.mark.parametrize(
    ("words", "remedy"),
    [
        (["jazzy,torch"], "rosml list jazzy torch"),
        (["jazzy-base-torch-cu130"], "rosml list jazzy base torch cu130"),
        (["me/rosml/ros-torch:jazzy-base-cu130"], "rosml explain jazzy-base-torch-cu130"),
    ],
)
def test_a_name_in_place_of_groups_has_a_remedy(real: ImageSet, words: list[str], remedy: str) -> None:
    with pytest.raises(RosmlError) as caught:
        selection.members(real, words)
    assert remedy in caught.value.remedy and caught.value.exit_code == 2


def test_command_for_machines(tmp_path: Path) -> None:
    (tmp_path / "matrix.yaml").write_text(SMALL)
    done = CliRunner().invoke(listing.main, ["--matrix", str(tmp_path / "matrix.yaml"), "--json", "alpha", "none"])
    images = json.loads(done.stdout)
    assert [image["target"] for image in images] == ["alpha-core", "alpha-base", "alpha-desktop"]
    assert all(image["inputs"] for image in images)
