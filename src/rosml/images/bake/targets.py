"""An image set -> its bake targets as plain data.

`bake_file` writes them for buildx. tests/unit/images/bake/test_targets.py compares buildx's reading of that file with these, for every
target and all variables of the bake file.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import Literal

from rosml.images.image_set import labels, missing_locks
from rosml.images.image_set.model import ENVIRONMENTS, PARTS, Environment, Image, ImageSet, Part
from rosml.images.matrix import combinations, names
from rosml.images.matrix.model import Matrix

EPOCH = "1767225600"
"""2026-01-01T00:00:00Z: the time of every file and image, so that the same inputs give the same digests."""

PROXIES = ("HTTP_PROXY", "HTTPS_PROXY", "NO_PROXY")

LICENCE = "Apache-2.0"
"""The licence of rosml's own files in ROS images. Packages of the system have theirs in /usr/share/doc."""

CONTENTS = "contents"
"""The target that describes the content of its context `described`."""


ENVIRONMENT = "environment"
"""The target that builds an environment of Python packages. Its caller names the locks and the arguments."""


ENVIRONMENT_LOCKS = "environment-locks"
"""The context of that target with its locks, one for each architecture."""


@dataclass(frozen=True)
class Overridable:
    """A fact of the matrix, unless a variable of the bake file has a value. The fact decides the inputs."""

    variable: str
    fact: str


@dataclass(frozen=True)
class Dependency:
    """A context: another target, or its image in the registry if DIGESTS has `name`. Without a name, the target is always built."""

    target: str
    name: str = ""
    repository: str = ""


@dataclass(frozen=True)
class NoInput:
    """A value that is no fact of the matrix: the caller of bake decides it, or it follows from other inputs.

    Attributes:
        what: `variable`: its value, if it is set; `sync date`: the date of ROS's repository of a distribution; `root`: the
            folder of a part's files in its context; `base name`, `base digest`: of the image that a variable names;
            `created`: SOURCE_DATE_EPOCH as a date.
        of: the variable, distribution or part.
    """

    what: Literal["variable", "sync date", "root", "base name", "base digest", "created"]
    of: str


Value = str | Overridable | NoInput
"""An argument or label: a fact, or a value that a variable decides. If something else shall decide one, give it its own type here."""


@dataclass(frozen=True)
class Locks:
    """A context: a folder with a lock for each architecture, relative to the project's root."""

    folder: str


Context = Dependency | Overridable | Locks


@dataclass(frozen=True)
class Join:
    """The additions of an image to a ROS image: parts in their order, and environment variables."""

    parts: tuple[str, ...]
    environment: Mapping[str, str]

    def dockerfile(self) -> str:
        """The Dockerfile of the join. *_ROOT is the folder of a part's files in its context."""
        lines = ["FROM ros"]
        for part in self.parts:
            root = root_variable(part)
            lines += [f"ARG {root}", f"COPY --link --from=part-{part} ${root} /"]
        return "\n".join([*lines, *(f"ENV {name}={value}" for name, value in self.environment.items()), ""])


def root_variable(part: str) -> str:
    """The argument for the folder of a part's files in its context."""
    return f"{labels.variable(part)}_ROOT"


@dataclass(frozen=True)
class Target:
    """A target for buildx. One without a stage joins parts, one without platforms is for the builder's own. Tags have no registry."""

    stage: str
    contexts: Mapping[str, Context]
    arguments: Mapping[str, Value]
    platforms: tuple[str, ...] = ()
    tags: tuple[str, ...] = ()
    labels: Mapping[str, Value] = field(default_factory=dict)
    description: str = ""
    join: Join | None = None


def of(image_set: ImageSet) -> dict[str, Target]:
    return dict(_targets(image_set))


