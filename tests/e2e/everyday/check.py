#!/usr/bin/env python3
"""What users install next, into an image with frameworks and cv_bridge, by pip and uv as they come.

  check.py PACKAGE...   installs them, upgrades them, installs and upgrades them with uv

No package that the image's parts pin changes, no command downloads more than 500 MB, and all of it is imported in one process
with rospy and cv_bridge.
"""

from __future__ import annotations

import importlib
import json
import re
import subprocess
import sys
from pathlib import Path

LIMIT = 500.0
"""Megabytes that a command may download."""

MODULES = {
    "opencv-python": "cv2",
    "scikit-learn": "sklearn",
    "tf-keras": "tf_keras",
    "tensorflow-hub": "tensorflow_hub",
}
"""What is imported by another name than it is installed by."""

UNITS = {"kB": 1e-3, "MB": 1.0, "GB": 1e3, "KiB": 1.024e-3, "MiB": 1.048576, "GiB": 1073.741824}
SLOTS = Path("/usr/local/share/rosml/constraints.d")
UV = "/tmp/everyday/bin/uv"


def run(*command: str) -> str:
    """Runs a command that must succeed, and shows and returns what it says."""
    print("+", *command, flush=True)
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    print(done.stdout, flush=True)
    assert done.returncode == 0, command
    return done.stdout


def versions() -> dict[str, str]:
    """What a new Python finds, by the names that pip compares."""
    code = (
        "import importlib.metadata as m, json, re\n"
        "found = {}\n"
        "for d in m.distributions(): found.setdefault(re.sub('[-_.]+', '-', d.metadata['Name']).lower(), d.version)\n"
        "print(json.dumps(found))"
    )
    return dict(json.loads(subprocess.run([sys.executable, "-c", code], stdout=subprocess.PIPE, check=True).stdout))


def pinned() -> dict[str, str]:
    """What keeps its version, as the parts say."""
    lines = [line for slot in SLOTS.glob("[0-9]*.txt") for line in slot.read_text().splitlines()]
    return dict(match.groups() for line in lines if (match := re.fullmatch(r"([a-z0-9-]+)==([^;]+)", line)))


def downloaded(output: str) -> float:
    """Megabytes that pip or uv output to download; uv is silent about small ones."""
    sizes = re.findall(r"Downloading \S+ \(([0-9.]+) ?([kKMG]i?B)\)", output)
    return sum(float(size) * UNITS[unit] for size, unit in sizes)


def install(before: dict[str, str], *command: str) -> None:
    """Installs, and compares what the parts hold."""
    amount = downloaded(run(*command))
    after = versions()
    changed = {name: (version, after.get(name)) for name, version in before.items() if after.get(name) != version}
    assert not changed, (command, changed)
    assert amount < LIMIT, (command, amount)
    print(f"everyday: {amount:.0f} MB by {' '.join(command[:3])}", flush=True)


def together(packages: list[str]) -> None:
    """ROS, cv_bridge, the frameworks and all that was installed, in this process."""
    import cv_bridge
    import numpy
    import rospy

    importlib.invalidate_caches()
    for name in packages:
        module = importlib.import_module(MODULES.get(name, name))
        print("imported", name, getattr(module, "__version__", ""), flush=True)
    picture = numpy.zeros((4, 4, 3), numpy.uint8)
    bridge = cv_bridge.CvBridge()
    assert bridge.imgmsg_to_cv2(bridge.cv2_to_imgmsg(picture, "bgr8")).shape == picture.shape
    assert rospy.Time(1).to_sec() == 1.0


def main(*packages: str) -> None:
    """Installs packages in every way, then uses them."""
    before = pinned()
    assert before and before.items() <= versions().items()
    pip = [sys.executable, "-m", "pip", "install", "--no-cache-dir", "--progress-bar", "off"]
    # The largest wheel of all by itself: it has 400 MB.
    large = [name for name in packages if name == "open3d"]
    for names in filter(None, ([name for name in packages if name not in large], large)):
        install(before, *pip, *names)
    install(before, *pip, "--upgrade", *packages)
    run(*pip, "--target", "/tmp/everyday", "uv")
    uv = [UV, "pip", "install", "--no-cache"]
    for options in ([], ["--upgrade"]):
        install(before, *uv, *options, *packages)
    frameworks = [name for name in ("torch", "tensorflow") if name in before]
    together([*frameworks, *packages])
    print("everyday: done")


if __name__ == "__main__":
    main(*sys.argv[1:])
