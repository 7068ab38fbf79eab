"""One issue on GitHub that says what keeps images from being published. It is closed when all images are published.

Endpoints: https://docs.github.com/en/rest/issues/issues (version 2022-11-28).
"""

from __future__ import annotations

import re
from typing import Any, TypeVar

import httpx
from pydantic import ConfigDict, ValidationError

from rosml.base import untrusted, web
from rosml.base.errors import RosmlError
from rosml.base.shapes import Adapter, Shape, adapter

T = TypeVar("T")

LABEL = "nightly"
"""Setting a label needs write access to the repository, so an issue with this label is ours."""

TITLE = "Images that are not published"

LONGEST = 60_000
"""Characters of an issue's text; GitHub takes 65,536."""

ANSWER_BYTES = 4 << 20
SECONDS = 30.0

_REMEDY = "give the job the permission 'issues: write', or set the variable ROSML_ISSUE=false to have no issue"


class _Issue(Shape):
    model_config = ConfigDict(extra="ignore")

    number: int
    html_url: str = ""
    title: str = ""


_ONE = adapter(_Issue)
_LIST = adapter(list[_Issue])


class Issues:
    """The issues of a repository."""

    def __init__(self, api: str, repository: str, token: str) -> None:
        if not re.fullmatch(r"[\w.-]+/[\w.-]+", repository) or not re.fullmatch(r"https?://[\w.:/-]+", api):
            raise RosmlError(
                f"{repository!r} at {api!r} is no repository", "run it in a job of GitHub Actions", exit_code=2
            )
        headers = {
            "Authorization": f"Bearer {token}",
            "Accept": "application/vnd.github+json",
            "X-GitHub-Api-Version": "2022-11-28",
        }
        self._client = web.client(base_url=f"{api}/repos/{repository}/", headers=headers, timeout=SECONDS)

    def keep(self, text: str, unpublished: int) -> str:
        """Opens or updates the issue; closes it if all images are published. Returns a line that says what was done."""
        query = {"labels": LABEL, "state": "open", "per_page": "100"}
        ours = [issue for issue in self._ask(_LIST, "GET", "issues", params=query) if issue.title == TITLE]
        if not unpublished:
            for issue in ours:
                self._ask(_ONE, "PATCH", f"issues/{issue.number}", json={"state": "closed", "body": text[:LONGEST]})
            return f"closed issue {ours[0].number}: all images are published" if ours else "all images are published"
        if ours:
            self._ask(_ONE, "PATCH", f"issues/{ours[0].number}", json={"body": text[:LONGEST]})
            return f"updated issue {ours[0].number}: {ours[0].html_url}"
        body = {"title": TITLE, "body": text[:LONGEST], "labels": [LABEL]}
        issue = self._ask(_ONE, "POST", "issues", json=body)
        return f"opened issue {issue.number}: {issue.html_url}"

    def _ask(self, kind: Adapter[T], method: str, path: str, **options: Any) -> T:
        try:
            with self._client.stream(method, path, **options) as answer:
                if answer.is_success:
                    return kind.validate_python(untrusted.json_value(web.read(answer, ANSWER_BYTES)))
        except (httpx.HTTPError, httpx.InvalidURL, ValueError) as error:
            reason = "something else than an issue" if isinstance(error, ValidationError) else str(error)
            raise RosmlError(f"GitHub answers {method} {path} with {reason or 'nothing'}", "run it again") from None
        raise RosmlError(f"GitHub refuses {method} {path}: HTTP {answer.status_code}", _REMEDY)
