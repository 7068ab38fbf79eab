"""The plan of a run as one job writes it and others read it."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Literal

from pydantic import BaseModel, ConfigDict, Field, ValidationError

from rosml.base.clock import checked_date
from rosml.base.errors import RosmlError
from rosml.base.problems import first_of, unknown

PLAN_FORMAT = 1
"""Version of plan.json's format."""

Named = Annotated[tuple[str, ...], Field(min_length=1)]
"""Names of what is meant: none would mean all that there are."""


class _Fact(BaseModel):
    model_config = ConfigDict(frozen=True, strict=True)


class Shard(_Fact):
    """What one machine of a run builds."""

    name: str
    targets: Named
    architecture: str


class Planned(_Fact):
    """What plan.json says that the other steps need."""

    version: Literal[1]
    date: str
    registry: str
    targets: Named
    architectures: Named
    serve: tuple[str, ...]
    force: bool
    upstream: dict[str, str]
    shards: tuple[Shard, ...]


def read_plan(file: Path, shard: str = "") -> Planned:
    """Reads plan.json.

    Args:
        file: what `plan` wrote.
        shard: the targets and architecture of this one alone; of the whole plan if empty.

    Raises:
        RosmlError: it is no plan, or has no such shard (exit code 2).
    """
    try:
        found = Planned.model_validate_json(file.read_bytes())
    except (OSError, ValidationError) as error:
        reason = error.strerror if isinstance(error, OSError) else first_of(error)
        text = f"{file} is no plan of this version: {reason}"
        raise RosmlError(text, "write it anew with: rosml plan --output FILE", exit_code=2) from None
    checked_date(found.date)
    if not shard:
        return found
    shards = {item.name: item for item in found.shards}
    if shard not in shards:
        raise RosmlError(unknown("shard", shard, shards), f"there is {', '.join(shards) or 'none'}", exit_code=2)
    part = shards[shard]
    return found.model_copy(update={"targets": part.targets, "architectures": (part.architecture,)})
