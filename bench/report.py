"""What `make bench` measured, as a page with charts: `report.md`, `report.json` and pictures (SVG) in one folder."""

from __future__ import annotations

import json
import os
import platform
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from bench import idle_run, many_tags, scan, second_image
from bench.idle_run import IdleRun
from rosml.base import files
from rosml.base.errors import RosmlError

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

OURS, USUAL = "#0072b2", "#d55e00"
"""Colours that people with a colour vision deficiency tell apart (Okabe and Ito)."""

MEGABYTE = 1_000_000


def write(data: Mapping[str, Any], folder: Path, limits: Mapping[str, float]) -> Path:
    """Writes the report; what was there is replaced.

    Args:
        data: as `python -m bench --json` prints it: `real_seconds`, `sizes`, `limits`, and where images were built `comparison` and
            `growth_of_tags`.
        folder: where to; it is made if need be.
        limits: of the generator, in seconds: `real` and `largest`.

    Returns:
        The page, `report.md`.

    Raises:
        RosmlError: matplotlib is not installed, or the folder cannot be written.
    """
    pictures = charts(data, limits)
    try:
        folder.mkdir(parents=True, exist_ok=True)
        for name, figure in pictures.items():
            figure.savefig(folder / f"{name}.svg", metadata={"Date": None})
        files.write(folder / "report.json", json.dumps(data, indent=2) + "\n")
        files.write(folder / "report.md", markdown(data, limits))
    except OSError as error:
        raise RosmlError(
            f"cannot write {error.filename or folder}: {error.strerror}", "name another folder with --output"
        ) from None
    return folder / "report.md"


def machine() -> dict[str, Any]:
    """What a number depends on: processor, how many of them, and how busy they were when the measurement began."""
    return {
        "architecture": platform.machine(),
        "processors": os.cpu_count() or 0,
        "system": platform.system(),
        "load": round(os.getloadavg()[0], 1),
    }


def markdown(data: Mapping[str, Any], limits: Mapping[str, float]) -> str:
    """The page: a table for each chart, so that it says the same without pictures."""
    parts = [
        "# Benchmark\n",
        *_machine(data),
        *_comparison(data),
        *_growth(data),
        *_generator(data, limits),
        *_limits(data),
    ]
    return "\n".join(parts)


def _machine(data: Mapping[str, Any]) -> list[str]:
    found = data.get("machine")
    if not found:
        return []
    text = f"{found['processors']} processors ({found['system']}, {found['architecture']}), load {found['load']} at the start"
    return [f"{text}. Machines differ: ratios tell more than seconds.\n"]


def _comparison(data: Mapping[str, Any]) -> list[str]:
    found = data.get("comparison")
    if not found:
        return []
    start = found["ours"]["start_seconds"] * 1000
    return [
        f"## A second image: {found['target']}\n",
        _table((found["target"], "ours", "`RUN pip install`", "ratio"), second_image.cells(found)),
        "![Both ways side by side](comparison.svg)\n",
        f"Our entrypoint takes {start:.0f} ms of a container's start, beyond sourcing ROS.\n",
    ]


def _growth(data: Mapping[str, Any]) -> list[str]:
    found = data.get("growth_of_tags")
    if not found:
        return []
    rows = [many_tags.cells(many_tags.Growth(**row)) for row in found["rows"]]
    again = idle_run.text(IdleRun(**found["again"]))
    night = [f"A{scan.HEADING[1:]}: {scan.text(scan.Scan(**found['scan']))}.\n"] if "scan" in found else []
    return [
        "## So many tags, after a change of ROS\n",
        _table(("tags", "joined", "new in the registry", "every tag built", "new in the registry"), rows),
        "![Time and bytes by the number of tags](growth.svg)\n",
        "Every tag built: one build was measured, above, and multiplied.",
        f"{idle_run.HEADING[0].upper()}{idle_run.HEADING[1:]}: {again}.\n",
        *night,
    ]


def _generator(data: Mapping[str, Any], limits: Mapping[str, float]) -> list[str]:
    rows = [("the real one, with the interpreter's start", f"{data['real_seconds']:.2f}", f"{limits['real']:.2f}", "")]
    for item in data["sizes"]:
        limit = f"{limits['largest']:.2f}" if item is data["sizes"][-1] else ""
        each = item["seconds"] / item["images"] * 1_000_000
        rows.append((f"{item['images']} images", f"{item['seconds']:.2f}", limit, f"{each:.0f}"))
    return [
        "## The generator\n",
        _table(("matrix", "seconds", "limit", "µs for an image"), rows),
        "![Seconds by the number of images](generator.svg)\n",
    ]


