"""What a broken or hostile registry sends: each answer ends in an error with a remedy, within a second and without much memory."""

from __future__ import annotations

import gzip
import json
import time
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from typing import Any

import pytest

from fakes.hostile import Answer, Hostile, endless, hostile, limited_error, reply
from fakes.http_registry import LocalRegistry
from fakes.mutations import bomb
from fakes.stubs import services
from rosml.base import web
from rosml.base.errors import RosmlError
from rosml.containerize.base_image import base as app_base
from rosml.images.builds import contents
from rosml.images.join import file_lists
from rosml.registry import oci, retries
from rosml.registry.client import Registry
from rosml.registry.credentials import Credentials
from rosml.registry.documents import Descriptor
from rosml.registry.transport import PAGES

SOMEBODY = Credentials("somebody", "s3cret-Pass")
DIGEST = "sha256:" + "1" * 64
DEEP = b'{"a":' * 100_000
BOMB = bomb(200)
GZIP = {"Content-Encoding": "gzip"}
NO_HOSTS = ["http://[", "https://a..b/x", f"http://{'a' * 64}.org/x", "ftp://a/x", "http://127.0.0.1:99999/x", "http://\x7f/"]  # fmt: skip
WHOLE = {"schemaVersion": 2, "mediaType": oci.IMAGE, "layers": []}
LINUX = {"os": "linux", "architecture": "amd64"}

Ask = Callable[[Registry], object]


