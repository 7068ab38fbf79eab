"""A registry as companies have them: TLS with a certificate of their own authority, and users with passwords, who are asked
for them by the registry itself or by a server that issues tokens."""

from __future__ import annotations

import base64
import datetime
import json
import os
import re
import socket
import ssl
import subprocess
import time
import uuid
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any
from urllib.parse import parse_qs, urlsplit

import bcrypt
import jwt
import pytest
import trustme

from rosml import ROOT
from rosml.machine.services import Services
from rosml.machine.setup import network
from tests.e2e.calls import succeeds, wait_until
from tests.e2e.local_servers import Handler, serving

NAME, PASSWORD = "robot+ci", "p4ss:wörd/with=odd&letters"
ISSUER, SERVICE = "a test", "a registry"


def own_address() -> str:
    """An address of this machine that is not loopback, where plain http would do; loopback on a machine without one."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        try:
            probe.connect(("192.0.2.1", 9))  # sends nothing
        except OSError:
            return "127.0.0.1"
        return str(probe.getsockname()[0])


def encoded(name: str, password: str) -> str:
    """As Docker's config file and the header have them."""
    return base64.b64encode(f"{name}:{password}".encode()).decode()


@dataclass
class Secure:
    """A running registry.

    Attributes:
        host: its address. authority: who signed its certificate. storage: its folder. log: its log.
        scopes: those of the tokens that were issued.
    """

    host: str
    authority: trustme.CA
    storage: Path
    log: Path
    scopes: list[str] = field(default_factory=list)

    @property
    def repositories(self) -> list[str]:
        """All that have anything."""
        root = self.storage / "docker/registry/v2/repositories"
        return sorted(str(path.parent.relative_to(root)) for path in root.rglob("_manifests"))

    def docker_config(self, folder: Path, config: Mapping[str, object], trust: bool = True) -> None:
        """Writes what `docker login` leaves, and the authority's certificate where it is looked for."""
        folder.mkdir(parents=True)
        (folder / "config.json").write_text(json.dumps(config))
        if trust:
            place = folder / "certs.d" / self.host
            place.mkdir(parents=True)
            self.authority.cert_pem.write_to_path(str(place / "ca.crt"))


def cosign() -> str:
    """Path of the real program; the test fails where there is none."""
    try:
        program: str = json.loads((ROOT / ".state/signer.json").read_text())["cosign"]
    except OSError:
        pytest.fail("cosign is not installed: rosml setup signer", pytrace=False)
    return program


def signing_key(prefix: Path) -> dict[str, str]:
    """Makes a pair of keys with cosign; the environment of a run that signs with it."""
    environment = {"COSIGN_KEY": f"{prefix}.key", "COSIGN_PASSWORD": "only for this test"}
    succeeds(cosign(), "generate-key-pair", "--output-key-prefix", str(prefix), env=environment)
    return environment


@contextmanager
def registry(folder: Path, expired: bool = False, users: Mapping[str, str] | None = None) -> Iterator[Secure]:
    """Starts one.

    Args:
        expired: its certificate has expired.
        users: what they may do, `pull` or `pull,push`, for one that wants tokens; without, it wants the password itself.
    """
    folder.mkdir()
    address = own_address()
    authority = trustme.CA()
    now = datetime.datetime.now(datetime.UTC)
    valid = (now - datetime.timedelta(days=2), now + datetime.timedelta(days=-1 if expired else 1))
    leaf = authority.issue_cert(address, not_before=valid[0], not_after=valid[1])
    leaf.private_key_pem.write_to_path(str(folder / "key.pem"))
    (folder / "chain.pem").write_bytes(b"".join(pem.bytes() for pem in leaf.cert_chain_pems))
    authority.cert_pem.write_to_path(str(folder / "authority.pem"))
    secured = Secure(f"{address}:{network.free_port()}", authority, folder / "storage", folder / "log")
    if users is None:
        hashed = bcrypt.hashpw(PASSWORD.encode(), bcrypt.gensalt(4)).decode()
        (folder / "htpasswd").write_text(f"{NAME}:{hashed}\n")
        with running(folder, secured, {"htpasswd": {"realm": "a test", "path": str(folder / "htpasswd")}}):
            yield secured
        return
    with tokens(folder, secured, leaf, users) as realm:
        token = {"realm": realm, "service": SERVICE, "issuer": ISSUER, "rootcertbundle": str(folder / "authority.pem")}
        with running(folder, secured, {"token": token}):
            yield secured


