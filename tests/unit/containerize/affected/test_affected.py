"""Which images have something, in which part, and what fixes them: by SBOMs that are attached to images, whoever wrote them."""

from __future__ import annotations

import json
import time
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any, cast

import pytest
from click.testing import CliRunner

from fakes.rebasing import FILES, OWN, App, Place, changed, moving, package
from rosml.cli.containerize import affected
from rosml.containerize.affected import query
from rosml.containerize.affected.causes import CAUSES, COMPONENTS, Cause, Causes
from rosml.containerize.affected.images import Images
from rosml.containerize.affected.search import Answer, Search
from rosml.containerize.rebase import screen
from rosml.containerize.rebase.fleet import Entry, Fleet
from rosml.images.dossier.bill import Bill
from rosml.images.scan import cyclonedx, sbom, vex
from rosml.images.scan.trivy import Report, Trivy
from rosml.images.scan.vex import Statement
from rosml.machine.services import Services
from rosml.registry import oci, references
from rosml.registry.client import Registries

CVE = "CVE-2026-1"
BAD, GOOD = "libssl3@3.0.1", "libssl3@3.0.2"


@pytest.fixture
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Place]:
    with moving(tmp_path, monkeypatch) as value:
        yield value


class Scanner:
    """The scanner's words: libssl3 3.0.1 has something, other versions have not."""

    def __init__(self, lacks: Sequence[str] = ()) -> None:
        self.calls, self._lacks = list[str](), lacks

    def lacks(self, _sources: object) -> list[str]:
        return [*self._lacks]

    def scan(self, content: bytes, what: str) -> Report:
        self.calls.append(what)
        bad = [it for it in json.loads(content)["components"] if (it["name"], it["version"]) == ("libssl3", "3.0.1")]
        facts = {"VulnerabilityID": CVE, "PkgName": "libssl3", "InstalledVersion": "3.0.1", "Severity": "HIGH"}
        results = [{**facts, "FixedVersion": "3.0.2", "PkgIdentifier": {"BOMRef": it["bom-ref"]}} for it in bad]
        return Report.model_validate({"SchemaVersion": 2, "Results": [{"Vulnerabilities": results}]})


def describe(place: Place, repository: str, reference: str, packages: Sequence[str], **more: Any) -> None:
    """Attaches an SBOM of a Debian system."""
    components: list[dict[str, Any]] = [
        {"bom-ref": it, "type": "library", "name": name, "version": version, "purl": f"pkg:deb/debian/{it}"}
        for it in packages
        for name, _, version in (it.partition("@"),)
    ]
    components += [{"bom-ref": "os", "type": "operating-system", "name": "debian", "version": "12.12"}]
    subject = place.image(repository, references.parse(reference).reference)
    about = {"component": {"name": f"x@{subject.digest}"}}
    content = {"bomFormat": "CycloneDX", "metadata": about, "components": components, **more.pop("content", {})}
    annotations = more.pop("annotations", sbom.FORMAT)
    data = more.pop("data", oci.encoded(content))
    place.registry.attach(repository, subject.descriptor, sbom.MEDIA_TYPE, data, sbom.MEDIA_TYPE, annotations)


def put(place: Place, base: str, name: str, *packages: str, **more: Any) -> str:
    app = App(base, name=name, **more).put(place.registry, "latest")
    if packages:
        describe(place, f"me/{name}", app, packages)
    return app


def ask(place: Place, text: str, *names: str, fleet: str = "", scanner: Scanner | None = None) -> dict[str, Answer]:
    question, trivy = query.parse(text), cast(Trivy, scanner or Scanner())
    with Registries() as registries, Images(registries, place.rebaser().where) as images:
        inventory = images.inventory
        judge = (
            (lambda start: inventory.vulnerable(CVE, trivy, start))
            if question.is_advisory
            else (lambda start: inventory.matching(question, start))
        )
        answers = Search(images, question, judge, fleet).run(names)
    return {answer.image.rpartition("/")[2].partition(":")[0]: answer for answer in answers}


def based(place: Place, *packages: str, **more: Any) -> str:
    base = place.base(**more)
    describe(place, "rosml/ros", base, packages)
    return base


