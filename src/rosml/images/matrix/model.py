"""The structure of matrix.yaml: its keys and the types of their values.

`references` checks whether the names in it exist; `combinations` decides which images exist. The descriptions here become
matrix.schema.json, which editors show.
"""

from __future__ import annotations

import datetime
import re
from collections.abc import Iterable
from functools import cached_property
from typing import Annotated, Any, Literal

from pydantic import BeforeValidator, Field

from rosml.images.matrix.additions import AddOn, EnvironmentEntry
from rosml.images.matrix.patterns import (
    HOST,
    IMAGE,
    PLATFORM,
    REFERENCE,
    SPDX,
    SPECIFIER,
    URL,
    AptAddress,
    ArchiveAddress,
    CudaMajor,
    DebAddress,
    Digest,
    Facts,
    Generations,
    Glibc,
    KeyFile,
    Megabytes,
    Name,
    Names,
    OsName,
    Packages,
    Pattern,
    Pinned,
    Python,
    Requirement,
    Requirements,
    Rmw,
    Sentence,
    Slot,
    Stacks,
    Target,
    Variable,
    Version,
    Word,
    only_whole,
)
from rosml.images.matrix.sizes import Disk, Rates

Generation = Literal["ros", "ros2"]
"""ROS 1 and ROS 2, in the words of ROS's apt repositories and their packages."""

Compression = Literal["zstd", "gzip"]

ANY_PYTHON = "any"
"""The Python version of a part that fits every Python; also a folder name in locks/."""


class Default(Facts):
    """Defaults if nothing is named."""

    targets: Annotated[tuple[Target, ...], Field(min_length=1)] = Field(
        description="`rosml image` builds the first of these images that this machine can build"
    )
    assembler: OsName = Field(
        description="the operating system that builds parts for any Python, tests images and lists their files"
    )
    group: Annotated[tuple[Target, ...], Field(min_length=1)] = Field(
        description="images of the bake file's `default` group: small and useful"
    )


class Architecture(Facts):
    """A processor architecture, under BuildKit's name (TARGETARCH)."""

    platform: Annotated[str, Field(pattern=PLATFORM)] = Field(description="BuildKit's platform")
    wheels: Word = Field(description="uv's name of the wheel platform, with the oldest glibc that is supported")
    runner: Word | None = Field(
        default=None, description="label of the machines that build for it in CI; a build plan needs it"
    )
    runner_disk: Megabytes | None = Field(default=None, description="MB of disk of these machines: a plan keeps to it")


class AptSource(Facts):
    """A release of the package that sets ROS's live apt repository up: its address and its key."""

    version: Version = Field(description="version of the release")
    digest: Digest = Field(description="digest of the package file")


class OperatingSystem(Facts):
    """An operating system for distributions."""

    image: Annotated[str, Field(pattern=IMAGE)] = Field(description="base image with its registry and tag")
    digest: Digest = Field(description="digest of the base image's index")
    python: Python = Field(description="version of the system's own Python, in quotes")
    numpy: Annotated[str, Field(pattern=SPECIFIER)] = Field(
        description="numpy versions with the ABI of the system's own numpy, which ROS's packages are compiled against"
    )
    architectures: Names = Field(description="architectures that images of it are built for")
    tools: Packages = Field(description="Debian packages of the developers' tools: colcon, rosdep, vcs")
    codename: Name | None = Field(
        default=None, description="name of its suite in ROS's apt repositories, such as noble"
    )
    apt_sources: dict[Generation, AptSource] = Field(
        default={}, description="the package <generation>-apt-source of ROS 1 (ros) and ROS 2 (ros2) for it"
    )
    provides: dict[Word, Version] = Field(
        default={}, description="Python packages of the system that ROS's tools import: no part carries them"
    )


class Component(Facts):
    """A part of ROS that is installed at once."""

    builds_on: Name | None = Field(
        default=None, description="the component below; if a distribution lacks it, the next one below that"
    )
    metapackage: Word | None = Field(default=None, description="name in package names; the component's own if left out")
    search: tuple[Word, ...] = Field(default=(), description="packages in it by which people look for an image")
    runtime_of: Name | None = Field(default=None, description="the component that it is without compilers and headers")