def _targets(image_set: ImageSet) -> Iterator[tuple[str, Target]]:
    matrix = image_set.matrix
    assembler = matrix.default.assembler
    description = "the packages and files of the image that its context `described` is"
    yield CONTENTS, Target(CONTENTS, {"os": _system(matrix, assembler)}, _common(), description=description)
    description = "an environment of Python packages: rosml env build"
    yield ENVIRONMENT, Target(ENVIRONMENT, {"os": _system(matrix, assembler)}, _common(), description=description)
    for os in dict.fromkeys(image.os for image in image_set.images):
        facts = matrix.operating_systems[os]
        platforms = tuple(matrix.architectures[name].platform for name in facts.architectures)
        arguments = {**_common(), "NUMPY": facts.numpy}
        for runtime in sorted(
            {combinations.only_runs(matrix, image.component) for image in image_set.images if image.os == os}
        ):
            image_arguments = {**arguments, "RUNTIME": "true"} if runtime else arguments
            yield names.os_target(os, runtime), Target("base", {"os": _system(matrix, os)}, image_arguments, platforms)
    for part in image_set.parts:
        yield from _environment(matrix, part) if isinstance(part, Environment) else _part(matrix, part)
    for image in image_set.images:
        yield image.target, _joined(image_set, image) if image.stack else _ros(image_set, image)
        contexts: dict[str, Context] = {"os": _system(matrix, assembler), "image": _dependency(image)}
        arguments = {**_common(), "TESTS": " ".join(image.tests), "EXPECT": _expected(image_set, image)}
        yield image.test_target, Target("test", contexts, arguments, image.platforms)


def _common() -> dict[str, Value]:
    """The arguments of every target."""
    epoch = Overridable("SOURCE_DATE_EPOCH", EPOCH)
    return {"SOURCE_DATE_EPOCH": epoch, **{proxy: NoInput("variable", proxy) for proxy in PROXIES}}


def base_image(matrix: Matrix, os: str) -> str:
    system = matrix.operating_systems[os]
    return f"docker-image://{system.image}@{system.digest}"


def _system(matrix: Matrix, os: str) -> Overridable:
    return Overridable(names.os_variable(os), base_image(matrix, os))


def _dependency(image: Image) -> Dependency:
    return Dependency(image.target, image.target, image.repository)


def _ros(image_set: ImageSet, image: Image) -> Target:
    """An image without a framework: a component on the one below it; the lowest is on the operating system."""
    matrix = image_set.matrix
    distribution = matrix.distributions[image.distribution]
    parent = image_set.by_target.get(image.parent)
    contexts: dict[str, Context] = {"parent": _dependency(parent) if parent else Dependency(image.parent)}
    arguments: dict[str, Value] = {**_common(), "ROS_DISTRO": image.ros_distro, "ROS_VERSION": str(image.ros)}
    if image.packages:
        arguments["ROS_PACKAGES"] = image.packages
    if combinations.only_runs(matrix, image.component):
        arguments["RUNTIME"] = "true"
    if parent is None and (first := tools(matrix, image)):
        arguments["ROS_TOOLS"] = first
    if facts := apt_arguments(matrix, image.distribution):
        arguments |= {name: Overridable(name, fact) if name in CHANNEL else fact for name, fact in facts.items()}
        arguments["ROS_SYNC_DATE"] = NoInput("sync date", image.distribution)
    if distribution.wheels:  # the stage takes uv from the assembler of parts, which stands on the system's base image
        arguments |= {"ROS_ROW": image.distribution, "PYTHON": image.python}
        contexts["os"] = _system(matrix, image.os)
    stage = "ros-wheels" if distribution.wheels else "ros"
    return Target(stage, contexts, arguments, image.platforms, image.tags, _labels(matrix, image), unlocked(image))


CHANNEL = ("ROS_CHANNEL", "ROS_SNAPSHOT")
"""Arguments of a distribution that variables of the same names may override."""


def apt_arguments(matrix: Matrix, name: str) -> dict[str, str]:
    """The facts about the apt repository of a distribution's packages; none if they are the operating system's, or wheels."""
    if archive := matrix.distributions[name].archive:
        return {
            "ROS_ARCHIVE": archive.address,
            "ROS_CODENAME": archive.suite,
            "ROS_COMPONENTS": " ".join(archive.components),
            "ROS_SIGNED_BY": archive.key,
        }
    if not (apt := matrix.distributions[name].apt):
        return {}
    facts = {
        "ROS_CHANNEL": apt.channel,
        "ROS_SNAPSHOT": apt.date.isoformat() if apt.date else "",
        "ROS_CODENAME": matrix.operating_systems[matrix.distributions[name].os].codename or "",
        "ROS_LIVE_ADDRESS": combinations.ros_live(matrix, name),
        "ROS_SNAPSHOT_ADDRESS": combinations.ros_snapshot(matrix, name, "{day}"),
    }
    others = {
        "ROS_TESTING_ADDRESS": combinations.ros_testing(matrix, name),
        "ROS_APT_SOURCE": combinations.ros_apt_source(matrix, name),
    }
    return facts | {name: fact for name, fact in others.items() if fact}


