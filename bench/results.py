"""What was measured, as JSON in `bench/results`, and the pages that are written from it.

A measurement stands for itself: whoever reads the page sees the command, the day, the machine and all sides of one run.
"""

from __future__ import annotations

import dataclasses
import datetime
import json
import os
import platform
import re
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from xml.sax.saxutils import escape

from rosml import ROOT
from rosml.base import files
from rosml.base.errors import RosmlError
from rosml.base.terminal import show, table
from rosml.base.units import duration, size

FOLDER = ROOT / "bench/results"
PAGES = (ROOT / "docs/performance.md", ROOT / "docs/scale.md")
PLOTS = ROOT / "docs/images/performance"


def _seconds(value: float) -> str:
    """With two digits of what is short, since ratios matter."""
    return f"{value:.2f} s" if value < 10 else duration(value)


WRITTEN: dict[str, Callable[[float], str]] = {
    "s": _seconds,
    "ms": lambda value: f"{value:.3f} ms" if value < 10 else f"{value:.0f} ms",
    "B": lambda value: f"{value / 1e12:.2f} TB" if value >= 1e12 else size(int(value)),
    "ratio": "{:.2f}".format,
    "": "{:,.0f}".format,
}
"""How the value of each unit is written. A number without a unit is a count."""

LABELS, BARS, BAR = 330, 300, 14
"""Of a plot: the widths of the labels and of the longest bar, and the height of a bar, in pixels."""


@dataclass(frozen=True)
class Row:
    """One thing that was measured.

    Attributes:
        what: what somebody waits for, or pays.
        values: one for each side, in the unit; None if that side does not have it.
        unit: of the values, one of `WRITTEN`.
        goal: what the last side shall be, in words.
        met: whether it is; None if there is no goal.
        command: what somebody types, if it is not the measurement's own command.
    """

    what: str
    values: Sequence[float | None]
    unit: str = "s"
    goal: str = ""
    met: bool | None = None
    command: str = ""

    @property
    def cells(self) -> list[str]:
        """The values as text."""
        return ["" if value is None else WRITTEN[self.unit](value) for value in self.values]

    @property
    def told_goal(self) -> str:
        """The goal, and whether it is met."""
        return self.goal if self.met is None else f"{self.goal}: {'met' if self.met else 'not met'}"


@dataclass(frozen=True)
class Result:
    """One measurement: its name is that of its file and of its place on the page.

    Attributes:
        name: as `python -m bench` has it.
        command: what measures it; empty if somebody did by hand.
        sides: what is compared, the head of a column each.
        rows: what was measured.
        measured: the day.
        machine: on which machine.
    """

    name: str
    command: str
    sides: Sequence[str]
    rows: Sequence[Row]
    measured: str = dataclasses.field(default_factory=lambda: datetime.datetime.now(datetime.UTC).date().isoformat())
    machine: str = dataclasses.field(default_factory=lambda: machine())

    def print(self) -> None:
        """Prints the result as a table."""
        printed = table(self.name, *self.sides, "goal", right=self.sides)
        for row in self.rows:
            printed.add_row(row.what, *row.cells, row.told_goal)
        show(printed)

    def save(self) -> None:
        """Writes the file, for the page."""
        FOLDER.mkdir(exist_ok=True)
        files.write(FOLDER / f"{self.name}.json", json.dumps(dataclasses.asdict(self), indent=1) + "\n")


def machine() -> str:
    """This machine, as far as times depend on it."""
    memory = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    return f"{os.cpu_count()} cores ({platform.machine()}), {memory / 1e9:.0f} GB of memory"


def load() -> dict[str, Result]:
    """All results, by name."""
    content = [json.loads(path.read_text()) for path in sorted(FOLDER.glob("*.json"))]
    return {item["name"]: Result(**item | {"rows": [Row(**row) for row in item["rows"]]}) for item in content}


