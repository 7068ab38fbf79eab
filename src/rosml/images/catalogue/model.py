"""The structure of catalogue.json: what is published, for the page and for other people's programs.

If a field that readers rely on goes away or changes its meaning, raise `FORMAT`; a new field does not raise it. The descriptions
here become catalogue.schema.json.
"""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import ConfigDict, Field

from rosml.base.shapes import Shape
from rosml.images.image_set import missing_locks
from rosml.images.image_set.model import Image as MatrixImage
from rosml.images.matrix.patterns import DIGEST
from rosml.images.scan.policy import ADVISORY, LONGEST, Severity
from rosml.images.scan.policy import Status as VexStatus

FORMAT = 1

Status = Literal["built", "not built"]
"""Whether an image is published."""

WORDS: dict[Status, str] = {"built": "built", "not built": "not built yet"}
"""The same for people."""

Bytes = Annotated[int, Field(ge=0)]
Digest = Annotated[str, Field(pattern=DIGEST)]
Count = Annotated[int, Field(ge=0)]

SIGNER = r"^(?:https://[A-Za-z0-9._~/@:+-]+|sha256:[0-9a-f]{64})$"
"""A signature's identity that people may copy into a shell: the address of a workflow, or the digest of a public key."""


class Fact(Shape):
    """Base of all: unknown keys are errors, nothing changes afterwards."""

    model_config = ConfigDict(
        extra="forbid", frozen=True, serialize_by_alias=True, validate_by_name=True, validate_by_alias=True
    )


class Distribution(Fact):
    """A ROS distribution, as matrix.yaml has it."""

    ros: Literal[1, 2] = Field(description="ROS 1 or ROS 2")
    os: str = Field(description="its operating system")
    python: str = Field(description="version of that one's Python")
    eol: str | None = Field(description="end of life, such as 2029-05-31; null for a rolling distribution")
    instead: tuple[str, ...] = Field(description="distributions to take instead, after its end of life; else empty")
    lts: bool = Field(description="a long-term release")
    experimental: bool = Field(description="not what its generation's users expect")


class Layer(Fact):
    """A layer, which any number of images may have."""

    digest: Digest
    compressed: Bytes = Field(description="bytes in the registry")
    part: str = Field(description="the ROS image or part that brought it; empty if unknown")


class Sbom(Fact):
    """An SBOM in CycloneDX, which the index of each image with this part names."""

    part: str = Field(description="the ROS image or part whose packages it lists")
    repository: str = Field(description="where it is, without the registry")
    digest: Digest = Field(description="of the artifact: regctl artifact get <registry>/<repository>@<digest>")


class Size(Fact):
    """Bytes of something."""

    compressed: Bytes = Field(description="in the registry")
    unpacked: Bytes | None = Field(description="on disk; null if unknown")


class Tests(Fact):
    """Structure tests that ran inside the image."""

    passed: Count
    failures: tuple[str, ...] = Field(description="those that did not pass")


Word = Annotated[str, Field(pattern=r"^[!-~]*$", max_length=LONGEST)]
"""A name or a version of a package: printable ASCII without a space."""


class Vulnerability(Fact):
    """A known vulnerability in a package of an image, and what the policy says about it."""

    id: Annotated[str, Field(pattern=ADVISORY, max_length=64)] = Field(description="advisory, such as CVE-2026-12345")
    severity: Severity
    package: Word
    installed: Word = Field(description="version in the image")
    fixed: Word = Field(description="version that fixes it; empty if none does")
    part: Word = Field(description="the ROS image or part that has the package")
    fails: bool = Field(description="whether the policy stops the image because of it")
    status: VexStatus | Literal[""] = Field(
        description="whether it concerns the image, in VEX's words; empty if nobody has judged it"
    )
    ignored: Annotated[str, Field(max_length=400)] = Field(
        description="why it does not stop the image; empty if the policy has no reason"
    )
    until: Annotated[str, Field(pattern=r"^([0-9]{4}-[0-9]{2}-[0-9]{2})?$")] = Field(
        description="the last day on which the policy accepts it; empty if no entry of the policy names it"
    )


class Scan(Fact):
    """The result of a scan for known vulnerabilities."""

    outcome: str = Field(description="clean, policy failed or scanner failed")
    database: str = Field(description="when the database of vulnerabilities was made; empty if unknown")
    packages: Count = Field(description="how many packages were held against it")
    findings: dict[str, Count] = Field(description="number of findings by severity, those that are ignored among them")
    failing: tuple[str, ...] = Field(description="advisories that stop the image")
    vulnerabilities: tuple[Vulnerability, ...] = Field(
        alias="named",
        description="at most 20 of the findings: those that stop the image, then the worst; none of older scans",
    )


