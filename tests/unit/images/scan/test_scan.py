"""Scanning: each part once, the outcome by the policy, and no failure that is taken for a clean image."""

from __future__ import annotations

import json
import re
from dataclasses import replace
from datetime import timedelta
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner
from conftest import ROOT

from fakes.http_registry import local_registry
from fakes.memory_registry import MemoryRegistry, sbom_of
from fakes.scanning import NOW, VERSION, World, advisory, digest, image, rules
from fakes.stubs import services
from rosml.base.errors import RosmlError
from rosml.base.programs import pinned_version
from rosml.cli.images import publish
from rosml.images.scan import judge, sbom, trivy
from rosml.images.scan.judge import Outcome, Scanned
from rosml.images.scan.policy import DatabaseRules
from rosml.images.scan.trivy import ScannerFailed, Trivy
from rosml.machine.services import Services
from rosml.registry import oci
from rosml.registry.client import Registry

INSTALL = "run 'rosml setup scanner'"


@pytest.fixture
def world(tmp_path: Path) -> World:
    """A database that knows a vulnerability of libc6 and one of torch."""
    advisories = {"libc6": [advisory("CVE-2026-1")], "torch": [advisory("CVE-2026-2", "CRITICAL", "3.0")]}
    return World(tmp_path, advisories=advisories)


def scanned(world: World, *parts: judge.Part, **options: Any) -> Scanned:
    return world.run(image("alpha-base", *parts), **options).images[0]


def base(world: World) -> judge.Part:
    return world.part("alpha-base", "bash", "libc6", ros=True)


def harmless(world: World, name: str = "c") -> judge.Part:
    return world.part(name, "bash", ros=True)


# ---- outcomes -------------------------------------------------------------------------------------------------------


def test_clean(world: World) -> None:
    result = world.run(image("alpha-core", harmless(world, "alpha-core")))
    assert (result.outcome, result.outcome.exit_code) == (Outcome.CLEAN, 0)
    (scan,) = result.images
    assert (scan.reason, scan.packages, scan.findings) == ("no findings", 1, ())
    assert scan.parts == {"alpha-core": digest("alpha-core")}
    assert scan.database and (scan.database.updated, scan.database.source) == (
        "2026-11-22T00:00:00Z",
        "example.org/db:2",
    )


def test_the_policy_stops_an_image(world: World) -> None:
    result = world.run(image("alpha-base-torch", base(world), world.part("torch", "torch", "numpy")))
    assert (result.outcome, result.outcome.exit_code) == (Outcome.POLICY_FAILED, 3)
    (scan,) = result.images
    assert scan.reason == "2 findings that the policy does not allow: CVE-2026-2 in torch, CVE-2026-1 in libc6"
    assert [(it.severity, it.id, it.package, it.installed, it.fixed, it.part) for it in scan.failing] == [
        ("critical", "CVE-2026-2", "torch", "1.0", "3.0", "torch"),
        ("high", "CVE-2026-1", "libc6", "1.0", "2.0", "alpha-base"),
    ]
    assert scan.packages == 4


@pytest.mark.parametrize(
    ("severity", "fixed", "changes", "stops"),
    [
        ("HIGH", "2.0", {}, True),
        ("MEDIUM", "2.0", {}, False),
        ("UNKNOWN", "2.0", {}, True),
        ("UNKNOWN", "", {}, False),
        ("UNKNOWN", "2.0", {"version": "1\nunknown: list"}, False),
        ("UNKNOWN", "2.0", {"fail": "[unknown]", "version": "1\nunknown: list"}, True),
        ("HIGH", "", {}, False),
        ("HIGH", "", {"fixable_only": "false"}, True),
        ("HIGH", "2.0", {"fail": "[critical]"}, False),
    ],
)
def test_severity_and_fix_decide(world: World, severity: str, fixed: str, changes: dict[str, str], stops: bool) -> None:
    world.advisories = {"libc6": [advisory("CVE-2026-1", severity, fixed)]}
    scan = scanned(world, base(world), rules=rules(**changes))
    assert scan.outcome is (Outcome.POLICY_FAILED if stops else Outcome.CLEAN) and len(scan.findings) == 1


