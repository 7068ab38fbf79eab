"""What the documentation shows, file by file and command by command as it stands there, in real images: the C++ examples,
Dockerfiles of users, the CI of a package, parts that are compared, an image that is carried to another registry."""

from __future__ import annotations

import json
import os
import re
import shlex
from collections.abc import Iterator
from pathlib import Path

import pytest
import yaml

from rosml import ROOT
from rosml.machine.services import Services
from tests import regctl
from tests.e2e.app_builds import write
from tests.e2e.calls import NAMESPACE, succeeds
from tests.e2e.images import Publish, Published, build_file
from tests.pages import SHELLS, Block, blocks, commands

TENSORFLOW = "ros1-bookworm-core-tensorflow-cpu"
CPP = ROOT / "docs/cpp.md"
NODES = ROOT / "docs/cpp/nodes.md"


def section(page: Path, name: str) -> Iterator[Block]:
    matches = [block for block in blocks(page) if block.section == name]
    assert matches, f"{page.name} has no section {name!r} with code"
    return iter(matches)


def require(pattern: str, output: str) -> None:
    """Asserts that a step of a build printed a line."""
    assert re.search(rf"^#\d+ [\d.]+ {pattern}", output, re.MULTILINE), f"{pattern!r} was not printed:\n{output}"


def example(services: Services, image: Published, folder: Path, name: str) -> str:
    """Writes the files of a section, runs its commands in them, and looks for what it says they print."""
    steps, printed = [], []
    for block in section(CPP, name):
        if block.title:
            write(folder / "files", {block.title: block.text})
        elif block.language in SHELLS:
            steps += list(commands(block))
        elif block.language == "text":
            printed += block.text.splitlines()
    assert steps and printed
    script = "\n".join(["#!/bin/bash", "set -euxo pipefail", "cd /example/files", *steps, ""])
    write(folder, {"files/steps.sh": script})
    lines = [f"FROM {image.result['reference']}", "COPY files /example/files"]
    lines += ["RUN --network=none env -u LD_LIBRARY_PATH /example/files/steps.sh"]
    output = build_file(services, folder, "\n".join(lines) + "\n")
    for line in printed:
        require(f"{re.escape(line)}$", output)
    return output


DETECTOR = """\
#include <c10/core/Device.h>
#include <ros/time.h>

#include <iostream>

int main() {
  std::cout << c10::Device(c10::kCPU) << " after " << ros::Duration(2).toSec() << " s" << std::endl;
}
"""
"""Little of PyTorch, so that it compiles within seconds; the program of the section before is the whole of it."""

NODE = """\
cmake_minimum_required(VERSION 3.16)
project(detector)
"""


def node(services: Services, image: Published, folder: Path) -> None:
    """Builds the page's lines for catkin, in a project that has nothing else, and runs what comes of it."""
    snippet = next(block for block in section(NODES, "A ROS 1 node") if "catkin" in block.text)
    write(folder, {"CMakeLists.txt": NODE + snippet.text, "src/detector.cpp": DETECTOR})
    steps = "/entrypoint.sh cmake -S /node -B /node/build && cmake --build /node/build && find /node/build -type f -perm -100 -name detector -exec {} \\;"
    text = f"FROM {image.result['reference']}\nCOPY . /node\nRUN --network=none env -u LD_LIBRARY_PATH bash -euc '{steps}'\n"
    require("cpu after 2 s$", build_file(services, folder, text))


@pytest.mark.full(proof="cuda")
def test_cplusplus_with_pytorch(services: Services, published: Publish, tmp_path: Path) -> None:
    image = published("ros1-bookworm-core-torch-cu128")
    example(services, image, tmp_path / "example", "PyTorch")
    node(services, image, tmp_path / "node")


def test_cplusplus_with_tensorflow(services: Services, published: Publish, tmp_path: Path) -> None:
    """By CMake and by hand."""
    image = published(TENSORFLOW)
    output = example(services, image, tmp_path, "TensorFlow")
    require(f"{re.escape(image.image.versions['tensorflow'])}$", output)


PACKAGE = """\
<package format="3">
  <name>example</name><version>0.0.1</version><description>x</description>
  <maintainer email="x@example.org">x</maintainer><license>Apache-2.0</license>
  <buildtool_depend>cmake</buildtool_depend><exec_depend>rospy</exec_depend>
  <export><build_type>cmake</build_type></export>
</package>
"""

CMAKE = """\
cmake_minimum_required(VERSION 3.16)
project(example NONE)
enable_testing()
add_test(NAME example COMMAND python3 ${CMAKE_SOURCE_DIR}/test_example.py)
install(FILES package.xml DESTINATION share/example)
"""

TEST = """\
import rospy

assert rospy.Duration(2).to_sec() == 2
"""


