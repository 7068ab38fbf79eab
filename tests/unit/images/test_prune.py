"""What may go: what no kept tag leads to, and nothing else."""

from __future__ import annotations

import json
import shutil
import threading
from collections.abc import Callable
from datetime import date, timedelta
from pathlib import Path
from typing import Any

import pytest
from conftest import SMALLER, changed, parse, smaller, write_locks

from fakes.memory_registry import DAY, INDEX, LATER, PREFIX, Publisher, Run, publisher
from fakes.projects import BASE
from fakes.stubs import OFFLINE, services
from rosml.base.errors import RosmlError
from rosml.cli.images import tables
from rosml.images.image_set import locked
from rosml.images.image_set.model import ImageSet
from rosml.images.matrix import names
from rosml.images.publish import status
from rosml.images.publish.prune import Pruner
from rosml.images.records import store, tag_moves
from rosml.registry.oci import Manifest

FIRST = date(2026, 9, 1)


@pytest.fixture(scope="module")
def published(sources: Path, tmp_path_factory: pytest.TempPathFactory) -> Publisher:
    """Six nights a week apart, each with other packages: published once for all tests here."""
    folder = shutil.copytree(sources, tmp_path_factory.mktemp("nights") / "project")
    with pytest.MonkeyPatch.context() as patch:
        found = publisher(folder, services(folder), patch)
        for number in range(6):
            night(found, smaller(folder), number)
        return found


@pytest.fixture
def nights(published: Publisher, project: Path, monkeypatch: pytest.MonkeyPatch) -> Publisher:
    """Those nights in a registry of the test's own."""
    found = publisher(project, services(project), monkeypatch)
    found.registry, found.packages = published.registry.copy(), dict(published.packages)
    return found


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


def test_a_dry_run_removes_nothing(nights: Publisher, image_set: ImageSet) -> None:
    before = nights.registry.writes
    found = pruner(nights, image_set).find()
    assert found.tags and found.manifests and found.records
    assert nights.registry.writes == before


def test_old_nights_go_with_what_only_they_led_to(nights: Publisher, image_set: ImageSet) -> None:
    tags, count = nights.tagged("ros"), len(nights.registry.manifests[f"{PREFIX}/ros"])
    here = pruner(nights, image_set)
    found = here.find()
    assert ("ros", "alpha-core-20260901") in found.tags and ("ros", "alpha-core-20260908") in found.tags
    list(here.remove(found))
    left = nights.tagged("ros")
    assert {name for name in tags if name not in left} == {
        f"alpha-{part}-{day}" for part in ("core", "base", "desktop") for day in ("20260901", "20260908", "20260915")
    } & tags.keys()
    assert len(nights.registry.manifests[f"{PREFIX}/ros"]) < count
    reachable(nights, image_set)
    again = here.find()
    assert (again.tags, again.manifests, again.records) == ([], [], [])
    run = nights.publish(image_set, only=["alpha"], date="2026-10-20T03:00:00Z", packages="5")
    assert run.made == [], "pruning took what the next run needs"


def test_what_a_kept_record_brings_back_stays(nights: Publisher, image_set: ImageSet) -> None:
    here = pruner(nights, image_set, days=10, newest=0)
    list(here.remove(here.find()))
    nights.undo()
    reachable(nights, image_set)


def test_a_registry_that_deletes_no_tags(nights: Publisher, image_set: ImageSet) -> None:
    nights.registry.refuses.add("delete a tag")
    here = pruner(nights, image_set)
    found = here.find()
    found.records.clear()
    lines = list(here.remove(found))
    assert any(" with sha256:" in line for line in lines)
    assert "alpha-core-20260901" not in nights.tagged("ros")
    reachable(nights, image_set)


def test_parts_that_did_not_change_stay(nights: Publisher, image_set: ImageSet) -> None:
    found = pruner(nights, image_set, days=0, newest=0).find()
    assert not [item for item in found.manifests if item[0] == "part"]


