#!/usr/bin/env python3
"""`rosml join`, from a checkout without a set-up of its own: rosml/cli/join.py."""

from __future__ import annotations

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

import rosml.base.environment  # noqa: F401 (first: says what to do where the others are missing)

# isort: split

from rosml.cli import command, join

if __name__ == "__main__":
    sys.exit(command.ended(command.run(join.main, join.KEPT)))
