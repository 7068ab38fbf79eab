"""Builds ROS images and parts that are out of date or missing, and pushes them by digest."""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import replace
from functools import partial

from rosml.base.clock import now
from rosml.base.errors import RosmlError
from rosml.images.builds import contents, package_state
from rosml.images.builds.maker import BuildRequest, NewImage
from rosml.images.image_set.model import Part
from rosml.images.publish.items import UNDESCRIBED, Item
from rosml.images.publish.new_entry import new_entry
from rosml.images.publish.run import Postponed, Run
from rosml.images.records.store import Entry

RESTARTS = 2
"""How often a run may restart a distribution after ROS publishes packages."""

PATIENCE_SECONDS = 45 * 60.0
"""How long a machine waits for ROS images that another one builds, which may have died."""

LOOK_SECONDS = 30.0

LAST = 2
"""The place of what other machines build, in the order of work."""


def build(run: Run) -> None:
    """Builds ROS images and parts.

    If ROS publishes packages after the plan, all components of that distribution are built from these: an image has one sync date.
    """
    items = sorted((item for item in run.state.items if item.kind != "joined"), key=partial(_order, run))
    if run.whole:
        _build_together(run, items)
    _build_all(run, [item for item in items if _order(run, item) < LAST])
    _wait_for_ros(run)
    _build_all(run, [item for item in items if _order(run, item) == LAST])


def _build_all(run: Run, items: Sequence[Item]) -> None:
    for restarts in range(RESTARTS, -1, -1):
        before = len(run.outcomes)
        if not run.each("build", items, partial(_build, run, restarts > 0)):
            return
        # Items that waited for a postponed one may be ready now, so all items are tried again.
        run.outcomes[before:] = [outcome for outcome in run.outcomes[before:] if outcome.state != "waits"]


def _order(run: Run, item: Item) -> int:
    """If there are other machines, they wait for the parts that are built here, and this one for theirs."""
    elsewhere = run.state.request.elsewhere
    if elsewhere is None:
        return 1
    if isinstance(item.thing, Part):
        return LAST if item.thing.name in elsewhere else 0
    return LAST if item.target in elsewhere else 1


def _wait_for_ros(run: Run) -> None:
    """Waits until another machine of the run has built and tested the ROS images that it has. Two machines that build the same image may
    end with two digests, and images that were joined with the first one then get no tag."""
    until = min(time.monotonic() + PATIENCE_SECONDS, run.deadline)
    for item in run.state.items:
        if item.kind == "ros" and _order(run, item) == LAST:
            while time.monotonic() < until:
                run.state.look_again(item)
                if not _is_under_way(run, item):
                    break
                time.sleep(LOOK_SECONDS)


def _is_under_way(run: Run, item: Item) -> bool:
    entry = run.state.entries.get(item.key)
    has_failed = entry is not None and bool(entry.failed) and entry.changed == run.state.date
    return not has_failed and not {"build", "test"}.isdisjoint(run.state.task(item, ahead=False).steps)


def _build_together(run: Run, items: Sequence[Item]) -> None:
    """Builds at once what one image is made of and what needs nothing else first. The builder has it when its step comes."""
    builds = []
    for item in items:
        task = run.state.task(item, ahead=False)
        if not task.hindered and task.steps[:1] == ("build",) and run.state.reasons(item) != [UNDESCRIBED]:
            builds.append(BuildRequest(item.thing, item.architecture, run.parts(item), _packages(run, item)))
    if len(builds) > 1:
        started = time.monotonic()
        run.maker.build_together(builds)
        share = (time.monotonic() - started) / len(builds)
        run.beforehand |= {each.key: share for each in builds}


def _packages(run: Run, item: Item) -> str:
    """The state of an image's package repositories; if they did not answer, that of its last build. Empty for a part."""
    if isinstance(item.thing, Part):
        return ""
    entry = run.state.entries.get(item.key)
    return run.state.package_state.get(item.thing.distribution, entry.package_state if entry else "")


def _build(run: Run, may_restart: bool, item: Item, entry: Entry) -> Entry:
    if run.state.reasons(item) == [UNDESCRIBED]:
        run.say(f"{item.target} stays as it is: only its facts are attached")
        sbom = run.maker.describe(item.thing, entry.digest)
        return replace(entry, sbom=sbom, described=contents.FORMAT, failed={})
    started = now()
    if isinstance(item.thing, Part):
        output = run.maker.build_part(item.thing, item.architecture)
    else:
        packages = _packages(run, item)
        try:
            output = run.maker.build_image(item.thing, item.architecture, run.parts(item), packages)
        except RosmlError:
            if may_restart:
                _postpone_if_packages_moved(run, item.thing.distribution, packages)
            raise
    run.pushed += _new_bytes(run, item, entry, output)
    return new_entry(run, item, entry, output, started)


def _postpone_if_packages_moved(run: Run, distribution: str, before: str) -> None:
    """After a build failed: if ROS published new packages since the plan was made, the distribution is built from these."""
    state = run.state
    try:
        current = package_state.state(state.request.services, state.image_set.matrix, distribution)
    except RosmlError:  # the error of the build says more
        return
    if package_state.ros_date(current) > package_state.ros_date(before):
        state.package_state[distribution] = current
        raise Postponed(
            f"ROS published new packages of {distribution} meanwhile ({current}); its images are built from these"
        )


def _new_bytes(run: Run, item: Item, before: Entry, output: NewImage) -> int:
    """Bytes of the new layers of an item: without the layers of its needs, and of its earlier manifest."""
    layers = _layer_sizes(run, item, output.digest)
    present = _layer_sizes(run, item, before.digest)
    for target, digest in output.parts.items():
        present |= _layer_sizes(run, run.state.by_key[target, item.architecture], digest)
    return sum(size for layer, size in layers.items() if layer not in present)


def _layer_sizes(run: Run, item: Item, digest: str) -> dict[str, int]:
    place = run.state.place
    manifest = place.client.manifest(place.path(item.repository), digest) if digest else None
    return {layer.digest: layer.size for layer in manifest.layers} if manifest else {}
