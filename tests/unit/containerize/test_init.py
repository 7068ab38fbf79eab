"""`rosml init`: what it finds in a folder, what it proposes, and the files that it writes, which their readers understand."""

from __future__ import annotations

import json
import os
import re
import shlex
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import click
import pytest
import yaml
from click.testing import CliRunner, Result
from conftest import ROOT

from fakes.desks import OURS, Desk
from fakes.stubs import HOSTILE
from rosml.base.errors import RosmlError
from rosml.cli import main
from rosml.cli.containerize import init
from rosml.cli.run import question
from rosml.containerize import inputs as app_inputs
from rosml.containerize.init import file_texts, forge
from rosml.containerize.packages import workspace
from rosml.containerize.packages.conditions import holds
from rosml.containerize.packages.ignored import LeftOut
from rosml.images.builds import base_images
from rosml.images.image_set import load
from rosml.images.image_set.model import ImageSet
from rosml.machine import git
from rosml.run import defaults
from rosml.run.plugins import gpu

REGISTRY = ["--registry", "ghcr.io/me/rosml"]


@pytest.fixture(autouse=True)
def machine(monkeypatch: pytest.MonkeyPatch, real: ImageSet) -> None:
    """A machine without a GPU, without ROS and without a local registry."""
    monkeypatch.setattr(load, "load", lambda *_: real)
    monkeypatch.setattr(gpu, "is_nvidia", lambda _: False)
    monkeypatch.setattr(init, "_local", lambda _: ("", False))
    monkeypatch.delenv("ROS_DISTRO", raising=False)


def manifest(name: str = "arm", build: str = "ament_python", depends: str = "", condition: str = "") -> str:
    """A package.xml."""
    where = f' condition="{condition}"' if condition else ""
    needs = "".join(f"\n  <depend>{key}</depend>" for key in depends.split())
    kind = f"<export><build_type{where}>{build}</build_type></export>" if build else ""
    return f'<package format="3">\n  <name>{name}</name>{needs}\n  {kind}\n</package>\n'


def write(folder: Path, files: Mapping[str, str]) -> Path:
    for name, text in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)
    return folder


def called(folder: Path, *words: str, code: int = 0, typed: str | None = None) -> Result:
    done = CliRunner().invoke(main.cli, ["init", str(folder), *words], input=typed)
    error = done.exception
    found = getattr(error, "exit_code", done.exit_code)
    assert found == code, (done.output, error)
    return done


def chosen(folder: Path, *words: str) -> dict[str, str]:
    """The values that are chosen, by question."""
    said = json.loads(called(folder, "--json", "--dry-run", *words).stdout)
    return {name: choice["value"] for name, choice in said["choices"].items()}


def snapshot(folder: Path) -> dict[str, tuple[bytes, int]]:
    files = (path for path in folder.rglob("*") if path.is_file() and not path.is_symlink())
    return {str(path.relative_to(folder)): (path.read_bytes(), path.stat().st_mtime_ns) for path in files}


# ---- Files -----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("registry", [[], REGISTRY])
def test_those_who_read_the_files_understand_them(tmp_path: Path, registry: list[str]) -> None:
    folder = write(
        tmp_path / "My Robot",
        {"arm/package.xml": manifest(), "arm/launch/it's $HOME.launch.py": "", ".git/HEAD": "ref: refs/heads/jazzy\n"},
    )
    called(folder, "--yes", "--gpu", "--framework", "torch", *registry)
    values = app_inputs.values({}, folder, {})
    place = "ghcr.io/me/rosml/" if registry else ""
    assert values.base_image == f"{place}ros-torch:jazzy-base-cu130"
    assert shlex.split(values.command) == ["ros2", "launch", "arm", "it's $HOME.launch.py"]
    assert values.image_name == "my-robot"
    assert list(app_inputs.answers(folder, {})) == []
    project = defaults.files({"XDG_CONFIG_HOME": str(tmp_path)}, str(folder), ["--mws"], []).project
    assert project and (project.line.image, project.line.own) == ("my-robot:latest-dev", ("--mws",))
    left = LeftOut(folder)
    assert left(folder / ".env") and left.whole(folder / ".git") and left.whole(folder / "build")
    assert [path.parent.name for path in workspace.manifests(folder, left=left)] == ["arm"]


def test_rosml_run_takes_the_image_to_work_in_and_mounts_the_folder(tmp_path: Path) -> None:
    desk = Desk(tmp_path)
    desk.engine(images={"dr:latest-dev": OURS})
    called(write(desk.folder, {"package.xml": manifest()}), "--yes")
    done = desk.call("--dry-run")
    assert done.returncode == 0, done.stderr
    words = shlex.split(done.stdout)
    mounted = [word for word in words if word.endswith("/docker-ros/ws/src/target")]
    assert len(mounted) == 1 and str(desk.folder) in mounted[0] and words[-1] == "dr:latest-dev", words


def test_a_dockerfile_names_only_a_registry_that_was_named(tmp_path: Path) -> None:
    """Otherwise Docker would look for `ros:jazzy-base` on Docker Hub, where others have a repository of that name."""
    one, two = (write(tmp_path / name, {"package.xml": manifest()}) for name in ("one", "two"))
    called(one, "--yes")
    called(two, "--yes", *REGISTRY)
    assert "\nARG BASE_IMAGE\n" in (one / "Dockerfile").read_text()
    assert "\nARG BASE_IMAGE=ghcr.io/me/rosml/ros:jazzy-base\n" in (two / "Dockerfile").read_text()


def test_a_dockerfile_says_how_its_image_gets_gpus(tmp_path: Path) -> None:
    one, two = (write(tmp_path / name, {"package.xml": manifest(), "a.py": TORCH}) for name in ("one", "two"))
    called(one, "--yes", "--gpu")
    called(two, "--yes", "--cpu")
    assert "docker run --rm -it --gpus all -e" in (one / "Dockerfile").read_text()
    assert "--gpus" not in (two / "Dockerfile").read_text()


@pytest.mark.parametrize(
    ("command", "last"),
    [
        ("ros2 run arm 'a b'", 'CMD ["ros2", "run", "arm", "a b"]'),
        ("a && b $X", 'CMD ["bash", "-c", "a && b $X"]'),
        ("", 'CMD ["bash"]'),
    ],
)
def test_the_command_of_a_dockerfile(tmp_path: Path, command: str, last: str) -> None:
    called(write(tmp_path, {"package.xml": manifest()}), "--yes", "--command", command)
    assert (tmp_path / "Dockerfile").read_text().splitlines()[-1] == last


