"""Shows what a publishing run will do, or did: as tables, as JSON, and as the summary of a CI job."""

from __future__ import annotations

import json
import math
import time
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence

from rosml.base import github, terminal
from rosml.base.problems import counted, listed, some
from rosml.base.units import duration, size, time_taken
from rosml.cli.images import tables
from rosml.images.builds import disk
from rosml.images.image_set.missing_locks import UNLOCKED
from rosml.images.image_set.model import Image, ImageSet
from rosml.images.publish import status
from rosml.images.publish.items import ELSEWHERE
from rosml.images.publish.plan import Plan
from rosml.images.publish.run import Outcome, Run
from rosml.images.publish.shards import Shard
from rosml.images.publish.state import State
from rosml.images.records import store


def plan_to_ci(plan: Plan, image_set: ImageSet, cost: str) -> None:
    """Gives a plan to CI: its shards as an output, for the matrix of the jobs that build; as a summary counts, its cost, and what it
    leaves out."""
    github.output("shards", json.dumps([{"name": shard.name, "runner": shard.runner} for shard in plan.shards]))
    counts = Counter(step for task in plan.tasks for step in task.steps)
    lines = [f"- {step}: {number}" for step, number in counts.items()] or ["- nothing to do"]
    lines += [f"- up to date: {plan.unchanged}"]
    unlocked = {task.target for task in plan.tasks if task.kind != "part" and task.hindered.startswith(UNLOCKED)}
    remarks = (*tables.unlocked([image_set.by_target[target] for target in unlocked]), *plan.remarks)
    lines += [*(f"- {remark}" for remark in remarks), f"- {cost}", ""]
    rows = tables.shard_rows(plan.shards)
    text = "\n".join(lines) + "\n" + (github.table(tables.SHARDS, rows) if rows else "") + _left_out(plan)
    github.summary(f"\n## Plan of {plan.date} for {plan.registry}\n\n{text}")


def _left_out(plan: Plan) -> str:
    """What the run cannot do, by what it waits for: a lock that is missing, a package, something below it."""
    causes = _causes((task.target, task.hindered) for task in plan.tasks)
    heads = ((f"### {len(names)} left out: {github.code(reason)}", names) for reason, names in causes.items())
    return "".join(f"\n{head}\n\n{tables.folded(names)}\n" for head, names in heads)


def _causes(hindered: Iterable[tuple[str, str]]) -> dict[str, list[str]]:
    """Targets that wait, by what they wait for."""
    targets: dict[str, dict[str, None]] = {}
    for target, reason in hindered:
        if reason:
            targets.setdefault(status.without_target(reason), {})[target] = None
    return {reason: [*names] for reason, names in targets.items()}


def waiting(state: State) -> Iterator[str]:
    """Says before a run what waits in it and for what, with the command or option that helps."""
    served = state.request.serve or state.image_set.matrix.architectures
    tasks = [task for task in state.tasks() if task.item.architecture in served]
    for reason, names in _causes((task.item.target, task.hindered) for task in tasks).items():
        if reason != ELSEWHERE:
            yield f"{some(names)} {'waits' if len(names) == 1 else 'wait'}: {reason}"
    yield from tables.unlocked([image for image in state.images if not image.locked])
    absent = listed(sorted({task.item.architecture for task in tasks if task.hindered == ELSEWHERE}))
    if absent:
        here = sorted(state.architectures)
        tags = f"tags move when a machine for {absent} has published its images, too"
        yield f"{absent} waits for a machine: {tags}; for {listed(here)} alone, add --serve {' --serve '.join(here)}"


def print_plan(state: State, why: bool) -> None:
    """Prints a line for each item that has steps to do, and counts of the others."""
    tasks = state.tasks()
    to_do = [task for task in tasks if task.steps]
    rows = []
    for task in to_do:
        changed = state.changes(task.item) if why else ()
        reason = "; ".join([*task.why, *([f"changed: {some(changed)}"] if changed else [])])
        rows.append((task.item.target, task.item.architecture, ", ".join(task.steps), reason))
    tables.show(("image", "architecture", "to do", "why"), rows, wrapped=["why"])
    hindered = Counter(task.hindered.partition(":")[0] for task in tasks if task.hindered)
    unchanged = len(tasks) - len(to_do) - sum(hindered.values())
    unlocked = {task.item.target: task.item.thing for task in tasks if task.hindered.startswith(UNLOCKED)}
    rest = "".join(f", {number} {reason}" for reason, number in hindered.items() if reason != UNLOCKED)
    kinds = Counter("part" if task.item.kind == "part" else "image" for task in to_do)
    each = ", each counted by architecture" if len({task.item.architecture for task in to_do}) > 1 else ""
    what = f" ({listed([counted(number, kind) for kind, number in sorted(kinds.items())])}{each})" if to_do else ""
    terminal.console().print(f"{len(to_do)} to do{what}, {unchanged} up to date{rest}", style="dim")
    tables.print_unlocked([thing for thing in unlocked.values() if isinstance(thing, Image)])


