"""Our second image beside the usual one, whose Dockerfile has a `RUN pip install`: time, registry, download, import.

Both are built twice on the same pair of ROS images, yesterday's and today's, which differ in a file of some bytes: it
stands for changed ROS packages. Yesterday's images are there already when today's, the second ones, are measured, as in
real life. Both install the versions of the same locks, checked by hash, and are compressed and pushed in the same way.

Everything is pushed by digest into a namespace of its own, and removed at the end: no tag is ever made, and none can move.
"""

from __future__ import annotations

import json
import secrets
import shutil
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from bench import local
from rosml.base import files
from rosml.base.errors import RosmlError
from rosml.base.terminal import show, table
from rosml.base.units import duration, size
from rosml.images.bake import bake_file, hcl
from rosml.images.builds import base_images, disk
from rosml.images.builds.maker import require_buildable
from rosml.images.builds.push import Push, push
from rosml.images.builds.variables import sync_dates, variables
from rosml.images.image_set import lock_file
from rosml.images.image_set.model import Image, ImageSet
from rosml.machine import buildx
from rosml.machine.services import Services
from rosml.registry import references
from rosml.registry.client import Registry
from rosml.registry.oci import Manifest

NAMESPACE = "bench"
"""Namespace in the local registry: nothing of anybody else is in it."""

DAYS = ("yesterday", "today")
WAYS = ("ours", "usual")

ROUNDS = 2
"""Imports of each image, of which the faster counts: the first one reads from the disk."""

CHANGE = """\
FROM ros AS {marker}
RUN echo {marker} >/etc/rosml-bench
"""
"""What stands for changed ROS packages. A marker is new in each comparison: nothing is found in the builder's cache, and
everything that it left there is known by its marker."""

USUAL = """\
FROM ros AS {marker}
RUN --mount=type=secret,id=ca-bundle --mount=type=bind,source=locks,target=/locks \\
    if [ -s /run/secrets/ca-bundle ]; then export PIP_CERT=/run/secrets/ca-bundle; fi; \\
    PIP_CONFIG_FILE=/dev/null PIP_BREAK_SYSTEM_PACKAGES=1 PIP_ROOT_USER_ACTION=ignore \\
    pip install --no-cache-dir --no-deps --ignore-installed --require-hashes {requirements} # {marker}
"""
"""As everybody does it, in its fastest form: nothing to resolve, and nothing of Debian's to remove, which pip cannot."""

IMPORT = """\
FROM image AS {marker}
COPY <<"EOF" /import.py
import importlib, json, sys, time
start = time.perf_counter()
versions = {{name: importlib.import_module(name).__version__ for name in sys.argv[1:]}}
print(json.dumps({{"seconds": time.perf_counter() - start, "versions": versions}}))
EOF
RUN --network=none : {marker}; python3 /import.py {modules} >/result.json
FROM scratch
COPY --from={marker} /result.json /
"""
"""A fresh container that imports."""


@dataclass(frozen=True)
class Side:
    """What one way of making the second image came to: wall time in seconds, and bytes as the registry stores them.

    Attributes:
        second, first: building and pushing today's image, and yesterday's. imported: importing the frameworks in a fresh
            container, without the start of the interpreter.
        new: of today's image what neither yesterday's nor today's ROS image had brought: layers, config and manifest.
        pulled: layers of today's image that whoever has yesterday's does not have.
    """

    second: float
    first: float
    imported: float
    new: int
    pulled: int


def print_table(image: Image, sides: Mapping[str, Side]) -> None:
    """Prints both ways side by side."""
    ours, usual = (sides[way] for way in WAYS)
    numbers = ("ours", "RUN pip install")
    printed = table(image.target, *numbers, right=numbers)
    printed.add_row("second image: build and push", duration(ours.second), duration(usual.second))
    printed.add_row("second image: new in the registry", size(ours.new), size(usual.new))
    printed.add_row("to pull after a change of ROS", size(ours.pulled), size(usual.pulled))
    printed.add_row("import, in a fresh container", duration(ours.imported), duration(usual.imported))
    printed.add_row("first image: build and push", duration(ours.first), duration(usual.first))
    show(printed)


