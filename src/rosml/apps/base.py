"""The image that an app is built on: found in a registry, and read."""

from __future__ import annotations

import json
import re
import subprocess
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from rosml.apps import lock
from rosml.base.errors import RosmlError
from rosml.base.problems import unknown
from rosml.images.labels import PREFIX, RUNTIME, VERSION
from rosml.machine.services import NAMESPACE, Services
from rosml.matrix.names import DATED, main_tag
from rosml.registry import oci
from rosml.registry.credentials import DOCKER_HUB


@dataclass(frozen=True)
class Base:
    """A base image.

    Attributes:
        name: as people write it, with its registry and tag. digest: of its index, or of its manifest.
        environment: its variables, of the first platform that was asked for. labels: those of its configuration.
        local: whether it is in the user's Docker, and in no registry that answers.
    """

    name: str
    digest: str
    environment: Mapping[str, str]
    labels: Mapping[str, str] = field(default_factory=dict)
    local: bool = False

    @property
    def reference(self) -> str:
        """What the builder takes, whatever becomes of the tag; Docker finds its own images by their names alone."""
        if self.local:
            return self.name
        return f"{self.repository}@{self.digest}"

    @property
    def repository(self) -> str:
        """Its name without a tag or digest."""
        return re.sub(r":[^:/]+$", "", self.name.partition("@")[0])


def candidates(text: str, services: Services) -> tuple[str, ...]:
    """Complete references that a user may mean, the likeliest first."""
    text = text.removeprefix(f"{DOCKER_HUB}/")
    if oci.has_registry(text):
        return (text,)
    local = (f"{services.registry}/{NAMESPACE}/{text}", f"{services.registry}/{text}") if services.registry else ()
    return (*local, oci.complete(text))


def find(text: str, services: Services, platforms: tuple[str, ...], digest: str = "") -> Base:
    """The base image of that name: in a registry, or else in the user's Docker if that builds.

    Args:
        digest: if it is to be that one, wherever its tag is now.

    Raises:
        RosmlError: there is none, or it is for other platforms.
    """
    names = candidates(text, services)
    refused: RosmlError | None = None
    near = ""
    with oci.Registries(services.ca_bundle) as registries:
        for name in names:
            place = oci.parse(name)
            registry = registries(place.host)
            try:
                manifest = registry.manifest(place.repository, digest or place.reference)
            except RosmlError as error:  # it does not answer, or wants to know who asks
                refused = error
                continue
            if manifest is not None:
                return _read(registry, place, manifest, platforms)
            if place.host == services.registry and not digest:  # others may have thousands of tags
                near = unknown("tag", place.reference, registry.tags(place.repository)).partition("; ")[2]
    if services.builder_kind != "buildkitd" and (found := _in_docker(text, digest)):
        return found
    if refused:
        if len(names) == 1:
            raise refused
        problem = f"there is no image {text} in the local registry, and {refused.message}"
        raise RosmlError(problem, near or refused.remedy)
    if digest:
        text = f"there is no image {text} with the digest {digest} of the lock file (looked for {', '.join(names)})"
        raise RosmlError(text, lock.RENEW, exit_code=2)
    raise RosmlError(
        f"there is no image {text} (looked for {', '.join(names)})",
        f"{near} 'rosml list' has all names; 'rosml image TARGET' builds one; 'docker login' for a private one".strip(),
        exit_code=2,
    )


def runtime(base: Base) -> str:
    """The name of the image without compilers that belongs to one of ours; empty if it says of none.

    Programs that were built on one run on the other. It is in the same repository, and of the same day and the same versions if
    the tag says them.
    """
    labels = base.labels
    component, distribution = labels.get(RUNTIME, ""), labels.get(f"{PREFIX}distribution", "")
    if not component or not distribution:
        return ""
    stack, day = labels.get(f"{PREFIX}stack"), DATED.search(base.name)
    own, spelled = main_tag(distribution, labels.get(f"{PREFIX}component", ""), stack), labels.get(VERSION, "")
    versions = spelled.removeprefix(own) if f":{spelled}" in base.name else ""
    return f"{base.repository}:{main_tag(distribution, component, stack)}{versions}{day[0] if day else ''}"


def differing(base: Base, other: Base) -> list[str]:
    """What labels of one of our images say otherwise than those of another one: versions, systems, days."""
    own = {f"{PREFIX}{name}" for name in ("component", "runtime", "app")}
    names = {name for labels in (base.labels, other.labels) for name in labels if name.startswith(PREFIX)} - own
    return sorted(name.removeprefix(PREFIX) for name in names if base.labels.get(name) != other.labels.get(name))


def _in_docker(text: str, digest: str) -> Base | None:
    """An image that the user's Docker has: of a digest, if one is wanted."""
    try:
        command = ["docker", "image", "inspect", text]
        done = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False)
        [facts] = json.loads(done.stdout)
    except (OSError, ValueError):
        return None
    known = [facts["Id"], *(name.partition("@")[2] for name in facts.get("RepoDigests") or [])]
    if digest and digest not in known:
        return None
    config = facts.get("Config") or {}
    return Base(text, facts["Id"], _variables(config), config.get("Labels") or {}, local=True)


def _variables(config: Mapping[str, Any]) -> dict[str, str]:
    """The variables that the configuration of an image sets."""
    return {name: value for name, _, value in (item.partition("=") for item in config.get("Env") or [])}


def _read(registry: oci.Registry, place: oci.Reference, found: oci.Manifest, platforms: tuple[str, ...]) -> Base:
    manifests = {"": found}
    if found.is_index:
        manifests = {}
        for entry in found.content["manifests"]:
            facts = entry.get("platform", {})
            name = "/".join(filter(None, (facts.get("os"), facts.get("architecture"))))
            if facts.get("os") != "unknown" and (not platforms or name in platforms):
                manifest = registry.manifest(place.repository, entry["digest"])
                if manifest is not None:
                    manifests[name] = manifest
        known = tuple(manifests)
    configs = {
        name: registry.json_blob(place.repository, manifest.content["config"]["digest"])
        for name, manifest in manifests.items()
    }
    if not found.is_index:
        known = tuple(f"{config['os']}/{config['architecture']}" for config in configs.values())
        configs = dict(zip(known, configs.values(), strict=True))
    missing = [name for name in platforms if name not in known]
    if missing:
        text = f"{place} is not for {', '.join(missing)}"
        raise RosmlError(text, "name another base image, or other platforms", exit_code=2)
    config = configs[platforms[0] if platforms else known[0]].get("config") or {}
    return Base(str(place), found.digest, _variables(config), config.get("Labels") or {})
