"""Tables of images, differences, shards, states and findings, for people."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Collection, Iterable, Iterator, Sequence
from typing import TYPE_CHECKING

from rosml.base import github, terminal
from rosml.base.problems import counted, some
from rosml.base.terminal import Cell
from rosml.cli import command
from rosml.images.image_set import missing_locks
from rosml.images.image_set.model import Image

if TYPE_CHECKING:  # a table of images needs none of them
    from rosml.images.bake.diff import Difference
    from rosml.images.bake.inputs import Inputs
    from rosml.images.publish.shards import Shard
    from rosml.images.publish.status import Ahead, Cause, ImageStatus
    from rosml.images.scan.judge import Run

MANY = 12
"""If there are more names than this, they are folded in a summary."""

COLOURS = {"critical": "bold red", "high": "red", "medium": "yellow"}


def show(
    columns: Sequence[str],
    rows: Iterable[Iterable[Cell]],
    right: Collection[str] = (),
    wrapped: Collection[str] = (),
    whole: Collection[str] = (),
) -> None:
    """Prints a table; nothing if it has no rows. `right`, `wrapped` and `whole` name columns, as in `terminal.table`."""
    if listed := [tuple(row) for row in rows]:
        terminal.show_rows(columns, listed, right, wrapped, whole)


coloured = terminal.Styled
"""A cell in a style of rich."""


def print_difference(difference: Difference) -> None:
    """Prints a difference in a few lines, however many images there are."""
    out, columns = terminal.console(), ("what", "why", "which")
    if difference.registry:
        out.print(f"registry: {' → '.join(difference.registry)}; all names change")
    from rosml.images.bake.diff import how_many, rows

    show(columns, rows(difference), wrapped=columns)
    counts = [how_many(difference, name) for name in ("added", "removed", "changed")]
    out.print(", ".join([*counts, f"{difference.same} same"]), style="dim")


def images_as_json(inputs: Inputs, images: Sequence[Image]) -> str:
    """Images with the digests of their inputs by architecture."""
    return json.dumps([{**image.to_json(), "inputs": inputs.digests(image)} for image in images], indent=2) + "\n"


CONTENT = 20
"""As many characters of an image's versions are shown at least, if they are shown."""


def print_images(images: Sequence[Image]) -> None:
    """Prints images, a row each. In a narrow terminal, versions are cut, and the last columns are left out."""
    from rosml.images.matrix.combinations import NVIDIA

    columns = ["tag", "GB", "platforms", "content", "target"]
    rows: list[list[Cell]] = []
    for image in images:
        # cuDNN and NCCL follow from CUDA; 'rosml list --json' has all versions, to the last number.
        versions = [f"{name} {short(version)}" for name, version in image.versions.items() if name not in NVIDIA[1:]]
        content = (", ".join(versions) or "ROS") + ("" if image.locked else " (no lock)")
        tag, size = image.tags[0] if image.tags else "none: a test", f"{image.disk.unpacked / 1000:.1f}"
        row = [tag, size, ", ".join(image.architectures), content, image.target]
        rows.append([*row] if image.locked else [coloured(cell, "dim") for cell in row])
    widths = terminal.widths(columns, rows)
    widths[3] = min(widths[3], CONTENT)
    while sum(widths) + 2 * (len(widths) - 1) > terminal.width() and len(widths) > 2:
        widths.pop()
    columns, rows = columns[: len(widths)], [row[: len(widths)] for row in rows]
    show(columns, rows, right=["GB"], whole=["tag", "GB", "platforms"])
    parts = {name for image in images for name in image.parts}
    counts = f"{counted(len(images), 'image')}, {counted(len(parts), 'part')}; GB: unpacked, a forecast"
    terminal.say(counts, "dim")
    print_unlocked(images)


def short(version: str) -> str:
    """A version's first two numbers."""
    return ".".join(version.split(".")[:2])


def print_unlocked(images: Collection[Image]) -> None:
    for line in unlocked(images):
        terminal.say(command.as_called(line), "yellow")


def unlocked(images: Collection[Image]) -> Iterator[str]:
    """Says how many of some images lack a lock: a line for each remedy."""
    unlocked_images = sorted((image for image in images if not image.locked), key=lambda image: not image.lost)
    for remedy, count in Counter(map(missing_locks.way_back, unlocked_images)).items():
        yield f"{counted(count, 'image')} without a lock, which cannot be built yet: {remedy}"


SHARDS = ("shard", "runner", "distributions", "images", "parts", "minutes (estimate)", "GB download", "GB disk")


def shard_rows(shards: Iterable[Shard]) -> list[tuple[str, ...]]:
    """A row for each shard, with estimates of what it takes."""
    rows = []
    for shard in shards:
        takes = shard.estimates
        counts = (str(len(shard.targets)), str(len(shard.parts) - len(shard.elsewhere)), f"{takes.seconds / 60:.0f}")
        sizes = (f"{megabytes / 1000:.1f}" for megabytes in (takes.download_mb, takes.disk_mb))
        rows.append((shard.name, shard.runner, ", ".join(shard.distributions), *counts, *sizes))
    return rows


