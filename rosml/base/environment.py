"""Imported first by every command: says how to call it where the packages that it needs are not installed."""

from __future__ import annotations

import importlib.util
import sys
from pathlib import Path

REQUIRED = ("click", "httpx", "pydantic", "rich", "yaml")
"""What pyproject.toml asks for, as it is imported; some of it is imported late, in the middle of the work."""


def program() -> str:
    """How this process was called: `publish.py`, or `python -m bench`."""
    called = Path(sys.argv[0])
    return f"python -m {called.parent.name}" if called.name == "__main__.py" else called.name


if lacking := [name for name in REQUIRED if importlib.util.find_spec(name) is None]:
    where = program() if program().startswith("python") else f"scripts/{program()}"
    print(
        f"error: not installed: {', '.join(lacking)}\n"
        f"remedy: python3 scripts/bootstrap.py tools --python, then uv run {where}",
        file=sys.stderr,
    )
    sys.exit(2)
