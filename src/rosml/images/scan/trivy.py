"""The scanner: the pinned trivy, its database, and its failures."""

from __future__ import annotations

import hashlib
import mmap
import os
import re
import subprocess
import tempfile
import time
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import Any

from pydantic import ConfigDict, ValidationError

from rosml.base import untrusted
from rosml.base.errors import RosmlError
from rosml.base.problems import first_of
from rosml.base.programs import pinned_version
from rosml.base.shapes import Shape
from rosml.images.scan.policy import DatabaseRules

SCANNER_FAILED = 4
"""The exit code if the scanner failed, as opposed to findings."""

INSTALL = "run 'rosml setup scanner'"
VERSION_SECONDS = 30.0
SCAN_SECONDS = 600.0
FETCH_SECONDS = 900.0
WRITTEN_BYTES = 512 << 20
"""The most bytes that trivy may write. SBOMs and reports have some MB."""

ANOTHER = "run it again with another trivy"

DATABASE_FORMAT = 2
"""The version of the database's format that the pinned trivy reads; also its tag in trivy's own repositories."""
REPORT_FORMAT = 2
"""The version of the pinned trivy's JSON reports."""
ATTEMPTS = 3
PAUSE_SECONDS = 5.0
"""Seconds before the second attempt; before the third one, twice as many."""

OUR_OWN = ("TRIVY_USERNAME", "TRIVY_PASSWORD", "TRIVY_REGISTRY_TOKEN", "TRIVY_INSECURE", "TRIVY_NON_SSL")
"""The user's settings that trivy gets: how to reach a registry. All others could change its findings."""


class ScannerFailed(RosmlError):
    """The scanner could not do its work, so nothing is known, neither good nor bad."""

    def __init__(self, message: str, remedy: str = "") -> None:
        super().__init__(message, remedy, exit_code=SCANNER_FAILED)


@dataclass(frozen=True)
class Database:
    """One state of trivy's database."""

    updated: str  # the time at which it was made
    digest: str  # the sha256 of the file, which is the same for all scans with this state
    source: str = ""  # its repository, with the digest there if known

    def require_fresh(self, rules: DatabaseRules, now: datetime) -> None:
        age = now - _moment(self.updated)
        if age > timedelta(hours=rules.max_age_hours):
            raise ScannerFailed(
                f"the database of vulnerabilities was made {_hours(age)} ago ({self.updated}); "
                f"the policy allows {rules.max_age_hours} hours",
                "fetch it again; if its repositories have no newer one, see database.repositories in the policy",
            )
        if age < timedelta(hours=-1):
            text = f"the database of vulnerabilities was made in the future ({self.updated})"
            raise ScannerFailed(text, "set this machine's clock")


class Model(Shape):
    """Data of others, by their own names."""

    model_config = ConfigDict(frozen=True, strict=True)


class Identifier(Model):
    """How trivy names a package: by its package URL, and by the `bom-ref` of the SBOM."""

    PURL: str = ""
    BOMRef: str = ""


class Vulnerability(Model):
    VulnerabilityID: str
    PkgName: str
    InstalledVersion: str
    Severity: str
    FixedVersion: str = ""
    Title: str = ""
    PrimaryURL: str = ""
    Status: str = ""  # what the distribution says, such as will_not_fix
    PkgIdentifier: Identifier = Identifier()


class Result(Model):
    Type: str = ""
    Packages: list[Any] | None = None
    Vulnerabilities: list[Vulnerability] | None = None


class System(Model):
    """The operating system. EOSL: it gets no more advisories."""

    Family: str = ""
    Name: str = ""
    EOSL: bool = False


class About(Model):
    OS: System | None = None


class Report(Model):
    SchemaVersion: int
    Metadata: About | None = None
    Results: list[Result] | None = None


class _Database(Model):
    Version: int = 0
    UpdatedAt: str


