"""What `rosml init` proposes for a folder, and what it refuses."""

from __future__ import annotations

import re
import shlex
from pathlib import Path
from typing import Any

import click
import pytest

from fakes.package_folders import (
    REGISTRY,
    TORCH,
    WITH_CI,
    called,
    chosen,
    machine,
    manifest,
    package,
    snapshot,
    terminal,
    values_of,
    write,
)
from rosml.cli.containerize import init
from rosml.cli.run import questions as run_questions
from rosml.containerize.init import forge
from rosml.containerize.packages.conditions import holds
from rosml.images.image_set.model import ImageSet
from rosml.run.plugins import gpu

__all__ = ["machine", "terminal"]


# ---- What the folder says --------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("files", "image"),
    [
        ({}, "jazzy base none"),
        (package(build="catkin"), "ros1-bookworm base none"),
        (package(build="cmake", depends="rclcpp"), "jazzy base none"),
        (package(condition="$ROS_DISTRO == humble"), "humble base none"),
        (package(build="catkin", condition="$ROS_DISTRO == noetic"), "ros1-bookworm base none"),
        (package(depends="desktop"), "jazzy desktop none"),
        (TORCH, "jazzy base torch"),
        ({"a.py": "import os, torch.nn as nn\n"}, "jazzy base torch"),
        ({"a.py": "# import torch\nfrom tf import x\n"}, "jazzy base none"),
        (package(depends="python3-pytorch-pip"), "jazzy base torch"),
        ({"a/package.xml": manifest(depends="torch_msgs"), "b/package.xml": manifest("torch_msgs")}, "jazzy base none"),
        ({"CMakeLists.txt": "find_package(Torch REQUIRED)\n"}, "jazzy base torch"),
        ({"setup.py": "setup(install_requires=['tensorflow>=2'])\n"}, "jazzy base tensorflow"),
        ({"requirements.txt": "torch==2.1\ntensorflow\n"}, "jazzy base ml"),
        ({"a.py": "import cupy as cp\n"}, "jazzy base cuda"),
        ({"a.cpp": "#include <cuda.h>\n#include <torch/script.h>\n"}, "jazzy base torch"),
        ({"requirements.txt": "onnxruntime-gpu\n"}, "jazzy base cuda"),
        ({".venv/a.py": TORCH["a.py"], "env/pyvenv.cfg": "", "env/a.py": TORCH["a.py"]}, "jazzy base none"),
        (package() | {"x/COLCON_IGNORE": "", "x/package.xml": manifest(build="catkin")}, "jazzy base none"),
        # The lock of ros1-bookworm for the CPU is missing, and this machine has no GPU.
        (package(build="catkin") | TORCH, "ros1-trixie base torch"),
    ],
)
def test_what_packages_and_sources_ask_for(tmp_path: Path, files: dict[str, str], image: str) -> None:
    assert list(chosen(write(tmp_path, files)).values())[:3] == image.split()


def test_a_proposal_can_be_built_where_another_one_cannot(tmp_path: Path, real: ImageSet) -> None:
    """ros1-bookworm lacks the lock of PyTorch for the CPU."""
    write(tmp_path, TORCH, build="catkin")
    assert chosen(tmp_path, "--gpu")["distribution"] == "ros1-bookworm"
    choices = chosen(tmp_path, "--cpu")
    target = "-".join(choices[name] for name in ("distribution", "component", "framework", "accelerator"))
    assert real.image(target).locked and not real.image("ros1-bookworm-base-torch-cpu").locked
    done = called(tmp_path, "--yes", "--cpu", "--distribution", "ros1-bookworm")
    assert "ros1-bookworm-base-torch-cpu cannot be built yet" in done.stderr


