"""The texts and numbers that matrix.yaml may have: patterns, each with its meaning in words, and the types made of them."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Annotated, Any

from pydantic import BaseModel, ConfigDict, Discriminator, Field, Tag
from pydantic_core import PydanticKnownError

# The patterns in words, for messages about values that do not match.
NAME = r"^[a-z][a-z0-9]*(-[a-z0-9]+)*$"
FILE_NAME = r"^[a-z][a-z0-9]*([.-][a-z0-9]+)*$"
VERSION = r"^[0-9]+(\.[0-9A-Za-z]+)*$"
GENERATION = r"^[1-9][0-9]*$"
PYTHON = r"^3\.(0|[1-9][0-9]?)$"
DIGEST = r"^sha256:[0-9a-f]{64}$"
HOST = r"^[a-z0-9]([a-z0-9.-]*[a-z0-9])?(:[1-9][0-9]{0,4})?$"
REFERENCE = r"^[a-z0-9]([a-z0-9.-]*[a-z0-9])?(:[1-9][0-9]{0,4})?(/[a-z0-9]+([._-]+[a-z0-9]+)*)*$"
IMAGE = r"^[a-z0-9.-]+(:[0-9]+)?(/[a-z0-9._-]+)+:[A-Za-z0-9_][A-Za-z0-9._-]*$"
URL = r"^https?://[^\s\"'$%{}@\\]+$"
APT = r"^http://[a-z0-9][a-z0-9.-]*(:[1-9][0-9]{0,4})?(/[a-z0-9{}][a-z0-9.{}_-]*)*$"
DEB = APT.replace("http:", "https?:", 1)
ARCHIVE = DEB.replace("{}", "")
KEY_FILE = r"^[a-z0-9][a-z0-9._-]*\.asc$"
PLATFORM = r"^linux/[a-z0-9]+(/v[0-9]+)?$"
RMW = r"^rmw_[a-z0-9]+(_[a-z0-9]+)*$"
WORD = r"^[A-Za-z0-9_][A-Za-z0-9_.+-]*$"
SPECIFIER = r"^(<=|>=|==|!=|~=|<|>)[0-9][0-9A-Za-z.*]*(,(<=|>=|==|!=|~=|<|>)[0-9][0-9A-Za-z.*]*)*$"
REQUIREMENT = (
    r"^[A-Za-z0-9][A-Za-z0-9._-]*(\[[a-z0-9,_-]+\])?((<=|>=|==|!=|~=|<|>)[0-9][0-9A-Za-z.*+]*"
    r"(,(<=|>=|==|!=|~=|<|>)[0-9][0-9A-Za-z.*+]*)*)?$"
)
PINNED = r"^[A-Za-z0-9][A-Za-z0-9._-]*(\[[a-z0-9,_-]+\])?==[0-9][0-9A-Za-z.+]*$"
PATTERN = r"^[a-z0-9*][a-z0-9*-]*$"
GLIBC = r"^2\.[1-9][0-9]$"
VARIABLE = r"^[A-Z][A-Z0-9]*(_[A-Z0-9]+)+$"
CUDA_MAJOR = r"^[1-9][0-9]*$"
SENTENCE = r"^[A-Za-z0-9][A-Za-z0-9 ,.;:()_+=<>-]*$"
SPDX = r"^[A-Za-z0-9][A-Za-z0-9.+-]*( (AND|WITH) [A-Za-z0-9][A-Za-z0-9.+-]*)*$"
PACKAGES = r"^[a-z0-9.+{}_-]+( [a-z0-9.+{}_-]+)*$"
MEANING = {
    NAME: "a name of lower-case letters, digits and single hyphens, such as desktop-full",
    FILE_NAME: "a name of lower-case letters, digits, points and hyphens, such as ubuntu-24.04",
    VERSION: "a version, such as 2.10.0",
    PYTHON: 'a Python version of two numbers in quotes, such as "3.11"',
    DIGEST: "a digest: sha256: and 64 hexadecimal digits",
    HOST: "the host of a registry, such as registry.example.com or registry.example.com:5000",
    REFERENCE: "a registry without https://, such as ghcr.io/owner or localhost:5000",
    IMAGE: "a full image name with its registry and tag, such as docker.io/library/debian:bookworm",
    URL: "an address without a password, such as https://example.org/images",
    APT: "the address of an apt repository, such as http://packages.example.org/{generation}/ubuntu",
    DEB: "the address of a Debian package, such as https://packages.example.org/{generation}-source_{version}.deb",
    ARCHIVE: "the address of an apt archive without a password and without a slash at the end, such as http://packages.example.org/ros2",
    KEY_FILE: "a file in components/archive-keys with an armored public key, such as mine.asc",
    PLATFORM: "a platform, such as linux/arm64",
    RMW: "an RMW implementation, such as rmw_cyclonedds_cpp",
    WORD: "one word",
    SPECIFIER: 'a version range, such as "<2" or ">=2.2,<2.3"',
    PATTERN: "a Python package, or a pattern of packages, such as nvidia-*",
    GLIBC: 'a version of glibc in quotes, such as "2.34"',
    VARIABLE: "a variable of capital letters, digits and single underscores, at least one of these, such as TF_ENABLE_ONEDNN_OPTS",
    CUDA_MAJOR: 'a generation of CUDA in quotes, such as "12"',
    SENTENCE: "a sentence without quotes",
    SPDX: "licences by their SPDX names with AND between them, such as Apache-2.0 AND LicenseRef-NVIDIA-CUDA",
    REQUIREMENT: 'a Python requirement, such as "protobuf>=5.28,<7"',
    PINNED: "a Python package with its version, such as ros-jazzy-rclpy[fastrtps]==7.1.6",
    PACKAGES: "Debian package names separated by single spaces; {component}, {metapackage} and {ros_distro} are filled in",
}

SLOTS = 16
"""The most parts of a matrix whose packages pip leaves alone. For each, ROS images have an empty file."""

# The limits on length keep a tag, which has several names in it, within a registry's 128 characters.
Name = Annotated[str, Field(pattern=NAME, max_length=24)]
OsName = Annotated[str, Field(pattern=FILE_NAME, max_length=24)]
Version = Annotated[str, Field(pattern=VERSION, max_length=20)]
Python = Annotated[str, Field(pattern=PYTHON)]
Generations = Annotated[str, Field(pattern=GENERATION)]
Digest = Annotated[str, Field(pattern=DIGEST)]
Word = Annotated[str, Field(pattern=WORD, max_length=64)]
AptAddress = Annotated[str, Field(pattern=APT, max_length=200)]
DebAddress = Annotated[str, Field(pattern=DEB, max_length=200)]
ArchiveAddress = Annotated[str, Field(pattern=ARCHIVE, max_length=200)]
KeyFile = Annotated[str, Field(pattern=KEY_FILE, max_length=64)]
Rmw = Annotated[str, Field(pattern=RMW, max_length=64)]
Sentence = Annotated[str, Field(pattern=SENTENCE, max_length=200)]
Requirement = Annotated[str, Field(pattern=REQUIREMENT, max_length=120)]
Pinned = Annotated[str, Field(pattern=PINNED, max_length=120)]
Packages = Annotated[str, Field(pattern=PACKAGES, max_length=400)]
Pattern = Annotated[str, Field(pattern=PATTERN, max_length=64)]
Glibc = Annotated[str, Field(pattern=GLIBC)]
Variable = Annotated[str, Field(pattern=VARIABLE, max_length=64)]
CudaMajor = Annotated[str, Field(pattern=CUDA_MAJOR, max_length=3)]
Target = Annotated[str, Field(pattern=NAME, max_length=128)]
Names = Annotated[tuple[Name, ...], Field(min_length=1)]
Slot = Annotated[int, Field(ge=1, le=SLOTS)]
Megabytes = Annotated[int, Field(ge=0, le=1_000_000)]
Rate = Annotated[int, Field(ge=1, le=10_000)]


def only_whole(value: Any) -> Any:
    """`true` and `1.0` equal 1, so a literal number would accept them."""
    if isinstance(value, (bool, float)):
        raise PydanticKnownError("int_type")
    return value


def _requirement_kind(value: Any) -> str:
    return "per-architecture" if isinstance(value, Mapping) else "same"


# One requirement, or one for each architecture where the packages' names differ.
Requirements = Annotated[
    Annotated[Requirement, Tag("same")] | Annotated[dict[Name, Requirement], Tag("per-architecture")],
    Discriminator(_requirement_kind),
]


def _amount(value: Any) -> str:
    return "one" if isinstance(value, str) else "several"


# One stack, or several, of which the first that fits counts.
Stacks = Annotated[Annotated[Name, Tag("one")] | Annotated[Names, Tag("several")], Discriminator(_amount)]


class Facts(BaseModel):
    """Base of all models: unknown keys are errors, nothing is converted silently, nothing changes afterwards."""

    model_config = ConfigDict(extra="forbid", strict=True, frozen=True, defer_build=True)
