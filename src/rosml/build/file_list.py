"""Lists the files of an image that was pushed, and attaches the list to it."""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from pathlib import Path

from rosml.base.errors import RosmlError
from rosml.build.push import write_excerpt
from rosml.images.image_set import ImageSet
from rosml.join.file_lists import ARTIFACT, MEDIA_TYPE, unpacked
from rosml.join.layers import platform
from rosml.machine import base_images, buildx, exported
from rosml.machine.services import Services
from rosml.matrix import names
from rosml.registry.oci import Manifest, Registry

TARGET = "file-list"
"""The bake target that makes a list."""


def attach_files(
    services: Services,
    image_set: ImageSet,
    registry: Registry,
    repository: str,
    digest: str,
    say: Callable[[str], None],
) -> list[str]:
    """Lists the files of an image that was pushed, for each of its platforms, and attaches the lists to it.

    The builder mounts the image, which it has where it built it, and runs nothing of it: no emulation is needed.
    A manifest that has its list keeps it.

    Args:
        services: the builder. image_set: for the system whose tools make the list.
        registry: where the image is. repository: its path there. digest: of a manifest, or of an index.
        say: told what is going on, a line at a time.

    Returns:
        Digests of the lists' artifacts that were attached now.

    Raises:
        RosmlError: the image is not there; the build failed; the registry refuses.
    """
    attached = []
    for manifest in manifests(registry, repository, digest):
        if registry.referrers(repository, manifest.digest, ARTIFACT):
            continue
        say(f"list the files of {repository}@{manifest.digest}")
        data = _made(services, image_set, registry, repository, manifest)
        attached.append(registry.attach(repository, manifest.descriptor, ARTIFACT, data, MEDIA_TYPE))
    return attached


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


def _made(services: Services, image_set: ImageSet, registry: Registry, repository: str, manifest: Manifest) -> bytes:
    config = registry.config(repository, manifest)
    os_name = image_set.matrix.default.assembler
    base = base_images.reference(services, image_set.matrix.operating_systems, os_name)
    file = write_excerpt(services, image_set, TARGET)
    (services.state / "tmp").mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=services.state / "tmp") as folder:
        sets = (
            f"{TARGET}.output={exported.output(Path(folder) / 'left.tar')}",
            f"{TARGET}.platform={platform(config.facts)}",
            f"{TARGET}.contexts.listed=docker-image://{registry.host}/{repository}@{manifest.digest}",
        )
        variables = {names.os_variable(os_name): f"docker-image://{base}"}
        short = manifest.digest.partition(":")[2][:12]
        buildx.run(services, buildx.Bake(TARGET, f"{TARGET}-{short}", file, sets, variables))
        exported.unpack(Path(folder) / "left.tar", Path(folder) / "left", limits=exported.OURS)
        data = exported.read(Path(folder) / "left", "files.gz")
    if not unpacked(data):
        raise RosmlError(f"the list of the files of {repository}@{manifest.digest} is empty", "run it again")
    return data
