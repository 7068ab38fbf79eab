"""The records' own repository: an entry takes the place of the one before, which goes where the registry deletes; what a
registry refuses, and publishers who write at the same time, harm no entry. What entries say: test_pipeline.py."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from fakes.http_registry import StandIn, standing_in
from fakes.memory_registry import DAY, IMAGE, LATER, NEXT, PREFIX, MemoryRegistry, Publisher, publisher
from fakes.stubs import services
from rosml.images.image_set.model import ImageSet
from rosml.images.records.store import ANNOTATION, Entry, Records, tag
from rosml.registry import oci
from rosml.registry.client import Registry
from rosml.registry.place import Place

PATH = f"{PREFIX}/records"
ENTRY = Entry("jazzy-base", "amd64", inputs="sha256:1", digest="sha256:2", changed=DAY)
OTHER = replace(ENTRY, architecture="arm64")
INPUTS = {"argument A": "1"}


@pytest.fixture
def server() -> Iterator[StandIn]:
    with standing_in() as found:
        yield found


@pytest.fixture
def book(server: StandIn) -> Iterator[Records]:
    with Registry(server.address) as client:
        yield Records(Place(client, PREFIX))


def night(number: int) -> Entry:
    """The entry after another scan."""
    return replace(ENTRY, scanned="clean", scan={"database": str(number)})


def test_only_the_present_entry_stays(server: StandIn, book: Records) -> None:
    for entry in (ENTRY, OTHER):
        book.write(entry, INPUTS)
    for number in range(3):
        book.write(night(number))
    assert book.read("jazzy-base", "amd64") == night(2)
    assert book.read("jazzy-base", "arm64") == OTHER
    assert book.inputs("jazzy-base", "amd64") == INPUTS
    assert len(server.manifests) == 2, "what no tag points at is left"


def test_an_entry_under_another_tag_is_none(book: Records) -> None:
    """Somebody copied it."""
    digest = book.write(ENTRY)
    book.registry.tag(PATH, digest, tag("jazzy-desktop", "amd64"))
    assert book.read("jazzy-base", "amd64") and book.read("jazzy-desktop", "amd64") is None


def test_a_record_that_is_written_again_is_there_once(server: StandIn, book: Records) -> None:
    for moves in ("[]", '["one"]', '["one"]'):
        book.artifact("undo.20261122T030000Z", moves.encode(), {ANNOTATION: "{}"})
    assert len(server.manifests) == 1 and book.registry.head(PATH, "undo.20261122T030000Z")


def test_the_same_entry_again_stays(server: StandIn, book: Records) -> None:
    assert book.write(ENTRY, INPUTS) == book.write(ENTRY, INPUTS)
    assert book.read("jazzy-base", "amd64") == ENTRY
    assert server.count("^DELETE") == 0


def test_missing_entries_cost_no_request(server: StandIn, book: Records) -> None:
    book.write(ENTRY)
    missing = [(f"jazzy-{number}", "amd64") for number in range(2000)]
    before = server.count("^GET")
    found = book.read_all([*missing, ("jazzy-base", "amd64"), ("jazzy-base", "arm64")])
    assert found == {("jazzy-base", "amd64"): ENTRY}
    assert server.count("^GET") - before == 2, "the list of tags, and the entry"


@pytest.mark.parametrize("status", [400, 403, 404, 405])
def test_a_registry_that_deletes_nothing_takes_entries(server: StandIn, book: Records, status: int) -> None:
    """And is asked once, for all entries."""
    server.fault("DELETE", "/manifests/", status, times=100)
    for entry in (ENTRY, OTHER):
        book.write(entry, INPUTS)
    for number in range(3):
        Records(book.place).write(night(number))  # as the publisher does: a run has one client
    book.write(replace(OTHER, changed=NEXT))
    assert book.read("jazzy-base", "amd64") == night(2)
    assert book.read("jazzy-base", "arm64") == replace(OTHER, changed=NEXT)
    assert server.count("^DELETE") == 1


def test_a_registry_that_fails_once_the_entry_is_written(server: StandIn, book: Records) -> None:
    first = book.write(ENTRY, INPUTS)
    # Where the tag points is asked before an entry is written; and after that, when it is too late to fail.
    server.fault("HEAD", "/manifests/", 200, headers={"Docker-Content-Digest": first})
    server.fault("HEAD", "/manifests/", 403)
    book.write(night(1))
    assert book.read("jazzy-base", "amd64") == night(1)
    assert not any(fault.times for fault in server.faults)


@pytest.fixture
def registry(project: Path, monkeypatch: pytest.MonkeyPatch) -> Publisher:
    return publisher(project, services(project), monkeypatch)


@pytest.mark.parametrize("refuses", [False, True], ids=["deletes", "refuses"])
def test_nights_of_a_publisher(registry: Publisher, image_set: ImageSet, refuses: bool) -> None:
    if refuses:
        registry.registry.refuses.add("delete a manifest")
    for number, date in enumerate((DAY, NEXT, LATER)):
        registry.packages["alpha"] = f"night {number}"
        run = registry.publish(image_set, only=["alpha-core"], date=date, packages=str(number))
        assert run.outcomes and not run.failed
    registry.check(image_set)
    there, tags = registry.registry.manifests[PATH], set(registry.tagged("records").values())
    assert tags <= there.keys()
    assert (there.keys() == tags) is not refuses


class Meeting(MemoryRegistry):
    """A registry in which somebody else writes something just before, or after, a manifest of ours is put."""

    before: Callable[[], Any] | None = None
    after: Callable[[], Any] | None = None

    def put_manifest(
        self, repository: str, reference: str, content: bytes | Mapping[str, Any], media_type: str = IMAGE
    ) -> str:
        first, self.before = self.before, None
        if first:
            first()
        digest = super().put_manifest(repository, reference, content, media_type)
        then, self.after = self.after, None
        if then:
            then()
        return digest


@pytest.mark.parametrize("when", ["before", "after"])
@pytest.mark.parametrize("number", [1, 2], ids=["the same", "another"])
def test_two_publishers_write_an_entry(when: str, number: int) -> None:
    registry = Meeting()
    mine, other = Records(Place(registry, PREFIX)), Records(Place(registry, PREFIX))
    first = mine.write(ENTRY, INPUTS)
    setattr(registry, when, lambda: other.write(night(number), INPUTS))
    mine.write(night(1), INPUTS)
    assert mine.read("jazzy-base", "amd64") == night(number if when == "after" else 1)
    assert mine.inputs("jazzy-base", "amd64") == INPUTS
    assert first not in registry.manifests[PATH]


def test_somebody_else_brings_the_entry_back() -> None:
    """The manifest that was to go has the tag again: it would lose that."""
    registry = Meeting()
    book = Records(Place(registry, PREFIX))
    book.write(ENTRY, INPUTS)
    registry.after = lambda: Records(Place(registry, PREFIX)).write(ENTRY, INPUTS)
    book.write(night(1), INPUTS)
    assert book.read("jazzy-base", "amd64") == ENTRY
    assert len(registry.manifests[PATH]) == 1


def test_an_artifact_is_as_it_was() -> None:
    """Its bytes decide its digest."""
    registry = MemoryRegistry()
    book = Records(Place(registry, PREFIX))
    digest = book.artifact("x.amd64", b'{"inputs": {}}', {ANNOTATION: "{}"})
    found = registry.manifests[PATH][digest].content
    assert json.dumps(found, sort_keys=True) == json.dumps(
        {
            "annotations": {ANNOTATION: "{}"},
            "artifactType": "application/vnd.rosml.records.v1+json",
            "config": {
                "digest": "sha256:44136fa355b3678a1146ad16f7e8649e94fb4fc21fe77e8310c060f61caaff8a",
                "mediaType": "application/vnd.oci.empty.v1+json",
                "size": 2,
            },
            "layers": [
                {"digest": oci.digest_of(b'{"inputs": {}}'), "mediaType": "application/json", "size": 14},
            ],
            "mediaType": "application/vnd.oci.image.manifest.v1+json",
            "schemaVersion": 2,
        }
    )
    for layer in (found["config"], *found["layers"]):
        assert len(registry.blob(PATH, layer["digest"])) == layer["size"]
