"""Whether every name that matrix.yaml uses exists in it, and whether its facts agree with each other."""

from __future__ import annotations

import string
from collections.abc import Iterable, Iterator

from rosml.base.problems import Path, listed, near, unknown
from rosml.matrix import names
from rosml.matrix.model import Distribution, Matrix, OperatingSystem, Release
from rosml.matrix.rules import NVIDIA

Finding = tuple[Path, str]
"""A problem's path and its text."""

MAX_COMBINATIONS = 50_000
"""More combinations than that are a mistake: they would take seconds, and hundreds of megabytes. The full matrix has
about 1,500; 10,000 images like its own are 30,000 combinations."""

MAX_CHAIN = 32
"""More components on one another than that are a mistake: each is a layer, of which an image can have 127."""

MAX_ARCHITECTURES = 16
"""More than that are a mistake: every image and part lists its own."""

PLACEHOLDERS = ("component", "metapackage", "ros_distro")


def findings(matrix: Matrix) -> Iterator[Finding]:
    """Every problem that needs more than one place of the file to be seen."""
    for check in (
        _duplicates,
        _axes,
        _default,
        _architectures,
        _operating_systems,
        _archives,
        _same_python,
        _components,
        _parts,
        _frameworks,
        _releases,
        _stacks,
        _distributions,
        _disk,
        _size,
    ):
        yield from check(matrix)


def _each(path: Path, kind: str, used: Iterable[str], known: Iterable[str]) -> Iterator[Finding]:
    """Names of a list that must exist."""
    known = dict.fromkeys(known)
    for index, name in enumerate(used):
        if name not in known:
            yield (*path, index), unknown(kind, name, known)


def _default(matrix: Matrix) -> Iterator[Finding]:
    """The assembler exists; images of `default` are looked for among all that the matrix allows."""
    assembler = matrix.default.assembler
    if assembler not in matrix.operating_systems:
        yield ("default", "assembler"), unknown("operating system", assembler, matrix.operating_systems)


def _duplicates(matrix: Matrix) -> Iterator[Finding]:
    lists: list[tuple[Path, tuple[str, ...]]] = [(("default", "group"), matrix.default.group)]
    for name, os in matrix.operating_systems.items():
        lists.append((("operating_systems", name, "architectures"), os.architectures))
    for name, framework in matrix.frameworks.items():
        for key in ("parts", "accelerators", "tests"):
            lists.append((("frameworks", name, key), getattr(framework, key)))
    for family, releases in matrix.releases.items():
        for version, release in releases.items():
            here: Path = ("releases", family, version)
            lists.append(((*here, "python"), release.python))
            lists += [((*here, "wheels", stack), wheels) for stack, wheels in release.wheels.items()]
            lists.append(((*here, "requires"), release.requires))
    for name, distribution in matrix.distributions.items():
        for key in ("components", "wheels", "architectures", "rmw"):
            lists.append((("distributions", name, key), getattr(distribution, key)))
    for path, values in lists:
        seen: set[str] = set()
        for index, value in enumerate(values):
            if value in seen:
                yield (*path, index), f"{value!r} is there twice; keep one"
            seen.add(value)


def _axes(matrix: Matrix) -> Iterator[Finding]:
    """Every value of an axis is a group of the bake file, so no two may share a name."""
    taken = dict.fromkeys(names.RESERVED_GROUPS, "a group of its own")
    for axis in ("distributions", "components", "frameworks", "stacks"):
        for name in getattr(matrix, axis):
            if name in taken:
                yield (
                    (axis, name),
                    f"the name {name!r} is taken ({taken[name]}); both would be the same group of targets",
                )
            else:
                taken[name] = f"by {axis}.{name}"
    slugs: dict[str, str] = {}
    for name in matrix.operating_systems:
        other = slugs.setdefault(names.os_slug(name), name)
        if other != name:
            yield ("operating_systems", name), f"{name!r} and {other!r} would have the same target; rename one"


def _architectures(matrix: Matrix) -> Iterator[Finding]:
    """BuildKit tells a build step its architecture as the second word of the platform; locks are found by that name."""
    for name, architecture in matrix.architectures.items():
        told = architecture.platform.split("/")[1]
        if told != name:
            yield (
                ("architectures", name, "platform"),
                f"BuildKit calls the architecture of {architecture.platform} {told!r}, and locks are found by that name;"
                f" rename {name!r} to it, or correct the platform",
            )


def _operating_systems(matrix: Matrix) -> Iterator[Finding]:
    for name, os in matrix.operating_systems.items():
        path: Path = ("operating_systems", name)
        yield from _each((*path, "architectures"), "architecture", os.architectures, matrix.architectures)
        yield from _placeholders((*path, "tools"), os.tools, ())
        if os.archive and os.archive not in matrix.archives:
            yield (*path, "archive"), unknown("archive", os.archive, matrix.archives)
        if (os.archive is None) != (os.suite is None):
            yield path, "'archive' and 'suite' go together; add the other one"


