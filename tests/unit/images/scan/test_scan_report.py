"""What people and programs see of a scan."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import pytest

from rosml.cli.images import tables
from rosml.images.scan import sarif as reporting
from rosml.images.scan.judge import Finding, Outcome, Run, Scanned
from rosml.images.scan.trivy import Database

STATE = Database("2026-11-22T00:00:00Z", f"sha256:{'1' * 64}", "example.org/db:2")
TORCH = ("torch", "2.10.0", "2.11.0", "torch-cu1", "python-pkg", "a fault", "u")
FINDINGS = (
    Finding("CVE-2026-2", "critical", *TORCH, fails=True),
    Finding("CVE-2026-1", "high", "libc6", "2.36", "", "alpha-base", "debian", "another"),
    Finding("CVE-2026-1", "high", "libc6-dev", "2.36", "", "alpha-base", "debian", "another"),
    Finding("CVE-2026-3", "low", "bash", "5.2", "5.3", "alpha-base", ignored="not [reachable]"),
)


def scanned(outcome: Outcome = Outcome.POLICY_FAILED, **changes: Any) -> Scanned:
    facts = {"findings": FINDINGS, "packages": 3, "database": STATE, "parts": {"alpha-base": "sha256:a"}, **changes}
    return Scanned("alpha-base-torch-cu1", "amd64", outcome, "a reason", **facts)


def test_sarif() -> None:
    """The parts of SARIF 2.1.0 that viewers need; what is ignored is there, as suppressed."""
    document = reporting.sarif(scanned())
    assert document["version"] == "2.1.0"
    (run,) = document["runs"]
    assert run["automationDetails"] == {"id": "scan/alpha-base-torch-cu1/amd64"}
    rules = {rule["id"]: rule["properties"]["security-severity"] for rule in run["tool"]["driver"]["rules"]}
    assert rules == {"CVE-2026-1": "8.0", "CVE-2026-2": "9.5", "CVE-2026-3": "2.0"}
    results = run["results"]
    assert [result["level"] for result in results] == ["error", "error", "error", "note"]
    assert [result["properties"]["fails"] for result in results] == [True, False, False, False]
    assert results[0]["message"]["text"] == "torch 2.10.0 of torch-cu1: a fault; fixed in 2.11.0"
    assert results[0]["locations"][0]["physicalLocation"]["artifactLocation"]["uri"] == "torch-cu1/torch"
    assert [result["suppressions"][0]["justification"] for result in results[3:]] == ["not [reachable]"]
    assert len({result["partialFingerprints"]["rosml/v1"] for result in results}) == len(results)
    assert run["invocations"][0]["executionSuccessful"]
    assert run["properties"]["database"]["digest"] == STATE.digest


def test_sarif_of_a_scanner_that_failed() -> None:
    """An empty list of results would be good news without it."""
    (run,) = reporting.sarif(scanned(Outcome.SCANNER_FAILED, findings=(), database=None))["runs"]
    assert run["results"] == [] and not run["invocations"][0]["executionSuccessful"]
    assert run["invocations"][0]["toolExecutionNotifications"] == [{"level": "error", "message": {"text": "a reason"}}]


def test_reports_are_written(tmp_path: Path) -> None:
    run = Run((scanned(),))
    sarif, whole = reporting.write(tmp_path / "reports", run)
    assert sarif.name == "alpha-base-torch-cu1.amd64.sarif"
    assert json.loads(sarif.read_text()) == reporting.sarif(run.images[0])
    document = json.loads(whole.read_text())
    assert document["exit_code"] == 3 and len(document["images"][0]["findings"]) == len(FINDINGS)


def test_table(capsys: pytest.CaptureFixture[str]) -> None:
    image = scanned(notes=("alpha-base: a note",))
    tables.print_scan(Run((image, image), ("scan.yaml:6:3: over",)))
    lines = capsys.readouterr().out.splitlines()
    assert lines[0] == "alpha-base-torch-cu1 amd64: policy failed: a reason (3 packages)"
    assert re.split(r"  +", lines[2]) == ["critical", "CVE-2026-2", *TORCH[:4], "stops the image"]
    assert lines[3].endswith("alpha-base  accepted: not [reachable]")
    assert lines.count("note: alpha-base: a note") == 1
    database = f"database of 2026-11-22T00:00:00Z, {STATE.digest}"
    assert lines[-3:] == ["scan.yaml:6:3: over", database, "2 images: policy failed"]
