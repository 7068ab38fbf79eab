"""The state of a registry's images, and the steps that each of them needs: the matrix and locks, compared with the
records.

This module only decides: `survey.py` asks, and `run.py` carries out. A step that was done from the same inputs is not
due again. So if a publishing run is interrupted, the next one continues, on any machine.
"""

from __future__ import annotations

import hashlib
import json
from collections import defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Literal

from rosml.base.problems import listed, some
from rosml.images.bake.inputs import TARGET, Inputs
from rosml.images.builds import base_images, contents, package_state
from rosml.images.image_set import missing
from rosml.images.image_set.model import Image, ImageSet, Part, repository_of
from rosml.images.matrix.sizes import Size
from rosml.images.records.store import INDEX, Entry, Records
from rosml.machine.services import Services
from rosml.registry.place import Place

Kind = Literal["ros", "part", "joined"]
Step = Literal["build", "join", "test", "scan"]

ABSENT = "the archive has no"
"""How the reason begins if a distribution cannot be built because its packages are not published."""

UNDESCRIBED = "it has no facts for apps that change their base"
"""The reason why an image or a part is described again: if there is no other, it is not built."""

WAITING = "waiting for a builder"
ELSEWHERE = f"{WAITING} of its architecture"


@dataclass(frozen=True)
class Item:
    """An image or part on one architecture.

    Attributes:
        thing: the image or part.
        architecture: under BuildKit's name.
        needs: bake targets of the ROS image below it and of its parts.
    """

    thing: Image | Part
    architecture: str
    needs: tuple[str, ...]

    @property
    def target(self) -> str:
        """The bake target of the image or part."""
        return self.thing.target

    @property
    def kind(self) -> Kind:
        """ROS images and parts are built; joined images are joined from them."""
        if isinstance(self.thing, Part):
            return "part"
        return "joined" if self.thing.stack else "ros"

    @property
    def repository(self) -> str:
        """The repository, without the registry's prefix."""
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
    """The steps that an item needs.

    Attributes:
        item: an image or part.
        steps: in order; empty if there is nothing to do.
        why: reasons for the first step.
        hindered: why no step can be done here; empty if it can.
    """

    item: Item
    steps: tuple[Step, ...] = ()
    why: tuple[str, ...] = ()
    hindered: str = ""


