"""What goes onto images beside a framework: add-ons and environments."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field

from rosml.images.matrix.patterns import Facts, Name, Names, OsName, Target
from rosml.images.matrix.sizes import Size


class TaggedImages(Facts):
    """The images with an add-on that get tags."""

    distributions: Names = Field(description="names from distributions")
    components: Names = Field(description="names from components")
    stacks: Names = Field(description="names from stacks; those that lack the add-on have none")


class AddOn(Facts):
    """Parts that go onto any image of a stack. In each stack and each Python, images that get no tag test it."""

    parts: Names = Field(description="names from parts; no other add-on has them")
    beside: tuple[Name, ...] = Field(
        default=(), description="frameworks beside which it is tested as well, if a stack has both"
    )
    systems: dict[Name, tuple[OsName, ...]] = Field(
        default={}, description="stack -> the operating systems on which it works; all, if a stack is not named"
    )
    tags: TaggedImages | None = Field(default=None, description="the images with it that get tags; none if left out")


class EnvironmentEntry(Facts):
    """An environment of Python packages beside ROS. Its locks are in environments/NAME: `rosml env add` makes them."""

    images: Annotated[tuple[Target, ...], Field(min_length=1)] = Field(
        description="images with a framework: each is there once more with the environment, and with its own tags"
    )
    architectures: Annotated[Names, Field(min_length=1)] = Field(description="those that it has locks for")
    tests: tuple[Name, ...] = Field(
        default=(), description="names of files in tests/structure that must hold in images with it"
    )
    disk: Size = Field(description="the size of its files")
