"""The steps of a publishing run, in their order: a file for each step, with one function.

Each step does only what is missing. No tag moves before the last step, and then only to an index of images that passed.
If a run has a scan, the scan comes before the index.
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
"""The function of each step, by name."""


def images(run: Run, minutes: float = math.inf) -> None:
    """Builds, joins and tests, each image as soon as it is finished: if a run ends early, the tested ones can get their tags."""
    run.deadline, run.on_made = time.monotonic() + 60 * minutes, partial(test.test_at_once, run)
    build.build(run)
    join.join(run)
    test.test(run)
