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
import json
import os
import re
import subprocess
import sys
import tempfile
import threading
from collections import Counter
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import NamedTuple

from rosml.base import progress_bar
from rosml.base.errors import RosmlError
from rosml.base.problems import listed
from rosml.images.image_set.lock_file import adapted_lines, cuda_packages, package_name, versions
from rosml.images.image_set.model import ImageSet
from rosml.images.matrix import names, rules
from rosml.images.matrix.model import ANY_PYTHON, Matrix, PartEntry
from rosml.images.matrix.rules import NVIDIA

_PIN = re.compile(r"^(?P<name>[A-Za-z0-9._-]+)==(?P<version>[^\s;\\]+)")


@dataclass(frozen=True)
class Elsewhere:
    """A framework whose wheel only PyTorch's own index has.

    Attributes:
        requirement: the wheel with its local version, e.g. ``torch==2.10.0+cpu``.
        digest: its published sha256; empty if we have to ask that index.
        requires: the wheel's requirements, which the Python package index has.
    """

    requirement: str
    digest: str
    requires: tuple[str, ...]


@dataclass(frozen=True)
class Request:
    """A request: a stack, or the wheels of a distribution, for one Python version on one architecture.

    Attributes:
        stack: the name of the stack, e.g. ``cu128``, or of the distribution.
        architecture: ``amd64`` or ``arm64``.
        python: the version of Python, e.g. ``3.11``.
        wheels: uv's name of the wheel platform, e.g. ``x86_64-manylinux_2_28``.
        roots: the requirement of each framework, e.g. ``{"torch": "torch==2.10.0"}``; for ROS, each package's own.
        ros: whether it is for a distribution.
        numpy: the version specifier that keeps the ABI of the operating system's own numpy, e.g. ``<2``.
        constraints: further requirements of the stack.
        added: requirements of packages that parts have although no framework asks for them.
        provided: packages of the operating system that the part must not have, with their versions.
        cuda: the stack's versions of ``cuda``, ``cudnn`` and ``nccl``; empty for a stack without CUDA.
        elsewhere: frameworks whose wheels only PyTorch's own index has.
        parts: the parts that get the packages; none for ROS.
        beside: requirements of the packages that go with each framework.
        adapted: requirements of each framework that replace its wheel's, as lines of locks.
        overrides: the same as requirements.
        indexes: packages that come from another index than the usual one, and the address of that index.
    """

    stack: str
    architecture: str
    python: str
    wheels: str
    roots: Mapping[str, str]
    numpy: str
    constraints: tuple[str, ...] = ()
    added: tuple[str, ...] = ()
    provided: Mapping[str, str] = field(default_factory=dict)
    cuda: Mapping[str, str] = field(default_factory=dict)
    elsewhere: Mapping[str, Elsewhere] = field(default_factory=dict)
    parts: tuple[PartEntry, ...] = ()
    ros: bool = False
    beside: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    adapted: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    overrides: tuple[str, ...] = ()
    indexes: Mapping[str, str] = field(default_factory=dict)

    @property
    def asks_pytorch(self) -> bool:
        """Whether we have to ask PyTorch's own index, because the digest of a wheel is unknown."""
        return any(not wheel.digest for wheel in self.elsewhere.values())

    def __str__(self) -> str:
        kind = "distribution" if self.ros else "stack"
        return f"{kind} {self.stack}, Python {self.python}, {self.architecture} ({listed(list(self.roots))})"


@dataclass(frozen=True)
class Pin:
    """A locked package: its version, the hashes of its files, and the packages that require it."""

    name: str
    version: str
    hashes: tuple[str, ...]
    wanted_by: frozenset[str]


