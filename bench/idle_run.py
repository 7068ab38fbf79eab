"""A second run over the whole matrix, measured on a registry: nothing changed, so nothing is to be done.

The images that a first run would have made stand there as manifests of some bytes, with their entries in the records and
their tags: what a run asks the registry for is the same, whatever an image weighs.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from bench.temporary import Temporary
from rosml.base.errors import RosmlError
from rosml.base.problems import counted
from rosml.base.units import duration, size
from rosml.images.image_set.labels import TITLE, title
from rosml.images.image_set.model import Image, ImageSet, Part, repository_of, tags_of
from rosml.images.matrix.names import dated
from rosml.images.publish import plan as planning
from rosml.images.publish.pipeline import Pipeline
from rosml.images.publish.plan import Item, Plan
from rosml.images.publish.steps import STEPS
from rosml.images.records.store import DATE, INDEX, READERS, Entry, Records
from rosml.machine.services import Services
from rosml.registry import oci
from rosml.registry.client import Registry

LAYER = b"a layer"

HEADING = "a second run over the whole matrix, nothing changed"


@dataclass(frozen=True)
class IdleRun:
    """What a run came to that found everything as it should be.

    Attributes:
        items: images and parts, on their architectures. tags: of all of them.
        seconds: wall time, from the first look at the registry to the end.
        uploaded: bytes that were sent. steps: how many were done, or failed.
    """

    items: int
    tags: int
    seconds: float
    uploaded: int
    steps: int

    def to_json(self) -> dict[str, float | int]:
        """For `--json`."""
        return dict(vars(self))


def text(found: IdleRun) -> str:
    """What was measured, in a sentence's end."""
    return (
        f"{found.items} images and parts on their architectures, {found.tags} tags, {duration(found.seconds)},"
        f" {size(found.uploaded)} uploaded, {counted(found.steps, 'step')} done"
        " (each image a manifest of some bytes, put there as a first run would have left it)"
    )


def measure(services: Services, image_set: ImageSet, prefix: str, date: str, say: Callable[[str], None]) -> IdleRun:
    """Fills a place with the whole matrix, runs all steps once more, and removes everything again.

    Args:
        services: the registry, and of when packages are. catalogue: what is published there.
        prefix: a path in the registry that nobody else uses. date: of the run.

    Raises:
        RosmlError: the registry does not answer or refuses; or something is to be done, because packages moved or their
            repositories do not answer. Nothing is built then.
    """
    with Temporary(services.registry, ca_bundle=services.ca_bundle) as client:
        first = _survey(services, image_set, client, prefix, date)
        say(f"{len(first.items)} manifests of some bytes, with their entries, in the place of a first run")
        tags = Place(first, client, prefix).fill()
        say(f"a run over {len(first.items)} images and parts on their architectures, nothing changed")
        before, started = client.uploaded, time.monotonic()
        run = Pipeline(_survey(services, image_set, client, prefix, date), client, services.registry, prefix, say)
        _require_idle(run.plan)
        for step in STEPS.values():
            step(run)
        seconds, uploaded = time.monotonic() - started, client.uploaded - before
    done = sum(outcome.state != "waits" for outcome in run.outcomes)
    return IdleRun(len(run.plan.items), tags, seconds, uploaded, done)


def _survey(services: Services, image_set: ImageSet, client: Registry, prefix: str, date: str) -> Plan:
    """For all architectures: nothing is left to another machine."""
    architectures = tuple(image_set.matrix.architectures)
    return planning.survey(services, image_set, client, prefix, (), architectures, date=date)


def _require_idle(plan: Plan) -> None:
    """Checks that a run would do nothing: this is a measurement, and no time to build images.

    Raises:
        RosmlError: it would.
    """
    tasks = [task for item in plan.items if (task := plan.task(item)).steps]
    if tasks:
        first, remarks = tasks[0], "".join(f"; {remark}" for remark in plan.remarks)
        text = f"{len(tasks)} items are not as they were put there, {first.item.target} because {first.why[0]}{remarks}"
        raise RosmlError(text, "measure again when the repositories of packages answer, and do not move")


