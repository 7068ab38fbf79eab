"""`rosml dossier` as people call it."""

from __future__ import annotations

import json
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest
from click.testing import CliRunner

from fakes.dossiers import Shop, shop
from rosml.base.errors import RosmlError
from rosml.cli.images import dossier
from rosml.machine.services import Services
from rosml.registry import retries


@pytest.fixture
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Shop]:
    monkeypatch.setattr(retries, "WAIT", 0.001)
    monkeypatch.setenv("DOCKER_CONFIG", str(tmp_path / "docker"))
    monkeypatch.setattr(dossier, "ROOT", tmp_path)
    monkeypatch.chdir(tmp_path)
    machine = replace(Services.load(tmp_path, required=False), ca_bundle="")
    monkeypatch.setattr(Services, "load", lambda *_, **__: machine)
    with shop(tmp_path) as opened:
        yield opened


def called(*arguments: str) -> tuple[int, str, str]:
    done = CliRunner().invoke(dossier.main, [*arguments])
    if isinstance(done.exception, RosmlError):
        return done.exception.exit_code, done.stdout, done.exception.message
    return done.exit_code, done.stdout, done.stderr


def test_the_table_and_the_folder(place: Shop, tmp_path: Path) -> None:
    code, out, err = called(place.base(), "--platform", "linux/amd64")
    assert code == 0, err
    lines = out.splitlines()
    assert lines[0].split() == ["field", "asked", "by", "have", "it", "share", "why", "others", "lack", "it"]
    assert any(line.startswith("version") and "7 of 7" in line and "100 %" in line for line in lines)
    assert any(line.startswith("Debian 12") and "2028-06-30" in line for line in lines)
    assert lines[-1] == (tmp_path / "ros-core-dossier/index.html").as_uri()
    assert "warning: VEX: none is attached" in err and "had its end of support" in err


def test_json(place: Shop, tmp_path: Path) -> None:
    code, out, _ = called(place.base(), "--platform", "linux/amd64", "--json", "--output", "a.zip")
    facts = json.loads(out)
    assert code == 0 and facts["files"] == ["a.zip"] and (tmp_path / "a.zip").is_file()
    assert facts["fields"][0]["lists"] == ["NTIA"] and facts["signature"] == "none"


def test_an_image_of_nobody_is_still_written(place: Shop, tmp_path: Path) -> None:
    """Exit code 0: a dossier says what is missing."""
    code, _, err = called(place.base(with_sbom=False, annotations={}), "--platform", "linux/amd64")
    assert code == 0 and "SBOM: none of rosml is attached" in err
    assert (tmp_path / "ros-core-dossier/index.html").is_file()


def test_wrong_input(place: Shop, tmp_path: Path) -> None:
    reference = place.base()
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine/file").touch()
    for arguments, says in (
        ((f"{reference}x",), "is not there"),
        (("robot",), "is no reference"),
        ((reference, "--output", "mine"), "mine has other files than those of a dossier"),
        ((reference, "--platform", "arm64"), "is not for arm64"),
        ((reference, "--signer", "gone.pub"), "there is no public key gone.pub"),
    ):
        code, _, err = called(*arguments)
        assert code == 2 and says in err
    assert not [*tmp_path.glob("*dossier*")]


def test_a_folder_that_cannot_be_written(place: Shop, tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    code, _, err = called(place.base(), "--platform", "linux/amd64", "--output", "file/out")
    assert code == 1 and "file/out" in err
