"""The names of an app's images, and the places to which they go."""

from __future__ import annotations

import functools
import re
import shutil
import subprocess

from rosml.base.errors import RosmlError
from rosml.containerize.inputs import Values
from rosml.images.builds.base_images import native_architecture
from rosml.machine.services import NAMESPACE, Services
from rosml.registry import references

RESERVED = (NAMESPACE, "library")
"""First parts of names that other images have in the local registry: our base images, and those of Docker Hub."""

DEV = "dev"
"""The image to work on the app: its sources, and what they need to be built."""

TARGETS = ("run", DEV)

SLIM = "slim"
"""The image to run the app on a base image without compilers. It comes with the run image."""

DESK = "desk"
"""The image for `rosml dev`. It stays on this machine."""


class Names:
    """The images that inputs ask for. `app`: the run image's name without its tag. `loads`: they go to Docker, and to no registry.
    `for_podman`: they go to the local registry, if there is one, as podman has no builder."""

    def __init__(self, values: Values, folder: str, services: Services, for_podman: bool = False) -> None:
        self._values, self._registry = values, services.registry
        self.app = _name(values.image_name or folder.lower())
        self.targets = _targets(values.target)
        if values.enable_slim and "run" in self.targets:
            self.targets += (SLIM,)
        self.platforms = listed_platforms(values.platform)
        has_docker = services.builder_kind != "buildkitd" and not for_podman and shutil.which("docker") is not None
        self.loads = not values.push and (has_docker or not services.registry)
        self._require_place()

    def reference(self, target: str) -> str:
        name, tag = self.app, self._values.image_tag
        if target not in (DESK, "run"):
            own_name = self._values.text(f"{target}-image-name")
            name = _name(own_name) if own_name else name
            tag = self._values.text(f"{target}-image-tag") or f"{tag}-{target}"
        if not re.fullmatch(r"[A-Za-z0-9_][A-Za-z0-9_.-]{0,127}", tag):
            raise RosmlError(f"{tag!r} is no tag of an image", "take letters, digits, points and hyphens", exit_code=2)
        local = f"{self._registry}/" if self._registry and not self.loads and not references.has_registry(name) else ""
        return f"{local}{name}:{tag}"

    def tags(self, target: str) -> list[str]:
        """All full names that an image gets."""
        reference = self.reference(target)
        if not self._values.enable_push_as_latest:
            return [reference]
        latest = "latest" if target == "run" else f"latest-{target}"
        return list(dict.fromkeys([reference, f"{reference.rpartition(':')[0]}:{latest}"]))

    @functools.cached_property
    def loading(self) -> str:
        """The builder's output to Docker. Docker before 23 cannot read zstd layers, which base images have."""
        command = ["docker", "version", "--format", "{{.Server.Version}}"]
        try:
            done = subprocess.run(command, stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False)
        except OSError:
            return "type=docker"
        major = re.match(r"(\d+)\.", done.stdout)
        reads_zstd = major is None or int(major[1]) >= 23
        return "type=docker" + ("" if reads_zstd else ",compression=uncompressed,force-compression=true")

    def _require_place(self) -> None:
        names = [self.reference(target).rpartition(":")[0] for target in self.targets]
        if self._values.push:
            for name in names:
                if not references.has_registry(name):
                    raise RosmlError(f"{name} names no registry", "name one, such as ghcr.io/me/robot", exit_code=2)
        elif self.loads and len(self.platforms) > 1:
            raise RosmlError("Docker holds images of one platform", "name one platform, or add --push", exit_code=2)
        elif not self.loads:
            for name in names:
                if name.startswith(tuple(f"{self._registry}/{first}/" for first in RESERVED)):
                    text = f"{name} is no name for an app: base images are called so in the local registry"
                    raise RosmlError(text, "choose another --image-name", exit_code=2)
                if not name.startswith(f"{self._registry}/"):
                    text = f"there is no Docker here that could hold {name}"
                    raise RosmlError(text, "add --push, or leave the registry out of the name", exit_code=2)


def listed(text: str) -> list[str]:
    return [word.strip() for word in text.split(",") if word.strip()]


def _targets(text: str) -> tuple[str, ...]:
    words = listed(text)
    wrong = [f"{word!r} is no target" for word in words if word not in TARGETS]
    if wrong or not words:
        raise RosmlError((wrong or ["no target is named"])[0], f"there are: {', '.join(TARGETS)}", exit_code=2)
    return tuple(name for name in TARGETS if name in words)


def listed_platforms(text: str) -> tuple[str, ...]:
    """Platforms by BuildKit's names; users of docker-ros write only the architecture."""
    names = listed(text) or [native_architecture()]
    return tuple(dict.fromkeys(name if "/" in name else f"linux/{name}" for name in names))


def _name(text: str) -> str:
    """Checks an image's name without its tag, by the rules of registries."""
    host, path = text.split("/", 1) if references.has_registry(text) else ("localhost", text)
    if not references.is_place(host, path):
        text = f"{text!r} is no name of an image"
        remedy = "add --image-name: small letters and digits, with single points, hyphens and slashes between them"
        raise RosmlError(text, remedy, exit_code=2)
    return text