def requests(image_set: ImageSet) -> Iterator[Request]:
    """Every resolution for the parts of an image set: one per stack, Python version and architecture; one per framework if those of
    a stack contradict each other."""
    matrix = image_set.matrix
    seen: set[tuple[str, str, str]] = set()
    # Frameworks without a part have no wheel there, and would make the whole stack unresolvable.
    held = {
        (part.stack, architecture, part.python, part.kind)
        for part in image_set.parts
        for architecture in part.architectures
    }
    for part in image_set.parts:
        if part.python == ANY_PYTHON:
            continue  # comes from the resolutions for all Python versions
        system = matrix.operating_systems[part.os]
        stack = matrix.stacks[part.stack]
        for architecture in part.architectures:
            if (key := (part.stack, architecture, part.python)) in seen:
                continue
            seen.add(key)
            families = [family for family in matrix.families if (*key, family) in held]
            for together in [[family] for family in families] if stack.apart else [families]:
                requirements = {family: stack.requirement(family, architecture) for family in together}
                wheels = {family: _elsewhere(matrix, *key, family) for family in together}
                releases = {family: matrix.release(part.stack, family) for family in together}
                yield Request(
                    stack=part.stack,
                    architecture=architecture,
                    python=part.python,
                    wheels=rules.wheels(matrix, architecture, releases.values()),
                    roots={family: requirement for family, requirement in requirements.items() if requirement},
                    numpy=system.numpy,
                    constraints=stack.constraints,
                    added=tuple(
                        requirement
                        for entry in matrix.parts
                        if entry.accelerator in (None, stack.accelerator)
                        for requirement in entry.added(stack.cuda)
                    ),
                    provided=system.provides,
                    cuda={
                        fact: version
                        for fact in NVIDIA
                        if (version := getattr(stack, fact)) and stack.accelerator == "cuda"
                    },
                    elsewhere={family: wheel for family, wheel in wheels.items() if wheel},
                    parts=matrix.parts,
                    beside={
                        family: tuple(f"{name}=={version}" for name, version in release.company(part.stack).items())
                        for family, release in releases.items()
                    },
                    adapted={family: tuple(adapted_lines(release, family)) for family, release in releases.items()},
                    overrides=tuple(
                        sorted(
                            {
                                f"{name}{bound}"
                                for release in releases.values()
                                for name, bound in release.adapted.items()
                            }
                        )
                    ),
                    indexes={
                        package_name(requirement): release.index
                        for family, release in releases.items()
                        if release.index
                        for requirement in (requirements[family], *release.company(part.stack))
                        if requirement
                    },
                )
    yield from _ros_requests(image_set)


def _ros_requests(image_set: ImageSet) -> Iterator[Request]:
    matrix = image_set.matrix
    for item in image_set.wheels:
        system = matrix.operating_systems[item.os]
        for architecture in item.architectures:
            yield Request(
                stack=item.distribution,
                architecture=architecture,
                python=item.python,
                wheels=matrix.architectures[architecture].wheels,
                roots={package_name(requirement): requirement for requirement in item.requirements},
                numpy=system.numpy,
                provided=system.provides,
                ros=True,
            )


def _elsewhere(matrix: Matrix, stack: str, architecture: str, python: str, family: str) -> Elsewhere | None:
    """A framework's wheel on PyTorch's own index, if the part's wheel comes from there."""
    facts = matrix.stacks[stack]
    release = matrix.release(stack, family)
    digests = release.elsewhere.get(stack, {}).get(architecture)
    requirement = facts.requirement(family, architecture)
    if digests is None or requirement is None:
        return None
    return Elsewhere(f"{requirement}+{facts.accelerator}", digests.get(python, ""), release.requires)


class Uv:
    """Runs uv in several threads at a time. Another thread can end all of them."""

    def __init__(self, command: str = "uv") -> None:
        self.command = command
        self._running: set[subprocess.Popen[str]] = set()
        self._ended = False
        self._lock = threading.Lock()

    def __call__(self, arguments: Sequence[str], folder: Path) -> tuple[int, str]:
        """Runs uv in a folder. Returns its exit status and its standard error.

        Raises:
            RosmlError: uv is not installed, or `end` was called.
        """
        pipe = subprocess.PIPE
        with self._lock:
            if self._ended:
                raise RosmlError("interrupted")
            try:
                command = [self.command, *arguments]
                process = subprocess.Popen(
                    command, cwd=folder, env=_environment(), stdout=pipe, stderr=pipe, text=True, errors="replace"
                )
            except FileNotFoundError:
                raise RosmlError(f"'{self.command}' is not installed", "run 'rosml setup', which installs it") from None
            self._running.add(process)
        with process:
            _, errors = process.communicate()
        with self._lock:
            self._running.discard(process)
        return process.returncode, errors

    def end(self) -> None:
        """Ends all calls, and starts no more: uv waits minutes for an index that does not answer."""
        with self._lock:
            self._ended = True
            for process in self._running:
                process.terminate()