@dataclass(frozen=True)
class Request:
    """What a survey has to find out.

    Attributes:
        services: the services of this machine.
        image_set: all that the matrix describes.
        place: where the images are.
        date: of the run; empty if nothing will be built.
        only: patterns of targets, or groups; all if empty.
        architectures: the architectures to work for; the machine's own if empty.
        serve: the architectures that the registry serves; all of the matrix if empty.
        force: rebuild everything.
        scanning: digest of the scan policy; empty if images need no scan.
        package_state: the package state of distributions, from a plan. All steps of a run use the plan's state.
            Packages that move later wait for the next run, unless a build fails because of them.
        whole: judge the ROS images and parts below images on all of their architectures.
        inputs: inputs of the image set's targets, if they were read before.
        all_tests: the requested images run all tests, also those that passed in others with the same parts.
        elsewhere: names of parts that other machines of the run build, and that are built here only if they are missing at the end;
            None if there are no other machines.
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
    all_tests: bool = False
    elsewhere: frozenset[str] | None = None


@dataclass
class State:
    """The requested images and parts, and what is known of them.

    Attributes:
        request: what was asked.
        inputs: inputs of the image set's targets.
        images: the requested images.
        architectures: the architectures that this run works for.
        known: entries of the records by target and architecture; a run keeps them up to date.
        present: the entries whose manifest is in the registry.
        package_state: the package state of each distribution whose repositories answered.
        lacking: packages that the archive of a distribution lacks, by distribution and architecture.
        remarks: for people, such as a repository that does not answer.
        forced: items that a run with `force` rebuilt already.
        digests: digests of tests, each computed once.
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
    _provers: dict[str, tuple[str, ...]] = field(default_factory=dict, repr=False)

    @property
    def image_set(self) -> ImageSet:
        """All that the matrix describes."""
        return self.request.image_set

    @property
    def place(self) -> Place:
        """The place of the images."""
        return self.request.place

    @property
    def date(self) -> str:
        """The date of the run."""
        return self.request.date

    @property
    def records(self) -> Records:
        """The records of the registry."""
        return Records(self.place)

    @cached_property
    def items(self) -> tuple[Item, ...]:
        """All items in the order of work: ROS images from the lowest up, parts, then joined images."""
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
        """The image set with the measured sizes of ROS images, as far as earlier runs measured them. For an unmeasured
        image, the matrix's forecast of its own size is added to the size of the image below it."""
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
        """The steps that an item needs, by what is known now.

        Args:
            item: one of `items`.
            ahead: for a plan: assume that the item's needs will be built, if they can be built here. If not set, they
                must be in the registry.
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
            why += [f"{target} is rebuilt" for target in lacking]
        elif lacking and not why:
            why = [f"{target} is built first" for target in lacking]
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

    def look_again(self, item: Item) -> None:
        """Reads the record of an item once more: another machine may have made it since."""
        entry = self.records.read(*item.key)
        if entry and entry != self.known.get(item.key):
            self.known[item.key] = entry
            self.present.discard(item.key)
            if entry.digest and self.place.client.head(self.place.path(entry.repository), entry.digest):
                self.present.add(item.key)

    def made(self, key: tuple[str, str]) -> bool:
        """Whether an item is in the registry and up to date."""
        return key in self.by_key and not self.reasons(self.by_key[key])

    def reasons(self, item: Item) -> list[str]:
        """Why an item has to be built or joined; empty if it is up to date."""
        entry = self.known.get(item.key)
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
        if item.kind != "joined" and not entry.sbom:  # an older version of this program made SBOMs in the scan
            why.append("it has no SBOM")
        elif item.kind != "joined" and entry.described != contents.FORMAT:
            why.append(UNDESCRIBED)
        for target in item.needs:
            part = self.known.get((target, item.architecture))
            if part and part.digest and entry.parts.get(target) != part.digest:
                why.append(f"{target} changed")
        return why

    def _moved(self, item: Item, entry: Entry) -> str:
        assert isinstance(item.thing, Image)
        now = self.package_state.get(item.thing.distribution, "")
        # ROS may have published packages after the plan, and another machine of this run used them.
        if entry.changed == self.date and package_state.ros_date(entry.package_state) > package_state.ros_date(now):
            return ""
        return (
            f"packages moved from {entry.package_state or 'an unknown state'} to {now}"
            if now not in ("", entry.package_state)
            else ""
        )

    def _checks(self, item: Item, entry: Entry | None) -> tuple[Step, ...]:
        """The checks that an item still needs; all checks if its entry is None."""
        steps: list[Step] = []
        if item.kind != "part" and not (entry and self.passed(item, entry)):
            steps.append("test")
        # A part is scanned with the images that have it.
        clean = entry and entry.scanned == "clean" and entry.scan.get("policy") == self.request.scanning
        if self.request.scanning and item.kind != "part" and not clean:
            steps.append("scan")
        return tuple(steps)

    def passed(self, item: Item, entry: Entry) -> bool:
        """Whether an image passed today's tests: all of them, or those that it runs itself."""
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
        """Whether today's tests ran."""
        assert isinstance(item.thing, Image)
        lacking = {*item.thing.shared} if self._runs_all(item) else set()
        ran = self._ran(item, entry)
        return bool(ran) and lacking <= {*ran}

    def _runs_all(self, item: Item) -> bool:
        return self.request.all_tests and item.target in self._asked

    def _ran(self, item: Item, entry: Entry) -> tuple[str, ...]:
        """The tests that ran in an image, if they are today's: its own, and perhaps some that it shares."""
        assert isinstance(item.thing, Image)
        image, of_ros, of_parts = item.thing, _of_ros(item.thing), _of_parts(item.thing)
        for shared in (image.shared, of_ros, of_parts, ()):
            if entry.tested == self.digest_of(item, (*image.tests, *shared)):
                return (*image.tests, *shared)
        return ()

    def tests(self, item: Item) -> tuple[str, ...]:
        """The tests that an image runs: its own tests; and the tests that it shares with other images, unless these are
        part of this run, or passed them before with the same parts."""
        image = item.thing
        assert isinstance(image, Image)
        of_ros, of_parts = _of_ros(image), _of_parts(image)
        if self._runs_all(item):
            return (*image.tests, *image.shared)
        if not of_ros or self._elsewhere(item, of_ros, image.parent):
            of_ros = ()
        if not of_parts or self._elsewhere(item, of_parts, *image.carriers[:1]):
            of_parts = ()
        return (*image.tests, *of_ros, *of_parts)

    def _elsewhere(self, item: Item, names: tuple[str, ...], first: str = "") -> bool:
        """Whether tests that an image shares run in another one, or passed in one.

        Args:
            first: the image that runs them in this run, if it is part of it.
        """
        return (first in self._asked and first != item.target) or not self._unproven_tests(item, names, first)

    def _unproven_tests(self, item: Item, names: tuple[str, ...], first: str) -> str:
        """Why tests that an image shares prove nothing for it; empty if they passed in one that counts for it.

        Args:
            first: the image that the reason is about.
        """
        assert isinstance(item.thing, Image)
        reason = ""
        for target in dict.fromkeys((first, *self.provers(item.thing))):
            if target in self.image_set.by_target and (target, item.architecture) in self.known:
                why = self._unproven(item, target, names)
                if not why:
                    return ""
                reason = reason or why
        return reason or f"tests that it shares with {first}: that image is missing"

    def digest_of(self, item: Item, names: tuple[str, ...]) -> str:
        """A digest of tests of an image: files, programs and expected values, without the image itself."""
        assert isinstance(item.thing, Image)
        key = (*item.key, names)
        if key not in self.digests:
            inputs = self.inputs.of_tests(item.thing, item.architecture, names)
            own = {name: value for name, value in inputs.items() if not name.startswith(TARGET)}
            own["budget"] = str(item.thing.budget)
            self.digests[key] = hashlib.sha256(json.dumps(own, sort_keys=True).encode()).hexdigest()
        return self.digests[key]

    def provers(self, image: Image) -> tuple[str, ...]:
        """Images that may have run tests that an image shares: on the same ROS image; or on that or a lower one, with all its parts."""
        if image.target not in self._provers:
            lower, below = {_ros_of(image)}, self.image_set.by_target.get(_ros_of(image))
            while below := below and self.image_set.by_target.get(below.parent):
                lower.add(below.target)
            self._provers[image.target] = tuple(
                other.target
                for other in self._by_distribution[image.distribution]
                if other.target != image.target
                and (
                    other.parent == image.parent
                    or (other.stack == image.stack and _ros_of(other) in lower and {*image.parts} <= {*other.parts})
                )
            )
        return self._provers[image.target]

    @cached_property
    def _by_distribution(self) -> Mapping[str, Sequence[Image]]:
        found: defaultdict[str, list[Image]] = defaultdict(list)
        for image in self.image_set.images:
            found[image.distribution].append(image)
        return found

    def unproven(self, item: Item) -> str:
        """Why shared tests in other images prove nothing for this image; empty if they passed, or the image ran all
        tests."""
        image = item.thing
        assert isinstance(image, Image)
        names = {*self._ran(item, self.known[item.key])}
        for shared, first in ((_of_ros(image), image.parent), (_of_parts(image), next(iter(image.carriers), ""))):
            if first in self._asked and first != image.target and (reason := self._unproven(item, first, shared)):
                return reason
            if not names.issuperset(shared) and (reason := self._unproven_tests(item, shared, first)):
                return reason
        return ""

    def _unproven(self, item: Item, target: str, names: tuple[str, ...]) -> str:
        """Why tests prove nothing that ran in one other image; empty if they passed there, with the same parts."""
        image = self.image_set.by_target[target]
        proof = Item(image, item.architecture, self._needs(image))
        entry = self.known.get(proof.key)
        what = f"tests that it shares with {target}"
        if entry is None or not entry.digest:
            return f"{what}: that image is missing"
        if proof.key in self.by_key and (why := self.reasons(proof)):
            return f"{what}: {why[0]}"
        ran = {*self._ran(proof, entry)}
        if not ran or not (entry.passed or entry.failures):
            return f"{what} have not passed"
        assert isinstance(item.thing, Image)
        common = {*item.thing.shared, *image.carried}
        if failures := [failure for failure in entry.failures if failure.partition(":")[0] in common]:
            return f"{what} failed: {some(failures)}"
        for name, digest in entry.parts.items():
            if (part := self.known.get((name, item.architecture))) and part.digest != digest:
                return f"{what}: that image has another {name}"
        if not (left := tuple(name for name in names if name not in ran)):
            return ""
        return self._unproven_tests(proof, left, image.parent) if target == item.thing.parent else f"{what} did not run"

    def _needs(self, image: Image) -> tuple[str, ...]:
        """The ROS image below an image, and its parts."""
        below = (image.parent,) if image.parent in self.image_set.by_target else ()
        return (*below, *(self.image_set.part_by_name[name].target for name in image.parts))

    def hindrance(self, item: Item) -> str:
        """Why an item cannot be built on this machine; empty if it can."""
        image_or_part = item.thing
        if lacking := missing.on(image_or_part, item.architecture):
            return f"{missing.UNLOCKED}: {some(lacking)}"
        if item.kind == "joined":  # any machine can join in the registry
            return ""
        if item.architecture not in self.architectures:
            return ELSEWHERE
        if isinstance(image_or_part, Part):  # builds on any base image that this machine has
            return ""
        unpublished = self.lacking.get((image_or_part.distribution, item.architecture), frozenset())
        if gone := sorted(unpublished.intersection(image_or_part.packages.split())):
            return f"{ABSENT} {listed(gone)} for {image_or_part.os}, {item.architecture}"
        systems = self.image_set.matrix.operating_systems
        absent = base_images.missing(self.request.services, systems, image_or_part.os)
        return f"{WAITING}: {absent}" if absent else ""

    def _reason(self, key: tuple[str, str]) -> str:
        """Why an item cannot be built here, or why something below it cannot."""
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
        """The members of the index of an image or part, as target and architecture: the architectures that the registry
        serves."""
        serve = self.request.serve
        return tuple((thing.target, name) for name in thing.architectures if not serve or name in serve)

    def unready(self, thing: Image | Part) -> str:
        """Why the index of an image or part cannot be made; empty if it can."""
        keys = self.members(thing)
        if not keys:
            return f"it does not exist for {', '.join(self.request.serve)}"
        for key in keys:
            item, entry = self.by_key.get(key), self.known.get(key)
            if item is None or entry is None or not entry.digest:
                return f"{key[1]} is missing" + (f": {self.hindrance(item)}" if item and self.hindrance(item) else "")
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
        """Whether an image with exactly this part passed its tests, and the scan if there is one."""
        return any(
            entry.parts.get(part.target) == part.digest and not self._checks(item, entry) and not self.unproven(item)
            for key, item in self.by_key.items()
            if item.kind == "joined" and item.architecture == part.architecture and (entry := self.known.get(key))
        )

    def things(self) -> tuple[Image | Part, ...]:
        """Images and parts that get an index: the requested ones, and those below them. An image without tags only tests."""
        things = {item.target: item.thing for item in self.items}.values()
        return tuple(thing for thing in things if isinstance(thing, Part) or thing.tags)

    def index_of(self, thing: Image | Part) -> Entry | None:
        """The entry of the index of an image or part."""
        return self.known.get((thing.target, INDEX))

    def is_of_these(self, thing: Image | Part, index: Entry) -> bool:
        """Whether the index of an image or part is made of its images as they are now."""
        members = {key[1]: self.known[key].digest for key in self.members(thing)}
        return index.parts == members and index.inputs == self.inputs.together(thing)

    # ---- For people --------------------------------------------------------------------------------------------------

    def tasks(self) -> list[Task]:
        """The task of every item."""
        return [self.task(item) for item in self.items]

    def changes(self, item: Item) -> list[str]:
        """Names of an item's inputs that changed since it was made. This reads the records."""
        old, new = self.records.inputs(*item.key), self.inputs.of(item.target, item.architecture)
        return sorted(name for name in old.keys() | new.keys() if old.get(name) != new.get(name)) if old else []


def _ros_of(image: Image) -> str:
    """The target of the ROS image that an image is or stands on."""
    return image.parent if image.stack else image.target


def _of_ros(image: Image) -> tuple[str, ...]:
    """The tests of the ROS image below an image."""
    return tuple(name for name in image.shared if name not in image.carried)


def _of_parts(image: Image) -> tuple[str, ...]:
    """The tests of its parts that an image does not carry itself."""
    return tuple(name for name in image.shared if name in image.carried)
