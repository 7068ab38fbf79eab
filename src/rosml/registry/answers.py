"""Answers of registries, with bodies of a limited size, and their error messages."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import httpx
from pydantic import ValidationError

from rosml.base import untrusted, web
from rosml.base.errors import RosmlError
from rosml.base.problems import first_of, listed
from rosml.registry.documents import Errors
from rosml.registry.failures import without_query

JSON_BYTES = 4 << 20
"""Largest manifest, page of a list or other answer in JSON. Registries take manifests of at most this size."""

SHOWN = 300
"""The most characters of a registry's error message."""


@dataclass(frozen=True)
class Answer:
    """An answer to `method` at `url`, after redirects. `redirect` is the host of a redirect that was not followed."""

    method: str
    url: httpx.URL
    status_code: int
    headers: httpx.Headers
    content: bytes
    redirect: str = ""

    @property
    def is_success(self) -> bool:
        return 200 <= self.status_code < 300


def whole(answer: httpx.Response, limit: int) -> Answer:
    """Reads the body of an answer, up to `limit` bytes if it is a success; of an error, only the beginning."""
    content = web.read(answer, limit) if answer.is_success else web.excerpt(answer)
    redirect = answer.next_request.url.host if answer.next_request else ""
    return Answer(answer.request.method, answer.url, answer.status_code, answer.headers, content, redirect)


def reason(answer: Answer) -> str:
    """The registry's error message in brackets; empty if there is none."""
    text = listed(list(dict.fromkeys(error.message or error.code for error in _errors(answer).errors)))
    text = "".join(character if character.isprintable() else " " for character in text)
    return f" ({text[:SHOWN]})" if text.strip() else ""


def codes(answer: Answer) -> set[str]:
    return {error.code for error in _errors(answer).errors}


def _errors(answer: Answer) -> Errors:
    try:
        return Errors.model_validate(untrusted.json_object(answer.content, web.EXCERPT) or {})
    except ValidationError:
        return Errors(errors=[])


def json_object(host: str, answer: Answer) -> dict[str, Any]:
    content, why = None, "it is another value"
    try:
        content = untrusted.json_value(answer.content)
    except ValueError as error:
        why = str(error)
    if not isinstance(content, dict):
        raise RosmlError(
            f"{host}: the answer to GET {without_query(answer.url)} is no JSON object, so no registry gave it: {why}",
            "check the address, and HTTPS_PROXY: a proxy may answer instead, for example with a sign-in page",
        )
    return content


@contextlib.contextmanager
def well_formed(host: str, answer: Answer) -> Iterator[None]:
    """Turns the validation error of an answer into a RosmlError."""
    try:
        yield
    except ValidationError as error:
        text = f"{host} does not answer as a registry: GET {answer.url.path}: {first_of(error)}"
        remedy = "check its name and the proxies (HTTPS_PROXY); if they are right, push the damaged content again"
        raise RosmlError(text, remedy) from None
