"""Answers of registries, with bodies of a limited size, and what they say about an error."""

from __future__ import annotations

from dataclasses import dataclass

import httpx
from pydantic import BaseModel, ValidationError

from rosml.base import untrusted, web
from rosml.base.problems import first_of, listed
from rosml.registry.documents import Errors

JSON_BYTES = 4 << 20
"""Largest manifest, page of a list or other answer in JSON. Registries take manifests of at most this size."""

SHOWN = 300
"""Characters of what a registry says about an error."""


@dataclass(frozen=True)
class Answer:
    """An answer with all of its body, as it was sent. Of an error, that is the beginning.

    Attributes:
        method, url: of the request that it answers, after redirects. redirect: the host that it redirects to; empty for none.
    """

    method: str
    url: httpx.URL
    status_code: int
    headers: httpx.Headers
    content: bytes
    redirect: str = ""

    @property
    def is_success(self) -> bool:
        """Whether it is what was asked for."""
        return 200 <= self.status_code < 300


def whole(answer: httpx.Response, limit: int) -> Answer:
    """An answer with its body.

    Args:
        limit: the largest size of the body of a success, in bytes.

    Raises:
        web.Unfit: it is larger. httpx.HTTPError: it does not arrive.
    """
    content = web.read(answer, limit) if answer.is_success else web.excerpt(answer)
    redirect = answer.next_request.url.host if answer.next_request else ""
    return Answer(answer.request.method, answer.url, answer.status_code, answer.headers, content, redirect)


def reason(answer: Answer) -> str:
    """What a registry says about an error, in brackets; nothing if it says nothing."""
    said = listed(list(dict.fromkeys(error.message or error.code for error in _errors(answer).errors)))
    said = "".join(character if character.isprintable() else " " for character in said)
    return f" ({said[:SHOWN]})" if said.strip() else ""


def codes(answer: Answer) -> set[str]:
    """The codes of the errors of an answer."""
    return {error.code for error in _errors(answer).errors}


def misfit(content: object, shape: type[BaseModel]) -> str:
    """What of an answer has another form than the specification gives it; empty if nothing has."""
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