def _limits(data: Mapping[str, Any]) -> list[str]:
    rows = [(item["what"], f"{item['seconds']:.3f}", f"{item['limit']:.2f}") for item in data.get("limits", ())]
    return ["## Limits\n", _table(("median of", "seconds", "limit"), rows)] if rows else []


def _table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    lines = [head, ["---", *("---:" for _ in head[1:])], *rows]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines) + "\n"


def charts(data: Mapping[str, Any], limits: Mapping[str, float]) -> dict[str, Figure]:
    """A picture for each part that was measured.

    Raises:
        RosmlError: matplotlib is not installed.
    """
    try:
        import matplotlib
    except ImportError:
        raise RosmlError("charts need matplotlib, which is not installed", "call it as 'make bench' does") from None
    matplotlib.rcParams["svg.hashsalt"] = "rosml"  # the same numbers make the same file
    found = {"generator": _generator_chart(data, limits)}
    if data.get("comparison"):
        found["comparison"] = _comparison_chart(data["comparison"])
    if data.get("growth_of_tags"):
        found["growth"] = _growth_chart(data["growth_of_tags"]["rows"])
    return found


def _figure(panels: int) -> tuple[Figure, list[Axes]]:
    from matplotlib.figure import Figure

    figure = Figure(figsize=(5.0 * panels, 3.6), layout="constrained")
    return figure, [figure.add_subplot(1, panels, number + 1) for number in range(panels)]


def _comparison_chart(found: Mapping[str, Any]) -> Figure:
    """Bars on logarithmic axes: seconds left, megabytes right."""
    figure, panels = _figure(2)
    for axes, suffix, unit, scale in zip(panels, ("_seconds", "_bytes"), ("s", "MB"), (1, MEGABYTE), strict=True):
        rows = {row: title for row, title in second_image.ROWS.items() if row.endswith(suffix)}
        places = range(len(rows))
        for shift, way, name, colour in ((-0.2, "ours", "ours", OURS), (0.2, "usual", "RUN pip install", USUAL)):
            values = [found[way][row] / scale for row in rows]
            bars = axes.barh([place + shift for place in places], values, height=0.38, color=colour, label=name)
            axes.bar_label(
                bars, labels=[second_image.shown(row)(found[way][row]) for row in rows], padding=2, fontsize=8
            )
        axes.set_yticks(list(places), list(rows.values()), fontsize=8)
        axes.invert_yaxis()
        axes.set_xscale("symlog", linthresh=0.01)
        axes.set_xlim(right=axes.get_xlim()[1] * 100)  # room for what the bars are labelled with
        axes.set_xlabel(unit)
    figure.legend(*panels[0].get_legend_handles_labels(), loc="outside upper center", ncols=2, fontsize=8)
    return figure


def _growth_chart(rows: Sequence[Mapping[str, Any]]) -> Figure:
    """Lines on logarithmic axes: seconds left, megabytes right."""
    figure, panels = _figure(2)
    tags = [row["tags"] for row in rows]
    keys = (("seconds", "usual_seconds", 1, "s"), ("uploaded", "usual_bytes", MEGABYTE, "MB new in the registry"))
    for axes, (ours, usual, scale, unit) in zip(panels, keys, strict=True):
        axes.plot(tags, [row[ours] / scale for row in rows], "o-", color=OURS, label="joined")
        axes.plot(tags, [row[usual] / scale for row in rows], "s--", color=USUAL, label="every tag built")
        axes.set_yscale("log")
        axes.set_xticks(tags)
        axes.set_xlabel("tags")
        axes.set_ylabel(unit)
    panels[0].legend(fontsize=8)
    return figure


def _generator_chart(data: Mapping[str, Any], limits: Mapping[str, float]) -> Figure:
    figure, [axes] = _figure(1)
    images = [item["images"] for item in data["sizes"]]
    axes.plot(images, [item["seconds"] for item in data["sizes"]], "o-", color=OURS, label="measured")
    axes.plot(images[-1:], [limits["largest"]], "v", color=USUAL, label="limit")
    axes.set_ylim(bottom=0)
    axes.set_xlabel("images")
    axes.set_ylabel("s")
    axes.legend(fontsize=8)
    return figure
