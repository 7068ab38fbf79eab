"""The one issue at GitHub, on a server that answers as GitHub's does."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from fakes.hostile import Hostile, hostile, reply
from rosml.cli import command
from rosml.cli.images import publish
from rosml.images.publish import issue

TOKEN = "ghs_secret"
OURS = {"number": 2, "title": issue.TITLE, "html_url": "https://github.example/2"}
ISSUES = "/repos/me/images/issues"


@pytest.fixture
def forge(monkeypatch: pytest.MonkeyPatch) -> Iterator[Hostile]:
    with hostile() as server:
        monkeypatch.setenv("GITHUB_API_URL", f"http://{server.address}")
        monkeypatch.setenv("GITHUB_REPOSITORY", "me/images")
        monkeypatch.setenv("GITHUB_TOKEN", TOKEN)
        yield server


def keep(folder: Path, text: str, unpublished: int) -> int:
    """`rosml publish issue`."""
    (folder / "night.md").write_text(text)
    return command.run(publish.main, arguments=("issue", str(folder / "night.md"), "--open", str(unpublished)))


@pytest.mark.parametrize(
    ("is_open", "unpublished", "request_line", "fields"),
    [
        (False, 3, f"POST {ISSUES}", {"title": issue.TITLE, "labels": [issue.LABEL]}),
        (True, 2, f"PATCH {ISSUES}/2", {}),
        (True, 0, f"PATCH {ISSUES}/2", {"state": "closed"}),
        (False, 0, "", {}),
    ],
)
def test_one_issue_is_opened_brought_up_to_date_and_closed(
    forge: Hostile, tmp_path: Path, is_open: bool, unpublished: int, request_line: str, fields: dict[str, Any]
) -> None:
    issues = [{"number": 1, "title": "Something else"}, *([OURS] if is_open else [])]
    forge.answers = {
        rf"GET {ISSUES}\?labels=nightly&state=open": reply(200, json.dumps(issues).encode()),
        "POST|PATCH": reply(200, json.dumps(OURS).encode()),
    }
    assert keep(tmp_path, "x" * 90_000, unpublished) == 0
    changes = [(name, json.loads(body)) for (name, _), body in zip(forge.requests[1:], forge.bodies[1:], strict=True)]
    assert changes == ([(request_line, {**fields, "body": "x" * issue.LONGEST})] if request_line else [])
    assert all(headers["authorization"] == f"Bearer {TOKEN}" for _, headers in forge.requests)


@pytest.mark.parametrize(
    ("code", "body", "error"),
    [
        (403, b"{}", "HTTP 403"),
        (200, b"<html>", "answers GET issues with"),
        (200, b'[{"number": "x"}]', "something else than an issue"),
        (302, b"", "HTTP 302"),
    ],
)
def test_what_goes_wrong_is_told(
    code: int, body: bytes, error: str, forge: Hostile, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    forge.answers = {".": reply(code, body)}
    assert keep(tmp_path, "3 failed", 3) == 1
    printed = capsys.readouterr().err
    assert error in printed and "remedy:" in printed and TOKEN not in printed
    assert [request.split("?")[0] for request, _ in forge.requests] == [f"GET {ISSUES}"]


@pytest.mark.parametrize("repository", ["", "me/images/..", "me/im ages"])
def test_outside_of_github_there_is_no_issue(
    repository: str, forge: Hostile, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("GITHUB_REPOSITORY", repository)
    assert keep(tmp_path, "3 failed", 3) == 2
    assert "in a job of GitHub Actions" in capsys.readouterr().err
