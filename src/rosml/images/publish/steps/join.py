"""Joins images with frameworks, in the registry."""

from __future__ import annotations

from functools import partial

from rosml.base.clock import now
from rosml.images.builds.maker import Made
from rosml.images.image_set.model import Image
from rosml.images.publish.made import after
from rosml.images.publish.run import Run
from rosml.images.publish.state import Item
from rosml.images.records.store import Entry


def join(run: Run) -> None:
    """Joins images. Images that run shared tests for others come first."""
    items = [item for item in run.state.items if item.kind == "joined"]
    run.each("join", sorted(items, key=_carries_nothing), partial(_join, run))


def _carries_nothing(item: Item) -> bool:
    """Whether an image runs no shared tests for others."""
    assert isinstance(item.thing, Image)
    return item.thing.carriers[:1] != (item.target,)


def _join(run: Run, item: Item, entry: Entry) -> Entry:
    assert isinstance(item.thing, Image)
    started, parts = now(), run.parts(item)
    digest = run.maker.join(item.thing, item.architecture, parts)
    return after(run, item, entry, Made(digest, parts), started)
