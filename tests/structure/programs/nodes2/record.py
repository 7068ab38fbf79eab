"""The words of `ros2 bag record`, which are others in each generation of rosbag2."""

from __future__ import annotations

import re
import subprocess


def topics(*names: str) -> list[str]:
    """Words that name topics: an option from jazzy on, and nothing else from lyrical on (rosbag2#1632, rosbag2#2328)."""
    done = subprocess.run(["ros2", "bag", "record", "--help"], capture_output=True, text=True, timeout=60)
    return [*(["--topics"] if re.search(r"^ +--topics\b", done.stdout, re.MULTILINE) else []), *names]
