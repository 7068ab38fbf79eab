"""Looks for one vulnerability in the SBOMs of apps and base images."""

from __future__ import annotations

import hashlib
import re
from collections.abc import Callable

from rosml.base.errors import RosmlError
from rosml.base.problems import listed
from rosml.images.scan.policy import ADVISORY
from rosml.images.scan.trivy import Report


def require_advisory(name: str) -> None:
    """Checks a name.

    Raises:
        RosmlError: it is no name of an advisory (exit code 2).
    """
    if not re.fullmatch(ADVISORY, name):
        raise RosmlError(f"--fixes: {name!r} is no name of an advisory", "write it as CVE-2026-12345", exit_code=2)


class Screen:
    """A vulnerability. Each SBOM is scanned once.

    Args:
        name: such as `CVE-2026-12345`.
        scan: gives the report about an SBOM; the second argument names its subject in messages.
    """

    def __init__(self, name: str, scan: Callable[[bytes, str], Report]) -> None:
        self._name, self._scan = name, scan
        self._known: dict[bytes, str] = {}

    def __call__(self, sbom: bytes, subject: str) -> str:
        """The packages that have it, such as `openssl 3.0.1 (fixed in 3.0.2)`; empty if there are none.

        Raises:
            RosmlError: the scanner failed.
        """
        key = hashlib.sha256(sbom).digest()
        if key not in self._known:
            self._known[key] = self._found(self._scan(sbom, subject))
        return self._known[key]

    def _found(self, report: Report) -> str:
        packages = set()
        for result in report.Results or ():
            for item in result.Vulnerabilities or ():
                if item.VulnerabilityID == self._name:
                    fixed = f" (fixed in {item.FixedVersion})" if item.FixedVersion else ""
                    packages.add(f"{item.PkgName} {item.InstalledVersion}{fixed}")
        return f"{listed(sorted(packages))} has {self._name}" if packages else ""
