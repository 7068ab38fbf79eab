"""Scanning: what is scanned how often, what the policy makes of it, and that no failure is taken for a clean image."""

from __future__ import annotations

import json
import re
from datetime import date, timedelta
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner
from conftest import ROOT

from fakes.http_registry import standing_in
from fakes.scanning import NOW, VERSION, Memory, World, advisory, digest, image, rules, sbom_of
from fakes.stubs import services
from rosml.base.errors import RosmlError
from rosml.base.programs import pinned_version
from rosml.cli.images import publish
from rosml.images.scan import judge, sbom, trivy
from rosml.images.scan.judge import Outcome
from rosml.images.scan.trivy import ScannerFailed, Trivy
from rosml.machine.services import Services
from rosml.registry import oci
from rosml.registry.client import Registry

IGNORE = "- {id: CVE-2026-1, reason: not reachable, expires: 2027-01-31}\n"


@pytest.fixture
def world(tmp_path: Path) -> World:
    """A ROS image, two parts, and a database that knows something of the image and of one part."""
    known = {"libc6": [advisory("CVE-2026-1")], "torch": [advisory("CVE-2026-2", "CRITICAL", "3.0")]}
    return World(tmp_path, advisories=known)


def scanned(
    world: World,
    *images: judge.Image,
    **options: Any,
) -> judge.Run:
    """Scans images with a database that was just fetched."""
    program = world.trivy(**options.pop("trivy", {}))
    found = options.pop("rules", None) or rules()
    program.fetch(found.policy.database)
    facts = {"now": NOW, "whole": True, **options}
    return judge.scan_images(images, found, program, world.shelf(), **facts)


def base(world: World) -> judge.Part:
    return world.part("alpha-base", "bash", "libc6", ros=True)


# ---- outcomes -------------------------------------------------------------------------------------------------------
def test_clean(world: World) -> None:
    run = scanned(world, image("alpha-core", world.part("alpha-core", "bash", ros=True)))
    assert run.outcome is Outcome.CLEAN
    assert run.outcome.exit_code == 0
    found = run.images[0]
    assert (found.reason, found.packages, found.findings) == ("no findings", 1, ())
    assert found.parts == {"alpha-core": digest("alpha-core")}
    assert found.database is not None
    assert (found.database.updated, found.database.source) == ("2026-11-22T00:00:00Z", "example.org/db:2")


def test_the_policy_stops_an_image(world: World) -> None:
    run = scanned(world, image("alpha-base-torch", base(world), world.part("torch", "torch", "numpy")))
    assert run.outcome is Outcome.POLICY_FAILED
    assert run.outcome.exit_code == 3
    found = run.images[0]
    assert found.reason == "2 findings that the policy does not allow: CVE-2026-2 in torch, CVE-2026-1 in libc6"
    assert [(it.severity, it.id, it.package, it.installed, it.fixed, it.part) for it in found.failing] == [
        ("critical", "CVE-2026-2", "torch", "1.0", "3.0", "torch"),
        ("high", "CVE-2026-1", "libc6", "1.0", "2.0", "alpha-base"),
    ]
    assert found.packages == 4


@pytest.mark.parametrize(
    ("severity", "fixed", "changes", "outcome"),
    [
        ("HIGH", "2.0", {}, Outcome.POLICY_FAILED),
        ("CRITICAL", "2.0", {}, Outcome.POLICY_FAILED),
        ("MEDIUM", "2.0", {}, Outcome.CLEAN),
        ("UNKNOWN", "2.0", {}, Outcome.POLICY_FAILED),
        ("UNKNOWN", "", {}, Outcome.CLEAN),
        ("UNKNOWN", "2.0", {"version": "1\nunknown: list"}, Outcome.CLEAN),
        ("UNKNOWN", "2.0", {"fail": "[unknown]", "version": "1\nunknown: list"}, Outcome.POLICY_FAILED),
        ("HIGH", "", {}, Outcome.CLEAN),
        ("HIGH", "", {"fixable_only": "false"}, Outcome.POLICY_FAILED),
        ("LOW", "2.0", {"fail": "[low]"}, Outcome.POLICY_FAILED),
        ("HIGH", "2.0", {"fail": "[critical]"}, Outcome.CLEAN),
    ],
)
def test_severity_and_fix_decide(
    world: World, severity: str, fixed: str, changes: dict[str, str], outcome: Outcome
) -> None:
    world.advisories = {"libc6": [advisory("CVE-2026-1", severity, fixed)]}
    run = scanned(world, image("alpha-base", base(world)), rules=rules(**changes))
    assert run.outcome is outcome
    assert len(run.images[0].findings) == 1


