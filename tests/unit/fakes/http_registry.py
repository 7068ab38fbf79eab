"""A registry in this process, with the distribution API, and the faults that a test gives it."""

from __future__ import annotations

import base64
import hashlib
import json
import math
import re
import ssl
import sys
import threading
import time
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import Any
from urllib.parse import parse_qs, urlsplit

from rosml.registry.oci import INDEX, digest_of, encoded

DENIED = b'{"errors": [{"code": "DENIED", "message": "denied"}]}'

DROP = "drop"
"""A fault: the connection ends without an answer. A number is the status of an answer."""


@dataclass
class Fault:
    """A failure of requests of a method whose path matches: `times` times, and `each` times with each path."""

    method: str
    path: str
    kind: int | str
    times: int = 1
    headers: dict[str, str] = field(default_factory=dict)
    body: bytes = b""
    each: int = 1 << 30
    seen: Counter[str] = field(default_factory=Counter)


@dataclass
class LocalRegistry:
    """The content of the registry, and how it behaves.

    Attributes:
        blobs, manifests: by repository and digest. tags: by repository. requests: as `METHOD path`.
        referrers: it has the referrers API. people: where it redirects a request for referrers. page: tags on a page.
        hides: who denies to read in a repository that has no manifest yet: "registry" or "token".
        users: passwords by name; if there are none, anybody may do anything. scoped: tokens are good only for their scopes.
        expires: seconds after which a token is refused. checks: it refuses a manifest whose parts it does not have.
        answering: called with a request before its answer leaves, which is decided by then.
    """

    address: str = ""
    blobs: dict[tuple[str, str], bytes] = field(default_factory=dict)
    manifests: dict[tuple[str, str], tuple[str, bytes]] = field(default_factory=dict)
    tags: dict[str, dict[str, str]] = field(default_factory=dict)
    mounts: bool = True
    referrers: bool = False
    page: int = 100
    hides: str = ""
    users: dict[str, str] = field(default_factory=dict)
    bearer: bool = False
    realm: str = ""
    tokens: dict[str, str] = field(default_factory=dict)
    expires: float = 300
    scoped: bool = False
    deletes: bool = True
    checks: bool = True
    people: str = ""
    ends: dict[str, float] = field(default_factory=dict)
    identity_token: str = ""
    faults: list[Fault] = field(default_factory=list)
    requests: list[str] = field(default_factory=list)
    headers: list[dict[str, str]] = field(default_factory=list)
    lock: threading.Lock = field(default_factory=threading.Lock)
    uploads: int = 0
    aborted: int = 0
    answering: Callable[[str], object] = lambda request: None

    def fault(self, method: str, path: str, kind: int | str, times: int = 1, **more: Any) -> None:
        self.faults.append(Fault(method, path, kind, times, **more))

    def due(self, method: str, path: str) -> Fault | None:
        with self.lock:
            for fault in self.faults:
                if fault.times and fault.method == method and re.search(fault.path, path):
                    fault.seen[path] += 1
                    if fault.seen[path] <= fault.each:
                        fault.times -= 1
                        return fault
        return None

    def count(self, pattern: str) -> int:
        return sum(re.search(pattern, request) is not None for request in self.requests)

    def exists(self, repository: str) -> bool:
        return any(where == repository for where, _ in list(self.manifests))