def tools(matrix: Matrix, image: Image) -> str:
    """The Debian packages of the lowest component: developers' tools, unless it only runs built programs; and more RMW implementations."""
    distribution = matrix.distributions[image.distribution]
    tools = distribution.tools or matrix.operating_systems[distribution.os].tools
    added = [f"ros-{image.ros_distro}-{rmw.replace('_', '-')}" for rmw in distribution.rmw]
    return " ".join(added if combinations.only_runs(matrix, image.component) else [tools, *added])


def unlocked(image: Image) -> str:
    """The message about a target that cannot be built yet; empty if it can."""
    return "" if image.locked else f"cannot be built yet: no lock; {missing_locks.remedy(image)}"


def _joined(image_set: ImageSet, image: Image) -> Target:
    """An image with a framework: parts joined to a ROS image."""
    matrix = image_set.matrix
    parts = {part.kind: part for part in map(image_set.part_by_name.__getitem__, image.parts)}
    contexts: dict[str, Context] = {"ros": _dependency(image_set.by_target[image.parent])}
    contexts |= {
        f"part-{kind}": Dependency(names.files_target(part.name), part.name, part.repository)
        for kind, part in parts.items()
    }
    roots = {root_variable(kind): NoInput("root", part.name) for kind, part in parts.items()}
    join = Join(tuple(parts), labels.environment(image.brought))
    arguments = {**_common(), **roots}
    return Target("", contexts, arguments, image.platforms, image.tags, _labels(matrix, image), unlocked(image), join)


def _labels(matrix: Matrix, image: Image) -> dict[str, Value]:
    variable = names.os_variable(image.os)
    distribution = matrix.distributions[image.distribution]
    stack = matrix.stacks[image.stack] if image.stack else None
    kinds = combinations.parts(matrix, matrix.carrying(image.framework, *image.addons), stack) if stack else ()
    kind = labels.ImageKind(
        image.distribution, image.component, str(image.ros), image.framework, image.stack, image.addons
    )
    labels_of_image: dict[str, Value] = {
        **labels.licensed([matrix.part[name] for name in kinds], LICENCE),
        labels.REVISION: NoInput("variable", "REVISION"),
        f"{labels.OCI}created": NoInput("created", "SOURCE_DATE_EPOCH"),
        f"{labels.OCI}base.name": NoInput("base name", variable),
        f"{labels.OCI}base.digest": NoInput("base digest", variable),
        f"{labels.PREFIX}distribution": image.distribution,
        f"{labels.PREFIX}framework": image.framework,
        f"{labels.PREFIX}os": image.os,
        f"{labels.PREFIX}python": image.python,
        f"{labels.PREFIX}ros": str(image.ros),
        **{f"{labels.PREFIX}{item.name}": item.version for item in image.brought},
        **labels.about_gpus(image.gpu),
        **labels.about_image(kind, image.brought),
        **labels.compressed(matrix.compression),
    }
    if runtime := combinations.runtime(matrix, image.distribution, image.component):
        labels_of_image[labels.RUNTIME] = runtime
    if matrix.source:
        labels_of_image[labels.SOURCE] = matrix.source
    if image.stack:
        labels_of_image[f"{labels.PREFIX}stack"] = image.stack
        labels_of_image[labels.PARTS] = " ".join(kinds)
    if image.addons:
        labels_of_image[labels.ADDONS] = " ".join(image.addons)
    if distribution.apt or distribution.archive:
        labels_of_image[f"{labels.PREFIX}ros.sync"] = NoInput("sync date", image.distribution)
    if distribution.usual_rmw:
        labels_of_image[labels.RMW] = distribution.usual_rmw
    if distribution.experimental:
        labels_of_image[f"{labels.PREFIX}experimental"] = "true"
    if image.environment:
        facts = {name: text for name, text in labels_of_image.items() if isinstance(text, str)}
        labels_of_image |= labels.with_environments(facts, (), (image.environment,))
    return labels_of_image


