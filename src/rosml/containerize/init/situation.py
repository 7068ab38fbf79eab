"""What `rosml init` decides by: the matrix, the packages, the user's wishes and this machine; and how it asks."""

from __future__ import annotations

import datetime
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field

from rosml.containerize.init.packages import FolderScan
from rosml.images.image_set.model import Image, ImageSet
from rosml.images.matrix.model import Matrix

BY_ENV = ".env says so"
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
    """A question to the user.

    Attributes:
        read: turns an answer into a value, or raises RosmlError.
        answers: all possible ones, if they can be counted.
        reason: why a value is taken that was not proposed.
    """

    text: str
    read: Callable[[str], str]
    answers: Sequence[str] = ()
    reason: Callable[[str], str] = lambda _: BY_USER


Ask = Callable[[Question, Choice], str]
"""Asks the user, who may take the proposal. Returns the value that was read."""


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
    """What counts of this machine and of the folder's repository.

    Attributes:
        today: for ends of life.
        env: the variables of the folder's `.env`.
        hints: words among which are names of ROS distributions, the most telling first, and what has them.
        driver: the version of the NVIDIA driver; empty if unknown.
    """

    today: datetime.date
    env: Mapping[str, str] = field(default_factory=dict)
    hints: tuple[tuple[frozenset[str], str], ...] = ()
    nvidia: bool = False
    driver: str = ""


@dataclass(frozen=True)
class Situation:
    """All that a choice depends on, beside earlier choices."""

    image_set: ImageSet
    scan: FolderScan
    wishes: Wishes
    surroundings: Surroundings
    ask: Ask

    @property
    def matrix(self) -> Matrix:
        """The matrix of the image set."""
        return self.image_set.matrix

    def before(self, distribution: str) -> Image | None:
        """The base image that `.env` names, if it is of this distribution."""
        image = self.image_set.by_tag(self.surroundings.env.get("BASE_IMAGE", ""))
        return image if image and image.distribution == distribution else None

    def settle(self, question: Question, wish: str, proposal: Choice) -> Choice:
        """Takes the user's wish, or else asks."""
        value = question.read(wish) if wish else self.ask(question, proposal)
        return proposal if value == proposal.value and not wish else Choice(value, question.reason(value))

    def is_gpu(self, stack: str) -> bool:
        """Whether a stack computes on GPUs."""
        return bool(self.matrix.stacks[stack].cuda)

    @property
    def asks_for_gpu(self) -> bool:
        """Whether the user asks for one, or for a stack that needs one."""
        stack = self.wishes.stack
        return bool(self.wishes.gpu or (stack in self.matrix.stacks and self.is_gpu(stack)))
