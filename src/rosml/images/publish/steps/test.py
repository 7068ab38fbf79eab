"""Runs the structure tests of images that have not passed them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import partial

from rosml.base.problems import some
from rosml.images.image_set.model import Image
from rosml.images.publish.run import Run, failure
from rosml.images.publish.state import Item
from rosml.images.records.store import Entry


def test(run: Run, targets: Sequence[str] = ()) -> None:
    """Tests images. An image that failed in this run is tested again only in the next one.

    Args:
        run: the run.
        targets: test only these; all if empty.
    """
    failed = {(it.target, it.architecture) for it in run.outcomes if (it.step, it.state) == ("test", "failed")}
    wanted = [i for i in run.state.items if i.kind != "part" and (not targets or i.target in targets)]
    run.each("test", [item for item in wanted if item.key not in failed], partial(_test, run))


def test_at_once(run: Run, item: Item) -> None:
    """Tests an image that was just built or joined, if this machine can."""
    task = run.state.task(item, ahead=False)
    if task.steps[:1] == ("test",):
        run.do("test", item, "(at once)", task.why, partial(_test, run))


def _test(run: Run, item: Item, entry: Entry) -> Entry:
    assert isinstance(item.thing, Image)
    names = run.state.tests(item)
    found = run.maker.test(item.thing, item.architecture, entry.digest, run.parts(item), names)
    reason = f"tests failed: {some(list(found.failures))}\n{found.said}".strip()
    return replace(
        entry,
        tested=run.state.digest_of(item, names),
        passed=found.passed,
        failures=found.failures,
        unpacked=found.unpacked,
        versions=found.versions,
        failed=failure("test", reason) if found.failures else {},
    )
