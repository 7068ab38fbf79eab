"""Entering a container: finds the right one, checks it, and makes the engine's command."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence

from rosml.base.errors import RosmlError
from rosml.run.context import Container, Image, Person
from rosml.run.plugins import places
from rosml.run.plugins.basic_options import COMPONENT_LABEL, FOLDER_LABEL, streams, targets
from rosml.run.plugins.places import ROS_NETWORK
from rosml.run.words import Line

ENTRYPOINT = "/entrypoint.sh"
"""The script that makes the user in our images, and sources ROS (docs/contract.md)."""

PASSED = frozenset(("detach", "detach-keys", "env", "env-file", "interactive", "privileged", "tty", "user", "workdir"))

SHELLS = ("ash", "bash", "dash", "fish", "ksh", "sh", "zsh")
IDLE = ("created", "exited", "configured", "initialized", "stopped")


class NoContainer(RosmlError):
    """No container was started in a folder."""


def argv(program: str, line: Line, person: Person, container: Container, image: Image | None) -> list[str]:
    """The engine's command. Of the options, which are for `exec`, we leave out --name and --rm. `image` is the container's, None if
    it is gone."""
    options = [x for x in line.engine if not set(x.names) <= {"name", "rm"}]
    refused = next((x.words[0] for x in options if not set(x.names) <= PASSED), "")
    if refused:
        text = f"{refused} is for a container that starts, and {container.name} is there already"
        raise RosmlError(text, f"rosml attach {container.name} without it; --new starts another container", exit_code=2)
    user = ["--user", container.user] if container.user and not line.has("user") else []
    words = [word for x in options for word in x.words]
    entrypoint = [ENTRYPOINT] if is_ours(container) else []
    command = line.command or default(container, image)
    return [program, "exec", *streams(line, person), *user, *words, container.name, *entrypoint, *command]


def is_ours(container: Container) -> bool:
    """Whether the container's image is ours, or built on ours. --entrypoint may have replaced the image's own."""
    contract = "DOCKER_UID" in container.environment
    return contract and (ENTRYPOINT in container.entrypoint or COMPONENT_LABEL in container.labels)


def default(container: Container, image: Image | None) -> Sequence[str]:
    """The default command: the image's own if that is a shell, otherwise bash. If the image's command is an app, that runs
    already. In another image with an entrypoint, CMD is a program only together with that entrypoint."""
    if image is None or not is_shell(image.command) or (image.entrypoint and not is_ours(container)):
        return ["bash"]
    return image.command


def is_shell(command: Sequence[str]) -> bool:
    """Whether a command is a shell that runs no program: `bash -l`, not `bash -c …` or `bash start.sh`."""
    program, *options = command or ("",)
    return program.rpartition("/")[2] in SHELLS and all(re.fullmatch("--[a-z]+|-[il]+", word) for word in options)


def of_folder(containers: Sequence[Container], folder: str, command: str) -> Container:
    """The container of a folder: the running one, or else the only one, of all that `rosml run` started. `command` is the call, for
    the message."""
    here = [container for container in containers if container.labels.get(FOLDER_LABEL) == folder]
    candidates = [container for container in here if container.state == "running"] or here
    if len(candidates) == 1:
        return candidates[0]
    if candidates:
        first = min(container.name for container in candidates)
        text = f"{len(candidates)} containers of this folder: {_shown(candidates)}"
        raise RosmlError(text, f"rosml attach {first}", exit_code=2)
    others = _shown(container for container in containers if container.state == "running")
    elsewhere = f"; rosml attach NAME enters one of other folders: {others}" if others else ""
    text = f"{command}: no container was started in this folder"
    raise NoContainer(text, f"rosml run IMAGE starts one{elsewhere}", exit_code=2)


def _shown(containers: Iterable[Container]) -> str:
    return ", ".join(sorted(f"{x.name} ({x.image}, {x.state})" for x in containers))


def check_same(program: str, line: Line, person: Person, container: Container, image: Image | None) -> None:
    """Checks that the container with the name is the one that `rosml run IMAGE` would start: it runs, is of this folder and of
    the same image, and has the folder mounted if the user asks for that. `image` is the typed one, None if it is missing."""
    name = container.name
    new = f"{_other(line)} starts another container"
    enter = f"rosml attach {name} enters it; {new}"
    if container.state != "running":
        again = f"rosml attach {name} starts it again, " if container.state in IDLE else ""
        text = f"a container named {name} exists ({container.state})"
        raise RosmlError(text, f"{again}{program} rm {name} removes it {container.loss(program)}; {new}")
    if container.labels.get(FOLDER_LABEL) != person.folder:
        place = container.labels.get(FOLDER_LABEL)
        whose = f"it belongs to the folder {place}" if place else "rosml run did not start it"
        raise RosmlError(f"a container named {name} runs, and {whose}", enter)
    if image.id != container.image_id if image else line.image != container.image:
        older = "an older " if line.image == container.image else ""
        raise RosmlError(f"{name} runs {older}{container.image}, and you ask for {line.image}", enter)
    missing = [place for place in targets(line, person.folder, container.environment) if place not in container.mounts]
    if missing:
        raise RosmlError(f"{name} runs without this folder at {missing[0]}", enter)
    if line.has("detach"):
        raise RosmlError(f"{name} runs already", enter)


def _other(line: Line) -> str:
    """The option by which another container starts."""
    return "another --name" if line.has("name") else "--new"


def lacking(line: Line, container: Container) -> tuple[str, str] | None:
    """A warning and its remedy if the user asks for a network for ROS and the container lacks it; None otherwise."""
    place = places.running(container, rootless=False)
    if not line.asks(ROS_NETWORK) or place.network == place.ipc == places.HOST:
        return None
    networks = f"its network is {place.network}, its shared memory {place.ipc or places.ALONE}"
    text = f"{container.name} runs without --{ROS_NETWORK}: {networks}"
    return text, f"{_other(line)} starts another container with it"


def check_state(program: str, container: Container) -> None:
    """Checks that a container can be entered, or started first."""
    if container.state == "running" or container.state in IDLE:
        return
    remedy = f"wait, or {program} rm --force {container.name}, which removes it {container.loss(program)}"
    if container.state == "paused":
        remedy = f"{program} unpause {container.name}"
    raise RosmlError(f"{container.name} cannot be entered: it is {container.state}", remedy)