def cost(state: State, shards: Sequence[Shard]) -> str:
    """What the requested images cost, in a sentence: machine time of this run, and all that the registry keeps of them."""
    minutes = math.ceil(sum(shard.estimates.seconds for shard in shards) / 60)
    kept = disk.registry_mb(state.image_set, state.images, state.architectures)
    tags = sum(len(image.tags) for image in state.images)
    return (
        f"this run takes about {counted(minutes, 'minute')} of machine time; "
        f"images with {counted(tags, 'tag')} take about {kept / 1000:.1f} GB in the registry"
    )


def show(run: Run, as_json: bool) -> None:
    """Prints what a run did, and writes it into the summary of the CI job, if there is one."""
    print_outcomes(run.outcomes, run.state.date, run.uploaded, run.started, as_json)
    github.summary(markdown(run))


def print_outcomes(outcomes: list[Outcome], date: str, uploaded: int, started: float, as_json: bool) -> None:
    """Prints the outcomes of a command that began at `started`, by the monotonic clock, and sent so many bytes."""
    if as_json:
        content = {
            "date": date,
            "seconds": round(time.monotonic() - started, 2),
            "uploaded": uploaded,
            "counts": dict(Counter(f"{outcome.step} {outcome.state}" for outcome in outcomes)),
            "outcomes": [outcome.to_json() for outcome in outcomes],
        }
        print(json.dumps(content, indent=2))
        return
    colours = {"done": "green", "failed": "red"}
    rows = []
    for it in _shown(outcomes):
        state = tables.coloured(it.state, colours[it.state])
        time_text = time_taken(it.seconds, it.waited)
        rows.append((it.step, it.target, it.architecture, state, time_text, it.reason.partition("\n")[0]))
    tables.show(("step", "image", "architecture", "state", "time", "what"), rows, right=["time"], wrapped=["what"])
    out = terminal.console()
    waiting, unlocked = _waiting(outcomes)
    for reason, number in waiting.items():
        out.print(f"waits: {number} times: {reason}", style="yellow")
    if unlocked:
        out.print(f"waits: {unlocked} without a lock", style="yellow")
    text = ", ".join(_counts(outcomes)) or "nothing to do: everything is up to date"
    out.print(text, _effort(uploaded, started), sep="\n", style="dim")


def _shown(outcomes: list[Outcome]) -> list[Outcome]:
    """What was done or failed. What waits is only counted."""
    return [outcome for outcome in outcomes if outcome.state != "waits"]


def _counts(outcomes: list[Outcome]) -> list[str]:
    """How many outcomes each step has in each state, and their time together."""
    counts = Counter((outcome.step, outcome.state) for outcome in outcomes)
    seconds = {key: sum(x.seconds for x in outcomes if (x.step, x.state) == key) for key in counts}
    return [
        f"{step}: {number} {state}" + (f" in {duration(seconds[step, state])}" if seconds[step, state] >= 1 else "")
        for (step, state), number in counts.items()
    ]


def _effort(uploaded: int, started: float) -> str:
    return f"{size(uploaded)} uploaded, {duration(time.monotonic() - started)}"


def _waiting(outcomes: list[Outcome]) -> tuple[Counter[str], int]:
    """How many items wait, by reason; and how many images and parts wait for a lock."""
    waiting = [outcome for outcome in outcomes if outcome.state == "waits"]
    reasons = Counter(outcome.reason for outcome in waiting if UNLOCKED not in outcome.reason)
    return reasons, len({outcome.target for outcome in waiting if UNLOCKED in outcome.reason})


def markdown(run: Run) -> str:
    """The summary of a CI job."""
    outcomes = run.outcomes
    touched = {(outcome.target, outcome.architecture) for outcome in outcomes}
    skipped = sum(not task.steps and not task.hindered for task in run.state.tasks() if task.item.key not in touched)
    lines = ["", f"## Publishing run of {run.state.date}", "", *(f"- {text}" for text in _counts(outcomes))]
    lines += [f"- {skipped} up to date, left alone", f"- {_effort(run.uploaded, run.started)}", ""]
    rows = []
    for it in _shown(outcomes):
        entry = run.state.entries.get((it.target, it.architecture or store.INDEX))
        bytes_text = size(entry.size) if entry and entry.size else ""
        digest = f"`{entry.digest[:19]}`" if entry and entry.digest else ""
        what, time_text = it.reason.partition("\n")[0], time_taken(it.seconds, it.waited)
        rows.append((it.step, f"`{it.target}`", it.architecture, it.state, time_text, bytes_text, digest, what))
    if rows:
        columns = ("step", "image", "architecture", "state", "time", "size", "digest", "what")
        lines += [github.table(columns, rows)]
    waiting, unlocked = _waiting(outcomes)
    lines += [f"- waits, {counted(number, 'time')}: {reason}" for reason, number in waiting.items()]
    lines += [f"- waits: {unlocked} without a lock"] if unlocked else []
    return "\n".join(lines) + "\n"
