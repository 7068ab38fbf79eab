"""Runs the structure tests of images that have not passed them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import partial

from rosml.base.problems import some
from rosml.images.image_set.model import Image
from rosml.images.publish.items import Item
from rosml.images.publish.run import Run, failure
from rosml.images.records.store import Entry


def test(run: Run, targets: Sequence[str] = ()) -> None:
    """Tests all images, or those of some targets. An image that failed in this run is tested again only in the next one."""
    failed = {(it.target, it.architecture) for it in run.outcomes if (it.step, it.state) == ("test", "failed")}
    items = [item for item in run.state.items if item.kind != "part" and item.key not in failed]
    run.each("test", [item for item in items if not targets or item.target in targets], partial(_test, run))


def test_at_once(run: Run, item: Item) -> None:
    """Tests an image that was just built or joined, if this machine can."""
    task = run.state.task(item, ahead=False)
    if task.steps[:1] == ("test",):
        run.do("test", item, "(at once)", task.why, partial(_test, run))


def _test(run: Run, item: Item, entry: Entry) -> Entry:
    assert isinstance(item.thing, Image)
    names = run.state.tests.to_run(item)
    report = run.maker.test(item.thing, item.architecture, entry.digest, run.parts(item), names)
    reason = f"tests failed: {some(list(report.failures))}\n{report.output}".strip()
    return replace(
        entry,
        tested=run.state.tests.digest(item, names),
        passed=report.passed,
        failures=report.failures,
        unpacked=report.unpacked,
        versions=report.versions,
        failed=failure("test", reason) if report.failures else {},
    )
