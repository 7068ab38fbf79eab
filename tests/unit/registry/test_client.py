"""The registry client against a registry in this process: what it does, and what it sends again if that goes wrong.

Calls that any registry answers alike are in tests/registry_calls.py; hostile answers in test_hostile_registry.py.
"""

from __future__ import annotations

import json
import threading
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import pytest

from fakes.http_registry import DROP, LocalRegistry, local_registry
from rosml.base.errors import RosmlError
from rosml.registry import oci, retries
from rosml.registry.client import Registry
from rosml.registry.references import parse

DIGEST = "sha256:" + "1" * 64
MANIFEST = {"schemaVersion": 2, "mediaType": oci.IMAGE, "layers": []}
TYPE = "application/vnd.example.v1"
PAGE = b"<html>Sign in to GitHub</html>"


@pytest.fixture(autouse=True)
def quick(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(retries, "WAIT", 0.001)
    monkeypatch.setattr(retries, "LONGEST_WAIT", 0.01)


@pytest.fixture
def registry(server: LocalRegistry) -> Iterator[Registry]:
    with Registry(server.address) as client:
        yield client


def put_subject(registry: Registry) -> dict[str, Any]:
    registry.put_manifest("a", "x", MANIFEST)
    return oci.descriptor(oci.IMAGE, oci.encoded(MANIFEST))


def attached(registry: Registry, subject: dict[str, Any]) -> list[str]:
    return [entry["digest"] for entry in registry.referrers("a", subject["digest"])]


# ---- References ------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("text", "parts"),
    [
        ("ghcr.io/me/ros:jazzy-base", ("ghcr.io", "me/ros", "jazzy-base")),
        ("localhost/ros", ("localhost", "ros", "latest")),
        ("127.0.0.1:5000/a/b/c_d:T.1", ("127.0.0.1:5000", "a/b/c_d", "T.1")),
        (f"[::1]:5000/ros:x@{DIGEST}", ("[::1]:5000", "ros", DIGEST)),
    ],
)
def test_references(text: str, parts: tuple[str, str, str]) -> None:
    assert parse(text) == parts == parse(str(parse(text)))


@pytest.mark.parametrize(
    "text", ["", "ros", "me/ros:x", "ghcr.io/", "ghcr.io/ME/ros", "ghcr.io/ros:", "ghcr.io/ros@sha256:12", "a.b/c:d:e", "a.b/c/../d"]
)  # fmt: skip
def test_texts_that_are_no_reference(text: str) -> None:
    with pytest.raises(RosmlError) as caught:
        parse(text)
    assert caught.value.exit_code == 2


@pytest.mark.parametrize(("host", "scheme"), [("127.0.0.1:1", "http"), ("localhost", "http"), ("[::1]:1", "http"),
                                              ("ghcr.io", "https"), ("127.example.org:5000", "https")])  # fmt: skip
def test_plain_http_is_for_this_machine(host: str, scheme: str) -> None:
    assert Registry(host).transport.base.scheme == scheme
    assert Registry(host, plain=scheme == "https").transport.base.scheme != scheme


# ---- Manifests and blobs ---------------------------------------------------------------------------------------------


def test_same_content_same_digest(registry: Registry) -> None:
    turned = dict(reversed(MANIFEST.items()))
    assert registry.put_manifest("a", "x", MANIFEST) == registry.put_manifest("a", "y", turned)


def test_tags_come_in_pages(server: LocalRegistry, registry: Registry) -> None:
    server.page = 7
    server.tags["a"] = {f"t{number:03}": "d" for number in range(50)}
    assert registry.tags("a") == sorted(server.tags["a"])
    assert server.count("tags/list") == 8


def test_a_blob_is_sent_once_and_mounted(server: LocalRegistry, registry: Registry) -> None:
    for _ in range(2):
        digest = registry.put_blob("a", b"hello")
    assert (registry.has_blob("a", digest), registry.has_blob("b", digest)) == (True, False)
    assert registry.mount("b", digest, "a") and registry.has_blob("b", digest)
    server.mounts = False
    assert not registry.mount("c", digest, "a")
    assert server.aborted == 1, "the upload that was begun instead is ended"
    assert (server.count("^PUT"), registry.uploaded, registry.sent_by_this_thread) == (1, 5, 5)