class Licence(Facts):
    """The licence of what a part holds."""

    spdx: Annotated[str, Field(pattern=SPDX, max_length=200)] = Field(
        description="its SPDX names with AND between them; LicenseRef-NAME for one that SPDX does not have"
    )
    allows: Sentence = Field(description="what it allows, in a short sentence")
    page: Annotated[str, Field(pattern=URL, max_length=200)] | None = Field(
        default=None, description="the address of its text"
    )


class PartEntry(Facts):
    """A part: built once from locked inputs, and joined to many images."""

    name: Name = Field(description="its own; also that of its folder in components/ and of its tests")
    title: Word | None = Field(default=None, description="how descriptions call what it brings, such as PyTorch")
    short: Name | None = Field(
        default=None, description="its name in tags with versions; the part's name if left out, if it has a title"
    )
    release: Name | None = Field(default=None, description="what it is a release of: a name from releases")
    versions: tuple[Literal["cuda", "cudnn"], ...] = Field(
        default=(), description="facts of its stack that labels and the environment name beside releases"
    )
    accelerator: Literal["cpu", "cuda"] | None = Field(
        default=None, description="only stacks with this accelerator have it"
    )
    any_python: bool = Field(default=False, description="the same for every Python version")
    needs: tuple[Name, ...] = Field(default=(), description="parts without which no image has it")
    slot: Slot | None = Field(
        default=None,
        description="number of the constraints in which pip and uv find what it holds; one that no other part has",
    )
    shared: bool = Field(default=False, description="it holds numpy and what several releases need; one part does")
    takes: tuple[Pattern, ...] = Field(
        default=(),
        description="packages that it holds, whatever needs them; a part that names one goes before parts with a pattern",
    )
    adds: dict[CudaMajor, tuple[Requirement, ...]] = Field(
        default={},
        description="by generation of CUDA: packages that no release asks for; without a version, of the stack's CUDA (12.8). Stacks of other generations do not have the part",
    )
    repeats: tuple[Pattern, ...] = Field(
        default=(),
        description="packages that it holds beside the part that has them; with 'release', those of its release",
    )
    tested: bool = Field(default=True, description="whether tests/structure has tests of its own for it")
    compiled: bool = Field(
        default=False,
        description="whether it has more of them, in NAME-build, that run in one image of each distribution: they need a compiler, or take long",
    )

    licence: Licence | None = Field(default=None, description="the licence of what it holds, for a label of its images")
    distribution: Literal["free", "restricted"] = Field(
        default="free",
        description="restricted: it goes only to registries on this machine, to those in private, and to places in i_have_the_rights",
    )

    @property
    def restricted(self) -> bool:
        """Whether its licence keeps it out of public registries."""
        return self.distribution == "restricted"

    @property
    def brings(self) -> tuple[str, ...]:
        """Names of the versions in labels and environment of its images."""
        return (self.release,) if self.release else self.versions

    def of_generation(self, cuda: str | None) -> bool:
        """Whether it is for the generation of a version of CUDA: one that it adds packages for, or any if it adds none."""
        return not cuda or not self.adds or cuda.partition(".")[0] in self.adds

    def added(self, cuda: str | None) -> tuple[str, ...]:
        """Requirements of packages that no release asks for, e.g. `nvidia-cuda-cccl-cu12==12.8.*` for CUDA 12.8.90."""
        generation, *rest = (cuda or "").split(".")
        release = ".".join([generation, *rest[:1], "*"])
        requirements = self.adds.get(generation, ())
        return tuple(item if re.search("[<=>]", item) else f"{item}=={release}" for item in requirements)


class Framework(Facts):
    """A framework: an addition to a ROS image."""

    repository: Name = Field(description="repository of its images, without the registry")
    parts: tuple[Name, ...] = Field(
        default=(), description="names from parts; those of an accelerator apply to stacks that have it"
    )
    accelerators: tuple[Literal["cpu", "cuda"], ...] = Field(
        default=("cpu", "cuda"), description="accelerators that it exists for; both if left out"
    )


