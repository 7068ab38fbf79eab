"""What every client of a registry does, as calls with assertions: imitations of a registry and the real one are held to it.

Each call gets a client and a repository of its own that is not there yet.
"""

from __future__ import annotations

import json
from collections.abc import Callable

import pytest

from rosml.base.errors import RosmlError
from rosml.registry import oci
from rosml.registry.client import Registry

KIND, OTHER = "application/vnd.example.one", "application/vnd.example.two"
NOWHERE = f"sha256:{'0' * 64}"

Call = Callable[[Registry, str], None]
CALLS: dict[str, Call] = {}


def call(function: Call) -> Call:
    """Adds a call to the set."""
    CALLS[function.__name__] = function
    return function


def image(client: Registry, repository: str, text: str, tag: str = "") -> str:
    """Puts an image of one small layer, under a tag if there is one; gives its digest."""
    config, layer = json.dumps({"os": "linux", "architecture": "amd64"}).encode(), text.encode()
    for data in (config, layer):
        client.put_blob(repository, data)
    content = {
        "schemaVersion": 2,
        "mediaType": oci.IMAGE,
        "config": oci.descriptor(oci.CONFIG, config),
        "layers": [oci.descriptor("application/vnd.oci.image.layer.v1.tar", layer)],
    }
    return client.put_manifest(repository, tag, content, oci.IMAGE)


def attach(client: Registry, repository: str, subject: str, kind: str, text: str) -> str:
    """Attaches an artifact to an image; gives its digest."""
    manifest = client.manifest(repository, subject)
    assert manifest
    return client.attach(repository, manifest.descriptor, kind, text.encode(), "text/plain", {"said": text})


def attached(client: Registry, repository: str, subject: str, kind: str = "") -> list[str]:
    """Digests of what is attached to an image, sorted."""
    return sorted(item["digest"] for item in client.referrers(repository, subject, kind))


@call
def an_empty_place(client: Registry, repository: str) -> None:
    assert client.manifest(repository, "latest") is None and client.manifest(repository, NOWHERE) is None
    assert client.head(repository, "latest") == "" == client.head(repository, NOWHERE)
    assert client.tags(repository) == []
    assert client.referrers(repository, NOWHERE) == []


@call
def an_absent_blob(client: Registry, repository: str) -> None:
    with pytest.raises(RosmlError):
        client.blob(repository, NOWHERE)


@call
def a_blob(client: Registry, repository: str) -> None:
    digest = client.put_blob(repository, b"some bytes")
    assert digest == oci.digest_of(b"some bytes")
    assert client.blob(repository, digest) == b"some bytes"
    assert client.put_blob(repository, b"some bytes") == digest


@call
def an_image_under_a_tag(client: Registry, repository: str) -> None:
    digest = image(client, repository, "one", "latest")
    for reference in ("latest", digest):
        manifest = client.manifest(repository, reference)
        assert manifest and (manifest.digest, manifest.media_type, manifest.is_index) == (digest, oci.IMAGE, False)
        assert manifest.size > 100 and manifest.content["layers"][0]["size"] == 3
        assert client.head(repository, reference) == digest
    assert client.tags(repository) == ["latest"]


@call
def an_image_without_a_tag(client: Registry, repository: str) -> None:
    digest = image(client, repository, "one")
    assert client.head(repository, digest) == digest
    assert client.tags(repository) == []


@call
def an_image_by_its_digest(client: Registry, repository: str) -> None:
    digest = image(client, repository, "one")
    manifest = client.manifest(repository, digest)
    assert manifest
    assert client.put_manifest(repository, digest, manifest.content, oci.IMAGE) == digest
    assert client.tags(repository) == []


@call
def a_tag_that_is_put_again_moves(client: Registry, repository: str) -> None:
    one, two = image(client, repository, "one", "latest"), image(client, repository, "two", "latest")
    assert client.head(repository, "latest") == two != one
    assert client.head(repository, one) == one, "the image before it stays"


@call
def an_index(client: Registry, repository: str) -> None:
    digest = image(client, repository, "one")
    manifest = client.manifest(repository, digest)
    assert manifest
    member = {**manifest.descriptor, "platform": {"os": "linux", "architecture": "amd64"}}
    content = {"schemaVersion": 2, "mediaType": oci.INDEX, "manifests": [member], "annotations": {"a": "b"}}
    name = client.put_manifest(repository, "latest", content, oci.INDEX)
    index = client.manifest(repository, "latest")
    assert index and index.is_index and index.digest == name
    assert (index.content["manifests"], index.content["annotations"]) == ([member], {"a": "b"})


