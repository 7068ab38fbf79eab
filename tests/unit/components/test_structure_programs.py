"""The parts of the structure tests that can be told without an image: what they take for wrong, and what they let pass."""

from __future__ import annotations

import itertools
import os
import runpy
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
import yaml
from conftest import ROOT

STRUCTURE = ROOT / "tests/structure"


def program(name: str) -> dict[str, Any]:
    """The functions of a Python program of the structure tests."""
    return runpy.run_path(str(STRUCTURE / name))


def test_programs_of_ros_run_as_commands_of_a_user_do() -> None:
    """Where ROS comes from Debian it is everywhere; elsewhere the entrypoint sources it. Checks look at files alone."""
    commands = {
        (file.name, test["name"]): test["command"]
        for file in STRUCTURE.glob("ros*.yaml")
        for test in yaml.safe_load(file.read_text()).get("commandTests", ())
    }
    assert ("ros1-workspace.yaml", "/entrypoint.sh") in {(file, command) for (file, _), command in commands.items()}
    bare = {name: command for name, command in commands.items() if command != "/entrypoint.sh"}
    assert [name for name, command in bare.items() if not command.startswith("/run/tests/checks/")] == []


# ---- Words of commands that differ by distribution -------------------------------------------------------------------

RECORD = """\
#!{python}
import argparse, sys
parser = argparse.ArgumentParser(prog="ros2")
parser.add_argument("--output")
parser.add_argument("--exclude-topics", nargs="+")
parser.add_argument("--topic-polling-interval")
group = parser.add_mutually_exclusive_group()
{topics}
assert sys.argv[1:3] == ["bag", "record"]
print(parser.parse_args(sys.argv[3:]))
"""
POSITIONAL = 'group.add_argument("positional", nargs="*", default=[])\n'
OPTION = 'group.add_argument("--topics", nargs="+", default=[])\n'
GENERATIONS = {"humble": POSITIONAL, "jazzy": POSITIONAL + OPTION, "lyrical": OPTION}