def pages(texts: Sequence[str], results: dict[str, Result]) -> list[str]:
    """The pages with each result in its place: between `<!-- measured: <name> -->` and `<!-- end -->`.

    Raises:
        RosmlError: a result has no place, or a place no result.
    """
    places = [name for text in texts for name in re.findall(r"<!-- measured: ([\w-]+) -->", text)]
    if sorted(places) != sorted(results):
        differ = ", ".join(sorted({*places} ^ {*results}))
        raise RosmlError(f"{FOLDER.name} and the pages differ: {differ}", "give each result one place on a page")

    def written(place: re.Match[str]) -> str:
        return f"{place[1]}\n{_section(results[place[2]])}{place[3]}"

    place = re.compile(r"(<!-- measured: ([\w-]+) -->)\n.*?(<!-- end -->)", re.DOTALL)
    return [place.sub(written, text) for text in texts]


def write_pages() -> None:
    """Writes the pages and their plots."""
    results = load()
    for path, text in zip(PAGES, pages([path.read_text() for path in PAGES], results), strict=True):
        files.write(path, text)
    PLOTS.mkdir(exist_ok=True)
    for result in results.values():
        files.write(PLOTS / f"{result.name}.svg", plot(result))


def _section(result: Result) -> str:
    with_goal = any(row.goal for row in result.rows)
    with_command = any(row.command for row in result.rows)
    heads = ["what", *result.sides, *["goal"] * with_goal, *["command"] * with_command]
    lines = [heads, ["---", *["---:"] * len(result.sides), *["---"] * (with_goal + with_command)]]
    for row in result.rows:
        command = f"`{row.command}`" if row.command else ""
        lines.append([row.what, *row.cells, *[row.told_goal] * with_goal, *[command] * with_command])
    by = f"by `{result.command}`" if result.command else "by hand, one after the other,"
    text = f"\nMeasured {by} on {result.measured}: {result.machine}.\n\n"
    text += "".join(f"| {' | '.join(cells)} |\n" for cells in lines)
    return f"{text}\n![{' and '.join(result.sides)} as bars](images/performance/{result.name}.svg)\n\n"


def plot(result: Result) -> str:
    """Bars for each row, the longest of a row as wide as there is room: what is compared stands below each other."""
    shapes = list[str]()
    top = 8
    for row in result.rows:
        most = max((value for value in row.values if value is not None), default=0.0)
        shapes.append(f'<text class="ink" x="0" y="{top + 11}">{escape(row.what)}</text>')
        for number, (side, value, cell) in enumerate(zip(result.sides, row.values, row.cells, strict=True)):
            if value is None:
                continue
            wide = max(1.0, BARS * value / most) if most else 1.0
            title = escape(f"{side}: {cell}")
            shapes.append(
                f'<rect class="side{number}" x="{LABELS}" y="{top}" width="{wide:.1f}" height="{BAR - 2}">'
                f"<title>{title}</title></rect>"
            )
            shapes.append(
                f'<text class="soft" x="{LABELS + wide + 6:.1f}" y="{top + 10}" font-size="11">{title}</text>'
            )
            top += BAR
        top += 8
    return _drawing(f"{result.name}: {' and '.join(result.sides)}", LABELS + BARS + 200, top, shapes)


def _drawing(title: str, wide: int, high: int, shapes: Iterable[str]) -> str:
    colours = (
        ("#8c959f", "#656c76"),
        ("#0969da", "#4493f8"),
        ("#1a7f37", "#3fb950"),
        ("#9a6700", "#d29922"),
        ("#8250df", "#a371f7"),
    )
    light = " ".join(f".side{number} {{ fill: {colour} }}" for number, (colour, _) in enumerate(colours))
    dark = " ".join(f".side{number} {{ fill: {colour} }}" for number, (_, colour) in enumerate(colours))
    return "\n  ".join([
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {wide} {high}" role="img" aria-labelledby="t" '
        'font-family="system-ui, sans-serif" font-size="13">',
        "<!-- Written by python -m bench page, from bench/results. -->",
        f'<title id="t">{escape(title)}</title>',
        f"<style>.ink {{ fill: #1f2328 }} .soft {{ fill: #59636e }} {light}",
        f"@media (prefers-color-scheme: dark) {{ .ink {{ fill: #e6edf3 }} .soft {{ fill: #9198a1 }} {dark} }}</style>",
        *shapes,
    ]) + "\n</svg>\n"  # fmt: skip