def test_a_folder_of_a_package_is_sent_although_builds_make_folders_of_that_name(tmp_path: Path) -> None:
    called(write(tmp_path, {"install/package.xml": manifest(), "src/package.xml": manifest("leg")}), "--yes")
    ignored = (tmp_path / ".dockerignore").read_text().splitlines()
    assert "install" not in ignored and "build" in ignored


def test_a_second_call_changes_nothing_and_keeps_to_the_first(tmp_path: Path) -> None:
    write(tmp_path, {"package.xml": manifest(), ".github/x": "", "Dockerfile": "FROM mine\n"})
    words = ["--distribution", "humble", "--component", "core", "--framework", "torch", "--accelerator", "cu128"]
    called(tmp_path, "--yes", *words, "--command", "mine", *REGISTRY)
    before = snapshot(tmp_path)
    assert before["Dockerfile"][0] == b"FROM mine\n" and ".github/workflows/images.yml" in before
    done = called(tmp_path, "--yes", *REGISTRY)
    assert snapshot(tmp_path) == before
    assert re.findall(r"^(same|kept) +(\S+)", done.stdout, re.MULTILINE) == [
        ("kept", "Dockerfile"),
        *(("same", name) for name in (".dockerignore", ".env", ".rosml.toml", ".github/workflows/images.yml")),
    ]
    assert done.stderr == (
        "warning: Dockerfile stays as it is, and does not start from ghcr.io/me/rosml/ros-torch:humble-core-cu128, and does not call"
        " rosdep install\nremedy: write FROM ghcr.io/me/rosml/ros-torch:humble-core-cu128, and let a RUN call it; rosml init"
        " --dry-run prints ours\n"
    )
    assert "docker build" not in done.stdout, "the Dockerfile is somebody else's"


GOOD = "FROM x/ros-torch:jazzy-base-cpu\nRUN rosdep \\\n    install -y{}\n"


@pytest.mark.parametrize(
    ("name", "text", "says"),
    [
        ("Dockerfile", GOOD.format(" --skip-keys python3-torch"), ""),
        ("Dockerfile", "ARG BASE_IMAGE\n" + GOOD.format(" --skip-keys 'python3-torch'"), ""),
        (
            "Dockerfile",
            GOOD.format(""),
            "lets rosdep install python3-torch, which the base image has\nremedy: add --skip-keys",
        ),
        ("Dockerfile", "FROM ubuntu\nRUN rosdep update && apt-get install x", "does not call rosdep install"),
        (
            ".github/workflows/images.yml",
            "jobs: {}\n",
            "does not call rosml containerize\nremedy: add the step uses: me/rosml/cont",
        ),
        (".github/workflows/images.yml", "- uses: x/rosml/containerize@1\n", ""),
    ],
)
def test_what_a_file_that_stays_lacks(tmp_path: Path, name: str, text: str, says: str) -> None:
    write(tmp_path, {"package.xml": manifest(depends="python3-torch"), ".github/x": "", name: text})
    said = called(tmp_path, "--yes", *REGISTRY).stderr
    assert (f"{name} stays as it is" in said) == bool(says) and says in said
    assert (tmp_path / name).read_text() == text


@pytest.mark.parametrize(
    ("depends", "words", "keys"),
    [
        ("python3-torch python3-pytorch-pip python3-numpy torch_msgs", [], "python3-pytorch-pip python3-torch"),
        ("python3-torch", ["--framework", "none"], ""),
        ("rclpy geometry_msgs nav_msgs", ["--distribution", "jazzy-wheels"], "geometry_msgs rclpy"),
        ("python3-torch python3-torchvision", ["--cpu"], "python3-torch"),
        ("python3-torch python3-torchvision", ["--gpu"], "python3-torch python3-torchvision"),
        ("python3-torch-geometric-pip python-tensorflow-gpu-pip", ["--framework", "ml"], "python-tensorflow-gpu-pip"),
    ],
)
def test_nobody_installs_again_what_the_base_image_has(
    tmp_path: Path, depends: str, words: list[str], keys: str
) -> None:
    """Neither rosml containerize, nor the Dockerfile, nor a job. Images for the CPU have no torchvision."""
    called(write(tmp_path, {"package.xml": manifest(depends=depends), ".github/x": ""}), "--yes", *REGISTRY, *words)
    assert app_inputs.values({}, tmp_path, {}).skip_keys == keys
    lines = [line for line in (tmp_path / "Dockerfile").read_text().splitlines() if "rosdep install" in line]
    skipped = [f" --skip-keys {shlex.quote(keys)} " in f"{line.rstrip(chr(92)).rstrip()} " for line in lines]
    assert skipped == [bool(keys)] * 2
    [step] = yaml.safe_load((tmp_path / file_texts.GITHUB).read_text())["jobs"]["images"]["steps"]
    assert step["with"].get("skip-keys", "") == keys


def test_an_option_wins_over_the_file_of_variables(tmp_path: Path) -> None:
    write(tmp_path, {"package.xml": manifest(), ".env": "BASE_IMAGE=ros:humble-core\n"})
    assert list(chosen(tmp_path).values())[:4] == ["humble", "core", "none", ""]
    assert list(chosen(tmp_path, "--gpu").values())[:4] == ["humble", "core", "cuda", "cu130"]
    assert list(chosen(tmp_path, "--distribution", "jazzy").values())[:3] == ["jazzy", "base", "none"]


def test_a_dry_run_shows_the_files_and_writes_none(tmp_path: Path) -> None:
    before = snapshot(write(tmp_path, {"package.xml": manifest()}))
    done = called(tmp_path, "--yes", "--dry-run")
    assert snapshot(tmp_path) == before
    assert "    BASE_IMAGE=ros:jazzy-base\n" in done.stdout


def test_what_a_file_of_variables_lacks(tmp_path: Path) -> None:
    write(tmp_path, {"package.xml": manifest(), ".env": "IMAGE=robot:v1\nPORT=1\nBASE_IMAGE=ros:humble-base\n"})
    done = called(tmp_path, "--yes", "--distribution", "jazzy")
    assert ".env stays as it is, and does not say BASE_IMAGE=ros:jazzy-base, COMMAND=bash\n" in done.stderr
    assert "IMAGE_NAME" not in done.stderr


