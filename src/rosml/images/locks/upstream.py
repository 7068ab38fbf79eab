"""Newer releases on the package index than in a stack: their dates, and the reasons why the stack cannot have them.

We ask uv for the newest release with a wheel for a stack's Python and architecture, then whether the stack still resolves with it and
with its own CUDA.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass, replace

from rosml.base.errors import RosmlError
from rosml.base.problems import counted
from rosml.images.image_set.lock_file import package_name
from rosml.images.image_set.model import ImageSet
from rosml.images.locks import pylock
from rosml.images.locks.requests import Request, requests
from rosml.images.locks.resolve import require_one_cuda, resolve
from rosml.images.locks.uv import Uv, compile_command


@dataclass(frozen=True, order=True)
class Newer:
    """A newer release than a stack's, for some versions of Python."""

    stack: str
    package: str
    ours: str
    newest: str
    since: str  # the day of its wheel, such as 2026-10-28; empty if the index does not tell
    held_by: str  # the reason why the stack cannot have it; empty if it can
    elsewhere: tuple[str, ...]  # stacks of the same accelerator that have it
    pythons: tuple[str, ...]


def look(
    image_set: ImageSet,
    uv: str = "uv",
    stacks: Collection[str] = (),
    say: Callable[[str], None] = lambda line: None,
) -> list[Newer]:
    """All newer releases. For each stack and Python it checks one architecture, the first whose wheels are all on the default index."""
    chosen: dict[tuple[str, str, tuple[str, ...]], Request] = {}
    for item in requests(image_set):
        if not item.ros and not item.elsewhere and (not stacks or item.stack in stacks):
            chosen.setdefault((item.stack, item.python, tuple(item.roots)), item)
    run = Uv(uv)
    results = run.for_each(
        chosen.values(),
        lambda request: (request, list(_of(image_set, request, run))),
        "stacks",
        lambda number, result: say(
            f"[{number} of {len(chosen)}] {result[0]}: {counted(len(result[1]), 'newer release')}"
        ),
    )
    return _merged(release for _, releases in results for release in releases)


def _merged(newer: Iterable[Newer]) -> list[Newer]:
    """The releases with equal ones of several Pythons merged."""
    pythons: dict[Newer, list[str]] = {}
    for item in newer:
        pythons.setdefault(replace(item, pythons=()), []).extend(item.pythons)
    return sorted(
        replace(item, pythons=tuple(sorted(versions, key=lambda version: [int(part) for part in version.split(".")])))
        for item, versions in pythons.items()
    )


def _of(image_set: ImageSet, request: Request, uv: Uv) -> Iterator[Newer]:
    families = {family: [root, *request.beside.get(family, ())] for family, root in request.roots.items()}
    packages = [package_name(requirement) for requirements in families.values() for requirement in requirements]
    newest = _newest(request, packages, uv)
    for family, requirements in families.items():
        for requirement in requirements:
            name, ours = package_name(requirement), requirement.partition("==")[2]
            version, since = newest.get(name, (ours, ""))
            if version == ours:
                continue
            held = _held(_with(image_set, request, family, requirement, version), uv)
            others = _having(image_set, request.stack, family, name, version)
            yield Newer(request.stack, name, ours, version, since, held, others, (request.python,))


def _newest(request: Request, packages: Iterable[str], uv: Uv) -> Mapping[str, tuple[str, str]]:
    """The newest version of packages with a wheel for a Python and an architecture, and the day of that wheel."""
    command = [*compile_command(request.python, request.wheels), "--no-deps", "--format", "pylock.toml", "in.txt"]
    status, text, errors = uv.compile(command, {"in.txt": "\n".join(packages) + "\n"}, "pylock.toml")
    if status != 0:
        text = f"{request}: the newest releases are unknown:\n{errors.strip()}"
        raise RosmlError(text, "check that the index answers")
    return {item.name: (item.version.partition("+")[0], _day(item)) for item in pylock.read(text)}


def _day(package: pylock.Package) -> str:
    """The day of a package's oldest wheel; empty if the index does not say it."""
    times = [str(wheel.uploaded) for wheel in package.wheels if wheel.uploaded]
    return min(times)[:10] if times else ""


def _with(image_set: ImageSet, request: Request, family: str, requirement: str, version: str) -> Request:
    """A request with another version of a package. A release goes without its companions, which follow it, but with its own facts."""
    newer = f"{requirement.partition('==')[0]}=={version}"
    if requirement == request.roots[family]:
        release = image_set.matrix.releases[family].get(version)
        adapted = release.adapted if release else {}
        overrides = {*request.overrides, *(f"{name}{bound}" for name, bound in adapted.items())}
        roots = {**request.roots, family: newer}
        alone = {**request.beside, family: ()}
        return replace(request, roots=roots, beside=alone, overrides=tuple(sorted(overrides)))
    beside = tuple(newer if item == requirement else item for item in request.beside[family])
    return replace(request, beside={**request.beside, family: beside})


def _held(request: Request, uv: Uv) -> str:
    """Why a request does not resolve, in one line; empty if it does."""
    try:
        require_one_cuda(request, resolve(request, uv))
    except RosmlError as error:
        lines = [re.sub(r"^\W+", "", line).strip() for line in error.message.splitlines()[1:]]
        if "would carry" in error.message:
            return "another CUDA: " + ", ".join(lines[:2]) + (", …" if len(lines) > 2 else "")
        text = " ".join(line for line in lines if line)
        because = text.partition("Because ")[2].partition(" And because ")[0]
        return re.sub(r"\{[^}]*\}", "", because) or text
    return ""


def _having(image_set: ImageSet, stack: str, family: str, package: str, version: str) -> tuple[str, ...]:
    """Other stacks of the same accelerator that have a version."""
    matrix = image_set.matrix
    having = []
    for name, facts in matrix.stacks.items():
        if name == stack or facts.accelerator != matrix.stacks[stack].accelerator or family not in facts.releases:
            continue
        release = matrix.releases[family][facts.releases[family]]
        versions = {**release.company(name), family: facts.releases[family]}
        if versions.get(package) == version:
            having.append(name)
    return tuple(having)
