"""The tags of images: `jazzy-base-cu130`, with versions, without a component, and of a day."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping

from rosml.images.matrix import combinations
from rosml.images.matrix.model import Matrix

DATED = re.compile(r"-(\d{8})(?:\.\d+)?$")
"""The date at the end of a tag that never moves."""

FLOATING = "base"
"""The component of the short tags: `ros:jazzy` is `ros:jazzy-base`."""


def full_tags(distribution: str, component: str, stack: str | None, versions: Mapping[str, str]) -> tuple[str, ...]:
    """The main tag of an image, and the one that spells its versions, if there are any."""
    main = main_tag(distribution, component, stack)
    return tuple(dict.fromkeys((main, spelled_tag(main, versions))))


def short_tags(distributions: Iterable[str], component: str, latest: bool) -> tuple[str, ...]:
    """The tags without a component, of the names of a distribution: `jazzy`, and `latest` of the latest one."""
    return (*distributions, *(["latest"] if latest else [])) if component == FLOATING else ()


def main_tag(distribution: str, component: str, stack: str | None = None) -> str:
    """The main tag of an image: `jazzy-base-cu128`."""
    return "-".join([distribution, component, *([stack] if stack else [])])


def spelled_tag(main: str, versions: Mapping[str, str]) -> str:
    """A main tag with versions by their names in tags: `jazzy-base-cu128-torch2.10.0`; unchanged without any."""
    return "-".join([main, *(f"{name}{version}" for name, version in versions.items())])


def dated(tag: str, date: str) -> str:
    """The tag of a day, which never moves: `jazzy-base-20261122`."""
    return f"{tag}-{date[:10].replace('-', '')}"


def latest_distribution(matrix: Matrix) -> str | None:
    """The newest long-term distribution, which is supported longest, of those with the component of the short tags and every
    framework. An experimental one does not count."""
    rows = matrix.distributions.items()
    lasting = [(row.eol, name, row) for name, row in rows if row.lts and row.eol and not row.experimental]
    whole = [
        (eol, name) for eol, name, row in lasting if FLOATING in row.present and _has_every_framework(matrix, name)
    ]
    return max(whole)[1] if whole else None


def _has_every_framework(matrix: Matrix, name: str) -> bool:
    return all(
        any(combinations.stack_reason(matrix, name, framework, stack) is None for stack in matrix.stacks)
        for framework, facts in matrix.frameworks.items()
        if facts.parts
    )
