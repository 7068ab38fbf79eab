"""The text of a lock: reads its pins, and checks whether it is the one that a part needs now."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from fnmatch import fnmatchcase

from rosml.images.image_set.model import Environment, Part, Wheels
from rosml.images.matrix import names
from rosml.images.matrix.combinations import remembered
from rosml.images.matrix.model import Matrix, Release
from rosml.images.matrix.patterns import NAME, PYTHON

_PIN = re.compile(r"\n([A-Za-z0-9._-]+)==([^\s;\\]+)")
"""A pin at the beginning of a line. A pattern that begins with a plain character finds its places faster than `^`."""

_PINNED = r"[A-Za-z0-9][A-Za-z0-9._-]*==[A-Za-z0-9.+!_-]+"

_WHOLE = re.compile(
    r"((?:#[^\n]*\n)+)"
    rf"(?:{_PINNED}(?: \\\n    --hash=sha256:[0-9a-f]{{64}})+\n)+"
)
"""A complete lock as `locks/lock.py` writes it: comments, and versions with hashes. Any other text was cut or edited."""


NVIDIA_PACKAGES = {"cuda": "cuda-runtime", "cudnn": "cudnn", "nccl": "nccl"}
"""A stack's facts of CUDA, and the packages with these versions, without `nvidia-` and a generation."""


_ENVIRONMENT = re.compile(
    rf"# Environment '(?P<name>{NAME.strip('^$')})', Python (?P<python>{PYTHON.strip('^$')}), (?P<architecture>[a-z0-9]+), glibc 2\.(?P<glibc>[1-9][0-9])\.\n"
    r"# Made by 'rosml env add' from environment\.toml; do not edit\.\n"
    rf"# releases:(?P<releases>( {_PINNED})*)\n"
    rf"# takes:(?P<takes>( {_PINNED})*)\n"
    rf"({_PINNED}( \\\n    --hash=sha256:[0-9a-f]{{64}})+\n)*"
)
"""A complete lock of an environment. Any other text was cut or edited."""


@dataclass(frozen=True)
class EnvironmentHead:
    """What the lock of an environment begins with. `takes` are the image's packages that it uses, with their versions; `releases` are those
    of them that images are named by, such as torch."""

    name: str
    python: str
    architecture: str
    glibc: int
    takes: Mapping[str, str]
    releases: Mapping[str, str]


def environment_head(text: str) -> EnvironmentHead | None:
    """The head of an environment's lock; None if rosml did not write the text so, to its end."""
    if not (whole := _ENVIRONMENT.fullmatch(text)):
        return None
    takes, releases = (dict(item.split("==", 1) for item in whole[kind].split()) for kind in ("takes", "releases"))
    return EnvironmentHead(whole["name"], whole["python"], whole["architecture"], int(whole["glibc"]), takes, releases)


def versions(text: str) -> dict[str, str]:
    """The pins of a lock: packages and their versions."""
    return dict(_PIN.findall(f"\n{text}"))


def package_name(requirement: str) -> str:
    """``tensorflow_cpu[x]==2.20.0`` -> ``tensorflow-cpu``: https://packaging.python.org/specifications/name-normalization/"""
    return re.sub(r"[-_.]+", "-", re.split(r"[\[(=<>!~;@\s]", requirement.strip(), maxsplit=1)[0]).lower()


def cuda_packages(cuda: str) -> Iterator[tuple[str, str]]:
    """Facts of a stack, and the packages with these versions, for a version of CUDA. Up to CUDA 12, the names of NVIDIA's packages
    end in its generation; later only some do."""
    for fact, package in NVIDIA_PACKAGES.items():
        yield fact, f"nvidia-{package}"
        yield fact, f"nvidia-{package}-cu{cuda.split('.')[0]}"


def current_environment(text: str, part: Environment, architecture: str) -> bool:
    """Whether a text is the lock of an environment, and takes what its locks for other architectures take."""
    head = environment_head(text)
    same = (part.environment, part.python, architecture, part.glibc, part.takes)
    return head is not None and (head.name, head.python, head.architecture, head.glibc, head.releases) == same


def current(text: str, part: Part, matrix: Matrix, architecture: str) -> bool:
    """Whether a text is the part's lock: its head says so, it is complete, and its pins match the stack's facts."""
    head = names.lock_head(part.stack, architecture, part.python, part.kind)
    if not text.startswith(f"{head}\n") or not (whole := _WHOLE.fullmatch(text)):
        return False
    pinned, stack, entry = versions(text), matrix.stacks[part.stack], matrix.part[part.kind]
    if any(pinned.get(name) != version for name, version in _beside(matrix, part.stack, part.kind).items()):
        return False
    if entry.release:
        requirement = stack.requirement(entry.release, architecture) or ""
        version = stack.releases[entry.release]
        if pinned.get(package_name(requirement), "").partition("+")[0] != version:
            return False
        return entry.name != entry.release or _adapted(whole[1], matrix.releases[entry.release][version], entry.name)
    for requirement in entry.added(stack.cuda):
        added = pinned.get(package_name(requirement))
        if added is None or not fnmatchcase(added, requirement.partition("==")[2] or "*"):
            return False
    if entry.versions:
        facts = {package: getattr(stack, fact) for fact, package in cuda_packages(stack.cuda or "")}
        return all(pinned[package] == fact for package, fact in facts.items() if package in pinned and fact)
    return True


@remembered
def _beside(matrix: Matrix, stack: str, kind: str) -> dict[str, str]:
    """The packages that go with releases of a stack and are in a part: in the one that takes them, or else in the release's own."""
    versions: dict[str, str] = {}
    for family, version in matrix.stacks[stack].releases.items():
        for name, requirement in matrix.releases[family][version].company(stack).items():
            takers = [part.name for part in matrix.parts if any(fnmatchcase(name, pattern) for pattern in part.takes)]
            if kind in (takers or [family]):
                versions[name] = requirement
    return versions


def _adapted(comments: str, release: Release, package: str) -> bool:
    """Whether the comments of the lock of a release's own part have the adapted requirements."""
    begin = names.adapted_line(package, "")
    adapted = [line for line in comments.splitlines() if line.startswith(begin)]
    return adapted == adapted_lines(release, package)


def adapted_lines(release: Release, package: str) -> list[str]:
    """The lines of a lock with the adapted requirements of a release's package."""
    return [names.adapted_line(package, f"{name}{bound}") for name, bound in sorted(release.adapted.items())]


def current_wheels(text: str, wheels: Wheels, architecture: str) -> bool:
    """Whether a text is the lock of ROS's wheels: its head says so, it is complete, and it pins the requirements of the matrix."""
    head = names.wheels_head(wheels.distribution, architecture, wheels.python)
    if not text.startswith(f"{head}\n") or not _WHOLE.fullmatch(text):
        return False
    pinned = versions(text)
    return all(
        pinned.get(package_name(requirement)) == requirement.partition("==")[2] for requirement in wheels.requirements
    )
