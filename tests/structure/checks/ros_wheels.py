#!/usr/bin/env python3
"""ROS's wheels are those that the matrix names, and `pip check` has nothing to say about them."""

import os
import subprocess
import sys
from importlib.metadata import version

for pin in os.environ["EXPECT_WHEELS"].split(","):
    name, _, promised = pin.partition("==")
    assert version(name) == promised, f"{name} {version(name)}, expected {promised}"
complaints = subprocess.run(["pip", "check"], capture_output=True, text=True, check=False).stdout.splitlines()
ours = [line for line in complaints if line.startswith(("ros-", "lark"))]
print("\n".join(complaints))
sys.exit("\n".join(["complaints about ROS's wheels:", *ours]) if ours else 0)