def require_comparable(image: Image, root: Path, image_set: ImageSet) -> None:
    """Checks, before anything is set up, that an image can be built in both ways.

    Raises:
        RosmlError: there is no framework to compare, a lock is missing, or pip would need another index (exit code 2).
    """
    require_buildable(image, base_images.native_architecture())
    if not frameworks(image):
        remedy = "take an image with PyTorch or TensorFlow: rosml list torch"
        raise RosmlError(f"{image.target} has no framework: there is nothing to compare", remedy, exit_code=2)
    for path in locks(image, image_set):
        if any("+" in version for version in lock_file.versions((root / path).read_text()).values()):
            text = f"{path} has wheels of PyTorch's own index alone, where pip does not look by itself"
            raise RosmlError(text, "take a target of another stack: rosml list cu128", exit_code=2)


def frameworks(image: Image) -> tuple[str, ...]:
    """What is imported: the modules of an image's frameworks."""
    return tuple(item.name for item in image.brought if item.released)


def locks(image: Image, image_set: ImageSet) -> tuple[str, ...]:
    """The locks of an image's parts for this machine's architecture, relative to the checkout."""
    parts = [image_set.part_by_name[name] for name in image.parts]
    architecture = base_images.native_architecture()
    return tuple(part.locks[part.architectures.index(architecture)] for part in parts)


def needed_mb(image_set: ImageSet, image: Image) -> int:
    """Megabytes that a comparison takes: ours as `rosml image` does, and the usual image twice, each unpacked in the
    builder and compressed in builder and registry; pip keeps all wheels of one beside it until it is done."""
    sizes = [image_set.part_by_name[name].disk for name in image.parts]
    unpacked, compressed = sum(size.unpacked for size in sizes), sum(size.compressed for size in sizes)
    return disk.needed_mb(image_set, image, set()) + len(DAYS) * (unpacked + 2 * compressed) + compressed


def compare(services: Services, image_set: ImageSet, image: Image, say: Callable[[str], None]) -> dict[str, Side]:
    """Builds and measures both ways, and removes from registry and builder what it left there.

    Raises:
        RosmlError: no room, a service is down, a build failed.
    """
    services.require_registry()
    services.require_builder()
    disk.require(services.state, needed_mb(image_set, image), f"{image.target} in both ways", say)
    bench = _Bench(services, image_set, image, say)
    with bench.cleaned():
        return bench.measure()