class Release(Facts):
    """A release of a framework: what its wheels exist for."""

    python: Annotated[tuple[Python, ...], Field(min_length=1)] = Field(description="Python versions with wheels")
    wheels: dict[Name, Names] = Field(description="stack -> architectures with wheels for that stack's accelerator")
    elsewhere: dict[Name, dict[Name, dict[Python, Digest]]] = Field(
        default={},
        description="stack -> architecture -> Python -> published digest of the wheel, if only PyTorch's own index"
        " has wheels; a Python without a digest has no lock before `rosml locks` could ask that index",
    )
    beside: dict[Name, Version] = Field(
        default={},
        description="packages that go with it, in the same part: a name on the Python package index -> its version; on"
        " stacks whose wheels are all on that index",
    )
    adapted: dict[Word, Annotated[str, Field(pattern=SPECIFIER)]] = Field(
        default={},
        description="package -> the requirement in the part's metadata, instead of the wheel's: for a release that asks for"
        " more than it was found to need, if no part may carry it",
    )
    glibc: Glibc | None = Field(
        default=None,
        description="the glibc that its wheels ask for, such as 2.34, if that is newer than the architectures' own",
    )
    environment: dict[Variable, Word] = Field(
        default={}, description="variables that every image with it has, and their values"
    )
    index: Annotated[str, Field(pattern=URL, max_length=200)] | None = Field(
        default=None,
        description="another index of Python packages, without a password, that has the release's package and what goes with"
        " it; it is asked for nothing else",
    )
    gpus: dict[Name, Annotated[tuple[Word, ...], Field(min_length=1)]] = Field(
        default={},
        description="architecture -> GPU architectures that its wheels with CUDA were built for, as they say it: sm_80",
    )
    cxx11_abi: bool = Field(
        default=True,
        description="whether its C++ libraries have the string ABI of ROS's, so that a program can link both",
    )
    requires: tuple[Requirement, ...] = Field(
        default=(), description="requirements of the wheels that are elsewhere, as their metadata says"
    )

    def architectures(self, stack: str) -> tuple[str, ...]:
        """Architectures with wheels for a stack, on any index."""
        return tuple(dict.fromkeys([*self.wheels.get(stack, ()), *self.elsewhere.get(stack, ())]))

    def company(self, stack: str) -> dict[str, str]:
        """The packages that go with it on a stack, and their versions. None if only PyTorch's own index has wheels."""
        return {} if stack in self.elsewhere else dict(sorted(self.beside.items()))


class Stack(Facts):
    """Versions that were resolved together: one CUDA and one numpy for all of them."""

    accelerator: Literal["cpu", "cuda"] = Field(description="what its wheels compute on")
    cuda: Version | None = Field(default=None, description="version of the CUDA runtime")
    cudnn: Version | None = Field(default=None, description="version of cuDNN")
    nccl: Version | None = Field(default=None, description="version of NCCL")
    releases: dict[Name, Version] = Field(default={}, description="a name from releases -> its version")
    packages: dict[Name, Requirements] = Field(
        default={}, description="what to ask the index for: a name, or one per architecture"
    )
    constraints: tuple[Requirement, ...] = Field(default=(), description="further requirements on dependencies")
    apart: Sentence | None = Field(
        default=None,
        description="why its releases contradict each other: each is resolved by itself, and no image carries both",
    )

    def requirement(self, family: str, architecture: str) -> str | None:
        """The requirement for the index, e.g. `tensorflow[and-cuda]==2.20.0`; None if the stack has no such release."""
        version = self.releases.get(family)
        package = self.packages.get(family, family)
        name = package.get(architecture) if isinstance(package, dict) else package
        return f"{name}=={version}" if version and name else None


