"""VEX: what the policy and the distribution say of an image's findings, for scanners of other people.

OpenVEX 0.2.0 (https://github.com/openvex/spec/blob/main/OPENVEX-SPEC.md), and the same statements in CycloneDX 1.6.
"""

from __future__ import annotations

import base64
import gzip
import hashlib
import uuid
from collections import defaultdict
from collections.abc import Iterable, Sequence
from typing import Annotated, Any, Literal
from urllib.parse import quote

from packageurl import PackageURL
from pydantic import ConfigDict, Field

from rosml import __version__
from rosml.base import archives, untrusted
from rosml.base.errors import RosmlError
from rosml.base.shapes import Shape, adapter
from rosml.images.records.store import CREATED
from rosml.images.scan import cyclonedx
from rosml.images.scan.judge import Finding
from rosml.images.scan.policy import ADVISORY, Justification, Status
from rosml.registry import oci
from rosml.registry.client import Registry

MEDIA_TYPE = "application/vnd.openvex+json"
"""The media type of an OpenVEX document; also the type of the artifact."""

CONTEXT = "https://openvex.dev/ns/v0.2.0"

HARMLESS: tuple[Status, ...] = ("not_affected", "fixed")
"""What lets a scanner drop a finding."""

LARGEST = 32 << 20
"""The most bytes of statements, unpacked. An image with thousands of findings has one."""

Text = Annotated[str, Field(max_length=1000)]


class Statement(Shape):
    """What is said of one vulnerability in components of an image."""

    model_config = ConfigDict(frozen=True, strict=True, extra="forbid")

    advisory: Annotated[str, Field(pattern=ADVISORY, max_length=64)]
    status: Status
    justification: Justification | Literal[""] = ""
    reason: Text = ""
    action: Text = ""
    components: list[Text]
    """Package URLs; none if it is about the whole image."""
    refs: list[Text] = []
    """The same components in the image's SBOM."""

    @property
    def is_harmless(self) -> bool:
        return self.status in HARMLESS


_STATEMENTS = adapter(list[Statement])


def statements(findings: Iterable[Finding], every: bool = False) -> list[Statement]:
    """What was judged of an image's findings, a statement for each advisory and verdict. `every`: the others are under investigation."""
    groups = defaultdict[tuple[str, ...], dict[str, Finding]](dict)
    for it in findings:
        if it.purl and (it.status or every):
            reason = it.ignored + (f"; accepted until {it.until}" if it.until and it.status == "affected" else "")
            key = (it.id, it.status or "under_investigation", it.justification, reason, it.action)
            groups[key][it.purl] = it
    names = ("advisory", "status", "justification", "reason", "action")
    return [
        Statement.model_validate(
            dict(zip(names, (text[:1000] for text in key), strict=True))
            | {"components": sorted(group), "refs": sorted({it.ref for it in group.values() if it.ref})}
        )
        for key, group in sorted(groups.items())
    ]


def packed(judged: Sequence[Statement]) -> str:
    """Statements as one word, for a file with those of many images."""
    return base64.b64encode(gzip.compress(_STATEMENTS.dump_json([*judged]), mtime=0)).decode()


def unpacked(text: str) -> list[Statement]:
    """Statements of `packed`. ValueError if they are none, or too many."""
    try:
        data = archives.gunzipped(base64.b64decode(text, validate=True), LARGEST)
    except ValueError:  # also of base64
        raise ValueError("its statements of VEX are damaged, or too many") from None
    return _STATEMENTS.validate_json(untrusted.json_text(data, LARGEST))


def digest(judged: Sequence[Statement]) -> str:
    """Which statements these are; empty if there are none."""
    return hashlib.sha256(_STATEMENTS.dump_json([*judged])).hexdigest() if judged else ""


def openvex(reference: str, judged: Sequence[Statement], date: str) -> bytes:
    """Statements about an image as OpenVEX.

    Args:
        reference: of the image, with its digest.
        date: when they were made, as a run's date.
    """
    repository, _, image = reference.partition("@")
    return oci.encoded(
        {
            "@context": CONTEXT,
            "@id": f"https://rosml.invalid/vex/{image.partition(':')[2]}/{digest(judged)}",
            "author": f"the publisher of {repository}",
            "timestamp": date,
            "version": 1,
            "tooling": f"rosml {__version__}",
            "statements": [_written(product(reference), it) for it in judged],
        }
    )


def product(reference: str) -> str:
    """The package URL of an image. Without a registry, so that it is the same image in a mirror."""
    repository, _, image = reference.partition("@")
    return PackageURL("oci", None, repository.rpartition("/")[2], image).to_string()


def _written(image: str, statement: Statement) -> dict[str, Any]:
    subcomponents = [{"@id": name} for purl in statement.components for name in _names(purl)]
    about = {"@id": image, **({"subcomponents": subcomponents} if subcomponents else {})}
    optional = {
        "status_notes": statement.reason,
        "justification": statement.justification,
        "impact_statement": statement.reason if statement.status == "not_affected" else "",
        "action_statement": statement.action,
    }
    return {
        "vulnerability": {"name": statement.advisory},
        "products": [about],
        "status": statement.status,
        **{name: text for name, text in optional.items() if text},
    }


