"""git for sources: with the user's own configuration, without questions, hooks or other programs.

Secrets reach git through its environment and a private file. They are in no argument, no URL and no message.
"""

from __future__ import annotations

import contextlib
import os
import re
import shlex
import signal
import subprocess
import tempfile
import threading
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from rosml.base import web
from rosml.base.errors import RosmlError
from rosml.containerize.sources import urls
from rosml.machine.git import CLEAN, QUIET


@dataclass(frozen=True)
class Access:
    """Access to private repositories. A key for ssh needs known hosts."""

    https_server: str = ""  # the only one that gets user and password, by https unless it is written as `http://…`
    https_user: str = field(default="", repr=False)
    https_password: str = field(default="", repr=False)
    ssh_key: str = field(default="", repr=False)
    ssh_known_hosts: str = field(default="", repr=False)


Setting = tuple[str, str]
"""A name and a value of git's configuration. If two have the same name, the later one wins; helpers add up."""

_BOILERPLATE = (
    "fatal: Could not read from remote repository",
    "Please make sure you have the correct access rights",
    "and the repository exists",
    "fatal: the remote end hung up",
)
"""git's lines after each failure of ssh."""

_BUSY = re.compile(rf"The requested URL returned error: ({'|'.join(map(str, web.BUSY))})\b")
"""git's message about a server that may answer otherwise a moment later."""


class Failed(Exception):
    """A call of git that failed. `stderr` has no secrets."""

    def __init__(self, stderr: str) -> None:
        super().__init__(stderr)
        self.stderr = stderr

    @property
    def reason(self) -> str:
        lines = [line.strip() for line in self.stderr.splitlines()]
        telling = [line for line in lines if line and not line.startswith(_BOILERPLATE)]
        return re.sub(r"^(fatal|error|remote): ", "", (telling or lines or [""])[-1])

    @property
    def could_not_write(self) -> bool:
        """Whether git could not write, as on a full disk. git often does not say the reason."""
        reasons = ("No space left on device", "Disk quota exceeded", "unable to write")
        return any(text in self.stderr for text in reasons)


SETTINGS = {
    # The same commit gives the same files, whatever the user has set for their own work.
    "core.autocrlf": "false",
    "core.eol": "lf",
    "core.fileMode": "true",
    "core.symlinks": "true",
    "core.sparseCheckout": "false",
    "core.splitIndex": "false",
    "init.defaultObjectFormat": "sha1",
    "filter.lfs.clean": "",
    "filter.lfs.smudge": "",
    "filter.lfs.process": "",
    "filter.lfs.required": "false",
    **QUIET,
    # Give up if a server sends nothing for a minute.
    "http.lowSpeedLimit": "1",
    "http.lowSpeedTime": "60",
}
"""Settings that go before the user's."""

LFS: tuple[Setting, ...] = (
    ("filter.lfs.smudge", "git-lfs smudge -- %f"),
    ("filter.lfs.process", "git-lfs filter-process"),
    ("filter.lfs.required", "true"),
)
"""Settings that replace LFS pointers with their files."""

_DROPPED = re.compile(
    r"GIT_(TRACE.*|CURL_VERBOSE|DIR|WORK_TREE|INDEX_FILE|OBJECT_DIRECTORY|ALTERNATE_OBJECT_DIRECTORIES|COMMON_DIR"
    r"|NAMESPACE|PREFIX|SHALLOW_FILE|GRAFT_FILE|REPLACE_REF_BASE|QUARANTINE_PATH|(NO)?GLOB_PATHSPECS|ICASE_PATHSPECS"
    r"|DEFAULT_HASH|LFS_SKIP_SMUDGE|HTTPS_PASSWORD|SSH_PRIVATE_KEY)|REGISTRY_PASSWORD"
)
"""Variables that name another repository, change what git prints, or hold a secret that git does not need."""

_STOPPING = (signal.SIGHUP, signal.SIGINT, signal.SIGTERM)
"""Signals from users: git leaves a repository undamaged then."""

_HELPER = (
    '!f() { test "$1" != get || printf "username=%s\\npassword=%s\\n" "$ROSML_GIT_USER" "$ROSML_GIT_PASSWORD"; }; f'
)
_SSH = "ssh -o BatchMode=yes -o ConnectTimeout=30 -o ServerAliveInterval=15"


