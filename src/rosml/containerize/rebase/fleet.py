"""Puts many apps, those of a file `apps.yaml`, on their base images' newest digests. Each moves alone: one that is refused or fails
stays. A dated tag comes first, which no later run moves. By the record of a run, `rosml publish undo` moves tags back."""

from __future__ import annotations

import threading
from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass, field, replace
from fnmatch import fnmatchcase
from itertools import chain
from pathlib import Path
from typing import Annotated, Any, Literal

from pydantic import Field

from rosml.base.errors import RosmlError
from rosml.base.problems import InputError, some
from rosml.base.side_by_side import side_by_side
from rosml.containerize.rebase import image
from rosml.containerize.rebase.plan import Plan, Rebased
from rosml.containerize.rebase.rebaser import Rebaser
from rosml.containerize.rebase.screen import Screen
from rosml.containerize.rebase.trial import Pair
from rosml.images.image_set.labels import BASE_NAME
from rosml.images.matrix import source, validate
from rosml.images.matrix.patterns import Facts
from rosml.images.matrix.tags import DATED, dated
from rosml.images.records import tag_moves
from rosml.images.records.store import Records
from rosml.images.records.tag_moves import Move
from rosml.registry import references
from rosml.registry.client import Registry
from rosml.registry.place import Place
from rosml.registry.references import Reference

REFERENCE = r"^[^\s@*?\[]*[a-z/][^\s@*?\[]*(:[A-Za-z0-9_.*?\[\]-]+)?$"
MEANING = {
    REFERENCE: "an app by its tag, without a digest or spaces, such as ghcr.io/me/robot:latest or ghcr.io/me/robot:v*"
}

MANY = 10_000  # most apps of a file, after its patterns were replaced

TIMES = 200  # most dated tags of an app on one day

_OURS = "sha256-"
"""The beginning of tags that are no app's: lists of what is attached to an image."""

RUNS = 30  # how many runs back a fleet looks for moves that somebody undid

State = Literal["moved", "planned", "there", "held", "unaffected", "refused", "failed"]
"""`there`: it was on the newest base image already. `held`: somebody undid the same move."""


class Entry(Facts):
    """One app, or those whose tags match a pattern."""

    app: Annotated[str, Field(pattern=REFERENCE, max_length=500)] = Field(
        description="the app, or a pattern of its tags"
    )
    base: Annotated[str, Field(max_length=500)] = Field(
        default="", description="the new base image; the app's own, where its tag is now, if left out"
    )
    check: Literal["auto", "metadata", "link", "run"] = Field(default="auto", description="as for rosml rebase")
    command: Annotated[str, Field(max_length=4000)] = Field(default="", description="for check: run")

    @property
    def is_pattern(self) -> bool:
        return any(character in self.app for character in "*?[")


class Apps(Facts):
    apps: Annotated[tuple[Entry, ...], Field(min_length=1)] = Field(description="apps that follow their base images")


@dataclass(frozen=True)
class Outcome:
    """What became of an app, or of a pattern without one. `--json` prints these fields."""

    app: str
    state: State
    reason: str = ""
    remedy: str = ""
    rebased: Rebased | None = None

    def to_json(self) -> dict[str, Any]:
        return {name: value for name, value in asdict(self).items() if value}


def read(file: Path) -> tuple[Entry, ...]:
    document = source.read(file, "--all", least="apps: [{app: ghcr.io/me/robot:latest}]")
    apps = validate.checked(document, Apps, MEANING).apps
    problems = []
    for number, entry in enumerate(apps):
        if entry.check == "run" and not entry.command:
            text = "check: run needs the command that it starts; add 'command: …'"
            problems.append(document.problem(("apps", number, "check"), text))
        if entry.command and entry.check != "run":
            text = "only check: run starts a command; add 'check: run', or remove the command"
            problems.append(document.problem(("apps", number, "command"), text))
    if problems:
        raise InputError(document.name, problems)
    return apps


@dataclass(frozen=True)
class _Ready:
    entry: Entry
    plan: Plan
    moves: tuple[Move, ...]
    vulnerable: str  # what the app has, and will have no more; empty if nobody looked


@dataclass(frozen=True)
class _Pushed(_Ready):
    rebased: Rebased