def _archives(matrix: Matrix) -> Iterator[Finding]:
    for name, hosts in matrix.archives.items():
        for host, folders in hosts.items():
            for index, folder in enumerate(folders):
                yield from _placeholders(("archives", name, host, index), folder, ("suite",))
    if ros := matrix.ros_archive:
        yield from _placeholders(("ros_archive", "live"), ros.live, ("generation",))
        yield from _placeholders(("ros_archive", "snapshot"), ros.snapshot, ("ros_distro", "day"))
        yield from _placeholders(("ros_archive", "apt_source"), ros.apt_source, ("generation", "version", "codename"))


def _same_python(matrix: Matrix) -> Iterator[Finding]:
    """Parts are shared by all systems with a Python version, so these must agree on what parts depend on."""
    first: dict[str, str] = {}
    for name, os in matrix.operating_systems.items():
        other = first.setdefault(os.python, name)
        for key in ("numpy", "provides"):
            if getattr(matrix.operating_systems[other], key) != getattr(os, key):
                yield (
                    ("operating_systems", name, key),
                    f"{name} and {other} have Python {os.python} and so the same parts, but another '{key}'; they must agree",
                )


def _components(matrix: Matrix) -> Iterator[Finding]:
    settled: set[str] = set()
    cycles = False
    for name, component in matrix.components.items():
        if component.builds_on and component.builds_on not in matrix.components:
            yield ("components", name, "builds_on"), unknown("component", component.builds_on, matrix.components)
        chain: dict[str, None] = {}  # a set that keeps its order
        below: str | None = name
        while below in matrix.components and below not in chain and below not in settled:
            chain[below] = None
            below = matrix.components[below].builds_on
        settled.update(chain)
        if below in chain:
            cycle = list(chain)[list(chain).index(below) :]
            way = " -> ".join([*cycle, below] if len(cycle) <= 8 else [below, "…", below])
            yield ("components", below, "builds_on"), f"a cycle: {way}; one of them must build on nothing"
            cycles = True
    for name in () if cycles else matrix.components:
        if _chain_length(matrix, name) > MAX_CHAIN:
            text = f"more than {MAX_CHAIN} components on one another, with what it builds on; remove some"
            yield ("components", name, "builds_on"), text
            return


def _chain_length(matrix: Matrix, name: str) -> int:
    """How many components stand on one another below one, with itself; counted no further than is allowed."""
    length, link = 0, matrix.components.get(name)
    while link and length <= MAX_CHAIN:
        length, link = length + 1, matrix.components.get(link.builds_on or "")
    return length


def _frameworks(matrix: Matrix) -> Iterator[Finding]:
    repositories: dict[str, str] = {"part": "the parts"}
    plain = 0
    for name, framework in matrix.frameworks.items():
        path: Path = ("frameworks", name)
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
        found = f"{plain} have" if plain else "none has"
        yield ("frameworks",), f"exactly one framework has no parts: the ROS images that all others stand on; {found}"


def _parts(matrix: Matrix) -> Iterator[Finding]:
    """Parts have names of their own, and those that are releases of something have one of its name among them."""
    seen: set[str] = set()
    shared = [part.name for part in matrix.parts if part.shared]
    for index, part in enumerate(matrix.parts):
        path: Path = ("parts", index)
        if part.name in seen:
            yield (*path, "name"), f"{part.name!r} is there twice; keep one"
        seen.add(part.name)
        yield from _each((*path, "needs"), "part", part.needs, matrix.part)
        if part.release and part.release not in matrix.releases:
            yield (*path, "release"), unknown("release", part.release, matrix.releases)
        elif part.release and part.release not in matrix.part:
            yield (*path, "release"), f"a part of the name {part.release} holds what only it needs; add one to 'parts'"
        if part.repeats and part.release in (None, part.name):
            yield (*path, "repeats"), "it belongs to a part beside the one of its release's name; remove it"
        if part.shared and part.name != shared[0]:
            yield (*path, "shared"), f"{shared[0]} holds what several releases need; remove it"
    if matrix.families and not shared:
        yield ("parts",), "no part holds what several releases need; say 'shared: true' of one"


def _releases(matrix: Matrix) -> Iterator[Finding]:
    for family, releases in matrix.releases.items():
        if family not in matrix.families:
            yield (
                ("releases", family),
                f"no part is a release of it; add one to 'parts': {{name: {family}, release: {family}}}",
            )
        for version, release in releases.items():
            for stack, architectures in release.wheels.items():
                path: Path = ("releases", family, version, "wheels", stack)
                if stack not in matrix.stacks:
                    yield path, unknown("stack", stack, matrix.stacks)
                yield from _each(path, "architecture", architectures, matrix.architectures)
            yield from _elsewhere(matrix, ("releases", family, version), release)


