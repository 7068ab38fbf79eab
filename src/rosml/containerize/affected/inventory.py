"""The components of many images, each once, from their SBOMs."""

from __future__ import annotations

import threading
from collections import defaultdict
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from hashlib import blake2b
from typing import Any

from packageurl import PackageURL

from rosml.containerize.affected.query import Component, Query
from rosml.images.scan.cyclonedx import PART
from rosml.images.scan.sbom import OF_A_SYSTEM, Sbom, component_of
from rosml.images.scan.trivy import Report, Trivy
from rosml.registry import oci

MOST = 100_000
"""The most components of an SBOM that are read."""

_NO_PACKAGE = -1
"""In place of a number: what is no package, such as the operating system."""

_TRIVY = "aquasecurity:trivy:"
_SOURCE, _SOURCE_VERSION = f"{_TRIVY}SrcName", f"{_TRIVY}SrcVersion"


@dataclass(frozen=True)
class Contents:
    """The components of an image, by their numbers, and what of its SBOMs was not understood."""

    numbers: frozenset[int]
    notes: tuple[str, ...] = ()

    @staticmethod
    def together(contents: Iterable[Contents]) -> Contents:
        every = [*contents]
        return Contents(
            frozenset[int]().union(*(it.numbers for it in every)),
            tuple(dict.fromkeys(note for it in every for note in it.notes)),
        )


@dataclass(frozen=True)
class Matches:
    """Components by number.

    Attributes:
        fixed: those that a question is for, each with the versions that fix it.
        unclear: those of which nobody knows: the scanner does not know their system, or they have no version that can be compared.
    """

    fixed: Mapping[int, str] = field(default_factory=dict)
    unclear: frozenset[int] = frozenset()

    def __or__(self, other: Matches) -> Matches:
        return Matches({**self.fixed, **other.fixed}, self.unclear | other.unclear)


@dataclass
class Inventory:
    """All components by number. Safe to share among threads."""

    components: list[Component] = field(default_factory=list)
    _numbers: dict[Component, int] = field(default_factory=dict)
    _systems: dict[bytes, str | None] = field(default_factory=dict)
    _same: defaultdict[str, dict[bytes, int]] = field(default_factory=lambda: defaultdict(dict))
    _lock: Any = field(default_factory=threading.Lock)

    def read(self, sbom: Sbom) -> Contents:
        """The components of an SBOM."""
        texts, notes = sbom.component_texts, list[str]()
        if len(texts) > MOST:
            notes.append(f"its SBOM has {len(texts):,} components, and {MOST:,} were read")
        keys = [blake2b(text, digest_size=16).digest() for text in texts[:MOST]]
        systems = (self._system_of(key, text) for key, text in zip(keys, texts, strict=False))
        system = next((system for system in systems if system is not None), "")
        numbers = self._numbered(keys, texts, system)
        if unnamed := sum(not self.components[number].purl for number in numbers):
            notes.append(f"package URLs that are none: {unnamed}")
        return Contents(numbers, tuple(notes))

    def _system_of(self, key: bytes, text: bytes) -> str | None:
        """The system that a component is; None if it is none."""
        if key not in self._systems:
            item = component_of(text)
            self._systems[key] = _system(item) if item.get("type") == "operating-system" else None
        return self._systems[key]

    def _numbered(self, keys: Iterable[bytes], texts: Iterable[bytes], system: str) -> frozenset[int]:
        """The numbers of an SBOM's packages. SBOMs share most of them: a text that was read before is only looked up by its digest."""
        same, numbers = self._same[system], set[int]()
        for key, text in zip(keys, texts, strict=False):
            number = same.get(key)
            if number is None:
                item = component_of(text)
                with self._lock:
                    is_package = item.get("type") == "library"
                    number = self._number(_component(item, _properties(item), system)) if is_package else _NO_PACKAGE
                    same[key] = number
            numbers.add(number)
        return frozenset(numbers - {_NO_PACKAGE})

    def _number(self, component: Component) -> int:
        number = self._numbers.setdefault(component, len(self.components))
        if number == len(self.components):
            self.components.append(component)
        return number

    def matching(self, query: Query, start: int = 0) -> Matches:
        """The components from a number on that a query for a package is for."""
        answers = [(number, query.meets(self.components[number])) for number in range(start, len(self.components))]
        unclear = frozenset(number for number, answer in answers if answer is None)
        return Matches({number: "" for number, answer in answers if answer}, unclear)

    def vulnerable(self, advisory: str, trivy: Trivy, start: int = 0) -> Matches:
        """The components from a number on that have an advisory.

        All components of a system make one SBOM. So trivy runs once for each system, however many images there are.
        """
        matches, by_system = Matches(), defaultdict[str, list[int]](list)
        for number in range(start, len(self.components)):
            component = self.components[number]
            if component.version and (component.kind == "pypi" or (component.kind == "deb" and component.system)):
                by_system[component.system].append(number)
            elif component.kind in ("deb", "pypi", ""):
                matches |= Matches(unclear=frozenset([number]))
        for system, numbers in sorted(by_system.items()):
            document = self._document(system, numbers)
            if trivy.lacks(Sbom(document).sources):
                matches |= Matches(unclear=frozenset(numbers))
            else:
                matches |= Matches(_with(advisory, trivy.scan(document, system or "packages of Python")))
        return matches

    def _document(self, system: str, numbers: Iterable[int]) -> bytes:
        """An SBOM for trivy, with its own properties of Debian packages. It names components by their numbers."""
        family, _, version = system.partition(" ")
        of_system = {"bom-ref": "system", "type": "operating-system", "name": family, "version": version}
        libraries = [_library(str(number), self.components[number], family) for number in numbers]
        about = {"component": {"bom-ref": "all", "type": "application", "name": "all"}}
        components = [*([of_system] if system else []), *libraries]
        document = {"bomFormat": "CycloneDX", "specVersion": "1.6", "version": 1, "metadata": about}
        return oci.encoded({**document, "components": components})


