"""Puts many apps on their base images' newest digests: those of a file `apps.yaml`.

Each app moves alone: one that is refused or fails stays, and the others move. A dated tag comes first, which no later run moves. Where tags
were before is in the record of the run, so that `rosml publish undo` moves them back.
"""

from __future__ import annotations

import threading
from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass, field
from fnmatch import fnmatchcase
from itertools import chain
from pathlib import Path
from typing import Annotated, Any, Literal

from pydantic import Field

from rosml.base.errors import RosmlError
from rosml.base.problems import InputError, some
from rosml.base.side_by_side import side_by_side
from rosml.containerize.build.bake_file import BASE_NAME
from rosml.containerize.rebase import image
from rosml.containerize.rebase.rebaser import Plan, Rebased, Rebaser
from rosml.containerize.rebase.trial import Pair
from rosml.images.matrix import source, validate
from rosml.images.matrix.names import DATED, dated
from rosml.images.matrix.patterns import Facts
from rosml.images.records import tag_moves
from rosml.images.records.store import Records
from rosml.images.records.tag_moves import Move
from rosml.registry import references
from rosml.registry.place import Place

REFERENCE = r"^[^\s@*?\[]*[a-z/][^\s@*?\[]*(:[A-Za-z0-9_.*?\[\]-]+)?$"
MEANING = {
    REFERENCE: "an app by its tag, without a digest or spaces, such as ghcr.io/me/robot:latest or ghcr.io/me/robot:v*"
}

MANY = 10_000
"""Most apps of a file, after its patterns were replaced."""

TIMES = 200
"""Most dated tags of an app on one day."""

_OURS = "sha256-"
"""The beginning of tags that are no app's: lists of what is attached to an image."""

RUNS = 30
"""How many runs back a fleet looks for moves that somebody undid."""

State = Literal["moved", "planned", "there", "held", "unaffected", "refused", "failed"]


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


class Apps(Facts):
    """The file."""

    apps: Annotated[tuple[Entry, ...], Field(min_length=1)] = Field(description="apps that follow their base images")


@dataclass
class Outcome:
    """What became of an app.

    Attributes:
        app: its complete reference; of a pattern without one, the pattern.
        state: `moved`, `planned` if it would move without `--dry-run`, `there` if it was on the newest base image already, `held` if
            somebody undid the same move, `unaffected` by the vulnerability, `refused` by the checks, or `failed`.
        reason: why it was refused or failed.
        remedy: what to do about it.
        rebased: the result, if it moved or would move.
    """

    app: str
    state: State
    reason: str = ""
    remedy: str = ""
    rebased: Rebased | None = None

    def to_json(self) -> dict[str, Any]:
        """For `--json`."""
        return {name: value for name, value in asdict(self).items() if value}


def read(file: Path) -> tuple[Entry, ...]:
    """The apps of a file.

    Raises:
        RosmlError: the file is missing or unreadable (exit code 2).
        InputError: with every problem of the file.
    """
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


