"""Scans within a publishing run: what the policy stops gets no tag, and nobody else suffers."""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from datetime import date
from pathlib import Path
from typing import Any

import pytest
from conftest import SMALLER, changed, smaller

from fakes.memory_registry import DAY, NEXT, MemoryRegistry, Publisher, Run, publisher, waiting
from fakes.projects import BASE
from fakes.scanning import World, advisory, rules
from fakes.stubs import services
from rosml.base.errors import RosmlError
from rosml.images.image_set import restricted
from rosml.images.image_set.labels import COVERED, VEX
from rosml.images.image_set.model import ImageSet, Part
from rosml.images.publish import scan_results
from rosml.images.publish.scan_results import Results
from rosml.images.publish.steps import STEPS
from rosml.images.publish.steps.scan import policy_digest, scan
from rosml.images.records.store import INDEX
from rosml.images.scan import judge as judging
from rosml.images.scan import vex
from rosml.images.scan.judge import Outcome, summarise
from rosml.images.scan.policy import Rules
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


@dataclass(frozen=True)
class Scan:
    """A publishing run that wants a clean scan by a policy before tags.

    Attributes:
        before: changes the registry before the scan.
    """

    registry: Publisher
    image_set: ImageSet
    date: str = DAY
    policy: Rules = field(default_factory=rules)
    only: Sequence[str] = ("alpha-*",)
    before: Callable[[Run], None] = lambda run: None

    def begin(self, *steps: str) -> Run:
        """The run after some steps."""
        scanning = policy_digest(self.policy, self.date)
        run = self.registry.run(self.image_set, self.date, scanning=scanning, only=[*self.only])
        for step in steps:
            STEPS[step](run)
        return run

    def run(self, world: World) -> Run:
        """The run after all its steps."""
        run = self.begin("build", "join", "test")
        self.before(run)
        scan(run, self.policy, world.ready())
        for step in ("index", "promote"):
            STEPS[step](run)
        return run


@pytest.fixture
def core(registry: Publisher, image_set: ImageSet) -> Scan:
    """A ROS image for two architectures."""
    return Scan(registry, image_set, only=("alpha-core",))


@pytest.fixture
def alpha(registry: Publisher, image_set: ImageSet) -> Scan:
    return Scan(registry, image_set)


def stopped(run: Run) -> list[str]:
    """The advisories that stop an image with PyTorch."""
    return [*run.state.entries[BASE, "amd64"].scan["failing"]]


def test_what_the_policy_stops_gets_no_tag(registry: Publisher, alpha: Scan, world: World) -> None:
    run = alpha.run(world)
    assert run.failed
    assert "alpha-core" in registry.tagged("ros") and "alpha-core-cu1" in registry.tagged("ros-cuda")
    assert registry.tagged("ros-torch") == {}
    assert "torch-cu1-py312" not in registry.tagged("part"), "a part goes with an image that has it"
    assert any("scan: policy failed" in reason for reason in waiting(run, BASE))
    entry = run.state.entries[BASE, "amd64"]
    assert entry.scan["failing"] == ["CVE-2026-2"] and entry.scan["findings"] == {"critical": 1}
    (finding,) = entry.scan["named"]
    assert [finding[name] for name in ("id", "package", "fixed", "fails")] == ["CVE-2026-2", "torch", "3.0", True]
    parts = {item.key for item in run.state.items if item.kind != "joined"}
    assert len(world.calls("sbom")) == len(parts), "a part that images share is scanned once"

    again = replace(alpha, date=NEXT).run(world)
    assert again.failed and not again.actions, "the same database, the same policy: it is stopped again"
    assert any("scan: policy failed" in reason for reason in waiting(again, BASE))

    world.advisories.clear()  # the next database
    world.updated = "2026-11-23T00:00:00Z"
    fixed = replace(alpha, date=NEXT).run(world)
    assert not fixed.failed and not fixed.actions
    assert "alpha-base-cu1" in registry.tagged("ros-torch") and "torch-cu1-py312" in registry.tagged("part")
    registry.check(alpha.image_set)


