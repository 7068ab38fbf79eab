"""What may go: what no kept tag leads to, and nothing else."""

from __future__ import annotations

import json
import shutil
import threading
from collections.abc import Callable
from datetime import date, timedelta
from pathlib import Path

import pytest
from conftest import smaller

from fakes.memory_registry import INDEX, PREFIX, Publisher, publisher
from fakes.stubs import services
from rosml.base import side_by_side
from rosml.base.errors import RosmlError
from rosml.images.image_set.model import ImageSet
from rosml.images.matrix.tags import DATED
from rosml.images.publish.prune import Pruner
from rosml.images.records import store, tag_moves
from rosml.registry.oci import Manifest

FIRST = date(2026, 9, 1)


@pytest.fixture(scope="module")
def published(sources: Path, tmp_path_factory: pytest.TempPathFactory) -> Publisher:
    """Six nights a week apart, each with other packages: published once for all tests here."""
    folder = shutil.copytree(sources, tmp_path_factory.mktemp("nights") / "project")
    with pytest.MonkeyPatch.context() as patch:
        place = publisher(folder, services(folder), patch)
        for number in range(6):
            night(place, smaller(folder), number)
        return place


@pytest.fixture
def nights(published: Publisher, project: Path, monkeypatch: pytest.MonkeyPatch) -> Publisher:
    """Those nights in a registry of the test's own."""
    place = publisher(project, services(project), monkeypatch)
    place.registry, place.packages = published.registry.copy(), dict(published.packages)
    return place


def night(here: Publisher, image_set: ImageSet, number: int) -> None:
    """Publishes all images of a row with the packages of a week."""
    here.packages["alpha"] = f"week {number}"
    day = FIRST + timedelta(days=7 * number)
    here.publish(image_set, only=["alpha"], date=f"{day}T03:00:00Z", packages=str(number))


def pruner(nights: Publisher, image_set: ImageSet, days: int = 20, newest: int = 2) -> Pruner:
    return Pruner(nights.place, image_set, FIRST + timedelta(days=36), days, newest)


def reachable(nights: Publisher, image_set: ImageSet) -> None:
    """Everything that a tag leads to is there."""
    for repository in {image.repository for image in image_set.images} | {"part"}:
        path = f"{PREFIX}/{repository}"
        for tag, target in nights.tagged(repository).items():
            index = nights.registry.manifest(path, target)
            assert index, f"{repository}:{tag}"
            for member in index.content["manifests"]:
                assert nights.registry.manifest(path, member["digest"]), f"{repository}:{tag}"


def test_old_nights_go_with_what_only_they_led_to(nights: Publisher, image_set: ImageSet) -> None:
    tags, count = nights.tagged("ros"), len(nights.registry.manifests[f"{PREFIX}/ros"])
    here, writes = pruner(nights, image_set), nights.registry.writes
    pruning = here.find()
    assert nights.registry.writes == writes, "the search removes nothing"
    assert ("ros", "alpha-core-20260901") in pruning.tags and ("ros", "alpha-core-20260908") in pruning.tags
    list(here.remove(pruning))
    remaining = nights.tagged("ros")
    assert {name for name in tags if name not in remaining} == {
        f"alpha-{part}-{day}" for part in ("core", "base", "desktop") for day in ("20260901", "20260908", "20260915")
    } & tags.keys()
    assert len(nights.registry.manifests[f"{PREFIX}/ros"]) < count
    reachable(nights, image_set)
    again = here.find()
    assert (again.tags, again.manifests, again.records) == ([], [], [])
    run = nights.publish(image_set, only=["alpha"], date="2026-10-20T03:00:00Z", packages="5")
    assert run.actions == [], "pruning took what the next run needs"


def test_what_a_kept_record_brings_back_stays(nights: Publisher, image_set: ImageSet) -> None:
    here = pruner(nights, image_set, days=10, newest=0)
    list(here.remove(here.find()))
    nights.undo()
    reachable(nights, image_set)


def test_a_registry_that_deletes_no_tags_deletes_their_digests(nights: Publisher, image_set: ImageSet) -> None:
    nights.registry.refuses.add("delete a tag")
    here = pruner(nights, image_set)
    pruning = here.find()
    pruning.records.clear()
    lines = list(here.remove(pruning))
    assert any(" with sha256:" in line for line in lines)
    assert "alpha-core-20260901" not in nights.tagged("ros")
    reachable(nights, image_set)


def test_an_entry_that_cannot_be_read_stops_it(nights: Publisher, image_set: ImageSet) -> None:
    store.Records(nights.place).artifact("alpha-core.amd64", b"{}", {store.ANNOTATION: "?"})
    with pytest.raises(RosmlError, match=r"alpha-core.amd64 cannot be read"):
        pruner(nights, image_set).find()