def test_one_image_does_not_stop_another(world: World) -> None:
    world.fail = {digest("broken"): "crash"}
    run = scanned(
        world,
        image("a", world.part("broken", "bash", ros=True)),
        image("b", world.part("good", "bash", ros=True)),
        image("c", base(world)),
    )
    assert [it.outcome for it in run.images] == [Outcome.SCANNER_FAILED, Outcome.CLEAN, Outcome.POLICY_FAILED]
    assert run.outcome is Outcome.SCANNER_FAILED
    assert run.outcome.exit_code == 4


def test_findings_of_the_other_parts_are_told_where_one_part_failed(world: World) -> None:
    """And the outcome is not theirs: nobody knows the whole image."""
    part = world.part("torch", "torch")
    world.fail = {part.digest: "crash"}
    found = scanned(world, image("alpha-base-torch", base(world), part)).images[0]
    assert found.outcome is Outcome.SCANNER_FAILED
    assert [it.id for it in found.failing] == ["CVE-2026-1"]


def test_an_image_without_parts_is_not_clean(world: World) -> None:
    assert scanned(world, image("alpha-base")).outcome is Outcome.SCANNER_FAILED


# ---- the scanner fails ----------------------------------------------------------------------------------------------
@pytest.mark.parametrize(
    ("how", "says"),
    [
        ("crash", "run error: it crashed * for two * reasons"),
        ("killed", "exit code -9"),
        ("silent", "exit code 7"),
        ("nothing", "ended well, and wrote no JSON object"),
        ("{", "ended well, and wrote no JSON object"),
        ("[]", "ended well, and wrote no JSON object"),
        ("{}", "trivy did not write a"),
    ],
)
def test_the_scanner_fails(world: World, how: str, says: str) -> None:
    world.fail = {"sbom": how}
    run = scanned(world, image("alpha-base", base(world)))
    assert run.outcome is Outcome.SCANNER_FAILED
    assert says in run.images[0].reason


def test_the_scanner_hangs(world: World) -> None:
    world.fail = {"sbom": "hang"}
    run = scanned(world, image("alpha-base", base(world)), trivy={"scan_seconds": 0.3})
    assert run.outcome is Outcome.SCANNER_FAILED
    assert run.images[0].reason == "trivy did not end within 0 s"


@pytest.mark.parametrize(
    "report",
    [
        {"SchemaVersion": 2, "Results": [{"Type": "debian", "Vulnerabilities": [{"VulnerabilityID": "CVE-2026-1"}]}]},
        {"SchemaVersion": 2, "Results": [3]},
        {"SchemaVersion": 2, "Results": [{"Type": "t", "Vulnerabilities": [{**advisory("C", "DREADFUL")}]}]},
        {"SchemaVersion": 2},
        {"SchemaVersion": 3, "Results": []},
    ],
)
def test_a_report_that_is_none(world: World, report: dict[str, Any]) -> None:
    world.fail = {"sbom": json.dumps(report)}
    assert scanned(world, image("alpha-base", base(world))).outcome is Outcome.SCANNER_FAILED


def test_packages_that_were_not_looked_at(world: World) -> None:
    """Trivy says little of an operating system that it does not know: no finding is no good news then."""
    world.fail = {"missed": 1}
    found = scanned(world, image("alpha-core", world.part("alpha-core", "bash", "tar", ros=True))).images[0]
    assert found.outcome is Outcome.SCANNER_FAILED
    assert found.reason == "alpha-core: trivy looked at 1 of 2 packages"


