"""The one issue at GitHub, on a server that answers as GitHub's does."""

from __future__ import annotations

import json
import threading
from collections.abc import Iterator
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any

import pytest

from rosml.cli import command
from rosml.cli.images import publish
from rosml.images.publish import issue

TOKEN = "ghs_secret"


class Forge(ThreadingHTTPServer):
    """Issues by number. `code`: what each request is answered with, unless it is 0; `body`: with which text."""

    def __init__(self) -> None:
        super().__init__(("127.0.0.1", 0), Handler)
        self.issues: dict[int, dict[str, Any]] = {}
        self.code, self.body = 0, b""

    @property
    def address(self) -> str:
        return f"http://127.0.0.1:{self.server_port}"


class Handler(BaseHTTPRequestHandler):
    server: Forge

    def log_message(self, *_: object) -> None:
        pass

    def do_GET(self) -> None:
        assert self.path.startswith("/repos/me/images/issues?labels=nightly&state=open")
        self.answer(200, [item for item in self.server.issues.values() if item["state"] == "open"])

    def do_POST(self) -> None:
        self.change(len(self.server.issues) + 1, {"state": "open"}, 201)

    def do_PATCH(self) -> None:
        self.change(int(self.path.rpartition("/")[2]), {}, 200)

    def change(self, number: int, more: dict[str, Any], code: int) -> None:
        sent = json.loads(self.rfile.read(int(self.headers["Content-Length"])))
        if not self.server.code:
            issue = self.server.issues.get(number, {"number": number, "html_url": f"https://github.example/{number}"})
            self.server.issues[number] = {**issue, **more, **sent}
        self.answer(code, self.server.issues.get(number))

    def answer(self, code: int, content: object) -> None:
        assert self.headers["Authorization"] == f"Bearer {TOKEN}"
        data = self.server.body or json.dumps(content).encode()
        self.send_response(self.server.code or code)
        self.send_header("Content-Length", str(len(data)))
        self.end_headers()
        self.wfile.write(data)


@pytest.fixture
def forge(monkeypatch: pytest.MonkeyPatch) -> Iterator[Forge]:
    with Forge() as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        monkeypatch.setenv("GITHUB_API_URL", server.address)
        monkeypatch.setenv("GITHUB_REPOSITORY", "me/images")
        monkeypatch.setenv("GITHUB_TOKEN", TOKEN)
        yield server
        server.shutdown()


def keep(folder: Path, text: str, unpublished: int) -> int:
    """`rosml publish issue`."""
    (folder / "night.md").write_text(text)
    return command.run(publish.main, arguments=("issue", str(folder / "night.md"), "--open", str(unpublished)))


def test_one_issue_is_opened_brought_up_to_date_and_closed(forge: Forge, tmp_path: Path) -> None:
    forge.issues[1] = {"number": 1, "state": "open", "title": "Something else", "body": "theirs"}
    for text, unpublished in (("3 failed", 3), ("2 failed " + "x" * 90_000, 2), ("all well", 0), ("all well", 0)):
        assert keep(tmp_path, text, unpublished) == 0
    ours = forge.issues[2]
    assert (ours["title"], ours["labels"]) == (issue.TITLE, [issue.LABEL])
    assert (ours["state"], ours["body"]) == ("closed", "all well")
    assert len(forge.issues) == 2 and forge.issues[1]["body"] == "theirs"
    assert keep(tmp_path, "broken again", 1) == 0
    assert forge.issues[3]["state"] == "open" and forge.issues[2]["state"] == "closed"
    keep(tmp_path, "x" * 90_000, 1)
    assert len(forge.issues[3]["body"]) == issue.LONGEST


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
    code: int, body: bytes, error: str, forge: Forge, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    forge.code, forge.body = code, body
    assert keep(tmp_path, "3 failed", 3) == 1
    printed = capsys.readouterr().err
    assert error in printed and "remedy:" in printed and TOKEN not in printed
    assert not forge.issues


@pytest.mark.parametrize("repository", ["", "me/images/..", "me/im ages"])
def test_outside_of_github_there_is_no_issue(
    repository: str, forge: Forge, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("GITHUB_REPOSITORY", repository)
    assert keep(tmp_path, "3 failed", 3) == 2
    assert "in a job of GitHub Actions" in capsys.readouterr().err
