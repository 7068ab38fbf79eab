"""Calls regctl: what tests read of a registry, they read with a program that nobody here wrote."""

from __future__ import annotations

import re
import subprocess
from dataclasses import dataclass
from typing import Any

from pydantic import ValidationError

from rosml.base import untrusted
from rosml.base.errors import RosmlError
from rosml.base.problems import first_of
from rosml.base.shapes import adapter
from rosml.machine.services import REMEDY, Services
from rosml.registry import certificates

SECONDS = 120.0
"""The longest that one call may take. No call moves a layer."""


LOOPBACK = re.compile(r"(?:127\.0\.0\.1|localhost|\[::1\])(?::\d+)?(?=/)")
"""Registries that speak plain http: those of this machine without certificates in certs.d."""


@dataclass(frozen=True)
class Layer:
    """One layer of an image: its digest as stored (compressed) and its size in bytes."""

    digest: str
    size: int


def program(services: Services) -> str:
    """The path of regctl: that of setup, or the machine's own."""
    ours = services.state / "bin/regctl"
    return str(ours) if ours.exists() else "regctl"


def regctl(services: Services, *arguments: str) -> str:
    """Runs regctl and returns its output.

    Raises:
        RosmlError: regctl failed, or the registry does not answer.
    """
    loopback = dict.fromkeys(
        match[0] for argument in arguments if (match := LOOPBACK.match(argument)) and not certificates.of(match[0])
    )
    plain = [option for host in loopback for option in ("--host", f"reg={host},tls=disabled")]
    command = [program(services), *arguments, *plain]
    try:
        done = subprocess.run(
            command, env=services.environment(), capture_output=True, text=True, timeout=SECONDS, check=False
        )
    except OSError as error:
        raise RosmlError(f"cannot run {command[0]}: {error.strerror}", REMEDY) from None
    except subprocess.TimeoutExpired:
        raise RosmlError(f"the registry did not answer within {SECONDS:.0f} s: {' '.join(arguments)}", REMEDY) from None
    if done.returncode != 0:
        services.require_registry()  # raises if that is the reason
        lines = done.stderr.strip().splitlines()
        raise RosmlError(f"regctl {' '.join(arguments)}: {lines[-1] if lines else f'exit code {done.returncode}'}")
    return done.stdout


def _json(services: Services, *arguments: str) -> dict[str, Any]:
    try:
        content = untrusted.json_value(regctl(services, *arguments))
    except ValueError:
        content = None
    if not isinstance(content, dict):
        text = f"the registry's answer to {' '.join(arguments)} is no JSON object"
        raise RosmlError(text, "look at the registry's address")
    return content


def manifest(services: Services, reference: str) -> dict[str, Any]:
    """The manifest or index of a reference, as stored."""
    return _json(services, "manifest", "get", "--format", "raw-body", reference)


def image_config(services: Services, reference: str, platform: str) -> dict[str, Any]:
    """The config of an image: entrypoint, environment, labels, diff ids."""
    return _json(services, "image", "config", "--platform", platform, reference)


def layers(services: Services, reference: str) -> tuple[Layer, ...]:
    """The layers of an image manifest, lowest first.

    Raises:
        RosmlError: as in `regctl`; or the reference is no image manifest.
    """
    try:
        return _LAYERS.validate_python(manifest(services, reference).get("layers"))
    except ValidationError as error:
        raise RosmlError(f"{reference} is no image: {first_of(error)}", "look at its name, and push it again") from None


_LAYERS = adapter(tuple[Layer, ...])


def digest(services: Services, reference: str) -> str:
    """The digest of a tag; empty if there is no such tag."""
    try:
        return regctl(services, "manifest", "head", reference).strip()
    except RosmlError as error:
        reason = error.message.rpartition(f" {reference}: ")[2].lower()  # the reference itself may hold such words
        if "not found" in reason or "404" in reason:
            return ""
        raise


def create_index(services: Services, repository: str, digests: list[str], annotations: dict[str, str]) -> str:
    """Makes an index of image manifests that the repository has already, without pulling anything.

    It is pushed by its digest alone: nobody sees it before a tag points at it.

    Returns:
        The digest of the index.
    """
    arguments = ["index", "create", "--by-digest", "--format", "{{.Manifest.GetDescriptor.Digest}}"]
    for name, value in sorted(annotations.items()):
        arguments += ["--annotation", f"{name}={value}"]
    for entry in digests:
        arguments += ["--ref", f"{repository}@{entry}"]
    return regctl(services, *arguments, repository).strip()
