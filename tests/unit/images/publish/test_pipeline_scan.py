"""Scans within a publishing run: what the policy stops gets no tag, and nobody else suffers."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace
from datetime import date
from pathlib import Path
from typing import Any

import pytest
from conftest import ROOT, SMALLER, changed, smaller

from fakes.memory_registry import DAY, NEXT, MemoryRegistry, Publisher, Run, publisher, waiting
from fakes.projects import BASE
from fakes.scanning import World, advisory, rules
from fakes.stubs import services
from rosml.images.image_set import load, restricted
from rosml.images.image_set.labels import COVERED
from rosml.images.image_set.model import ImageSet, Part
from rosml.images.publish import scan_results
from rosml.images.publish.steps import STEPS
from rosml.images.publish.steps.scan import left_out, policy_digest, scan
from rosml.images.records.store import INDEX
from rosml.images.scan import judge as judging
from rosml.images.scan.judge import Outcome, summarise
from rosml.images.scan.policy import Rules
from rosml.images.scan.policy import load as load_policy
from rosml.images.scan.results import Results
from rosml.images.scan.sbom import FORMAT, MEDIA_TYPE
from rosml.images.scan.trivy import ScannerFailed

HELD = changed("{name: torch, title: PyTorch", "{name: torch, distribution: restricted, title: PyTorch", SMALLER)
"""The smaller matrix, whose part torch is restricted."""


@pytest.fixture
def registry(project: Path, monkeypatch: pytest.MonkeyPatch) -> Publisher:
    return publisher(project, services(project), monkeypatch)


@pytest.fixture
def world(tmp_path: Path) -> World:
    return World(tmp_path, advisories={"torch": [advisory("CVE-2026-2", "CRITICAL", "3.0")]})


def judged(registry: Publisher, image_set: ImageSet, policy: Rules, date: str = DAY, only: str = "alpha-core") -> Run:
    """A run of which a clean scan by a policy is asked before tags."""
    return registry.run(image_set, date, scanning=policy_digest(policy, date), only=[only])


def scanned(
    registry: Publisher,
    image_set: ImageSet,
    world: World,
    date: str = DAY,
    policy: Rules | None = None,
    only: str = "alpha-*",
    before_the_scan: Callable[[Run], None] | None = None,
) -> Run:
    """Such a run with all its steps."""
    policy = policy or rules()
    run = judged(registry, image_set, policy, date, only)
    for step in ("build", "join", "test"):
        STEPS[step](run)
    if before_the_scan:
        before_the_scan(run)
    trivy = world.trivy()
    trivy.fetch(policy.policy.database)
    scan(run, policy, trivy)
    STEPS["index"](run)
    STEPS["promote"](run)
    return run


def test_what_the_policy_stops_gets_no_tag(
    registry: Publisher,
    image_set: ImageSet,
    world: World,
) -> None:
    run = scanned(registry, image_set, world)
    assert run.failed
    assert "alpha-core" in registry.tagged("ros") and "alpha-core-cu1" in registry.tagged("ros-cuda")
    assert registry.tagged("ros-torch") == {}
    assert any("scan: policy failed" in reason for reason in waiting(run, BASE))
    entry = run.state.entries[BASE, "amd64"]
    assert entry.scan["failing"] == ["CVE-2026-2"] and entry.scan["findings"] == {"critical": 1}
    (named,) = entry.scan["named"]
    assert (named["id"], named["package"], named["fixed"], named["fails"]) == ("CVE-2026-2", "torch", "3.0", True)
    calls = world.calls("sbom")
    parts = {item.key for item in run.state.items if item.kind != "joined"}
    assert len(calls) == len(parts), "a part that images share is scanned once"

    again = scanned(registry, image_set, world, date=NEXT)
    assert again.failed, "the same database, the same policy: what was stopped is stopped again"
    assert any("scan: policy failed" in reason for reason in waiting(again, BASE))
    assert not again.actions

    world.advisories.clear()  # the next database
    world.updated = "2026-11-23T00:00:00Z"
    mended = scanned(registry, image_set, world, date=NEXT)
    assert not mended.failed and not mended.actions
    assert "alpha-base-cu1" in registry.tagged("ros-torch")
    registry.check(image_set)


@pytest.mark.parametrize("claimed", ["that image", "another image", "nothing"])
@pytest.mark.parametrize("packages", [("numpy",), ()])
def test_an_sbom_that_somebody_attached_does_not_count(
    registry: Publisher, image_set: ImageSet, world: World, claimed: str, packages: tuple[str, ...]
) -> None:
    """Whoever may push into a repository attaches what a scan would look for: the part with PyTorch looks harmless."""

    def attack(run: Run) -> None:
        item = next(item for item in run.state.items if isinstance(item.thing, Part) and item.thing.kind == "torch")
        entry = run.state.entries[item.key]
        path = run.state.place.path(entry.repository)
        wheels = [{"bom-ref": name, "type": "library", "name": name, "purl": f"pkg:pypi/{name}@2"} for name in packages]
        digest = {"that image": entry.digest, "another image": f"sha256:{'1' * 64}"}.get(claimed, "")
        document: dict[str, Any] = {"bomFormat": "CycloneDX", "components": wheels}
        document |= (
            {"metadata": {"component": {"name": f"{run.state.place.client.host}/{path}@{digest}"}}} if digest else {}
        )
        manifest = run.state.place.client.manifest(path, entry.digest)
        assert manifest
        data = json.dumps(document).encode()
        run.state.place.client.attach(path, manifest.descriptor, MEDIA_TYPE, data, MEDIA_TYPE, FORMAT)

    run = scanned(registry, image_set, world, before_the_scan=attack)
    assert run.state.entries[BASE, "amd64"].scan["failing"] == ["CVE-2026-2"]
    assert registry.tagged("ros-torch") == {}
    again = scanned(registry, image_set, world, date=NEXT, before_the_scan=attack)
    assert again.state.entries[BASE, "amd64"].scan["failing"] == ["CVE-2026-2"]


def test_an_index_names_the_sboms_of_what_its_images_are_made_of(
    registry: Publisher, image_set: ImageSet, world: World
) -> None:
    """By digest, so that whoever checks the index's signature knows which of those that are attached are the publisher's."""
    world.advisories.clear()
    run = scanned(registry, image_set, world)
    known = run.state.entries
    index = run.state.place.client.manifest(run.state.place.path("ros-torch"), known[BASE, INDEX].digest)
    assert index
    for item in index.content["manifests"]:
        architecture = item["platform"]["architecture"]
        named = {name: text for name, text in item["annotations"].items() if name.startswith(COVERED)}
        parts = known[BASE, architecture].parts
        assert named.keys() == {COVERED + target for target in parts}
        for target, digest in parts.items():
            repository, _, artifact = named[COVERED + target].partition("@")
            manifest = run.state.place.client.manifest(run.state.place.path(repository), artifact)
            assert manifest and manifest.content["subject"]["digest"] == digest


def test_what_has_no_sbom_is_made_again(registry: Publisher, image_set: ImageSet, world: World) -> None:
    """Its record is of a version that had scans make them; or its build ended before it was attached."""
    run = scanned(registry, image_set, world, only="alpha-core")
    for entry in run.state.entries.values():
        run.records.write(replace(entry, sbom=""))
    again = scanned(registry, image_set, world, NEXT, only="alpha-core")
    assert [step for step, *_ in again.actions].count("build") == 2
    assert not again.failed and all(entry.sbom for key, entry in again.state.entries.items() if key[1] != INDEX)


def test_what_was_clean_is_not_scanned_again(registry: Publisher, image_set: ImageSet, world: World) -> None:
    scanned(registry, image_set, world, only="alpha-core")
    calls = world.calls("sbom")
    again = scanned(registry, image_set, world, NEXT, only="alpha-core")
    assert calls and world.calls("sbom") == calls, "the same database, the same policy"
    assert not again.failed


def test_an_ignore_entry_that_has_expired_lets_no_tag_move(
    registry: Publisher, image_set: ImageSet, world: World
) -> None:
    """Neither where the image is scanned again, nor where no scan came after its last day: nothing else has changed."""
    entry = "  - {id: CVE-2026-2, reason: nobody calls it here, expires: %s}\n"
    policy = rules(entry % DAY[:10])
    assert "alpha-base-cu1" in (scanned(registry, image_set, world, policy=policy), registry.tagged("ros-torch"))[1]
    late = judged(registry, image_set, policy, NEXT, "alpha-*")
    STEPS["index"](late)
    assert "amd64: scan: not done by this policy" in waiting(late, BASE)
    again = scanned(registry, image_set, world, NEXT, policy)
    assert again.state.entries[BASE, "amd64"].scan["failing"] == ["CVE-2026-2"]
    assert any("scan: policy failed" in reason for reason in waiting(again, BASE))


def built(registry: Publisher, image_set: ImageSet) -> Run:
    """A run with a ROS image for two architectures."""
    run = judged(registry, image_set, rules())
    for step in ("build", "test"):
        STEPS[step](run)
    return run


@pytest.mark.parametrize("handed_over", [False, True])
def test_what_was_scanned_before_the_run_is_killed_is_kept(
    registry: Publisher, image_set: ImageSet, world: World, tmp_path: Path, handed_over: bool
) -> None:
    run, file = built(registry, image_set), tmp_path / "scan.json"
    trivy = world.trivy()
    trivy.fetch(rules().policy.database)
    said: list[str] = []

    def until_the_second(line: str) -> None:
        said.append(line)
        if sum(text.startswith("scan ") for text in said) == 2:
            raise KeyboardInterrupt

    run.say = until_the_second
    with pytest.raises(KeyboardInterrupt):
        scan(run, rules(), trivy, results=Results(file, DAY) if handed_over else None)
    if handed_over:
        scan_results.record(judged(registry, image_set, rules()), file)
    found = judged(registry, image_set, rules()).state
    assert [found.entries[item.key].scanned for item in found.items] == ["clean", ""]


def test_what_is_handed_over_is_not_written(
    registry: Publisher, image_set: ImageSet, world: World, tmp_path: Path
) -> None:
    """The outcomes are for another job."""
    run = built(registry, image_set)
    trivy, results, writes = world.trivy(), Results(tmp_path / "scan.json", DAY), registry.registry.writes
    trivy.fetch(rules().policy.database)
    scan(run, rules(), trivy, results=results)
    assert registry.registry.writes == writes
    assert [(entry["architecture"], entry["scanned"]) for entry in results.entries.values()] == [
        (item.architecture, "clean") for item in run.state.items
    ]


def test_a_scanner_that_fails_is_no_clean_scan(registry: Publisher, image_set: ImageSet) -> None:
    run = judged(registry, image_set, rules())
    for step in ("build", "test"):
        STEPS[step](run)
    found = scan(run, rules(), ScannerFailed("the scanner is not installed", "rosml setup scanner"))
    assert found.outcome is Outcome.SCANNER_FAILED
    STEPS["index"](run)
    STEPS["promote"](run)
    assert registry.tagged("ros") == {}
    assert any("scanner failed" in reason for reason in waiting(run, "alpha-core"))


def test_a_part_of_the_images_says_nothing_of_an_ignore_entry(
    registry: Publisher,
    image_set: ImageSet,
) -> None:
    """Only where all images that are there were scanned is an entry known to be in none. Those that cannot be built do not
    count: they never are there."""
    found: list[bool] = []

    def judge(_images: object, _rules: object, _today: object, whole: bool, *_targets: object) -> Any:
        found.append(whole)
        return summarise([], rules(), date(2026, 11, 22), whole=False)

    registry.publish(image_set)
    for only in (["alpha-*"], []):
        run = registry.run(image_set, date=NEXT, only=only)
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(judging, "summarise", judge)
            scan(run, rules(), ScannerFailed("none", "rosml setup scanner"))
    for key in [key for key in run.state.present if key[0] == "omega-base"]:
        run.state.present.discard(key)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(judging, "summarise", judge)
        scan(run, rules(), ScannerFailed("none", "rosml setup scanner"))
    assert found == [False, True, True]


def test_what_may_not_go_to_a_registry_is_not_missing_there(
    registry: Publisher, project: Path, world: World, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A run over everything that a public registry may have names entries that are in no image. One over fewer images does not, and
    neither does an entry for an image that the registry may not have."""
    monkeypatch.delenv(restricted.VARIABLE, raising=False)
    image_set = smaller(project, HELD)
    free = [image.target for image in image_set.images if not {"torch", "ml"} & {*image.target.split("-")}]
    assert 1 < len(free) < len(image_set.images)
    entry = "- {{id: CVE-2026-7, {}reason: not reachable, expires: 2027-01-31}}\n"
    policy = rules(entry.format("") + entry.format("targets: '*torch*', "))

    def useless(host: str, only: list[str]) -> list[str]:
        registry.registry = MemoryRegistry(host=host)
        run = registry.run(image_set, DAY, scanning=policy_digest(policy, DAY), only=only)
        for step in ("build", "join", "test"):
            STEPS[step](run)
        trivy = world.trivy()
        trivy.fetch(policy.policy.database)
        return [text.partition(": ")[2].partition(":")[0] for text in scan(run, policy, trivy).problems]

    assert useless("ghcr.io", free) == ["ignore[0]"]
    assert useless("ghcr.io", free[1:]) == []
    monkeypatch.setenv(restricted.VARIABLE, "registry.example.com")
    assert useless("registry.example.com", free) == [], "it may have all"
    assert useless("registry.example.com", []) == ["ignore[0]", "ignore[1]"]


