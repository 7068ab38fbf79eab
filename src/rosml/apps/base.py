"""The image that an app is built on: found in a registry, and read."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass

from rosml.base.errors import RosmlError
from rosml.machine.services import NAMESPACE, Services
from rosml.registry import oci
from rosml.registry.credentials import DOCKER_HUB


@dataclass(frozen=True)
class Base:
    """A base image.

    Attributes:
        name: as people write it, with its registry and tag. digest: of its index, or of its manifest.
        platforms: that it has.
        environment: its variables, and labels, of the first platform that was asked for.
    """

    name: str
    digest: str
    platforms: tuple[str, ...]
    environment: Mapping[str, str]
    labels: Mapping[str, str]

    @property
    def reference(self) -> str:
        """What the builder pulls, whatever becomes of the tag."""
        return f"{re.sub(r':[^:/]+$', '', self.name)}@{self.digest}"


def candidates(text: str, services: Services) -> tuple[str, ...]:
    """Complete references that a user may mean, the likeliest first."""
    text = text.removeprefix("docker.io/") if text.startswith("docker.io/") else text
    host = text.split("/")[0]
    if "/" in text and (re.search(r"[.:]", host) or host == "localhost"):
        return (text,)
    local = (f"{services.registry}/{NAMESPACE}/{text}", f"{services.registry}/{text}") if services.registry else ()
    return (*local, f"{DOCKER_HUB}/{text}" if "/" in text else f"{DOCKER_HUB}/library/{text}")


def find(text: str, services: Services, platforms: tuple[str, ...]) -> Base:
    """The base image of that name.

    Raises:
        RosmlError: there is none, or it is for other platforms.
    """
    with oci.Registries(services.ca_bundle) as registries:
        for name in candidates(text, services):
            place = oci.parse(name)
            registry = registries(place.host)
            manifest = registry.manifest(place.repository, place.reference)
            if manifest is None:
                continue
            return _read(registry, place, manifest, platforms)
    tried = ", ".join(candidates(text, services))
    raise RosmlError(
        f"there is no image {text} (looked for {tried})",
        "check its name with 'rosml list'; 'rosml image TARGET' builds one of ours; 'docker login' for a private one",
        exit_code=2,
    )


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
    pairs = (item.partition("=") for item in config.get("Env") or [])
    return Base(str(place), found.digest, known, {name: value for name, _, value in pairs}, config.get("Labels") or {})
