"""What is known of the images of a registry, and what is to be done about each: how it should be, compared with its records.

Nothing is done here, and nobody is asked: `survey.py` asks, and `run.py` does. A step that was done before, from the same
inputs, is not to be done again; so a publishing run that was interrupted goes on where it was, on any machine.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Literal

from rosml.base.problems import listed, some
from rosml.images.bake.inputs import TARGET, Inputs
from rosml.images.builds import base_images, package_state
from rosml.images.image_set import missing
from rosml.images.image_set.model import Image, ImageSet, Part, repository_of
from rosml.images.matrix.model import Size
from rosml.images.records.store import INDEX, Entry, Records
from rosml.machine.services import Services
from rosml.registry.place import Place

Kind = Literal["ros", "part", "joined"]
Step = Literal["build", "join", "test", "scan"]

ABSENT = "the archive has no"
"""How the reason begins why a row cannot be built whose packages nobody published."""

WAITING = "waiting for a builder"
ELSEWHERE = f"{WAITING} of its architecture"


@dataclass(frozen=True)
class Item:
    """An image or part on one architecture.

    Attributes:
        thing: the image or part.
        architecture: under BuildKit's name.
        needs: bake targets of what it is put together from: the ROS image below, and parts.
    """

    thing: Image | Part
    architecture: str
    needs: tuple[str, ...]

    @property
    def target(self) -> str:
        """Its bake target."""
        return self.thing.target

    @property
    def kind(self) -> Kind:
        """ROS images and parts are built; a joined image is joined of them."""
        if isinstance(self.thing, Part):
            return "part"
        return "joined" if self.thing.stack else "ros"

    @property
    def repository(self) -> str:
        """Without the registry's prefix."""
        return repository_of(self.thing)

    @property
    def key(self) -> tuple[str, str]:
        """Target and architecture."""
        return self.target, self.architecture

    @property
    def making(self) -> Step:
        """The step that makes it."""
        return "join" if self.kind == "joined" else "build"


@dataclass(frozen=True)
class Task:
    """What is to be done about an item.

    Attributes:
        steps: in order; empty where nothing is. why: reasons for the first of them.
        hindered: why none of it can be done here; empty where it can.
    """

    item: Item
    steps: tuple[Step, ...] = ()
    why: tuple[str, ...] = ()
    hindered: str = ""


@dataclass(frozen=True)
class Request:
    """What a survey is asked.

    Attributes:
        services: what this machine has.
        image_set: all that the matrix describes.
        place: where the images are.
        date: of the run; empty if nothing will be made.
        only: patterns of targets, or groups; all if empty.
        architectures: those to work for; the machine's own if empty.
        serve: the architectures that the registry serves; all of the matrix if empty.
        force: make everything anew.
        scanning: digest of the scan policy; empty if images need no scan.
        package_state: of distributions, by a plan. All steps of a run take packages to be as the plan says; what moves after
            it is the next run's, unless a build can have it no other way.
        whole: judge what images stand on for all of its architectures.
        inputs: of the image set's targets, if they were read before.
    """

    services: Services
    image_set: ImageSet
    place: Place
    date: str = ""
    only: tuple[str, ...] = ()
    architectures: tuple[str, ...] = ()
    serve: tuple[str, ...] = ()
    force: bool = False
    scanning: str = ""
    package_state: Mapping[str, str] = field(default_factory=dict)
    whole: bool = False
    inputs: Inputs | None = None


