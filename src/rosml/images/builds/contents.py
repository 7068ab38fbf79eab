"""Attaches lists of files, SBOMs and facts to pushed images. The builder lists them: it has the layers already."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

from rosml.base import files
from rosml.base.errors import RosmlError
from rosml.images.bake import bake_file, hcl
from rosml.images.bake.targets import CONTENTS
from rosml.images.builds import base_images
from rosml.images.image_set.model import ImageSet
from rosml.images.join import facts, file_lists
from rosml.images.join.layers import platform
from rosml.images.matrix import names
from rosml.images.scan import attached, cyclonedx, packages
from rosml.machine import buildx, exported
from rosml.machine.services import Services
from rosml.registry.client import Registry
from rosml.registry.oci import Manifest

FORMAT = "sbom.v3"
"""What is attached beside the SBOM and the list of files. With another one, all images are described again, without a build."""

PACKAGES = "packages.json"
"""The packages of an image, written by components/containerize/contents.py."""

FILES = "files.gz"

FACTS = "facts.gz"
"""The facts of an image or of an app, written by components/containerize/facts.py."""

LISTS = ((FILES, file_lists.ARTIFACT, file_lists.MEDIA_TYPE), (FACTS, facts.ARTIFACT, facts.MEDIA_TYPE))
"""What is attached as it was written, with the types of its artifact and its layer."""


def attach(
    services: Services,
    image_set: ImageSet,
    registry: Registry,
    images: Sequence[tuple[str, str]],  # the repository of each, and the digest of its manifest or index
    say: Callable[[str], None],
) -> dict[str, str]:
    """Attaches what one call of the builder lists of images, which it only mounts. Returns the digests of SBOMs, by that of the manifest."""
    listed = [(repository, item) for repository, digest in images for item in manifests(registry, repository, digest)]
    for repository, manifest in listed:
        say(f"list the packages and files of {repository}@{manifest.digest}")
    sboms = {}
    for (repository, manifest), listing in zip(listed, _listings(services, image_set, registry, listed), strict=True):
        for name, artifact, media_type in LISTS:
            if not registry.referrers(repository, manifest.digest, artifact):
                registry.attach(repository, manifest.descriptor, artifact, listing[name], media_type)
        image = f"{registry.host}/{repository}@{manifest.digest}"
        created = cyclonedx.created(registry.config(repository, manifest).facts)
        home = image_set.matrix.source or ""
        document = cyclonedx.document(packages.read(listing[PACKAGES]), image, created, home=home)
        sboms[manifest.digest] = attached.attach(registry, repository, manifest.descriptor, document)
    return sboms


def manifests(registry: Registry, repository: str, digest: str) -> list[Manifest]:
    """The manifest itself; or, of an index, the manifests for platforms."""
    target = _require(registry, repository, digest)
    digests = [entry.digest for entry in target.members if "unknown" not in platform(entry.platform)]
    images = [_require(registry, repository, name) for name in dict.fromkeys(digests)] if target.is_index else [target]
    for image in images:
        if image.config is None:  # also if an index contains an index
            text = f"{registry.host}/{repository}@{image.digest} is no image: it has no config"
            raise RosmlError(text, "check its name", exit_code=2)
    return images


def _require(registry: Registry, repository: str, digest: str) -> Manifest:
    manifest = registry.manifest(repository, digest)
    if manifest is None:
        raise RosmlError(f"{registry.host}/{repository}@{digest} is not there", "push it first")
    return manifest


def _listings(
    services: Services, image_set: ImageSet, registry: Registry, images: Sequence[tuple[str, Manifest]]
) -> list[dict[str, bytes]]:
    """The packages, the list of files and the facts of each image, by the name of their file."""
    os_name = image_set.matrix.default.assembler
    base = base_images.reference(services, image_set.matrix.operating_systems, os_name)
    variables = {names.os_variable(os_name): f"docker-image://{base}"}
    targets = [f"{CONTENTS}-{manifest.digest.partition(':')[2][:12]}" for _, manifest in images]
    file = services.state / "bake" / f"{targets[0]}.hcl"
    file.parent.mkdir(parents=True, exist_ok=True)
    blocks = [hcl.block("target", target, {"inherits": [CONTENTS]}) for target in dict.fromkeys(targets)]
    files.write(file, "\n".join([bake_file.excerpt(image_set, [CONTENTS]), *blocks]))
    with services.temporary_folder() as folder:
        sets = []
        for target, (repository, manifest) in zip(targets, images, strict=True):
            config = registry.config(repository, manifest)
            sets += [
                f"{target}.output={exported.output(Path(folder, f'{target}.tar'))}",
                f"{target}.platform={platform(config.facts)}",
                f"{target}.contexts.described=docker-image://{registry.host}/{repository}@{manifest.digest}",
            ]
        call = buildx.Bake(targets[0], targets[0], file, sets, variables, shares=buildx.IMAGES, beside=targets[1:])
        buildx.run_all(services, call)
        return [
            _listing(Path(folder, target), f"{repository}@{manifest.digest}")
            for target, (repository, manifest) in zip(targets, images, strict=True)
        ]


def _listing(folder: Path, image: str) -> dict[str, bytes]:
    exported.unpack(folder.with_name(f"{folder.name}.tar"), folder, limits=exported.OURS)
    listing = {name: exported.read(folder, name) for name in (PACKAGES, FILES, FACTS)}
    if not file_lists.unpacked(listing[FILES]):
        raise RosmlError(f"the list of the files of {image} is empty", "run it again")
    return listing
