"""Base images by digest: those that matrix.yaml names, or others that this machine uses instead.

A variable names another image: `OS_BOOKWORM=registry.example.com/debian:bookworm@sha256:…`. A machine that cannot pull
the images of matrix.yaml may have a command for them (`Services.bases`). rosml calls the command with an image by
digest. The command prints a JSON object: `{"reference": …}`, which the builder can pull; or, if it fails,
`{"error": …, "remedy": …}`. With `--check`, it prints `{"missing": …}` with the reason why the image is not available.
With `--assembler 3.12`, it may give another image to build parts for that Python on, and `{"python": …}` says which
Python this image has.
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
from rosml.registry import references
from rosml.registry.credentials import DOCKER_HUB

PINNED = re.compile(r"[^\s@]+@sha256:[0-9a-f]{64}")


@dataclass(frozen=True)
class Assembler:
    """The image that parts are built on."""

    reference: str
    python: str  # the version of Python in it; empty if it lacks that of the part


def native_architecture() -> str:
    """This machine's architecture, as images name it."""
    machine = platform.machine()
    return {"x86_64": "amd64", "aarch64": "arm64"}.get(machine, machine)


def reference(services: Services, systems: Mapping[str, OperatingSystem], name: str, architecture: str = "") -> str:
    """The reference by digest of an operating system's base image, which the builder can pull.

    For another architecture than its own, the machine's command gives an image that has both: parts are built on its own.
    """
    if override := _override(name):
        return override
    if not services.bases:
        return _official(systems[name])
    options = "--architecture", architecture or native_architecture()
    return _for_builder(services, name, _answer(services, name, _official(systems[name]), ("reference",), *options)[0])


def assembler(services: Services, systems: Mapping[str, OperatingSystem], name: str, python: str) -> Assembler:
    """The image that parts for an operating system and a Python are built on, for this machine's own architecture."""
    if _override(name) or not services.bases:
        return Assembler(reference(services, systems, name), systems[name].python)
    keys = ("reference", "python")
    text, version = _answer(services, name, _official(systems[name]), keys, "--assembler", python)
    return Assembler(_for_builder(services, name, text), version)


def docker_hub(services: Services, name: str) -> str:
    """The host by which the builder pulls what stands for an image of Docker Hub. Docker's own takes the local registry for no mirror."""
    return services.registry if services.is_docker_itself and services.bases and not _override(name) else DOCKER_HUB


def _for_builder(services: Services, name: str, text: str) -> str:
    hub, whole = docker_hub(services, name), references.complete(text)
    return f"{hub}{whole.removeprefix(DOCKER_HUB)}" if whole.startswith(f"{DOCKER_HUB}/") else text


def missing(services: Services, systems: Mapping[str, OperatingSystem], name: str) -> str:
    """Why an operating system's base image is not available on this machine; empty if it is."""
    if _override(name) or not services.bases:
        return ""
    return _answer(services, name, _official(systems[name]), ("missing",), "--check")[0]


def name_another(name: str) -> str:
    """The remedy if an operating system's base image is not available."""
    return f"name one that answers: {names.os_variable(name)}=registry.example.com/image:tag@sha256:…"


def _official(system: OperatingSystem) -> str:
    return f"{system.image}@{system.digest}"


def _override(name: str) -> str:
    variable = names.os_variable(name)
    text = os.environ.get(variable, "").removeprefix("docker-image://")
    if text and not PINNED.fullmatch(text):
        raise RosmlError(f"{variable} names no image by its digest: {text}", name_another(name), exit_code=2)
    return text


@functools.cache
def _answer(services: Services, name: str, image: str, keys: tuple[str, ...], *arguments: str) -> tuple[str, ...]:
    """Values that the machine's command prints for an image. A process calls it once."""
    command = [*services.bases, image, *arguments]
    try:
        process = subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, text=True, check=False)
        answer = untrusted.json_value(process.stdout)
        if "error" in answer:
            raise RosmlError(str(answer["error"]), f"{answer['remedy']}; or {name_another(name)}")
        return tuple(str(answer[key]) for key in keys)
    except (OSError, ValueError, TypeError, KeyError) as error:
        text = f"no base image for {name}: {' '.join(command)}: {error}"
        raise RosmlError(text, f"{REMEDY}; or {name_another(name)}") from None
