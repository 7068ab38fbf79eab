"""An image set -> the text of docker-bake.hcl: every target, written out, and what it inherits.

`targets` decides the content of targets. Here they become text. Fields that several targets share become an abstract target, which
they inherit.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from dataclasses import replace
from functools import cache
from itertools import groupby

from rosml.images.bake import targets
from rosml.images.bake.hcl import Code, aligned, block, literal, text
from rosml.images.bake.targets import Context, Dependency, Locks, Overridable, Target, Value
from rosml.images.image_set.model import Image, ImageSet
from rosml.images.matrix import names
from rosml.images.matrix.model import Matrix

NAME, TESTS = "docker-bake.hcl", "docker-bake.tests.hcl"


def render(image_set: ImageSet, all_targets: Mapping[str, Target] | None = None) -> dict[str, str]:
    """Both files by name. Structure tests have their own, because buildx's time for a file grows with the square of its targets."""
    every = _Blocks(image_set, all_targets)
    images, tests = every.needed(every.others), every.needed(every.tests)
    head = _HEADER_OF_TESTS.format(target=image_set.matrix.default.group[0])
    return {
        NAME: "\n".join([*_head(image_set.matrix), *every.blocks(images), *_groups(image_set, False)]),
        TESTS: "\n".join([head, *every.blocks(tests - images), *_groups(image_set, True)]),
    }


def excerpt(image_set: ImageSet, roots: Iterable[str]) -> str:
    """The part of both files that some targets need. It looks at no other image, because a run needs hundreds of excerpts."""
    chosen = {targets.CONTENTS, *roots}
    images, parts = set[str](), {part.name for part in image_set.parts if part.target in chosen}
    for root in chosen:
        image = image_set.by_target.get(root) or image_set.by_target.get(root.removesuffix(names.test_target("")))
        while image:
            images.add(image.target)
            parts.update(image.parts)
            image = image_set.by_target.get(image.parent)
    some = replace(
        image_set,
        images=tuple(image for image in image_set.images if image.target in images),
        parts=tuple(part for part in image_set.parts if part.name in parts),
    )
    blocks = _Blocks(some)
    return "\n".join([*_head(image_set.matrix), *blocks.blocks(blocks.needed(chosen, built=True))])


def variables(matrix: Matrix) -> dict[str, str]:
    return {name: default for name, default, _ in _variables(matrix)}


_HEADER = """\
# Generated from matrix.yaml: change that, then run
#   rosml generate
#
#   PLATFORM=linux/amd64 docker buildx bake {target}   builds an image, and what it stands on, for one platform
#   docker buildx bake --print <target>                     shows what would be built
#   docker buildx bake --list targets                       lists all targets, --list variables what can be set
"""

_HEADER_OF_TESTS = """\
# Generated from matrix.yaml: change that, then run
#   rosml generate
#
#   docker buildx bake -f docker-bake.hcl -f docker-bake.tests.hcl {target}-test   runs an image's structure tests inside the build
"""

_FUNCTIONS = """\
# What the caller says in JSON. An empty text says nothing.
digests    = { for name, digest in jsondecode(DIGESTS == "" ? "{}" : DIGESTS) : name => digest if digest != "" }
sync_dates = { for name, date in jsondecode(ROS_SYNC_DATES == "" ? "{}" : ROS_SYNC_DATES) : name => date if date != "" }

# A dependency: built here, unless DIGESTS names it. The only place that decides.
function "dependency" {
  params = [name, repository, target]
  result = try("docker-image://${REGISTRY}/${repository}@${digests[name]}", "target:${target}")
}
"""


def _head(matrix: Matrix) -> Iterator[str]:
    yield _HEADER.format(target=matrix.default.group[0])
    for variable, default, description in _variables(matrix):
        yield block("variable", variable, {"description": description, "default": default})
    yield _FUNCTIONS


