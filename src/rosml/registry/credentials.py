"""Finds the user's credentials for a registry as Docker does: in a variable, its config file, and its credential helpers."""

from __future__ import annotations

import base64
import os
import subprocess
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from pydantic import ConfigDict

from rosml import STATE
from rosml.base import untrusted
from rosml.base.errors import RosmlError
from rosml.base.shapes import Shape

DOCKER_HUB = "docker.io"
DOCKER_HUB_KEY = "https://index.docker.io/v1/"

HELPER_SECONDS = 30.0
"""Time limit of a credential helper, which may ask a keychain or a cloud."""

VARIABLE = "DOCKER_AUTH_CONFIG"
"""Has the same content as `auths` in the config file, for jobs in CI. buildx reads it as well."""

OWN = "auth/docker.json"
"""Below `.state`: credentials for the local registry of a checkout, in the form of Docker's config file."""

TOKEN_USER = "<token>"
"""The user name in a helper's answer if the secret is an identity token."""

_REMEDY = "correct it, or log in again: docker login"


@dataclass(frozen=True)
class Credentials:
    """A user's name and password, or an identity token instead. They appear in no message."""

    username: str = field(default="", repr=False)
    password: str = field(default="", repr=False)
    identity_token: str = field(default="", repr=False)


def folder() -> Path | None:
    """The folder of Docker's config file; None if the user has no home folder, as in some containers."""
    if variable := os.environ.get("DOCKER_CONFIG"):
        return Path(variable)
    try:
        return Path.home() / ".docker"
    except RuntimeError:
        return None


def from_docker(host: str) -> Credentials | None:
    """The credentials of a registry, in Docker's order: the variable, the helper of that registry, the helper for all, the config file.

    Only the credentials that `rosml setup` made for the local registry come before the helpers.
    """
    names = (DOCKER_HUB_KEY, DOCKER_HUB) if host == DOCKER_HUB else (host,)
    if login := _from_variable(names):
        return login
    if login := _of(local_file(STATE).get("auths"), names, OWN):
        return login
    docker_folder = folder()
    if docker_folder is None:
        return None
    file = docker_folder / "config.json"
    config = _read(file)
    helpers = _object(config.get("credHelpers"), f"{file}: credHelpers")
    for name in names:
        if helpers.get(name):
            return _helper(_program(helpers[name], file), name)
    if config.get("credsStore"):
        for name in names:
            if login := _helper(_program(config["credsStore"], file), name):
                return login
    return _of(config.get("auths"), names, str(file))


def local_file(state: Path) -> dict[str, Any]:
    """The credentials file that `rosml setup` made for the local registry; empty if there is none, or it is unreadable."""
    try:
        return untrusted.json_object((state / OWN).read_bytes()) or {}
    except OSError:
        return {}


def _from_variable(names: tuple[str, ...]) -> Credentials | None:
    """Messages do not show the variable's text."""
    text = os.environ.get(VARIABLE, "")
    if not text:
        return None
    content = untrusted.json_object(text)
    if content is None:
        remedy = f'set it to {{"auths": {{"{names[-1]}": {{"auth": …}}}}}}, or unset it'
        raise RosmlError(f"{VARIABLE} is no JSON object", remedy, exit_code=2)
    return _of(content.get("auths"), names, VARIABLE)


def _of(auths: Any, names: tuple[str, ...], place: str) -> Credentials | None:
    auths = _object(auths, f"{place}: auths")
    hosts = {_bare(name) for name in names}
    entry = next((entry for name, entry in auths.items() if _bare(name) in hosts), None)
    return _entry(_object(entry, f"{place}: auths of {names[-1]}"), place, names[-1])


def _object(value: Any, what: str) -> dict[str, Any]:
    """A JSON object of the file or the variable; empty if it is null. Messages do not show its text."""
    if value is None or isinstance(value, dict):
        return value or {}
    raise RosmlError(f"{what} is no JSON object", _REMEDY, exit_code=2)


def _read(file: Path) -> dict[str, Any]:
    try:
        config = untrusted.json_object(file.read_bytes())
    except FileNotFoundError:
        return {}
    except OSError as error:
        raise RosmlError(f"cannot read {file}: {error.strerror}", "make it readable, or set DOCKER_CONFIG") from None
    if config is None:
        raise RosmlError(f"{file} is no JSON object", _REMEDY)
    return config


def _bare(name: str) -> str:
    """A key of `auths` without scheme and path, since old versions of Docker wrote both."""
    return name.partition("://")[2].partition("/")[0] if "://" in name else name.partition("/")[0]


class _Entry(Shape):
    model_config = ConfigDict(strict=True)

    auth: str | None = None
    username: str | None = None
    password: str | None = None
    identitytoken: str | None = None


def _entry(entry: Mapping[str, Any], place: str, host: str) -> Credentials | None:
    try:
        login = _Entry.model_validate(entry)
        if login.identitytoken:
            return Credentials(identity_token=login.identitytoken)
        if login.auth:
            username, password = base64.b64decode(login.auth, validate=True).decode().split(":", 1)
            return Credentials(username, password.rstrip("\0"))
    except ValueError:  # also if the text is not ASCII or UTF-8. Messages do not show it
        raise RosmlError(f"{place}: its entry for {host} cannot be read", f"docker login {host}") from None
    return Credentials(login.username, login.password or "") if login.username else None


def _program(name: Any, file: Path) -> str:
    if not isinstance(name, str) or "/" in name:
        raise RosmlError(f"{file}: the name of a credential helper is no name of a program", _REMEDY)
    return f"docker-credential-{name}"


def _helper(program: str, server: str) -> Credentials | None:
    """Asks a credential helper; None if it fails, since a helper without credentials exits with an error."""
    try:
        done = subprocess.run(
            [program, "get"],
            input=server,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            text=True,
            encoding="utf-8",
            errors="replace",  # otherwise the error would contain the text, which may hold the secret
            timeout=HELPER_SECONDS,
            check=False,
        )
    except (OSError, ValueError, subprocess.TimeoutExpired) as error:
        slow = f"no answer within {HELPER_SECONDS:.0f} s"
        reason = getattr(error, "strerror", None) or (str(error) if isinstance(error, ValueError) else slow)
        remedy = f"install it, or remove it from Docker's config file and log in again: docker login {server}"
        raise RosmlError(f"{program}, which Docker's config file names for {server}: {reason}", remedy) from None
    if done.returncode != 0:
        return None
    answer = untrusted.json_object(done.stdout) or {}
    username, secret = answer.get("Username"), answer.get("Secret")
    if not isinstance(username, str) or not isinstance(secret, str):  # the text may hold the secret: do not show it
        raise RosmlError(f"{program} does not answer as credential helpers do", f"docker login {server}")
    return Credentials(identity_token=secret) if username == TOKEN_USER else Credentials(username, secret)
