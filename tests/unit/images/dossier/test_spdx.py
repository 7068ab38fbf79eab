"""The same SBOM in SPDX 2.3."""

from __future__ import annotations

import json
import re
import time
from typing import Any

import pytest

from fakes.dossiers import HOSTILE, ROBOT, components, contents
from rosml.images.dossier import spdx_document
from rosml.images.dossier.bill import Bill
from rosml.images.scan import cyclonedx

REFERENCE = "registry.example/me/robot@sha256:0"


def converted(document: dict[str, Any]) -> dict[str, Any]:
    value: dict[str, Any] = json.loads(spdx_document.document(Bill(document), REFERENCE))
    return value


@pytest.fixture(scope="module")
def robot() -> dict[str, Any]:
    return converted(json.loads(cyclonedx.document(contents(ROBOT), REFERENCE, 1_700_000_000.0)))


def require_sound(document: dict[str, Any]) -> None:
    """What the specification asks for, and a schema or a reader checks: https://spdx.github.io/spdx-spec/v2.3/"""
    assert (document["spdxVersion"], document["dataLicense"]) == ("SPDX-2.3", "CC0-1.0")
    assert document["SPDXID"] == "SPDXRef-DOCUMENT" and "#" not in document["documentNamespace"]
    assert re.fullmatch(r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ", document["creationInfo"]["created"])
    assert all(re.match("(Tool|Organization|Person): ", it) for it in document["creationInfo"]["creators"])
    names = [it["SPDXID"] for it in document["packages"]]
    assert len({*names}) == len(names) and all(re.fullmatch(r"SPDXRef-[A-Za-z0-9.-]+", name) for name in names)
    extracted = {it["licenseId"] for it in document.get("hasExtractedLicensingInfos", ())}
    assert all(re.fullmatch(r"LicenseRef-[A-Za-z0-9.-]+", name) for name in extracted)
    for package in document["packages"]:
        assert package["name"] and package["downloadLocation"] == "NOASSERTION" and package["filesAnalyzed"] is False
        assert {*re.findall(r"LicenseRef-[A-Za-z0-9.-]+", package["licenseDeclared"])} <= extracted
        for checksum in package.get("checksums", ()):
            assert (checksum["algorithm"], len(checksum["checksumValue"])) in spdx_document.HASHES.values()
    for relation in document["relationships"]:
        assert {relation["spdxElementId"], relation["relatedSpdxElement"]} <= {*names, "SPDXRef-DOCUMENT"}


def by_name(document: dict[str, Any]) -> dict[str, dict[str, Any]]:
    return {it["name"]: it for it in document["packages"]}


def test_packages_have_what_cyclonedx_says(robot: dict[str, Any]) -> None:
    require_sound(robot)
    bash, numpy = by_name(robot)["bash"], by_name(robot)["numpy"]
    assert bash["versionInfo"] == "5.2.15-2" and bash["packageFileName"] == "bash_5.2.15-2_amd64.deb"
    assert bash["supplier"] == "Organization: bash (bash@d.org)" and bash["licenseDeclared"] == "GPL-3.0-or-later"
    assert bash["externalRefs"][0]["referenceLocator"].startswith("pkg:deb/debian/bash@5.2.15-2?")
    assert by_name(robot)["libc6"]["sourceInfo"] == "built package from: glibc 2.36-9"
    assert numpy["supplier"] == "Organization: Travis" and numpy["licenseDeclared"].startswith("LicenseRef-")
    assert by_name(robot)["debian"]["primaryPackagePurpose"] == "OPERATING-SYSTEM"
    assert robot["documentNamespace"] == robot["documentNamespace"].lower() and robot["name"] == REFERENCE


def test_relations_are_those_of_cyclonedx(robot: dict[str, Any]) -> None:
    ids = {it["name"]: it["SPDXID"] for it in robot["packages"]}
    relations = {
        (it["spdxElementId"], it["relationshipType"], it["relatedSpdxElement"]) for it in robot["relationships"]
    }
    image = ids[REFERENCE]
    assert ("SPDXRef-DOCUMENT", "DESCRIBES", image) in relations
    assert {(image, "CONTAINS", name) for name in ids.values() if name != image} <= relations
    assert (ids["bash"], "DEPENDS_ON", ids["libc6"]) in relations and (
        ids["torch"],
        "DEPENDS_ON",
        ids["numpy"],
    ) in relations


@pytest.mark.parametrize(
    ("licenses", "expected"),
    [
        ([], "NOASSERTION"),
        ([{"license": {"id": "MIT"}}, {"license": {"id": "Apache-2.0"}}], "MIT AND Apache-2.0"),
        ([{"expression": "MIT OR Apache-2.0"}, {"license": {"id": "ISC"}}], "(MIT OR Apache-2.0) AND ISC"),
        ([{"expression": "GPL-2.0-only WITH Classpath-exception-2.0"}], "GPL-2.0-only WITH Classpath-exception-2.0"),
        ([{"license": {"id": "no identifier"}}], "LicenseRef-no-identifier-*"),
        ([{"expression": "MIT AND LicenseRef-theirs"}], "LicenseRef-MIT-AND-LicenseRef-theirs-*"),
        ([{"license": {"name": "as its copyright file says", "url": "file:///x"}}], "LicenseRef-as-its-copyright-file-says-*"),
        ([{"license": {"name": "许可"}}], "LicenseRef-*"),
    ],
)  # fmt: skip
def test_licences(licenses: list[Any], expected: str) -> None:
    document = converted(components({"name": "a", "type": "library", "licenses": licenses}))
    require_sound(document)
    declared = by_name(document)["a"]["licenseDeclared"]
    assert re.fullmatch(re.escape(expected).replace(r"\*", "[0-9a-f]{12}"), declared), declared
    for item in document.get("hasExtractedLicensingInfos", ()):
        assert item["extractedText"]


def test_two_licences_of_one_name_at_other_places() -> None:
    licences = [{"license": {"name": "own", "url": f"file:///usr/share/doc/{name}/copyright"}} for name in "ab"]
    document = converted(components(*({"name": "x", "licenses": [it]} for it in licences)))
    require_sound(document)
    texts = sorted(it["extractedText"] for it in document["hasExtractedLicensingInfos"])
    assert texts == [f"own\nIts text is at file:///usr/share/doc/{name}/copyright in the image." for name in "ab"]


def test_bad_input() -> None:
    """None of it stops the conversion, and all of it stays text."""
    long = "x AND (" * 1_500 + HOSTILE
    odd = [
        {"name": "a", "type": "library", "licenses": [{"expression": long}]},
        {"name": HOSTILE, "bom-ref": "b/../b", "purl": "none at all", "hashes": [{"alg": "SHA-512", "content": "00"}]},
        {"bom-ref": "b\\b", "type": [], "supplier": "Ada", "authors": [{"name": 3}, "x"]},
        {},
    ]
    needs = [{"ref": "b/../b", "dependsOn": ["b\\b", "nothing", 3]}, {"ref": 1}, "x"]
    started = time.monotonic()
    document = converted(components(*odd, dependencies=needs))
    same = [{"bom-ref": "x", "name": "x"}] * 20_000
    for authors in (True, 3, {"name": "x"}, "x", [3, {"name": 3}]):
        content = {"metadata": {"authors": authors, "timestamp": "2026-01-01T01:00:00+01:00"}, "components": same}
        facts = json.loads(spdx_document.document(Bill(content), REFERENCE))
        assert (
            facts["creationInfo"]["created"] == "2026-01-01T00:00:00Z" and len(facts["creationInfo"]["creators"]) == 1
        )
        assert len({it["SPDXID"] for it in facts["packages"]}) == len(facts["packages"]) == len(same) + 1
        same = same[:2]
    assert time.monotonic() - started < 5
    require_sound(document)
    assert [it["SPDXID"] for it in document["packages"][2:4]] == ["SPDXRef-Package-b-..-b", "SPDXRef-Package-b-b"]
    assert "versionInfo" not in document["packages"][1] and "checksums" not in document["packages"][2]
    assert document["hasExtractedLicensingInfos"][0]["extractedText"] == long
    assert document["creationInfo"]["created"] == "1970-01-01T00:00:00Z"


def test_the_same_bytes_again() -> None:
    document = components({"name": "a", "licenses": [{"license": {"name": "own"}}]})
    assert spdx_document.document(Bill(document), REFERENCE) == spdx_document.document(Bill(document), REFERENCE)