def _elsewhere(matrix: Matrix, path: Path, release: Release) -> Iterator[Finding]:
    """Wheels on PyTorch's own index: only there, only for the CPU, and their requirements are known."""
    if bool(release.elsewhere) != bool(release.requires):
        yield (*path, "requires"), "'requires' belongs to 'elsewhere': the requirements of just those wheels"
    for stack, wheels in release.elsewhere.items():
        here: Path = (*path, "elsewhere", stack)
        if stack not in matrix.stacks:
            yield here, unknown("stack", stack, matrix.stacks)
        elif matrix.stacks[stack].accelerator != "cpu":
            yield here, f"stack {stack} is not one of the CPU; wheels with CUDA are on the Python package index"
        for architecture, digests in wheels.items():
            if architecture not in matrix.architectures:
                yield (*here, architecture), unknown("architecture", architecture, matrix.architectures)
            if architecture in release.wheels.get(stack, ()):
                yield (*here, architecture), f"'wheels' names {architecture} for stack {stack} already; keep one"
            for python in digests:
                if python not in release.python:
                    yield (*here, architecture, python), unknown("Python of this release", python, release.python)


def _stacks(matrix: Matrix) -> Iterator[Finding]:
    for name, stack in matrix.stacks.items():
        path: Path = ("stacks", name)
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
        for key in NVIDIA:
            if stack.accelerator != "cuda" and getattr(stack, key) is not None:
                yield (*path, key), f"a stack with accelerator {stack.accelerator} has no {key}; remove it"


def _released(matrix: Matrix, name: str, family: str) -> Iterator[Finding]:
    """A stack's release exists, and has a package for each architecture with wheels."""
    path: Path = ("stacks", name)
    stack, releases = matrix.stacks[name], matrix.releases.get(family)
    version = stack.releases[family]
    if releases is None:
        yield (*path, "releases", family), unknown("release", family, matrix.releases)
        return
    if version not in releases:
        yield (*path, "releases", family), unknown(f"release of {family}", version, releases)
    package = stack.packages.get(family)
    for architecture in package if isinstance(package, dict) else ():
        if architecture not in matrix.architectures:
            problem = unknown("architecture", architecture, matrix.architectures)
            yield (*path, "packages", family, architecture), problem
    wheels = releases[version].architectures(name) if version in releases else ()
    named = package if isinstance(package, dict) else dict.fromkeys(wheels)
    for architecture in wheels:
        if architecture not in named and architecture in matrix.architectures:
            text = f"{family} {version} has a wheel for {architecture}; name its package"
            yield (*path, "packages", family), text


def _distributions(matrix: Matrix) -> Iterator[Finding]:
    for name, distribution in matrix.distributions.items():
        path: Path = ("distributions", name)
        if distribution.os not in matrix.operating_systems:
            yield (*path, "os"), unknown("operating system", distribution.os, matrix.operating_systems)
        yield from _each((*path, "components"), "component", distribution.components, matrix.components)
        if distribution.default_stack not in matrix.stacks:
            yield (*path, "default_stack"), unknown("stack", distribution.default_stack, matrix.stacks)
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
            text = "nothing says where ROS's apt repositories are; add 'ros_archive: {live: …, snapshot: …, apt_source: …}'"
            yield (*path, "apt"), text
        if distribution.rmw and distribution.ros == 1:
            yield (*path, "rmw"), "ROS 1 has no RMW implementations; they are ROS 2's"
        if distribution.os in matrix.operating_systems:
            os = matrix.operating_systems[distribution.os]
            yield from _apt((*path, "apt"), distribution, os) if distribution.apt else _no_apt(path, distribution, os)


def _row_architectures(matrix: Matrix, path: Path, distribution: Distribution) -> Iterator[Finding]:
    """A distribution may exist for fewer architectures than its operating system, and for no other."""
    yield from _each(path, "architecture", distribution.architectures, matrix.architectures)
    os = matrix.operating_systems.get(distribution.os)
    for index, name in enumerate(distribution.architectures):
        if os and name in matrix.architectures and name not in os.architectures:
            yield (*path, index), f"{distribution.os} is built for {listed(os.architectures)} only; remove {name}"


def _wheels(path: Path, name: str, distribution: Distribution) -> Iterator[Finding]:
    """ROS comes from Debian packages or from wheels, which are one set for one component, and know no apt source."""
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
    for key in ("apt", "rmw"):
        if getattr(distribution, key):
            yield (*path, key), f"'{key}' is about Debian packages of ROS, and {name} has wheels; remove it"


