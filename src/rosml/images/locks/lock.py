"""Hash-pinned locks: resolves a stack once, and splits the result into parts.

A stack is resolved as a whole, so that its releases, CUDA and numpy agree, and written as one requirements file per part. The
packages of a part follow from the dependency graph and its entry in matrix.yaml:

* a part with the name of a release has the packages that only this release needs
* a part that `takes` packages has these, whatever needs them: NVIDIA's libraries. An exact name goes before a pattern
* a part that `adds` packages has them although no release asks for them: C++ headers of CUDA
* a part that `repeats` packages has them once more: those of its release, or, without a release, any
* the `shared` part has numpy and the packages that several releases need

A distribution whose ROS comes from wheels is resolved like a stack. Its only part, ``ros``, has everything that the operating
system lacks.
"""

from __future__ import annotations

import fnmatch
from collections import Counter
from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import NamedTuple

from rosml.base.errors import RosmlError
from rosml.images.image_set.lock_file import package_name, versions
from rosml.images.image_set.model import ImageSet
from rosml.images.locks.requests import Request, requests
from rosml.images.locks.resolve import Pin, Unreachable, parse, require_one_cuda, resolve
from rosml.images.locks.uv import Uv
from rosml.images.matrix import names
from rosml.images.matrix.model import ANY_PYTHON, PartEntry


def closure(root: str, pins: Iterable[Pin]) -> frozenset[str]:
    """The names of all packages that `root` needs, including itself."""
    children: dict[str, set[str]] = {}
    for pin in pins:
        for parent in pin.wanted_by:
            children.setdefault(parent, set()).add(pin.name)
    seen: set[str] = set()
    todo = [root]
    while todo:
        name = todo.pop()
        if name not in seen:
            seen.add(name)
            todo.extend(children.get(name, ()))
    return frozenset(seen)


def split(
    pins: list[Pin],
    roots: Mapping[str, str],
    parts: Sequence[PartEntry],
    beside: Mapping[str, Sequence[str]] | None = None,
) -> dict[str, list[Pin]]:
    """Assigns every package to a part, and repeated ones to several. `roots` and `beside` are those of `Request`."""
    families = {family: [requirement, *(beside or {}).get(family, ())] for family, requirement in roots.items()}
    needs = {
        family: frozenset[str]().union(*(closure(package_name(requirement), pins) for requirement in requirements))
        for family, requirements in families.items()
    }
    shared = closure("numpy", pins)
    common = shared_part(parts)
    pins_by_part: dict[str, list[Pin]] = {part.name: [] for part in parts}
    for pin in pins:
        owners = [framework for framework, names in needs.items() if pin.name in names]
        takers = [part.name for part in parts if pin.name in part.takes]
        takers = takers or [part.name for part in parts if _among(pin, part.takes)]
        if not takers:
            takers = [common] if pin.name in shared or len(owners) != 1 else owners
        takers += [part.name for part in parts if part.release in (None, *takers) and _among(pin, part.repeats)]
        for name in takers:
            pins_by_part[name].append(pin)
    return {part: sorted(content, key=lambda pin: pin.name) for part, content in pins_by_part.items() if content}


def shared_part(parts: Sequence[PartEntry]) -> str:
    return next(part.name for part in parts if part.shared)


def _among(pin: Pin, patterns: Sequence[str]) -> bool:
    return any(fnmatch.fnmatchcase(pin.name, pattern) for pattern in patterns)


def render(request: Request, part: str, pins: list[Pin]) -> str:
    """The text of a part's lock. It has no index and no date, so the same resolution gives the same bytes."""
    lines = [
        names.wheels_head(request.stack, request.architecture, request.python)
        if request.ros
        else names.lock_head(request.stack, request.architecture, _python(request, part), part),
        "# Made by 'rosml locks' from matrix.yaml; do not edit.",
        *request.adapted.get(part, ()),
    ]
    return "\n".join([*lines, *map(str, pins)]) + "\n"


@dataclass(frozen=True)
class Locks:
    """The text of every lock, by path, and requests that got no new lock, with the reason."""

    texts: Mapping[str, str]
    left_out: Mapping[str, str]