def test_one_image_does_not_stop_another(world: World) -> None:
    world.fail = {digest("broken"): "crash"}
    parts = (harmless(world, "broken"), harmless(world), base(world))
    result = world.run(*(image(part.name, part) for part in parts))
    outcomes = [Outcome.SCANNER_FAILED, Outcome.CLEAN, Outcome.POLICY_FAILED]
    assert [scan.outcome for scan in result.images] == outcomes
    assert (result.outcome, result.outcome.exit_code) == (Outcome.SCANNER_FAILED, 4)


def test_findings_of_other_parts_count_beside_a_part_that_failed(world: World) -> None:
    part = world.part("torch", "torch")
    world.fail = {part.digest: "crash"}
    scan = scanned(world, base(world), part)
    assert scan.outcome is Outcome.SCANNER_FAILED, "nobody knows the whole image"
    assert [it.id for it in scan.failing] == ["CVE-2026-1"]


def test_an_image_without_parts_is_not_clean(world: World) -> None:
    assert scanned(world).outcome is Outcome.SCANNER_FAILED


def test_the_records_get_what_stops_an_image_first_and_not_everything(world: World) -> None:
    world.advisories = {"libc6": [advisory(f"CVE-2026-{number}", "CRITICAL", "") for number in range(100, 130)]}
    world.advisories["libc6"].append(advisory("CVE-2026-9", "HIGH", "2" * 200))
    scan = scanned(world, base(world))
    assert len(scan.findings) == 31 and len(scan.recorded) == 20
    assert [it["id"] for it in scan.recorded][:2] == ["CVE-2026-9", "CVE-2026-100"], "though others are critical"
    assert (scan.recorded[0]["fails"], scan.recorded[0]["fixed"]) == (True, "2" * 128)


# ---- the scanner fails ----------------------------------------------------------------------------------------------


def report(**result: Any) -> str:
    return json.dumps({"SchemaVersion": 2, "Results": [result]})


@pytest.mark.parametrize(
    ("behaviour", "reason"),
    [
        ("crash", "run error: it crashed * for two * reasons"),
        ("killed", "exit code -9"),
        ("silent", "exit code 7"),
        ("nothing", "trivy did not write a report about alpha-base: it is no JSON"),
        ("[]", "did not write a report"),
        ('{"SchemaVersion": 3, "Results": []}', "did not write a report"),
        ('{"SchemaVersion": 2}', "trivy looked at 0 of 2 packages"),
        (report(Type="debian", Vulnerabilities=[{"VulnerabilityID": "CVE-2026-1"}]), "did not write a report"),
        (report(Type="t", Vulnerabilities=[{**advisory("C", "DREADFUL"), "PkgName": "a", "InstalledVersion": "1"}]), "the severity 'dreadful'"),
        ("hang", "trivy did not end within 0 s"),
    ],
)  # fmt: skip
def test_the_scanner_fails(world: World, behaviour: str, reason: str) -> None:
    world.fail = {"sbom": behaviour}
    scan = scanned(world, base(world), trivy={"scan_seconds": 0.3} if behaviour == "hang" else {})
    assert scan.outcome is Outcome.SCANNER_FAILED and reason in scan.reason


def test_packages_that_were_not_checked(world: World) -> None:
    """Trivy says little of an operating system that it does not know: no finding is no good news then."""
    world.fail = {"missed": 1}
    scan = scanned(world, world.part("alpha-core", "bash", "tar", ros=True))
    assert (scan.outcome, scan.reason) == (Outcome.SCANNER_FAILED, "alpha-core: trivy looked at 1 of 2 packages")


