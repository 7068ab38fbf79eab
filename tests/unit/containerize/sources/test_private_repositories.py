"""Sources from private servers, by https and ssh: who gets secrets, and what an error says about them."""

from __future__ import annotations

import base64
import contextlib
import http.server
import os
import re
import shutil
import ssl
import subprocess
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path

import pytest
import trustme

from fakes.repositories import GIT, NOBODY, SECRET, Place, commit, git, place, repos, with_submodule
from fakes.stubs import executable
from rosml.base import web
from rosml.containerize.sources import fetch as sources
from rosml.containerize.sources.git import Access, Failed, opened

__all__ = ["place"]


def no_secret(place: Place, secret: str = SECRET) -> None:
    """Checks all that is on the disk, the arguments of programs among it, and all sentences."""
    files = [file for file in place.root.rglob("*") if file.is_file() and not file.is_symlink()]
    assert [file for file in files if secret.encode() in file.read_bytes()] == []
    assert secret not in "".join(place.sentences)


def test_git_gets_no_secret_that_it_does_not_need(place: Place, monkeypatch: pytest.MonkeyPatch) -> None:
    place.a()
    place.program("git", f'export -p >>{place.root}/environment\nexec {GIT} "$@"')
    for name in ("GIT_HTTPS_PASSWORD", "GIT_SSH_PRIVATE_KEY", "REGISTRY_PASSWORD"):
        monkeypatch.setenv(name, SECRET)
    place.fetch()
    environment = (place.root / "environment").read_text()
    assert "GIT_NO_LAZY_FETCH" in environment
    assert re.search(r"GIT_TERMINAL_PROMPT=['\"]?0\b", environment), "nobody is there to answer"
    no_secret(place)


def test_a_password_that_a_server_echoes_is_not_shown(place: Place) -> None:
    place.put(repos(a=("https://git.example.org/a", "main")))
    place.program("git", 'echo "fatal: remote: who is $ROSML_GIT_PASSWORD?" >&2; exit 1')
    error = place.refused(Access(https_server="git.example.org", https_user="me", https_password=SECRET))
    assert "who is ***?" in error.message


class _Backend(http.server.BaseHTTPRequestHandler):
    """`git http-backend` behind a password."""

    root = Path()
    users: list[str]

    def do_GET(self) -> None:
        sent = self.headers.get("Authorization", "")
        user = base64.b64decode(sent.removeprefix("Basic ")).decode() if sent else ""
        self.users.append(user)
        if user != f"robot:{SECRET}":
            self.send_response(401)
            self.send_header("WWW-Authenticate", 'Basic realm="private"')
            self.send_header("Content-Length", "0")
            self.end_headers()
            return
        path, _, query = self.path.partition("?")
        environment = {
            **os.environ,
            "GIT_PROJECT_ROOT": str(self.root),
            "GIT_HTTP_EXPORT_ALL": "1",
            "PATH_INFO": path,
            "QUERY_STRING": query,
            "REQUEST_METHOD": self.command,
            "CONTENT_TYPE": self.headers.get("Content-Type", ""),
            "HTTP_CONTENT_ENCODING": self.headers.get("Content-Encoding", ""),
            "GIT_PROTOCOL": self.headers.get("Git-Protocol", ""),
        }
        body = self.rfile.read(int(self.headers.get("Content-Length", 0)))
        done = subprocess.run(["git", "http-backend"], input=body, env=environment, capture_output=True, check=True)
        head, _, content = done.stdout.partition(b"\r\n\r\n")
        fields = dict(line.split(": ", 1) for line in head.decode().split("\r\n"))
        self.send_response(int(fields.pop("Status", "200").split()[0]))
        for name, value in fields.items():
            self.send_header(name, value)
        self.send_header("Content-Length", str(len(content)))
        self.end_headers()
        self.wfile.write(content)

    do_POST = do_GET

    def log_message(self, format: str, *args: object) -> None:
        """Says nothing."""