def resolve(request: Request, uv: Uv, upgrade: bool = True, previous: str = "") -> list[Pin]:
    """Resolves a request with ``uv pip compile``.

    Args:
        request: the request.
        uv: runs uv.
        upgrade: take the newest versions that fit; otherwise keep those of ``previous`` if they still fit.
        previous: the requirements of an earlier lock.

    Raises:
        Unreachable: only PyTorch's own index knows a wheel, and it does not answer.
        RosmlError: uv is missing, an index does not answer, or the requirements contradict each other.
    """
    if request.asks_pytorch:
        requirements = [request.elsewhere[family].requirement if family in request.elsewhere else requirement
                  for family, requirement in request.roots.items()]  # fmt: skip
    else:  # we know the wheel on that index by its digest; all others are on the usual index
        requirements = []
        for family, requirement in request.roots.items():
            requirements += request.elsewhere[family].requires if family in request.elsewhere else [requirement]
    requirements += [requirement for family in request.roots for requirement in request.beside.get(family, ())]
    with tempfile.TemporaryDirectory() as folder:
        base = Path(folder)
        apart = [requirement for requirement in requirements if package_name(requirement) in request.indexes]
        usual = [requirement for requirement in requirements if requirement not in apart]
        (base / "in.txt").write_text("\n".join([*usual, *request.added, f"numpy{request.numpy}"]) + "\n")
        # The system's packages are constraints, not overrides: a release that asks for more would not work there, unless
        # matrix.yaml says that it does (adapted).
        # But ROS's wheels need some of it that has no wheel (empy): no Python is below 3, so it is left out, and
        # `pip check` in the image judges.
        provided = [f"{name}=={version}" for name, version in sorted(request.provided.items())]
        (base / "constraints.txt").write_text(
            "\n".join([*request.constraints, *([] if request.ros else provided)]) + "\n"
        )
        overrides = [f"{pin}; python_version < '3'" for pin in provided if request.ros] + [*request.overrides]
        (base / "overrides.txt").write_text("\n".join(overrides) + "\n")
        output = base / "out.txt"
        if previous and not upgrade:
            output.write_text(previous)
        command = [
            *compile_command(request.python, request.wheels),
            "--generate-hashes",
            "--no-header",
            "--annotation-style",
            "split",
        ]
        command += ["--no-emit-index-url", "--constraint", "constraints.txt", "in.txt", "--output-file", "out.txt"]
        if apart:
            (base / "pyproject.toml").write_text(_from_indexes(apart, request.indexes))
            command.insert(command.index("in.txt"), "pyproject.toml")
        if request.asks_pytorch:
            command += ["--torch-backend", "cpu"]
        if overrides:
            command += ["--override", "overrides.txt"]
        for name in sorted(request.provided):
            command += ["--no-emit-package", name]
        status, errors = uv(command, base)
        if status != 0 and request.asks_pytorch and _no_answer(errors):
            raise Unreachable(errors)
        if status < 0:
            raise RosmlError(f"uv was ended by signal {-status} while it resolved {request}", "run it again")
        if status != 0:
            raise RosmlError(
                f"{request} does not resolve:\n{errors.strip()}",
                remedy=_remedy(request.indexes, errors),
            )
        pins = parse(output.read_text(errors="replace") if output.exists() else "")
    return pins if request.asks_pytorch else _with_known_wheels(request, pins)


def _from_indexes(requirements: Sequence[str], indexes: Mapping[str, str]) -> str:
    """A project's file, by which uv asks one index alone for each of these packages, and that index for nothing else."""
    addresses = list(dict.fromkeys(indexes.values()))
    lines = ["[project]", 'name = "matrix"', 'version = "0"', f"dependencies = {json.dumps(list(requirements))}"]
    lines += ["[tool.uv.sources]", *(f'{name} = {{index = "i{addresses.index(at)}"}}' for name, at in indexes.items())]
    for number, address in enumerate(addresses):
        lines += ["[[tool.uv.index]]", f'name = "i{number}"', f"url = {json.dumps(address)}", "explicit = true"]
    return "\n".join(lines) + "\n"