def test_a_broken_file_of_variables_is_told(tmp_path: Path) -> None:
    done = called(write(tmp_path, {"package.xml": manifest(), ".env": "x y\n"}), "--yes")
    assert f"{tmp_path}/.env:1: it is not NAME=VALUE" in done.stderr
    assert (tmp_path / "Dockerfile").exists()


@pytest.mark.parametrize("name", [".env", "Dockerfile", ".rosml.toml"])
def test_a_link_stays_wherever_it_leads(tmp_path: Path, name: str) -> None:
    folder = write(tmp_path / "robot", {"package.xml": manifest()})
    (folder / name).symlink_to(tmp_path / "outside")
    called(folder, "--yes")
    assert (folder / name).is_symlink() and not (tmp_path / "outside").exists()


def test_no_file_is_written_behind_a_link_out_of_the_folder(tmp_path: Path) -> None:
    folder = write(tmp_path / "robot", {"package.xml": manifest()})
    (tmp_path / "outside").mkdir()
    (folder / ".github").symlink_to(tmp_path / "outside")
    before = (tmp_path / "outside").stat().st_mtime_ns
    done = called(folder, "--yes", "--ci", "github", *REGISTRY, code=1)
    assert "a link leads out of" in str(done.exception)
    assert [path.name for path in folder.iterdir() if path.name != ".github"] == ["package.xml"]
    assert list((tmp_path / "outside").iterdir()) == []
    assert (tmp_path / "outside").stat().st_mtime_ns == before, "no folder was made there either"