@pytest.mark.parametrize(
    ("packages", "ros", "system", "reason"),
    [
        ((), True, "12", "no Debian package"),
        (("bash",), True, "", "no operating system"),
        ((), False, "", "torch: its SBOM names no package, and a part is made of wheels"),
    ],
)
def test_an_sbom_that_lacks_packages_is_not_clean(
    world: World, packages: tuple[str, ...], ros: bool, system: str, reason: str
) -> None:
    scan = scanned(world, world.part("torch", *packages, ros=ros, system=system))
    assert scan.outcome is Outcome.SCANNER_FAILED and reason in scan.reason


def test_a_system_without_advisories_is_noted(world: World) -> None:
    world.eosl = True
    assert scanned(world, harmless(world)).notes[0].startswith("c: debian 12.15 gets no advisories any more")


def test_the_system_of_a_library_in_a_wheel_does_not_count() -> None:
    """As auditwheel's SBOMs have it: without a version."""
    foreign = [
        {"bom-ref": "a", "type": "operating-system", "name": "almalinux"},
        {"bom-ref": "b", "type": "library", "name": "libgfortran", "purl": "pkg:rpm/almalinux/libgfortran@8.5.0"},
    ]
    wheel = {"bom-ref": "c", "type": "library", "name": "numpy", "purl": "pkg:pypi/numpy@1"}
    system = {"bom-ref": "d", "type": "operating-system", "name": "debian", "version": "12.12"}
    package = {"bom-ref": "e", "type": "library", "name": "libc6", "purl": "pkg:deb/debian/libc6@2.36"}
    for components, sources in (([wheel], ["pip::"]), ([system, package, wheel], ["debian 12", "pip::"])):
        document = sbom.Sbom(json.dumps({"bomFormat": "CycloneDX", "components": [*foreign, *components]}).encode())
        assert document.sources == sources
        assert [item.name for item in document.packages] == [it["name"] for it in components if it is not system]


# ---- the program ----------------------------------------------------------------------------------------------------


def test_another_version(world: World) -> None:
    world.version = "0.64.1"
    with pytest.raises(ScannerFailed, match=r"is trivy 0\.64\.1, and 0\.65\.0 is pinned") as caught:
        world.trivy()
    assert (caught.value.exit_code, caught.value.remedy) == (4, INSTALL)


@pytest.mark.parametrize("text", [None, "{", "{}", "[]", '{"trivy": "/nowhere/trivy"}'])
def test_no_program(tmp_path: Path, text: str | None) -> None:
    (tmp_path / ".state").mkdir()
    (tmp_path / "tools/go/trivy").mkdir(parents=True)
    (tmp_path / "tools/go/trivy/go.mod").write_text(f"\tgithub.com/aquasecurity/trivy v{VERSION}\n")
    if text is not None:
        (tmp_path / ".state/scanner.json").write_text(text)
    with pytest.raises(ScannerFailed) as caught:
        Trivy.find(tmp_path)
    assert caught.value.remedy == INSTALL


def test_the_projects_pins(tmp_path: Path) -> None:
    assert pinned_version(ROOT, "trivy", ScannerFailed) == VERSION
    assert re.fullmatch(r"3\.\d+\.\d+", pinned_version(ROOT, "cosign", RosmlError))
    with pytest.raises(ScannerFailed, match="No such file"):
        pinned_version(tmp_path, "trivy", ScannerFailed)


def test_no_setting_of_the_user_changes_findings(world: World) -> None:
    """Neither variables nor files in the folder; how to reach a registry is theirs to say."""
    program = world.trivy()
    program.environment = {"TRIVY_SEVERITY": "LOW", "TRIVY_INSECURE": "true", "TRIVY_PASSWORD": "secret", "HOME": "/h"}
    program.run("--version", seconds=10)
    environment = json.loads((world.folder / "environment").read_text())
    assert "TRIVY_SEVERITY" not in environment
    assert [environment[name] for name in ("TRIVY_INSECURE", "TRIVY_PASSWORD", "HOME")] == ["true", "secret", "/h"]
    assert environment["FOLDER"] != str(Path.cwd())
    assert "secret" not in repr(program)


# ---- the database ---------------------------------------------------------------------------------------------------


def databases(*repositories: str) -> DatabaseRules:
    return rules(database=f"{{repositories: {[*repositories]}, max_age_hours: 48}}").policy.database


