"""An add-on that is joined to a published image and to a published app, and a second add-on beside the first.

Each join goes into a new repository of the local registry, as the first one of a user does, with nothing read before. Everything is
in a namespace of its own. All but the app is removed at the end.
"""

from __future__ import annotations

import statistics
import subprocess
import sys
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

from bench import local
from rosml import ROOT
from rosml.base.errors import RosmlError
from rosml.base.terminal import show, table
from rosml.base.units import duration, size
from rosml.images.image_set.model import ImageSet
from rosml.images.join.joiner import Joiner
from rosml.machine.services import Services
from rosml.registry import references
from rosml.registry.client import Registries

NAMESPACE = "bench-addons"
FIRST, SECOND = "ros1-bookworm-core-onnx-cpu", "ros1-bookworm-core-triton-cpu"
"""The images that test the add-ons: they name the parts."""
SECONDS, BYTES = 1.0, 10_000
"""What a join may take."""
ROUNDS = 5
"""Joins of each kind, of which the median counts."""


@dataclass(frozen=True)
class Row:
    """What joins of a kind came to: the median of their seconds, and the bytes that one sends."""

    what: str
    seconds: float
    uploaded: int

    @property
    def beyond(self) -> list[str]:
        """What took more than it may."""
        limits = ((duration(self.seconds), self.seconds, SECONDS, duration(SECONDS)),
                  (size(self.uploaded), self.uploaded, BYTES, size(BYTES)))  # fmt: skip
        return [f"{self.what}: {shown}, and at most {most}" for shown, value, limit, most in limits if value > limit]


def print_table(rows: Sequence[Row]) -> None:
    """Prints the result."""
    printed = table(f"median of {ROUNDS} joins", "seconds", "sent", right=("seconds", "sent"))
    for row in rows:
        printed.add_row(row.what, duration(row.seconds), size(row.uploaded))
    show(printed)


def measure(services: Services, image_set: ImageSet, say: Callable[[str], None]) -> list[Row]:
    """Makes the base image, the parts and an app on it, unless they are there, and joins them.

    Raises:
        RosmlError: a build failed, or the registry does not answer.
    """
    for target in (FIRST, SECOND):
        say(f"make {target}, unless it is there")
        if subprocess.run([sys.executable, str(ROOT / "src"), "image", target], check=False).returncode:
            raise RosmlError(f"making {target} failed", f"see above; try it alone: ./rosml image {target}")
    app, _ = local.example(services, NAMESPACE, say)
    names = [
        [f"{services.registry}/rosml/part:{part}" for part in image_set.image(name).parts] for name in (FIRST, SECOND)
    ]
    return Bench(services, f"{services.registry}/{local.BASE}", app, names[0], names[1], say).measure()


@dataclass
class Bench:
    """One measurement.

    Attributes:
        services: the local registry.
        base, app: a published image, and an app on it.
        first, second: parts of two add-ons.
        say: tells what begins.
        pushed: repositories with the digests that are to be removed.
    """

    services: Services
    base: str
    app: str
    first: Sequence[str]
    second: Sequence[str]
    say: Callable[[str], None]
    pushed: set[tuple[str, str]] = field(default_factory=set)

    def measure(self) -> list[Row]:
        """Joins, and removes everything.

        Raises:
            RosmlError: the registry does not answer or refuses.
        """
        more = [part for part in self.second if part not in self.first]
        with (
            Registries(self.services.ca_bundle) as registries,
            local.cleaned(registries(self.services.registry), self.pushed, self.say),
        ):
            image = self._joins("an image gets an add-on", "image", self.base, self.first)
            both = self._joins("the result gets a second one", "both", f"{self._place}/image-0:latest", more)
            return [image, both, self._joins("an app gets an add-on", "app", self.app, self.first)]

    @property
    def _place(self) -> str:
        return f"{self.services.registry}/{NAMESPACE}"

    def _joins(self, what: str, name: str, image: str, parts: Sequence[str]) -> Row:
        """Joins the same several times, each time with new connections and into a new repository."""
        self.say(what)
        seconds, uploaded = list[float](), 0
        for number in range(ROUNDS):
            target = f"{self._place}/{name}-{number}:latest"
            started = time.monotonic()
            with Registries(self.services.ca_bundle) as registries, Joiner(registries) as joiner:
                joined = joiner.join(image, parts, target)
            seconds.append(time.monotonic() - started)
            uploaded = max(uploaded, joined.uploaded)
            repository = references.parse(target).repository
            self.pushed.update((repository, digest) for digest in (joined.digest, *joined.manifests.values()))
        return Row(what, statistics.median(seconds), uploaded)
