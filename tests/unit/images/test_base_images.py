"""Base images: which one is taken where the machine's set-up, or a variable, names another one than matrix.yaml."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from fakes.stubs import calls, executable, load
from rosml.base.errors import RosmlError
from rosml.images.builds import base_images
from rosml.images.builds.base_images import Assembler
from rosml.images.matrix.model import OperatingSystem
from rosml.machine.services import Services

DIGEST, OTHER = f"sha256:{'a' * 64}", f"sha256:{'b' * 64}"
OFFICIAL = f"docker.io/library/system:1@{DIGEST}"
GIVEN = f"registry.test:5000/copy:1@{OTHER}"
VARIABLE = "OS_SYSTEM_1_0"


SYSTEMS = {
    "system-1.0": OperatingSystem(
        image="docker.io/library/system:1",
        digest=DIGEST,
        python="3.12",
        numpy="<2",
        architectures=("amd64",),
        tools="git",
    )
}


@pytest.fixture(autouse=True)
def native(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(base_images, "native_architecture", lambda: "amd64")
    monkeypatch.delenv(VARIABLE, raising=False)


def answering(folder: Path, answer: dict[str, Any] | str, code: int = 0) -> Services:
    """A machine whose set-up names a command that answers so."""
    text = answer if isinstance(answer, str) else json.dumps(answer)
    script = f"echo \"$*\" >>'{folder}/calls'\necho '{text}'\nexit {code}"
    return load(folder, bases=[executable(folder / "bases", script)])


def test_the_official_image(tmp_path: Path) -> None:
    services = load(tmp_path)
    assert base_images.reference(services, SYSTEMS, "system-1.0") == OFFICIAL
    assert base_images.reference(services, SYSTEMS, "system-1.0", "arm64") == OFFICIAL
    assert base_images.assembler(services, SYSTEMS, "system-1.0", "3.12") == Assembler(OFFICIAL, "3.12")
    assert base_images.missing(services, SYSTEMS, "system-1.0") == ""


@pytest.mark.parametrize("before", ["", "docker-image://"])
def test_a_variable_names_another(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, before: str) -> None:
    """Whatever the machine's command would say."""
    services = answering(tmp_path, {"error": "asked"}, 1)
    monkeypatch.setenv(VARIABLE, before + GIVEN)
    assert base_images.reference(services, SYSTEMS, "system-1.0") == GIVEN
    assert base_images.assembler(services, SYSTEMS, "system-1.0", "3.12") == Assembler(GIVEN, "3.12")
    assert base_images.missing(services, SYSTEMS, "system-1.0") == ""
    assert calls(tmp_path) == []


@pytest.mark.parametrize(
    "text", ["registry.test/copy:1", f"registry.test/copy:1@{OTHER}0", f"a b@{OTHER}", f"@{OTHER}"]
)
def test_a_variable_without_a_digest(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, text: str) -> None:
    monkeypatch.setenv(VARIABLE, text)
    for ask in (base_images.reference, base_images.missing):
        with pytest.raises(RosmlError, match=f"{VARIABLE} names no image by its digest") as caught:
            ask(load(tmp_path), SYSTEMS, "system-1.0")
        assert caught.value.exit_code == 2


def test_the_command_is_asked_once(tmp_path: Path) -> None:
    services = answering(tmp_path, {"reference": GIVEN, "python": "3.12.9", "missing": "nobody has it"})
    for _ in range(2):
        assert base_images.reference(services, SYSTEMS, "system-1.0") == GIVEN
        assert base_images.reference(services, SYSTEMS, "system-1.0", "arm64") == GIVEN
        assert base_images.assembler(services, SYSTEMS, "system-1.0", "3.12") == Assembler(GIVEN, "3.12.9")
        assert base_images.missing(services, SYSTEMS, "system-1.0") == "nobody has it"
    assert calls(tmp_path) == [
        f"{OFFICIAL} --architecture amd64",
        f"{OFFICIAL} --architecture arm64",
        f"{OFFICIAL} --assembler 3.12",
        f"{OFFICIAL} --check",
    ]


def test_an_error_of_the_command(tmp_path: Path) -> None:
    """With its remedy, and another one; it may be gone when it is asked again."""
    services = answering(tmp_path, {"error": "nobody has it", "remedy": "wait"}, 1)
    with pytest.raises(RosmlError, match=r"^nobody has it$") as caught:
        base_images.reference(services, SYSTEMS, "system-1.0")
    assert caught.value.remedy.startswith("wait; or name one that answers: OS_SYSTEM_1_0=")
    answering(tmp_path, {"reference": GIVEN})
    assert base_images.reference(services, SYSTEMS, "system-1.0") == GIVEN


@pytest.mark.parametrize("answer", ["", "no", "[]", "3", "{}"])
def test_a_command_that_says_nothing_of_use(tmp_path: Path, answer: str) -> None:
    with pytest.raises(RosmlError, match=r"no base image for system-1\.0: .*/bases") as caught:
        base_images.reference(answering(tmp_path, answer), SYSTEMS, "system-1.0")
    assert caught.value.remedy.startswith("run 'rosml setup'; or name one that answers: OS_SYSTEM_1_0=")


def test_a_command_that_is_not_there(tmp_path: Path) -> None:
    with pytest.raises(RosmlError, match=r"/nowhere.*No such file"):
        base_images.reference(load(tmp_path, bases=["/nowhere"]), SYSTEMS, "system-1.0")
