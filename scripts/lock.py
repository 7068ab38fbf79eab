#!/usr/bin/env python3
"""`rosml locks`, from a checkout without a set-up of its own: src/rosml/cli/images/locks.py."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "src"))

from rosml.__main__ import run

if __name__ == "__main__":
    sys.exit(run("locks"))