def lock(
    image_set: ImageSet,
    root: Path,
    uv: str = "uv",
    upgrade: bool = False,
    say: Callable[[str], None] = lambda line: None,
    stacks: Collection[str] = (),
) -> Locks:
    """Resolves everything; writes nothing. Unless `upgrade`, the versions of earlier locks in `root` stay if they fit.

    If PyTorch's own index does not answer, wheels that only that index has are left out. Their locks from an earlier call stay. If the
    rest of the stack has all its locks, these stay as well; otherwise it is locked without those wheels.
    """
    chosen = [request for request in requests(image_set) if not stacks or request.stack in stacks]
    run = Uv(uv)
    outcomes = run.for_each(
        chosen,
        lambda request: _outcome(request, root, run, upgrade),
        "locks",
        lambda number, outcome: say(f"[{number} of {len(chosen)}] {outcome.request}: resolved"),
    )
    pins: dict[str, dict[str, Pin]] = {}
    heads: dict[str, tuple[Request, str]] = {}
    texts: dict[str, str] = {}
    for outcome in outcomes:
        texts |= outcome.kept
        for part, part_pins in _parts(outcome).items():
            path = _path(outcome.request, part)
            heads[path] = (outcome.request, part)
            pins[path] = _merged(path, pins.get(path, {}), part_pins)
    for path, path_pins in pins.items():
        texts[path] = render(*heads[path], sorted(path_pins.values(), key=lambda pin: pin.name))
    return Locks(texts, {name: reason for outcome in outcomes for name, reason in outcome.left_out.items()})


@dataclass(frozen=True)
class _Outcome:
    """The pins of a request, earlier locks that stay as they are, and requests that got none, with the reason."""

    request: Request
    pins: list[Pin] = field(default_factory=list)
    kept: Mapping[str, str] = field(default_factory=dict)
    left_out: Mapping[str, str] = field(default_factory=dict)


def _outcome(request: Request, root: Path, uv: Uv, upgrade: bool) -> _Outcome:
    earlier = {
        str(file.relative_to(root)): file.read_text(errors="replace")
        for python in (request.python, ANY_PYTHON)
        for file in sorted((root / "locks" / request.stack / request.architecture / python).glob("*.txt"))
    }
    # An earlier lock gives only versions. Hashes come from the index again, as a wrong one would stay for ever.
    previous = "".join(f"{pin.name}=={pin.version}\n" for text in earlier.values() for pin in parse(text))
    left_out, kept = dict[str, str](), dict[str, str]()
    try:
        pins = resolve(request, uv, upgrade, previous)
    except Unreachable as error:
        if all(_path(request, part) in earlier for part in (shared_part(request.parts), *request.roots)):
            return _Outcome(request, kept=earlier, left_out={str(request): error.message})
        away = {family: requirement for family, requirement in request.roots.items() if family in request.elsewhere}
        paths = [_path(request, part.name) for part in request.parts if part.release in away]
        kept = {path: earlier[path] for path in paths if path in earlier}
        left_out = {str(replace(request, roots=away)): error.message}
        here = {family: requirement for family, requirement in request.roots.items() if family not in away}
        request = replace(request, roots=here, elsewhere={})
        # What was resolved with a lock that stays has to go with it.
        pins = resolve(request, uv, upgrade and not kept, previous) if here else []
    require_one_cuda(request, pins)
    return _Outcome(request, pins, kept, left_out)


def _parts(outcome: _Outcome) -> dict[str, list[Pin]]:
    """The pins of a request, by part. ROS gets no numpy, as the operating system has it."""
    if outcome.request.ros:
        return {names.ROS: [pin for pin in outcome.pins if pin.name != "numpy"]}
    return split(outcome.pins, outcome.request.roots, outcome.request.parts, outcome.request.beside)


def _path(request: Request, part: str) -> str:
    return names.lock_path(request.stack, request.architecture, _python(request, part), part)


def _python(request: Request, part: str) -> str:
    """The Python version of a part's lock; some parts fit every Python."""
    return ANY_PYTHON if any(item.name == part and item.any_python for item in request.parts) else request.python


def _merged(path: str, pins: Mapping[str, Pin], new_pins: Sequence[Pin]) -> dict[str, Pin]:
    """The pins of two resolutions for a common part, which must agree: CUDA for all Pythons, numpy if frameworks are resolved apart."""
    merged = dict(pins)
    for pin in new_pins:
        other = merged.setdefault(pin.name, pin)
        if (other.version, other.hashes) != (pin.version, pin.hashes):
            raise RosmlError(
                f"{path}: {pin.name} would be {other.version} and {pin.version}, depending on the package that asks",
                "pin it in the stack's constraints in matrix.yaml",
            )
    return merged


class Move(NamedTuple):
    """A package that moved in a stack. A version is empty if the package is new or gone."""

    stack: str
    package: str
    before: str
    after: str


def moves(earlier: Mapping[str, str], later: Mapping[str, str]) -> Counter[Move]:
    """The moves between texts of locks, by path, each with the number of locks."""
    counted: Counter[Move] = Counter()
    for path, text in later.items():
        before, after = versions(earlier.get(path, "")), versions(text)
        for name in before.keys() | after.keys():
            if before.get(name) != after.get(name):
                counted[Move(path.split("/")[1], name, before.get(name, ""), after.get(name, ""))] += 1
    return counted
