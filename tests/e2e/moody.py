"""A registry on a bad day: it stands before the real one, and answers some requests as registries do that are busy or broken."""

from __future__ import annotations

import base64
import http.client
import http.server
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from rosml.registry import credentials

Mood = Callable[[int, str], str]
"""What a registry answers, by the number of the request and by its method, path and who asks: nothing for what it would."""


@contextmanager
def moody(upstream: str, mood: Mood) -> Iterator[str]:
    """A registry in front of the real one that now and then answers with an error, or hangs up; gives its address. It knows
    the password."""
    counter = iter(range(1, 1 << 30))
    account = credentials.from_docker(upstream)
    assert account
    secret = base64.b64encode(f"{account.username}:{account.password}".encode()).decode()
    lock = threading.Lock()

    class Handler(http.server.BaseHTTPRequestHandler):
        protocol_version = "HTTP/1.1"

        def answer(self) -> None:
            length = int(self.headers.get("Content-Length") or 0)
            body = self.rfile.read(length) if length else b""
            if self.headers.get("Transfer-Encoding") == "chunked":
                while size := int(self.rfile.readline().split(b";")[0], 16):
                    body += self.rfile.read(size)
                    self.rfile.readline()
                self.rfile.readline()
            with lock:
                what = mood(next(counter), f"{self.command} {self.path} {self.headers.get('User-Agent')}")
            if what == "hang up":
                self.close_connection = True
                self.connection.close()
                return
            if what:
                self.send_response(int(what))
                self.send_header("Content-Length", "0")
                if what == "429":
                    self.send_header("Retry-After", "0")
                self.end_headers()
                return
            connection = http.client.HTTPConnection(upstream, timeout=60)
            connection.putrequest(self.command, self.path, skip_host=True, skip_accept_encoding=True)
            for name, value in self.headers.items():  # Accept comes several times
                if name.lower() not in ("transfer-encoding", "content-length", "connection"):
                    connection.putheader(name, value)
            connection.putheader("Authorization", f"Basic {secret}")
            if body or self.command in ("PUT", "POST", "PATCH"):
                connection.putheader("Content-Length", str(len(body)))
            connection.endheaders(body or None)
            response = connection.getresponse()
            data = response.read()
            self.send_response(response.status)
            for name, value in response.getheaders():
                if name.lower() not in ("transfer-encoding", "connection", "content-length"):
                    self.send_header(name, value)
            length_said = response.getheader("Content-Length") if self.command == "HEAD" else str(len(data))
            self.send_header("Content-Length", length_said or "0")
            self.end_headers()
            if self.command != "HEAD":
                self.wfile.write(data)

        do_GET = do_HEAD = do_PUT = do_POST = do_PATCH = do_DELETE = answer

        def log_message(self, format: str, *args: object) -> None:
            pass

    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), Handler) as server:
        server.daemon_threads = True
        threading.Thread(target=server.serve_forever, kwargs={"poll_interval": 0.05}, daemon=True).start()
        yield f"127.0.0.1:{server.server_port}"
        server.shutdown()
