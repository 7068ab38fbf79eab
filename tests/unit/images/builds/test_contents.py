"""What is attached to pushed images: lists of files, facts and SBOMs, as one call of the builder lists them."""

from __future__ import annotations

import gzip
import json
from pathlib import Path

import pytest

from fakes import archives
from fakes.http_registry import LocalRegistry
from rosml.base.errors import RosmlError
from rosml.images.builds import contents
from rosml.images.image_set.model import ImageSet
from rosml.images.join import facts, file_lists
from rosml.images.scan import sbom
from rosml.machine import buildx
from rosml.machine.services import Services
from rosml.registry.client import Registry
from tests.e2e.parts import part, ros

PACKAGES = '{"system": {"name": "debian", "version": "12"}, "apt": [], "python": [], "ros": []}'
TYPES = (file_lists.ARTIFACT, facts.ARTIFACT, sbom.MEDIA_TYPE)


def attach(
    server: LocalRegistry, folder: Path, image_set: ImageSet, monkeypatch: pytest.MonkeyPatch, files: bytes
) -> int:
    """Attaches what a builder lists of a ROS image and a part. Returns how many calls of the builder that took."""
    calls: list[buildx.Bake] = []

    def run_all(_services: object, call: buildx.Bake) -> None:
        calls.append(call)
        listing = {contents.PACKAGES: PACKAGES.encode(), contents.FILES: gzip.compress(files), contents.FACTS: b"facts"}
        for output in (word.partition("dest=")[2] for word in call.sets if ".output=" in word):
            archives.write(Path(output), listing)

    monkeypatch.setattr(buildx, "run_all", run_all)
    with Registry(server.address) as registry:
        images = [("me/ros", ros(unlisted=True)), ("me/part", part("torch", unlisted=True))]
        pushed = [(repository, image.put_manifest(registry, repository)[0]) for repository, image in images]
        sboms = contents.attach(Services.load(folder, required=False), image_set, registry, pushed, lambda line: None)
        assert sboms.keys() == {digest for _, digest in pushed}
        for repository, digest in pushed:
            attached = [[entry["digest"] for entry in registry.referrers(repository, digest, kind)] for kind in TYPES]
            assert [len(digests) for digests in attached] == [1, 1, 1] and attached[2] == [sboms[digest]]
            artifact = registry.manifest(repository, sboms[digest])
            assert artifact
            about = json.loads(registry.part(repository, artifact.layers[0]))["metadata"]
            assert about["manufacturer"] == {"url": [image_set.matrix.source]}, "who publishes it"
    return len(calls)


def test_images_are_listed_by_one_call_and_keep_their_lists(
    server: LocalRegistry, tmp_path: Path, small: ImageSet, monkeypatch: pytest.MonkeyPatch
) -> None:
    for files in (b"usr/bin/a\n", b"usr/bin/b\n"):
        assert attach(server, tmp_path, small, monkeypatch, files) == 1


def test_an_empty_list_of_files_is_an_error(
    server: LocalRegistry, tmp_path: Path, small: ImageSet, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It would let any other image's files be hidden."""
    with pytest.raises(RosmlError, match=r"the list of the files of me/ros@sha256:[0-9a-f]+ is empty"):
        attach(server, tmp_path, small, monkeypatch, b"")
