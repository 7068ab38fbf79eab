"""The steps of a publishing run by their names, as commands call them."""

from __future__ import annotations

from rosml.publish.pipeline import Pipeline
from rosml.publish.promote import Promotion

STEPS = ("build", "join", "test", "index", "promote")


def do(run: Pipeline, step: str) -> None:
    """Runs a step."""
    if step == "promote":
        Promotion(run).run()
    else:
        getattr(run, step)()
