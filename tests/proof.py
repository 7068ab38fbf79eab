"""Proofs: what only `make test-all` runs, a file each in `tests/proofs/`.

A proof's file says what it proves, how it is run, which files it is about, and how its last run ended. An old proof fails
nothing: the list says how many commits have touched those files since.
"""

from __future__ import annotations

import re
import subprocess
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path

import yaml

from rosml.base.errors import RosmlError
from rosml.base.files import write

ROOT = Path(__file__).resolve().parent.parent
FOLDER = ROOT / "tests" / "proofs"


@cache
def names(folder: Path = FOLDER) -> tuple[str, ...]:
    """All proofs."""
    return tuple(sorted(file.stem for file in folder.glob("*.yaml")))


@dataclass(frozen=True)
class Run:
    """How a run of a proof ended: its day, the commit that was checked out, and how many tests came to what."""

    date: str
    commit: str
    passed: int
    failed: int = 0
    skipped: int = 0

    @property
    def outcome(self) -> str:
        """`5 passed, 1 failed`."""
        counts = {"passed": self.passed, "failed": self.failed, "skipped": self.skipped}
        return ", ".join(f"{count} {name}" for name, count in counts.items() if count or name == "passed")


@dataclass(frozen=True)
class Proof:
    """A proof.

    Attributes:
        name: of its file, and of the tests' marker: `full(proof=NAME)`. proves: what, in a sentence.
        files: what it is about, as patterns of git.
        minutes: about how long it takes on two cores.
        tests: what pytest runs. environment: of that run. needs: commands of scripts/bootstrap.py that set up for it.
        last: its last run; None before the first one.
    """

    name: str
    proves: str
    minutes: float
    files: Sequence[str]
    tests: Sequence[str] = ()
    environment: Mapping[str, str] = field(default_factory=dict)
    needs: Sequence[str] = ()
    last: Run | None = None

    @classmethod
    def load(cls, name: str, folder: Path = FOLDER) -> Proof:
        """Reads a proof's file.

        Raises:
            RosmlError: it is damaged.
        """
        try:
            content = yaml.safe_load((folder / f"{name}.yaml").read_text(encoding="utf-8"))
            last = content.pop("last", None)
            return cls(name=name, **content, last=Run(**last) if last else None)
        except (AttributeError, TypeError, yaml.YAMLError) as error:
            text = f"tests/proofs/{name}.yaml is damaged: {type(error).__name__}: {error}"
            raise RosmlError(text, f"git checkout tests/proofs/{name}.yaml") from None

    @property
    def arguments(self) -> list[str]:
        """What pytest is told."""
        return list(self.tests) or ["-m", f'full(proof="{self.name}")', "tests/e2e"]

    def changes(self, root: Path = ROOT) -> int | None:
        """How many commits since its last run touched its files; None where git does not know: the proof never ran, the clone
        is shallow, or its commit is gone."""
        if not self.last:
            return None
        argv = ["git", "-C", str(root), "rev-list", "--count", f"{self.last.commit}..HEAD", "--", *self.files]
        try:
            return int(subprocess.run(argv, capture_output=True, text=True, check=True).stdout)
        except (OSError, subprocess.CalledProcessError):
            return None

    def record(self, run: Run, folder: Path = FOLDER) -> None:
        """Writes its last run into its file; the rest stays as it is.

        Raises:
            RosmlError: the file cannot be written; it is as it was.
        """
        file = folder / f"{self.name}.yaml"
        kept = re.sub(r"^last:.*\n(?:[ \t].*\n)*", "", file.read_text(encoding="utf-8"), flags=re.MULTILINE)
        write(file, kept + yaml.safe_dump({"last": vars(run)}, sort_keys=False))


def head(root: Path = ROOT) -> str:
    """The commit that is checked out; empty where git does not say."""
    argv = ["git", "-C", str(root), "rev-parse", "HEAD"]
    return subprocess.run(argv, capture_output=True, text=True, check=False).stdout.strip()


def table(proofs: Sequence[Proof], root: Path = ROOT) -> str:
    """When each proof last ran, how that ended, and how many commits since then touched what it is about."""
    rows = [("proof", "last run", "changes since", "outcome")]
    for proof in proofs:
        changes = proof.changes(root)
        ran = (
            (proof.last.date, "unknown" if changes is None else str(changes), proof.last.outcome) if proof.last else ()
        )
        rows.append((proof.name, *(ran or ("never", "", f"run: make test-all PROOF={proof.name}"))))
    widths = [max(len(row[column]) for row in rows) for column in range(3)]
    return "\n".join("  ".join([*map(str.ljust, row[:3], widths), row[3]]) for row in rows)
