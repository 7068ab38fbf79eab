"""Certificates of registries in certs.d, for setup and for the client. Against a real registry: tests/e2e/test_secure_registry.py."""

from __future__ import annotations

import datetime
import ssl
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
import trustme

from fakes.http_registry import local_registry
from fakes.stubs import services
from rosml.base.errors import RosmlError
from rosml.registry import certificates, retries
from rosml.registry.client import Registry

NOW = datetime.datetime.now(datetime.UTC)
DAY = datetime.timedelta(days=1)


@pytest.fixture(autouse=True)
def docker(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Path:
    monkeypatch.setenv("DOCKER_CONFIG", str(tmp_path / "docker"))
    monkeypatch.setattr(certificates, "SYSTEM", tmp_path / "system")
    monkeypatch.setattr(retries, "WAIT", 0.001)
    return tmp_path / "docker/certs.d"


def put(folder: Path, host: str, authority: trustme.CA, name: str = "ca.crt") -> Path:
    (folder / host).mkdir(parents=True, exist_ok=True)
    authority.cert_pem.write_to_path(str(folder / host / name))
    return folder / host / name


@contextmanager
def tls(authority: trustme.CA, name: str = "127.0.0.1", valid: int = 1) -> Iterator[str]:
    """The address of an empty registry, whose certificate is valid for some more days."""
    leaf = authority.issue_cert(name, not_before=NOW - 3 * DAY, not_after=NOW + valid * DAY)
    context = ssl.create_default_context(ssl.Purpose.CLIENT_AUTH)
    leaf.configure_cert(context)
    with local_registry(context) as server:
        yield server.address


def test_setup_and_client_have_the_same(docker: Path, tmp_path: Path) -> None:
    authority = trustme.CA()
    for folder in (docker, tmp_path / "system"):
        for name in ("b.crt", "a.crt"):
            put(folder, "reg.example", authority, name)
        (folder / "reg.example/client.key").write_text("not for us")
    put(docker, "127.0.0.1:5001", authority)
    (docker / "a file").write_text("")
    by_host = certificates.by_host()
    assert by_host == {host: certificates.of(host) for host in ("reg.example", "127.0.0.1:5001")}
    assert [file.name for file in by_host["reg.example"]] == ["a.crt", "b.crt"] * 2
    assert certificates.of("other.example") == [] == certificates.of("a file")
    assert Registry("127.0.0.1:5001").transport.base.scheme == "https"
    assert Registry("127.0.0.1:5002").transport.base.scheme == "http"


def test_an_authority_is_trusted_for_its_registry(docker: Path) -> None:
    authority = trustme.CA()
    with tls(authority) as host, tls(authority) as other:
        put(docker, host, authority)
        put(docker, other, trustme.CA())
        with Registry(host) as client:
            assert client.head("a", "x") == ""
        with Registry(other) as client, pytest.raises(RosmlError, match="its certificate is not trusted") as caught:
            client.head("a", "x")
    assert f"{docker}/{other}/ca.crt" in caught.value.remedy and "rosml setup" in caught.value.remedy


@pytest.mark.parametrize(
    ("name", "valid", "remedy"),
    [("127.0.0.1", -1, "its operator has to renew it"), ("other.example", 1, "by a name that its certificate has")],
)
def test_a_certificate_that_is_wrong_is_tried_once(
    docker: Path, monkeypatch: pytest.MonkeyPatch, name: str, valid: int, remedy: str
) -> None:
    pauses: list[float] = []  # before further attempts
    monkeypatch.setattr(time, "sleep", pauses.append)
    authority = trustme.CA()
    with tls(authority, name, valid) as host:
        put(docker, host, authority)
        with Registry(host) as client, pytest.raises(RosmlError, match=r"^(?!.*(_ssl\.c|CERTIFICATE))") as caught:
            client.head("a", "x")
    assert pauses == [] and remedy in caught.value.remedy


def cut(file: Path) -> None:
    file.write_text(file.read_text()[:100])


def replace_by_folder(file: Path) -> None:
    file.unlink()
    file.mkdir()


def replace_by_dead_link(file: Path) -> None:
    file.unlink()
    file.symlink_to("/nowhere.crt")


@pytest.mark.parametrize("damage", [cut, replace_by_folder, replace_by_dead_link])
def test_a_damaged_certificate_stops_its_own_host_alone(
    docker: Path, tmp_path: Path, damage: Callable[[Path], None]
) -> None:
    """Programs that take a bundle for all hosts get the certificates of the others."""
    base = tmp_path / "base.pem"
    base.write_text("the usual ones\n")
    good, bad = (put(docker, host, trustme.CA()) for host in ("reg.example", "other.example"))
    damage(bad)
    with pytest.raises(RosmlError, match=str(bad)) as caught:
        Registry("other.example")
    assert caught.value.exit_code == 2
    if damage is not cut:
        bundle = Path(services(tmp_path, ca_bundle=str(base)).trusting()["SSL_CERT_FILE"])
        assert bundle.read_text() == f"the usual ones\n\n{good.read_text()}"
        assert set(certificates.by_host()) == {"reg.example"}


def test_a_bundle_that_is_missing(monkeypatch: pytest.MonkeyPatch) -> None:
    with pytest.raises(RosmlError, match=r"/nowhere\.pem: No such file"):
        Registry("reg.example", ca_bundle="/nowhere.pem")
    monkeypatch.setenv("SSL_CERT_FILE", "/nowhere.pem")
    with pytest.raises(RosmlError, match="SSL_CERT_FILE"):
        Registry("reg.example")


def test_the_bundle_is_the_usual_one_without_further_certificates(tmp_path: Path) -> None:
    base = tmp_path / "base.pem"
    here = services(tmp_path, ca_bundle=str(base))
    base.write_text("the usual ones\n")
    assert here.trusting()["SSL_CERT_FILE"] == str(base)


def test_a_bundle_that_cannot_be_read(docker: Path, tmp_path: Path) -> None:
    put(docker, "reg.example", trustme.CA())
    with pytest.raises(RosmlError, match=r"cannot read .*base\.pem: No such file"):
        services(tmp_path, ca_bundle=str(tmp_path / "base.pem")).trusting()
