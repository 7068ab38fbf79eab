#!/usr/bin/env python3
"""A payload replaces no file of the distribution's or ROS's packages, and shadows no Python package that their tools
import, but for those that are named here with the reason."""

from __future__ import annotations

import fcntl
import os
import sys
from pathlib import Path

SHADOWED = {
    "numpy": "both frameworks need a newer one, within the ABI of the distribution's own",
    "typing_extensions": "pure Python, and newer ones keep what older ones had",
    "markupsafe": "needed by jinja2",
    "jinja2": "pure Python, and newer ones keep what older ones had",
    "pil": "a dependency of keras' pictures",
    "pygments": "pure Python; colours tracebacks",
    "sympy": "torch.compile needs it",
    "mpmath": "sympy needs it",
    "networkx": "torch.compile needs it",
    "filelock": "torch needs it",
    "fsspec": "torch needs it",
    "requests": "a dependency of tensorboard",
    "urllib3": "requests needs it",
    "idna": "requests needs it",
    "certifi": "requests needs it",
    "charset_normalizer": "requests needs it",
    "google": "protobuf: TensorFlow needs a newer one, for Python alone",
    "h5py": "keras needs it",
    "markdown": "tensorboard needs it",
    "rich": "keras needs it",
    "optree": "keras needs it",
    "mdurl": "rich needs it",
    "markdown_it": "rich needs it",
    "werkzeug": "tensorboard needs it",
}
NEVER = {"setuptools", "pkg_resources", "em", "empy", "yaml", "packaging", "catkin_pkg", "lark", "six", "wheel", "pip"}
"""What ROS's own tools import."""


def of_packages() -> set[str]:
    """Files of all Debian packages."""
    listings = Path("/var/lib/dpkg/info").glob("*.list")
    return {line for listing in listings for line in listing.read_text().splitlines()}


def replaced() -> list[str]:
    """Files of packages that a payload replaced: it has links to its own below /usr/local, and nothing else elsewhere."""
    return sorted(
        path for path in of_packages() if os.path.islink(path) and "/usr/local/lib/" in os.path.realpath(path)
    )


def modules(folder: Path) -> set[str]:
    """Top-level packages and modules of a folder."""
    names = {entry.name for entry in folder.iterdir()} if folder.is_dir() else set()
    return {
        name.split(".")[0].lower() for name in names if not name.endswith((".dist-info", ".egg-info", ".pth", ".libs"))
    }


# Not while pip_install.py changes Python's packages.
lock = open("/tmp/rosml-python-packages.lock", "w")  # noqa: SIM115 (held until this process ends)
fcntl.flock(lock, fcntl.LOCK_EX)
sites = [site for site in Path("/usr/local/lib").glob("python3*/dist-packages") if any(site.glob("*.dist-info"))]
assert sites, "no payload is here"
shadowed: set[str] = set()
for site in sites:
    shadowed |= modules(site) & (modules(Path("/usr/lib/python3/dist-packages")) | NEVER)
unexplained = sorted(shadowed - SHADOWED.keys() - {"__pycache__"})
print("shadowed:", *sorted(shadowed))
if replaced() or unexplained or shadowed & NEVER:
    sys.exit(f"replaced: {replaced()}\nshadowed without a reason: {unexplained}\nnever: {sorted(shadowed & NEVER)}")
