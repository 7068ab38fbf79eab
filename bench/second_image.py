"""Our second image beside the usual one, whose Dockerfile has a `RUN pip install`: time, registry, download, import.

Both are built twice on the same pair of ROS images, yesterday's and today's, which differ in a file of some bytes: it
stands for changed ROS packages. Yesterday's images are there already when today's, the second ones, are measured, as in
real life. Both install the versions of the same locks, checked by hash, and are compressed and pushed in the same way.

Everything is pushed by digest into a namespace of its own: no tag is ever made, and none can move.
"""

from __future__ import annotations

import json
import secrets
import shutil
import subprocess
import time
from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import asdict, dataclass, field, replace
from pathlib import Path
from typing import Any

from bench.here import Here
from rosml.base import files
from rosml.base.errors import RosmlError
from rosml.base.terminal import console, show, table
from rosml.base.units import duration, size
from rosml.images.bake import bake_file, hcl
from rosml.images.builds import base_images, disk
from rosml.images.builds.maker import require_buildable
from rosml.images.builds.push import COMPRESSION, push_by_digest
from rosml.images.image_set import lock_file
from rosml.images.image_set.model import Image, ImageSet
from rosml.machine import buildx, regctl
from rosml.machine.progress import BuildProgress
from rosml.machine.services import Services

NAMESPACE = "bench"
"""Namespace in the local registry: nothing of anybody else is in it."""

DAYS = ("yesterday", "today")

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
print(json.dumps({{"import_seconds": time.perf_counter() - start, "versions": versions}}))
EOF
COPY <<"EOF" /shell.py
import json, subprocess, sys, time
def seconds(*command):
    start = time.perf_counter()
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return time.perf_counter() - start
way, *names = sys.argv[1:]
if way == "ours":
    commands = [("bash", "-ic", "true"), ("/usr/local/share/rosml/banner.sh",)]
else:
    asked = [(sys.executable, "-c", f"import {{name}}; print({{name}}.__version__)") for name in names]
    commands = [("bash", "--norc", "-ic", "true"), *asked]
with open("/import.json") as file:
    found = json.load(file)
source = 'setup=/opt/ros/$ROS_DISTRO/setup.bash; if [ -f "$setup" ]; then . "$setup"; fi; exec true'
start, sourcing = (
    min(seconds(*command) for _ in range(5)) for command in (("/entrypoint.sh", "true"), ("bash", "-c", source))
)
shell = sum(seconds(*command) for command in commands)
print(json.dumps({{**found, "shell_seconds": shell, "start_seconds": max(0.0, start - sourcing)}}))
EOF
RUN --network=none : {marker}; python3 /import.py {modules} >/import.json && \\
    python3 /shell.py {way} {modules} >/result.json
FROM scratch
COPY --from={marker} /result.json /
"""
"""A fresh container that imports. Then the start of an interactive shell that says what the image holds, which the usual
banner finds out by importing each framework. Then what the entrypoint takes beyond sourcing ROS."""


@dataclass(frozen=True)
class Side:
    """What one way of making the second image came to.

    Attributes:
        build_and_push_seconds: wall time of building and pushing today's image.
        registry_new_bytes: of today's image what neither yesterday's nor today's ROS image had brought: layers, config
            and manifest, as they are stored.
        pull_bytes: layers of today's image that whoever has yesterday's does not have.
        import_seconds: importing the frameworks in a fresh container, without the start of the interpreter.
        shell_seconds: starting an interactive shell with a banner that names the frameworks' versions.
        first_image_seconds: wall time of building and pushing yesterday's image.
        install_seconds: the builder's work on the framework in today's image: `pip install`; 0 where layers are joined.
        image_bytes: all layers of today's image, as they are stored.
        start_seconds: what the entrypoint takes beyond sourcing ROS; both ways stand on the same ROS image, and so on the
            same entrypoint.
    """

    build_and_push_seconds: float = 0.0
    registry_new_bytes: int = 0
    pull_bytes: int = 0
    import_seconds: float = 0.0
    first_image_seconds: float = 0.0
    install_seconds: float = 0.0
    image_bytes: int = 0
    shell_seconds: float = 0.0
    start_seconds: float = 0.0


INSIDE = ("import_seconds", "shell_seconds", "start_seconds")
"""What is measured in a container."""

PRUNE_SECONDS = 600.0
"""What removing some gigabytes from the builder's cache may take."""

