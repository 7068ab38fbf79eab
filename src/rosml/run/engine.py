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
from rosml.run.context import Container, Engine, Image
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


CDI = ("/etc/cdi", "/var/run/cdi")
"""Where podman looks for CDI's files."""

IMAGE = "{{json .Id}} {{json .Config}}"
"""What is asked of an image."""

CONTAINER = "{{json .Name}} {{json .State.Status}} {{json .Image}} {{json .Config}} {{json .Mounts}}"
"""What is asked of a container."""


@dataclass(frozen=True)
class Facts:
    """What an engine says. Attributes: image: None where the engine does not have it. taken: the container that has the
    wanted name; None where there is none."""

    engine: Engine
    image: Image | None
    taken: Container | None


def ask(command: str, image: str, name: str) -> Facts:
    """Asks an engine, all at once.

    Args:
        command: the engine's command. image: as the person wrote it. name: for a container; empty where none is wanted.

    Raises:
        RosmlError: the engine does not answer.
    """
    about = _begun(command, "info", "--format", "{{json .}}")
    inspected = _begun(command, "image", "inspect", "--format", IMAGE, image)
    containers = _begun(command, "container", "inspect", "--format", CONTAINER, name) if name else None
    said, described = _ended(about), _ended(inspected)
    taken = _containers(_ended(containers).text) if containers else []
    engine = _engine(command, said.text)
    found = _image(described.text) if described.code == 0 else None
    if found is None and engine is None:
        raise _silent(command, described.complaint or said.complaint)
    # An engine also finds a container by the beginning of its id, and its name is not ours then.
    return Facts(engine or _guessed(command), found, next((x for x in taken if x.name == name), None))


def image(command: str, identity: str) -> Image | None:
    """An image by its name or digest; None where the engine does not have it."""
    described = _ended(_begun(command, "image", "inspect", "--format", IMAGE, identity))
    return _image(described.text) if described.code == 0 else None


def container(command: str, name: str) -> Container | None:
    """A container by its name or id; None where there is none.

    Raises:
        RosmlError: the engine does not answer.
    """
    inspected = _ended(_begun(command, "container", "inspect", "--format", CONTAINER, name))
    found = _containers(inspected.text)
    if not found and _engine(command, _ended(_begun(command, "info", "--format", "{{json .}}")).text) is None:
        raise _silent(command, inspected.complaint)
    return found[0] if found else None


def containers(command: str, label: str) -> list[Container]:
    """The containers with a label, those that have ended among them.

    Args:
        label: its key.

    Raises:
        RosmlError: the engine does not answer.
    """
    listed = _ended(_begun(command, "ps", "--all", "--quiet", "--no-trunc", "--filter", f"label={label}"))
    if listed.code:
        raise _silent(command, listed.complaint)
    ids = listed.text.split()
    # One that ends meanwhile is missing in the answer.
    return _containers(_ended(_begun(command, "container", "inspect", "--format", CONTAINER, *ids)).text) if ids else []


def start(command: str, name: str) -> None:
    """Starts a container that has ended.

    Raises:
        RosmlError: the engine cannot, or it ends at once.
    """
    if subprocess.run([command, "start", name], stdout=subprocess.DEVNULL, check=False).returncode:
        raise RosmlError(f"{command} cannot start {name}", f"{command} rm {name} removes it")
    found = container(command, name)
    if found is None or found.state != "running":
        remedy = f"{command} logs {name} shows why; {command} rm {name} removes it"
        raise RosmlError(f"{name} has ended at once: its command had nothing to wait for", remedy)


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
        rootless = bool(found["host"].get("security", {}).get("rootless"))
        return Engine(
            command, podman=True, rootless=rootless, cdi=CDI, machine=str(found["host"].get("hostname") or "")
        )
    if not found or found.get("ServerErrors") or not found.get("ServerVersion"):
        return None
    options = [option.partition(",")[0] for option in found.get("SecurityOptions") or []]
    nvidia = "nvidia" in (found.get("Runtimes") or {})
    rootless, cdi = "name=rootless" in options, tuple(found.get("CDISpecDirs") or ())
    return Engine(command, rootless=rootless, nvidia=nvidia, cdi=cdi, machine=str(found.get("Name") or ""))


def _guessed(command: str) -> Engine:
    """Which engine it is, where it has the image and yet says nothing of itself that can be read."""
    podman = os.path.basename(command).startswith("podman")
    return Engine(command, podman, rootless=podman and os.geteuid() != 0, cdi=CDI if podman else ())


def _object(text: str) -> dict[str, Any]:
    try:
        found = json.loads(text)
    except ValueError:
        return {}
    return found if isinstance(found, dict) else {}


def _image(text: str) -> Image:
    """An image, from what `inspect` says; one that says nothing of itself, where that cannot be read."""
    try:
        identity, config = _values(text)
    except ValueError:
        return Image()
    return Image(_bare(identity), *_described(config), _words(config.get("Cmd")))


def _containers(text: str) -> list[Container]:
    """Containers, from what `inspect` says of each; those that cannot be read are left out."""
    found = []
    for line in text.splitlines():
        try:
            name, state, image, config, mounts = _values(line)
        except ValueError:
            continue
        places = frozenset(str(mount.get("Destination", "")) for mount in mounts or [])
        named, user = str(config.get("Image") or ""), str(config.get("User") or "")
        variables, labels, entrypoint = _described(config)
        given = name.removeprefix("/")  # docker's begin with it
        found.append(Container(given, state, named, _bare(image), user, variables, labels, entrypoint, places))
    return found


def _described(config: Mapping[str, Any]) -> tuple[Mapping[str, str], Mapping[str, str], tuple[str, ...]]:
    """The variables, the labels and the entrypoint of an image or a container."""
    variables = dict(entry.partition("=")[::2] for entry in config.get("Env") or [])
    return variables, config.get("Labels") or {}, _words(config.get("Entrypoint"))


def _words(found: Any) -> tuple[str, ...]:
    """A command as the engines have it: a list, nothing, or text in podman before 5."""
    return tuple(found.split() if isinstance(found, str) else found or ())


def _bare(identity: str) -> str:
    """A digest, which podman writes without its kind."""
    return identity.removeprefix("sha256:")


def _values(text: str) -> list[Any]:
    """The JSON values that follow each other in a text.

    Raises:
        ValueError: they do not.
    """
    decoder, found, rest = json.JSONDecoder(), [], text.strip()
    while rest:
        value, end = decoder.raw_decode(rest)
        found.append(value)
        rest = rest[end:].lstrip()
    return found


def _silent(command: str, complaint: str) -> RosmlError:
    """An engine that does not answer: its own words, and what to do about it."""
    words = complaint.splitlines()[-1] if complaint else "it says nothing"
    others = [name for name in ENGINES if name != command and shutil.which(name)]
    other = f"; or take the other one: {ENGINE}={others[0]}" if others and command in ENGINES else ""
    if "permission denied" in complaint.lower():
        remedy = "sudo usermod -aG docker $USER, then log in again"
        return RosmlError(f"{command} does not let you in: {words}", remedy + other)
    return RosmlError(f"{command} does not answer: {words}", f"start it: sudo systemctl start {command}{other}")


def lacking(command: str, image: str) -> RosmlError:
    """What to say where an image is missing, and nothing may be pulled: who runs in it depends on the image."""
    return RosmlError(f"no image {image} here", f"{command} pull {image}, then call it again")