def _variables(matrix: Matrix) -> Iterator[tuple[str, str, str]]:
    """Name, default and description of every variable."""
    yield "REGISTRY", matrix.registry, "where images live, without https://"
    for os in matrix.operating_systems:
        yield names.os_variable(os), targets.base_image(matrix, os), f"base image of {os}"
    yield "DOCKER_HUB", "docker.io/", "what base images begin with that stand for Docker Hub's, for a label"
    yield "PLATFORM", "", "build for this platform only, such as linux/amd64; if empty, for all that a target has"
    yield "SOURCE_DATE_EPOCH", targets.EPOCH, "time of every file, in seconds since 1970"
    yield "REVISION", "", "commit that is built, for a label"
    yield "DIGESTS", "", 'JSON text: dependencies to take from the registry, {"torch-cu128-py311": "sha256:…"}'
    yield "ROS_SYNC_DATES", "", 'JSON text: the dates of ROS\'s repositories, {"jazzy": "2026-11-20T21:14:09Z"}'
    channels = "live, testing, snapshot or final, instead of matrix.yaml's channel (ROS_CHANNEL=final rosml image)"
    yield "ROS_CHANNEL", "", channels
    yield "ROS_SNAPSHOT", "", "day of the snapshot if ROS_CHANNEL is snapshot: YYYY-MM-DD"
    yield "CA_BUNDLE", "", "file with certificates that build steps trust; never part of a layer"
    mirror = "mirror of the hosts that ros_archive names, such as http://host:3142; never part of an image"
    yield "ROS_APT_MIRROR", "", mirror
    archive = "mirror of the hosts that base images' apt sources name, such as http://host:3142; never part of an image"
    yield "OS_APT_MIRROR", "", archive
    steps = "host: build steps have the network of the builder's machine; needs --allow network.host, and a builder that does"
    yield "STEP_NETWORK", "", steps
    for proxy in targets.PROXIES:
        yield proxy, "", "for build steps; never part of an image"


# ---- Targets ---------------------------------------------------------------------------------------------------------

Fields = dict[tuple[str, str], str]
"""The fields of a target as HCL: by attribute, and by key if the attribute is a mapping."""

EVERY: Fields = {
    ("context", ""): '"."',
    ("network", ""): 'STEP_NETWORK == "" ? null : STEP_NETWORK',
    ("secret", ""): """concat(
    CA_BUNDLE == "" ? [] : ["id=ca-bundle,src=${CA_BUNDLE}"],
    ROS_APT_MIRROR == "" ? [] : ["id=ros-apt-mirror,env=ROS_APT_MIRROR"],
    OS_APT_MIRROR == "" ? [] : ["id=os-apt-mirror,env=OS_APT_MIRROR"]
  )""",
}
"""The fields of every target. Mirrors are secrets like the certificates: an argument would be in the image's history."""

ORDER = ("inherits", "description", "target", "platforms", "contexts", "args", "labels", "tags")
"""The first attributes, in the best order for readers; others follow."""


def _fields(target: Target) -> Fields:
    fields = {**EVERY}
    if target.description:
        fields["description", ""] = text(target.description)
    if target.stage:
        fields["target", ""] = text(target.stage)
    if target.platforms:
        fields["platforms", ""] = f'PLATFORM == "" ? {literal(target.platforms)} : [PLATFORM]'
    if target.tags:
        tags = (f'\n    "${{REGISTRY}}/{text(tag)[1:]}' for tag in target.tags)
        fields["tags", ""] = f"[{','.join(tags)}\n  ]"
    fields |= {("contexts", name): _context(value) for name, value in target.contexts.items()}
    fields |= {("args", name): _value(value, '""') for name, value in target.arguments.items()}
    fields |= {("labels", name): _value(value, "null") for name, value in target.labels.items()}
    if target.join:
        lines = "".join(f"    {line}\n" for line in target.join.dockerfile().splitlines())
        fields["dockerfile-inline", ""] = f"<<-EOT\n{lines}  EOT"
    if target.stage == "test":
        fields["output", ""] = '["type=cacheonly"]'
    return fields


def _context(context: Context) -> str:
    if isinstance(context, Overridable):
        return context.variable
    if isinstance(context, Locks):
        return text(context.folder)
    if not context.name:
        return text(f"target:{context.target}")
    return f"dependency({text(context.name)}, {text(context.repository)}, {text(context.target)})"


