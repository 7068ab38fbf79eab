"""A catalogue -> the text of docker-bake.hcl."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from rosml import labels, missing, names, rules
from rosml.expand import Catalogue, Image, Payload
from rosml.hcl import Expression, block, call, template, text
from rosml.model import PARTS, Apt, Distribution, Matrix

EPOCH = "1767225600"
"""2026-01-01T00:00:00Z: the time of every file and image, so that the same inputs give the same digests."""

PROXIES = ("HTTP_PROXY", "HTTPS_PROXY", "NO_PROXY")

Labels = Mapping[str, "str | Expression"]

Target = tuple[str, Mapping[str, Any]]
"""Name and attributes of a bake target."""


@dataclass(frozen=True)
class Dependency(Expression):
    """A context that is another target; its image in the registry, where DIGESTS names it."""

    target: str


@dataclass(frozen=True)
class Overridable(Expression):
    """A fact of the matrix that a variable may override."""

    fact: str


@dataclass(frozen=True)
class NoInput(Expression):
    """An expression that holds no fact of the matrix: the caller of the bake file decides its value, or it follows from
    what is an input anyway."""


def render(catalogue: Catalogue) -> str:
    """The bake file. Depends on nothing but the catalogue."""
    parts = list(_head(catalogue))
    for title, content in _sections(catalogue):
        parts += [_title(title), *(block("target", name, attributes) for name, attributes in content)]
    parts += [_title("Groups"), *_groups(catalogue)]
    return "\n".join(parts)


def excerpt(catalogue: Catalogue, roots: Iterable[str]) -> str:
    """The bake file with nothing but some targets and what they stand on, word for word as the whole has it.

    buildx evaluates a whole file, which takes seconds for some hundred images.
    """
    every = targets(catalogue)
    needed: set[str] = set()
    todo = list(roots)
    while todo:
        name = todo.pop()
        if name not in needed:
            needed.add(name)
            todo += [*every[name].get("inherits", ()), *_contexts(every[name].get("contexts", {}))]
    blocks = [block("target", name, attributes) for name, attributes in every.items() if name in needed]
    return "\n".join([*_head(catalogue), *blocks])


def _contexts(contexts: Mapping[str, str | Expression]) -> Iterator[str]:
    """The targets among named contexts."""
    for value in contexts.values():
        if isinstance(value, Dependency):
            yield value.target
        elif isinstance(value, str) and value.startswith("target:"):
            yield value.removeprefix("target:")


def targets(catalogue: Catalogue) -> dict[str, Mapping[str, Any]]:
    """The attributes of every target by its name: the bake file as data, for whoever asks what a target depends on."""
    return {name: attributes for _, content in _sections(catalogue) for name, attributes in content}


def variables(matrix: Matrix) -> dict[str, str]:
    """The default of every variable by its name."""
    return {name: default for name, default, _ in _variables(matrix)}


def _sections(catalogue: Catalogue) -> Iterator[tuple[str, Iterator[Target]]]:
    yield "What targets have in common", _abstract(catalogue)
    yield "Operating systems with the essentials", _operating_systems(catalogue)
    yield "ROS images: a chain of components", _ros_images(catalogue)
    yield "Payloads: assembled once, joined to many images", _payloads(catalogue)
    yield "Images with a framework: a ROS image joined with payloads", _joined_images(catalogue)
    yield "Structure tests, inside the build", _tests(catalogue)


def _title(title: str) -> str:
    return f"# ---- {title} ".ljust(118, "-") + "\n"


_HEADER = """\
# Generated from matrix.yaml by scripts/generate_bake.py: change matrix.yaml, then run
#   make generate
#
#   docker buildx bake {target}          builds an image (and what it stands on)
#   docker buildx bake {target}-test     runs its structure tests inside the build
#   docker buildx bake --print <target>       shows what would be built
"""

_FUNCTIONS = """\
# The digest of a dependency that is to be taken from the registry; empty if it is to be built here.
function "digest" {
  params = [name]
  result = lookup(jsondecode(DIGESTS == "" ? "{}" : DIGESTS), name, "")
}

