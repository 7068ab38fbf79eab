"""Imported first by every command: says how to call it where the packages that it needs are not installed."""

from __future__ import annotations

import importlib.util
import sys
from pathlib import Path

RUN = ("click", "yaml")
"""What pyproject.toml asks for, as it is imported; some of it is imported late, in the middle of the work."""

IMAGES = ("httpx", "packageurl", "pydantic", "rich")
"""What all commands but `rosml run` and `rosml attach` need as well: the extra `images` of pyproject.toml."""


def program() -> str:
    """How this process was called: `rosml`, `publish.py`, or `python -m bench`."""
    called = Path(sys.argv[0])
    if called.parent.name == "rosml" or called.name == "src":
        return "rosml"
    return f"python -m {called.parent.name}" if called.name == "__main__.py" else called.name


LACKING = tuple(name for name in (*RUN, *IMAGES) if importlib.util.find_spec(name) is None)
"""What is not installed. Outside of a checkout, `rosml` goes without the extra."""

if LACKING and (Path(sys.argv[0]).name != "rosml" or {*LACKING} & {*RUN}):
    remedy = (
        "rm -r .venv, then call it again"
        if program() == "rosml"
        else "run this with .venv/bin/python; ./rosml makes it"
    )
    print(f"error: not installed: {', '.join(LACKING)}\nremedy: {remedy}", file=sys.stderr)
    sys.exit(2)
