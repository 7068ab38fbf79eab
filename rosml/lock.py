"""Hash-pinned locks: resolve a stack once, split the result into payload parts.

A stack is resolved as a whole, so that PyTorch, TensorFlow, CUDA and numpy agree, and written as one requirements file
per part. What a part holds follows from the dependency graph alone:

* ``cuda``        NVIDIA's libraries (they do not depend on the Python version)
* ``common``      numpy, and what both frameworks need
* ``torch``       what only PyTorch needs
* ``tensorflow``  what only TensorFlow needs
"""

from __future__ import annotations

import re
import subprocess
import tempfile
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path

from rosml import names
from rosml.errors import RosmlError
from rosml.expand import Catalogue
from rosml.model import ANY_PYTHON, FAMILIES

_PIN = re.compile(r"^(?P<name>[A-Za-z0-9._-]+)==(?P<version>[^\s;\\]+)")


@dataclass(frozen=True)
class Request:
    """What to resolve: one stack for one Python version on one architecture.

    Attributes:
        stack: name of the stack, e.g. ``cu128``.
        architecture: ``amd64`` or ``arm64``.
        python: version of the interpreter, e.g. ``3.11``.
        wheels: uv's name of the wheel platform, e.g. ``x86_64-manylinux_2_28``.
        roots: requirement of each framework, e.g. ``{"torch": "torch==2.10.0"}``.
        numpy: version specifier that keeps the ABI of the operating system's own numpy, e.g. ``<2``.
        constraints: further requirements of the stack.
        provided: packages the operating system has and the payload must not carry, with their versions.
        cuda: the stack's versions of ``cuda``, ``cudnn`` and ``nccl``; empty for a stack without CUDA.
    """

    stack: str
    architecture: str
    python: str
    wheels: str
    roots: Mapping[str, str]
    numpy: str
    constraints: tuple[str, ...] = ()
    provided: Mapping[str, str] = field(default_factory=dict)
    cuda: Mapping[str, str] = field(default_factory=dict)


@dataclass(frozen=True)
class Pin:
    """One locked package: its version, the hashes of its files, and the packages that asked for it."""

    name: str
    version: str
    hashes: tuple[str, ...]
    wanted_by: frozenset[str]


def requests(catalogue: Catalogue) -> Iterator[Request]:
    """Every resolution that the payloads of a catalogue need: one per stack, Python version and architecture."""
    matrix = catalogue.matrix
    seen: set[tuple[str, str, str]] = set()
    # What no payload holds has no wheel there, and would make the whole stack unresolvable.
    held = {
        (payload.stack, architecture, payload.python, payload.part)
        for payload in catalogue.payloads
        for architecture in payload.architectures
    }
    for payload in catalogue.payloads:
        if payload.python == ANY_PYTHON:
            continue  # comes out of the resolution for any Python version
        system = matrix.operating_systems[payload.os]
        stack = matrix.stacks[payload.stack]
        for architecture in payload.architectures:
            if (key := (payload.stack, architecture, payload.python)) in seen:
                continue
            seen.add(key)
            families = [family for family in FAMILIES if (*key, family) in held]
            wanted = {family: stack.requirement(family, architecture) for family in families}
            yield Request(
                stack=payload.stack,
                architecture=architecture,
                python=payload.python,
                wheels=matrix.architectures[architecture].wheels,
                roots={family: requirement for family, requirement in wanted.items() if requirement},
                numpy=system.numpy,
                constraints=stack.constraints,
                provided=system.provides,
                cuda={
                    fact: version
                    for fact in ("cuda", "cudnn", "nccl")
                    if (version := getattr(stack, fact)) and stack.accelerator == "cuda"
                },
            )


