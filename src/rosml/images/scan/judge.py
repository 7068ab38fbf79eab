"""Scans images for known vulnerabilities, part by part, and judges the findings by the policy.

Each ROS image and each part has an SBOM beside it in the registry, from its build. Each night, every SBOM is compared once with one
state of the database. So hundreds of images take some dozens of scans of small files, and no layer is pulled.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from dataclasses import asdict, dataclass, field, replace
from datetime import UTC, date, datetime
from enum import StrEnum
from functools import cached_property
from typing import Any, Literal

from rosml.base.errors import RosmlError
from rosml.base.problems import counted, listed, some
from rosml.images.scan.policy import LONGEST, SEVERITIES, Ignored, Justification, Policy, Rules, Status
from rosml.images.scan.sbom import Shelf
from rosml.images.scan.trivy import ANOTHER, SCANNER_FAILED, Database, Report, ScannerFailed, Trivy, Vulnerability

RECORDED = 20
"""The most findings of an image that the records name: they are read at every plan. All are in the reports of a run."""

POLICY_FAILED = 3


class Outcome(StrEnum):
    CLEAN = "clean"
    POLICY_FAILED = "policy failed"
    SCANNER_FAILED = "scanner failed"

    @property
    def exit_code(self) -> int:
        return {Outcome.CLEAN: 0, Outcome.POLICY_FAILED: POLICY_FAILED, Outcome.SCANNER_FAILED: SCANNER_FAILED}[self]


@dataclass(frozen=True)
class Part:
    """A ROS image or a part, for one platform, by the place of its image manifest."""

    name: str  # the bake target of the ROS image, or the part's name
    registry: str
    repository: str
    digest: str
    ros: bool  # whether it is a ROS image, which has an operating system

    @property
    def reference(self) -> str:
        return f"{self.registry}/{self.repository}@{self.digest}"


@dataclass(frozen=True)
class Image:
    """An image for one platform: the ROS image, then its parts. Ignore entries match its bake target."""

    target: str
    architecture: str
    parts: tuple[Part, ...]


@dataclass(frozen=True)
class Finding:
    """A known vulnerability in a package of a part."""

    id: str
    severity: str  # of `policy.SEVERITIES`
    package: str
    installed: str
    fixed: str  # the version that fixes it; empty if there is none
    part: str
    kind: str = ""  # the kind of package, in trivy's words: debian, ubuntu, python-pkg
    title: str = ""
    url: str = ""
    ignored: str = ""  # the reason why the policy ignores it; empty if it does not
    until: str = ""  # the last day on which an entry of the policy ignores it, such as 2027-05-31; empty if none does
    fails: bool = False
    status: Status | Literal[""] = ""  # what VEX says of it; empty if nobody has judged it
    justification: Justification | Literal[""] = ""  # why the image is not affected
    action: str = ""  # what users can do; empty if they need not do anything
    purl: str = ""
    ref: str = ""  # the component in the SBOM
    vendor: str = ""  # what the distribution says, in trivy's words

    @property
    def order(self) -> tuple[Any, ...]:
        """The worst first; findings with a fix before those without."""
        return (SEVERITIES.index(self.severity), not self.fixed, self.part, self.package, self.id)


@dataclass(frozen=True)
class PartReport:
    """The findings about a part."""

    packages: int  # the number of packages that the scanner checked
    findings: tuple[Finding, ...]
    notes: tuple[str, ...] = ()  # remarks for readers, such as an operating system without further advisories


@dataclass(frozen=True)
class Scanned:
    """The result of scanning an image."""

    target: str
    architecture: str
    outcome: Outcome
    reason: str  # why it has that outcome, in a sentence
    findings: tuple[Finding, ...] = ()  # all findings, the worst first
    packages: int = 0
    parts: Mapping[str, str] = field(default_factory=dict)  # the name and the digest of each part
    notes: tuple[str, ...] = ()  # remarks for readers beside the findings
    matched: tuple[int, ...] = ()  # indexes of the policy's ignore entries that matched a finding
    database: Database | None = None

    @property
    def failing(self) -> tuple[Finding, ...]:
        return tuple(finding for finding in self.findings if finding.fails)

    @property
    def recorded(self) -> list[dict[str, Any]]:
        """The findings for the records: those that stop the image, then the worst of the others."""
        fields = ("id", "severity", "package", "installed", "fixed", "part")
        return [
            {name: getattr(finding, name)[:LONGEST] for name in fields}
            | {"fails": finding.fails, "ignored": finding.ignored, "until": finding.until, "status": finding.status}
            for finding in sorted(self.findings, key=lambda finding: not finding.fails)[:RECORDED]
        ]

    def to_json(self) -> dict[str, Any]:
        return {**asdict(self), "outcome": self.outcome.value, "exit_code": self.outcome.exit_code}


@dataclass(frozen=True)
class Run:
    """The result of scanning many images. Only an image's own outcome decides whether it gets its tags."""

    images: tuple[Scanned, ...]
    problems: tuple[str, ...] = ()  # of the policy's own entries, with file and line; they fail the run, but no image
    ending: tuple[str, ...] = ()  # entries of the policy that end within thirty days, likewise; they fail nothing

    @property
    def outcome(self) -> Outcome:
        """The outcome of the run. If the scanner failed, that counts most, because something is unknown."""
        outcomes = {image.outcome for image in self.images}
        if Outcome.SCANNER_FAILED in outcomes:
            return Outcome.SCANNER_FAILED
        return Outcome.POLICY_FAILED if Outcome.POLICY_FAILED in outcomes or self.problems else Outcome.CLEAN

    def to_json(self) -> dict[str, Any]:
        return {
            "outcome": self.outcome.value,
            "exit_code": self.outcome.exit_code,
            "problems": list(self.problems),
            "ending": list(self.ending),
            "images": [image.to_json() for image in self.images],
        }


