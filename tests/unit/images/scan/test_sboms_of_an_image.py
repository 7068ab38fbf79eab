"""SBOMs that are attached to an image, by rosml and by others."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import replace

import pytest

from fakes.memory_registry import HOST, MemoryRegistry, put_image, sbom_of
from rosml.base import units
from rosml.base.errors import RosmlError
from rosml.images.scan import attached
from rosml.images.scan.sbom import FORMAT, LARGEST, MEDIA_TYPE

PATH = "me/robot"
OLDER = dict.fromkeys(FORMAT, "1")


class Image:
    """An image in a registry, to which SBOMs are attached."""

    def __init__(self) -> None:
        self.registry = MemoryRegistry()
        self.digest = put_image(self.registry, PATH, "amd64", {}, [b"layer"])

    def attach(self, content: bytes, annotations: Mapping[str, str] = FORMAT) -> str:
        manifest = self.registry.manifest(PATH, self.digest)
        assert manifest
        name: str = self.registry.attach(PATH, manifest.descriptor, MEDIA_TYPE, content, MEDIA_TYPE, annotations)
        return name

    def document(self, *names: str, digest: str = "") -> bytes:
        return sbom_of(f"{HOST}/{PATH}@{digest or self.digest}", names)

    def names(self) -> list[list[str]]:
        return [[item.name for item in sbom.packages] for sbom in self.read().sboms]

    def read(self) -> attached.Attached:
        return attached.read(self.registry, PATH, self.digest)


def test_the_newest_format_counts_and_an_older_one_if_there_is_no_other() -> None:
    image = Image()
    image.attach(image.document("old"), OLDER)
    assert image.names() == [["old"]]
    image.attach(image.document("new"))
    assert image.names() == [["new"]] and not image.read().ignored


def test_what_others_attached_is_said_and_does_not_count() -> None:
    image = Image()
    theirs = image.attach(image.document("theirs"), {})
    another = image.attach(image.document("copied", digest=f"sha256:{'0' * 64}"))
    broken = image.attach(b"<html>")
    ignored = {it.digest: it.why for it in image.read().ignored}
    assert ignored == {
        theirs: "somebody else attached it",
        another: "it is of another image",
        broken: ignored[broken],
    }
    assert "what is kept as an SBOM is none" in ignored[broken] and image.names() == []
    with pytest.raises(RosmlError, match=f"robot has no SBOM of rosml .*{min(ignored)} does not count: ") as caught:
        image.read().first("robot")
    assert caught.value.exit_code == 2
    image.attach(image.document("ours"))
    assert [item.name for item in image.read().first("robot").packages] == ["ours"]


def test_one_beyond_the_limit_is_not_downloaded() -> None:
    image = Image()
    name = image.attach(image.document("large"))
    manifest = image.registry.manifests[PATH][name]
    content = json.loads(json.dumps(manifest.content))
    content["layers"][0]["size"] = LARGEST + 1
    image.registry.manifests[PATH][name] = replace(manifest, content=content)
    image.registry.blobs[PATH].clear()
    [ignored] = image.read().ignored
    assert ignored.why == "it has 200.0 MB, and at most 200.0 MB are read"


def test_all_together_have_one_limit_and_a_large_one_hides_no_smaller_one() -> None:
    image = Image()
    documents = [image.document(*map(str, range(number))) for number in (1, 20, 30)]
    small, middle, large = map(image.attach, documents)
    limit = len(documents[0]) + len(documents[2])
    answer = attached.read(image.registry, PATH, image.digest, limit)
    assert {*answer.artifacts} == {small, middle} and {it.digest for it in answer.ignored} == {large}
    assert answer.ignored[0].why == f"at most {units.size(limit)} of SBOMs are read of an image, the smallest first"


def test_only_some_of_many_are_read() -> None:
    image = Image()
    for number in range(attached.MOST + 3):
        image.attach(image.document(f"package-{number}"), {})
    before = image.registry.reads
    ignored = image.read().ignored
    assert [it.why for it in ignored].count(f"only {attached.MOST} are read") == 3
    assert image.registry.reads - before == 2 + attached.MOST


def test_a_list_of_artifacts_is_enough_to_read_ours() -> None:
    image = Image()
    manifest = image.registry.manifest(PATH, image.digest)
    assert manifest
    name = attached.attach(image.registry, PATH, manifest.descriptor, image.document("ours"))
    before = image.registry.reads
    assert image.names() == [["ours"]]
    assert image.registry.reads - before == 2 + 1, "the list, and the SBOM"
    for annotation in ("", f"{image.digest} 3 more", f"{image.digest} {'9' * 16}"):
        damaged = {**FORMAT, attached.BLOB: annotation}
        artifact = image.registry.manifests[PATH][name]
        content = {**artifact.content, "annotations": damaged}
        image.registry.manifests[PATH][name] = replace(artifact, content=content)
        assert image.names() == [["ours"]], "it is read by its artifact"


def test_an_image_that_is_gone_has_none() -> None:
    image = Image()
    del image.registry.manifests[PATH][image.digest]
    assert image.read() == attached.Attached((), ())
