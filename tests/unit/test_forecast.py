"""Disk space: the forecast against numbers worked out by hand from the small matrix, and the check before a build."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest

from rosml.base.errors import RosmlError
from rosml.images.image_set import ImageSet
from rosml.machine import disk

# A ROS image counts unpacked + 2 * compressed, a part 2 * unpacked + 2 * compressed.
OS, COMPONENT = 100 + 2 * 10, 20 + 2 * 2
CUDA, COMMON, TORCH = 2 * 1000 + 2 * 100, 2 * 300 + 2 * 30, 2 * 2000 + 2 * 200


@pytest.mark.parametrize(
    ("target", "built", "needed"),
    [
        ("alpha-core", [], OS + COMPONENT),
        ("alpha-desktop", [], OS + 3 * COMPONENT),
        ("alpha-core", ["alpha-core"], 0),
        ("alpha-core-torch-cu1", [], OS + COMPONENT + CUDA + COMMON + TORCH),
        ("alpha-core-torch-cu1", ["alpha-core"], CUDA + COMMON + TORCH),
        ("alpha-core-torch-cu1", ["cuda-cu1", "common-cu1-py312"], OS + COMPONENT + TORCH),
        ("alpha-core-torch-cu1", ["alpha-core", "cuda-cu1", "common-cu1-py312", "torch-cu1-py312"], 0),
        ("omega-core-torch-cu1", ["cuda-cu1", "common-cu1-py312", "torch-cu1-py312"], OS + COMPONENT + COMMON + TORCH),
    ],
)
def test_needed(small: ImageSet, target: str, built: list[str], needed: int) -> None:
    found = disk.needed_mb(small, small.image(target), built)
    assert found == needed


@pytest.mark.parametrize(
    ("target", "built", "needed"),
    [
        ("alpha-base", ["alpha-core"], COMPONENT),
        ("alpha-desktop", ["alpha-core"], 2 * COMPONENT),
        ("alpha-core", ["_os-ubuntu-24-04"], COMPONENT),
        ("alpha-base-torch-cu1", ["alpha-core", "cuda-cu1", "common-cu1-py312", "torch-cu1-py312"], COMPONENT),
    ],
)
def test_what_lies_below_is_not_the_image(small: ImageSet, target: str, built: list[str], needed: int) -> None:
    """The component below is there; the component itself still has to be installed."""
    found = disk.needed_mb(small, small.image(target), built)
    assert found == needed


def free(monkeypatch: pytest.MonkeyPatch, megabytes: int) -> None:
    """Makes every file system have this much room."""

    usage = shutil.disk_usage("/")._replace(free=megabytes * 1_000_000)
    monkeypatch.setattr(shutil, "disk_usage", lambda path: usage)


def test_enough(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    free(monkeypatch, 5_000 + disk.RESERVE_MB)
    disk.require(tmp_path, 5_000, "a")


def test_too_little(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    free(monkeypatch, 4_999 + disk.RESERVE_MB)
    with pytest.raises(RosmlError, match="not enough disk space"):
        disk.require(tmp_path, 5_000, "a-core")
    free(monkeypatch, 300)
    with pytest.raises(RosmlError, match=r"build a-core: 7\.1 GB are needed .* 0\.3 GB are free at ") as caught:
        disk.require(tmp_path, 5_100, "a-core")
    assert "rosml setup clean" in caught.value.remedy
    assert "rosml list" in caught.value.remedy


def test_nothing_to_build_needs_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    free(monkeypatch, 1)
    disk.require(tmp_path, 0, "a")


def test_gigabytes() -> None:
    assert [disk.gigabytes(size) for size in (0, 999, 12345)] == ["0.0 GB", "1.0 GB", "12.3 GB"]