class Apt(Facts):
    """ROS's apt repository, for distributions that are not part of the operating system."""

    channel: Literal["live", "testing", "snapshot", "final"] = Field(
        description="live repository; what is tested before it is released there; dated snapshot; or the last snapshot of a distribution"
        " past its end of life"
    )
    date: datetime.date | None = Field(default=None, description="day of the snapshot")


class Archive(Facts):
    """A signed apt archive with ROS's packages that is not ROS's own: a company's, a build farm's, a team's."""

    address: ArchiveAddress = Field(description="its address, as an image's apt source names it")
    suite: Word = Field(description="its suite, such as noble")
    components: Annotated[tuple[Word, ...], Field(min_length=1)] = Field(
        default=("main",), description="its components, such as main"
    )
    key: KeyFile = Field(description="file in components/archive-keys with the public key that signs it")


class Distribution(Facts):
    """A ROS distribution on an operating system."""

    aliases: tuple[Name, ...] = Field(
        default=(), description="names that it had: its images get the tags with these, too; left out after a release"
    )
    os: OsName = Field(description="a name from operating_systems")
    ros: Annotated[Literal[1, 2], BeforeValidator(only_whole)] = Field(description="ROS 1 or ROS 2")
    ros_distro: Word | None = Field(
        default=None, description="value of ROS_DISTRO; the distribution's own name if left out"
    )
    packages: Packages | None = Field(
        default=None, description="packages of a component; {component}, {metapackage} and {ros_distro} are filled in"
    )
    wheels: tuple[Pinned, ...] = Field(
        default=(), description="Python packages of ROS 2 itself, instead of Debian packages"
    )
    lacks: tuple[Word, ...] = Field(default=(), description="ROS packages that people expect of it, and that it lacks")
    tools: Packages | None = Field(
        default=None, description="Debian packages that come first; the developers' tools of its system if left out"
    )
    architectures: tuple[Name, ...] = Field(
        default=(), description="architectures that it exists for; those of its system if left out"
    )
    experimental: bool = Field(default=False, description="not what its generation's users expect; never `latest`")
    components: Names = Field(description="components that it has")
    default_stack: Stacks = Field(
        description="stack of the short tags, such as ros-torch:jazzy; of several the first that a framework exists on"
    )
    eol: datetime.date | None = Field(default=None, description="last day of support; leave out if it is rolling")
    lts: bool = Field(
        default=False, description="a long-term release of ROS: the newest one that has every framework gets `latest`"
    )
    apt: Apt | None = Field(
        default=None, description="ROS's own apt repository, for packages that are not the system's"
    )
    archive: Archive | None = Field(default=None, description="another apt archive instead of ROS's own")
    rmw: tuple[Rmw, ...] = Field(
        default=(), description="RMW implementations of ROS 2 beside the default one; RMW_IMPLEMENTATION chooses one"
    )
    usual_rmw: Rmw | None = Field(
        default=None,
        description="what ROS 2 takes if RMW_IMPLEMENTATION chooses none, for an archive without rmw_fastrtps_cpp",
    )

    @property
    def generation(self) -> Generation:
        """Its generation of ROS, in the words of ROS's apt repositories."""
        return "ros" if self.ros == 1 else "ros2"

    @property
    def default_stacks(self) -> tuple[str, ...]:
        """The stacks of the short tags: for each framework, the first on which it exists."""
        return (self.default_stack,) if isinstance(self.default_stack, str) else self.default_stack

    @cached_property
    def present(self) -> frozenset[str]:
        """The components, to look one up."""
        return frozenset(self.components)


class RosArchive(Facts):
    """ROS's apt repositories, as an image's apt source names them."""

    live: AptAddress = Field(description="today's packages; {generation} is filled in: ros or ros2")
    testing: AptAddress | None = Field(
        default=None, description="packages before they are released into the live one; {generation} is filled in"
    )
    snapshot: AptAddress = Field(
        description="a state of them; {ros_distro} and {day} are filled in: a date, or final after the end of life"
    )
    apt_source: DebAddress = Field(
        description="the package that sets up the live one; {generation}, {version} and {codename} are filled in"
    )


