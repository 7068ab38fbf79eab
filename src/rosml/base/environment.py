"""Every command imports this first: if a Python package is missing, it says how to call the command."""

from __future__ import annotations

import importlib.util
import sys
from pathlib import Path

RUN = ("click", "yaml")
"""The modules of the packages that pyproject.toml requires. We check all at once, as some are imported late in the work."""

ZSTD = "compression.zstd" if sys.version_info >= (3, 14) else "backports.zstd"
"""Python has it itself since 3.14."""

IMAGES = (ZSTD, "cyclonedx", "httpx", "msgspec", "packageurl", "packaging", "pydantic", "rich")
"""The modules that all commands need, except `rosml run` and `rosml attach`."""


def program() -> str:
    """The name by which this process was called: `rosml`, `publish.py`, or `python -m bench`."""
    called = Path(sys.argv[0])
    if called.parent.name == "rosml" or called.name == "src":
        return "rosml"
    return f"python -m {called.parent.name}" if called.name == "__main__.py" else called.name


def _lacks(module: str) -> bool:
    try:
        return importlib.util.find_spec(module) is None
    except ModuleNotFoundError:  # its package
        return True


LACKING = tuple(name for name in (*RUN, *IMAGES) if _lacks(name))
"""The missing modules. Outside of a checkout, `rosml run` and `rosml attach` do without some of them."""

if LACKING and (Path(sys.argv[0]).name != "rosml" or {*LACKING} & {*RUN}):
    remedy = (
        "rm -r .venv, then call it again"
        if program() == "rosml"
        else "run this with .venv/bin/python; ./rosml makes it"
    )
    print(f"error: not installed: {', '.join(LACKING)}\nremedy: {remedy}", file=sys.stderr)
    sys.exit(2)