@pytest.mark.parametrize(
    ("files", "ros_distro", "name"),
    [
        ({".git/HEAD": "ref: refs/heads/humble-devel\n"}, "", "humble"),
        ({".git/HEAD": "ref: refs/heads/feature/lyrical_x\n"}, "", "lyrical"),
        ({".git/HEAD": "ref: refs/heads/foxy\n"}, "", "jazzy"),
        ({".git/HEAD": "ref: refs/heads/humble\n"}, "rolling", "rolling"),
        ({".github/workflows/ci.yml": "container: ros:humble-ros-base\n"}, "", "humble"),
        ({".github/workflows/a.yml": "humble", ".github/workflows/b.yml": "jazzy kilted"}, "", "jazzy"),
        ({"Dockerfile": "FROM osrf/ros:lyrical-desktop\n"}, "", "lyrical"),
        ({".env": "BASE_IMAGE=ros:rolling-core\n", ".git/HEAD": "ref: refs/heads/humble\n"}, "", "rolling"),
    ],
)
def test_where_a_distribution_is_named(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, files: dict[str, str], ros_distro: str, name: str
) -> None:
    monkeypatch.setenv("ROS_DISTRO", ros_distro)
    assert chosen(write(tmp_path, files))["distribution"] == name


@pytest.mark.parametrize(
    ("driver", "words", "stack"),
    [
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
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, driver: str | None, words: list[str], stack: str
) -> None:
    monkeypatch.setattr(gpu, "is_nvidia", lambda _: driver is not None)
    monkeypatch.setattr(gpu, "driver", lambda _: driver or "")
    assert chosen(write(tmp_path, TORCH), *words)["accelerator"] == stack


GO = {"setup.py": "x = ['go = arm.go:main']\n"}
CATKIN = """\
catkin_install_python(PROGRAMS scripts/go.py ${OTHERS}
  DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
install(FILES go.yaml DESTINATION ${CATKIN_PACKAGE_SHARE_DESTINATION})
"""
AMENT = """project(arm) add_executable(go src/go.cpp)
add_library(arm src/arm.cpp)
install(TARGETS arm go ARCHIVE DESTINATION lib RUNTIME DESTINATION "lib/${PROJECT_NAME}")
"""
COMPONENT = 'rclcpp_components_register_node(arm PLUGIN "Go" EXECUTABLE go_node)'


@pytest.mark.parametrize(
    ("distribution", "files", "command"),
    [
        ("jazzy", {"launch/a.launch.py": ""}, "ros2 launch arm a.launch.py"),
        ("jazzy", {"launch/a.launch.py": "", "launch/bringup.launch.xml": ""}, "ros2 launch arm bringup.launch.xml"),
        ("jazzy", {"launch/a.launch.py": "", "launch/b_launch.py": ""}, "bash"),
        ("jazzy", GO, "ros2 run arm go"),
        ("jazzy", {"setup.cfg": "[options.entry_points]\nconsole_scripts =\n  go = arm.go:main\n"}, "ros2 run arm go"),
        ("jazzy", {"setup.py": "x = ['a = arm.a:main', 'b = arm.b:main']\n"}, "bash"),
        ("noetic", {**package(build="catkin", depends="rospy"), "CMakeLists.txt": CATKIN}, "rosrun arm go.py"),
        ("jazzy", {"CMakeLists.txt": AMENT}, "ros2 run arm go"),
        ("jazzy", {"CMakeLists.txt": COMPONENT}, "ros2 run arm go_node"),
        ("jazzy", {"CMakeLists.txt": AMENT + COMPONENT}, "bash"),
        ("jazzy", {"CMakeLists.txt": f"# {COMPONENT}\nadd_executable(a a.cpp)\ninstall(TARGETS a DESTINATION bin)"}, "bash"),
        ("jazzy", {}, "bash"),
        ("jazzy-wheels", {**GO, "launch/a.launch.py": ""}, "/docker-ros/ws/install/arm/lib/arm/go"),
        ("jazzy-wheels", {"launch/a.launch.py": ""}, "bash"),
    ],
)  # fmt: skip
def test_the_command_that_is_proposed(tmp_path: Path, distribution: str, files: dict[str, str], command: str) -> None:
    """ROS from wheels has no command ros2."""
    assert chosen(write(tmp_path, files), "--distribution", distribution)["command"] == command


@pytest.mark.parametrize(
    ("files", "warns"), [(GO, False), ({"src/a.cpp": ""}, True), (package(build="ament_cmake"), True)]
)
def test_ros_from_wheels_builds_python_alone(tmp_path: Path, files: dict[str, str], warns: bool) -> None:
    errors = called(write(tmp_path, files), "--yes", "--distribution", "jazzy-wheels").stderr
    assert ("builds packages of Python alone, and package.xml is none" in errors) == warns


@pytest.mark.parametrize(
    ("depends", "lacks", "take"),
    [
        ("rclpy std_msgs python3-numpy", "", ""),
        ("rclpy launch_ros", "launch_ros", "--distribution jazzy --component base"),
        ("launch cv_bridge", "cv_bridge and launch", "--distribution jazzy --component perception"),
    ],
)
def test_what_ros_from_wheels_lacks_is_said_with_the_image_that_has_it(
    tmp_path: Path, depends: str, lacks: str, take: str
) -> None:
    text = manifest(depends=depends, build="ament_python")
    errors = called(write(tmp_path, {**GO, "package.xml": text}), "--yes", "--distribution", "jazzy-wheels").stderr
    says = f"jazzy-wheels lacks {lacks}, which package.xml depends on\nremedy: take {take}\n"
    assert says in errors if lacks else "lacks" not in errors
    error: Any = called(tmp_path, "--yes", "--distribution", "jazzy-wheels", "--component", "base", code=2).exception
    assert error.remedy == "take core, or --distribution jazzy"


@pytest.mark.parametrize(
    ("text", "does_hold"),
    [
        ("", True),
        ("$ROS_VERSION==1", False),
        ("$ROS_VERSION == 1 or $ROS_DISTRO == 'jazzy'", True),
        ("$ROS_VERSION == 1 or $ROS_VERSION == 2 and $ROS_DISTRO == foxy", False),
        ("($ROS_VERSION == 1 or $ROS_VERSION == 2) and $ROS_DISTRO == jazzy", True),
        ('$ROS_DISTRO >= "humble"', True),
        ("$ROS_DISTRO != jazzy", False),
        ("$OTHER == ''", True),
        *(
            (broken, True)
            for broken in ("$ROS_VERSION ==", "a b c", "(", "$ROS_VERSION == 1)", "((" * 400, "$ROS_VERSION == 1 &")
        ),
    ],
)
def test_conditions(text: str, does_hold: bool) -> None:
    assert holds(text, {"ROS_VERSION": "2", "ROS_DISTRO": "jazzy"}) is does_hold


def test_lists_of_upstream_repositories_and_requirements(tmp_path: Path) -> None:
    """Of lists for several distributions one counts; requirements are installed, wherever they are."""
    files = {"a/package.xml": manifest("a"), "b/package.xml": manifest("b"), "c.jazzy.repos": "", "c.humble.repos": ""}
    write(tmp_path, {**files, "a/requirements.txt": "scipy\n", "b/requirements.txt": "scipy\n"})
    called(tmp_path, "--yes")
    values, text = values_of(tmp_path), (tmp_path / "Dockerfile").read_text()
    assert (values.enable_recursive_vcs_import, values.vcs_import_file) == (False, "c.jazzy.repos")
    assert (values.enable_recursive_additional_pip, values.additional_pip_file) == (True, "requirements.txt")
    assert 'COPY ["c.jazzy.repos", "/upstream.repos"]' in text and "! -name requirements.txt" in text
    assert text.count("pip install -r /run/src/target/b/requirements.txt") == 2


# ---- What is wrong ---------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("files", "words", "says"),
    [
        ({"package.xml": "<x/>"}, "", "its first element is <x>, not <package>"),
        ({"package.xml": '<?xml version="1.0" encoding="x-y"?><package/>'}, "", "package.xml:1: no XML"),
        ({"x/COLCON_IGNORE": "", "x/package.xml": manifest()}, "", "there is no package.xml in"),
        (
            {"a/package.xml": manifest("a"), "b/package.xml": manifest("b", "catkin")},
            "",
            r"ROS 1 and of ROS 2 do not build together: b/package.xml \(ROS 1\) and a/package.xml \(ROS 2\)",
        ),
        ({}, "--distribution jazy", "no distribution named 'jazy'; did you mean 'jazzy'"),
        ({}, "--distribution noetic", "package.xml is not for noetic, which is ROS 1"),
        ({}, "--component robot", "has no robot metapackage"),
        ({}, "--framework tf --distribution lyrical", "has a wheel for Python 3.14"),
        ({}, "--framework torch --accelerator cu121", "torch 2.4.1 has no wheel"),
        ({}, "--accelerator tpu", "no accelerator named 'tpu'"),
        ({}, "--framework torch --accelerator cpu --gpu", "not what you ask for"),
        ({}, "--framework none --gpu", "none computes nothing on a GPU"),
        ({}, '--command "a \'b"', "no closing quotation"),
        ({}, "--registry https://x/y", "no place for images"),
        ({}, "--registry ghcr.io/me/rosml --ci jenkins", "no forge named 'jenkins'"),
        ({}, "--ci github", "do not reach this machine's images"),
        ({}, "--ci github --registry quay.io/me/x", "nobody knows where on github"),
    ],
)
def test_what_is_wrong_has_a_remedy_and_nothing_is_written(
    tmp_path: Path, files: dict[str, str], words: str, says: str
) -> None:
    before = snapshot(write(tmp_path, files))
    error: Any = called(tmp_path, "--yes", *shlex.split(words), code=2).exception
    assert re.search(says, error.message), error.message
    assert error.remedy and snapshot(tmp_path) == before


