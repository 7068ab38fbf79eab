"""A registry on a bad day: it stands before the real one, and answers some requests as registries do that are busy or broken."""

from __future__ import annotations

import base64
import http.client
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from rosml.registry import credentials
from tests.e2e.local_servers import Handler, serving

Mood = Callable[[int, str], str]
"""What a registry answers, by the number of the request and by its method, path and who asks: nothing for what it would."""

OURS = ("transfer-encoding", "connection", "content-length")
"""Headers of an answer that are not passed on."""


@contextmanager
def moody(upstream: str, mood: Mood) -> Iterator[str]:
    """A registry in front of the real one that now and then answers with an error, or hangs up; gives its address. It knows
    the password."""
    counter = iter(range(1, 1 << 30))
    account = credentials.from_docker(upstream)
    assert account
    secret = base64.b64encode(f"{account.username}:{account.password}".encode()).decode()
    lock = threading.Lock()

    class Moody(Handler):
        protocol_version = "HTTP/1.1"

        def answer(self) -> None:
            body = self.body()
            with lock:
                what = mood(next(counter), f"{self.command} {self.path} {self.headers.get('User-Agent')}")
            if what == "hang up":
                self.close_connection = True
                self.connection.close()
            elif what:
                self.reply(int(what), headers={"Retry-After": "0"} if what == "429" else None)
            else:
                self.pass_on(body)

        def body(self) -> bytes:
            if self.headers.get("Transfer-Encoding") != "chunked":
                return self.rfile.read(int(self.headers.get("Content-Length") or 0))
            body = b""
            while size := int(self.rfile.readline().split(b";")[0], 16):
                body += self.rfile.read(size)
                self.rfile.readline()
            self.rfile.readline()
            return body

        def pass_on(self, body: bytes) -> None:
            """Answers as the real one does."""
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
            headers = {name: value for name, value in response.getheaders() if name.lower() not in OURS}
            if self.command == "HEAD":
                headers["Content-Length"] = response.getheader("Content-Length") or "0"
            self.reply(response.status, data, headers)

        do_GET = do_HEAD = do_PUT = do_POST = do_PATCH = do_DELETE = answer

    with serving(Moody) as address:
        yield address