class _Handler(BaseHTTPRequestHandler):
    protocol_version = "HTTP/1.1"
    wbufsize = -1  # headers and body together: the other side need not wait for the second packet
    registry: LocalRegistry

    def _handle(self) -> None:
        body = self.rfile.read(int(self.headers.get("Content-Length") or 0))
        registry, parts = self.registry, urlsplit(self.path)
        query = {name: values[0] for name, values in parse_qs(parts.query).items()}
        with registry.lock:
            registry.requests.append(f"{self.command} {self.path}")
            registry.headers.append({name.lower(): value for name, value in self.headers.items()})
        if fault := registry.due(self.command, self.path):
            if fault.kind == DROP:
                self.close_connection = True
                self.connection.close()
                return
            self._answer(int(fault.kind), fault.body, fault.headers)
            return
        if parts.path == "/token":
            self._token(body)
        elif not self._authorized():
            realm = registry.realm or f"http://{registry.address}/token"
            challenge = f'Bearer realm="{realm}",service="x"' if registry.bearer else 'Basic realm="x"'
            self._answer(401, b"", {"WWW-Authenticate": challenge})
        else:
            self._api(parts.path, query, body)

    do_GET = do_HEAD = do_PUT = do_POST = do_DELETE = _handle

    def _answer(self, code: int, body: bytes = b"", headers: dict[str, str] | None = None) -> None:
        self.registry.answering(f"{self.command} {self.path}")
        self.send_response(code)
        for name, value in (headers or {}).items():
            self.send_header(name, value)
        self.send_header("Content-Length", str(len(body)))
        self.end_headers()
        if self.command != "HEAD":
            with suppress(ConnectionError):  # the client may have read enough
                self.wfile.write(body)
                self.wfile.flush()

    def _authorized(self) -> bool:
        registry, header = self.registry, self.headers.get("Authorization", "")
        if not registry.users and not registry.bearer:
            return True
        kind, _, secret = header.partition(" ")
        if not registry.bearer:
            return kind == "Basic" and self._user(secret) is not None
        if secret not in registry.tokens or time.monotonic() > registry.ends.get(secret, math.inf):
            return False
        target = re.match(r"/v2/(.+)/(?:manifests|blobs|tags|referrers)/", self.path)
        if not registry.scoped or not target:
            return True
        action = "pull" if self.command in ("GET", "HEAD") else "delete" if self.command == "DELETE" else "push"
        if "/uploads/" in self.path:
            action = "push"
        allowed = re.findall(r"repository:(\S+):(\S+)", registry.tokens[secret])
        return any(name == target[1] and action in actions.split(",") for name, actions in allowed)

    def _user(self, secret: str) -> str | None:
        name, _, password = base64.b64decode(secret).decode().partition(":")
        return name if self.registry.users.get(name) == password else None

    def _token(self, body: bytes) -> None:
        registry, header = self.registry, self.headers.get("Authorization", "")
        if self.command == "POST":
            form = {name: values[0] for name, values in parse_qs(body.decode()).items()}
            allowed = form.get("refresh_token") == registry.identity_token != ""
            scopes = form.get("scope", "")
        else:
            allowed = not registry.users or (bool(header) and self._user(header.partition(" ")[2]) is not None)
            scopes = " ".join(parse_qs(urlsplit(self.path).query).get("scope", []))
        if not allowed:
            self._answer(401)
            return
        read = re.findall(r"repository:(\S+):pull(?!,)", scopes)
        if registry.hides == "token" and not all(registry.exists(name) for name in read):
            self._answer(403, DENIED)
            return
        with registry.lock:
            token = f"token-{len(registry.tokens)}"
            registry.tokens[token] = scopes
            registry.ends[token] = time.monotonic() + registry.expires
        self._answer(200, json.dumps({"token": token, "expires_in": 300}).encode())

    def _api(self, path: str, query: dict[str, str], body: bytes) -> None:
        if match := re.fullmatch(r"/v2/(.+)/(manifests|blobs|tags|referrers)/(.+)", path):
            reads = self.command in ("GET", "HEAD") and not match[3].startswith("uploads/")
            if reads and self.registry.hides == "registry" and not self.registry.exists(match[1]):
                self._answer(403, DENIED)
                return
            getattr(self, f"_{match[2]}")(match[1], match[3], query, body)
        elif match := re.fullmatch(r"/v2/(.+)/blobs/uploads/?", path):
            self._blobs(match[1], "uploads/", query, body)
        else:
            self._answer(200 if path == "/v2/" else 404)

    def _blobs(self, repository: str, name: str, query: dict[str, str], body: bytes) -> None:
        registry = self.registry
        if not name.startswith("uploads/"):
            data = registry.blobs.get((repository, name))
            self._answer(404 if data is None else 200, data or b"")
        elif self.command == "POST":
            source = (query.get("from", ""), query.get("mount", ""))
            if registry.mounts and source in registry.blobs:
                registry.blobs[repository, query["mount"]] = registry.blobs[source]
                self._answer(201)
            else:
                registry.uploads += 1
                self._answer(202, b"", {"Location": f"/v2/{repository}/blobs/uploads/{registry.uploads}?_state=s%3D"})
        elif self.command == "DELETE":
            registry.aborted += 1
            self._answer(204)
        elif query.get("_state") != "s=" or f"sha256:{hashlib.sha256(body).hexdigest()}" != query.get("digest"):
            self._answer(400, b'{"errors": [{"code": "DIGEST_INVALID"}]}')
        else:
            registry.blobs[repository, query["digest"]] = body
            self._answer(201)

    def _manifests(self, repository: str, name: str, query: dict[str, str], body: bytes) -> None:
        registry = self.registry
        tags = registry.tags.setdefault(repository, {})
        if self.command == "PUT":
            digest = digest_of(body)
            if unknown := registry.checks and self._unknown(repository, json.loads(body)):
                problem = {"code": "MANIFEST_BLOB_UNKNOWN", "message": "blob unknown to registry", "detail": unknown}
                self._answer(404, encoded({"errors": [problem]}))
                return
            registry.manifests[repository, digest] = (self.headers["Content-Type"], body)
            if not name.startswith("sha256:"):
                tags[name] = digest
            subject = json.loads(body).get("subject")
            extra = {"OCI-Subject": subject["digest"]} if subject and registry.referrers else {}
            self._answer(201, b"", {"Docker-Content-Digest": digest, **extra})
            return
        if self.command == "DELETE" and not registry.deletes:
            self._answer(405, b'{"errors": [{"code": "UNSUPPORTED"}]}')
            return
        digest = tags.get(name, name)
        stored = registry.manifests.get((repository, digest))
        if stored is None:
            self._answer(404, b'{"errors": [{"code": "MANIFEST_UNKNOWN", "message": "manifest unknown"}]}')
        elif self.command == "DELETE" and name in tags:
            del tags[name]
            self._answer(202)
        elif self.command == "DELETE":
            del registry.manifests[repository, digest]
            registry.tags[repository] = {tag: value for tag, value in tags.items() if value != digest}
            self._answer(202)
        else:
            self._answer(200, stored[1], {"Content-Type": stored[0], "Docker-Content-Digest": digest})

    def _unknown(self, repository: str, content: dict[str, Any]) -> list[str]:
        """What a manifest names that is not in its repository, as far as registries look."""
        blobs = [item["digest"] for item in (*content.get("layers", ()), *filter(None, [content.get("config")]))]
        images = [item["digest"] for item in content.get("manifests", ())]
        registry = self.registry
        lacking = [name for name in blobs if (repository, name) not in registry.blobs]
        return lacking + [name for name in images if (repository, name) not in registry.manifests]

    def _tags(self, repository: str, name: str, query: dict[str, str], body: bytes) -> None:
        tags = sorted(self.registry.tags.get(repository, {}))
        if not tags:
            self._answer(404)
            return
        rest = [tag for tag in tags if tag > query.get("last", "")]
        shown, link = rest[: self.registry.page], {}
        if len(rest) > len(shown):
            link = {"Link": f'</v2/{repository}/tags/list?n={self.registry.page}&last={shown[-1]}>; rel="next"'}
        self._answer(200, json.dumps({"tags": shown}).encode(), link)

    def _referrers(self, repository: str, name: str, query: dict[str, str], body: bytes) -> None:
        if self.registry.people:
            self._answer(303, b"", {"Location": f"{self.registry.people}/{repository}/referrers"})
            return
        if not self.registry.referrers:
            self._answer(404)
            return
        entries = []
        for (where, digest), (media_type, data) in self.registry.manifests.items():
            content = json.loads(data)
            if where == repository and content.get("subject", {}).get("digest") == name:
                entry = {"mediaType": media_type, "digest": digest, "size": len(data)}
                entries.append({**entry, "artifactType": content["artifactType"]})
        self._answer(200, encoded({"schemaVersion": 2, "mediaType": INDEX, "manifests": entries}))

    def log_message(self, format: str, *args: object) -> None:
        pass


class _Server(ThreadingHTTPServer):
    daemon_threads = True

    def handle_error(self, request: Any, client_address: Any) -> None:
        if not isinstance(sys.exc_info()[1], ssl.SSLError | ConnectionError):  # a client may hang up
            super().handle_error(request, client_address)


@contextmanager
def local_registry(tls: ssl.SSLContext | None = None) -> Iterator[LocalRegistry]:
    """A registry that answers as long as this, over TLS if there is a context."""
    registry = LocalRegistry()
    handler = type("Handler", (_Handler,), {"registry": registry})
    with _Server(("127.0.0.1", 0), handler) as server:
        registry.address = f"127.0.0.1:{server.server_port}"
        if tls:
            server.socket = tls.wrap_socket(server.socket, server_side=True, do_handshake_on_connect=False)
        threading.Thread(target=server.serve_forever, kwargs={"poll_interval": 0.01}, daemon=True).start()
        yield registry
        server.shutdown()