# A dependency: built here, unless DIGESTS names it. The only place that decides.
function "dependency" {
  params = [name, repository, target]
  result = digest(name) == "" ? "target:${target}" : "docker-image://${REGISTRY}/${repository}@${digest(name)}"
}

function "image" {
  params = [repository, name]
  result = dependency(name, repository, name)
}

# A payload part, and where its files are in that context.
function "part" {
  params = [name]
  result = dependency(name, "payload", "_files-${name}")
}

function "root" {
  params = [name]
  result = digest(name) == "" ? "/out/" : "/"
}

# The name and the digest of a base image, for labels; no digest, no label.
function "image_name" {
  params = [context]
  result = trimprefix(split("@", context)[0], "docker-image://")
}

function "image_digest" {
  params = [context]
  result = try(split("@", context)[1], null)
}

function "platforms" {
  params = [all]
  result = PLATFORM == "" ? all : [PLATFORM]
}

# The date of the ROS repository of a distribution, where the caller knows it.
function "sync_date" {
  params = [distribution]
  result = lookup(jsondecode(ROS_SYNC_DATES == "" ? "{}" : ROS_SYNC_DATES), distribution, "")
}

# A fact of matrix.yaml, unless the caller says otherwise.
function "overridable" {
  params = [fact, value]
  result = value == "" ? fact : value
}

