"""The plan of a run, plan.json: one job writes it, others read it."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Literal

from pydantic import ValidationError

from rosml.base import files, untrusted
from rosml.base.clock import checked_date
from rosml.base.errors import RosmlError
from rosml.base.problems import first_of, unknown
from rosml.images.image_set.model import ImageSet
from rosml.images.publish.items import Kind, Step, Task
from rosml.images.publish.shards import Fact, Names, Shard, Work, deal, too_large
from rosml.images.publish.state import State
from rosml.images.records.store import REPOSITORY


class PlannedTask(Fact):
    """The steps to do for an image or part on an architecture, and why."""

    target: str
    architecture: str
    kind: Kind
    steps: tuple[Step, ...]
    why: tuple[str, ...] = ()
    hindered: str = ""  # why nothing can be done here
    inputs: tuple[str, ...] = ()  # names of the inputs that changed, if they were asked for


class Plan(Fact):
    """A plan. Its options are as in a `Request`."""

    version: Literal[1]  # of this format
    date: str
    registry: str  # where the images go, with the prefix
    architectures: Names
    serve: tuple[str, ...]
    force: bool
    package_state: dict[str, str]
    targets: Names  # the images of the run
    shards: tuple[Shard, ...]
    tasks: tuple[PlannedTask, ...]  # items with steps to do, and items that cannot be done here
    unchanged: int  # how many items are up to date
    remarks: tuple[str, ...]  # for people, such as a repository that does not answer

    def repositories(self, image_set: ImageSet) -> list[str]:
        """The repositories that the plan writes into, without the registry's prefix. The records come first."""
        tasks = [task for task in self.tasks if task.steps]
        if not tasks:
            return []
        repositories = {part.target: part.repository for part in image_set.parts}
        repositories |= {image.target: image.repository for image in image_set.images}
        return list(dict.fromkeys([REPOSITORY, *(repositories[task.target] for task in tasks)]))

    def text(self) -> str:
        """The content of plan.json."""
        content = self.model_dump(mode="json")
        content["tasks"] = [task.model_dump(mode="json", exclude_defaults=True) for task in self.tasks]
        return json.dumps(content, indent=2) + "\n"


def make_plan(state: State, shards: int, why: bool = False) -> Plan:
    """Plans a run for at most so many machines. With `why`, it reads from the records which inputs changed."""
    tasks = state.tasks()
    to_do = [task for task in tasks if task.steps or task.hindered]
    dealt = deal(state.forecast, shards, _work(state, tasks))
    return Plan(
        version=1,
        date=state.date,
        registry=str(state.place),
        architectures=state.architectures,
        serve=state.request.serve,
        force=state.request.force,
        package_state=state.package_state,
        targets=tuple(image.target for image in state.images),
        shards=dealt,
        tasks=tuple(_planned(state, task, why) for task in to_do),
        unchanged=len(tasks) - len(to_do),
        remarks=(*state.remarks, *too_large(state.forecast, dealt)),
    )


def _work(state: State, tasks: list[Task]) -> Work:
    # Images that are only tested need a machine of their architecture as well. A scan runs on any machine.
    here = [task for task in tasks if task.item.architecture in state.architectures]
    built = frozenset(task.item.key for task in here if task.item.making in task.steps)
    tested = frozenset(task.item.key for task in here if "test" in task.steps)
    targets = {image.target for image in state.images}
    return Work(
        frozenset(key for key in built | tested if key[0] in targets),
        built,
        tested,
        {key: entry.seconds for key, entry in state.entries.items() if not entry.failed},
    )


def _planned(state: State, task: Task, why: bool) -> PlannedTask:
    return PlannedTask(
        target=task.item.target,
        architecture=task.item.architecture,
        kind=task.item.kind,
        steps=task.steps,
        why=task.why,
        hindered=task.hindered,
        inputs=tuple(state.changes(task.item)) if why and task.steps else (),
    )


def read_plan(file: Path, shard: str = "") -> Plan:
    """Reads plan.json; of a shard, only its targets and its architecture."""
    try:
        plan = Plan.model_validate_json(untrusted.json_text(files.limited(file, untrusted.SIZE)))
    except (OSError, ValueError) as error:
        reason = first_of(error) if isinstance(error, ValidationError) else getattr(error, "strerror", "") or error
        text = f"{file} is no plan of this version: {reason}"
        raise RosmlError(text, "write it again with: rosml plan --output FILE", exit_code=2) from None
    checked_date(plan.date)
    if not shard:
        return plan
    shards = {item.name: item for item in plan.shards}
    if shard not in shards:
        raise RosmlError(unknown("shard", shard, shards), f"there is {', '.join(shards) or 'none'}", exit_code=2)
    part = shards[shard]
    return plan.model_copy(update={"targets": part.targets, "architectures": (part.architecture,)})
