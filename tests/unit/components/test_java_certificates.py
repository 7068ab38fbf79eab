"""Java's store of certificates is the same in every build."""

from __future__ import annotations

import hashlib
import struct
import subprocess
import sys
from pathlib import Path

import pytest
from conftest import ROOT

SCRIPT = ROOT / "components/build/java_certificates.py"
SALT = "changeit".encode("utf-16-be") + b"Mighty Aphrodite"


def store(times: list[int], kind: int = 2, password: bytes = SALT) -> bytes:
    """As ca-certificates-java writes it: certificates of different lengths, each with the time of its addition."""
    body = struct.pack(">III", 0xFEEDFEED, 2, len(times))
    for number, time in enumerate(times):
        name, certificate = f"debian:{'n' * number}.pem".encode(), b"c" * (100 + number)
        body += struct.pack(">IH", kind, len(name)) + name + struct.pack(">QH", time, 5) + b"X.509"
        body += struct.pack(">I", len(certificate)) + certificate
    return body + hashlib.sha1(password + body).digest()


def after(file: Path, content: bytes) -> tuple[bytes, str]:
    file.write_bytes(content)
    argv = [sys.executable, str(SCRIPT), str(file), "1767225600"]
    done = subprocess.run(argv, capture_output=True, text=True, check=True)
    return file.read_bytes(), done.stderr


def test_all_certificates_get_one_time(tmp_path: Path) -> None:
    expected = store([1767225600000] * 3)
    for times in ([1, 2, 3], [1795320266742, 1795320266750, 1795320267001]):
        assert after(tmp_path / "cacerts", store(times)) == (expected, "")


OTHERS = {
    "empty": b"",
    "another format": b"0\x82" + bytes(400),
    "another password": store([1, 2], password=b"other"),
    "a key": store([1, 2], kind=1),
}


@pytest.mark.parametrize("other", OTHERS)
def test_what_else_there_is_stays(tmp_path: Path, other: str) -> None:
    content, message = after(tmp_path / "cacerts", OTHERS[other])
    assert content == OTHERS[other]
    assert "left as it is" in message