def _remedy(indexes: Mapping[str, str], errors: str) -> str:
    """What to do, if uv found no solution: what matters first is whether another index has what is taken from it."""
    for name, address in indexes.items():
        if (
            f"{name} was not found" in errors
            or f"no version of {name}=" in errors
            or re.search(rf"{name}==\S+ has no", errors)
        ):
            return f"put the wheel of {name} on {address}; a source package in its place is not enough"
    return "relax the stack's versions or constraints in matrix.yaml, or check that the index answers"


def compile_command(python: str, wheels: str) -> list[str]:
    """The beginning of every resolution's command, for a version of Python and a platform of wheels.

    It names this process' own interpreter, of any version, as nothing is built with it. Otherwise uv downloads an interpreter of each
    version, or tries to for ten seconds each time.
    """
    quiet = ["pip", "compile", "--quiet", "--no-config", "--python", sys.executable, "--only-binary", ":all:"]
    return [*quiet, "--python-version", python, "--python-platform", wheels]


def _environment() -> dict[str, str]:
    """The user's environment without settings of uv that would change the result; indexes and caches stay."""
    changing = (
        "UV_RESOLUTION",
        "UV_PRERELEASE",
        "UV_EXCLUDE_NEWER",
        "UV_CONSTRAINT",
        "UV_OVERRIDE",
        "UV_TORCH_BACKEND",
    )
    return {name: value for name, value in os.environ.items() if name not in changing}


class Unreachable(RosmlError):
    """PyTorch's own index does not answer."""

    def __init__(self, reason: str) -> None:
        cause = reason.strip().rpartition("cause: ")[2]
        super().__init__(
            f"PyTorch's own index does not answer ({cause})", "run 'rosml locks' on a machine that reaches it"
        )


def _no_answer(stderr: str) -> bool:
    """Whether uv failed because an index did not answer, and not because the index had nothing."""
    return any(sign in stderr for sign in ("Failed to fetch", "Request failed", "error sending request", "dns error"))


def _with_known_wheels(request: Request, pins: list[Pin]) -> list[Pin]:
    """Adds the wheels with known digests, above their requirements."""
    for wheel in request.elsewhere.values():
        name, version = package_name(wheel.requirement), wheel.requirement.split("==")[1]
        required = {package_name(requirement) for requirement in wheel.requires}
        pins = [replace(pin, wanted_by=pin.wanted_by | {name}) if pin.name in required else pin for pin in pins]
        pins.append(Pin(name, version, (wheel.digest,), frozenset()))
    return pins


def parse(requirements: str) -> list[Pin]:
    """Reads the output of ``uv pip compile`` with split annotations."""
    pins: list[Pin] = []
    name = version = ""
    hashes: list[str] = []
    requirers: list[str] = []

    def finish() -> None:
        if name:
            pins.append(Pin(name, version, tuple(sorted(hashes)), frozenset(requirers)))

    for line in requirements.splitlines():
        text = line.strip().rstrip("\\").strip()
        if match := _PIN.match(line):
            finish()
            name, version, hashes, requirers = match["name"], match["version"], [], []
        elif text.startswith("--hash="):
            hashes.append(text.removeprefix("--hash="))
        elif text.startswith("#") and name:
            parent = re.sub(r"^#\s*(via(\s+|$))?", "", text)
            if parent and not parent.startswith("-"):
                requirers.append(parent)
    finish()
    return pins


def closure(root: str, pins: Iterable[Pin]) -> frozenset[str]:
    """The names of all packages that ``root`` needs, including itself."""
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
    """Assigns every package to a part, and repeated ones to several.

    Args:
        roots: the requirement of each release.
        parts: the parts of the matrix.
        beside: the requirements of the packages that go with each release.
    """
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
    """The part with the packages that several releases need."""
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
    for pin in pins:
        lines.append(" \\\n".join([f"{pin.name}=={pin.version}", *(f"    --hash={digest}" for digest in pin.hashes)]))
    return "\n".join(lines) + "\n"


