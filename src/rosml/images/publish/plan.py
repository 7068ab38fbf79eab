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
from rosml.images.image_set.model import PARTS, ImageSet
from rosml.images.image_set.selection import select
from rosml.images.publish.shards import Fact, Named, Shard, Work, deal
from rosml.images.publish.state import Kind, State, Step
from rosml.images.records.store import REPOSITORY


class PlannedTask(Fact):
    """The steps to do for an image or part on an architecture, and why; or why nothing can be done here.

    Attributes:
        target: bake target.
        architecture: under BuildKit's name.
        kind: ROS image, part or joined image.
        steps: in order; empty if there is nothing to do.
        why: reasons for the first step.
        hindered: why no step can be done here; empty if it can.
        inputs: names of the inputs that changed, if they were asked for.
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
        date: of the run.
        registry: where the images go, with the prefix.
        architectures: the architectures that the run works for.
        serve: the architectures that the registry serves; all of the matrix if empty.
        force: rebuild everything.
        package_state: the package state of each distribution whose repositories answered.
        targets: the images of the run.
        shards: which machine builds what.
        tasks: items with steps to do, and items that cannot be done here.
        unchanged: how many items are up to date.
        remarks: for people, such as a repository that does not answer.
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
        """The repositories that the plan writes into, without the registry's prefix. The records come first.

        Raises:
            RosmlError: the plan has an image that the image set lacks (exit code 2).
        """
        wanted = [task for task in self.tasks if task.steps]
        images = [task.target for task in wanted if task.kind != "part"]
        found = [REPOSITORY] if wanted else []
        found += [PARTS] if len(images) < len(wanted) else []
        found += [image.repository for image in select(image_set, images)] if images else []
        return list(dict.fromkeys(found))

    def text(self) -> str:
        """The content of plan.json."""
        facts = self.model_dump(mode="json")
        facts["tasks"] = [task.model_dump(mode="json", exclude_defaults=True) for task in self.tasks]
        return json.dumps(facts, indent=2) + "\n"


def make_plan(state: State, shards: int, why: bool = False) -> Plan:
    """Plans a run: the steps of every item, and which machine builds what.

    Args:
        state: what is known of the images.
        shards: how many machines there are at most.
        why: name the inputs that changed. This reads the records.

    Raises:
        RosmlError: the matrix names no runner for an architecture (exit code 2).
    """
    tasks = state.tasks()
    # Images that are only tested need a machine of their architecture as well. A scan runs on any machine.
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
        shard: take only the targets and the architecture of this shard; the whole plan if empty.

    Raises:
        RosmlError: the file is no plan, or has no such shard (exit code 2).
    """
    try:
        found = Plan.model_validate_json(untrusted.json_text(files.limited(file, untrusted.SIZE)))
    except (OSError, ValueError) as error:
        reason = first_of(error) if isinstance(error, ValidationError) else getattr(error, "strerror", "") or error
        text = f"{file} is no plan of this version: {reason}"
        raise RosmlError(text, "write it again with: rosml plan --output FILE", exit_code=2) from None
    checked_date(found.date)
    if not shard:
        return found
    shards = {item.name: item for item in found.shards}
    if shard not in shards:
        raise RosmlError(unknown("shard", shard, shards), f"there is {', '.join(shards) or 'none'}", exit_code=2)
    part = shards[shard]
    return found.model_copy(update={"targets": part.targets, "architectures": (part.architecture,)})
