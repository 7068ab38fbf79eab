"""ROS packages that people expect of a distribution and that it lacks, and what to take instead: `lacks` in matrix.yaml."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from rosml.base.problems import listed, some
from rosml.images.matrix import combinations
from rosml.images.matrix.model import Matrix
from rosml.images.matrix.tags import FLOATING, main_tag


def other_distribution(matrix: Matrix, name: str) -> str:
    """The distribution of the same ROS that lacks nothing; else one of its generation, a long-term one first. Empty if there is none."""
    row = matrix.distributions[name]
    others = [
        ((it.ros_distro or key) != (row.ros_distro or name), not it.lts, key)
        for key, it in matrix.distributions.items()
        if it.ros == row.ros and not it.lacks and not it.experimental and key != name
    ]
    return min(others)[-1] if others else ""


def with_component(matrix: Matrix, name: str, component: str) -> str:
    """The distribution to take instead of one that lacks something, if it has a component; else empty."""
    other = other_distribution(matrix, name) if matrix.distributions[name].lacks else ""
    return other if other and component in matrix.distributions[other].present else ""


def component_with(matrix: Matrix, name: str, packages: frozenset[str]) -> str:
    """The component of a distribution that has some packages: the usual one, or a larger one that people search for one of them."""
    components = matrix.distributions[name].components
    usual = components.index(FLOATING) if FLOATING in components else 0
    searched = [
        place for place, item in enumerate(components) if not packages.isdisjoint(matrix.components[item].search)
    ]
    return components[max(usual, *searched[:1])] if searched else components[usual]


def instead(
    matrix: Matrix, name: str, packages: Iterable[str] = (), framework: str = "", stack: str | None = None
) -> str:
    """The tag to take instead of an image of a distribution, if packages need what it lacks: `ros:jazzy-base`. It has the same framework
    on the same stack, if there is one. Empty if no distribution has the packages."""
    other = other_distribution(matrix, name)
    if not other:
        return ""
    exists = framework in matrix.frameworks and stack in matrix.stacks
    if not exists or combinations.stack_reason(matrix, other, framework, stack):
        framework, stack = combinations.plain(matrix), None
    component = component_with(matrix, other, frozenset(packages))
    return f"{matrix.frameworks[framework].repository}:{main_tag(other, component, stack)}"


def sentence(matrix: Matrix, name: str, framework: str = "", stack: str | None = None) -> str:
    """Says what a distribution lacks, and what to take instead; empty if it lacks nothing."""
    row = matrix.distributions[name]
    if not row.lacks:
        return ""
    what = f"has ROS {row.ros} for Python alone, without" if row.wheels else "lacks"
    usual = instead(matrix, name, (), framework, stack)
    keys_by_tag: dict[str, list[str]] = {}
    for key in row.lacks:
        keys_by_tag.setdefault(instead(matrix, name, [key], framework, stack), []).append(key)
    larger = [f"{tag} for {listed(keys)}" for tag, keys in keys_by_tag.items() if tag != usual]
    takes = f"; take {usual}{f', or {listed(larger)}' if larger else ''}" if usual else ""
    return f"{name} {what} {some(row.lacks)}{takes}"


def sentences(matrix: Matrix, names: Iterable[str]) -> Iterator[str]:
    """The same of those of some distributions that lack something."""
    return filter(None, (sentence(matrix, name) for name in dict.fromkeys(names)))
