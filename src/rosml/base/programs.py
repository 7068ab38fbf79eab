"""Pins: versions of the programs that we build from source, in tools/go, and digests of images, in tools/images.txt."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

from rosml.base.errors import RosmlError


@dataclass(frozen=True)
class Pin:
    """The tool of a go.mod: the package to build (``.``: the main.go beside it) and the version of its module."""

    package: str
    version: str


def parse_pin(go_mod: str) -> Pin:
    """Reads a go.mod. It has one ``tool`` line; that of our own programs requires one module directly instead. Raises ValueError."""
    required = re.findall(r"^(?:require)?\s+(\S+) (v\S+)( // indirect)?$", go_mod, re.MULTILINE)
    tool = re.search(r"^tool (\S+)$", go_mod, re.MULTILINE)
    if not tool:
        direct = [version for _module, version, indirect in required if not indirect]
        if len(direct) != 1:
            raise ValueError("no tool line, and not one module that is required directly")
        return Pin(".", direct[0])
    package = tool[1]
    modules = [(module, version) for module, version, _ in required if f"{package}/".startswith(f"{module}/")]
    if not modules:
        raise ValueError(f"no module provides {package}")
    return Pin(package, max(modules)[1])


def pinned_version(root: Path, program: str, failed: type[RosmlError]) -> str:
    """The version of a program, such as `0.65.0`, that a checkout pins in a folder of tools/go. The error is of the class `failed`."""
    file = root / "tools" / "go" / program / "go.mod"
    try:
        return parse_pin(file.read_text()).version.removeprefix("v")
    except OSError as error:
        raise failed(f"{file}: {error.strerror}", "call this in a checkout") from None
    except ValueError:
        raise failed(f"{file} pins no {program}", "restore the file") from None


def pinned_image(root: Path, name: str) -> str:
    """The reference of an image such as `moby/buildkit`, with the tag and the digest that a checkout pins."""
    file = root / "tools" / "images.txt"
    try:
        match = re.search(rf"^{re.escape(name)}:\S+@sha256:[0-9a-f]{{64}}$", file.read_text(), re.MULTILINE)
    except OSError as error:
        raise RosmlError(f"{file}: {error.strerror}", "call this in a checkout") from None
    if not match:
        raise RosmlError(f"{file} pins no {name}", "restore the file")
    return match[0]
