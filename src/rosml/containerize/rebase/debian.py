"""Versions of Debian's packages and what they say of each other, by Debian's policy (chapters 5.6.12 and 7).

dpkg's own fields have no restrictions by architecture or build profile: dpkg-gencontrol has decided them.
"""

from __future__ import annotations

import functools
import re
from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence
from itertools import zip_longest
from typing import NamedTuple, Protocol

_RELATION = re.compile(r"([a-z0-9][a-z0-9+.-]*)(:[a-z0-9-]+)?\s*(?:\(\s*(<<|<=|=|>=|>>|<|>)\s*([^\s()]+)\s*\))?")
COMPARISONS = 2_000_000
"""The most versions that are compared for one image, which take some seconds."""

_RUN = re.compile(r"(\D*)(\d*)")


class Package(Protocol):
    """The fields of a package that others refer to. The last two are as dpkg writes them."""

    @property
    def name(self) -> str: ...
    @property
    def version(self) -> str: ...
    @property
    def provides(self) -> str: ...
    @property
    def conflicts(self) -> str: ...


class Relation(NamedTuple):
    """A package that another one names. Operator and version are empty if any version counts."""

    name: str
    operator: str
    version: str

    def __str__(self) -> str:
        return f"{self.name} ({self.operator} {self.version})" if self.operator else self.name

    def is_met_by(self, version: str) -> bool:
        """Whether a version counts; empty: that of a virtual package without one."""
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
    """The packages that a field names: for each entry its alternatives.

    Raises:
        ValueError: it is no such field.
    """
    return [[_relation(item) for item in entry.split("|")] for entry in text.split(",") if entry.strip()]


def _relation(text: str) -> Relation:
    found = _RELATION.fullmatch(text.strip())
    if not found:
        raise ValueError(f"{text.strip()[:80]!r} names no package")
    return Relation(found[1], found[3] or "", found[4] or "")


def compare(one: str, other: str) -> int:
    """The order of two versions: negative if the first one is older, 0 if both are the same."""
    for first, second in zip(_parts(one), _parts(other), strict=True):
        for left, right in zip_longest(first, second, fillvalue=(0,)):  # what is missing counts as 0
            if left != right:
                return 1 if left > right else -1
    return 0


@functools.lru_cache(1 << 14)
def _parts(version: str) -> tuple[Sequence[tuple[int, ...]], ...]:
    """Epoch, upstream's version and revision. In each of them, characters and numbers take turns, so that Python's order is dpkg's:
    a tilde comes before the end, and letters before other characters."""
    epoch, colon, rest = version.partition(":")
    upstream, hyphen, revision = (rest if colon else version).rpartition("-")
    if not hyphen:
        upstream, revision = revision, ""
    found = []
    for text in (epoch if colon else "", upstream, revision):
        turns = ((_ranks(letters), (int(digits or 0),)) for letters, digits in _RUN.findall(text))
        found.append([item for turn in turns for item in turn])
    return tuple(found)


def _ranks(letters: str) -> tuple[int, ...]:
    """The places of characters in dpkg's order, with 0 for the end."""
    return (*(-1 if it == "~" else ord(it) if it.isalpha() else ord(it) + 256 for it in letters), 0)


class Known:
    """Packages that are there, with the virtual ones that they provide.

    Raises:
        ValueError: a field is damaged.
    """

    def __init__(self, packages: Iterable[Package]) -> None:
        self._left = COMPARISONS
        self._versions: defaultdict[str, list[tuple[str, str]]] = defaultdict(list)
        for package in packages:
            self._versions[package.name].append((package.version, package.name))
            for [provided, *_] in relations(package.provides):
                self._versions[provided.name].append((provided.version, package.name))

    def __contains__(self, name: str) -> bool:
        return name in self._versions

    def met(self, alternatives: Sequence[Relation]) -> bool:
        """Whether one of some alternatives is there.

        Raises:
            ValueError: it would take too long.
        """
        return any(
            self._is_met(item, version) for item in alternatives for version, _ in self._versions.get(item.name, ())
        )

    def _is_met(self, item: Relation, version: str) -> bool:
        self._left -= 1 + (len(version) + len(item.version)) // 64
        if self._left < 0:
            raise ValueError("packages name each other more often than any real ones")
        return item.is_met_by(version)

    def there(self, name: str) -> str:
        """The version of a package; empty if it is not there."""
        return next((version for version, owner in self._versions.get(name, ()) if owner == name), "")

    def conflicts(self, package: Package) -> Iterator[tuple[str, Relation]]:
        """The packages that another package cannot stand beside, with what it says.

        Raises:
            ValueError: a field is damaged, or it would take too long.
        """
        for [named, *_] in relations(package.conflicts):
            for version, owner in self._versions.get(named.name, ()):
                if owner != package.name and self._is_met(named, version):
                    yield owner, named
