"""Looks for one vulnerability in the SBOMs of apps and base images."""

from __future__ import annotations

import hashlib
import re
from collections.abc import Callable
from datetime import UTC, datetime
from pathlib import Path

from rosml.base.errors import RosmlError
from rosml.base.problems import listed
from rosml.images.scan import policy
from rosml.images.scan.policy import ADVISORY
from rosml.images.scan.trivy import Report, Trivy
from rosml.images.scan.vex import Statement
from rosml.machine.services import Services


def require_advisory(name: str) -> None:
    if not re.fullmatch(ADVISORY, name):
        raise RosmlError(f"--fixes: {name!r} is no name of an advisory", "write it as CVE-2026-12345", exit_code=2)


def scanner(root: Path, services: Services, say: Callable[[str], None]) -> Trivy:
    """The scanner of a checkout, with today's database."""
    trivy = Trivy.find(root, environment=services.trusting())
    rules = policy.load(root / "scan.yaml").policy.database
    trivy.fetch(rules, say=say).require_fresh(rules, datetime.now(UTC))
    return trivy


class Screen:
    """Looks for a vulnerability, such as `CVE-2026-12345`. Each SBOM is scanned once."""

    def __init__(self, name: str, scan: Callable[[bytes, str], Report]) -> None:
        self._name, self._scan = name, scan
        self._answers: dict[bytes, str] = {}

    def __call__(self, sbom: bytes, subject: str) -> str:
        """The packages that have it, such as `openssl 3.0.1 (fixed in 3.0.2) has CVE-2026-12345`; empty if there are none."""
        key = hashlib.sha256(sbom).digest()
        if key not in self._answers:
            self._answers[key] = self._affected(self._scan(sbom, subject))
        return self._answers[key]

    def fixed(self, vulnerable: str) -> Statement:
        """What VEX says of an image that had it until it moved."""
        return Statement(
            advisory=self._name, status="fixed", reason=f"{vulnerable}, until the image moved", components=[]
        )

    def _affected(self, report: Report) -> str:
        packages = {
            f"{item.PkgName} {item.InstalledVersion}"
            + (f" (fixed in {item.FixedVersion})" if item.FixedVersion else "")
            for scanned in report.Results or ()
            for item in scanned.Vulnerabilities or ()
            if item.VulnerabilityID == self._name
        }
        return f"{listed(sorted(packages))} has {self._name}" if packages else ""
