"""Attaches its list of files, its SBOM and its facts to a pushed image.

The builder that built the image makes both: it has the layers already, so that nobody pulls an image to see its
content.
"""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from pathlib import Path

from rosml.base.errors import RosmlError
from rosml.images.builds import base_images
from rosml.images.builds.push import write_excerpt
from rosml.images.image_set.model import ImageSet
from rosml.images.join import facts, file_lists
from rosml.images.join.layers import platform
from rosml.images.matrix import names
from rosml.images.scan import packages, sbom
from rosml.machine import buildx, exported
from rosml.machine.services import Services
from rosml.registry.client import Registry
from rosml.registry.oci import Manifest

FORMAT = "facts.v1"
"""What is attached beside the SBOM and the list of files. With another one, all images are described again, without a build."""

TARGET = "contents"
"""The bake target that lists the content of an image."""

PACKAGES = "packages.json"
"""The packages of an image, written by components/containerize/contents.py."""

FILES = "files.gz"
"""The list of files of an image."""

FACTS = "facts.gz"
"""The facts of an image or of an app, written by components/containerize/facts.py."""

LISTS = ((FILES, file_lists.ARTIFACT, file_lists.MEDIA_TYPE), (FACTS, facts.ARTIFACT, facts.MEDIA_TYPE))
"""What is attached as it was written, with the types of its artifact and its layer."""


def attach(
    services: Services,
    image_set: ImageSet,
    registry: Registry,
    repository: str,
    digest: str,
    say: Callable[[str], None],
) -> dict[str, str]:
    """Attaches a list of files, facts and an SBOM to a pushed image, for each of its platforms.

    The builder mounts the image and runs nothing of it, so no emulation is needed. If a manifest has a list of files or
    facts, it keeps them. The same packages give an SBOM with the same digest.

    Args:
        services: the builder.
        image_set: names the operating system whose tools read the image.
        registry: of the image.
        repository: path of the image.
        digest: of a manifest or an index.
        say: prints a line of progress.

    Returns:
        Digests of the SBOMs' artifacts, by digest of the manifest.

    Raises:
        RosmlError: the image is missing; the build failed; the registry refuses.
    """
    found = {}
    for manifest in manifests(registry, repository, digest):
        place = f"{repository}@{manifest.digest}"
        say(f"list the packages and files of {place}")
        said = _made(services, image_set, registry, repository, manifest)
        for name, artifact, media_type in LISTS:
            if not registry.referrers(repository, manifest.digest, artifact):
                registry.attach(repository, manifest.descriptor, artifact, said[name], media_type)
        document = packages.cyclonedx(packages.read(said[PACKAGES]), f"{registry.host}/{place}")
        kind = sbom.MEDIA_TYPE, document, sbom.MEDIA_TYPE, sbom.FORMAT
        found[manifest.digest] = registry.attach(repository, manifest.descriptor, *kind)
    return found


def manifests(registry: Registry, repository: str, digest: str) -> list[Manifest]:
    """The manifest itself; or, of an index, the manifests for platforms.

    Raises:
        RosmlError: the image is missing, or the manifest is no image (exit code 2).
    """
    found = _there(registry, repository, digest)
    digests = [entry.digest for entry in found.members if "unknown" not in platform(entry.platform)]
    images = [_there(registry, repository, name) for name in dict.fromkeys(digests)] if found.is_index else [found]
    for image in images:
        if image.config is None:  # also if an index contains an index
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
) -> dict[str, bytes]:
    """The packages, the list of files and the facts of a manifest, by the name of their file."""
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
        buildx.run(services, buildx.Bake(TARGET, f"{TARGET}-{short}", file, sets, variables, shares=buildx.IMAGES))
        exported.unpack(Path(folder) / "left.tar", Path(folder) / "left", limits=exported.OURS)
        found = {name: exported.read(Path(folder) / "left", name) for name in (PACKAGES, FILES, FACTS)}
    if not file_lists.unpacked(found[FILES]):
        raise RosmlError(f"the list of the files of {repository}@{manifest.digest} is empty", "run it again")
    return found