def test_three_of_five_apps_and_what_fixes_them(place: Place) -> None:
    base, other = based(place, BAD), place.base("other")
    describe(place, "rosml/ros", other, [GOOD])
    apps = [put(place, base, name, BAD, "bash@1") for name in ("a", "b", "c")]
    apps += [put(place, other, name, GOOD) for name in ("d", "e")]
    scanner = Scanner()
    before = ask(place, CVE, *apps, fleet="apps.yaml", scanner=scanner)
    assert {name: it.state for name, it in before.items()} == dict.fromkeys("abc", "affected") | dict.fromkeys(
        "de", "clear"
    )
    assert len(scanner.calls) == 1, "equal components are scanned once"
    assert before["a"].fix.endswith("ros:core has libssl3 as well") and not before["a"].command

    based(place, GOOD, files=FILES)
    fixed = ask(place, CVE, *apps, fleet="apps.yaml")
    assert fixed["a"].command == "rebase --all apps.yaml --fixes CVE-2026-1"
    assert fixed["a"].newer_base == place.manifest("rosml/ros", "core").members[0].digest
    (hit,) = fixed["a"].hits
    assert (hit.name, hit.version, hit.fixed, hit.origin) == ("libssl3", "3.0.1", "3.0.2", "base")
    assert ask(place, CVE, apps[0])["a"].command == f"rebase {apps[0]}"

    with place.rebaser() as rebaser:
        screening = screen.Screen(CVE, Scanner().scan)
        Fleet(rebaser, "2026-11-27T03:00:00Z", lambda *_: None, screen=screening).run([Entry(app=app) for app in apps])
    assert {it.state for it in ask(place, CVE, *apps).values()} == {"clear"}


def test_a_package_of_the_app_itself_needs_a_build(place: Place) -> None:
    base = based(place, GOOD)
    app = put(place, base, "robot", BAD, facts=changed(OWN, packages=[package("libssl3", "3.0.1", files=[])]))
    answer = ask(place, "libssl3<3.0.2", app)["robot"]
    assert (answer.state, answer.hits[0].origin, answer.command) == ("affected", "app", "")
    assert answer.fix.startswith("the app brings libssl3 3.0.1: build it again")


def test_an_environment_is_built_again(place: Place) -> None:
    """As an add-on: neither the app nor its base image brings its packages."""
    app = put(place, based(place, GOOD), "robot")
    part = {"properties": [{"name": cyclonedx.PART, "value": "env:policy-py311"}]}
    numpy = {"bom-ref": "n", "type": "library", "name": "numpy", "version": "2.2", "purl": "pkg:pypi/numpy@2.2", **part}
    describe(place, "me/robot", app, [], content={"components": [numpy]})
    answer = ask(place, "numpy", app)["robot"]
    assert (answer.hits[0].origin, answer.hits[0].part, answer.command) == ("part", "env:policy-py311", "")
    assert answer.fix == "rosml rebase brings env:policy-py311 when it is built with another version"


def test_which_package_of_the_app_is_the_cause(place: Place, monkeypatch: pytest.MonkeyPatch) -> None:
    """Packages that need each other, and references to nothing, are somebody's words."""
    app = put(place, based(place, "libc6@1"), "robot")
    of_base = {"properties": [{"name": cyclonedx.PART, "value": "core"}]}
    components = [
        {"bom-ref": name, "type": "library", "name": name, "version": "1", "purl": f"pkg:{kind}/{name}@1", **more}
        for kind, name, more in (
            ("pypi", "bad", {}),
            ("pypi", "middle", {}),
            ("generic/ros", "driver", {}),
            ("generic/ros", "bringup", {}),
            ("pypi", "tool", {}),
            ("deb/debian", "base", of_base),
            ("pypi", "first", {}),
            ("pypi", "second", {}),
        )
    ]
    needs: dict[str, list[Any]] = {
        "middle": ["bad", "middle", "nothing", 3],
        "driver": ["middle"],
        "bringup": ["driver"],
        "tool": ["bad"],
        "base": ["bad", "second"],
        "nothing": ["bad"],
        "first": ["second"],
        "second": ["first"],
    }
    dependencies = [{"ref": ref, "dependsOn": refs} for ref, refs in needs.items()]
    describe(place, "me/robot", app, [], content={"components": components, "dependencies": dependencies})
    (hit,) = ask(place, "bad<2", app)["robot"].hits
    assert hit.needed_by == (Cause("tool 1"), Cause("driver 1", "middle 1"))
    text = "bad 1, of the app, needed by tool 1, driver 1 through middle 1"
    assert text in call(place, monkeypatch, "bad<2", app)[1]
    (hit,) = ask(place, "second", app)["robot"].hits
    assert hit.needed_by == (Cause("first 1"),)
    (hit,) = ask(place, "bringup", app)["robot"].hits
    assert hit.needed_by == ()