ROWS = {
    "build_and_push_seconds": "second image: build and push",
    "registry_new_bytes": "second image: new in the registry",
    "pull_bytes": "to pull after a change of ROS",
    "import_seconds": "import, in a fresh container",
    "shell_seconds": "interactive shell, with versions",
    "first_image_seconds": "first image: build and push",
    "image_bytes": "an image, compressed",
}
"""What is shown of both sides, with the ratio, in this order."""


@dataclass(frozen=True)
class Comparison:
    """Both ways side by side.

    Attributes:
        target: the image that was built.
        ours, usual: what each came to.
        versions: what was imported, the same in both.
        packages: how many packages the locks pin.
        assembling_seconds: the builder's work of assembling parts, once for all images of a stack; 0 if they were
            there already.
        compression: how layers were compressed and pushed, on both sides.
        left: manifests that could not be removed from the registry.
    """

    target: str
    ours: Side
    usual: Side
    versions: dict[str, str]
    packages: int
    assembling_seconds: float
    compression: str = COMPRESSION
    left: tuple[str, ...] = ()

    @property
    def ratios(self) -> dict[str, float | None]:
        """How many times as much the usual way takes, by row; None where ours takes nothing."""
        ours, usual = asdict(self.ours), asdict(self.usual)
        return {row: usual[row] / ours[row] if ours[row] else None for row in ROWS}

    def to_json(self) -> dict[str, Any]:
        """For `--json`: units are in the names."""
        return {**asdict(self), "left": list(self.left), "ratios": self.ratios}


def require_comparable(image: Image, image_set: ImageSet, root: Path) -> None:
    """Checks, before anything is set up, that an image can be built in both ways.

    Args:
        image: what is to be compared.
        image_set: all that the matrix describes.
        root: the checkout with the locks.

    Raises:
        RosmlError: there is no framework to compare, a lock is missing, or pip would need another index (exit code 2).
    """
    require_buildable(image, base_images.native_architecture())
    if not frameworks(image, image_set):
        raise RosmlError(
            f"{image.target} has no framework: there is nothing to compare",
            "take an image with PyTorch or TensorFlow: rosml list torch",
            exit_code=2,
        )
    for name, version in pins(image, image_set, root).items():
        if "+" in version:
            raise RosmlError(
                f"{name} {version} is on PyTorch's own index alone, where pip does not look by itself",
                "take a target of another stack: rosml list cu128",
                exit_code=2,
            )


def frameworks(image: Image, image_set: ImageSet) -> tuple[str, ...]:
    """What is imported: the modules of an image's frameworks."""
    return tuple(item.name for item in image.brought if item.released)


def locks(image: Image, image_set: ImageSet) -> tuple[str, ...]:
    """The locks of an image's parts for this machine's architecture, relative to the checkout."""
    parts = [image_set.part_by_name[name] for name in image.parts]
    architecture = base_images.native_architecture()
    return tuple(part.locks[part.architectures.index(architecture)] for part in parts)


def pins(image: Image, image_set: ImageSet, root: Path) -> dict[str, str]:
    """What is installed in both ways: packages and their versions."""
    found: dict[str, str] = {}
    for path in locks(image, image_set):
        found.update(lock_file.versions((root / path).read_text()))
    return found