def resolve(request: Request, uv: str = "uv", upgrade: bool = True, previous: str = "") -> list[Pin]:
    """Resolves a request with ``uv pip compile``.

    Args:
        request: what to resolve.
        uv: the command to run.
        upgrade: take the newest versions that fit; otherwise keep those of ``previous`` where they still fit.
        previous: requirements of an earlier lock.

    Raises:
        RosmlError: uv is missing, an index does not answer, or the requirements contradict each other.
    """
    with tempfile.TemporaryDirectory() as folder:
        base = Path(folder)
        (base / "in.txt").write_text("\n".join([*request.roots.values(), f"numpy{request.numpy}"]) + "\n")
        (base / "constraints.txt").write_text("\n".join(request.constraints) + "\n")
        (base / "provided.txt").write_text("\n".join(f"{n}=={v}" for n, v in sorted(request.provided.items())) + "\n")
        output = base / "out.txt"
        if previous and not upgrade:
            output.write_text(previous)
        command = [uv, "pip", "compile", "--quiet", "--generate-hashes", "--only-binary", ":all:", "--no-header"]
        command += ["--no-config", "--annotation-style", "split", "--no-emit-index-url"]
        command += ["--python-version", request.python, "--python-platform", request.wheels]
        command += [
            "--constraint",
            "constraints.txt",
            "--override",
            "provided.txt",
            "in.txt",
            "--output-file",
            "out.txt",
        ]
        for name in sorted(request.provided):
            command += ["--no-emit-package", name]
        try:
            done = subprocess.run(command, cwd=base, capture_output=True, text=True, check=False)
        except FileNotFoundError:
            raise RosmlError(f"'{uv}' is not installed", remedy="run 'make up', which installs it") from None
        if done.returncode != 0:
            raise RosmlError(
                f"stack {request.stack}, Python {request.python}, {request.architecture} does not resolve:\n"
                + done.stderr.strip(),
                remedy="relax the stack's versions or constraints in matrix.yaml, or check that the index answers",
            )
        return parse(output.read_text())


def parse(requirements: str) -> list[Pin]:
    """Reads the output of ``uv pip compile`` with split annotations."""
    pins: list[Pin] = []
    name = version = ""
    hashes: list[str] = []
    wanted: list[str] = []

    def finish() -> None:
        if name:
            pins.append(Pin(name, version, tuple(sorted(hashes)), frozenset(wanted)))

    for line in requirements.splitlines():
        text = line.strip().rstrip("\\").strip()
        if match := _PIN.match(line):
            finish()
            name, version, hashes, wanted = match["name"], match["version"], [], []
        elif text.startswith("--hash="):
            hashes.append(text.removeprefix("--hash="))
        elif text.startswith("#") and name:
            parent = re.sub(r"^#\s*(via(\s+|$))?", "", text)
            if parent and not parent.startswith("-"):
                wanted.append(parent)
    finish()
    return pins


def closure(root: str, pins: Iterable[Pin]) -> frozenset[str]:
    """Names of all packages that ``root`` needs, itself included."""
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


def split(pins: list[Pin], roots: Mapping[str, str]) -> dict[str, list[Pin]]:
    """Assigns every package to exactly one part. ``roots``: framework name to the requirement that asks for it."""
    needs = {framework: closure(package_name(requirement), pins) for framework, requirement in roots.items()}
    shared = closure("numpy", pins)
    parts: dict[str, list[Pin]] = {"cuda": [], "common": [], **{framework: [] for framework in roots}}
    for pin in pins:
        owners = [framework for framework, names in needs.items() if pin.name in names]
        if pin.name.startswith("nvidia-"):
            parts["cuda"].append(pin)
        elif pin.name in shared or len(owners) != 1:
            parts["common"].append(pin)
        else:
            parts[owners[0]].append(pin)
    return {part: sorted(content, key=lambda pin: pin.name) for part, content in parts.items() if content}


def package_name(requirement: str) -> str:
    """``tensorflow_cpu[x]==2.20.0`` -> ``tensorflow-cpu``, as uv spells it."""
    return re.sub(r"[-_.]+", "-", re.split(r"[\[=<>!~;\s]", requirement, maxsplit=1)[0]).lower()


