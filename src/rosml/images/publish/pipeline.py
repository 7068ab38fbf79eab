"""The steps of a publishing run: build, join, test, scan, index, promote. Each does what the plan says is missing.

A step works item by item, and records each item when it is done. If a run is interrupted, the next one completes it. A
failed item is recorded as failed; only items that are joined from it wait for it. No tag moves before the last step, and
then only to an index of images that passed.
"""

from __future__ import annotations

import hashlib
import math
import threading
import time
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field, replace
from datetime import datetime
from functools import cached_property
from pathlib import Path
from typing import Any, Literal, TypeVar

from rosml.base import progress_bar
from rosml.base.clock import now
from rosml.base.errors import RosmlError
from rosml.base.problems import some
from rosml.images.builds import package_state as upstreams
from rosml.images.builds.maker import BuildKitMaker, Made, Maker
from rosml.images.image_set import apt_source
from rosml.images.image_set.labels import OCI, REVISION, SOURCE, TITLE, title
from rosml.images.image_set.model import Image, Part, repository_of
from rosml.images.publish import provenance, same_content
from rosml.images.publish.plan import ELSEWHERE, Item, Plan
from rosml.images.publish.sign import PATIENCE, Signer, SignerFailed
from rosml.images.records.store import DATE, INDEX, INPUTS, READERS, Entry, Records
from rosml.images.scan import judge as scanning
from rosml.images.scan import sarif, sbom
from rosml.images.scan.policy import Rules
from rosml.images.scan.results import Results
from rosml.images.scan.sbom import Shelf
from rosml.images.scan.trivy import ScannerFailed, Trivy
from rosml.registry import oci, repositories
from rosml.registry.client import Registry
from rosml.registry.oci import Config, Manifest

State = Literal["done", "failed", "waits"]

T = TypeVar("T")
R = TypeVar("R")

SYNCS = 2
"""So often a row is begun anew in a run because ROS published new packages while it was built."""

SUPERSEDED = 20
"""From so many digests on that an entry has taken the place of, those that are gone from the registry are forgotten."""


class _Synced(Exception):
    """ROS published new packages since the plan was made."""


@dataclass(frozen=True)
class Outcome:
    """What a step did about an item.

    Attributes:
        step: its name. target, architecture: of the item; no architecture where it is about an index or tags.
        state: done, failed, or waits for something that is not there.
        reason: what was done, or why it failed or waits.
        seconds: wall time. uploaded: bytes that the registry got.
    """

    step: str
    target: str
    architecture: str
    state: State
    reason: str = ""
    seconds: float = 0.0
    uploaded: int = 0

    def to_json(self) -> dict[str, Any]:
        """For `--json`."""
        return {name: value for name, value in vars(self).items() if value != ""}


