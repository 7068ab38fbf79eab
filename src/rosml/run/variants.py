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
    """The image for a stack; empty if there is none, or if the typed image is for that stack, or is named in full: by a digest,
    a stack or a date."""
    own_stack, image = context.image.labels.get(STACK, ""), context.line.image
    name, _, tag = image.rpartition(":")
    if not name or "/" in tag:
        name, tag = image, "latest"
    is_full = "@" in image or _DATED.search(tag) or any(tag.endswith(f"-{other}") for other in drivers)
    return "" if own_stack not in drivers or not tag or is_full or stack in ("", own_stack) else f"{name}:{tag}-{stack}"


def _drivers(context: Context) -> dict[str, str]:
    """The stacks with their drivers; none if the label says something else."""
    entries = [_ENTRY.fullmatch(text) for text in context.image.labels.get(LABEL, "").split()]
    if len(entries) > MOST_STACKS or not all(entries):
        return {}
    return {entry[1]: entry[2] or "" for entry in entries if entry}


def _best_stack(context: Context, drivers: dict[str, str]) -> str:
    """The stack with the newest CUDA that the driver can run; without a GPU, one that needs none. Empty if none fits."""
    host, line = context.host, context.line
    has_gpu = gpu.is_nvidia(host) and not line.asks("no-gpu")
    version = gpu.numbers(gpu.driver(host)) if has_gpu else ()
    if has_gpu and not version:
        return ""  # a Jetson, whose driver has another name
    can_hand_in = line.has("gpus", "runtime") or bool(gpu.handed_in(context.engine, host))
    fitting = [name for name, driver in drivers.items() if driver and can_hand_in and gpu.numbers(driver) <= version]
    if fitting:
        return max(fitting, key=lambda name: (gpu.numbers(drivers[name]), int("".join(re.findall("[0-9]", name)) or 0)))
    return next((name for name, driver in drivers.items() if not driver), "")