def test_copy_from_another_registry(server: LocalRegistry, registry: Registry) -> None:
    data = bytes(range(256)) * 20_000
    with local_registry() as other, Registry(other.address) as source:
        digest = source.put_blob("far/away", data)
        other.fault("GET", "/blobs/", 503)
        other.fault("GET", "/blobs/", DROP)
        registry.copy_blob("here", digest, len(data), source, "far/away")
        assert registry.blob("here", digest) == data
        other.blobs["far/away", digest] = data[::-1]
        with pytest.raises(RosmlError, match="has another digest"):
            registry.copy_blob("damaged", digest, len(data), source, "far/away")
    assert [repository for repository, _ in server.blobs] == ["here"]


def test_content_that_has_another_digest(server: LocalRegistry, registry: Registry) -> None:
    blob, digest = registry.put_blob("a", b"hello"), registry.put_manifest("a", "x", MANIFEST)
    server.blobs["a", blob] = b"jello"
    server.manifests["a", digest] = (oci.IMAGE, b"{}")
    for call in (lambda: registry.blob("a", blob), lambda: registry.manifest("a", digest), lambda: registry.tag("a", digest, "y")):  # fmt: skip
        with pytest.raises(RosmlError, match="has another digest"):
            call()
    assert "y" not in server.tags["a"]


def test_a_registry_that_deletes_nothing(server: LocalRegistry, registry: Registry) -> None:
    server.deletes = False
    for reference, text in ((DIGEST, "deletes nothing"), ("x", "deletes no tag")):
        with pytest.raises(RosmlError, match=text):
            registry.delete("a", reference)


@pytest.mark.parametrize("kind", [400, 403, 404, 405, 503])
def test_a_registry_that_discards_nothing_is_asked_once(server: LocalRegistry, registry: Registry, kind: int) -> None:
    """404 as well, where the manifest is still in the registry; and once only, if it has no time."""
    server.fault("DELETE", "/manifests/", kind, retries.ATTEMPTS)
    digest = registry.put_manifest("a", "x", MANIFEST)
    for _ in range(2):
        registry.discard("a", digest)
        assert server.count("^DELETE") == 1 and registry.head("a", digest) == digest
    server.faults.clear()
    other = registry.put_manifest("b", "x", MANIFEST)
    registry.discard("b", DIGEST)  # somebody else removed it, so the registry can delete
    registry.discard("b", other)
    assert registry.head("b", other) == "", "another repository may have other rules"


@pytest.mark.parametrize("method", ["GET", "HEAD"])
def test_a_manifest_that_is_redirected_elsewhere_is_not_missing(
    server: LocalRegistry, registry: Registry, method: str
) -> None:
    """The other host has no manifests, and its 404 would let a tag move without a look at where it was."""
    digest = registry.put_manifest("a", "x", MANIFEST)

    def ask() -> str:
        manifest = registry.manifest("a", "x") if method == "GET" else None
        return manifest.digest if manifest else registry.head("a", "x")

    with local_registry() as elsewhere:
        headers = {"Location": f"http://{elsewhere.address}/v2/a/manifests/x?signed=s3cret"}
        server.fault(method, "/manifests/", 307, 2, headers=headers)
        assert ask() == digest, "it passes"
        server.fault(method, "/manifests/", 307, retries.ATTEMPTS, headers=headers)
        with pytest.raises(RosmlError, match=r"a redirect to 127\.0\.0\.1") as caught:
            ask()
        assert "s3cret" not in caught.value.message and "run it again" in caught.value.remedy
        assert elsewhere.requests == []
    server.fault(method, "/manifests/x$", 307, headers={"Location": f"/v2/a/manifests/{digest}"})
    assert ask() == digest, "within the registry it is followed"