@contextmanager
def used(folder: Path, tokens: bool, monkeypatch: pytest.MonkeyPatch) -> Iterator[tuple[Secure, Services, Path]]:
    """Starts one and logs in to it, as this process and what it calls see it.

    Args:
        folder: an empty one. tokens: whether the registry wants tokens; without, it wants the password itself.

    Yields:
        the registry, services of a machine without a builder, Docker's configuration folder.
    """
    docker = folder / "docker"
    monkeypatch.setenv("DOCKER_CONFIG", str(docker))
    monkeypatch.delenv("DOCKER_AUTH_CONFIG", raising=False)
    for name in ("no_proxy", "NO_PROXY"):
        monkeypatch.setenv(name, own_address())
    root = folder / "checkout"
    (root / ".state").mkdir(parents=True)
    services = Services(root, "", (), "", "", None, "", "", ())
    with registry(folder / "registry", users={NAME: "pull,push"} if tokens else None) as secured:
        secured.docker_config(docker, {"auths": {secured.host: {"auth": encoded(NAME, PASSWORD)}}})
        yield secured, services, docker


@contextmanager
def running(folder: Path, secured: Secure, auth: Mapping[str, object]) -> Iterator[None]:
    """Runs the registry's program with TLS and users."""
    tls = {"certificate": str(folder / "chain.pem"), "key": str(folder / "key.pem")}
    config = {"http": {"addr": secured.host, "tls": tls}, "auth": auth}
    with registry_program(folder, secured.storage, config):
        yield


@contextmanager
def plain(folder: Path, deletes: bool) -> Iterator[str]:
    """Starts a registry on this machine that speaks plain http to anybody, and deletes, or refuses to; gives its address."""
    folder.mkdir()
    address = f"127.0.0.1:{network.free_port()}"
    with registry_program(folder, folder / "storage", {"http": {"addr": address}}, deletes):
        yield address


@contextmanager
def registry_program(folder: Path, storage: Path, settings: Mapping[str, Any], deletes: bool = True) -> Iterator[None]:
    """Runs the registry's program.

    Args:
        folder: for its configuration and log. storage: for what it holds.
        settings: the rest of its configuration; `http.addr` in it is where it listens.
        deletes: whether it deletes.
    """
    kept = {"filesystem": {"rootdirectory": str(storage)}, "delete": {"enabled": deletes}}
    (folder / "config.json").write_text(
        json.dumps({"version": 0.1, "log": {"level": "info"}, "storage": kept, **settings})
    )
    env = {name: value for name, value in os.environ.items() if not name.startswith(("REGISTRY_", "OTEL_"))}
    env["OTEL_TRACES_EXPORTER"] = "none"
    command = [str(ROOT / ".state/bin/registry"), "serve", str(folder / "config.json")]
    with (folder / "log").open("wb") as log:
        process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=log, stderr=log, env=env)
    try:
        host, _, port = settings["http"]["addr"].rpartition(":")

        def listens() -> bool:
            with socket.socket() as probe:
                return probe.connect_ex((host, int(port))) == 0

        wait_until(listens, 20, lambda: (folder / "log").read_text()[-2000:], process)
        yield
    finally:
        process.terminate()
        process.wait(timeout=20)


@contextmanager
def tokens(folder: Path, secured: Secure, leaf: trustme.LeafCert, users: Mapping[str, str]) -> Iterator[str]:
    """A server that issues tokens, signed by the registry's authority; gives its address."""
    key = leaf.private_key_pem.bytes().decode()
    chain = [base64.b64encode(ssl.PEM_cert_to_DER_cert(pem.bytes().decode())).decode() for pem in leaf.cert_chain_pems]

    class Issuer(Handler):
        def do_GET(self) -> None:
            header = self.headers.get("Authorization", "")
            name = next((name for name in users if header == f"Basic {encoded(name, PASSWORD)}"), "")
            if header and not name:
                self.answer(401, {"details": "unknown user or wrong password"})
                return
            scopes = " ".join(parse_qs(urlsplit(self.path).query).get("scope", [])).split()
            secured.scopes.extend(scopes)
            access = []
            for scope in scopes:
                kind, repository, actions = re.fullmatch(r"(\w+):(.+):([^:]*)", scope).groups()  # type: ignore[union-attr]
                allowed = [action for action in actions.split(",") if action in users.get(name, "").split(",")]
                access.append({"type": kind, "name": repository, "actions": allowed})
            now = int(time.time())
            claims = {"iss": ISSUER, "sub": name, "aud": SERVICE, "exp": now + 300, "nbf": now - 10, "iat": now}
            claims |= {"jti": uuid.uuid4().hex, "access": access}
            token = jwt.encode(claims, key, algorithm="ES256", headers={"x5c": chain})
            self.answer(200, {"token": token, "expires_in": 300})

        def do_POST(self) -> None:  # the newer way, which not all servers know
            self.rfile.read(int(self.headers.get("Content-Length") or 0))
            self.answer(405, {})

        def answer(self, code: int, content: Mapping[str, object]) -> None:
            self.reply(code, json.dumps(content).encode())

    address = secured.host.rpartition(":")[0]
    context = ssl.create_default_context(ssl.Purpose.CLIENT_AUTH)
    context.load_cert_chain(folder / "chain.pem", folder / "key.pem")
    with serving(Issuer, address, context) as place:
        yield f"https://{place}/token"
