"""What is attached to promoted images: their entries of the records, and where they came from."""

from __future__ import annotations

import json
from dataclasses import replace
from datetime import date
from pathlib import Path
from typing import Any

import pytest

from fakes.memory_registry import BASE, DAY, HOST, LATER, NEXT, PREFIX, Publisher, Run, publisher
from fakes.projects import git
from fakes.stubs import services
from rosml.base.errors import RosmlError
from rosml.images.image_set.labels import REVISION, SOURCE
from rosml.images.image_set.model import ImageSet
from rosml.images.join import facts
from rosml.images.publish import provenance
from rosml.images.publish.provenance import MEDIA_TYPE
from rosml.images.publish.prune import Pruner
from rosml.images.publish.steps import STEPS
from rosml.images.records import store
from rosml.images.records.store import ARTIFACT, INDEX, Records

ONLY = ["alpha-core", "alpha-core-torch-cu1"]
TARGET = "alpha-core-torch-cu1"


@pytest.fixture
def registry(project: Path, monkeypatch: pytest.MonkeyPatch) -> Publisher:
    return publisher(project, services(project), monkeypatch)


def attached(here: Publisher, run: Run, key: tuple[str, str], kind: str) -> list[dict[str, Any]]:
    """What is attached to an image, as data."""
    entry = run.state.entries[key]
    path = run.state.place.path(entry.repository)
    found = []
    for item in here.registry.referrers(path, entry.digest, kind):
        manifest = here.registry.manifest(path, item["digest"])
        assert manifest
        found.append(json.loads(here.registry.blob(path, manifest.content["layers"][0]["digest"])))
    return found


def pruner(here: Publisher, found: ImageSet) -> Pruner:
    return Pruner(here.place, found, date(2026, 11, 24))


# ---- Entries ---------------------------------------------------------------------------------------------------------


def test_a_promoted_image_carries_its_entry(registry: Publisher, image_set: ImageSet) -> None:
    run = registry.publish(image_set, only=ONLY)
    book = Records(registry.place)
    for item in run.state.items:
        entry = run.state.entries[item.key]
        (said,) = attached(registry, run, item.key, ARTIFACT)
        assert said["inputs"] == run.state.inputs.of(*item.key)
        assert store.parse(said["entry"]) == entry
        found = book.attached(item.repository, entry.digest)
        assert found == entry


def test_what_has_not_passed_carries_none(registry: Publisher, image_set: ImageSet) -> None:
    run = registry.publish(image_set, only=ONLY, poisoned={TARGET})
    assert attached(registry, run, (TARGET, "amd64"), ARTIFACT) == []
    assert attached(registry, run, ("alpha-core", "amd64"), ARTIFACT) != []


def test_an_image_carries_what_was_known_when_tags_moved_to_it(
    registry: Publisher,
    image_set: ImageSet,
    project: Path,
) -> None:
    first = registry.publish(image_set, only=ONLY)
    test = project / "tests/structure/torch.yaml"
    test.write_text(test.read_text() + "# another\n")
    run = registry.publish(image_set, only=ONLY, date=NEXT)
    assert run.state.entries[TARGET, "amd64"] != first.state.entries[TARGET, "amd64"]
    assert {outcome.step for outcome in run.outcomes if outcome.target == TARGET} == {"test"}
    (said,) = attached(registry, run, (TARGET, "amd64"), ARTIFACT)
    assert said["entry"]["changed"] == DAY
    before = registry.registry.writes
    registry.publish(image_set, only=ONLY, date=LATER)
    assert registry.registry.writes == before, "something is uploaded although nothing changed"
    registry.publish(image_set, only=ONLY, date=LATER, force=True)  # an index of another date
    newest = Records(registry.place).attached("ros-torch", run.state.entries[TARGET, "amd64"].digest)
    assert newest and newest.changed == LATER


def test_what_others_attach_stays(registry: Publisher, image_set: ImageSet) -> None:
    run = registry.publish(image_set, only=ONLY)
    entry = run.state.entries["alpha-core", "amd64"]
    path = f"{PREFIX}/ros"
    there = registry.registry.manifests[path][entry.digest]
    subject = {"mediaType": there.media_type, "digest": entry.digest, "size": there.size}
    for number in range(2):
        for kind in (MEDIA_TYPE, "application/vnd.dev.sigstore.bundle.v0.3+json"):
            registry.registry.attach(path, subject, kind, str(number).encode(), kind, {})
    found = pruner(registry, image_set).find()
    assert found.manifests == []


