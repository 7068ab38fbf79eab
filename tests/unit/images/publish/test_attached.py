"""What is attached to promoted images: their entries of the records, their provenance, and facts."""

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
from rosml.images.image_set.labels import REVISION, SOURCE
from rosml.images.image_set.model import ImageSet
from rosml.images.join import facts
from rosml.images.publish import provenance
from rosml.images.publish.provenance import MEDIA_TYPE
from rosml.images.publish.prune import Pruner
from rosml.images.publish.steps import STEPS
from rosml.images.records import store
from rosml.images.records.store import ARTIFACT, INDEX, Entry, Records
from rosml.images.scan import sbom

TARGET = "alpha-core-torch-cu1"
ONLY = ["alpha-core", TARGET]
CORE, TORCH = ("alpha-core", "amd64"), (TARGET, "amd64")
ROS = f"{PREFIX}/ros"


@pytest.fixture
def registry(project: Path, monkeypatch: pytest.MonkeyPatch) -> Publisher:
    return publisher(project, services(project), monkeypatch)


def attached(here: Publisher, run: Run, key: tuple[str, str], kind: str) -> list[dict[str, Any]]:
    """What is attached to an image, as data."""
    entry = run.state.entries[key]
    path, documents = run.state.place.path(entry.repository), []
    for item in here.registry.referrers(path, entry.digest, kind):
        manifest = here.registry.manifest(path, item["digest"])
        assert manifest
        documents.append(json.loads(here.registry.blob(path, manifest.content["layers"][0]["digest"])))
    return documents


def images(run: Run) -> dict[tuple[str, str], str]:
    """Digests of the run's images, without indexes."""
    return {key: entry.digest for key, entry in run.state.entries.items() if key[1] != INDEX}


def subject(registry: Publisher, entry: Entry) -> dict[str, Any]:
    manifest = registry.registry.manifests[ROS][entry.digest]
    return {"mediaType": manifest.media_type, "digest": entry.digest, "size": manifest.size}


# ---- Entries ---------------------------------------------------------------------------------------------------------


def test_a_promoted_image_carries_its_entry(registry: Publisher, image_set: ImageSet) -> None:
    run = registry.publish(image_set, only=ONLY)
    for item in run.state.items:
        entry = run.state.entries[item.key]
        (document,) = attached(registry, run, item.key, ARTIFACT)
        assert document["inputs"] == run.state.inputs.of(*item.key)
        assert (
            store.parse(document["entry"]) == entry == Records(registry.place).attached(item.repository, entry.digest)
        )


def test_an_image_carries_the_entry_of_when_its_tags_moved(
    registry: Publisher, image_set: ImageSet, project: Path
) -> None:
    registry.publish(image_set, only=ONLY)
    test = project / "tests/structure/torch.yaml"
    test.write_text(test.read_text() + "# another\n")
    run = registry.publish(image_set, only=ONLY, date=NEXT)
    assert {outcome.step for outcome in run.outcomes if outcome.target == TARGET} == {"test"}
    (document,) = attached(registry, run, TORCH, ARTIFACT)
    assert document["entry"]["changed"] == DAY
    before = registry.registry.writes
    registry.publish(image_set, only=ONLY, date=LATER)
    assert registry.registry.writes == before, "something is uploaded although nothing changed"
    registry.publish(image_set, only=ONLY, date=LATER, force=True)  # an index of another date
    newest = Records(registry.place).attached("ros-torch", run.state.entries[TORCH].digest)
    assert newest and newest.changed == LATER


def test_what_others_attach_stays(registry: Publisher, image_set: ImageSet) -> None:
    run = registry.publish(image_set, only=ONLY)
    for number in (b"0", b"1"):
        for kind in (MEDIA_TYPE, "application/vnd.dev.sigstore.bundle.v0.3+json"):
            registry.registry.attach(ROS, subject(registry, run.state.entries[CORE]), kind, number, kind, {})
    assert Pruner(registry.place, image_set, date(2026, 11, 24)).find().manifests == []


def test_what_is_attached_goes_with_its_image(registry: Publisher, image_set: ImageSet) -> None:
    first = registry.publish(image_set, only=ONLY, date="2026-01-01T03:00:00Z").state.entries[CORE].digest
    registry.packages["alpha"] = "tuesday"
    registry.publish(image_set, only=ONLY, date=DAY, packages="2")
    artifacts = {item["digest"] for item in registry.registry.referrers(ROS, first)}
    assert len(artifacts) == 3
    pruner = Pruner(registry.place, image_set, date(2027, 6, 1), 10, 0)
    list(pruner.remove(pruner.find()))
    assert not {first, *artifacts} & registry.registry.manifests[ROS].keys()


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


def test_records_that_were_lost_are_built_again(registry: Publisher, image_set: ImageSet) -> None:
    """It costs a night of builds; tags stay where they were meanwhile, and the same images come of it."""
    first = registry.publish(image_set)
    for holder in (registry.registry.manifests, registry.registry.names, registry.registry.blobs):
        holder.pop(f"{PREFIX}/records")
    run = registry.publish(image_set, date=NEXT)
    assert not run.failed and len(run.actions) == len(first.actions) and images(run) == images(first)
    registry.check(image_set)


