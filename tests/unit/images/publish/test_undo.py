"""`undo` and `prune` as somebody calls them in an emergency: from a fresh clone, with nothing but a registry."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path

import pytest

from fakes.http_registry import StandIn, standing_in
from rosml.cli import command
from rosml.cli.images import publish as script
from rosml.images.image_set.labels import TITLE
from rosml.images.records import store
from rosml.images.records.store import INDEX, Entry, Records
from rosml.registry import oci
from rosml.registry.client import Registry
from rosml.registry.place import Place

PREFIX = "me/rosml"
RUN = "2026-11-22T03:00:00Z"
TAGS = ("jazzy-base", "jazzy-base-20261122")


@pytest.fixture
def server() -> Iterator[StandIn]:
    with standing_in() as found:
        yield found


@pytest.fixture
def clone(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder without services, locks or a build file."""
    monkeypatch.setattr(script, "ROOT", tmp_path)
    return tmp_path


def index(client: Registry, repository: str, title: str, night: str) -> str:
    """Puts an index of an image of few bytes; gives its digest."""
    path = f"{PREFIX}/{repository}"
    data = json.dumps({"architecture": "amd64", "night": night}).encode()
    client.put_blob(path, data)
    config = oci.descriptor(oci.CONFIG, data)
    image = {"schemaVersion": 2, "mediaType": oci.IMAGE, "config": config, "layers": []}
    digest = client.put_manifest(path, "", image)
    member = {**oci.descriptor(oci.IMAGE, oci.encoded(image)), "platform": {"os": "linux", "architecture": "amd64"}}
    said = {TITLE: title, store.DATE: night}
    content = {"schemaVersion": 2, "mediaType": oci.INDEX, "manifests": [member], "annotations": said}
    assert member["digest"] == digest
    return client.put_manifest(path, "", content, oci.INDEX)


def published(client: Registry) -> dict[str, tuple[str, str]]:
    """Two nights of an image and of a part: where tags were, and where the second night moved them."""
    book, found, moves = Records(Place(client, PREFIX)), {}, []
    for repository, title, target, tags in (
        ("ros", "jazzy-base", "jazzy-base", TAGS),
        ("part", "torch-cpu-py312", "part-torch-cpu-py312", ("torch-cpu-py312",)),
    ):
        old, new = (index(client, repository, title, night) for night in ("2026-11-21T03:00:00Z", RUN))
        found[repository] = old, new
        for tag in tags:
            client.tag(f"{PREFIX}/{repository}", new, tag)
            before = "" if tag.endswith("20261122") else old
            moves.append({"repository": repository, "tag": tag, "old": before, "new": new})
        book.write(Entry(target, INDEX, repository=repository, digest=new, date=RUN), {})
    for number in range(40):  # entries that nobody has to read
        book.write(Entry(f"image-{number}", INDEX, repository="ros", digest=oci.digest_of(b"%d" % number)), {})
    book.artifact("undo.20261122T030000Z", json.dumps({"date": RUN, "moves": moves}).encode(), {store.ANNOTATION: "{}"})
    return found


def test_undo_needs_a_registry_alone(server: StandIn, clone: Path, capsys: pytest.CaptureFixture[str]) -> None:
    with Registry(server.address) as client:
        found = published(client)
        before = len(server.requests)
        code = command.run(script.main, arguments=["undo", RUN, "--registry", f"{server.address}/{PREFIX}", "--json"])
        said = capsys.readouterr()
        assert code == 0, said.err
        reads = [line for line in server.requests[before:] if "/records/manifests/image-" in line]
        assert reads == [], "the records' other entries are nobody's business"
        assert {item["state"] for item in json.loads(said.out)["outcomes"]} == {"done"}
        assert client.head(f"{PREFIX}/ros", TAGS[0]) == found["ros"][0]
        assert client.head(f"{PREFIX}/part", "torch-cpu-py312") == found["part"][0]
        assert client.head(f"{PREFIX}/ros", TAGS[1]) == "", "it was not there before"
        book = Records(Place(client, PREFIX))
        for target in ("jazzy-base", "part-torch-cpu-py312"):
            entry = book.read(target, INDEX)
            assert entry and entry.held, f"{target}: the next night would move its tags there again"
    assert not (clone / ".state").exists()


