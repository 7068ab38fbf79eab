"""The repository of an image, by its name: users trust repositories. The image's own labels do not count."""

from __future__ import annotations

import re
from pathlib import Path

from rosml.base import untrusted

_LABEL = "[A-Za-z0-9](?:[A-Za-z0-9-]*[A-Za-z0-9])?"
_HOST = rf"(?:{_LABEL}(?:\.{_LABEL})*|\[[0-9A-Fa-f]*:[0-9A-Fa-f:]*\])(?::[0-9]+)?"
_PART = "[a-z0-9]+(?:(?:[._]|__|-+)[a-z0-9]+)*"
_TAG = r"[A-Za-z0-9_][A-Za-z0-9_.-]{0,127}"
_DIGEST = "[A-Za-z][A-Za-z0-9]*(?:[-_+.][A-Za-z][A-Za-z0-9]*)*:[0-9a-fA-F]{32,}"
REFERENCE = re.compile(rf"(?P<name>(?:{_HOST}/)?{_PART}(?:/{_PART})*)(?::{_TAG})?(?:@{_DIGEST})?")
"""The name of an image: https://github.com/distribution/reference/blob/main/reference.go."""

ID = re.compile("(?:sha256:)?(?P<hex>[0-9a-f]+)")
PUSHED = "push it to a registry, and write its name there"
PODMAN_TRANSPORTS = (
    *("containers-storage", "dir", "docker", "docker-archive", "docker-daemon", "oci", "oci-archive", "ostree", "sif"),
)

HUB = "docker.io"
SERVICES = "services.json"
NAMESPACE = "rosml"


def repository(name: str, identity: str, podman: bool) -> str:
    """The repository of an image, with its registry and without tag and digest: `docker.io/library/ros` for `ros:jazzy`. If the
    user names an image by its id, or in another way, it is its own repository. Upper and lower case differ. podman resolves a name
    without a registry by its own settings, so such a name stays as it is, and is no repository elsewhere."""
    reference, by_id = REFERENCE.fullmatch(name), ID.fullmatch(name)
    path = podman and name.partition(":")[0] in PODMAN_TRANSPORTS and ":" in name
    if not reference or path or (by_id and identity.startswith(by_id["hex"])):
        return f"sha256:{identity}"
    registry, slash, rest = reference["name"].partition("/")
    if not slash or not (set(registry) & set(".:") or registry == "localhost" or registry != registry.lower()):
        if podman:
            return reference["name"]
        registry, rest = HUB, reference["name"]
    if registry == f"index.{HUB}":
        registry = HUB
    return f"{registry}/library/{rest}" if registry == HUB and "/" not in rest else f"{registry}/{rest}"


def local_registry(state: Path) -> str:
    """The address of a checkout's local registry; empty if there is none. `state` is the checkout's folder `.state`."""
    try:
        services = untrusted.json_object((state / SERVICES).read_bytes()) or {}
    except OSError:
        return ""
    address = services.get("registry")
    return address if isinstance(address, str) else ""


def is_local(repository: str, registry: str) -> bool:
    """Whether a repository has the images that a checkout builds into its local registry."""
    return bool(registry) and repository.startswith(f"{registry}/{NAMESPACE}/")