def test_an_end_of_life_is_a_warning(tmp_path: Path) -> None:
    done = called(write(tmp_path, {}), "--yes", "--distribution", "foxy")
    assert "foxy had its end of life on 2023-06-20\nremedy: if your packages allow it, take jazzy" in done.stderr
    assert "rosdep update --include-eol-distros" in (tmp_path / "Dockerfile").read_text()


def test_a_framework_that_the_distribution_of_the_branch_lacks(tmp_path: Path) -> None:
    write(tmp_path, {"a.py": "import tensorflow\n", ".git/HEAD": "ref: refs/heads/lyrical\n"})
    assert "no release of tensorflow has a wheel for Python 3.14" in called(tmp_path, "--yes").stderr
    assert "BASE_IMAGE=ros:lyrical-base\n" in (tmp_path / ".env").read_text()


def test_a_library_that_no_manifest_names(tmp_path: Path) -> None:
    write(tmp_path, {"a.py": "\nimport cv2\nimport onnxruntime\n", "b.cpp": "#include <cuda_runtime.h>\n"})
    errors = called(tmp_path, "--yes").stderr
    assert "a.py:2 names cv2, and no package.xml does" in errors
    assert "a.py:3 names onnxruntime: containerize adds the add-on onnx" in errors
    assert "b.cpp:1 names cuda_runtime.h, and base images have CUDA's libraries, and no nvcc" in errors
    assert "ADDONS=onnx-cpu\n" in (tmp_path / ".env").read_text()
    (tmp_path / "b.cpp").unlink()
    write(tmp_path, {"requirements.txt": "onnxruntime\n"}, depends="python3-opencv")
    assert "names" not in called(tmp_path, "--yes").stderr


