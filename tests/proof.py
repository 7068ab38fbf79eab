"""What only `make test-all` proves, one file for each proof in `tests/proofs/`: which committed files it depends on, and the
digest that they had, the counts and the date when it was last proved. `make test` fails where they changed since."""

from __future__ import annotations

import ast
import hashlib
import io
import itertools
import json
import re
import subprocess
import tokenize
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path

import yaml

from rosml.bake.inputs import Inputs
from rosml.base.errors import RosmlError
from rosml.base.files import write
from rosml.images import load

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
            RosmlError: it is damaged, or depends on nothing.
        """
        file = folder / f"{name}.yaml"
        try:
            content = yaml.safe_load(file.read_text(encoding="utf-8"))
            depends, proved = content.pop("depends"), content.pop("proved", None)
            found = cls(name=name, **depends, **content, proved=Proved(**proved) if proved else None)
        except (AttributeError, KeyError, TypeError, yaml.YAMLError) as error:
            text = f"tests/proofs/{name}.yaml is damaged: {type(error).__name__}: {error}"
            raise RosmlError(text, f"git checkout tests/proofs/{name}.yaml") from None
        if isinstance(found.targets, str) or isinstance(found.files, str) or not (found.targets or found.files):
            raise RosmlError(f"tests/proofs/{name}.yaml depends on nothing", "list files or targets under depends")
        return found

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
            RosmlError: a pattern matches no committed file; there is no such target; this is no checkout of git.
        """
        found: dict[str, object] = {pattern: _files(root, pattern, self.name) for pattern in self.files}
        if self.targets:
            images = load.load(root / "matrix.yaml", root)
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
        """Writes an outcome into its file; the rest stays as it is.

        Raises:
            RosmlError: the file cannot be written; it is as it was.
        """
        file = folder / f"{self.name}.yaml"
        kept = re.sub(r"^proved:.*\n(?:[ \t].*\n)*", "", file.read_text(encoding="utf-8"), flags=re.MULTILINE)
        write(file, kept + yaml.safe_dump({"proved": vars(proved)}, sort_keys=False))


def _files(root: Path, pattern: str, proof: str) -> dict[str, str]:
    """The digests of files that git tracks, or would, by path; of Python, of what it says."""
    listed = ["git", "-C", str(root), "ls-files", "--cached", "--others", "--exclude-standard", "-z", "--", pattern]
    try:
        done = subprocess.run(listed, capture_output=True, text=True, check=True)
    except (OSError, subprocess.CalledProcessError) as error:
        said = str(getattr(error, "stderr", "") or error).strip()
        raise RosmlError(f"git does not list the checkout's files: {said}", "work in a clone, with git") from None
    paths = [root / path for path in sorted(set(filter(None, done.stdout.split("\0"))))]
    found = {
        path.relative_to(root).as_posix(): hashlib.sha256(_said(root, path)).hexdigest()
        for path in paths
        if path.is_file()
    }
    if not found:
        raise RosmlError(f"tests/proofs/{proof}.yaml: no committed file matches {pattern!r}", "correct its depends")
    return found


_LAYOUT = {tokenize.COMMENT, tokenize.NL, tokenize.ENCODING}
_BLOCKS = {tokenize.NEWLINE, tokenize.INDENT, tokenize.DEDENT}


def _said(root: Path, file: Path) -> bytes:
    """What counts of a file: all of it; of Python neither layout and comments, nor in which module the product keeps what
    is called, which type checks hold. So a module that moves has no proof given again."""
    content = file.read_bytes()
    if file.suffix != ".py":
        return content
    try:
        tree = ast.parse(content)
    except SyntaxError:  # or an example for another Python
        return content
    imports = [
        node
        for node in ast.walk(tree)
        if isinstance(node, ast.ImportFrom) and (node.module or "").partition(".")[0] == "rosml"
    ]
    lines = {line for node in imports for line in range(node.lineno, (node.end_lineno or node.lineno) + 1)}
    modules = {
        name.asname or name.name
        for node in imports
        for name in node.names
        if (root / (node.module or "").replace(".", "/") / f"{name.name}.py").exists()
    }
    tokens = [
        token
        for token in tokenize.tokenize(io.BytesIO(content).readline)
        if token.type not in _LAYOUT and token.start[0] not in lines
    ]
    said = [tokenize.tok_name[token.type] if token.type in _BLOCKS else token.string for token in tokens]
    for before, (here, after) in zip(["", *said], itertools.pairwise(range(len(said))), strict=False):
        if said[here] in modules and said[after] == "." and before != ".":
            said[here] = "module"
    return " ".join(said).encode()
