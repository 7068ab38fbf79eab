"""Joins images with frameworks, in the registry."""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial

from rosml.base.clock import now
from rosml.base.errors import RosmlError
from rosml.images.builds import contents
from rosml.images.builds.maker import NewImage
from rosml.images.image_set.model import Image
from rosml.images.publish.items import Item
from rosml.images.publish.new_entry import new_entry
from rosml.images.publish.run import Run
from rosml.images.records.store import Entry
from rosml.images.scan import cyclonedx
from rosml.images.scan.sbom import FORMAT, MEDIA_TYPE, Shelf


def join(run: Run) -> None:
    """Joins images, one stack after the other. In each, images that run shared tests for others come first."""
    joined = [(item, item.thing) for item in run.state.items if isinstance(item.thing, Image) and item.kind == "joined"]
    items = [item for item, _ in sorted(joined, key=lambda pair: order(pair[1]))]
    run.each("join", items, partial(_join, run))


def order(image: Image) -> tuple[str, bool]:
    """Each image is tested as soon as it is joined. If the builder's disk is too small for all stacks, it fetches the parts of each
    stack once."""
    return image.stack or "", image.carriers[:1] != (image.target,)


def _join(run: Run, item: Item, entry: Entry) -> Entry:
    assert isinstance(item.thing, Image)
    started, parts = now(), run.parts(item)
    digest = run.maker.join(item.thing, item.architecture, parts)
    sbom = _attach_sbom(run, item, digest, parts)
    return new_entry(run, item, entry, NewImage(digest, parts, sbom=sbom), started)


def _attach_sbom(run: Run, item: Item, digest: str, parts: Mapping[str, str]) -> str:
    """Attaches the SBOM of a joined image, which those of its parts are put together to; returns the digest of the artifact."""
    state, place = run.state, run.state.place
    entries = [state.entries[target, item.architecture] for target in parts]
    shelf = Shelf(place.client, {entry.digest: entry.sbom for entry in entries})
    sboms = [(entry.target, shelf.load(place.path(entry.repository), entry.digest)) for entry in entries]
    assert isinstance(item.thing, Image)
    repository = place.path(item.thing.repository)
    manifest = place.client.manifest(repository, digest)
    if manifest is None:
        raise RosmlError(f"{item.target} is not in the registry any more", "run it again")
    reference = f"{place.client.host}/{repository}@{digest}"
    content = cyclonedx.joined(reference, contents.created(place.client.config(repository, manifest).facts), sboms)
    kind = MEDIA_TYPE, content, MEDIA_TYPE, FORMAT
    return place.client.attach(repository, manifest.descriptor, *kind)
