"""The steps of a publishing run, in their order. A scan, which not every run has, stands before the index."""

from __future__ import annotations

from collections.abc import Callable

from rosml.images.publish.pipeline import Pipeline
from rosml.images.publish.promote import Promotion

STEPS: dict[str, Callable[[Pipeline], object]] = {
    "build": Pipeline.build,
    "join": Pipeline.join,
    "test": Pipeline.test,
    "index": Pipeline.index,
    "promote": lambda run: Promotion(run).run(),
}
"""What does each, by its name."""
