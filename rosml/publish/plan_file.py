"""The plan of a run as one job writes it and others read it."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from rosml.base.clock import checked_date
from rosml.base.errors import RosmlError
from rosml.base.problems import unknown

PLAN_FORMAT = 1
"""Version of plan.json's format."""


@dataclass(frozen=True)
class Planned:
    """What plan.json says that the other steps need."""

    date: str
    registry: str
    targets: tuple[str, ...]
    architectures: tuple[str, ...]
    serve: tuple[str, ...] = ()
    force: bool = False
    upstream: Mapping[str, str] = field(default_factory=dict)


def read_plan(file: Path, shard: str = "") -> Planned:
    """Reads plan.json.

    Args:
        file: what `plan` wrote.
        shard: the targets and architecture of this one alone; of the whole plan if empty.

    Raises:
        RosmlError: it is no plan, or has no such shard (exit code 2).
    """
    try:
        content = json.loads(file.read_text(encoding="utf-8"))
        if content["version"] != PLAN_FORMAT:
            raise ValueError(f"it has format {content['version']}")
        shards = {_text(item["name"]): item for item in content["shards"]}
        if shard and shard not in shards:
            raise RosmlError(unknown("shard", shard, shards), f"there is {', '.join(shards) or 'none'}", exit_code=2)
        part = shards[shard] if shard else content
        found = Planned(
            checked_date(_text(content["date"])),
            _text(content["registry"]),
            _texts(part["targets"]),
            (_text(part["architecture"]),) if shard else _texts(content["architectures"]),
            _texts(content["serve"]),
            content["force"],
            {_text(name): _text(moment) for name, moment in content["upstream"].items()},
        )
        if not (found.targets and found.architectures):  # which would mean all that there are
            raise ValueError("it names no images")
        if not isinstance(content["force"], bool):
            raise TypeError(f"{content['force']!r} is neither true nor false")
    except (OSError, ValueError, KeyError, TypeError, AttributeError, RecursionError) as error:
        raise RosmlError(
            f"{file} is no plan: {error}", "write it with: publish.py plan --output FILE", exit_code=2
        ) from None
    return found


def _text(value: Any) -> str:
    if not isinstance(value, str):
        raise TypeError(f"{value!r} is no text")
    return value


def _texts(value: Any) -> tuple[str, ...]:
    if not isinstance(value, list):
        raise TypeError(f"{value!r} is no list")
    return tuple(map(_text, value))
