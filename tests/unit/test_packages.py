"""What pip and uv know of a part's packages, and the word that sets them free."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest
from conftest import ROOT

from rosml.matrix.model import SLOTS

SITE = "usr/local/lib/python3.11/dist-packages"
LOCK = """\
nvidia-nccl-cu12==2.27.5 \\
    --hash=sha256:0
    # via torch
nvidia-cublas==13.1.0.3
"""


def told(out: Path, *arguments: object) -> list[str]:
    """Calls packages.py for a part; returns the lines of its slot."""
    env = {**os.environ, "OUT": str(out), "SITE": f"/{SITE}", "PART": "torch"}
    subprocess.run([ROOT / "components/part/packages.py", *map(str, arguments)], env=env, check=True)
    return (out / f"usr/local/share/rosml/constraints.d/{arguments[0]}.txt").read_text().splitlines()


def test_a_slot_has_all_that_python_finds(tmp_path: Path) -> None:
    for name in ("torch-2.10.0+cpu", "typing_extensions-4.16.0", "Pillow-13.0.0", "ruamel.yaml-0.18"):
        (tmp_path / SITE / f"{name}.dist-info").mkdir(parents=True)
    assert told(tmp_path, "02", tmp_path / "*.txt") == [
        "# What the part torch holds",
        "pillow==13.0.0",
        "ruamel-yaml==0.18",
        "torch==2.10.0+cpu",
        "typing-extensions==4.16.0",
    ]


def test_packages_of_another_part_are_shown(tmp_path: Path) -> None:
    """In folders of their own: uv follows no link to one. What they lead to is where that part is joined."""
    (tmp_path / SITE).mkdir(parents=True)
    (tmp_path / "cuda.txt").write_text(LOCK)
    found = told(tmp_path, "01", tmp_path / "cuda.txt")
    assert found[1:] == ["nvidia-cublas==13.1.0.3", "nvidia-nccl-cu12==2.27.5"]
    folder = tmp_path / SITE / "nvidia_nccl_cu12-2.27.5.dist-info"
    assert folder.is_dir() and not folder.is_symlink()
    links = {file.name: os.readlink(file) for file in folder.iterdir()}
    assert links == {
        name: f"/usr/local/lib/rosml/cuda/{folder.name}/{name}" for name in ("INSTALLER", "METADATA", "RECORD", "WHEEL")
    }


def test_ros_images_have_a_slot_for_every_part_that_there_may_be() -> None:
    script = (ROOT / "components/base/install.sh").read_text()
    assert f"{{01..{SLOTS}}}" in script


def test_unpinned() -> None:
    """What ROS needs stays; the command gets its words as they were, and its exit code is the word's own."""
    word = str(ROOT / "components/base/unpinned.sh")
    command = [word, "bash", "-c", 'echo "$PIP_CONSTRAINT $UV_CONSTRAINT <$1>"; exit 7', "x", "a b"]
    env = {**os.environ, "UV_CONSTRAINT": "/usr/local/share/rosml/constraints.d/all.txt"}
    done = subprocess.run(command, env=env, capture_output=True, text=True, check=False)
    kept = "/usr/local/share/rosml/constraints.txt"
    assert (done.returncode, done.stdout) == (7, f"{kept} {kept} <a b>\n")


@pytest.mark.parametrize("shell", ["sh", "bash"])
def test_unpinned_without_a_command(shell: str) -> None:
    done = subprocess.run([shell, ROOT / "components/base/unpinned.sh"], capture_output=True, text=True, check=False)
    assert done.returncode == 64 and "usage: unpinned COMMAND" in done.stderr