@pytest.fixture(autouse=True)
def quick(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr(retries, "WAIT", 0.001)
    monkeypatch.setattr(retries, "LONGEST_WAIT", 0.01)
    monkeypatch.setenv("DOCKER_CONFIG", str(tmp_path / "docker"))
    monkeypatch.delenv("DOCKER_AUTH_CONFIG", raising=False)


@pytest.fixture
def hostile_server() -> Iterator[Hostile]:
    with hostile() as running:
        yield running


# ---- Answers of a registry -------------------------------------------------------------------------------------------


ASKS: dict[str, Ask] = {
    "manifest": lambda registry: registry.manifest("a", "x"),
    "by digest": lambda registry: registry.manifest("a", DIGEST),
    "head": lambda registry: registry.head("a", "x"),
    "tags": lambda registry: registry.tags("a"),
    "blob": lambda registry: registry.blob("a", DIGEST),
    "stream": lambda registry: registry.read_blob("a", DIGEST, lambda blocks: sum(map(len, blocks)), 1000),
    "part": lambda registry: registry.part("a", Descriptor(mediaType="x", digest=DIGEST, size=1000)),
    "push": lambda registry: registry.put_blob("a", b"hello"),
    "referrers": lambda registry: [registry.manifest("a", "existing"), registry.referrers("a", DIGEST)],
    "move": lambda registry: registry.tag("a", oci.digest_of(json.dumps(WHOLE).encode()), "x"),
    "attach": lambda registry: registry.attach("a", oci.descriptor(oci.IMAGE, b"x"), "a/b", b"x", "a/b"),
    "file list": lambda registry: file_lists.Lists().of(registry, "a", DIGEST),
    "platforms": lambda registry: contents.manifests(registry, "a", "x"),
}


def get(code: int, body: bytes = b"", **headers: str | bytes) -> dict[str, Answer]:
    """The same answer to each GET."""
    return {"GET": reply(code, body, {name.replace("_", "-"): value for name, value in headers.items()})}


def changed(**fields: Any) -> dict[str, Answer]:
    return get(200, json.dumps({**WHOLE, **fields}).encode())


def challenge(value: str | bytes) -> dict[str, Answer]:
    return {".": reply(401, headers={"WWW-Authenticate": value})}


def token(answer: bytes | Answer) -> dict[str, Answer]:
    """A registry that needs a token, with the body or the answer of its token server."""
    body = answer if callable(answer) or answer.startswith(b"HTTP") else reply(200, answer)
    return {"/token": body, **challenge('Bearer realm="/token",service="x"')}


ANSWERS: dict[str, tuple[str, dict[str, Answer]]] = {
    "a challenge of 60 kB": ("manifest", challenge("Bearer " + "a" * 60_000)),
    "a challenge of 60 kB of spaces": ("manifest", challenge("Bearer realm" + " " * 60_000 + "x")),
    "a challenge with an open quote": ("manifest", challenge('Bearer realm="' + '\\"' * 30_000)),
    "a challenge in latin-1": ("manifest", challenge('Bearer realm="http://ä/",service="ä"'.encode("latin-1"))),
    **{f"a realm at {host}": ("manifest", challenge(f'Bearer realm="{host}"')) for host in NO_HOSTS[:-1]},
    "a token that is not ASCII": ("manifest", token('{"token": "ä"}'.encode())),
    "a token of two lines": ("manifest", token(b'{"token": "a\\r\\nX: y"}')),
    "a token that is too large": ("manifest", token(b'{"token": "' + b"a" * (1 << 20) + b'"}')),
    "a token that holds for 400 digits": ("manifest", token(b'{"token": "a", "expires_in": ' + b"9" * 400 + b"}")),
    "a token without an end": ("manifest", token(endless(200))),
    "a token that is a bomb": ("manifest", token(reply(200, BOMB, GZIP))),
    "a manifest without an end": ("manifest", {"GET": endless(200)}),
    "a manifest of 100 MB": ("manifest", get(200, Content_Length="100000000")),
    "a manifest that is a bomb": ("manifest", get(200, BOMB, Content_Encoding="gzip")),
    "a deep manifest": ("manifest", get(200, DEEP)),
    "a manifest with half a character": ("manifest", changed(annotations={"x": "\ud800"})),
    "a manifest that is an index too": ("manifest", changed(manifests=[])),
    "a manifest whose type is no type": ("manifest", changed(mediaType="a/b\nc: d")),
    "a manifest whose type is not ASCII": ("move", get(200, json.dumps(WHOLE).encode(), Content_Type="a/ä".encode("latin-1"))),
    "a digest with another one behind it": ("manifest", changed(layers=[{"mediaType": "x", "size": 1, "digest": DIGEST + "/../../x"}])),
    "an error without an end": ("manifest", {"GET": endless(400)}),
    "an error that is a bomb": ("manifest", get(400, BOMB, Content_Encoding="gzip")),
    "a deep error": ("manifest", get(400, b'{"errors": ' + b"[" * 60_000)),
    "an error that moves the cursor": ("manifest", get(400, b'{"errors": [{"code": "X", "message": "\\u001b]52;c;eA==\\u0007 x"}]}')),
    "a wait of 5,000 digits": ("manifest", get(429, Retry_After="9" * 5000)),
    "a wait until the end of time": ("manifest", get(503, Retry_After="Fri, 31 Dec 9999 23:59:59 -2359")),
    **{f"a blob at {host}": ("blob", get(302, Location=host)) for host in NO_HOSTS},
    **{f"an upload at {host}": ("push", {"POST": reply(202, headers={"Location": host})}) for host in NO_HOSTS},
    "a manifest at no host": ("manifest", get(302, Location=NO_HOSTS[0])),
    "an upload nowhere": ("push", {"POST": reply(202)}),
    "a redirect that is a bomb": ("blob", get(302, BOMB, Content_Encoding="gzip", Location="/v2/a/blobs/" + DIGEST)),
    "a redirect to itself": ("manifest", get(307, Location="/v2/a/manifests/x")),
    "a blob without an end": ("blob", {"GET": endless(200)}),
    "a blob that is a bomb": ("blob", get(200, BOMB, Content_Encoding="gzip")),
    "a stream without an end": ("stream", {"GET": endless(200)}),
    "a blob that is larger than its manifest says": ("part", {"GET": endless(200)}),
    "tags that are no tags": ("tags", get(200, b'{"tags": ["../../../x", "\\u001b[2J"]}')),
    "tags without an end": ("tags", {"GET": endless(200)}),
    **{
        f"a link to {address}": ("tags", get(200, b'{"tags": []}', Link=f'<{address}>; rel="next"'))
        for address in ("http://evil.example/v2/a/tags/list", *NO_HOSTS[:-1])
    },
    "a deep list of referrers": (
        "referrers",
        {
            "/existing": reply(200, json.dumps(WHOLE).encode()),
            "/referrers/": reply(200, b'{"manifests": ' + b"[" * 100_000),
            "GET": reply(400, DEEP),
        },
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", ANSWERS)
def test_an_answer(hostile_server: Hostile, name: str) -> None:
    ask, hostile_server.answers = ANSWERS[name]
    with Registry(hostile_server.address, credentials=lambda _: SOMEBODY) as registry:
        limited_error(lambda: ASKS[ask](registry))


def test_a_list_has_an_end(hostile_server: Hostile) -> None:
    pages = iter(range(1 << 30))

    def page() -> Iterator[bytes]:
        number = next(pages)
        yield reply(200, b'{"tags": ["t%d"]}' % number, {"Link": f'</v2/a/tags/list?last={number}>; rel="next"'})

    hostile_server.answers = {"GET": page}
    with Registry(hostile_server.address) as registry, pytest.raises(RosmlError, match="a list without end"):
        registry.tags("a")
    assert len(hostile_server.requests) == PAGES + 1


def test_a_link_of_60_kb_is_none(hostile_server: Hostile) -> None:
    hostile_server.answers = get(200, b'{"tags": ["x"]}', Link="<" * 30_000 + ">; " * 10_000)
    with Registry(hostile_server.address) as registry:
        before = time.thread_time()
        assert registry.tags("a") == ["x"]
        assert time.thread_time() - before < 1


def test_an_answer_takes_no_hours(hostile_server: Hostile, monkeypatch: pytest.MonkeyPatch) -> None:
    """A byte now and then keeps a connection alive for ever."""
    monkeypatch.setattr(web, "LONGEST", 0.3)

    def slow() -> Iterator[bytes]:
        for block in endless(200, b"[")():
            yield block
            time.sleep(0.02)

    hostile_server.answers = {"GET": slow}
    with Registry(hostile_server.address) as registry:
        for ask in ("manifest", "tags", "blob"):
            assert "takes longer" in limited_error(partial(ASKS[ask], registry)).message


def test_cookies_are_not_kept(hostile_server: Hostile) -> None:
    hostile_server.answers = {".": reply(200, json.dumps(WHOLE).encode(), {"Set-Cookie": "a=b; Path=/"})}
    with Registry(hostile_server.address) as registry:
        for _ in range(2):
            assert registry.manifest("a", "x")
    assert not any("cookie" in headers for _, headers in hostile_server.requests)


@pytest.mark.parametrize("header", ["sha256:x", "../../../x", "md5:" + "1" * 32, "sha256:" + "A" * 64, DIGEST + "x"])
def test_a_header_without_a_digest_is_not_believed(hostile_server: Hostile, header: str) -> None:
    data = json.dumps(WHOLE).encode()
    hostile_server.answers = {".": reply(200, data, {"Docker-Content-Digest": header})}
    with Registry(hostile_server.address) as registry:
        assert registry.head("a", "x") == oci.digest_of(data)


def test_a_digest_of_other_content_is_not_believed(hostile_server: Hostile) -> None:
    hostile_server.answers = {
        ".": reply(200, json.dumps(WHOLE).encode(), {"Docker-Content-Digest": "sha256:" + "2" * 64})
    }
    with Registry(hostile_server.address) as registry:
        assert "has another digest" in limited_error(lambda: registry.head("a", DIGEST)).message


@pytest.mark.parametrize("name", ["../../x", "x?y=z", "sha256:1", "a/b", "x" * 129, ""])
def test_a_name_that_leads_elsewhere_is_not_asked_for(hostile_server: Hostile, name: str) -> None:
    """Records and indexes name manifests."""
    with Registry(hostile_server.address) as registry:
        for ask in (registry.manifest, registry.head, registry.delete):
            assert "neither a tag nor a digest" in limited_error(partial(ask, "a", name)).message
        assert "no digest" in limited_error(lambda: registry.blob("a", name)).message
    assert hostile_server.requests == []


# ---- Images that are none --------------------------------------------------------------------------------------------

CONFIGS: dict[str, Any] = {
    "a label that is a number": {**LINUX, "config": {"Labels": {"x": 5}}},
    "a variable that is null": {**LINUX, "config": {"Env": [None]}},
    "layers that are text": {**LINUX, "rootfs": {"diff_ids": "x"}},
    "no object": [],
    "a deep config": {**LINUX, "x": json.loads("[" * 500 + "]" * 500)},
}


def put_image(client: Registry, content: Any, **fields: Any) -> dict[str, Any]:
    """Puts an image with such a config; returns its descriptor with a platform."""
    data = json.dumps(content).encode()
    client.put_blob("a", data)
    image: dict[str, Any] = {**WHOLE, "config": oci.descriptor(oci.CONFIG, data), **fields}
    encoded = oci.encoded({name: value for name, value in image.items() if value is not None})
    client.put_manifest("a", "x", encoded)
    return {**oci.descriptor(oci.IMAGE, encoded), "platform": LINUX}


def put_artifact(client: Registry) -> str:
    return client.put_artifact("a", "x", "application/x", b"data", "text/plain")


def put_index(client: Registry, *entries: dict[str, Any]) -> None:
    client.put_manifest("a", "x", {"schemaVersion": 2, "mediaType": oci.INDEX, "manifests": entries}, oci.INDEX)


def index_of_artifacts(client: Registry) -> None:
    artifact = client.manifest("a", put_artifact(client))
    assert artifact
    put_index(client, {**artifact.descriptor, "platform": LINUX})


IMAGES: dict[str, Callable[[Registry], object]] = {
    **{name: partial(put_image, content=content) for name, content in CONFIGS.items()},
    "an artifact": put_artifact,
    "no config": lambda client: put_image(client, {}, config=None),
    "an index of nothing": put_index,
    "an index without a platform": lambda client: put_index(client, {**put_image(client, LINUX), "platform": None}),
    "an index of artifacts": index_of_artifacts,
    "an index of missing images": lambda client: put_index(
        client, {"mediaType": oci.IMAGE, "size": 1, "digest": DIGEST, "platform": LINUX}
    ),
}


@pytest.mark.parametrize("name", IMAGES)
def test_a_base_image_that_is_none(server: LocalRegistry, tmp_path: Path, name: str) -> None:
    server.checks = False
    with Registry(server.address) as client:
        IMAGES[name](client)
    here = services(tmp_path, server.address)
    error = limited_error(lambda: app_base.find(f"{server.address}/a:x", here, ("linux/amd64",)))
    assert any(place in error.message for place in (f"{server.address}/a:x", "/v2/a/", "sha256:"))


def test_an_image_without_a_config_has_no_list_of_files(server: LocalRegistry) -> None:
    """An index may list indexes, and those may list more."""
    server.checks = False
    with Registry(server.address) as client:
        entry = put_image(client, {}, config=None)
        for _ in range(2):
            assert "it has no config" in limited_error(lambda: contents.manifests(client, "a", "x")).message
            put_index(client, entry)


def test_an_index_without_platforms_is_a_base_image_of_any(server: LocalRegistry, tmp_path: Path) -> None:
    with Registry(server.address) as client:
        put_index(client, {**put_image(client, {**LINUX, "config": None}), "platform": None})
    assert app_base.find(f"{server.address}/a:x", services(tmp_path, server.address), ()).labels == {}


# ---- Lists of files --------------------------------------------------------------------------------------------------


def files(data: bytes) -> file_lists.Files:
    return file_lists.Files.parse(file_lists.unpacked(data))


def test_all_members_of_a_gzip_file_are_read() -> None:
    assert files(gzip.compress(b"a\n") + gzip.compress(b"usr/bin/env\n")).entries == {"a", "usr/bin/env"}


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
    limited_error(lambda: files(data))
