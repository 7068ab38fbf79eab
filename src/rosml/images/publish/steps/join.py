"""Joins images with frameworks, in the registry."""

from __future__ import annotations

from functools import partial

from rosml.base.clock import now
from rosml.images.builds.maker import NewImage
from rosml.images.image_set.model import Image
from rosml.images.publish.items import Item
from rosml.images.publish.new_entry import new_entry
from rosml.images.publish.run import Run
from rosml.images.records.store import Entry


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
    return new_entry(run, item, entry, NewImage(digest, parts), started)