@dataclass
class Fleet:
    """A run over many apps. `trial` links an app in the builder, and starts a command in it, unless that is empty; `screen` names the
    packages of an SBOM that are vulnerable."""

    rebaser: Rebaser
    date: str
    trial: Callable[[Rebased, dict[str, Pair], str], None]
    with_sbom: bool = True
    say: Callable[[str], None] = lambda _: None
    screen: Screen | None = None
    _building: threading.Lock = field(default_factory=threading.Lock)
    _undone: dict[tuple[str, str], frozenset[Move]] = field(default_factory=dict)
    _reading: threading.Lock = field(default_factory=threading.Lock)

    def run(self, entries: Iterable[Entry], dry_run: bool = False) -> list[Outcome]:
        """Moves all apps. An app on another one of them waits for that one."""
        by_app, failed = self._by_app([*entries])
        if len(by_app) > MANY:
            text = f"{len(by_app):,} apps match, and at most {MANY:,} move in a run"
            raise RosmlError(text, "name fewer", exit_code=2)
        below = dict(zip(by_app, side_by_side(self._below, [*by_app], title="read"), strict=True))
        outcomes: dict[str, Outcome] = {}
        for names in _levels(below):
            planned = side_by_side(lambda name: self._plan(name, by_app[name]), names, title="plan")
            if dry_run:
                under = [None if by_app[name].base else outcomes.get(below[name]) for name in names]
                level: Iterable[Outcome] = map(_foreseen, names, planned, under)
            else:
                level = self._carry_out(planned)
            outcomes |= {outcome.app: outcome for outcome in level}
        return [*failed, *(outcomes[name] for name in by_app)]

    def _carry_out(self, planned: Sequence[_Ready | Outcome]) -> Iterator[Outcome]:
        pushed = side_by_side(self._push, [item for item in planned if isinstance(item, _Ready)], title="push")
        ready = [item for item in pushed if isinstance(item, _Pushed)]
        self._record(ready)
        moved = side_by_side(self._move, ready, title="move")
        return (item for item in chain(planned, pushed, moved) if isinstance(item, Outcome))

    def _by_app(self, entries: Sequence[Entry]) -> tuple[dict[str, Entry], list[Outcome]]:
        """The entry for each app: its own, or else that of a pattern. Also, what became of entries that name no app."""
        by_app: dict[str, Entry] = {}
        failed = []
        for entry in sorted(entries, key=lambda entry: entry.is_pattern):
            try:
                names = names_of(entry, self.rebaser.where, self.rebaser.registries)
            except RosmlError as error:
                failed.append(_stopped(entry.app, error))
                continue
            for name in names:
                first = by_app.setdefault(name, entry)
                if first.is_pattern == entry.is_pattern and first.model_copy(update={"app": entry.app}) != entry:
                    text = f"{name} is named twice, and differently: by {first.app} and by {entry.app}"
                    raise RosmlError(text, "let one entry name it", exit_code=2)
        return by_app, failed

    def _below(self, name: str) -> str:
        """The image below an app, by its name; empty if it cannot be read, which its plan will say."""
        try:
            sources = self.rebaser.read(name)
        except RosmlError:
            return ""
        return next((source.labels.get(BASE_NAME, "") for source in sources.values()), "")

    def _plan(self, name: str, entry: Entry) -> _Ready | Outcome:
        try:
            vulnerable = self._screened(name, map(self.rebaser.attachments.sbom, self.rebaser.read(name).values()))
            if self.screen and not vulnerable:
                return Outcome(name, "unaffected")
            plan = self.rebaser.plan(name, entry.base)
            remaining = self._screened(name, (self.rebaser.new_sbom(plan, platform) for platform in plan.members))
            if remaining:
                return Outcome(name, "refused", f"{vulnerable}, and {remaining} on {plan.base.name}", image.AGAIN)
            if plan.changes_nothing:
                return Outcome(name, "there")
            if self._is_undone(plan):
                text = "somebody undid this move; another base image, or another app, moves again"
                return Outcome(name, "held", text, f"to move it nevertheless: rosml rebase {name}")
            return _Ready(entry, plan, self._moves(plan), vulnerable)
        except RosmlError as error:
            return _stopped(name, error)

    def _screened(self, name: str, sboms: Iterable[bytes]) -> str:
        return next(filter(None, (self.screen(sbom, name) for sbom in sboms)), "") if self.screen else ""

    def _moves(self, plan: Plan) -> tuple[Move, ...]:
        """The moves of an app's tags, in their order: the dated one first."""
        host, repository, tag = plan.target
        registry, name, day = self.rebaser.registries(host), repository.rpartition("/")[2], dated(tag, self.date)
        move = Move(name, tag, plan.tag_digest, plan.digest)
        for number in range(1, TIMES):  # the second tag of a day ends in .2
            candidate = f"{day}.{number}" if number > 1 else day
            digest = registry.head(repository, candidate)
            if not digest:
                return Move(name, candidate, "", plan.digest), move
            if digest == plan.digest:
                return (move,)
        text = f"{host}/{repository} has no free tag of the day after {day}"
        raise RosmlError(text, "remove those that you do not need")

    def _is_undone(self, plan: Plan) -> bool:
        """Whether an earlier run moved the tag to the same image, and somebody undid that run."""
        host, repository, tag = plan.target
        prefix, _, name = repository.rpartition("/")
        with self._reading:
            if prefix and (host, prefix) not in self._undone:
                records = Records(Place(self.rebaser.registries(host), prefix))
                self._undone[host, prefix] = frozenset(tag_moves.undone_moves(records, RUNS))
        return Move(name, tag, plan.tag_digest, plan.digest) in self._undone.get((host, prefix), ())

    def _push(self, ready: _Ready) -> _Pushed | Outcome:
        plan = ready.plan
        try:
            rebased = self.rebaser.push(plan, self.with_sbom)
            if self.screen and ready.vulnerable:
                self.rebaser.attach_vex(plan, self.screen.fixed(ready.vulnerable), self.date)
            if plan.needs_link(ready.entry.check):
                with self._building:
                    self.trial(rebased, plan.pairs, ready.entry.command)
                rebased = replace(rebased, linked=True)
        except RosmlError as error:
            return _stopped(plan.app_name, error)
        return _Pushed(ready.entry, plan, ready.moves, ready.vulnerable, rebased)

    def _record(self, pushed: Sequence[_Pushed]) -> None:
        by_place: defaultdict[tuple[str, str], list[Move]] = defaultdict(list)
        for item in pushed:
            by_place[item.plan.target.host, item.plan.target.repository.rpartition("/")[0]] += item.moves
        for (host, prefix), moves in by_place.items():
            if prefix:
                tag_moves.record(Records(Place(self.rebaser.registries(host), prefix)), self.date, moves)
            else:
                text = "apps without a folder have no record, and rosml publish undo does not move them back"
                self.say(f"{host}: {text}")

    def _move(self, pushed: _Pushed) -> Outcome:
        name = pushed.plan.app_name
        try:
            rebased = self.rebaser.move(pushed.plan, pushed.rebased, [move.tag for move in pushed.moves[:-1]])
        except RosmlError as error:
            return Outcome(name, "failed", error.message, error.remedy, pushed.rebased)
        return Outcome(name, "moved", rebased=rebased)