def needed_mb(image_set: ImageSet, image: Image, built: set[str]) -> int:
    """Megabytes that a comparison takes: ours as `rosml image` does, and the usual image twice, each unpacked in the
    builder and compressed in builder and registry; pip keeps all wheels of one beside it until it is done."""
    sizes = [image_set.part_by_name[name].disk for name in image.parts]
    unpacked, compressed = sum(size.unpacked for size in sizes), sum(size.compressed for size in sizes)
    usual = len(DAYS) * (unpacked + 2 * compressed) + compressed
    return disk.needed_mb(image_set, image, built) + usual


def compare(here: Here, target: str) -> Comparison:
    """Builds and measures both ways, and removes from the registry what it pushed.

    Args:
        here: with a namespace of the bench's own.
        target: an image with a framework.

    Raises:
        RosmlError: unknown target, nothing to compare, no room, a service is down, a build failed.
    """
    image = here.image_set.image(target)
    services = here.services
    require_comparable(image, here.image_set, services.root)
    services.require_registry()
    services.require_builder()
    needed = needed_mb(here.image_set, image, set())
    disk.require(services.state, needed, f"{image.target} in both ways")
    bench = _Bench(here, image, secrets.token_hex(6))
    try:
        found = bench.measure()
    finally:
        left = bench.clean()
    return replace(found, left=tuple(left))


@dataclass(frozen=True)
class _Pushed:
    """An image that was pushed: repository and digest, seconds of wall time, and what the builder did."""

    reference: str
    seconds: float
    progress: BuildProgress

    def seconds_of(self, command: str) -> float:
        """Seconds of the steps whose command line has some text in it."""
        return sum(step.seconds for step in self.progress.steps.values() if command in step.name)