@pytest.mark.parametrize("distro", GENERATIONS)
def test_ros2_bag_records_by_words_that_each_generation_knows(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, distro: str
) -> None:
    """Parsers laid out as rosbag2's are; the words stand where `nodes2/bag.py` has them."""
    ros2 = tmp_path / "ros2"
    ros2.write_text(RECORD.format(python=sys.executable, topics=GENERATIONS[distro]))
    ros2.chmod(0o755)
    monkeypatch.setenv("PATH", f"{tmp_path}:{os.environ['PATH']}")
    words = program("programs/nodes2/record.py")["topics"]("/numbers")
    done = subprocess.run(
        ["ros2", "bag", "record", "--output", "bag", *words], capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    name = "positional" if distro == "humble" else "topics"
    assert f"{name}=['/numbers']" in done.stdout
    assert (
        'start("record", "--output", str(folder), *topics("/numbers"))'
        in (STRUCTURE / "programs/nodes2/bag.py").read_text()
    )


# ---- One runtime of OpenMP -------------------------------------------------------------------------------------------

GNU = "/usr/lib/x86_64-linux-gnu/libgomp.so.1.0.0"
TORCH = "/usr/local/lib/python3.11/dist-packages/torch/lib/libgomp.so.1"
TENSORFLOW = "/usr/local/lib/python3.11/dist-packages/tensorflow.libs/libomp-f1025659.so.5"
LLVM = "/usr/lib/aarch64-linux-gnu/libomp.so.5"
INTEL = "/usr/local/lib/libiomp5.so"

RUNTIMES = {
    "none": ([], "x86_64", True),
    "two of GNU's": ([GNU, TORCH], "x86_64", False),
    "TensorFlow's for arm64 beside GNU's": ([GNU, TENSORFLOW], "aarch64", True),
    "TensorFlow's beside two of GNU's": ([GNU, TORCH, TENSORFLOW], "aarch64", False),
    "LLVM's, but not TensorFlow's": ([GNU, LLVM], "aarch64", False),
}


@pytest.mark.parametrize("name", RUNTIMES)
def test_runtimes_of_openmp_in_one_process(name: str) -> None:
    paths, machine, well = RUNTIMES[name]
    mapped = ["7f00-7f01 rw-p 00000000 00:00 0", "7f02-7f03 r-xp 00000000 08:01 7 /usr/lib/libcompute.so"]
    mapped += [
        f"7f0{i}-7f1{i} {kind} 00000000 08:01 {i} {path}" for i, path in enumerate(paths) for kind in ("r--p", "r-xp")
    ]
    excess = program("programs/coexist/process.py")["runtimes_too_many"]("\n".join(mapped), machine)
    assert excess == ([] if well else sorted(paths))


@pytest.mark.parametrize("turns", [1, 3])
def test_orders_of_imports(turns: int) -> None:
    names = ["cv_bridge", "cv2", "torch", "tensorflow", "numpy", "rospy"]
    tried = program("programs/coexist/process.py")["orders"](names, turns)
    assert len(set(map(tuple, tried))) == 2 * turns
    for one, other in itertools.combinations(names, 2):
        assert {order.index(one) < order.index(other) for order in tried} == {True, False}


# ---- The banner, and what was recorded -------------------------------------------------------------------------------

PROMISED = {
    "releases": "torch,tensorflow",
    "os": "ubuntu-24.04",
    "python": "3.12",
    "ros": "2",
    "ros_distro": "jazzy",
    "rmw": "rmw_cyclonedds_cpp",
    "cuda": "12.8.90",
    "cudnn": "9.10.2.21",
    "nccl": "2.27.5",
    "torch": "2.10.0",
    "tensorflow": "2.20.0",
}
RECORDED = {
    "image-os": "Ubuntu 24.04.3 LTS",
    "image-architecture": "amd64",
    "image-python": "3.12.3",
    "image-cmake": "3.28.3",
    "ros-distro": "jazzy",
    "ros-version": "2",
    "nvidia-cuda-runtime-cu12": "12.8.90",
    "nvidia-cudnn-cu12": "9.10.2.21",
    "nvidia-nccl-cu12": "2.27.5",
    "torch": "2.10.0",
    "tensorflow": "2.20.0",
}
SYSTEM = {"ID": "ubuntu", "VERSION_ID": "24.04", "VERSION_CODENAME": "noble", "PRETTY_NAME": "Ubuntu 24.04.3 LTS"}


def banner(folder: Path, recorded: dict[str, str], *middleware: str) -> str:
    """What banner.sh says of an image with these records, below another folder than /."""
    (folder / "versions.d").mkdir(parents=True)
    (folder / "versions.d/all").write_text("".join(f"{name} {version}\n" for name, version in recorded.items()))
    index = folder / "jazzy/share/ament_index/resource_index/rmw_typesupport"
    index.mkdir(parents=True)
    for name in middleware:
        (index / name).touch()
    script = (ROOT / "components/base/banner.sh").read_text()
    for path in ("/usr/local/share/rosml/", "/opt/ros/"):
        assert path in script
        script = script.replace(path, f"{folder}/")
    environment = {"PATH": os.environ["PATH"], "ROS_DISTRO": "jazzy"}
    return subprocess.run(["bash", "-c", script], env=environment, capture_output=True, text=True, check=True).stdout


ROS_2 = ("rmw_cyclonedds_cpp", "rmw_fastrtps_cpp", "rmw_implementation")

FAULTS: dict[str, tuple[dict[str, str], dict[str, str | None], tuple[str, ...], list[str]]] = {
    "as promised": ({}, {}, ROS_2, []),
    "another CUDA": (
        {"nvidia-cuda-runtime-cu12": "12.6.77"},
        {},
        ROS_2,
        ["recorded of cuda: {'nvidia-cuda-runtime-cu12': '12.6.77'}, expected 12.8.90",
         "the banner's CUDA: 12.6.77, expected 12.8.90"],
    ),
    "a build for the CPU is of the same version": ({"torch": "2.10.0+cpu"}, {}, ROS_2, []),
    "a TensorFlow that nobody promised": (
        {},
        {"tensorflow": None},
        ROS_2,
        ["recorded of tensorflow: {'tensorflow': '2.20.0'}, expected None",
         "the banner's TensorFlow: 2.20.0, expected None"],
    ),
    "a middleware that is missing": (
        {},
        {},
        ("rmw_fastrtps_cpp",),
        ["the banner's RMW: rmw_fastrtps_cpp (installed: rmw_fastrtps_cpp), expected rmw_fastrtps_cpp, and installed: "
         "rmw_fastrtps_cpp rmw_cyclonedds_cpp"],
    ),
    "middleware where ROS has its own": (
        {},
        {"ros": "1"},
        ("rmw_fastrtps_cpp",),
        ["the banner's ROS: jazzy (ROS 2), expected jazzy (ROS 1)",
         "the banner's RMW: rmw_fastrtps_cpp (installed: rmw_fastrtps_cpp), expected none: ROS 1 has one of its own"],
    ),
    "another Python": ({"image-python": "3.13.1"}, {}, ROS_2, ["the banner's Python: 3.13.1, expected 3.12"]),
    "another system": (
        {},
        {"os": "ubuntu-22.04"},
        ROS_2,
        ["the operating system's name in matrix.yaml: ubuntu-22.04, expected ['noble', 'ubuntu-24.04']"],
    ),
    "a banner of another system": (
        {"image-os": "Debian GNU/Linux 12 (bookworm)"},
        {},
        ROS_2,
        ["the banner's OS: Debian GNU/Linux 12 (bookworm), amd64, expected Ubuntu 24.04.3 LTS"],
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", FAULTS)
def test_versions_of_an_image(name: str, tmp_path: Path) -> None:
    records, promises, middleware, faults = FAULTS[name]
    recorded = {key: value for key, value in {**RECORDED, **records}.items() if value}
    promised = {key: value for key, value in {**PROMISED, **promises}.items() if value}
    text = banner(tmp_path, recorded, *middleware)
    assert program("checks/versions.py")["wrong"](text, recorded, SYSTEM, promised) == faults
