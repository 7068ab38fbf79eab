"""A mirror of apt repositories."""

from __future__ import annotations

import contextlib
import threading
from collections.abc import Iterator
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer


class AptMirror(ThreadingHTTPServer):
    files: dict[str, bytes]  # by path
    requests: list[str]  # the paths
    authorization = ""  # the header that it requires

    @property
    def address(self) -> str:
        return f"http://127.0.0.1:{self.server_port}"


class _Handler(BaseHTTPRequestHandler):
    server: AptMirror

    def do_GET(self) -> None:
        self.server.requests.append(self.path)
        body = self.server.files.get(self.path)
        denied = self.headers["Authorization"] != (self.server.authorization or None)
        self.send_response(401 if denied else 404 if body is None else 200)
        self.end_headers()
        self.wfile.write(b"" if denied else body or b"")

    def log_message(self, format: str, *args: object) -> None:
        pass


@contextlib.contextmanager
def serving() -> Iterator[AptMirror]:
    with AptMirror(("127.0.0.1", 0), _Handler) as server:
        server.files, server.requests = {}, []
        threading.Thread(target=server.serve_forever, kwargs={"poll_interval": 0.01}, daemon=True).start()
        yield server
        server.shutdown()
