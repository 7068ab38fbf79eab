"""Which images have what a query asks for, in which part, whether VEX says that it does no harm, and what fixes them."""

from __future__ import annotations

import gc
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import asdict, dataclass, replace
from typing import Any, Literal

from rosml.base.errors import RosmlError
from rosml.base.problems import listed, some
from rosml.base.side_by_side import side_by_side
from rosml.containerize.affected.causes import Cause
from rosml.containerize.affected.images import Image, Images
from rosml.containerize.affected.inventory import Matches
from rosml.containerize.affected.query import Component, Query
from rosml.images.image_set.labels import APP
from rosml.images.scan import vex
from rosml.images.scan.cyclonedx import APP as APP_PART
from rosml.images.scan.vex import Statement

State = Literal["affected", "harmless", "clear", "unknown"]
"""`harmless`: VEX says of each component that it does no harm. `unknown`: the image has no SBOM that counts, or is gone."""

Origin = Literal["image", "base", "part", "app", "unknown"]
"""Where a component of an app is from; `part` for add-ons and environments on its base image, `image` for an image that is no app."""


@dataclass(frozen=True)
class Hit:
    """A component that the query is for."""

    name: str
    version: str
    purl: str
    part: str  # the ROS image or part that has it; empty if unknown
    origin: Origin
    fixed: str = ""  # the versions that fix it
    status: str = ""  # of VEX
    reason: str = ""  # of VEX
    needed_by: tuple[Cause, ...] = ()  # of a component that an app brings

    @property
    def is_harmless(self) -> bool:
        return self.status in vex.HARMLESS


@dataclass(frozen=True)
class Answer:
    """About an image for one platform. `--json` prints these fields."""

    image: str
    digest: str
    platform: str
    state: State
    hits: tuple[Hit, ...] = ()
    base: str = ""  # the app's base image, by its tag
    newer_base: str = ""  # the digest of a newer one without what the query asks for
    fix: str = ""  # what fixes it
    command: str = ""  # arguments of rosml that fix it
    notes: tuple[str, ...] = ()

    def to_json(self) -> dict[str, Any]:
        return asdict(self)