@pytest.mark.parametrize(
    ("packages", "system", "says"),
    [((), "12", "no Debian package"), (("bash",), "", "no operating system")],
)
def test_a_ros_image_without_packages_is_not_clean(
    world: World, packages: tuple[str, ...], system: str, says: str
) -> None:
    found = scanned(world, image("a", world.part("a", *packages, ros=True, system=system))).images[0]
    assert found.outcome is Outcome.SCANNER_FAILED
    assert says in found.reason


def test_a_part_without_packages_is_not_clean(world: World) -> None:
    found = scanned(world, image("a", world.part("a", "bash", ros=True), world.part("torch"))).images[0]
    assert found.outcome is Outcome.SCANNER_FAILED
    assert found.reason == "torch: its SBOM names no package, and a part is made of wheels"


def test_a_system_without_advisories_is_noted(world: World) -> None:
    world.eosl = True
    found = scanned(world, image("a", world.part("a", "bash", ros=True))).images[0]
    assert found.notes[0].startswith("a: debian 12.15 gets no advisories any more")


def test_the_system_of_a_library_in_a_wheel_is_none_of_the_images() -> None:
    """As auditwheel's SBOMs have it: without a version."""
    foreign = [
        {"bom-ref": "a", "type": "operating-system", "name": "almalinux"},
        {"bom-ref": "b", "type": "library", "name": "libgfortran", "purl": "pkg:rpm/almalinux/libgfortran@8.5.0"},
    ]
    wheel = {"bom-ref": "c", "type": "library", "name": "numpy", "purl": "pkg:pypi/numpy@1"}
    system = {"bom-ref": "d", "type": "operating-system", "name": "debian", "version": "12.12"}
    package = {"bom-ref": "e", "type": "library", "name": "libc6", "purl": "pkg:deb/debian/libc6@2.36"}
    for own, sources in (([wheel], ["pip::"]), ([system, package, wheel], ["debian 12", "pip::"])):
        document = {"bomFormat": "CycloneDX", "components": [*foreign, *own]}
        found = sbom.Sbom(json.dumps(document).encode())
        assert found.sources == sources
        assert [item.name for item in found.packages] == [item["name"] for item in own if item is not system]


# ---- the program ----------------------------------------------------------------------------------------------------
def test_another_version(world: World) -> None:
    world.version = "0.64.1"
    with pytest.raises(ScannerFailed, match=r"is trivy 0\.64\.1, and 0\.65\.0 is pinned") as caught:
        world.trivy()
    assert caught.value.exit_code == 4
    assert caught.value.remedy == "run 'rosml setup scanner'"


@pytest.mark.parametrize("text", [None, "{", "{}", "[]", '{"trivy": "/nowhere/trivy"}'])
def test_no_program(tmp_path: Path, text: str | None) -> None:
    (tmp_path / ".state").mkdir()
    (tmp_path / "tools/go/trivy").mkdir(parents=True)
    (tmp_path / "tools/go/trivy/go.mod").write_text(f"\tgithub.com/aquasecurity/trivy v{VERSION}\n")
    if text is not None:
        (tmp_path / ".state/scanner.json").write_text(text)
    with pytest.raises(ScannerFailed) as caught:
        Trivy.find(tmp_path)
    assert caught.value.remedy == "run 'rosml setup scanner'"


def test_the_projects_pins(tmp_path: Path) -> None:
    assert pinned_version(ROOT, "trivy", ScannerFailed) == VERSION
    assert re.fullmatch(r"3\.\d+\.\d+", pinned_version(ROOT, "cosign", RosmlError))
    with pytest.raises(ScannerFailed, match="No such file"):
        pinned_version(tmp_path, "trivy", ScannerFailed)
    (tmp_path / "tools/go/trivy").mkdir(parents=True)
    (tmp_path / "tools/go/trivy/go.mod").write_text("module trivy\n")
    with pytest.raises(ScannerFailed, match="pins no trivy"):
        pinned_version(tmp_path, "trivy", ScannerFailed)


