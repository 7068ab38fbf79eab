"""Hosts of registries: those on this machine, and those that anybody can pull from."""

from __future__ import annotations

import ipaddress
import re

PUBLIC = (
    *("docker.io", "docker.com", "ghcr.io", "quay.io", "registry.gitlab.com", "public.ecr.aws", "mcr.microsoft.com"),
    *("nvcr.io", "codeberg.org", "lscr.io", "pkg.github.com", "registry.access.redhat.com", "ttl.sh"),
)
"""Registries that show images to everybody, unless a repository is made private. Also the names below these."""


def name_of(host: str) -> str:
    """The name of a host without its port, in small letters."""
    return re.sub(r":[0-9]+$", "", host.lower()).rstrip(".")


def is_public(host: str) -> bool:
    """Whether a registry shows images to everybody."""
    name = name_of(host)
    return any(name == suffix or name.endswith(f".{suffix}") for suffix in PUBLIC)


def is_here(host: str) -> bool:
    """Whether a registry is on this machine."""
    name = name_of(host)
    try:
        return name == "localhost" or ipaddress.ip_address(name.strip("[]")).is_loopback
    except ValueError:
        return False
