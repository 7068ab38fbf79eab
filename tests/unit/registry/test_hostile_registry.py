"""What a broken or hostile server sends: each ends in an error with a remedy, within a second and without much memory, and no
password goes where it does not belong."""

from __future__ import annotations

import base64
import gzip
import json
import time
import tracemalloc
from collections.abc import Callable, Iterator
from contextlib import nullcontext
from dataclasses import replace
from functools import partial
from pathlib import Path
from random import Random
from typing import Any

import httpx
import pytest

from fakes.hostile import Answer, Hostile, endless, hostile, reply
from fakes.http_registry import StandIn, standing_in
from fakes.mutations import bomb
from fakes.stubs import executable, services
from rosml.base import untrusted, web
from rosml.base.errors import RosmlError
from rosml.containerize.base_image import base as app_base
from rosml.images.builds import contents, release_file
from rosml.images.join import file_lists
from rosml.machine.services import Services
from rosml.machine.setup import network
from rosml.registry import credentials, failures, oci
from rosml.registry.client import Registry
from rosml.registry.credentials import Credentials
from rosml.registry.documents import Descriptor
from rosml.registry.transport import PAGES

SECONDS = 1.0
BYTES = 100 << 20
"""What a call may take at most, of this thread's time and of memory."""

WALL = 10.0
"""Seconds until it ends, also on a machine that does other things."""

SOMEBODY = Credentials("somebody", "s3cret-Pass")
DIGEST = "sha256:" + "1" * 64
DEEP = b'{"a":' * 100_000
BOMB = bomb(200)
LABEL = "a" * 64
NO_HOSTS = [
    "http://[",
    "https://a..b/x",
    f"http://{LABEL}.org/x",
    "ftp://a/x",
    "http://127.0.0.1:99999/x",
    "http://\x7f/",
]


