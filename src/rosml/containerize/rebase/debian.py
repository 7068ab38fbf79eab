"""Versions of Debian's packages and what they say of each other, by Debian's policy (chapters 5.6.12 and 7). dpkg's own fields have no
restrictions by architecture or build profile: dpkg-gencontrol has decided them."""

from __future__ import annotations

import functools
import re
from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence
from itertools import zip_longest
from typing import NamedTuple

from rosml.images.join.facts import Package

COMPARISONS = 2_000_000  # the most versions that are compared for one image, which take some seconds

_RELATION = re.compile(r"([a-z0-9][a-z0-9+.-]*)(:[a-z0-9-]+)?\s*(?:\(\s*(<<|<=|=|>=|>>|<|>)\s*([^\s()]+)\s*\))?")
_RUN = re.compile(r"(\D*)(\d*)")


class Relation(NamedTuple):
    """A package that another one names. Operator and version are empty if any version counts."""

    name: str
    operator: str
    version: str

    def __str__(self) -> str:
        return f"{self.name} ({self.operator} {self.version})" if self.operator else self.name

    def is_met_by(self, version: str) -> bool:
        """Whether a version counts. A virtual package without a version has an empty one."""
        if not self.operator:
            return True
        if not version:
            return False
        order = compare(version, self.version)
        if self.operator == "=":
            return order == 0
        if order == 0:
            return self.operator not in ("<<", ">>")  # the old forms < and > count as <= and >=
        return (order < 0) == self.operator.startswith("<")


def relations(text: str) -> list[list[Relation]]:
    """The alternatives of each entry of a field. ValueError if it is no such field."""
    return [[_relation(item) for item in entry.split("|")] for entry in text.split(",") if entry.strip()]


def _relation(text: str) -> Relation:
    match = _RELATION.fullmatch(text.strip())
    if not match:
        raise ValueError(f"{text.strip()[:80]!r} names no package")
    return Relation(match[1], match[3] or "", match[4] or "")


def compare(version: str, other: str) -> int:
    """The order of two versions: negative if the first one is older, 0 if both are the same."""
    for turns, other_turns in zip(_parts(version), _parts(other), strict=True):
        for turn, other_turn in zip_longest(turns, other_turns, fillvalue=(0,)):  # what is missing counts as 0
            if turn != other_turn:
                return 1 if turn > other_turn else -1
    return 0


@functools.lru_cache(1 << 14)
def _parts(version: str) -> tuple[Sequence[tuple[int, ...]], ...]:
    """Epoch, upstream's version and revision. In each, characters and numbers take turns, so that Python's order is dpkg's: a tilde
    comes before the end, and letters before other characters."""
    epoch, colon, rest = version.partition(":")
    upstream, hyphen, revision = (rest if colon else version).rpartition("-")
    if not hyphen:
        upstream, revision = revision, ""
    parts = []
    for text in (epoch if colon else "", upstream, revision):
        turns = ((_ranks(letters), (int(digits or 0),)) for letters, digits in _RUN.findall(text))
        parts.append([item for turn in turns for item in turn])
    return tuple(parts)


def _ranks(letters: str) -> tuple[int, ...]:
    """The places of characters in dpkg's order, with 0 for the end."""
    return (*(-1 if it == "~" else ord(it) if it.isalpha() else ord(it) + 256 for it in letters), 0)


class Budget:
    """Steps for the facts of one image. If they take more, which no real ones do, that is a ValueError."""

    def __init__(self, steps: int, things: str) -> None:
        self._remaining, self._things = steps, things

    def take(self, count: int) -> None:
        self._remaining -= count
        if self._remaining < 0:
            raise ValueError(f"{self._things} name each other more often than any real ones")


class PackageSet:
    """Packages of images, with the virtual ones that they provide. A damaged field, or too many comparisons, raise ValueError."""

    def __init__(self, packages: Iterable[Package]) -> None:
        self._budget = Budget(COMPARISONS, "packages")
        self._providers: defaultdict[str, list[tuple[str, str]]] = defaultdict(list)
        for package in packages:
            self._providers[package.name].append((package.version, package.name))
            for [provided, *_] in relations(package.provides):
                self._providers[provided.name].append((provided.version, package.name))

    def __contains__(self, name: str) -> bool:
        return name in self._providers

    def meets(self, alternatives: Sequence[Relation]) -> bool:
        return any(
            self._is_met(item, version) for item in alternatives for version, _ in self._providers.get(item.name, ())
        )

    def _is_met(self, relation: Relation, version: str) -> bool:
        self._budget.take(1 + (len(version) + len(relation.version)) // 64)
        return relation.is_met_by(version)

    def version_of(self, name: str) -> str:
        """The version of a package that is no virtual one; empty if it is missing."""
        return next((version for version, package in self._providers.get(name, ()) if package == name), "")

    def conflicts(self, package: Package) -> Iterator[tuple[str, Relation]]:
        """The packages beside which another package cannot stand, and the relation that says so."""
        for [relation, *_] in relations(package.conflicts):
            for version, name in self._providers.get(relation.name, ()):
                if name != package.name and self._is_met(relation, version):
                    yield name, relation
