"""The records' own repository: an entry takes the place of the one before, which goes where the registry deletes; what a
registry refuses, and publishers who write at the same time, harm no entry. What entries say: test_pipeline.py."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import pytest

from fakes.http_registry import LocalRegistry
from fakes.memory_registry import DAY, IMAGE, NEXT, PREFIX, MemoryRegistry
from rosml.images.records.store import ANNOTATION, Entry, Records, tag
from rosml.registry import oci
from rosml.registry.client import Registry
from rosml.registry.place import Place

PATH = f"{PREFIX}/records"
ENTRY = Entry("jazzy-base", "amd64", inputs="sha256:1", digest="sha256:2", changed=DAY)
OTHER = replace(ENTRY, architecture="arm64")
INPUTS = {"argument A": "1"}


@pytest.fixture
def book(server: LocalRegistry) -> Iterator[Records]:
    with Registry(server.address) as client:
        yield Records(Place(client, PREFIX))


def night(number: int) -> Entry:
    """The entry after another scan."""
    return replace(ENTRY, scanned="clean", scan={"database": str(number)})


def test_only_the_present_entry_stays(server: LocalRegistry, book: Records) -> None:
    for entry in (ENTRY, OTHER):
        book.write(entry, INPUTS)
    for number in range(3):
        book.write(night(number))
    assert book.read("jazzy-base", "amd64") == night(2)
    assert book.read("jazzy-base", "arm64") == OTHER
    assert book.inputs("jazzy-base", "amd64") == INPUTS
    assert len(server.manifests) == 2, "what no tag points at is left"
    deletions = server.count("^DELETE")
    assert book.write(night(2), INPUTS) == book.write(night(2), INPUTS)
    assert (len(server.manifests), server.count("^DELETE")) == (2, deletions), "the same entry again stays"


def test_an_entry_under_another_tag_is_none(book: Records) -> None:
    digest = book.write(ENTRY)
    book.registry.tag(PATH, digest, tag("jazzy-desktop", "amd64"))
    assert book.read("jazzy-base", "amd64") and book.read("jazzy-desktop", "amd64") is None


def test_missing_entries_cost_no_request(server: LocalRegistry, book: Records) -> None:
    book.write(ENTRY)
    missing = [(f"jazzy-{number}", "amd64") for number in range(2000)]
    before = server.count("^GET")
    entries = book.read_all([*missing, ("jazzy-base", "amd64"), ("jazzy-base", "arm64")])
    assert entries == {("jazzy-base", "amd64"): ENTRY}
    assert server.count("^GET") - before == 2, "the list of tags, and the entry"


@pytest.mark.parametrize("status", [400, 403, 404, 405])
def test_a_registry_that_deletes_nothing_takes_entries(server: LocalRegistry, book: Records, status: int) -> None:
    server.fault("DELETE", "/manifests/", status, times=100)
    for entry in (ENTRY, OTHER):
        book.write(entry, INPUTS)
    for number in range(3):
        Records(book.place).write(night(number))  # as the publisher does: a run has one client
    book.write(replace(OTHER, changed=NEXT))
    assert book.read("jazzy-base", "amd64") == night(2)
    assert book.read("jazzy-base", "arm64") == replace(OTHER, changed=NEXT)
    assert server.count("^DELETE") == 1


def test_a_registry_that_fails_once_the_entry_is_written(server: LocalRegistry, book: Records) -> None:
    first = book.write(ENTRY, INPUTS)
    # Where the tag points is asked before an entry is written; and after that, when it is too late to fail.
    server.fault("HEAD", "/manifests/", 200, headers={"Docker-Content-Digest": first})
    server.fault("HEAD", "/manifests/", 403)
    book.write(night(1))
    assert book.read("jazzy-base", "amd64") == night(1)
    assert not any(fault.times for fault in server.faults)


@pytest.mark.parametrize(
    "content", ["", "[]", '{"target": "x"}', '{"target": "x", "architecture": "amd64", "later": 1}', '{"target": 1}']
)
def test_a_damaged_entry_counts_as_missing(content: str) -> None:
    book = Records(Place(MemoryRegistry(), PREFIX))
    book.artifact("x.amd64", b"{}", {ANNOTATION: content})
    assert book.read("x", "amd64") is None


def test_an_entry_remembers_what_it_superseded() -> None:
    book = Records(Place(MemoryRegistry(), PREFIX))
    entry = Entry("x", "amd64", digest="sha256:1", parts={"a": "b"}, superseded=("sha256:0",), seconds={"build": 1.5})
    book.write(entry, INPUTS)
    book.write(entry.with_digest("sha256:2"))
    assert book.inputs("x", "amd64") == INPUTS
    assert book.read("x", "amd64") == Entry("x", "amd64", digest="sha256:2", superseded=("sha256:0", "sha256:1"))


@dataclass
class Meeting(MemoryRegistry):
    """A registry in which somebody else writes something just before, or after, a manifest of ours is put."""

    meetings: dict[str, Callable[[], object]] = field(default_factory=dict)

    def put_manifest(
        self, repository: str, reference: str, content: bytes | Mapping[str, Any], media_type: str = IMAGE
    ) -> str:
        self.meetings.pop("before", lambda: None)()
        digest = super().put_manifest(repository, reference, content, media_type)
        self.meetings.pop("after", lambda: None)()
        return digest


@pytest.mark.parametrize("when", ["before", "after"])
@pytest.mark.parametrize("number", [1, 2], ids=["the same", "another"])
def test_two_publishers_write_an_entry(when: str, number: int) -> None:
    registry = Meeting()
    mine, other = Records(Place(registry, PREFIX)), Records(Place(registry, PREFIX))
    first = mine.write(ENTRY, INPUTS)
    registry.meetings[when] = lambda: other.write(night(number), INPUTS)
    mine.write(night(1), INPUTS)
    assert mine.read("jazzy-base", "amd64") == night(number if when == "after" else 1)
    assert mine.inputs("jazzy-base", "amd64") == INPUTS
    assert first not in registry.manifests[PATH]


def test_somebody_else_brings_the_entry_back() -> None:
    """The manifest that was to go has the tag again: it would lose that."""
    registry = Meeting()
    book = Records(Place(registry, PREFIX))
    book.write(ENTRY, INPUTS)
    registry.meetings["after"] = lambda: Records(Place(registry, PREFIX)).write(ENTRY, INPUTS)
    book.write(night(1), INPUTS)
    assert book.read("jazzy-base", "amd64") == ENTRY
    assert len(registry.manifests[PATH]) == 1


def test_an_artifact_is_as_it_was() -> None:
    registry = MemoryRegistry()
    book = Records(Place(registry, PREFIX))
    digest = book.artifact("x.amd64", b'{"inputs": {}}', {ANNOTATION: "{}"})
    content = registry.manifests[PATH][digest].content
    empty = "sha256:44136fa355b3678a1146ad16f7e8649e94fb4fc21fe77e8310c060f61caaff8a"
    assert content == {
        "annotations": {ANNOTATION: "{}"},
        "artifactType": "application/vnd.rosml.records.v1+json",
        "config": {"digest": empty, "mediaType": "application/vnd.oci.empty.v1+json", "size": 2},
        "layers": [{"digest": oci.digest_of(b'{"inputs": {}}'), "mediaType": "application/json", "size": 14}],
        "mediaType": "application/vnd.oci.image.manifest.v1+json",
        "schemaVersion": 2,
    }
    for layer in (content["config"], *content["layers"]):
        assert len(registry.blob(PATH, layer["digest"])) == layer["size"]
