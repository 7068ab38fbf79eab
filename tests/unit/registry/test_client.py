"""The registry client, against a registry in this process that goes wrong: what is tried again, what is not, and what is
said. Against the real one: tests/e2e/test_join.py."""

from __future__ import annotations

import base64
import json
import logging
import ssl
import threading
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import httpx
import pytest
import trustme

from fakes.http_registry import DROP, StandIn, standing_in
from fakes.stubs import executable
from rosml.base.errors import RosmlError
from rosml.registry import failures, login, oci
from rosml.registry.client import Registry
from rosml.registry.credentials import DOCKER_HUB, Credentials, from_docker
from rosml.registry.references import parse

NAME, SECRET = "somebody", "s3cret-Pass"
MANIFEST = {"schemaVersion": 2, "mediaType": oci.IMAGE, "layers": []}
TYPE = "application/vnd.example.v1"


@pytest.fixture(autouse=True)
def quick(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr(failures, "WAIT", 0.001)
    monkeypatch.setattr(failures, "LONGEST_WAIT", 0.01)
    monkeypatch.setenv("DOCKER_CONFIG", str(tmp_path / "docker"))
    monkeypatch.delenv("DOCKER_AUTH_CONFIG", raising=False)


@pytest.fixture
def server() -> Iterator[StandIn]:
    with standing_in() as found:
        yield found


@pytest.fixture
def registry(server: StandIn) -> Iterator[Registry]:
    with Registry(server.address) as found:
        yield found


def docker_config(tmp_path: Path, **content: Any) -> None:
    (tmp_path / "docker").mkdir(exist_ok=True)
    (tmp_path / "docker" / "config.json").write_text(json.dumps(content))


def auth(name: str = NAME, secret: str = SECRET) -> dict[str, str]:
    return {"auth": base64.b64encode(f"{name}:{secret}".encode()).decode()}


# ---- References ------------------------------------------------------------------------------------------------------

DIGEST = "sha256:" + "1" * 64


@pytest.mark.parametrize(
    ("text", "parts"),
    [
        ("ghcr.io/me/ros:jazzy-base", ("ghcr.io", "me/ros", "jazzy-base")),
        ("localhost/ros", ("localhost", "ros", "latest")),
        ("127.0.0.1:5000/a/b/c_d:T.1", ("127.0.0.1:5000", "a/b/c_d", "T.1")),
        (f"[::1]:5000/ros:x@{DIGEST}", ("[::1]:5000", "ros", DIGEST)),
        (f"docker.io/library/ubuntu@{DIGEST}", ("docker.io", "library/ubuntu", DIGEST)),
    ],
)
def test_references(text: str, parts: tuple[str, str, str]) -> None:
    assert parse(text) == parts
    assert parse(str(parse(text))) == parts


@pytest.mark.parametrize(
    "text", ["", "ros", "me/ros:x", "ghcr.io/", "ghcr.io/ME/ros", "ghcr.io/ros:", "ghcr.io/ros@sha256:12", "a.b/c:d:e", "a.b/c/../d"]
)  # fmt: skip
def test_what_is_no_reference(text: str) -> None:
    with pytest.raises(RosmlError, match="no reference") as caught:
        parse(text)
    assert caught.value.exit_code == 2
    assert "ghcr.io/me/ros:jazzy-base" in caught.value.remedy


@pytest.mark.parametrize(("host", "scheme"), [("127.0.0.1:1", "http"), ("localhost", "http"), ("[::1]:1", "http"),
                                              ("ghcr.io", "https"), ("127.example.org:5000", "https")])  # fmt: skip
def test_plain_http_is_for_this_machine(host: str, scheme: str) -> None:
    assert Registry(host).transport.base.scheme == scheme
    assert Registry(host, plain=scheme == "https").transport.base.scheme != scheme


# ---- What it does ----------------------------------------------------------------------------------------------------


def test_manifests_and_tags(server: StandIn, registry: Registry) -> None:
    digest = registry.put_manifest("a/b", "", MANIFEST)
    assert registry.tags("a/b") == []
    assert registry.manifest("a/b", "one") is None
    assert registry.head("a/b", "one") == ""
    registry.tag("a/b", digest, "one")
    found = registry.manifest("a/b", "one")
    assert found == oci.Manifest(MANIFEST, digest, oci.IMAGE, len(oci.encoded(MANIFEST)))
    assert registry.head("a/b", "one") == digest
    registry.delete("a/b", digest)
    registry.delete("a/b", digest)
    assert registry.manifest("a/b", digest) is None
    with pytest.raises(RosmlError, match="no tag can point at it"):
        registry.tag("a/b", digest, "two")


def test_same_content_same_digest(registry: Registry) -> None:
    turned = dict(reversed(MANIFEST.items()))
    assert registry.put_manifest("a", "x", MANIFEST) == registry.put_manifest("a", "y", turned)


def test_tags_come_in_pages(server: StandIn, registry: Registry) -> None:
    server.page = 7
    server.tags["a"] = {f"t{number:03}": "d" for number in range(50)}
    assert registry.tags("a") == sorted(server.tags["a"])
    assert server.count("tags/list") == 8


def test_blobs(server: StandIn, registry: Registry) -> None:
    digest = registry.put_blob("a", b"hello")
    assert registry.blob("a", digest) == b"hello"
    assert (registry.has_blob("a", digest), registry.has_blob("b", digest)) == (True, False)
    registry.put_blob("a", b"hello")
    assert server.count("^PUT") == 1, "what is there is not sent again"
    assert registry.uploaded == 5


def test_mount(server: StandIn, registry: Registry) -> None:
    digest = registry.put_blob("a", b"hello")
    assert registry.mount("b", digest, "a")
    assert registry.has_blob("b", digest)
    server.mounts = False
    assert not registry.mount("c", digest, "a")
    assert server.aborted == 1, "the upload that was begun instead is ended"
    assert registry.uploaded == 5


def test_copy_from_another_registry(registry: Registry) -> None:
    data = bytes(range(256)) * 20_000
    with standing_in() as other, Registry(other.address) as source:
        digest = source.put_blob("far/away", data)
        other.fault("GET", "/blobs/", 503)
        other.fault("GET", "/blobs/", DROP)
        registry.copy_blob("here", digest, len(data), source, "far/away")
        assert registry.blob("here", digest) == data


def test_copy_of_a_damaged_blob(server: StandIn, registry: Registry) -> None:
    with standing_in() as other, Registry(other.address) as source:
        digest = source.put_blob("a", b"hello")
        other.blobs["a", digest] = b"jello"
        with pytest.raises(RosmlError, match="has another digest"):
            registry.copy_blob("here", digest, 5, source, "a")
    assert not server.blobs


def described(registry: Registry) -> dict[str, Any]:
    """Puts a manifest; gives its descriptor."""
    registry.put_manifest("a", "x", MANIFEST)
    return oci.descriptor(oci.IMAGE, oci.encoded(MANIFEST))


@pytest.mark.parametrize("api", [True, False])
def test_referrers(server: StandIn, registry: Registry, api: bool) -> None:
    server.referrers = api
    subject = described(registry)
    assert registry.referrers("a", subject["digest"]) == []
    first = registry.attach("a", subject, TYPE, b"one", "text/plain", {"k": "v"})
    second = registry.attach("a", subject, "application/other", b"two", "text/plain")
    assert registry.attach("a", subject, TYPE, b"one", "text/plain", {"k": "v"}) == first, "the same again is the same"
    assert [entry["digest"] for entry in registry.referrers("a", subject["digest"])] == [first, second]
    (entry,) = registry.referrers("a", subject["digest"], TYPE)
    assert (entry["digest"], entry["artifactType"]) == (first, TYPE)
    manifest = registry.manifest("a", first)
    assert manifest is not None
    assert registry.blob("a", manifest.content["layers"][0]["digest"]) == b"one"
    assert server.tags["a"].keys() == ({"x"} if api else {"x", subject["digest"].replace(":", "-")})


PAGE = b"<html>Sign in to GitHub</html>"


@pytest.mark.parametrize(
    ("code", "times", "body"),
    [(303, 1, b""), (404, 1, PAGE), (429, failures.ATTEMPTS, b""), (200, 1, PAGE), (200, 1, b"[]"), (400, 1, b"")],
)
def test_what_is_no_index_says_that_there_are_no_referrers(
    server: StandIn, registry: Registry, code: int, times: int, body: bytes
) -> None:
    """ghcr.io redirects to a page for people; nobody asks that page, and the registry is not asked again."""
    with standing_in() as pages:
        headers = {"Location": f"http://{pages.address}/me/a"} if code == 303 else {}
        server.fault("GET", "/referrers/", code, 1000, body=body, headers=headers)
        subject = described(registry)
        assert registry.referrers("a", subject["digest"]) == []
        made = registry.attach("a", subject, TYPE, b"one", "text/plain")
        assert [entry["digest"] for entry in registry.referrers("a", subject["digest"], TYPE)] == [made]
        assert server.count("/referrers/") == times
        assert pages.requests == []


def test_a_registry_that_has_referrers_does_not_lose_them_for_a_moment(server: StandIn, registry: Registry) -> None:
    server.referrers = True
    subject = described(registry)
    made = registry.attach("a", subject, TYPE, b"one", "text/plain")
    server.fault("GET", "/referrers/", 429, 2)
    assert [entry["digest"] for entry in registry.referrers("a", subject["digest"])] == [made]
    server.fault("GET", "/referrers/", 200, body=PAGE)
    with pytest.raises(RosmlError, match="is no JSON object"):
        registry.referrers("a", subject["digest"])


@pytest.mark.parametrize("method", ["GET", "HEAD"])
def test_a_manifest_that_is_redirected_elsewhere_is_not_missing(
    server: StandIn, registry: Registry, method: str
) -> None:
    """The other host knows no manifests, and its 404 would let a tag move without a look at where it was."""
    digest = registry.put_manifest("a", "x", MANIFEST)

    def ask() -> str:
        found = registry.manifest("a", "x") if method == "GET" else None
        return found.digest if found else registry.head("a", "x")

    with standing_in() as elsewhere:
        there = {"Location": f"http://{elsewhere.address}/v2/a/manifests/x?signed=s3cret"}
        server.fault(method, "/manifests/", 307, 2, headers=there)
        assert ask() == digest, "it passes"
        server.fault(method, "/manifests/", 307, failures.ATTEMPTS, headers=there)
        with pytest.raises(RosmlError, match=r"/v2/a/manifests/x: 307: a redirect to 127\.0\.0\.1") as caught:
            ask()
        assert "s3cret" not in caught.value.message and "run it again" in caught.value.remedy
        assert elsewhere.requests == []
    server.fault(method, "/manifests/x$", 307, headers={"Location": f"/v2/a/manifests/{digest}"})
    assert ask() == digest, "within the registry it is followed"


@pytest.mark.parametrize("api", [False, True], ids=["tag", "api"])
def test_what_is_attached_can_go(server: StandIn, registry: Registry, api: bool) -> None:
    """With what it is attached to: also the list that stands in for the API."""
    server.referrers = api
    subject: dict[str, Any] = {"mediaType": oci.IMAGE, "digest": registry.put_manifest("a", "", MANIFEST), "size": 1}
    before = server.manifests["a", subject["digest"]]
    first, second = (registry.attach("a", subject, TYPE, data, "text/plain") for data in (b"one", b"two"))
    assert server.manifests["a", subject["digest"]] == before, "the manifest itself changed"
    assert {entry["digest"] for entry in registry.referrers("a", subject["digest"])} == {first, second}
    registry.forget("a", subject["digest"])
    assert registry.tags("a") == [], "the list of what was attached to a manifest that is gone"
    registry.forget("a", subject["digest"])


def test_many_attach_at_once(registry: Registry) -> None:
    subject = described(registry)
    with ThreadPoolExecutor(8) as pool:
        made = list(pool.map(lambda n: registry.attach("a", subject, TYPE, b"%d" % n, "text/plain"), range(24)))
    assert {entry["digest"] for entry in registry.referrers("a", subject["digest"])} == set(made)
    assert len(set(made)) == 24


def test_nobody_waits_for_what_is_attached_to_another_image(server: StandIn, registry: Registry) -> None:
    """Without the API each manifest has a list of its own."""
    both = threading.Barrier(2, timeout=20)
    server.answering = lambda request: both.wait() if request.startswith("PUT /v2/a/manifests/sha256-") else None
    contents = [{**MANIFEST, "annotations": {"number": number}} for number in ("1", "2")]
    for content in contents:
        registry.put_manifest("a", "", content)
    subjects = [oci.descriptor(oci.IMAGE, oci.encoded(content)) for content in contents]
    with ThreadPoolExecutor(2) as pool:
        made = list(pool.map(lambda subject: registry.attach("a", subject, TYPE, b"one", "text/plain"), subjects))
    assert len(set(made)) == 2


def test_two_publishers_change_what_is_attached(server: StandIn, registry: Registry) -> None:
    """Without the API there is one list of it: what another publisher adds between a look at it and its change stays."""
    subject = described(registry)
    first = registry.attach("a", subject, TYPE, b"one", "text/plain")
    theirs: list[str] = []

    def meanwhile(request: str) -> None:
        if request == f"GET /v2/a/manifests/{subject['digest'].replace(':', '-')}" and not theirs:
            theirs.append("begun")
            theirs.append(other.attach("a", subject, TYPE, b"theirs", "text/plain"))

    with Registry(server.address) as other:
        server.answering = meanwhile
        ours = [first, registry.attach("a", subject, TYPE, b"two", "text/plain")]
    assert {entry["digest"] for entry in registry.referrers("a", subject["digest"])} == {*ours, theirs[1]}


# ---- What goes wrong -------------------------------------------------------------------------------------------------

FAULTS: list[int | str] = [429, 500, 502, 503, 504, DROP]


@pytest.mark.parametrize("kind", FAULTS)
def test_what_fails_for_a_moment_is_tried_again(server: StandIn, registry: Registry, kind: int | str) -> None:
    registry.tags("a")  # it was reached
    for method, path in (("GET", "/manifests/"), ("HEAD", "/manifests/"), ("PUT", "/manifests/"), ("GET", "/tags/"),
                         ("POST", "/uploads/"), ("PUT", "/uploads/"), ("HEAD", "/blobs/"), ("GET", "/blobs/"),
                         ("DELETE", "/manifests/")):  # fmt: skip
        server.fault(method, path, kind, 3)
    digest = registry.put_manifest("a", "x", MANIFEST)
    assert registry.head("a", "x") == digest
    assert registry.manifest("a", "x") is not None
    assert registry.tags("a") == ["x"]
    assert registry.blob("a", registry.put_blob("a", b"hello")) == b"hello"
    registry.delete("a", digest)
    assert not any(fault.times for fault in server.faults)


@pytest.mark.parametrize("kind", FAULTS)
def test_what_stays_wrong_is_an_error(server: StandIn, registry: Registry, kind: int | str) -> None:
    registry.tags("a")
    server.fault("GET", "/manifests/", kind, 1000)
    with pytest.raises(RosmlError) as caught:
        registry.manifest("a", "x")
    assert server.address in caught.value.message
    assert "/v2/a/manifests/x" in caught.value.message
    assert "run it again" in caught.value.remedy
    assert server.count("manifests") == failures.ATTEMPTS


def test_a_registry_that_is_not_there_is_told_soon() -> None:
    with pytest.raises(RosmlError, match=r"127\.0\.0\.1:1: GET .*refused") as caught:
        Registry("127.0.0.1:1").manifest("a", "x")
    assert "check its name" in caught.value.remedy


def test_a_connection_that_drops_at_once_is_no_wrong_name(server: StandIn, registry: Registry) -> None:
    server.fault("GET", "/manifests/", DROP, failures.ATTEMPTS - 1)
    assert registry.manifest("a", "x") is None


def test_retry_after(server: StandIn, registry: Registry, monkeypatch: pytest.MonkeyPatch) -> None:
    """It waits as long as the registry asks for, within limits."""
    monkeypatch.setattr(failures, "LONGEST_WAIT", 1.2)
    for asked, waited in (("1", 1.0), ("86400", 1.2), ("Sat, 01 Jan 2050 00:00:00 GMT", 1.2), ("soon", 0.0)):
        server.fault("GET", "/tags/", 503, headers={"Retry-After": asked})
        pauses: list[float] = []
        with monkeypatch.context() as patched:
            patched.setattr(time, "sleep", pauses.append)
            registry.tags("a")
        assert len(pauses) == 1 and waited <= pauses[0] <= 1.2


@pytest.mark.parametrize("code", [400, 409, 412])
def test_a_tag_that_may_not_move(server: StandIn, registry: Registry, code: int) -> None:
    """The same content is there already; other content is refused at once, with the tag."""
    registry.put_manifest("a", "x", MANIFEST)
    body = b'{"errors": [{"code": "TAG_INVALID", "message": "The tag x is immutable and cannot be overwritten"}]}'
    server.fault("PUT", "/manifests/x", code, 1000, body=body)
    registry.put_manifest("a", "x", MANIFEST)
    before = server.count("manifests/x")
    with pytest.raises(
        RosmlError, match="a:x is there with other content, and the registry lets no tag move"
    ) as caught:
        registry.put_manifest("a", "x", {**MANIFEST, "annotations": {"b": "c"}})
    assert caught.value.remedy == "choose another tag"
    assert server.count("manifests/x") == before + 2, "no attempt is repeated"


@pytest.mark.parametrize(
    ("asked", "before", "requests", "remedy"),
    [
        ("", False, failures.ATTEMPTS_LIMITED, "wait some minutes, or log in"),
        ("3600", False, 1, "wait 60 min 0 s, as it asks, or log in"),
        ("3600", True, 1, "wait 60 min 0 s, as it asks, or log in"),
        ("", True, failures.ATTEMPTS, "wait some minutes, or log in"),
    ],
)
def test_too_many_requests(
    server: StandIn, registry: Registry, asked: str, before: bool, requests: int, remedy: str
) -> None:
    """A limit that is over in a moment is waited for, one that was there from the first request or lasts is not."""
    if before:
        registry.tags("a")
    server.fault("GET", "/manifests/", 429, 1000, headers={"Retry-After": asked} if asked else {})
    with pytest.raises(RosmlError) as caught:
        registry.manifest("a", "x")
    assert caught.value.remedy.startswith(remedy) and f"docker login {server.address}" in caught.value.remedy
    assert server.count("manifests") == requests


def test_a_blob_that_has_another_digest(server: StandIn, registry: Registry) -> None:
    digest = registry.put_blob("a", b"hello")
    server.blobs["a", digest] = b"jello"
    with pytest.raises(RosmlError, match=f"{digest} has another digest") as caught:
        registry.blob("a", digest)
    assert "damaged" in caught.value.remedy


def test_a_manifest_that_has_another_digest(server: StandIn, registry: Registry) -> None:
    digest = registry.put_manifest("a", "x", MANIFEST)
    server.manifests["a", digest] = (oci.IMAGE, b"{}")
    with pytest.raises(RosmlError, match="has another digest"):
        registry.manifest("a", digest)
    with pytest.raises(RosmlError, match="has another digest"):
        registry.tag("a", digest, "y")
    assert "y" not in server.tags["a"]


@pytest.mark.parametrize("body", [b"[]", b"<html>", b"null"])
def test_an_answer_that_is_no_object(server: StandIn, registry: Registry, body: bytes) -> None:
    server.fault("GET", "/manifests/", 200, body=body)
    with pytest.raises(RosmlError, match="is no JSON object") as caught:
        registry.manifest("a", "x")
    assert "HTTPS_PROXY" in caught.value.remedy


def test_redirects_without_end_name_the_registry(registry: Registry, monkeypatch: pytest.MonkeyPatch) -> None:
    def send(*_: object, **__: object) -> None:
        raise httpx.TooManyRedirects("no")

    monkeypatch.setattr(httpx.Client, "send", send)
    with pytest.raises(RosmlError, match=f"{registry.host}/v2/a/manifests/x: redirects without end"):
        registry.manifest("a", "x")


NO_DIGEST = {"mediaType": oci.IMAGE, "size": 1}
NO_SIZE = {"mediaType": oci.IMAGE, "digest": DIGEST}
NO_PLATFORM = {**NO_SIZE, "size": 1, "platform": "linux"}


@pytest.mark.parametrize(
    "answer",
    [
        {"tags": ["a", 1, None, {}]},
        {"schemaVersion": 2, "mediaType": oci.INDEX},
        {"schemaVersion": 2, "mediaType": oci.INDEX, "manifests": {"x": 1}},
        {"schemaVersion": 2, "mediaType": oci.INDEX, "manifests": [{"x": 1}]},
        {"schemaVersion": 2, "mediaType": oci.INDEX, "manifests": [NO_DIGEST]},
        {"schemaVersion": 2, "mediaType": oci.INDEX, "manifests": [{**NO_SIZE, "size": 1, "digest": "x"}]},
        {"schemaVersion": 2, "mediaType": oci.INDEX, "manifests": [NO_PLATFORM]},
        {"schemaVersion": 2, "mediaType": oci.IMAGE, "layers": [NO_SIZE]},
        {"schemaVersion": 2, "mediaType": oci.IMAGE, "layers": None},
        {"schemaVersion": 2, "mediaType": oci.IMAGE, "config": "x", "layers": []},
    ],
)
def test_a_manifest_of_another_shape(server: StandIn, registry: Registry, answer: dict[str, Any]) -> None:
    server.fault("GET", "/manifests/", 200, body=json.dumps(answer).encode())
    with pytest.raises(
        RosmlError, match=f"{server.address} does not answer as a registry: GET /v2/a/manifests/x: "
    ) as no:
        registry.manifest("a", "x")
    assert "HTTPS_PROXY" in no.value.remedy
    assert "pydantic" not in no.value.message


@pytest.mark.parametrize("answer", [{}, {"tags": "a"}, {"tags": ["a", 1, None, {}]}])
def test_tags_of_another_shape(server: StandIn, registry: Registry, answer: dict[str, Any]) -> None:
    server.fault("GET", "/tags/list", 200, body=json.dumps(answer).encode())
    with pytest.raises(RosmlError, match="does not answer as a registry"):
        registry.tags("a")


def test_a_repository_without_tags(server: StandIn, registry: Registry) -> None:
    server.fault("GET", "/tags/list", 200, body=b'{"name": "a", "tags": null}')
    assert registry.tags("a") == []


@pytest.mark.parametrize("answer", [{"tags": []}, {"manifests": ["x"]}, {"manifests": [NO_DIGEST]}])
def test_referrers_of_another_shape(server: StandIn, registry: Registry, answer: dict[str, Any]) -> None:
    server.referrers = True
    registry.put_manifest("a", "x", MANIFEST)
    assert registry.referrers("a", DIGEST) == []
    server.fault("GET", "/referrers/", 200, body=json.dumps(answer).encode())
    with pytest.raises(RosmlError, match="does not answer as a registry"):
        registry.referrers("a", DIGEST)


UNKNOWN = [
    (code, f'{{"errors": [{{"code": "{name}", "message": "blob unknown to registry"}}]}}'.encode())
    for code, name in ((400, "MANIFEST_BLOB_UNKNOWN"), (404, "BLOB_UNKNOWN"), (400, "MANIFEST_UNKNOWN"))
]


@pytest.mark.parametrize(("code", "body"), UNKNOWN)
def test_a_blob_that_a_part_of_the_registry_does_not_know_yet(
    server: StandIn, registry: Registry, code: int, body: bytes
) -> None:
    server.fault("PUT", "/manifests/", code, 3, body=body)
    assert registry.put_manifest("a", "x", MANIFEST) == registry.head("a", "x")
    server.fault("PUT", "/manifests/", code, 1000, body=body)
    before = server.count("^PUT")
    with pytest.raises(RosmlError, match=rf"PUT /v2/a/manifests/x: {code} \(blob unknown to registry\)"):
        registry.put_manifest("a", "x", MANIFEST)
    assert server.count("^PUT") - before == failures.ATTEMPTS_REFUSED, "it may really be missing"


@pytest.mark.parametrize("bearer", [True, False])
@pytest.mark.parametrize("method", ["POST", "PUT"])
@pytest.mark.parametrize("code", [403, 404, 409, 500])
def test_a_first_push_while_another_machine_makes_the_repository(
    server: StandIn, registry: Registry, tmp_path: Path, code: int, method: str, bearer: bool
) -> None:
    server.users, server.bearer = {NAME: SECRET}, bearer
    docker_config(tmp_path, auths={server.address: auth()})
    server.fault(method, "/uploads/", code, 3)
    assert registry.blob("a", registry.put_blob("a", b"hello")) == b"hello"
    server.fault("GET", "/token.*push", 403, 2)
    registry.may_push("b")


@pytest.mark.parametrize("where", ["/uploads/", "/token.*push"])
def test_a_push_that_is_denied_is_told_within_seconds(
    server: StandIn, registry: Registry, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, where: str
) -> None:
    server.users, server.bearer = {NAME: SECRET}, True
    docker_config(tmp_path, auths={server.address: auth()})
    registry.head("a", "x")  # it knows the account
    server.fault("GET" if "token" in where else "POST", where, 403, 1000)
    monkeypatch.setattr(failures, "WAIT", 0.5)
    pauses: list[float] = []
    monkeypatch.setattr(failures, "LONGEST_WAIT", 30)
    monkeypatch.setattr(time, "sleep", pauses.append)
    with pytest.raises(
        RosmlError, match=r"access denied: cannot .* with the account that is logged in .*403"
    ) as caught:
        registry.may_push("a")
    assert f"docker login {server.address}" in caught.value.remedy
    assert 5 < sum(pauses) < 12 and pauses == sorted(pauses)


def test_a_registry_says_why(server: StandIn, registry: Registry) -> None:
    server.fault("PUT", "/manifests/", 400, body=b'{"errors": [{"code": "X", "message": "blob unknown"}]}')
    with pytest.raises(RosmlError, match=r"PUT /v2/a/manifests/x: 400 \(blob unknown\)"):
        registry.put_manifest("a", "x", MANIFEST)
    with pytest.raises(RosmlError, match=r"/v2/a/blobs/sha256:1.*: 404"):
        registry.blob("a", DIGEST)


def test_a_registry_that_deletes_nothing(server: StandIn, registry: Registry) -> None:
    server.fault("DELETE", "/manifests/", 405)
    with pytest.raises(RosmlError, match="deletes nothing"):
        registry.delete("a", DIGEST)
    server.fault("DELETE", "/manifests/", 405)
    with pytest.raises(RosmlError, match="deletes no tag by its name"):
        registry.delete("a", "x")


@pytest.mark.parametrize("kind", [400, 403, 404, 405, 503])
def test_a_registry_that_discards_nothing_is_asked_once(server: StandIn, registry: Registry, kind: int) -> None:
    """404 as well, where the manifest is still there; and once only, if it has no time."""
    server.fault("DELETE", "/manifests/", kind, failures.ATTEMPTS)
    digest = registry.put_manifest("a", "x", MANIFEST)
    for _ in range(2):
        registry.discard("a", digest)
        assert server.count("^DELETE") == 1 and registry.head("a", digest) == digest
    server.faults.clear()
    other = registry.put_manifest("b", "x", MANIFEST)
    registry.discard("b", other)
    assert registry.head("b", other) == "", "another repository may have other rules"


def test_what_somebody_else_removed_is_discarded(server: StandIn, registry: Registry) -> None:
    """And the registry is asked for the next one."""
    digest = registry.put_manifest("a", "x", MANIFEST)
    registry.discard("a", DIGEST)
    registry.discard("a", digest)
    assert registry.head("a", digest) == ""


def test_threads_share_a_registry(server: StandIn, registry: Registry) -> None:
    for path in ("/blobs/", "/uploads/"):
        server.fault("HEAD", path, DROP, 5)
        server.fault("PUT", path, 503, 5)
    with ThreadPoolExecutor(16) as pool:
        digests = list(pool.map(lambda n: registry.put_blob("a", b"%d" % n), range(200)))
    assert [server.blobs["a", digest] for digest in digests] == [b"%d" % n for n in range(200)]


# ---- Who asks --------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("bearer", [True, False])
def test_docker_login(server: StandIn, registry: Registry, tmp_path: Path, bearer: bool) -> None:
    server.users, server.bearer = {NAME: SECRET}, bearer
    docker_config(tmp_path, auths={f"http://{server.address}/v1/": auth()})
    registry.put_blob("a", b"hello")
    assert registry.mount("b", oci.digest_of(b"hello"), "a")
    if bearer:
        assert "repository:a:pull repository:b:pull,push" in server.tokens.values(), (
            "a mount reads the other repository"
        )
        assert server.count("/token") == 3, "one for reading, one for writing, one for the mount"
    else:
        assert server.count("^HEAD") == 2, "who asks is said without being asked again"
        assert server.count("^POST") == 2


def test_anybody_gets_a_token_to_read(server: StandIn, registry: Registry) -> None:
    server.bearer = True
    assert registry.manifest("a", "x") is None
    assert list(server.tokens.values()) == ["repository:a:pull"]


def test_threads_share_a_token(server: StandIn, registry: Registry) -> None:
    server.bearer = True
    with ThreadPoolExecutor(16) as pool:
        list(pool.map(lambda _: registry.head("a", "x"), range(64)))
    assert len(server.tokens) == 1


READERS = 16


def test_readers_go_on_while_another_scope_gets_its_token(server: StandIn, registry: Registry) -> None:
    """Nobody but who needs that token waits for it: all others are answered while the request for it is open."""
    server.bearer = True
    registry.head("a", "x")
    asked, enough = threading.Event(), threading.Event()
    read: list[str] = []
    answered: list[int] = []

    def answering(request: str) -> None:
        if "/token" in request:
            asked.set()
            enough.wait(10)  # which ends the test where they do not go on
            answered.append(len(read))
        elif "/a/" in request:
            read.append(request)
            if len(read) == READERS:
                enough.set()

    server.answering = answering
    with ThreadPoolExecutor(READERS + 1) as pool:
        slow = pool.submit(registry.head, "b", "x")
        assert asked.wait(10)
        list(pool.map(lambda _: registry.head("a", "x"), range(READERS)))
        slow.result()
    assert answered == [READERS]
    assert server.count("/token") == 2


def test_scopes_get_their_tokens_side_by_side(server: StandIn, registry: Registry) -> None:
    """An answer of the token server leaves when the other scope's request is there as well."""
    server.bearer = True
    registry.head("c", "x")  # from here on it is known that a token is wanted
    both = threading.Barrier(2, timeout=5)
    server.answering = lambda request: both.wait() if "/token" in request else None
    with ThreadPoolExecutor(2) as pool:
        list(pool.map(lambda repository: registry.head(repository, "x"), ("a", "b")))
    assert not both.broken


@pytest.mark.parametrize("who", ["registry", "token"])
def test_an_empty_registry_is_asked_for_one_token(
    server: StandIn, registry: Registry, tmp_path: Path, who: str
) -> None:
    """However much is looked for in a repository that does not exist yet; what is put there is found at once."""
    server.users, server.bearer, server.hides = {NAME: SECRET}, True, who
    docker_config(tmp_path, auths={server.address: auth()})
    with ThreadPoolExecutor(16) as pool:
        found = list(pool.map(lambda number: registry.head("a", f"x{number}"), range(2200)))
    assert not any(found)
    log_in = (
        who == "token"
    )  # a denial is held against one request without a scope, which says whether the account is known
    assert server.count("/token") == 1 + log_in
    digest = registry.put_manifest("a", "x1", MANIFEST)
    assert registry.head("a", "x1") == digest


def test_a_denial_is_soon_asked_about_again(
    server: StandIn, registry: Registry, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Another machine may have made the repository."""
    monkeypatch.setattr(login, "DENIED_SECONDS", 0.05)
    server.users, server.bearer, server.hides = {NAME: SECRET}, True, "token"
    docker_config(tmp_path, auths={server.address: auth()})
    assert registry.head("a", "x") == ""
    with Registry(server.address) as other:
        digest = other.put_manifest("a", "x", MANIFEST)
    time.sleep(0.1)
    assert registry.head("a", "x") == digest


def test_a_token_that_ended_is_replaced(server: StandIn, registry: Registry) -> None:
    server.bearer = True
    registry.head("a", "x")
    server.tokens.clear()
    server.tokens["another"] = ""  # the next one has another name
    registry.head("a", "x")
    registry.put_blob("a", b"hello")


def test_identity_token(server: StandIn, registry: Registry, tmp_path: Path) -> None:
    server.users, server.bearer, server.identity_token = {NAME: "x"}, True, SECRET
    docker_config(tmp_path, auths={server.address: {"identitytoken": SECRET}})
    assert registry.head("a", "x") == ""
    assert list(server.tokens.values()) == ["repository:a:pull"]


def helper(folder: Path, monkeypatch: pytest.MonkeyPatch, text: str) -> None:
    """A credential helper named `local replacement`."""
    (folder / "bin").mkdir(exist_ok=True)
    executable(folder / "bin" / "docker-credential-local replacement", text)
    monkeypatch.setenv("PATH", f"{folder / 'bin'}:/usr/bin:/bin")


ANSWERS = f'test "$1" = get || exit 1; read -r server; echo "$server" >>"$0.asked"; echo \'{{"Username": "{NAME}", "Secret": "{SECRET}"}}\''


@pytest.mark.parametrize("key", ["credHelpers", "credsStore"])
def test_credential_helper(
    server: StandIn, registry: Registry, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, key: str
) -> None:
    server.users = {NAME: SECRET}
    docker_config(
        tmp_path, **{key: {server.address: "local replacement"} if key == "credHelpers" else "local replacement"}
    )
    helper(tmp_path, monkeypatch, ANSWERS)
    registry.put_blob("a", b"hello")
    assert (tmp_path / "bin/docker-credential-local replacement.asked").read_text() == f"{server.address}\n", (
        "asked once"
    )


def test_helper_for_identity_tokens_and_for_docker_hub(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    docker_config(tmp_path, credsStore="local replacement", auths={"ghcr.io": auth()})
    helper(tmp_path, monkeypatch, ANSWERS.replace(NAME, "<token>"))
    assert from_docker(DOCKER_HUB) == Credentials(identity_token=SECRET)
    assert (tmp_path / "bin/docker-credential-local replacement.asked").read_text() == "https://index.docker.io/v1/\n"
    helper(tmp_path, monkeypatch, "echo 'credentials not found'; exit 1")
    assert from_docker("ghcr.io") == Credentials(NAME, SECRET), "what the helper lacks may be in the file"
    assert from_docker("quay.io") is None


def test_helpers_that_fail(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    docker_config(tmp_path, credHelpers={"ghcr.io": "local replacement"})
    with pytest.raises(
        RosmlError, match=r"docker-credential-local replacement, .* for ghcr.io: No such file"
    ) as caught:
        from_docker("ghcr.io")
    assert "docker login ghcr.io" in caught.value.remedy
    helper(tmp_path, monkeypatch, f"echo {SECRET}")
    with pytest.raises(RosmlError, match="does not answer as credential helpers do") as caught:
        from_docker("ghcr.io")
    assert SECRET not in caught.value.message


@pytest.mark.parametrize("name", ["local replacement", "a\0b"])
def test_a_helper_that_says_no_text(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str) -> None:
    """What cannot be decoded would be shown with what stands before it."""
    docker_config(tmp_path, credHelpers={"ghcr.io": name})
    helper(tmp_path, monkeypatch, f"printf '{SECRET}\\377'")
    with pytest.raises(RosmlError) as caught:
        from_docker("ghcr.io")
    assert SECRET not in caught.value.message


def test_a_user_without_a_home(monkeypatch: pytest.MonkeyPatch) -> None:
    def home() -> Path:
        raise RuntimeError("Could not determine home directory.")

    monkeypatch.delenv("DOCKER_CONFIG", raising=False)
    monkeypatch.setattr(Path, "home", home)
    assert from_docker("ghcr.io") is None


def test_the_environment_counts_more_than_the_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    docker_config(tmp_path, auths={"ghcr.io": auth("other"), "quay.io": auth()}, credHelpers={"ghcr.io": "nowhere"})
    monkeypatch.setenv("DOCKER_AUTH_CONFIG", json.dumps({"auths": {"ghcr.io": auth()}}))
    assert from_docker("ghcr.io") == Credentials(NAME, SECRET)
    assert from_docker("quay.io") == Credentials(NAME, SECRET), "what the variable lacks may be in the file"
    monkeypatch.setenv("DOCKER_AUTH_CONFIG", json.dumps({"auths": {"https://index.docker.io/v1/": auth()}}))
    assert from_docker(DOCKER_HUB) == Credentials(NAME, SECRET)


@pytest.mark.parametrize("content", [{"auths": 5}, {"auths": [1]}, {"auths": {"ghcr.io": 5}}, {"credHelpers": 5}])
def test_what_is_no_object_is_not_taken_as_nothing(tmp_path: Path, content: dict[str, Any]) -> None:
    docker_config(tmp_path, **content)
    with pytest.raises(RosmlError, match=r"config\.json: .* is no JSON object"):
        from_docker("ghcr.io")


@pytest.mark.parametrize("text", [SECRET, f'["{SECRET}"]', f'{{"auths": {{"ghcr.io": {{"auth": "{SECRET}%"}}}}}}'])
def test_a_damaged_variable_is_not_shown(monkeypatch: pytest.MonkeyPatch, text: str) -> None:
    monkeypatch.setenv("DOCKER_AUTH_CONFIG", text)
    with pytest.raises(RosmlError, match="DOCKER_AUTH_CONFIG") as caught:
        from_docker("ghcr.io")
    assert SECRET not in caught.value.message + caught.value.remedy


@pytest.mark.parametrize(
    "text", ["{", "[]", '{"auths": {"ghcr.io": {"auth": "%%%"}}}', '{"auths": {"ghcr.io": {"auth": "YWJj"}}}']
)
def test_damaged_config(tmp_path: Path, text: str) -> None:
    docker_config(tmp_path)
    (tmp_path / "docker" / "config.json").write_text(text)
    with pytest.raises(RosmlError, match=r"config\.json") as caught:
        from_docker("ghcr.io")
    assert "docker login" in caught.value.remedy or "log in" in caught.value.remedy


@pytest.mark.parametrize("bearer", [True, False])
@pytest.mark.parametrize("known", [True, False])
def test_denied(server: StandIn, registry: Registry, tmp_path: Path, bearer: bool, known: bool) -> None:
    server.users, server.bearer = {NAME: "another"}, bearer
    if known:
        docker_config(tmp_path, auths={server.address: auth()})
    with pytest.raises(RosmlError) as caught:
        registry.put_blob("a", b"hello")
    assert f"docker login {server.address}" in caught.value.remedy
    assert ("with the account" if known else "without an account") in caught.value.message


def test_forbidden(server: StandIn, registry: Registry) -> None:
    server.fault("POST", "/uploads/", 403)
    with pytest.raises(RosmlError, match=r"push to a without an account .*403"):
        registry.put_blob("a", b"hello")


@pytest.mark.parametrize("who", ["registry", "token"])
def test_a_repository_that_does_not_exist_yet_may_be_denied(
    server: StandIn, registry: Registry, tmp_path: Path, caplog: pytest.LogCaptureFixture, who: str
) -> None:
    """As ghcr.io may do: what is to be read there is not there. Without an account, nobody knows what the reason is."""
    server.users, server.bearer, server.hides = {NAME: SECRET}, True, who
    docker_config(tmp_path, auths={server.address: auth()})
    with (
        Registry(server.address, credentials=lambda _: None) as nobody,
        pytest.raises(RosmlError, match="access denied"),
    ):
        nobody.manifest("a", "x")
    assert registry.manifest("a", "x") is None
    assert (registry.head("a", "x"), registry.tags("a"), registry.referrers("a", DIGEST)) == ("", [], [])
    assert server.count(r"^(GET|HEAD) /v2/a/manifests/x") <= 4, "nothing is tried again"
    assert [record.message for record in caplog.records if "does not exist yet" in record.message], "nobody was warned"
    assert len(caplog.records) == 1
    registry.put_blob("a", b"hello")
    digest = registry.put_manifest("a", "x", MANIFEST)
    assert registry.head("a", "x") == digest and registry.tags("a") == ["x"]


def test_what_is_denied_in_a_repository_that_exists_is_not_missing(
    server: StandIn, registry: Registry, tmp_path: Path
) -> None:
    """Or its tag would move whatever it points at."""
    server.users = {NAME: SECRET}
    docker_config(tmp_path, auths={server.address: auth()})
    digest = registry.put_manifest("a", "x", MANIFEST)
    with Registry(server.address) as other:
        assert other.head("a", digest) == digest
        server.fault("HEAD", "/manifests/x", 403, 1000)
        server.fault("GET", "/tags/list", 403, 1)
        for client in (registry, other):
            with pytest.raises(RosmlError, match=r"cannot pull from a with the account .*403"):
                client.head("a", "x")
            assert client.tags("a") == ["x"], "what is denied for a moment is tried again"


@pytest.mark.parametrize("code", [401, 403])
def test_a_login_that_is_refused_is_not_a_missing_repository(
    server: StandIn, registry: Registry, tmp_path: Path, code: int
) -> None:
    server.users, server.bearer = {NAME: SECRET}, True
    docker_config(tmp_path, auths={server.address: auth()})
    server.fault("GET", "/token", code, 1000)
    with pytest.raises(RosmlError, match=rf"cannot log in with the account .*{code}") as caught:
        registry.manifest("a", "x")
    assert f"docker login {server.address}" in caught.value.remedy
    assert server.count("/token") <= 2, "it is told at once"


def test_no_password_goes_elsewhere(server: StandIn, registry: Registry, tmp_path: Path) -> None:
    """Uploads and blobs may be on another host, as storage is: it is not told who asks."""
    server.users = {NAME: SECRET}
    docker_config(tmp_path, auths={server.address: auth()})
    digest = registry.put_blob("a", b"hello")
    with standing_in() as storage:
        storage.blobs["a", digest] = b"hello"
        there = f"http://{storage.address}/v2/a/blobs/"
        server.fault("GET", "/blobs/", 307, headers={"Location": there + digest})
        assert registry.blob("a", digest) == b"hello"
        server.fault("POST", "/uploads/", 202, headers={"Location": there + "uploads/1?_state=s%3D"})
        assert oci.digest_of(b"more") == registry.put_blob("a", b"more")
        assert len(storage.headers) == 2
        assert not any("authorization" in headers for headers in storage.headers)


def test_no_password_in_the_clear(tmp_path: Path) -> None:
    authority = trustme.CA()
    authority.cert_pem.write_to_path(str(tmp_path / "ca.pem"))
    context = ssl.create_default_context(ssl.Purpose.CLIENT_AUTH)
    authority.issue_cert("127.0.0.1").configure_cert(context)
    with standing_in(context) as server:
        server.users, server.bearer, server.realm = {NAME: SECRET}, True, "http://registry.example.org/token"
        found = Registry(
            server.address,
            plain=False,
            ca_bundle=str(tmp_path / "ca.pem"),
            credentials=lambda _: Credentials(NAME, SECRET),
        )
        with found, pytest.raises(RosmlError, match="in the clear"):
            found.head("a", "x")
    assert server.requests == ["HEAD /v2/a/manifests/x"]


@pytest.mark.parametrize("bearer", [True, False])
def test_nothing_secret_is_said(
    server: StandIn, registry: Registry, tmp_path: Path, caplog: pytest.LogCaptureFixture, bearer: bool
) -> None:
    caplog.set_level(logging.DEBUG)
    logging.getLogger("httpcore").setLevel(logging.INFO)  # which nobody switches on by accident
    server.users, server.bearer = {NAME: SECRET}, bearer
    docker_config(tmp_path, auths={server.address: auth()})
    registry.put_blob("a", b"hello")
    known = from_docker(server.address)
    texts = [repr(registry), repr(known), repr(vars(known)), caplog.text]
    for fault in (DROP, 500, 403, 404):
        server.fault("PUT", "/uploads/", fault, 1000)
        with pytest.raises(RosmlError) as caught:
            registry.put_blob("a", b"%r" % fault)
        texts += [caught.value.message, caught.value.remedy, repr(caught.value), caplog.text]
        server.faults.clear()
    del texts[2]  # vars() has them: it shows that the rest was looked at for the right words
    for text in texts:
        for word in (SECRET, auth()["auth"], "token-", "_state"):
            assert word not in text


def test_whether_one_may_push_is_asked_and_leaves_nothing(server: StandIn, registry: Registry) -> None:
    registry.may_push("a")
    assert (server.uploads, server.aborted, server.blobs) == (1, 1, {})
    server.users = {NAME: SECRET}
    with pytest.raises(RosmlError, match="without an account"):
        registry.may_push("a")