def test_nothing_of_the_user_changes_what_is_found(world: World, monkeypatch: pytest.MonkeyPatch) -> None:
    """Neither variables nor files in the folder; how to reach a registry is theirs to say."""
    program = world.trivy()
    program.environment = {"TRIVY_SEVERITY": "LOW", "TRIVY_INSECURE": "true", "TRIVY_PASSWORD": "secret", "HOME": "/h"}
    program.run("--version", seconds=10)
    seen = json.loads((world.folder / "environment").read_text())
    assert "TRIVY_SEVERITY" not in seen
    assert (seen["TRIVY_INSECURE"], seen["TRIVY_PASSWORD"], seen["HOME"]) == ("true", "secret", "/h")
    assert seen["FOLDER"] != str(Path.cwd())
    assert "secret" not in repr(program)


# ---- the database ---------------------------------------------------------------------------------------------------
def test_no_database(world: World) -> None:
    run = judge.scan_images(
        [image("a", base(world)), image("b", base(world))], rules(), world.trivy(), world.shelf(), now=NOW, whole=True
    )
    assert [it.outcome for it in run.images] == [Outcome.SCANNER_FAILED] * 2
    assert "there is no database of vulnerabilities" in run.images[0].reason
    assert run.images[0].database is None
    assert not world.calls("sbom")


@pytest.mark.parametrize(
    "text", ["", "{}", "[]", '{"UpdatedAt": "yesterday"}', '{"UpdatedAt": "0001-01-01T00:00:00Z"}']
)
def test_a_damaged_database(world: World, text: str) -> None:
    program = world.trivy()
    program.fetch(rules().policy.database)
    (program.folder / "db/metadata.json").write_text(text)
    run = judge.scan_images([image("a", base(world))], rules(), program, world.shelf(), now=NOW, whole=True)
    assert run.outcome is Outcome.SCANNER_FAILED
    assert "is damaged" in run.images[0].reason


def test_a_database_of_another_format(world: World) -> None:
    world.schema = 3
    with pytest.raises(ScannerFailed, match="has format 3, and trivy reads 2"):
        scanned(world, image("a", base(world)))


def test_a_new_format_of_the_database_is_no_other_format_of_reports(
    world: World, monkeypatch: pytest.MonkeyPatch
) -> None:
    """trivy may change one without the other; its repositories name the database's as their tag."""
    monkeypatch.setattr(trivy, "DATABASE_FORMAT", 3)
    world.schema = 3
    assert scanned(world, image("a", world.part("a", "bash", ros=True))).outcome is Outcome.CLEAN
    database = rules(database="{repositories: [example.org/db], max_age_hours: 48}").policy.database
    asked: list[str] = []

    def digest(reference: str) -> str:
        asked.append(reference)
        return "sha256:1"

    trivy.resolve(database, digest)
    assert asked == ["example.org/db:3"]


@pytest.mark.parametrize(
    ("hours", "says"),
    [(48, ""), (49, "was made 52 hours ago"), (24 * 30, "was made 30 days ago"), (-5, "made in the future")],
)
def test_the_age_of_the_database(world: World, hours: int, says: str) -> None:
    now = NOW - timedelta(hours=3) + timedelta(hours=hours)
    if hours == 49:
        now += timedelta(hours=3)
    run = scanned(world, image("a", world.part("a", "bash", ros=True)), now=now)
    assert run.outcome is (Outcome.SCANNER_FAILED if says else Outcome.CLEAN)
    assert says in run.images[0].reason


def test_the_next_repository_is_asked(world: World) -> None:
    world.sources = ("example.net/db:2",)
    found = rules(database="{repositories: [example.org/db:2, example.net/db:2], max_age_hours: 48}").policy.database
    said: list[str] = []
    assert world.trivy().fetch(found, say=said.append).source == "example.net/db:2"
    assert said == [f"fetch the database of vulnerabilities from example.{name}/db:2" for name in ("org", "net")]


def test_no_repository_answers(world: World) -> None:
    """Nor is the database of yesterday taken for today's."""
    program = world.trivy()
    program.fetch(rules().policy.database)
    world.sources = ()
    world.write()
    with pytest.raises(ScannerFailed) as caught:
        program.fetch(rules().policy.database)
    assert caught.value.message.endswith("run error: example.org/db:2: MANIFEST_UNKNOWN")
    assert caught.value.message.count("MANIFEST_UNKNOWN") == 1
    assert len(world.calls("--download-db-only")) == 1 + trivy.ATTEMPTS
    with pytest.raises(ScannerFailed, match="there is no database"):
        program.database()


