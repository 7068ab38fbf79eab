"""What people ask for: an advisory, or a package with or without a range of versions."""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import NamedTuple

from packaging.utils import canonicalize_name
from packaging.version import InvalidVersion, Version

from rosml.base.errors import RosmlError
from rosml.containerize.rebase import debian
from rosml.images.scan.policy import ADVISORY

KINDS = ("deb", "pypi", "ros")
"""The kinds of packages that SBOMs of rosml have."""

LONGEST = 200
"""The most characters of a version that are compared."""

_IS_ADVISORY = re.compile(r"[A-Z]{3,}-.*")
_PACKAGE = re.compile(
    rf"(?:({'|'.join(KINDS)}):)?([A-Za-z0-9][A-Za-z0-9._+-]*?)\s*(?:(<=|>=|==|=|<|>)\s*([A-Za-z0-9][A-Za-z0-9.+:~!_-]*))?"
)
_COMPARISONS = {
    "<": lambda order: order < 0,
    "<=": lambda order: order <= 0,
    "=": lambda order: order == 0,
    ">=": lambda order: order >= 0,
    ">": lambda order: order > 0,
}


class Component(NamedTuple):
    """A package in an SBOM. A text is empty if the SBOM lacks it."""

    kind: str  # of KINDS
    name: str
    version: str
    source: str  # a Debian package's source package
    source_version: str
    purl: str
    part: str  # of the image that it is in
    system: str  # the operating system of a Debian package, such as debian 12.12

    def __str__(self) -> str:
        return f"{self.name} {self.version or 'of unknown version'}"


@dataclass(frozen=True)
class Query:
    """`package` is empty for an advisory, and `operator` if any version counts."""

    text: str
    kind: str = ""
    package: str = ""
    operator: str = ""
    version: str = ""

    @property
    def is_advisory(self) -> bool:
        return not self.package

    def meets(self, component: Component) -> bool | None:
        """Whether a component is one of the package in the range; None if its version cannot be compared."""
        if self.kind not in ("", component.kind):
            return False
        if self.package == component.source and self.package != component.name:
            return self._is_in_range(component.kind, component.source_version)
        names = (self.package, component.name)
        if component.kind == "pypi":
            names = (canonicalize_name(names[0]), canonicalize_name(names[1]))
        return names[0] == names[1] and self._is_in_range(component.kind, component.version)

    def _is_in_range(self, kind: str, version: str) -> bool | None:
        if not self.operator:
            return True
        order = compared(kind, version, self.version)
        return None if order is None else _COMPARISONS[self.operator](order)


def parse(text: str) -> Query:
    """Raises RosmlError with exit code 2 if it is neither an advisory nor a package."""
    text = text.strip()
    if _IS_ADVISORY.fullmatch(text) and re.fullmatch(ADVISORY, text):
        return Query(text)
    match = _PACKAGE.fullmatch(text)
    if not match:
        remedy = "write it as CVE-2026-12345, openssl, 'openssl<3.0.15' or 'pypi:torch<2.6'"
        raise RosmlError(f"{text[:80]!r} is neither an advisory nor a package", remedy, exit_code=2)
    operator = "=" if match[3] == "==" else match[3] or ""
    return Query(text, match[1] or "", match[2], operator, match[4] or "")


def compared(kind: str, version: str, other: str) -> int | None:
    """The order of two versions, by the rules of the kind of package: Debian's policy or PEP 440. None if one is none, or too long."""
    if not version or max(len(version), len(other)) > LONGEST:
        return None
    if kind == "deb":
        return debian.compare(version, other)
    try:
        first, second = Version(version), Version(other)
    except InvalidVersion:
        return None
    return (first > second) - (first < second)
