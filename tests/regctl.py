"""Calls regctl: what tests read of a registry, they read with a program that nobody here wrote."""

from __future__ import annotations

import json
import re
import subprocess
from dataclasses import dataclass
from typing import Any

from rosml.base.errors import RosmlError
from rosml.machine.services import Services
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
    """Runs regctl and returns its output. Raises RosmlError if it fails."""
    matches = [match[0] for argument in arguments if (match := LOOPBACK.match(argument))]
    loopback = dict.fromkeys(host for host in matches if not certificates.of(host))
    plain = [option for host in loopback for option in ("--host", f"reg={host},tls=disabled")]
    command = [program(services), *arguments, *plain]
    done = subprocess.run(command, env=services.environment(), capture_output=True, text=True, timeout=SECONDS)
    if done.returncode != 0:
        raise RosmlError(f"regctl {' '.join(arguments)}: {(done.stderr.strip().splitlines() or [''])[-1]}")
    return done.stdout


def manifest(services: Services, reference: str) -> dict[str, Any]:
    """The manifest or index of a reference, as stored."""
    content: dict[str, Any] = json.loads(regctl(services, "manifest", "get", "--format", "raw-body", reference))
    return content


def image_config(services: Services, reference: str, platform: str) -> dict[str, Any]:
    """The config of an image: entrypoint, environment, labels, diff ids."""
    content: dict[str, Any] = json.loads(regctl(services, "image", "config", "--platform", platform, reference))
    return content


def layers(services: Services, reference: str) -> tuple[Layer, ...]:
    """The layers of an image manifest, lowest first."""
    return tuple(Layer(item["digest"], item["size"]) for item in manifest(services, reference)["layers"])


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
    """Makes an index of image manifests that the repository has already, without a tag. Returns its digest."""
    arguments = ["index", "create", "--by-digest", "--format", "{{.Manifest.GetDescriptor.Digest}}"]
    arguments += [word for name, value in sorted(annotations.items()) for word in ("--annotation", f"{name}={value}")]
    arguments += [word for entry in digests for word in ("--ref", f"{repository}@{entry}")]
    return regctl(services, *arguments, repository).strip()