class Scanner:
    """Scans parts and remembers them: a shared part is scanned once, and fails once."""

    def __init__(self, trivy: Trivy, shelf: Shelf, say: Callable[[str], None] = lambda line: None):
        self.trivy, self.shelf, self.say = trivy, shelf, say
        self._reports: dict[str, PartReport | ScannerFailed] = {}  # by digest

    @cached_property
    def database(self) -> Database:
        """The state with which all parts are compared, from the first to the last."""
        return self.trivy.database()

    def require_same_database(self) -> None:
        """Checks that nobody exchanged the database during the scans."""
        if self.trivy.database().digest != self.database.digest:
            text = "the database of vulnerabilities changed during the run"
            raise ScannerFailed(text, "let only one run at a time fetch it")

    def report(self, part: Part) -> PartReport:
        """The database's findings about a part."""
        report = self._reports.get(part.digest)
        if report is None:
            try:
                report = self._report(part)
            except ScannerFailed as error:
                report = error
            self._reports[part.digest] = report
        if isinstance(report, ScannerFailed):
            raise report
        return report

    def _report(self, part: Part) -> PartReport:
        self.say(f"scan {part.name}")
        try:
            sbom = self.shelf.load(part.repository, part.digest)
        except RosmlError as error:
            raise ScannerFailed(f"{part.name}: {error.message}", error.remedy) from None
        sbom.require(part.name, part.ros)
        report = self.trivy.scan(sbom.content, part.name)
        if lacking := self.trivy.lacks(sbom.sources):
            text = f"{part.name}: the database knows nothing of {listed(lacking)}"
            raise ScannerFailed(text, "check whether its publisher covers that system")
        summary = part_report(report, part)
        if summary.packages != len(sbom.packages):
            raise ScannerFailed(
                f"{part.name}: trivy looked at {summary.packages} of {counted(len(sbom.packages), 'package')}",
                "its operating system or a kind of package may be unknown to the pinned trivy",
            )
        return summary


