"""Certificates of registries in certs.d: found alike by what sets a machine up and by what publishes, trusted for their host,
and told when they are not to be had. Against a real registry: tests/e2e/test_secure_registry.py."""

from __future__ import annotations

import datetime
import ssl
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

import pytest
import trustme

from fakes.stubs import services
from rosml.base.errors import RosmlError
from rosml.machine import trust
from rosml.registry import certificates, failures
from rosml.registry.client import Registry

NOW = datetime.datetime.now(datetime.UTC)
DAY = datetime.timedelta(days=1)


@pytest.fixture(autouse=True)
def docker(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Path:
    monkeypatch.setenv("DOCKER_CONFIG", str(tmp_path / "docker"))
    monkeypatch.setattr(certificates, "SYSTEM", tmp_path / "system")
    monkeypatch.setattr(failures, "WAIT", 0.001)
    return tmp_path / "docker/certs.d"


def put(folder: Path, host: str, authority: trustme.CA, name: str = "ca.crt") -> Path:
    (folder / host).mkdir(parents=True, exist_ok=True)
    authority.cert_pem.write_to_path(str(folder / host / name))
    return folder / host / name


@contextmanager
def tls(authority: trustme.CA, folder: Path, name: str = "127.0.0.1", valid: int = 1) -> Iterator[str]:
    """A server with TLS that knows no manifest; gives its address."""

    class Handler(BaseHTTPRequestHandler):
        def do_HEAD(self) -> None:
            self.send_response(404)
            self.send_header("Content-Length", "0")
            self.end_headers()

        def log_message(self, format: str, *args: object) -> None:
            pass

    leaf = authority.issue_cert(name, not_before=NOW - 3 * DAY, not_after=NOW + valid * DAY)
    context = ssl.create_default_context(ssl.Purpose.CLIENT_AUTH)
    leaf.configure_cert(context)

    class Server(ThreadingHTTPServer):
        daemon_threads = True

        def handle_error(self, *_: object) -> None:
            """A client that hangs up is what these tests are about."""

    with Server(("127.0.0.1", 0), Handler) as server:
        server.socket = context.wrap_socket(server.socket, server_side=True, do_handshake_on_connect=False)
        threading.Thread(target=server.serve_forever, kwargs={"poll_interval": 0.01}, daemon=True).start()
        yield f"127.0.0.1:{server.server_port}"
        server.shutdown()


def test_set_up_and_publisher_find_the_same(docker: Path, tmp_path: Path) -> None:
    authority = trustme.CA()
    for folder in (docker, tmp_path / "system"):
        for host in ("reg.example", "127.0.0.1:5000"):
            put(folder, host, authority, "b.crt")
            put(folder, host, authority, "a.crt")
            (folder / host / "client.key").write_text("not for us")
    put(docker, "own.example:8443", authority)
    (docker / "a file").write_text("")
    found = certificates.by_host()
    assert set(found) == {"reg.example", "127.0.0.1:5000", "own.example:8443"}
    for host, files in found.items():
        assert files == certificates.of(host)
    assert [file.name for file in found["reg.example"]] == ["a.crt", "b.crt"] * 2
    assert certificates.of("other.example") == [] == certificates.of("a file")


def test_an_authority_is_trusted_for_its_registry(docker: Path, tmp_path: Path) -> None:
    authority = trustme.CA()
    with tls(authority, tmp_path) as host, tls(authority, tmp_path) as other:
        put(docker, host, authority)
        put(docker, other, trustme.CA())
        with Registry(host) as client:
            assert client.head("a", "x") == ""
        with Registry(other) as client, pytest.raises(RosmlError, match="its certificate is not trusted") as caught:
            client.head("a", "x")
    assert f"{docker}/{other}/ca.crt" in caught.value.remedy and "rosml setup" in caught.value.remedy


@pytest.mark.parametrize(
    ("name", "valid", "says"),
    [("127.0.0.1", -1, "its operator has to renew it"), ("other.example", 1, "by a name that its certificate has")],
)
def test_what_is_wrong_with_a_certificate_is_told_at_once(
    docker: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str, valid: int, says: str
) -> None:
    pauses: list[float] = []  # before further attempts
    monkeypatch.setattr(time, "sleep", pauses.append)
    authority = trustme.CA()
    with tls(authority, tmp_path, name, valid) as host:
        put(docker, host, authority)
        with Registry(host) as client, pytest.raises(RosmlError) as caught:
            client.head("a", "x")
    assert pauses == []
    assert says in caught.value.remedy
    assert "_ssl.c" not in caught.value.message and "CERTIFICATE" not in caught.value.message


def cut(file: Path) -> None:
    file.write_text(file.read_text()[:100])


def emptied(file: Path) -> None:
    file.write_text("")


def folder(file: Path) -> None:
    file.unlink()
    file.mkdir()


@pytest.mark.parametrize("damage", [cut, emptied, folder])
def test_a_damaged_certificate_is_named(docker: Path, damage: Callable[[Path], None]) -> None:
    file = put(docker, "reg.example", trustme.CA())
    damage(file)
    with pytest.raises(RosmlError) as caught:
        Registry("reg.example")
    assert str(file) in caught.value.message and caught.value.exit_code == 2


def test_a_bundle_that_is_not_there(monkeypatch: pytest.MonkeyPatch) -> None:
    with pytest.raises(RosmlError, match=r"/nowhere\.pem: No such file"):
        Registry("reg.example", ca_bundle="/nowhere.pem")
    monkeypatch.setenv("SSL_CERT_FILE", "/nowhere.pem")
    with pytest.raises(RosmlError, match="the file that SSL_CERT_FILE names: No such file"):
        Registry("reg.example")


def test_what_looks_for_authorities_in_a_bundle_gets_one(docker: Path, tmp_path: Path) -> None:
    base = tmp_path / "base.pem"
    base.write_text("the usual ones\n")
    here = services(tmp_path, ca_bundle=str(base))
    assert trust.trusting(here)["SSL_CERT_FILE"] == str(base)
    file = put(docker, "reg.example", trustme.CA())
    bundle = Path(trust.trusting(here)["SSL_CERT_FILE"])
    assert "the usual ones" in bundle.read_text() and file.read_text() in bundle.read_text()
    base.unlink()
    with pytest.raises(RosmlError, match=r"cannot read .*base\.pem: No such file"):
        trust.trusting(here)


def lost(file: Path) -> None:
    file.unlink()
    file.symlink_to("/nowhere.crt")


@pytest.mark.parametrize("damage", [lost, folder])
def test_what_cannot_be_read_stops_its_own_host_alone(
    docker: Path, tmp_path: Path, damage: Callable[[Path], None]
) -> None:
    """As one that only root may read; programs that take a bundle for all hosts get the certificates of the others."""
    base = tmp_path / "base.pem"
    base.write_text("the usual ones\n")
    ours, other = (put(docker, host, trustme.CA()) for host in ("reg.example", "other.example"))
    damage(other)
    bundle = Path(trust.trusting(services(tmp_path, ca_bundle=str(base)))["SSL_CERT_FILE"])
    assert bundle.read_text() == f"the usual ones\n\n{ours.read_text()}"
    assert set(certificates.by_host()) == {"reg.example"}
    with pytest.raises(RosmlError, match=str(other)):
        Registry("other.example")


def test_a_registry_of_this_machine_speaks_tls_where_there_are_certificates(docker: Path) -> None:
    put(docker, "127.0.0.1:5001", trustme.CA())
    assert Registry("127.0.0.1:5001").transport.base.scheme == "https"
    assert Registry("127.0.0.1:5002").transport.base.scheme == "http"