@pytest.mark.parametrize("claim", ["that image", "another image", "nothing"])
@pytest.mark.parametrize("packages", [("numpy",), ()])
def test_an_sbom_that_somebody_attached_does_not_count(
    registry: Publisher, alpha: Scan, world: World, claim: str, packages: tuple[str, ...]
) -> None:
    """Whoever may push into a repository attaches what a scan would look for: the part with PyTorch looks harmless."""

    def attack(run: Run) -> None:
        item = next(item for item in run.state.items if isinstance(item.thing, Part) and item.thing.kind == "torch")
        entry, client = run.state.entries[item.key], run.state.place.client
        path = run.state.place.path(entry.repository)
        wheels = [{"bom-ref": name, "type": "library", "name": name, "purl": f"pkg:pypi/{name}@2"} for name in packages]
        document: dict[str, Any] = {"bomFormat": "CycloneDX", "components": wheels}
        if digest := {"that image": entry.digest, "another image": f"sha256:{'1' * 64}"}.get(claim):
            document["metadata"] = {"component": {"name": f"{client.host}/{path}@{digest}"}}
        manifest = client.manifest(path, entry.digest)
        assert manifest
        client.attach(path, manifest.descriptor, MEDIA_TYPE, json.dumps(document).encode(), MEDIA_TYPE, FORMAT)

    attacked = replace(alpha, before=attack)
    assert stopped(attacked.run(world)) == ["CVE-2026-2"] and registry.tagged("ros-torch") == {}
    assert stopped(replace(attacked, date=NEXT).run(world)) == ["CVE-2026-2"]


def test_an_index_names_the_sboms_of_the_parts_of_its_images(alpha: Scan, world: World) -> None:
    """By digest, so that the index's signature tells which of those that are attached are the publisher's."""
    world.advisories.clear()
    state = alpha.run(world).state
    index = state.place.client.manifest(state.place.path("ros-torch"), state.entries[BASE, INDEX].digest)
    assert index
    for item in index.content["manifests"]:
        sboms = {name: text for name, text in item["annotations"].items() if name.startswith(COVERED)}
        parts = state.entries[BASE, item["platform"]["architecture"]].parts
        assert sboms.keys() == {COVERED + target for target in parts}
        for target, digest in parts.items():
            repository, _, artifact = sboms[COVERED + target].partition("@")
            manifest = state.place.client.manifest(state.place.path(repository), artifact)
            assert manifest and manifest.content["subject"]["digest"] == digest


def test_an_image_without_an_sbom_is_built_again(core: Scan, world: World) -> None:
    """Its build ended before the SBOM was attached."""
    run = core.run(world)
    for entry in run.state.entries.values():
        run.records.write(replace(entry, sbom=""))
    again = replace(core, date=NEXT).run(world)
    assert [step for step, *_ in again.actions].count("build") == 2
    assert not again.failed and all(entry.sbom for key, entry in again.state.entries.items() if key[1] != INDEX)


def test_a_clean_image_is_not_scanned_again(core: Scan, world: World) -> None:
    core.run(world)
    calls = world.calls("sbom")
    again = replace(core, date=NEXT).run(world)
    assert calls and world.calls("sbom") == calls, "the same database, the same policy"
    assert not again.failed


def test_an_ignore_entry_that_has_expired_lets_no_tag_move(registry: Publisher, alpha: Scan, world: World) -> None:
    """Neither where the image is scanned again, nor where no scan came after its last day."""
    policy = rules(f"  - {{id: CVE-2026-2, reason: nobody calls it here, expires: {DAY[:10]}}}\n")
    first = replace(alpha, policy=policy)
    first.run(world)
    assert "alpha-base-cu1" in registry.tagged("ros-torch")
    late = replace(first, date=NEXT)
    assert "amd64: scan: not done by this policy" in waiting(late.begin("index"), BASE)
    assert stopped(late.run(world)) == ["CVE-2026-2"]


ACCEPTED = "  - {{id: CVE-2026-2, reason: {}, expires: 2027-01-31}}\n"


