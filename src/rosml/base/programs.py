"""Versions of the programs that are built from source, as tools/go pins them, and digests of images, as tools/images.txt does."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

from rosml.base.errors import RosmlError


@dataclass(frozen=True)
class Pin:
    """What a go.mod says of its tool: the package to build (``.``: the main.go beside it) and the version of its module."""

    package: str
    version: str


def parse_pin(go_mod: str) -> Pin:
    """Reads a go.mod: with one ``tool`` line, or that of a program of our own, which requires one module directly.

    Raises:
        ValueError: neither says what to build, or the tool's module is not required.
    """
    required = re.findall(r"^(?:require)?\s+(\S+) (v\S+)( // indirect)?$", go_mod, re.MULTILINE)
    tool = re.search(r"^tool (\S+)$", go_mod, re.MULTILINE)
    if not tool:
        direct = [version for _module, version, indirect in required if not indirect]
        if len(direct) != 1:
            raise ValueError("no tool line, and not one module that is required directly")
        return Pin(".", direct[0])
    package = tool[1]
    modules = [
        (module, version)
        for module, version, _indirect in required
        if package == module or package.startswith(f"{module}/")
    ]
    if not modules:
        raise ValueError(f"no module provides {package}")
    return Pin(package, max(modules)[1])


def pinned_version(root: Path, program: str, failed: type[RosmlError]) -> str:
    """The version of a program that a checkout pins, such as `0.65.0`.

    Args:
        root: the checkout.
        program: such as `trivy`: a folder of tools/go.
        failed: the error to raise.

    Raises:
        RosmlError: it pins none; of the kind that was asked for.
    """
    file = root / "tools" / "go" / program / "go.mod"
    try:
        return parse_pin(file.read_text()).version.removeprefix("v")
    except OSError as error:
        raise failed(f"{file}: {error.strerror}", "call this in a checkout") from None
    except ValueError:
        raise failed(f"{file} pins no {program}", "restore the file") from None


def pinned_image(root: Path, name: str) -> str:
    """An image with the tag and the digest that a checkout pins.

    Args:
        root: the checkout.
        name: such as `moby/buildkit`.

    Raises:
        RosmlError: it pins none.
    """
    file = root / "tools" / "images.txt"
    try:
        found = re.search(rf"^{re.escape(name)}:\S+@sha256:[0-9a-f]{{64}}$", file.read_text(), re.MULTILINE)
    except OSError as error:
        raise RosmlError(f"{file}: {error.strerror}", "call this in a checkout") from None
    if not found:
        raise RosmlError(f"{file} pins no {name}", "restore the file")
    return found[0]