def names_of(entry: Entry, where: Callable[[str], Reference], registries: Callable[[str], Registry]) -> list[str]:
    """The apps of an entry, in full. RosmlError if a pattern matches none."""
    name, _, tag = entry.app.rpartition(":")
    if not name or "/" in tag:
        name, tag = entry.app, "latest"
    if not entry.is_pattern:
        return [str(where(f"{name}:{tag}"))]
    place = where(f"{name}:x")
    tags = moving_tags(registries(place.host), place.repository)
    matching = [item for item in tags if fnmatchcase(item, tag)]
    if not matching:
        has = f"its tags are {some(sorted(tags))}" if tags else "the repository has no tags of apps"
        raise RosmlError(f"no tag of {name} matches {tag}", has, exit_code=2)
    return [str(place._replace(reference=item)) for item in matching]


def moving_tags(registry: Registry, repository: str) -> list[str]:
    """The tags of images in a repository, without dated ones."""
    return [tag for tag in registry.tags(repository) if not DATED.search(tag) and not tag.startswith(_OURS)]


def places(outcomes: Iterable[Outcome]) -> list[str]:
    """The registries with folders, such as `ghcr.io/me`, whose records say where moved tags were: for `rosml publish undo`."""
    moved = [references.parse(item.rebased.reference) for item in outcomes if item.rebased and item.state == "moved"]
    folders = {f"{where.host}/{where.repository.rpartition('/')[0]}" for where in moved if "/" in where.repository}
    return sorted(folders)


def _levels(below: Mapping[str, str]) -> Iterator[list[str]]:
    """Apps in the order in which they can move, by the image below each: those on other ones of them come later."""
    waiting = dict.fromkeys(below)
    while waiting:
        ready = [name for name in waiting if below[name] not in waiting or below[name] == name]
        ready = ready or [*waiting]  # they name each other: each stands for itself
        yield ready
        for name in ready:
            del waiting[name]


def _foreseen(name: str, planned: _Ready | Outcome, under: Outcome | None) -> Outcome:
    """What would become of an app. If the app below it would move, this plan is of an image that does not exist yet."""
    if isinstance(planned, Outcome) and planned.state not in ("there", "refused"):
        return planned
    if under and under.state == "planned":
        return Outcome(name, "planned", f"once {under.app} has moved, if it fits onto that")
    return planned if isinstance(planned, Outcome) else Outcome(name, "planned", rebased=planned.plan.rebased)


def _stopped(name: str, error: RosmlError) -> Outcome:
    return Outcome(name, "refused" if error.exit_code == 2 else "failed", error.message, error.remedy)
