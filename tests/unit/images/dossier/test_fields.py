"""How complete an SBOM is."""

from __future__ import annotations

import json
from typing import Any

from cyclonedx.schema import SchemaVersion
from cyclonedx.validation.json import JsonStrictValidator

from fakes.dossiers import ROBOT, components, contents, matrix
from rosml.images.dossier import fields, support
from rosml.images.dossier.bill import REASONS, Bill
from rosml.images.dossier.fields import NO_REASON, Field
from rosml.images.scan import cyclonedx

CREATOR = "creator of the SBOM, by e-mail or URL"

FULL: dict[str, Any] = {
    "bom-ref": "a",
    "type": "library",
    "name": "a",
    "version": "1",
    "purl": "pkg:deb/debian/a@1",
    "supplier": {"name": "Ada", "contact": [{"email": "ada@example.com"}]},
    "licenses": [{"license": {"id": "MIT"}}],
    "hashes": [{"alg": "SHA-512", "content": "00"}],
    "externalReferences": [{"type": "vcs", "url": "https://a"}, {"type": "distribution", "url": "https://b"}],
    "properties": [
        {"name": f"bsi:component:{name}", "value": "x"} for name in ("filename", "executable", "archive", "structured")
    ],
}
ABOUT = {
    "component": {"bom-ref": "image"},
    "timestamp": "2026-11-29T12:00:00Z",
    "authors": [{"name": "us", "email": "us@example.com"}],
}


def checked(*items: dict[str, Any], **more: Any) -> dict[str, Field]:
    return {f"{it.name} {it.lists}": it for it in fields.check(Bill(components(*items, **more)))}


def one(name: str, *items: dict[str, Any], **more: Any) -> Field:
    return next(it for key, it in checked(*items, **more).items() if key.startswith(name))


def test_a_component_can_have_all_fields() -> None:
    needs = [{"ref": "a", "dependsOn": []}]
    compositions = [{"aggregate": "complete", "dependencies": ["a"]}]
    whole = {"metadata": ABOUT, "serialNumber": "urn:uuid:1", "dependencies": needs, "compositions": compositions}
    lacking = {name: it.why for name, it in checked(FULL, **whole).items() if it.have < it.of}
    assert lacking == {}
    assert {it.percent for it in checked(FULL, **whole).values()} == {"100 %"}


def test_without_anything_each_field_says_why() -> None:
    every = checked({"type": "library"})
    assert all(it.have == 0 and it.lacks and it.lacks[0].reason for it in every.values())
    assert {it.percent for it in every.values()} == {"0 %"}


def test_a_reason_by_name_counts_more_than_ours() -> None:
    reasoned = {**FULL, "hashes": [], "properties": [{"name": f"{REASONS}hash", "value": "built in the image"}]}
    other = {**FULL, "hashes": [], "properties": []}
    weaker = {**FULL, "hashes": [{"alg": "SHA-256", "content": "00"}]}
    field = one("hash", reasoned, reasoned, other, weaker, FULL)
    assert (field.have, field.of, field.percent) == (1, 5, "20 %")
    assert [(it.reason, it.number) for it in field.lacks] == [
        ("built in the image", 2),
        ("its source publishes SHA-256 alone", 1),
        (NO_REASON, 1),
    ]


def test_a_hundred_percent_are_all() -> None:
    field = one("version", *([FULL] * 999), {**FULL, "version": ""})
    assert (field.percent, field.why) == ("99 %", "1: its metadata has no version (such as a)")


def test_a_package_url_that_is_none() -> None:
    assert one("other", {**FULL, "purl": "nonsense"}).why == "1: its package URL is none (such as a 1)"
    assert one("other", {**FULL, "purl": ["pkg:deb/a@1"]}).have == 0


def test_odd_types_count_as_what_is_not_there() -> None:
    odd = {"name": 1, "version": {}, "licenses": "MIT", "hashes": {}, "properties": [1, {"name": []}], "supplier": 3}
    wrong = {"metadata": [], "dependencies": {"ref": "a"}, "compositions": [None], "serialNumber": 7}
    assert all(it.have == 0 for it in checked(odd, **wrong).values())


def test_what_rosml_writes_of_each_package() -> None:
    """What an SBOM of ours has in any case."""
    reference, created = "x/robot@sha256:0", 1_700_000_000.0
    document = json.loads(cyclonedx.document(contents(ROBOT), reference, created))
    every = {it.name: it for it in fields.check(Bill(document))}
    assert "named no address" in every[CREATOR].why
    content = cyclonedx.joined(reference, created, [], "https://example.org/robots")
    assert {it.name: it for it in fields.check(Bill(json.loads(content)))}[CREATOR].have == 1
    assert JsonStrictValidator(SchemaVersion.V1_6).validate_str(content.decode()) is None
    assert every["time of the SBOM"].have == every["author of the SBOM"].have == 1
    for name in ("name", "version"):
        assert every[name].percent == "100 %", every[name].why
    assert every["other unique identifier"].why == "1: an operating system has no package URL (such as debian 12)"
    assert every["dependencies"].of == len(contents(ROBOT).apt) + len(contents().python) + 2


def test_words_of_strangers_are_one_line_each() -> None:
    """With more, they could look like words of the command that prints them."""
    odd = {"name": "python3", "version": "3.11\n\nerror: x", "purl": "pkg:deb/debian/python3"}
    reason = {"name": f"{REASONS}hash", "value": "why\n" * 9999}
    bill = Bill({"components": [{**odd, "type": "library", "properties": [reason]}]})
    ends = support.ends(bill.components, "jazzy\nerror: x", matrix())
    lines = [*(it.version for it in ends), *(it.why for it in fields.check(bill)), bill.components[0].title]
    assert len(ends) == 2 and all("\n" not in line and len(line) < 1000 for line in lines)