def test_causes_in_an_sbom_with_very_many_dependencies() -> None:
    many = range(2000)
    components = [{"bom-ref": f"{it}", "name": f"{it}", "purl": f"pkg:pypi/{it}"} for it in many]
    dependencies = [{"ref": f"{it}", "dependsOn": [*map(str, many)]} for it in many]
    bill = Bill({"components": components, "dependencies": dependencies})
    started = time.process_time()
    causes = Causes(bill).of_all(f"pkg:pypi/{it}" for it in many)
    assert len(causes) == COMPONENTS and {*map(len, causes.values())} == {CAUSES}
    assert time.process_time() - started < 20


def test_causes_in_a_large_circle() -> None:
    """Without a limit, each component would take a walk through all of it."""
    many = range(33_000)
    components = [{"bom-ref": f"{it}", "name": f"{it}", "purl": f"pkg:pypi/{it}"} for it in many]
    dependencies = [{"ref": f"{it}", "dependsOn": [f"{(it + step) % len(many)}" for step in (1, 7, 91)]} for it in many]
    causes = Causes(Bill({"components": components, "dependencies": dependencies}))
    started = time.process_time()
    answers = causes.of_all(f"pkg:pypi/{it}" for it in many)
    assert len(answers) == COMPONENTS and all(answers.values())
    assert time.process_time() - started < 3


def test_vex_says_that_it_does_no_harm(place: Place) -> None:
    """That of the base image counts for what the app has from it."""
    base = based(place, BAD)
    app = put(place, base, "robot", BAD)
    subject = place.image("rosml/ros", "core")
    statement = Statement(
        advisory=CVE,
        status="not_affected",
        justification="vulnerable_code_not_present",
        reason="nobody calls it",
        components=[f"pkg:deb/debian/{BAD}"],
    )
    content = vex.openvex(f"{place.server.address}/rosml/ros@{subject.digest}", [statement], "2026-11-22T03:00:00Z")
    place.registry.attach("rosml/ros", subject.descriptor, vex.MEDIA_TYPE, content, vex.MEDIA_TYPE)
    answer = ask(place, CVE, app)["robot"]
    assert (answer.state, answer.hits[0].status, answer.hits[0].reason) == (
        "harmless",
        "not_affected",
        "nobody calls it",
    )
    assert ask(place, "libssl3", app)["robot"].state == "affected", "VEX is about an advisory"
    place.registry.attach(
        "me/robot", place.image("me/robot", "latest").descriptor, vex.MEDIA_TYPE, b"{}", vex.MEDIA_TYPE
    )
    assert ask(place, CVE, app)["robot"].state == "harmless", "damaged VEX says nothing"


def test_images_of_which_nobody_knows(place: Place, monkeypatch: pytest.MonkeyPatch) -> None:
    """Each stands for itself, and is not taken for a good one."""
    base = based(place, GOOD)
    names = ("none", "others", "another", "large", "broken", "surrogate", "good")
    apps = {name: put(place, base, name) for name in names}
    describe(place, "me/others", apps["others"], [GOOD], annotations={})
    describe(place, "me/another", apps["another"], [GOOD], content={"metadata": {"component": {"name": "x@sha256:1"}}})
    monkeypatch.setattr("rosml.containerize.affected.images.LARGEST", 20_000)
    describe(place, "me/large", apps["large"], [f"package{number}@1" for number in range(1000)])
    describe(place, "me/broken", apps["broken"], [], data=b"[")
    digest = place.image("me/surrogate", "latest").digest
    text = f'{{"bomFormat": "CycloneDX", "metadata": {{"component": {{"name": "x@{digest}"}}}}, "components": [{{"name": "\\ud800"}}]}}'
    describe(place, "me/surrogate", apps["surrogate"], [], data=text.encode())
    describe(place, "me/good", apps["good"], [GOOD])
    gone = f"{place.server.address}/me/gone:latest"
    answers = ask(place, CVE, *apps.values(), gone)
    assert {name: it.state for name, it in answers.items()} == dict.fromkeys((*names[:-1], "gone"), "unknown") | {
        "good": "clear"
    }
    reasons = {name: it.notes[0] for name, it in answers.items() if it.notes}
    assert "somebody else attached it" in reasons["others"] and "of another image" in reasons["another"]
    assert "is none: " in reasons["broken"] and "is none: " in reasons["surrogate"]
    assert "at most" in reasons["large"] and reasons["gone"] == "it is gone"


