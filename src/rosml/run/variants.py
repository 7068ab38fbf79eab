"""Apps that exist for several accelerators: takes the image for this machine's GPU and driver.

`rosml rebase --variants` makes them. Each has a label with all of them, and a tag that ends in its own stack.
"""

from __future__ import annotations

import re
from collections.abc import Mapping

from rosml.run.context import Context
from rosml.run.plugins import gpu

LABEL = "io.rosml.variants"
"""The label with the stacks, each with the oldest driver that it needs: `cpu cu130:580`."""

STACK = "io.rosml.stack"

MOST_STACKS = 10
_ENTRY = re.compile(r"([a-z][a-z0-9]{0,15})(?::([0-9]{1,5}(?:\.[0-9]{1,5}){0,3}))?")

_DATED = re.compile(r"-\d{8}(\.\d+)?$")


def for_this_machine(context: Context) -> str:
    """The image for this machine; empty if it is the typed one, or if nobody knows: of another machine, or by a full name."""
    drivers = _drivers(context)
    return _tagged(context, drivers, _best_stack(context, drivers)) if context.is_here else ""


def for_another_machine(context: Context) -> str:
    """The image that a call for another machine asks for; empty if it is the typed one. Of images for GPUs, it is the one for the
    oldest driver, as nobody knows that machine's."""
    drivers, line = _drivers(context), context.line
    if line.asks("no-gpu"):
        return _tagged(context, drivers, next((stack for stack, driver in drivers.items() if not driver), ""))
    if not gpu.is_theirs(line) or drivers.get(context.image.labels.get(STACK, "")):
        return ""
    with_gpu = [stack for stack, driver in drivers.items() if driver]
    return _tagged(context, drivers, min(with_gpu, key=lambda stack: gpu.numbers(drivers[stack]), default=""))


def _tagged(context: Context, drivers: Mapping[str, str], stack: str) -> str:
    """The image for a stack; empty if there is none, or if the typed image is for that stack or is named in full."""
    own_stack = context.image.labels.get(STACK, "")
    image, tag = _split(context.line.image)
    is_full_name = any(tag.endswith(f"-{name}") for name in drivers) or _DATED.search(
        tag
    )  # nothing has that name and a stack
    return (
        ""
        if own_stack not in drivers or not tag or is_full_name or stack in ("", own_stack)
        else f"{image}:{tag}-{stack}"
    )


def _drivers(context: Context) -> dict[str, str]:
    """The stacks with their drivers; none if the label says something else."""
    entries = [_ENTRY.fullmatch(text) for text in context.image.labels.get(LABEL, "").split()]
    if len(entries) > MOST_STACKS or not all(entries):
        return {}
    return {entry[1]: entry[2] or "" for entry in entries if entry}


def _best_stack(context: Context, drivers: dict[str, str]) -> str:
    """The stack with the newest CUDA that the driver can run; without a GPU, one that needs none. Empty if none fits."""
    host, line = context.host, context.line
    driver_version = gpu.numbers(gpu.driver(host)) if gpu.is_nvidia(host) and not line.asks("no-gpu") else ()
    can_hand_in = line.has("gpus", "runtime") or bool(gpu.handed_in(context.engine, host))
    if gpu.is_nvidia(host) and not driver_version and not line.asks("no-gpu"):
        return ""  # a Jetson, whose driver has another name
    fitting = {
        name: driver
        for name, driver in drivers.items()
        if driver and can_hand_in and gpu.numbers(driver) <= driver_version
    }
    if driver_version and fitting:
        return max(fitting, key=lambda name: (gpu.numbers(fitting[name]), _digits(name)))
    return next((name for name, driver in drivers.items() if not driver), "")


def _digits(name: str) -> int:
    return int("".join(character for character in name if character in "0123456789") or 0)


def _split(image: str) -> tuple[str, str]:
    """The name and the tag of an image; no tag if it is named by its digest."""
    name, _, tag = image.rpartition(":")
    if "@" in image:
        return image, ""
    return (name, tag) if name and "/" not in tag else (image, "latest")
