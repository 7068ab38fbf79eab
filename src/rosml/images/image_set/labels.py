"""The labels of images and parts, for the bake file and for joins in a registry.

A part's labels have its facts and its needs, so that you can join it with nothing but the registry.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple

from rosml.images.image_set.model import Image, Part
from rosml.images.matrix import names
from rosml.images.matrix.combinations import Brought
from rosml.images.matrix.model import ANY_PYTHON, PartEntry
from rosml.images.matrix.patterns import VARIABLE
from rosml.images.matrix.tags import main_tag, spelled_tag

PREFIX = "io.rosml."
TITLE = "org.opencontainers.image.title"
DESCRIPTION = "org.opencontainers.image.description"
VERSION = "org.opencontainers.image.version"
SOURCE = "org.opencontainers.image.source"
REVISION = "org.opencontainers.image.revision"

LICENSES = "org.opencontainers.image.licenses"

OCI = "org.opencontainers.image."
"""The prefix of labels that an index also has as annotations."""

BASE_NAME, BASE_DIGEST = f"{OCI}base.name", f"{OCI}base.digest"
"""The labels of an image with the one below it: for an app, its base image."""

LOCK = f"{PREFIX}lock"
"""The label of an app with its inputs, as in the lock file."""

BRINGS = f"{PREFIX}brings"
"""The label of a part with its software, each with its name in tags and its title: `tensorflow:tf:TensorFlow`."""

APP = f"{PREFIX}app"
"""The label of an app's image with its target, such as `run`. Its title is the app's name."""

GPU = f"{PREFIX}gpu."
"""The prefix of the labels about drivers and GPUs: `driver`, `torch.amd64`."""

RUNTIME = f"{PREFIX}runtime"
"""The label of an image with the component that runs programs built on it."""

COMPRESSED = f"{PREFIX}compression"
"""The label of an image or part whose layers are not compressed by zstd: `gzip`. Apps on such an image are compressed alike."""

RMW = f"{PREFIX}rmw"
"""The label of an image whose ROS 2 has another default RMW implementation than Fast DDS's."""

OWN = f"{PREFIX}own"
"""The label of an image that is not ours and got ROS, if it has its own CUDA or framework: which, and the variables that say so."""

ADDONS = f"{PREFIX}addons"
"""The label of an image with the names of its add-ons; and of a part of one, with their parts: `onnx=cuda*,common,onnx-cc*,onnx`."""

PARTS = f"{PREFIX}parts"
"""The label of an image with the names of its parts."""

ENVIRONMENT = f"{PREFIX}environment"
"""The label of an environment as an image of its own: its name."""

ENVIRONMENTS = f"{PREFIX}environments"
"""The label of an image with the names of its environments."""

ENVIRONMENTS_FOLDER = "/opt/env"
"""Where images have their environments, each in a folder with its name."""

TAKES = f"{PREFIX}takes"
"""The label of an environment with the releases that it takes from its image: `torch=2.10.0`."""

NEEDS = f"{PREFIX}needs"
"""The label of an environment with the names of all packages that it takes from its image."""

RELEASE = f"{PREFIX}release"
"""The label of a part with the name of its release."""


RESTRICTED = f"{PREFIX}restricted"
"""The label with the restricted parts of an image, or with the name of a part that is one."""

JOINED = f"{PREFIX}joined"
"""The annotation of an image in its index with the digests of the images from which `rosml join` made it. It names no repository, so that
the same parts give the same digest wherever they are."""

COVERED = f"{PREFIX}sbom."
"""The prefix of an image's annotations in its index that name the SBOMs of its ROS image and parts, by repository and digest."""

SBOM = f"{PREFIX}sbom"
"""The annotation of a joined image in its index that names the SBOM of the whole image, likewise."""

VEX = f"{PREFIX}vex"
"""The annotation of an image in its index that names its VEX, likewise."""


class ImageKind(NamedTuple):
    """What an image is, in the words of the matrix; `ros` is 1 or 2."""

    distribution: str
    component: str
    ros: str
    framework: str = "none"
    stack: str | None = None
    addons: Sequence[str] = ()


