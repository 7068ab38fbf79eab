"""The steps of a publishing run, in their order: a file for each, with one function that does it.

Each does what is missing, and nothing that was done before. No tag moves before the last step, and then only to an index of
images that passed. A scan, which not every run has, stands before the index.
"""

from __future__ import annotations

import math
import time
from collections.abc import Callable
from functools import partial

from rosml.images.publish.run import Run
from rosml.images.publish.steps import build, index, join, promote, test

STEPS: dict[str, Callable[[Run], object]] = {
    "build": build.build,
    "join": join.join,
    "test": test.test,
    "index": index.index,
    "promote": promote.promote,
}
"""What does each, by its name."""


def images(run: Run, minutes: float = math.inf) -> None:
    """Builds, joins and tests: each image is tested as soon as it is there, so that a run that ends early leaves images that
    can get their tags.

    Args:
        minutes: after which nothing more is begun. What is left waits for the next run.
    """
    run.deadline, run.on_made = time.monotonic() + 60 * minutes, partial(test.test_at_once, run)
    build.build(run)
    join.join(run)
    test.test(run)