@dataclass
class Pipeline:
    """A publishing run.

    Attributes:
        plan: what there is to do.
        registry: where images go. host: its address. prefix: path of its repositories.
        say: told what is going on, a line at a time.
        serving: the architectures that the registry serves; all of the matrix if empty.
        outcomes: what was done so far.
        signer: signs indexes, without which they get no tags; None where nothing is signed.
        started: when it began, by the monotonic clock.
        pushed: bytes of layers that the builder added to the registry.
        maker: builds, joins and tests; with this checkout's builder if None.
    """

    plan: Plan
    registry: Registry
    host: str
    prefix: str
    say: Callable[[str], None]
    serving: tuple[str, ...] = ()
    outcomes: list[Outcome] = field(default_factory=list)
    signer: Signer | None = None
    started: float = field(default_factory=time.monotonic)
    pushed: int = 0
    refused: int = 0
    """How often the signer failed, one time after the other."""
    maker: Maker | None = None
    _may_push: bool = False
    _ask_anew: bool = False  # whether a failed build asks if ROS published new packages
    _synced: bool = False  # it did
    _testing: bool = False  # whether an image is tested as soon as it is there
    _end: float = math.inf  # by the monotonic clock, when nothing more is begun
    _signing: Any = field(default_factory=threading.Lock)  # one signature at a time

    @cached_property
    def _maker(self) -> Maker:
        plan = self.plan
        services, image_set = plan.services, plan.image_set
        return self.maker or BuildKitMaker(
            services, image_set, self.registry, self.host, self.prefix, self.say, plan.force, plan.forecast
        )

    @property
    def records(self) -> Records:
        """The records of the registry."""
        return Records(self.registry, self.prefix)

    def repository(self, name: str) -> str:
        """Path of a repository in the registry."""
        return repositories.repository_path(self.prefix, name)

    def reference(self, name: str) -> str:
        """A repository with the registry before it."""
        return f"{self.host}/{self.repository(name)}"

    @property
    def failed(self) -> bool:
        """Whether something failed."""
        return any(outcome.state == "failed" for outcome in self.outcomes)

    @property
    def uploaded(self) -> int:
        """Bytes that the registry got since its client was made: layers that it did not have, configs, manifests, what is
        attached, indexes, the records. Without signatures, which cosign sends, of about 1 kB each.
        """
        return self.pushed + self.registry.uploaded

    # ---- Items -------------------------------------------------------------------------------------------------------

    def build(self) -> None:
        """Builds ROS images and parts that are not as they should be, and pushes them by digest.

        Where ROS publishes new packages after the plan, the row is built of these, all of its components: an image's packages
        are of one moment.
        """
        items = [item for item in self.plan.items if item.kind != "joined"]
        for number in range(SYNCS + 1):
            before, self._ask_anew = len(self.outcomes), number < SYNCS
            self._synced = False
            self._each("build", items, self._build)
            if not self._synced:
                return
            # What stands on what was not built waits no more: all are gone through once again.
            self.outcomes[before:] = [outcome for outcome in self.outcomes[before:] if outcome.state != "waits"]

    def join(self) -> None:
        """Puts images with frameworks together, in the registry. Those first that test what others share with them."""
        items = [item for item in self.plan.items if item.kind == "joined"]
        self._each("join", sorted(items, key=_carries_nothing), self._join)

    def test(self, targets: Sequence[str] = ()) -> None:
        """Runs the structure tests of images that have not passed them. What failed in this run is left to the next one.

        Args:
            targets: of these alone; all if empty.
        """
        failed = {(it.target, it.architecture) for it in self.outcomes if (it.step, it.state) == ("test", "failed")}
        wanted = [i for i in self.plan.items if i.kind != "part" and (not targets or i.target in targets)]
        self._each("test", [item for item in wanted if item.key not in failed], self._test)

    def images(self, minutes: float = math.inf) -> None:
        """Builds, joins and tests: each image is tested as soon as it is there, so that a run that ends early leaves images that
        can get their tags.

        Args:
            minutes: after which nothing more is begun. What is left waits for the next run.
        """
        self._testing, self._end = True, time.monotonic() + 60 * minutes
        self.build()
        self.join()
        self.test()
        self._testing, self._end = False, math.inf

    def _each(self, step: str, items: Sequence[Item], work: Callable[[Item, Entry], Entry]) -> None:
        """Does a step's work on those items whose turn it is."""
        expected = sum(step in self.plan.task(item).steps for item in items)
        number = 0
        for item in progress_bar.over(items, step, len(items)):
            task = self.plan.task(item, ahead=False)
            if task.hindered:
                if task.hindered != ELSEWHERE:
                    self.outcomes.append(Outcome(step, *item.key, "waits", task.hindered))
                continue
            if step not in task.steps[:1]:
                if step in task.steps:  # an earlier step is still to be done
                    self.outcomes.append(Outcome(step, *item.key, "waits", f"{task.steps[0]} comes first"))
                continue
            if time.monotonic() >= self._end:
                self.outcomes.append(Outcome(step, *item.key, "waits", "the time of this run is over"))
                continue
            number += 1
            self._do(step, item, f"({number} of {expected})", task.why, work)
            if self._testing and item.kind != "part" and step != "test":
                task = self.plan.task(item, ahead=False)
                if task.steps[:1] == ("test",):
                    self._do("test", item, "(as soon as it is there)", task.why, self._test)

    def _do(self, step: str, item: Item, place: str, why: Sequence[str], work: Callable[[Item, Entry], Entry]) -> None:
        """Does a step's work on an item, and writes down what came of it."""
        if not self._may_push:  # asked before the first work is done, which may take hours
            self.registry.may_push(self.records.repository)
            self._may_push = True
        self.say(f"{step} {item.target} for {item.architecture} {place}: {'; '.join(why)}")
        entry = self.plan.known.get(item.key) or Entry(*item.key)
        started, before = time.monotonic(), self.uploaded
        try:
            entry = work(item, entry)
            state: State = "failed" if entry.failed else "done"
        except RosmlError as error:
            entry = replace(entry, failed={"step": step, "reason": _short(error.message), "remedy": error.remedy})
            state = "failed"
            self.say(f"failed: {error.message}" + (f"; {error.remedy}" if error.remedy else ""))
        except _Synced as news:
            self.say(str(news))
            return
        seconds = time.monotonic() - started
        entry = replace(entry, changed=self.plan.date, seconds={**entry.seconds, step: round(seconds, 2)})
        self._write(item, entry)
        reason = entry.failed.get("reason", "") if state == "failed" else "; ".join(why)
        self.outcomes.append(Outcome(step, *item.key, state, reason, seconds, self.uploaded - before))

    def _write(self, item: Item, entry: Entry) -> None:
        entry = self._remembered(entry)
        self.records.write(entry, self.plan.inputs.of(*item.key))
        self.plan.known[item.key] = entry
        if entry.digest:
            self.plan.present.add(item.key)

    def _remembered(self, entry: Entry) -> Entry:
        """An entry without the digests that were in its place and are gone, where it has many: it would grow for ever."""
        if len(entry.superseded) <= SUPERSEDED:
            return entry
        where = self.repository(entry.repository)
        return replace(entry, superseded=tuple(x for x in entry.superseded if self.registry.head(where, x)))

    def _build(self, item: Item, entry: Entry) -> Entry:
        started = now()
        if isinstance(item.thing, Part):
            made = self._maker.build_part(item.thing, item.architecture)
        else:  # packages whose repository did not answer are taken for those of the last build
            moment = self.plan.upstream.get(item.thing.distribution, entry.upstream)
            try:
                made = self._maker.build_image(item.thing, item.architecture, self._parts(item), moment)
            except RosmlError:
                self._ask_again(item.thing.distribution, moment)
                raise
        self.pushed += self._new_bytes(item, entry, made)
        said = self._attest(item, entry, made, started)
        self.plan.forced.add(item.key)
        facts = self._facts(item, made.digest, made.parts)
        return entry.made(made.digest, **facts, provenance=said, upstream=made.upstream, sbom=made.sbom)

    def _ask_again(self, distribution: str, moment: str) -> None:
        """Asks, after a build failed, whether ROS published new packages since the plan was made.

        Raises:
            _Synced: it did, and the row is to be built of these.
        """
        if not self._ask_anew:
            return
        try:
            now = upstreams.state(self.plan.services, self.plan.image_set.matrix, distribution)
        except RosmlError:  # what the build said stands
            return
        if upstreams.ros_date(now) > upstreams.ros_date(moment):
            self.plan.upstream[distribution] = now
            self._synced = True
            raise _Synced(
                f"ROS published new packages of {distribution} meanwhile ({now}); its images are built of these"
            )

    def _new_bytes(self, item: Item, before: Entry, made: Made) -> int:
        """Bytes of the layers of what was built, without those of what it stands on and of what was in its place."""
        own = self._sizes(item, made.digest)
        there = self._sizes(item, before.digest)
        for target, digest in made.parts.items():
            there |= self._sizes(self.plan.by_key[target, item.architecture], digest)
        return sum(size for layer, size in own.items() if layer not in there)

    def _sizes(self, item: Item, digest: str) -> dict[str, int]:
        """Bytes of the layers of a manifest by their digests; none where it is not in the registry."""
        found = self.registry.manifest(self.repository(item.repository), digest) if digest else None
        return {layer.digest: layer.size for layer in found.layers} if found else {}

    # ---- Where an image came from ------------------------------------------------------------------------------------

    def _attest(self, item: Item, before: Entry, made: Made, started: str) -> dict[str, str]:
        """Attaches to what was made, or joined, what it was made from; gives digests of all statements, by builder. What was
        said of the same bytes before is not said again."""
        known = dict(before.provenance) if before.digest == made.digest else {}
        place = self.repository(item.repository)
        inputs = self.plan.inputs.digest(*item.key)
        definition = provenance.definition(self._parameters(item), inputs, self._dependencies(item, made))
        builder = self.machine.builder
        facts = definition, self.machine, started, now(), known.get(builder, "")
        return known | {builder: provenance.attach(self.registry, place, made.digest, *facts)}

    @cached_property
    def machine(self) -> provenance.Machine:
        """Who makes the images of this run."""
        return provenance.Machine.here(self.plan.date)

    @cached_property
    def _source(self) -> list[dict[str, Any]]:
        return provenance.source(self.plan.services.root)

    def _parameters(self, item: Item) -> dict[str, str]:
        """What was asked for."""
        asked = {"target": item.target, "platform": self._platform(item.architecture)}
        if isinstance(item.thing, Part):
            return asked
        image = item.thing
        found = {"distribution": image.distribution, "component": image.component, "framework": image.framework}
        repository = apt_source.source(self.plan.image_set.matrix, image.distribution)
        channel = {"channel": repository.channel, "snapshot": repository.day} if repository else {}
        return asked | found | {"stack": image.stack or ""} | channel

    def _dependencies(self, item: Item, made: Made) -> Iterator[dict[str, Any]]:
        """What it was made from: base image or parts, locks, packages, the checkout."""
        services = self.plan.services
        if made.base:
            system = self.plan.image_set.matrix.operating_systems[item.thing.os]
            yield provenance.base(made.base, system.digest)
        for target, digest in made.parts.items():
            part = self.plan.by_key[target, item.architecture]
            yield provenance.image(target, self.reference(part.repository), digest)
        if item.kind != "joined":  # those of a joined image are its parts'
            used = self.plan.inputs.of(*item.key)
            yield from provenance.locks(services.root, [name for name in item.thing.locks if name in used])
        if isinstance(item.thing, Image) and item.kind == "ros":
            matrix, distribution = self.plan.image_set.matrix, item.thing.distribution
            for address, moment in upstreams.repositories(services, matrix, distribution, made.upstream):
                yield provenance.packages(address, moment)
        yield from self._source

    def _facts(self, item: Item, digest: str, parts: Mapping[str, str]) -> dict[str, Any]:
        manifest = self.registry.manifest(self.repository(item.repository), digest)
        if manifest is None:
            raise RosmlError(f"{item.target} is not in the registry after it was pushed", "run it again")
        return {
            "inputs": self.plan.inputs.digest(*item.key),
            "repository": item.repository,
            "parts": dict(parts),
            "size": sum(layer.size for layer in manifest.layers),
            "date": self.plan.date,
        }

    def _parts(self, item: Item) -> dict[str, str]:
        """Digests of what an item is put together from."""
        return {target: self.plan.known[target, item.architecture].digest for target in item.needs}

    def _platform(self, architecture: str) -> str:
        return self.plan.image_set.matrix.architectures[architecture].platform

    def _join(self, item: Item, entry: Entry) -> Entry:
        started, parts = now(), self._parts(item)
        assert isinstance(item.thing, Image)
        digest = self._maker.join(item.thing, item.architecture, parts)
        said = self._attest(item, entry, Made(digest, parts), started)
        self.plan.forced.add(item.key)
        return entry.made(digest, **self._facts(item, digest, parts), provenance=said)

    def _test(self, item: Item, entry: Entry) -> Entry:
        """Runs an image's structure tests."""
        assert isinstance(item.thing, Image)
        names = self.plan.tests(item)
        found = self._maker.test(item.thing, item.architecture, entry.digest, self._parts(item), names)
        reason = f"tests failed: {some(list(found.failures))}\n{found.said}".strip()
        return replace(
            entry,
            tested=self.plan.tests_digest(item),
            passed=found.passed,
            failures=found.failures,
            unpacked=found.unpacked,
            versions=found.versions,
            failed={"step": "test", "reason": _short(reason)} if found.failures else {},
        )

    # ---- Scans -------------------------------------------------------------------------------------------------------

    def scan(
        self,
        rules: Rules,
        trivy: Trivy | ScannerFailed,
        reports: Path | None = None,
        results: Results | None = None,
    ) -> scanning.Run:
        """Scans all images that are there, on whatever architecture: what a scan reads is in the registry. Each is recorded as
        soon as it was scanned, so that a run that ends early keeps what it got to.

        An image that was clean by the same policy and the same database before is left alone: it would be so again.

        Args:
            rules: the policy.
            trivy: the scanner, with its database; or why there is none.
            reports: a folder for a SARIF file of each image.
            results: get what was found; then nothing is written into the registry.
        """
        policy = policy_digest(rules, self.plan.date)
        state = _database(trivy)
        images: dict[tuple[str, str], scanning.Image] = {}
        for item in self.plan.items:
            entry = self.plan.known.get(item.key)
            if item.kind == "part" or entry is None or not entry.digest or item.key not in self.plan.present:
                continue
            same = state and entry.scan.get("policy") == policy and entry.scan.get("database") == state
            if not same or entry.scanned != scanning.Outcome.CLEAN.value:
                needs = item.needs if item.kind == "joined" else (item.target,)
                parts = tuple(self.scanned_part(target, item.architecture) for target in needs)
                images[item.key] = scanning.Image(*item.key, parts)
        moment = _moment(self.plan.date)
        # Of those that are not there nothing can be known: they may lack a lock.
        there = {item.key for item in self.plan.items if item.kind != "part"} & self.plan.present
        whole = images.keys() == there and len(self.plan.images) == len(self.plan.image_set.images)
        started = time.monotonic()

        def keep(found: scanning.Scanned) -> None:
            facts = {
                "policy": policy,
                "database": found.database.digest if found.database else "",
                "updated": found.database.updated if found.database else "",
                "packages": found.packages,
                "findings": dict(Counter(finding.severity for finding in found.findings)),
                "failing": sorted({finding.id for finding in found.failing}),
            }
            key = found.target, found.architecture
            entry = replace(self.plan.known[key], scanned=found.outcome.value, scan=facts, changed=self.plan.date)
            if results is None:
                self._write(self.plan.by_key[key], entry)
            else:
                results.add(entry)

        run = self._scan(list(images.values()), rules, trivy, moment, whole, keep)
        seconds = (time.monotonic() - started) / max(1, len(run.images))
        for found in run.images:
            key = found.target, found.architecture
            clean = found.outcome is scanning.Outcome.CLEAN
            reason = found.reason if clean else f"{found.outcome.value}: {found.reason}"
            self.outcomes.append(Outcome("scan", *key, "done" if clean else "failed", reason, seconds))
        if reports:
            sarif.write(reports, run)
        for problem in run.problems:
            self.outcomes.append(Outcome("scan", "policy", "", "failed", problem))
        return run

    def _scan(
        self,
        images: list[scanning.Image],
        rules: Rules,
        trivy: Trivy | ScannerFailed,
        moment: datetime,
        whole: bool,
        keep: Callable[[scanning.Scanned], None],
    ) -> scanning.Run:
        targets = self.plan.image_set.by_target
        if isinstance(trivy, ScannerFailed):
            return scanning.summarise(scanning.unscanned(images, trivy, keep), rules, moment.date(), whole, targets)
        facts: dict[str, Any] = {"now": moment, "whole": whole, "targets": targets}
        return scanning.scan_images(images, rules, trivy, self.shelf, **facts, say=self.say, keep=keep)

    @property
    def shelf(self) -> Shelf:
        """The SBOMs that the records name."""
        return Shelf(self.registry, {entry.digest: entry.sbom for entry in self.plan.known.values() if entry.sbom})

    def scanned_part(self, target: str, architecture: str) -> scanning.Part:
        """A ROS image or part that was made, as a scan knows it."""
        part = self.plan.by_key[target, architecture]
        digest = self.plan.known[part.key].digest
        return scanning.Part(target, self.host, self.repository(part.repository), digest, part.kind == "ros")

    # ---- Indexes and tags --------------------------------------------------------------------------------------------

    def index(self) -> None:
        """Makes an index of every image whose architectures are all there, tested and alike; nobody sees it yet. Images side by
        side: one after the other, hundreds take hours on a registry that is far away."""
        before, wanted = len(self.outcomes), list[Image | Part]()
        for thing in self.plan.things():
            if reason := self.plan.unready(thing, self.serving):
                self.outcomes.append(Outcome("index", thing.target, "", "waits", reason))
            elif not self._indexed(thing):
                wanted.append(thing)
        side_by_side(self._do_index, wanted)
        self.put_in_order(before)

    def _do_index(self, thing: Image | Part) -> None:
        """Makes and signs the index of an image, and writes down what came of it."""
        started = time.monotonic()
        entries, inputs = self._members(thing), self.plan.inputs.together(thing)
        entry = self.plan.known.get((thing.target, INDEX)) or Entry(thing.target, INDEX)
        try:
            digest = self._index(thing, entries, inputs)
            facts = {
                "inputs": inputs,
                "repository": repository_of(thing),
                "parts": {entry.architecture: entry.digest for entry in entries},
                "date": self.plan.date,
            }
            entry = entry.made(digest, **facts)
            state: State = "done"
            reason = f"{len(entries)} architecture{'s'[: len(entries) != 1]}"
        except RosmlError as error:
            entry = replace(entry, failed={"step": "index", "reason": _short(error.message), "remedy": error.remedy})
            state, reason = "failed", error.message
        entry = self._remembered(replace(entry, changed=self.plan.date))
        self.records.write(entry, {})
        self.plan.known[thing.target, INDEX] = entry
        self.plan.present.add((thing.target, INDEX))
        self.outcomes.append(Outcome("index", thing.target, "", state, reason, time.monotonic() - started))
        if state == "done":
            self.signed(thing)

    def put_in_order(self, before: int) -> None:
        """Gives outcomes the order of images again, which were done side by side.

        Args:
            before: how many outcomes there were before that.
        """
        order = {thing.target: number for number, thing in enumerate(self.plan.things())}
        self.outcomes[before:] = sorted(self.outcomes[before:], key=lambda outcome: order[outcome.target])

    def _indexed(self, thing: Image | Part) -> bool:
        """Whether an image's index is of these very images, and there."""
        key = thing.target, INDEX
        entry = self.plan.known.get(key)
        if entry is None or key not in self.plan.present or (self.plan.force and entry.date != self.plan.date):
            return False
        digests = {entry.architecture: entry.digest for entry in self._members(thing)}
        return entry.parts == digests and entry.inputs == self.plan.inputs.together(thing) and not entry.failed

    def _members(self, thing: Image | Part) -> list[Entry]:
        """Entries of what an index of an image is made of."""
        return [self.plan.known[key] for key in self.members(thing)]

    def signed(self, thing: Image | Part, moving: bool = False) -> bool:
        """Whether an image's index has the signature that it needs, which is made if it lacks it.

        Args:
            thing: the image or part.
            moving: whether a tag is about to move to it: then the records' word is not enough, and cosign is asked.
        """
        entry = self.plan.known[thing.target, INDEX]
        if self.signer is None or (self.signer.identity in entry.signed and not moving):
            return True
        with self._signing:
            if self.refused >= PATIENCE:
                self.outcomes.append(Outcome("sign", thing.target, "", "waits", f"the signer failed {PATIENCE} times"))
                return False
            started = time.monotonic()
            try:
                made = self.signer.ensure(f"{self.reference(entry.repository)}@{entry.digest}")
            except SignerFailed as error:
                self.refused += 1
                self.say(f"failed: {error.message}; {error.remedy}")
                seconds = time.monotonic() - started
                self.outcomes.append(Outcome("sign", thing.target, "", "failed", error.message, seconds))
                return False
            self.refused = 0
        if self.signer.identity not in entry.signed:
            signed = {**entry.signed, self.signer.identity: self.plan.date}
            self.plan.known[thing.target, INDEX] = replace(entry, signed=signed)
            self.records.write(self.plan.known[thing.target, INDEX], {})
        if made:
            text = f"by {self.signer.identity}"
            self.outcomes.append(Outcome("sign", thing.target, "", "done", text, time.monotonic() - started))
        return True

    def members(self, thing: Image | Part) -> Iterator[tuple[str, str]]:
        """Target and architecture of what an index of an image is made of."""
        return (key for key in self.plan.members(thing) if not self.serving or key[1] in self.serving)

    def _index(self, thing: Image | Part, entries: Sequence[Entry], inputs: str) -> str:
        """Makes an index; gives its digest. Nothing is pulled.

        Raises:
            RosmlError: its architectures do not hold the same; or the records name another image's manifest.
        """
        repository = self.repository(repository_of(thing))
        images = {entry.architecture: self._image(repository, entry.digest) for entry in entries}
        configs = {architecture: config for architecture, (_, config) in images.items()}
        for entry in entries:
            _require_own(thing, entry, configs[entry.architecture])
        versions = {entry.architecture: entry.versions for entry in entries}
        released = [item.name for item in thing.brought if item.released] if isinstance(thing, Image) else []
        contents = {architecture: config.content for architecture, config in configs.items()}
        same_content.require(thing.target, contents, versions, released)
        labels = configs[entries[0].architecture].labels
        annotations = self._checkout | {name: text for name, text in labels.items() if name.startswith(OCI)}
        annotations |= {INPUTS: inputs, DATE: self.plan.date}
        members = [
            {**manifest.descriptor, "platform": _platform(config), **self._covered(entry)}
            for entry, (manifest, config) in zip(entries, images.values(), strict=True)
        ]
        content = {"schemaVersion": 2, "mediaType": oci.INDEX, "manifests": members, "annotations": annotations}
        return self.registry.put_manifest(repository, "", content, oci.INDEX)

    def _covered(self, entry: Entry) -> dict[str, dict[str, str]]:
        """What an index says of one of its images besides: which statements and SBOMs are the publisher's, by their digests. A
        signature of the index covers them then."""
        found = {provenance.COVERED: " ".join(sorted(entry.provenance.values()))} if entry.provenance else {}
        item = self.plan.by_key[entry.target, entry.architecture]
        for target in item.needs if item.kind == "joined" else (item.target,):
            part = self.plan.known.get((target, entry.architecture))
            if part and part.sbom and part.digest == entry.parts.get(target, entry.digest):
                found[sbom.COVERED + target] = f"{part.repository}@{part.sbom}"
        return {"annotations": found} if found else {}

    @property
    def _checkout(self) -> dict[str, str]:
        """What an index says of the checkout that it was made in: its address, and its revision unless files differ from it.
        Images say no revision: every commit would change all of them."""
        found = next(iter(self._source), {})
        address, revision = found.get("uri", "").removeprefix("git+"), found.get("digest", {}).get("gitCommit", "")
        said = {SOURCE: address, REVISION: "" if "annotations" in found else revision}
        return {name: text for name, text in said.items() if text}

    def _image(self, repository: str, digest: str) -> tuple[Manifest, Config]:
        """A manifest and its config."""
        manifest = self.registry.manifest(repository, digest)
        if manifest is None:
            raise RosmlError(f"{repository}@{digest} is not in the registry any more", "run 'build' and 'join' again")
        return manifest, self.registry.config(repository, manifest)


