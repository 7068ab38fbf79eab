"""What regctl is asked, and what its answers and failures become."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from stubs import answering_registry, calls, executable, services

from bench.second_image import stored
from rosml.base.errors import RosmlError
from rosml.machine import regctl
from rosml.machine.regctl import Layer
from rosml.machine.services import Services

DIGEST = "sha256:" + "1" * 64


@pytest.fixture(scope="module")
def address() -> Iterator[str]:
    with answering_registry() as found:
        yield found


def having(tmp_path: Path, address: str, text: str, **changes: Any) -> Services:
    """Services with a regctl that records its call and does as the text says."""
    record = f"echo \"$*\" >>'{tmp_path}/calls'\n"
    return services(tmp_path, address, regctl=executable(tmp_path / "regctl", record + text), **changes)


def test_layers(tmp_path: Path, address: str) -> None:
    found = having(tmp_path, address, f'echo \'{{"layers": [{{"digest": "{DIGEST}", "size": 7, "mediaType": "x"}}]}}\'')
    assert regctl.layers(found, f"r@{DIGEST}") == (Layer(DIGEST, 7),)
    assert calls(tmp_path) == [f"manifest get --format raw-body r@{DIGEST}"]


def test_stored(tmp_path: Path, address: str) -> None:
    """Layers, config and manifest; a layer that is in an image twice is stored once."""
    layers = '{"digest": "l", "size": 7}, {"digest": "l", "size": 7}'
    answer = f'{{"layers": [{layers}], "config": {{"digest": "c", "size": 3}}}}'
    found = having(tmp_path, address, f"case $2 in get) echo '{answer}' ;; head) echo 99 ;; esac")
    assert stored(found, f"r@{DIGEST}") == {"l": 7, "c": 3, DIGEST: 99}


def test_config(tmp_path: Path, address: str) -> None:
    found = having(tmp_path, address, 'echo \'{"config": {"Cmd": ["bash"]}}\'')
    assert regctl.image_config(found, "r:t", "linux/arm64") == {"config": {"Cmd": ["bash"]}}
    assert calls(tmp_path) == ["image config --platform linux/arm64 r:t"]


def test_index(tmp_path: Path, address: str) -> None:
    found = having(tmp_path, address, f"echo {DIGEST}")
    assert regctl.create_index(found, "r", ["sha256:a", "sha256:b"], {"b": "2", "a": "1"}) == DIGEST
    assert calls(tmp_path) == [
        "index create --by-digest --format {{.Manifest.GetDescriptor.Digest}}"
        " --annotation a=1 --annotation b=2 --ref r@sha256:a --ref r@sha256:b r"
    ]


def test_digest(tmp_path: Path, address: str) -> None:
    assert regctl.digest(having(tmp_path, address, f"echo {DIGEST}"), "r:t") == DIGEST
    assert calls(tmp_path) == ["manifest head r:t"]


@pytest.mark.parametrize("words", ["failed: r:t: manifest Not Found", "unexpected http status 404"])
def test_no_such_tag(tmp_path: Path, address: str, words: str) -> None:
    assert regctl.digest(having(tmp_path, address, f"echo noise >&2; echo '{words}' >&2; exit 1"), "r:t") == ""


@pytest.mark.parametrize("reference", ["r:t", "r404:t", "127.0.0.1:40404/r:not found"])
def test_another_failure_is_not_a_missing_tag(tmp_path: Path, address: str, reference: str) -> None:
    """Whatever the reference is called: a port, too, can hold 404."""
    found = having(tmp_path, address, "echo 'http status 500' >&2; exit 1")
    with pytest.raises(RosmlError, match="http status 500"):
        regctl.digest(found, reference)


def test_failure_says_the_last_line(tmp_path: Path, address: str) -> None:
    with pytest.raises(RosmlError) as caught:
        regctl.manifest(having(tmp_path, address, "echo one >&2; echo denied >&2; exit 1"), "r:t")
    assert caught.value.message == "regctl manifest get --format raw-body r:t: denied"
    with pytest.raises(RosmlError, match=r"r:t: exit code 3$"):
        regctl.manifest(having(tmp_path, address, "exit 3"), "r:t")


def test_registry_is_down(tmp_path: Path) -> None:
    """Also when regctl's words hint at something else; and no tag is missing because of it."""
    for words in ("denied", "not found"):
        with pytest.raises(RosmlError, match=r"the local registry at 127\.0\.0\.1:1 does not answer") as caught:
            regctl.digest(having(tmp_path, "127.0.0.1:1", f"echo '{words}' >&2; exit 1"), "r:t")
        assert caught.value.remedy == "run 'rosml setup'"


def test_registry_hangs(tmp_path: Path, address: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(regctl, "SECONDS", 0.1)
    with pytest.raises(RosmlError, match="did not answer within 0 s: manifest head r:t") as caught:
        regctl.digest(having(tmp_path, address, "exec sleep 5"), "r:t")
    assert caught.value.remedy == "run 'rosml setup'"


def test_regctl_is_gone(tmp_path: Path, address: str) -> None:
    with pytest.raises(RosmlError, match="cannot run /nowhere/regctl: No such file") as caught:
        regctl.digest(services(tmp_path, address), "r:t")
    assert caught.value.remedy == "run 'rosml setup'"


@pytest.mark.parametrize("answer", ["[]", "null", "3", "", "<html>"])
def test_answer_that_is_no_object(tmp_path: Path, address: str, answer: str) -> None:
    with pytest.raises(RosmlError, match="answer to manifest get --format raw-body r:t is no JSON object"):
        regctl.manifest(having(tmp_path, address, f"echo '{answer}'"), "r:t")


def test_environment(tmp_path: Path, address: str) -> None:
    found = having(tmp_path, address, 'echo "$REGCTL_CONFIG $SSL_CERT_FILE"', ca_bundle="/ca.pem")
    assert regctl.regctl(found, "version") == f"{tmp_path}/.state/regctl/config.json /ca.pem\n"
