"""`make list`: all images, or those that are in all of some groups; for people and for machines."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest
from conftest import ROOT, SMALL

from rosml import listing
from rosml.errors import RosmlError
from rosml.expand import Catalogue, with_locks

SCRIPT = str(ROOT / "scripts/generate_bake.py")


def targets(catalogue: Catalogue, *groups: str) -> list[str]:
    return [image.target for image in listing.members(catalogue, groups)]


def test_groups_narrow_the_list_down(small: Catalogue) -> None:
    assert targets(small) == [image.target for image in small.images]
    assert targets(small, "omega", "none") == ["omega-core", "omega-base"]
    assert targets(small, "alpha", "torch", "cu1") == [
        "alpha-core-torch-cu1",
        "alpha-base-torch-cu1",
        "alpha-desktop-torch-cu1",
    ]
    assert targets(small, "alpha", "omega") == []


def test_a_group_that_does_not_exist(small: Catalogue) -> None:
    with pytest.raises(RosmlError, match="no group named 'omga'; did you mean 'omega'") as caught:
        listing.members(small, ["omga"])
    assert caught.value.exit_code == 2
    assert "cu1, cuda, default, desktop" in caught.value.remedy


def test_images_without_a_lock_are_listed(small: Catalogue) -> None:
    assert targets(with_locks(small, ()), "omega", "base", "cpu") == ["omega-base-torch-cpu"]


def test_command(real: Catalogue) -> None:
    """With two groups that the project's matrix has together, whatever it holds."""
    image = real.image(real.matrix.default.target)
    done = subprocess.run(
        ["make", "list", f"GROUP={image.distribution} {image.framework}"],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=True,
    )
    wanted = targets(real, image.distribution, image.framework)
    assert [line.split()[0] for line in done.stdout.splitlines()[1 : len(wanted) + 1]] == wanted
    assert f"\n{len(wanted)} images, " in done.stdout


def test_command_for_machines(tmp_path: Path) -> None:
    (tmp_path / "matrix.yaml").write_text(SMALL)
    argv = [sys.executable, SCRIPT, "--matrix", str(tmp_path / "matrix.yaml"), "--list", "--json"]
    argv += ["--group", "alpha", "--group", "none"]
    images = json.loads(subprocess.run(argv, capture_output=True, check=True).stdout)
    assert [image["target"] for image in images] == ["alpha-core", "alpha-base", "alpha-desktop"]
    assert all(image["inputs"] for image in images)


def test_a_reader_that_has_seen_enough() -> None:
    """`make list | head` is no error."""
    done = subprocess.run(
        ["bash", "-c", 'set -o pipefail; "$0" "$1" --list | head -1', sys.executable, SCRIPT],
        capture_output=True,
        text=True,
        check=False,
    )
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.startswith("target ")
