"""Base images for a machine that does not reach Docker Hub: `python tools/offline`, the command in services.json."""

from __future__ import annotations

import re


def debian_suite(image: str) -> str:
    """``docker.io/library/debian:bookworm`` -> ``bookworm``; empty for an image that is not Debian's."""
    match = re.fullmatch(r"(?:docker\.io/)?(?:library/)?debian:([a-z]+)", image)
    return match[1] if match else ""


def missing(image: str) -> str:
    """Why an image is not available without Docker Hub; empty if it is in another registry, or Debian's."""
    if not image.startswith("docker.io/") or debian_suite(image):
        return ""
    return f"{image} is on Docker Hub, which does not answer"
