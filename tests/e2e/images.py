"""What tests do with published images: build on them as users do, and push single targets."""

from __future__ import annotations

import json
import shutil
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Protocol

from rosml import ROOT
from rosml.images.builds import base_images
from rosml.images.builds.push import COMPRESSION
from rosml.images.image_set import load
from rosml.images.image_set.model import Image, Part
from rosml.images.matrix import names
from rosml.machine import buildx as builder
from rosml.machine.services import Services
from rosml.registry.client import Registry
from tests import regctl
from tests.e2e.calls import NAMESPACE, rosml, succeeds

SOURCES = Path(__file__).parent
"""Where the programs are that tests run in images."""


@dataclass(frozen=True)
class Published:
    """A published image: its facts, what the command reported, and where it is."""

    image: Image
    result: dict[str, Any]
    repository: str
    services: Services

    @property
    def reference(self) -> str:
        return f"{self.repository}@{self.result['manifest']}"

    @property
    def layers(self) -> list[str]:
        return layers(self.services, self.reference)

    @property
    def part_layers(self) -> list[str]:
        """The layers that are its parts'."""
        return self.layers[-len(self.image.parts) :]


Publish = Callable[[str], Published]


class BuildOn(Protocol):
    """Builds steps on a published image; gives what the builder said."""

    def __call__(self, target: str, steps: Sequence[str], name: str = "") -> str: ...


NATIVE = base_images.native_architecture()
PLATFORM = f"linux/{NATIVE}"


def ca_secret(services: Services) -> list[str]:
    """Options of buildx that hand a company's certificates to build steps, where there are any."""
    return ["--secret", f"id=ca-bundle,src={services.ca_bundle}"] if services.ca_bundle else []


def layers(services: Services, reference: str) -> list[str]:
    """The digests of an image's layers, lowest first."""
    return [layer.digest for layer in regctl.layers(services, reference)]


def config(services: Services, reference: str) -> dict[str, Any]:
    """What containers of an image start with: environment, entrypoint, labels."""
    content: dict[str, Any] = regctl.image_config(services, reference, PLATFORM)["config"]
    return content


def buildx(services: Services, *arguments: str) -> str:
    """A build of a user's; returns what the builder said."""
    command = [*services.buildx, "build", "--progress", "plain", *ca_secret(services), *arguments]
    return succeeds(*command, env=services.environment()).err


def build(services: Services, folder: Path, *options: str) -> str:
    """Builds a folder's Dockerfile as a user would, each step again: what another test left in the cache says nothing.

    Returns what the builder said.
    """
    if not any(option.startswith("--no-cache") for option in options):
        options = ("--no-cache", *options)
    if HOST in (folder / "Dockerfile").read_text():
        options = ("--allow", "network.host", *options)
    return buildx(services, "--output", "type=cacheonly", *options, str(folder))


def build_file(services: Services, folder: Path, text: str, *options: str) -> str:
    """The same with the text of a Dockerfile, in a folder that is made if it is missing."""
    folder.mkdir(exist_ok=True)
    (folder / "Dockerfile").write_text(text)
    return build(services, folder, *options)


INSTALL = """\
#!/bin/bash
set -e
source /run/network.sh
apt-get update
apt-get install --yes "$@"
"""


HOST = "--network=host"

ONLINE = """\
#!/bin/bash
set -e
source /run/network.sh
trap - EXIT
exec "$@"
"""


def context(reference: str, folder: Path, steps: Sequence[str], name: str = "") -> None:
    """Writes what a build on an image reads.

    Args:
        reference: of the image.
        folder: an empty one.
        steps: commands; one may be `install-packages PACKAGE…`, from the image's own apt source, or `online COMMAND…`, with what
            the builder has for its own network; `nearby COMMAND…` reaches this machine's registry as well.
        name: path of a folder from here, which becomes /NAME by the last part of it.
    """
    shutil.copy(ROOT / "components/build/network.sh", folder)
    tools = {"install-packages": INSTALL, "online": ONLINE, "nearby": ONLINE}
    for tool, text in tools.items():
        (folder / tool).write_text(text)
        (folder / tool).chmod(0o755)
    if name:
        shutil.copytree(SOURCES / name, folder / Path(name).name)
    mounts = "--mount=type=bind,source=network.sh,target=/run/network.sh --mount=type=secret,id=ca-bundle"
    mounts += "".join(f" --mount=type=bind,source={tool},target=/usr/local/bin/{tool}" for tool in tools)
    lines = [f"FROM {reference}", *([f"COPY {Path(name).name} /{Path(name).name}"] if name else [])]
    first = [step.split()[0] for step in steps]
    options = [f"{HOST if word == 'nearby' else ''} {mounts if word in tools else ''}" for word in first]
    lines += [f"RUN {option} {step}" for option, step in zip(options, steps, strict=True)]
    (folder / "Dockerfile").write_text("\n".join(lines) + "\n")


def push(
    services: Services,
    base: Published,
    target: str,
    prefix: str,
    *sets: str,
    variables: Mapping[str, str] | None = None,
) -> None:
    """Builds a target, on the operating system of a published image, and pushes it by its tags below a place."""
    bake = builder.Bake(
        target,
        f"push-{target}",
        ROOT / "docker-bake.hcl",
        (f"{target}.output=type=image,push=true,{COMPRESSION}", *sets),
        {
            "REGISTRY": prefix,
            names.os_variable(base.image.os): base_image(base),
            "PLATFORM": PLATFORM,
            **(variables or {}),
        },
    )
    builder.run(services, bake)


def push_part(
    services: Services, image: Published, part: Part, *sets: str, variables: Mapping[str, str] | None = None
) -> list[str]:
    """Pushes a part as an image of its own, by its name as a tag; returns its layers."""
    prefix = f"{services.registry}/{NAMESPACE}"
    push(services, image, part.target, prefix, *sets, variables=variables)
    return layers(services, f"{prefix}/part:{part.name}")


def build_parts(services: Services, *names: str) -> None:
    """Builds parts for this architecture alone, under their tags."""
    built = rosml("part", *names, "--namespace", NAMESPACE, "--platform", PLATFORM, "--json")
    with Registry(services.registry) as registry:
        for part in json.loads(built.out):
            registry.tag(f"{NAMESPACE}/part", part["digest"], part["name"])


def system(services: Services, name: str, architecture: str = NATIVE) -> str:
    """The image of an operating system that images start from."""
    systems = load.load(ROOT / "matrix.yaml").matrix.operating_systems
    return base_images.reference(services, systems, name, architecture)


def base_image(image: Published) -> str:
    """The same, of an image, as a context of a build."""
    return f"docker-image://{system(image.services, image.image.os)}"