@pytest.mark.parametrize("moves", [5, ["x"], [{"repository": "ros"}]])
def test_a_record_that_cannot_be_read_stops_it(nights: Publisher, image_set: ImageSet, moves: object) -> None:
    data = json.dumps({"moves": moves}).encode()
    store.Records(nights.place).artifact("undo.20261001T030000Z", data, {})
    with pytest.raises(RosmlError, match=r"undo.20261001T030000Z cannot be read"):
        pruner(nights, image_set).find()


def test_what_is_needed_stays_where_only_digests_can_be_deleted(nights: Publisher, image_set: ImageSet) -> None:
    """A dated tag goes, and its index is what a kept record brings back: the digest must not go with the tag."""
    nights.registry.refuses.add("delete a tag")
    here = pruner(nights, image_set, days=0, newest=0)
    here.today = FIRST + timedelta(days=35)
    pruning = here.find()
    record = next(name for name in nights.registry.tags(f"{PREFIX}/records") if name == "undo.20261006T030000Z")
    moves = [move for move in tag_moves.read_moves(store.Records(nights.place), record) if move.previous]
    assert moves
    list(here.remove(pruning))
    for move in moves:
        assert nights.registry.manifest(f"{PREFIX}/{move.repository}", move.previous), f"{move.repository}:{move.tag}"
    assert not [name for name in nights.registry.tags(f"{PREFIX}/records") if name in pruning.records]


def test_a_tag_of_somebody_else_stays(nights: Publisher, image_set: ImageSet) -> None:
    path = f"{PREFIX}/ros"
    dated = {"schemaVersion": 2, "manifests": [], "annotations": {"io.rosml.date": "yesterday"}}
    nights.registry.put_manifest(path, "mine-20200101", dated, INDEX)
    for day in ("20200101", "20200102"):
        nights.registry.put_manifest(path, f"backup-{day}", {"schemaVersion": 2, "day": day}, "application/json")
    nights.registry.put_manifest(path, "odd", {"schemaVersion": 2, "manifests": None}, INDEX)
    pruning = pruner(nights, image_set, days=0, newest=0).find()
    assert pruning.tags and not [tag for _, tag in pruning.tags if "backup" in tag or "mine" in tag]


def between(nights: Publisher, work: Callable[[], object], monkeypatch: pytest.MonkeyPatch) -> None:
    """Has something happen right after the first tag was removed."""
    delete = nights.registry.delete
    waiting = [work]

    def deleting(repository: str, reference: str) -> None:
        delete(repository, reference)
        if waiting and not reference.startswith("sha256:"):
            waiting.pop()()

    monkeypatch.setattr(nights.registry, "delete", deleting)


def test_what_a_run_comes_to_need_while_tags_go_stays(
    nights: Publisher, image_set: ImageSet, monkeypatch: pytest.MonkeyPatch
) -> None:
    here = pruner(nights, image_set, days=0, newest=0)
    pruning = here.find()
    again: list[str] = []

    def run() -> None:
        nights.packages["alpha"] = "week 1 again"
        done = nights.publish(image_set, only=["alpha"], date="2026-10-07T03:00:00Z", packages="1")
        again.extend(entry.digest for entry in done.state.entries.values())
        assert not done.failed

    between(nights, run, monkeypatch)
    lines = list(here.remove(pruning))
    removable = {digest for _, digest in pruning.manifests}
    assert removable & set(again), "nothing that may go was needed again: this test says nothing"
    assert any("stays: it is in use again" in line for line in lines)
    reachable(nights, image_set)
    assert nights.publish(image_set, only=["alpha"], date="2026-10-08T03:00:00Z", packages="1").actions == []


