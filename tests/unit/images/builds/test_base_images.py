"""Base images: that of matrix.yaml, or another one that a variable or the machine's command names."""

from __future__ import annotations

import json
from dataclasses import replace
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
COPY = f"registry.test:5000/copy:1@{OTHER}"
NAME, VARIABLE = "system-1.0", "OS_SYSTEM_1_0"
FACTS: dict[str, Any] = {"python": "3.12", "numpy": "<2", "architectures": ("amd64",), "tools": "git"}
SYSTEMS = {NAME: OperatingSystem(image="docker.io/library/system:1", digest=DIGEST, **FACTS)}


@pytest.fixture(autouse=True)
def native(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(base_images, "native_architecture", lambda: "amd64")
    monkeypatch.delenv(VARIABLE, raising=False)


def answering(folder: Path, answer: dict[str, Any] | str, code: int = 0) -> Services:
    """A machine whose command for base images answers so."""
    text = answer if isinstance(answer, str) else json.dumps(answer)
    script = f"echo \"$*\" >>'{folder}/calls'\necho '{text}'\nexit {code}"
    return load(folder, bases=[executable(folder / "bases", script)])


def results(services: Services) -> tuple[object, ...]:
    return (
        base_images.reference(services, SYSTEMS, NAME),
        base_images.reference(services, SYSTEMS, NAME, "arm64"),
        base_images.assembler(services, SYSTEMS, NAME, "3.12"),
        base_images.missing(services, SYSTEMS, NAME),
    )


def test_the_official_image(tmp_path: Path) -> None:
    assert results(load(tmp_path)) == (OFFICIAL, OFFICIAL, Assembler(OFFICIAL, "3.12"), "")


@pytest.mark.parametrize("prefix", ["", "docker-image://"])
def test_a_variable_names_another(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, prefix: str) -> None:
    """Whatever the machine's command would say."""
    monkeypatch.setenv(VARIABLE, prefix + COPY)
    assert results(answering(tmp_path, {"error": "x"}, 1)) == (COPY, COPY, Assembler(COPY, "3.12"), "")
    assert calls(tmp_path) == []


@pytest.mark.parametrize("text", ["r.test/copy:1", f"r.test/copy:1@{OTHER}0", f"a b@{OTHER}", f"@{OTHER}"])
def test_a_variable_without_a_digest(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, text: str) -> None:
    monkeypatch.setenv(VARIABLE, text)
    with pytest.raises(RosmlError, match=f"{VARIABLE} names no image by its digest") as caught:
        base_images.reference(load(tmp_path), SYSTEMS, NAME)
    assert caught.value.exit_code == 2


def test_the_command_is_called_once(tmp_path: Path) -> None:
    services = answering(tmp_path, {"reference": COPY, "python": "3.12.9", "missing": "nobody has it"})
    for _ in range(2):
        assert results(services) == (COPY, COPY, Assembler(COPY, "3.12.9"), "nobody has it")
    options = ("--architecture amd64", "--architecture arm64", "--assembler 3.12", "--check")
    assert calls(tmp_path) == [f"{OFFICIAL} {option}" for option in options]


def test_dockers_own_builder_has_no_mirror_of_docker_hub(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """It pulls from the local registry, and labels say what that stands for."""
    mirrored, here = f"docker.io/library/copy:1@{OTHER}", "127.0.0.1:5001"
    theirs = replace(answering(tmp_path, {"reference": mirrored}), registry=here)
    assert base_images.reference(theirs, SYSTEMS, NAME) == mirrored
    assert base_images.docker_hub(theirs, NAME) == "docker.io"
    ours = replace(theirs, builder_kind="engine")
    assert base_images.reference(ours, SYSTEMS, NAME) == mirrored.replace("docker.io", here)
    assert base_images.docker_hub(ours, NAME) == here
    monkeypatch.setenv(VARIABLE, f"{here}/mine:1@{OTHER}")
    assert base_images.docker_hub(ours, NAME) == "docker.io", "they named it so"


def test_an_error_of_the_command(tmp_path: Path) -> None:
    """With its remedy, and another one; the next call may succeed."""
    services = answering(tmp_path, {"error": "nobody has it", "remedy": "wait"}, 1)
    with pytest.raises(RosmlError, match=r"^nobody has it$") as caught:
        base_images.reference(services, SYSTEMS, NAME)
    assert caught.value.remedy.startswith(f"wait; or name one that answers: {VARIABLE}=")
    answering(tmp_path, {"reference": COPY})
    assert base_images.reference(services, SYSTEMS, NAME) == COPY


@pytest.mark.parametrize("answer", ["", "no", "[]", "3", "{}"])
def test_an_answer_of_no_use(tmp_path: Path, answer: str) -> None:
    with pytest.raises(RosmlError, match=r"no base image for system-1\.0: .*/bases") as caught:
        base_images.reference(answering(tmp_path, answer), SYSTEMS, NAME)
    assert VARIABLE in caught.value.remedy


def test_a_missing_command(tmp_path: Path) -> None:
    with pytest.raises(RosmlError, match=r"/nowhere.*No such file"):
        base_images.reference(load(tmp_path, bases=["/nowhere"]), SYSTEMS, NAME)
