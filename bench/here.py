"""Where measurements build: with this checkout's services, in a namespace of their own in the local registry."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field

from rosml.images.builds import base_images
from rosml.images.builds.variables import variables
from rosml.images.image_set.model import Image, ImageSet
from rosml.machine.services import Services


@dataclass(frozen=True)
class Here:
    """This checkout's services, all that the matrix describes, who is told what is going on, and the namespace."""

    services: Services
    image_set: ImageSet
    say: Callable[[str], None]
    namespace: str
    architecture: str = field(default_factory=base_images.native_architecture)

    @property
    def prefix(self) -> str:
        """Of references: the registry and the namespace."""
        return f"{self.services.registry}/{self.namespace}"

    def variables(self, image: Image) -> dict[str, str]:
        """Variables of the bake file for an image."""
        return variables(self.services, self.image_set, image, self.architecture, self.prefix, self.say)
