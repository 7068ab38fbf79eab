"""Imported first by every command: says how to call it where the packages that it needs are not installed."""

from __future__ import annotations

import importlib.util
import sys
from pathlib import Path

REQUIRED = ("click", "httpx", "pydantic", "rich", "yaml")
"""What pyproject.toml asks for, as it is imported; some of it is imported late, in the middle of the work."""


def program() -> str:
    """How this process was called: `rosml`, `publish.py`, or `python -m bench`."""
    called = Path(sys.argv[0])
    if called.parent.name == "rosml" or called.name == "src":
        return "rosml"
    return f"python -m {called.parent.name}" if called.name == "__main__.py" else called.name


if lacking := [name for name in REQUIRED if importlib.util.find_spec(name) is None]:
    remedy = (
        "rm -r .venv, then call it again"
        if program() == "rosml"
        else "run this with .venv/bin/python; ./rosml makes it"
    )
    print(f"error: not installed: {', '.join(lacking)}\nremedy: {remedy}", file=sys.stderr)
    sys.exit(2)
