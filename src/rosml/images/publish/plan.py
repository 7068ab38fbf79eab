"""The plan of a run, plan.json: one model of what one job writes and others read."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Literal

from pydantic import ValidationError

from rosml.base.clock import checked_date
from rosml.base.errors import RosmlError
from rosml.base.problems import first_of, unknown
from rosml.images.image_set.model import PARTS, ImageSet
from rosml.images.image_set.selection import select
from rosml.images.publish.shards import Fact, Named, Shard, Work, deal
from rosml.images.publish.state import Kind, State, Step
from rosml.images.records.store import REPOSITORY


class PlannedTask(Fact):
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


class Plan(Fact):
    """A plan.

    Attributes:
        version: of this format.
        date: of the run. registry: where its images go, with the prefix.
        architectures: those that it works for. serve: those that the registry serves; all of the matrix if empty.
        force: everything is made anew.
        package_state: of each distribution whose repositories answered.
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
    package_state: dict[str, str]
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


def make_plan(state: State, shards: int, why: bool = False) -> Plan:
    """What is to be done, and which machine builds what.

    Args:
        shards: how many machines there are at most. why: name the inputs that changed; the records are read for them.

    Raises:
        RosmlError: the matrix does not say where an architecture is built (exit code 2).
    """
    tasks = state.tasks()
    # What is only to be tested needs a machine as well. A scan needs none of a kind.
    here = [task for task in tasks if task.item.architecture in state.architectures]
    work = Work(
        frozenset(task.item.key for task in here if task.item.making in task.steps),
        frozenset(task.item.key for task in here if "test" in task.steps),
        {key: entry.seconds for key, entry in state.known.items() if not entry.failed},
    )
    wanted = {image.target for image in state.images}
    return Plan(
        version=1,
        date=state.date,
        registry=str(state.place),
        architectures=state.architectures,
        serve=state.request.serve,
        force=state.request.force,
        package_state=state.package_state,
        targets=tuple(image.target for image in state.images),
        shards=deal(state.forecast, shards, lambda image: image.target in wanted, work),
        tasks=tuple(
            PlannedTask(
                target=task.item.target,
                architecture=task.item.architecture,
                kind=task.item.kind,
                steps=task.steps,
                why=task.why,
                hindered=task.hindered,
                inputs=tuple(state.changes(task.item)) if why and task.steps else (),
            )
            for task in tasks
            if task.steps or task.hindered
        ),
        unchanged=sum(not task.steps and not task.hindered for task in tasks),
        remarks=tuple(state.remarks),
    )


def read_plan(file: Path, shard: str = "") -> Plan:
    """Reads plan.json.

    Args:
        file: what `plan` wrote.
        shard: the targets and architecture of this one alone; of the whole plan if empty.

    Raises:
        RosmlError: it is no plan, or has no such shard (exit code 2).
    """
    try:
        found = Plan.model_validate_json(file.read_bytes())
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
