"""PyTorch's own index, tested against a local replacement: a proxy on loopback that answers for whatever index uv asks.

No index is named anywhere: uv itself knows where the wheels of `--torch-backend cpu` are, and the local replacement serves the
host that uv asks for, under a certificate of a CA of its own.
"""

from __future__ import annotations

import hashlib
import io
import os
import shutil
import socket
import ssl
import subprocess
import threading
import zipfile
from collections.abc import Iterator
from contextlib import closing
from dataclasses import dataclass, field, replace
from pathlib import Path

import pytest
from conftest import ROOT, SMALL, parse

from rosml.base.errors import RosmlError
from rosml.images.locks import lock, resolve
from rosml.images.locks.requests import Elsewhere, Request
from rosml.images.locks.uv import Uv

ASSEMBLE = (ROOT / "components/part/assemble.sh").read_text()


def wheel(name: str, version: str) -> tuple[str, bytes]:
    stem, content = f"{name}-{version}", io.BytesIO()
    with zipfile.ZipFile(content, "w") as archive:
        archive.writestr(f"{name}/__init__.py", f"__version__ = '{version}'\n")
        archive.writestr(f"{stem}.dist-info/METADATA", f"Metadata-Version: 2.1\nName: {name}\nVersion: {version}\n")
        tags = "Wheel-Version: 1.0\nGenerator: test\nRoot-Is-Purelib: true\nTag: py3-none-any\n"
        archive.writestr(f"{stem}.dist-info/WHEEL", tags)
        archive.writestr(f"{stem}.dist-info/RECORD", "")
    return f"{stem}-py3-none-any.whl", content.getvalue()


@dataclass
class Index:
    """The local replacement: its proxy's address, its CA, the hosts that were asked for wheels of PyTorch, and all requests."""

    folder: Path
    wheels: dict[str, tuple[str, bytes]]
    port: int = 0
    torch_hosts: set[str] = field(default_factory=set)
    paths: list[tuple[str, str]] = field(default_factory=list)
    lock: threading.Lock = field(default_factory=threading.Lock)

    @property
    def environment(self) -> dict[str, str]:
        address = f"http://127.0.0.1:{self.port}"
        kept = {key: value for key, value in os.environ.items() if not key.upper().endswith("_PROXY")}
        ours = {"HTTPS_PROXY": address, "SSL_CERT_FILE": str(self.folder / "ca.pem"), "UV_NO_CACHE": "1"}
        return {**kept, **ours, "UV_HTTP_RETRIES": "0"}

    def openssl(self, *arguments: str) -> None:
        subprocess.run(["openssl", *arguments], cwd=self.folder, capture_output=True, check=True)

    def certificate(self, host: str) -> ssl.SSLContext:
        name = hashlib.sha256(host.encode()).hexdigest()[:12]
        if not (self.folder / f"{name}.pem").exists():
            self.openssl("req", "-newkey", "rsa:2048", "-nodes", "-keyout", f"{name}.key", "-out", f"{name}.csr", "-subj", "/CN=local replacement")  # fmt: skip
            (self.folder / f"{name}.ext").write_text(f"subjectAltName=DNS:{host}\n")
            self.openssl("x509", "-req", "-in", f"{name}.csr", "-CA", "ca.pem", "-CAkey", "ca.key", "-days", "2", "-extfile", f"{name}.ext", "-out", f"{name}.pem")  # fmt: skip
        context = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
        context.load_cert_chain(self.folder / f"{name}.pem", self.folder / f"{name}.key")
        return context

    def serve(self, client: socket.socket) -> None:
        """One connection through the proxy: CONNECT, then a request inside TLS."""
        with closing(client):
            host = _head(client).split()[1].partition(":")[0]
            client.sendall(b"HTTP/1.1 200 OK\r\n\r\n")
            try:
                with self.lock:  # two requests for one host make its certificate once
                    context = self.certificate(host)
                with context.wrap_socket(client, server_side=True) as inside:
                    path = _head(inside).split()[1]
                    self.paths.append((host, path))
                    if "torch" in path:
                        self.torch_hosts.add(host)
                    status, body = self.answer(path)
                    kind = "text/html" if path.endswith("/") else "application/octet-stream"
                    head = f"HTTP/1.1 {status}\r\nContent-Type: {kind}\r\nContent-Length: {len(body)}\r\nConnection: close\r\n\r\n"
                    inside.sendall(head.encode() + body)
            except (OSError, IndexError):
                return  # the client changed its mind

    def answer(self, path: str) -> tuple[str, bytes]:
        """A simple index (PEP 503), and the wheels."""
        for name, (file, content) in self.wheels.items():
            if path.endswith(f"/{name}/"):
                digest = hashlib.sha256(content).hexdigest()
                return "200 OK", f'<a href="{file.replace("+", "%2B")}#sha256={digest}">{file}</a>'.encode()
            if path.split("#")[0].endswith(file.replace("+", "%2B")):
                return "200 OK", content
        return "404 Not Found", b""


def _head(connection: socket.socket) -> str:
    data = b""
    while b"\r\n\r\n" not in data and (chunk := connection.recv(4096)):
        data += chunk
    return data.decode()


