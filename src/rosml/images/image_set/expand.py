"""Makes every image and part that the facts of a matrix allow."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field, replace
from functools import cached_property

from rosml.images.image_set import labels
from rosml.images.image_set.model import Environment, Image, ImageSet, Part, Wheels
from rosml.images.matrix import combinations, names
from rosml.images.matrix.combinations import Brought
from rosml.images.matrix.model import ANY_PYTHON, Distribution, Framework, Matrix
from rosml.images.matrix.sizes import Size
from rosml.images.matrix.tags import full_tags, latest_distribution, short_tags


def expand(matrix: Matrix) -> ImageSet:
    """Every image and part of a checked matrix."""
    every_place = tuple(places(matrix))
    return with_images(matrix, every_place, parts_of(matrix, every_place))


def with_images(matrix: Matrix, images: Iterable[Place], parts: tuple[Part, ...]) -> ImageSet:
    """The image set with the images of some places."""
    return ImageSet(matrix, tuple(_image(matrix, place) for place in images), parts, tuple(_wheels(matrix)))


@dataclass(frozen=True)
class Kind:
    """The common facts of a distribution's images with one framework and stack. `covering`: the frameworks whose images have all these
    parts and more, those with the most first."""

    distribution: str
    framework: str
    facts: Framework
    stack: str | None
    architectures: tuple[str, ...]
    platforms: tuple[str, ...]
    parts: tuple[Part, ...] = ()
    versions: dict[str, str] = field(default_factory=dict)
    brought: tuple[Brought, ...] = ()
    covering: tuple[str, ...] = ()
    short: bool = True
    addon: str = ""
    environment: str = ""
    gpu: dict[str, str] = field(default_factory=dict)

    @property
    def addons(self) -> tuple[str, ...]:
        """The add-ons of its images."""
        return (self.addon,) if self.addon else ()

    def target(self, component: str, framework: str = "") -> str:
        """The target of such an image, or of one with another framework and the same stack."""
        target = names.image_target(self.distribution, component, framework or self.framework, self.stack, self.addons)
        return target + names.environments_end([self.environment])

    @cached_property
    def part_names(self) -> tuple[str, ...]:
        """The parts of its images."""
        return tuple(part.name for part in self.parts)

    @cached_property
    def locks(self) -> tuple[str, ...]:
        """The locks of its parts."""
        return tuple(lock for part in self.parts for lock in part.locks)


@dataclass(frozen=True)
class Place:
    """An image before its facts are worked out: its place on the axes and its names. It has no tags if it only tests its add-on."""

    kind: Kind
    component: str
    tags: tuple[str, ...]

    @cached_property
    def target(self) -> str:
        """The name of its bake target."""
        return self.kind.target(self.component)


def places(matrix: Matrix) -> Iterator[Place]:
    """The places of all images, in their order."""
    every = {place.target: place for place in _without_environments(matrix)}
    yield from every.values()
    for name, entry in matrix.environments.items():
        for place in (every[target] for target in entry.images if target in every):
            kind = _with_environment(matrix, name, place.kind)
            if kind and place.tags:
                end = names.environments_end([name])
                yield Place(kind, place.component, tuple(f"{tag}{end}" for tag in place.tags))


def _without_environments(matrix: Matrix) -> Iterator[Place]:
    latest = latest_distribution(matrix)
    for name, distribution in matrix.distributions.items():
        for framework, facts in matrix.frameworks.items():
            for stack in matrix.stacks if facts.parts else (None,):
                if combinations.stack_reason(matrix, name, framework, stack) is None:
                    kind = _kind(matrix, name, framework, stack)
                    for component in matrix.components:
                        if component in distribution.present:
                            yield Place(kind, component, _tags(matrix, kind, component, latest))
    for addon in matrix.addons:
        yield from _with_addon(matrix, addon, latest)


def _with_addon(matrix: Matrix, addon: str, latest: str | None) -> Iterator[Place]:
    """The images with an add-on: those that get tags, and those that test it. The latter have the lowest component of the distribution of
    each Python that is supported longest, and of those whose images get tags."""
    entry, bare = matrix.addons[addon], combinations.plain(matrix)
    tagged = entry.tags
    for stack in matrix.stacks:
        seen: set[tuple[str, str]] = set()
        for name, distribution in _lasting(matrix):
            python = matrix.operating_systems[distribution.os].python
            for framework in (bare, *entry.beside):
                if combinations.stack_reason(matrix, name, framework, stack, addon):
                    continue
                kind = _kind(matrix, name, framework, stack, addon)
                is_listed = tagged and framework == bare and name in tagged.distributions and stack in tagged.stacks
                with_tags = tagged.components if tagged and is_listed else ()
                tests = _lowest(matrix, name)[:1] if is_listed or (framework, python) not in seen else []
                seen.add((framework, python))
                for component in matrix.components:
                    if component in (*with_tags, *tests) and component in distribution.present:
                        tags = _tags(matrix, kind, component, latest) if component in with_tags else ()
                        yield Place(kind, component, tags)


@combinations.remembered
def _lasting(matrix: Matrix) -> list[tuple[str, Distribution]]:
    """The distributions, those that are supported longest first; the order of the matrix does not count."""

    def worth(item: tuple[str, Distribution]) -> tuple[bool, bool, str, str]:
        name, facts = item
        return not facts.experimental, facts.lts, str(facts.eol or ""), name

    return sorted(matrix.distributions.items(), key=worth, reverse=True)


@combinations.remembered
def _lowest(matrix: Matrix, name: str) -> list[str]:
    """The components of a distribution that stand on no other one and build programs; in all distributions but those without it,
    there is one."""
    present = matrix.distributions[name].present
    links = [link for link in matrix.components if link in present and not combinations.only_runs(matrix, link)]
    return [link for link in links if len(_chain(matrix, name, link)) == 1]


@combinations.remembered
def _kind(matrix: Matrix, name: str, framework: str, stack: str | None, addon: str = "") -> Kind:
    facts = matrix.carrying(framework, addon)
    architectures = combinations.architectures(matrix, name, framework, stack, addon)
    platforms = tuple(matrix.architectures[architecture].platform for architecture in architectures)
    if stack is None:
        return Kind(name, framework, facts, None, architectures, platforms)
    python = matrix.operating_systems[matrix.distributions[name].os].python
    kinds = combinations.parts(matrix, facts, matrix.stacks[stack])
    parts = tuple(_part(matrix, kind, stack, python, architectures) for kind in kinds)
    more = {
        other: combinations.parts(matrix, entry, matrix.stacks[stack])
        for other, entry in matrix.frameworks.items()
        if not addon
        and combinations.stack_reason(matrix, name, other, stack) is None
        and set(architectures) <= set(combinations.architectures(matrix, name, other, stack))
    }
    covering = sorted((other for other in more if set(kinds) < set(more[other])), key=lambda other: -len(more[other]))
    release_versions = combinations.versions(matrix, matrix.stacks[stack])
    versions = {
        name: release_versions[name] for name in combinations.counted(matrix, facts) if name in release_versions
    }
    brought = combinations.brought(matrix, kinds, matrix.stacks[stack])
    short = stack == combinations.default_stack(matrix, name, framework, addon)
    return Kind(
        name,
        framework,
        facts,
        stack,
        architectures,
        platforms,
        parts,
        versions,
        brought,
        tuple(covering),
        short,
        addon,
        gpu=combinations.gpu(matrix, stack, kinds),
    )


def _with_environment(matrix: Matrix, environment: str, kind: Kind) -> Kind | None:
    """The facts of images with an environment; None if they have no stack, or it has locks for none of their architectures."""
    architectures = tuple(it for it in kind.architectures if it in matrix.environments[environment].architectures)
    if not architectures or not kind.stack:
        return None
    python = matrix.operating_systems[matrix.distributions[kind.distribution].os].python
    part = _environment(matrix, environment, python, architectures)
    parts = (*kind.parts, part)
    return replace(kind, architectures=architectures, platforms=part.platforms, parts=parts, environment=environment)


def _image(matrix: Matrix, place: Place) -> Image:
    kind, component, target, name = place.kind, place.component, place.target, place.kind.distribution
    distribution = matrix.distributions[name]
    chain = _chain(matrix, name, component)
    ros_image = names.image_target(name, component)
    runtime = combinations.only_runs(matrix, component)
    below = names.image_target(name, chain[-2]) if len(chain) > 1 else names.os_target(distribution.os, runtime)
    groups = [
        name,
        component,
        kind.environment or kind.addon or kind.framework,
        *([kind.stack] if kind.stack else []),
        "all",
    ]
    tests = _tests(matrix, name, component, kind)
    carries = tests.carriers[:1] == (target,)
    wheels = _wheels_of(matrix, name, kind.architectures)
    tagged, end = bool(place.tags), names.environments_end([kind.environment])
    return Image(
        target=target,
        distribution=name,
        component=component,
        framework=kind.framework,
        stack=kind.stack,
        os=distribution.os,
        python=matrix.operating_systems[distribution.os].python,
        ros=distribution.ros,
        ros_distro=distribution.ros_distro or name,
        architectures=kind.architectures,
        platforms=kind.platforms,
        versions=kind.versions,
        brought=kind.brought,
        gpu=kind.gpu,
        repository=kind.facts.repository,
        tags=place.tags,
        groups=tuple(groups if tagged else [kind.addon]) + (("default",) if target in matrix.default.group else ()),
        parent=ros_image if kind.stack else below,
        packages="" if kind.stack else _packages(matrix, name, distribution, component),
        wheels=() if kind.stack else distribution.wheels,
        parts=kind.part_names,
        tests=(*tests.of_image, *(tests.carried if carries else ())),
        shared=(*tests.below, *(() if carries else tests.carried)),
        carried=tests.carried,
        carriers=tests.carriers,
        locks=(*(lock for item in wheels for lock in item.locks), *kind.locks),
        disk=Size.total(
            combinations.system_size(matrix, component),
            *(matrix.disk.components[link] for link in chain),
            *(part.disk for part in kind.parts),
        ),
        budget=matrix.disk.budgets.get(kind.stack or "", {}).get(kind.addon or kind.framework),
        budgeted=_budgeted(matrix, kind),
        addons=kind.addons,
        combination="-".join([kind.framework, *kind.addons]).removeprefix(f"{names.NONE}-") + end,
        environment=kind.environment,
    )


def _budgeted(matrix: Matrix, kind: Kind) -> tuple[str, ...]:
    """The parts that a budget counts. What frameworks have is in theirs, so that the one of an add-on holds beside any of them."""
    parts = [part for part in kind.parts if not isinstance(part, Environment)]
    others = set[str]()
    if kind.addon and kind.stack:
        others = {part for parts in combinations.frameworks(matrix, kind.stack).values() for part in parts}
    return tuple(part.name for part in parts if part.kind not in others)


@dataclass(frozen=True)
class _Tests:
    """The tests of an image.

    ROS and parts are the same in every image that has them, so their tests run once: those of ROS in the ROS image, those of parts
    once in each distribution, with its lowest component and all frameworks of a stack. If you ask for one image alone, it runs all.

    Attributes:
        of_image: tests that depend on the image as a whole.
        below: the tests of the ROS image below it.
        carried: tests that one image of a distribution runs for the others.
        carriers: the images that may run them, the best first.
    """

    of_image: tuple[str, ...]
    below: tuple[str, ...]
    carried: tuple[str, ...]
    carriers: tuple[str, ...]


def carriers(matrix: Matrix, place: Place) -> tuple[str, ...]:
    """The targets of the images that may run the shared tests of an image."""
    return _tests(matrix, place.kind.distribution, place.component, place.kind).carriers


def _tests(matrix: Matrix, name: str, component: str, kind: Kind) -> _Tests:
    distribution = matrix.distributions[name]
    if kind.environment:  # it changes nothing of the image without it, whose tests count for the rest
        parts = tuple(part for part in kind.parts if not isinstance(part, Environment))
        plain = replace(kind, environment="", parts=parts)
        beside = ("contract", "environment", *matrix.environments[kind.environment].tests)
        tests = _tests(matrix, name, component, plain)
        others = (test for test in (*tests.of_image, *tests.carried) if test not in beside)
        return _Tests(beside, tests.below, tuple(others), (plain.target(component),))
    ros, runtime = f"ros{distribution.ros}", combinations.only_runs(matrix, component)
    entries = [matrix.part[part.kind] for part in kind.parts]
    of_image = ["contract", "runtime" if runtime else "tools"]
    of_image += [f"{ros}-wheels"] if distribution.wheels else [ros, f"{ros}-beside"]
    of_image += [entry.name for entry in entries if entry.tested]
    lowest = next(iter(_lowest(matrix, name)), component)
    frameworks = (*kind.covering, kind.framework) if kind.stack or not runtime else ()
    carriers = tuple(kind.target(lowest, framework) for framework in frameworks)
    if runtime:  # other tests need a compiler
        return _Tests(tuple(of_image), (), (), carriers)
    # What an add-on does not bring was tested without it.
    mine = matrix.addons[kind.addon].parts if kind.addon else tuple(entry.name for entry in entries)
    carried = [f"{entry.name}-build" for entry in entries if entry.compiled and entry.name in mine]
    if distribution.wheels:
        return _Tests(tuple(of_image), (), (*carried, "pip"), carriers)
    chain = [f"{ros}-{link}" for link in _chain(matrix, name, component)]
    of_ros = [*chain, f"{ros}-components"]
    below = of_ros if kind.stack else of_ros[:-2]
    workspace = [] if kind.addon else [f"{ros}-workspace"]
    return _Tests((*of_image, *of_ros[len(below) :]), tuple(below), (*carried, *workspace, "pip"), carriers)


@combinations.remembered
def _chain(matrix: Matrix, name: str, component: str) -> tuple[str, ...]:
    return tuple(link for link in combinations.chain(matrix, component) if link in matrix.distributions[name].present)


def _packages(matrix: Matrix, name: str, distribution: Distribution, component: str) -> str:
    component = matrix.components[component].runtime_of or component
    metapackage = matrix.components[component].metapackage or component
    ros_distro = distribution.ros_distro or name
    return (distribution.packages or "").format(component=component, metapackage=metapackage, ros_distro=ros_distro)


def _tags(matrix: Matrix, kind: Kind, component: str, latest: str | None) -> tuple[str, ...]:
    rows = (kind.distribution, *matrix.distributions[kind.distribution].aliases)
    versions = labels.spelled(kind.brought)
    tags = [tag for row in rows for tag in full_tags(row, component, kind.stack, versions)]
    short = short_tags(rows, component, kind.distribution == latest) if kind.short else ()
    return tuple(f"{kind.facts.repository}:{tag}" for tag in (*tags, *short))


def _wheels(matrix: Matrix) -> Iterator[Wheels]:
    for name in matrix.distributions:
        yield from _wheels_of(matrix, name, combinations.built_for(matrix, name))


def _wheels_of(matrix: Matrix, name: str, architectures: tuple[str, ...]) -> tuple[Wheels, ...]:
    distribution = matrix.distributions[name]
    python = matrix.operating_systems[distribution.os].python
    locks = tuple(names.lock_path(name, architecture, python, names.ROS) for architecture in architectures)
    wheels = Wheels(name, distribution.os, python, distribution.wheels, architectures, locks)
    return (wheels,) if distribution.wheels else ()


@combinations.remembered
def _part(matrix: Matrix, kind: str, stack: str, python: str, architectures: tuple[str, ...]) -> Part:
    any_python = matrix.part[kind].any_python
    os = _system(matrix, _pythons(matrix, kind, stack) if any_python else (python,))
    if any_python:
        python = ANY_PYTHON
    return Part(
        name=names.part_name(kind, stack, python),
        kind=kind,
        stack=stack,
        python=python,
        os=os,
        architectures=architectures,
        platforms=tuple(matrix.architectures[architecture].platform for architecture in architectures),
        locks=tuple(names.lock_path(stack, architecture, python, kind) for architecture in architectures),
        disk=matrix.disk.parts[stack][kind],
    )


def _system(matrix: Matrix, pythons: Iterable[str]) -> str:
    """The operating system with one of these Pythons on which a part is built; the assembler if none has."""
    fitting = sorted(name for name, system in matrix.operating_systems.items() if system.python in pythons)
    assembler = matrix.default.assembler
    return assembler if assembler in fitting or not fitting else fitting[0]


def _environment(matrix: Matrix, name: str, python: str, architectures: tuple[str, ...]) -> Environment:
    folder = names.environment_locks(name, python)
    return Environment(
        name=names.environment_part(name, python),
        kind=f"env-{name}",
        stack="",
        python=python,
        os=_system(matrix, (python,)),
        architectures=architectures,
        platforms=tuple(matrix.architectures[architecture].platform for architecture in architectures),
        locks=tuple(f"{folder}/{architecture}.txt" for architecture in architectures),
        disk=matrix.environments[name].disk,
        environment=name,
    )


def _pythons(matrix: Matrix, part: str, stack: str) -> tuple[str, ...]:
    """The Pythons of the wheels from which a part for any Python is taken; none if the wheels are for any Python themselves."""
    family = matrix.part[part].release
    return matrix.release(stack, family).python if family else ()


def parts_of(matrix: Matrix, images: Iterable[Place]) -> tuple[Part, ...]:
    """Each part that images need, once, for all architectures for which they need it."""
    by_stack: dict[tuple[str | None, str], list[Kind]] = {}
    for kind in {id(place.kind): place.kind for place in images}.values():
        python = matrix.operating_systems[matrix.distributions[kind.distribution].os].python
        by_stack.setdefault((kind.stack, python), []).append(kind)
    needed_parts: dict[tuple[str, str, str], set[str]] = {}
    environments: dict[tuple[str, str], set[str]] = {}
    for kind in (kind for kinds in by_stack.values() for kind in kinds):
        for part in kind.parts:
            if isinstance(part, Environment):
                environments.setdefault((part.environment, part.python), set()).update(kind.architectures)
            else:
                needed_parts.setdefault((part.kind, part.stack, part.python), set()).update(kind.architectures)

    def ordered(architectures: set[str]) -> tuple[str, ...]:
        return tuple(name for name in matrix.architectures if name in architectures)

    return (
        *(_part(matrix, *key, ordered(needed)) for key, needed in needed_parts.items()),
        *(_environment(matrix, *key, ordered(needed)) for key, needed in environments.items()),
    )
