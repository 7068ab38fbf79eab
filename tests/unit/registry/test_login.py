"""Who asks a registry, and where passwords go: credentials as Docker keeps them, tokens, and accounts without access."""

from __future__ import annotations

import base64
import json
import logging
import ssl
import threading
import time
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import nullcontext
from pathlib import Path
from typing import Any

import pytest
import trustme

from fakes.hostile import Hostile, hostile, reply
from fakes.http_registry import DROP, LocalRegistry, local_registry
from fakes.stubs import executable
from rosml.base.errors import RosmlError
from rosml.registry import login, oci, retries
from rosml.registry.client import Registry
from rosml.registry.credentials import DOCKER_HUB, Credentials, from_docker

NAME, SECRET = "somebody", "s3cret-Pass"
DIGEST = "sha256:" + "1" * 64
MANIFEST = {"schemaVersion": 2, "mediaType": oci.IMAGE, "layers": []}


@pytest.fixture(autouse=True)
def folder(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Path:
    """Docker's configuration, with a folder of programs in it."""
    monkeypatch.setattr(retries, "WAIT", 0.001)
    monkeypatch.setattr(retries, "LONGEST_WAIT", 0.01)
    monkeypatch.setenv("DOCKER_CONFIG", str(tmp_path))
    monkeypatch.setenv("PATH", f"{tmp_path / 'bin'}:/usr/bin:/bin")
    monkeypatch.delenv("DOCKER_AUTH_CONFIG", raising=False)
    (tmp_path / "bin").mkdir()
    return tmp_path


@pytest.fixture
def registry(server: LocalRegistry) -> Iterator[Registry]:
    with Registry(server.address) as client:
        yield client


@pytest.fixture
def account(server: LocalRegistry, folder: Path) -> None:
    """The registry has one user, who is logged in; it asks for tokens."""
    server.users, server.bearer = {NAME: SECRET}, True
    configure(folder, auths={server.address: auth()})


def configure(folder: Path, **content: Any) -> None:
    (folder / "config.json").write_text(json.dumps(content))


def auth(name: str = NAME) -> dict[str, str]:
    return {"auth": base64.b64encode(f"{name}:{SECRET}".encode()).decode()}


# ---- Docker's configuration ------------------------------------------------------------------------------------------

HELPER = "bin/docker-credential-keychain"
ANSWERING = f'test "$1" = get || exit 1; read -r server; echo "$server" >>"$0.servers"; echo \'{{"Username": "{NAME}", "Secret": "{SECRET}"}}\''


@pytest.mark.parametrize("key", ["credHelpers", "credsStore"])
def test_credential_helper(server: LocalRegistry, registry: Registry, folder: Path, key: str) -> None:
    server.users = {NAME: SECRET}
    configure(folder, **{key: {server.address: "keychain"} if key == "credHelpers" else "keychain"})
    executable(folder / HELPER, ANSWERING)
    registry.put_blob("a", b"hello")
    assert (folder / f"{HELPER}.servers").read_text() == f"{server.address}\n", "asked once"


def test_helper_for_identity_tokens_and_for_docker_hub(folder: Path) -> None:
    configure(folder, credsStore="keychain", auths={"ghcr.io": auth()})
    executable(folder / HELPER, ANSWERING.replace(NAME, "<token>"))
    assert from_docker(DOCKER_HUB) == Credentials(identity_token=SECRET)
    assert (folder / f"{HELPER}.servers").read_text() == "https://index.docker.io/v1/\n"
    executable(folder / HELPER, "echo 'credentials not found'; exit 1")
    assert from_docker("ghcr.io") == Credentials(NAME, SECRET), "the file may have what the helper lacks"
    assert from_docker("quay.io") is None


@pytest.mark.parametrize(
    "script",
    ["", f"echo {SECRET}", f"printf '{SECRET}\\377'", f"echo '{'[' * 10_000}{SECRET}'",
     f'echo \'{{"Username": "{SECRET}", "Secret": 5}}\''],
    ids=["none", "text", "no UTF-8", "deep", "number"],
)  # fmt: skip
def test_helpers_that_fail(folder: Path, script: str) -> None:
    configure(folder, credHelpers={"ghcr.io": "keychain"})
    if script:
        executable(folder / HELPER, script)
    with pytest.raises(RosmlError, match="docker-credential-keychain") as caught:
        from_docker("ghcr.io")
    assert "docker login ghcr.io" in caught.value.remedy and SECRET not in caught.value.message


@pytest.mark.parametrize("name", ["../../tmp/x", 5, {"a": "b"}, "a\0b"])
def test_a_helper_that_is_no_program(folder: Path, name: Any) -> None:
    configure(folder, credsStore=name)
    with pytest.raises(RosmlError, match=r"config\.json|docker-credential-a"):
        from_docker("ghcr.io")


def test_a_user_without_a_home(monkeypatch: pytest.MonkeyPatch) -> None:
    def home() -> Path:
        raise RuntimeError("Could not determine home directory.")

    monkeypatch.delenv("DOCKER_CONFIG")
    monkeypatch.setattr(Path, "home", home)
    assert from_docker("ghcr.io") is None


def test_the_environment_counts_more_than_the_file(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    configure(folder, auths={"ghcr.io": auth("other"), "quay.io": auth()}, credHelpers={"ghcr.io": "nowhere"})
    monkeypatch.setenv("DOCKER_AUTH_CONFIG", json.dumps({"auths": {"ghcr.io": auth()}}))
    assert from_docker("ghcr.io") == Credentials(NAME, SECRET)
    assert from_docker("quay.io") == Credentials(NAME, SECRET), "the file may have what the variable lacks"
    monkeypatch.setenv("DOCKER_AUTH_CONFIG", json.dumps({"auths": {"https://index.docker.io/v1/": auth()}}))
    assert from_docker(DOCKER_HUB) == Credentials(NAME, SECRET)


ENTRIES: list[Any] = [5, {"auth": "ä"}, {"auth": 5}, {"auth": "%%%"}, {"auth": "//4="}, {"auth": "YWJj"}, {"auth": "\ud800"},
                      {"username": "x", "password": []}, {"identitytoken": {}}]  # fmt: skip


@pytest.mark.parametrize(
    "text",
    ["{", "[]", '{"auths": 5}', '{"credHelpers": 5}', *(json.dumps({"auths": {"ghcr.io": entry}}) for entry in ENTRIES)],
)  # fmt: skip
def test_a_damaged_config_is_not_taken_for_an_empty_one(folder: Path, text: str) -> None:
    (folder / "config.json").write_text(text)
    with pytest.raises(RosmlError, match=r"config\.json") as caught:
        from_docker("ghcr.io")
    assert "docker login" in caught.value.remedy


@pytest.mark.parametrize("text", [SECRET, f'["{SECRET}"]', f'{{"auths": {{"ghcr.io": {{"auth": "{SECRET}%"}}}}}}'])
def test_a_damaged_variable_is_not_shown(monkeypatch: pytest.MonkeyPatch, text: str) -> None:
    monkeypatch.setenv("DOCKER_AUTH_CONFIG", text)
    with pytest.raises(RosmlError, match="DOCKER_AUTH_CONFIG") as caught:
        from_docker("ghcr.io")
    assert SECRET not in caught.value.message + caught.value.remedy


# ---- Passwords and tokens --------------------------------------------------------------------------------------------


@pytest.mark.parametrize("bearer", [True, False])
def test_docker_login(server: LocalRegistry, registry: Registry, folder: Path, bearer: bool) -> None:
    server.users, server.bearer = {NAME: SECRET}, bearer
    configure(folder, auths={f"http://{server.address}/v1/": auth()})
    registry.put_blob("a", b"hello")
    assert registry.mount("b", oci.digest_of(b"hello"), "a")
    if bearer:
        assert "repository:a:pull repository:b:pull,push" in server.tokens.values(), (
            "a mount reads the other repository"
        )
        assert server.count("/token") == 3, "one for reading, one for writing, one for the mount"
    else:
        assert (server.count("^HEAD"), server.count("^POST")) == (2, 2), "only the first request is sent twice"


@pytest.mark.parametrize("bearer", [True, False])
@pytest.mark.parametrize("password", ["pässword", "пароль", "密码 \t"])
def test_any_password_is_sent(server: LocalRegistry, bearer: bool, password: str) -> None:
    server.users, server.bearer = {"jürgen": password}, bearer
    with Registry(server.address, credentials=lambda _: Credentials("jürgen", password)) as client:
        assert client.put_manifest("a", "x", MANIFEST)


def test_identity_token(server: LocalRegistry, registry: Registry, folder: Path) -> None:
    server.users, server.bearer, server.identity_token = {NAME: "x"}, True, SECRET
    configure(folder, auths={server.address: {"identitytoken": SECRET}})
    assert registry.head("a", "x") == ""
    assert list(server.tokens.values()) == ["repository:a:pull"]


def test_threads_share_a_token(server: LocalRegistry, registry: Registry) -> None:
    server.bearer = True
    with ThreadPoolExecutor(16) as pool:
        list(pool.map(lambda _: registry.head("a", "x"), range(64)))
    assert list(server.tokens.values()) == ["repository:a:pull"]


def test_a_token_that_ended_is_replaced(server: LocalRegistry, registry: Registry) -> None:
    server.bearer = True
    registry.head("a", "x")
    server.tokens.clear()
    server.tokens["another"] = ""  # the next one has another name
    registry.head("a", "x")
    registry.put_blob("a", b"hello")


def test_readers_go_on_while_another_scope_gets_its_token(server: LocalRegistry, registry: Registry) -> None:
    server.bearer = True
    registry.head("a", "x")
    with ThreadPoolExecutor(1) as pool:

        def answering(request: str) -> None:
            if "/token" in request:
                pool.submit(registry.head, "a", "x").result(5)

        server.answering = answering
        registry.head("b", "x")
    assert server.count("/token") == 2


def test_scopes_get_their_tokens_side_by_side(server: LocalRegistry, registry: Registry) -> None:
    server.bearer = True
    registry.head("c", "x")  # from here on the client knows that it needs a token
    both = threading.Barrier(2, timeout=5)
    server.answering = lambda request: both.wait() if "/token" in request else None
    with ThreadPoolExecutor(2) as pool:
        list(pool.map(lambda repository: registry.head(repository, "x"), ("a", "b")))
    assert not both.broken


# ---- Accounts without access -----------------------------------------------------------------------------------------


@pytest.mark.parametrize("bearer", [True, False])
@pytest.mark.parametrize("logged_in", [True, False])
def test_denied(server: LocalRegistry, registry: Registry, folder: Path, bearer: bool, logged_in: bool) -> None:
    server.users, server.bearer = {NAME: "another"}, bearer
    if logged_in:
        configure(folder, auths={server.address: auth()})
    for call in (lambda: registry.put_blob("a", b"hello"), lambda: registry.may_push("a")):
        with pytest.raises(RosmlError, match="with the account" if logged_in else "without an account") as caught:
            call()
        assert f"docker login {server.address}" in caught.value.remedy


@pytest.mark.parametrize("code", [401, 403])
@pytest.mark.usefixtures("account")
def test_a_login_that_is_refused_is_not_a_missing_repository(
    server: LocalRegistry, registry: Registry, code: int
) -> None:
    server.fault("GET", "/token", code, 1000)
    with pytest.raises(RosmlError, match=rf"cannot log in with the account .*{code}"):
        registry.manifest("a", "x")
    assert server.count("/token") <= 2, "no attempt is repeated"


@pytest.mark.usefixtures("account")
def test_whether_one_may_push_leaves_nothing(server: LocalRegistry, registry: Registry) -> None:
    registry.may_push("a")
    assert (server.uploads, server.aborted, server.blobs) == (1, 1, {})


@pytest.mark.parametrize("bearer", [True, False])
@pytest.mark.parametrize("method", ["POST", "PUT"])
@pytest.mark.parametrize("code", [403, 404, 409])
@pytest.mark.usefixtures("account")
def test_a_first_push_while_another_machine_makes_the_repository(
    server: LocalRegistry, registry: Registry, code: int, method: str, bearer: bool
) -> None:
    server.bearer = bearer
    server.fault(method, "/uploads/", code, 3)
    assert registry.blob("a", registry.put_blob("a", b"hello")) == b"hello"
    server.fault("GET", "/token.*push", 403, 2)
    registry.may_push("b")


@pytest.mark.parametrize(("method", "path"), [("POST", "/uploads/"), ("GET", "/token.*push")])
@pytest.mark.usefixtures("account")
def test_a_push_that_is_denied_fails_within_seconds(
    server: LocalRegistry, registry: Registry, monkeypatch: pytest.MonkeyPatch, method: str, path: str
) -> None:
    registry.head("a", "x")  # the client knows the account
    server.fault(method, path, 403, 1000)
    monkeypatch.setattr(retries, "WAIT", 0.5)
    monkeypatch.setattr(retries, "LONGEST_WAIT", 30)
    pauses: list[float] = []
    monkeypatch.setattr(time, "sleep", pauses.append)
    with pytest.raises(RosmlError, match=r"access denied: cannot .* with the account that is logged in .*403"):
        registry.may_push("a")
    assert 5 < sum(pauses) < 12 and pauses == sorted(pauses)


@pytest.mark.parametrize("who", ["registry", "token"])
@pytest.mark.usefixtures("account")
def test_a_repository_that_does_not_exist_yet_may_be_denied(
    server: LocalRegistry, registry: Registry, caplog: pytest.LogCaptureFixture, who: str
) -> None:
    """As on ghcr.io: its content counts as missing. Without an account, nobody knows what the reason is."""
    server.hides = who
    with Registry(server.address, credentials=lambda _: None) as nobody, pytest.raises(RosmlError, match="denied"):
        nobody.manifest("a", "x")
    assert registry.manifest("a", "x") is None
    assert (registry.head("a", "x"), registry.tags("a"), registry.referrers("a", DIGEST)) == ("", [], [])
    assert server.count(r"^(GET|HEAD) /v2/a/manifests/x") <= 4, "nothing is tried again"
    assert ["does not exist yet" in record.message for record in caplog.records] == [True], "one warning"
    registry.put_blob("a", b"hello")
    digest = registry.put_manifest("a", "x", MANIFEST)
    assert registry.head("a", "x") == digest and registry.tags("a") == ["x"]


@pytest.mark.parametrize("who", ["registry", "token"])
@pytest.mark.usefixtures("account")
def test_an_empty_registry_is_asked_for_one_token(server: LocalRegistry, registry: Registry, who: str) -> None:
    server.hides = who
    with ThreadPoolExecutor(16) as pool:
        assert not any(pool.map(lambda number: registry.head("a", f"x{number}"), range(500)))
    log_in = who == "token"  # after a denial, one request without a scope shows whether the account is known
    assert server.count("/token") == 1 + log_in
    digest = registry.put_manifest("a", "x1", MANIFEST)
    assert registry.head("a", "x1") == digest


@pytest.mark.usefixtures("account")
def test_a_denial_does_not_last(server: LocalRegistry, registry: Registry, monkeypatch: pytest.MonkeyPatch) -> None:
    """Another machine may have made the repository."""
    monkeypatch.setattr(login, "DENIED_SECONDS", 0.05)
    server.hides = "token"
    assert registry.head("a", "x") == ""
    with Registry(server.address) as other:
        digest = other.put_manifest("a", "x", MANIFEST)
    time.sleep(0.1)
    assert registry.head("a", "x") == digest


@pytest.mark.usefixtures("account")
def test_denied_content_of_a_repository_that_exists_is_not_missing(server: LocalRegistry, registry: Registry) -> None:
    """Or its tag would move whatever it points at."""
    digest = registry.put_manifest("a", "x", MANIFEST)
    with Registry(server.address) as other:
        assert other.head("a", digest) == digest
        server.fault("HEAD", "/manifests/x", 403, 1000)
        server.fault("GET", "/tags/list", 403, 1)
        for client in (registry, other):
            with pytest.raises(RosmlError, match=r"cannot pull from a with the account .*403"):
                client.head("a", "x")
            assert client.tags("a") == ["x"], "a denial of a moment is tried again"


# ---- Where passwords go ----------------------------------------------------------------------------------------------


@pytest.mark.usefixtures("account")
def test_no_password_goes_to_storage(server: LocalRegistry, registry: Registry) -> None:
    """Uploads and blobs may be on another host."""
    digest = registry.put_blob("a", b"hello")
    with local_registry() as storage:
        storage.blobs["a", digest] = b"hello"
        folder = f"http://{storage.address}/v2/a/blobs/"
        server.fault("GET", "/blobs/", 307, headers={"Location": folder + digest})
        assert registry.blob("a", digest) == b"hello"
        server.fault("POST", "/uploads/", 202, headers={"Location": f"{folder}uploads/1?_state=s%3D"})
        assert registry.put_blob("a", b"more") == oci.digest_of(b"more")
        assert len(storage.headers) == 2
        assert not any("authorization" in headers for headers in storage.headers)


@pytest.mark.parametrize("kind", ["Bearer", "Basic"])
@pytest.mark.parametrize("way", ["blob", "stream", "upload", "cancel"])
@pytest.mark.usefixtures("account")
def test_another_host_asks_for_the_password(server: LocalRegistry, registry: Registry, way: str, kind: str) -> None:
    """It names itself as the server of tokens."""
    calls: dict[str, Callable[[], object]] = {
        "blob": lambda: registry.blob("a", DIGEST),
        "stream": lambda: registry.read_blob("a", DIGEST, lambda blocks: sum(map(len, blocks)), 1000),
        "upload": lambda: registry.put_blob("a", b"hello"),
        "cancel": lambda: registry.may_push("a"),
    }
    with hostile() as other:
        challenge = f'{kind} realm="http://{other.address}/token",service="x"'
        other.answers = {"/token": reply(200, b'{"token": "stolen"}'), ".": reply(401, headers={"WWW-Authenticate": challenge})}  # fmt: skip
        registry.put_manifest("a", "x", MANIFEST)  # it has logged in
        location = {"Location": f"http://{other.address}/v2/a/blobs/{DIGEST}"}
        server.fault("GET", "/blobs/", 307, 100, headers=location)
        server.fault("POST", "/uploads/", 202, 100, headers=location)
        with nullcontext() if way == "cancel" else pytest.raises(RosmlError, match=other.address):
            calls[way]()
        assert registry.put_manifest("b", "x", MANIFEST), "the registry itself is asked as before"
        assert_no_secret(other)
        assert not [request for request, _ in other.requests if request.startswith(("DELETE", "GET /token"))]


def assert_no_secret(server: Hostile) -> None:
    assert not any("authorization" in headers for _, headers in server.requests)
    assert auth()["auth"] not in repr(server.requests)


@pytest.mark.usefixtures("account")
def test_a_registry_may_name_a_token_server_elsewhere(server: LocalRegistry, registry: Registry) -> None:
    """As Docker Hub does: the password goes to that server, and nowhere else."""
    with local_registry() as tokens:
        tokens.users, tokens.tokens = server.users, server.tokens
        server.realm = f"http://{tokens.address}/token"
        assert registry.put_manifest("a", "x", MANIFEST)
        assert tokens.count("/token") == 1 and "authorization" in tokens.headers[0]
        assert "Basic" not in repr(server.headers)


@pytest.mark.parametrize("tls", [True, False])
def test_no_password_in_the_clear(tmp_path: Path, tls: bool) -> None:
    authority = trustme.CA()
    authority.cert_pem.write_to_path(str(tmp_path / "ca.pem"))
    context = ssl.create_default_context(ssl.Purpose.CLIENT_AUTH)
    authority.issue_cert("127.0.0.1").configure_cert(context)
    with local_registry(context if tls else None) as server:
        server.users, server.bearer, server.realm = {NAME: SECRET}, True, "http://registry.example.org/token"
        client = Registry(server.address, plain=not tls, ca_bundle=str(tmp_path / "ca.pem"),
                          credentials=lambda _: Credentials(NAME, SECRET))  # fmt: skip
        with client, pytest.raises(RosmlError, match="in the clear"):
            client.head("a", "x")
        assert server.requests == ["HEAD /v2/a/manifests/x"]


@pytest.mark.parametrize("bearer", [True, False])
@pytest.mark.usefixtures("account")
def test_no_message_and_no_log_line_has_a_secret(
    server: LocalRegistry, registry: Registry, caplog: pytest.LogCaptureFixture, bearer: bool
) -> None:
    caplog.set_level(logging.DEBUG)
    server.bearer = bearer
    registry.put_blob("a", b"hello")
    texts = [repr(registry), repr(from_docker(server.address))]
    for fault in (DROP, 500, 403, 404):
        server.fault("PUT", "/uploads/", fault, 1000)
        with pytest.raises(RosmlError) as caught:
            registry.put_blob("a", b"%r" % fault)
        texts += [caught.value.message, caught.value.remedy, repr(caught.value), caplog.text]
        server.faults.clear()
    for word in (SECRET, auth()["auth"], "token-", "_state"):
        assert word not in "\n".join(texts)
