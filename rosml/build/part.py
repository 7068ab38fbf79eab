"""Parts as images of their own: assembled for all of their architectures, pushed by digest, then tagged.

A part is assembled on an operating system that has its Python, which compiles the bytecode. Where that base image
cannot be had, Debian's takes its place: with an interpreter of the same version that this machine happens to have, or
without bytecode. What was done is part of the result: such a part has other digests than the published one.
"""

from __future__ import annotations

import json
import shutil
import subprocess
import tempfile
import time
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from rosml.base.errors import RosmlError
from rosml.base.problems import listed, unknown
from rosml.build.push import push_by_digest, write_excerpt
from rosml.images.image_set import ImageSet, Part
from rosml.machine import base_images, buildx, regctl
from rosml.machine.services import NAMESPACE, Services
from rosml.matrix import names
from rosml.matrix.model import ANY_PYTHON
from rosml.registry import oci

VERSIONS = "~/.pyenv/versions"
"""Where this machine may have further Pythons."""


@dataclass(frozen=True)
class Assembled:
    """A part in the registry.

    Attributes:
        name: `torch-cu128-py311`.
        reference: where it is, with its digest; with its tag, where that was moved.
        digest: what the tag points at.
        layers: by platform, the digest of its one layer and the layer's size in bytes.
        assembled_on: the base image, and what is said of it.
        bytecode: the version of Python that compiled it; empty where there is none.
        seconds: wall time.
    """

    name: str
    reference: str
    digest: str
    layers: Mapping[str, tuple[str, int]]
    assembled_on: str
    bytecode: str
    seconds: float

    def to_json(self) -> dict[str, Any]:
        """For `--json`."""
        return asdict(self)


def find(image_set: ImageSet, name: str) -> Part:
    """The part of a name or bake target.

    Raises:
        RosmlError: there is none (exit code 2), or a lock is missing.
    """
    part = image_set.part_by_name.get(name.removeprefix("part-"))
    if part is None:
        text = unknown("part", name, image_set.part_by_name)
        raise RosmlError(text, "see all with: uv run scripts/publish.py part", exit_code=2)
    return part


def publish(
    services: Services,
    image_set: ImageSet,
    part: Part,
    say: Callable[[str], None],
    namespace: str = NAMESPACE,
    again: bool = False,
    platform: str = "",
) -> Assembled:
    """Assembles a part for all architectures that have its lock, of what the matrix says now, and moves its tag if these
    are all that it has.

    Args:
        services: registry and builder.
        image_set: all that the matrix describes.
        part: what to assemble.
        say: told what is going on, a line at a time.
        namespace: first part of the repository's name.
        again: assemble it even if the builder has it: the same inputs give the same digests.
        platform: only for this one, where the wheels of another cannot be had; no tag moves then.

    Raises:
        RosmlError: a lock is missing, no base image can be had, a service is down, or the build failed.
    """
    started = time.monotonic()
    if platform and platform not in part.platforms:
        known = ", ".join(part.platforms)
        raise RosmlError(f"part {part.name} is for {known}", f"take one of them, not {platform}", exit_code=2)
    platforms = [
        name
        for name, lock in zip(part.platforms, part.locks, strict=True)
        if platform in ("", name) and lock not in part.unlocked
    ]
    if not platforms:
        text = f"part {part.name} has no lock of what matrix.yaml says now: {listed(part.unlocked)}"
        raise RosmlError(text, "run 'make locks'")
    prefix = f"{services.registry}/{namespace}"
    repository = f"{prefix}/part"
    base, digest = push(services, image_set, part, say, prefix, platforms, again)
    layers = dict(_layers(services, f"{repository}@{digest}", platforms))
    reference = f"{repository}@{digest}"
    if len(platforms) == len(part.platforms):  # a tag is for all platforms
        with oci.Registry(services.registry, ca_bundle=services.ca_bundle) as client:
            client.tag(f"{namespace}/part", digest, part.name)
        reference = f"{repository}:{part.name}@{digest}"
    python = base.python if part.python != ANY_PYTHON else ""
    return Assembled(part.name, reference, digest, layers, base.said, python, time.monotonic() - started)


def push(
    services: Services,
    image_set: ImageSet,
    part: Part,
    say: Callable[[str], None],
    prefix: str,
    platforms: list[str],
    again: bool = False,
) -> tuple[Base, str]:
    """Assembles a part for some platforms and pushes it by digest into the repository `part` below a prefix.

    Returns:
        What it was assembled on, and the digest: of an index, or for one platform of its manifest.

    Raises:
        RosmlError: no base image can be had, or the build failed.
    """
    base = _base(services, image_set, part, say)
    file = write_excerpt(services, image_set, part.target)
    sets = [
        f"{part.target}.tags=",
        f"{part.target}.platform={','.join(platforms)}",
    ]
    if not base.python and part.python != ANY_PYTHON:
        sets.append(f"{part.target}.args.BYTECODE=none")
    if again:
        sets.append(f"{part.target}.no-cache=true")
    variables = {"REGISTRY": prefix, names.os_variable(part.os): f"docker-image://{base.reference}"}
    say(f"part {part.name} for {', '.join(platforms)}, assembled on {base.said}")
    call = buildx.Bake(part.target, part.target, file, tuple(sets), variables)
    _, digest = push_by_digest(services, call, f"{prefix}/part")
    return base, digest