def print_scan(run: Run) -> None:
    """Prints a scan: a line for each image, and its findings that stop it or are ignored, the worst first; problems of
    the policy's entries, and the outcome."""
    from rosml.images.scan.sarif import COLUMNS, finding_rows, summary

    printed: set[str] = set()
    for image in run.images:
        terminal.echo(summary(image))
        rows = finding_rows([it for it in image.findings if it.fails or it.ignored])
        show(COLUMNS, ([coloured(first, COLOURS.get(first, "")), *others] for first, *others in rows))
        for note in image.notes:
            if note not in printed:
                terminal.echo(f"note: {note}")
        printed.update(image.notes)
    for line in (*run.problems, *run.ending):
        terminal.echo(line)
    states = {(image.database.updated, image.database.digest) for image in run.images if image.database}
    for updated, digest in sorted(states):
        terminal.echo(f"database of {updated}, {digest}")
    terminal.echo(f"{counted(len(run.images), 'image')}: {run.outcome.value}")


FEW = 24
"""As many images as fit on a screen have a line each, whatever their state."""


def print_status(
    statuses: list[ImageStatus],
    causes: Sequence[Cause],
    ahead: Iterable[Ahead],
    ending: Iterable[str] = (),
    now: str = "",
) -> None:
    """Prints a line for each image that was published or failed, the published ones first; a block for each cause; and how many
    images each state has. If there are few images, each has a line."""
    from rosml.images.publish.status import STATES, after_a_number, age, vulnerabilities

    order = list(STATES)
    shown = [it for it in statuses if it.digest or it.state == "failed" or len(statuses) <= FEW]
    rows = (
        (it.target, coloured(it.state, STATES[it.state]), age(it.age), ", ".join(it.platforms), it.reason)
        for it in sorted(shown, key=lambda it: order.index(it.state))
    )
    show(("image", "state", "age", "platforms", "why"), rows, wrapped=["why"], whole=["image"])
    rows_of_scans = ((it.target, it.eol, vulnerabilities(it, now)) for it in shown if it.database)
    show(("image", "supported until", "vulnerabilities"), rows_of_scans, wrapped=["vulnerabilities"], whole=["image"])
    out = terminal.console()
    for cause in causes if len(statuses) > 1 else ():
        head = f"{cause.count} {after_a_number(cause.state)}"
        out.print(f"{head}: {cause.reason or some(cause.targets)}", style=STATES[cause.state], markup=False)
        if cause.reason:
            out.print(f"  {some(cause.targets)}", style="dim", markup=False)
        for line in cause.log.split("\n") if cause.log else ():
            out.print(f"  | {line}", style="dim", markup=False)
    for line in ending:
        out.print(line, style="yellow", markup=False)
    out.print(f"{_counts(statuses)}; {_ahead(ahead)}", style="dim")


def _counts(statuses: Sequence[ImageStatus]) -> str:
    """How many images have each state, and how many parts: `3 images: 2 published, 1 missing; 1 part: 1 published`."""
    from rosml.images.publish import status

    texts = []
    for things in ([it for it in statuses if it.kind == kind] for kind in ("image", "part")):
        counts = Counter(it.state for it in things)
        text = ", ".join(f"{counts[name]} {status.after_a_number(name)}" for name in status.STATES if counts[name])
        texts += [f"{status.count(things)}: {text}"] if things else []
    return "; ".join(texts) or status.count(())


def _ahead(ahead: Iterable[Ahead]) -> str:
    steps = ", ".join(f"{it.step} {it.number}" + f" for {it.architecture}" * bool(it.architecture) for it in ahead)
    return f"a further run would {steps}" if steps else "a further run has nothing to do"


def folded(targets: Sequence[str]) -> str:
    """Names of images in a summary; many are folded."""
    names = ", ".join(f"`{name}`" for name in targets)
    many = len(targets) > MANY
    return f"<details><summary>{some(targets)}</summary>\n\n{names}\n</details>" if many else names


def status_markdown(
    place: str,
    statuses: Sequence[ImageStatus],
    causes: Sequence[Cause],
    ahead: Iterable[Ahead],
    ending: Iterable[str] = (),
) -> str:
    """The state of a registry's images, for the owner of a repository: numbers, then each cause with its images and the
    last lines of its log."""
    from rosml.images.publish.status import after_a_number

    lines = [f"## Images of {place}", "", f"{_counts(statuses)}. {_ahead(ahead).capitalize()}.", ""]
    for cause in causes:
        reason = f": {github.code(cause.reason)}" if cause.reason else ""
        lines += [f"### {cause.count} {after_a_number(cause.state)}{reason}", ""]
        lines += [folded(cause.targets), ""]
        if cause.log:
            lines += [github.code(cause.log), ""]
    lines += [f"- {line}" for line in ending]
    return "\n".join(lines)