@call
def all_tags(client: Registry, repository: str) -> None:
    digest = image(client, repository, "one")
    names = [f"v{number:03}" for number in range(30)]
    for name in names:
        client.tag(repository, digest, name)
    assert sorted(client.tags(repository)) == names


@call
def a_tag_moves(client: Registry, repository: str) -> None:
    one, two = image(client, repository, "one", "latest"), image(client, repository, "two", "other")
    client.tag(repository, two, "latest")
    assert client.head(repository, "latest") == two
    client.tag(repository, one, "latest")
    assert client.head(repository, "latest") == one
    assert sorted(client.tags(repository)) == ["latest", "other"]


@call
def a_tag_to_nothing(client: Registry, repository: str) -> None:
    image(client, repository, "one", "latest")
    with pytest.raises(RosmlError, match="is not there"):
        client.tag(repository, NOWHERE, "latest")


@call
def a_manifest_is_deleted_with_its_tags(client: Registry, repository: str) -> None:
    digest, other = image(client, repository, "one", "latest"), image(client, repository, "two", "other")
    client.tag(repository, digest, "again")
    client.delete(repository, digest)
    assert client.manifest(repository, digest) is None and client.head(repository, "latest") == ""
    assert client.tags(repository) == ["other"] and client.head(repository, "other") == other


@call
def a_tag_is_deleted_alone(client: Registry, repository: str) -> None:
    digest = image(client, repository, "one", "latest")
    client.tag(repository, digest, "other")
    client.delete(repository, "latest")
    assert client.head(repository, "latest") == "" and client.tags(repository) == ["other"]
    assert client.head(repository, "other") == digest == client.head(repository, digest)


@call
def the_last_tag_is_deleted(client: Registry, repository: str) -> None:
    digest = image(client, repository, "one", "latest")
    client.delete(repository, "latest")
    assert client.tags(repository) == [] and client.head(repository, digest) == digest


@call
def nothing_is_deleted_without_an_error(client: Registry, repository: str) -> None:
    client.delete(repository, NOWHERE)
    client.delete(repository, "latest")
    digest = image(client, repository, "one", "other")
    client.delete(repository, NOWHERE)
    client.delete(repository, "latest")
    client.delete(repository, digest)
    client.delete(repository, digest)
    assert client.tags(repository) == []


@call
def what_nothing_leads_to_is_discarded(client: Registry, repository: str) -> None:
    digest = image(client, repository, "one")
    for _ in range(2):  # the second time it is gone
        client.discard(repository, digest)
        assert client.head(repository, digest) == ""


@call
def what_is_attached(client: Registry, repository: str) -> None:
    subject = image(client, repository, "one", "latest")
    assert attached(client, repository, subject) == []
    one, two = (attach(client, repository, subject, kind, "x") for kind in (KIND, OTHER))
    assert attached(client, repository, subject) == sorted((one, two))
    assert attached(client, repository, subject, KIND) == [one]
    assert attached(client, repository, subject, "application/vnd.example.three") == []
    (item,) = client.referrers(repository, subject, OTHER)
    assert item["artifactType"] == OTHER
    manifest = client.manifest(repository, one)
    assert (
        manifest
        and manifest.content["subject"]["digest"] == subject
        and manifest.content["annotations"] == {"said": "x"}
    )
    assert client.blob(repository, manifest.content["layers"][0]["digest"]) == b"x"


@call
def the_same_is_attached_once(client: Registry, repository: str) -> None:
    subject = image(client, repository, "one", "latest")
    one, again = (attach(client, repository, subject, KIND, "x") for _ in range(2))
    assert one == again and attached(client, repository, subject) == [one]


@call
def what_was_attached_is_forgotten(client: Registry, repository: str) -> None:
    subject = image(client, repository, "one")
    one = attach(client, repository, subject, KIND, "x")
    client.delete(repository, subject)
    client.delete(repository, one)
    client.forget(repository, subject)
    assert attached(client, repository, subject) == []
    assert client.tags(repository) == []