@dataclass
class Place:
    """Where everything that a matrix describes stands in a few bytes.

    Attributes:
        plan: all items. client: the registry. prefix: path of the repositories.
    """

    plan: Plan
    client: Registry
    prefix: str

    @cached_property
    def _book(self) -> Records:
        return Records(self.client, self.prefix)

    def fill(self) -> int:
        """Puts all of it, as a run that passed everything would have left it. Gives the number of images' tags."""
        things = self.plan.things()
        for repository in {repository_of(thing) for thing in things}:
            self.client.put_blob(self._book.path(repository), LAYER)
        with ThreadPoolExecutor(READERS) as pool:
            list(pool.map(self._put_item, self.plan.items))
            return sum(pool.map(self._put_index, things))

    def _config(self, item: Item) -> bytes:
        labels = {TITLE: title(item.thing)}
        return oci.encoded({"os": "linux", "architecture": item.architecture, "config": {"Labels": labels}})

    def _manifest(self, item: Item) -> bytes:
        layer = oci.descriptor("application/vnd.oci.image.layer.v1.tar", LAYER)
        config = oci.descriptor(oci.CONFIG, self._config(item))
        return oci.encoded({"schemaVersion": 2, "mediaType": oci.IMAGE, "config": config, "layers": [layer]})

    def _entry(self, item: Item) -> Entry:
        """What the records say of it after a run in which it passed its tests."""
        needs = {target: self.plan.by_key[target, item.architecture] for target in item.needs}
        tested = "" if item.kind == "part" else self.plan.tests_digest(item)
        upstream = self.plan.upstream.get(item.thing.distribution, "") if isinstance(item.thing, Image) else ""
        return Entry(
            *item.key,
            inputs=self.plan.inputs.digest(*item.key),
            upstream=upstream if item.kind == "ros" else "",
            repository=item.repository,
            digest=oci.digest_of(self._manifest(item)),
            parts={target: oci.digest_of(self._manifest(part)) for target, part in needs.items()},
            size=len(LAYER),
            sbom="" if item.kind == "joined" else oci.digest_of(LAYER),
            date=self.plan.date,
            changed=self.plan.date,
            tested=tested,
            passed=int(bool(tested)),
        )

    def _put_item(self, item: Item) -> None:
        repository = self._book.path(item.repository)
        self.client.put_blob(repository, self._config(item))
        self.client.put_manifest(repository, "", self._manifest(item), oci.IMAGE)
        self._write(self._entry(item))

    def _put_index(self, thing: Image | Part) -> int:
        """The index of its architectures, and its tags, of which it gives the number."""
        items = [self.plan.by_key[key] for key in self.plan.members(thing)]
        members = []
        for item in items:
            place = {"os": "linux", "architecture": item.architecture}
            members.append({**oci.descriptor(oci.IMAGE, self._manifest(item)), "platform": place})
        content: dict[str, Any] = {"schemaVersion": 2, "mediaType": oci.INDEX, "manifests": members}
        index = oci.encoded({**content, "annotations": {TITLE: title(thing), DATE: self.plan.date}})
        entries = [self._entry(item) for item in items]
        entry = Entry(
            thing.target,
            INDEX,
            inputs=self.plan.inputs.together(thing),
            repository=repository_of(thing),
            digest=oci.digest_of(index),
            parts={item.architecture: item.digest for item in entries},
            date=self.plan.date,
            changed=self.plan.date,
        )
        repository = self._book.path(entry.repository)
        names = tags_of(thing)
        tags = (dated(names[0], self.plan.date), *names)
        for tag in tags:
            self.client.put_manifest(repository, tag, index, oci.INDEX)
        self._write(entry)
        return len(tags)

    def _write(self, entry: Entry) -> None:
        inputs = {} if entry.architecture == INDEX else self.plan.inputs.of(entry.target, entry.architecture)
        self._book.write(entry, inputs)
