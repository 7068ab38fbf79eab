"""The state of a registry's images, and the steps that each of them needs: the matrix and locks, compared with the records.

This module only decides: `survey.py` asks, and `run.py` carries out. A step that was done from the same inputs is not
due again. So if a publishing run is interrupted, the next one continues, on any machine.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property

from rosml.base.problems import listed, some
from rosml.images.bake.inputs import Inputs
from rosml.images.builds import base_images, contents, package_state
from rosml.images.image_set import missing_locks
from rosml.images.image_set.model import Image, ImageSet, Part
from rosml.images.matrix.sizes import Size
from rosml.images.publish.items import (
    ABSENT,
    ELSEWHERE,
    ENDED,
    NO_SBOM,
    UNDESCRIBED,
    WAITING,
    Item,
    Key,
    Step,
    Task,
    ros_images,
)
from rosml.images.publish.shared_tests import SharedTests
from rosml.images.records.store import INDEX, Entry, Records
from rosml.machine.services import Services
from rosml.registry.place import Place


@dataclass(frozen=True)
class Request:
    """What a survey has to find out."""

    services: Services
    image_set: ImageSet
    place: Place
    date: str = ""  # of the run; empty if nothing will be built
    only: tuple[str, ...] = ()  # patterns of targets, or groups; all if empty
    architectures: tuple[str, ...] = ()  # those to work for; the machine's own if empty
    serve: tuple[str, ...] = ()  # the architectures that the registry serves; all of the matrix if empty
    force: bool = False
    scanning: str = ""  # digest of the scan policy; empty if images need no scan
    # The package state of distributions, from a plan. All steps of a run use the plan's state. Packages that move later
    # wait for the next run, unless a build fails because of them.
    package_state: Mapping[str, str] = field(default_factory=dict)
    whole: bool = False  # judge the ROS images and parts below images on all of their architectures
    inputs: Inputs | None = None  # inputs of the image set's targets, if they were read before
    even_ended: bool = False  # also images of distributions past their end of life; else their tags stay where they are
    all_tests: bool = False  # the requested images run all tests, also those that passed in others with the same parts
    # Names of parts, and targets of ROS images, that other machines of the run build. They are built here only if they are missing at the end.
    elsewhere: frozenset[str] | None = None  # None if there are no other machines


@dataclass
class State:
    """The requested images and parts, and what the registry and the package repositories say about them."""

    request: Request
    inputs: Inputs
    images: tuple[Image, ...]  # the requested images
    architectures: tuple[str, ...]  # those that this run works for
    entries: dict[Key, Entry] = field(default_factory=dict)  # of the records; a run keeps them up to date
    present: set[Key] = field(default_factory=set)  # the entries whose manifest is in the registry
    package_state: dict[str, str] = field(default_factory=dict)  # of each distribution whose repositories answered
    # Packages that the archive of a distribution lacks, by distribution and architecture.
    unpublished: dict[Key, frozenset[str]] = field(default_factory=dict)
    closed: frozenset[str] = frozenset()  # distributions past their end of life, whose tags stay where they are
    remarks: list[str] = field(default_factory=list)  # for people, such as a repository that does not answer
    forced: set[Key] = field(default_factory=set)  # items that a run with `force` rebuilt already

    @property
    def image_set(self) -> ImageSet:
        return self.request.image_set

    @property
    def place(self) -> Place:
        return self.request.place

    @property
    def date(self) -> str:
        return self.request.date

    @property
    def records(self) -> Records:
        return Records(self.place)

    @cached_property
    def items(self) -> tuple[Item, ...]:
        """All items in the order of work: ROS images from the lowest up, parts, then joined images."""
        ros: dict[Key, Item] = {}
        parts: dict[Key, Item] = {}
        joined: dict[Key, Item] = {}
        for image in self.images:
            chain = ros_images(self.image_set, image)
            image_parts = [] if self.end(image) else [self.image_set.part_by_name[name] for name in image.parts]
            for architecture in self.image_set.matrix.architectures if self.request.whole else image.architectures:
                for link in chain:
                    if architecture in link.architectures:
                        ros.setdefault((link.target, architecture), Item(link, architecture, self._needs(link)))
                for part in image_parts:
                    if architecture in part.architectures:
                        parts.setdefault((part.target, architecture), Item(part, architecture, ()))
                if image.stack and architecture in image.architectures:
                    joined[image.target, architecture] = Item(image, architecture, self._needs(image))
        return (*ros.values(), *parts.values(), *joined.values())

    @cached_property
    def forecast(self) -> ImageSet:
        """The image set with measured sizes of ROS images. To an unmeasured one, the matrix's forecast adds its own size."""
        sizes: dict[str, Size] = {}
        for image in self.image_set.images:
            if image.stack is None:
                sizes[image.target] = self._size(image, sizes)
        images = tuple(replace(image, disk=sizes.get(image.target, image.disk)) for image in self.image_set.images)
        return replace(self.image_set, images=images)

    def _size(self, image: Image, sizes: Mapping[str, Size]) -> Size:
        entries = [self.entries.get((image.target, architecture)) for architecture in image.architectures]
        if measured := [(entry.unpacked, entry.size) for entry in entries if entry and entry.unpacked and entry.size]:
            unpacked, compressed = max(measured)
            return Size(unpacked=unpacked // 1_000_000, compressed=compressed // 1_000_000)
        below = self.image_set.by_target.get(image.parent)
        return Size.total(sizes[below.target], image.disk - below.disk) if below else image.disk

    @cached_property
    def tests(self) -> SharedTests:
        def outdated(key: Key) -> list[str]:
            return self.reasons(self.by_key[key]) if key in self.by_key else []

        requested = frozenset(image.target for image in self.images)
        return SharedTests(self.image_set, self.inputs, self.entries, requested, self.request.all_tests, outdated)

    @cached_property
    def by_key(self) -> dict[Key, Item]:
        return {item.key: item for item in self.items}

    def task(self, item: Item, ahead: bool = True) -> Task:
        """The steps that an item needs. With `ahead`, for a plan, its needs will be built if they can be built here."""
        if reason := self.hindrance(item):
            return Task(item, hindered=reason)
        lacking = [target for target in item.needs if not self.is_current((target, item.architecture))]
        hindered = ((target, self._hindrance_below((target, item.architecture))) for target in lacking)
        first, reason = next((pair for pair in hindered if pair[1]), ("", ""))
        if lacking and not ahead and not reason:
            first, reason = lacking[0], "it is not made yet"
        if reason:
            return Task(item, hindered=reason if reason == ELSEWHERE else f"{reason} (for {first})")
        why = self.reasons(item)
        if lacking and item.key in self.entries and self.entries[item.key].digest:
            why += [f"{target} is rebuilt" for target in lacking]
        elif lacking and not why:
            why = [f"{target} is built first" for target in lacking]
        entry = None if why else self.entries[item.key]
        steps = self._checks(item, entry)
        if item.architecture not in self.architectures and "test" in steps:
            if not why:
                return Task(item, hindered=ELSEWHERE)
            steps = ()
        if why:
            return Task(item, (item.making, *steps), tuple(why))
        if not steps:
            return Task(item)
        first = "it was not scanned by this policy" if steps[0] == "scan" else f"it was {self.tests.outcome(item)}"
        return Task(item, steps, (first,))

    def look_again(self, item: Item) -> None:
        """Reads the record of an item once more: another machine may have made it since."""
        entry = self.records.read(*item.key)
        if entry and entry != self.entries.get(item.key):
            self.entries[item.key] = entry
            self.present.discard(item.key)
            if entry.digest and self.place.client.head(self.place.path(entry.repository), entry.digest):
                self.present.add(item.key)

    def is_current(self, key: Key) -> bool:
        """Whether an item is in the registry and up to date."""
        return key in self.by_key and not self.reasons(self.by_key[key])

    def reasons(self, item: Item) -> list[str]:
        """Why an item has to be built or joined; empty if it is up to date."""
        entry = self.entries.get(item.key)
        if entry is None or not entry.digest:
            return ["it was never made"]
        # An entry with the date of this run was made by this run, perhaps on another machine.
        if self.request.force and item.key not in self.forced and entry.date != self.date:
            return ["--force"]
        why = []
        if entry.inputs != self.inputs.digest(item.target, item.architecture):
            why.append("its inputs changed")
        if item.kind == "ros" and (moved := self._moved(item, entry)):
            why.append(moved)
        if item.key not in self.present:
            why.append("it is not in the registry any more")
        if not entry.sbom:
            why.append(NO_SBOM)
        elif entry.described != contents.FORMAT:
            why.append(UNDESCRIBED)
        for target in item.needs:
            part = self.entries.get((target, item.architecture))
            if part and part.digest and entry.parts.get(target) != part.digest:
                why.append(f"{target} changed")
        return why

    def _moved(self, item: Item, entry: Entry) -> str:
        assert isinstance(item.thing, Image)
        now = self.package_state.get(item.thing.distribution, "")
        # ROS may have published packages after the plan, and another machine of this run used them.
        newer = entry.changed == self.date and package_state.ros_date(entry.package_state) > package_state.ros_date(now)
        if newer or now in ("", entry.package_state):
            return ""
        return f"packages moved from {entry.package_state or 'an unknown state'} to {now}"

    def _checks(self, item: Item, entry: Entry | None) -> tuple[Step, ...]:
        steps: list[Step] = []
        if item.kind != "part" and not (entry and self.tests.passed(item, entry)):
            steps.append("test")
        # A part is scanned with the images that have it.
        clean = entry and entry.scanned == "clean" and entry.scan.get("policy") == self.request.scanning
        if self.request.scanning and item.kind != "part" and not clean:
            steps.append("scan")
        return tuple(steps)

    def _needs(self, image: Image) -> tuple[str, ...]:
        below = (image.parent,) if image.parent in self.image_set.by_target else ()
        return (*below, *(self.image_set.part_by_name[name].target for name in image.parts))

    def hindrance(self, item: Item) -> str:
        """Why an item cannot be built on this machine; empty if it can."""
        image_or_part = item.thing
        if reason := self.end(image_or_part):
            return reason
        if reason := missing_locks.hindrance(image_or_part, item.architecture):
            return reason
        if item.kind == "joined":  # any machine can join in the registry
            return ""
        if item.architecture not in self.architectures:
            return ELSEWHERE
        if isinstance(image_or_part, Part):  # builds on any base image that this machine has
            return ""
        unpublished = self.unpublished.get((image_or_part.distribution, item.architecture), frozenset())
        if absent_packages := sorted(unpublished.intersection(image_or_part.packages.split())):
            return f"{ABSENT} {listed(absent_packages)} for {image_or_part.os}, {item.architecture}"
        systems = self.image_set.matrix.operating_systems
        absent = base_images.missing(self.request.services, systems, image_or_part.os)
        return f"{WAITING}: {absent}" if absent else ""

    def end(self, thing: Image | Part) -> str:
        """Why the tags of an image stay where they are for good; empty if they do not."""
        if not isinstance(thing, Image) or thing.distribution not in self.closed:
            return ""
        return f"{ENDED}: {thing.distribution} had its end of life on {self.image_set.matrix.distributions[thing.distribution].eol}"

    def damage(self, thing: Image | Part) -> str:
        """Which locks of an image are there and unusable: somebody has to correct them. Empty if none is."""
        return (
            missing_locks.damage(thing, [name for _, name in self.members(thing)]) if isinstance(thing, Image) else ""
        )

    def _hindrance_below(self, key: Key) -> str:
        """Why an item, or something below it, cannot be built here."""
        item = self.by_key[key]
        if reason := self.hindrance(item):
            return reason
        entry = self.entries.get(key)
        if entry and entry.failed and entry.changed == self.date:
            return f"its {entry.failed.get('step', 'build')} failed in this run"
        for target in item.needs:
            below = (target, item.architecture)
            if not self.is_current(below) and (reason := self._hindrance_below(below)):
                return reason
        return ""

    # ---- Indexes -----------------------------------------------------------------------------------------------------

    def members(self, thing: Image | Part) -> tuple[Key, ...]:
        """The members of an index, as target and architecture: the architectures that the registry serves."""
        serve = self.request.serve
        return tuple((thing.target, name) for name in thing.architectures if not serve or name in serve)

    def unready(self, thing: Image | Part) -> str:
        """Why the index of an image or part cannot be made; empty if it can."""
        if reason := self.end(thing) or self.damage(thing):
            return reason
        keys = self.members(thing)
        if not keys:
            return f"it does not exist for {', '.join(self.request.serve)}"
        for key in keys:
            item, entry = self.by_key.get(key), self.entries.get(key)
            if item is None or entry is None or not entry.digest:
                return f"{key[1]} is missing" + (f": {self.hindrance(item)}" if item and self.hindrance(item) else "")
            if why := self.reasons(item):
                return f"{key[1]}: {why[0]}"
            if item.kind != "part" and not self.tests.passed(item, entry):
                failures = f"tests failed: {some(list(entry.failures))}" if entry.failures else ""
                return f"{key[1]}: {failures or self.tests.outcome(item)}"
            if item.kind != "part" and (reason := self.tests.unproven(item)):
                return f"{key[1]}: {reason}"
            if self.request.scanning and "scan" in self._checks(item, entry):
                outcome = "not done by this policy" if entry.scanned == "clean" else entry.scanned or "not done"
                return f"{key[1]}: scan: {outcome}"
            if item.kind == "part" and not self._used(entry):
                if tester := self.failed_tester(entry):
                    return f"{key[1]}: tests of {tester.target} failed"
                checks = "its tests and the scan" if self.request.scanning else "its tests"
                return f"{key[1]}: no image that has it passed {checks} yet"
        return ""

    def _used(self, part: Entry) -> bool:
        return any(
            not self._checks(item, self.entries[item.key]) and not self.tests.unproven(item)
            for item in self._joined_with(part)
        )

    def failed_tester(self, part: Entry) -> Item | None:
        """An image that has a part and whose tests failed, if no image that has it passed them."""
        failed = (it for it in self._joined_with(part) if self.entries[it.key].failures and not self.reasons(it))
        return None if self._used(part) else next(failed, None)

    def _joined_with(self, part: Entry) -> Iterator[Item]:
        for key, item in self.by_key.items():
            entry = self.entries.get(key)
            if (
                entry
                and item.kind == "joined"
                and item.architecture == part.architecture
                and entry.parts.get(part.target) == part.digest
            ):
                yield item

    def things(self) -> tuple[Image | Part, ...]:
        """Images and parts that get an index: the requested ones, and those below them. An image without tags only tests."""
        things = {item.target: item.thing for item in self.items}.values()
        return tuple(thing for thing in things if isinstance(thing, Part) or thing.tags)

    def index_of(self, thing: Image | Part) -> Entry | None:
        return self.entries.get((thing.target, INDEX))

    def is_of_these(self, thing: Image | Part, index: Entry) -> bool:
        """Whether the index of an image or part is made of its images as they are now."""
        members = {key[1]: self.entries[key].digest for key in self.members(thing)}
        return index.parts == members and index.inputs == self.inputs.together(thing)

    # ---- For people --------------------------------------------------------------------------------------------------

    def tasks(self) -> list[Task]:
        return [self.task(item) for item in self.items]

    def changes(self, item: Item) -> list[str]:
        """Names of an item's inputs that changed since it was made. This reads the records."""
        recorded, inputs = self.records.inputs(*item.key), self.inputs.of(item.target, item.architecture)
        names = recorded.keys() | inputs.keys() if recorded else ()
        return sorted(name for name in names if recorded.get(name) != inputs.get(name))