@dataclass
class Trivy:
    """The program, and the folder with its database."""

    program: str
    version: str  # its version, which is the pinned one
    folder: Path  # its cache, with the database below `db`
    environment: Mapping[str, str] = field(default_factory=lambda: dict(os.environ), repr=False)  # its calls inherit it
    scan_seconds: float = SCAN_SECONDS
    pause: float = PAUSE_SECONDS  # seconds before the second attempt to fetch the database

    @classmethod
    def find(cls, root: Path, folder: Path | None = None, environment: Mapping[str, str] = os.environ) -> Trivy:
        """The scanner of a checkout, from `rosml setup scanner`, if it has the pinned version."""
        try:
            program = str(untrusted.json_value((root / ".state" / "scanner.json").read_bytes())["trivy"])
        except FileNotFoundError:
            raise ScannerFailed("the scanner is not installed", INSTALL) from None
        except (OSError, ValueError, KeyError, TypeError):
            raise ScannerFailed(f"{root}/.state/scanner.json is damaged", INSTALL) from None
        pinned = pinned_version(root, "trivy", ScannerFailed)
        trivy = cls(program, pinned, folder or root / ".state" / "trivy", environment)
        lines = trivy.run("--version", seconds=VERSION_SECONDS).splitlines()
        version = next((line.split()[-1].lstrip("v") for line in lines if line.startswith("Version:")), "")
        if version != pinned:
            raise ScannerFailed(
                f"{program} is trivy {version or 'of unknown version'}, and {pinned} is pinned", INSTALL
            )
        return trivy

    def scan(self, sbom: bytes, what: str) -> Report:
        """Trivy's report about an SBOM's packages, with all packages that it checked. `what` is its name in messages."""
        with tempfile.TemporaryDirectory(prefix="rosml-scan-") as folder:
            file, output = Path(folder, "sbom.cdx.json"), Path(folder, "output.json")
            file.write_bytes(sbom)
            self.run(
                *("sbom", "--output", str(output), "--format", "json", "--list-all-pkgs", "--scanners", "vuln"),
                *("--cache-backend", "memory", "--skip-db-update", "--skip-java-db-update", "--offline-scan"),
                *("--skip-vex-repo-update", str(file)),
                seconds=self.scan_seconds,
            )
            written = output.read_bytes() if output.is_file() else b""
        return read_report(written, what)

    def fetch(self, rules: DatabaseRules, pinned: str = "", say: Callable[[str], None] = lambda line: None) -> Database:
        """Fetches the database from the first repository that has it, or the `pinned` state, which `resolve` gives all shards of a run."""
        reasons: list[str] = []
        for attempt in range(ATTEMPTS):
            if attempt:
                time.sleep(self.pause * 2 ** (attempt - 1))
            for source in (pinned,) if pinned else rules.repositories:
                # An older one that is not finished, or that trivy takes for new enough, must not count.
                for name in ("trivy.db", "metadata.json", "source"):
                    (self.folder / "db" / name).unlink(missing_ok=True)
                say(f"fetch the database of vulnerabilities from {source}")
                try:
                    options = ("--download-db-only", "--no-progress", "--db-repository", source)
                    self.run("image", *options, seconds=FETCH_SECONDS)
                    (self.folder / "db" / "source").write_text(source)
                    return self.database()
                except ScannerFailed as error:
                    reasons.append(f"{source}: {error.message}")
        raise _unreachable("the database of vulnerabilities cannot be fetched", reasons)

    def database(self) -> Database:
        folder = self.folder / "db"
        try:
            facts = _Database.model_validate(untrusted.json_value((folder / "metadata.json").read_bytes()))
            updated = _written_moment(facts.UpdatedAt)
            with (folder / "trivy.db").open("rb") as stream:
                digest = f"sha256:{hashlib.file_digest(stream, 'sha256').hexdigest()}"
        except FileNotFoundError:
            raise ScannerFailed(f"there is no database of vulnerabilities in {folder}", "fetch it first") from None
        except (OSError, OverflowError, ValueError):
            raise ScannerFailed(f"the database of vulnerabilities in {folder} is damaged", "fetch it again") from None
        if facts.Version != DATABASE_FORMAT:
            raise ScannerFailed(
                f"the database of vulnerabilities has format {facts.Version}, and trivy reads {DATABASE_FORMAT}",
                f"take the tag :{DATABASE_FORMAT} of the repository, or pin a trivy that reads it",
            )
        source = folder / "source"
        return Database(updated, digest, source.read_text() if source.exists() else "")

    def lacks(self, sources: Iterable[str]) -> list[str]:
        """The sources of advisories, such as `debian 12`, that the database lacks.

        If its database lacks a source, trivy finds nothing and does not say why. The names of sources are plain text in the file.
        """
        with (self.folder / "db" / "trivy.db").open("rb") as stream:
            if not os.fstat(stream.fileno()).st_size:
                return list(sources)
            with mmap.mmap(stream.fileno(), 0, access=mmap.ACCESS_READ) as content:
                return [name for name in sources if content.find(name.encode()) < 0]

    def run(self, *arguments: str, seconds: float) -> str:
        self.folder.mkdir(parents=True, exist_ok=True)
        env = {
            name: text for name, text in self.environment.items() if name in OUR_OWN or not name.startswith("TRIVY_")
        }
        # Neither a trivy.yaml nor a .trivyignore of the current folder may change the findings.
        with tempfile.TemporaryDirectory(prefix="rosml-trivy-") as nowhere:
            quiet = () if arguments == ("--version",) else ("--disable-telemetry", "--skip-version-check")
            argv = [self.program, "--cache-dir", str(self.folder), *arguments[:1], *quiet, *arguments[1:]]
            if arguments != ("--version",):
                argv[1:1] = ["--timeout", f"{int(seconds)}s"]
            done = _call(argv, env, nowhere, seconds)
        if done.returncode != 0:
            raise ScannerFailed(f"trivy {arguments[0]}: {_reason(done.stderr) or f'exit code {done.returncode}'}")
        return done.stdout