# ---- Questions -------------------------------------------------------------------------------------------------------

WORDS = [
    ("distribution", "noble", "jazzy"),
    ("distribution", "Ubuntu 22.04", "humble"),
    ("distribution", "ROS 2", "jazzy"),
    ("distribution", "bookworm", "jazzy-wheels"),
    ("component", "ros-base", "base"),
    ("component", "desktop_full", "desktop-full"),
    ("framework", "pytorch and tf", "ml"),
    ("framework", "gpu", "cuda"),
    ("framework", "no", "none"),
    ("accelerator", "gpu", "cu130"),
    ("accelerator", "CUDA 12.8", "cu128"),
    ("accelerator", "none", "cpu"),
    ("ci", "GitHub Actions", "github"),
]


@pytest.mark.parametrize(("question", "word", "value"), WORDS)
def test_words_of_people_are_understood_on_the_command_line_and_as_answers(
    tmp_path: Path, terminal: None, question: str, word: str, value: str
) -> None:
    write(tmp_path, {})
    options = ["--framework", "torch"] if question == "accelerator" else []
    assert chosen(tmp_path, f"--{question}", word, *options, *REGISTRY)[question] == value
    questions = ["distribution", "component", "accelerator" if options else "framework"]
    before = len([*questions, "command"]) if question == "ci" else questions.index(question)
    done = called(tmp_path, "--dry-run", *options, *REGISTRY, typed="\n" * before + f"{word}\n" + "\n" * 9)
    assert re.search(rf"^{question} +{value} ", done.stdout, re.MULTILINE), (done.stdout, done.stderr)