def vex_of(run: Run) -> tuple[str, dict[str, Any]]:
    """The digest of the VEX of an image with PyTorch, and the statement in it."""
    entry, place = run.state.entries[BASE, "amd64"], run.state.place
    path = place.path(entry.repository)
    artifact = place.client.manifest(path, entry.vex)
    assert artifact and artifact.subject == entry.digest
    assert [layer.mediaType for layer in artifact.layers] == [vex.MEDIA_TYPE, MEDIA_TYPE]
    (statement,) = json.loads(place.client.part(path, artifact.layers[0]))["statements"]
    return entry.vex, statement


def covered(run: Run) -> str:
    """The VEX that the index names of that image."""
    place = run.state.place
    index = place.client.manifest(place.path("ros-torch"), run.state.entries[BASE, INDEX].digest)
    assert index
    (member,) = (it for it in index.members if it.platform and it.platform.architecture == "amd64")
    return member.annotations[VEX].partition("@")[2]


@dataclass
class Recording:
    """A signer that only remembers what it signs."""

    identity: str = "sha256:1"
    signed: list[str] = field(default_factory=list)

    def ensure(self, reference: str) -> bool:
        self.signed.append(reference.partition("@")[2])
        return True


def test_the_verdict_travels_with_the_image(alpha: Scan, world: World) -> None:
    """The index's signature covers VEX. If it changes and the image does not, it has one of its own, and no tag moves."""
    run = replace(alpha, policy=rules(ACCEPTED.format("nobody calls it"))).run(world)
    digest, statement = vex_of(run)
    assert statement["status"] == "affected" and "nobody calls it" in statement["status_notes"]
    assert covered(run) == digest

    world.updated = "2026-11-23T00:00:00Z"  # another database that says the same
    again = replace(alpha, policy=rules(ACCEPTED.format("nobody calls it")), date=NEXT)
    assert vex_of(again.run(world))[0] == digest

    changed = replace(alpha, policy=rules(ACCEPTED.format("nobody calls it here")), date=NEXT)
    run, signer = changed.begin(), Recording()
    run.signer = signer  # type: ignore[assignment]
    scan(run, changed.policy, world.ready())
    STEPS["index"](run)
    other, statement = vex_of(run)
    assert other != digest and covered(run) == digest, "the index stays as it was"
    assert other in signer.signed and len(signer.signed) == len({*signer.signed})
    signer.signed.clear()
    STEPS["index"](run)
    assert not signer.signed, "each is signed once"


def test_a_verdict_is_not_withdrawn_in_silence(alpha: Scan, world: World) -> None:
    """Who looks for the newest VEX of the image would still read the old one."""
    world.advisories = {"torch": [advisory("CVE-2026-2", "LOW", "")]}
    digest, _ = vex_of(replace(alpha, policy=rules(ACCEPTED.format("nobody calls it"))).run(world))
    other, statement = vex_of(replace(alpha, date=NEXT).run(world))
    assert other != digest and statement["status"] == "under_investigation"


def test_vex_is_handed_over_to_the_job_that_may_write(alpha: Scan, world: World, tmp_path: Path) -> None:
    policy = rules(ACCEPTED.format("nobody calls it"))
    run = replace(alpha, policy=policy).begin("build", "join", "test")
    results = Results(tmp_path / "scan.json", DAY)
    scan(run, policy, world.ready(), results=results)
    results.write()
    recording = replace(alpha, policy=policy).begin()
    scan_results.record(recording, results.file)
    assert vex_of(recording)[1]["status"] == "affected"
    content = json.loads(results.file.read_text())
    content["entries"][-1]["vex"] = "H4sI"
    results.file.write_text(json.dumps(content))
    with pytest.raises(RosmlError, match="does not hold the results of a scan"):
        scan_results.record(recording, results.file)


@pytest.mark.parametrize("handed_over", [False, True])
def test_results_of_a_run_that_is_killed_are_kept(core: Scan, world: World, tmp_path: Path, handed_over: bool) -> None:
    run, file = core.begin("build", "test"), tmp_path / "scan.json"
    lines: list[str] = []

    def until_the_second(line: str) -> None:
        lines.append(line)
        if sum(text.startswith("scan ") for text in lines) == 2:
            raise KeyboardInterrupt

    run.say = until_the_second
    with pytest.raises(KeyboardInterrupt):
        scan(run, rules(), world.ready(), results=Results(file, DAY) if handed_over else None)
    if handed_over:
        scan_results.record(core.begin(), file)
    state = core.begin().state
    assert [state.entries[item.key].scanned for item in state.items] == ["clean", ""]