@pytest.fixture(autouse=True)
def quick(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr(failures, "WAIT", 0.001)
    monkeypatch.setattr(failures, "LONGEST_WAIT", 0.01)
    monkeypatch.setenv("DOCKER_CONFIG", str(tmp_path / "docker"))
    monkeypatch.delenv("DOCKER_AUTH_CONFIG", raising=False)


@pytest.fixture
def server() -> Iterator[Hostile]:
    with hostile() as found:
        yield found


def ends(call: Callable[[], object]) -> RosmlError:
    """The error that a call ends with, soon and without much memory."""
    tracemalloc.start()
    try:
        before, started = time.thread_time(), time.monotonic()
        with pytest.raises(RosmlError) as caught:
            call()
        took, wall = time.thread_time() - before, time.monotonic() - started
        peak = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    assert took < SECONDS and wall < WALL
    assert peak < BYTES
    assert caught.value.message and caught.value.remedy
    assert len(caught.value.message) < 2000
    assert (caught.value.message + caught.value.remedy).replace("\n", "").isprintable()
    return caught.value


# ---- What a registry answers -----------------------------------------------------------------------------------------

Ask = Callable[[Registry], object]


def manifest(registry: Registry) -> object:
    return registry.manifest("a", "x")


def by_digest(registry: Registry) -> object:
    return registry.manifest("a", DIGEST)


def head(registry: Registry) -> object:
    return registry.head("a", "x")


def tags(registry: Registry) -> object:
    return registry.tags("a")


def blob(registry: Registry) -> object:
    return registry.blob("a", DIGEST)


def stream(registry: Registry) -> object:
    return registry.read_blob("a", DIGEST, lambda blocks: sum(map(len, blocks)), 1000)


def part(registry: Registry) -> object:
    return registry.part("a", Descriptor(mediaType="x", digest=DIGEST, size=1000))


def push(registry: Registry) -> object:
    return registry.put_blob("a", b"hello")


def attached(registry: Registry) -> object:
    registry.manifest("a", "there")
    return registry.referrers("a", DIGEST)


def move(registry: Registry) -> None:
    registry.tag("a", oci.digest_of(json.dumps(WHOLE).encode()), "x")


WHOLE = {"schemaVersion": 2, "mediaType": oci.IMAGE, "layers": []}
THERE = {"GET /v2/a/manifests/there": reply(200, json.dumps(WHOLE).encode())}


def text(**changes: Any) -> dict[str, Answer]:
    """A manifest with another field."""
    return {"GET": reply(200, json.dumps({**WHOLE, **changes}).encode())}


def challenge(value: str | bytes) -> dict[str, Answer]:
    return {".": reply(401, headers={"WWW-Authenticate": value})}


def token(content: bytes, code: int = 200) -> dict[str, Answer]:
    """A registry that wants a token, and what its token server answers."""
    wants = reply(401, headers={"WWW-Authenticate": 'Bearer realm="/token",service="x"'})
    return {"/token": reply(code, content), ".": wants}


ANSWERS: dict[str, tuple[Ask, dict[str, Answer]]] = {
    "a challenge of 60 kB": (manifest, challenge("Bearer " + "a" * 60_000)),
    "a challenge of 60 kB of spaces": (manifest, challenge("Bearer realm" + " " * 60_000 + "x")),
    "a challenge with an open quote": (manifest, challenge('Bearer realm="' + '\\"' * 30_000)),
    "a challenge in latin-1": (manifest, challenge('Bearer realm="http://ä/",service="ä"'.encode("latin-1"))),
    **{f"a realm at {where}": (manifest, challenge(f'Bearer realm="{where}"')) for where in NO_HOSTS[:-1]},
    "a token that is not ASCII": (manifest, token('{"token": "ä"}'.encode())),
    "a token of two lines": (manifest, token(b'{"token": "a\\r\\nX: y"}')),
    "a token that is a number": (manifest, token(b'{"token": 5}')),
    "a token of half a character": (manifest, token(b'{"token": "\\ud800"}')),
    "a token that is too large": (manifest, token(b'{"token": "' + b"a" * (1 << 20) + b'"}')),
    "a token that holds for 400 digits": (manifest, token(b'{"token": "a", "expires_in": ' + b"9" * 400 + b"}")),
    "a token that holds for 5,000 digits": (manifest, token(b'{"token": "a", "expires_in": ' + b"9" * 5000 + b"}")),
    "a deep token": (manifest, token(DEEP)),
    "a deep error of a token server": (manifest, token(DEEP, 400)),
    "a token without an end": (manifest, {**token(b""), "/token": endless(200)}),
    "a token that is a bomb": (manifest, {**token(b""), "/token": reply(200, BOMB, {"Content-Encoding": "gzip"})}),
    "a manifest without an end": (manifest, {"GET": endless(200)}),
    "a manifest of 100 MB": (manifest, {"GET": reply(200, b"", {"Content-Length": "100000000"})}),
    "a manifest of 10^5000 bytes": (manifest, {"GET": reply(200, b"", {"Content-Length": "9" * 5000})}),
    "a manifest that is a bomb": (manifest, {"GET": reply(200, BOMB, {"Content-Encoding": "gzip"})}),
    "a manifest in hex": (manifest, {"GET": reply(200, b"xx", {"Content-Type": "text/plain; charset=hex"})}),
    "a deep manifest": (manifest, {"GET": reply(200, DEEP)}),
    "a deep manifest that is whole": (manifest, text(config={"x": json.loads("[" * 500 + "]" * 500)})),
    "a manifest with a size of 5,000 digits": (
        manifest,
        {"GET": reply(200, b'{"schemaVersion": 2, "layers": [], "size": ' + b"9" * 5000 + b"}")},
    ),
    "a manifest with half a character": (manifest, text(annotations={"x": "\ud800"})),
    "a manifest with NaN": (manifest, text(size=float("nan"))),
    "a manifest that is an index too": (manifest, text(manifests=[])),
    "an index that is a manifest too": (manifest, text(mediaType=oci.INDEX, manifests=[])),
    "a manifest whose type is a number": (manifest, text(mediaType=5)),
    "a manifest whose type is no type": (manifest, text(mediaType="a/b\nc: d")),
    "a manifest whose type is not ASCII": (
        move,
        {"GET": reply(200, json.dumps(WHOLE).encode(), {"Content-Type": "a/ä".encode("latin-1")})},
    ),
    "a digest with another one behind it": (
        manifest,
        text(layers=[{"mediaType": "x", "size": 1, "digest": DIGEST + "/../../x"}]),
    ),
    "a layer of less than nothing": (manifest, text(layers=[{"mediaType": "x", "size": -1, "digest": DIGEST}])),
    "a manifest by digest without an end": (by_digest, {"GET": endless(200)}),
    "an error without an end": (manifest, {"GET": endless(400)}),
    "an error that is a bomb": (manifest, {"GET": reply(400, BOMB, {"Content-Encoding": "gzip"})}),
    "a deep error": (manifest, {"GET": reply(400, b'{"errors": ' + b"[" * 60_000)}),
    "an error in hex": (manifest, {"GET": reply(400, b"xx", {"Content-Type": "text/plain; charset=hex"})}),
    "an error that moves the cursor": (
        manifest,
        {"GET": reply(400, b'{"errors": [{"code": "X", "message": "\\u001b]52;c;eA==\\u0007 x"}]}')},
    ),
    "an error of another form": (manifest, {"GET": reply(400, b'{"errors": [[], {"code": []}]}')}),
    "a wait of 5,000 digits": (manifest, {"GET": reply(429, headers={"Retry-After": "9" * 5000})}),
    "a wait until year 99999": (
        manifest,
        {"GET": reply(429, headers={"Retry-After": "Mon, 01 Jan 99999 00:00:00 GMT"})},
    ),
    "a wait until the end of time": (
        manifest,
        {"GET": reply(503, headers={"Retry-After": "Fri, 31 Dec 9999 23:59:59 -2359"})},
    ),
    **{f"a manifest at {w}": (manifest, {"GET": reply(302, headers={"Location": w})}) for w in NO_HOSTS},
    **{f"a digest at {w}": (head, {"HEAD": reply(302, headers={"Location": w})}) for w in NO_HOSTS},
    **{f"a blob at {w}": (blob, {"GET": reply(302, headers={"Location": w})}) for w in NO_HOSTS},
    **{f"an upload at {w}": (push, {"POST": reply(202, headers={"Location": w})}) for w in NO_HOSTS},
    "an upload nowhere": (push, {"POST": reply(202)}),
    "a redirect that is a bomb": (
        blob,
        {"GET": reply(302, BOMB, {"Content-Encoding": "gzip", "Location": "/v2/a/blobs/" + DIGEST})},
    ),
    "a redirect to itself": (manifest, {"GET": reply(307, headers={"Location": "/v2/a/manifests/x"})}),
    "a blob without an end": (blob, {"GET": endless(200)}),
    "a blob that is a bomb": (blob, {"GET": reply(200, BOMB, {"Content-Encoding": "gzip"})}),
    "a stream without an end": (stream, {"GET": endless(200)}),
    "a blob that is larger than its manifest says": (part, {"GET": endless(200)}),
    "tags that are no tags": (tags, {"GET": reply(200, b'{"tags": ["../../../x", "\\u001b[2J"]}')}),
    "tags without an end": (tags, {"GET": endless(200)}),
    "a link to another host": (
        tags,
        {"GET": reply(200, b'{"tags": []}', {"Link": '<http://evil.example/v2/a/tags/list>; rel="next"'})},
    ),
    **{
        f"a link to {w}": (tags, {"GET": reply(200, b'{"tags": []}', {"Link": f'<{w}>; rel="next"'})})
        for w in NO_HOSTS[:-1]
    },
    "a deep list of what is attached": (
        attached,
        {**THERE, "/referrers/": reply(200, b'{"manifests": ' + b"[" * 100_000), "GET": reply(400, DEEP)},
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", ANSWERS)
def test_an_answer(server: Hostile, name: str) -> None:
    ask, server.answers = ANSWERS[name]
    with Registry(server.address, credentials=lambda _: SOMEBODY) as registry:
        ends(lambda: ask(registry))


def test_a_list_has_an_end(server: Hostile) -> None:
    pages = iter(range(1 << 30))

    def page() -> Iterator[bytes]:
        number = next(pages)
        yield reply(200, b'{"tags": ["t%d"]}' % number, {"Link": f'</v2/a/tags/list?last={number}>; rel="next"'})

    server.answers = {"GET": page}
    with Registry(server.address) as registry, pytest.raises(RosmlError, match="a list without end"):
        registry.tags("a")
    assert len(server.requests) == PAGES + 1


def test_a_link_of_60_kb_is_none(server: Hostile) -> None:
    server.answers = {"GET": reply(200, b'{"tags": ["x"]}', {"Link": "<" * 30_000 + ">; " * 10_000})}
    with Registry(server.address) as registry:
        before = time.thread_time()
        assert registry.tags("a") == ["x"]
        assert time.thread_time() - before < SECONDS


def test_an_answer_takes_no_hours(server: Hostile, monkeypatch: pytest.MonkeyPatch) -> None:
    """A byte now and then keeps a connection alive for ever."""
    monkeypatch.setattr(web, "LONGEST", 0.3)

    def slow() -> Iterator[bytes]:
        made = endless(200, b"[")()
        for block in made:
            yield block
            time.sleep(0.02)

    for code, ask in ((200, manifest), (200, tags), (200, blob)):
        server.answers = {"GET": slow}
        with Registry(server.address) as registry:
            assert "takes longer" in ends(lambda ask=ask, it=registry: ask(it)).message, code  # type: ignore[misc]


def test_cookies_are_not_kept(server: Hostile) -> None:
    server.answers = {".": reply(200, json.dumps(WHOLE).encode(), {"Set-Cookie": "a=b; Path=/"})}
    with Registry(server.address) as registry:
        for _ in range(2):
            assert registry.manifest("a", "x")
    assert not any("cookie" in headers for _, headers in server.requests)


@pytest.mark.parametrize("said", ["sha256:x", "../../../x", "md5:" + "1" * 32, "sha256:" + "A" * 64, DIGEST + "x"])
def test_a_digest_that_is_none_is_not_believed(server: Hostile, said: str) -> None:
    data = json.dumps(WHOLE).encode()
    server.answers = {".": reply(200, data, {"Docker-Content-Digest": said})}
    with Registry(server.address) as registry:
        assert registry.head("a", "x") == oci.digest_of(data)


def test_a_digest_of_something_else_is_not_believed(server: Hostile) -> None:
    """Who asks whether a digest is there is told of another one."""
    server.answers = {".": reply(200, json.dumps(WHOLE).encode(), {"Docker-Content-Digest": "sha256:" + "2" * 64})}
    with Registry(server.address) as registry:
        assert "has another digest" in ends(lambda: registry.head("a", DIGEST)).message


@pytest.mark.parametrize("name", ["../../x", "x?y=z", "sha256:1", "a/b", "x" * 129, ""])
def test_what_is_no_tag_and_no_digest_is_not_asked_for(server: Hostile, name: str) -> None:
    """Records and indexes name manifests; what they name may lead elsewhere in the registry."""
    with Registry(server.address) as registry:
        for ask in (registry.manifest, registry.head, registry.delete):
            assert "neither a tag nor a digest" in ends(lambda ask=ask: ask("a", name)).message  # type: ignore[misc]
        assert "no digest" in ends(lambda: registry.blob("a", name)).message
    assert server.requests == []


# ---- Where passwords go ----------------------------------------------------------------------------------------------


def sent(server: Hostile | StandIn) -> str:
    """All that a server got to know."""
    return repr([server.requests, getattr(server, "headers", [])])


@pytest.fixture
def registry() -> Iterator[StandIn]:
    with standing_in() as found:
        found.users, found.bearer = {SOMEBODY.username: SOMEBODY.password}, True
        yield found


def ask_back(server: Hostile, kind: str = "Bearer") -> None:
    """Another host asks who it is, and names itself as what gives tokens."""
    realm = f'{kind} realm="http://{server.address}/token",service="x"'
    server.answers = {
        "/token": reply(200, b'{"token": "stolen"}'),
        ".": reply(401, headers={"WWW-Authenticate": realm}),
    }


@pytest.mark.parametrize("kind", ["Bearer", "Basic"])
@pytest.mark.parametrize("way", ["blob", "stream", "upload", "give up"])
def test_another_host_asks_for_the_password(registry: StandIn, server: Hostile, way: str, kind: str) -> None:
    ask_back(server, kind)
    where = {"Location": f"http://{server.address}/v2/a/blobs/{DIGEST}"}
    registry.fault("GET", "/blobs/", 307, 100, headers=where)
    with Registry(registry.address, credentials=lambda _: SOMEBODY) as client:
        client.put_manifest("a", "x", WHOLE)  # it has logged in
        registry.fault("POST", "/uploads/", 202, 100, headers=where)
        asks: dict[str, Ask] = {"blob": blob, "stream": stream, "upload": push, "give up": lambda it: it.may_push("a")}
        with nullcontext() if way == "give up" else pytest.raises(RosmlError) as caught:
            asks[way](client)
        assert client.put_manifest("b", "x", WHOLE), "the registry itself is asked as before"
        basic = base64.b64encode(b"somebody:s3cret-Pass").decode()
        assert "/token" not in sent(server) and "authorization" not in sent(server) and basic not in sent(server)
        assert not [request for request, _ in server.requests if request.startswith("DELETE")]
        assert caught is None or server.address in caught.value.message


def test_a_registry_names_its_token_server_elsewhere(registry: StandIn) -> None:
    """As Docker Hub does: the password goes there, and nowhere else."""
    with standing_in() as tokens:
        tokens.users, tokens.tokens = registry.users, registry.tokens
        registry.realm = f"http://{tokens.address}/token"
        with Registry(registry.address, credentials=lambda _: SOMEBODY) as client:
            assert client.put_manifest("a", "x", WHOLE)
        assert tokens.count("/token") == 1 and "authorization" in sent(tokens)
        assert "Basic" not in sent(registry)


def test_a_token_server_elsewhere_without_tls(server: Hostile) -> None:
    server.answers = {".": reply(401, headers={"WWW-Authenticate": 'Bearer realm="http://registry.example/token"'})}
    with Registry(server.address, credentials=lambda _: SOMEBODY) as client:
        assert "in the clear" in ends(lambda: client.head("a", "x")).message


@pytest.mark.parametrize("bearer", [True, False])
@pytest.mark.parametrize("password", ["pässword", "пароль", "密码 \t"])
def test_any_password_is_sent(registry: StandIn, bearer: bool, password: str) -> None:
    registry.users, registry.bearer = {"jürgen": password}, bearer
    with Registry(registry.address, credentials=lambda _: Credentials("jürgen", password)) as client:
        assert client.put_manifest("a", "x", WHOLE)


@pytest.mark.parametrize(
    "entry",
    [
        {"auth": "ä"}, {"auth": 5}, {"auth": ["x"]}, {"auth": "//4="}, {"username": 5}, {"username": "x", "password": []},
        {"identitytoken": {}}, {"auth": "\ud800"},
    ],
)  # fmt: skip
def test_a_damaged_login(tmp_path: Path, entry: dict[str, Any]) -> None:
    (tmp_path / "docker").mkdir()
    (tmp_path / "docker/config.json").write_text(json.dumps({"auths": {"ghcr.io": entry}}))
    assert "config.json" in ends(lambda: credentials.from_docker("ghcr.io")).message


@pytest.mark.parametrize(
    "answer", ['{"Username":' * 100_000, '{"Username": "x", "Secret": 5}', '{"Username": "\\ud800", "Secret": "x"}']
)
def test_a_damaged_answer_of_a_credential_helper(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, answer: str) -> None:
    (tmp_path / "docker").mkdir()
    (tmp_path / "docker/config.json").write_text(json.dumps({"credsStore": "deep"}))
    (tmp_path / "answer").write_text(answer)
    executable(tmp_path / "docker-credential-deep", f"cat {tmp_path}/answer")
    monkeypatch.setenv("PATH", f"{tmp_path}:/usr/bin:/bin")
    assert "credential helpers" in ends(lambda: credentials.from_docker("ghcr.io")).message


@pytest.mark.parametrize("name", ["../../tmp/x", 5, {"a": "b"}])
def test_a_helper_that_is_no_name(tmp_path: Path, name: Any) -> None:
    (tmp_path / "docker").mkdir()
    (tmp_path / "docker/config.json").write_text(json.dumps({"credsStore": name}))
    assert "config.json" in ends(lambda: credentials.from_docker("ghcr.io")).message


# ---- Images that are none --------------------------------------------------------------------------------------------

LINUX = {"os": "linux", "architecture": "amd64"}
CONFIGS: dict[str, Any] = {
    "labels that are a list": {**LINUX, "config": {"Labels": ["x"]}},
    "a label that is a number": {**LINUX, "config": {"Labels": {"x": 5}}},
    "variables that are an object": {**LINUX, "config": {"Env": {"A": "b"}}},
    "a variable that is null": {**LINUX, "config": {"Env": [None]}},
    "a config that is a list": {**LINUX, "config": []},
    "a system that is a number": {**LINUX, "os": 5},
    "layers that are text": {**LINUX, "rootfs": {"diff_ids": "x"}},
    "a history of text": {**LINUX, "history": ["x"]},
    "no object": [],
    "nothing": None,
}


def image(client: Registry, content: Any, **changes: Any) -> str:
    """Puts an image with such a config; gives its digest."""
    data = json.dumps(content).encode()
    client.put_blob("a", data)
    found: dict[str, Any] = {**WHOLE, "config": oci.descriptor(oci.CONFIG, data), **changes}
    return client.put_manifest("a", "x", {name: value for name, value in found.items() if value is not None})


def index(client: Registry, manifests: Any) -> None:
    client.put_manifest("a", "x", {"schemaVersion": 2, "mediaType": oci.INDEX, "manifests": manifests}, oci.INDEX)


def member(client: Registry, digest: str, **more: Any) -> dict[str, Any]:
    found = client.manifest("a", digest)
    assert found
    return {**found.descriptor, **more}


IMAGES: dict[str, Callable[[Registry], object]] = {
    **{name: partial(image, content=content) for name, content in CONFIGS.items()},
    "a deep config": lambda client: image(client, {**LINUX, "x": json.loads("[" * 500 + "]" * 500)}),
    "an artifact": lambda client: client.put_artifact("a", "x", "application/x", b"data", "text/plain"),
    "no config": lambda client: image(client, {}, config=None),
    "an index of nothing": lambda client: index(client, []),
    "an index of null": lambda client: index(client, None),
    "an index without a platform": lambda client: index(client, [member(client, image(client, LINUX), platform=None)]),
    "an index of artifacts": lambda client: index(
        client,
        [member(client, client.put_artifact("a", "y", "application/x", b"data", "text/plain"), platform=LINUX)],
    ),
    "an index of what is not there": lambda client: index(
        client, [{"mediaType": oci.IMAGE, "size": 1, "digest": DIGEST, "platform": LINUX}]
    ),
}  # fmt: skip


@pytest.fixture
def plain() -> Iterator[StandIn]:
    with standing_in() as found:
        found.checks = False
        yield found


@pytest.mark.parametrize("name", IMAGES)
def test_a_base_image_that_is_none(plain: StandIn, tmp_path: Path, name: str) -> None:
    with Registry(plain.address) as client:
        IMAGES[name](client)
    here = services(tmp_path, plain.address)
    error = ends(lambda: app_base.find(f"{plain.address}/a:x", here, ("linux/amd64",)))
    assert f"{plain.address}/a:x" in error.message or "/v2/a/" in error.message or "sha256:" in error.message


def test_an_index_without_platforms_is_a_base_image_of_any(plain: StandIn, tmp_path: Path) -> None:
    with Registry(plain.address) as client:
        index(client, [member(client, image(client, {**LINUX, "config": None}), platform=None)])
    assert app_base.find(f"{plain.address}/a:x", services(tmp_path, plain.address), ()).labels == {}


def test_the_files_of_what_is_no_image(plain: StandIn) -> None:
    with Registry(plain.address) as client:
        image(client, {}, config=None)
        assert "it has no config" in ends(lambda: contents.manifests(client, "a", "x")).message
        index(client, [member(client, "x", platform=LINUX)])  # an index may list indexes, and those may list more
        index(client, [member(client, "x", platform=LINUX, mediaType=oci.IMAGE)])
        assert "it has no config" in ends(lambda: contents.manifests(client, "a", "x")).message


# ---- Anything ---------------------------------------------------------------------------------------------------------

ODD: list[Any] = [
    None, 0, -1, True, "", [], {}, [[]], [None], ["x"], {"a": {}}, 10**25, 1e300, "x", "ä", "\ud800", "\0", "\x1b[2J", "../..",
    "sha256:", DIGEST, "a" * 5000, "\u2028",
]  # fmt: skip
HEADERS = [
    "Location", "Link", "WWW-Authenticate", "Retry-After", "Content-Type", "Docker-Content-Digest", "Content-Encoding",
    "OCI-Subject", "Set-Cookie",
]  # fmt: skip
VALUES = [
    "", "ä", "/v2/", "//", "?", "9" * 400, "Mon, 01 Jan 2024 99:99:99 GMT", '</v2/x>; rel="next"', '<>; rel="next"', "Basic",
    'Bearer realm="x",scope="a b"', 'Bearer realm="', "Bearer", "a/b; charset=hex", "gzip", "chunked", "-1", "a" * 9000,
    DIGEST, "sha256:zz", "http://user:pw@127.0.0.1:1/", "ws://x/", "http://xn--/", "http://a b/", "/\t/", *NO_HOSTS,
]  # fmt: skip
CODES = [*[200] * 8, 201, 202, 204, 302, 307, 401, 403, 404, 405, 429, 500]


class Mutator:
    """Answers of a registry with something wrong; the same ones for the same seed."""

    def __init__(self, seed: int) -> None:
        self.random = Random(seed)

    def content(self, found: Any) -> Any:
        """A document with another value somewhere in it, or without one."""
        if not isinstance(found, dict | list) or not found or self.random.random() < 0.1:
            return self.random.choice(ODD)
        changed: Any = dict(found) if isinstance(found, dict) else dict(enumerate(found))
        key = self.random.choice(list(changed))
        changed[key] = self.content(changed[key])
        if self.random.random() < 0.2:
            del changed[key]
        return changed if isinstance(found, dict) else list(changed.values())

    def document(self, found: Any) -> bytes:
        """Bytes of a document, most of them with something wrong."""
        data = bytearray(json.dumps(self.content(found) if self.random.random() < 0.7 else found).encode())
        if data and self.random.random() < 0.1:
            data[self.random.randrange(len(data))] = self.random.randrange(256)
        return bytes(data)

    def reply(self, body: bytes, headers: dict[str, str | bytes] | None = None) -> bytes:
        """An answer with this body."""
        found = dict(headers or {})
        if self.random.random() < 0.3:
            found[self.random.choice(HEADERS)] = self.random.choice(VALUES).encode("latin-1")
        return reply(self.random.choice(CODES), body, found)

    def answers(self) -> dict[str, Answer]:
        """All answers of a registry that has one image."""
        here = {
            "mediaType": oci.IMAGE,
            "size": 1000,
            "platform": LINUX,
            "annotations": {"a": "b"},
            "artifactType": "a/b",
        }
        config = self.document(
            {**LINUX, "config": {"Env": ["A=b"], "Labels": {"a": "b"}}, "rootfs": {"diff_ids": [DIGEST]}}
        )
        described = oci.descriptor(oci.CONFIG, config)
        image = self.document({**WHOLE, "config": described, "layers": [described], "annotations": {"a": "b"}})
        entry = {**here, "digest": oci.digest_of(image)}
        index = self.document({"schemaVersion": 2, "mediaType": oci.INDEX, "manifests": [entry, entry]})
        place: dict[str, str | bytes] = {
            "Location": self.random.choice(["/v2/a/blobs/uploads/1", *VALUES]).encode("latin-1")
        }
        return {
            "/token": self.reply(self.document({"token": "abc", "expires_in": 300})),
            "/tags/list": self.reply(self.document({"tags": ["x", "y"]})),
            "/referrers/": self.reply(self.document({"manifests": [entry]})),
            "/blobs/uploads": self.reply(b"", place),
            f"/blobs/{described['digest']}": self.reply(config),
            "/blobs/": self.reply(self.document({"errors": [{"code": "X", "message": "y"}]})),
            f"/manifests/{oci.digest_of(image)}": self.reply(image),
            "/manifests/": self.reply(self.random.choice([index, image])),
        }


def test_anything(server: Hostile, tmp_path: Path) -> None:
    """Answers with something wrong somewhere: an error with a remedy, or what can be read."""
    here = services(tmp_path, server.address)

    def config(client: Registry) -> object:
        found = client.manifest("a", "x")
        return found and (found.layers, found.members, found.annotations, client.config("a", found))

    asks: list[Ask] = [
        head, tags, push, attached, config, by_digest, move,
        lambda client: client.attach("a", oci.descriptor(oci.IMAGE, b"x"), "a/b", b"x", "a/b"),
        lambda client: contents.manifests(client, "a", "x"),
        lambda client: file_lists.Lists().of(client, "a", DIGEST),
        lambda client: app_base.find(f"{server.address}/a:x", here, ("linux/amd64",)),
    ]  # fmt: skip
    read = 0
    for seed in range(200):
        mutator = Mutator(seed)
        server.answers = mutator.answers()
        with Registry(server.address, credentials=lambda _: SOMEBODY) as client:
            try:
                mutator.random.choice(asks)(client)
                read += 1
            except RosmlError as error:
                assert error.remedy, (seed, error.message)
            except Exception as error:
                raise AssertionError(f"seed {seed}") from error
    assert 20 < read < 180, "some answers are whole, and some are not"


# ---- Lists of files --------------------------------------------------------------------------------------------------


def files(data: bytes) -> file_lists.Files:
    return file_lists.Files.parse(file_lists.unpacked(data))


def test_all_members_of_a_gzip_file_are_read() -> None:
    data = gzip.compress(b"a\n") + gzip.compress(b"usr/bin/env\n")
    assert files(data).entries == {"a", "usr/bin/env"}


@pytest.mark.parametrize(
    "data",
    [
        gzip.compress(b"a/" * 40_000 + b"x\n"),
        gzip.compress(b"".join(b"%d/" % number + b"a/" * 2000 + b"x\n" for number in range(200))),
        gzip.compress(b"a\n") + b"rest",
        gzip.compress(b"") * 100_000,
    ],
    ids=["40,000 folders", "200 paths of 2,000 folders", "something behind it", "100,000 members"],
)
def test_a_list_of_files_that_is_none(data: bytes) -> None:
    ends(lambda: files(data))


# ---- Other servers ---------------------------------------------------------------------------------------------------

OTHERS: dict[str, Answer] = {
    "a bomb": reply(404, BOMB, {"Content-Encoding": "gzip"}),
    "a redirect that is a bomb": reply(302, BOMB, {"Content-Encoding": "gzip", "Location": "/x"}),
    "an error without an end": endless(500),
    **{f"a redirect to {where}": reply(302, headers={"Location": where}) for where in NO_HOSTS},
    "a redirect to itself": reply(302, headers={"Location": "/x"}),
}


@pytest.mark.parametrize("name", OTHERS)
def test_a_repository_of_packages(server: Hostile, name: str) -> None:
    server.answers = {"GET": OTHERS[name]}
    ends(lambda: release_file.read(f"http://{server.address}/x", 1000, "MIRROR"))


@pytest.mark.parametrize("code", [429, 503, 200])
@pytest.mark.parametrize("times", [1, 100])
def test_a_repository_that_is_too_busy_is_asked_again(
    server: Hostile, monkeypatch: pytest.MonkeyPatch, code: int, times: int
) -> None:
    """And not for ever. An answer of 200 that breaks off before its headers is none."""
    monkeypatch.setattr(web, "WAIT", 0.001)
    busy = [reply(code, headers={"Retry-After": "0"}) if code != 200 else b""] * times

    def answer() -> Iterator[bytes]:
        yield busy.pop() if busy else reply(200, b"Suite: stable")

    server.answers = {"GET": answer}
    server.requests.clear()
    if times == 1:
        assert release_file.read(f"http://{server.address}/x", 1000, "MIRROR") == "Suite: stable"
    else:
        with pytest.raises(RosmlError, match="does not answer"):
            release_file.read(f"http://{server.address}/x", 1000, "MIRROR")
    assert len(server.requests) == min(times + 1, web.ATTEMPTS)


@pytest.mark.parametrize(
    "answer", [endless(200), reply(200, BOMB, {"Content-Encoding": "gzip"})], ids=["endless", "bomb"]
)
def test_a_release_file_is_read_up_to_its_limit(server: Hostile, answer: Answer) -> None:
    server.answers = {"GET": answer}
    tracemalloc.start()
    try:
        found = release_file.read(f"http://{server.address}/x", 1000, "MIRROR")
        assert 900 < len(found) <= 1000, "1000 bytes, of which two may be one character"
        assert tracemalloc.get_traced_memory()[1] < BYTES
    finally:
        tracemalloc.stop()


def test_the_local_registry(server: Hostile, tmp_path: Path) -> None:
    here: Services = replace(services(tmp_path), registry=server.address)
    for answer in (endless(200), reply(302, headers={"Location": "http://["}), endless(500)):
        server.answers = {".": answer}
        ends(lambda: here.get("/v2/"))


def test_what_takes_the_place_of_a_registry(server: Hostile, monkeypatch: pytest.MonkeyPatch) -> None:
    version = {"Docker-Distribution-Api-Version": "registry/2.0"}
    server.answers = {".": endless(200, headers=version)}
    monkeypatch.setattr(network, "HUB_API", f"http://{server.address}/v2/")
    before = time.monotonic()
    assert network.registry_answers(server.address) and network.docker_hub_answers("")
    server.answers = {".": reply(302, headers={"Location": "http://["})}
    assert not network.registry_answers(server.address) and not network.docker_hub_answers("")
    assert time.monotonic() - before < WALL


# ---- JSON ------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("document", "why"),
    [
        ("[" * 200 + "]" * 200, "nested"), ("[" * 1_000_000, "nested"), ('{"a":' * 900 + "1" + "}" * 900, "nested"),
        ("1" * 31, "a number of 31 digits"), ("1" * 4_000_000, "digits"), ("1e999", "number"), ("NaN", "NaN"),
        ('"\\ud800"', "half of"), (b'"\xed\xa0\x80"', "not UTF-8"), ('"\udc80"', "."), ("[1,]", "."), ("", "."),
    ],
)  # fmt: skip
def test_json_that_is_refused(document: str | bytes, why: str) -> None:
    before = time.thread_time()
    with pytest.raises(ValueError, match=why) as caught:
        untrusted.json_value(document)
    with pytest.raises(ValueError, match="more than"):
        untrusted.json_value(b"[]" + b" " * 100, 100)
    assert time.thread_time() - before < SECONDS and len(str(caught.value)) < 100


@pytest.mark.parametrize(
    ("document", "content"),
    [("[" * 64 + "]" * 64, ...), (b"\xef\xbb\xbf{}", {}), ('{"a": "\\ud83d\\ude00 ä", "b": "[[["}', {"a": "😀 ä", "b": "[[["}), ("-1.5", -1.5)],
)  # fmt: skip
def test_json_that_is_read(document: str | bytes, content: Any) -> None:
    assert content is ... or untrusted.json_value(document) == content
    assert untrusted.json_value(document) is not None


def test_httpx_is_asked_for_nothing_that_it_unpacks() -> None:
    """If a new version of httpx unpacks raw bytes, bombs are bombs again."""
    answer = httpx.Response(200, headers={"Content-Encoding": "gzip"}, stream=httpx.ByteStream(BOMB[:1000]))
    assert b"".join(answer.iter_raw()) == BOMB[:1000]