def test_undo_says_what_a_registry_that_deletes_nothing_keeps(
    server: StandIn, clone: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    with Registry(server.address) as client:
        found = published(client)
        server.fault("DELETE", "/manifests/", 405, times=99)
        with pytest.raises(SystemExit) as ended:
            command.run(script.main, arguments=["undo", RUN, "--registry", f"{server.address}/{PREFIX}", "--json"])
        (failed,) = [item for item in json.loads(capsys.readouterr().out)["outcomes"] if item["state"] == "failed"]
        assert ended.value.code == 1 and failed["target"] == f"ros:{TAGS[1]}"
        assert "deletes no tag by its name" in failed["reason"] and "its own tools" in failed["reason"]
        assert client.head(f"{PREFIX}/ros", TAGS[0]) == found["ros"][0]


def test_a_tag_that_a_later_run_moved_to_the_same_index_stays(
    server: StandIn, clone: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    with Registry(server.address) as client:
        old, new = published(client)["ros"]
        moves = [{"repository": "ros", "tag": TAGS[0], "old": oci.digest_of(b"another"), "new": new}]
        later = json.dumps({"date": "2026-11-23T03:00:00Z", "moves": moves})
        Records(Place(client, PREFIX)).artifact("undo.20261123T030000Z", later.encode(), {store.ANNOTATION: "{}"})
        arguments = ["undo", RUN, "--registry", f"{server.address}/{PREFIX}"]
        says = "the run of 2026-11-23T03:00:00Z moved it here again; undo that one first"
        assert command.run(script.main, arguments=[*arguments, "--dry-run"]) == 0
        assert f"ros:{TAGS[0]}  stays: {says}" in capsys.readouterr().out
        command.run(script.main, arguments=[*arguments, "--json"])
        outcomes = {item["target"]: item for item in json.loads(capsys.readouterr().out)["outcomes"]}
        assert (outcomes[f"ros:{TAGS[0]}"]["state"], outcomes[f"ros:{TAGS[0]}"]["reason"]) == ("waits", says)
        assert client.head(f"{PREFIX}/ros", TAGS[0]) == new != old


def test_an_empty_word_is_no_run(server: StandIn, clone: Path, capsys: pytest.CaptureFixture[str]) -> None:
    with Registry(server.address) as client:
        new = published(client)["ros"][1]
        assert command.run(script.main, arguments=["undo", "", "--registry", f"{server.address}/{PREFIX}"]) == 2
        assert "the run is an empty word" in capsys.readouterr().err
        assert client.head(f"{PREFIX}/ros", TAGS[0]) == new


def test_undo_without_a_place_says_how_to_name_one(clone: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert command.run(script.main, arguments=["undo"]) == 1
    assert "--registry" in capsys.readouterr().err


def test_prune_needs_a_registry_alone(server: StandIn, clone: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Its matrix names the repositories; no lock is read."""
    with Registry(server.address) as client:
        published(client)
    arguments = ["prune", "--registry", f"{server.address}/{PREFIX}", "--json"]
    assert command.run(script.main, arguments=arguments) == 0
    assert json.loads(capsys.readouterr().out)["kept"] == 3
    assert not (clone / ".state").exists()


def test_prune_reads_a_set(server: StandIn, clone: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Whose file has neither components nor systems of its own."""
    own = clone / "set.yaml"
    own.write_text("extends: rosml\ndistributions:\n  jazzy:\ndefault: {targets: [jazzy-core], group: [jazzy-core]}\n")
    place = f"{server.address}/{PREFIX}"
    with Registry(server.address) as client:
        published(client)
    assert command.run(script.main, arguments=["prune", "--registry", place, "--matrix", str(own), "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["kept"] == 3


def test_moves_are_reported_as_a_table_too(server: StandIn, clone: Path, capsys: pytest.CaptureFixture[str]) -> None:
    with Registry(server.address) as client:
        published(client)
    place = f"{server.address}/{PREFIX}"
    assert command.run(script.main, arguments=["undo", RUN, "--registry", place]) == 0
    assert "undo: 3 done" in capsys.readouterr().out
    assert command.run(script.main, arguments=["undo", "2020-01-01T00:00:00Z", "--registry", place]) == 1