def test_what_is_attached_goes_with_its_image(registry: Publisher, image_set: ImageSet) -> None:
    first = registry.publish(image_set, only=ONLY, date="2026-01-01T03:00:00Z")
    registry.packages["alpha"] = "tuesday"
    registry.publish(image_set, only=ONLY, date=DAY, packages="2")
    old = first.state.entries["alpha-core", "amd64"].digest
    path = f"{PREFIX}/ros"
    there = {item["digest"] for item in registry.registry.referrers(path, old)}
    assert len(there) == 3
    here = Pruner(registry.place, image_set, date(2027, 6, 1), 10, 0)
    list(here.remove(here.find()))
    assert not there & registry.registry.manifests[path].keys() and old not in registry.registry.manifests[path]


def test_a_registry_that_takes_no_entry_moves_no_tag(registry: Publisher, image_set: ImageSet) -> None:
    run = registry.run(image_set, only=ONLY)
    for step in ("build", "join", "test", "index"):
        STEPS[step](run)
    registry.registry.refuses.add("attach")
    STEPS["promote"](run)
    assert run.failed and registry.tagged("ros") == {}
    registry.registry.refuses.clear()
    assert not registry.publish(image_set, only=ONLY).failed
    registry.check(image_set)


# ---- A records that was lost ------------------------------------------------------------------------------------------


def test_a_records_that_was_lost_is_made_anew(registry: Publisher, image_set: ImageSet) -> None:
    """It costs a night of builds; tags stay where they were meanwhile, and the same images come of it."""
    first = registry.publish(image_set)
    for holder in (registry.registry.manifests, registry.registry.names, registry.registry.blobs):
        holder.pop(f"{PREFIX}/records")
    run = registry.publish(image_set, date=NEXT)
    assert not run.failed and len(run.actions) == len(first.actions)
    digests = {key: entry.digest for key, entry in first.state.entries.items() if key[1] != INDEX}
    assert {key: entry.digest for key, entry in run.state.entries.items() if key[1] != INDEX} == digests
    registry.check(image_set)


@pytest.mark.parametrize("members", [None, [], [{}], [{"digest": "sha256:1"}]])
def test_a_tag_of_somebody_else_is_no_trouble(registry: Publisher, image_set: ImageSet, members: object) -> None:
    content = {"manifests": members}
    registry.registry.put_manifest(f"{PREFIX}/ros", "alpha-core", content, "application/json")
    run = registry.run(image_set, only=ONLY)
    assert run.state.entries == {}


def test_an_entry_of_another_image_is_not_believed(registry: Publisher, image_set: ImageSet) -> None:
    run = registry.publish(image_set, only=ONLY)
    book = Records(registry.place)
    entry = run.state.entries["alpha-core", "amd64"]
    path = f"{PREFIX}/ros"
    there = registry.registry.manifests[path][entry.digest]
    subject = {"mediaType": there.media_type, "digest": entry.digest, "size": there.size}
    other = {"entry": run.state.entries["alpha-core", "arm64"].to_json(), "inputs": {}}
    for data in (json.dumps(other).encode(), b'{"entry": {}}', b"[]"):
        registry.registry.attach(path, subject, ARTIFACT, data, "application/json", {store.CREATED: LATER})
        found = book.attached("ros", entry.digest)
        assert found and found.architecture == "amd64"


# ---- Where images came from ------------------------------------------------------------------------------------------


