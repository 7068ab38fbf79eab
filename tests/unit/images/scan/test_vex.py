"""VEX: each verdict under its own name, so that other scanners drop what does not matter, and nothing else."""

from __future__ import annotations

import base64
import gzip
import json
from pathlib import Path
from typing import Any

import pytest
from cyclonedx.schema import SchemaVersion
from cyclonedx.validation.json import JsonStrictValidator

from fakes.scanning import World, advisory, image, rules
from rosml.images.scan import vex
from rosml.images.scan.judge import Outcome, Scanned
from rosml.images.scan.vex import Statement

IMAGE = f"ghcr.io/me/ros@sha256:{'1' * 64}"
DAY = "2026-11-22T03:00:00Z"
ENTRIES = """\
- {id: CVE-2026-1, package: libc6, status: not_affected, justification: vulnerable_code_not_in_execute_path,
   reason: nobody calls it, expires: 2027-01-31}
- {id: CVE-2026-2, status: fixed, reason: the installed one has the fix, expires: 2027-01-31}
- {id: CVE-2026-3, reason: no newer one for Python 3.8, expires: 2027-01-31}
- {id: CVE-2026-4, reason: no fix yet, action: open no files of strangers, expires: 2027-01-31}
- {id: CVE-2026-5, status: under_investigation, reason: we look at it, expires: 2026-12-01}
"""


@pytest.fixture
def world(tmp_path: Path) -> World:
    advisories = {f"lib{number}": [advisory(f"CVE-2026-{number}")] for number in range(2, 8)}
    advisories |= {name: [advisory("CVE-2026-1")] for name in ("libc6", "libc6-dev")}
    advisories["linux-libc-dev"] = [advisory("CVE-2026-8", "CRITICAL")]
    advisories["lib6"] = [{**advisory("CVE-2026-6", "HIGH", ""), "Status": "will_not_fix"}]
    advisories["lib7"] = [{**advisory("CVE-2026-7", "LOW", ""), "Status": "affected"}]
    return World(tmp_path, advisories=advisories)


def scanned(world: World, ignore: str = ENTRIES) -> Scanned:
    part = world.part("alpha-base", *world.advisories, ros=True)
    return world.run(image("alpha-base", part), rules=rules(ignore)).images[0]


def statements_of(scan: Scanned) -> dict[str, dict[str, Any]]:
    document = json.loads(vex.openvex(IMAGE, vex.statements(scan.findings), DAY))
    return {it["vulnerability"]["name"]: it for it in document["statements"]}


def test_each_verdict_has_its_status(world: World) -> None:
    scan = scanned(world)
    verdicts = [(it.advisory, it.status) for it in vex.statements(scan.findings) if it.advisory == "CVE-2026-1"]
    assert verdicts == [("CVE-2026-1", "affected"), ("CVE-2026-1", "not_affected")], "no entry is for libc6-dev"
    statements = statements_of(scan)
    assert {name: it["status"] for name, it in statements.items()} == {
        "CVE-2026-1": "not_affected",
        "CVE-2026-2": "fixed",
        "CVE-2026-3": "affected",
        "CVE-2026-4": "affected",
        "CVE-2026-5": "under_investigation",
        "CVE-2026-6": "affected",
        "CVE-2026-8": "not_affected",
    }, "that of a low severity is only listed"
    assert statements["CVE-2026-3"]["action_statement"] == "use an image with lib3 2.0 or newer"
    assert statements["CVE-2026-3"]["status_notes"].endswith("Python 3.8; accepted until 2027-01-31")
    assert statements["CVE-2026-4"]["action_statement"] == "open no files of strangers"
    assert "will not fix" in statements["CVE-2026-6"]["action_statement"]
    assert statements["CVE-2026-8"]["justification"] == "vulnerable_code_not_present"
    for it in statements.values():  # as the specification wants it
        assert ("action_statement" in it) == (it["status"] == "affected")
        assert ("justification" in it) == ("impact_statement" in it) == (it["status"] == "not_affected")
    assert (scan.outcome, [it.package for it in scan.failing]) == (Outcome.POLICY_FAILED, ["libc6-dev"])


def test_a_statement_is_about_components_of_one_image(world: World) -> None:
    scan = scanned(world, ENTRIES.replace("package: libc6, ", ""))
    (product,) = statements_of(scan)["CVE-2026-1"]["products"]
    assert product["@id"].replace("%3A", ":") == f"pkg:oci/ros@sha256:{'1' * 64}"
    assert [it["@id"] for it in product["subcomponents"]] == [
        "pkg:deb/debian/libc6-dev@1.0",
        "pkg:deb/debian/libc6@1.0",
    ]


def test_an_epoch_is_written_in_both_ways() -> None:
    statement = Statement(
        advisory="CVE-2026-1", status="fixed", components=["pkg:deb/debian/a@1%3A2.3?arch=all", "none"]
    )
    document = json.loads(vex.openvex(IMAGE, [statement], DAY))
    names = [it["@id"] for it in document["statements"][0]["products"][0]["subcomponents"]]
    assert [name.replace("%3A", ":") for name in names] == [
        "pkg:deb/debian/a@1:2.3",
        "pkg:deb/debian/a@2.3?epoch=1",
        "none",
    ]


def test_cyclonedx_says_the_same(world: World) -> None:
    statements = vex.statements(scanned(world).findings)
    text = vex.in_cyclonedx(IMAGE, statements, DAY).decode()
    assert JsonStrictValidator(SchemaVersion.V1_6).validate_str(text) is None
    states = {it["id"]: it["analysis"]["state"] for it in json.loads(text)["vulnerabilities"]}
    assert states["CVE-2026-2"] == "resolved" and states["CVE-2026-8"] == "not_affected"
    affects = next(it["affects"] for it in json.loads(text)["vulnerabilities"] if it["id"] == "CVE-2026-8")
    assert affects[0]["ref"].endswith("/1#apt%3Alinux-libc-dev%3Aamd64%401.0")


def test_all_findings_can_be_under_investigation(world: World) -> None:
    statements = vex.statements(scanned(world).findings, every=True)
    assert {it.advisory: it.status for it in statements}["CVE-2026-7"] == "under_investigation"


def test_statements_are_handed_over_as_they_are(world: World) -> None:
    statements = vex.statements(scanned(world).findings)
    assert vex.unpacked(vex.packed(statements)) == statements


def packed(content: object) -> str:
    return base64.b64encode(gzip.compress(json.dumps(content).encode(), mtime=0)).decode()


@pytest.mark.parametrize(
    "text",
    [
        "%",
        "aGVsbG8=",
        packed({}),
        packed([{"advisory": "CVE-2026-1", "status": "harmless", "components": []}]),
        packed([{"advisory": "CVE-2026-1", "status": "fixed", "components": [], "more": 1}]),
        base64.b64encode(gzip.compress(b"[" + b" " * vex.LARGEST + b"]", mtime=0)).decode(),
    ],
)
def test_statements_that_are_none(text: str) -> None:
    with pytest.raises(ValueError, match=r"statement|Input|Extra|valid"):
        vex.unpacked(text)