def test_no_database(world: World) -> None:
    images = [image("a", base(world)), image("b", base(world))]
    scans = judge.scan_images(images, rules(), judge.Scanner(world.trivy(), world.shelf()), NOW)
    assert [scan.outcome for scan in scans] == [Outcome.SCANNER_FAILED] * 2
    assert "there is no database" in scans[0].reason and scans[0].database is None
    assert not world.calls("sbom")


@pytest.mark.parametrize(
    "text", ["", "{}", "[]", '{"UpdatedAt": "yesterday"}', '{"UpdatedAt": "0001-01-01T00:00:00Z"}']
)
def test_a_damaged_database(world: World, text: str) -> None:
    program = world.ready()
    (program.folder / "db/metadata.json").write_text(text)
    with pytest.raises(ScannerFailed, match="is damaged"):
        program.database()


def test_a_database_of_another_format(world: World) -> None:
    world.schema = 3
    with pytest.raises(ScannerFailed, match="has format 3, and trivy reads 2"):
        world.ready()


def test_a_new_format_of_the_database_is_no_other_format_of_reports(
    world: World, monkeypatch: pytest.MonkeyPatch
) -> None:
    """trivy may change one without the other; its repositories name the database's as their tag."""
    monkeypatch.setattr(trivy, "DATABASE_FORMAT", 3)
    world.schema = 3
    assert scanned(world, harmless(world)).outcome is Outcome.CLEAN
    assert trivy.resolve(databases("example.org/db"), str) == "example.org/db@example.org/db:3"


@pytest.mark.parametrize(
    ("hours", "reason"),
    [(48, ""), (52, "was made 52 hours ago"), (24 * 30, "was made 30 days ago"), (-5, "made in the future")],
)
def test_the_age_of_the_database(world: World, hours: int, reason: str) -> None:
    scan = scanned(world, harmless(world), now=NOW - timedelta(hours=3) + timedelta(hours=hours))
    assert scan.outcome is (Outcome.SCANNER_FAILED if reason else Outcome.CLEAN) and reason in scan.reason


def test_the_next_repository_is_asked(world: World) -> None:
    world.sources = ("example.net/db:2",)
    lines: list[str] = []
    repositories = databases("example.org/db:2", "example.net/db:2")
    assert world.trivy().fetch(repositories, say=lines.append).source == "example.net/db:2"
    assert [line.rpartition(" ")[2] for line in lines] == list(repositories.repositories)


def test_no_repository_answers(world: World) -> None:
    """Nor is the database of yesterday taken for today's."""
    program = world.ready()
    world.sources = ()
    world.write()
    with pytest.raises(ScannerFailed) as caught:
        program.fetch(rules().policy.database)
    assert caught.value.message.count("MANIFEST_UNKNOWN") == 1
    assert len(world.calls("--download-db-only")) == 1 + trivy.ATTEMPTS
    with pytest.raises(ScannerFailed, match="there is no database"):
        program.database()


def _head(reference: str) -> str:
    if reference.startswith("down"):
        raise RosmlError("it is down")
    return digest("state") if reference == "example.net/db:2" else ""


def test_shards_fetch_the_same_state(world: World) -> None:
    state = f"example.net/db@{digest('state')}"
    world.sources = (state,)
    assert trivy.resolve(databases("example.net/db"), _head) == state
    assert world.trivy().fetch(rules().policy.database, state).source == state
    with pytest.raises(ScannerFailed) as caught:
        trivy.resolve(databases("down:5000/db:2", "example.org/none"), _head)
    lines = caught.value.message.splitlines()
    assert lines[1:] == ["    down:5000/db:2: it is down", "    example.org/none:2: there is no such tag"]


