"""`undo` and `prune` as somebody calls them in an emergency: from a fresh clone, with nothing but a registry."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from fakes.http_registry import LocalRegistry
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
    annotations = {TITLE: title, store.DATE: night}
    content = {"schemaVersion": 2, "mediaType": oci.INDEX, "manifests": [member], "annotations": annotations}
    assert member["digest"] == digest
    return client.put_manifest(path, "", content, oci.INDEX)


def published(client: Registry) -> dict[str, tuple[str, str]]:
    """Two nights of an image and of a part: where tags were, and where the second night moved them."""
    book, digests, moves = Records(Place(client, PREFIX)), {}, []
    for repository, title, target, tags in (
        ("ros", "jazzy-base", "jazzy-base", TAGS),
        ("part", "torch-cpu-py312", "part-torch-cpu-py312", ("torch-cpu-py312",)),
    ):
        before, new = (index(client, repository, title, night) for night in ("2026-11-21T03:00:00Z", RUN))
        digests[repository] = before, new
        for tag in tags:
            client.tag(f"{PREFIX}/{repository}", new, tag)
            origin = "" if tag.endswith("20261122") else before
            moves.append({"repository": repository, "tag": tag, "old": origin, "new": new})
        book.write(Entry(target, INDEX, repository=repository, digest=new, date=RUN), {})
    for number in range(40):  # entries that nobody has to read
        book.write(Entry(f"image-{number}", INDEX, repository="ros", digest=oci.digest_of(b"%d" % number)), {})
    book.artifact("undo.20261122T030000Z", json.dumps({"date": RUN, "moves": moves}).encode(), {store.ANNOTATION: "{}"})
    return digests


def test_undo_needs_a_registry_alone(server: LocalRegistry, clone: Path, capsys: pytest.CaptureFixture[str]) -> None:
    with Registry(server.address) as client:
        digests = published(client)
        before = len(server.requests)
        code = command.run(script.main, arguments=["undo", RUN, "--registry", f"{server.address}/{PREFIX}", "--json"])
        printed = capsys.readouterr()
        assert code == 0, printed.err
        reads = [line for line in server.requests[before:] if "/records/manifests/image-" in line]
        assert reads == [], "the records' other entries are nobody's business"
        assert {item["state"] for item in json.loads(printed.out)["outcomes"]} == {"done"}
        assert client.head(f"{PREFIX}/ros", TAGS[0]) == digests["ros"][0]
        assert client.head(f"{PREFIX}/part", "torch-cpu-py312") == digests["part"][0]
        assert client.head(f"{PREFIX}/ros", TAGS[1]) == "", "it was not there before"
        book = Records(Place(client, PREFIX))
        for target in ("jazzy-base", "part-torch-cpu-py312"):
            entry = book.read(target, INDEX)
            assert entry and entry.held, f"{target}: the next night would move its tags there again"
    assert not (clone / ".state").exists()


def test_undo_says_what_a_registry_that_deletes_nothing_keeps(
    server: LocalRegistry, clone: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    with Registry(server.address) as client:
        digests = published(client)
        server.fault("DELETE", "/manifests/", 405, times=99)
        with pytest.raises(SystemExit) as ended:
            command.run(script.main, arguments=["undo", RUN, "--registry", f"{server.address}/{PREFIX}", "--json"])
        (failed,) = [item for item in json.loads(capsys.readouterr().out)["outcomes"] if item["state"] == "failed"]
        assert ended.value.code == 1 and failed["target"] == f"ros:{TAGS[1]}"
        assert "deletes no tag by its name" in failed["reason"] and "its own tools" in failed["reason"]
        assert client.head(f"{PREFIX}/ros", TAGS[0]) == digests["ros"][0]


def test_a_tag_that_a_later_run_moved_to_the_same_index_stays(
    server: LocalRegistry, clone: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    with Registry(server.address) as client:
        before, new = published(client)["ros"]
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
        assert client.head(f"{PREFIX}/ros", TAGS[0]) == new != before


@pytest.mark.parametrize(
    ("words", "code", "error"),
    [
        (["undo", ""], 2, "the run is an empty word"),
        (["undo", "2020-01-01T00:00:00Z"], 1, "no record of a run of 2020"),
        (["undo"], 2, "no run was named"),
    ],
)
def test_undo_wants_a_run_that_is_sure_to_be_meant(
    server: LocalRegistry, clone: Path, capsys: pytest.CaptureFixture[str], words: list[str], code: int, error: str
) -> None:
    with Registry(server.address) as client:
        new = published(client)["ros"][1]
        assert command.run(script.main, arguments=[*words, "--registry", f"{server.address}/{PREFIX}"]) == code
        assert error in capsys.readouterr().err
        assert client.head(f"{PREFIX}/ros", TAGS[0]) == new


@pytest.mark.parametrize("extends", [False, True])
def test_prune_needs_only_a_registry_and_a_matrix(
    server: LocalRegistry, clone: Path, capsys: pytest.CaptureFixture[str], extends: bool
) -> None:
    """Also a set, whose file has neither components nor systems of its own. No lock is read."""
    (clone / "set.yaml").write_text(
        "extends: rosml\ndistributions:\n  jazzy:\ndefault: {targets: [jazzy-core], group: [jazzy-core]}\n"
    )
    with Registry(server.address) as client:
        published(client)
    arguments = ["prune", "--registry", f"{server.address}/{PREFIX}", "--json"]
    assert command.run(script.main, arguments=[*arguments, *(["--matrix", f"{clone}/set.yaml"] * extends)]) == 0
    assert json.loads(capsys.readouterr().out)["kept"] == 3
    assert not (clone / ".state").exists()