def test_results_for_another_job_are_not_written_into_the_registry(core: Scan, world: World, tmp_path: Path) -> None:
    run, results = core.begin("build", "test"), Results(tmp_path / "scan.json", DAY)
    writes = core.registry.registry.writes
    scan(run, rules(), world.ready(), results=results)
    assert core.registry.registry.writes == writes
    assert [entry["scanned"] for entry in results.entries.values()] == ["clean"] * len(run.state.items)


def test_a_scanner_that_fails_is_no_clean_scan(core: Scan) -> None:
    run = core.begin("build", "test")
    result = scan(run, rules(), ScannerFailed("the scanner is not installed", "rosml setup scanner"))
    assert result.outcome is Outcome.SCANNER_FAILED
    for step in ("index", "promote"):
        STEPS[step](run)
    assert core.registry.tagged("ros") == {}
    assert any("scanner failed" in reason for reason in waiting(run, "alpha-core"))


def test_some_of_the_images_say_nothing_of_an_ignore_entry(
    registry: Publisher, image_set: ImageSet, monkeypatch: pytest.MonkeyPatch
) -> None:
    """An entry is in no image only where all present images were scanned."""
    wholes: list[bool] = []

    def judge(_images: object, _rules: object, _today: object, whole: bool, *_targets: object) -> Any:
        wholes.append(whole)
        return summarise([], rules(), date(2026, 11, 22), whole=False)

    registry.publish(image_set)
    monkeypatch.setattr(judging, "summarise", judge)
    some, every = (registry.run(image_set, date=NEXT, only=only) for only in (["alpha-*"], []))
    scan(some, rules(), ScannerFailed("none", "rosml setup scanner"))
    scan(every, rules(), ScannerFailed("none", "rosml setup scanner"))
    every.state.present.difference_update([key for key in every.state.present if key[0] == "omega-base"])
    scan(every, rules(), ScannerFailed("none", "rosml setup scanner"))
    assert wholes == [False, True, True]


def test_what_may_not_go_to_a_registry_is_not_missing_there(
    registry: Publisher, project: Path, world: World, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Entries that are in no image are named only by a run over everything that a registry may have."""
    monkeypatch.delenv(restricted.VARIABLE, raising=False)
    image_set = smaller(project, HELD)
    free = [image.target for image in image_set.images if not {"torch", "ml"} & {*image.target.split("-")}]
    assert 1 < len(free) < len(image_set.images)
    entry = "- {{id: CVE-2026-7, {}reason: not reachable, expires: 2027-01-31}}\n"
    policy = rules(entry.format("") + entry.format("targets: '*torch*', "))

    def useless(host: str, only: list[str]) -> list[str]:
        registry.registry = MemoryRegistry(host=host)
        run = Scan(registry, image_set, policy=policy, only=only).begin("build", "join", "test")
        return [text.partition(": ")[2].partition(":")[0] for text in scan(run, policy, world.ready()).problems]

    assert useless("ghcr.io", free) == ["ignore[0]"]
    assert useless("ghcr.io", free[1:]) == []
    monkeypatch.setenv(restricted.VARIABLE, "registry.example.com")
    assert useless("registry.example.com", free) == [], "it may have all"
    assert useless("registry.example.com", []) == ["ignore[0]", "ignore[1]"]


def test_a_night_of_a_set_passes_entries_for_other_images(
    registry: Publisher, image_set: ImageSet, world: World, real: ImageSet
) -> None:
    entry = "- {id: CVE-2026-7, targets: 'noetic-*', reason: not reachable, expires: 2027-01-31}\n"
    for base, failures in ((None, 1), (real.matrix, 0)):
        run = Scan(registry, replace(image_set, base=base), policy=rules(entry), only=("alpha-core",)).run(world)
        assert [(it.step, it.target, it.state) for it in run.outcomes].count(("scan", "policy", "failed")) == failures