class Matrix(Facts):
    """The one source of truth: what exists, as positive facts. Combinations that the facts allow are built."""

    version: Annotated[Literal[1], BeforeValidator(only_whole)] = Field(description="version of this file's format")
    registry: Annotated[str, Field(pattern=REFERENCE)] = Field(
        description="where images live, unless the variable REGISTRY says otherwise"
    )
    private: tuple[Annotated[str, Field(pattern=HOST, max_length=255)], ...] = Field(
        default=(), description="registries from which only your organization can pull: restricted parts may go there"
    )
    i_have_the_rights: tuple[Annotated[str, Field(pattern=REFERENCE, max_length=255)], ...] = Field(
        default=(),
        description="places in public registries, such as ghcr.io/me/robots, where the licences of restricted parts let you publish these",
    )
    source: Annotated[str, Field(pattern=URL)] | None = Field(
        default=None, description="the project's address, for the images' label and SBOMs"
    )
    compression: Compression = Field(
        default="zstd", description="of layers; gzip is larger and slower, and for machines with Docker before 23"
    )
    default: Default
    architectures: dict[Name, Architecture] = Field(min_length=1)
    operating_systems: dict[OsName, OperatingSystem] = Field(min_length=1)
    ros_archive: RosArchive | None = Field(default=None, description="needed by distributions with 'apt'")
    components: dict[Name, Component] = Field(min_length=1)
    parts: tuple[PartEntry, ...] = Field(default=(), description="in the order in which they are joined")
    frameworks: dict[Name, Framework] = Field(min_length=1)
    addons: dict[Name, AddOn] = Field(
        default={}, description="what goes onto any image of a stack: 'rosml join', 'rosml containerize --addons'"
    )
    environments: dict[Name, EnvironmentEntry] = Field(
        default={}, description="Python packages at a prefix of their own: 'rosml env add', docs/environments.md"
    )
    releases: dict[Name, dict[Version, Release]] = Field(
        default={}, description="what has wheels of its own -> version -> release"
    )
    drivers: dict[Generations, Version] = Field(
        default={}, description="generation of CUDA, in quotes -> the oldest NVIDIA driver that runs any CUDA of it"
    )
    stacks: dict[Name, Stack] = Field(min_length=1)
    distributions: dict[Name, Distribution] = Field(min_length=1)
    disk: Disk
    rates: Rates = Field(default=Rates(), description="how fast images are built, for a plan's estimates")

    @cached_property
    def part(self) -> dict[str, PartEntry]:
        """Parts by name."""
        return {part.name: part for part in self.parts}

    @cached_property
    def answers(self) -> dict[Any, Any]:
        """The answers that `combinations.remembered` keeps: a matrix never changes, so they stay true."""
        return {}

    def carrying(self, framework: str, addon: str = "") -> Framework:
        """A framework, with the parts of an add-on and those that they need, in the order in which they are joined."""
        facts = self.frameworks[framework]
        if not addon:
            return facts
        key = Framework, framework, addon
        if key not in self.answers:
            names = {*facts.parts, *self.needed(self.addons[addon].parts)}
            parts = tuple(part.name for part in self.parts if part.name in names)
            repository = f"{facts.repository}-{addon}"
            self.answers[key] = Framework(repository=repository, parts=parts, accelerators=facts.accelerators)
        framework_with_addon: Framework = self.answers[key]
        return framework_with_addon

    def release(self, stack: str, family: str) -> Release:
        return self.releases[family][self.stacks[stack].releases[family]]

    def needed(self, parts: Iterable[str]) -> set[str]:
        """Parts, and all that they need."""
        needed_parts, todo = set[str](), [*parts]
        while todo:
            if (name := todo.pop()) not in needed_parts and name in self.part:
                needed_parts.add(name)
                todo += self.part[name].needs
        return needed_parts

    @cached_property
    def families(self) -> tuple[str, ...]:
        """The names of releases that parts have, in the order in which parts are joined."""
        return tuple(dict.fromkeys(part.release for part in self.parts if part.release))