@dataclass
class State:
    """The images and parts that are asked for, and what is known of them.

    Attributes:
        request: what was asked.
        inputs: of the image set's targets.
        images: those that are asked for.
        architectures: those that this run works for.
        known: entries of the records by target and architecture; a run keeps them up to date.
        present: the entries whose manifest is in the registry.
        package_state: of each distribution whose repositories answered.
        lacking: packages that the archive of a distribution does not have, by distribution and architecture.
        remarks: what people should know, such as a repository that does not answer.
        forced: what a run with `force` made anew already.
        digests: of tests, which are made once.
    """

    request: Request
    inputs: Inputs
    images: tuple[Image, ...]
    architectures: tuple[str, ...]
    known: dict[tuple[str, str], Entry] = field(default_factory=dict)
    present: set[tuple[str, str]] = field(default_factory=set)
    package_state: dict[str, str] = field(default_factory=dict)
    lacking: dict[tuple[str, str], frozenset[str]] = field(default_factory=dict)
    remarks: list[str] = field(default_factory=list)
    forced: set[tuple[str, str]] = field(default_factory=set)
    digests: dict[tuple[str, str, tuple[str, ...]], str] = field(default_factory=dict, repr=False)

    @property
    def image_set(self) -> ImageSet:
        """All that the matrix describes."""
        return self.request.image_set

    @property
    def place(self) -> Place:
        """Where the images are."""
        return self.request.place

    @property
    def date(self) -> str:
        """Of the run."""
        return self.request.date

    @property
    def records(self) -> Records:
        """The records of the registry."""
        return Records(self.place)

    @cached_property
    def items(self) -> tuple[Item, ...]:
        """In the order of work: ROS images from the lowest up, parts, then what is joined of both."""
        ros: dict[tuple[str, str], Item] = {}
        parts: dict[tuple[str, str], Item] = {}
        joined: dict[tuple[str, str], Item] = {}
        for image in self.images:
            chain = [image] if image.stack is None else []
            below = self.image_set.by_target.get(image.parent)
            while below:
                chain.append(below)
                below = self.image_set.by_target.get(below.parent)
            own = [self.image_set.part_by_name[name] for name in image.parts]
            for architecture in self.image_set.matrix.architectures if self.request.whole else image.architectures:
                for link in reversed(chain):
                    if architecture in link.architectures:
                        ros.setdefault((link.target, architecture), Item(link, architecture, self._needs(link)))
                for part in own:
                    if architecture in part.architectures:
                        parts.setdefault((part.target, architecture), Item(part, architecture, ()))
                if image.stack and architecture in image.architectures:
                    joined[image.target, architecture] = Item(image, architecture, self._needs(image))
        return (*ros.values(), *parts.values(), *joined.values())

    @cached_property
    def forecast(self) -> ImageSet:
        """The image set with the sizes of ROS images that earlier runs measured, in the place of what the matrix forecasts. What
        stands on such an image, and was never measured, adds to it what the matrix says."""
        sizes: dict[str, Size] = {}
        for image in self.image_set.images:
            if image.stack is None:
                sizes[image.target] = self._size(image, sizes)
        images = tuple(replace(image, disk=sizes.get(image.target, image.disk)) for image in self.image_set.images)
        return replace(self.image_set, images=images)

    def _size(self, image: Image, sizes: Mapping[str, Size]) -> Size:
        entries = [self.known.get((image.target, architecture)) for architecture in image.architectures]
        if found := [(entry.unpacked, entry.size) for entry in entries if entry and entry.unpacked and entry.size]:
            unpacked, compressed = max(found)
            return Size(unpacked=unpacked // 1_000_000, compressed=compressed // 1_000_000)
        below = self.image_set.by_target.get(image.parent)
        return Size.total(sizes[below.target], image.disk - below.disk) if below else image.disk

    @cached_property
    def _asked(self) -> frozenset[str]:
        """Targets of the images that are part of this run."""
        return frozenset(image.target for image in self.images)

    @cached_property
    def by_key(self) -> dict[tuple[str, str], Item]:
        """Items by target and architecture."""
        return {item.key: item for item in self.items}

    def task(self, item: Item, ahead: bool = True) -> Task:
        """What is to be done about an item, by what is known now.

        Args:
            item: one of `items`.
            ahead: take what it needs for as good as made, if only that can be made here: a plan. Otherwise it has to be there.
        """
        if reason := self.hindrance(item):
            return Task(item, hindered=reason)
        lacking = [target for target in item.needs if not self.made((target, item.architecture))]
        hindered = {target: reason for target in lacking if (reason := self._reason((target, item.architecture)))}
        if hindered or (lacking and not ahead):
            first, reason = next(iter(hindered.items()), (lacking[0] if lacking else "", "it is not made yet"))
            return Task(item, hindered=reason if reason == ELSEWHERE else f"{reason} (for {first})")
        why = self.reasons(item)
        if lacking and item.key in self.known and self.known[item.key].digest:
            why += [f"{target} is made anew" for target in lacking]
        elif lacking and not why:
            why = [f"{target} is made first" for target in lacking]
        entry = None if why else self.known[item.key]
        steps = self._checks(item, entry)
        if item.architecture not in self.architectures and "test" in steps:
            if not why:
                return Task(item, hindered=ELSEWHERE)
            steps = ()
        if why:
            return Task(item, (item.making, *steps), tuple(why))
        if not steps:
            return Task(item)
        first = "it was not scanned by this policy" if steps[0] == "scan" else f"it was {self._untested(item)}"
        return Task(item, steps, (first,))

    def made(self, key: tuple[str, str]) -> bool:
        """Whether an item is in the registry as it should be."""
        return key in self.by_key and not self.reasons(self.by_key[key])

    def reasons(self, item: Item) -> list[str]:
        """Why an item is to be made anew; nothing where it is as it should be."""
        entry = self.known.get(item.key)
        if entry is None or not entry.digest:
            return ["it was never made"]
        # What another machine made in this run, which has one date, is not made once more.
        if self.request.force and item.key not in self.forced and entry.date != self.date:
            return ["--force"]
        why = []
        if entry.inputs != self.inputs.digest(item.target, item.architecture):
            why.append("its inputs changed")
        if item.kind == "ros" and (moved := self._moved(item, entry)):
            why.append(moved)
        if item.key not in self.present:
            why.append("it is not in the registry any more")
        if item.kind != "joined" and not entry.sbom:  # of a version that had the scan make them
            why.append("it has no SBOM")
        for target in item.needs:
            part = self.known.get((target, item.architecture))
            if part and part.digest and entry.parts.get(target) != part.digest:
                why.append(f"{target} is another one")
        return why

    def _moved(self, item: Item, entry: Entry) -> str:
        assert isinstance(item.thing, Image)
        now = self.package_state.get(item.thing.distribution, "")
        # Another machine of this run may have found packages that ROS published after the plan.
        if entry.changed == self.date and package_state.ros_date(entry.package_state) > package_state.ros_date(now):
            return ""
        return (
            f"packages moved from {entry.package_state or 'nobody knows when'} to {now}"
            if now not in ("", entry.package_state)
            else ""
        )

    def _checks(self, item: Item, entry: Entry | None) -> tuple[Step, ...]:
        """The checks that are still to be done; all of them for an item that is to be made."""
        steps: list[Step] = []
        if item.kind != "part" and not (entry and self.passed(item, entry)):
            steps.append("test")
        # A part is scanned as a part of the images that have it.
        clean = entry and entry.scanned == "clean" and entry.scan.get("policy") == self.request.scanning
        if self.request.scanning and item.kind != "part" and not clean:
            steps.append("scan")
        return tuple(steps)

    def passed(self, item: Item, entry: Entry) -> bool:
        """Whether the tests that there are now passed in the image of an entry: all, or those that it runs itself."""
        return self._tested(item, entry) and entry.passed > 0 and not entry.failures

    def _untested(self, item: Item) -> str:
        """What is known of the tests of an image that did not pass those that there are now."""
        entry = self.known[item.key]
        if not entry.tested:
            return "not tested yet"
        if not self._tested(item, entry):
            return "tested before its tests changed"
        return f"tested, and failed: {some(list(entry.failures))}" if entry.failures else "tested, and no test ran"

    def _tested(self, item: Item, entry: Entry) -> bool:
        """Whether the tests that there are now ran."""
        assert isinstance(item.thing, Image)
        return entry.tested in {self._digest_of(item, names) for names in (item.thing.tests, self._all(item.thing))}

    def tests(self, item: Item) -> tuple[str, ...]:
        """The tests that an image runs: those that depend on its own sum; and those that it shares with others, unless these are
        part of this run, or passed them before with the same parts."""
        assert isinstance(item.thing, Image)
        elsewhere = all(target in self._asked or not self._unproven(item, target) for target in item.thing.proven_by)
        return item.thing.tests if elsewhere else self._all(item.thing)

    def tests_digest(self, item: Item) -> str:
        """A digest of the tests that an image runs: files, programs, what they expect; not of the image itself."""
        return self._digest_of(item, self.tests(item))

    def _all(self, image: Image) -> tuple[str, ...]:
        return (*image.tests, *image.shared)

    def _digest_of(self, item: Item, names: tuple[str, ...]) -> str:
        assert isinstance(item.thing, Image)
        key = (*item.key, names)
        if key not in self.digests:
            inputs = self.inputs.of_tests(item.thing, item.architecture, names)
            own = {name: value for name, value in inputs.items() if not name.startswith(TARGET)}
            own["budget"] = str(item.thing.budget)
            self.digests[key] = hashlib.sha256(json.dumps(own, sort_keys=True).encode()).hexdigest()
        return self.digests[key]

    def unproven(self, item: Item) -> str:
        """What other images were to prove of an image and did not; empty where they did, or it ran all tests itself."""
        assert isinstance(item.thing, Image)
        entry = self.known[item.key]
        whole = entry.tested == self._digest_of(item, self._all(item.thing))
        for target in item.thing.proven_by:
            if (target in self._asked or not whole) and (reason := self._unproven(item, target)):
                return reason
        return ""

    def _unproven(self, item: Item, target: str) -> str:
        """Why the tests of another image say nothing about one; empty where they passed, with the same parts."""
        image = self.image_set.by_target[target]
        proof = Item(image, item.architecture, self._needs(image))
        entry = self.known.get(proof.key)
        what = f"tests that it shares with {target}"
        if entry is None or not entry.digest:
            return f"{what}: that is not there"
        if proof.key in self.by_key and (why := self.reasons(proof)):
            return f"{what}: {why[0]}"
        if not self._tested(proof, entry) or not (entry.passed or entry.failures):
            return f"{what} have not passed"
        assert isinstance(item.thing, Image)
        common = {*item.thing.shared, *image.carried}
        if failures := [failure for failure in entry.failures if failure.partition(":")[0] in common]:
            return f"{what} failed: {some(failures)}"
        for name, digest in entry.parts.items():
            if (part := self.known.get((name, item.architecture))) and part.digest != digest:
                return f"{what}: that has another {name}"
        return self.unproven(proof) if target == item.thing.parent else ""

    def _needs(self, image: Image) -> tuple[str, ...]:
        """What an image is put together from."""
        below = (image.parent,) if image.parent in self.image_set.by_target else ()
        return (*below, *(self.image_set.part_by_name[name].target for name in image.parts))

    def hindrance(self, item: Item) -> str:
        """Why an item cannot be made on this machine; empty where it can."""
        image_or_part = item.thing
        if lacking := missing.on(image_or_part, item.architecture):
            return f"{missing.UNLOCKED}: {some(lacking)}"
        if item.kind == "joined":  # put together in the registry, from anywhere
            return ""
        if item.architecture not in self.architectures:
            return ELSEWHERE
        if isinstance(image_or_part, Part):  # assembled on what there is
            return ""
        unpublished = self.lacking.get((image_or_part.distribution, item.architecture), frozenset())
        if gone := sorted(unpublished.intersection(image_or_part.packages.split())):
            return f"{ABSENT} {listed(gone)} for {image_or_part.os}, {item.architecture}"
        systems = self.image_set.matrix.operating_systems
        absent = base_images.missing(self.request.services, systems, image_or_part.os)
        return f"{WAITING}: {absent}" if absent else ""

    def _reason(self, key: tuple[str, str]) -> str:
        """Why a part cannot be made here; of what it needs itself, if that is the reason."""
        item = self.by_key[key]
        if reason := self.hindrance(item):
            return reason
        failed = self.known.get(key)
        if failed and failed.failed and failed.changed == self.date:
            return f"its {failed.failed.get('step', 'build')} failed in this run"
        for target in item.needs:
            below = (target, item.architecture)
            if not self.made(below) and (reason := self._reason(below)):
                return reason
        return ""

    # ---- Indexes -----------------------------------------------------------------------------------------------------

    def members(self, thing: Image | Part) -> tuple[tuple[str, str], ...]:
        """Target and architecture of what an image's, or part's, index is made of: those that the registry serves."""
        serve = self.request.serve
        return tuple((thing.target, name) for name in thing.architectures if not serve or name in serve)

    def unready(self, thing: Image | Part) -> str:
        """Why no index of an image, or part, can be made; empty if one can."""
        keys = self.members(thing)
        if not keys:
            return f"it does not exist for {', '.join(self.request.serve)}"
        for key in keys:
            item, entry = self.by_key.get(key), self.known.get(key)
            if item is None or entry is None or not entry.digest:
                return f"{key[1]} is not there" + (f": {self.hindrance(item)}" if item and self.hindrance(item) else "")
            if why := self.reasons(item):
                return f"{key[1]}: {why[0]}"
            if item.kind != "part" and not self.passed(item, entry):
                failures = f"tests failed: {some(list(entry.failures))}" if entry.failures else ""
                return f"{key[1]}: {failures or self._untested(item)}"
            if item.kind != "part" and (reason := self.unproven(item)):
                return f"{key[1]}: {reason}"
            if self.request.scanning and "scan" in self._checks(item, entry):
                outcome = "not done by this policy" if entry.scanned == "clean" else entry.scanned or "not done"
                return f"{key[1]}: scan: {outcome}"
            if item.kind == "part" and not self._used(entry):
                checks = "its tests and the scan" if self.request.scanning else "its tests"
                return f"{key[1]}: no image that has it passed {checks} yet"
        return ""

    def _used(self, part: Entry) -> bool:
        """Whether an image that has a part, this very one, passed its tests, and the scan where there is one."""
        return any(
            entry.parts.get(part.target) == part.digest and not self._checks(item, entry) and not self.unproven(item)
            for key, item in self.by_key.items()
            if item.kind == "joined" and item.architecture == part.architecture and (entry := self.known.get(key))
        )

    def things(self) -> tuple[Image | Part, ...]:
        """Images and parts that get an index: those that are asked for, and what they stand on."""
        return tuple({item.target: item.thing for item in self.items}.values())

    def index_of(self, thing: Image | Part) -> Entry | None:
        """What the records say of the index of an image, or part."""
        return self.known.get((thing.target, INDEX))

    # ---- For people --------------------------------------------------------------------------------------------------

    def tasks(self) -> list[Task]:
        """What is to be done about every item."""
        return [self.task(item) for item in self.items]

    def changes(self, item: Item) -> list[str]:
        """Names of the inputs of an item that differ from those that it was made from; the records are read for them."""
        old, new = self.records.inputs(*item.key), self.inputs.of(item.target, item.architecture)
        return sorted(name for name in old.keys() | new.keys() if old.get(name) != new.get(name)) if old else []
