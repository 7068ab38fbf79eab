"""The plan of a run, plan.json: one model of what one job writes and others read."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Annotated, Literal

from pydantic import BaseModel, ConfigDict, Field, ValidationError

from rosml.base.clock import checked_date
from rosml.base.errors import RosmlError
from rosml.base.problems import first_of, unknown
from rosml.images.image_set.model import PARTS, ImageSet
from rosml.images.image_set.selection import select
from rosml.images.publish.plan import Kind, Step
from rosml.images.records.store import REPOSITORY

Named = Annotated[tuple[str, ...], Field(min_length=1)]
"""Names of what is meant: none would mean all that there are."""


class _Fact(BaseModel):
    model_config = ConfigDict(frozen=True, strict=True)


class Estimates(_Fact):
    """What a shard takes.

    Attributes:
        download_mb: what the network brings: base images, Debian packages and wheels, compressed.
        disk_mb: room that it needs at its peak, which is its end, with the reserve; counted as `machine/disk.py` counts.
        seconds: time of building and testing: what each took the last time, or else by the matrix' rates.
    """

    download_mb: int
    disk_mb: int
    seconds: int


class Shard(_Fact):
    """What one machine of a run builds.

    Attributes:
        name: `amd64-1`; an architecture's longest shard has the number 1.
        architecture: under BuildKit's name. platform: the same as BuildKit calls it.
        runner: label of the machines in CI.
        distributions: what it builds, in the order of the matrix.
        targets: bake targets in build order: of each distribution the ROS images from the lowest up, then the others.
        parts: names of the parts that it assembles.
    """

    name: str
    architecture: str
    platform: str
    runner: str
    distributions: tuple[str, ...]
    targets: Named
    parts: tuple[str, ...]
    estimates: Estimates


class PlannedTask(_Fact):
    """What is to be done about an image or part on an architecture, and why, or why it cannot be done here.

    Attributes:
        inputs: names of those that changed, where they were asked for.
    """

    target: str
    architecture: str
    kind: Kind
    steps: tuple[Step, ...]
    why: tuple[str, ...] = ()
    hindered: str = ""
    inputs: tuple[str, ...] = ()


class Planned(_Fact):
    """A plan.

    Attributes:
        version: of this format.
        date: of the run. registry: where its images go, with the prefix.
        architectures: those that it works for. serve: those that the registry serves; all of the matrix if empty.
        force: everything is made anew. upstream: of when the packages of each distribution are.
        targets: the images that are meant. shards: which machine builds what.
        tasks: what is to be done or cannot be done. unchanged: how many items are as they should be.
        remarks: what people should know, such as a repository that does not answer.
    """

    version: Literal[1]
    date: str
    registry: str
    architectures: Named
    serve: tuple[str, ...]
    force: bool
    upstream: dict[str, str]
    targets: Named
    shards: tuple[Shard, ...]
    tasks: tuple[PlannedTask, ...]
    unchanged: int
    remarks: tuple[str, ...]

    def repositories(self, image_set: ImageSet) -> list[str]:
        """The repositories that something of the plan is written into, the records first; without the registry's prefix.

        Raises:
            RosmlError: it has an image that the image set lacks (exit code 2).
        """
        wanted = [task for task in self.tasks if task.steps]
        images = [task.target for task in wanted if task.kind != "part"]
        found = [REPOSITORY] if wanted else []
        found += [PARTS] if len(images) < len(wanted) else []
        found += [image.repository for image in select(image_set, images)] if images else []
        return list(dict.fromkeys(found))

    def text(self) -> str:
        """What `read_plan` reads."""
        facts = self.model_dump(mode="json")
        facts["tasks"] = [task.model_dump(mode="json", exclude_defaults=True) for task in self.tasks]
        return json.dumps(facts, indent=2) + "\n"


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
