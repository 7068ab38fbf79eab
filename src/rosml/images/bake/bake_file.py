"""An image set -> the text of docker-bake.hcl: tables with the facts, and `graph.hcl`, which says what follows from them.

The graph is written by hand, the same for every image set. `targets` says what follows in Python.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import cache
from pathlib import Path

from rosml.images.bake import targets
from rosml.images.bake.hcl import Code, aligned, block, key, literal, pairs, text
from rosml.images.image_set import labels
from rosml.images.image_set.expand import FLOATING
from rosml.images.image_set.model import Image, ImageSet, Part
from rosml.images.matrix import names, rules
from rosml.images.matrix.model import Matrix, PartEntry

GRAPH = Path(__file__).with_name("graph.hcl")
"""What is made of the tables."""


def render(image_set: ImageSet) -> str:
    """The bake file. Depends on nothing but the image set."""
    return "\n".join([*_tables(image_set), _groups(image_set), _graph()])


def excerpt(image_set: ImageSet, roots: Iterable[str]) -> str:
    """The part of the bake file that some targets need: their rows, and what these are built on.

    buildx evaluates a whole file, which takes seconds for some hundred images.

    Args:
        roots: targets of images, of their tests, of parts; others are in every bake file.
    """
    images: set[str] = set()
    parts: set[str] = set()
    for root in roots:
        image = image_set.by_target.get(root) or image_set.by_target.get(root.removesuffix(names.test_target("")))
        while image:
            images.add(image.target)
            parts.update(image.parts)
            image = image_set.by_target.get(image.parent)
        parts.add(root.removeprefix(names.part_target("")))
    some = replace(
        image_set,
        images=tuple(image for image in image_set.images if image.target in images),
        parts=tuple(part for part in image_set.parts if part.name in parts),
    )
    return "\n".join([*_tables(some), _graph()])


def variables(matrix: Matrix) -> dict[str, str]:
    """The default of every variable by its name."""
    return {name: default for name, default, _ in _variables(matrix)}


@cache
def _graph() -> str:
    return GRAPH.read_text(encoding="utf-8")


_HEADER = """\
# Generated from matrix.yaml by scripts/generate_bake.py, with src/rosml/images/bake/graph.hcl below it: change one of them, then run
#   rosml generate
#
#   PLATFORM=linux/amd64 docker buildx bake {target}   builds an image, and what it stands on, for one platform
#   docker buildx bake {target}-test                   runs its structure tests inside the build
#   docker buildx bake --print <target>                     shows what would be built
#   docker buildx bake --list targets                       lists all targets, --list variables what can be set
"""


def _tables(image_set: ImageSet) -> Iterator[str]:
    matrix = image_set.matrix
    yield _HEADER.format(target=matrix.default.group[0])
    for variable, default, description in _variables(matrix):
        yield block("variable", variable, {"description": description, "default": default})
    yield "# ---- Tables ".ljust(119, "-") + "\n"
    yield _table(
        "systems", "Operating systems.", _tall({name: _system(matrix, name) for name in matrix.operating_systems})
    )
    about = "Each component with all that it is built on, the lowest first."
    yield _table("components", about, aligned({name: rules.chain(matrix, name) for name in matrix.components}))
    about = (
        "Versions that go together. frameworks: those that can have them, the smallest first. beside: what goes with each"
        " release, in its part. gpu: what parts say of drivers and GPUs."
    )
    yield _table("stacks", about, _tall({name: _stack(matrix, name) for name in matrix.stacks}))
    about = "What is built once and joined to many images. brings: whose versions labels and the environment name."
    yield _table("entries", about, _tall({part.name: _entry(matrix, part) for part in matrix.parts}))
    about = (
        "What images carry. spelled: whose versions a tag names. stacks: the platforms that all of it has wheels for."
    )
    yield _table("frameworks", about, _tall({name: _framework(matrix, name) for name in matrix.frameworks}))
    yield (
        "\n".join(["# What is taken where nothing is named, and how things are called.", *aligned(_words(matrix))])
        + "\n"
    )
    about = (
        "runtime: components on which programs run that are built on another one."
        " short: the stack of a framework's short tags. aliases: names that it had. lowest: its smallest component. carrying: what runs there what others share with it."
        " unlocked: what has no lock yet, and why."
    )
    yield _table("distributions", about, _tall(_distributions(image_set)))
    about = "What is assembled once, on a system, and joined to many images."
    yield _table("parts", about, (f"{literal(_part(part))}," for part in image_set.parts), "[]")


Lines = Sequence[Mapping[str, object]]
"""A row of a table, in lines."""


def _table(name: str, about: str, rows: Iterable[str], brackets: str = "{}") -> str:
    return "\n".join([f"# {about}", f"{name} = {brackets[0]}", *(f"  {row}" for row in rows), brackets[1]]) + "\n"


def _tall(rows: Mapping[str, Lines]) -> Iterator[str]:
    """Rows that take more than a line."""
    for name, lines in rows.items():
        yield "\n".join([f"{key(name)} = {{", *(f"    {', '.join(pairs(line))}" for line in lines), "  }"])


def _variables(matrix: Matrix) -> Iterator[tuple[str, str, str]]:
    """Name, default and description of every variable."""
    yield "REGISTRY", matrix.registry, "where images live, without https://"
    for os in matrix.operating_systems:
        yield names.os_variable(os), targets.base_image(matrix, os), f"base image of {os}"
    yield "PLATFORM", "", "build for this platform only, such as linux/amd64; if empty, for all that a target has"
    yield "SOURCE_DATE_EPOCH", targets.EPOCH, "time of every file, in seconds since 1970"
    yield "REVISION", "", "commit that is built, for a label"
    yield "DIGESTS", "", 'JSON text: dependencies to take from the registry, {"torch-cu128-py311": "sha256:…"}'
    yield "ROS_SYNC_DATES", "", 'JSON text: the dates of ROS\'s repositories, {"jazzy": "2026-11-20T21:14:09Z"}'
    yield (
        "ROS_CHANNEL",
        "",
        "live, testing, snapshot or final, in the place of what matrix.yaml says (ROS_CHANNEL=final rosml image)",
    )
    yield "ROS_SNAPSHOT", "", "day of the snapshot where ROS_CHANNEL is snapshot: YYYY-MM-DD"
    yield "CA_BUNDLE", "", "file with certificates that build steps trust; never part of a layer"
    mirror = "mirror of the hosts that ros_archive names, such as http://host:3142; never part of an image"
    yield "ROS_APT_MIRROR", "", mirror
    archive = "mirror of the hosts that base images' apt sources name, such as http://host:3142; never part of an image"
    yield "OS_APT_MIRROR", "", archive
    steps = "host: build steps have the network of the builder's machine; needs --allow network.host, and a builder that does"
    yield "STEP_NETWORK", "", steps
    for proxy in targets.PROXIES:
        yield proxy, "", "for build steps; never part of an image"


def _system(matrix: Matrix, name: str) -> Lines:
    facts = matrix.operating_systems[name]
    image, platforms = Code(names.os_variable(name)), _platforms(matrix, facts.architectures)
    return [
        {"image": image, "python": facts.python, "numpy": facts.numpy, "platforms": platforms},
        {"tools": facts.tools},
    ]


def _platforms(matrix: Matrix, architectures: Iterable[str]) -> list[str]:
    return [matrix.architectures[name].platform for name in architectures]


def _stack(matrix: Matrix, name: str) -> Lines:
    facts = matrix.stacks[name]
    taking = labels.smallest_first(rules.frameworks(matrix, name))
    return [
        {"accelerator": facts.accelerator, "frameworks": taking},
        {"versions": rules.versions(matrix, facts)},
        {"beside": {family: rules.company(matrix, name, [family]) for family in facts.releases}},
        {"gpu": {part: gpu for part in matrix.part if (gpu := _gpu(matrix, name, part))}},
    ]


def _gpu(matrix: Matrix, stack: str, part: str) -> dict[str, str]:
    """What a part says of GPUs; nothing where the stack does not have it."""
    release = matrix.part[part].release
    return {} if release and release not in matrix.stacks[stack].releases else rules.gpu(matrix, stack, [part])


def _framework(matrix: Matrix, name: str) -> Lines:
    facts = matrix.frameworks[name]
    releases = rules.families(matrix, facts)
    stacks = [stack for stack in matrix.stacks if facts.parts and name in rules.frameworks(matrix, stack)]
    parts = [part.name for part in matrix.parts if part.name in facts.parts]
    spelled = releases or [part.brings[0] for part in matrix.parts if part.name in parts and part.title]
    return [
        {"repository": facts.repository, "parts": parts},
        {"versions": rules.counted(matrix, facts), "spelled": spelled},
        {"stacks": {stack: _platforms(matrix, rules.joined_for(matrix, name, stack)) for stack in stacks}},
    ]


def _words(matrix: Matrix) -> dict[str, object]:
    """What is no row of a table."""
    return {
        "plain": rules.plain(matrix),
        "assembler": matrix.default.assembler,
        "source": matrix.source,
        "short_component": FLOATING,
        "releases": matrix.families,
        "runtimes": [name for name, facts in matrix.components.items() if facts.runtime_of],
    }


def _entry(matrix: Matrix, entry: PartEntry) -> Lines:
    brings = [{"name": item.name, "short": item.short, "title": item.title} for item in rules.brought_by(entry)]
    return [
        {"accelerator": entry.accelerator or "", "any_python": entry.any_python},
        {"tested": entry.tested, "compiled": entry.compiled},
        {"slot": f"{entry.slot:02}" if entry.slot else "", "shows": rules.shown(matrix, entry.name)},
        {"release": entry.release or "", "brings": brings},
    ]


def _distributions(image_set: ImageSet) -> dict[str, Lines]:
    """A row for each distribution that has images."""
    images: dict[str, list[Image]] = {}
    for image in image_set.images:
        images.setdefault(image.distribution, []).append(image)
    rows = image_set.matrix.distributions
    return {name: _distribution(image_set.matrix, name, images[name]) for name in rows if name in images}


def _distribution(matrix: Matrix, name: str, images: Sequence[Image]) -> Lines:
    facts = matrix.distributions[name]
    alone = [image for image in images if image.stack is None]
    kinds = {_key(image): image for image in images}
    carrying = [image for image in images if image.carriers[:1] == (image.target,)]
    platforms = _platforms(matrix, rules.architectures(matrix, name, rules.plain(matrix), None))
    short = [
        tag.split(":")[1]
        for image in alone
        if image.component == FLOATING
        for tag in image.tags[1 + len(facts.aliases) :]
    ]
    chosen = {framework: rules.default_stack(matrix, name, framework) for framework in matrix.frameworks}
    defaults = {framework: stack for framework, stack in chosen.items() if stack}
    stacks: dict[str, list[str]] = {}
    for image in kinds.values():
        if image.stack:
            stacks.setdefault(image.framework, []).append(image.stack)
    return [
        {"os": facts.os, "ros": str(facts.ros), "ros_distro": facts.ros_distro or name, "platforms": platforms},
        {"tags": short, "aliases": list(facts.aliases), "experimental": facts.experimental},
        {"short": defaults},
        {
            "rmw": ",".join(facts.rmw),
            "usual_rmw": facts.usual_rmw or "",
            "wheels": targets.wheels(facts.wheels),
            "tools": facts.tools or "",
        },
        {"packages": {image.component: image.packages for image in alone}},
        {
            "runtime": {
                image.component: found for image in alone if (found := rules.runtime(matrix, name, image.component))
            }
        },
        {"apt": targets.apt_arguments(matrix, name) or None},
        {"stacks": stacks},
        {"lowest": next((image.component for image in carrying), ""), "carrying": [_key(image) for image in carrying]},
        {"unlocked": {kind: targets.unlocked(image) for kind, image in kinds.items() if not image.locked}},
    ]


def _key(image: Image) -> str:
    """What tells images of a distribution and component apart: `torch-cu128`."""
    return f"{image.framework}-{image.stack}" if image.stack else image.framework


def _part(part: Part) -> dict[str, object]:
    return {
        "kind": part.kind,
        "stack": part.stack,
        "python": part.python,
        "os": part.os,
        "platforms": part.platforms,
    }


def _groups(image_set: ImageSet) -> str:
    """The groups of the axes, as far as they have a target: what those have in common, so that a new row adds a line."""
    present, found = image_set.groups, {}
    if "default" in present:
        found["default"] = literal(present["default"])
    for axis in ("distributions", "components", "frameworks", "stacks"):
        for name in getattr(image_set.matrix, axis):
            if name in present:
                found[name] = f"having({text(axis.removesuffix('s'))}, {text(name)})"
    return "".join(f"group {text(name)} {{ targets = {members} }}\n" for name, members in found.items())