@dataclass
class Fleet:
    """A run over many apps.

    Attributes:
        rebaser: plans and moves each.
        date: of the run.
        link: links an app in the builder; raises if it lacks something.
        start: starts a command in an app; raises if it fails.
        screen: names the packages of an SBOM that have a vulnerability; None to move all apps.
        with_sbom: attach SBOMs.
        say: prints a line for people.
    """

    rebaser: Rebaser
    date: str
    link: Callable[[Rebased, dict[str, Pair]], None]
    start: Callable[[Rebased, dict[str, Pair], str], None]
    with_sbom: bool = True
    say: Callable[[str], None] = lambda _: None
    screen: Callable[[bytes, str], str] | None = None
    _building: threading.Lock = field(default_factory=threading.Lock)
    _known: dict[tuple[str, str], frozenset[Move]] = field(default_factory=dict)
    _reading: threading.Lock = field(default_factory=threading.Lock)

    def run(self, entries: Iterable[Entry], dry_run: bool = False) -> list[Outcome]:
        """Moves all apps. An app on another one of them waits for that one.

        Args:
            dry_run: plan only, and change nothing.

        Raises:
            RosmlError: two entries say different things of an app (exit code 2), or a registry refuses the record.
        """
        wanted, failed = self._wanted([*entries])
        if len(wanted) > MANY:
            raise RosmlError(
                f"{len(wanted):,} apps match, and at most {MANY:,} move in a run", "name fewer", exit_code=2
            )
        found: dict[str, Outcome] = {}
        below = dict(zip(wanted, side_by_side(self._below, [*wanted], title="read"), strict=True))
        for names in _levels(below):
            planned = side_by_side(lambda name: self._plan(name, wanted[name]), names, title="plan")
            if dry_run:
                for name, item in zip(names, planned, strict=True):
                    under = found.get(below[name]) if not wanted[name].base else None
                    found[name] = _foreseen(name, item, under)
                continue
            ready = [item for item in planned if isinstance(item, _Ready)]
            pushed = side_by_side(self._push, ready, title="push")
            self._record([item for item in pushed if isinstance(item, _Ready)])
            done = side_by_side(self._move, (item for item in pushed if isinstance(item, _Ready)), title="move")
            for outcome in chain(planned, pushed, done):
                if isinstance(outcome, Outcome):
                    found[outcome.app] = outcome
        return [*failed, *(found[name] for name in wanted)]

    def _wanted(self, entries: Sequence[Entry]) -> tuple[dict[str, Entry], list[Outcome]]:
        """The entry for each app: its own, or else that of a pattern. Also, what became of entries that name no app.

        Raises:
            RosmlError: two entries say different things of an app (exit code 2).
        """
        found: dict[str, Entry] = {}
        failed = []
        for entry in sorted(entries, key=_is_pattern):
            try:
                names = self._named(entry)
            except RosmlError as error:
                failed.append(_stopped(entry.app, error))
                continue
            for name in names:
                before = found.setdefault(name, entry)
                if _is_pattern(before) == _is_pattern(entry) and before.model_copy(update={"app": entry.app}) != entry:
                    text = f"{name} is named twice, and differently: by {before.app} and by {entry.app}"
                    raise RosmlError(text, "let one entry name it", exit_code=2)
        return found, failed

    def _named(self, entry: Entry) -> list[str]:
        """The complete references of an entry.

        Raises:
            RosmlError: a pattern matches nothing (exit code 2), or the registry does not answer or refuses.
        """
        name, _, tag = entry.app.rpartition(":")
        if not name or "/" in tag:
            name, tag = entry.app, "latest"
        if not _is_pattern(entry):
            return [str(self.rebaser.where(f"{name}:{tag}"))]
        place = self.rebaser.where(f"{name}:x")
        known = self.rebaser.registries(place.host).tags(place.repository)
        tags = [item for item in known if not DATED.search(item) and not item.startswith(_OURS)]
        matching = [item for item in tags if fnmatchcase(item, tag)]
        if not matching:
            has = f"its tags are {some(sorted(tags))}" if tags else "the repository has no tags of apps"
            raise RosmlError(f"no tag of {name} matches {tag}", has, exit_code=2)
        return [str(place._replace(reference=item)) for item in matching]

    def _below(self, name: str) -> str:
        """The image below an app, by its name; empty if it cannot be read, which its plan will say."""
        try:
            sources = self.rebaser.read(name)
        except RosmlError:
            return ""
        return next((source.labels.get(BASE_NAME, "") for source in sources.values()), "")

    def _plan(self, name: str, entry: Entry) -> _Ready | Outcome:
        try:
            has = self._has(name) if self.screen else ""
            if self.screen and not has:
                return Outcome(name, "unaffected")
            plan = self.rebaser.plan(name, entry.base)
            if left := self._left(plan) if self.screen else "":
                return Outcome(name, "refused", f"{has}, and {left} on {plan.base.name}", image.AGAIN)
            if plan.there == plan.digest:
                return Outcome(name, "there")
            if self._undone(plan):
                back = f"to move it nevertheless: rosml rebase {name}"
                return Outcome(
                    name, "held", "somebody undid this move; another base image, or another app, moves again", back
                )
            return _Ready(name, entry, plan, self._moves(plan))
        except RosmlError as error:
            return _stopped(name, error)

    def _has(self, name: str) -> str:
        """The packages of an app that have the vulnerability."""
        assert self.screen
        found = [self.screen(self.rebaser.sbom(source), name) for source in self.rebaser.read(name).values()]
        return next(filter(None, found), "")

    def _left(self, plan: Plan) -> str:
        """The packages that have it on the new base image as well."""
        assert self.screen
        found = [self.screen(self.rebaser.new_sbom(plan, platform), plan.named) for platform in plan.images]
        return next(filter(None, found), "")

    def _moves(self, plan: Plan) -> list[Move]:
        """The moves of an app's tags, in their order: the dated one first.

        Raises:
            RosmlError: too many of the day are there; the registry does not answer or refuses.
        """
        host, repository, tag = plan.target
        registry = self.rebaser.registries(host)
        name = repository.rpartition("/")[2]
        day = dated(tag, self.date)
        found = []
        for candidate in (
            day,
            *(f"{day}.{number}" for number in range(2, TIMES)),
        ):  # the second tag of a day ends in .2
            there = registry.head(repository, candidate)
            if not there:
                found.append(Move(name, candidate, "", plan.digest))
            if there in ("", plan.digest):
                return [*found, Move(name, tag, plan.there, plan.digest)]
        raise RosmlError(
            f"{host}/{repository} has no free tag of the day after {day}", "remove those that you do not need"
        )

    def _undone(self, plan: Plan) -> bool:
        """Whether an earlier run moved the tag to the same image, and somebody undid that run.

        Raises:
            RosmlError: the registry does not answer, or a record cannot be read.
        """
        host, repository, tag = plan.target
        prefix, _, name = repository.rpartition("/")
        with self._reading:
            if prefix and (host, prefix) not in self._known:
                book = Records(Place(self.rebaser.registries(host), prefix))
                self._known[host, prefix] = frozenset(tag_moves.undone_moves(book, RUNS))
        return Move(name, tag, plan.there, plan.digest) in self._known.get((host, prefix), ())

    def _push(self, ready: _Ready) -> _Ready | Outcome:
        """Pushes an app by its digest, and tries it in the builder."""
        try:
            ready.rebased = self.rebaser.push(ready.plan, self.with_sbom)
            pairs, check = self.rebaser.pairs(ready.plan), ready.entry.check
            undecided = check == "auto" and bool(ready.plan.judgement.undecided)
            if check in ("link", "run") or undecided:
                with self._building:
                    self.link(ready.rebased, pairs)
                    ready.rebased.linked = True
                    if check == "run":
                        self.start(ready.rebased, pairs, ready.entry.command)
        except RosmlError as error:
            return _stopped(ready.name, error)
        return ready

    def _record(self, ready: Sequence[_Ready]) -> None:
        """Records where tags were, beside the apps."""
        by_place: defaultdict[tuple[str, str], list[Move]] = defaultdict(list)
        for item in ready:
            by_place[item.plan.target.host, item.plan.target.repository.rpartition("/")[0]] += item.moves
        for (host, prefix), moves in by_place.items():
            if prefix:
                tag_moves.record(Records(Place(self.rebaser.registries(host), prefix)), self.date, moves)
            else:
                self.say(
                    f"{host}: apps without a folder have no record, and rosml publish undo does not move them back"
                )

    def _move(self, ready: _Ready) -> Outcome:
        assert ready.rebased
        try:
            self.rebaser.move(ready.plan, ready.rebased, [move.tag for move in ready.moves[:-1]])
        except RosmlError as error:
            return Outcome(ready.name, "failed", error.message, error.remedy, ready.rebased)
        return Outcome(ready.name, "moved", rebased=ready.rebased)