def test_shards_fetch_the_same_state(world: World) -> None:
    state = f"example.net/db@{digest('state')}"
    world.sources = (state,)
    pinned = trivy.resolve(rules(database="{repositories: [example.net/db], max_age_hours: 48}").policy.database, _head)
    assert pinned == state
    assert world.trivy().fetch(rules().policy.database, pinned).source == state


def _head(reference: str) -> str:
    if reference == "example.net/db:2":
        return digest("state")
    if reference.startswith("down"):
        raise RosmlError("it is down")
    return ""


def test_the_command_says_which_state_is_the_newest(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    known = services(tmp_path)
    monkeypatch.setattr(Services, "load", lambda root: known)
    with standing_in() as server:
        state = Registry(server.address).put_manifest("me/db", "2", b"{}", oci.INDEX)
        policy = tmp_path / "scan.yaml"
        text = (ROOT / "scan.yaml").read_text()
        policy.write_text(re.sub(r"repositories: .*", f"repositories: ['{server.address}/me/db:2']", text))
        done = CliRunner().invoke(publish.main, ["database", "--policy", str(policy)])
    assert done.exit_code == 0, done.exception
    assert done.output == (f"{server.address}/me/db@{state}\n")


def test_no_state_to_share() -> None:
    asked = rules(database="{repositories: ['down:5000/db:2', example.org/none], max_age_hours: 48}").policy.database
    with pytest.raises(ScannerFailed) as caught:
        trivy.resolve(asked, _head)
    assert caught.value.message.splitlines()[1:] == [
        "    down:5000/db:2: it is down",
        "    example.org/none:2: there is no such tag",
    ]


def test_a_database_that_changes_during_the_run(world: World) -> None:
    part = base(world)
    program = world.trivy()
    program.fetch(rules().policy.database)

    def exchange(line: str) -> None:
        if line.startswith("scan"):
            world.advisories = {"bash": [advisory("CVE-2026-3")]}
            world.write()
            program.fetch(rules().policy.database)

    found = judge.scan_images([image("a", part)], rules(), program, world.shelf(), now=NOW, whole=True, say=exchange)
    assert found.images[0].outcome is Outcome.SCANNER_FAILED
    assert "changed during the run" in found.images[0].reason


@pytest.mark.parametrize(
    ("buckets", "says"),
    [
        ("debian 11, pip::GitHub", "alpha-core: the database knows nothing of debian 12"),
        ("debian 12", "torch: the database knows nothing of pip::"),
    ],
)
def test_a_database_that_knows_nothing_of_the_system(world: World, buckets: str, says: str) -> None:
    """Trivy itself would find nothing, and say nothing of it."""
    world.buckets, world.advisories = buckets, {}
    parts = (world.part("alpha-core", "bash", ros=True), world.part("torch", "torch"))
    run = scanned(world, image("alpha-core-torch", *parts))
    assert run.outcome is Outcome.SCANNER_FAILED
    assert run.images[0].reason == says


# ---- once -----------------------------------------------------------------------------------------------------------
def test_a_shared_part_is_scanned_once(world: World) -> None:
    torch = world.part("torch", "torch")
    parts = [world.part(name, "bash", ros=True) for name in ("a", "b", "c")]
    run = scanned(world, *(image(f"{part.name}-torch", part, torch) for part in parts))
    assert [len(it.findings) for it in run.images] == [1, 1, 1]
    assert len(world.calls("sbom")) == 4


def test_a_shared_part_fails_once(world: World) -> None:
    torch = world.part("torch", "torch")
    world.fail = {torch.digest: "crash"}
    run = scanned(world, *(image(name, world.part(name, "bash", ros=True), torch) for name in ("a", "b")))
    assert {it.outcome for it in run.images} == {Outcome.SCANNER_FAILED}
    assert len(world.calls("sbom")) == 3


@pytest.mark.parametrize("content", [b"", b"[]", b"{}", b'{"bomFormat": "CycloneDX", "components": [1]}'])
def test_something_else_in_the_place_of_an_sbom(world: World, content: bytes) -> None:
    part = base(world)
    world.records[part.digest] = world.attach(part, content)
    assert scanned(world, image("a", part)).outcome is Outcome.SCANNER_FAILED


@pytest.mark.parametrize("place", ["subject", "content", "format"])
def test_the_records_vouch_for_no_sbom_of_another_image(world: World, place: str) -> None:
    """Whoever attached it: what it is attached to and what it says of itself have to be that image, and it has to be ours."""
    part, harmless = base(world), world.part("harmless", "bash", ros=True)
    of = harmless if place == "content" else part
    content = sbom_of(of.reference, ["bash"], "12.15")
    to = harmless if place == "subject" else part
    world.records[part.digest] = world.attach(to, content, {} if place == "format" else sbom.FORMAT)
    found = scanned(world, image("a", part)).images[0]
    assert found.outcome is Outcome.SCANNER_FAILED
    assert found.reason == "alpha-base: what the records name as its SBOM is another thing"


def test_an_image_without_an_sbom(world: World) -> None:
    part = base(world)
    artifact = world.records.pop(part.digest)
    assert scanned(world, image("a", part)).images[0].reason == "alpha-base: the records name no SBOM of it"
    world.records[part.digest] = artifact
    world.memory.attached.clear()
    assert scanned(world, image("a", part)).images[0].reason == "alpha-base: its SBOM is not there"


def test_a_registry_that_fails(world: World) -> None:
    class Broken(Memory):
        def manifest(self, repository: str, reference: str) -> Any:
            raise RosmlError("the registry answers 503", "try again")

    part, world.memory = base(world), Broken()
    found = scanned(world, image("a", part)).images[0]
    assert found.outcome is Outcome.SCANNER_FAILED
    assert found.reason.endswith("the registry answers 503")


def test_records_name_what_stops_an_image_first_and_not_everything(world: World) -> None:
    world.advisories = {"libc6": [advisory(f"CVE-2026-{number}", "CRITICAL", "") for number in range(100, 130)]}
    world.advisories["libc6"].append(advisory("CVE-2026-9", "HIGH", "2" * 200))
    found = scanned(world, image("alpha-base", base(world))).images[0]
    assert len(found.findings) == 31 and len(found.named) == 20
    assert [it["id"] for it in found.named][:2] == ["CVE-2026-9", "CVE-2026-100"], "though others are critical"
    assert (found.named[0]["fails"], found.named[0]["fixed"]) == (True, "2" * 128)


# ---- ignore entries -------------------------------------------------------------------------------------------------
def test_an_entry_ignores(world: World) -> None:
    run = scanned(world, image("alpha-base", base(world)), rules=rules(IGNORE))
    assert run.outcome is Outcome.CLEAN
    finding = run.images[0].findings[0]
    assert (finding.ignored, finding.until) == ("not reachable", "2027-01-31")
    assert run.images[0].matched == (0,)


def test_an_expired_entry_ignores_nothing_and_fails_the_run(world: World) -> None:
    over = rules(IGNORE.replace("2027-01-31", "2026-11-21"))
    run = scanned(world, image("alpha-base", base(world)), image("c", world.part("c", "bash", ros=True)), rules=over)
    assert [it.outcome for it in run.images] == [Outcome.POLICY_FAILED, Outcome.CLEAN]
    assert run.problems == (
        "scan.yaml:6:3: ignore[0]: CVE-2026-1 was ignored until 2026-11-21; look at it again: "
        "give it a new date, or remove it",
    )


def test_an_expired_entry_fails_a_run_without_findings(world: World) -> None:
    over = rules(IGNORE.replace("2027-01-31", "2026-11-21"))
    run = scanned(world, image("c", world.part("c", "bash", ros=True)), rules=over, whole=False)
    assert run.images[0].outcome is Outcome.CLEAN
    assert run.outcome is Outcome.POLICY_FAILED


def test_an_entry_that_matches_nothing_fails_the_run(world: World) -> None:
    found = rules(IGNORE + IGNORE.replace("CVE-2026-1", "CVE-2026-9"))
    run = scanned(world, image("alpha-base", base(world)), rules=found)
    assert run.images[0].outcome is Outcome.CLEAN
    assert run.outcome is Outcome.POLICY_FAILED
    assert run.problems == ("scan.yaml:7:3: ignore[1]: CVE-2026-9 is in no image that the entry is for; remove it",)


def test_an_entry_for_other_images_matches_nothing_here(world: World) -> None:
    found = rules(IGNORE.replace("reason", 'targets: "omega-*", reason'))
    run = scanned(world, image("alpha-base", base(world)), rules=found, targets=["alpha-base", "omega-base"])
    assert run.images[0].outcome is Outcome.POLICY_FAILED
    assert run.problems == (), "of omega-base nobody knows anything"
    (problem,) = scanned(world, image("alpha-base", base(world)), rules=found, targets=["alpha-base"]).problems
    assert "ignore[0]: 'omega-*' matches no image of the matrix" in problem


@pytest.mark.parametrize(
    ("entry", "said"),
    [
        ('targets: "omega-*"', ""),
        ('expires: 2026-11-01, targets: "omega-*"', ""),
        ("", ""),
        ('targets: "alpha-*"', "ignore[0]: CVE-2026-9 is in no image that the entry is for"),
        ('expires: 2026-11-01, targets: "*"', "ignore[0]: CVE-2026-9 was ignored until 2026-11-01"),
        ('targets: "omga-*"', "ignore[0]: 'omga-*' matches no image of the matrix"),
    ],
)
def test_entries_about_images_that_a_set_leaves_out_are_silent(world: World, entry: str, said: str) -> None:
    """They are in the policy of the matrix that it extends, whose own run names those of no use."""
    text = IGNORE.replace("CVE-2026-1", "CVE-2026-9")
    if "expires" in entry:
        text = text.replace(", expires: 2027-01-31", "")
    found = rules(text.replace("reason", f"{entry}, reason") if entry else text)
    bash = image("alpha-base", world.part("c", "bash", ros=True))
    run = scanned(world, bash, rules=found, targets=["alpha-base"], left_out=["omega-base"])
    assert [said in problem for problem in run.problems] == [True] * bool(said)
    whole = scanned(world, bash, rules=found, targets=["alpha-base", "omega-base"], whole=False)
    assert bool(whole.problems) == ("expires" in entry or "omga" in entry)


@pytest.mark.parametrize("case", ["a part of the run", "an image of which nothing is known"])
def test_an_entry_is_not_called_useless_too_soon(world: World, case: str) -> None:
    found = rules(IGNORE.replace("CVE-2026-1", "CVE-2026-9"))
    if case == "a part of the run":
        run = scanned(world, image("alpha-base", base(world)), rules=found, whole=False)
    else:
        world.fail = {digest("broken"): "crash"}
        run = scanned(world, image("b", world.part("broken", "bash", ros=True)), rules=found)
    assert run.problems == ()


def test_shards_are_summed_up(world: World) -> None:
    """An entry that matches in one shard is not useless because of another."""
    found = rules(IGNORE + IGNORE.replace("CVE-2026-1", "CVE-2026-9"))
    one = scanned(world, image("alpha-base", base(world)), rules=found, whole=False)
    two = scanned(world, image("c", world.part("c", "bash", ros=True)), rules=found, whole=False)
    whole = judge.summarise([*one.images, *two.images], found, NOW.date(), whole=True)
    assert [problem.split(": ")[2][:10] for problem in whole.problems] == ["CVE-2026-9"]


def test_entries_expire_by_the_runs_date(world: World) -> None:
    """Whatever the machine's clock says by the time an image is scanned."""
    program = world.trivy()
    program.fetch(rules().policy.database)
    scanner = judge.Scanner(program, world.shelf(), program.database())
    part = base(world)
    world.write()
    for day, outcome in ((date(2027, 1, 31), Outcome.CLEAN), (date(2027, 2, 1), Outcome.POLICY_FAILED)):
        assert judge.scan(image("alpha-base", part), rules(IGNORE), scanner, day).outcome is outcome