# A build argument that is left out when it is empty.
function "given" {
  params = [value]
  result = value == "" ? null : value
}
"""


def _head(catalogue: Catalogue) -> Iterator[str]:
    yield _HEADER.format(target=catalogue.matrix.default.group[0])
    for variable in _variables(catalogue.matrix):
        yield _variable(*variable)
    yield _FUNCTIONS


def _variables(matrix: Matrix) -> Iterator[tuple[str, str, str]]:
    """Name, default and description of every variable."""
    yield "REGISTRY", matrix.registry, "where images live, without https://"
    for os, system in matrix.operating_systems.items():
        yield names.os_variable(os), f"docker-image://{system.image}@{system.digest}", f"base image of {os}"
    yield "PLATFORM", "", "build for this platform only, such as linux/amd64; if empty, for all that a target has"
    yield "SOURCE_DATE_EPOCH", EPOCH, "time of every file, in seconds since 1970"
    yield "REVISION", "", "commit that is built, for a label"
    yield "DIGESTS", "", 'JSON text: dependencies to take from the registry, {"torch-cu128-py311": "sha256:…"}'
    yield "ROS_SYNC_DATES", "", 'JSON text: the dates of ROS\'s repositories, {"jazzy": "2026-11-20T21:14:09Z"}'
    yield "ROS_CHANNEL", "", "live, snapshot or final, in the place of what matrix.yaml says (make image CHANNEL=final)"
    yield "ROS_SNAPSHOT", "", "day of the snapshot where ROS_CHANNEL is snapshot: YYYY-MM-DD"
    yield "CA_BUNDLE", "", "file with certificates that build steps trust; never part of a layer"
    mirror = "mirror of the hosts that ros_archive names, such as http://host:3142; never part of an image"
    yield "ROS_APT_MIRROR", "", mirror
    archive = "mirror of the hosts that base images' apt sources name, such as http://host:3142; never part of an image"
    yield "OS_APT_MIRROR", "", archive
    for proxy in PROXIES:
        yield proxy, "", "for build steps; never part of an image"


def _variable(name: str, default: str, description: str) -> str:
    return f"# {description}\nvariable {text(name)} {{\n  default = {text(default)}\n}}\n"


def _groups(catalogue: Catalogue) -> Iterator[str]:
    for name, targets in catalogue.groups.items():
        yield block("group", name, {"targets": targets})


def _abstract(catalogue: Catalogue) -> Iterator[Target]:
    proxies = {proxy: _no_input("given", Expression(proxy)) for proxy in PROXIES}
    # Mirrors are secrets like the certificates: an argument would be in the image's history.
    secret = Expression(
        'concat(CA_BUNDLE == "" ? [] : ["id=ca-bundle,src=${CA_BUNDLE}"], '
        'ROS_APT_MIRROR == "" ? [] : ["id=ros-apt-mirror,env=ROS_APT_MIRROR"], '
        'OS_APT_MIRROR == "" ? [] : ["id=os-apt-mirror,env=OS_APT_MIRROR"])'
    )
    epoch = {"SOURCE_DATE_EPOCH": Expression("SOURCE_DATE_EPOCH")}
    yield "_common", {"context": ".", "secret": secret, "args": epoch | proxies}
    yield "_base", {"inherits": ["_common"], "target": "base"}
    yield "_payload", {"inherits": ["_common"]}
    common: Labels = {
        "org.opencontainers.image.licenses": "Apache-2.0",
        **({"org.opencontainers.image.source": catalogue.matrix.source} if catalogue.matrix.source else {}),
        "org.opencontainers.image.revision": _no_input("given", Expression("REVISION")),
        "org.opencontainers.image.created": _no_input(
            "timeadd", "1970-01-01T00:00:00Z", template("${SOURCE_DATE_EPOCH}s")
        ),
    }
    yield "_image", {"inherits": ["_common"], "labels": common}
    assembler = Expression(names.os_variable(catalogue.matrix.default.assembler))
    test = {"inherits": ["_common"], "target": "test", "contexts": {"os": assembler}, "output": ["type=cacheonly"]}
    yield "_test", test
    listing = {"inherits": ["_common"], "target": "file-list", "contexts": {"os": assembler}}
    yield "file-list", {"description": "the files of the image that its context `listed` is", **listing}


def _operating_systems(catalogue: Catalogue) -> Iterator[Target]:
    matrix = catalogue.matrix
    for os in dict.fromkeys(image.os for image in catalogue.images):
        system = matrix.operating_systems[os]
        attributes = {
            "inherits": ["_base"],
            "platforms": _platforms(matrix.architectures[name].platform for name in system.architectures),
            "contexts": {"os": Expression(names.os_variable(os))},
            "args": {"NUMPY": system.numpy},
        }
        yield names.os_target(os), attributes


def _ros_images(catalogue: Catalogue) -> Iterator[Target]:
    matrix = catalogue.matrix
    images: dict[str, list[Image]] = {name: [] for name in matrix.distributions}
    for image in catalogue.images:
        if image.stack is None:
            images[image.distribution].append(image)
    for name, distribution in matrix.distributions.items():
        yield _distribution_target(name), _distribution(matrix, name, distribution)
        yield _ros_target(name), _ros(matrix, name, distribution)
        for image in images[name]:
            yield image.target, _ros_image(catalogue, image)


def _distribution_target(name: str) -> str:
    return f"_distribution-{name}"


def _ros_target(name: str) -> str:
    return f"_ros-{name}"


def _distribution(matrix: Matrix, name: str, distribution: Distribution) -> dict[str, object]:
    """What all images of a distribution have in common."""
    system = matrix.operating_systems[distribution.os]
    variable = Expression(names.os_variable(distribution.os))
    common: Labels = {
        "org.opencontainers.image.base.name": _no_input("image_name", variable),
        "org.opencontainers.image.base.digest": _no_input("image_digest", variable),
        "io.rosml.distribution": name,
        "io.rosml.os": distribution.os,
        "io.rosml.python": system.python,
        "io.rosml.ros": str(distribution.ros),
        **({"io.rosml.ros.sync": _no_input("given", _sync_date(name))} if distribution.apt else {}),
        **({"io.rosml.experimental": "true"} if distribution.experimental else {}),
    }
    platforms = _platforms(matrix.architectures[item].platform for item in rules.built_for(matrix, name))
    return {"inherits": ["_image"], "platforms": platforms, "labels": common}


def _ros(matrix: Matrix, name: str, distribution: Distribution) -> dict[str, object]:
    """What a distribution's images without a framework have in common."""
    args: dict[str, str | Expression] = {
        "ROS_DISTRO": distribution.ros_distro or name,
        "ROS_VERSION": str(distribution.ros),
    }
    if distribution.apt:
        args |= _apt(matrix, name, distribution.apt)
        args["ROS_SYNC_DATE"] = _sync_date(name)
    wheels: dict[str, object] = {}
    if distribution.wheels:  # the stage takes uv from what assembles payloads, which stands on the system's base image
        args |= {"ROS_ROW": name, "PYTHON": matrix.operating_systems[distribution.os].python}
        wheels = {"contexts": {"os": Expression(names.os_variable(distribution.os))}}
    return {
        "inherits": [_distribution_target(name)],
        "target": "ros-wheels" if distribution.wheels else "ros",
        **wheels,
        "args": args,
        "labels": {"io.rosml.framework": rules.plain(matrix)},
    }