@cache
def _value(value: Value, unknown: str) -> str:
    """An argument or label. `unknown` is its value if it is a date that nobody has set."""
    if isinstance(value, str):
        return text(value)
    if isinstance(value, Overridable):
        if value.variable == "SOURCE_DATE_EPOCH" or not value.fact:  # the variable's default is the fact
            return value.variable
        return f'{value.variable} == "" ? {text(value.fact)} : {value.variable}'
    return {
        "variable": f'{value.of} == "" ? null : {value.of}',
        "sync date": f"try(sync_dates[{text(value.of)}], {unknown})",
        "root": f'can(digests[{text(value.of)}]) ? "/" : "/out/"',
        "base name": f'replace(trimprefix(split("@", {value.of})[0], "docker-image://"), DOCKER_HUB, "docker.io/")',
        "base digest": f'try(split("@", {value.of})[1], null)',
        "created": f'timeadd("1970-01-01T00:00:00Z", "${{{value.of}}}s")',
    }[value.what]


class _Blocks:
    """Targets as blocks of HCL. Fields that some of them share are in an abstract target, which these inherit."""

    def __init__(self, image_set: ImageSet, all_targets: Mapping[str, Target] | None = None) -> None:
        self._image_set, self._targets = image_set, all_targets or targets.of(image_set)
        self.tests = [image.test_target for image in image_set.images]
        self.others = self._targets.keys() - {*self.tests}
        self._fields = {name: _fields(target) for name, target in self._targets.items()}
        self._above: dict[str, list[str]] = {name: [] for name in self._targets}
        self._merged: dict[tuple[str, ...], Fields] = {}
        self._families()

    def _families(self) -> None:
        images, parts = self._image_set.images, self._image_set.parts
        self._family("_every", [], [*self._fields])
        of_stacks = self._image_set.parts_of_stacks
        self._family("_files", ["_every"], [names.files_target(part.name) for part in of_stacks])
        environments = [part for part in parts if part not in of_stacks]
        self._family("_environment", ["_every"], [names.files_target(part.name) for part in environments])
        for part in parts:
            self._above[part.target] = [names.files_target(part.name)]
        self._family("_image", ["_every"], [image.target for image in images])
        self._family("_test", ["_every"], self.tests)
        for row, members in _by(images, lambda image: image.distribution).items():
            self._family(f"_{row}", ["_image"], [image.target for image in members])
            self._family(f"_{row}-ros", [f"_{row}"], [image.target for image in members if not image.stack])
        for name, members in _by((image for image in images if image.stack), _joined).items():
            self._family(name, [], [image.target for image in members])

    def _family(self, name: str, above: list[str], members: list[str]) -> None:
        """Adds an abstract target with what its members share, and do not all inherit already. It inherits `above`, and they inherit it."""
        if not members:
            return
        common, inherited = (set(fields.items()) for fields in (self._fields[members[0]], self._inherited(members[0])))
        for member in members[1:]:
            common &= self._fields[member].items()
            inherited &= self._inherited(member).items()
        family_fields = common - inherited
        self._fields[name] = {
            place: code for place, code in self._fields[members[0]].items() if (place, code) in family_fields
        }
        self._above[name] = above
        for member in members:
            self._above[member] = [*(other for other in self._above[member] if other not in above), name]

    def needed(self, roots: Iterable[str], built: bool = False) -> set[str]:
        """Some targets, those that they inherit, and, if `built`, those that they are built on."""
        needed, waiting = set[str](), [root for root in roots if root in self._targets]
        while waiting:
            if (name := waiting.pop()) not in needed:
                needed.add(name)
                waiting += self._above[name]
                contexts = self._targets[name].contexts.values() if built and name in self._targets else ()
                waiting += [context.target for context in contexts if isinstance(context, Dependency)]
        return needed

    def blocks(self, names: Collection[str]) -> Iterator[str]:
        """Some of the targets, in the order of the whole file."""
        for title, members in self._sections():
            if section := [name for name in members if name in names]:
                yield f"# ---- {title} ".ljust(119, "-") + "\n"
                yield from (self._block(name) for name in section)

    def _sections(self) -> Iterator[tuple[str, list[str]]]:
        images = self._image_set.images
        systems = [names.os_target(image.os, runs) for image in images for runs in (False, True)]
        everything = ["_every", targets.CONTENTS, targets.ENVIRONMENT, *dict.fromkeys(systems), "_image", "_test"]
        yield "What others inherit, and operating systems", [name for name in everything if name in self._fields]
        both = [[names.files_target(part.name), part.target] for part in self._image_set.parts]
        yield (
            "Parts: the files below /out, and the part as an image of its own",
            ["_files", "_environment", *(name for pair in both for name in pair)],
        )
        joined = [_joined(image) for image in images if image.stack]
        yield "What images with the same framework, stack and Python have in common", [*dict.fromkeys(joined)]
        for row, members in _by(images, lambda image: image.distribution).items():
            image_targets = [name for image in members for name in (image.target, image.test_target)]
            yield row, [f"_{row}", f"_{row}-ros", *image_targets]

    def _inherited(self, name: str) -> Fields:
        above = tuple(self._above[name])
        if above not in self._merged:
            fields: Fields = {}
            for other in above:
                fields |= self._inherited(other) | self._fields[other]
            self._merged[above] = fields
        return self._merged[above]

    def _block(self, name: str) -> str:
        """A target with the fields that it does not inherit."""
        inherited = self._inherited(name)
        attributes: dict[str, str | dict[str, Code]] = {}
        if above := self._above[name]:
            attributes["inherits"] = literal(above)
        for (attribute, item), code in self._fields[name].items():
            if inherited.get((attribute, item)) == code:
                continue
            if item:
                mapping = attributes.setdefault(attribute, {})
                assert isinstance(mapping, dict)
                mapping[item] = Code(code)
            else:
                attributes[attribute] = code
        return "\n".join([f"target {text(name)} {{", *_lines(attributes), "}"]) + "\n"


