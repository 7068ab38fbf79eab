"""How many components of an SBOM have each field that two lists ask for, and why others lack it.

- NTIA: The Minimum Elements For a Software Bill of Materials, 2021-07-12:
  https://www.ntia.gov/report/2021/minimum-elements-software-bill-materials-sbom
- BSI: TR-03183-2 version 2.1.0, 2025-08-20, sections 5.2.1 to 5.2.4: https://www.bsi.bund.de/dok/TR-03183-en. Its properties in
  CycloneDX: https://github.com/BSI-Bund/tr-03183-cyclonedx-property-taxonomy
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import asdict, dataclass
from typing import Any

from rosml.images.dossier.bill import REASONS, Bill, Component, counted_by, items, shortened, text

NTIA, BSI = "NTIA", "BSI"
BOTH = (NTIA, BSI)

NO_REASON = "the SBOM gives no reason"

EXAMPLES = 3
"""As many components are named for each reason."""


@dataclass(frozen=True)
class Lack:
    """Components that lack a field, for one reason."""

    reason: str
    number: int
    examples: tuple[str, ...]


@dataclass(frozen=True)
class Field:
    """`optional`: the list asks for it only if there is such a thing."""

    name: str
    lists: tuple[str, ...]
    have: int
    of: int
    optional: bool = False
    lacks: tuple[Lack, ...] = ()

    @property
    def percent(self) -> str:
        """Rounded down, so that 100 % are all."""
        return f"{self.have * 100 // self.of} %" if self.of else "-"

    @property
    def why(self) -> str:
        return "; ".join(f"{it.number}: {it.reason} (such as {', '.join(it.examples)})" for it in self.lacks)

    def to_json(self) -> dict[str, Any]:
        return asdict(self)


@dataclass(frozen=True)
class _Asked:
    """`lacks` says why a component lacks the field; it is empty if the component has it. `key` names the property with a better reason."""

    name: str
    lists: tuple[str, ...]
    lacks: Callable[[Bill, Component], str]
    key: str = ""
    optional: bool = False


def check(bill: Bill) -> tuple[Field, ...]:
    """The fields of both lists: those of the SBOM itself, then those of each component."""
    return (*_of_document(bill), *(_counted(bill, question) for question in _FIELDS))


def _counted(bill: Bill, question: _Asked) -> Field:
    reasons = dict[str, list[str]]()
    for component in bill.components:
        if why := question.lacks(bill, component):
            better = component.properties.get(f"{REASONS}{question.key}", "") if question.key else ""
            reasons.setdefault(shortened(better) or why, []).append(component.title)
    lacks = tuple(
        Lack(reason, number, tuple(reasons[reason][:EXAMPLES]))
        for reason, number in counted_by(reason for reason, names in reasons.items() for _ in names)
    )
    whole = len(bill.components)
    return Field(question.name, question.lists, whole - sum(it.number for it in lacks), whole, question.optional, lacks)


# ---- Of the SBOM -----------------------------------------------------------------------------------------------------


def _of_document(bill: Bill) -> Iterator[Field]:
    about = bill.content.get("metadata")
    about = about if isinstance(about, dict) else {}
    authors = [*items(about, "authors"), *(it for it in (about.get("manufacturer"),) if isinstance(it, dict))]
    has_name = any(text(it, "name") for it in authors)
    address = any(map(_address, authors))
    yield _single("author of the SBOM", (NTIA,), has_name or address, "it names none")
    yield _single("creator of the SBOM, by e-mail or URL", (BSI,), address, "the publisher named no address")
    yield _single("time of the SBOM", BOTH, bool(text(about, "timestamp")), "it has none")
    serial = bool(text(bill.content, "serialNumber"))
    yield _single("URI of the SBOM", (BSI,), serial, "it has no serial number", optional=True)


def _single(name: str, lists: tuple[str, ...], present: bool, why: str, optional: bool = False) -> Field:
    lacks = () if present else (Lack(why, 1, ("the SBOM itself",)),)
    return Field(name, lists, int(present), 1, optional, lacks)


# ---- Of a component --------------------------------------------------------------------------------------------------


def _address(entity: Any) -> bool:
    """Whether an entity has an e-mail address or a URL."""
    urls = entity.get("url")
    contacts = (entity, *items(entity, "contact"))
    return bool(urls) or any("@" in text(it, "email") + text(it, "name") for it in contacts)


def _supplier(_bill: Bill, component: Component) -> str:
    names = [it for it in component.suppliers if text(it, "name") or _address(it)]
    return "" if names else "its metadata names nobody"


def _creator(_bill: Bill, component: Component) -> str:
    if any(map(_address, component.suppliers)):
        return ""
    return _supplier(_bill, component) or "its metadata names its maker without an address"


def _name(_bill: Bill, component: Component) -> str:
    return "" if component.name else "it has none"


def _version(_bill: Bill, component: Component) -> str:
    return "" if component.version else "its metadata has no version"


def _identifier(_bill: Bill, component: Component) -> str:
    if component.purl or text(component.content, "cpe"):
        return ""
    if text(component.content, "purl"):
        return "its package URL is none"
    return "an operating system has no package URL" if component.type == "operating-system" else NO_REASON


def _dependencies(bill: Bill, component: Component) -> str:
    return "" if component.ref in bill.needs else "the SBOM does not say what it needs"


def _dependencies_complete(bill: Bill, component: Component) -> str:
    if why := _dependencies(bill, component):
        return why
    return "" if component.ref in bill.complete else "the SBOM does not say whether the list is complete"


def _licence(_bill: Bill, component: Component) -> str:
    if component.licences:
        return ""
    system = component.type == "operating-system"
    return "its packages have theirs" if system else "its metadata names no licence"


def _hash(_bill: Bill, component: Component) -> str:
    hashes = component.hashes
    if "SHA-512" in hashes:
        return ""
    if hashes:
        return f"its source publishes {' and '.join(sorted(hashes))} alone"
    system = component.type == "operating-system"
    return "an operating system is no file" if system else NO_REASON


def _property(name: str, of_system: str = "") -> Callable[[Bill, Component], str]:
    """The lack of one of BSI's properties."""

    def lacks(_bill: Bill, component: Component) -> str:
        if component.properties.get(f"bsi:component:{name}"):
            return ""
        return of_system if of_system and component.type == "operating-system" else NO_REASON

    return lacks


