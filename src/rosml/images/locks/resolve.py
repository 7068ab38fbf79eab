"""One resolution by uv: a request becomes pins, with hashes. NVIDIA's packages must be those of the stack's CUDA."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from rosml.base.errors import RosmlError
from rosml.images.image_set.lock_file import cuda_packages, package_name
from rosml.images.locks.requests import Request
from rosml.images.locks.uv import Uv, compile_command

_PIN = re.compile(r"^(?P<name>[A-Za-z0-9._-]+)==(?P<version>[^\s;\\]+)")


@dataclass(frozen=True)
class Pin:
    """A locked package: the hashes of its files, and the packages that require it."""

    name: str
    version: str
    hashes: tuple[str, ...]
    wanted_by: frozenset[str]

    def __str__(self) -> str:
        """Its lines in a lock."""
        return " \\\n".join([f"{self.name}=={self.version}", *(f"    --hash={digest}" for digest in self.hashes)])


def resolve(request: Request, uv: Uv, upgrade: bool = True, previous: str = "") -> list[Pin]:
    """Resolves a request with `uv pip compile`. Without `upgrade`, the versions of `previous` stay if they still fit."""
    inputs = _inputs(request)
    earlier = {"out.txt": previous} if previous and not upgrade else {}
    status, text, errors = uv.compile(_command(request, inputs), inputs | earlier)
    if status != 0:
        raise _failure(request, status, errors)
    return parse(text) if request.asks_pytorch else _with_known_wheels(request, parse(text))


def _inputs(request: Request) -> dict[str, str]:
    """The files that uv reads, by name."""
    requirements = _requirements(request)
    apart = [requirement for requirement in requirements if package_name(requirement) in request.indexes]
    usual = [requirement for requirement in requirements if requirement not in apart]
    # The system's packages are constraints, not overrides: a release that asks for more would not work there, unless
    # matrix.yaml says that it does (adapted).
    # But ROS's wheels need some of it that has no wheel (empy): no Python is below 3, so it is left out, and
    # `pip check` in the image judges.
    provided = [f"{name}=={version}" for name, version in sorted(request.provided.items())]
    constraints = [*request.constraints, *([] if request.ros else provided)]
    overrides = [*(f"{pin}; python_version < '3'" for pin in provided if request.ros), *request.overrides]
    inputs = {
        "in.txt": "\n".join([*usual, *request.added, f"numpy{request.numpy}"]) + "\n",
        "constraints.txt": "\n".join(constraints) + "\n",
    }
    if apart:
        inputs["pyproject.toml"] = _from_indexes(apart, request.indexes)
    if overrides:
        inputs["overrides.txt"] = "\n".join(overrides) + "\n"
    return inputs


def _requirements(request: Request) -> list[str]:
    requirements: list[str] = []
    for family, requirement in request.roots.items():
        wheel = request.elsewhere.get(family)
        if wheel is None:
            requirements.append(requirement)
        elif request.asks_pytorch:
            requirements.append(wheel.requirement)
        else:  # we know the wheel on that index by its digest; all others are on the usual index
            requirements += wheel.requires
    return requirements + [item for family in request.roots for item in request.beside.get(family, ())]


def _command(request: Request, inputs: Mapping[str, str]) -> list[str]:
    hashes = ["--generate-hashes", "--no-header", "--annotation-style", "split", "--no-emit-index-url"]
    command = [*compile_command(request.python, request.wheels), *hashes, "--constraint", "constraints.txt"]
    command += [name for name in ("pyproject.toml", "in.txt") if name in inputs]
    if request.asks_pytorch:
        command += ["--torch-backend", "cpu"]
    if "overrides.txt" in inputs:
        command += ["--override", "overrides.txt"]
    return command + [word for name in sorted(request.provided) for word in ("--no-emit-package", name)]


def _failure(request: Request, status: int, errors: str) -> RosmlError:
    if request.asks_pytorch and _no_answer(errors):
        return Unreachable(errors)
    if status < 0:
        return RosmlError(f"uv was ended by signal {-status} while it resolved {request}", "run it again")
    return RosmlError(f"{request} does not resolve:\n{errors.strip()}", _remedy(request.indexes, errors))


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


class Unreachable(RosmlError):
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


def require_one_cuda(request: Request, pins: list[Pin]) -> None:
    """Checks that NVIDIA's packages are of the stack's CUDA generation, and have the versions of its facts."""
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
