"""What a dossier reads of an SBOM. Each value is a stranger's word: a wrong type counts as a value that is not there."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from packageurl import PackageURL

from rosml.base import terminal, untrusted
from rosml.images.scan.deployed import NO_HASH
from rosml.images.scan.sbom import LARGEST

LONGEST = 500
"""The most characters of a name, a version or a licence that are shown."""

MOST = 100
"""The most licences, hashes or contacts of a component that are read."""

Item = Mapping[str, Any]

REASONS = NO_HASH.removesuffix("hash")
"""The prefix of a component's properties that say why it lacks a field: `io.rosml.lacks.hash`."""


def text(item: Item, *path: str) -> str:
    """The text at a place within an object; empty if there is none."""
    value: Any = item
    for name in path:
        value = value.get(name) if isinstance(value, Mapping) else None
    return value.strip() if isinstance(value, str) else ""


def items(item: Item, *path: str) -> list[Item]:
    """The objects of a list within an object."""
    value: Any = item
    for name in path:
        value = value.get(name) if isinstance(value, Mapping) else None
    return [it for it in value if isinstance(it, Mapping)] if isinstance(value, list) else []


def shortened(words: str) -> str:
    """A stranger's words to show: one line, and not too long."""
    shown = terminal.line(words[:LONGEST])
    return shown if len(words) <= LONGEST else f"{shown}… ({len(words) - LONGEST:,} characters more)"


@dataclass(frozen=True)
class Licence:
    """`is_spdx`: the text is an expression of SPDX. `place`: where the licence's text is, as the SBOM says."""

    text: str
    is_spdx: bool
    place: str = ""


@dataclass(frozen=True)
class Component:
    content: Item

    @property
    def ref(self) -> str:
        return text(self.content, "bom-ref")

    @property
    def name(self) -> str:
        return text(self.content, "name")

    @property
    def version(self) -> str:
        return text(self.content, "version")

    @property
    def type(self) -> str:
        return text(self.content, "type")

    @property
    def title(self) -> str:
        return shortened(f"{self.name or 'without a name'} {self.version}".strip())

    @cached_property
    def purl(self) -> PackageURL | None:
        try:
            return PackageURL.from_string(text(self.content, "purl"))
        except ValueError:
            return None

    @cached_property
    def properties(self) -> dict[str, str]:
        return {text(it, "name"): text(it, "value") for it in items(self.content, "properties")}

    @property
    def suppliers(self) -> list[Item]:
        """Who made or brought it, the first that counts first."""
        ones = [it for name in ("manufacturer", "supplier") if isinstance(it := self.content.get(name), Mapping)]
        return [*ones, *items(self.content, "authors")]

    @cached_property
    def licences(self) -> list[Licence]:
        return [*filter(lambda it: it.text, map(_licence, items(self.content, "licenses")[:MOST]))]

    @property
    def hashes(self) -> dict[str, str]:
        return {text(it, "alg"): text(it, "content") for it in items(self.content, "hashes")[:MOST]}


def _licence(entry: Item) -> Licence:
    if expression := text(entry, "expression"):
        return Licence(expression, True)
    place = text(entry, "license", "url")
    if identifier := text(entry, "license", "id"):
        return Licence(identifier, True, place)
    return Licence(text(entry, "license", "name"), False, place)


@dataclass(frozen=True)
class Bill:
    """An SBOM in CycloneDX."""

    content: Item

    @classmethod
    def of(cls, data: bytes) -> Bill:
        """Raises ValueError if it is no JSON object."""
        value = untrusted.json_value(data, LARGEST)
        if not isinstance(value, dict):
            raise ValueError("it is no JSON object")
        return cls(value)

    @cached_property
    def components(self) -> list[Component]:
        return [Component(it) for it in items(self.content, "components")]

    @cached_property
    def needs(self) -> dict[str, Sequence[str]]:
        """What each component needs, by their `bom-ref`."""
        return {text(it, "ref"): _texts(it.get("dependsOn")) for it in items(self.content, "dependencies")}

    @cached_property
    def complete(self) -> frozenset[str]:
        """The components of which the SBOM says how complete the list of their needs is."""
        judged = (it for it in items(self.content, "compositions") if text(it, "aggregate"))
        return frozenset(ref for it in judged for ref in _texts(it.get("dependencies")))

    @property
    def image(self) -> str:
        """The `bom-ref` of the image itself."""
        return text(self.content, "metadata", "component", "bom-ref")


def _texts(value: Any) -> Sequence[str]:
    return [it for it in value if isinstance(it, str)] if isinstance(value, list) else []


def counted_by(words: Iterable[str]) -> Iterator[tuple[str, int]]:
    """Each word and how often it is there, the most frequent first."""
    counts: dict[str, int] = {}
    for word in words:
        counts[word] = counts.get(word, 0) + 1
    yield from sorted(counts.items(), key=lambda item: (-item[1], item[0]))