class Git:
    """Calls git. Threads may call it at the same time."""

    def __init__(self, folder: Path, environment: Mapping[str, str], settings: Iterable[Setting], hidden: str) -> None:
        self._folder = folder
        self._environment = dict(environment)
        self._settings = tuple(settings)
        self._hidden = hidden
        self._running: set[subprocess.Popen[bytes]] = set()
        self._guard = threading.Lock()
        self._stopped = False

    @property
    def path(self) -> str:
        return self._environment.get("PATH", os.defpath)

    def __call__(
        self,
        *arguments: str,
        stdin: bytes = b"",
        settings: Iterable[Setting] = (),
        environment: Mapping[str, str] | None = None,
    ) -> str:
        """Returns git's output. If a server is too busy, asks again. Raises Failed."""
        attempt = 0
        while True:
            attempt += 1
            try:
                return self._call(arguments, stdin, settings, environment or {})
            except Failed as error:
                if not _BUSY.search(error.stderr) or not web.waited(attempt):
                    raise

    def _call(
        self, arguments: Sequence[str], stdin: bytes, settings: Iterable[Setting], environment: Mapping[str, str]
    ) -> str:
        options = [word for name, value in (*self._settings, *settings) for word in ("-c", f"{name}={value}")]
        try:
            process = subprocess.Popen(
                ["git", *options, *arguments],
                cwd=self._folder,
                env={**self._environment, **environment},
                umask=0o022,
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=subprocess.PIPE,
            )
        except FileNotFoundError:
            raise RosmlError("git is not installed", "install it: apt-get install git") from None
        with self._guard:
            self._running.add(process)
            if self._stopped:
                process.terminate()
        try:
            out, err = process.communicate(stdin)
        finally:
            with self._guard:
                self._running.discard(process)
        if process.returncode and (self._stopped or -process.returncode in _STOPPING):
            raise RosmlError("git was stopped", "run it again")
        if process.returncode:
            raise Failed(self._shown(err.decode(errors="replace")) or f"exit code {process.returncode}")
        return out.decode(errors="surrogateescape")

    def stop(self) -> None:
        """Ends the calls of all threads, and their later ones."""
        with self._guard:
            self._stopped = True
            for process in self._running:
                process.terminate()

    def _shown(self, text: str) -> str:
        """A text without secrets: ours, and those in URLs of the user's configuration."""
        if self._hidden:
            text = text.replace(self._hidden, "***")
        return re.sub(r"(?<=://)[^/@\s]+@", "", text).strip()


@contextlib.contextmanager
def opened(access: Access, folder: Path) -> Iterator[Git]:
    """git with access to private repositories, in a folder. The file with the key is removed at the end."""
    credentials, variables = _https(access)
    environment = {
        **{name: value for name, value in os.environ.items() if not _DROPPED.fullmatch(name)},
        **CLEAN,
        "GIT_ALLOW_PROTOCOL": ":".join(urls.PROTOCOLS),
        "GIT_PROTOCOL_FROM_USER": "0",
        "GIT_CEILING_DIRECTORIES": str(folder.resolve().parent),
        "GIT_LITERAL_PATHSPECS": "1",
        **variables,
    }
    settings = (*SETTINGS.items(), *credentials)
    hidden = variables.get("ROSML_GIT_PASSWORD", "")
    with tempfile.TemporaryDirectory(prefix="rosml-") as private:
        command = _ssh(access, Path(private))
        if not command and not _has_ssh(Git(folder, environment, settings, hidden), environment):
            command = _SSH
        if command:
            environment |= {"GIT_SSH_COMMAND": command, "GIT_SSH_VARIANT": "ssh"}
        yield Git(folder, environment, settings, hidden)


def _has_ssh(git: Git, environment: Mapping[str, str]) -> bool:
    if environment.get("GIT_SSH_COMMAND") or environment.get("GIT_SSH"):
        return True
    try:
        return bool(git("config", "--get", "core.sshCommand"))
    except Failed:  # not set
        return False


def _https(access: Access) -> tuple[tuple[Setting, ...], dict[str, str]]:
    """Settings and variables that give user and password to one server. The user's own helpers see neither, and store neither."""
    user, password = access.https_user.strip(), access.https_password.strip("\r\n")
    if not password:
        return (), {}
    server = access.https_server.strip().rstrip("/")
    server = server if server.startswith("http://") else f"https://{server.removeprefix('https://')}"
    if not re.fullmatch(r"https?://[A-Za-z0-9._:\[\]-]+", server):
        text = f"{access.https_server!r} is no server" if access.https_server else "no server for GIT_HTTPS_PASSWORD"
        raise RosmlError(text, "set GIT_HTTPS_SERVER to the name of a host, such as github.com", exit_code=2)
    if not (user + password).isprintable():
        text = "GIT_HTTPS_USER or GIT_HTTPS_PASSWORD has several lines"
        raise RosmlError(text, "give each of them in one line", exit_code=2)
    name = f"credential.{server}.helper"
    settings = (name, ""), (name, _HELPER)  # the empty one drops helpers before it
    return settings, {"ROSML_GIT_USER": user or "git", "ROSML_GIT_PASSWORD": password}


def _ssh(access: Access, private: Path) -> str:
    """The command for ssh; empty if the user's own counts."""
    key, hosts = access.ssh_key.strip(), access.ssh_known_hosts.strip()
    if key and not hosts:
        text = "a key for ssh without the keys of the hosts that it is for"
        raise RosmlError(text, "set GIT_SSH_KNOWN_HOST_KEYS to what this prints: ssh-keyscan HOST", exit_code=2)
    if not hosts:
        return ""
    command = [_SSH, "-o StrictHostKeyChecking=yes", "-o GlobalKnownHostsFile=/dev/null"]
    command += ["-o", shlex.quote(f'UserKnownHostsFile="{_file(private / "known_hosts", hosts)}"')]
    if key:
        command += ["-o IdentitiesOnly=yes", "-o IdentityAgent=none", "-i", shlex.quote(_file(private / "key", key))]
    return " ".join(command)


def _file(file: Path, text: str) -> str:
    """Writes a private file, with line breaks that a variable may have lost. Returns its name, quoted for ssh."""
    lines = text.replace("\\n", "\n").replace("\r", "").strip()
    descriptor = os.open(file, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600)
    with os.fdopen(descriptor, "w", encoding="utf-8") as stream:
        stream.write(f"{lines}\n")
    return str(file).replace("%", "%%")
