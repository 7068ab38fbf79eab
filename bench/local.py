"""What measurements share that work in the local registry: an example app, and how they leave nothing there."""

from __future__ import annotations

import subprocess
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress

from rosml import ROOT
from rosml.base.errors import RosmlError
from rosml.base.side_by_side import side_by_side
from rosml.containerize import inputs as app_inputs
from rosml.containerize.build import step_order as build
from rosml.machine.services import Services
from rosml.registry.client import Registry

BASE = "rosml/ros:ros1-bookworm-core"

PRUNE_SECONDS = 600.0
"""What removing some gigabytes from the builder's cache may take."""


def example(services: Services, namespace: str, say: Callable[[str], None]) -> tuple[str, float]:
    """Builds the example on the base image that is in the local registry.

    Returns:
        Its reference, and the seconds that this took.

    Raises:
        RosmlError: no base image is there, or the build failed.
    """
    options = {"base-image": f"{services.registry}/{BASE}", "image-name": f"{namespace}/example", "target": "run"}
    options |= {"command": "roslaunch compass compass.launch", "tests": "false", "image-tag": "latest"}
    folder = ROOT / "examples/ros1"
    say("build the example")
    started = time.monotonic()
    built = build.build_images(build.new_call(folder, app_inputs.values(options, folder, {}), {}, services, say))
    return built.images[0].reference, time.monotonic() - started


def buildx(services: Services, *words: str) -> str:
    """What buildx prints about the builder's cache; nothing if it fails: the builder forgets what is left by itself, only later."""
    with suppress(OSError, subprocess.TimeoutExpired):
        return subprocess.run(
            [*services.buildx, *words, "--builder", services.builder],
            env=services.environment(),
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            timeout=PRUNE_SECONDS,
            check=False,
        ).stdout
    return ""


@contextmanager
def cleaned(registry: Registry, pushed: set[tuple[str, str]], say: Callable[[str], None]) -> Iterator[None]:
    """Removes at the end what was pushed. The registry itself collects its blobs.

    Args:
        pushed: repositories with digests; what is added meanwhile counts as well.
    """
    try:
        yield
    finally:
        say("remove what was pushed")

        def remove(item: tuple[str, str]) -> None:
            with suppress(RosmlError):
                registry.delete(*item)
                registry.forget(*item)

        side_by_side(remove, sorted(pushed))