def test_the_command_prints_the_newest_state(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    machine = services(tmp_path)
    monkeypatch.setattr(Services, "load", lambda root: machine)
    with local_registry() as server:
        state = Registry(server.address).put_manifest("me/db", "2", b"{}", oci.INDEX)
        policy = tmp_path / "scan.yaml"
        text = (ROOT / "scan.yaml").read_text()
        policy.write_text(re.sub(r"repositories: .*", f"repositories: ['{server.address}/me/db:2']", text))
        done = CliRunner().invoke(publish.main, ["database", "--policy", str(policy)])
    assert (done.exit_code, done.output) == (0, f"{server.address}/me/db@{state}\n")


def test_a_database_that_changes_during_the_run(world: World) -> None:
    part, program = base(world), world.ready()

    def exchange(line: str) -> None:
        if line.startswith("scan"):
            world.advisories = {"bash": [advisory("CVE-2026-3")]}
            world.write()
            program.fetch(rules().policy.database)

    (scan,) = judge.scan_images([image("a", part)], rules(), judge.Scanner(program, world.shelf(), exchange), NOW)
    assert scan.outcome is Outcome.SCANNER_FAILED and "changed during the run" in scan.reason


@pytest.mark.parametrize(
    ("buckets", "reason"),
    [
        ("debian 11, pip::GitHub", "alpha-core: the database knows nothing of debian 12"),
        ("debian 12", "torch: the database knows nothing of pip::"),
    ],
)
def test_a_database_that_knows_nothing_of_the_system(world: World, buckets: str, reason: str) -> None:
    """Trivy itself would find nothing, and not say why."""
    world.buckets, world.advisories = buckets, {}
    scan = scanned(world, harmless(world, "alpha-core"), world.part("torch", "torch"))
    assert (scan.outcome, scan.reason) == (Outcome.SCANNER_FAILED, reason)


# ---- SBOMs ----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("fails", [False, True])
def test_a_shared_part_is_scanned_once(world: World, fails: bool) -> None:
    torch = world.part("torch", "torch")
    world.fail = {torch.digest: "crash"} if fails else {}
    images = [image(name, harmless(world, name), torch) for name in ("a", "b", "c")]
    scans = world.run(*images).images
    assert {scan.outcome for scan in scans} == {Outcome.SCANNER_FAILED if fails else Outcome.POLICY_FAILED}
    assert len(world.calls("sbom")) == 4


@pytest.mark.parametrize("content", [b"", b"[]", b"{}", b'{"bomFormat": "CycloneDX", "components": [1]}'])
def test_an_sbom_that_is_none(world: World, content: bytes) -> None:
    part = base(world)
    world.records[part.digest] = world.attach(part, content)
    assert scanned(world, part).outcome is Outcome.SCANNER_FAILED


@pytest.mark.parametrize("field", ["subject", "content", "format"])
def test_the_records_vouch_for_no_sbom_of_another_image(world: World, field: str) -> None:
    """The manifest to which it is attached and its content have to be of that image, and it has to be ours."""
    part, other = base(world), harmless(world, "harmless")
    content = sbom_of((other if field == "content" else part).reference, ["bash"], "12.15")
    annotations = {} if field == "format" else sbom.FORMAT
    subject = replace(part, digest=other.digest) if field == "subject" else part
    world.records[part.digest] = world.attach(subject, content, annotations)
    scan = scanned(world, part)
    assert scan.outcome is Outcome.SCANNER_FAILED
    assert scan.reason == "alpha-base: what the records name as its SBOM is another thing"


def test_an_image_without_an_sbom(world: World) -> None:
    part = base(world)
    artifact = world.records.pop(part.digest)
    assert scanned(world, part).reason == "alpha-base: the records name no SBOM of it"
    world.records[part.digest] = artifact
    world.memory.manifests.clear()
    assert scanned(world, part).reason == "alpha-base: its SBOM is not there"


def test_a_registry_that_fails(world: World) -> None:
    class Broken(MemoryRegistry):
        def manifest(self, repository: str, reference: str) -> Any:
            raise RosmlError("the registry answers 503", "try again")

    part, world.memory = base(world), Broken()
    scan = scanned(world, part)
    assert scan.outcome is Outcome.SCANNER_FAILED and scan.reason.endswith("the registry answers 503")