def test_every_image_says_what_it_was_made_from(registry: Publisher, image_set: ImageSet) -> None:
    run = registry.publish(image_set, only=ONLY)
    known = run.state.entries
    (core,) = attached(registry, run, ("alpha-core", "amd64"), MEDIA_TYPE)
    assert core["_type"] == "https://in-toto.io/Statement/v1"
    assert core["predicateType"] == "https://slsa.dev/provenance/v1"
    digest = known["alpha-core", "amd64"].digest
    assert core["subject"] == [{"name": f"{PREFIX}/ros", "digest": {"sha256": digest.removeprefix("sha256:")}}]
    definition = core["predicate"]["buildDefinition"]
    assert definition["buildType"] == provenance.BUILD_TYPE
    assert definition["internalParameters"] == {"inputs": known["alpha-core", "amd64"].inputs}
    asked = definition["externalParameters"]
    assert (asked["target"], asked["platform"], asked["channel"]) == ("alpha-core", "linux/amd64", "live")
    found = {item["name"]: item for item in definition["resolvedDependencies"]}
    assert found["debian:alpha"] == provenance.base(BASE, "another")
    assert found["apt"]["annotations"] == {"state": "monday"}
    details = core["predicate"]["runDetails"]
    assert details["metadata"]["startedOn"] <= details["metadata"]["finishedOn"]

    (joined,) = attached(registry, run, (TARGET, "amd64"), MEDIA_TYPE)
    found = {item["name"]: item for item in joined["predicate"]["buildDefinition"]["resolvedDependencies"]}
    parts = known[TARGET, "amd64"].parts
    assert found.keys() == parts.keys()
    assert found["alpha-core"]["digest"] == {"sha256": parts["alpha-core"].removeprefix("sha256:")}
    assert found["alpha-core"]["uri"].startswith("pkg:oci/ros@sha256:")
    assert f"repository_url={HOST}/{PREFIX}/ros" in found["alpha-core"]["uri"]

    part = next(item for item in run.state.items if item.kind == "part" and item.thing.locks)
    (said,) = attached(registry, run, part.key, MEDIA_TYPE)
    found = {item["name"]: item for item in said["predicate"]["buildDefinition"]["resolvedDependencies"]}
    (lock,) = [name for name in found if name.startswith("locks/")]
    assert f"/{part.architecture}/" in lock
    assert {lock: found[lock]["digest"]["sha256"]}.items() <= run.state.inputs.of(*part.key).items()


