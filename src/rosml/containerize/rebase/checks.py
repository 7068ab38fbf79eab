"""What speaks against another base image: facts of both, without a look into a layer."""

from __future__ import annotations

from rosml.base.errors import RosmlError
from rosml.containerize.rebase.image import AGAIN
from rosml.images.image_set.labels import PREFIX
from rosml.images.join.layers import Source

SAME = {"distribution": "ROS distribution", "os": "system", "python": "Python", "ros": "generation of ROS"}
"""The labels that the old and the new base image must have in common, by the words for people."""


def require_fit(app: Source, base: Source) -> None:
    """Checks that a base image is of the app's kind.

    Raises:
        RosmlError: it is not (exit code 2).
    """
    for name, words in SAME.items():
        old, new = (source.labels.get(PREFIX + name, "") for source in (app, base))
        if not new and not old:
            continue
        if not new:
            text = f"{base.name} does not say which {words} it has: it is no image of rosml with ROS"
            raise RosmlError(text, "name one, such as ros:jazzy-base", exit_code=2)
        if old != new:
            text = f"{app.name} was built on {words} {old or 'unknown'}, and {base.name} has {new}"
            raise RosmlError(text, f"name a base image with {old or 'the same'}; or {AGAIN}", exit_code=2)
