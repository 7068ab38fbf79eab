"""What differs between two versions of the project: images that are added, removed or changed, and why."""

from __future__ import annotations

import io
import json
import re
import subprocess
import tarfile
import tempfile
from collections.abc import Iterable, Iterator
from dataclasses import asdict, dataclass, field
from functools import cache
from pathlib import Path

from rosml import expand, source
from rosml.errors import RosmlError
from rosml.inputs import TARGET, Inputs
from rosml.problems import InputError, some


@dataclass(frozen=True)
class Change:
    """An input that differs; None on the side that does not have it."""

    input: str
    old: str | None
    new: str | None


@dataclass(frozen=True)
class Difference:
    """Targets of images that are added and removed, and why the others changed. `same`: how many did not. `tags`: those
    that lead from one image to another now, or from one that stays to none."""

    added: tuple[str, ...]
    removed: tuple[str, ...]
    changed: dict[str, tuple[Change, ...]]
    same: int
    tags: dict[str, tuple[str, str | None]] = field(default_factory=dict)


def since(version: str, now: Inputs) -> Difference:
    """From a git revision, or from another matrix file with everything else as it is now.

    Raises:
        RosmlError: there is no such version, or this version of the project cannot read it.
    """
    if Path(version).is_file():
        return between(Inputs(now.root, expand.load(Path(version))), now)
    with tempfile.TemporaryDirectory() as folder:
        _unpack(version, now.root, Path(folder))
        return between(Inputs(Path(folder), _catalogue(version, Path(folder) / "matrix.yaml")), now)


def between(old: Inputs, new: Inputs) -> Difference:
    """From one version to another."""

    @cache
    def changes(target: str, architecture: str) -> frozenset[Change]:
        before, after = old.of(target, architecture), new.of(target, architecture)
        found: set[Change] = set()
        for name in before.keys() | after.keys():
            if before.get(name) != after.get(name):
                if name.startswith(TARGET) and name in before and name in after:
                    found |= changes(name.removeprefix(TARGET), architecture)
                else:
                    found.add(Change(name, before.get(name), after.get(name)))
        return frozenset(found)

    def reasons(target: str) -> Iterator[Change]:
        before, after = (side.digests(side.catalogue.by_target[target]) for side in (old, new))
        for architecture in before.keys() | after.keys():
            if architecture in before and architecture in after:
                yield from changes(target, architecture)
            else:
                sides = ["built" if architecture in side else None for side in (before, after)]
                yield Change(f"architecture {architecture}", *sides)

    was, now = old.catalogue.by_target, new.catalogue.by_target
    found = {target: _ordered(reasons(target)) for target in now if target in was}
    changed = {target: why for target, why in found.items() if why}
    added, removed = tuple(name for name in now if name not in was), tuple(name for name in was if name not in now)
    return Difference(added, removed, changed, len(found) - len(changed), _moved(old.catalogue, new.catalogue))


def _moved(old: expand.Catalogue, new: expand.Catalogue) -> dict[str, tuple[str, str | None]]:
    before, after = ({tag: image.target for image in side.images for tag in image.tags} for side in (old, new))
    return {
        tag: (target, after.get(tag))
        for tag, target in before.items()
        if after.get(tag) != target and (tag in after or target in new.by_target)
    }


def as_json(difference: Difference) -> str:
    """All of it, with whole digests."""
    return json.dumps(asdict(difference), indent=2) + "\n"


def rows(difference: Difference) -> Iterator[tuple[str, str, str]]:
    """What happened, why and to which images: a row for each reason, one for reasons that reach the same images."""
    for kind in ("added", "removed"):
        if targets := getattr(difference, kind):
            yield kind, "", some(targets)
    for tag, (was, now) in difference.tags.items():
        yield "tag moved" if now else "tag gone", f"{was} → {now or 'nothing'}", tag
    reached: dict[Change, list[str]] = {}
    for target, why in difference.changed.items():
        # Labels spell out what the other inputs say, for each image in its own words.
        for item in [item for item in why if not item.input.startswith("label ")] or why:
            reached.setdefault(item, []).append(target)
    alike: dict[tuple[str, ...], list[str]] = {}
    for item, targets in reached.items():
        alike.setdefault(tuple(targets), []).append(_sentence(item))
    for images, reasons in alike.items():
        yield "changed", "\n".join(reasons), some(images)


def print_table(difference: Difference) -> None:
    """Prints it in few lines, whatever the number of images."""
    from rich.table import Table  # slow to import, and only needed here
    from rich.text import Text

    from rosml.listing import console

    table = Table(box=None, header_style="bold", pad_edge=False, padding=(0, 2, 0, 0))
    for column in ("what", "why", "which"):
        table.add_column(column, overflow="fold")
    for row in rows(difference):
        table.add_row(*map(Text, row))
    out = console()
    if table.row_count:
        out.print(table)
    counts = [f"{len(getattr(difference, name))} {name}" for name in ("added", "removed", "changed")]
    out.print(", ".join([*counts, f"{difference.same} same"]), style="dim")


def _ordered(changes: Iterable[Change]) -> tuple[Change, ...]:
    return tuple(sorted(set(changes), key=lambda change: (change.input, change.old or "", change.new or "")))


def _sentence(change: Change) -> str:
    """An input with the words that differ, digests shortened."""
    old, new = ((value or "").split() for value in (change.old, change.new))
    sides = [[word for word in old if word not in new], [word for word in new if word not in old]]
    words = [" ".join(side) or "nothing" for side in (sides if any(sides) else [old, new])]
    return re.sub(r"\b([0-9a-f]{12})[0-9a-f]{52}\b", r"\1", f"{change.input}: {' → '.join(words)}")


def _catalogue(revision: str, file: Path) -> expand.Catalogue:
    if not file.is_file():
        raise RosmlError(f"revision {revision} has no matrix.yaml", remedy="name a later one", exit_code=2)
    try:
        return expand.catalogue(source.parse(file.read_bytes(), f"{revision}:matrix.yaml"))
    except InputError as error:
        reason = f"this version of the project does not understand the matrix of revision {revision}:\n{error.message}"
        raise RosmlError(reason, remedy="compare with a later revision", exit_code=2) from None


def _unpack(revision: str, root: Path, folder: Path) -> None:
    """The files of a revision."""
    commit = _git(root, "rev-parse", "--verify", "--quiet", "--end-of-options", f"{revision}^{{commit}}")
    if not commit:
        remedy = "see the revisions with: git log --oneline --all (a shallow clone lacks most: git fetch --unshallow)"
        raise RosmlError(f"no revision and no file named {revision!r}", remedy=remedy, exit_code=2)
    content = _git(root, "archive", "--format=tar", commit.decode().strip())
    try:
        with tarfile.open(fileobj=io.BytesIO(content)) as archive:
            archive.extractall(folder, filter="data")
    except tarfile.TarError as error:  # such as a link to a place outside of the checkout
        raise RosmlError(f"revision {revision} cannot be unpacked: {error}", "compare with another one") from None


def _git(root: Path, *arguments: str) -> bytes:
    """What git says; nothing where it fails silently."""
    remedy = "call it in a git checkout, or name another matrix file"
    try:
        done = subprocess.run(["git", *arguments], cwd=root, capture_output=True, check=False)
    except FileNotFoundError:
        raise RosmlError("git is not installed", remedy=remedy) from None
    if done.returncode and done.stderr:
        raise RosmlError(f"git cannot read {root}: {done.stderr.decode(errors='replace').strip()}", remedy=remedy)
    return done.stdout
