"""The library behind the commands: packages with one noun each and one direction of imports, which `lint-imports` holds.

From the top: cli; apps; publish, catalogue; build, scan; join; records; machine, locks; registry, bake; images; matrix, run; base.
Each imports from those below it alone. docs/architecture.md walks through them.
"""

from __future__ import annotations

import os
import tempfile
from pathlib import Path

__version__ = "0.1.0"

PARTS = ("matrix.yaml", "Dockerfile", "components", "scripts/bootstrap.py")
"""What a checkout is known by."""


def root_of(package: Path) -> Path:
    """The checkout that the package is in; else that in which somebody works; else what was installed with the package."""
    if _own(package):
        return package.parents[1]
    return next((folder for folder in _around() if _is_checkout(folder) and _is_trusted(folder)), package / "data")


def passed_over(package: Path) -> Path | None:
    """The checkout in which somebody works that is another user's, and therefore not the package's root; None if there is
    none."""
    if _own(package):
        return None
    nearest = next(filter(_is_checkout, _around()), None)
    return None if nearest is None or _is_trusted(nearest) else nearest


def _own(package: Path) -> bool:
    """Whether a package is in the folder `src` of a checkout."""
    return (package.parents[1] / "scripts/bootstrap.py").is_file()


def _around() -> list[Path]:
    """The current folder and those above it; none where it was removed, or is not to be entered."""
    try:
        here = Path.cwd()
    except OSError:
        return []
    return [here, *here.parents]


def _is_checkout(folder: Path) -> bool:
    """Whether a folder is a checkout."""
    try:
        return all((folder / name).exists() for name in PARTS)
    except OSError:
        return False


def _is_trusted(folder: Path) -> bool:
    """Whether a folder is this user's or root's: programs of a checkout are called."""
    try:
        return folder.stat().st_uid in {os.geteuid(), 0, int(os.environ.get("SUDO_UID") or 0)}
    except (OSError, ValueError):
        return False


def _cache() -> Path:
    """The user's folder for what may get lost; a temporary one for a user who has none."""
    named = Path(os.environ.get("XDG_CACHE_HOME", ""))
    try:
        return (named if named.is_absolute() else Path.home() / ".cache") / "rosml"
    except RuntimeError:
        return Path(tempfile.gettempdir()) / f"rosml-{os.geteuid()}"


_PACKAGE = Path(__file__).resolve().parent

ROOT = root_of(_PACKAGE)
"""The project's root: the folder of `matrix.yaml`, `Dockerfile` and `components/`."""

IN_CHECKOUT = ROOT != _PACKAGE / "data"
"""Whether that is a checkout, in which images can be built."""

FOREIGN = passed_over(_PACKAGE)
"""The checkout of another user in which somebody works, and which is not used; None if there is none."""

STATE = ROOT / ".state" if IN_CHECKOUT else _cache()
"""What commands keep: `.state` of the checkout; the user's cache where there is no checkout."""