@pytest.mark.parametrize("name", [".github/workflows/test.yml", ".gitlab-ci.yml"])
def test_ci_of_a_package(services: Services, published: Publish, tmp_path: Path, name: str) -> None:
    """The commands that the page gives a runner, in a plain shell, with a package that has a test."""
    [block] = [block for block in blocks(ROOT / "docs/use/ci.md") if block.title == name]
    job = yaml.safe_load(block.text)
    if "jobs" in job:
        steps = [step["run"] for step in job["jobs"]["test"]["steps"] if "run" in step]
        environment = job["jobs"]["test"]["env"]
    else:
        steps, environment = job["test"]["script"], job["test"]["variables"]
    assert len(steps) == 3
    write(tmp_path / "checkout", {"package.xml": PACKAGE, "CMakeLists.txt": CMAKE, "test_example.py": TEST})
    exported = " ".join(f"{key}={shlex.quote(value)}" for key, value in environment.items())
    image = published("ros1-bookworm-core")
    lines = [f"FROM {image.result['reference']}", "COPY checkout /checkout", "WORKDIR /checkout"]
    lines += [f"RUN --network=none export {exported} && {step}" for step in steps]
    output = build_file(services, tmp_path, "\n".join(lines) + "\n")
    assert "Finished <<< example" in output
    assert re.search(r"Summary: [1-9]\d* tests?, 0 errors, 0 failures", output), output


USED = """\
<package format="2">
  <name>my_package</name><version>0.0.1</version><description>x</description>
  <maintainer email="x@example.org">x</maintainer><license>Apache-2.0</license>
  <buildtool_depend>catkin</buildtool_depend><exec_depend>rospy</exec_depend>
</package>
"""

USED_CMAKE = """\
cmake_minimum_required(VERSION 3.16)
project(my_package)
find_package(catkin REQUIRED)
catkin_package()
catkin_install_python(PROGRAMS detector.py DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
"""


def test_dockerfiles_of_users(services: Services, published: Publish, tmp_path: Path) -> None:
    """Both of the pages, line by line as they stand there, but for the image: ros1-bookworm-core, which has no framework."""
    image = published("ros1-bookworm-core").result["reference"]
    plain = next(
        block.text for block in section(ROOT / "docs/use.md", "In a Dockerfile") if "catkin_make" in block.text
    )
    page = ROOT / "docs/use/dev-container.md"
    [container] = [block.text for block in blocks(page) if block.title == ".devcontainer/Dockerfile"]
    for name, text in (("plain", plain), ("container", container)):
        first, rest = text.split("\n", 1)
        assert first.startswith("FROM <registry>/ros-torch:")
        program = "#!/usr/bin/env python3\nprint('it detects')\n"
        write(tmp_path / name, {"package.xml": USED, "CMakeLists.txt": USED_CMAKE, "detector.py": program})
        command = re.search(r"^CMD (\[.*\])$", rest, re.MULTILINE)
        last = (
            f"RUN /entrypoint.sh {shlex.join(json.loads(command[1]))}"
            if command
            else "USER dev\nRUN touch /docker-ros/ws/mine && id -nG && bash -ic 'rospack find rospy'"
        )
        output = build_file(services, tmp_path / name, f"FROM {image}\n{rest}{last}\n")
        require("it detects" if command else r"dev .*\bvideo\b", output)


def test_parts_are_compared(services: Services) -> None:
    """The commands of the page about reproducibility, in the tests' namespaces, and without `--again`: a part that is
    assembled without the builder's cache is tests/e2e/test_containerize.py's."""
    steps = [
        command
        for block in section(ROOT / "docs/reproducibility.md", "Check it yourself")
        for command in commands(block)
        if command.startswith(("./rosml ", "regctl "))
    ]
    again = f"{NAMESPACE}-again"
    changes = [
        ("part ", f"part --namespace {NAMESPACE} "),
        ("--again --namespace again", f"--namespace {again}"),
        ("<host>/rosml/", f"<host>/{NAMESPACE}/"),
    ]
    for step, (words, ours) in zip(steps, changes, strict=True):
        assert words in step
        command = step.replace(words, ours).replace("<host>/again/", f"<host>/{again}/")
        argv = shlex.split(command.replace("<host>", services.registry))
        if argv[0] == "./rosml":
            argv[0] = str(ROOT / "rosml")
        if argv[0] == "regctl":
            argv[:1] = [regctl.program(services), "--host", f"reg={services.registry},tls=disabled"]
        done = succeeds(*argv, env={"PATH": f"{Path(services.uv).parent}:{os.environ['PATH']}"})
    assert done.out.strip() == "", "they differ"


def test_an_image_is_carried_over(services: Services, published: Publish, tmp_path: Path) -> None:
    """Out of a registry into a file, and out of the file into another repository: the same digest."""
    image = published("ros1-bookworm-core")
    page = ROOT / "docs/registry/networks.md"
    lines = [shlex.split(line) for block in section(page, "Air-gapped") for line in commands(block)]
    assert [words[:3] for words in lines] == [["regctl", "image", "export"], ["regctl", "image", "import"]]
    moved = f"{services.registry}/{NAMESPACE}/carried:over"
    places = (image.result["reference"], moved)
    for words, place in zip(lines, places, strict=True):
        regctl.regctl(services, *words[1:3], place, str(tmp_path / words[4]))
    assert regctl.digest(services, moved) == image.result["digest"]