def _no_input(function: str, *arguments: str | Expression) -> NoInput:
    return NoInput(call(function, *arguments).code)


def _sync_date(distribution: str) -> NoInput:
    return _no_input("sync_date", distribution)


def _overridable(fact: str, variable: str) -> Overridable:
    return Overridable(call("overridable", fact, Expression(variable)).code, fact)


def _apt(matrix: Matrix, name: str, apt: Apt) -> dict[str, str | Expression]:
    """Arguments of a distribution whose packages come from ROS's own apt repository."""
    day = apt.date.isoformat() if apt.date else ""
    args: dict[str, str | Expression] = {
        "ROS_CHANNEL": _overridable(apt.channel, "ROS_CHANNEL"),
        "ROS_SNAPSHOT": _overridable(day, "ROS_SNAPSHOT"),
        "ROS_LIVE_ADDRESS": rules.ros_live(matrix, name),
        "ROS_SNAPSHOT_ADDRESS": rules.ros_snapshot(matrix, name, "{day}"),
        "ROS_CODENAME": matrix.operating_systems[matrix.distributions[name].os].codename or "",
    }
    if source := rules.ros_apt_source(matrix, name):
        args["ROS_APT_SOURCE"] = source
    return args


def _ros_image(catalogue: Catalogue, image: Image) -> dict[str, object]:
    matrix = catalogue.matrix
    args = {"ROS_PACKAGES": image.packages} if image.packages else {}
    parent = catalogue.by_target.get(image.parent)
    if parent is None:  # the lowest component brings the developers' tools
        tools = matrix.distributions[image.distribution].tools or matrix.operating_systems[image.os].tools
        args["ROS_TOOLS"] = " ".join([tools, *_rmw_packages(matrix, image)])
    return {
        "description": _unlocked(image),
        "inherits": [_ros_target(image.distribution)],
        "tags": _tags(image),
        "contexts": {"parent": _dependency(parent) if parent else f"target:{image.parent}"},
        "args": args,
        "labels": _labels(image),
    }


def _unlocked(image: Image) -> str:
    """What to say of a target that cannot be built yet; empty, and so left out, where it can be."""
    return "" if image.locked else f"cannot be built yet: no lock; {missing.remedy(image)}"


def _rmw_packages(matrix: Matrix, image: Image) -> Iterator[str]:
    for name in matrix.distributions[image.distribution].rmw:
        yield f"ros-{image.ros_distro}-{name.replace('_', '-')}"


def _dependency(image: Image) -> Dependency:
    return Dependency(call("image", image.repository, image.target).code, image.target)


def _part(payload: str) -> Dependency:
    return Dependency(call("part", payload).code, names.files_target(payload))


def _platforms(platforms: Iterable[str]) -> Expression:
    return Expression(f"platforms([{', '.join(text(platform) for platform in platforms)}])")


def _tags(image: Image) -> list[Expression]:
    return [template(f"${{REGISTRY}}/{tag}") for tag in image.tags]


def _labels(image: Image) -> Labels:
    return labels.named(
        image.distribution, image.component, str(image.ros), image.framework, image.stack, image.versions
    )


def _payloads(catalogue: Catalogue) -> Iterator[Target]:
    for payload in catalogue.payloads:
        yield names.files_target(payload.name), _files(catalogue.matrix, payload)
        published = {
            "inherits": [names.files_target(payload.name)],
            "target": "payload",
            "tags": [template(f"${{REGISTRY}}/payload:{payload.name}")],
            "labels": _payload_labels(catalogue.matrix, payload),
        }
        yield payload.target, published


