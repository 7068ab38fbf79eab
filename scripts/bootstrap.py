#!/usr/bin/env python3
"""Sets this machine up: tools, local registry, builder. Needs nothing but Python; what it makes is in .state."""

from __future__ import annotations

import sys
from pathlib import Path

if sys.version_info < (3, 9):  # noqa: UP036 (an old one may well call this)
    sys.exit("error: this needs Python 3.9 or newer, and this is {}.{}".format(*sys.version_info[:2]))

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tools"))

from machine import commands  # noqa: E402

if __name__ == "__main__":
    sys.exit(commands.main(ROOT, sys.argv[1:]))
