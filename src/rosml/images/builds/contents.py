"""What is in an image that was pushed, attached to it: the list of its files, and its SBOM.

Both are made by the builder that built the image, which has its layers: nobody pulls an image to know what is in it.
"""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from pathlib import Path

from rosml.base.errors import RosmlError
from rosml.images.builds import base_images
from rosml.images.builds.push import write_excerpt
from rosml.images.image_set.model import ImageSet
from rosml.images.join import file_lists
from rosml.images.join.layers import platform
from rosml.images.matrix import names
from rosml.images.scan import packages, sbom
from rosml.machine import buildx, exported
from rosml.machine.services import Services
from rosml.registry.client import Registry
from rosml.registry.oci import Manifest

TARGET = "contents"
"""The bake target that says what is in an image."""

PACKAGES = "packages.json"
"""The packages of an image, as components/containerize/contents.py writes them."""

FILES = "files.gz"
"""The list of its files."""


def attach(
    services: Services,
    image_set: ImageSet,
    registry: Registry,
    repository: str,
    digest: str,
    say: Callable[[str], None],
) -> dict[str, str]:
    """Attaches to an image that was pushed what is in it, for each of its platforms.

    The builder mounts the image, which it has where it built it, and runs nothing of it: no emulation is needed.
    A manifest that has a list of files keeps it. The same packages give the same SBOM, by its digest.

    Args:
        services: the builder. image_set: for the system whose tools look into the image.
        registry: where the image is. repository: its path there. digest: of a manifest, or of an index.
        say: told what is going on, a line at a time.

    Returns:
        Digests of the SBOMs' artifacts, by those of the manifests.

    Raises:
        RosmlError: the image is not there; the build failed; the registry refuses.
    """
    found = {}
    for manifest in manifests(registry, repository, digest):
        place = f"{repository}@{manifest.digest}"
        say(f"list the packages and files of {place}")
        said, files = _made(services, image_set, registry, repository, manifest)
        if not registry.referrers(repository, manifest.digest, file_lists.ARTIFACT):
            registry.attach(repository, manifest.descriptor, file_lists.ARTIFACT, files, file_lists.MEDIA_TYPE)
        document = packages.cyclonedx(packages.read(said), f"{registry.host}/{place}")
        kind = sbom.MEDIA_TYPE, document, sbom.MEDIA_TYPE, sbom.FORMAT
        found[manifest.digest] = registry.attach(repository, manifest.descriptor, *kind)
    return found


def manifests(registry: Registry, repository: str, digest: str) -> list[Manifest]:
    """A manifest itself, or those of an index that are for a platform.

    Raises:
        RosmlError: the image is not there, or is none.
    """
    found = _there(registry, repository, digest)
    digests = [entry.digest for entry in found.members if "unknown" not in platform(entry.platform)]
    images = [_there(registry, repository, name) for name in dict.fromkeys(digests)] if found.is_index else [found]
    for image in images:
        if image.config is None:  # also of an index within an index
            text = f"{registry.host}/{repository}@{image.digest} is no image: it has no config"
            raise RosmlError(text, "check its name", exit_code=2)
    return images


def _there(registry: Registry, repository: str, digest: str) -> Manifest:
    found = registry.manifest(repository, digest)
    if found is None:
        raise RosmlError(f"{registry.host}/{repository}@{digest} is not there", "push it first")
    return found


def _made(
    services: Services, image_set: ImageSet, registry: Registry, repository: str, manifest: Manifest
) -> tuple[bytes, bytes]:
    """The packages and the list of files."""
    config = registry.config(repository, manifest)
    os_name = image_set.matrix.default.assembler
    base = base_images.reference(services, image_set.matrix.operating_systems, os_name)
    file = write_excerpt(services, image_set, TARGET)
    (services.state / "tmp").mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=services.state / "tmp") as folder:
        sets = (
            f"{TARGET}.output={exported.output(Path(folder) / 'left.tar')}",
            f"{TARGET}.platform={platform(config.facts)}",
            f"{TARGET}.contexts.described=docker-image://{registry.host}/{repository}@{manifest.digest}",
        )
        variables = {names.os_variable(os_name): f"docker-image://{base}"}
        short = manifest.digest.partition(":")[2][:12]
        buildx.run(services, buildx.Bake(TARGET, f"{TARGET}-{short}", file, sets, variables))
        exported.unpack(Path(folder) / "left.tar", Path(folder) / "left", limits=exported.OURS)
        said, data = (exported.read(Path(folder) / "left", name) for name in (PACKAGES, FILES))
    if not file_lists.unpacked(data):
        raise RosmlError(f"the list of the files of {repository}@{manifest.digest} is empty", "run it again")
    return said, data