def _names(purl: str) -> list[str]:
    """A component's package URL without qualifiers, which scanners write in several ways. So they do the epoch of a Debian version."""
    try:
        url = PackageURL.from_string(purl)
    except ValueError:
        return [purl]
    names = [PackageURL(url.type, url.namespace, url.name, url.version).to_string()]
    epoch, colon, version = (url.version or "").partition(":")
    if url.type == "deb" and colon:
        names.append(PackageURL(url.type, url.namespace, url.name, version, {"epoch": epoch}).to_string())
    return names


_STATES = {
    "affected": "exploitable",
    "not_affected": "not_affected",
    "fixed": "resolved",
    "under_investigation": "in_triage",
}
_JUSTIFICATIONS = {
    "component_not_present": "code_not_present",
    "vulnerable_code_not_present": "code_not_present",
    "vulnerable_code_not_in_execute_path": "code_not_reachable",
    "inline_mitigations_already_exist": "protected_by_mitigating_control",
}
"""The words of CycloneDX for those of OpenVEX, if it has one."""


def in_cyclonedx(reference: str, judged: Sequence[Statement], date: str) -> bytes:
    """The same statements as CycloneDX: they name components of the image's SBOM by its serial number."""
    return oci.encoded(
        {
            "bomFormat": "CycloneDX",
            "specVersion": "1.6",
            "serialNumber": uuid.uuid5(uuid.NAMESPACE_URL, f"{reference} {digest(judged)}").urn,
            "version": 1,
            "metadata": {"timestamp": date},
            "vulnerabilities": [_vulnerability(cyclonedx.serial(reference), it) for it in judged],
        }
    )


def _vulnerability(sbom: uuid.UUID, statement: Statement) -> dict[str, Any]:
    analysis = {
        "state": _STATES[statement.status],
        "justification": _JUSTIFICATIONS.get(statement.justification, ""),
        "detail": "; ".join(filter(None, (statement.reason, statement.action))),
    }
    return {
        "id": statement.advisory,
        "analysis": {name: text for name, text in analysis.items() if text},
        "affects": [{"ref": f"urn:cdx:{sbom}/1#{quote(ref, safe='')}"} for ref in statement.refs],
    }


# ---- Reading ---------------------------------------------------------------------------------------------------------


class _Component(Shape):
    id: Text = Field(default="", alias="@id")


class _Product(_Component):
    subcomponents: list[_Component] = []


class _Vulnerability(Shape):
    name: Annotated[str, Field(pattern=ADVISORY, max_length=64)]


class _Statement(Shape):
    """A statement of anybody's OpenVEX, as far as we read it."""

    vulnerability: _Vulnerability
    products: list[_Product] = []
    status: Status
    justification: Justification | Literal[""] = ""
    status_notes: str = ""
    impact_statement: str = ""
    action_statement: str = ""


class _Document(Shape):
    statements: list[_Statement]


MOST = 16
"""The most artifacts of an image that are looked at."""


def read(registry: Registry, repository: str, digest: str) -> tuple[Statement, ...]:
    """The newest VEX that is attached to an image; empty if there is none. Everybody who may push there can attach one.

    Raises RosmlError if it is damaged.
    """
    listed = [entry["digest"] for entry in registry.referrers(repository, digest, MEDIA_TYPE)][:MOST]
    artifacts = [it for name in listed if (it := registry.manifest(repository, name)) and it.layers]
    if not artifacts:
        return ()
    newest = max(artifacts, key=lambda it: it.annotations.get(CREATED, ""))
    content = registry.part(repository, newest.layers[0], LARGEST)
    try:
        document = _Document.model_validate(untrusted.json_value(content, LARGEST))
    except ValueError:
        raise RosmlError(
            f"{repository}@{newest.digest} is no OpenVEX", "delete that artifact in the registry"
        ) from None
    name = product(f"{repository}@{digest}")
    return tuple(
        _judged(it, [component.id for component in about.subcomponents])
        for it in document.statements
        for about in it.products
        if about.id in (name, name.replace("%3A", ":"))
    )


def _judged(statement: _Statement, components: list[str]) -> Statement:
    return Statement(
        advisory=statement.vulnerability.name,
        status=statement.status,
        justification=statement.justification,
        reason=(statement.status_notes or statement.impact_statement)[:1000],
        action=statement.action_statement[:1000],
        components=components,
    )


def about(statements: Iterable[Statement], advisory: str, purl: str) -> Statement | None:
    """What is said of an advisory in a component; None if nothing is."""
    names = {*_names(purl), purl}
    return next((it for it in statements if it.advisory == advisory and names & {*it.components}), None)
