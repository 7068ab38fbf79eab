"""`rosml locks`: writes the hash-pinned locks in locks/ from matrix.yaml, and updates the digests of base images in
it."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from rosml import ROOT, own_of
from rosml.base import files, github, terminal
from rosml.base.errors import RosmlError
from rosml.cli import options
from rosml.cli.checkout import Command
from rosml.cli.command import say

if TYPE_CHECKING:
    from rosml.images.image_set.model import ImageSet
    from rosml.images.locks.base_digests import Pins
    from rosml.images.locks.lock import Move
    from rosml.images.locks.shared_files import Difference
    from rosml.images.locks.upstream import Newer
    from rosml.images.scan.locked import Refused

COLUMNS = ("stack", "package", "old", "new", "locks")
UPSTREAM = ("stack", "package", "ours", "newest", "since", "held by")

UNSHARED = "name the files in prune.txt of both parts, or take them out of the shared part's keep.txt (components/)"
"""The remedy if the wheels for two Pythons differ in the files of a part for every Python."""


@dataclass(frozen=True)
class Call:
    """The options of a call."""

    upgrade: bool
    bases: bool
    upstream: bool
    installs: bool
    check: bool
    stacks: tuple[str, ...]
    matrix: Path
    report: Path | None
    as_json: bool


@dataclass(frozen=True)
class Changes:
    """What a call changed, or would change: paths of locks, and those of them that are new.

    Attributes:
        moved: versions, and how many locks have each.
        left_out: requests that got no new lock, with the reason.
        bases: base images, if the call looked at them.
        differing: wheels whose files differ from those of a part for every Python.
        refused: versions that the scan will stop; `refused_unknown` is why these are not known.
    """

    moved: Mapping[Move, int] = field(default_factory=dict)
    changed: Sequence[str] = ()
    new: Sequence[str] = ()
    left_out: Mapping[str, str] = field(default_factory=dict)
    bases: Pins | None = None
    differing: Sequence[Difference] = ()
    refused: Sequence[Refused] = ()
    refused_unknown: str = ""


@click.command("locks", short_help="Resolves versions of Python packages, and writes the locks.", cls=Command)
@click.option(
    "--upgrade",
    is_flag=True,
    help="Take the newest versions that fit, and update base images to what their tags point at. Without it, versions stay.",
)
@click.option("--bases", is_flag=True, help="Only update base images to what their tags point at; resolve nothing.")
@click.option(
    "--upstream",
    is_flag=True,
    help="List the releases on the index that the matrix lacks, since when they exist, and what holds them back.",
)
@click.option(
    "--installs",
    is_flag=True,
    help="Find which releases of other packages you get if you install them into images, and write that to"
    " docs/installs.md; exit 1 if constraints force older releases than necessary.",
)
@click.option("--check", is_flag=True, help="Write nothing; exit 1 if a lock or a base image would change.")
@click.option(
    "--stack",
    "stacks",
    multiple=True,
    metavar="NAME",
    help="Only the locks of this stack, or of this distribution's wheels.",
)
@options.MATRIX
@click.option(
    "--report",
    type=click.Path(path_type=Path, dir_okay=False),
    help="Write the table of versions into this file, as Markdown.",
)
@click.option("--json", "as_json", is_flag=True, help="Print what moved as JSON, and all else on standard error.")
def main(**values: Any) -> None:
    """Resolves every stack for every Python version and architecture, and writes the locks that changed. In a set, these are locks that
    differ from rosml's: they go into the set's own folder.

    --upgrade and --bases also update the digests of base images in matrix.yaml; run 'rosml generate' afterwards.
    If you have the scanner ('rosml setup scanner'), the command lists the versions that the scan will stop, by
    scan.yaml.

    \b
    Examples:
      rosml locks              after a change in matrix.yaml
      rosml locks --upgrade    take new releases of the dependencies
      rosml locks --stack cpu  the locks of one stack
      rosml locks --check --json   what would move, for machines
      rosml locks --bases      take new base images
      rosml locks --upstream   releases of PyTorch and TensorFlow that no stack has yet
      rosml locks --installs   what you get if you install gradio, jax or vllm
    """
    from rosml.images.image_set import load

    call = Call(**values)
    image_set = load.without_locks(call.matrix)
    require_alone(call)
    require_stacks(image_set, call.stacks)
    if call.installs:
        write_installs(call.matrix)
    elif call.upstream:
        show_upstream(image_set, call)
    elif call.bases:
        update_bases(call)
    else:
        update_locks(image_set, call)


def require_alone(call: Call) -> None:
    """Refuses options that exclude each other."""
    if call.upstream and (call.upgrade or call.bases or call.check):
        raise click.UsageError("--upstream writes no lock; leave --upgrade, --bases and --check out")
    if call.bases and (call.upgrade or call.stacks):
        raise click.UsageError("--bases updates only base images; leave --upgrade and --stack out")
    if call.installs and (call.upstream or call.upgrade or call.bases or call.check or call.stacks):
        raise click.UsageError("--installs looks at all stacks, and writes no lock; give no other option")


def require_stacks(image_set: ImageSet, stacks: Sequence[str]) -> None:
    from rosml.base.problems import listed, unknown

    names = [*image_set.matrix.stacks, *(item.distribution for item in image_set.wheels)]
    for name in stacks:
        if name not in names:
            raise RosmlError(unknown("stack", name, names), f"there is {listed(names)}", exit_code=2)


# ---- Locks -----------------------------------------------------------------------------------------------------------


def update_locks(image_set: ImageSet, call: Call) -> None:
    from rosml.cli.images import tables
    from rosml.images.image_set import locked
    from rosml.images.locks.lock import lock, moves

    bases = base_images(call) if call.upgrade and not call.stacks else None
    locks = lock(image_set, ROOT, upgrade=call.upgrade, say=say, stacks=call.stacks)
    of_stacks = (path for path in locked.locks(ROOT) if path.startswith("locks/"))  # others are made by `rosml env add`
    present = {path for path in of_stacks if not call.stacks or path.split("/")[1] in call.stacks}
    earlier = {path: (ROOT / path).read_text(errors="replace") for path in present & locks.texts.keys()}
    outdated = {path: text for path, text in sorted(locks.texts.items()) if earlier.get(path) != text}
    folder = own_of(ROOT)
    for path, text in () if call.check else outdated.items():
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        files.write(folder / path, text, within=folder)
    for path in outdated:  # after all is written: the reader of a pipe may stop reading
        terminal.echo(f"{path}: {'would change' if call.check else 'written'}", err=call.as_json)
    moved = moves(earlier, {path: text for path, text in outdated.items() if path in earlier})
    if not call.as_json:
        tables.show(COLUMNS, rows_of(moved))
    new = [path for path in outdated if path not in earlier]
    differing = differences(image_set, locks.texts, call.stacks)
    changes = Changes(moved, [*outdated], new, locks.left_out, bases, differing, *judged(image_set, locks.texts))
    if call.report:
        newer = upstream_text(newer_releases(image_set, call.stacks)) if call.upgrade else ""
        files.write(call.report, pull_request(changes) + newer)
    for path in sorted(locked.locks(folder) & present - locks.texts.keys()):
        terminal.echo(f"{path}: belongs to nothing in {call.matrix.name}; delete it", err=call.as_json)
    warn(changes)
    word = "outdated" if call.check else "changed"
    terminal.echo(f"{len(locks.texts)} locks, {len(outdated)} {word}", err=call.as_json)
    finish(call, changes)


def warn(changes: Changes) -> None:
    """Prints what got no lock, and which images will fail their tests or the scan."""
    unknown = [changes.refused_unknown] if changes.refused_unknown else []
    lines = [f"{request}: no new lock: {reason}" for request, reason in changes.left_out.items()]
    lines += [*map(str, changes.differing), *map(str, changes.refused), *unknown]
    if changes.differing:
        lines.append(f"images with these parts will fail their tests; {UNSHARED}")
    if changes.refused:
        lines.append(
            "raise the versions that the scan will stop, or add entries to scan.yaml, with a reason and a last day"
        )
    for line in lines:
        terminal.echo(line, err=True)


def finish(call: Call, changes: Changes) -> None:
    """Prints the changes for --json. For --check, ends the command with an error if there are any: it names the command that
    writes them."""
    from rosml.base.problems import counted, listed

    if call.as_json:
        terminal.echo(to_json(changes))
    bases, locks = len(changes.bases.moved) if changes.bases else 0, len(changes.changed)
    outdated = [counted(number, noun) for number, noun in ((bases, "base image"), (locks, "lock")) if number]
    if not call.check or not outdated:
        return
    words = ["rosml locks", *(f"--{name}" for name in ("bases", "upgrade") if getattr(call, name))]
    words += [f"--stack {stack}" for stack in call.stacks]
    generate = ", then 'rosml generate'," if bases else ""
    text = f"{listed(outdated)} {'is' if bases + locks == 1 else 'are'} outdated"
    error = RosmlError(text, f"run '{' '.join(words)}'{generate} and commit the result")
    if not call.as_json:
        raise error
    # The one object is printed already.
    terminal.echo(f"error: {error.message}\nremedy: {error.remedy}", err=True)
    raise click.exceptions.Exit(error.exit_code)


def differences(image_set: ImageSet, texts: Mapping[str, str], stacks: Sequence[str]) -> list[Difference]:
    """The files that a part for every Python has otherwise than the wheels of another Python."""
    from rosml.base import web
    from rosml.images.locks import shared_files
    from rosml.images.locks.index import Index
    from rosml.images.locks.uv import Uv

    with web.client(timeout=60) as client:
        return shared_files.differences(image_set, ROOT, Index(Uv(), client), texts, stacks)


def judged(image_set: ImageSet, texts: Mapping[str, str]) -> tuple[list[Refused], str]:
    """The locked versions that the scan will stop by scan.yaml; or the reason why these are not known."""
    from datetime import UTC, datetime

    from rosml.images.scan import locked, policy
    from rosml.images.scan.trivy import ScannerFailed, Trivy

    try:
        trivy = Trivy.find(ROOT)
        return locked.refused(image_set, texts, policy.load(ROOT / "scan.yaml"), trivy, datetime.now(UTC), say), ""
    except ScannerFailed as error:
        remedy = f"; {error.remedy}" if error.remedy else ""
        return [], f"cannot tell which locked versions the scan will stop: {error.message}{remedy}"


# ---- Other calls -----------------------------------------------------------------------------------------------------


def write_installs(matrix: Path) -> None:
    """Writes which releases people get of packages that they install, as data and as a page."""
    from rosml.images.image_set import load
    from rosml.images.locks import installs

    resolved = installs.look(load.load(matrix, ROOT), ROOT, say=say)
    files.write(ROOT / installs.FILE, installs.to_json(resolved), within=ROOT)
    files.write(ROOT / installs.PAGE, installs.render(files.text(ROOT / installs.PAGE), resolved), within=ROOT)
    if too_old := installs.too_old(resolved):
        raise RosmlError("\n".join(too_old), "correct components/*/pins.txt or components/base/constraints.sh")
    terminal.echo(f"{installs.FILE}, {installs.PAGE}: written")


def show_upstream(image_set: ImageSet, call: Call) -> None:
    from rosml.base.problems import counted
    from rosml.cli.images import tables

    newer = newer_releases(image_set, call.stacks)
    if call.report:
        files.write(call.report, upstream_text(newer))
    if call.as_json:
        terminal.echo(json.dumps([asdict(item) for item in newer], indent=2, ensure_ascii=False))
        return
    tables.show(UPSTREAM, upstream_rows(newer), wrapped=("held by",))
    terminal.echo(
        counted(len(newer), "newer release") if newer else "no release is newer than those that the matrix names"
    )


def newer_releases(image_set: ImageSet, stacks: Sequence[str]) -> list[Newer]:
    from rosml.images.locks import upstream

    return upstream.look(image_set, stacks=stacks, say=say)


def update_bases(call: Call) -> None:
    bases = base_images(call)
    if call.report:
        files.write(call.report, base_table(bases))
    finish(call, Changes(bases=bases))


def base_images(call: Call) -> Pins:
    """Asks where the tags of base images point, and writes that into the matrix, unless the call only checks."""
    from rosml.images.image_set import load
    from rosml.images.locks import base_digests
    from rosml.images.matrix import extends
    from rosml.registry.client import Registries

    document = extends.read(call.matrix)
    systems = base_digests.pinned(document)
    with Registries(os.environ.get("SSL_CERT_FILE", "")) as registries:
        bases = base_digests.look(load.image_set(document).matrix, systems, registries)
    if bases.moved and not call.check:
        files.write(call.matrix, base_digests.rewritten(call.matrix.read_text(encoding="utf-8"), document, bases.moved))
    for system, image, before, after in base_digests.rows(bases.moved):
        verb = "would move" if call.check else "moved"
        terminal.echo(f"{system}: {image}: {verb} from {before} to {after}", err=call.as_json)
    for line in base_digests.reasons(bases.left_out):
        terminal.echo(line, err=True)
    word = "outdated" if call.check else "changed"
    terminal.echo(f"{len(systems)} base images, {len(bases.moved)} {word}", err=call.as_json)
    return bases


# ---- JSON, and Markdown for a pull request ---------------------------------------------------------------------------


def to_json(changes: Changes) -> str:
    """The changes for machines. The version of a package that a lock lacked, or lacks now, is `null`."""
    bases = changes.bases
    data = {
        "moved": [
            {"stack": m.stack, "package": m.package, "old": m.before or None, "new": m.after or None, "locks": count}
            for m, count in sorted(changes.moved.items())
        ],
        "changed": changes.changed,
        "new": changes.new,
        "left_out": changes.left_out,
        "base_images": [
            {"system": pin.system, "image": pin.image, "old": pin.before, "new": pin.after}
            for pin in (bases.moved if bases else ())
        ],
        "base_images_left_out": bases.left_out if bases else {},
        "differing": [asdict(item) for item in changes.differing],
        "refused": [item.to_json() for item in changes.refused],
        "refused_unknown": changes.refused_unknown,
    }
    return json.dumps(data, indent=2, ensure_ascii=False)


def pull_request(changes: Changes) -> str:
    text = github.table(COLUMNS, rows_of(changes.moved)) if changes.moved else "No version moved.\n"
    lines = [f"- new: `{path}`" for path in changes.new]
    lines += [f"- {request}: no new lock: {reason}" for request, reason in changes.left_out.items()]
    text += "\n" + "\n".join(lines) + "\n" if lines else ""
    text += base_table(changes.bases) if changes.bases else ""
    if changes.differing:
        items = "".join(f"- {item}\n" for item in changes.differing)
        text += f"\nImages with these parts will fail their tests; {UNSHARED}:\n\n{items}"
    return text + refused_table(changes.refused, changes.refused_unknown)


def rows_of(moved: Mapping[Move, int]) -> list[tuple[str, ...]]:
    return [(m.stack, m.package, m.before or "-", m.after or "-", str(count)) for m, count in sorted(moved.items())]


def base_table(bases: Pins) -> str:
    """The base images that moved, and those that could not be checked."""
    from rosml.images.locks import base_digests

    rows = base_digests.rows(bases.moved)
    text = github.table(("system", "base image", "old", "new"), rows) if rows else "No base image moved.\n"
    lines = "".join(f"- {line}\n" for line in base_digests.reasons(bases.left_out))
    return f"\n{text}" + (f"\n{lines}" if lines else "")


def refused_table(refused: Sequence[Refused], unknown: str) -> str:
    if unknown:
        return f"\n{unknown[0].upper()}{unknown[1:]}\n"
    if not refused:
        return "\nThe scan will stop none of the locked versions.\n"
    rows = [(it.package, it.version, it.id, it.severity, it.fixed or "-", str(len(it.images))) for it in refused]
    columns = ("package", "version", "advisory", "severity", "fixed in", "images")
    return "\nBy `scan.yaml`, the scan will stop images with these versions:\n\n" + github.table(columns, rows)


def upstream_text(newer: Sequence[Newer]) -> str:
    if not newer:
        return "\nNo release on the index is newer than those that the matrix names.\n"
    return "\nOn the index, and not in the matrix:\n\n" + github.table(UPSTREAM, upstream_rows(newer))


def upstream_rows(newer: Sequence[Newer]) -> list[tuple[str, ...]]:
    return [
        (
            f"{item.stack}, Python {', '.join(item.pythons)}",
            item.package,
            item.ours,
            item.newest,
            item.since or "-",
            (item.held_by or "nothing: name it in matrix.yaml")
            + (f" ({', '.join(item.elsewhere)} has it)" if item.elsewhere else ""),
        )
        for item in newer
    ]
