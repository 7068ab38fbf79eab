"""Base images by digest: those that matrix.yaml names, or others that this machine was told to take in their place.

A variable names another one: `OS_BOOKWORM=registry.example.com/debian:bookworm@sha256:…`. Without it, a machine's set-up may
name a command (`Services.bases`), for where the images of matrix.yaml cannot be had. It is called with an image by its digest
and prints a JSON object: `{"reference": …}`, which the builder can pull, or `{"error": …, "remedy": …}` and a failure. With
`--check` it says in `{"missing": …}` why there is none; with `--assembler 3.12`, the image may be another one that parts for
that Python are built on, and `{"python": …}` says which Python it has.
"""

from __future__ import annotations

import functools
import os
import platform
import re
import subprocess
from collections.abc import Mapping
from dataclasses import dataclass

from rosml.base import untrusted
from rosml.base.errors import RosmlError
from rosml.images.matrix import names
from rosml.images.matrix.model import OperatingSystem
from rosml.machine.services import REMEDY, Services

PINNED = re.compile(r"[^\s@]+@sha256:[0-9a-f]{64}")


@dataclass(frozen=True)
class Assembler:
    """What parts are built on: a reference by digest, and the version of Python there; empty where it has not the wanted one."""

    reference: str
    python: str


def native_architecture() -> str:
    """This machine's architecture, as images name it."""
    machine = platform.machine()
    return {"x86_64": "amd64", "aarch64": "arm64"}.get(machine, machine)


def reference(services: Services, systems: Mapping[str, OperatingSystem], name: str, architecture: str = "") -> str:
    """The reference by digest of an operating system's base image, which the builder can pull.

    Args:
        services: this machine's.
        systems: those of matrix.yaml. name: of one of them.
        architecture: `amd64` or `arm64`; the machine's own if empty. The image has both where it is not: parts are built on
            the machine's own.

    Raises:
        RosmlError: the image cannot be had here, or a variable names none by its digest (exit code 2).
    """
    if given := _given(name):
        return given
    if not services.bases:
        return _official(systems[name])
    asked = architecture or native_architecture()
    return _answer(services, name, _official(systems[name]), ("reference",), "--architecture", asked)[0]


def assembler(services: Services, systems: Mapping[str, OperatingSystem], name: str, python: str) -> Assembler:
    """What parts for an operating system and a Python are built on, on this machine's own architecture.

    Args:
        services: this machine's.
        systems: those of matrix.yaml. name: of the one that has that Python.
        python: such as `3.12`; `any` where no Python is needed.

    Raises:
        RosmlError: as for `reference`.
    """
    if _given(name) or not services.bases:
        return Assembler(reference(services, systems, name), systems[name].python)
    return Assembler(*_answer(services, name, _official(systems[name]), ("reference", "python"), "--assembler", python))


def missing(services: Services, systems: Mapping[str, OperatingSystem], name: str) -> str:
    """Why an operating system's base image cannot be had on this machine; empty where it can.

    Raises:
        RosmlError: nobody can tell, or a variable names no image by its digest (exit code 2).
    """
    if _given(name) or not services.bases:
        return ""
    return _answer(services, name, _official(systems[name]), ("missing",), "--check")[0]


def name_another(name: str) -> str:
    """What helps where an operating system's base image cannot be had, in words."""
    return f"name one that answers: {names.os_variable(name)}=registry.example.com/image:tag@sha256:…"


def _official(system: OperatingSystem) -> str:
    """The reference of the base image that matrix.yaml names."""
    return f"{system.image}@{system.digest}"


def _given(name: str) -> str:
    """The reference that a variable names; empty where none does.

    Raises:
        RosmlError: it names no image by its digest (exit code 2).
    """
    variable = names.os_variable(name)
    text = os.environ.get(variable, "").removeprefix("docker-image://")
    if text and not PINNED.fullmatch(text):
        raise RosmlError(f"{variable} names no image by its digest: {text}", name_another(name), exit_code=2)
    return text


@functools.cache
def _answer(services: Services, name: str, image: str, keys: tuple[str, ...], *arguments: str) -> tuple[str, ...]:
    """What the machine's command says of an image; asked once in a process. What it tells people goes to standard error.

    Raises:
        RosmlError: it fails, or says nothing of use.
    """
    command = [*services.bases, image, *arguments]
    try:
        done = subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, text=True, check=False)
        answer = untrusted.json_value(done.stdout)
        if "error" in answer:
            raise RosmlError(str(answer["error"]), f"{answer['remedy']}; or {name_another(name)}")
        return tuple(str(answer[key]) for key in keys)
    except (OSError, ValueError, TypeError, KeyError) as error:
        text = f"no base image for {name}: {' '.join(command)}: {error}"
        raise RosmlError(text, f"{REMEDY}; or {name_another(name)}") from None
