"""Authenticates requests to one registry, by a name and password or by a token.

The credentials of a registry go only to that registry, and to the token server that it names in its own answer. A host
that it redirects to cannot name a token server.
"""

from __future__ import annotations

import base64
import re
import threading
import time
from collections import defaultdict
from collections.abc import Callable

import httpx
from pydantic import ValidationError

from rosml.base import untrusted, web
from rosml.base.errors import RosmlError
from rosml.base.units import duration
from rosml.registry import answers, challenge, failures
from rosml.registry.answers import Answer
from rosml.registry.challenge import Challenge
from rosml.registry.credentials import Credentials
from rosml.registry.documents import Token
from rosml.registry.failures import Denied, Transient, http_errors

TOKEN_BYTES = 256 << 10
"""Largest answer of a token server. A token has some thousand characters."""

TOKEN_SECONDS = 60.0
"""Used if the token server does not say how long a token is valid."""

LONGEST = 86400.0
"""The most seconds that a token is kept."""

DENIED_SECONDS = 5.0
"""After the token server denied a read-only scope, it is not asked for this scope again for so many seconds. An empty
registry would deny thousands of reads at once. The time is short because another machine may create the repository."""


class Login:
    """Safe to share among threads."""

    def __init__(
        self, host: str, base: httpx.URL, client: httpx.Client, find: Callable[[str], Credentials | None]
    ) -> None:
        self.host = host
        self.credentials: Credentials | None = None  # until the registry asks for them, or if there are none
        self._base, self._client, self._find = base, client, find
        self._searched = False
        self._challenge: Challenge | None = None
        self._tokens: dict[frozenset[str], tuple[str, float]] = {}
        self._denied: dict[frozenset[str], tuple[RosmlError, float]] = {}
        self._lock = threading.Lock()  # guards the state of this object; never held during a request
        self._asking: defaultdict[frozenset[str], threading.Lock] = defaultdict(threading.Lock)  # no scope: the log-in
        self._logged_in = False  # the token server has accepted the credentials

    def challenged(self, answer: httpx.Response) -> bool:
        """Whether an answer comes from the registry itself and asks for credentials, in a known scheme."""
        if answer.status_code != 401 or web.origin(answer.url) != web.origin(self._base):
            return False
        new = challenge.read(answer.headers.get_list("www-authenticate"))
        with self._lock:
            self._challenge = new or self._challenge
        return new is not None

    def header(self, address: httpx.URL, scopes: frozenset[str], refused: str) -> str:
        """The header `Authorization` for a request; empty for another host, or if the registry has not asked for credentials.

        `refused` is the header that the registry just refused, or empty. Raises Transient if the token server is busy, or denies a scope to
        a known account.
        """
        with self._lock:
            demand = self._challenge
        if demand is None or web.origin(address) != web.origin(self._base):
            return ""
        if demand.bearer and (header := self._kept(scopes, refused)):
            return header
        with self._turn(frozenset()):  # one thread runs the program that keeps passwords
            if not self._searched:
                self.credentials, self._searched = self._find(self.host), True
        if not demand.bearer:
            if self.credentials is None:
                raise self.denied("log in", "it asks for a user's name and a password")
            pair = f"{self.credentials.username}:{self.credentials.password}"
            return f"Basic {base64.b64encode(pair.encode()).decode()}"
        with self._turn(scopes):  # one thread asks for all threads that need the same token
            return self._kept(scopes, refused) or self._new(demand, scopes, bool(refused))

    def _new(self, demand: Challenge, scopes: frozenset[str], was_refused: bool) -> str:
        try:
            token, seconds = self._token(demand, scopes | demand.scopes if was_refused else scopes)
        except Denied as denied:
            if all(scope.endswith(":pull") for scope in scopes):
                with self._lock:
                    self._denied[scopes] = (denied.error, time.monotonic() + DENIED_SECONDS)
            raise
        with self._lock:
            self._tokens[scopes] = (token, time.monotonic() + 0.8 * seconds)
        return f"Bearer {token}"

    def reconsider(self, scopes: frozenset[str]) -> None:
        """Forgets that scopes were denied, because the repository exists now."""
        with self._lock:
            self._denied.pop(scopes, None)

    def denied(self, action: str, answer: str) -> RosmlError:
        account = "with the account that is logged in" if self.credentials else "without an account"
        remedy = f"docker login {self.host}, with an account that has access; or check that the repository exists"
        return RosmlError(f"{self.host}: access denied: cannot {action} {account} ({answer})", remedy)

    def slower(self, seconds: float) -> str:
        """The remedy for too many requests. `seconds` is the wait that the registry asks for, or 0."""
        wait = f"wait {duration(seconds)}, as it asks" if seconds > 0 else "wait some minutes"
        login = f", or log in, since accounts may ask more often: docker login {self.host}"
        return f"{wait}{'' if self.credentials else login}; then run it again, what is finished is kept"

    def _turn(self, scopes: frozenset[str]) -> threading.Lock:
        with self._lock:
            return self._asking[scopes]

    def _kept(self, scopes: frozenset[str], refused: str) -> str:
        """The header with the kept token for some scopes, or empty. Raises Denied if the token server denied them a moment ago."""
        with self._lock:
            token, end = self._tokens.get(scopes, ("", 0.0))
            denied, until = self._denied.get(scopes, (None, 0.0))
        header, now = f"Bearer {token}", time.monotonic()
        if token and header != refused and now <= end:
            return header
        if denied and now <= until:
            raise Denied(denied)
        return ""

    def _realm(self, demand: Challenge) -> httpx.URL:
        """The address of the token server, if credentials may go there."""
        try:
            realm = web.joined(self._base, demand.realm)
        except web.Unfit:
            text = f"{self.host} does not say where to ask for a token"
            raise RosmlError(text, "check the registry's configuration") from None
        plain = realm.scheme == "http" and not is_local(realm.host)
        if realm.scheme != "https" and (self._base.scheme == "https" or (plain and realm.host != self._base.host)):
            raise RosmlError(f"{self.host} wants passwords sent in the clear, to {realm.host}", "use another registry")
        return realm

    def _token(self, demand: Challenge, scopes: frozenset[str]) -> tuple[str, float]:
        """A Bearer token, and how many seconds it is valid."""
        realm, account = self._realm(demand), self.credentials
        fields = {"service": demand.service} if demand.service else {}
        with http_errors("asking for a token at", realm):
            if account and account.identity_token:
                grant = {"grant_type": "refresh_token", "refresh_token": account.identity_token, "client_id": "rosml"}
                data = {**fields, **grant, "scope": " ".join(sorted(scopes))}
                request, password = self._client.build_request("POST", realm, data=data), None
            else:
                query = [*realm.params.multi_items(), *fields.items(), *(("scope", item) for item in sorted(scopes))]
                request = self._client.build_request("GET", realm.copy_with(params=query))
                password = httpx.BasicAuth(account.username, account.password) if account else None
            response = self._client.send(request, stream=True, auth=password, follow_redirects=False)
            answer = answers.whole(response, TOKEN_BYTES)
        text = f"asking for a token: {answer.status_code}"
        if answer.status_code in web.BUSY:
            raise Transient(text, web.after(answer.headers))
        if answer.status_code == 403 and account and scopes:
            with self._turn(frozenset()):
                if not self._logged_in:  # if this request without a repository fails, the log-in itself is wrong
                    self._token(demand, frozenset())
            raise Denied(self.denied(f"have {' '.join(sorted(scopes))}", text))
        if not answer.is_success:
            raise self.denied("log in", text)
        self._logged_in = True
        return self._read(answer)

    def _read(self, answer: Answer) -> tuple[str, float]:
        try:
            document = Token.model_validate(untrusted.json_object(answer.content, TOKEN_BYTES))
        except ValidationError:
            raise failures.unfit("GET", answer.url, "its answer is not that of a token server") from None
        token, seconds = document.token or document.access_token or "", document.expires_in
        if not re.fullmatch(r"[\x21-\x7e]+", token):
            text = f"{self.host} asks for a token, but gave none that can be sent"
            raise RosmlError(text, "run it again; if it fails again, its operator has to correct the token server")
        has_end = isinstance(seconds, int | float) and seconds > 0
        return token, min(float(seconds), LONGEST) if has_end else TOKEN_SECONDS


def is_local(name: str) -> bool:
    """Whether a host, with or without a port, is this machine itself."""
    name = name.rpartition(":")[0] if re.search(r":[0-9]+$", name) and name != "::1" else name
    return name in ("localhost", "[::1]", "::1") or re.fullmatch(r"127(\.[0-9]+){3}", name) is not None
