"""What a step tells GitHub: a summary for people, and outputs for later steps. Outside of GitHub it writes nothing."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Sequence
from pathlib import Path

from rosml.base.terminal import shown

SUMMARY, OUTPUT = "GITHUB_STEP_SUMMARY", "GITHUB_OUTPUT"
"""The variables that name the files to append to."""


def summary(text: str) -> None:
    _append(SUMMARY, text)


def output(name: str, value: str) -> None:
    """Sets an output of the step. Raises ValueError for a value of several lines, which could set another output."""
    if "\n" in value or "\r" in value:
        raise ValueError(f"the output {name} has several lines")
    _append(OUTPUT, f"{name}={value}\n")


def table(columns: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    lines = [columns, ["---"] * len(columns), *rows]
    return "".join(f"| {' | '.join(map(_cell, line))} |\n" for line in lines)


def code(text: str) -> str:
    """Text from outside as Markdown code: no part of it becomes a link, a mention or HTML. Several lines become a block."""
    text = shown(text)
    ticks = "`" * (1 + max((len(run) for run in re.findall("`+", text)), default=0))
    if "\n" in text:
        return f"{ticks}``\n{text}\n{ticks}``"
    return f"{ticks} {text} {ticks}" if "`" in text else f"{ticks}{text}{ticks}"


def _cell(text: str) -> str:
    return text.replace("|", "\\|").replace("\n", "<br>")


def _append(variable: str, text: str) -> None:
    if path := os.environ.get(variable):
        with Path(path).open("a", encoding="utf-8") as stream:
            stream.write(text)
