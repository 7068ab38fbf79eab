"""The engine, docker or podman, is asked what it is and what it has. Nothing else of this package starts a process."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from rosml.base.errors import RosmlError
from rosml.run.context import Engine
from rosml.run.words import Line

ENGINE = "ROSML_ENGINE"
"""The environment variable that names an engine, or its path."""

ENGINES = ("docker", "podman")
"""What is looked for, in this order."""

FOR_PULL = (
    *("arch", "authfile", "cert-dir", "creds", "decryption-key", "disable-content-trust", "os", "platform", "quiet"),
    *("retry", "retry-delay", "signature-policy", "tls-verify", "variant"),
)
"""The options of `run` that say how an image is pulled; `pull` has them as well."""


def program(environment: Mapping[str, str]) -> str:
    """The engine's command.

    Raises:
        RosmlError: there is none.
    """
    path = environment.get("PATH")
    if named := environment.get(ENGINE, ""):
        if shutil.which(named, path=path):
            return named
        raise RosmlError(f"no program {named!r}, which {ENGINE} names", f"install it, or unset {ENGINE}")
    found = next((name for name in ENGINES if shutil.which(name, path=path)), "")
    if not found:
        remedy = "install one: apt-get install docker.io, or apt-get install podman"
        raise RosmlError("neither docker nor podman is installed, or not on PATH", f"{remedy}; {ENGINE} names another")
    return found


@dataclass(frozen=True)
class Facts:
    """What an engine says. Attributes: image: the image's environment variables; None where the engine does not have it.
    taken: the state of the container that has the wanted name, such as `running`; empty where there is none."""

    engine: Engine
    image: Mapping[str, str] | None
    taken: str


def ask(command: str, image: str, name: str) -> Facts:
    """Asks an engine, all at once.

    Args:
        command: the engine's command. image: as the person wrote it. name: for a container; empty where none is wanted.

    Raises:
        RosmlError: the engine does not answer.
    """
    about = _begun(command, "info", "--format", "{{json .}}")
    inspected = _begun(command, "image", "inspect", "--format", "{{json .Config.Env}}", image)
    containers = (
        _begun(command, "container", "inspect", "--format", "{{.State.Status}} {{.Name}}", name) if name else None
    )
    said, variables = _ended(about), _ended(inspected)
    taken, _, owner = _ended(containers).text.strip().partition(" ") if containers else ("", "", "")
    engine = _engine(command, said.text)
    found = _variables(variables.text) if variables.code == 0 else None
    if found is None and engine is None:
        raise _silent(command, variables.complaint or said.complaint)
    # An engine also finds a container by the beginning of its id, and its name is not ours then.
    return Facts(engine or _guessed(command), found, taken if owner.removeprefix("/") == name else "")


def pull(command: str, line: Line) -> None:
    """Has the engine pull an image; what it says of its progress goes to standard error, as that of `docker run` does.

    Raises:
        RosmlError: it cannot, or must not, or it has pulled nothing that could be read.
    """
    if line.value("pull") == "never":
        raise RosmlError(f"no image {line.image} here, and --pull=never", f"{command} pull {line.image}")
    alone = [given for given in line.engine if len(given.names) == 1]  # `pull` does not know -i and -t of -itq
    options = [word for given in alone if given.names[0] in FOR_PULL for word in given.words]
    argv = [command, "pull", *options, line.image]
    if subprocess.run(argv, stdout=2, check=False).returncode:
        remedy = f"look at its name; where it is private: {command} login REGISTRY"
        raise RosmlError(f"no image {line.image} here, and {command} cannot pull it", remedy)


@dataclass(frozen=True)
class _Answer:
    code: int
    text: str
    complaint: str


def _begun(*argv: str) -> subprocess.Popen[str]:
    pipe, quiet = subprocess.PIPE, subprocess.DEVNULL
    return subprocess.Popen(argv, stdin=quiet, stdout=pipe, stderr=pipe, text=True, errors="replace", encoding="utf-8")


def _ended(process: subprocess.Popen[str]) -> _Answer:
    text, complaint = process.communicate()
    return _Answer(process.returncode, text, complaint.strip())


def _engine(command: str, text: str) -> Engine | None:
    """Which engine answers, by what `info` says; None where none does. podman may be called docker."""
    found = _object(text)
    if "host" in found:
        return Engine(command, podman=True, rootless=bool(found["host"].get("security", {}).get("rootless")))
    if not found or found.get("ServerErrors") or not found.get("ServerVersion"):
        return None
    options = [option.partition(",")[0] for option in found.get("SecurityOptions") or []]
    return Engine(command, rootless="name=rootless" in options)


def _guessed(command: str) -> Engine:
    """Which engine it is, where it has the image and yet says nothing of itself that can be read."""
    podman = os.path.basename(command).startswith("podman")
    return Engine(command, podman, rootless=podman and os.geteuid() != 0)


def _object(text: str) -> dict[str, Any]:
    try:
        found = json.loads(text)
    except ValueError:
        return {}
    return found if isinstance(found, dict) else {}


def _variables(text: str) -> Mapping[str, str]:
    """An image's environment variables, from JSON's list of `NAME=value`; none of null, or of what is no JSON."""
    try:
        return dict(entry.partition("=")[::2] for entry in json.loads(text) or [])
    except ValueError:
        return {}


def _silent(command: str, complaint: str) -> RosmlError:
    """An engine that does not answer: its own words, and what to do about it."""
    words = complaint.splitlines()[-1] if complaint else "it says nothing"
    others = [name for name in ENGINES if name != command and shutil.which(name)]
    other = f"; or take the other one: {ENGINE}={others[0]}" if others and command in ENGINES else ""
    if "permission denied" in complaint.lower():
        remedy = "sudo usermod -aG docker $USER, then log in again"
        return RosmlError(f"{command} does not let you in: {words}", remedy + other)
    return RosmlError(f"{command} does not answer: {words}", f"start it: sudo systemctl start {command}{other}")


def taken(command: str, name: str, state: str) -> RosmlError:
    """What to say where another container has the name."""
    if state == "running":
        first = f"{command} exec -it {name} /entrypoint.sh bash opens a shell in it"
    else:
        first = f"{command} rm {name} removes it"
    return RosmlError(
        f"a container named {name} exists ({state})", f"{first}; --name OTHER or --no-name starts another"
    )


def lacking(command: str, image: str) -> RosmlError:
    """What to say where an image is missing, and nothing may be pulled: who runs in it depends on the image."""
    return RosmlError(f"no image {image} here", f"{command} pull {image}, then call it again")