def test_an_entry_of_another_image_does_not_count(registry: Publisher, image_set: ImageSet) -> None:
    entries = registry.publish(image_set, only=ONLY).state.entries
    other = {"entry": entries["alpha-core", "arm64"].to_json(), "inputs": {}}
    for data in (json.dumps(other).encode(), b'{"entry": {}}', b"[]"):
        annotations = {store.CREATED: LATER}
        registry.registry.attach(ROS, subject(registry, entries[CORE]), ARTIFACT, data, "application/json", annotations)
        entry = Records(registry.place).attached("ros", entries[CORE].digest)
        assert entry and entry.architecture == "amd64"


# ---- Provenance ------------------------------------------------------------------------------------------------------


def dependencies(statement: dict[str, Any]) -> dict[str, dict[str, Any]]:
    items = statement["predicate"]["buildDefinition"]["resolvedDependencies"]
    return {item["name"]: item for item in items}


def test_the_provenance_of_an_image(registry: Publisher, image_set: ImageSet) -> None:
    run = registry.publish(image_set, only=ONLY)
    entries = run.state.entries
    (core,) = attached(registry, run, CORE, MEDIA_TYPE)
    assert core["_type"] == "https://in-toto.io/Statement/v1"
    assert core["predicateType"] == "https://slsa.dev/provenance/v1"
    digest = {"sha256": entries[CORE].digest.removeprefix("sha256:")}
    assert core["subject"] == [{"name": ROS, "digest": digest}]
    definition = core["predicate"]["buildDefinition"]
    assert definition["buildType"] == provenance.BUILD_TYPE
    assert definition["internalParameters"] == {"inputs": entries[CORE].inputs}
    parameters = definition["externalParameters"]
    assert [parameters[name] for name in ("target", "platform", "channel")] == ["alpha-core", "linux/amd64", "live"]
    assert dependencies(core)["debian:alpha"] == provenance.base(BASE, "another")
    assert dependencies(core)["apt"]["annotations"] == {"state": "monday"}
    assert "stack" not in parameters, "it has none"
    details = core["predicate"]["runDetails"]
    assert details["builder"] == {"id": provenance.OWN_MACHINE} and details["metadata"]["invocationId"] == DAY
    assert details["metadata"]["startedOn"] <= details["metadata"]["finishedOn"]

    (joined,) = attached(registry, run, TORCH, MEDIA_TYPE)
    parts = dependencies(joined)
    assert parts.keys() == entries[TORCH].parts.keys() and parts["alpha-core"]["digest"] == digest
    assert parts["alpha-core"]["uri"].startswith("pkg:oci/ros@sha256:")
    assert f"repository_url={HOST}/{ROS}" in parts["alpha-core"]["uri"]

    part = next(item for item in run.state.items if item.kind == "part" and item.thing.locks)
    (statement,) = attached(registry, run, part.key, MEDIA_TYPE)
    (lock,) = [name for name in dependencies(statement) if name.startswith("locks/")]
    assert f"/{part.architecture}/" in lock
    assert run.state.inputs.of(*part.key)[lock] == dependencies(statement)[lock]["digest"]["sha256"]


