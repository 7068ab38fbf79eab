"""Which payloads were assembled, for the state "verified by stand-in" in README.md and in the catalogue.

The steps that install ROS's packages run against stand-ins for all components of every distribution with an apt source:
tests/e2e/test_apt_source.py, which tests/unit/test_catalogue.py holds to that.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING

from rosml import ROOT
from rosml.errors import RosmlError
from rosml.expand import Catalogue, Image

if TYPE_CHECKING:  # imports the catalogue, which imports this module
    from rosml.built import Built

DIGESTS = "docs/digests.md"
BUILT = "docs/built.json"

Assembled = frozenset[tuple[str, str]]
"""Payloads by name and platform."""

_ROW = re.compile(r"^\| `([^`]+)` \| (linux/[^ |]+) \| `sha256:", re.MULTILINE)


def assembled(catalogue: Catalogue, built: Iterable[Built], folder: Path = ROOT) -> Assembled:
    """Payloads that were assembled: those that docs/digests.md lists, and those of images that were built, on the first
    platform of each. A record of payloads that have changed since says nothing of today's.

    Args:
        catalogue: the images. built: which of them were built. folder: a checkout; one without that page lists none.

    Raises:
        RosmlError: that page is damaged, and would take payloads from the tables in silence.
    """
    return frozenset({*_listed(folder / DIGESTS), *_joined(catalogue, built)})


def _listed(file: Path) -> list[tuple[str, str]]:
    remedy = f"git checkout {DIGESTS}"
    try:
        found = _ROW.findall(file.read_text(encoding="utf-8"))
    except FileNotFoundError:
        return []
    except UnicodeDecodeError:
        raise RosmlError(f"{DIGESTS} is not UTF-8", remedy) from None
    if not found:
        raise RosmlError(f"{DIGESTS} lists no payload", remedy)
    return [(name, platform) for name, platform in found]


def _joined(catalogue: Catalogue, built: Iterable[Built]) -> Iterator[tuple[str, str]]:
    for item in built:
        image = catalogue.by_target.get(item.target)
        if image and not item.outdated:
            yield from ((part, image.platforms[0]) for part in image.parts)


def lacking(image: Image, known: Assembled) -> list[str]:
    """Payloads of an image that nobody has assembled: `torch-cu121-py38 for linux/amd64`."""
    wanted = ((part, platform) for part in image.parts for platform in image.platforms)
    return [f"{part} for {platform}" for part, platform in wanted if (part, platform) not in known]
