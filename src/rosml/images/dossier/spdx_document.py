"""An SBOM of CycloneDX as SPDX 2.3, for tools that take only that: https://spdx.github.io/spdx-spec/v2.3/

Everything that SPDX 2.3 has a place for comes along. What it has none for, such as whether a file is executable, is in CycloneDX alone.
"""

from __future__ import annotations

import hashlib
import re
from collections.abc import Iterable, Iterator
from typing import Any

from cyclonedx.spdx import is_expression, is_supported_id

from rosml import __version__
from rosml.images.dossier.bill import Bill, Component, Item, Licence, items, text
from rosml.images.scan import cyclonedx
from rosml.images.scan.deployed import FILENAME
from rosml.registry import oci

NOTHING = "NOASSERTION"

DOCUMENT = "SPDXRef-DOCUMENT"

PURPOSES = {
    "application": "APPLICATION",
    "container": "CONTAINER",
    "file": "FILE",
    "firmware": "FIRMWARE",
    "framework": "FRAMEWORK",
    "library": "LIBRARY",
    "operating-system": "OPERATING-SYSTEM",
}

HASHES = {
    "MD5": ("MD5", 32),
    "SHA-1": ("SHA1", 40),
    "SHA-256": ("SHA256", 64),
    "SHA-384": ("SHA384", 96),
    "SHA-512": ("SHA512", 128),
}
"""SPDX's names of algorithms, and how many digits a hash has."""

SOURCE, SOURCE_VERSION = "aquasecurity:trivy:SrcName", "aquasecurity:trivy:SrcVersion"
"""The properties with the source package of a package of Debian, by which its advisories name it."""

LONGEST_EXPRESSION = 1_000
"""The most characters of an expression. Reading one takes time, which grows faster than its length."""

LONGEST_TEXT = 20_000
"""The most characters of a licence that has no identifier."""


def document(bill: Bill, reference: str) -> bytes:
    """The same SBOM gives the same bytes. `reference` is the image's, with its digest."""
    image = Component({"name": reference, "type": "container", **_object(bill.content, "metadata", "component")})
    names = _Names()
    licences = dict[str, Item]()
    subject = names.of(image)
    packages = [_package(image, subject, licences)]
    refs = {bill.image: subject}
    for component in bill.components:
        name = names.of(component)
        refs.setdefault(component.ref, name)
        packages.append(_package(component, name, licences))
    content = {
        "spdxVersion": "SPDX-2.3",
        "dataLicense": "CC0-1.0",
        "SPDXID": DOCUMENT,
        "name": reference,
        "documentNamespace": f"https://rosml.invalid/spdx/{hashlib.sha256(oci.encoded(bill.content)).hexdigest()}",
        "creationInfo": {"created": _time(bill), "creators": [*_creators(bill)]},
        "packages": packages,
        "relationships": [_relation(DOCUMENT, "DESCRIBES", subject), *_relations(bill, refs, subject)],
        **({"hasExtractedLicensingInfos": [licences[name] for name in sorted(licences)]} if licences else {}),
    }
    return oci.encoded(content)


def _object(item: Item, *path: str) -> Item:
    value: Any = item
    for name in path:
        value = value.get(name) if isinstance(value, dict) else None
    return value if isinstance(value, dict) else {}


class _Names:
    """Identifiers of packages, each given once."""

    def __init__(self) -> None:
        self._taken = dict[str, int]()  # how many have had each

    def of(self, component: Component) -> str:
        """Readers tell an operating system by the beginning of its identifier."""
        kinds = {"operating-system": "OperatingSystem", "container": "ContainerImage"}
        words = (kinds.get(component.type, "Package"), component.ref or component.name)
        name = "SPDXRef-" + "-".join(re.sub(r"[^A-Za-z0-9.]+", "-", word)[:200].strip("-") or "none" for word in words)
        new, number = name, self._taken.get(name, 0) + 1
        while new in self._taken:
            number += 1
            new = f"{name}-{number}"
        self._taken |= {name: number, new: 1}
        return new


def _time(bill: Bill) -> str:
    """In SPDX's form, which has whole seconds and a Z."""
    time = cyclonedx.moment(text(bill.content, "metadata", "timestamp"))
    return f"{time.replace(tzinfo=None).isoformat(timespec='seconds')}Z"


def _creators(bill: Bill) -> Iterator[str]:
    yield f"Tool: rosml-{__version__}"
    yield from (f"Organization: {name}" for it in items(bill.content, "metadata", "authors") if (name := _entity(it)))