@pytest.mark.parametrize("only_digests", [False, True])
@pytest.mark.parametrize("mover", ["a tag", "an undo", "the record of a run"])
def test_what_a_tag_moves_to_while_manifests_go_stays(
    nights: Publisher, image_set: ImageSet, monkeypatch: pytest.MonkeyPatch, mover: str, only_digests: bool
) -> None:
    registry, path, records = nights.registry, f"{PREFIX}/ros", store.Records(nights.place)
    here, delete = pruner(nights, image_set, days=0, newest=0), registry.delete
    if only_digests:
        registry.refuses.add("delete a tag")
    dated = [registry.head(path, tag) for place, tag in here.find().tags if place == "ros"]
    going = [digest for place, digest in here.find().manifests if place == "ros"]
    # The last one that goes: with its tag, if the registry deletes nothing but digests.
    one, other = (dated, going) if only_digests else (going, dated)
    goal = [digest for digest in one if digest in other][-1]
    for name in registry.tags(records.repository):
        if name.startswith(tag_moves.UNDO):  # an undo leaves what a later run moved
            tag_moves.mark_undone(records, name, "2026-10-06T03:00:00Z")
    move = tag_moves.Move("ros", "alpha-core", goal, registry.head(path, "alpha-core"))
    old_run = "20260801T030000Z"
    records.artifact(f"undo.{old_run}", json.dumps({"moves": [move.to_json()]}).encode(), {})
    pruning = here.find()
    assert ("ros", goal) in pruning.manifests
    moved: list[str] = []

    def deleting(repository: str, reference: str) -> None:
        delete(repository, reference)
        if moved or repository != path or not reference.startswith("sha256:"):
            return
        moved.append(reference)
        if mover == "a tag":
            registry.tag(path, goal, "alpha-core")
        elif mover == "an undo":
            nights.undo(old_run)
        else:
            data = json.dumps({"moves": [{**move.to_json(), "old": move.new, "new": goal}]}).encode()
            records.artifact("undo.20261007T030000Z", data, {})

    monkeypatch.setattr(registry, "delete", deleting)
    lines = list(here.remove(pruning))
    assert moved and goal not in moved
    assert [line for line in lines if "ros" in line and " stays: " in line]
    index = registry.manifest(path, goal)
    assert index and all(registry.manifest(path, item["digest"]) for item in index.content["manifests"])
    assert mover == "the record of a run" or registry.head(path, "alpha-core") == goal
    reachable(nights, image_set)


def test_an_index_that_comes_while_another_one_goes_keeps_its_images(
    nights: Publisher, image_set: ImageSet, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It has the same images as the index that just went."""
    registry, path = nights.registry, f"{PREFIX}/ros"
    here, delete = pruner(nights, image_set, days=0, newest=0), registry.delete
    pruning = here.find()
    going = [digest for repository, digest in pruning.manifests if repository == "ros"]
    indexes = {digest: registry.manifest(path, digest).content.get("manifests", []) for digest in going}  # type: ignore[union-attr]
    one = next(name for name, members in indexes.items() if {item["digest"] for item in members} & {*going})
    came: list[str] = []

    def deleting(repository: str, reference: str) -> None:
        delete(repository, reference)
        if (repository, reference) == (path, one):
            again = {"schemaVersion": 2, "manifests": indexes[one], "annotations": {"from": "another run"}}
            came.append(registry.put_manifest(path, "came", again, INDEX))

    monkeypatch.setattr(registry, "delete", deleting)
    list(here.remove(pruning))
    assert came and came == [registry.head(path, "came")]
    reachable(nights, image_set)
    index = registry.manifest(path, "came")
    assert index and all(registry.manifest(path, item["digest"]) for item in index.content["manifests"])


def test_a_dated_tag_that_moved_stays(nights: Publisher, image_set: ImageSet) -> None:
    here = pruner(nights, image_set, days=0, newest=0)
    pruning = here.find()
    repository, tag = next(item for item in pruning.tags if item[0] == "ros")
    path = f"{PREFIX}/{repository}"
    other = nights.registry.head(path, "alpha-core")
    assert other != nights.registry.head(path, tag)
    nights.registry.names[path][tag] = other
    lines = list(here.remove(pruning))
    assert f"{repository}:{tag} stays: it moved meanwhile" in lines
    assert nights.registry.head(path, tag) == other


@pytest.mark.parametrize(("days", "newest"), [(3650, 99), (0, 0)], ids=["all stay", "all go"])
def test_looking_asks_at_most_twice_for_an_image_of_a_night(
    project: Path,
    image_set: ImageSet,
    monkeypatch: pytest.MonkeyPatch,
    days: int,
    newest: int,
) -> None:
    here = publisher(project, services(project), monkeypatch)
    requests, images, repositories = [], [], {image.repository for image in image_set.images}
    for number in range(6):
        night(here, image_set, number)
        before = here.registry.reads
        Pruner(here.place, image_set, FIRST + timedelta(days=100), days, newest).find()
        requests.append(here.registry.reads - before)
        dated = [tag for name in repositories for tag in here.tagged(name) if DATED.search(tag)]
        images.append(len(dated))
    more = images[5] - images[1]
    assert more >= 4 * 10, "nights without new images say nothing"
    assert (requests[5] - requests[1]) / more <= 2


def test_images_are_asked_for_side_by_side(
    nights: Publisher,
    image_set: ImageSet,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    manifest, both, met = nights.registry.manifest, threading.Barrier(2, timeout=20), threading.local()

    def answering(repository: str, reference: str) -> Manifest | None:
        if not repository.endswith("/records") and not hasattr(met, "once"):
            met.once = True
            both.wait()
        return manifest(repository, reference)

    monkeypatch.setattr(nights.registry, "manifest", answering)
    monkeypatch.setattr(side_by_side, "AT_ONCE", 2)
    assert pruner(nights, image_set).find().tags