@dataclass(frozen=True)
class Locks:
    """The result: the text of every lock, by path, and what had to be left out, with the reason."""

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
    """Resolves everything; writes nothing.

    If PyTorch's own index does not answer, wheels that only that index has are left out. Their locks from an earlier call stay. If the
    rest of the stack has all its locks, these stay as well; otherwise it is locked without those wheels.

    Args:
        image_set: the image set.
        root: the project's root, which has the earlier locks.
        uv: the command of uv.
        upgrade: take the newest versions that fit; otherwise an earlier lock's versions stay if they fit.
        say: gets messages, a line each: the whole work takes minutes.
        stacks: only these stacks; all if empty.

    Raises:
        RosmlError: something does not resolve, or two Python versions of a stack need different versions of a common part.
    """
    chosen = [request for request in requests(image_set) if not stacks or request.stack in stacks]
    run = Uv(uv)
    with ThreadPoolExecutor(WORKERS) as pool:  # mostly waits for the indexes
        futures = [pool.submit(_outcome, request, root, run, upgrade) for request in chosen]
        try:
            for number, future in enumerate(progress_bar.over(as_completed(futures), "locks", len(futures)), 1):
                say(f"[{number} of {len(chosen)}] {future.result().request}: resolved")
        except BaseException:  # also Ctrl-C: do not wait for the others
            pool.shutdown(wait=False, cancel_futures=True)
            run.end()
            raise
        outcomes = [future.result() for future in futures]
    parts: dict[str, dict[str, Pin]] = {}
    headers: dict[str, tuple[Request, str]] = {}
    texts: dict[str, str] = {}
    for outcome in outcomes:
        texts |= outcome.kept
        for part, content in _parts(outcome).items():
            path = _path(outcome.request, part)
            headers[path] = (outcome.request, part)
            _merge(path, parts.setdefault(path, {}), content)
    for path, pins in parts.items():
        texts[path] = render(*headers[path], sorted(pins.values(), key=lambda pin: pin.name))
    return Locks(texts, {name: reason for outcome in outcomes for name, reason in outcome.left_out.items()})


WORKERS = 8
"""How many resolutions run at a time."""


@dataclass(frozen=True)
class _Outcome:
    """The result of a request: pins, locks that stay as they are, and what was left out, with the reason."""

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


def _merge(path: str, pins: dict[str, Pin], new_pins: list[Pin]) -> None:
    """Merges the pins of two resolutions for a common part: CUDA for all Pythons, numpy if frameworks are resolved apart.

    Raises:
        RosmlError: they need different versions of a package.
    """
    for pin in new_pins:
        other = pins.setdefault(pin.name, pin)
        if (other.version, other.hashes) != (pin.version, pin.hashes):
            raise RosmlError(
                f"{path}: {pin.name} would be {other.version} and {pin.version}, depending on the package that asks",
                "pin it in the stack's constraints in matrix.yaml",
            )


def require_one_cuda(request: Request, pins: list[Pin]) -> None:
    """Checks that NVIDIA's packages are those of the stack: one CUDA, the promised one.

    Raises:
        RosmlError: a package is of another CUDA generation, or has another version than the stack's facts.
    """
    nvidia = {pin.name: pin.version for pin in pins if pin.name.startswith("nvidia-")}
    major = request.cuda.get("cuda", "").split(".")[0]
    wrong = {name: f"{name} {version}" for name, version in nvidia.items() if not _of_generation(name, major)}
    for fact, name in cuda_packages(request.cuda.get("cuda", "")):
        if name in nvidia and nvidia[name] != request.cuda.get(fact, nvidia[name]):
            wrong[name] = f"{name} {nvidia[name]} (the stack says {request.cuda[fact]})"
    if wrong:
        raise RosmlError(
            "\n  ".join([f"{request} would carry:", *wrong.values()]),
            "correct the stack's cuda, cudnn and nccl in matrix.yaml; another CUDA generation needs a stack of its own",
        )


def _of_generation(name: str, major: str) -> bool:
    """Whether an NVIDIA package belongs to a CUDA generation: up to CUDA 12 every name ends in -cuNN, later only some."""
    suffix = re.search(r"-cu([0-9]+)$", name)
    if suffix:
        return suffix[1] == major
    return major.isdecimal() and int(major) > 12


class Move(NamedTuple):
    """A package that moved in a stack from one version to another. A version is empty if the package is new or gone."""

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
