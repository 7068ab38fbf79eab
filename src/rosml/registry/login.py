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
"""How many seconds a token is used if its server does not say how long it is valid."""

LONGEST = 86400.0
"""How many seconds a token is kept at most."""

DENIED_SECONDS = 5.0
"""After the token server denied a read-only scope, it is not asked for this scope again for so many seconds. An empty
registry would deny thousands of reads at once. The time is short because another machine may create the repository."""


class Login:
    """Authenticates the requests to one registry. Safe to share among threads.

    Attributes:
        host: the registry, as in references.
        credentials: None; None until the registry asks for them, or if there are none.
    """

    def __init__(
        self, host: str, base: httpx.URL, client: httpx.Client, find: Callable[[str], Credentials | None]
    ) -> None:
        """
        Args:
            host: the registry, as in references.
            base: the address of the registry's root.
            client: for the token server.
            find: gives the credentials of a host; it is called once, when the registry asks for them.
        """
        self.host = host
        self.credentials: Credentials | None = None
        self._base, self._client, self._find = base, client, find
        self._asked = False
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
        found = challenge.read(answer.headers.get_list("www-authenticate"))
        with self._lock:
            self._challenge = found or self._challenge
        return found is not None

    def header(self, address: httpx.URL, scopes: frozenset[str], refused: str) -> str:
        """The header `Authorization` for a request; empty for another host, or if the registry has not asked for
        credentials.

        Args:
            address: of the request.
            scopes: what the request needs.
            refused: the header that the registry just refused; empty if it refused none.

        Raises:
            Transient: the token server is busy, or denies a scope to a known account.
            RosmlError: there are no credentials, or the token server refuses them.
        """
        with self._lock:
            wanted = self._challenge
        if wanted is None or web.origin(address) != web.origin(self._base):
            return ""
        if wanted.bearer and (header := self._kept(scopes, refused)):
            return header
        with self._turn(frozenset()):  # one thread runs the program that keeps passwords
            if not self._asked:
                self.credentials, self._asked = self._find(self.host), True
        if not wanted.bearer:
            if self.credentials is None:
                raise self.denied("log in", "it asks for a user's name and a password")
            return (
                "Basic "
                + base64.b64encode(f"{self.credentials.username}:{self.credentials.password}".encode()).decode()
            )
        with self._turn(scopes):  # one thread asks for all threads that need the same token
            if header := self._kept(scopes, refused):
                return header
            try:
                token, seconds = self._token(wanted, scopes | wanted.scopes if refused else scopes)
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

    def denied(self, what: str, said: str) -> RosmlError:
        """The error if access is denied.

        Args:
            what: the denied action.
            said: what the registry said.
        """
        known = "with the account that is logged in" if self.credentials else "without an account"
        remedy = f"docker login {self.host}, with an account that has access; or check that the repository exists"
        return RosmlError(f"{self.host}: access denied: cannot {what} {known} ({said})", remedy)

    def slower(self, seconds: float) -> str:
        """The remedy if the registry says that there were too many requests.

        Args:
            seconds: how long it asks to wait; 0 if it does not say.
        """
        wait = f"wait {duration(seconds)}, as it asks" if seconds > 0 else "wait some minutes"
        more = "" if self.credentials else f", or log in, since accounts may ask more often: docker login {self.host}"
        return f"{wait}{more}; then run it again, what is finished is kept"

    def _turn(self, scopes: frozenset[str]) -> threading.Lock:
        """The lock of threads that need the same scopes."""
        with self._lock:
            return self._asking[scopes]

    def _kept(self, scopes: frozenset[str], refused: str) -> str:
        """The header with the kept token for some scopes; empty if there is none, or it is no longer valid.

        Raises:
            Denied: the token server denied the scopes a moment ago.
        """
        with self._lock:
            token, end = self._tokens.get(scopes, ("", 0.0))
            denied, until = self._denied.get(scopes, (None, 0.0))
        header, now = f"Bearer {token}", time.monotonic()
        if token and header != refused and now <= end:
            return header
        if denied and now <= until:
            raise Denied(denied)
        return ""

    def _realm(self, wanted: Challenge) -> httpx.URL:
        """The address of the token server, if credentials may go there."""
        try:
            realm = web.joined(self._base, wanted.realm)
        except web.Unfit:
            text = f"{self.host} does not say where to ask for a token"
            raise RosmlError(text, "check the registry's configuration") from None
        plain = realm.scheme == "http" and not is_local(realm.host)
        if realm.scheme != "https" and (self._base.scheme == "https" or (plain and realm.host != self._base.host)):
            raise RosmlError(f"{self.host} wants passwords sent in the clear, to {realm.host}", "use another registry")
        return realm

    def _token(self, wanted: Challenge, scopes: frozenset[str]) -> tuple[str, float]:
        """A Bearer token for some scopes, and how many seconds it is valid."""
        realm, known = self._realm(wanted), self.credentials
        fields = {"service": wanted.service} if wanted.service else {}
        with http_errors("asking for a token at", realm):
            if known and known.identity_token:
                grant = {"grant_type": "refresh_token", "refresh_token": known.identity_token, "client_id": "rosml"}
                data = {**fields, **grant, "scope": " ".join(sorted(scopes))}
                request, password = self._client.build_request("POST", realm, data=data), None
            else:
                query = [*realm.params.multi_items(), *fields.items(), *(("scope", item) for item in sorted(scopes))]
                request = self._client.build_request("GET", realm.copy_with(params=query))
                password = httpx.BasicAuth(known.username, known.password) if known else None
            sent = self._client.send(request, stream=True, auth=password, follow_redirects=False)
            answer = answers.whole(sent, TOKEN_BYTES)
        said = f"asking for a token: {answer.status_code}"
        if answer.status_code in web.BUSY:
            raise Transient(said, web.after(answer.headers))
        if answer.status_code == 403 and known and scopes:
            with self._turn(frozenset()):
                if not self._logged_in:  # if this request without a repository fails, the log-in itself is wrong
                    self._token(wanted, frozenset())
            raise Denied(self.denied(f"have {' '.join(sorted(scopes))}", said))
        if not answer.is_success:
            raise self.denied("log in", said)
        self._logged_in = True
        return self._given(answer)

    def _given(self, answer: Answer) -> tuple[str, float]:
        content = untrusted.json_object(answer.content, TOKEN_BYTES)
        if content is None or answers.misfit(content, Token):
            raise failures.unfit("GET", answer.url, "its answer is not that of a token server")
        found = Token.model_validate(content)
        token, seconds = found.token or found.access_token or "", found.expires_in
        if not re.fullmatch(r"[\x21-\x7e]+", token):
            text = f"{self.host} asks for a token, but gave none that can be sent"
            raise RosmlError(text, "run it again; if it fails again, its operator has to correct the token server")
        holds = isinstance(seconds, int | float) and seconds > 0
        return token, min(float(seconds), LONGEST) if holds else TOKEN_SECONDS


def is_local(name: str) -> bool:
    """Whether a host, with or without a port, is this machine itself."""
    name = name.rpartition(":")[0] if re.search(r":[0-9]+$", name) and name != "::1" else name
    return name in ("localhost", "[::1]", "::1") or re.fullmatch(r"127(\.[0-9]+){3}", name) is not None
