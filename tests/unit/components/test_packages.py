"""What pip and uv know of a part's packages, and the word that sets them free."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest
from conftest import ROOT

from rosml.images.matrix.patterns import SLOTS

SITE = "usr/local/lib/python3.11/dist-packages"
LOCK = """\
nvidia-nccl-cu12==2.27.5 \\
    --hash=sha256:0
    # via torch
nvidia-cublas==13.1.0.3
"""


def slot_lines(out: Path, *arguments: object, name: str = "torch") -> list[str]:
    """Calls packages.py for a part; returns the lines of its slot."""
    env = {**os.environ, "OUT": str(out), "SITE": f"/{SITE}", "PART": name}
    subprocess.run([ROOT / "components/part/packages.py", *map(str, arguments)], env=env, check=True)
    return (out / f"usr/local/share/rosml/constraints.d/{arguments[0]}.txt").read_text().splitlines()


ASKS = """\
Metadata-Version: 2.1
Requires-Dist: typing-extensions>=4.10.0
Requires-Dist: Jinja2
Requires-Dist: pillow (!=8.3.*,>=5.3.0)
Requires-Dist: cuda_toolkit[cublas,nvrtc] ==13.0.3 ; platform_system == "Linux"
Requires-Dist: triton~=3.6.0; platform_system == "Linux"
Requires-Dist: opt-einsum>=3.3; extra == "opt-einsum"

Requires-Dist: nothing>=1 is what the description says
"""


def part(folder: Path, *names: str) -> Path:
    """A part's packages, of which PyTorch asks for others."""
    for name in names:
        (folder / SITE / f"{name}.dist-info").mkdir(parents=True)
    (folder / SITE / f"{names[0]}.dist-info/METADATA").write_text(ASKS)
    return folder


def test_a_slot_keeps_what_pins_name_and_holds_the_rest_to_what_the_part_asks_for(tmp_path: Path) -> None:
    packages = part(tmp_path, "torch-2.10.0+cpu", "triton-3.6.0", "typing_extensions-4.16.0", "Pillow-13.0.0")
    assert slot_lines(packages, "02", tmp_path / "*.txt") == [
        "# What the part torch holds and asks for",
        "torch==2.10.0+cpu",
        "triton==3.6.0",
        'cuda-toolkit==13.0.3; platform_system == "Linux"',
        "pillow!=8.3.*,>=5.3.0",
        "typing-extensions>=4.10.0",
    ]


def test_all_of_a_part_keeps_its_version_where_nobody_names_what_does(tmp_path: Path) -> None:
    packages = part(tmp_path, "einops-1.0", "Pillow-13.0.0", "ruamel.yaml-0.18")
    assert slot_lines(packages, "02", name="einops")[:4] == [
        "# What the part einops holds and asks for",
        "einops==1.0",
        "pillow==13.0.0",
        "ruamel-yaml==0.18",
    ]


def test_a_requirement_that_nobody_can_read_stops_the_part(tmp_path: Path) -> None:
    """Rather than a package that moves where it must not."""
    packages = part(tmp_path, "torch-2.10.0")
    (packages / SITE / "torch-2.10.0.dist-info/METADATA").write_text("Requires-Dist: (>=1)\n")
    with pytest.raises(subprocess.CalledProcessError):
        slot_lines(packages, "02")


def test_packages_of_another_part_are_shown(tmp_path: Path) -> None:
    """In folders of their own: uv follows no link to one. What they lead to is where that part is joined."""
    (tmp_path / SITE).mkdir(parents=True)
    (tmp_path / "cuda.txt").write_text(LOCK)
    lines = slot_lines(tmp_path, "01", tmp_path / "cuda.txt", name="common")
    assert lines[1:] == ["nvidia-cublas==13.1.0.3", "nvidia-nccl-cu12==2.27.5"]
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