class Platform(Fact):
    """An image, or part, for one platform."""

    platform: str = Field(description="such as linux/amd64")
    digest: Digest = Field(description="of the image manifest")
    inputs: str = Field(description="digest of all that decides its content; empty if unknown")
    ros_sync: str = Field(
        description="of when ROS's packages are: the repository's date, or a digest of the system's lists; else empty"
    )
    size: Size
    parts: dict[str, Size] = Field(description="what it is the sum of: ROS images by target, parts by name")
    layers: tuple[Count, ...] = Field(description="its layers, lowest first: positions in the catalogue's `layers`")
    sboms: tuple[Count, ...] = Field(description="its SBOMs: positions in the catalogue's `sboms`; none if unknown")
    versions: dict[str, str] = Field(description="the versions found inside; those of the labels if it was not tested")
    found_inside: bool = Field(description="whether the versions were found inside, by the tests")
    tests: Tests | None = Field(description="null if unknown")
    scan: Scan | None = Field(description="null if there was none")


class Build(Fact):
    """A build: the index of a tag, now or before."""

    digest: Digest = Field(description="of the index")
    created: str = Field(description="date of the run that made it, such as 2026-11-22T03:00:00Z; else empty")
    tags: tuple[str, ...] = Field(description="tags that point at it now; none may be left")
    platforms: tuple[Platform, ...]
    signed: tuple[Annotated[str, Field(pattern=SIGNER)], ...] = Field(
        description="who signed it, as the records of the last run say: workflows, or digests of public keys"
    )


class Tag(Fact):
    """A tag of a repository."""

    name: str
    kind: Literal["main", "versions", "floating", "dated"] = Field(
        description="the main one; one that spells versions out; a short one; one that never moves"
    )
    digest: Digest


class Move(Fact):
    """A run moved the main tag."""

    run: str = Field(description="date of the run")
    previous: str = Field(alias="old", description="the digest before; empty if there was none")
    new: str


class Tagged(Fact):
    """The common fields of images and parts."""

    repository: str = Field(description="without the registry")
    tags: tuple[Tag, ...] = Field(description="the main one first; none if nothing is published")
    builds: tuple[Build, ...] = Field(
        description="the one that the main tag points at first, then others, newest first"
    )
    moves: tuple[Move, ...] = Field(description="as far as records of runs are kept, newest first")


class AddOn(Fact):
    """An add-on: parts that go onto any image of their stacks."""

    title: str = Field(description="what it brings, such as onnxruntime")
    words: tuple[str, ...] = Field(description="words by which people look for it")
    stacks: tuple[str, ...]
    restricted: bool = Field(description="whether images with it go to private registries alone")


class Taken(Fact):
    """An add-on that an image can take."""

    addon: str
    parts: tuple[str, ...] = Field(description="the parts that the image lacks, for `rosml join`, in their order")
    platforms: tuple[str, ...]


class Image(Tagged):
    """An image that the matrix describes."""

    target: str = Field(description="bake target")
    distribution: str
    component: str
    framework: str
    stack: str | None
    addons: tuple[str, ...] = Field(description="the add-ons that it has")
    takes: dict[str, Taken] = Field(
        description="the add-ons that it can take besides, as `rosml containerize --addons` names them: onnx, or onnx-cpu if it has no stack"
    )
    only_runs: bool = Field(description="without compilers: for programs that are built elsewhere")
    platforms: tuple[str, ...] = Field(description="those that the matrix allows; a build has its own")
    promised: dict[str, str] = Field(description="versions that the matrix gives it")
    promised_tags: tuple[str, ...] = Field(
        description="tags that a publishing run gives it, published or not; the main one first"
    )
    gpu: dict[str, str] = Field(
        description="of images with CUDA: `driver`, the oldest NVIDIA driver; by release and architecture the GPUs that it was built for"
    )
    search: tuple[str, ...] = Field(description="words by which people look for it, such as noble, py312, gpu")
    status: Status
    reason: str = Field(description="why it is not published; empty if it is")


class Part(Tagged):
    """A part, built once for a stack. You can add it to any image with the same Python."""

    name: str
    kind: str
    stack: str
    python: str = Field(description="`any` if it is the same for all")
    platforms: tuple[str, ...]


class Sharing(Fact):
    """The bytes saved by sharing layers, in the images of main tags, on all platforms."""

    images: Count = Field(description="number of manifests")
    apart: Bytes = Field(description="bytes if each had its layers to itself")
    stored: Bytes = Field(description="bytes with each layer once")


class Published(Fact):
    """All that is published, and what is not."""

    format: Literal[1] = Field(description="version of this format")
    created: str = Field(description="when this was written")
    registry: str = Field(description="registry and path, to be put before a repository's name")
    source: str | None = Field(description="the project's address")
    distributions: dict[str, Distribution]
    addons: dict[str, AddOn]
    words: dict[Status, str] = Field(description="what people call each status")
    images: tuple[Image, ...]
    parts: tuple[Part, ...]
    layers: tuple[Layer, ...]
    sboms: tuple[Sbom, ...]
    sharing: Sharing


def status(image: MatrixImage, built: bool) -> tuple[Status, str]:
    """Whether an image was built, tested and published (`built`), and if not, why."""
    if built:
        return "built", ""
    return "not built", missing_locks.reason(image) if image.unlocked else "no publishing run has built it yet"