def _payload_labels(matrix: Matrix, payload: Payload) -> Labels:
    stack = matrix.stacks[payload.stack]
    versions = {name: version for name in labels.VERSIONS if (version := getattr(stack, name))}
    taking = {name: parts for name, parts in rules.frameworks(matrix, payload.stack).items() if payload.part in parts}
    return labels.of_payload(payload.part, payload.stack, payload.python, versions, taking)


def _files(matrix: Matrix, payload: Payload) -> dict[str, object]:
    return {
        "inherits": ["_payload"],
        "target": "payload-files",
        "platforms": _platforms(payload.platforms),
        "contexts": {"os": Expression(names.os_variable(payload.os))},
        "args": {
            "PART": payload.part,
            "STACK": payload.stack,
            "PYTHON": payload.python,
            "WHEEL_PYTHON": matrix.operating_systems[payload.os].python,
            "ACCELERATOR": matrix.stacks[payload.stack].accelerator,
        },
    }


def _joined_images(catalogue: Catalogue) -> Iterator[Target]:
    matrix = catalogue.matrix
    seen: set[str] = set()
    for image in catalogue.images:
        if image.stack is None:
            continue
        common = names.joined_target(image.framework, image.stack, image.os)
        if common not in seen:
            seen.add(common)
            yield common, _join(matrix, image)
        ros = catalogue.by_target[image.parent]
        attributes = {
            "description": _unlocked(image),
            "inherits": [_distribution_target(image.distribution), common],
            **(
                {"platforms": _platforms(image.platforms)}
                if matrix.distributions[image.distribution].architectures
                else {}
            ),
            "tags": _tags(image),
            "contexts": {"ros": _dependency(ros)},
            "labels": _labels(image),
        }
        yield image.target, attributes


def _join(matrix: Matrix, image: Image) -> dict[str, object]:
    """What images of one framework, stack and operating system have in common, whatever their component."""
    framework, stack = matrix.frameworks[image.framework], matrix.stacks[image.stack or ""]
    parts = dict(zip(rules.parts(framework, stack), image.parts, strict=True))
    everywhere = rules.joined_for(matrix, image.os, image.framework, image.stack)
    args: dict[str, str | Expression] = {"ACCELERATOR": stack.accelerator}
    args |= {
        f"{part.upper().replace('-', '_')}_ROOT": _no_input("root", parts[part]) for part in PARTS if part in parts
    }
    args |= {f"{name.upper()}_VERSION": version for name, version in image.versions.items() if name != "nccl"}
    return {
        "target": image.framework,
        "platforms": _platforms(matrix.architectures[name].platform for name in everywhere),
        "contexts": {f"part-{part}": _part(name) for part, name in parts.items()},
        "args": args,
        "labels": {
            "io.rosml.framework": image.framework,
            "io.rosml.stack": image.stack or "",
            **{f"io.rosml.{name}": version for name, version in image.versions.items() if name != "nccl"},
        },
    }


def _tests(catalogue: Catalogue) -> Iterator[Target]:
    for image in catalogue.images:
        attributes = {
            "inherits": ["_test"],
            "platforms": _platforms(image.platforms),
            "contexts": {"image": _dependency(image)},
            "args": {
                "TESTS": " ".join(image.tests),
                "EXPECT": " ".join(f"{k}={v}" for k, v in expected(catalogue, image).items()),
            },
        }
        yield image.test_target, attributes


def expected(catalogue: Catalogue, image: Image) -> dict[str, str]:
    """What tags and labels promise, for the tests in the image, which see `torch` as $EXPECT_TORCH."""
    packages: dict[str, str] = {}
    distribution = catalogue.matrix.distributions[image.distribution]
    ros: Image | None = image
    while ros:
        if ros.packages:
            packages[f"packages_{ros.component.replace('-', '_')}"] = ros.packages.replace(" ", ",")
        ros = catalogue.by_target.get(ros.parent)
    return {
        "os": image.os,
        "python": image.python,
        "ros": str(image.ros),
        "ros_distro": image.ros_distro,
        **({"rmw": ",".join(distribution.rmw)} if distribution.rmw else {}),
        **(
            {"wheels": ",".join(re.sub(r"\[.*\]", "", item) for item in distribution.wheels)}
            if distribution.wheels
            else {}
        ),
        **dict(reversed(packages.items())),
        **image.versions,
    }