def _lines(attributes: Mapping[str, str | dict[str, Code]]) -> Iterator[str]:
    """Attributes as `hclfmt` writes them: it aligns the values of neighbours with one line each."""
    single: dict[str, object] = {}
    for name in sorted(attributes, key=lambda name: ORDER.index(name) if name in ORDER else len(ORDER)):
        value = attributes[name]
        if isinstance(value, str) or len(value) == 1:
            single[name] = Code(value) if isinstance(value, str) else value
            continue
        yield from (f"  {line}" for line in aligned(single))
        single = {}
        yield from (f"  {name} = {{", *(f"    {line}" for line in aligned(value)), "  }")
    yield from (f"  {line}" for line in aligned(single))


def _joined(image: Image) -> str:
    """The abstract target of images with the same framework, add-ons, stack and Python."""
    what = "-".join([image.framework, *image.addons])
    end = names.environments_end([image.environment])
    return f"_{what}-{image.stack}-py{image.python.replace('.', '')}{end}"


def _by(images: Iterable[Image], of: Callable[[Image], str]) -> dict[str, list[Image]]:
    groups: dict[str, list[Image]] = {}
    for image in images:
        groups.setdefault(of(image), []).append(image)
    return groups


# ---- Groups ----------------------------------------------------------------------------------------------------------


def _groups(image_set: ImageSet, tests: bool) -> Iterator[str]:
    """The groups. Each distribution's targets are on one line, so a new distribution adds a line."""
    rows = {image.target: image.distribution for image in image_set.images}
    rows |= {image.test_target: image.distribution for image in image_set.images}
    yield "# ---- Groups ".ljust(119, "-") + "\n"
    for name, members in image_set.groups.items():
        if (name == "tests") is tests:
            lines = "".join(f"    {', '.join(map(text, line))},\n" for _, line in groupby(members, rows.get))
            yield f"group {text(name)} {{\n  targets = [\n{lines}  ]\n}}\n"
