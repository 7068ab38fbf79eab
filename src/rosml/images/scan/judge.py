"""Scans images for known vulnerabilities, part by part, and judges what is found by the policy.

An image is a ROS image and parts. Each of these has an SBOM beside it in the registry, from the build that made it; each
night every SBOM is held against one state of the database, once, however many images have that part. So hundreds of images
cost some dozens of scans of small files, and no layer is pulled.

Three outcomes are kept apart: the image is clean, the policy stops it, or the scanner failed and nothing is known.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from dataclasses import asdict, dataclass, field, replace
from datetime import UTC, date, datetime
from enum import StrEnum
from typing import Any, TypeVar

from rosml.base.errors import RosmlError
from rosml.base.problems import counted, listed, some
from rosml.images.scan.policy import SEVERITIES, Ignored, Rules
from rosml.images.scan.sbom import Shelf
from rosml.images.scan.trivy import ANOTHER, SCANNER_FAILED, Database, Report, ScannerFailed, Trivy

Known = TypeVar("Known")

POLICY_FAILED = 3
"""Exit code where the policy stops an image."""


class Outcome(StrEnum):
    """What a scan came to."""

    CLEAN = "clean"
    POLICY_FAILED = "policy failed"
    SCANNER_FAILED = "scanner failed"

    @property
    def exit_code(self) -> int:
        """0, 3 or 4."""
        return {Outcome.CLEAN: 0, Outcome.POLICY_FAILED: POLICY_FAILED, Outcome.SCANNER_FAILED: SCANNER_FAILED}[self]


@dataclass(frozen=True)
class Part:
    """A ROS image or a part, for one platform.

    Attributes:
        name: the bake target of the ROS image, or the part's name.
        registry, repository, digest: where its image manifest is.
        ros: whether it is a ROS image, which has an operating system.
    """

    name: str
    registry: str
    repository: str
    digest: str
    ros: bool

    @property
    def reference(self) -> str:
        """What to pull."""
        return f"{self.registry}/{self.repository}@{self.digest}"


@dataclass(frozen=True)
class Image:
    """An image for one platform.

    Attributes:
        target: its bake target, which ignore entries speak of.
        architecture: which of its platforms this is.
        parts: what it is the sum of: the ROS image, then its parts.
    """

    target: str
    architecture: str
    parts: tuple[Part, ...]


@dataclass(frozen=True)
class Finding:
    """A known vulnerability in a package of a part.

    Attributes:
        id: the advisory.
        severity: of `policy.SEVERITIES`.
        package, installed, fixed: the package and its versions; `fixed` is empty where no newer one mends it.
        part: name of the part.
        kind: of package, in trivy's words: debian, ubuntu, python-pkg.
        title, url: what it is about, and where more is said.
        ignored: the reason why the policy ignores it; empty where it does not.
        fails: whether it stops the image.
    """

    id: str
    severity: str
    package: str
    installed: str
    fixed: str
    part: str
    kind: str = ""
    title: str = ""
    url: str = ""
    ignored: str = ""
    fails: bool = False

    @property
    def order(self) -> tuple[Any, ...]:
        """The worst first, what can be mended before what cannot."""
        return (SEVERITIES.index(self.severity), not self.fixed, self.part, self.package, self.id)


@dataclass(frozen=True)
class PartReport:
    """What is known of a part.

    Attributes:
        packages: how many packages the scanner looked at.
        findings: their vulnerabilities.
        notes: what a reader should know, such as an operating system without further advisories.
    """

    packages: int
    findings: tuple[Finding, ...]
    notes: tuple[str, ...] = ()


@dataclass(frozen=True)
class Scanned:
    """What scanning an image came to.

    Attributes:
        target, architecture: the image.
        outcome: one of three.
        reason: why it is so, in a sentence.
        findings: all of them, the worst first.
        packages: how many packages were looked at.
        parts: name and digest of each part.
        notes: what a reader should know beside the findings.
        matched: indexes of the policy's ignore entries that spoke of a finding.
        database: the state of the database; none where there was none.
    """

    target: str
    architecture: str
    outcome: Outcome
    reason: str
    findings: tuple[Finding, ...] = ()
    packages: int = 0
    parts: Mapping[str, str] = field(default_factory=dict)
    notes: tuple[str, ...] = ()
    matched: tuple[int, ...] = ()
    database: Database | None = None

    @property
    def failing(self) -> tuple[Finding, ...]:
        """What stops the image."""
        return tuple(finding for finding in self.findings if finding.fails)

    def to_json(self) -> dict[str, Any]:
        """For `--json` and for the records."""
        return {**asdict(self), "outcome": self.outcome.value, "exit_code": self.outcome.exit_code}


@dataclass(frozen=True)
class Run:
    """What scanning many images came to.

    Attributes:
        images: one by one; whether an image gets its tags is its own outcome alone.
        problems: of the policy's own entries, as `file:line:column: …`; they fail the run, and no image.
    """

    images: tuple[Scanned, ...]
    problems: tuple[str, ...] = ()

    @property
    def outcome(self) -> Outcome:
        """The run's: a scanner that failed counts most, because then not everything is known."""
        found = {image.outcome for image in self.images}
        if Outcome.SCANNER_FAILED in found:
            return Outcome.SCANNER_FAILED
        return Outcome.POLICY_FAILED if Outcome.POLICY_FAILED in found or self.problems else Outcome.CLEAN

    def to_json(self) -> dict[str, Any]:
        """For `--json`."""
        return {
            "outcome": self.outcome.value,
            "exit_code": self.outcome.exit_code,
            "problems": list(self.problems),
            "images": [image.to_json() for image in self.images],
        }


