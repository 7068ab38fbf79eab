"""A line of a given rate: a registry that is read-only, serves the local registry's files, and paces what it sends.

The kernel copies the bytes (sendfile), so that the line takes next to no processor time from what is measured.
"""

from __future__ import annotations

import json
import os
import re
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from http import HTTPStatus
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path

CHUNK = 256 * 1024
"""Bytes between two looks at the clock."""

_PATH = re.compile(r"/v2/[\w./-]+/(blobs|manifests)/sha256:([0-9a-f]{64})")


class _Pace:
    """All connections of a line share its rate, in bytes per second; 0 is no limit."""

    def __init__(self, rate: float) -> None:
        self._rate, self._lock, self._free = rate, threading.Lock(), 0.0

    def wait(self, size: int) -> None:
        """Returns when the line has room for so many bytes."""
        if not self._rate:
            return
        with self._lock:
            start = max(self._free, time.monotonic())
            self._free = start + size / self._rate
        time.sleep(max(0.0, self._free - time.monotonic()))


@contextmanager
def serve(storage: Path, rate: float) -> Iterator[str]:
    """Serves what a registry stores, by digest alone.

    Args:
        storage: the registry's folder.
        rate: bytes per second of all connections together; 0 is no limit.

    Yields:
        The host of the registry: 127.0.0.1 and a port.
    """
    blobs = storage / "docker/registry/v2/blobs/sha256"
    handler = type("Handler", (_Handler,), {"pace": _Pace(rate), "blobs": blobs})  # two servers share neither
    with ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
        server.daemon_threads = True
        thread = threading.Thread(target=server.serve_forever, daemon=True)
        thread.start()
        try:
            yield f"127.0.0.1:{server.server_address[1]}"
        finally:
            server.shutdown()


class _Handler(BaseHTTPRequestHandler):
    pace: _Pace
    blobs: Path
    protocol_version = default_request_version = "HTTP/1.1"  # also to who tries TLS first, and looks for this answer

    def log_message(self, format: str, *args: object) -> None:
        pass

    def do_HEAD(self) -> None:
        self._answer(body=False)

    def do_GET(self) -> None:
        self._answer(body=True)

    def _answer(self, body: bool) -> None:
        match = _PATH.fullmatch(self.path)
        file = self.blobs / match[2][:2] / match[2] / "data" if match else Path("/nonexistent")
        if self.path.rstrip("/") == "/v2" or not file.is_file():
            self.send_response(HTTPStatus.OK if self.path.rstrip("/") == "/v2" else HTTPStatus.NOT_FOUND)
            self.send_header("Content-Length", "0")
            self.end_headers()
            return
        assert match
        size = file.stat().st_size
        first, last = self._range(size)
        self.send_response(HTTPStatus.OK if last - first == size else HTTPStatus.PARTIAL_CONTENT)
        self.send_header("Content-Length", str(last - first))
        self.send_header("Content-Type", _media_type(file) if match[1] == "manifests" else "application/octet-stream")
        self.send_header("Docker-Content-Digest", f"sha256:{match[2]}")
        if last - first != size:
            self.send_header("Content-Range", f"bytes {first}-{last - 1}/{size}")
        self.end_headers()
        self.wfile.flush()
        if body:
            with file.open("rb") as source:
                while first < last:
                    count = min(CHUNK, last - first)
                    self.pace.wait(count)
                    first += os.sendfile(self.connection.fileno(), source.fileno(), first, count)

    def _range(self, size: int) -> tuple[int, int]:
        match = re.fullmatch(r"bytes=(\d+)-(\d*)", self.headers.get("Range", ""))
        return (int(match[1]), int(match[2] or size - 1) + 1) if match else (0, size)


def _media_type(file: Path) -> str:
    return str(json.loads(file.read_bytes())["mediaType"])
