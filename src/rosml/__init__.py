"""ROS images with machine learning, images of people's own packages, and containers of both. See docs/architecture.md."""

from __future__ import annotations

import os
from pathlib import Path

__version__ = "0.1.0"


def root_of(package: Path) -> Path:
    """The checkout that the package is in, or what was installed with the package. The current folder may be a stranger's, and does not count."""
    in_checkout = package.parent.name == "src" and (package.parents[1] / "scripts/bootstrap.py").is_file()
    return package.parents[1] if in_checkout else package / "data"


def user_cache() -> Path:
    """The user's folder for what may get lost and what checkouts share; a temporary one for a user without a home folder."""
    variable = Path(os.environ.get("XDG_CACHE_HOME", ""))
    try:
        return (variable if variable.is_absolute() else Path.home() / ".cache") / "rosml"
    except RuntimeError:
        import tempfile  # only needed here, and every command waits for it

        return Path(tempfile.gettempdir()) / f"rosml-{os.geteuid()}"


_PACKAGE = Path(__file__).resolve().parent

ROOT = root_of(_PACKAGE)
"""The project's root: the folder of `matrix.yaml`, `Dockerfile` and `components/`."""


def matrix_of(root: Path) -> Path:
    """`set.yaml` of a user's set, or `matrix.yaml`. A set's command has a link to its `set.yaml`: messages name the file that people edit."""
    set_file = root / "set.yaml"
    return set_file.resolve() if set_file.is_file() else root / "matrix.yaml"


def own_of(root: Path) -> Path:
    """The folder of the files that the user keeps: that of a set's `set.yaml`, which has its rosml in a folder below it; or the root."""
    return matrix_of(root).parent


MATRIX = ROOT / os.environ["ROSML_MATRIX"] if os.environ.get("ROSML_MATRIX") else matrix_of(ROOT)
"""What commands read if no option names another file. ROSML_MATRIX is relative to the root."""

IN_CHECKOUT = ROOT != _PACKAGE / "data"
"""Whether images can be built here."""

STATE = ROOT / ".state" if IN_CHECKOUT else user_cache()
"""What commands keep: `.state` of the checkout; the user's cache where there is no checkout."""