# ---- Referrers -------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("api", [True, False])
def test_without_the_api_referrers_have_the_fallback_tag(server: LocalRegistry, registry: Registry, api: bool) -> None:
    server.referrers = api
    subject = put_subject(registry)
    layer = oci.descriptor("text/plain", b"two")
    registry.put_blob("a", b"two")
    artifact = oci.artifact(TYPE, b"one", "text/plain", subject=subject)
    digest = registry.attach_with_layers("a", b"one", artifact, [layer])
    manifest = registry.manifest("a", digest)
    assert manifest and [item.digest for item in manifest.layers] == [oci.digest_of(b"one"), layer["digest"]]
    assert attached(registry, subject) == [digest]
    assert server.tags["a"].keys() == ({"x"} if api else {"x", subject["digest"].replace(":", "-")})


@pytest.mark.parametrize(
    ("code", "times", "body"),
    [(303, 1, b""), (404, 1, PAGE), (429, retries.ATTEMPTS, b""), (200, 1, PAGE), (200, 1, b"[]"), (400, 1, b"")],
)
def test_an_answer_that_is_no_index_means_that_there_is_no_api(
    server: LocalRegistry, registry: Registry, code: int, times: int, body: bytes
) -> None:
    """ghcr.io redirects to a page for people; nobody asks that page, and the registry is not asked again."""
    with local_registry() as pages:
        headers = {"Location": f"http://{pages.address}/me/a"} if code == 303 else {}
        server.fault("GET", "/referrers/", code, 1000, body=body, headers=headers)
        subject = put_subject(registry)
        assert attached(registry, subject) == []
        digest = registry.attach("a", subject, TYPE, b"one", "text/plain")
        assert attached(registry, subject) == [digest]
        assert server.count("/referrers/") == times
        assert pages.requests == []


def test_a_registry_that_has_the_api_does_not_lose_it_for_a_moment(server: LocalRegistry, registry: Registry) -> None:
    server.referrers = True
    subject = put_subject(registry)
    digest = registry.attach("a", subject, TYPE, b"one", "text/plain")
    server.fault("GET", "/referrers/", 429, 2)
    assert attached(registry, subject) == [digest]
    server.fault("GET", "/referrers/", 200, body=PAGE)
    with pytest.raises(RosmlError, match="is no JSON object"):
        attached(registry, subject)


def test_many_attach_at_once(registry: Registry) -> None:
    subject = put_subject(registry)
    with ThreadPoolExecutor(8) as pool:
        digests = set(pool.map(lambda n: registry.attach("a", subject, TYPE, b"%d" % n, "text/plain"), range(24)))
    assert set(attached(registry, subject)) == digests and len(digests) == 24


def test_lists_of_two_manifests_are_written_side_by_side(server: LocalRegistry, registry: Registry) -> None:
    both = threading.Barrier(2, timeout=20)
    server.answering = lambda request: both.wait() if request.startswith("PUT /v2/a/manifests/sha256-") else None
    contents = [{**MANIFEST, "annotations": {"number": number}} for number in ("1", "2")]
    for content in contents:
        registry.put_manifest("a", "", content)
    subjects = [oci.descriptor(oci.IMAGE, oci.encoded(content)) for content in contents]
    with ThreadPoolExecutor(2) as pool:
        digests = list(pool.map(lambda subject: registry.attach("a", subject, TYPE, b"one", "text/plain"), subjects))
    assert len(set(digests)) == 2


def test_two_publishers_attach(server: LocalRegistry, registry: Registry) -> None:
    """What another publisher adds to the list between a look at it and its change stays."""
    subject = put_subject(registry)
    first = registry.attach("a", subject, TYPE, b"one", "text/plain")
    theirs: list[str] = []

    def meanwhile(request: str) -> None:
        if request == f"GET /v2/a/manifests/{subject['digest'].replace(':', '-')}" and not theirs:
            theirs.append("begun")
            theirs.append(other.attach("a", subject, TYPE, b"theirs", "text/plain"))

    with Registry(server.address) as other:
        server.answering = meanwhile
        ours = [first, registry.attach("a", subject, TYPE, b"two", "text/plain")]
    assert set(attached(registry, subject)) == {*ours, theirs[1]}


