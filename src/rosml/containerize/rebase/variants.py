"""One app on several accelerators: an image for each stack, from one build. Each image has a label with all of them, by which
`rosml run` takes the one for a machine (`run/variants.py`)."""

from __future__ import annotations

import re
from collections.abc import Sequence

from rosml.base.errors import RosmlError
from rosml.containerize.rebase.image import VARIANTS
from rosml.containerize.rebase.plan import Plan
from rosml.containerize.rebase.rebaser import Rebaser
from rosml.images.image_set.labels import ADDONS, BASE_NAME, PREFIX
from rosml.images.join.layers import Source
from rosml.images.matrix.names import NONE
from rosml.images.matrix.tags import main_tag
from rosml.registry import references

STACK = re.compile(r"[a-z][a-z0-9]{0,15}")
DRIVER = re.compile(r"[0-9]{1,5}(\.[0-9]{1,5}){0,3}")

MOST = 10  # most variants of an app


def plans(rebaser: Rebaser, app: str, stacks: Sequence[str], tag: str = "") -> list[Plan]:
    """The images of an app, one for each stack, and last the tag itself, which is the first of them."""
    _require_stacks(stacks)
    sources = rebaser.read(app)
    source = next(iter(sources.values()))
    bases = {stack: _base(source, stack) for stack in stacks}
    drivers = {stack: rebaser.driver(source, bases[stack], tuple(sources), stack) for stack in stacks}
    where = references.parse(tag) if tag else rebaser.where(app)
    if references.is_digest(where.reference):
        text = f"{where} is a digest, and tags have to move"
        raise RosmlError(text, "name one: --tag REGISTRY/NAME:TAG", exit_code=2)
    versions = {stack: f":{driver}" if DRIVER.fullmatch(driver) else "" for stack, driver in drivers.items()}
    label = {VARIANTS: " ".join(f"{stack}{version}" for stack, version in versions.items())}
    tags = [(stack, f"{where}-{stack}") for stack in stacks] + [(stacks[0], str(where))]
    return [rebaser.plan(app, bases[stack], name, extra=label, stack=stack) for stack, name in tags]


def _require_stacks(stacks: Sequence[str]) -> None:
    if twice := [name for number, name in enumerate(stacks) if name in stacks[:number]]:
        raise RosmlError(f"{twice[0]} is named twice", "name each stack once, such as cpu,cu130", exit_code=2)
    if wrong := [name for name in stacks if not STACK.fullmatch(name)]:
        raise RosmlError(f"{wrong[0]!r} is no stack", "name stacks such as cpu,cu130", exit_code=2)
    if not 2 <= len(stacks) <= MOST:
        text = "one variant is named" if len(stacks) == 1 else f"{len(stacks)} variants are named"
        raise RosmlError(text, f"name 2 to {MOST}, such as cpu,cu130", exit_code=2)


def _base(app: Source, stack: str) -> str:
    """The app's base image on another stack; the same one if that has no stack, but the app has add-ons of one."""
    labels = app.labels
    own_stack, distribution, component = (
        labels.get(PREFIX + name, "") for name in ("stack", "distribution", "component")
    )
    if not own_stack:
        text = f"{app.name} has no framework, so no accelerator makes a difference"
        raise RosmlError(text, "put it on an image with one first: --base ros-torch:…", exit_code=2)
    name = labels.get(BASE_NAME, "")
    if not distribution or not component or not name:
        raise RosmlError(f"{app.name} does not say which base image it is on", "build it again with rosml", exit_code=2)
    if labels.get(f"{PREFIX}framework") == NONE and labels.get(ADDONS):
        return name
    where = references.parse(name)
    return f"{where.host}/{where.repository}:{main_tag(distribution, component, stack)}"
