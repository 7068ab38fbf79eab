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
from rosml.base.shapes import Shape
from rosml.registry.documents import Errors
from rosml.registry.failures import without_query

JSON_BYTES = 4 << 20
"""Largest manifest, page of a list or other answer in JSON. Registries take manifests of at most this size."""

SHOWN = 300
"""How many characters of a registry's error message are shown."""


@dataclass(frozen=True)
class Answer:
    """An answer with its body, as it was sent.

    Attributes:
        method: of the request.
        url: of the request, after redirects.
        status_code: by HTTP.
        headers: of the answer.
        content: the body; only the beginning if the answer is an error.
        redirect: the host that the answer redirects to; empty if it does not.
    """

    method: str
    url: httpx.URL
    status_code: int
    headers: httpx.Headers
    content: bytes
    redirect: str = ""

    @property
    def is_success(self) -> bool:
        """Whether the request succeeded."""
        return 200 <= self.status_code < 300


def whole(answer: httpx.Response, limit: int) -> Answer:
    """Reads the body of an answer.

    Args:
        answer: as httpx has it.
        limit: the largest body of a success, in bytes.

    Raises:
        web.Unfit: the body is larger.
        httpx.HTTPError: the body does not arrive.
    """
    content = web.read(answer, limit) if answer.is_success else web.excerpt(answer)
    redirect = answer.next_request.url.host if answer.next_request else ""
    return Answer(answer.request.method, answer.url, answer.status_code, answer.headers, content, redirect)


def reason(answer: Answer) -> str:
    """The registry's error message in brackets; empty if there is none."""
    said = listed(list(dict.fromkeys(error.message or error.code for error in _errors(answer).errors)))
    said = "".join(character if character.isprintable() else " " for character in said)
    return f" ({said[:SHOWN]})" if said.strip() else ""


def codes(answer: Answer) -> set[str]:
    """The error codes of an answer."""
    return {error.code for error in _errors(answer).errors}


def misfit(content: object, shape: type[Shape]) -> str:
    """The first problem of content that has not the form of the specification; empty if it has."""
    try:
        shape.model_validate(content)
    except ValidationError as error:
        return first_of(error)
    return ""


def _errors(answer: Answer) -> Errors:
    try:
        return Errors.model_validate(untrusted.json_object(answer.content, web.EXCERPT) or {})
    except ValidationError:
        return Errors(errors=[])


def json_object(host: str, answer: Answer) -> dict[str, Any]:
    """The JSON object of an answer."""
    try:
        content = untrusted.json_value(answer.content)
    except ValueError as error:
        content, why = None, str(error)
    else:
        why = "it is another value"
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