def render(request: Request, part: str, pins: list[Pin]) -> str:
    """The text of a part's lock. It names no index and no date: the same resolution gives the same bytes."""
    python = ANY_PYTHON if part == "cuda" else request.python
    lines = [
        f"# Part '{part}' of stack {request.stack}, Python {python}, {request.architecture}.",
        "# Made by scripts/lock.py (make locks) from matrix.yaml; do not edit.",
    ]
    for pin in pins:
        lines.append(" \\\n".join([f"{pin.name}=={pin.version}", *(f"    --hash={digest}" for digest in pin.hashes)]))
    return "\n".join(lines) + "\n"


def render_all(request: Request, pins: list[Pin]) -> dict[str, str]:
    """Path (relative to the root) and text of every lock that a resolution gives."""
    return {
        names.lock_path(
            request.stack, request.architecture, ANY_PYTHON if part == "cuda" else request.python, part
        ): render(request, part, content)
        for part, content in split(pins, request.roots).items()
    }


def lock(catalogue: Catalogue, root: Path, uv: str = "uv", upgrade: bool = False) -> dict[str, str]:
    """Resolves everything and gives the text of every lock by path; writes nothing.

    Args:
        catalogue: all that the matrix describes.
        root: the project's root, where earlier locks are.
        uv: the command to resolve with.
        upgrade: move to the newest versions that fit; otherwise an earlier lock's versions stay where they fit.

    Raises:
        RosmlError: something does not resolve, or two Python versions of a stack would need different CUDA libraries.
    """
    locks: dict[str, str] = {}
    for request in requests(catalogue):
        earlier = "\n".join(
            path.read_text()
            for python in (ANY_PYTHON, request.python)
            for path in sorted((root / "locks" / request.stack / request.architecture / python).glob("*.txt"))
        )
        pins = resolve(request, uv, upgrade, earlier)
        _one_cuda(request, pins)
        for path, text in render_all(request, pins).items():
            if locks.setdefault(path, text) != text:
                raise RosmlError(
                    f"{path} would differ between Python versions of stack {request.stack}",
                    "pin the NVIDIA package that differs in the stack's constraints in matrix.yaml",
                )
    return locks


def _one_cuda(request: Request, pins: list[Pin]) -> None:
    """Checks that NVIDIA's packages are those of the stack: one CUDA, the promised one.

    Raises:
        RosmlError: another CUDA generation, or a version other than the stack's facts say.
    """
    nvidia = {pin.name: pin.version for pin in pins if pin.name.startswith("nvidia-")}
    major = request.cuda.get("cuda", "").split(".")[0]
    wrong = [f"{name} {version}" for name, version in nvidia.items() if not _of_generation(name, major)]
    for fact, package in (("cuda", "cuda-runtime"), ("cudnn", "cudnn"), ("nccl", "nccl")):
        for name in (f"nvidia-{package}", f"nvidia-{package}-cu{major}"):
            if name in nvidia and nvidia[name] != request.cuda.get(fact, nvidia[name]):
                wrong.append(f"{name} {nvidia[name]} (the stack says {request.cuda[fact]})")
    if wrong:
        raise RosmlError(
            f"stack {request.stack}, Python {request.python}, {request.architecture} would carry other NVIDIA packages"
            f" than it promises: {', '.join(wrong)}",
            "correct the stack's cuda, cudnn and nccl in matrix.yaml; another CUDA generation needs a stack of its own",
        )


def _of_generation(name: str, major: str) -> bool:
    """Whether an NVIDIA package belongs to a CUDA generation: up to CUDA 12 every name ends in -cuNN, later only some."""
    suffix = re.search(r"-cu([0-9]+)$", name)
    if suffix:
        return suffix[1] == major
    return major.isdecimal() and int(major) > 12


def versions(text: str) -> dict[str, str]:
    """Package names and versions of a lock."""
    return {pin.name: pin.version for pin in parse(text)}