def test_a_terminal_is_asked(tmp_path: Path, terminal: None) -> None:
    """The question, in brackets the proposal, and a short reason; what cannot be read is asked for again."""
    write(tmp_path, {"src/Node.py": TORCH["a.py"]})
    typed = "humbl\nhumble\n?\ncore\n\ncu128\nros2 run 'arm go\nros2 run arm go\n\n"
    done = called(tmp_path, typed=typed)
    assert re.findall(r"^[A-Z][\w ]+ \[.*(?=: )", done.stderr, re.MULTILINE) == [
        *["ROS distribution [jazzy] (ROS 2, long-term, supported until 2029-05-31)"] * 2,
        *["How much of ROS [base] (the build installs what your packages need beyond it)"] * 2,
        "Framework for machine learning [torch] (src/Node.py:1 names torch)",
        "Accelerator [cpu] (this machine has no NVIDIA GPU)",
        *["Command to start [bash] (a shell, as there is no launch file and no program)"] * 2,
        "CI file for [none] (no forge is known)",
    ]
    assert "no distribution named 'humbl'; did you mean 'humble'?" in done.stderr
    assert "core, base, perception, desktop" in done.stderr and "no closing quotation" in done.stderr
    values = values_of(tmp_path)
    assert (values.base_image, values.command) == ("ros-torch:humble-core-cu128", "ros2 run arm go")


def test_what_was_typed_before_a_question_is_no_answer(
    tmp_path: Path, terminal: None, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A stranger's .env would name the registry, and keys of impatience confirm it."""
    order, prompt = list[str](), click.prompt

    def asking(*words: Any, **more: Any) -> Any:
        order.append("ask")
        return prompt(*words, **more)

    monkeypatch.setattr(run_questions, "drop_typed", lambda: order.append("drop"))
    monkeypatch.setattr(click, "prompt", asking)
    called(write(tmp_path, {}), typed="\n" * 9)
    assert order and order == ["drop", "ask"] * (len(order) // 2)


def test_without_a_terminal_nothing_is_asked(tmp_path: Path) -> None:
    called(write(tmp_path, WITH_CI), typed="")
    assert values_of(tmp_path).base_image == "ros:jazzy-base"


def test_an_interruption_writes_nothing(tmp_path: Path, terminal: None) -> None:
    before = snapshot(write(tmp_path, {}))
    called(tmp_path, typed="humble\n", code=1)
    assert snapshot(tmp_path) == before


def test_without_a_checkout_a_registry_is_asked_for(
    tmp_path: Path, terminal: None, monkeypatch: pytest.MonkeyPatch
) -> None:
    for module in (init, forge):
        monkeypatch.setattr(module, "IN_CHECKOUT", False)
    write(tmp_path, {})
    assert init.UNNAMED[0] in called(tmp_path, "--yes", "--dry-run").stderr
    done = called(tmp_path, typed="\n" * 5 + "ghcr.io/Me/rosml\n" + "\n" * 9)
    assert init.UNNAMED[0] not in done.stderr and "rosml image" not in done.stdout
    assert values_of(tmp_path).base_image == "ghcr.io/me/rosml/ros:jazzy-base"