class Scanner:
    """Knows every part that it was asked about: shared ones are scanned once, and fail once."""

    def __init__(self, trivy: Trivy, shelf: Shelf, database: Database, say: Callable[[str], None] = lambda line: None):
        """Scans with one state of the database, from the first part to the last.

        Args:
            trivy: the program.
            shelf: has the SBOMs.
            database: the state that all parts are held against.
            say: told what is going on, a line at a time.
        """
        self.trivy, self.shelf, self.database, self.say = trivy, shelf, database, say
        self._reports: dict[str, PartReport | ScannerFailed] = {}

    def report(self, part: Part) -> PartReport:
        """What the database knows of a part.

        Raises:
            ScannerFailed: nobody knows.
        """
        return _once(self._reports, part.digest, lambda: self._report(part))

    def _report(self, part: Part) -> PartReport:
        self.say(f"scan {part.name}")
        try:
            sbom = self.shelf.load(part.repository, part.digest)
        except RosmlError as error:
            raise ScannerFailed(f"{part.name}: {error.message}", error.remedy) from None
        sbom.require(part.name, part.ros)
        report = self.trivy.scan(sbom.content, part.name)
        if lacking := self.trivy.lacks(sbom.sources):
            raise ScannerFailed(
                f"{part.name}: the database knows nothing of {listed(lacking)}",
                "see whether its publisher covers that system",
            )
        found = part_report(report, part)
        if found.packages != len(sbom.packages):
            raise ScannerFailed(
                f"{part.name}: trivy looked at {found.packages} of {counted(len(sbom.packages), 'package')}",
                "its operating system or a kind of package may be unknown to the pinned trivy",
            )
        return found


def part_report(report: Report, part: Part) -> PartReport:
    """What trivy's report says of a part.

    Raises:
        ScannerFailed: it has a severity that is not known.
    """
    packages, findings, notes = 0, set(), []
    for result in report.Results or []:
        packages += len(result.Packages or [])
        for found in result.Vulnerabilities or []:
            severity = found.Severity.lower()
            if severity not in SEVERITIES:
                raise ScannerFailed(f"{part.name}: trivy's report has the severity {severity!r}", ANOTHER)
            findings.add(
                Finding(
                    id=found.VulnerabilityID,
                    severity=severity,
                    package=found.PkgName,
                    installed=found.InstalledVersion,
                    fixed=found.FixedVersion,
                    part=part.name,
                    kind=result.Type,
                    title=found.Title,
                    url=found.PrimaryURL,
                )
            )
    system = report.Metadata.OS if report.Metadata else None
    if system and system.EOSL:
        notes.append(
            f"{part.name}: {system.Family} {system.Name} gets no advisories any more: "
            "what became known since is not among the findings"
        )
    return PartReport(packages, tuple(sorted(findings, key=lambda finding: finding.order)), tuple(notes))