def test_an_index_says_of_which_revision_it_is_and_images_do_not(
    project: Path,
    image_set: ImageSet,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Of a checkout as it was committed; in any other, the digest of the inputs tells what it was made from."""

    def said() -> tuple[dict[str, str], set[str]]:
        here = publisher(project, services(project), monkeypatch)
        known = here.publish(image_set, only=ONLY).state.entries
        index = here.registry.manifest(f"{PREFIX}/ros", known["alpha-core", INDEX].digest)
        assert index
        found = {name: text for name, text in index.content["annotations"].items() if name in (REVISION, SOURCE)}
        return found, {entry.digest for key, entry in known.items() if key[1] != INDEX}

    found, images = said()
    assert found == {}
    git(project.parent, "init", "-q", str(project))
    git(project, "remote", "add", "origin", "https://me:s3cret@forge.example/me/rosml")
    git(project, "add", ".")
    git(project, "commit", "-qm", "first")
    address = {SOURCE: "https://forge.example/me/rosml"}
    assert said() == ({REVISION: git(project, "rev-parse", "HEAD"), **address}, images)
    with (project / "matrix.yaml").open("a") as stream:
        stream.write("# somebody's edit\n")
    assert said() == (address, images)


def test_manifests_do_not_know_of_it(
    project: Path,
    image_set: ImageSet,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Another day, another machine: other statements, the same bytes of images."""
    found = []
    for day, run_id in ((DAY, ""), (NEXT, "7")):
        monkeypatch.setenv("GITHUB_ACTIONS", "true" if run_id else "")
        monkeypatch.setenv("GITHUB_SERVER_URL", "https://forge.example")
        monkeypatch.setenv("GITHUB_WORKFLOW_REF", "me/rosml/.github/workflows/nightly.yml@refs/heads/main")
        monkeypatch.setenv("GITHUB_RUN_ID", run_id)
        here = publisher(project, services(project), monkeypatch)
        run = here.publish(image_set, only=ONLY, date=day)
        images = {key: entry.digest for key, entry in run.state.entries.items() if key[1] != INDEX}
        builders = {
            attached(here, run, key, MEDIA_TYPE)[0]["predicate"]["runDetails"]["builder"]["id"] for key in images
        }
        found.append((images, builders))
    assert found[0][0] == found[1][0]
    assert found[0][1] == {provenance.OWN_MACHINE}
    assert found[1][1] == {"https://forge.example/me/rosml/.github/workflows/nightly.yml@refs/heads/main"}


def test_nothing_is_said_of_a_manifest_that_is_gone(registry: Publisher) -> None:
    made = provenance.definition({}, "sha256:1", ())
    with pytest.raises(RosmlError, match="ros@sha256:2 is not in the registry any more"):
        statement = provenance.Statement("ros", "sha256:2", made, provenance.Machine("me", "1"), DAY, NEXT)
        provenance.attach(registry.registry, statement)


def test_a_signature_covers_the_publishers_statements_and_no_other(registry: Publisher, image_set: ImageSet) -> None:
    """Somebody who may push attaches a statement that names the same builder; the index is made again after that."""
    run = registry.publish(image_set, only=ONLY)
    key = (TARGET, "amd64")
    entry = run.state.entries[key]
    path = run.state.place.path(entry.repository)
    manifest = registry.registry.manifest(path, entry.digest)
    assert manifest
    said = {provenance.PREDICATE_ANNOTATION: provenance.PREDICATE, provenance.BUILDER: provenance.OWN_MACHINE}
    forged = registry.registry.attach(path, manifest.descriptor, MEDIA_TYPE, b"{}", MEDIA_TYPE, said)
    for number in (0, 1):
        if number:
            run = registry.publish(image_set, only=ONLY, date=NEXT, force=True)
        index = registry.registry.manifest(path, run.state.entries[TARGET, INDEX].digest)
        assert index
        named = {
            item["platform"]["architecture"]: item["annotations"][provenance.COVERED].split()
            for item in index.content["manifests"]
        }
        assert named["amd64"] == list(run.state.entries[key].provenance.values()) != [forged]
        statement = registry.registry.manifest(path, named["amd64"][0])
        assert statement and statement.content["subject"]["digest"] == entry.digest


def test_a_builder_says_it_once(registry: Publisher, image_set: ImageSet, monkeypatch: pytest.MonkeyPatch) -> None:
    run = registry.publish(image_set, only=ONLY)
    registry.publish(image_set, only=ONLY, date=NEXT, force=True)
    assert len(attached(registry, run, ("alpha-core", "amd64"), MEDIA_TYPE)) == 1
    registry.packages["alpha"] = "tuesday"  # the same packages after all, in another state of the repository
    registry.publish(image_set, only=ONLY, date=LATER)
    (said,) = attached(registry, run, ("alpha-core", "amd64"), MEDIA_TYPE)
    assert said["predicate"]["buildDefinition"]["resolvedDependencies"][-1]["annotations"]["state"] == "monday"
    monkeypatch.setattr(provenance, "OWN_MACHINE", "https://forge.example/another")
    registry.publish(image_set, only=ONLY, date="2026-11-25T03:00:00Z", force=True)
    assert len(attached(registry, run, ("alpha-core", "amd64"), MEDIA_TYPE)) == 2
    assert len(attached(registry, run, (TARGET, "amd64"), MEDIA_TYPE)) == 2


# ---- Facts -----------------------------------------------------------------------------------------------------------


def test_what_has_no_facts_is_described_again_and_not_built(registry: Publisher, image_set: ImageSet) -> None:
    """An older version attached none. Digests stay, so nothing is joined or tested again."""
    run = registry.publish(image_set, only=ONLY)
    for entry in run.state.entries.values():
        run.records.write(replace(entry, described=""))
    digests = {key: entry.digest for key, entry in run.state.entries.items()}
    again = registry.publish(image_set, only=ONLY, date=NEXT)
    items = [item for item in again.state.items if item.kind != "joined"]
    assert {item.kind for item in items} == {"ros", "part"}
    assert again.actions == [("describe", item.target, "") for item in items] and not again.failed
    assert {key: entry.digest for key, entry in again.state.entries.items()} == digests
    assert all(again.state.entries[item.key].described for item in items)
    assert registry.publish(image_set, only=ONLY, date=LATER).actions == []


def test_an_index_leads_from_a_joined_image_to_its_parts(registry: Publisher, image_set: ImageSet) -> None:
    """On each platform to the manifests of that platform; whoever reads facts needs nothing else."""
    run = registry.publish(image_set, only=ONLY)
    entry = run.state.entries[TARGET, INDEX]
    path = run.state.place.path(entry.repository)
    found = registry.registry.manifest(path, entry.digest)
    assert found and found.members
    for member in found.members:
        assert member.platform and member.platform.architecture
        parts = run.state.entries[TARGET, member.platform.architecture].parts
        places = facts.components(registry.registry, path, member.digest, member.annotations)
        assert {digest for _, digest in places} == {*parts.values()} and len(parts) > 2
        assert all(registry.registry.manifest(*place) for place in places)