def _library(ref: str, component: Component, family: str) -> dict[str, Any]:
    facts = {"PkgType": family, "SrcName": component.source, "SrcVersion": component.source_version}
    properties = [{"name": f"{_TRIVY}{name}", "value": value} for name, value in facts.items() if value and family]
    names = {"name": component.name, "version": component.version, "purl": component.purl}
    return {"bom-ref": ref, "type": "library", **names, "properties": properties}


def _with(advisory: str, report: Report) -> dict[int, str]:
    return {
        int(item.PkgIdentifier.BOMRef): item.FixedVersion
        for result in report.Results or ()
        for item in result.Vulnerabilities or ()
        if item.VulnerabilityID == advisory and item.PkgIdentifier.BOMRef.isdecimal()
    }


def _text(item: Mapping[str, Any], name: str) -> str:
    value = item.get(name)
    return value[:1000] if isinstance(value, str) else ""


def _properties(item: Mapping[str, Any]) -> dict[str, str]:
    properties = item.get("properties")
    entries = properties if isinstance(properties, list) else []
    return {_text(it, "name"): _text(it, "value") for it in entries if isinstance(it, dict)}


def _system(item: Mapping[str, Any]) -> str:
    """Such as `debian 12.12`; empty of one without a version, which is of the wheel's SBOM that names it."""
    return f"{_text(item, 'name')} {_text(item, 'version')}" if _text(item, "version") else ""


def _component(item: Mapping[str, Any], properties: Mapping[str, str], system: str) -> Component:
    purl, name, version = (_text(item, key) for key in ("purl", "name", "version"))
    kind = _kind(purl)
    family = system.partition(" ")[0]
    if family and (match := OF_A_SYSTEM.match(purl)) and match[1] != family:
        kind = "foreign"  # of a library that was copied into a wheel
    return Component(
        kind,
        name,
        version,
        properties.get(_SOURCE, "") if kind == "deb" else "",
        properties.get(_SOURCE_VERSION, "") if kind == "deb" else "",
        purl if kind else "",
        properties.get(PART, ""),
        system if kind == "deb" else "",
    )


def _kind(purl: str) -> str:
    """The kind of a package by its URL; empty if it is none."""
    for start, kind in (("pkg:deb/", "deb"), ("pkg:pypi/", "pypi"), ("pkg:generic/ros/", "ros")):
        if purl.startswith(start) and len(purl) > len(start):
            return kind
    try:
        return PackageURL.from_string(purl).type
    except ValueError:
        return ""