@dataclass
class _Bench:
    """One comparison.

    Attributes:
        run: tells this comparison's steps in the builder from all others'.
        pushed: manifests that are to be removed.
    """

    services: Services
    image_set: ImageSet
    image: Image
    say: Callable[[str], None]
    run: str = field(default_factory=lambda: f"bench-{secrets.token_hex(6)}")
    variables: dict[str, str] = field(default_factory=dict)
    pushed: list[str] = field(default_factory=list)

    @property
    def _prefix(self) -> str:
        return f"{self.services.registry}/{NAMESPACE}"

    @property
    def _file(self) -> Path:
        return self.services.state / "bake" / f"bench-{self.image.target}.hcl"

    def measure(self) -> dict[str, Side]:
        """All builds and imports, one after the other."""
        image, services = self.image, self.services
        architecture = base_images.native_architecture()
        self.variables = variables(services, self.image_set, image, architecture, self._prefix)
        self.variables |= sync_dates(services, self.image_set, image.distribution, self.say)
        self._write()
        self.say(f"{image.parent}, yesterday's and today's")
        ros = {day: self._push(f"{self.run}-ros-{day}", "ros")[0] for day in DAYS}
        pushed_images: dict[tuple[str, str], tuple[str, float]] = {}
        for day in DAYS:
            self.say(f"{day}'s image, ours: joined with parts")
            pushed_images["ours", day] = self._push(image.target, "image", ros[day])
            self.say(f"{day}'s image, the usual way: pip install")
            pushed_images["usual", day] = self._push(f"{self.run}-usual-{day}", "image", ros[day])
            if day == "yesterday":  # gigabytes that would push the parts out of the builder's cache
                self._prune(f"{self.run}-usual-{day}")
        self.say(f"import {', '.join(frameworks(image))} in fresh containers")
        imports = {
            way: [
                self._import(f"{self.run}-import-{way}-{number}", pushed_images[way, "today"][0])
                for number in range(ROUNDS)
            ]
            for way in WAYS
        }
        if any(
            versions != imports["ours"][0][1] for imports_of_way in imports.values() for _, versions in imports_of_way
        ):
            raise RosmlError(f"the two ways did not install the same: {imports}")
        sides = {}
        for way in WAYS:
            today, yesterday = (stored(pushed_images[way, day][0]) for day in ("today", "yesterday"))
            stored_before = {**yesterday, **stored(ros["today"])}
            layers = {layer.digest: layer.size for layer in manifest(pushed_images[way, "today"][0]).layers}
            sides[way] = Side(
                second=pushed_images[way, "today"][1],
                first=pushed_images[way, "yesterday"][1],
                imported=min(seconds for seconds, _ in imports[way]),
                new=sum(size for digest, size in today.items() if digest not in stored_before),
                pulled=sum(size for digest, size in layers.items() if digest not in yesterday),
            )
        return sides

    @contextmanager
    def cleaned(self) -> Iterator[None]:
        """Removes what was pushed, and the builder's cache of it, however the measurement ends."""
        try:
            yield
        finally:
            for reference in self.pushed:
                try:
                    place = references.parse(reference)
                    with Registry(place.host) as registry:
                        registry.delete(place.repository, place.reference)
                except RosmlError:
                    self.say(f"left in the registry, without a tag: {reference}")
            self._prune(self.run)
            self._prune(f"{self._prefix}/")

    def _write(self) -> None:
        """The bake file: ours as it always is, the usual one, and what both need."""
        facts = {
            "requirements": " ".join(f"--requirement /{path}" for path in locks(self.image, self.image_set)),
            "modules": " ".join(frameworks(self.image)),
        }
        texts = {f"{self.run}-{way}-{day}": text for way, text in (("ros", CHANGE), ("usual", USUAL)) for day in DAYS}
        texts |= {f"{self.run}-import-{way}-{number}": IMPORT for way in WAYS for number in range(ROUNDS)}
        blocks = [
            hcl.block(
                "target",
                name,
                {
                    "inherits": ["_every"],
                    "dockerfile-inline": text.format(marker=name, **facts),
                    "platforms": [self.variables["PLATFORM"]],
                    "contexts": {"ros": f"target:{self.image.parent}"} if text is CHANGE else {},
                },
            )
            for name, text in texts.items()
        ]
        self._file.parent.mkdir(parents=True, exist_ok=True)
        files.write(self._file, "\n".join([bake_file.excerpt(self.image_set, (self.image.target,)), *blocks]))

    def _push(self, target: str, repository: str, ros: str = "") -> tuple[str, float]:
        """Builds a target on a ROS image, or on the bake file's own, and pushes it: its reference, and seconds."""
        sets = [f"{target}.tags="] if target == self.image.target else []
        sets += [f"{target}.contexts.ros=docker-image://{ros}"] if ros else []
        start = time.monotonic()
        digest = push(self.services, Push(self._call(target, sets), f"{self._prefix}/{repository}"))
        reference = f"{self._prefix}/{repository}@{digest}"
        self.pushed.append(reference)
        return reference, time.monotonic() - start

    def _call(self, target: str, sets: Sequence[str]) -> buildx.Bake:
        return buildx.Bake(target, target.replace(self.run, "bench"), self._file, sets, self.variables)

    def _import(self, target: str, reference: str) -> tuple[float, Mapping[str, Any]]:
        """Seconds and versions of an import in a container that has just been made."""
        folder = self.services.state / "bench"
        shutil.rmtree(folder, ignore_errors=True)
        sets = (f"{target}.contexts.image=docker-image://{reference}", f"{target}.output=type=local,dest={folder}")
        buildx.run(self.services, self._call(target, sets))
        result = json.loads((folder / "result.json").read_text())
        return float(result["seconds"]), result["versions"]

    def _prune(self, words: str) -> None:
        """Removes from the builder's cache what is described with some words: a marker, or where it was pulled from."""
        local.buildx(self.services, "prune", "--force", "--all", "--filter", f"description~={words}")


def manifest(reference: str) -> Manifest:
    """The manifest that a registry has.

    Args:
        reference: the repository, and the manifest's digest after an ``@``.
    """
    place = references.parse(reference)
    with Registry(place.host) as registry:
        content = registry.manifest(place.repository, place.reference)
    if content is None:
        raise RosmlError(f"{reference} is not in the registry any more", "run it again")
    return content


def stored(reference: str) -> dict[str, int]:
    """All that a registry stores for an image manifest, in bytes by digest: its layers, its config, and itself."""
    image = manifest(reference)
    entries = [*image.layers, *filter(None, [image.config])]
    return {entry.digest: entry.size for entry in entries} | {image.digest: image.size}