def _entity(entity: Item) -> str:
    """A name, and an address in brackets, which SPDX reads: `name (me@example.com)`."""
    contacts = entity.get("contact")
    contacts = contacts if isinstance(contacts, list) else []
    addresses = [text(it, "email") for it in (entity, *contacts) if isinstance(it, dict)]
    name = re.sub(r"[()\s]+", " ", text(entity, "name")).strip()
    address = next((re.sub(r"[()\s]+", "", it) for it in addresses if it), "")
    return f"{name} ({address})" if name and address else name or address


def _package(component: Component, name: str, licences: dict[str, Item]) -> dict[str, Any]:
    """`licences` grows by those that SPDX has no identifier for."""
    supplier = next(filter(None, map(_entity, component.suppliers)), "")
    source = component.properties.get(SOURCE, "")
    checksums = [
        {"algorithm": HASHES[kind][0], "checksumValue": value.lower()}
        for kind, value in sorted(component.hashes.items())
        if kind in HASHES and len(value) == HASHES[kind][1] and re.fullmatch(r"[0-9a-fA-F]+", value)
    ]
    optional = {
        "versionInfo": component.version,
        "packageFileName": component.properties.get(FILENAME, ""),
        "primaryPackagePurpose": PURPOSES.get(component.type, "OTHER"),
        "checksums": checksums,
        "externalRefs": [_reference(purl.to_string())] if (purl := component.purl) else [],
        "sourceInfo": f"built package from: {source} {component.properties.get(SOURCE_VERSION, '')}" if source else "",
    }
    return {
        "SPDXID": name,
        "name": component.name or "none",
        "downloadLocation": NOTHING,
        "filesAnalyzed": False,
        "supplier": f"Organization: {supplier}" if supplier else NOTHING,
        "licenseConcluded": NOTHING,
        "licenseDeclared": _expression(component, licences),
        "copyrightText": NOTHING,
        **{key: value for key, value in optional.items() if value},
    }


def _reference(purl: str) -> dict[str, str]:
    return {"referenceCategory": "PACKAGE-MANAGER", "referenceType": "purl", "referenceLocator": purl}


# ---- Licences --------------------------------------------------------------------------------------------------------


def _expression(component: Component, licences: dict[str, Item]) -> str:
    terms = []
    for licence in component.licences:
        if _is_spdx(licence):
            terms.append(f"({licence.text})" if " " in licence.text and len(component.licences) > 1 else licence.text)
            continue
        extracted = _extracted(licence)
        terms.append(extracted["licenseId"])
        licences[extracted["licenseId"]] = extracted
    return " AND ".join(dict.fromkeys(terms)) or NOTHING


def _is_spdx(licence: Licence) -> bool:
    """An expression with a `LicenseRef-` of the SBOM's own is none here: SPDX asks for its text."""
    if not licence.is_spdx or len(licence.text) > LONGEST_EXPRESSION or "Ref-" in licence.text:
        return False
    return is_supported_id(licence.text) or is_expression(licence.text)


def _extracted(licence: Licence) -> dict[str, Any]:
    words = licence.text[:LONGEST_TEXT]
    readable = re.sub(r"[^A-Za-z0-9.]+", "-", words)[:40].strip("-")
    place = f"\nIts text is at {licence.place} in the image." if licence.place else ""
    key = hashlib.sha256(f"{licence.text}\n{licence.place}".encode()).hexdigest()[:12]
    return {
        "licenseId": f"LicenseRef-{'-'.join(filter(None, (readable, key)))}",
        "name": re.sub(r"\s+", " ", words)[:200],
        "extractedText": f"{words}{place}",
    }


# ---- Relations -------------------------------------------------------------------------------------------------------


def _relations(bill: Bill, refs: dict[str, str], subject: str) -> Iterator[dict[str, str]]:
    """The image contains all components; these depend on each other."""
    for name in dict.fromkeys(refs.values()):
        if name != subject:
            yield _relation(subject, "CONTAINS", name)
    for ref, needed in bill.needs.items():
        if ref in refs and refs[ref] != subject:
            yield from (_relation(refs[ref], "DEPENDS_ON", name) for name in _targets(needed, refs))


def _targets(needed: Iterable[str], refs: dict[str, str]) -> Iterator[str]:
    return (refs[ref] for ref in dict.fromkeys(needed) if ref in refs)


def _relation(source: str, kind: str, target: str) -> dict[str, str]:
    return {"spdxElementId": source, "relationshipType": kind, "relatedSpdxElement": target}