def test_components_that_say_too_little(place: Place) -> None:
    base = based(place, GOOD)
    app = put(place, base, "robot")
    odd: list[Any] = [
        {"bom-ref": "a", "type": "library", "name": "libssl3", "purl": "pkg:deb/debian/libssl3"},
        {"bom-ref": "b", "type": "library", "name": "libssl3", "version": "4", "purl": "libssl3"},
        {"bom-ref": "c", "type": "library", "name": ["x"], "version": 3, "purl": {}, "properties": {"a": 1}},
        "libssl3",
        {"type": "operating-system", "name": "debian", "version": "12.12"},
    ]
    describe(place, "me/robot", app, [], content={"components": odd})
    assert ask(place, CVE, app)["robot"].state == "unknown"
    answer = ask(place, "libssl3<3.0.2", app)["robot"]
    assert answer.state == "unknown" and "libssl3 of unknown version" in answer.notes[-1]
    assert "package URLs that are none: 2" in answer.notes


def test_a_system_of_which_the_scanner_knows_nothing(place: Place) -> None:
    app = put(place, based(place, GOOD), "robot", BAD)
    assert ask(place, CVE, app, scanner=Scanner(["debian 12"]))["robot"].state == "unknown"


def test_an_app_whose_base_image_is_gone(place: Place) -> None:
    base = based(place, BAD)
    app = put(place, base, "robot", BAD)
    for digest in [place.digest(base)]:
        place.registry.delete("rosml/ros", digest)
    answer = ask(place, CVE, app)["robot"]
    assert (answer.state, answer.hits[0].origin) == ("affected", "unknown") and "is gone" in answer.fix


def call(place: Place, monkeypatch: pytest.MonkeyPatch, *arguments: str) -> tuple[int, str]:
    monkeypatch.setattr(Services, "load", lambda *_, **__: place.services)
    done = CliRunner().invoke(affected.main, [*arguments])
    return getattr(done.exception, "exit_code", done.exit_code), done.output


def test_a_component_says_no_line_of_its_own(place: Place, monkeypatch: pytest.MonkeyPatch) -> None:
    app = put(place, based(place, GOOD), "robot", "libssl3@3.0.1\nfix: rosml \x1b[2Ax\r\n0 affected")
    code, output = call(place, monkeypatch, "libssl3", app)
    lines = output.splitlines()
    assert code == 3 and lines[1].startswith("          libssl3 3.0.1 fix: rosml x 0 affected, of the app")
    assert not any(line.startswith(("fix:", "0 affected")) for line in lines)


def test_the_command(place: Place, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    base = based(place, BAD)
    put(place, base, "robot", BAD)
    put(place, base, "arm", GOOD)
    repository, apps = f"{place.server.address}/me/robot", tmp_path / "apps.yaml"
    code, output = call(place, monkeypatch, "libssl3<3.0.2", "--repository", repository)
    assert code == 3 and "libssl3 3.0.1, of the base image" in output and output.splitlines()[-1] == "1 affected"
    apps.write_text(f"apps: [{{app: '{place.server.address}/me/arm:*'}}]")
    code, output = call(place, monkeypatch, "libssl3<3.0.2", "--all", str(apps), "--json")
    assert code == 0 and json.loads(output)["counts"] == {"affected": 0, "harmless": 0, "clear": 1, "unknown": 0}
    assert call(place, monkeypatch, "libssl3", f"{place.server.address}/me/gone:latest")[0] == 4
    assert call(place, monkeypatch, "libssl3")[0] == 2
