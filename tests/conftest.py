"""The tests find the same environment under `make test` as by themselves: a make that a test calls is not a sub-make."""

from __future__ import annotations

import os

for name in ("MAKELEVEL", "MAKEFLAGS", "MFLAGS"):
    os.environ.pop(name, None)