def test_an_entry_that_cannot_be_read_stops_it(nights: Publisher, image_set: ImageSet) -> None:
    store.Records(nights.place).artifact("alpha-core.amd64", b"{}", {store.ANNOTATION: "?"})
    with pytest.raises(RosmlError, match=r"alpha-core.amd64 cannot be read"):
        pruner(nights, image_set).find()


@pytest.mark.parametrize("moves", [5, [5], ["x"], [{"repository": "ros"}], [{"old": ""}]])
def test_a_record_that_cannot_be_read_stops_it(nights: Publisher, image_set: ImageSet, moves: object) -> None:
    data = json.dumps({"moves": moves}).encode()
    store.Records(nights.place).artifact("undo.20261001T030000Z", data, {})
    with pytest.raises(RosmlError, match=r"undo.20261001T030000Z cannot be read"):
        pruner(nights, image_set).find()


def test_how_images_stand(nights: Publisher, image_set: ImageSet) -> None:
    now = "2026-10-08T03:00:00Z"

    def states(**options: object) -> dict[str, status.ImageStatus]:
        run = nights.run(image_set, **options)  # type: ignore[arg-type]
        found = status.read(run.state, now)
        return {item.target: item for item in found}

    found = states()
    assert found["alpha-core"].state == "published" and found["alpha-core"].age == 2 * 86400
    assert found["alpha-core"].platforms == ("amd64", "arm64")
    assert (
        found["omega-core"].state == "missing"
        and found["omega-core"].reason == "amd64: it was never made; arm64: it was never made"
    )
    nights.packages["alpha"] = "week 7"
    found = states()
    assert found["alpha-core"].state == "outdated" and "packages moved" in found["alpha-core"].reason
    assert found[BASE].state == "outdated"
    nights.publish(image_set, only=["alpha"], date="2026-10-13T03:00:00Z", packages="7", poisoned={BASE})
    found = states()
    assert found[BASE].state == "failed" and "tests failed" in found[BASE].reason
    assert found["alpha-core"].state == "published"
    assert states(architectures=("amd64",))["alpha-core"].state == "published", "another machine's work is no fault"
    nights.publish(image_set, only=["omega-core"], architectures=("amd64",), serving=("amd64",))
    assert states(serving=("amd64",))["omega-core"].state == "published", "what is not served is not missed"
    assert states()["omega-core"].state == "outdated"
    assert status.age(None) == "" and status.age(59) == "59 s" and status.age(7300) == "2 h"
    assert '"failed": 1' in status.as_json(list(found.values()))


def test_how_images_stand_for_a_machine_of_one_architecture(nights: Publisher, image_set: ImageSet) -> None:
    """What the other one lacks is told in words of its own, and what is not published yet is not called published."""

    def state(target: str) -> tuple[str, str]:
        run = nights.run(image_set, architectures=("amd64",))
        found = status.read(run.state, "2026-10-20T03:00:00Z")
        return next((item.state, item.reason) for item in found if item.target == target)

    assert state("omega-core-torch-cpu") == ("waiting for a builder", "of its architecture")
    alone: dict[str, Any] = {"date": "2026-10-13T03:00:00Z", "architectures": ("amd64",)}
    nights.publish(image_set, only=["omega-core"], serving=("amd64",), **alone)
    assert state("omega-core") == ("published", "not published: arm64")
    nights.packages["alpha"] = "week 7"
    nights.publish(image_set, only=["alpha"], packages="7", **alone)
    assert state("alpha-core") == ("outdated", "arm64: packages moved from week 5 to week 7")
    assert state("alpha-core-torch-cpu") == ("outdated", "arm64: alpha-core is rebuilt")
    assert state("alpha-core-torch-cu1") == ("published", "")