def scan(image: Image, rules: Rules, scanner: Scanner, today: date) -> Scanned:
    """Scans an image. Never raises because of the image: what goes wrong is its outcome.

    Args:
        image: the image.
        rules: the policy.
        scanner: with the database that the whole run uses.
        today: the run's date, by which ignore entries expire.
    """
    reports, reasons = [], []
    for part in image.parts:
        try:
            reports.append(scanner.report(part))
        except ScannerFailed as error:
            reasons.append(error.message)
    expired = rules.expired(today)
    entries = [(index, entry) for index, entry in enumerate(rules.policy.ignore) if index not in expired]
    findings: list[Finding] = []
    matched: set[int] = set()
    for finding in sorted((finding for report in reports for finding in report.findings), key=lambda it: it.order):
        covering = [
            (index, entry) for index, entry in entries if entry.covers(image.target, finding.id, finding.package)
        ]
        matched.update(index for index, _ in covering)
        findings.append(_judged(finding, rules, covering[0][1] if covering else None))
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


def _judged(finding: Finding, rules: Rules, entry: Ignored | None) -> Finding:
    policy = rules.policy
    fails = entry is None and policy.stops(finding.severity) and (bool(finding.fixed) or not policy.fixable_only)
    return replace(finding, ignored=entry.reason if entry else "", fails=fails)


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
    trivy: Trivy,
    shelf: Shelf,
    *,
    now: datetime,
    whole: bool,
    targets: Collection[str] = (),
    say: Callable[[str], None] = lambda line: None,
    keep: Callable[[Scanned], None] = lambda image: None,
) -> Run:
    """Scans images with the database that is there; one that fails does not stop the others.

    Args:
        images: in the order in which they are told.
        rules: the policy.
        trivy: the program, with its database.
        shelf: has the SBOMs.
        now: the run's time, in UTC: by its date ignore entries expire, by it the database is too old or not.
        whole: whether these are all images that there are, so that ignore entries that are in none of them can be told.
        targets: of all images of the matrix, so that ignore entries that are for none of them can be told.
        say: told what is going on, a line at a time.
        keep: gets each image as soon as it was scanned; once more, as one whose scan failed, if the database turns out to
            have changed by the end.
    """
    now = now.astimezone(UTC)
    found: list[Scanned] = []
    try:
        database = trivy.database()
        database.require_fresh(rules.policy.database, now)
        scanner = Scanner(trivy, shelf, database, say)
        for image in images:
            found.append(scan(image, rules, scanner, now.date()))
            keep(found[-1])
        if trivy.database().digest != database.digest:
            text = "the database of vulnerabilities changed during the run"
            raise ScannerFailed(text, "let only one run at a time fetch it")
    except ScannerFailed as error:
        found = unscanned(images, error, keep)
    return summarise(found, rules, now.date(), whole, targets)


def unscanned(
    images: Sequence[Image], error: ScannerFailed, keep: Callable[[Scanned], None] = lambda image: None
) -> list[Scanned]:
    """What is said of images where the scanner could not even begin: it is not installed, or has no database. `keep` gets
    each of them."""
    failed = (Outcome.SCANNER_FAILED, error.message)
    found = [Scanned(image.target, image.architecture, *failed, parts=_digests(image)) for image in images]
    for image in found:
        keep(image)
    return found


def summarise(images: Iterable[Scanned], rules: Rules, today: date, whole: bool, targets: Collection[str] = ()) -> Run:
    """A run of images, with what is wrong with the policy's own entries.

    Args:
        images: all that the run scanned.
        rules: the policy that they were judged by.
        today: the run's date.
        whole: whether these are all images that there are. An ignore entry is judged by them if it is for one of them: those
            of the matrix that were never built are not among them.
        targets: of all images of the matrix.
    """
    found = tuple(images)
    expired = rules.expired(today)
    problems = [*expired.values(), *(rules.for_nobody(targets) if targets else [])]
    if whole:
        matched = {index for image in found for index in image.matched}
        judged = [
            index
            for index, entry in enumerate(rules.policy.ignore)
            if index not in expired
            and any(entry.is_for(image.target) for image in found)
            # It may be in an image of which nothing is known.
            and not any(image.outcome is Outcome.SCANNER_FAILED and entry.is_for(image.target) for image in found)
        ]
        problems += rules.unmatched(matched, judged)
    texts = [problem.message(rules.document.name) for problem in sorted(problems, key=lambda problem: problem.line)]
    return Run(found, tuple(texts))


def _digests(image: Image) -> dict[str, str]:
    return {part.name: part.digest for part in image.parts}


def _once(known: dict[str, Known | ScannerFailed], key: str, work: Callable[[], Known]) -> Known:
    """What work gives or raises, done once for a key."""
    if key not in known:
        try:
            known[key] = work()
        except ScannerFailed as error:
            known[key] = error
    found = known[key]
    if isinstance(found, ScannerFailed):
        raise found
    return found