def _layers(services: Services, reference: str, platforms: list[str]) -> Iterator[tuple[str, tuple[str, int]]]:
    """The layer of each platform.

    Raises:
        RosmlError: the registry's answer is not that of parts.
    """
    repository = reference.partition("@")[0]
    try:
        content = regctl.manifest(services, reference)
        if "layers" in content:  # one platform only
            entries = {platforms[0]: content}
        else:
            entries = {
                f"{entry['platform']['os']}/{entry['platform']['architecture']}": regctl.manifest(
                    services, f"{repository}@{entry['digest']}"
                )
                for entry in content["manifests"]
            }
        for platform, manifest in entries.items():
            (layer,) = manifest["layers"]
            yield platform, (layer["digest"], layer["size"])
    except (KeyError, TypeError, ValueError):
        raise RosmlError(f"{reference} is not a part with one layer for each platform", "run it again") from None


@dataclass(frozen=True)
class Base:
    """What a part is assembled on: a reference, the Python that compiles bytecode, and both in words."""

    reference: str
    python: str
    said: str


def _base(services: Services, image_set: ImageSet, part: Part, say: Callable[[str], None]) -> Base:
    systems = image_set.matrix.operating_systems
    system = systems[part.os]
    if not services.mirror or base_images.debian_suite(system.image):
        reference = base_images.ensure(services, system, say=say)
        return Base(reference, system.python, reference)
    choice = [systems[image_set.matrix.default.assembler], *(systems[name] for name in sorted(systems))]
    debian = next((item for item in choice if base_images.debian_suite(item.image)), None)
    if debian is None:
        raise RosmlError(f"{system.image} is on Docker Hub, which does not answer", "use a machine that reaches it")
    reference = base_images.ensure(services, debian, say=say)
    if part.python == ANY_PYTHON:
        return Base(reference, "", f"{debian.image} instead of {system.image}")
    version, home = _interpreter(part.python)
    if home is None:
        return Base(
            reference, "", f"{debian.image} instead of {system.image}, without bytecode: no Python {part.python}"
        )
    stand_in = _with_python(services, reference, part.python, home)
    return Base(stand_in, version, f"{debian.image} with Python {version} instead of {system.image}")


def _interpreter(python: str) -> tuple[str, Path | None]:
    """The newest release of a Python that this machine has beside its own, and its folder."""
    found = sorted(
        Path(VERSIONS).expanduser().glob(f"{python}.*/bin/python{python}"),
        key=lambda path: [int(number) for number in path.parts[-3].split(".") if number.isdecimal()],
    )
    return (found[-1].parts[-3], found[-1].parent.parent) if found else ("", None)


def _with_python(services: Services, reference: str, python: str, home: Path) -> str:
    """Debian's base image with a Python of this machine, in the local registry; gives its reference by digest.

    Raises:
        RosmlError: buildx fails.
    """
    (services.state / "tmp").mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=services.state / "tmp") as folder:
        context = Path(folder)
        shared = [str(file.relative_to(home)) for file in (home / "lib").glob(f"libpython{python}*.so*")]
        for part in (f"bin/python{python}", f"lib/python{python}", *shared):
            (context / part).parent.mkdir(exist_ok=True)
            if (home / part).is_dir():
                left_out = shutil.ignore_patterns("test", "tests", "__pycache__", "site-packages", "config-*", "*.a")
                shutil.copytree(home / part, context / part, ignore=left_out)
            else:
                shutil.copy(home / part, context / part)
        (context / "Dockerfile").write_text(f"FROM {reference}\nCOPY bin /usr/bin\nCOPY lib /usr/lib\n")
        repository = f"{services.registry}/library/assembler"
        command = [*services.buildx, "build", "--builder", services.builder, "--metadata-file", str(context / "said")]
        command += ["--output", f"type=image,name={repository},push=true,push-by-digest=true", str(context)]
        done = subprocess.run(
            command, env=services.environment(), stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False
        )
        if done.returncode != 0:
            raise RosmlError(f"cannot add Python {python} to {reference}:\n{done.stderr.strip()}", "run 'make up'")
        digest = json.loads((context / "said").read_text())["containerimage.digest"]
    return f"{repository}@{digest}"


def markdown(found: Iterable[Assembled]) -> str:
    """A table of parts with their digests, for docs/digests.md."""
    lines = ["| part | platform | layer | MB | bytecode |", "| --- | --- | --- | ---: | --- |"]
    for item in found:
        for platform, (digest, size) in item.layers.items():
            bytecode = item.bytecode or ("none" if "-py" in item.name else "no Python in it")
            lines.append(f"| `{item.name}` | {platform} | `{digest}` | {size / 1e6:.1f} | {bytecode} |")
    return "\n".join(lines) + "\n"