def places(outcomes: Iterable[Outcome]) -> list[str]:
    """The registries with folders, such as `ghcr.io/me`, whose records say where moved tags were: for `rosml publish undo`."""
    moved = [references.parse(item.rebased.reference) for item in outcomes if item.rebased and item.state == "moved"]
    found = {f"{where.host}/{where.repository.rpartition('/')[0]}" for where in moved if "/" in where.repository}
    return sorted(found)


def _levels(below: Mapping[str, str]) -> Iterator[list[str]]:
    """Apps in the order in which they can move: those on other ones of them come later.

    Args:
        below: the image below each app.
    """
    left = dict.fromkeys(below)
    while left:
        ready = [name for name in left if below[name] not in left or below[name] == name]
        ready = ready or [*left]  # they name each other: each stands for itself
        yield ready
        for name in ready:
            del left[name]


def _foreseen(name: str, planned: _Ready | Outcome, under: Outcome | None) -> Outcome:
    """What would become of an app.

    Args:
        under: what would become of the app below it. If that would move, this plan is of an image that is not there yet.
    """
    if isinstance(planned, Outcome) and planned.state not in ("there", "refused"):
        return planned
    if under and under.state == "planned":
        return Outcome(name, "planned", f"once {under.app} has moved, if it fits onto that")
    return planned if isinstance(planned, Outcome) else Outcome(name, "planned", rebased=planned.plan.result)


def _stopped(name: str, error: RosmlError) -> Outcome:
    return Outcome(name, "refused" if error.exit_code == 2 else "failed", error.message, error.remedy)


def _is_pattern(entry: Entry) -> bool:
    return any(character in entry.app for character in "*?[")


@dataclass
class _Ready:
    """An app that may move."""

    name: str
    entry: Entry
    plan: Plan
    moves: list[Move]
    rebased: Rebased | None = None