@dataclass
class _Bench:
    """One comparison.

    Attributes:
        here, image: what is compared.
        run: tells this comparison's steps in the builder from all others'.
        pushed: manifests that are to be removed.
    """

    here: Here
    image: Image
    run: str
    variables: dict[str, str] = field(default_factory=dict)
    pushed: list[str] = field(default_factory=list)

    def measure(self) -> Comparison:
        """All builds and imports, one after the other."""
        image_set, image, say = self.here.image_set, self.image, self.here.say
        say("base image")
        self.variables = self.here.variables(image)
        self._write()

        say(f"{image.parent}, yesterday's and today's")
        parent = image_set.by_target[image.parent].repository
        ros = {day: self._push(self._name("ros", day), parent, "").reference for day in DAYS}

        ours, usual = {}, {}
        for day in DAYS:
            say(f"{day}'s image, ours: joined with parts")
            ours[day] = self._push(image.target, image.repository, ros[day])
            say(f"{day}'s image, the usual way: pip install")
            usual[day] = self._push(self._name("usual", day), image.repository, ros[day])
            if day == "yesterday":  # gigabytes that would push the parts out of the builder's cache
                self._prune(self._name("usual", day))

        say(f"import {', '.join(frameworks(image, image_set))} in fresh containers")
        both = {"ours": ours["today"].reference, "usual": usual["today"].reference}
        imports = [{way: self._import(way, number, both[way]) for way in both} for number in range(ROUNDS)]
        versions = [imported[way]["versions"] for imported in imports for way in both]
        if any(others != versions[0] for others in versions):
            raise RosmlError(f"the two ways did not install the same: {versions[0]} and {versions[1]}")

        best = {way: {key: min(imported[way][key] for imported in imports) for key in INSIDE} for way in both}
        return Comparison(
            target=image.target,
            ours=replace(self._side(ours, ros), **best["ours"]),
            usual=replace(self._side(usual, ros), **best["usual"]),
            versions=versions[0],
            packages=len(pins(image, image_set, self.here.services.root)),
            assembling_seconds=ours["yesterday"].seconds_of("/assemble.sh"),
        )

    def clean(self) -> list[str]:
        """Removes what was pushed, and the builder's cache of it; returns the manifests that could not be removed."""
        left = []
        for reference in self.pushed:
            try:
                regctl.regctl(self.here.services, "manifest", "delete", reference)
            except RosmlError:
                left.append(reference)
        self._prune(self._name())
        self._prune(f"{self.here.prefix}/")
        if left:
            self.here.say(f"left in the registry, without a tag: {', '.join(left)}")
        return left

    def _name(self, *words: str) -> str:
        """A bake target, a stage and a marker in one: ``bench-0123456789ab-usual-today``."""
        return "-".join(("bench", self.run, *words))

    @property
    def _file(self) -> Path:
        return self.here.services.state / "bake" / f"bench-{self.image.target}.hcl"

    def _write(self) -> None:
        """The bake file: ours as it always is, the usual one, and what both need."""
        image_set, image = self.here.image_set, self.image
        requirements = " ".join(f"--requirement /{path}" for path in locks(image, image_set))
        dockerfiles = {
            **{self._name("ros", day): CHANGE for day in DAYS},
            **{self._name("usual", day): USUAL for day in DAYS},
            **{self._name(way, str(number)): IMPORT for way in ("ours", "usual") for number in range(ROUNDS)},
        }
        blocks = [
            hcl.block(
                "target",
                name,
                {
                    "inherits": ["_common"],
                    "dockerfile-inline": text.format(
                        marker=name,
                        requirements=requirements,
                        modules=" ".join(frameworks(image, image_set)),
                        way="usual" if "usual" in name else "ours",
                    ),
                    "platforms": [self.variables["PLATFORM"]],
                    "contexts": {"ros": f"target:{image.parent}"} if text is CHANGE else {},
                },
            )
            for name, text in dockerfiles.items()
        ]
        self._file.parent.mkdir(parents=True, exist_ok=True)
        files.write(self._file, "\n".join([bake_file.excerpt(image_set, (image.target,)), *blocks]))

    def _push(self, target: str, repository: str, ros: str) -> _Pushed:
        """Builds a target on a ROS image, or on the bake file's own, and pushes it by digest."""
        repository = f"{self.here.prefix}/{repository}"
        sets = [f"{target}.tags="] if target == self.image.target else []
        if ros:
            sets.append(f"{target}.contexts.ros=docker-image://{ros}")
        start = time.monotonic()
        progress, digest = push_by_digest(self.here.services, self._call(target, sets), repository)
        seconds = time.monotonic() - start
        reference = f"{repository}@{digest}"
        self.pushed.append(reference)
        return _Pushed(reference, seconds, progress)

    def _call(self, target: str, sets: Sequence[str]) -> buildx.Bake:
        name = target.replace(f"-{self.run}", "") if self.run in target else f"bench-{target}"
        return buildx.Bake(target, name, self._file, sets, self.variables)

    def _import(self, way: str, number: int, reference: str) -> dict[str, Any]:
        """Seconds and versions of an import in a container that has just been made."""
        name = self._name(way, str(number))
        folder = self.here.services.state / "bench" / way
        shutil.rmtree(folder, ignore_errors=True)
        sets = (f"{name}.contexts.image=docker-image://{reference}", f"{name}.output=type=local,dest={folder}")
        buildx.run(self.here.services, self._call(name, sets))
        try:
            content = json.loads((folder / "result.json").read_text())
            return {**{key: float(content[key]) for key in INSIDE}, "versions": dict(content["versions"])}
        except (OSError, ValueError, TypeError, KeyError) as error:
            raise RosmlError(f"importing in {reference} gave no result: {error}", "run it again") from None

    def _side(self, images: dict[str, _Pushed], ros: dict[str, str]) -> Side:
        """What a way came to, from its two images."""
        services, today, yesterday = self.here.services, images["today"], images["yesterday"]
        there = {**stored(services, yesterday.reference), **stored(services, ros["today"])}
        pulled = {layer.digest for layer in regctl.layers(services, yesterday.reference)}
        layers = regctl.layers(services, today.reference)
        now = stored(services, today.reference)
        return Side(
            build_and_push_seconds=today.seconds,
            registry_new_bytes=sum(size for digest, size in now.items() if digest not in there),
            pull_bytes=sum(layer.size for layer in layers if layer.digest not in pulled),
            first_image_seconds=yesterday.seconds,
            install_seconds=today.seconds_of("pip install"),
            image_bytes=sum(layer.size for layer in layers),
        )

    def _prune(self, words: str) -> None:
        """Removes from the builder's cache what is described with some words: a marker, or where it was pulled from."""
        services = self.here.services
        argv = [*services.buildx, "prune", "--force", "--all", "--filter", f"description~={words}"]
        with suppress(OSError, subprocess.TimeoutExpired):  # the builder forgets them by itself, only later
            subprocess.run(
                [*argv, "--builder", services.builder],
                env=services.environment(),
                stdin=subprocess.DEVNULL,
                capture_output=True,
                timeout=PRUNE_SECONDS,
                check=False,
            )


