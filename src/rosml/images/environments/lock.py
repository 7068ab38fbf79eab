"""Locks of environments: what is installed into one on an image, and what it takes from that image.

An environment sees the image's Python packages. Those that fit stay the image's: PyTorch, with all that it needs, is there once. The
others are resolved anew, so numpy may be another one than ROS's.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from rosml.base import files
from rosml.base.errors import RosmlError
from rosml.images.environments.declaration import Declaration
from rosml.images.image_set.lock_file import EnvironmentHead, environment_head, package_name
from rosml.images.join.label_claims import LONGEST
from rosml.images.locks import resolve
from rosml.images.locks.resolve import Pin
from rosml.images.locks.uv import Uv, compile_command


@dataclass(frozen=True)
class Provider:
    """An image for one architecture, on which an environment stands."""

    name: str  # as the user wrote it
    architecture: str
    python: str  # such as 3.11
    glibc: int  # the N of its glibc 2.N
    wheels: str  # uv's name of its wheel platform
    packages: Mapping[str, str]  # versions of the packages of its parts, by their normalized names
    releases: Collection[str] = ()  # those of them that the image is named by: torch

    @property
    def pinned(self) -> dict[str, str]:
        """Its packages with the versions that an index has: one of PyTorch's own index has more behind a plus."""
        return {name: version.partition("+")[0] for name, version in self.packages.items()}

    @property
    def pinned_releases(self) -> dict[str, str]:
        return {name: version for name, version in self.pinned.items() if name in self.releases}


@dataclass(frozen=True)
class Lock(EnvironmentHead):
    """What an environment has for an architecture."""

    pins: tuple[Pin, ...] = ()

    def __str__(self) -> str:
        """Its text, which has no date, no image and no index: the same resolution gives the same bytes."""
        lines = [
            f"# Environment '{self.name}', Python {self.python}, {self.architecture}, glibc 2.{self.glibc}.",
            "# Made by 'rosml env add' from environment.toml; do not edit.",
            f"# releases:{_pinned(self.releases)}",
            f"# takes:{_pinned(self.takes)}",
        ]
        return "\n".join([*lines, *map(str, self.pins)]) + "\n"


def _pinned(versions: Mapping[str, str]) -> str:
    return "".join(f" {name}=={version}" for name, version in sorted(versions.items()))


FILES = "3.*/*.txt"
"""The locks in the folder of an environment: each below its Python, named by its architecture."""


def file_of(folder: Path, python: str, architecture: str) -> Path:
    """The lock of an environment for a Python and an architecture, in the environment's folder."""
    return folder / python / f"{architecture}.txt"


def read(file: Path) -> Lock:
    """A lock. Raises a RosmlError if it is not whole, or not in its place."""
    lock = parse(files.text(file))
    if lock is None or (lock.python, lock.architecture) != (file.parent.name, file.stem):
        text = f"{file} was cut or edited"
        raise RosmlError(text, f"make it again: rosml env add {file.parents[1].name}", exit_code=2)
    return lock


def parse(text: str) -> Lock | None:
    """The lock of a text; None if rosml did not write it so: each package is there once, and releases are among what it takes."""
    head = environment_head(text)
    if not head or len(head.name) > LONGEST:
        return None
    lock = Lock(**vars(head), pins=tuple(resolve.parse(text)))
    packages = [package_name(name) for name in (*lock.takes, *(pin.name for pin in lock.pins))]
    is_ours = str(lock) == text and len({*packages}) == len(packages) and lock.releases.items() <= lock.takes.items()
    return lock if is_ours else None


class NoSolution(RosmlError):
    """Requirements that no set of wheels meets beside an image's releases. `reason` is uv's."""

    def __init__(self, text: str, reason: str) -> None:
        super().__init__(f"{text}:\n{reason}", exit_code=2)
        self.reason = reason


def resolved(name: str, declaration: Declaration, provider: Provider, uv: Uv, previous: str = "") -> Lock:
    """Resolves an environment on an image. It takes as much of the image as fits, and in any case the releases: PyTorch.

    Args:
        previous: the text of the lock before, whose versions stay if they fit.

    Raises:
        NoSolution: it does not go with the image's releases, or by itself.
    """
    reason = ""
    for kept in (provider.pinned, provider.pinned_releases):
        pins, reason = _pins(declaration, provider, kept, uv, previous)
        if pins is not None:
            return _lock(name, declaration, provider, pins)
    raise NoSolution(f"{name} does not go with {provider.name} ({provider.architecture})", reason)


def fits(declaration: Declaration, provider: Provider, releases: Mapping[str, str], uv: Uv) -> bool:
    """Whether an environment goes with these releases, on the Python and system of an image."""
    return _pins(declaration, provider, releases, uv, "")[0] is not None


def _pins(
    declaration: Declaration, provider: Provider, kept: Mapping[str, str], uv: Uv, previous: str
) -> tuple[list[Pin] | None, str]:
    """What uv resolves beside packages in their versions; None with uv's reason if there is no solution."""
    inputs = {
        "in.txt": "".join(f"{item}\n" for item in declaration.requirements),
        "constraints.txt": "".join(f"{name}=={version}\n" for name, version in sorted(kept.items())),
        # No Python is below 3: so it is left out.
        "overrides.txt": "".join(f"{item}; python_version < '3'\n" for item in declaration.without),
    }
    options = ["--generate-hashes", "--no-header", "--annotation-style", "split", "--no-emit-index-url"]
    files_of = ["--constraint", "constraints.txt", "--override", "overrides.txt", "in.txt"]
    earlier = {"out.txt": previous} if previous else {}
    status, text, errors = uv.compile(
        [*compile_command(provider.python, provider.wheels), *options, *files_of], inputs | earlier
    )
    if status == 0:
        return resolve.parse(text), ""
    if "No solution found" not in errors:
        remedy = "check the requirements, and that the index answers"
        raise RosmlError(f"uv resolves nothing for {provider.architecture}:\n{errors.strip()}", remedy)
    return None, errors.strip()


def _lock(name: str, declaration: Declaration, provider: Provider, pins: Sequence[Pin]) -> Lock:
    """A lock of what the image lacks. What only its packages need, such as CUDA for PyTorch, is the image's matter."""
    by_name, needs = {pin.name: pin for pin in pins}, dict[str, list[str]]()
    for pin in pins:
        for parent in pin.wanted_by:
            needs.setdefault(parent, []).append(pin.name)
    takes, installed = dict[str, str](), dict[str, Pin]()
    todo = [package_name(item) for item in declaration.requirements]
    while todo:
        package = todo.pop()
        if package not in by_name or package in takes or package in installed:
            continue
        chosen = by_name[package]
        if provider.pinned.get(package) == chosen.version:
            takes[package] = chosen.version
        else:
            installed[package] = chosen
            todo += needs.get(package, ())
    ordered = tuple(installed[package] for package in sorted(installed))
    releases = {package: version for package, version in takes.items() if package in provider.releases}
    return Lock(name, provider.python, provider.architecture, provider.glibc, takes, releases, ordered)
