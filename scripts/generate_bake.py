#!/usr/bin/env python3
"""Runs `rosml generate` in a checkout without its own setup: src/rosml/cli/images/generate.py."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "src"))

from rosml.__main__ import run

if __name__ == "__main__":
    sys.exit(run("generate"))
