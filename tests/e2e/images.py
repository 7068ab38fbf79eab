"""What tests do with published images: build on them as users do, and push single targets."""

from __future__ import annotations

import shutil
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

from rosml import ROOT
from rosml.images.builds import base_images
from rosml.images.builds.push import COMPRESSION
from rosml.images.image_set import load
from rosml.images.image_set.model import Part
from rosml.images.matrix import names
from rosml.machine import buildx
from rosml.machine.services import Services
from tests import regctl
from tests.e2e.conftest import NAMESPACE, Published, run

Publish = Callable[[str], Published]

NATIVE = base_images.native_architecture()
PLATFORM = f"linux/{NATIVE}"


def ca_secret(services: Services) -> list[str]:
    """Options of buildx that hand a company's certificates to build steps, where there are any."""
    return ["--secret", f"id=ca-bundle,src={services.ca_bundle}"] if services.ca_bundle else []


def build(services: Services, folder: Path, *options: str) -> str:
    """Builds a folder's Dockerfile as a user would; returns what the builder said: of every step, because what another run or
    another test left in the cache says nothing."""
    if not any(option.startswith("--no-cache") for option in options):
        options = ("--no-cache", *options)
    if HOST in (folder / "Dockerfile").read_text():
        options = ("--allow", "network.host", *options)
    command = [
        *services.buildx,
        "build",
        "--progress",
        "plain",
        "--output",
        "type=cacheonly",
        *ca_secret(services),
        *options,
    ]
    outcome = run(*command, str(folder), env=services.environment())
    assert outcome.code == 0, outcome.err
    return outcome.err


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
        shutil.copytree(Path(__file__).parent / name, folder / Path(name).name)
    mounts = "--mount=type=bind,source=network.sh,target=/run/network.sh --mount=type=secret,id=ca-bundle"
    mounts += "".join(f" --mount=type=bind,source={tool},target=/usr/local/bin/{tool}" for tool in tools)
    lines = [f"FROM {reference}", *([f"COPY {Path(name).name} /{Path(name).name}"] if name else [])]
    first = [step.split()[0] for step in steps]
    options = [f"{HOST if word == 'nearby' else ''} {mounts if word in tools else ''}" for word in first]
    lines += [f"RUN {option} {step}" for option, step in zip(options, steps, strict=True)]
    (folder / "Dockerfile").write_text("\n".join(lines) + "\n")


def build_on(services: Services, image: Published, folder: Path, steps: Sequence[str], name: str = "") -> str:
    """Builds on an image, as `context` says; returns what the builder said."""
    context(image.reference, folder, steps, name)
    return build(services, folder)


def push(
    services: Services,
    base: Published,
    target: str,
    prefix: str,
    *sets: str,
    variables: Mapping[str, str] | None = None,
) -> None:
    """Builds a target, on the operating system of a published image, and pushes it by its tags below a place."""
    bake = buildx.Bake(
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
    buildx.run(services, bake)


def push_part(
    services: Services, image: Published, part: Part, *sets: str, variables: Mapping[str, str] | None = None
) -> list[str]:
    """Pushes a part as an image of its own, by its name as a tag; returns its layers."""
    prefix = f"{services.registry}/{NAMESPACE}"
    push(services, image, part.target, prefix, *sets, variables=variables)
    return [layer.digest for layer in regctl.layers(services, f"{prefix}/part:{part.name}")]


def base_reference(image: Published) -> str:
    """The operating system's image that an image starts from."""
    systems = load.load(ROOT / "matrix.yaml").matrix.operating_systems
    return base_images.reference(image.services, systems, image.image.os, NATIVE)


def base_image(image: Published) -> str:
    return f"docker-image://{base_reference(image)}"