class Search:
    """Answers one query. `judge` says which components it is for, from a number on; `fleet` is the file that names the apps, if there is one."""

    def __init__(self, images: Images, query: Query, judge: Callable[[int], Matches], fleet: str = "") -> None:
        self._images, self._query, self._judge, self._fleet = images, query, judge, fleet
        self._matches, self._judged = Matches(), 0

    def run(self, names: Sequence[str], platforms: Iterable[str] = ()) -> list[Answer]:
        chosen = tuple(platforms)
        with _without_collector():
            read = side_by_side(lambda name: self._images.read(name, chosen), names, title="read")
        images = [image for several in read for image in several]
        self._look()
        affected = [image for image in images if self._numbers(image)]
        below = dict(zip(affected, side_by_side(self._below, affected, title="base images"), strict=True))
        self._look()
        with _without_collector():
            return side_by_side(lambda image: self._answer(image, below.get(image)), images, title="causes")

    def _look(self) -> None:
        """Judges the components that were read since."""
        components = self._images.inventory.components
        if len(components) > self._judged:
            self._matches |= self._judge(self._judged)
            self._judged = len(components)

    def _numbers(self, image: Image) -> list[int]:
        return sorted(image.contents.numbers & self._matches.fixed.keys())

    def _below(self, image: Image) -> _Below | None:
        """The base images of an app; None if it is none."""
        try:
            source = self._images.source(image)
        except RosmlError:
            return None
        if not source.labels.get(APP):
            return None
        pinned, newest = self._images.below(source, source.platform)
        return _Below(source.platform, pinned, newest)

    def _answer(self, image: Image, below: _Below | None) -> Answer:
        answer = Answer(image.name, image.place.reference, image.platform, "clear", notes=image.contents.notes)
        if image.why:
            remedy = (image.remedy,) if image.remedy else ()
            return replace(answer, digest="", state="unknown", notes=(image.why, *remedy))
        unclear = [self._images.inventory.components[it] for it in image.contents.numbers & self._matches.unclear]
        if unclear:
            note = f"nobody can compare {some(sorted(map(str, unclear)))}"
            answer = replace(answer, state="unknown", notes=(*answer.notes, note))
        if not (numbers := self._numbers(image)):
            return answer
        hits = self._with_causes(image, [self._hit(number, image, below) for number in numbers])
        state: State = "harmless" if all(hit.is_harmless for hit in hits) else "affected"
        answer = replace(answer, state=state, hits=hits)
        return answer if state == "harmless" else self._with_fix(answer, below)

    def _hit(self, number: int, image: Image, below: _Below | None) -> Hit:
        component = self._images.inventory.components[number]
        origin, part = self._origin(component, below)
        places = [image.place, *([below.pinned.place] if below and below.pinned and origin == "base" else [])]
        statement = self._statement(component, places)
        return Hit(
            component.name,
            component.version,
            component.purl,
            part or component.part,
            origin,
            self._matches.fixed[number],
            statement.status if statement else "",
            statement.reason if statement else "",
        )

    def _with_causes(self, image: Image, hits: Sequence[Hit]) -> tuple[Hit, ...]:
        purls = [hit.purl for hit in hits if hit.origin == "app" and hit.purl]
        try:
            causes = self._images.causes(image, purls) if purls else {}
        except RosmlError:  # the SBOM was read before: the verdict stands without them
            causes = {}
        return tuple(replace(hit, needed_by=causes.get(hit.purl, ())) if hit.origin == "app" else hit for hit in hits)

    def _statement(self, component: Component, places: Iterable[Any]) -> Statement | None:
        if not self._query.is_advisory:
            return None
        every = (vex.about(self._images.statements(it), self._query.text, component.purl) for it in places)
        return next(filter(None, every), None)

    def _origin(self, component: Component, below: _Below | None) -> tuple[Origin, str]:
        """Where a component is from, and the part of the base image that has it."""
        if below is None:
            return "image", ""
        if below.pinned is None:
            return "unknown", ""
        of_base = {it.purl: it for it in self._components(below.pinned)}
        same = of_base.get(component.purl)
        return ("base", same.part) if same else ("app" if component.part in ("", APP_PART) else "part", "")

    def _components(self, image: Image) -> list[Component]:
        """The components of an image that the query is for."""
        return [self._images.inventory.components[number] for number in self._numbers(image)]

    def _with_fix(self, answer: Answer, below: _Below | None) -> Answer:
        harmful = [hit for hit in answer.hits if not hit.is_harmless]
        if below is None:
            parts = listed(sorted({hit.part for hit in harmful if hit.part})) or "it"
            return replace(answer, fix=f"who publishes it builds {parts} again, with {_newer(harmful)}")
        answer = replace(answer, platform=answer.platform or below.platform)
        fixes, command, newer = list[str](), "", ""
        if of_app := [hit for hit in harmful if hit.origin == "app"]:
            fixes.append(f"the app brings {_texts_of(of_app)}: build it again with {_newer(of_app)}")
        if of_parts := [hit for hit in harmful if hit.origin == "part"]:
            names = listed(sorted({hit.part for hit in of_parts}))
            fixes.append(f"rosml rebase brings {names} when it is built with {_newer(of_parts)}")
        if lost := [hit for hit in harmful if hit.origin == "unknown"]:
            fixes.append(f"its base image is gone, so nobody knows what brings {_texts_of(lost)}: build it again")
        if of_base := {hit.name for hit in harmful if hit.origin == "base"}:
            present = {it.name for it in self._components(below.newest)} if below.newest else of_base
            if of_base & present:
                fixes.append(f"{below.name or 'its base image'} has {listed(sorted(of_base & present))} as well")
            elif below.newest:
                newer = below.newest.place.reference
                fixes.append(f"{below.newest.name} no longer has it")
                command = "" if of_app or of_parts or lost else self._command(answer.image)
        return replace(answer, base=below.name, newer_base=newer, fix="; ".join(fixes), command=command)

    def _command(self, app: str) -> str:
        if not self._fleet:
            return f"rebase {app}"
        return f"rebase --all {self._fleet}" + (f" --fixes {self._query.text}" if self._query.is_advisory else "")


@contextmanager
def _without_collector() -> Iterator[None]:
    """SBOMs have many values and no cycles: Python's collector would look through all of them again and again."""
    enabled = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if enabled:
            gc.enable()


@dataclass(frozen=True)
class _Below:
    """The base image of an app, as it was when the app was put on it, and where its tag is now. None: it is gone."""

    platform: str
    pinned: Image | None
    newest: Image | None

    @property
    def name(self) -> str:
        return self.newest.name if self.newest else self.pinned.name if self.pinned else ""


def _texts_of(hits: Iterable[Hit]) -> str:
    return some(sorted({f"{hit.name} {hit.version}" for hit in hits}))


def _newer(hits: Iterable[Hit]) -> str:
    fixes = sorted({f"{hit.name} {hit.fixed}" for hit in hits if hit.fixed})
    return f"{some(fixes)} or newer" if fixes else "another version"
