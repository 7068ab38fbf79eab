"""Environments on an image of the image set: whether their locks go with it, and an image with both in the local registry."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import partial
from pathlib import Path

from rosml.base.errors import RosmlError
from rosml.base.problems import listed
from rosml.images.environments import build
from rosml.images.environments.lock import Lock
from rosml.images.image_set.labels import PREFIX
from rosml.images.image_set.model import Image, ImageSet, tags_of
from rosml.images.join import short_names
from rosml.images.join.environments import AGAIN, misfit
from rosml.images.join.joiner import Joiner, JoinReport
from rosml.images.matrix.names import environments_end
from rosml.images.scan import together
from rosml.machine.services import Services
from rosml.registry import references
from rosml.registry.client import Registries


def read(image: Image, names: Iterable[str], folder: Path, architectures: Iterable[str]) -> dict[str, list[Lock]]:
    """The locks of environments by their names. Raises a RosmlError if one does not go with the image, or if that has one already."""
    if image.environment:
        plain = image.target.removesuffix(environments_end([image.environment]))
        text = f"{image.target} has the environment {image.environment} already"
        raise RosmlError(text, f"name {plain}, and each environment with --env", exit_code=2)
    every = {
        name: build.read(folder / short_names.require(name), name, architectures, image.python)[0] for name in names
    }
    labels = {f"{PREFIX}{name}": text for name, text in {**image.versions, "python": image.python}.items()}
    for name, locks in every.items():
        if reason := misfit(build.labels_of(locks), labels, image.target):
            raise RosmlError(reason, AGAIN.format(name, image.target), exit_code=2)
    if len(tags_of(image)[0]) + len(environments_end(every)) > references.LONGEST_TAG:
        text = f"a tag has at most {references.LONGEST_TAG} characters, and that of {image.target} with {listed([*every])} has more"
        raise RosmlError(
            text, "name fewer, and join the others: rosml join IMAGE env:NAME --tag REFERENCE", exit_code=2
        )
    return every


def join(
    services: Services,
    image_set: ImageSet,
    reference: str,
    every: Mapping[str, Sequence[Lock]],
    say: Callable[[str], None],
) -> JoinReport:
    """Builds environments beside an image in the local registry, and joins them to it under a tag of their own."""
    prefix = reference.rpartition("/")[0]
    built = [build.publish(services, image_set, locks, prefix, say).reference for locks in every.values()]
    with (
        Registries(services.ca_bundle) as registries,
        Joiner(registries, say=say, describe=partial(together.attach, registries, say)) as joiner,
    ):
        return joiner.join(reference, built, f"{reference}{environments_end(every)}")
