"""What a publishing run works on: images and parts on an architecture, and the steps that each of them needs."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from rosml.images.image_set.model import Image, ImageSet, Part

Kind = Literal["ros", "part", "joined"]
Step = Literal["build", "join", "test", "scan"]
Key = tuple[str, str]
"""Target and architecture."""

ABSENT = "the archive has no"
"""How the reason begins if a distribution cannot be built because its packages are not published."""

NO_SBOM = "it has no SBOM"
UNDESCRIBED = "it has no facts for apps that change their base"
"""If this is the only reason, an image or a part is described again and not built."""

ENDED = "ended"
"""How the reason begins if the tags of an image stay where they are, because its distribution is past its end of life."""

WAITING = "waiting for a builder"
ELSEWHERE = f"{WAITING} of its architecture"


@dataclass(frozen=True)
class Item:
    """An image or part on one architecture. `needs` has the bake targets of the ROS image below it and of its parts."""

    thing: Image | Part
    architecture: str
    needs: tuple[str, ...]

    @property
    def target(self) -> str:
        return self.thing.target

    @property
    def kind(self) -> Kind:
        """ROS images and parts are built; joined images are joined from them."""
        if isinstance(self.thing, Part):
            return "part"
        return "joined" if self.thing.stack else "ros"

    @property
    def repository(self) -> str:
        """The repository, without the registry's prefix."""
        return self.thing.repository

    @property
    def key(self) -> Key:
        return self.target, self.architecture

    @property
    def making(self) -> Step:
        """The step that makes it."""
        return "join" if self.kind == "joined" else "build"


@dataclass(frozen=True)
class Task:
    """The steps that an item needs."""

    item: Item
    steps: tuple[Step, ...] = ()  # in order; empty if there is nothing to do
    why: tuple[str, ...] = ()  # reasons for the first step
    hindered: str = ""  # why no step can be done here; empty if it can


def ros_images(image_set: ImageSet, image: Image) -> list[Image]:
    """The ROS images that an image stands on, lowest first, and the image itself if it is a ROS image."""
    chain = [] if image.stack else [image]
    while below := image_set.by_target.get(image.parent):
        chain.append(below)
        image = below
    return chain[::-1]