def part_report(report: Report, part: Part) -> PartReport:
    """The findings in trivy's report about a part."""
    results = report.Results or []
    findings = {_finding(entry, result.Type, part) for result in results for entry in result.Vulnerabilities or []}
    packages, notes = sum(len(result.Packages or []) for result in results), list[str]()
    system = report.Metadata.OS if report.Metadata else None
    if system and system.EOSL:
        end = "gets no advisories any more: what became known since is not among the findings"
        notes.append(f"{part.name}: {system.Family} {system.Name} {end}")
    return PartReport(packages, tuple(sorted(findings, key=lambda finding: finding.order)), tuple(notes))


def _finding(vulnerability: Vulnerability, kind: str, part: Part) -> Finding:
    severity = vulnerability.Severity.lower()
    if severity not in SEVERITIES:
        raise ScannerFailed(f"{part.name}: trivy's report has the severity {severity!r}", ANOTHER)
    return Finding(
        id=vulnerability.VulnerabilityID,
        severity=severity,
        package=vulnerability.PkgName,
        installed=vulnerability.InstalledVersion,
        fixed=vulnerability.FixedVersion,
        part=part.name,
        kind=kind,
        title=vulnerability.Title,
        url=vulnerability.PrimaryURL,
        purl=vulnerability.PkgIdentifier.PURL,
        ref=vulnerability.PkgIdentifier.BOMRef,
        vendor=vulnerability.Status,
    )


def scan(image: Image, rules: Rules, scanner: Scanner, today: date) -> Scanned:
    """Scans an image. If that fails, it raises nothing: the failure is the outcome. Ignore entries expire by `today`."""
    reports, reasons = [], []
    for part in image.parts:
        try:
            reports.append(scanner.report(part))
        except ScannerFailed as error:
            reasons.append(error.message)
    expired = rules.expired(today)
    entries = {index: entry for index, entry in enumerate(rules.policy.ignore) if index not in expired}
    findings, matched = list[Finding](), set[int]()
    for finding in sorted((finding for report in reports for finding in report.findings), key=lambda it: it.order):
        covering = [i for i, entry in entries.items() if entry.covers(image.target, finding.id, finding.package)]
        matched.update(covering)
        findings.append(_judged(finding, rules.policy, entries[covering[0]] if covering else None))
    outcome, reason = _outcome(findings, reasons, image.parts)
    return Scanned(
        image.target,
        image.architecture,
        outcome,
        reason,
        tuple(findings),
        sum(report.packages for report in reports),
        _digests(image),
        tuple(note for report in reports for note in report.notes),
        tuple(sorted(matched)),
        scanner.database,
    )


def _judged(finding: Finding, policy: Policy, entry: Ignored | None) -> Finding:
    if entry:
        action = entry.action or (_update(finding) if entry.status == "affected" else "")
        judged = replace(finding, status=entry.status, justification=entry.justification or "", action=action)
        return replace(judged, ignored=entry.reason, until=str(entry.expires))
    if finding.package.startswith(KERNEL_HEADERS):
        return replace(
            finding,
            status="not_affected",
            justification="vulnerable_code_not_present",
            ignored="the package has headers of the kernel, and none of its code",
        )
    if policy.stops(finding.severity) and (bool(finding.fixed) or not policy.fixable_only):
        return replace(finding, fails=True, status="affected", action=_update(finding))
    if finding.vendor in VENDOR and not finding.fixed:
        return replace(finding, status="affected", action=VENDOR[finding.vendor])
    return finding


KERNEL_HEADERS = "linux-libc-dev"
"""The beginning of names of packages with the headers of the kernel. Containers use the kernel of their machine."""

VENDOR = {
    "will_not_fix": "the distribution will not fix it in this release; a newer release may have a fix",
    "fix_deferred": "the distribution fixes it together with another problem, or not in this release",
    "end_of_life": "the distribution does not support the package any more; a newer release may",
}
"""What users can do if a distribution says this, in trivy's words. Of one that is not affected, trivy's database says nothing at all."""