def test_an_index_has_the_revision_and_images_do_not(
    project: Path, image_set: ImageSet, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Only of a checkout as it was committed: in any other, the digest of the inputs says what it was built from."""

    def published() -> tuple[dict[str, str], dict[tuple[str, str], str]]:
        here = publisher(project, services(project), monkeypatch)
        run = here.publish(image_set, only=ONLY)
        index = here.registry.manifest(ROS, run.state.entries["alpha-core", INDEX].digest)
        assert index
        annotations = index.content["annotations"]
        return {name: annotations[name] for name in (REVISION, SOURCE) if name in annotations}, images(run)

    annotations, digests = published()
    assert annotations == {}
    git(project.parent, "init", "-q", str(project))
    git(project, "remote", "add", "origin", "https://me:s3cret@forge.example/me/rosml")
    git(project, "add", ".")
    git(project, "commit", "-qm", "first")
    address = {SOURCE: "https://forge.example/me/rosml"}
    assert published() == ({REVISION: git(project, "rev-parse", "HEAD"), **address}, digests)
    with (project / "matrix.yaml").open("a") as stream:
        stream.write("# somebody's edit\n")
    assert published() == (address, digests)


def test_another_machine_makes_other_statements_and_the_same_images(
    project: Path, image_set: ImageSet, monkeypatch: pytest.MonkeyPatch
) -> None:
    workflow = "me/rosml/.github/workflows/nightly.yml@refs/heads/main"
    monkeypatch.setenv("GITHUB_SERVER_URL", "https://forge.example")
    monkeypatch.setenv("GITHUB_WORKFLOW_REF", workflow)
    digests = []
    for day, run_id, builder in ((DAY, "", provenance.OWN_MACHINE), (NEXT, "7", f"https://forge.example/{workflow}")):
        monkeypatch.setenv("GITHUB_ACTIONS", "true" if run_id else "")
        monkeypatch.setenv("GITHUB_RUN_ID", run_id)
        here = publisher(project, services(project), monkeypatch)
        run = here.publish(image_set, only=ONLY, date=day)
        digests.append(images(run))
        statements = [attached(here, run, key, MEDIA_TYPE)[0] for key in images(run)]
        assert {statement["predicate"]["runDetails"]["builder"]["id"] for statement in statements} == {builder}
    assert digests[0] == digests[1]


def test_a_signature_covers_the_publishers_statements_and_no_other(registry: Publisher, image_set: ImageSet) -> None:
    """Somebody who may push attaches a statement that names the same builder; then the index is made again."""
    run = registry.publish(image_set, only=ONLY)
    entry = run.state.entries[TORCH]
    path = run.state.place.path(entry.repository)
    manifest = registry.registry.manifest(path, entry.digest)
    assert manifest
    annotations = {provenance.PREDICATE_ANNOTATION: provenance.PREDICATE, provenance.BUILDER: provenance.OWN_MACHINE}
    forged = registry.registry.attach(path, manifest.descriptor, MEDIA_TYPE, b"{}", MEDIA_TYPE, annotations)
    for force in (False, True):
        if force:
            run = registry.publish(image_set, only=ONLY, date=NEXT, force=True)
        index = registry.registry.manifest(path, run.state.entries[TARGET, INDEX].digest)
        assert index
        covered = {
            item["platform"]["architecture"]: item["annotations"][provenance.COVERED].split()
            for item in index.content["manifests"]
        }
        assert covered["amd64"] == list(run.state.entries[TORCH].provenance.values()) != [forged]
        statement = registry.registry.manifest(path, covered["amd64"][0])
        assert statement and statement.content["subject"]["digest"] == entry.digest


def test_a_builder_makes_one_statement(
    registry: Publisher, image_set: ImageSet, monkeypatch: pytest.MonkeyPatch
) -> None:
    run = registry.publish(image_set, only=ONLY)
    registry.publish(image_set, only=ONLY, date=NEXT, force=True)
    registry.packages["alpha"] = "tuesday"  # the same packages after all, in another state of the repository
    registry.publish(image_set, only=ONLY, date=LATER)
    (statement,) = attached(registry, run, CORE, MEDIA_TYPE)
    assert dependencies(statement)["apt"]["annotations"]["state"] == "monday"
    monkeypatch.setattr(provenance, "OWN_MACHINE", "https://forge.example/another")
    registry.publish(image_set, only=ONLY, date="2026-11-25T03:00:00Z", force=True)
    assert [len(attached(registry, run, key, MEDIA_TYPE)) for key in (CORE, TORCH)] == [2, 2]


# ---- Facts -----------------------------------------------------------------------------------------------------------


def test_what_has_no_facts_is_described_again_and_not_built(registry: Publisher, image_set: ImageSet) -> None:
    """An older version attached none. Digests stay, so nothing is joined or tested again."""
    run = registry.publish(image_set, only=ONLY)
    for entry in run.state.entries.values():
        run.records.write(replace(entry, described=""))
    again = registry.publish(image_set, only=ONLY, date=NEXT)
    items = [item for item in again.state.items if item.kind != "joined"]
    assert {item.kind for item in items} == {"ros", "part"}
    assert again.actions == [("describe", item.target, "") for item in items] and not again.failed
    assert images(again) == images(run) and all(again.state.entries[item.key].described for item in items)
    assert registry.publish(image_set, only=ONLY, date=LATER).actions == []


def test_the_sbom_of_a_joined_image_has_the_address_of_who_publishes_it(
    registry: Publisher, image_set: ImageSet
) -> None:
    run = registry.publish(image_set, only=ONLY)
    (document,) = attached(registry, run, TORCH, sbom.MEDIA_TYPE)
    assert document["metadata"]["manufacturer"] == {"url": [image_set.matrix.source]}


def test_an_index_leads_from_a_joined_image_to_its_parts(registry: Publisher, image_set: ImageSet) -> None:
    """On each platform to the manifests of that platform; whoever reads facts needs nothing else."""
    run = registry.publish(image_set, only=ONLY)
    entry = run.state.entries[TARGET, INDEX]
    path = run.state.place.path(entry.repository)
    index = registry.registry.manifest(path, entry.digest)
    assert index and index.members
    for member in index.members:
        assert member.platform and member.platform.architecture
        parts = run.state.entries[TARGET, member.platform.architecture].parts
        places = facts.components(registry.registry, path, member.digest, member.annotations)
        assert {digest for _, digest in places} == {*parts.values()} and len(parts) > 2
        assert all(registry.registry.manifest(*place) for place in places)