def _carries_nothing(item: Item) -> bool:
    """Whether an image tests nothing for others."""
    assert isinstance(item.thing, Image)
    return item.thing.carriers[:1] != (item.target,)


def side_by_side(work: Callable[[T], R], items: Iterable[T]) -> list[R]:
    """Does some work for each of several things, some at a time; gives the results in the order of the things. After an error
    nothing more is begun."""
    pool = ThreadPoolExecutor(READERS)
    try:
        return list(pool.map(work, items))
    finally:
        pool.shutdown(cancel_futures=True)


def _platform(config: Config) -> dict[str, str]:
    """What an index says of where an image runs."""
    facts = config.facts
    found = {"os": facts.os or "linux", "architecture": facts.architecture, "variant": facts.variant}
    return {name: value for name, value in found.items() if value}


def _require_own(thing: Image | Part, entry: Entry, config: Config) -> None:
    """Checks that a manifest is that of the image which the records say it is.

    Raises:
        RosmlError: it is not.
    """
    found = config.labels.get(TITLE, ""), config.facts.architecture or ""
    if found != (title(thing), entry.architecture):
        raise RosmlError(
            f"the records' entry {entry.tag} names {entry.digest},"
            f" which is {found[0] or 'an image without a title'} for {found[1] or 'no architecture'}",
            "publish it again with --force",
        )


def _database(trivy: Trivy | ScannerFailed) -> str:
    """The digest of the scanner's database; empty where there is none, of which the scan tells."""
    try:
        return "" if isinstance(trivy, ScannerFailed) else trivy.database().digest
    except ScannerFailed:
        return ""


def policy_digest(rules: Rules, date: str) -> str:
    """Stands for what a scan's policy says at the date of a run, not for how it is written. An ignore entry that has expired
    by then says nothing, so that a scan that was clean thanks to it does not count any more."""
    return hashlib.sha256(rules.in_force(_moment(date).date()).model_dump_json().encode()).hexdigest()


def _moment(date: str) -> datetime:
    """A run's date."""
    return datetime.fromisoformat(date.replace("Z", "+00:00"))


def _short(message: str, lines: int = 12) -> str:
    """A message's beginning: the records are no place for logs."""
    return "\n".join(message.splitlines()[:lines])[:2000]
