"""Servers that are no registry: an answer has a limit in bytes and time, and a busy server is asked again."""

from __future__ import annotations

import logging
import time
import tracemalloc
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import httpx
import pytest

from fakes.hostile import MEMORY, Answer, Hostile, endless, hostile, limited_error, reply
from fakes.mutations import bomb
from fakes.stubs import services
from rosml.base import web
from rosml.base.errors import RosmlError
from rosml.images.builds import release_file
from rosml.machine.services import registry_answers
from rosml.machine.setup import network

BOMB, GZIP = bomb(200), {"Content-Encoding": "gzip"}


@pytest.fixture
def server(monkeypatch: pytest.MonkeyPatch) -> Iterator[Hostile]:
    monkeypatch.setattr(web, "WAIT", 0.001)
    with hostile() as running:
        yield running


@pytest.mark.parametrize(
    "answer",
    [reply(404, BOMB, GZIP), reply(302, BOMB, {**GZIP, "Location": "/x"}), endless(500), reply(302, headers={"Location": "/x"}),
     reply(302, headers={"Location": "http://["})],
    ids=["a bomb", "a redirect that is a bomb", "an error without an end", "a redirect to itself", "no host"],
)  # fmt: skip
def test_a_repository_of_packages(server: Hostile, answer: Answer) -> None:
    server.answers = {"GET": answer}
    limited_error(lambda: release_file.read(f"http://{server.address}/x", 1000, "MIRROR"))


@pytest.mark.parametrize("place", [f"http://{'a' * 64}.example/x", "ftp://a/x"], ids=["no name", "no http"])
def test_a_redirect_leads_to_what_can_be_asked(server: Hostile, place: str) -> None:
    server.answers = {"GET": reply(302, headers={"Location": place})}
    with web.client() as client, pytest.raises(web.Unfit):
        web.fetched(client, f"http://{server.address}/x")


@pytest.mark.parametrize("code", [429, 503, 200])
@pytest.mark.parametrize("times", [1, 100])
def test_a_repository_that_is_too_busy_is_asked_again(server: Hostile, code: int, times: int) -> None:
    """And not for ever. An answer of 200 that breaks off before its headers is none."""
    busy = [reply(code, headers={"Retry-After": "0"}) if code != 200 else b""] * times

    def answer() -> Iterator[bytes]:
        yield busy.pop() if busy else reply(200, b"Suite: stable")

    server.answers = {"GET": answer}
    if times == 1:
        assert release_file.read(f"http://{server.address}/x", 1000, "MIRROR") == "Suite: stable"
    else:
        with pytest.raises(RosmlError, match="does not answer"):
            release_file.read(f"http://{server.address}/x", 1000, "MIRROR")
    assert len(server.requests) == min(times + 1, web.ATTEMPTS)


@pytest.mark.parametrize("answer", [endless(200), reply(200, BOMB, GZIP)], ids=["endless", "bomb"])
def test_a_release_file_is_read_up_to_its_limit(server: Hostile, answer: Answer) -> None:
    server.answers = {"GET": answer}
    tracemalloc.start()
    try:
        text = release_file.read(f"http://{server.address}/x", 1000, "MIRROR")
        assert 900 < len(text) <= 1000, "1000 bytes, of which two may be one character"
        assert tracemalloc.get_traced_memory()[1] < MEMORY
    finally:
        tracemalloc.stop()


def test_no_log_line_has_a_password(server: Hostile, caplog: pytest.LogCaptureFixture) -> None:
    """The libraries below log whole addresses, and headers of answers."""
    caplog.set_level(logging.DEBUG)
    server.answers = {"/x": reply(302, headers={"Location": "/y?signature=s3cret"}), "/y": reply(200, b"Suite: stable")}
    release_file.read(f"http://me:s3cret@{server.address}/x", 1000, "MIRROR")
    assert len(server.requests) == 2 and "s3cret" not in caplog.text


def test_the_local_registry(server: Hostile, tmp_path: Path) -> None:
    here = replace(services(tmp_path), registry=server.address)
    for answer in (reply(302, headers={"Location": "http://["}), endless(500)):
        server.answers = {".": answer}
        limited_error(here.require_registry)


def test_a_server_in_the_place_of_a_registry(server: Hostile, monkeypatch: pytest.MonkeyPatch) -> None:
    version = {"Docker-Distribution-Api-Version": "registry/2.0"}
    server.answers = {".": endless(200, headers=version)}
    monkeypatch.setattr(network, "HUB_API", f"http://{server.address}/v2/")
    before = time.monotonic()
    assert registry_answers(server.address) and network.docker_hub_answers("")
    server.answers = {".": reply(302, headers={"Location": "http://["})}
    assert not registry_answers(server.address) and not network.docker_hub_answers("")
    assert time.monotonic() - before < 10


def test_httpx_unpacks_no_raw_bytes() -> None:
    """If a new version does, bombs are bombs again."""
    answer = httpx.Response(200, headers=GZIP, stream=httpx.ByteStream(BOMB[:1000]))
    assert b"".join(answer.iter_raw()) == BOMB[:1000]