def test_a_set_leaves_out_what_the_matrix_that_it_extends_has(tmp_path: Path, real: ImageSet) -> None:
    """With rosml's own scan.yaml, whose entries are for images of many distributions and stacks: none is a problem of the set."""
    file = tmp_path / "set.yaml"
    file.write_text("extends: rosml\ndistributions:\n  jazzy:\ndefault: {targets: [jazzy-core], group: [jazzy-core]}\n")
    own, policy = load.load(file, ROOT), load_policy(ROOT / "scan.yaml")
    assert left_out(own) == set(real.by_target) - set(own.by_target) and not left_out(real)
    assert policy.for_nobody(own.by_target), "rosml's policy has entries for other distributions"
    found = summarise([], policy, date(2026, 11, 26), True, own.by_target, left_out(own))
    assert found.problems == ()


def test_a_night_of_a_set_passes_entries_for_other_images(
    registry: Publisher, image_set: ImageSet, world: World, real: ImageSet
) -> None:
    entry = "- {id: CVE-2026-7, targets: 'noetic-*', reason: not reachable, expires: 2027-01-31}\n"
    for base, failed in ((None, 1), (real.matrix, 0)):
        run = scanned(registry, replace(image_set, base=base), world, policy=rules(entry), only="alpha-core")
        assert (
            len([it for it in run.outcomes if (it.step, it.target, it.state) == ("scan", "policy", "failed")]) == failed
        )
