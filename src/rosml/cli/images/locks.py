"""`rosml locks`: writes the hash-pinned locks in locks/ from matrix.yaml, and updates the digests of base images in
it."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping, Sequence
from dataclasses import asdict
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
    from rosml.images.locks.resolve import Move
    from rosml.images.locks.shared_files import Difference
    from rosml.images.locks.upstream import Newer
    from rosml.images.scan.locked import Refused


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
def main(
    upgrade: bool,
    bases: bool,
    upstream: bool,
    installs: bool,
    check: bool,
    stacks: tuple[str, ...],
    matrix: Path,
    report: Path | None,
    as_json: bool,
) -> None:
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
    from rosml.cli.images import tables
    from rosml.images.image_set import load, locked
    from rosml.images.locks.resolve import lock, moves

    image_set = load.without_locks(matrix)
    require_alone(
        upstream, installs, bases, {"--upgrade": upgrade, "--bases": bases, "--check": check, "--stack": stacks}
    )
    require_known(image_set, stacks)
    if installs or upstream:
        tell_installs(matrix) if installs else tell_upstream(image_set, stacks, report, as_json)
        return
    pinned = base_images(matrix, check, as_json) if bases or (upgrade and not stacks) else None
    if bases and pinned:
        tell_bases(pinned, check, report, as_json)
        return
    locks = lock(image_set, ROOT, upgrade=upgrade, say=say, stacks=stacks)
    there = {path for path in locked.locks(ROOT) if not stacks or path.split("/")[1] in stacks}
    earlier = {path: (ROOT / path).read_text(errors="replace") for path in there & locks.texts.keys()}
    stale = [path for path, text in sorted(locks.texts.items()) if earlier.get(path) != text]
    own = own_of(ROOT)
    for path in () if check else stale:
        (own / path).parent.mkdir(parents=True, exist_ok=True)
        files.write(own / path, locks.texts[path], within=own)
    for path in stale:  # after all is written: the reader of a pipe may stop reading
        terminal.echo(f"{path}: {'would change' if check else 'written'}", err=as_json)
    moved = moves(earlier, {path: locks.texts[path] for path in stale if path in earlier})
    fresh = [path for path in stale if path not in earlier]
    if not as_json:
        tables.show(COLUMNS, rows_of(moved))
    differing = differences(image_set, locks.texts, stacks)
    stopped, unknown = judged(image_set, locks.texts)
    if report:
        text = markdown(moved, fresh, locks.left_out) + (base_table(pinned) if pinned else "")
        text += differences_list(differing)
        text += refused_table(stopped, unknown)
        files.write(report, text + (upstream_table(image_set, stacks) if upgrade else ""))
    for path in sorted(locked.locks(own) & there - locks.texts.keys()):
        terminal.echo(f"{path}: belongs to nothing in {matrix.name}; delete it", err=as_json)
    for request, reason in locks.left_out.items():
        terminal.echo(f"{request}: no new lock: {reason}", err=True)
    for line in [*map(str, differing), *map(str, stopped), *([unknown] if unknown else [])]:
        terminal.echo(line, err=True)
    if differing:
        terminal.echo(f"images with these parts will fail their tests; {UNSHARED}", err=True)
    if stopped:
        terminal.echo(
            "raise the versions that the scan will stop, or add entries to scan.yaml, with a reason and a last day",
            err=True,
        )
    terminal.echo(f"{len(locks.texts)} locks, {len(stale)} {'outdated' if check else 'changed'}", err=as_json)
    if as_json:
        terminal.echo(to_json(moved, stale, fresh, locks.left_out, pinned, differing, stopped, unknown))
    if check:
        words = [*(["--upgrade"] if upgrade else []), *(word for stack in stacks for word in ("--stack", stack))]
        require_fresh(len(stale), pinned, words, as_json)


def require_alone(upstream: bool, installs: bool, bases: bool, given: Mapping[str, object]) -> None:
    """Refuses options that exclude each other.

    Args:
        upstream: whether --upstream is given.
        installs: whether --installs is given.
        bases: whether --bases is given.
        given: the values of the options that may exclude these.
    """
    if upstream and (given["--upgrade"] or given["--bases"] or given["--check"]):
        raise click.UsageError("--upstream writes no lock; leave --upgrade, --bases and --check out")
    if bases and (given["--upgrade"] or given["--stack"]):
        raise click.UsageError("--bases updates only base images; leave --upgrade and --stack out")
    if installs and (upstream or any(given.values())):
        raise click.UsageError("--installs looks at all stacks, and writes no lock; give no other option")


def require_known(image_set: ImageSet, stacks: Sequence[str]) -> None:
    """Refuses unknown stacks."""
    from rosml.base.problems import listed, unknown

    known = [*image_set.matrix.stacks, *(item.distribution for item in image_set.wheels)]
    for name in stacks:
        if name not in known:
            raise RosmlError(unknown("stack", name, known), f"there is {listed(known)}", exit_code=2)


def tell_installs(matrix: Path) -> None:
    """Finds which releases people get of packages that they install, and writes the data and the page.

    Raises:
        RosmlError: constraints force older releases than necessary.
    """
    from rosml.images.image_set import load
    from rosml.images.locks import installs

    found = installs.look(load.load(matrix, ROOT), ROOT, say=say)
    files.write(ROOT / installs.FILE, installs.to_json(found), within=ROOT)
    files.write(ROOT / installs.PAGE, installs.render(files.text(ROOT / installs.PAGE), found), within=ROOT)
    wrong = installs.too_old(found)
    if wrong:
        raise RosmlError("\n".join(wrong), "correct components/*/pins.txt or components/base/constraints.sh")
    terminal.echo(f"{installs.FILE}, {installs.PAGE}: written")


UPSTREAM = ("stack", "package", "ours", "newest", "since", "held by")


def tell_upstream(image_set: ImageSet, stacks: Sequence[str], report: Path | None, as_json: bool) -> None:
    """Prints the releases on the index that the matrix lacks."""
    from rosml.base.problems import counted
    from rosml.cli.images import tables
    from rosml.images.locks import upstream

    found = upstream.look(image_set, stacks=stacks, say=say)
    if report:
        files.write(report, upstream_text(found))
    if as_json:
        terminal.echo(json.dumps([asdict(item) for item in found], indent=2, ensure_ascii=False))
        return
    tables.show(UPSTREAM, upstream_rows(found), wrapped=("held by",))
    terminal.echo(
        f"{counted(len(found), 'newer release')}" if found else "no release is newer than those that the matrix names"
    )


def upstream_table(image_set: ImageSet, stacks: Sequence[str]) -> str:
    """The releases on the index that the matrix lacks, as Markdown for a pull request."""
    from rosml.images.locks import upstream

    return upstream_text(upstream.look(image_set, stacks=stacks, say=say))


def upstream_text(found: Sequence[Newer]) -> str:
    """Releases that the matrix lacks, as Markdown."""
    if not found:
        return "\nNo release on the index is newer than those that the matrix names.\n"
    return "\nOn the index, and not in the matrix:\n\n" + github.table(UPSTREAM, upstream_rows(found))


def upstream_rows(found: Sequence[Newer]) -> list[tuple[str, ...]]:
    """A row for each release."""
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
        for item in found
    ]


def tell_bases(pinned: Pins, check: bool, report: Path | None, as_json: bool) -> None:
    """Reports which base images moved, for --bases.

    Args:
        pinned: the base images.
        check: raise an error if any moved.
        report: a file for the table, as Markdown.
        as_json: print them as JSON.
    """
    if report:
        files.write(report, base_table(pinned))
    if as_json:
        terminal.echo(to_json(pinned=pinned))
    if check:
        require_fresh(0, pinned, ["--bases"], as_json)


def require_fresh(locks: int, pinned: Pins | None, words: Sequence[str], as_json: bool) -> None:
    """Ends the command with an error if something is stale. The error names it, and the command that writes it.

    Args:
        locks: how many locks are stale.
        pinned: base images, if they were looked at.
        words: the options of the command.
        as_json: print the error on standard error alone.
    """
    from rosml.base.problems import counted, listed

    bases = len(pinned.moved) if pinned else 0
    stale = [counted(number, what) for number, what in ((bases, "base image"), (locks, "lock")) if number]
    if stale:
        wrong = f"{listed(stale)} {'is' if bases + locks == 1 else 'are'} outdated"
        generate = ", then 'rosml generate'," if bases else ""
        stop(RosmlError(wrong, f"run '{' '.join(['rosml locks', *words])}'{generate} and commit the result"), as_json)


def stop(error: RosmlError, as_json: bool) -> None:
    """Ends the command with an error. With `--json`, the one object is printed already, so the error goes to standard
    error."""
    if not as_json:
        raise error
    terminal.echo(f"error: {error.message}\nremedy: {error.remedy}", err=True)
    raise click.exceptions.Exit(error.exit_code)


def to_json(
    moved: Mapping[Move, int] | None = None,
    stale: Sequence[str] = (),
    fresh: Sequence[str] = (),
    left_out: Mapping[Any, str] | None = None,
    pinned: Pins | None = None,
    differing: Sequence[Difference] = (),
    stopped: Sequence[Refused] = (),
    unknown: str = "",
) -> str:
    """What `--json` prints. The version of a package that a lock lacked, or lacks now, is `null`.

    Args:
        moved: versions, and how many locks have each.
        stale: locks that changed, or would change.
        fresh: the new ones of these.
        left_out: requests that got no new lock, with the reason.
        pinned: base images.
        differing: wheels whose files differ from those of a part for every Python.
        stopped: versions that the scan will stop.
        unknown: why these are not known.
    """
    found = {
        "moved": [
            {"stack": m.stack, "package": m.package, "old": m.before or None, "new": m.after or None, "locks": count}
            for m, count in sorted((moved or {}).items())
        ],
        "changed": list(stale),
        "new": list(fresh),
        "left_out": {str(request): reason for request, reason in (left_out or {}).items()},
        "base_images": [
            {"system": pin.system, "image": pin.image, "old": pin.before, "new": pin.after}
            for pin in (pinned.moved if pinned else ())
        ],
        "base_images_left_out": dict(pinned.left_out) if pinned else {},
        "differing": [asdict(item) for item in differing],
        "refused": [item.to_json() for item in stopped],
        "refused_unknown": unknown,
    }
    return json.dumps(found, indent=2, ensure_ascii=False)


def base_images(matrix: Path, check: bool, as_json: bool = False) -> Pins:
    """Asks where the tags of base images point, and writes that into the matrix, unless `check` is set."""
    from rosml.images.image_set import load
    from rosml.images.locks import base_digests
    from rosml.images.matrix import extends
    from rosml.registry.client import Registries

    document = extends.read(matrix)
    systems = base_digests.pinned(document)
    with Registries(os.environ.get("SSL_CERT_FILE", "")) as registries:
        found = base_digests.look(load.image_set(document).matrix, systems, registries)
    if found.moved and not check:
        files.write(matrix, base_digests.rewritten(matrix.read_text(encoding="utf-8"), document, found.moved))
    for system, image, old, new in base_digests.rows(found.moved):
        terminal.echo(f"{system}: {image}: {'would move' if check else 'moved'} from {old} to {new}", err=as_json)
    for line in base_digests.reasons(found.left_out):
        terminal.echo(line, err=True)
    what = "outdated" if check else "changed"
    terminal.echo(f"{len(systems)} base images, {len(found.moved)} {what}", err=as_json)
    return found


def base_table(pinned: Pins) -> str:
    """The base images that moved, and those whose registry did not say, as Markdown for a pull request."""
    from rosml.images.locks import base_digests

    rows = base_digests.rows(pinned.moved)
    text = github.table(("system", "base image", "old", "new"), rows) if rows else "No base image moved.\n"
    lines = "".join(f"- {line}\n" for line in base_digests.reasons(pinned.left_out))
    return f"\n{text}" + (f"\n{lines}" if lines else "")


UNSHARED = "name the files in prune.txt of both parts, or take them out of the shared part's keep.txt (components/)"
"""The remedy if the wheels for two Pythons differ in the files of a part for every Python."""


def differences(image_set: ImageSet, texts: Mapping[str, str], stacks: Sequence[str]) -> list[Difference]:
    """The files that a part for every Python has otherwise than the wheels of another Python."""
    from rosml.base import web
    from rosml.images.locks import shared_files
    from rosml.images.locks.index import Index
    from rosml.images.locks.resolve import Uv

    with web.client(timeout=60) as client:
        return shared_files.differences(image_set, ROOT, Index(Uv(), client), texts, stacks)


def differences_list(differing: Sequence[Difference]) -> str:
    """Wheels that differ from a part for every Python, as Markdown for a pull request."""
    if not differing:
        return ""
    lines = "".join(f"- {item}\n" for item in differing)
    return f"\nImages with these parts will fail their tests; {UNSHARED}:\n\n{lines}"


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


def refused_table(stopped: Sequence[Refused], unknown: str) -> str:
    """The locked versions that the scan will stop, as Markdown for a pull request."""
    if unknown:
        return f"\n{unknown[0].upper()}{unknown[1:]}\n"
    if not stopped:
        return "\nThe scan will stop none of the locked versions.\n"
    rows = [(it.package, it.version, it.id, it.severity, it.fixed or "-", str(len(it.images))) for it in stopped]
    columns = ("package", "version", "advisory", "severity", "fixed in", "images")
    return "\nBy `scan.yaml`, the scan will stop images with these versions:\n\n" + github.table(columns, rows)


COLUMNS = ("stack", "package", "old", "new", "locks")


def rows_of(moved: Mapping[Move, int]) -> list[tuple[str, ...]]:
    """Old and new versions, and how many locks have each."""
    return [(m.stack, m.package, m.before or "-", m.after or "-", str(count)) for m, count in sorted(moved.items())]


def markdown(moved: Mapping[Move, int], fresh: Sequence[str], left_out: Mapping[Any, str]) -> str:
    """The text of a pull request: the table, new locks, and what got no new lock, with the reason."""
    text = github.table(COLUMNS, rows_of(moved)) if moved else "No version moved.\n"
    lines = [f"- new: `{path}`" for path in fresh]
    lines += [f"- {request}: no new lock: {reason}" for request, reason in left_out.items()]
    return text + ("\n" + "\n".join(lines) + "\n" if lines else "")