def test_what_cannot_be_had_is_told_apart(
    project: Path,
    image_set: ImageSet,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    """Without a lock, or without the base image on this machine: neither is missing work. The table says it for each image."""
    here = publisher(project, services(project), monkeypatch)
    here.publish(image_set, only=["alpha-core"], date="2026-11-19T03:00:00Z")
    here.services = services(project, docker_hub=False, bases=OFFLINE)
    lock = next(name for name in image_set.by_target[BASE].locks if name.endswith("/torch.txt"))
    lacking = locked.with_locks(image_set, image_set.locks - {lock})
    (project / lock).unlink()
    run = here.run(lacking, only=["alpha-core", "alpha-base", BASE, "alpha-core-ml-cu1"])
    found = list(status.read(run.state, DAY))
    part = "part-torch-cu1-py312"
    states = {it.target: (it.state, it.reason) for it in found if not it.target.startswith("part") or it.target == part}
    why = "docker.io/library/ubuntu:24.04 is on Docker Hub, which does not answer"
    assert states == {
        "alpha-core": ("published", ""),
        "alpha-base": ("waiting for a builder", why),
        BASE: ("lock missing", "1 of its locks are missing"),
        "alpha-core-ml-cu1": ("lock missing", "1 of its locks are missing"),
        part: ("lock missing", "1 of its locks are missing"),
    }
    counts = json.loads(status.as_json(found))["counts"]
    assert (counts["published"], counts["waiting for a builder"], counts["lock missing"]) == (1, 1, 3)
    monkeypatch.setattr(tables, "FEW", len(found))
    tables.print_status(found, [], {"join": 2})
    lines = {line.split()[0]: " ".join(line.split()[1:]) for line in capsys.readouterr().out.splitlines() if line}
    assert lines["image"] == "state age platforms why"
    assert lines["alpha-core"] == "published 3 d amd64, arm64"
    assert lines["alpha-base"] == f"waiting for a builder {why}"
    assert lines[BASE] == "lock missing 1 of its locks are missing"
    monkeypatch.setattr(tables, "FEW", 1)
    tables.print_status(found, [], {})
    assert [line.split()[0] for line in capsys.readouterr().out.splitlines()[:-1]] == ["image", "alpha-core"]
    total = lines[str(len(found))]
    assert total.startswith("images: 1 published") and total.endswith(
        "3 lock missing, 1 waiting for a builder; a further run would join 2"
    )


def test_a_missing_lock_hides_no_failure(project: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A lock for one architecture is missing, and the tests on the other one failed. A lock for an architecture that is not served
    is not missed. What was published before has one cause, whichever locks it lacks now."""
    target, image_set = "alpha-core-torch-cpu", parse(changed("cpu: [arm64]}", "cpu: [amd64, arm64]}", SMALLER))
    write_locks(project, image_set)
    here = publisher(project, services(project), monkeypatch)
    (lock,) = (name for name in image_set.by_target[target].locks if name.endswith("arm64/3.12/torch.txt"))
    lacking = locked.with_locks(image_set, image_set.locks - {lock})

    def causes(run: Run) -> dict[str, tuple[str, str]]:
        found = list(status.read(run.state, LATER))
        made = status.causes(found, image_set.matrix.architectures)
        return {name: (cause.state, cause.reason) for cause in made for name in cause.targets}

    assert causes(here.run(lacking, only=[target]))[target] == ("lock missing", "")
    run = here.publish(lacking, only=[target], poisoned={target})
    assert causes(run)[target] == ("failed", "tests failed: contract: it is poisoned")
    assert status.ahead(run.state) == {"test": 1}, "on the architecture that has its lock"
    run = here.publish(lacking, only=[target], date=LATER, serving=("amd64",))
    assert target not in causes(run) and status.ahead(run.state) == {}
    other = lock.replace("arm64", "amd64")
    (project / other).unlink()
    without = locked.with_locks(image_set, image_set.locks - {lock, other})
    run = here.run(without, only=[target], date=LATER, serving=("amd64",))
    assert causes(run)[target] == ("outdated", "lock missing")


def test_what_is_needed_stays_where_only_digests_can_be_deleted(nights: Publisher, image_set: ImageSet) -> None:
    """A dated tag goes, and its index is what a kept record brings back: the digest must not go with the tag."""
    nights.registry.refuses.add("delete a tag")
    here = pruner(nights, image_set, days=0, newest=0)
    here.today = FIRST + timedelta(days=35)
    found = here.find()
    record = next(name for name in nights.registry.tags(f"{PREFIX}/records") if name == "undo.20261006T030000Z")
    moves = [move for move in tag_moves.read_moves(store.Records(nights.place), record) if move.old]
    assert moves
    list(here.remove(found))
    for move in moves:
        assert nights.registry.manifest(f"{PREFIX}/{move.repository}", move.old), f"{move.repository}:{move.tag}"
    assert not [name for name in nights.registry.tags(f"{PREFIX}/records") if name in found.records]


def test_a_tag_of_somebody_else_stays(nights: Publisher, image_set: ImageSet) -> None:
    path = f"{PREFIX}/ros"
    for day in ("20200101", "20200102"):
        nights.registry.put_manifest(path, f"backup-{day}", {"schemaVersion": 2, "day": day}, "application/json")
    nights.registry.put_manifest(path, "odd", {"schemaVersion": 2, "manifests": None}, INDEX)
    found = pruner(nights, image_set, days=0, newest=0).find()
    assert found.tags and not [tag for _, tag in found.tags if "backup" in tag]


def test_how_images_stand_after_a_failure_is_over(nights: Publisher, image_set: ImageSet, project: Path) -> None:
    def state(target: str) -> tuple[str, str]:
        run = nights.run(image_set, only=["alpha"])
        found = status.read(run.state, "2026-10-20T03:00:00Z")
        return next((item.state, item.reason) for item in found if item.target == target)

    script = project / "components/ros/install.sh"
    before = script.read_text()
    script.write_text(before + "# a fault\n")
    nights.publish(image_set, only=["alpha"], date="2026-10-13T03:00:00Z", packages="5", broken={"alpha-core"})
    assert state("alpha-core")[0] == "failed"
    script.write_text(before)
    assert state("alpha-core") == ("published", "")


def test_an_index_that_cannot_be_made_has_failed(nights: Publisher, image_set: ImageSet) -> None:
    nights.packages["alpha"] = "week 7"
    odd = {("alpha-core", "arm64"): {"org.opencontainers.image.version": "another"}}
    nights.publish(image_set, only=["alpha"], date="2026-10-13T03:00:00Z", packages="7", odd=odd)
    run = nights.run(image_set, only=["alpha"])
    found = {i.target: i for i in status.read(run.state, "2026-10-20T03:00:00Z")}
    assert found["alpha-core"].state == "failed" and "not the same on all" in found["alpha-core"].reason


@pytest.mark.parametrize("date", ["yesterday", "2026-11-22", "9999-99-99T99:99:99Z"])
def test_a_date_that_is_none_has_no_age(nights: Publisher, image_set: ImageSet, date: str) -> None:
    path = f"{PREFIX}/ros"
    content = {"schemaVersion": 2, "manifests": None, "annotations": {"io.rosml.date": date}}
    nights.registry.put_manifest(path, "alpha-core", content, INDEX)
    run = nights.run(image_set, only=["alpha-core"])
    (found,) = status.read(run.state, "2026-10-20T03:00:00Z")
    assert (found.state, found.age, found.platforms) == ("outdated", None, ())


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
    """The packages are those of an old night again: its images, which may go, are needed once more."""
    here = pruner(nights, image_set, days=0, newest=0)
    found = here.find()
    again: list[str] = []

    def run() -> None:
        nights.packages["alpha"] = "week 1 again"
        done = nights.publish(image_set, only=["alpha"], date="2026-10-07T03:00:00Z", packages="1")
        again.extend(entry.digest for entry in done.state.entries.values())
        assert not done.failed

    between(nights, run, monkeypatch)
    lines = list(here.remove(found))
    gone = {digest for _, digest in found.manifests}
    assert gone & set(again), "nothing that may go was needed again: this test says nothing"
    assert any("stays: it is in use again" in line for line in lines)
    reachable(nights, image_set)
    assert nights.publish(image_set, only=["alpha"], date="2026-10-08T03:00:00Z", packages="1").made == []


@pytest.mark.parametrize("only_digests", [False, True])
@pytest.mark.parametrize("mover", ["a tag", "an undo", "the record of a run"])
def test_what_a_tag_moves_to_while_manifests_go_stays(
    nights: Publisher, image_set: ImageSet, monkeypatch: pytest.MonkeyPatch, mover: str, only_digests: bool
) -> None:
    """The tag moves when the first manifest is gone; a run writes its record before its tags move."""
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
    found = here.find()
    assert ("ros", goal) in found.manifests
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
    lines = list(here.remove(found))
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
    found = here.find()
    going = [digest for repository, digest in found.manifests if repository == "ros"]
    indexes = {digest: registry.manifest(path, digest).content.get("manifests", []) for digest in going}  # type: ignore[union-attr]
    one = next(name for name, members in indexes.items() if {item["digest"] for item in members} & {*going})
    came: list[str] = []

    def deleting(repository: str, reference: str) -> None:
        delete(repository, reference)
        if (repository, reference) == (path, one):
            again = {"schemaVersion": 2, "manifests": indexes[one], "annotations": {"from": "another run"}}
            came.append(registry.put_manifest(path, "came", again, INDEX))

    monkeypatch.setattr(registry, "delete", deleting)
    list(here.remove(found))
    assert came and came == [registry.head(path, "came")]
    reachable(nights, image_set)
    index = registry.manifest(path, "came")
    assert index and all(registry.manifest(path, item["digest"]) for item in index.content["manifests"])


def test_a_dated_tag_that_moved_stays(nights: Publisher, image_set: ImageSet) -> None:
    here = pruner(nights, image_set, days=0, newest=0)
    found = here.find()
    repository, tag = next(item for item in found.tags if item[0] == "ros")
    path = f"{PREFIX}/{repository}"
    other = nights.registry.head(path, "alpha-core")
    assert other != nights.registry.head(path, tag)
    nights.registry.names[path][tag] = other
    lines = list(here.remove(found))
    assert f"{repository}:{tag} stays: it moved meanwhile" in lines
    assert nights.registry.head(path, tag) == other


def test_a_dated_tag_with_a_date_that_is_none_is_somebody_elses(nights: Publisher, image_set: ImageSet) -> None:
    content = {"schemaVersion": 2, "manifests": [], "annotations": {"io.rosml.date": "yesterday"}}
    nights.registry.put_manifest(f"{PREFIX}/ros", "mine-20200101", content, INDEX)
    assert ("ros", "mine-20200101") not in pruner(nights, image_set, days=0, newest=0).find().tags


@pytest.mark.parametrize(("days", "newest"), [(3650, 99), (0, 0)], ids=["all stay", "all go"])
def test_looking_asks_at_most_twice_for_an_image_of_a_night(
    project: Path,
    image_set: ImageSet,
    monkeypatch: pytest.MonkeyPatch,
    days: int,
    newest: int,
) -> None:
    here = publisher(project, services(project), monkeypatch)
    asked, images, repositories = [], [], {image.repository for image in image_set.images}
    for number in range(6):
        night(here, image_set, number)
        before = here.registry.reads
        Pruner(here.place, image_set, FIRST + timedelta(days=100), days, newest).find()
        asked.append(here.registry.reads - before)
        dated = [tag for name in repositories for tag in here.tagged(name) if names.DATED.search(tag)]
        images.append(len(dated))
    more = images[5] - images[1]
    assert more >= 4 * 10, "nights without new images say nothing"
    assert (asked[5] - asked[1]) / more <= 2


def test_images_are_asked_for_side_by_side(
    nights: Publisher,
    image_set: ImageSet,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """The first requests for manifests are answered only when eight of them wait."""
    manifest, together, waiting = nights.registry.manifest, threading.Event(), []

    def answering(repository: str, reference: str) -> Manifest | None:
        if repository.endswith("/records"):
            return manifest(repository, reference)
        waiting.append(reference)
        if len(waiting) >= 8:
            together.set()
        if not together.wait(5):
            raise RosmlError("nobody else asks for anything meanwhile", "")
        return manifest(repository, reference)

    monkeypatch.setattr(nights.registry, "manifest", answering)
    assert pruner(nights, image_set).find().tags