def about_image(image: ImageKind, brought: Sequence[Brought]) -> dict[str, str]:
    """The labels that describe an image to people. `brought` is its software, in the order of the environment."""
    carried = [f"{item.title} {item.version}" for item in brought if item.title]
    return {
        TITLE: names.image_target(image.distribution, image.component, image.framework, image.stack, image.addons),
        DESCRIPTION: ", ".join([f"ROS {image.ros} {image.component} ({image.distribution})", *carried]),
        VERSION: spelled_tag(main_tag(image.distribution, image.component, image.stack), spelled(brought)),
        f"{PREFIX}component": image.component,
    }


def with_environments(image: Mapping[str, str], present: Iterable[str], environments: Iterable[str]) -> dict[str, str]:
    """The labels that change if environments are joined to an image with these labels, which has the `present` ones. An app keeps its names."""
    before, added = [*present], sorted(environments)
    changed = {ENVIRONMENTS: " ".join(sorted([*before, *added]))}
    if not image.get(APP):
        earlier, end = names.environments_end(before), names.environments_end([*before, *added])
        changed |= {name: image[name].removesuffix(earlier) + end for name in (TITLE, VERSION) if name in image}
    if DESCRIPTION in image:
        changed[DESCRIPTION] = ", ".join([image[DESCRIPTION], *(f"environment {name}" for name in added)])
    return changed


def without_environments(image: Mapping[str, str]) -> dict[str, str]:
    """The labels that `with_environments` changes, as they were before."""
    names_of_image = image.get(ENVIRONMENTS, "").split()
    end, words = names.environments_end(names_of_image), {f"environment {name}" for name in names_of_image}
    changed = {name: image[name].removesuffix(end) for name in (TITLE, VERSION) if name in image}
    if DESCRIPTION in image:
        changed[DESCRIPTION] = ", ".join(word for word in image[DESCRIPTION].split(", ") if word not in words)
    return changed


def of_environment(name: str, python: str, takes: Mapping[str, str], needs: Iterable[str] = ()) -> dict[str, str]:
    """The labels of an environment: what a join has to know. It takes these releases of its image, and needs these packages of it."""
    return {
        TITLE: names.environment_part(name, python),
        DESCRIPTION: f"environment {name} below {ENVIRONMENTS_FOLDER}, for Python {python}",
        ENVIRONMENT: name,
        f"{PREFIX}python": python,
        TAKES: " ".join(f"{release}={version}" for release, version in sorted(takes.items())),
        NEEDS: " ".join(sorted(needs)),
    }


def spelled(brought: Sequence[Brought]) -> dict[str, str]:
    """The versions in tags of an image, by their names in tags: those of its releases, or else of its stack."""
    called = [item for item in brought if item.short]
    return {item.short: item.version for item in [item for item in called if item.released] or called}


def environment(brought: Sequence[Brought]) -> dict[str, str]:
    """The variables of an image about the software that was joined to it."""
    versions = {f"{variable(item.name)}_VERSION": item.version for item in brought}
    needed = {name: value for item in brought for name, value in item.environment.items()}
    cuda = next((item.version for item in brought if item.name == "cuda"), None)
    return versions | needed | ({REQUIRE: required_driver(cuda)} if cuda else {})


REQUIRE = "NVIDIA_REQUIRE_CUDA"
"""The variable that NVIDIA's container runtime compares with the driver before it starts a container."""


def required_driver(cuda: str) -> str:
    """The condition of a version of CUDA on the driver: the first release of its generation, by NVIDIA's minor-version
    compatibility: `cuda>=12.0` for 12.8.90."""
    return f"cuda>={cuda.partition('.')[0]}.0"


def about_gpus(facts: Mapping[str, str]) -> dict[str, str]:
    """The labels about GPUs."""
    return {GPU + name: value for name, value in facts.items()}


def compressed(compression: str) -> dict[str, str]:
    """The label about an unusual compression; none about the usual one."""
    return {COMPRESSED: compression} if compression != "zstd" else {}


def licensed(entries: Iterable[PartEntry], own_licences: str = "") -> dict[str, str]:
    """The labels about licences of a part, or of an image with parts and `own_licences`."""
    all_entries = list(entries)
    spdx = [own_licences, *(entry.licence.spdx for entry in all_entries if entry.licence)]
    return together(spdx, [entry.name for entry in all_entries if entry.restricted])


