"""Add-ons for real: the image that tests one, and an app whose base image gets it in its build and in a rebase."""

from __future__ import annotations

import json
import sys
from pathlib import Path

from rosml import ROOT
from rosml.machine.services import Services
from tests.e2e.conftest import NAMESPACE, run
from tests.e2e.images import PLATFORM, Publish
from tests.e2e.test_containerize import BASE, PACKAGE, config, made

TRIAL = "ros1-bookworm-core-triton-cpu"
PARTS = ("common-cpu-py311", "grpc-cpu-py311", "tritonclient-cpu-py311")
CMAKE = """cmake_minimum_required(VERSION 3.16)
project(asker)
find_package(catkin REQUIRED)
catkin_package()
catkin_install_python(PROGRAMS ask DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
if(CATKIN_ENABLE_TESTING)
  catkin_add_nosetests(test.py)
endif()
"""
NODE = """#!/usr/bin/env python3
import rospy
import tritonclient.grpc as triton
print("asks with", triton.InferInput("x", [1], "FP32").name())
"""
TEST = "import unittest\nclass T(unittest.TestCase):\n    def test_it(self):\n        import tritonclient.grpc\n"


def test_an_app_gets_an_addon_and_keeps_it(published: Publish, services: Services, tmp_path: Path) -> None:
    trial, base = published(TRIAL), published(BASE)
    assert trial.image.tags == () and trial.result["passed"] > 10 and trial.result["failed"] == 0
    place = trial.reference.partition("@")[0].rpartition("/")[0]
    joined = f"{place}/joined:latest"
    command = [sys.executable, str(ROOT / "src"), "join", base.reference, *(f"{place}/part:{name}" for name in PARTS)]
    outcome = run(*command, "--tag", joined, "--platform", PLATFORM, "--json")
    assert outcome.code == 0, outcome.err
    said = json.loads(outcome.out)
    assert said["seconds"] < 10 and said["uploaded"] < 10_000, "thresholds of seconds are the bench's"

    folder = tmp_path / "asker"
    folder.mkdir()
    for name, text in {
        "package.xml": PACKAGE.format("asker", "<test_depend>rosunit</test_depend>"),
        "CMakeLists.txt": CMAKE,
        "ask": NODE,
        "test.py": TEST,
    }.items():
        (folder / name).write_text(text)
    (folder / "ask").chmod(0o755)
    name = f"{services.registry}/{NAMESPACE}/asker"
    options = (
        "--base-image",
        base.reference,
        "--addons",
        "triton-cpu",
        "--command",
        "rosrun asker ask",
        "--target",
        "run",
    )
    found = made(folder, *options, "--image-name", name, "--push", "--lock")
    assert found["tests"]["count"] == 1
    labels = config(services, f"{name}:latest")["config"]["Labels"]
    assert labels["io.rosml.addons"] == "triton" and labels["io.rosml.stack"] == "cpu"
    assert labels["org.opencontainers.image.base.name"] == base.reference
    lock = json.loads((folder / "containerize.lock").read_text())
    assert {key.rpartition(":")[2] for key in lock["addons"]} == {*PARTS}
    again = made(folder, *options, "--image-name", name, "--push")
    assert again["run"]["digest"] == found["run"]["digest"], "from the lock file, the same"