def _update(finding: Finding) -> str:
    if not finding.fixed:
        return f"no version of {finding.package} fixes it yet"
    return f"use an image with {finding.package} {finding.fixed} or newer"


def _outcome(findings: Sequence[Finding], reasons: Sequence[str], parts: Sequence[Part]) -> tuple[Outcome, str]:
    if not parts:
        return Outcome.SCANNER_FAILED, "no part was named: nothing was scanned"
    if reasons:
        return Outcome.SCANNER_FAILED, "; ".join(dict.fromkeys(reasons))
    if failing := [finding for finding in findings if finding.fails]:
        names = list(dict.fromkeys(f"{finding.id} in {finding.package}" for finding in failing))
        return Outcome.POLICY_FAILED, f"{counted(len(names), 'finding')} that the policy does not allow: {some(names)}"
    if not findings:
        return Outcome.CLEAN, "no findings"
    return Outcome.CLEAN, f"{counted(len(findings), 'finding')}, none of which the policy stops"


def scan_images(
    images: Sequence[Image],
    rules: Rules,
    scanner: Scanner,
    now: datetime,
    keep: Callable[[Scanned], None] = lambda image: None,
) -> list[Scanned]:
    """Scans images with the present database. If one fails, the others still go on.

    `keep` gets each image once it is scanned. If the database has changed by the end, it gets each again, as a failed scan.
    """
    today, scans = now.astimezone(UTC).date(), list[Scanned]()
    try:
        scanner.database.require_fresh(rules.policy.database, now)
        for image in images:
            scans.append(scan(image, rules, scanner, today))
            keep(scans[-1])
        scanner.require_same_database()
    except ScannerFailed as error:
        return unscanned(images, error, keep)
    return scans


def unscanned(
    images: Sequence[Image], error: ScannerFailed, keep: Callable[[Scanned], None] = lambda image: None
) -> list[Scanned]:
    """The results of images if the scanner could not begin: it is not installed, or has no database. `keep` gets each."""
    failed = (Outcome.SCANNER_FAILED, error.message)
    scans = [Scanned(image.target, image.architecture, *failed, parts=_digests(image)) for image in images]
    for image in scans:
        keep(image)
    return scans


def summarise(
    images: Iterable[Scanned],
    rules: Rules,
    today: date,
    whole: bool,
    targets: Collection[str] = (),
    left_out: Collection[str] = (),
) -> Run:
    """The result of a run, with the problems of the policy's own entries.

    Args:
        whole: whether these are all images. Those that were never built are not among them: an entry for none of these is not judged.
        targets: the targets of all images of the matrix.
        left_out: the targets that a set does not have, and the matrix that it extends has. An entry that is for one of them says
            something about rosml's images: this run knows too little to call it useless.
    """
    scans = tuple(images)
    entries = rules.policy.ignore
    elsewhere = {index for index, entry in enumerate(entries) if any(map(entry.is_for, left_out))}
    only_there = {index for index in elsewhere if not any(map(entries[index].is_for, targets))}
    expired = rules.expired(today)
    problems = [problem for index, problem in expired.items() if index not in only_there]
    problems += rules.for_nobody([*targets, *left_out]) if targets else []
    if whole:
        matched = {index for image in scans for index in image.matched}
        judged = [
            index
            for index, entry in enumerate(entries)
            if index not in expired
            and index not in elsewhere
            and any(entry.is_for(image.target) for image in scans)
            # It may match an image whose scan failed.
            and not any(image.outcome is Outcome.SCANNER_FAILED and entry.is_for(image.target) for image in scans)
        ]
        problems += rules.unmatched(matched, judged)
    ending = [problem.message(rules.document.name) for problem in rules.ending(today)]
    texts = [problem.message(rules.document.name) for problem in sorted(problems, key=lambda problem: problem.line)]
    return Run(scans, tuple(texts), tuple(ending))


def _digests(image: Image) -> dict[str, str]:
    return {part.name: part.digest for part in image.parts}
