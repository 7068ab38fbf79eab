"""A vulnerability is planted in a part below three apps of five. The real trivy finds it by their SBOMs, one rebase moves them, and then no app has it.

The apps are of a few bytes each, in a registry in this process: nothing is built or pulled. Needs no builder."""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner

from fakes.rebasing import FILES, App, Place, moving
from rosml.cli.containerize import affected, rebase
from rosml.containerize.rebase import screen
from rosml.images.scan import cyclonedx, sbom
from rosml.images.scan.packages import Apt, Packages, Python, System
from rosml.images.scan.sbom import Sbom
from rosml.machine.services import Services
from rosml.registry import references
from tests.e2e.vulnerabilities import installed, write_database

pytestmark = pytest.mark.full(proof="scanner")

CVE = "CVE-2026-90004"
"""In numpy before 99.0; CVE-2026-90001 is in each gpg."""

PART = "common-cpu-py311"


@pytest.fixture
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Place]:
    with moving(tmp_path, monkeypatch) as value:
        trivy = installed(tmp_path / "trivy", value.services.trusting())
        write_database(trivy.folder / "db")
        monkeypatch.setattr(screen, "scanner", lambda *_: trivy)
        monkeypatch.setattr(Services, "load", lambda *_, **__: value.services)
        yield value


def describe(place: Place, repository: str, reference: str, numpy: str, more: Sequence[str] = ()) -> None:
    """Attaches the SBOM of a ROS image and a part with numpy, and of an app's own wheels."""
    subject = place.image(repository, references.parse(reference).reference)
    name = f"{place.server.address}/{repository}@{subject.digest}"
    gpg = Apt(name="gpg", version="2.2.40-1.1", architecture="amd64", source="gnupg2", source_version="2.2.40-1.1")
    of_ros = Packages(system=System(name="debian", version="12.12"), apt=[gpg], python=[], ros=[])
    wheels = [Python(name="numpy", version=numpy), *(Python(name=it, version="1.0") for it in more)]
    of_part = Packages(system=System(name="", version=""), apt=[], python=wheels, ros=[])
    parts = [(part, Sbom(cyclonedx.document(it, part))) for part, it in (("core", of_ros), (PART, of_part))]
    data = cyclonedx.joined(name, 0.0, parts)
    place.registry.attach(repository, subject.descriptor, sbom.MEDIA_TYPE, data, sbom.MEDIA_TYPE, sbom.FORMAT)


def call(command: Any, *arguments: str) -> tuple[int, dict[str, Any]]:
    done = CliRunner().invoke(command, [*arguments, "--json"])
    assert done.stdout, done.exception
    return done.exit_code, json.loads(done.stdout)


def test_a_vulnerability_of_a_part_is_found_in_three_apps_and_one_rebase_fixes_them(
    place: Place, tmp_path: Path
) -> None:
    earlier, later = place.base("old"), place.base("new", files=FILES)
    describe(place, "rosml/ros", earlier, "2.1.0")
    describe(place, "rosml/ros", later, "99.0")
    for name, base, numpy in (
        ("a", earlier, "2.1.0"),
        ("b", earlier, "2.1.0"),
        ("c", earlier, "2.1.0"),
        ("d", later, "99.0"),
        ("e", later, "99.0"),
    ):
        describe(place, f"me/{name}", App(base, name=name).put(place.registry, "latest"), numpy)
    apps = tmp_path / "apps.yaml"
    apps.write_text("apps:\n" + "".join(f"  - app: {place.server.address}/me/{name}:latest\n" for name in "abcde"))

    code, before = call(affected.main, CVE, "--all", str(apps))
    assert (code, before["counts"]) == (3, {"affected": 3, "harmless": 0, "clear": 2, "unknown": 0})
    assert call(affected.main, "CVE-2026-90001", "--all", str(apps))[1]["counts"]["affected"] == 5, "it is in gpg"
    bad = [it for it in before["images"] if it["state"] == "affected"]
    assert {it["image"].rpartition("/")[2] for it in bad} == {"a:latest", "b:latest", "c:latest"}
    for it in bad:
        (hit,) = it["hits"]
        assert [hit[key] for key in ("name", "version", "part", "origin", "fixed")] == [
            "numpy",
            "2.1.0",
            PART,
            "base",
            "99.0",
        ]
        assert "has numpy as well" in it["fix"] and not it["command"]

    describe(place, "rosml/ros", place.base("old", files=FILES), "99.0")  # tonight's image
    (command,) = {it["command"] for it in call(affected.main, CVE, "--all", str(apps))[1]["images"] if it["command"]}
    assert command == f"rebase --all {apps} --fixes {CVE}"
    code, moved = call(rebase.main, *command.split()[1:])
    assert code == 0 and [it["state"] for it in moved["apps"]] == ["moved"] * 3 + ["unaffected"] * 2
    code, after = call(affected.main, CVE, "--all", str(apps))
    assert (code, after["counts"]["clear"]) == (0, 5)