def test_a_folder_that_cannot_be_written(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The third file cannot be written: the first two are not there either, nor is the folder for the last one."""
    write(tmp_path, {"package.xml": manifest()})
    calls, real = iter(range(9)), os.fdopen

    def full(*words: Any, **more: Any) -> Any:
        if words[1:] == ("w",) and next(calls) == 2:
            raise PermissionError(13, "Permission denied")
        return real(*words, **more)

    monkeypatch.setattr(os, "fdopen", full)
    done = called(tmp_path, "--yes", "--ci", "github", *REGISTRY, code=1)
    assert "cannot be written: Permission denied" in str(done.exception)
    assert [path.name for path in tmp_path.iterdir()] == ["package.xml"]


# ---- What is found ---------------------------------------------------------------------------------------------------

TORCH = "import torch\n"


@pytest.mark.parametrize(
    ("files", "wanted"),
    [
        ({"package.xml": manifest()}, ("jazzy", "base", "none")),
        ({"package.xml": manifest(build="catkin")}, ("ros1-bookworm", "base", "none")),
        ({"package.xml": manifest(build="", depends="rospy")}, ("ros1-bookworm", "base", "none")),
        ({"package.xml": manifest(build="cmake", depends="rclcpp")}, ("jazzy", "base", "none")),
        ({"package.xml": manifest(build="catkin", condition="$ROS_VERSION == 1")}, ("ros1-bookworm", "base", "none")),
        ({"package.xml": manifest(condition="$ROS_DISTRO == humble")}, ("humble", "base", "none")),
        (
            {"package.xml": manifest(build="catkin", condition="$ROS_DISTRO == noetic")},
            ("ros1-bookworm", "base", "none"),
        ),
        ({"package.xml": manifest(depends="desktop")}, ("jazzy", "desktop", "none")),
        ({"package.xml": manifest(), "a.py": TORCH}, ("jazzy", "base", "torch")),
        ({"package.xml": manifest(), "a.py": "import os, torch.nn as nn\n"}, ("jazzy", "base", "torch")),
        ({"package.xml": manifest(), "a.py": "  from torch.nn import Linear\n"}, ("jazzy", "base", "torch")),
        ({"package.xml": manifest(), "a.py": "# import torch\nfrom tf import x\n"}, ("jazzy", "base", "none")),
        ({"package.xml": manifest(), "a.py": "import torchvision\n"}, ("jazzy", "base", "torch")),
        ({"package.xml": manifest(depends="python3-pytorch-pip")}, ("jazzy", "base", "torch")),
        (
            {"package.xml": manifest(depends="tf tf2_ros torch_msgs"), "m/package.xml": manifest("x")},
            ("jazzy", "base", "torch"),
        ),
        (
            {"a/package.xml": manifest(depends="torch_msgs"), "b/package.xml": manifest("torch_msgs")},
            ("jazzy", "base", "none"),
        ),
        ({"package.xml": manifest(), "CMakeLists.txt": "find_package(Torch REQUIRED)\n"}, ("jazzy", "base", "torch")),
        ({"package.xml": manifest(), "a.cpp": "#include <torch/script.h>\n"}, ("jazzy", "base", "torch")),
        (
            {"package.xml": manifest(), "setup.py": "setup(install_requires=['tensorflow>=2'])\n"},
            ("jazzy", "base", "tensorflow"),
        ),
        ({"package.xml": manifest(), "requirements.txt": "torch==2.1\ntensorflow\n"}, ("jazzy", "base", "ml")),
        ({"package.xml": manifest(), "a.cu": "#include <cuda_runtime.h>\n"}, ("jazzy", "base", "none")),
        ({"package.xml": manifest(), "a.py": "import cupy as cp\n"}, ("jazzy", "base", "cuda")),
        (
            {"package.xml": manifest(), "a.cpp": "#include <cuda.h>\n#include <torch/script.h>\n"},
            ("jazzy", "base", "torch"),
        ),
        ({"package.xml": manifest(), "requirements.txt": "onnxruntime-gpu\n"}, ("jazzy", "base", "cuda")),
        (
            {"package.xml": manifest(), ".venv/a.py": TORCH, "env/pyvenv.cfg": "", "env/a.py": TORCH},
            ("jazzy", "base", "none"),
        ),
        (
            {"package.xml": manifest(), "x/COLCON_IGNORE": "", "x/package.xml": manifest(build="catkin")},
            ("jazzy", "base", "none"),
        ),
        # The lock of ros1-bookworm for the CPU is missing, and this machine has no GPU.
        ({"package.xml": manifest(build="catkin"), "a.py": TORCH}, ("ros1-trixie", "base", "torch")),
    ],
)
def test_what_packages_and_sources_ask_for(tmp_path: Path, files: dict[str, str], wanted: tuple[str, str, str]) -> None:
    found = chosen(write(tmp_path, files))
    assert (found["distribution"], found["component"], found["framework"]) == wanted


def test_a_proposal_can_be_built_where_another_one_cannot(tmp_path: Path, real: ImageSet) -> None:
    """ros1-bookworm lacks the lock of PyTorch for the CPU."""
    write(tmp_path, {"package.xml": manifest(build="catkin"), "a.py": TORCH})
    assert chosen(tmp_path, "--gpu")["distribution"] == "ros1-bookworm"
    found = chosen(tmp_path, "--cpu")
    target = "-".join(found[name] for name in ("distribution", "component", "framework", "accelerator"))
    assert real.image(target).locked
    assert not real.image("ros1-bookworm-base-torch-cpu").locked
    done = called(tmp_path, "--yes", "--cpu", "--distribution", "ros1-bookworm")
    assert "ros1-bookworm-base-torch-cpu cannot be built yet" in done.stderr


@pytest.mark.parametrize(
    ("files", "environment", "wanted"),
    [
        ({".git/HEAD": "ref: refs/heads/humble-devel\n"}, {}, "humble"),
        ({".git/HEAD": "ref: refs/heads/feature/kilted_x\n"}, {}, "kilted"),
        ({".git/HEAD": f"{'1' * 40}\n"}, {}, "jazzy"),
        ({".git/HEAD": "ref: refs/heads/foxy\n"}, {}, "jazzy"),
        ({".git/HEAD": "ref: refs/heads/humble\n"}, {"ROS_DISTRO": "rolling"}, "rolling"),
        ({}, {"ROS_DISTRO": "noetic"}, "jazzy"),
        ({".github/workflows/ci.yml": "container: ros:humble-ros-base\n"}, {}, "humble"),
        ({".github/workflows/ci.yml": "ros: [foxy, humble, rolling]\n"}, {}, "humble"),
        ({".github/workflows/a.yml": "humble", ".github/workflows/b.yml": "jazzy kilted"}, {}, "jazzy"),
        ({"Dockerfile": "FROM osrf/ros:kilted-desktop\n"}, {}, "kilted"),
        ({".env": "BASE_IMAGE=ros:rolling-core\n", ".git/HEAD": "ref: refs/heads/humble\n"}, {}, "rolling"),
        ({".env": "BASE_IMAGE=ubuntu\n"}, {}, "jazzy"),
    ],
)
def test_where_a_distribution_is_named(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, files: dict[str, str], environment: dict[str, str], wanted: str
) -> None:
    for name, value in environment.items():
        monkeypatch.setenv(name, value)
    found = chosen(write(tmp_path, {"package.xml": manifest(), **files}))
    assert found["distribution"] == wanted


@pytest.mark.parametrize(
    ("driver", "words", "wanted"),
    [
        ("580.1", [], "cu130"),
        ("570.86", [], "cu128"),
        ("", [], "cu130"),
        ("390.1", [], "cpu"),
        ("580.1", ["--cpu"], "cpu"),
        ("570.86", ["--accelerator", "cu130"], "cu130"),
        (None, [], "cpu"),
        (None, ["--gpu"], "cu130"),
    ],
)
def test_which_accelerator_fits_a_machine(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, driver: str | None, words: list[str], wanted: str
) -> None:
    monkeypatch.setattr(gpu, "is_nvidia", lambda _: driver is not None)
    monkeypatch.setattr(gpu, "driver", lambda _: driver or "")
    assert chosen(write(tmp_path, {"package.xml": manifest(), "a.py": TORCH}), *words)["accelerator"] == wanted


@pytest.mark.parametrize(
    ("files", "wanted"),
    [
        ({"launch/a.launch.py": ""}, "ros2 launch arm a.launch.py"),
        ({"launch/a.launch.py": "", "launch/bringup.launch.xml": ""}, "ros2 launch arm bringup.launch.xml"),
        ({"launch/a.launch.py": "", "launch/b_launch.py": ""}, "bash"),
        ({"setup.py": "entry_points={'console_scripts': ['go = arm.go:main']},\n"}, "ros2 run arm go"),
        ({"setup.cfg": "[options.entry_points]\nconsole_scripts =\n  go = arm.go:main\n"}, "ros2 run arm go"),
        ({"setup.py": "x = ['a = arm.a:main', 'b = arm.b:main']\n"}, "bash"),
        ({}, "bash"),
    ],
)
def test_the_command_that_is_proposed(tmp_path: Path, files: dict[str, str], wanted: str) -> None:
    assert chosen(write(tmp_path, {"package.xml": manifest(), **files}))["command"] == wanted


@pytest.mark.parametrize(
    ("files", "wanted"),
    [
        ({"setup.py": "x = ['go = arm.go:main']\n"}, "/docker-ros/ws/install/arm/lib/arm/go"),
        ({"setup.py": "x = ['go = arm.go:main']\n", "launch/a.launch.py": ""}, "/docker-ros/ws/install/arm/lib/arm/go"),
        ({"launch/a.launch.py": ""}, "bash"),
    ],
)
def test_ros_from_wheels_has_no_command_ros2(tmp_path: Path, files: dict[str, str], wanted: str) -> None:
    write(tmp_path, {"package.xml": manifest(), **files})
    assert chosen(tmp_path, "--distribution", "jazzy-wheels")["command"] == wanted
    assert "Python alone" not in called(tmp_path, "--yes", "--distribution", "jazzy-wheels").stderr
    write(tmp_path, {"src/a.cpp": ""})
    said = called(tmp_path, "--yes", "--distribution", "jazzy-wheels").stderr
    assert "jazzy-wheels builds packages of Python alone, and package.xml is none" in said
    write(tmp_path, {"package.xml": manifest(build="ament_cmake")})
    (tmp_path / "src/a.cpp").unlink()
    assert "builds packages of Python alone" in called(tmp_path, "--yes", "--distribution", "jazzy-wheels").stderr


@pytest.mark.parametrize(
    ("text", "wanted"),
    [
        ("", True),
        ("$ROS_VERSION == 2", True),
        ("$ROS_VERSION==1", False),
        ("$ROS_VERSION == 1 or $ROS_DISTRO == 'jazzy'", True),
        ("$ROS_VERSION == 1 or $ROS_VERSION == 2 and $ROS_DISTRO == foxy", False),
        ("($ROS_VERSION == 1 or $ROS_VERSION == 2) and $ROS_DISTRO == jazzy", True),
        ('$ROS_DISTRO >= "humble"', True),
        ("$ROS_DISTRO < humble", False),
        ("$ROS_DISTRO != jazzy", False),
        ("$OTHER == ''", True),
        *(
            (broken, True)
            for broken in ("$ROS_VERSION ==", "a b c", "(", "$ROS_VERSION == 1)", "((" * 5_000, "$ROS_VERSION = 1")
        ),
    ],
)
def test_conditions(text: str, wanted: bool) -> None:
    assert holds(text, {"ROS_VERSION": "2", "ROS_DISTRO": "jazzy"}) is wanted


def test_lists_of_upstream_repositories_and_requirements(tmp_path: Path) -> None:
    """Of lists for several distributions one counts; requirements are installed, wherever they are."""
    files = {"a/package.xml": manifest("a"), "b/package.xml": manifest("b"), "c.jazzy.repos": "", "c.humble.repos": ""}
    write(tmp_path, {**files, "a/requirements.txt": "scipy\n", "b/requirements.txt": "scipy\n"})
    called(tmp_path, "--yes")
    values = app_inputs.values({}, tmp_path, {})
    assert (values.enable_recursive_vcs_import, values.vcs_import_file) == (False, "c.jazzy.repos")
    assert (values.enable_recursive_additional_pip, values.additional_pip_file) == (True, "requirements.txt")
    text = (tmp_path / "Dockerfile").read_text()
    assert 'COPY ["c.jazzy.repos", "/upstream.repos"]' in text and "! -name requirements.txt" in text
    assert text.count("pip install -r /run/src/target/b/requirements.txt") == 2


# ---- What is wrong ---------------------------------------------------------------------------------------------------

BOTH = {"a/package.xml": manifest("a"), "b/package.xml": manifest("b", "catkin")}


@pytest.mark.parametrize(
    ("files", "words", "says"),
    [
        ({}, [], "there is no package.xml in"),
        (BOTH, [], r"ROS 1 and of ROS 2 do not build together: b/package.xml \(ROS 1\) and a/package.xml \(ROS 2\)"),
        ({"package.xml": "<package>\n<name>x</nam>\n</package>"}, [], r"package.xml:2:\d+: no XML: mismatched tag"),
        ({"package.xml": ""}, [], "package.xml:1:1: no XML: no element found"),
        ({"package.xml": "<package/>"}, [], "no manifest of a ROS package: no <name>"),
        ({"package.xml": "<x/>"}, [], "its first element is <x>, not <package>"),
        ({"package.xml": '<?xml version="1.0" encoding="x-y"?><package/>'}, [], "package.xml:1: no XML"),
        ({"package.xml": manifest()}, ["--distribution", "jazy"], "no distribution named 'jazy'; did you mean 'jazzy'"),
        ({"package.xml": manifest()}, ["--distribution", "noetic"], "package.xml is not for noetic, which is ROS 1"),
        ({"package.xml": manifest()}, ["--component", "robot"], "has no robot metapackage"),
        ({"package.xml": manifest()}, ["--component", "core-run"], "core-run only runs programs"),
        ({"package.xml": manifest()}, ["--framework", "trch"], "no framework named 'trch'; did you mean 'torch'"),
        (
            {"package.xml": manifest()},
            ["--framework", "tf", "--distribution", "lyrical"],
            "has a wheel for Python 3.14",
        ),
        ({"package.xml": manifest()}, ["--framework", "torch", "--accelerator", "cu121"], "torch 2.4.1 has no wheel"),
        ({"package.xml": manifest()}, ["--framework", "torch", "--accelerator", "tpu"], "no accelerator named 'tpu'"),
        ({"package.xml": manifest()}, ["--accelerator", "tpu"], "no accelerator named 'tpu'"),
        (
            {"package.xml": manifest()},
            ["--framework", "torch", "--accelerator", "cpu", "--gpu"],
            "not what you ask for",
        ),
        ({"package.xml": manifest()}, ["--framework", "cuda", "--cpu"], "has no cuda for the CPU"),
        ({"package.xml": manifest()}, ["--framework", "none", "--gpu"], "none computes nothing on a GPU"),
        ({"package.xml": manifest()}, ["--command", "a 'b"], "no closing quotation"),
        ({"package.xml": manifest()}, ["--registry", "https://x/y"], "no place for images"),
        ({"package.xml": manifest()}, ["--ci", "jenkins", *REGISTRY], "no forge named 'jenkins'"),
        ({"package.xml": manifest()}, ["--ci", "github"], "do not reach this machine's images"),
        ({"package.xml": manifest()}, ["--ci", "github", "--registry", "127.0.0.1:5/x"], "do not reach this machine's"),
        ({"package.xml": manifest()}, ["--ci", "github", "--registry", "quay.io/me/x"], "nobody knows where on github"),
        ({"package.xml": manifest()}, ["--ci", "gitlab", *REGISTRY], "nobody knows where on gitlab"),
    ],
)
def test_what_is_wrong_is_told_with_a_remedy_and_nothing_is_written(
    tmp_path: Path, files: dict[str, str], words: list[str], says: str
) -> None:
    before = snapshot(write(tmp_path, files))
    error: Any = called(tmp_path, "--yes", *words, code=2).exception
    assert re.search(says, error.message), error.message
    assert error.remedy
    assert snapshot(tmp_path) == before


def test_an_end_of_life_is_a_warning(tmp_path: Path) -> None:
    done = called(write(tmp_path, {"package.xml": manifest()}), "--yes", "--distribution", "foxy")
    assert "foxy had its end of life on 2023-06-20\nremedy: if your packages allow it, take jazzy" in done.stderr
    assert "rosdep update --include-eol-distros" in (tmp_path / "Dockerfile").read_text()


def test_a_framework_that_the_distribution_of_the_branch_lacks(tmp_path: Path) -> None:
    write(
        tmp_path, {"package.xml": manifest(), "a.py": "import tensorflow\n", ".git/HEAD": "ref: refs/heads/lyrical\n"}
    )
    done = called(tmp_path, "--yes")
    assert "no release of tensorflow has a wheel for Python 3.14" in done.stderr
    assert "BASE_IMAGE=ros:lyrical-base\n" in (tmp_path / ".env").read_text()


def test_a_library_that_no_manifest_names(tmp_path: Path) -> None:
    write(tmp_path, {"package.xml": manifest(), "a.py": "\nimport cv2\nimport onnxruntime\n"})
    said = called(tmp_path, "--yes").stderr
    assert "a.py:2 names cv2, and no package.xml does" in said
    assert "a.py:3 names onnxruntime: containerize adds the add-on onnx" in said
    assert "ADDONS=onnx-cpu\n" in (tmp_path / ".env").read_text()
    write(tmp_path, {"a.cpp": "#include <cuda_runtime.h>\n"})
    assert (
        "a.cpp:1 names cuda_runtime.h, and base images have CUDA's libraries, and no nvcc"
        in called(tmp_path, "-y").stderr
    )
    (tmp_path / "a.cpp").unlink()
    write(tmp_path, {"package.xml": manifest(depends="python3-opencv"), "requirements.txt": "onnxruntime\n"})
    assert "names" not in called(tmp_path, "--yes").stderr


# ---- Questions, CI, output -------------------------------------------------------------------------------------------


def test_git_may_leave_out_the_file_of_variables(tmp_path: Path) -> None:
    write(tmp_path, {"package.xml": manifest(), ".gitignore": "build/\n.env\n"})
    assert ".gitignore leaves out .env" in called(tmp_path, "--yes").stderr


WORDS = [
    ("distribution", "Humble", "humble"),
    ("distribution", "noble", "jazzy"),
    ("distribution", "Ubuntu 22.04", "humble"),
    ("distribution", "ros2-kilted", "kilted"),
    ("distribution", "ROS 2", "jazzy"),
    ("distribution", "bookworm", "jazzy-wheels"),
    ("component", "ros-base", "base"),
    ("component", "desktop_full", "desktop-full"),
    ("framework", "pytorch", "torch"),
    ("framework", "tf", "tensorflow"),
    ("framework", "TensorFlow2", "tensorflow"),
    ("framework", "torch and tensorflow", "ml"),
    ("framework", "gpu", "cuda"),
    ("framework", "no", "none"),
    ("accelerator", "gpu", "cu130"),
    ("accelerator", "CUDA 12.8", "cu128"),
    ("accelerator", "12", "cu128"),
    ("accelerator", "none", "cpu"),
    ("ci", "GitHub Actions", "github"),
    ("ci", "no", "none"),
]


@pytest.mark.parametrize(("question", "word", "wanted"), WORDS)
def test_words_of_people_are_understood_on_the_command_line_and_as_answers(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, question: str, word: str, wanted: str
) -> None:
    write(tmp_path, {"package.xml": manifest()})
    given = ["--framework", "torch"] if question == "accelerator" else []
    assert chosen(tmp_path, f"--{question}", word, *given, *REGISTRY)[question] == wanted
    monkeypatch.setattr(init, "_has_terminal", lambda: True)
    asked = ["distribution", "component", *([] if given else ["framework"]), *(["accelerator"] if given else [])]
    before = len([*asked, "command"]) if question == "ci" else asked.index(question)
    done = called(tmp_path, "--dry-run", *given, *REGISTRY, typed="\n" * before + f"{word}\n" + "\n" * 9)
    assert re.search(rf"^{question} +{wanted} ", done.stdout, re.MULTILINE), (done.stdout, done.stderr)


def test_debian_has_both(tmp_path: Path) -> None:
    write(tmp_path, {"package.xml": manifest(build="catkin")})
    assert chosen(tmp_path, "--distribution", "bookworm")["distribution"] == "ros1-bookworm"


def test_a_terminal_is_asked(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The question, in brackets the proposal, and a short reason; what cannot be read is asked for again."""
    monkeypatch.setattr(init, "_has_terminal", lambda: True)
    write(tmp_path, {"package.xml": manifest(), "src/Node.py": TORCH})
    typed = "humbl\nhumble\n?\ncore\n\ncu128\nros2 run 'arm go\nros2 run arm go\n\n"
    done = called(tmp_path, typed=typed)
    lines = re.findall(r"^[A-Z][\w ]+ \[.*(?=: )", done.stderr, re.MULTILINE)
    core = "How much of ROS [base] (the build installs what your packages need beyond it)"
    command = "Command to start [bash] (a shell)"
    assert lines == [
        *["ROS distribution [jazzy] (ROS 2, long-term, supported until 2029-05-31)"] * 2,
        *[core] * 2,
        "Framework for machine learning [torch] (src/Node.py:1 names torch)",
        "Accelerator [cpu] (this machine has no NVIDIA GPU)",
        *[command] * 2,
        "CI file for [none] (no forge is known)",
    ]
    assert "no distribution named 'humbl'; did you mean 'humble'?" in done.stderr
    assert "core, base, perception, desktop" in done.stderr and "no closing quotation" in done.stderr
    values = app_inputs.values({}, tmp_path, {})
    assert (values.base_image, values.command) == ("ros-torch:humble-core-cu128", "ros2 run arm go")


def test_what_was_typed_before_a_question_is_no_answer(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A stranger's .env would name the registry, and keys of impatience confirm it."""
    order: list[str] = []
    monkeypatch.setattr(init, "_has_terminal", lambda: True)
    monkeypatch.setattr(question, "drop_typed", lambda: order.append("drop"))
    prompt = click.prompt

    def asking(*words: Any, **more: Any) -> Any:
        order.append("ask")
        return prompt(*words, **more)

    monkeypatch.setattr(click, "prompt", asking)
    write(tmp_path, {"package.xml": manifest()})
    called(tmp_path, typed="\n" * 9)
    assert order and order == ["drop", "ask"] * (len(order) // 2)


def test_a_terminal_is_asked_for_ci_and_where_it_pushes(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(init, "_has_terminal", lambda: True)
    write(tmp_path, {"package.xml": manifest(), ".git/config": GITHUB_REMOTE, ".git/HEAD": ""})
    typed = "\n" * 5 + "ghcr.io/Me/rosml\n{}\n"
    done = called(tmp_path, "--dry-run", typed=typed.format(""))
    assert "CI file for [github] (git's remote is github.com:me/robot.git): " in done.stderr
    assert "Registry of the base images [none] (such as ghcr.io/me/rosml: jobs do not reach this" in done.stderr
    assert "Push images to [ghcr.io/me/robot] (the repository's own place): " in done.stderr
    assert "image-name" not in done.stdout and re.search("^push to +ghcr.io/me/robot ", done.stdout, re.MULTILINE)
    done = called(tmp_path, typed=typed.format("quay.io/me/robot"))
    [step] = yaml.safe_load((tmp_path / file_texts.GITHUB).read_text())["jobs"]["images"]["steps"]
    secrets = {name: f"${{{{ secrets.REGISTRY_{name.upper()} }}}}" for name in ("user", "password")}
    assert step["with"].items() >= {
        ("image-name", "quay.io/me/robot"),
        ("registry", "quay.io"),
        *((f"registry-{name}", secret) for name, secret in secrets.items()),
    }
    assert "CI logs in to quay.io alone" in done.stderr


@pytest.mark.parametrize(
    ("words", "inputs"),
    [
        (["github", "ghcr.io/me/arm"], {"image-name": "ghcr.io/me/arm"}),
        (["gitlab", "quay.io/me/arm"], {"image-name": "quay.io/me/arm", "registry": "quay.io"}),
    ],
)
def test_where_ci_pushes(tmp_path: Path, words: list[str], inputs: dict[str, str]) -> None:
    name, place = words
    base = {"github": "ghcr.io/me/rosml", "gitlab": "registry.gitlab.com/me/rosml"}[name]
    done = called(
        write(tmp_path, {"package.xml": manifest()}), "--yes", "--ci", name, "--push-to", place, "--registry", base
    )
    found = yaml.safe_load((tmp_path / file_texts.FORGES[name]).read_text())
    given = found["include"][0]["inputs"] if name == "gitlab" else found["jobs"]["images"]["steps"][0]["with"]
    assert {key: value for key, value in given.items() if key.startswith(("image", "registry"))} == inputs
    assert ("masked variables" in done.stderr) == (name == "gitlab")


def test_without_ci_a_call_pushes(tmp_path: Path) -> None:
    said = called(write(tmp_path, {"package.xml": manifest()}), "--yes", "--push-to", "quay.io/me/arm").stdout
    assert f"containerize {tmp_path} --push --image-name quay.io/me/arm\n" in said


def test_without_a_terminal_nothing_is_asked(tmp_path: Path) -> None:
    called(write(tmp_path, {"package.xml": manifest(), ".github/x": ""}), typed="")
    assert app_inputs.values({}, tmp_path, {}).base_image == "ros:jazzy-base"


def test_an_interruption_writes_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(init, "_has_terminal", lambda: True)
    before = snapshot(write(tmp_path, {"package.xml": manifest()}))
    called(tmp_path, typed="humble\n", code=1)
    assert snapshot(tmp_path) == before


def test_without_a_checkout_a_registry_is_asked_for(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for module in (init, forge):
        monkeypatch.setattr(module, "IN_CHECKOUT", False)
    write(tmp_path, {"package.xml": manifest()})
    assert init.UNNAMED[0] in called(tmp_path, "--yes", "--dry-run").stderr
    monkeypatch.setattr(init, "_has_terminal", lambda: True)
    done = called(tmp_path, typed="\n" * 5 + "ghcr.io/Me/rosml\n" + "\n" * 9)
    assert init.UNNAMED[0] not in done.stderr
    assert app_inputs.values({}, tmp_path, {}).base_image == "ghcr.io/me/rosml/ros:jazzy-base"
    assert "rosml image" not in done.stdout


GITHUB_REMOTE = '[remote "origin"]\n\turl = git@github.com:me/robot.git\n'
GITLAB_REMOTE = '[remote "origin"]\n\turl = https://gitlab.example.com/me/robot.git\n'


@pytest.mark.parametrize(
    ("files", "words", "wanted"),
    [
        ({}, REGISTRY, "none"),
        ({".github/dependabot.yml": ""}, REGISTRY, "github"),
        ({".github/dependabot.yml": ""}, [], "none"),
        ({".github/dependabot.yml": ""}, [*REGISTRY, "--ci", "none"], "none"),
        ({".git/HEAD": "", ".git/config": GITHUB_REMOTE}, REGISTRY, "github"),
        ({".git/HEAD": "", ".git/config": GITLAB_REMOTE}, REGISTRY, "none"),
        ({".git/HEAD": "", ".git/config": GITLAB_REMOTE}, ["--registry", "registry.example.com/me/rosml"], "gitlab"),
    ],
)
def test_the_forge_of_a_repository(tmp_path: Path, files: dict[str, str], words: list[str], wanted: str) -> None:
    assert chosen(write(tmp_path, {"package.xml": manifest(), **files}), *words)["ci"] == wanted


def test_ci_files_belong_to_the_top_of_a_repository(tmp_path: Path) -> None:
    write(tmp_path, {"ros/package.xml": manifest(), ".git/HEAD": ""})
    error: Any = called(tmp_path / "ros", "--ci", "github", *REGISTRY, code=2).exception
    assert error.message == f"CI files belong into {tmp_path}"


@pytest.mark.parametrize(
    ("name", "place"), [("github", "ghcr.io/me/rosml"), ("gitlab", "registry.gitlab.com/me/rosml")]
)
def test_inputs_of_a_ci_file_are_those_that_there_are(tmp_path: Path, name: str, place: str) -> None:
    write(
        tmp_path,
        {"package.xml": manifest(), "a/x.jazzy.repos": "", "b/x.humble.repos": "", "requirements.txt": "scipy\n"},
    )
    called(tmp_path, "--yes", "--ci", name, "--registry", place, "--command", 'ros2 run "a b" c: d # é')
    found = yaml.safe_load((tmp_path / file_texts.FORGES[name]).read_text())
    if name == "github":
        [step] = found["jobs"]["images"]["steps"]
        assert step["uses"].startswith("me/rosml/containerize@")
        given, known = step["with"], yaml.safe_load((ROOT / "containerize/action.yml").read_text())["inputs"]
    else:
        [included] = found["include"]
        assert included["project"] == "me/rosml" and (ROOT / included["file"]).is_file()
        given, known = (
            included["inputs"],
            next(yaml.safe_load_all((ROOT / included["file"]).read_text()))["spec"]["inputs"],
        )
    assert set(given) <= set(known)
    assert (given["base-image"], given["command"]) == (f"{place}/ros:jazzy-base", 'ros2 run "a b" c: d # é')
    assert given["vcs-import-file"] == "a/x.jazzy.repos" and given["additional-pip-file"] == "requirements.txt"


def test_a_job_gets_a_commit_only_if_a_remote_has_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(git, "commit", lambda _: git.Commit("1" * 40, 0))
    monkeypatch.setattr(git, "ask", lambda *_: b"1 commit refs/remotes/origin/main\n")
    assert (forge.revision("github"), forge.revision("gitlab")) == ("1" * 40, "main")
    monkeypatch.setattr(git, "ask", lambda *_: b"")
    assert forge.revision("github") == "main"


def test_what_comes_next(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    write(tmp_path, {"package.xml": manifest("robot")})
    monkeypatch.chdir(tmp_path)
    own = f"{ROOT}/rosml"
    said = json.loads(called(Path("."), "--json").stdout)
    name = file_texts.image_name(tmp_path.name)
    assert said["next"] == [
        f"{own} image jazzy-base",
        f"{own} containerize",
        f"{own} run",
        f"docker build --build-arg BASE_IMAGE=REGISTRY/ros:jazzy-base -t {name} .",
    ]
    monkeypatch.setattr(init, "_local", lambda _: ("127.0.0.1:5000/rosml", True))
    said = json.loads(called(Path("."), "--json").stdout)
    assert said["next"][0] == f"{own} containerize"
    assert "BASE_IMAGE=127.0.0.1:5000/rosml/ros:jazzy-base" in said["next"][2]
    assert said["packages"] == [{"name": "robot", "folder": ".", "languages": []}]


def test_a_base_image_in_a_registry_is_published_first(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    write(tmp_path, {"package.xml": manifest("robot")})
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(base_images, "native_architecture", lambda: "amd64")
    line = f"{ROOT}/rosml publish all --registry ghcr.io/me/rosml --only jazzy-base{{}} --serve amd64"
    said = json.loads(called(tmp_path, "--json", *REGISTRY).stdout)
    assert said["next"][0] == line.format("")
    assert said["next"][1] == f"{ROOT}/rosml containerize"
    said = json.loads(called(tmp_path, "--json", "--ci", "github", *REGISTRY).stdout)
    assert said["next"][0] == line.format(" --only jazzy-base-run"), "CI makes a slim image, too"
    monkeypatch.setattr(init, "IN_CHECKOUT", False)
    assert "in a clone of rosml: publishes" in called(tmp_path, "--yes", *REGISTRY).stdout


@pytest.mark.parametrize(
    ("folder", "name"),
    [
        ("my_robot", "my_robot"),
        ("My Robot!", "my-robot"),
        ("a..b", "a.b"),
        ("_x-", "x"),
        ("機械", "app"),
        ("a-_b", "a-b"),
    ],
)
def test_the_name_of_an_image(folder: str, name: str) -> None:
    assert file_texts.image_name(folder) == name


# ---- What a repository says is written into files of others ----------------------------------------------------------


def project_of(text: str) -> file_texts.Project:
    """A project in which all that a repository may choose has a text."""
    return file_texts.Project(
        name="robot", tag="ros:jazzy-base", place="ghcr.io/me/rosml", ros=2, gpu=False, command=f"ros2 launch a '{text}'", ended=False,
        pip=(f"{text}.txt",), repos=f"{text}.repos", is_one_of_several=True, packages=(text,), forge="github", source="me/rosml",
        revision="main", keys=(text,),
    )  # fmt: skip


@pytest.mark.parametrize("text", HOSTILE)
def test_texts_of_a_repository_are_only_texts_in_all_files(text: str) -> None:
    """Each file is read as its system reads it."""
    project = project_of(text)
    expected = {name.lower().replace("_", "-"): value for name, value in file_texts.variables(project).items()}
    github = file_texts.texts(project)[file_texts.GITHUB]
    given = yaml.safe_load(github)["jobs"]["images"]["steps"][0]["with"]
    literal = "${{ '${{' }}"
    for name, value in given.items():
        if name != "push":
            assert "${{" not in value.replace(literal, "")
            assert value.replace(literal, "${{") == expected[name]
    gitlab = file_texts.texts(replace(project, forge="gitlab"))[file_texts.GITLAB]
    (include,) = yaml.safe_load(gitlab)["include"]
    for name, value in include["inputs"].items():
        if name not in ("rosml-url", "rosml-ref"):
            assert (value if name in file_texts.AS_IT_IS else value.replace("$$", "$")) == expected[name]
            assert name in file_texts.AS_IT_IS or "$" not in value.replace("$$", "")
    dockerfile = file_texts.texts(project)[file_texts.DOCKERFILE]
    instructions = [line for line in dockerfile.split("\n") if line and not line.startswith((" ", "#"))]
    assert {line.split(" ")[0] for line in instructions} <= {"ARG", "FROM", "COPY", "RUN", "CMD"}
    (copied,) = [json.loads(line[5:]) for line in instructions if line.startswith("COPY [")]
    assert re.sub(r"\\(.)", r"\1", copied[0]) == project.repos and not re.search(r"(?<!\\)(\\\\)*\$", copied[0])


@pytest.mark.parametrize("text", ["a\nRUN id", "a\rb", "a\x00", "a\u2028b"])
def test_a_name_of_several_lines_is_refused(text: str) -> None:
    with pytest.raises(RosmlError, match="has the character"):
        file_texts.texts(project_of(text))


def test_a_registry_of_the_repository_is_a_proposal(tmp_path: Path) -> None:
    """A stranger's .env would choose whose workflow may write packages."""
    folder = write(
        tmp_path,
        {"package.xml": manifest(), ".env": "BASE_IMAGE=ghcr.io/attacker/rosml/ros:jazzy-base\n", ".github/x": ""},
    )
    done = called(folder, "--yes", "--distribution", "jazzy")
    assert "names the registry ghcr.io/attacker/rosml, and nobody has confirmed it" in done.stderr
    assert not (folder / ".github/workflows").exists()
    assert "attacker" not in (folder / "Dockerfile").read_text()
    (folder / "Dockerfile").unlink()
    (folder / ".env").write_text('BASE_IMAGE="x.y/a\nFROM debian AS z\nRUN id >/evil\n# /ros:jazzy-base"\n')
    called(folder, "--yes", "--distribution", "jazzy")
    assert "evil" not in (folder / "Dockerfile").read_text()
