"""Disk space: the forecast against numbers worked out by hand from the small matrix, and the check before a build."""

from __future__ import annotations

import shutil
from pathlib import Path
from types import SimpleNamespace

import pytest

from fakes.stubs import buildx, calls, services
from rosml.base.errors import RosmlError
from rosml.images.builds import disk
from rosml.images.image_set.model import ImageSet

# A ROS image counts unpacked + 2 * compressed, a part 2 * unpacked + 2 * compressed.
OS, COMPONENT = 100 + 2 * 10, 20 + 2 * 2
CUDA, COMMON, TORCH = 2 * 1000 + 2 * 100, 2 * 300 + 2 * 30, 2 * 2000 + 2 * 200


@pytest.mark.parametrize(
    ("target", "built", "needed"),
    [
        ("alpha-core", [], OS + COMPONENT),
        ("alpha-desktop", [], OS + 3 * COMPONENT),
        ("alpha-desktop", ["alpha-core"], 2 * COMPONENT),
        ("alpha-base-torch-cu1", ["alpha-core", "cuda-cu1", "common-cu1-py312", "torch-cu1-py312"], COMPONENT),
        ("alpha-core-torch-cu1", [], OS + COMPONENT + CUDA + COMMON + TORCH),
        ("alpha-core-torch-cu1", ["cuda-cu1", "common-cu1-py312"], OS + COMPONENT + TORCH),
        ("alpha-core-torch-cu1", ["alpha-core", "cuda-cu1", "common-cu1-py312", "torch-cu1-py312"], 0),
        ("omega-core-torch-cu1", ["cuda-cu1", "common-cu1-py312", "torch-cu1-py312"], OS + COMPONENT + COMMON + TORCH),
    ],
)
def test_needed(small: ImageSet, target: str, built: list[str], needed: int) -> None:
    assert disk.needed_mb(small, small.image(target), set(built)) == needed


def free(monkeypatch: pytest.MonkeyPatch, megabytes: int) -> None:
    """Makes every file system have this much room."""
    usage = shutil.disk_usage("/")._replace(free=megabytes * 1_000_000)
    monkeypatch.setattr(shutil, "disk_usage", lambda path: usage)


def test_enough_room_for_a_build(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    free(monkeypatch, 5_000 + disk.RESERVE_MB)
    lines: list[str] = []
    disk.require(tmp_path, 5_000, "a", lines.append)
    assert lines == ["a needs about 5.0 GB of disk; 7.0 GB are free"]
    with pytest.raises(RosmlError, match=r"build a: 7\.0 GB are needed .* 7\.0 GB are free at "):
        disk.require(tmp_path, 5_001, "a", print)
    free(monkeypatch, 1)
    disk.require(tmp_path, 0, "a", pytest.fail)


@pytest.mark.parametrize(("after", "count"), [(9_000, 1), (5_000, 2)])
def test_room_is_made_before_a_build(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, after: int, count: int) -> None:
    machine = services(tmp_path, buildx=buildx(tmp_path, ""))
    lines: list[str] = []

    def usage(_: Path) -> object:
        pruned = any(call.startswith("buildx prune") for call in calls(tmp_path))
        return SimpleNamespace(free=(after if pruned else 4_000) * 1_000_000)

    monkeypatch.setattr(shutil, "disk_usage", usage)
    assert not disk.make_room(machine, 4_000 - disk.RESERVE_MB, lines.append)
    assert calls(tmp_path) == lines == []
    assert disk.make_room(machine, 6_000, lines.append)
    assert calls(tmp_path) == ["buildx prune --builder rosml --force --all --min-free-space 8000MB"]
    assert lines[0].startswith("4.0 GB are free, and 8.0 GB needed") and len(lines) == count


def test_somebodys_own_builder_keeps_its_cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    free(monkeypatch, 1)
    machine = services(tmp_path, buildx=buildx(tmp_path, ""), builder_kind="user")
    assert not disk.make_room(machine, 6_000, lambda _: None) and calls(tmp_path) == []


def test_a_cache_that_cannot_be_pruned_ends_no_build(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    free(monkeypatch, 1)
    lines: list[str] = []
    assert disk.make_room(services(tmp_path, buildx=["/nowhere/buildx"]), 6_000, lines.append)
    assert "was not pruned" in lines[1]


@pytest.mark.parametrize(
    ("target", "present", "needed"),
    [
        ("alpha-core-torch-cu1", set(), OS + COMPONENT + 1000 + 100 + 300 + 30 + 2000 + 200),
        ("alpha-core-torch-cu1", {"alpha-core", "cuda-cu1"}, 300 + 30 + 2000 + 200),
        ("alpha-desktop", {"alpha-core"}, 2 * COMPONENT),
    ],
)
def test_what_a_test_unpacks(small: ImageSet, target: str, present: set[str], needed: int) -> None:
    assert disk.tested_mb(small, small.image(target), present) == needed
