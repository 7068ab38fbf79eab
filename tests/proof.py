"""What only `make test-all` proves, one file for each proof in `tests/proofs/`: which committed files it depends on, and the
digest that they had, the counts and the date when it was last proved. `make test` fails where they changed since."""

from __future__ import annotations

import hashlib
import json
import re
import subprocess
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path

import yaml

from rosml import expand
from rosml.inputs import Inputs

ROOT = Path(__file__).resolve().parent.parent
FOLDER = ROOT / "tests" / "proofs"


@cache
def names(folder: Path = FOLDER) -> tuple[str, ...]:
    """All proofs."""
    return tuple(sorted(file.stem for file in folder.glob("*.yaml")))


@dataclass(frozen=True)
class Proved:
    """An outcome: the day, the digest of what the proof depends on, tests that passed, and the digest of the log."""

    date: str
    digest: str
    passed: int
    log: str


@dataclass(frozen=True)
class Proof:
    """A proof.

    Attributes:
        name: of its file, and of the tests' marker: `full(proof=NAME)`. proves: what, in a sentence.
        targets: bake targets whose inputs it depends on. files: committed files, as patterns of git.
        tests: what pytest runs. environment: of that run. needs: commands of scripts/bootstrap.py that set up for it.
        minutes: about how long it takes on two cores.
        proved: the last outcome; None before the first one.
    """

    name: str
    proves: str
    minutes: float
    targets: Sequence[str] = ()
    files: Sequence[str] = ()
    tests: Sequence[str] = ()
    environment: Mapping[str, str] = field(default_factory=dict)
    needs: Sequence[str] = ()
    proved: Proved | None = None

    @classmethod
    def load(cls, name: str, folder: Path = FOLDER) -> Proof:
        """Reads a proof's file.

        Raises:
            KeyError, TypeError, ValueError: it is damaged.
        """
        content = yaml.safe_load((folder / f"{name}.yaml").read_text(encoding="utf-8"))
        depends = content.pop("depends")
        proved = Proved(**content.pop("proved")) if content.get("proved") else None
        return cls(
            name=name,
            targets=depends.get("targets", ()),
            files=depends.get("files", ()),
            **content | {"proved": proved},
        )

    @property
    def arguments(self) -> list[str]:
        """What pytest is told."""
        return list(self.tests) or ["-m", f'full(proof="{self.name}")', "tests/e2e"]

    @property
    def command(self) -> str:
        """What proves it anew."""
        return f"make test-all PROOF={self.name}"

    def digest(self, root: Path = ROOT) -> str:
        """Of all that it depends on in a checkout: committed files, and the inputs of images.

        Raises:
            ValueError: a pattern matches no file.
            RosmlError: there is no such target.
        """
        found: dict[str, object] = {pattern: _files(root, pattern) for pattern in self.files}
        if self.targets:
            images = expand.load(root / "matrix.yaml", root)
            inputs = Inputs(root, images)
            for target in self.targets:
                for architecture in images.image(target.removesuffix("-test")).architectures:
                    found[f"{target} {architecture}"] = inputs.digest(target, architecture)
        return "sha256:" + hashlib.sha256(json.dumps(found, sort_keys=True).encode()).hexdigest()

    def stale(self, root: Path = ROOT) -> str:
        """Why nothing proves it for a checkout; empty where something does."""
        if not self.proved:
            return f"{self.name} was never proved; run: {self.command}"
        if self.proved.digest != self.digest(root):
            return f"what {self.name} depends on has changed since {self.proved.date}; run: {self.command}"
        return ""

    def record(self, proved: Proved, folder: Path = FOLDER) -> None:
        """Writes an outcome into its file; the rest stays as it is."""
        file = folder / f"{self.name}.yaml"
        kept = re.sub(r"^proved:.*\Z", "", file.read_text(encoding="utf-8"), flags=re.MULTILINE | re.DOTALL)
        file.write_text(kept + yaml.safe_dump({"proved": vars(proved)}, sort_keys=False), encoding="utf-8")


def _files(root: Path, pattern: str) -> dict[str, str]:
    """The digests of files that git tracks, or would, by path."""
    listed = ["git", "-C", str(root), "ls-files", "--cached", "--others", "--exclude-standard", "-z", "--", pattern]
    done = subprocess.run(listed, capture_output=True, text=True, check=True)
    paths = [root / path for path in sorted(set(filter(None, done.stdout.split("\0"))))]
    found = {
        path.relative_to(root).as_posix(): hashlib.sha256(path.read_bytes()).hexdigest()
        for path in paths
        if path.is_file()
    }
    if not found:
        raise ValueError(f"no committed file matches {pattern!r}")
    return found
