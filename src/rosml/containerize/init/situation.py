"""What `rosml init` decides by: the matrix, the packages, the user's wishes and this machine; and how it asks."""

from __future__ import annotations

import datetime
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field

from rosml.containerize.init.packages import FolderScan
from rosml.images.image_set.model import Image, ImageSet
from rosml.images.matrix.model import Matrix

BY_ENV = ".env says so"
BY_LOCK = "the lock file is of it"
BY_USER = "you ask for it"

Note = tuple[str, str]
"""A sentence for the user, and its remedy."""


@dataclass(frozen=True)
class Choice:
    """A value, and why it is proposed or taken, in one clause."""

    value: str
    reason: str


@dataclass(frozen=True)
class Question:
    """A question. `read` raises RosmlError for a wrong answer; `reason` says why a value is taken that was not proposed."""

    text: str
    read: Callable[[str], str]
    answers: Sequence[str] = ()
    reason: Callable[[str], str] = lambda _: BY_USER


Ask = Callable[[Question, Choice], str]
"""Asks the user, who may take the proposal. Returns the value that was read."""


def settle(ask: Ask, question: Question, wish: str, proposal: Choice) -> Choice:
    value = question.read(wish) if wish else ask(question, proposal)
    return proposal if value == proposal.value and not wish else Choice(value, question.reason(value))


@dataclass(frozen=True)
class Wishes:
    """What the user says; empty, or None for `gpu`, if nothing."""

    distribution: str = ""
    component: str = ""
    framework: str = ""
    stack: str = ""
    gpu: bool | None = None
    command: str = ""


@dataclass(frozen=True)
class Surroundings:
    """This machine and the folder's repository. `hints` are words that may name a distribution, the most telling first, with their source.
    `locked` is the base image of its lock file."""

    today: datetime.date
    env: Mapping[str, str] = field(default_factory=dict)
    hints: tuple[tuple[frozenset[str], str], ...] = ()
    nvidia: bool = False
    driver: str = ""
    locked: str = ""


@dataclass(frozen=True)
class Situation:
    image_set: ImageSet
    scan: FolderScan
    wishes: Wishes
    surroundings: Surroundings
    ask: Ask

    @property
    def matrix(self) -> Matrix:
        return self.image_set.matrix

    def before(self, distribution: str) -> Image | None:
        """The base image that `.env` or the lock file names, if it is of this distribution."""
        image = self.image_set.by_tag(self.surroundings.env.get("BASE_IMAGE") or self.surroundings.locked)
        return image if image and image.distribution == distribution else None

    @property
    def by_repository(self) -> str:
        """Why a choice follows `before`."""
        return BY_ENV if self.surroundings.env.get("BASE_IMAGE") else BY_LOCK

    def is_gpu(self, stack: str) -> bool:
        return bool(self.matrix.stacks[stack].cuda)

    @property
    def asks_for_gpu(self) -> bool:
        stack = self.wishes.stack
        return bool(self.wishes.gpu or (stack in self.matrix.stacks and self.is_gpu(stack)))