def _no_apt(path: Path, distribution: Distribution, os: OperatingSystem) -> Iterator[Finding]:
    """A system with a suite in ROS's apt repositories does not have ROS's packages itself, as Debian has."""
    if os.codename and distribution.packages is not None and not distribution.wheels:
        yield (
            path,
            f"{distribution.os} does not have ROS's packages itself, and nothing says where they come from; "
            "add 'apt: {channel: live}', 'apt: {channel: snapshot, date: …}' or, past the end of life, "
            "'apt: {channel: final}'",
        )


def _apt(path: Path, distribution: Distribution, os: OperatingSystem) -> Iterator[Finding]:
    """ROS's apt repository has a suite for the operating system; the live one is set up by a pinned package."""
    if os.codename is None:
        yield path, f"ROS's apt repositories need the suite of {distribution.os}; add 'codename: …' to it"
    if distribution.apt and distribution.apt.channel == "live" and distribution.generation not in os.apt_sources:
        package, pin = f"{distribution.generation}-apt-source", "{version: …, digest: …}"
        remedy = f"add 'apt_sources: {{{distribution.generation}: {pin}}}' to it"
        yield path, f"the live channel needs a pinned {package} for {distribution.os}; {remedy}"


def _placeholders(path: Path, template: str, known: tuple[str, ...]) -> Iterator[Finding]:
    try:
        fields = [field for _, field, _, _ in string.Formatter().parse(template) if field is not None]
    except ValueError:
        yield path, f"unpaired braces in {template!r}; placeholders: {listed(known) or 'none'}"
        return
    if "{{" in template or "}}" in template:
        yield path, f"double braces in {template!r} are no placeholder; write them once"
    for word in template.split():
        if word.startswith("-") or word.endswith("-"):
            yield path, f"no package is called {word!r}: apt would take it for an option, or remove it"
    for field in fields:
        if field not in known:
            remedy = near(field, known) if known else "no placeholders are filled in here"
            yield path, f"no placeholder {{{field}}}; {remedy}"


def _disk(matrix: Matrix) -> Iterator[Finding]:
    for section, known in (("components", matrix.components), ("parts", matrix.stacks)):
        forecasts = getattr(matrix.disk, section)
        kind = "component" if section == "components" else "stack"
        for name in forecasts:
            if name not in known:
                yield ("disk", section, name), unknown(kind, name, known)
        for name in known:
            if name not in forecasts:
                yield (
                    ("disk", section),
                    f"no forecast for {kind} {name}; add {_forecast(matrix, kind, name)}, a guess will do",
                )
    for name, budgets in matrix.disk.budgets.items():
        if name not in matrix.stacks:
            yield ("disk", "budgets", name), unknown("stack", name, matrix.stacks)
        carrying = [framework for framework, facts in matrix.frameworks.items() if facts.parts]
        for framework in budgets:
            if framework not in carrying:
                yield ("disk", "budgets", name, framework), unknown("framework with parts", framework, carrying)
    yield from _disk_parts(matrix)


def _disk_parts(matrix: Matrix) -> Iterator[Finding]:
    """Each part of each stack has a forecast, and nothing else has."""
    for name, forecasts in matrix.disk.parts.items():
        for part in _forecast_parts(matrix, name) if name in matrix.stacks else ():
            if part not in forecasts:
                yield ("disk", "parts", name), f"no forecast for part {part}; add '{part}: {FORECAST}', a guess will do"
        for part in forecasts:
            if part not in matrix.part:
                yield ("disk", "parts", name, part), unknown("part", part, matrix.part)


FORECAST = "{unpacked: 900, compressed: 250}"
"""The form of a forecast, for remedies."""


def _forecast(matrix: Matrix, kind: str, name: str) -> str:
    """A forecast to fill in: of a stack, for each of its parts."""
    if kind == "component":
        return f"'{name}: {FORECAST}'"
    return f"'{name}: {{{', '.join(f'{part}: {FORECAST}' for part in _forecast_parts(matrix, name))}}}'"


def _forecast_parts(matrix: Matrix, name: str) -> list[str]:
    """The parts of a stack that some image has."""
    stack = matrix.stacks[name]
    used = {part for framework in matrix.frameworks.values() for part in framework.parts}
    return [
        part.name
        for part in matrix.parts
        if part.name in used
        and part.accelerator in (None, stack.accelerator)
        and (part.release is None or part.release in stack.releases)
    ]


def _size(matrix: Matrix) -> Iterator[Finding]:
    if len(matrix.architectures) > MAX_ARCHITECTURES:
        yield ("architectures",), f"{len(matrix.architectures)}, more than {MAX_ARCHITECTURES}; remove some"
    components = sum(len(distribution.components) for distribution in matrix.distributions.values())
    combinations = components * (1 + len(matrix.frameworks) * len(matrix.stacks))
    if combinations > MAX_COMBINATIONS:
        yield (), f"{combinations} combinations to look at, more than {MAX_COMBINATIONS}; remove rows"
