#!/usr/bin/env python3
"""Removes the ROS packages that a list names from a folder: manifests.py FOLDER LEFT_OUT"""

from __future__ import annotations

import os
import re
import shutil
import sys
from pathlib import Path
from typing import Any, NoReturn

from catkin_pkg.package import parse_package

IGNORED = {"COLCON_IGNORE", "CATKIN_IGNORE", "AMENT_IGNORE"}
"""Files that keep colcon from looking for packages in a folder."""

PROJECT = re.compile(r"""^[ \t]*project[ \t]*\([ \t]*"?([\w.+-]+)""", re.IGNORECASE | re.MULTILINE)
"""How a CMakeLists.txt names its package, as colcon reads it."""


def fail(message: str, remedy: str) -> NoReturn:
    sys.exit(f"error: {message}; {remedy}")


def _manifests(folder: Path) -> list[Path]:
    """The package.xml of all packages, as colcon finds them: none in an ignored folder, and none inside of another package. Of a folder
    in no package, the CMakeLists.txt. A folder behind a link counts once, unless the link leads out."""
    paths = []
    seen = set()
    top = os.path.realpath(folder)
    for path, folders, names in os.walk(folder, followlinks=True):
        real = os.path.realpath(path)
        if real in seen or not f"{real}/".startswith(f"{top}/"):
            folders.clear()
            continue
        seen.add(real)
        folders[:] = sorted(name for name in folders if not name.startswith("."))
        ignored = IGNORED & set(names)
        candidates = [name for name in ("package.xml", "CMakeLists.txt") if name in names and not ignored]
        paths += [Path(path, name) for name in candidates[:1]]
        if ignored or "package.xml" in names:
            folders.clear()
    return paths


def shown(place: Path) -> Path:
    """A place as the user knows it."""
    return place.relative_to("target") if place.parts[:1] == ("target",) else place


def _parsed(path: Path, name: Path) -> Any:
    """A manifest, as colcon reads it. catkin_pkg raises what it likes: AssertionError for `format="4"`, ValueError for "x"."""
    try:
        return parse_package(str(path))
    except UnicodeDecodeError:
        fail(f"{name} is not UTF-8, and colcon reads nothing else", "save it as UTF-8, and let its first line say so")
    except Exception as error:
        why = " ".join(str(error).replace(str(path), "").split()).strip(" :'")[:500]
        fail(f"{name} is no manifest: {why or type(error).__name__}", "correct it")


def all_packages(folder: Path) -> dict[str, tuple[Path, Any]]:
    """All packages by name: the place of each below the folder, and its manifest."""
    by_name: dict[str, tuple[Path, Any]] = {}
    for path in _manifests(folder):
        if path.name != "package.xml":
            continue
        place = path.parent.relative_to(folder)
        package = _parsed(path, shown(place) / path.name)
        if package.name in by_name:
            places = f"{shown(by_name[package.name][0])} and {shown(place)}"
            fail(f"two packages are called {package.name}: {places}", "put COLCON_IGNORE into one")
        by_name[package.name] = place, package
    return by_name


def plain(folder: Path) -> set[str]:
    """The names of packages without a manifest: colcon builds them, and before those that name them."""
    files = [path for path in _manifests(folder) if path.name != "package.xml" and path.is_file()]
    matches = (PROJECT.search(path.read_text("utf-8", "replace")) for path in files)
    return {match[1] for match in matches if match}


def packages(folder: Path, left_out: Path) -> list[tuple[Path, Any]]:
    """The packages that count, each with its place."""
    by_name = all_packages(folder)
    names = left_out.read_text().split()
    for name in names:
        if name not in by_name:  # a list may be older than the sources
            print(f"warning: no package is called {name}, which is to be left out", file=sys.stderr)
    counting = [by_name[name] for name in by_name if name not in names]
    if not any(place.parts[:1] != ("downstream",) for place, _package in counting):
        fail("there is no package left to build", "leave fewer out")
    return counting


def main(folder: Path, left_out: Path) -> None:
    kept = {place for place, _package in packages(folder, left_out)}
    for place, _package in all_packages(folder).values():
        if place in kept:
            continue
        if (folder / place).is_symlink():
            (folder / place).unlink()
        elif len(place.parts) > 1:
            shutil.rmtree(folder / place)
        else:  # the repository itself is the package, and src/target stays
            for path in (folder / place).iterdir():
                if path.is_dir() and not path.is_symlink():
                    shutil.rmtree(path)
                else:
                    path.unlink()


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))
