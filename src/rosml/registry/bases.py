"""Images that a build starts from: which ones of an index a builder may take, and that none of them has ONBUILD.

A builder runs the instructions of ONBUILD itself. `ADD http://…` among them reads from the machine's own network, which the steps
of a build do not reach. So rosml starts from no image that has some.
"""

from __future__ import annotations

from collections.abc import Collection
from typing import TYPE_CHECKING

from rosml.base.errors import RosmlError
from rosml.base.problems import some
from rosml.registry import documents
from rosml.registry.documents import Platform, Settings
from rosml.registry.oci import Config, Manifest

if TYPE_CHECKING:
    from rosml.registry.client import Registry

FALLBACKS = {"386": "amd64", "arm": "arm64"}
"""Older architectures, with the one whose builders take their images if an index has no others."""

LONGEST = 100
"""The most characters of an instruction in a message."""


def require_no_triggers(settings: Settings | None, name: str) -> None:
    """Raises RosmlError if an image has ONBUILD. `name` is the user's name of the image."""
    if triggers := (settings and settings.OnBuild) or ():
        texts = [" ".join(text.split())[:LONGEST] for text in triggers]
        raise RosmlError(
            f"{name} has ONBUILD, which a builder runs itself, outside of the network of steps: {some(texts)}",
            "name an image without ONBUILD; one that you build on this image yourself has none",
            exit_code=2,
        )


def configs(
    registry: Registry, repository: str, manifest: Manifest, name: str, architectures: Collection[str] = ()
) -> list[tuple[Platform | documents.Config, Config]]:
    """The configs of the images that a builder may take, each with the platform of the index, or the config if there is none."""
    images: list[
        tuple[Platform | documents.Config, Config]
    ] = []  # an index may list several images for a platform, or say none
    if not manifest.is_index:
        config = registry.config(repository, manifest, name)
        images.append((config.facts, config))
    for entry in manifest.members:
        if not _may_be_taken(entry.platform or Platform(), architectures):
            continue
        if image := registry.manifest(repository, entry.digest):
            config = registry.config(repository, image, name)
            images.append((entry.platform or Platform(), config))
    for _, config in images:
        require_no_triggers(config.facts.config, name)
    return images


def _may_be_taken(platform: Platform, architectures: Collection[str]) -> bool:
    if platform.os == "unknown":  # an attestation of buildx
        return False
    architecture = platform.architecture
    if not architectures or not architecture:
        return True
    return architecture in architectures or FALLBACKS.get(architecture) in architectures
