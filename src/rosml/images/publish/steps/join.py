"""Joins images with frameworks, in the registry."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import cache, partial

from rosml.base.clock import now
from rosml.base.errors import RosmlError
from rosml.images.builds import contents
from rosml.images.builds.maker import NewImage
from rosml.images.image_set.labels import title
from rosml.images.image_set.model import Image
from rosml.images.publish.items import NO_SBOM, UNDESCRIBED, Item, Key
from rosml.images.publish.new_entry import new_entry
from rosml.images.publish.run import Run
from rosml.images.records.store import Entry
from rosml.images.scan import attached, cyclonedx
from rosml.images.scan.sbom import Sbom, Shelf


def join(run: Run) -> None:
    """Joins images, one stack after the other. In each, images that run shared tests for others come first."""
    joined = [(item, item.thing) for item in run.state.items if isinstance(item.thing, Image) and item.kind == "joined"]
    items = [item for item, _ in sorted(joined, key=lambda pair: order(pair[1]))]
    run.each("join", items, partial(_join, run, cache(partial(_sbom, run))))


def order(image: Image) -> tuple[str, bool]:
    """Each image is tested as soon as it is joined. If the builder's disk is too small for all stacks, it fetches the parts of each
    stack once."""
    return image.stack or "", image.carriers[:1] != (image.target,)


Read = Callable[[Key], Sbom]


def _join(run: Run, read: Read, item: Item, entry: Entry) -> Entry:
    assert isinstance(item.thing, Image)
    started, parts = now(), run.parts(item)
    if {*run.state.reasons(item)} <= {NO_SBOM, UNDESCRIBED}:
        sbom = _attach_sbom(run, read, item, entry.digest)
        return replace(entry, sbom=sbom, described=contents.FORMAT, failed={})
    digest = run.maker.join(item.thing, item.architecture, parts)
    sbom = _attach_sbom(run, read, item, digest)
    return new_entry(run, item, entry, NewImage(digest, parts, sbom=sbom), started)


def _sbom(run: Run, key: Key) -> Sbom:
    """The SBOM of a ROS image or part."""
    place, entry = run.state.place, run.state.entries[key]
    return Shelf(place.client, {entry.digest: entry.sbom}).load(place.path(entry.repository), entry.digest)


def _attach_sbom(run: Run, read: Read, item: Item, digest: str) -> str:
    """Attaches the SBOM of a joined image, to which those of its parts are put together; returns the digest of the artifact."""
    place = run.state.place
    needs = [run.state.by_key[target, item.architecture] for target in item.needs]
    sboms = [(title(need.thing), read(need.key)) for need in needs]
    repository = place.path(item.repository)
    manifest = place.client.manifest(repository, digest)
    if manifest is None:
        raise RosmlError(f"{item.target} is not in the registry any more", "run it again")
    reference = f"{place.client.host}/{repository}@{digest}"
    created = cyclonedx.created(place.client.config(repository, manifest).facts)
    content = cyclonedx.joined(reference, created, sboms, run.state.image_set.matrix.source or "")
    return attached.attach(place.client, repository, manifest.descriptor, content)
