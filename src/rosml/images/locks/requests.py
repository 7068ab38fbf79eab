"""What is resolved for an image set: one request for each stack or distribution, version of Python and architecture."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field

from rosml.base.problems import listed
from rosml.images.image_set.lock_file import adapted_lines, package_name
from rosml.images.image_set.model import ImageSet, Part
from rosml.images.matrix import combinations
from rosml.images.matrix.combinations import NVIDIA
from rosml.images.matrix.model import ANY_PYTHON, Matrix, PartEntry


@dataclass(frozen=True)
class Elsewhere:
    """A framework whose wheel only PyTorch's own index has, such as `torch==2.10.0+cpu`."""

    requirement: str
    digest: str  # its published sha256; empty if we have to ask that index
    requires: tuple[str, ...]  # the wheel's requirements, which the Python package index has


@dataclass(frozen=True)
class Request:
    """A request: a stack, or the wheels of a distribution, for one Python version on one architecture."""

    stack: str  # the name of the stack, such as `cu128`, or of the distribution
    architecture: str
    python: str
    wheels: str  # uv's name of the wheel platform, such as `x86_64-manylinux_2_28`
    roots: Mapping[str, str]  # by framework, such as `{"torch": "torch==2.10.0"}`; for ROS, each package's own
    numpy: str  # the version specifier that keeps the ABI of the operating system's own numpy, such as `<2`
    constraints: tuple[str, ...] = ()
    added: tuple[str, ...] = ()  # requirements of packages that parts have although no framework asks for them
    provided: Mapping[str, str] = field(default_factory=dict)  # the operating system's versions, not for the part
    cuda: Mapping[str, str] = field(default_factory=dict)  # the stack's versions of `cuda`, `cudnn` and `nccl`
    elsewhere: Mapping[str, Elsewhere] = field(default_factory=dict)
    parts: tuple[PartEntry, ...] = ()
    ros: bool = False
    beside: Mapping[str, tuple[str, ...]] = field(default_factory=dict)  # requirements that go with each framework
    adapted: Mapping[str, tuple[str, ...]] = field(default_factory=dict)  # replace a wheel's own, as lines of locks
    overrides: tuple[str, ...] = ()  # the adapted ones as uv takes them
    indexes: Mapping[str, str] = field(default_factory=dict)  # address by package, if it is not on the usual index

    @property
    def asks_pytorch(self) -> bool:
        """Whether we have to ask PyTorch's own index, because the digest of a wheel is unknown."""
        return any(not wheel.digest for wheel in self.elsewhere.values())

    def __str__(self) -> str:
        kind = "distribution" if self.ros else "stack"
        return f"{kind} {self.stack}, Python {self.python}, {self.architecture} ({listed(list(self.roots))})"


def requests(image_set: ImageSet) -> Iterator[Request]:
    """Every resolution for the parts of an image set. Frameworks of a stack that contradict each other have one each."""
    matrix = image_set.matrix
    parts_by_key: dict[tuple[str, str, str], dict[str, Part]] = {}
    for part in image_set.parts_of_stacks:
        if part.python != ANY_PYTHON:  # comes from the resolutions for all Python versions
            for architecture in part.architectures:
                parts_by_key.setdefault((part.stack, architecture, part.python), {})[part.kind] = part
    for (stack, architecture, _), parts in parts_by_key.items():
        # Frameworks without a part have no wheel there, and would make the whole stack unresolvable.
        families = [family for family in matrix.families if family in parts]
        for together in [[family] for family in families] if matrix.stacks[stack].apart else [families]:
            yield _of_stack(matrix, next(iter(parts.values())), architecture, together)
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


def _of_stack(matrix: Matrix, part: Part, architecture: str, families: Sequence[str]) -> Request:
    """The request for frameworks of a stack, for the Python and the operating system of one of its parts."""
    stack, system = matrix.stacks[part.stack], matrix.operating_systems[part.os]
    releases = {family: matrix.release(part.stack, family) for family in families}
    roots = {family: text for family in families if (text := stack.requirement(family, architecture))}
    wheels = {family: _elsewhere(matrix, part, architecture, family) for family in families}
    beside = {
        family: tuple(f"{name}=={version}" for name, version in release.company(part.stack).items())
        for family, release in releases.items()
    }
    entries = [entry for entry in matrix.parts if entry.accelerator in (None, stack.accelerator)]
    overrides = {f"{name}{bound}" for release in releases.values() for name, bound in release.adapted.items()}
    versions = {fact: getattr(stack, fact) for fact in NVIDIA if stack.accelerator == "cuda"}
    return Request(
        stack=part.stack,
        architecture=architecture,
        python=part.python,
        wheels=combinations.wheels(matrix, architecture, releases.values()),
        roots=roots,
        numpy=system.numpy,
        constraints=stack.constraints,
        added=tuple(requirement for entry in entries for requirement in entry.added(stack.cuda)),
        provided=system.provides,
        cuda={fact: version for fact, version in versions.items() if version},
        elsewhere={family: wheel for family, wheel in wheels.items() if wheel},
        parts=matrix.parts,
        beside=beside,
        adapted={family: tuple(adapted_lines(release, family)) for family, release in releases.items()},
        overrides=tuple(sorted(overrides)),
        indexes={
            package_name(requirement): release.index
            for family, release in releases.items()
            if release.index
            for requirement in (*((roots[family],) if family in roots else ()), *beside[family])
        },
    )


def _elsewhere(matrix: Matrix, part: Part, architecture: str, family: str) -> Elsewhere | None:
    """A framework's wheel on PyTorch's own index, if the part's wheel comes from there."""
    stack, release = matrix.stacks[part.stack], matrix.release(part.stack, family)
    digests = release.elsewhere.get(part.stack, {}).get(architecture)
    requirement = stack.requirement(family, architecture)
    if digests is None or requirement is None:
        return None
    return Elsewhere(f"{requirement}+{stack.accelerator}", digests.get(part.python, ""), release.requires)