# ---- Attempts --------------------------------------------------------------------------------------------------------

FAULTS: list[int | str] = [429, 500, 502, 503, 504, DROP]


@pytest.mark.parametrize("kind", FAULTS)
def test_a_failure_of_a_moment_is_tried_again(server: LocalRegistry, registry: Registry, kind: int | str) -> None:
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
def test_a_failure_that_stays_is_an_error(server: LocalRegistry, registry: Registry, kind: int | str) -> None:
    registry.tags("a")
    server.fault("GET", "/manifests/", kind, 1000)
    with pytest.raises(RosmlError, match=rf"{server.address}.*/v2/a/manifests/x") as caught:
        registry.manifest("a", "x")
    assert "run it again" in caught.value.remedy
    assert server.count("manifests") == retries.ATTEMPTS


def test_a_host_without_a_registry_fails_soon(server: LocalRegistry, registry: Registry) -> None:
    with pytest.raises(RosmlError, match=r"127\.0\.0\.1:1: GET .*refused") as caught:
        Registry("127.0.0.1:1").manifest("a", "x")
    assert "check its name" in caught.value.remedy
    server.fault("GET", "/manifests/", DROP, retries.ATTEMPTS - 1)
    assert registry.manifest("a", "x") is None, "a connection that drops is no wrong name"


