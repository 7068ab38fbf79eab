"""A server on a real socket that answers whatever a test says, byte for byte: also what no library would send."""

from __future__ import annotations

import re
import socketserver
import threading
import time
import tracemalloc
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field

import pytest

from rosml.base.errors import RosmlError

MEMORY = 100 << 20
"""The most bytes of memory that an answer may take."""

Answer = bytes | Callable[[], Iterator[bytes]]
"""All bytes of an answer, or a function that makes them one block after another."""


@dataclass
class Hostile:
    """`answers` are by a pattern of `METHOD path`: the first that fits. Everything else gets 404. Headers are in lower case."""

    address: str = ""
    answers: dict[str, Answer] = field(default_factory=dict)
    requests: list[tuple[str, dict[str, str]]] = field(default_factory=list)
    bodies: list[bytes] = field(default_factory=list)  # of the requests

    def answer(self, request: str) -> Answer:
        matching = (answer for pattern, answer in self.answers.items() if re.search(pattern, request))
        return next(matching, reply(404))


def reply(code: int, body: bytes = b"", headers: Mapping[str, str | bytes] | None = None) -> bytes:
    """An answer with these headers, as they are, and its length."""
    lines = [b"HTTP/1.1 %d X" % code, b"Connection: close"]
    for name, value in {"Content-Length": str(len(body)), **(headers or {})}.items():
        lines.append(name.encode() + b": " + (value if isinstance(value, bytes) else value.encode()))
    return b"\r\n".join(lines) + b"\r\n\r\n" + body


def endless(
    code: int, block: bytes = b"[" * 65536, headers: Mapping[str, str] | None = None
) -> Callable[[], Iterator[bytes]]:
    """An answer whose body has no end."""

    def blocks() -> Iterator[bytes]:
        lines = [f"HTTP/1.1 {code} X", "Transfer-Encoding: chunked", *(f"{k}: {v}" for k, v in (headers or {}).items())]
        yield "\r\n".join(lines).encode() + b"\r\n\r\n"
        while True:
            yield b"%x\r\n%b\r\n" % (len(block), block)

    return blocks


def limited_error(call: Callable[[], object]) -> RosmlError:
    """The error of a call, which must come within a second of work, without much memory, and with a remedy."""
    tracemalloc.start()
    try:
        before, started = time.thread_time(), time.monotonic()
        with pytest.raises(RosmlError) as caught:
            call()
        seconds, wall_seconds = time.thread_time() - before, time.monotonic() - started
        peak = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    assert seconds < 1 and wall_seconds < 10 and peak < MEMORY
    assert caught.value.message and caught.value.remedy and len(caught.value.message) < 2000
    assert (caught.value.message + caught.value.remedy).replace("\n", "").isprintable()
    return caught.value


class _Handler(socketserver.StreamRequestHandler):
    hostile: Hostile

    def handle(self) -> None:
        with suppress(OSError):  # the client may have read enough
            first = self.rfile.readline().decode("latin-1").split(" ")
            headers: dict[str, str] = {}
            while line := self.rfile.readline().strip():
                name, _, value = line.decode("latin-1").partition(":")
                headers[name.lower()] = value.strip()
            body = self.rfile.read(int(headers.get("content-length") or 0))
            if len(first) < 2:
                return
            request = " ".join(first[:2])
            self.hostile.requests.append((request, headers))
            self.hostile.bodies.append(body)
            answer = self.hostile.answer(request)
            for block in [answer] if isinstance(answer, bytes) else answer():
                self.wfile.write(block)


class _Server(socketserver.ThreadingTCPServer):
    allow_reuse_address = True
    daemon_threads = True


@contextmanager
def hostile() -> Iterator[Hostile]:
    """A server that answers as long as this."""
    running = Hostile()
    with _Server(("127.0.0.1", 0), type("Handler", (_Handler,), {"hostile": running})) as server:
        running.address = f"127.0.0.1:{server.server_address[1]}"
        threading.Thread(target=server.serve_forever, kwargs={"poll_interval": 0.01}, daemon=True).start()
        yield running
        server.shutdown()
