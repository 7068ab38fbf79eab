"""Short names of environments: `env:lerobot` is the environment lerobot for the Python of an image, beside it in its registry."""

from __future__ import annotations

import re
from collections.abc import Sequence

from rosml.base.errors import RosmlError
from rosml.base.problems import listed, some
from rosml.images.image_set import labels
from rosml.images.image_set.model import ENVIRONMENTS
from rosml.images.join import label_claims
from rosml.images.join.label_claims import LONGEST
from rosml.images.join.layers import Source
from rosml.images.join.transfer import Transfer
from rosml.images.matrix import names
from rosml.images.matrix.patterns import NAME
from rosml.registry import references
from rosml.registry.failures import Busy

KIND = f"{ENVIRONMENTS}:"


def environment(text: str) -> str:
    """The name in `env:NAME`; empty if a text is a reference."""
    return require(text.removeprefix(KIND)) if text.startswith(KIND) and "/" not in text else ""


def require(name: str) -> str:
    """The name of an environment itself. Raises a RosmlError if it is none."""
    if len(name) > LONGEST or not re.fullmatch(NAME, name):
        text = f"{name[:LONGEST]!r} is no name of an environment"
        raise RosmlError(text, "write small letters, digits and single hyphens, such as lerobot", exit_code=2)
    return name


def beside(host: str, repository: str) -> str:
    """The place of an image's neighbours: its registry and its path, without the last name."""
    return "/".join(filter(None, (host, repository.rpartition("/")[0])))


def find(transfer: Transfer, name: str, python: str, places: Sequence[str]) -> str:
    """The reference of the environment `name` for a Python, with its tag and its digest, in the first of these places that has it.

    Args:
        places: registries with a path, such as `ghcr.io/me/rosml`. Empty ones do not count.

    Raises:
        RosmlError: there is none, or a tag is of something else; Busy if a registry is too busy to say.
    """
    tag = names.environment_name(name, python)
    candidates = [f"{place}/{ENVIRONMENTS}:{tag}" for place in dict.fromkeys(places) if place]
    others, refused = set[str](), ""
    for candidate in candidates:
        where = references.parse(candidate)
        try:
            manifest = transfer.manifest(where)
            tags = [] if manifest else transfer.registries(where.host).tags(where.repository)
        except Busy:  # what another place has may be something else
            raise
        except RosmlError as error:  # the registry does not answer, or wants a log-in
            refused += f"; {error.message}"
            continue
        if manifest:
            require_environment(transfer.one(candidate, manifest), name)
            return f"{candidate}@{manifest.digest}"
        others |= {tag for tag in tags if re.fullmatch(rf"{name}-py3[0-9]+", tag)}
    instead = f"; there is {some(sorted(others))}" if others else ""
    text = f"there is no environment {name} for Python {python}: no {listed(candidates, 'or')}{instead}{refused}"
    remedy = f"make its lock with an image of that Python: rosml env add {name}; then: rosml env build {name}"
    raise RosmlError(text, f"{remedy}; or name an environment in full", exit_code=2)


def require_environment(image: Source, name: str) -> None:
    """Checks that an environment is what its tag, or a lock, says."""
    label_claims.require(image.labels, image.name)
    if (claim := image.labels.get(labels.ENVIRONMENT, "")) != name:
        text = f"{image.name} is {f'environment {claim}' if claim else 'no environment'}, and not {name}"
        raise RosmlError(text, f"build it again: rosml env build {name}", exit_code=2)