@pytest.fixture
def index(tmp_path: Path) -> Iterator[Index]:
    """The local replacement with PyTorch for the CPU and numpy."""
    folder = tmp_path / "index"
    folder.mkdir()
    replacement = Index(folder, {"torch": wheel("torch", "2.10.0+cpu"), "numpy": wheel("numpy", "1.26.4")})
    replacement.openssl("req", "-x509", "-newkey", "rsa:2048", "-nodes", "-keyout", "ca.key", "-out", "ca.pem", "-days", "2", "-subj", "/CN=test CA")  # fmt: skip
    with socket.create_server(("127.0.0.1", 0)) as server:
        replacement.port = server.getsockname()[1]

        def accept() -> None:
            while True:
                try:
                    client, _ = server.accept()
                except OSError:
                    return
                threading.Thread(target=replacement.serve, args=(client,), daemon=True).start()

        threading.Thread(target=accept, daemon=True).start()
        yield replacement
        server.shutdown(socket.SHUT_RDWR)


@pytest.fixture
def uv() -> str:
    program = shutil.which("uv", path=f"{ROOT}/.state/bin:{os.environ['PATH']}")
    assert program, "the set-up of every test command installs uv"
    return program


REQUEST = Request(
    stack="cpu",
    architecture="amd64",
    python="3.11",
    wheels="x86_64-manylinux_2_28",
    roots={"torch": "torch==2.10.0"},
    numpy="<2",
    elsewhere={"torch": Elsewhere("torch==2.10.0+cpu", "", ("jinja2",))},
    parts=parse(SMALL).matrix.parts,
)


def test_a_lock_of_a_wheel_that_is_there_alone_can_be_made_and_installed(
    index: Index, uv: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for key, value in index.environment.items():
        monkeypatch.setenv(key, value)
    pins = resolve.resolve(REQUEST, Uv(uv))
    digest = hashlib.sha256(index.wheels["torch"][1]).hexdigest()
    assert [(pin.name, pin.version, pin.hashes) for pin in pins if pin.name == "torch"] == [
        ("torch", "2.10.0+cpu", (f"sha256:{digest}",))
    ]
    assert len(index.torch_hosts) == 1, "one index, known to uv"

    text = lock.render(REQUEST, "torch", lock.split(pins, REQUEST.roots, REQUEST.parts)["torch"])
    (tmp_path / "torch.txt").write_text(text)
    assert not any(host in text for host in index.torch_hosts)
    # The line of the assembly that decides where wheels come from, and the call that follows it.
    choose = next(line for line in ASSEMBLE.splitlines() if "UV_TORCH_BACKEND" in line)
    install = f'{choose}; "{uv}" pip install --no-deps --require-hashes --only-binary :all: --target out --requirement "$LOCK"'
    done = subprocess.run(
        ["bash", "-euo", "pipefail", "-c", install],
        cwd=tmp_path,
        env={**os.environ, "LOCK": "torch.txt"},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "out/torch/__init__.py").read_text() == "__version__ = '2.10.0+cpu'\n"


def test_an_index_that_does_not_answer(uv: str, monkeypatch: pytest.MonkeyPatch, index: Index) -> None:
    for key, value in {**index.environment, "HTTPS_PROXY": "http://127.0.0.1:1"}.items():
        monkeypatch.setenv(key, value)
    with pytest.raises(resolve.Unreachable, match="PyTorch's own index does not answer") as caught:
        resolve.resolve(REQUEST, Uv(uv))
    assert "rosml locks" in caught.value.remedy


def test_an_index_without_the_wheel(uv: str, monkeypatch: pytest.MonkeyPatch, index: Index) -> None:
    index.wheels["torch"] = wheel("torch", "2.9.0+cpu")
    for key, value in index.environment.items():
        monkeypatch.setenv(key, value)
    with pytest.raises(RosmlError, match="does not resolve") as caught:
        resolve.resolve(REQUEST, Uv(uv))
    assert not isinstance(caught.value, resolve.Unreachable)


MINE = "https://pypi.example.com/simple"
OF_ANOTHER = replace(
    REQUEST,
    roots={"torch": "mine==1.0"},
    elsewhere={},
    beside={"torch": ("mine-libs==1.0",)},
    indexes={"mine": MINE, "mine-libs": MINE},
)


@pytest.fixture
def another(index: Index, monkeypatch: pytest.MonkeyPatch) -> Index:
    index.wheels |= {"mine": wheel("mine", "1.0"), "mine-libs": wheel("mine_libs", "1.0")}
    for key, value in index.environment.items():
        monkeypatch.setenv(key, value)
    return index


def test_another_index_is_asked_for_its_packages_alone(another: Index, uv: str) -> None:
    pins = resolve.resolve(OF_ANOTHER, Uv(uv))
    assert {pin.name: pin.version for pin in pins} == {"mine": "1.0", "mine-libs": "1.0", "numpy": "1.26.4"}
    assert set(lock.split(pins, OF_ANOTHER.roots, OF_ANOTHER.parts, OF_ANOTHER.beside)["torch"]) >= {pins[0]}
    [usual] = {host for host, path in another.paths if "numpy" in path}
    assert {host for host, path in another.paths if "mine" in path} == {"pypi.example.com"} != {usual}


@pytest.mark.parametrize("replacement", [None, ("mine_libs-1.0.tar.gz", b""), wheel("mine_libs", "0.9")])
def test_another_index_without_a_wheel_is_named(another: Index, uv: str, replacement: tuple[str, bytes] | None) -> None:
    """A source package in its place is none: the usual index has such for wheels of NVIDIA's."""
    del another.wheels["mine-libs"]
    if replacement:
        another.wheels["mine-libs"] = replacement
    with pytest.raises(RosmlError, match="does not resolve") as caught:
        resolve.resolve(OF_ANOTHER, Uv(uv))
    assert f"put the wheel of mine-libs on {MINE}" in caught.value.remedy