def _part(matrix: Matrix, part: Part) -> Iterator[tuple[str, Target]]:
    """A part's files below /out, and the part as an image of its own."""
    contexts = {"os": _system(matrix, part.os)}
    arguments: dict[str, Value] = {
        **_common(),
        "PART": part.kind,
        "STACK": part.stack,
        "PYTHON": part.python,
        "WHEEL_PYTHON": matrix.operating_systems[part.os].python,
        "ACCELERATOR": matrix.stacks[part.stack].accelerator,
    }
    if glibc := combinations.glibc(matrix, part.stack, part.kind):
        arguments["GLIBC"] = glibc
    if slot := matrix.part[part.kind].slot:
        arguments["SLOT"] = f"{slot:02}"
    if index := combinations.index(matrix, part.stack, part.kind):
        arguments["INDEX"] = index
    shown = combinations.shown(matrix, part.kind)
    if shown and matrix.part[shown].accelerator in (None, matrix.stacks[part.stack].accelerator):
        arguments["SHOWS"] = shown
    taking = {
        name: [matrix.part[kind] for kind in kinds]
        for name, kinds in combinations.frameworks(matrix, part.stack).items()
        if part.kind in kinds
    }
    brought = combinations.brought(matrix, [part.kind], matrix.stacks[part.stack])
    gpu = combinations.gpu(matrix, part.stack, [part.kind])
    adding = {
        name: [matrix.part[kind] for kind in kinds]
        for name, kinds in combinations.addons(matrix, part.stack).items()
        if part.kind in matrix.addons[name].parts
    }
    part_labels = labels.of_part(matrix.part[part.kind], part.stack, part.python, brought, taking, adding)
    part_labels |= labels.about_gpus(gpu) | labels.compressed(matrix.compression)
    yield names.files_target(part.name), Target("part-files", contexts, arguments, part.platforms)
    tags = (f"{PARTS}:{part.name}",)
    yield part.target, Target("part", contexts, arguments, part.platforms, tags, part_labels)


def _environment(matrix: Matrix, part: Environment) -> Iterator[tuple[str, Target]]:
    """An environment's files below /out, and the environment as an image of its own. `rosml env build` builds it by the same stages."""
    folder = names.environment_locks(part.environment, part.python)
    contexts: dict[str, Context] = {"os": _system(matrix, part.os), ENVIRONMENT_LOCKS: Locks(folder)}
    arguments: dict[str, Value] = {**_common(), "ENVIRONMENT": part.environment, "PYTHON": part.python}
    if part.glibc:
        arguments["GLIBC"] = str(part.glibc)
    own_labels = labels.of_environment(part.environment, part.python, part.takes, part.needs)
    yield names.files_target(part.name), Target("environment-files", contexts, arguments, part.platforms)
    tags = (f"{ENVIRONMENTS}:{part.tag}",)
    yield part.target, Target(ENVIRONMENT, contexts, arguments, part.platforms, tags, own_labels)


def _expected(image_set: ImageSet, image: Image) -> str:
    """The promises of tags and labels, for the tests in the image, which see `torch` as $EXPECT_TORCH."""
    distribution = image_set.matrix.distributions[image.distribution]
    packages: dict[str, str] = {}
    ros: Image | None = image
    while ros:
        if ros.packages and not combinations.only_runs(image_set.matrix, ros.component):
            packages[f"packages_{ros.component.replace('-', '_')}"] = ros.packages.replace(" ", ",")
        ros = image_set.by_target.get(ros.parent)
    facts = {"os": image.os, "python": image.python, "ros": str(image.ros), "ros_distro": image.ros_distro}
    if distribution.rmw:
        facts["rmw"] = ",".join(distribution.rmw)
    if image.environment:
        facts["environment"] = image.environment
    if distribution.wheels:
        facts["wheels"] = wheels(distribution.wheels)
    if families := image_set.matrix.families:
        facts["releases"] = ",".join(families)
    company = combinations.company(image_set.matrix, image.stack, image.versions)
    gpu = {f"gpu_{re.sub('[.-]', '_', name)}": value.replace(" ", ",") for name, value in image.gpu.items()}
    facts |= {**dict(reversed(packages.items())), **image.versions, **company, **gpu}
    return " ".join(f"{name}={fact}" for name, fact in facts.items())


def wheels(requirements: tuple[str, ...]) -> str:
    """Python packages with their versions, without extras: `ros-jazzy-rclpy==7.1.6,ros-std-msgs==5.3.6`."""
    return ",".join(re.sub(r"\[.*\]", "", item) for item in requirements)