def _reference(why: str, *kinds: str) -> Callable[[Bill, Component], str]:
    def lacks(_bill: Bill, component: Component) -> str:
        present = {text(it, "type") for it in items(component.content, "externalReferences")}
        return "" if present & {*kinds} else why

    return lacks


_FILE = "an operating system is no file"

_FIELDS: Sequence[_Asked] = (
    _Asked("supplier", (NTIA,), _supplier, "supplier"),
    _Asked("creator, by e-mail or URL", (BSI,), _creator, "creator"),
    _Asked("name", BOTH, _name),
    _Asked("version", BOTH, _version, "version"),
    _Asked("other unique identifier", BOTH, _identifier, "purl"),
    _Asked("dependencies", (NTIA,), _dependencies, "dependencies"),
    _Asked("dependencies, and whether they are complete", (BSI,), _dependencies_complete, "dependencies"),
    _Asked("file name", (BSI,), _property("filename", _FILE), "filename"),
    _Asked("distribution licences", (BSI,), _licence, "licence"),
    _Asked("hash of what was deployed, SHA-512", (BSI,), _hash, "hash"),
    _Asked("executable property", (BSI,), _property("executable", _FILE), "executable"),
    _Asked("archive property", (BSI,), _property("archive", _FILE), "archive"),
    _Asked("structured property", (BSI,), _property("structured", _FILE), "structured"),
    _Asked(
        "URI of the source code",
        (BSI,),
        _reference("rosml does not look for it", "source-distribution", "vcs"),
        "source",
        optional=True,
    ),
    _Asked(
        "URI of what was deployed",
        (BSI,),
        _reference("its metadata names none", "distribution"),
        "distribution",
        optional=True,
    ),
)


def rows(fields: Iterable[Field]) -> Iterator[tuple[str, str, str, str, str]]:
    """For a table with the columns of `COLUMNS`."""
    for it in fields:
        asks = f"{' and '.join(it.lists)}{', if there is one' if it.optional else ''}"
        yield it.name, asks, f"{it.have:,} of {it.of:,}", it.percent, it.why


COLUMNS = ("field", "asked by", "have it", "share", "why others lack it")