def read_report(written: bytes, what: str) -> Report:
    """Parses the text from trivy; `what` is its subject, for messages."""
    text = f"trivy did not write a report about {what}"
    try:
        report = Report.model_validate(untrusted.json_value(written, WRITTEN_BYTES))
    except ValidationError as error:
        raise ScannerFailed(f"{text}: {first_of(error)}", ANOTHER) from None
    except ValueError as error:
        raise ScannerFailed(f"{text}: it is no JSON: {error}", ANOTHER) from None
    if report.SchemaVersion != REPORT_FORMAT:
        raise ScannerFailed(text, ANOTHER)
    return report


def resolve(rules: DatabaseRules, head: Callable[[str], str]) -> str:
    """The newest state of the database, for all shards of a run. `head` returns the digest of a reference, or an empty text."""
    reasons = []
    for repository in rules.repositories:
        tagged = ":" in repository.rpartition("/")[2]
        name, _, tag = repository.rpartition(":") if tagged else (repository, "", str(DATABASE_FORMAT))
        try:
            if digest := head(f"{name}:{tag}"):
                return f"{name}@{digest}"
            reasons.append(f"{name}:{tag}: there is no such tag")
        except RosmlError as error:
            reasons.append(f"{name}:{tag}: {error.message}")
    raise _unreachable("no repository says which database of vulnerabilities it has", reasons)


def _unreachable(text: str, reasons: Iterable[str]) -> ScannerFailed:
    lines = "".join(f"\n    {reason}" for reason in dict.fromkeys(reasons))
    remedy = "see database.repositories in the policy, and whether this machine reaches them"
    return ScannerFailed(f"{text}:{lines}", remedy)


def _call(argv: Sequence[str], env: Mapping[str, str], folder: str, seconds: float) -> subprocess.CompletedProcess[str]:
    try:
        # trivy itself stops at its timeout, and says in what it was stuck; this is for one that does not.
        return subprocess.run(
            argv,
            stdin=subprocess.DEVNULL,
            capture_output=True,
            env=env,
            cwd=folder,
            text=True,
            errors="replace",
            timeout=seconds * 1.1 + 1,
            check=False,
        )
    except OSError as error:
        raise ScannerFailed(f"cannot run {argv[0]}: {error.strerror}", INSTALL) from None
    except subprocess.TimeoutExpired:
        raise ScannerFailed(f"trivy did not end within {seconds:.0f} s", "run it again") from None


def _reason(errors: str) -> str:
    """The reason in a failed trivy's output: from its FATAL line on, without time and level."""
    lines = [line.strip() for line in errors.splitlines() if line.strip()]
    start = next((number for number, line in enumerate(lines) if "\tFATAL\t" in line), max(0, len(lines) - 1))
    text = " ".join(lines[start:]).rpartition("\tFATAL\t")[2]
    text = re.sub(r"\s+", " ", text).removeprefix("Fatal error ")
    return text if len(text) <= 500 else f"{text[:300]} … {text[-200:]}"


def _written_moment(text: str) -> str:
    """A time of trivy's, in UTC and whole seconds. Its year 1 means never: a `ValueError`."""
    if text.startswith("0001-"):
        raise ValueError("never")
    moment = datetime.fromisoformat(text).astimezone(UTC).replace(tzinfo=None, microsecond=0)
    return f"{moment.isoformat()}Z"  # strftime writes the year 900 with three digits


def _moment(text: str) -> datetime:
    return datetime.strptime(text, "%Y-%m-%dT%H:%M:%SZ").replace(tzinfo=UTC)


def _hours(age: timedelta) -> str:
    hours = age.total_seconds() / 3600
    return f"{hours:.0f} hours" if hours < 72 else f"{hours / 24:.0f} days"
