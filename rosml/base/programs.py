"""Versions of the programs that are built from source, as tools/go pins them."""

from __future__ import annotations

import re
from pathlib import Path

from rosml.base.errors import RosmlError


def pinned_version(root: Path, program: str, failed: type[RosmlError]) -> str:
    """The version of a program that a checkout pins.

    Args:
        root: the checkout.
        program: such as `trivy`: a folder of tools/go, and the last part of its Go module's name.
        failed: the error to raise.

    Raises:
        RosmlError: it pins none; of the kind that was asked for.
    """
    file = root / "tools" / "go" / program / "go.mod"
    try:
        found = re.search(rf"^\s*github\.com/[^/\s]+/{program}(?:/v\d+)? v(\S+)", file.read_text(), re.MULTILINE)
    except OSError as error:
        raise failed(f"{file}: {error.strerror}", "call this in a checkout") from None
    if not found:
        raise failed(f"{file} pins no {program}", "restore the file")
    return found[1]