def together(licences: Iterable[str], restricted: Iterable[str]) -> dict[str, str]:
    """The labels about licences of things that become one: their SPDX expressions, which may be empty, and their restricted parts."""
    terms = (term.strip() for text in licences for term in (f"({text})" if " OR " in text else text).split(" AND "))
    values = {
        LICENSES: " AND ".join(dict.fromkeys(filter(None, terms))),
        RESTRICTED: " ".join(dict.fromkeys(restricted)),
    }
    return {name: text for name, text in values.items() if text}


def variable(name: str) -> str:
    """The beginning of variables about a part or a version."""
    return name.upper().replace("-", "_")


def of_part(
    entry: PartEntry,
    stack: str,
    python: str,
    brought: Sequence[Brought],
    frameworks: Mapping[str, Sequence[PartEntry]],
    addons: Mapping[str, Sequence[PartEntry]] | None = None,
) -> dict[str, str]:
    """The labels of a part, without those of `about_gpus`. `frameworks` and `addons` take it, each with all its parts. `python` may be
    `any`."""
    pythons = "any Python" if python == ANY_PYTHON else f"Python {python}"
    return {
        TITLE: names.part_name(entry.name, stack, python),
        DESCRIPTION: f"part {entry.name} of stack {stack}, for {pythons}",
        f"{PREFIX}part": entry.name,
        f"{PREFIX}stack": stack,
        f"{PREFIX}python": python,
        **{f"{PREFIX}{item.name}": item.version for item in brought},
        **{_needs(item.name): _pairs(item.environment) for item in brought if item.environment},
        **({BRINGS: called(brought)} if brought else {}),
        **({RELEASE: entry.release} if entry.release else {}),
        **licensed([entry]),
        **({f"{PREFIX}frameworks": _combinations(frameworks)} if frameworks else {}),
        **({ADDONS: _combinations(addons)} if addons else {}),
    }


def _combinations(parts: Mapping[str, Sequence[PartEntry]]) -> str:
    """Names, each with its parts, as text of a label: `torch=cuda*,common,torch`."""
    return " ".join(f"{name}={_marked(parts[name])}" for name in smallest_first(parts))


def _marked(parts: Iterable[PartEntry]) -> str:
    """Names of parts; those for any Python have a *."""
    return ",".join(f"{part.name}*" if part.any_python else part.name for part in parts)


def called(brought: Sequence[Brought]) -> str:
    """The software of a part, as text of a label: `cuda:cuda:CUDA cudnn::`."""
    return " ".join(f"{item.name}:{item.short}:{item.title}" for item in brought)


def _needs(name: str) -> str:
    """The label of a part with the variables that software in it needs."""
    return f"{PREFIX}{name}.environment"


def _pairs(environment: Mapping[str, str]) -> str:
    """Variables as text of a label: `ORT_DISABLE_TELEMETRY=1`."""
    return " ".join(f"{name}={value}" for name, value in environment.items())


def brought_by(labels: Mapping[str, str]) -> Iterator[Brought]:
    """The software of a part with these labels. Raises a ValueError if the label is damaged."""
    for item in labels.get(BRINGS, "").split():
        name, short, title = item.split(":")
        if version := labels.get(PREFIX + name):
            environment = dict(pair.split("=") for pair in labels.get(_needs(name), "").split())
            if wrong := next((name for name in environment if not re.fullmatch(VARIABLE, name)), ""):
                raise ValueError(wrong)
            yield Brought(name, version, title, short, RELEASE in labels, environment)


def smallest_first(frameworks: Mapping[str, Sequence[object]]) -> list[str]:
    """Frameworks by the number of their parts, then by name; the order of the matrix does not count."""
    return sorted(frameworks, key=lambda name: (len(frameworks[name]), name))


def combinations(text: str) -> dict[str, tuple[str, ...]]:
    """The parts of every framework or add-on that takes a part, from its label: the smallest first. Raises a ValueError if it is
    damaged."""
    pairs = (item.split("=") for item in text.split())
    return {name: tuple(part.removesuffix("*") for part in parts.split(",")) for name, parts in pairs}


def any_python(text: str, part: str) -> bool:
    """Whether a part is for any Python, by the label that names it."""
    return f"{part}*" in re.split("[ =,]", text)


def title(thing: Image | Part) -> str:
    """The title of an image or part, for the label, the annotation and the SBOMs of joined images."""
    return thing.name if isinstance(thing, Part) else thing.target