def print_table(found: Comparison) -> None:
    """Prints both ways side by side, and what has to be known to judge them."""
    numbers = ("ours", "RUN pip install", "ratio")
    made = table(found.target, *numbers, right=numbers)
    for row in cells(found.to_json()):
        made.add_row(*row)
    show(made)
    out = console()
    for line in notes(found):
        out.print(line, style="dim")


def cells(found: Mapping[str, Any]) -> list[tuple[str, str, str, str]]:
    """The rows of both ways side by side, for people: what was measured, ours, the usual way's, ratio.

    Args:
        found: as `Comparison.to_json` gives it.
    """
    rows = []
    for row, title in ROWS.items():
        ours, usual = (shown(row)(found[way][row]) for way in ("ours", "usual"))
        rows.append((title, ours, usual, times(found["ratios"][row])))
    return rows


def shown(row: str) -> Callable[[Any], str]:
    """How a row's numbers are shown, which its name's unit tells."""
    return duration if row.endswith("_seconds") else size


def times(ratio: float | None) -> str:
    """``12.34`` -> ``12 x``; small ones keep a decimal, and beyond a thousand it is no measure any more."""
    if ratio is None:
        return ""
    if ratio > 1_000:
        return "> 1,000 x"
    return f"{ratio:.0f} x" if ratio >= 10 else f"{ratio:.1f} x"


def notes(found: Comparison) -> list[str]:
    """What was measured, and how."""
    versions = ", ".join(f"{name} {version}" for name, version in found.versions.items())
    assembled = (
        f"{duration(found.assembling_seconds)} of work in this run" if found.assembling_seconds else "before this run"
    )
    return [
        f"{versions}: the same {found.packages} pinned packages both ways, {found.compression.split(',oci')[0]}",
        f"pip's download and installation took {duration(found.usual.install_seconds)} of the usual second image",
        f"the parts of ours were assembled once, {assembled}",
        "the usual banner imports each framework to ask for its version",
        f"our entrypoint takes {found.ours.start_seconds * 1000:.0f} ms beyond sourcing ROS",
        "ROS's change is a file of some bytes; a real one adds its own size to the pull both ways",
        "nothing was tagged, and the manifests are removed; their layers stay until 'rosml setup clean', which removes all there is",
    ]


def stored(services: Services, reference: str) -> dict[str, int]:
    """All that a registry stores for an image manifest, in bytes by digest: its layers, its config, and itself.

    Args:
        reference: the repository, and the manifest's digest after an ``@``.
    """
    content = regctl.manifest(services, reference)
    entries = {entry["digest"]: int(entry["size"]) for entry in (*content["layers"], content["config"])}
    descriptor = regctl.regctl(services, "manifest", "head", "--format", "{{.GetDescriptor.Size}}", reference)
    return {**entries, reference.rpartition("@")[2]: int(descriptor)}