@contextmanager
def serving(root: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[tuple[str, list[str]]]:
    """An https server of the repositories in a folder, which git trusts: its address, and the users that called it."""
    authority = trustme.CA()
    authority.cert_pem.write_to_path(root / "ca.pem")
    monkeypatch.setenv("GIT_SSL_CAINFO", str(root / "ca.pem"))
    tls = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
    authority.issue_cert("127.0.0.1").configure_cert(tls)
    users: list[str] = []
    handler = type("Handler", (_Backend,), {"root": root, "users": users})
    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
        server.socket = tls.wrap_socket(server.socket, server_side=True)
        threading.Thread(target=server.serve_forever, daemon=True).start()
        try:
            yield f"127.0.0.1:{server.server_address[1]}", users
        finally:
            server.shutdown()


def test_a_private_repository_by_https(place: Place, monkeypatch: pytest.MonkeyPatch) -> None:
    a, sub = place.root / "a", place.root / "sub"
    commit(sub, {"s": "1"})
    commit(a, {"f": "1"})
    version = with_submodule(a, "../sub")
    for url, name in ((a, "a.git"), (sub, "sub")):
        git(place.root, "clone", "--quiet", "--bare", str(url), f"bare/{name}")
    trace = place.trace("[credential]\n\thelper = store\n")
    with serving(place.root, monkeypatch) as (server, users):
        access = Access(https_server=server, https_user="robot", https_password=f"{SECRET}\n")
        place.put(repos(a=(f"https://somebody@{server}/bare/a.git", "main")))
        (repository,) = place.fetch(access)
        assert repository.url == f"https://{server}/bare/a.git" and repository.commit == version
        assert place.read("a/sub/s") == "1"
        assert "git-remote-https" in trace.read_text() and SECRET not in repr(access)
        no_secret(place)

        shutil.rmtree(place.cache)
        for wrong in (NOBODY, replace(access, https_server="127.0.0.1"), replace(access, https_server=f"x{server}")):
            users.clear()
            error = place.refused(wrong)
            assert "could not read Username" in error.message and set(users) == {""}
            assert "check GIT_HTTPS_SERVER, GIT_HTTPS_USER and GIT_HTTPS_PASSWORD too" in error.remedy
        assert "Authentication failed" in place.refused(replace(access, https_user="nobody")).message
        no_secret(place)


def test_a_password_needs_its_server(place: Place) -> None:
    place.put(repos(a=("https://example.org/a", "main")))
    assert "GIT_HTTPS_SERVER" in place.refused(Access(https_password=SECRET)).remedy
    assert "is no server" in place.refused(Access(https_server="a/b", https_password=SECRET)).message
    assert "several lines" in place.refused(Access(https_server="a", https_password=f"{SECRET}\nx")).message


def test_a_server_names_no_repository_of_this_machine(place: Place, monkeypatch: pytest.MonkeyPatch) -> None:
    private, a, b = (place.root / name for name in ("private", "a", "b"))
    commit(private, {"p": "1"})
    commit(a, {"x.repos": repos(private=(private, "main"))})
    commit(b, {"f": "1"})
    with_submodule(b, str(private))
    with serving(place.root, monkeypatch) as (server, _):
        access = Access(https_server=server, https_user="robot", https_password=SECRET)
        for name, begin in (("a", ""), ("b", "the submodule sub: ")):
            place.put(repos(**{name: (f"https://{server}/{name}/.git", "main")}))
            assert f"{begin}the url names a repository of this machine" in place.refused(access).message


KEY = "-----BEGIN OPENSSH PRIVATE KEY-----\ncanary-of-the-key\n-----END OPENSSH PRIVATE KEY-----\n"

SSH = f"""#!{sys.executable}
# Answers as ssh does, as far as options say who is let in.
import os, shlex, stat, sys
words = sys.argv[1:]
options = dict(word.split("=", 1) for word in words if "=" in word)
assert options["BatchMode"] == "yes"
key = words[words.index("-i") + 1] if "-i" in words else ""
if "UserKnownHostsFile" in options:
    assert options["StrictHostKeyChecking"] == "yes"
    if "git.test ssh-ed25519" not in open(options["UserKnownHostsFile"].strip('"')).read():
        sys.exit("No ED25519 host key is known for git.test and you have requested strict checking.\\n"
                 "Host key verification failed.")
with open(os.environ["HOME"] + "/ssh", "a") as log:
    log.write(f"{{key}}\\n")
if key and (open(key, 'rb').read() != {KEY.encode()!r} or stat.S_IMODE(os.stat(key).st_mode) != 0o600):
    sys.exit("git@git.test: Permission denied (publickey).")
assert words[-2] == "git@git.test"
os.execvp("sh", ["sh", "-c", words[-1]])
"""


@pytest.fixture
def ssh(place: Place) -> Path:
    """Puts a program in the place of ssh. Returns its log, with the key of each call."""
    executable(place.root / "programs/ssh", "")
    (place.root / "programs/ssh").write_text(SSH)
    return place.root / "home/ssh"


HOSTS = "git.test ssh-ed25519 AAAA"


@pytest.mark.parametrize("key", [KEY, KEY.strip(), KEY.replace("\n", "\\n"), KEY.replace("\n", "\r\n")])
def test_a_private_repository_by_ssh(place: Place, ssh: Path, key: str) -> None:
    a, _ = place.a()
    place.trace()
    place.put(repos(a=(f"git@git.test:{a}", "main"), b=(f"ssh://git@git.test{a}", "main")))
    access = Access(ssh_key=key, ssh_known_hosts=HOSTS)
    assert [item.url for item in place.fetch(access)] == [f"git@git.test:{a}", f"ssh://git@git.test{a}"]
    keys = set(ssh.read_text().split())
    assert len(keys) == 1 and not any(Path(name).exists() for name in keys)
    (place.root / "programs/ssh").unlink()  # which has the key in it
    assert "canary" not in repr(access)
    no_secret(place, "canary-of-the-key")


def test_without_a_key_the_users_ssh_counts(place: Place, ssh: Path) -> None:
    a, _ = place.a()
    place.put(repos(a=(f"git@git.test:{a}", "main")))
    place.fetch()
    assert ssh.read_text() == "\n" * len(ssh.read_text())
    place.trace("[core]\n\tsshCommand = echo mine >&2; false\n")
    shutil.rmtree(place.cache)
    assert "cannot be read: mine" in place.refused().message


def test_ctrl_c_leaves_no_key(place: Place, ssh: Path) -> None:
    program = place.root / "programs/ssh"
    program.write_text(program.read_text().replace("assert words[-2]", f"os.kill({os.getpid()}, 2); assert words[-2]"))
    a, _ = place.a()
    place.put(repos(a=(f"git@git.test:{a}", "main")))
    with pytest.raises(KeyboardInterrupt):
        place.fetch(Access(ssh_key=KEY, ssh_known_hosts=HOSTS))
    (name,) = ssh.read_text().split()
    assert not Path(name).parent.exists()


def test_ssh_says_what_is_wrong(place: Place, ssh: Path) -> None:
    a, _ = place.a()
    place.put(repos(a=(f"ssh://git@git.test:2222{a}", "main")))
    error = place.refused(Access(ssh_key=KEY, ssh_known_hosts="other.test ssh-ed25519 AAAA"))
    assert "the host key of git.test:2222 is unknown" in error.message
    assert error.remedy.endswith("ssh-keyscan -p 2222 git.test")
    error = place.refused(Access(ssh_key="another key", ssh_known_hosts=HOSTS))
    assert "Permission denied (publickey)" in error.message and "GIT_SSH_PRIVATE_KEY" in error.remedy
    assert not any(Path(name).exists() for name in ssh.read_text().split())
    error = place.refused(Access(ssh_key=KEY))
    assert "ssh-keyscan HOST" in error.remedy and error.exit_code == 2


@pytest.mark.parametrize(("code", "calls"), [(429, 2), (503, 2), (404, 1)])
def test_a_server_that_is_too_busy_is_asked_again(
    place: Place, monkeypatch: pytest.MonkeyPatch, code: int, calls: int
) -> None:
    monkeypatch.setattr(web, "WAIT", 0.001)
    here = place.root
    answer = f"fatal: unable to access 'https://h/a/': The requested URL returned error: {code}"
    once = f"echo x >>{here}/calls; test -e {here}/again && echo done && exit; touch {here}/again"
    place.program("git", f'case "$*" in *ls-remote*) ;; *) exit 1 ;; esac\n{once}; echo "{answer}" >&2; exit 128')
    with opened(NOBODY, here) as call, contextlib.suppress(Failed):
        assert call("ls-remote", "https://h/a") == "done\n"
    assert (here / "calls").read_text() == "x\n" * calls


@pytest.mark.parametrize(
    ("url", "stderr", "remedy"),
    [
        (
            "file:///srv/my robot",
            "fatal: detected dubious ownership in repository at '/srv/my robot'\nTo add an exception, call:",
            "git config --global --add safe.directory '/srv/my robot'",
        ),
        ("/srv/a", "fatal: unsafe repository ('/srv/a' is owned by someone else)", "safe.directory /srv/a"),
        ("git://github.com/me/a.git", "fatal: unable to connect to github.com:", "write https://github.com/me/a.git"),
    ],
)
def test_a_failure_of_git_has_a_remedy(url: str, stderr: str, remedy: str) -> None:
    assert remedy in sources.explained("a.repos:2: a", url, Failed(stderr)).remedy
