"""Findings of a scan, for people (a table) and for programs that show findings (SARIF)."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterator, Sequence
from dataclasses import asdict
from pathlib import Path
from typing import Any

from rosml.base import files
from rosml.base.problems import counted
from rosml.images.scan.judge import Finding, Outcome, Run, Scanned

COLUMNS = ("severity", "advisory", "package", "installed", "fixed in", "part", "")

LEVELS = {"critical": "error", "high": "error", "medium": "warning"}
"""SARIF's levels; others have the level note."""

SCORES = {"critical": "9.5", "high": "8.0", "medium": "5.5", "low": "2.0", "unknown": "0.0"}
"""The middle of each severity's range: viewers of SARIF sort by a number."""


def sarif(scanned: Scanned) -> dict[str, Any]:
    """An image's findings as SARIF 2.1.0: one run, whose name keeps images and architectures apart.

    If the scanner failed, the invocation is marked as failed, so that nobody takes an empty list of results for good news.
    """
    failed = scanned.outcome is Outcome.SCANNER_FAILED
    rules = {finding.id: finding for finding in reversed(scanned.findings)}  # the worst of each counts
    return {
        "$schema": "https://json.schemastore.org/sarif-2.1.0.json",
        "version": "2.1.0",
        "runs": [
            {
                "tool": {
                    "driver": {
                        "name": "trivy",
                        "informationUri": "https://github.com/aquasecurity/trivy",
                        "rules": [_rule(rules[name]) for name in sorted(rules)],
                    }
                },
                "automationDetails": {"id": f"scan/{scanned.target}/{scanned.architecture}"},
                "invocations": [
                    {
                        "executionSuccessful": not failed,
                        "toolExecutionNotifications": [
                            *([{"level": "error", "message": {"text": scanned.reason}}] if failed else []),
                            *({"level": "warning", "message": {"text": note}} for note in scanned.notes),
                        ],
                    }
                ],
                "properties": {
                    "outcome": scanned.outcome.value,
                    "reason": scanned.reason,
                    "parts": dict(scanned.parts),
                    "database": asdict(scanned.database) if scanned.database else None,
                },
                "results": [_result(scanned, finding) for finding in scanned.findings],
            }
        ],
    }


def write(folder: Path, run: Run) -> list[Path]:
    """Writes a run's reports: `<target>.<architecture>.sarif` for each image, and `scan.json` for all of them."""
    folder.mkdir(parents=True, exist_ok=True)
    reports: dict[str, Any] = {f"{image.target}.{image.architecture}.sarif": sarif(image) for image in run.images}
    for name, content in {**reports, "scan.json": run.to_json()}.items():
        files.write(folder / name, json.dumps(content, indent=2) + "\n")
    return [folder / name for name in (*reports, "scan.json")]


def _rule(finding: Finding) -> dict[str, Any]:
    return {
        "id": finding.id,
        "shortDescription": {"text": finding.title or finding.id},
        **({"helpUri": finding.url} if finding.url else {}),
        "properties": {"security-severity": SCORES[finding.severity], "tags": ["vulnerability", finding.severity]},
    }


def _result(scanned: Scanned, finding: Finding) -> dict[str, Any]:
    fix = f"fixed in {finding.fixed}" if finding.fixed else "not fixed in any version"
    text = f"{finding.package} {finding.installed} of {finding.part}: {finding.title or finding.id}; {fix}"
    suppression = {"kind": "external", "status": "accepted", "justification": finding.ignored}
    key = "\n".join((scanned.target, scanned.architecture, finding.part, finding.package, finding.id))
    return {
        "ruleId": finding.id,
        "level": LEVELS.get(finding.severity, "note"),
        "message": {"text": text},
        # No file of the checkout has the finding: the part stands for it.
        "locations": [{"physicalLocation": {"artifactLocation": {"uri": f"{finding.part}/{finding.package}"}}}],
        "partialFingerprints": {"rosml/v1": hashlib.sha256(key.encode()).hexdigest()},
        "properties": {"fails": finding.fails, "installed": finding.installed, "fixed": finding.fixed},
        **({"suppressions": [suppression]} if finding.ignored else {}),
    }


def finding_rows(findings: Sequence[Finding]) -> Iterator[tuple[str, ...]]:
    """A row for each finding, with the cells of `COLUMNS`."""
    for item in findings:
        yield (item.severity, item.id, item.package, item.installed, item.fixed or "-", item.part, verdict(item))


def verdict(finding: Finding) -> str:
    """What the policy says of a finding: `accepted until 2027-05-31: …`, or `not affected: …` as VEX has it."""
    if finding.fails:
        return "stops the image"
    if not finding.ignored:
        return ""
    accepted = finding.status in ("", "affected")
    return f"{'accepted' if accepted else finding.status.replace('_', ' ')}{until(finding.until)}: {finding.ignored}"


def until(day: str) -> str:
    return f" until {day}" if day else ""


def summary(scanned: Scanned) -> str:
    """One line: `jazzy-base amd64: clean: 12 findings, none of which the policy stops (525 packages)`."""
    checked = f" ({counted(scanned.packages, 'package')})" if scanned.packages else ""
    return f"{scanned.target} {scanned.architecture}: {scanned.outcome.value}: {scanned.reason}{checked}"
