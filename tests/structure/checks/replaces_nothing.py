#!/usr/bin/env python3
"""A part replaces no file of the distribution's or ROS's packages, and neither shadows nor is shadowed by a Python
package of theirs, but for those that are named here with the reason; it hides no command of theirs, but for those that
such a package brings."""

from __future__ import annotations

import os
import re
import sys
from pathlib import Path

SHADOWED = {
    "numpy": "both frameworks need a newer one, within the ABI of the distribution's own",
    "typing_extensions": "pure Python, and newer ones keep what older ones had",
    "markupsafe": "needed by jinja2",
    "jinja2": "pure Python, and newer ones keep what older ones had",
    "pil": "torchvision and keras need it for pictures",
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
"""What ROS's own tools import. pip is the base's, if a part has none (components/base/pip.sh)."""

ROOT = Path(os.environ.get("CHECK_ROOT", "/"))
LOCAL = ROOT / "usr/local"
OF_THE_SYSTEM = ("usr/bin", "usr/sbin", "bin", "sbin", "opt/ros/*/bin")


def of_packages() -> set[str]:
    """Files of all Debian packages."""
    listings = (ROOT / "var/lib/dpkg/info").glob("*.list")
    return {line for listing in listings for line in listing.read_text().splitlines()}


def replaced() -> list[str]:
    """Files of packages that a part replaced: it has links to its own below /usr/local, and nothing else elsewhere."""
    places = {path: ROOT / path.lstrip("/") for path in of_packages()}
    parts_folder = f"{LOCAL.resolve()}/lib/"
    return sorted(
        path for path, file in places.items() if file.is_symlink() and os.path.realpath(file).startswith(parts_folder)
    )


def modules(folder: Path) -> set[str]:
    """Top-level packages and modules of a folder."""
    names = {entry.name for entry in folder.iterdir()} if folder.is_dir() else set()
    return {
        name.split(".")[0].lower() for name in names if not name.endswith((".dist-info", ".egg-info", ".pth", ".libs"))
    } - {"__pycache__"}


def hidden_commands() -> dict[str, set[str]]:
    """Commands of the part that come before others of the same name, with the modules that they import."""
    folders = [folder for pattern in OF_THE_SYSTEM for folder in ROOT.glob(pattern)]
    return {
        command.name: {
            name.lower() for name in re.findall(r"^(?:from|import) (\w+)", command.read_text(errors="replace"), re.M)
        }
        for command in LOCAL.glob("bin/*")
        if any((folder / command.name).exists() for folder in folders)
    }


sites = [site for site in LOCAL.glob("lib/python3*/dist-packages") if any(site.glob("*.dist-info"))]
assert sites, "no part is here"
# Debian's own, and ROS's, which the entrypoint puts before all others.
theirs = [ROOT / "usr/lib/python3/dist-packages", *ROOT.glob("opt/ros/*/lib/python3*/*-packages")]
theirs += ROOT.glob("opt/ros/*/local/lib/python3*/*-packages")
versions = [file.read_text() for file in (LOCAL / "share/rosml/versions.d").glob("*")]
of_base = {"pip"} - {line.split()[0] for text in versions for line in text.splitlines()}
others = NEVER.union(*map(modules, theirs)) - of_base
shadowed = {name for site in sites for name in modules(site) & others}
unexplained = sorted(shadowed - SHADOWED.keys())
hidden = {name: imports for name, imports in hidden_commands().items() if not imports & (SHADOWED.keys() | of_base)}
print("shadowed:", *sorted(shadowed))
if replaced() or unexplained or shadowed & NEVER or hidden:
    sys.exit(
        f"replaced: {replaced()}\nshadowed without a reason: {unexplained}\nnever: {sorted(shadowed & NEVER)}\n"
        f"commands hidden: {sorted(hidden)}"
    )
