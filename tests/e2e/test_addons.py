"""Add-ons for real: the image that tests one, and an app whose base image gets it in its build and in a rebase."""

from __future__ import annotations

import json
from pathlib import Path

from rosml.machine.services import Services
from tests.e2e.app_builds import BASE, build_app, package
from tests.e2e.calls import NAMESPACE, rosml
from tests.e2e.images import PLATFORM, Publish, config

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
    trial, base = published(TRIAL), published(BASE).reference
    assert trial.image.tags == () and trial.result["passed"] > 10 and trial.result["failed"] == 0
    place = f"{services.registry}/{NAMESPACE}"
    parts = [f"{place}/part:{name}" for name in PARTS]
    joined = rosml("join", base, *parts, "--tag", f"{place}/joined:latest", "--platform", PLATFORM, "--json")
    report = json.loads(joined.out)
    assert report["seconds"] < 10 and report["uploaded"] < 10_000, "thresholds of seconds are the bench's"

    files = {"CMakeLists.txt": CMAKE, "ask": NODE, "test.py": TEST}
    folder = package(tmp_path / "asker", "<test_depend>rosunit</test_depend>", files=files)
    options = {"base-image": base, "addons": "triton-cpu", "command": "rosrun asker ask", "target": "run"}
    options |= {"image-name": f"{place}/asker", "push": "true"}
    result = build_app(folder, options, "--lock")
    assert result["tests"]["count"] == 1
    labels = config(services, f"{place}/asker:latest")["Labels"]
    assert labels["io.rosml.addons"] == "triton" and labels["io.rosml.stack"] == "cpu"
    assert labels["org.opencontainers.image.base.name"] == base
    lock = json.loads((folder / "containerize.lock").read_text())
    assert {key.rpartition(":")[2] for key in lock["addons"]} == {*PARTS}
    again = build_app(folder, options)
    assert again["run"]["digest"] == result["run"]["digest"], "from the lock file, the same"
