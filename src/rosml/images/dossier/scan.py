"""The vulnerabilities in an image's packages that this machine's database knows, with the database's age."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import Any

from packageurl import PackageURL

from rosml.base.problems import counted, listed
from rosml.images.dossier.bill import Item, items, text
from rosml.images.join.layers import Source
from rosml.images.scan.judge import Finding, Part, part_report
from rosml.images.scan.policy import SEVERITIES
from rosml.images.scan.sbom import Sbom
from rosml.images.scan.trivy import Database, Trivy

WEEK = timedelta(days=7)
"""A database that is older may lack what everybody speaks of."""

FETCH = "fetch a newer one: ./rosml publish scan --fetch"


@dataclass(frozen=True)
class Scan:
    """`age`: of the database, in whole days. `statuses`: what VEX says of a finding, by advisory and package."""

    database: Database
    age: int
    findings: tuple[Finding, ...]
    remarks: tuple[str, ...]
    statuses: Mapping[tuple[str, str], str]

    def status(self, finding: Finding) -> str:
        return self.statuses.get((finding.id, finding.package), "")

    @property
    def counts(self) -> list[tuple[str, int]]:
        """How many findings each severity has, the worst first."""
        counts = Counter(it.severity for it in self.findings)
        return [(severity, counts[severity]) for severity in SEVERITIES if counts[severity]]

    def to_json(self) -> dict[str, Any]:
        findings = [
            {name: getattr(it, name) for name in ("id", "severity", "package", "installed", "fixed", "title", "url")}
            | {"vex": self.status(it)}
            for it in self.findings
        ]
        return {
            "database": asdict(self.database) | {"age_in_days": self.age},
            "remarks": list(self.remarks),
            "findings": findings,
        }


def scan(image: Source, sbom: Sbom, vex: Item | None, root: Path, now: str) -> Scan:
    """Scans an SBOM with the trivy and the database of a checkout. ScannerFailed if it has none."""
    trivy = Trivy.find(root)
    database = trivy.database()
    part = Part(image.name, image.host, image.repository, image.digest, ros=False)
    report = part_report(trivy.scan(sbom.content, image.name), part)
    remarks = [*report.notes]
    age = _moment(now) - _moment(database.updated)
    if age > WEEK:
        remarks.append(
            f"the database of {database.updated} is {age.days} days old, and lacks newer vulnerabilities; {FETCH}"
        )
    if lacking := trivy.lacks(sbom.sources):
        remarks.append(f"the database knows nothing of {listed(lacking)}")
    if report.packages != len(sbom.packages):
        remarks.append(f"trivy looked at {report.packages} of {counted(len(sbom.packages), 'package')}")
    return Scan(database, max(age.days, 0), report.findings, tuple(remarks), statuses(vex or {}))


def _moment(time: str) -> datetime:
    return datetime.fromisoformat(time).astimezone(UTC)


def statuses(vex: Item) -> dict[tuple[str, str], str]:
    """What OpenVEX says, by advisory and name of the package."""
    verdicts = {}
    for statement in items(vex, "statements"):
        for product in items(statement, "products"):
            for component in items(product, "subcomponents"):
                try:
                    name = PackageURL.from_string(text(component, "@id")).name
                except ValueError:
                    continue
                verdicts[text(statement, "vulnerability", "name"), name] = text(statement, "status")
    return verdicts