def test_retry_after(server: LocalRegistry, registry: Registry, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(retries, "LONGEST_WAIT", 1.2)
    for header, seconds in (("1", 1.0), ("86400", 1.2), ("Sat, 01 Jan 2050 00:00:00 GMT", 1.2), ("soon", 0.0)):
        server.fault("GET", "/tags/", 503, headers={"Retry-After": header})
        pauses: list[float] = []
        with monkeypatch.context() as patched:
            patched.setattr(time, "sleep", pauses.append)
            registry.tags("a")
        assert len(pauses) == 1 and seconds <= pauses[0] <= 1.2


@pytest.mark.parametrize(
    ("header", "reached", "requests", "remedy"),
    [
        ("", False, retries.ATTEMPTS_LIMITED, "wait some minutes"),
        ("3600", False, 1, "wait 60 min 0 s, as it asks"),
        ("3600", True, 1, "wait 60 min 0 s, as it asks"),
        ("", True, retries.ATTEMPTS, "wait some minutes"),
    ],
)
def test_too_many_requests(
    server: LocalRegistry, registry: Registry, header: str, reached: bool, requests: int, remedy: str
) -> None:
    """The client waits for the end of a short limit, but not of one that lasts, or applied from the first request."""
    if reached:
        registry.tags("a")
    server.fault("GET", "/manifests/", 429, 1000, headers={"Retry-After": header} if header else {})
    with pytest.raises(RosmlError) as caught:
        registry.manifest("a", "x")
    assert caught.value.remedy.startswith(remedy) and f"docker login {server.address}" in caught.value.remedy
    assert server.count("manifests") == requests


def test_a_limit_after_another_failure_passes(server: LocalRegistry, registry: Registry) -> None:
    server.fault("GET", "/manifests/", DROP)
    server.fault("GET", "/manifests/", 429)
    assert registry.manifest("a", "x") is None


@pytest.mark.parametrize("code", [400, 409, 412])
def test_a_tag_that_may_not_move(server: LocalRegistry, registry: Registry, code: int) -> None:
    """The same content is no failure; other content is refused at once."""
    registry.put_manifest("a", "x", MANIFEST)
    body = b'{"errors": [{"code": "TAG_INVALID", "message": "The tag x is immutable and cannot be overwritten"}]}'
    server.fault("PUT", "/manifests/x", code, 1000, body=body)
    registry.put_manifest("a", "x", MANIFEST)
    before = server.count("manifests/x")
    with pytest.raises(RosmlError, match="the registry lets no tag move") as caught:
        registry.put_manifest("a", "x", {**MANIFEST, "annotations": {"b": "c"}})
    assert caught.value.remedy == "choose another tag"
    assert server.count("manifests/x") == before + 2, "no attempt is repeated"


UNKNOWN = [(400, "MANIFEST_BLOB_UNKNOWN"), (404, "BLOB_UNKNOWN"), (400, "MANIFEST_UNKNOWN")]


@pytest.mark.parametrize(("code", "name"), UNKNOWN)
def test_a_blob_that_a_part_of_the_registry_lacks_for_a_moment(
    server: LocalRegistry, registry: Registry, code: int, name: str
) -> None:
    body = f'{{"errors": [{{"code": "{name}", "message": "blob unknown to registry"}}]}}'.encode()
    server.fault("PUT", "/manifests/", code, 3, body=body)
    assert registry.put_manifest("a", "x", MANIFEST) == registry.head("a", "x")
    server.fault("PUT", "/manifests/", code, 1000, body=body)
    before = server.count("^PUT")
    with pytest.raises(RosmlError, match=rf"PUT /v2/a/manifests/x: {code} \(blob unknown to registry\)"):
        registry.put_manifest("a", "x", MANIFEST)
    assert server.count("^PUT") - before == retries.ATTEMPTS_REFUSED, "it may really be missing"


def test_threads_share_a_registry(server: LocalRegistry, registry: Registry) -> None:
    for path in ("/blobs/", "/uploads/"):
        server.fault("HEAD", path, DROP, 5)
        server.fault("PUT", path, 503, 5)
    with ThreadPoolExecutor(16) as pool:
        digests = list(pool.map(lambda n: registry.put_blob("a", b"%d" % n), range(200)))
    assert [server.blobs["a", digest] for digest in digests] == [b"%d" % n for n in range(200)]


# ---- Answers of another form -----------------------------------------------------------------------------------------

NO_SIZE = {"mediaType": oci.IMAGE, "digest": DIGEST}
INDEX = {"schemaVersion": 2, "mediaType": oci.INDEX}


@pytest.mark.parametrize("body", [b"[]", b"<html>", b"null"])
def test_an_answer_that_is_no_object(server: LocalRegistry, registry: Registry, body: bytes) -> None:
    server.fault("GET", "/manifests/", 200, body=body)
    with pytest.raises(RosmlError, match="is no JSON object") as caught:
        registry.manifest("a", "x")
    assert "HTTPS_PROXY" in caught.value.remedy


@pytest.mark.parametrize(
    "answer",
    [
        INDEX,
        {**INDEX, "manifests": [{**NO_SIZE, "size": 1, "digest": "x"}]},
        {**INDEX, "manifests": [{**NO_SIZE, "size": 1, "platform": "linux"}]},
        {**MANIFEST, "layers": [NO_SIZE]},
        {**MANIFEST, "config": "x"},
    ],
)
def test_a_manifest_of_another_form(server: LocalRegistry, registry: Registry, answer: dict[str, Any]) -> None:
    server.fault("GET", "/manifests/", 200, body=json.dumps(answer).encode())
    with pytest.raises(RosmlError, match=f"{server.address} does not answer as a registry") as caught:
        registry.manifest("a", "x")
    assert "HTTPS_PROXY" in caught.value.remedy and "pydantic" not in caught.value.message


@pytest.mark.parametrize(
    ("path", "answer"),
    [
        ("/tags/list", {"tags": ["a", 1, None, {}]}),
        ("/referrers/", {"manifests": [{"mediaType": oci.IMAGE, "size": 1}]}),
    ],
)
def test_lists_of_another_form(server: LocalRegistry, registry: Registry, path: str, answer: dict[str, Any]) -> None:
    server.referrers = True
    subject = put_subject(registry)
    assert attached(registry, subject) == []
    server.fault("GET", "/tags/list", 200, body=b'{"name": "a", "tags": null}')
    assert registry.tags("a") == []
    server.fault("GET", path, 200, body=json.dumps(answer).encode())
    with pytest.raises(RosmlError, match="does not answer as a registry"):
        registry.tags("a") if "tags" in path else attached(registry, subject)
