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
from tests.e2e.conftest import NAMESPACE, Published, run
from tests.e2e.images import Publish, build
from tests.pages import SHELLS, Block, blocks, commands

TENSORFLOW = "ros1-bookworm-core-tensorflow-cpu"
CPP = ROOT / "docs/cpp.md"
NODES = ROOT / "docs/cpp/nodes.md"


def section(page: Path, name: str) -> Iterator[Block]:
    found = [block for block in blocks(page) if block.section == name]
    assert found, f"{page.name} has no section {name!r} with code"
    return iter(found)


def example(services: Services, image: Published, folder: Path, name: str) -> str:
    """Writes the files of a section, runs its commands in them, and looks for what it says they print."""
    (folder / "files").mkdir()
    steps, printed = [], []
    for block in section(CPP, name):
        if block.title:
            (folder / "files" / block.title).write_text(block.text)
        elif block.language in SHELLS:
            steps += list(commands(block))
        elif block.language == "text":
            printed += block.text.splitlines()
    assert steps and printed
    script = "\n".join(["#!/bin/bash", "set -euxo pipefail", "cd /example/files", *steps, ""])
    (folder / "files/steps.sh").write_text(script)
    (folder / "files/steps.sh").chmod(0o755)
    lines = [f"FROM {image.result['reference']}", "COPY files /example/files"]
    lines += ["RUN --network=none env -u LD_LIBRARY_PATH /example/files/steps.sh"]
    (folder / "Dockerfile").write_text("\n".join(lines) + "\n")
    said = build(services, folder)
    for line in printed:
        assert re.search(rf"^#\d+ [\d.]+ {re.escape(line)}$", said, re.MULTILINE), f"{line!r} was not printed:\n{said}"
    return said


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
    (folder / "src").mkdir(parents=True)
    (folder / "CMakeLists.txt").write_text(NODE + snippet.text)
    (folder / "src/detector.cpp").write_text(DETECTOR)
    steps = "/entrypoint.sh cmake -S /node -B /node/build && cmake --build /node/build && find /node/build -type f -perm -100 -name detector -exec {} \\;"
    (folder / "Dockerfile").write_text(
        f"FROM {image.result['reference']}\nCOPY . /node\nRUN --network=none env -u LD_LIBRARY_PATH bash -euc '{steps}'\n"
    )
    said = build(services, folder)
    assert re.search(r"^#\d+ [\d.]+ cpu after 2 s$", said, re.MULTILINE), said


@pytest.mark.full(proof="cuda")
def test_cplusplus_with_pytorch(services: Services, published: Publish, tmp_path: Path) -> None:
    image = published("ros1-bookworm-core-torch-cu128")
    (tmp_path / "example").mkdir()
    example(services, image, tmp_path / "example", "PyTorch")
    node(services, image, tmp_path / "node")


def test_cplusplus_with_tensorflow(services: Services, published: Publish, tmp_path: Path) -> None:
    """By CMake and by hand."""
    image = published(TENSORFLOW)
    said = example(services, image, tmp_path, "TensorFlow")
    assert re.search(rf"^#\d+ [\d.]+ {re.escape(image.image.versions['tensorflow'])}$", said, re.MULTILINE)


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
        job = job["jobs"]
        steps = [step["run"] for step in job["test"]["steps"] if "run" in step]
        environment = job["test"]["env"]
    else:
        steps, environment = job["test"]["script"], job["test"]["variables"]
    assert len(steps) == 3
    source = tmp_path / "checkout"
    source.mkdir()
    (source / "package.xml").write_text(PACKAGE)
    (source / "CMakeLists.txt").write_text(CMAKE)
    (source / "test_example.py").write_text(TEST)
    exported = " ".join(f"{key}={shlex.quote(value)}" for key, value in environment.items())
    image = published("ros1-bookworm-core")
    lines = [f"FROM {image.result['reference']}", "COPY checkout /checkout", "WORKDIR /checkout"]
    lines += [f"RUN --network=none export {exported} && {step}" for step in steps]
    (tmp_path / "Dockerfile").write_text("\n".join(lines) + "\n")
    said = build(services, tmp_path)
    assert "Finished <<< example" in said
    assert re.search(r"Summary: [1-9]\d* tests?, 0 errors, 0 failures", said), said


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
        context = tmp_path / name
        context.mkdir()
        first, rest = text.split("\n", 1)
        assert first.startswith("FROM <registry>/ros-torch:")
        for file, content in {
            "package.xml": USED,
            "CMakeLists.txt": USED_CMAKE,
            "detector.py": "#!/usr/bin/env python3\nprint('it detects')\n",
        }.items():
            (context / file).write_text(content)
        (context / "detector.py").chmod(0o755)
        command = re.search(r"^CMD (\[.*\])$", rest, re.MULTILINE)
        last = (
            f"RUN /entrypoint.sh {shlex.join(json.loads(command[1]))}"
            if command
            else "USER dev\nRUN touch /docker-ros/ws/mine && id -nG && bash -ic 'rospack find rospy'"
        )
        (context / "Dockerfile").write_text(f"FROM {image}\n{rest}{last}\n")
        said = build(services, context)
        wanted = r"it detects" if command else r"dev .*\bvideo\b"
        assert re.search(rf"^#\d+ [\d.]+ {wanted}", said, re.MULTILINE), said


def test_parts_are_compared(services: Services) -> None:
    """The commands of the page about reproducibility, in the tests' namespaces, and without `--again`: a part that is
    assembled without the builder's cache is tests/e2e/test_tensorflow.py's."""
    steps = [
        command
        for block in section(ROOT / "docs/reproducibility.md", "Check it yourself")
        for command in commands(block)
        if command.startswith(("./rosml ", "regctl "))
    ]
    again = f"{NAMESPACE}-again"
    for step, (old, new) in zip(
        steps,
        [
            ("part ", f"part --namespace {NAMESPACE} "),
            ("--again --namespace again", f"--namespace {again}"),
            ("<host>/rosml/", f"<host>/{NAMESPACE}/"),
        ],
        strict=True,
    ):
        assert old in step
        command = step.replace(old, new).replace("<host>/again/", f"<host>/{again}/")
        argv = shlex.split(command.replace("<host>", services.registry))
        if argv[0] == "./rosml":
            argv[0] = str(ROOT / "rosml")
        if argv[0] == "regctl":
            argv[:1] = [regctl.program(services), "--host", f"reg={services.registry},tls=disabled"]
        done = run(*argv, env={"PATH": f"{Path(services.uv).parent}:{os.environ['PATH']}"})
        assert done.code == 0, done.err
    assert done.out.strip() == "", "they differ"


def test_an_image_is_carried_over(services: Services, published: Publish, tmp_path: Path) -> None:
    """Out of a registry into a file, and out of the file into another repository: the same digest."""
    image = published("ros1-bookworm-core")
    found = [
        command for block in section(ROOT / "docs/registry/networks.md", "Air-gapped") for command in commands(block)
    ]
    assert [command.split()[:3] for command in found] == [["regctl", "image", "export"], ["regctl", "image", "import"]]
    moved = f"{services.registry}/{NAMESPACE}/carried:over"
    places = (image.result["reference"], moved)
    for command, place in zip(found, places, strict=True):
        words = shlex.split(command)
        done = run(
            regctl.program(services),
            "--host",
            f"reg={services.registry},tls=disabled",
            *words[1:3],
            place,
            str(tmp_path / words[4]),
            env=services.environment(),
        )
        assert done.code == 0, done.err
    assert regctl.digest(services, moved) == image.result["digest"]
