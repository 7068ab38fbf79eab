"""Reads the answers of an engine. Who runs in a container depends on them, so what we cannot read is an error."""

from __future__ import annotations

import contextlib
import re
import shlex
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any, TypeVar

from rosml.base import untrusted
from rosml.base.errors import RosmlError
from rosml.run.context import PODMAN_CDI, Container, Engine, Health, Image

T = TypeVar("T")

JSON = "{{json .}}"
"""The template for an engine or an image. docker and podman name an image's id differently in a template, and alike in JSON."""

CONTAINER = (
    "{{json .Name}} {{json .State.Status}} {{json .Image}} {{json .Config}} {{json .Mounts}} {{json .HostConfig}}"
)
CONTAINER_ID = re.compile("[A-Za-z0-9][A-Za-z0-9_.-]*")
IMAGE_ID = re.compile("(?:sha256:)?[0-9a-f]{64}")
NAME_WITH_DIGEST = re.compile(r"[A-Za-z0-9][A-Za-z0-9._:/-]*@sha256:[0-9a-f]{64}")

VERSION = re.compile(r"[0-9]{1,4}(?:\.[0-9]{1,4}){0,3}")
ZSTD = (23,)
"""The first docker that reads zstd, as `OLD_DOCKER` says."""
PASSWD = (4, 1)
"""The first podman with both --passwd and --passwd-entry: its release notes of 4.0.0 and 4.1.0."""


@dataclass(frozen=True)
class Answer:
    code: int
    text: str
    complaint: str

    @property
    def json(self) -> str:
        """The text without the warnings before it. It is an object, or begins with a text."""
        return re.sub(r'\A(?:(?!["{]).*\n)+(?=["{])', "", self.text)


@contextlib.contextmanager
def understood(command: str, answer: Answer, *words: str) -> Iterator[None]:
    """Turns a ValueError into an error whose remedy asks the engine the same by these words."""
    try:
        yield
    except ValueError:
        lines = answer.text.strip().splitlines() or ["nothing at all"]
        text = f"{command} answers with something that rosml does not understand: {lines[0][:60]}"
        raise RosmlError(text, f"try `{shlex.join([command, *words])}`") from None


def ids(command: str, answer: Answer, pattern: re.Pattern[str], *words: str) -> list[str]:
    """The ids in a list, without duplicates."""
    listed = answer.text.split()
    with understood(command, answer, *words):
        if not all(map(pattern.fullmatch, listed)):
            raise ValueError(answer.text)
    return list(dict.fromkeys(listed))


def engine(command: str, answer: Answer) -> Engine | None:
    """The engine that `info` describes; None if none answers. podman may be called docker."""
    if not answer.text.strip():
        return None
    with understood(command, answer, "info", "--format", JSON):
        (info,) = untrusted.json_values(answer.json)
        return _podman(command, info) if "host" in _kind(dict, info) else _docker(command, info)


def _podman(command: str, info: Mapping[str, Any]) -> Engine:
    host = _kind(dict, info["host"])
    security = _kind(dict, host.get("security", {}))
    version = _version(_kind(dict, info.get("version") or {}).get("Version"))
    return Engine(
        command,
        podman=True,
        version=version,
        rootless=bool(security.get("rootless")),
        cdi=PODMAN_CDI,
        machine=str(host.get("hostname") or ""),
        selinux=bool(security.get("selinuxEnabled")),
        passwd=not version or _numbers(version) >= PASSWD,
    )


def _version(text: object) -> str:
    """The number of a version that its engine names, such as `20.10.24+dfsg1`; empty if there is none."""
    match = VERSION.match(str(text))
    return match[0] if match else ""


def _numbers(version: str) -> tuple[int, ...]:
    return tuple(map(int, version.split(".")))


def _docker(command: str, info: Mapping[str, Any]) -> Engine | None:
    """None if docker's server does not answer."""
    if info.get("ServerErrors") or not info.get("ServerVersion"):
        return None
    version = _version(info["ServerVersion"])
    options = [option.partition(",")[0] for option in _texts(info.get("SecurityOptions"))]
    return Engine(
        command,
        version=version,
        rootless="name=rootless" in options,
        nvidia="nvidia" in _kind(dict, info.get("Runtimes") or {}),
        cdi=tuple(_texts(info.get("CDISpecDirs"))),
        machine=str(info.get("Name") or ""),
        selinux="name=selinux" in options,
        snap=str(info.get("DockerRootDir") or "").startswith("/var/snap/"),
        chains="io.containerd.snapshotter" not in str(info.get("DriverStatus")),
        zstd=not version or _numbers(version) >= ZSTD,
    )


def image(command: str, answer: Answer, name: str) -> Image | None:
    """The image that `inspect` describes; None if the engine does not have it."""
    if answer.code:
        return None
    with understood(command, answer, "image", "inspect", name):
        (described,) = untrusted.json_values(answer.json)
        (facts,) = described if isinstance(described, list) else [described]  # podman writes a list
        facts = _kind(dict, facts)
        config = _kind(dict, facts.get("Config"))
        return Image(
            without_kind(facts.get("Id")),
            *_config_facts(config),
            _words(config.get("Cmd")),
            _kind(str, config.get("User") or ""),
            str(facts.get("Digest") or ""),
            tuple(filter(NAME_WITH_DIGEST.fullmatch, _texts(facts.get("RepoDigests")))),
            _health(config.get("Healthcheck") or facts.get("HealthCheck")),  # docker's place, podman's place
        )


def _health(healthcheck: object) -> Health:
    """The HEALTHCHECK of an image, whose durations are in nanoseconds."""
    fields = _kind(dict, healthcheck or {})
    kind, *command = _texts(fields.get("Test")) or [""]
    numbers = [_kind(int, fields.get(name) or 0) for name in ("Interval", "Timeout", "StartPeriod", "Retries")]
    if not all(0 <= number < 2**63 for number in numbers):
        raise ValueError(numbers)
    if kind not in ("CMD", "CMD-SHELL") or not command:
        return Health()
    interval, timeout, start, retries = numbers
    shell = ["/bin/sh", "-c"] if kind == "CMD-SHELL" else []
    return Health((*shell, *command), interval / 1e9, timeout / 1e9, start / 1e9, min(retries, 2**31 - 1))


def containers(command: str, answer: Answer, *names: str) -> list[Container]:
    """The containers that `inspect` describes; missing ones are left out."""
    with understood(command, answer, "container", "inspect", *names):
        return [_container(line) for line in answer.json.split("\n") if line.strip()]


def _container(line: str) -> Container:
    name, state, image_id, config, mounts, settings = untrusted.json_values(line)
    config, settings = _kind(dict, config), _kind(dict, settings or {})
    places = [_kind(dict, mount) for mount in _kind(list, mounts or [])]
    sources = {str(mount.get("Destination", "")): str(mount.get("Source") or "") for mount in places}
    environment, labels, entrypoint = _config_facts(config)
    return Container(
        name=_kind(str, name).removeprefix("/"),  # docker's names begin with it
        state=_kind(str, state),
        image=str(config.get("Image") or ""),
        image_id=without_kind(image_id),
        user=str(config.get("User") or ""),
        environment=environment,
        labels=labels,
        entrypoint=entrypoint,
        mounts=frozenset(sources),
        network=str(settings.get("NetworkMode") or ""),
        ipc=str(settings.get("IpcMode") or ""),
        sources=sources,
    )


def layers(command: str, answer: Answer, *images: str) -> dict[str, tuple[str, ...]]:
    """The digests of each image's layers before they were compressed, lowest first, by the image's id."""
    with understood(command, answer, "image", "inspect", *images):
        described = _kind(list, untrusted.json_value(answer.text[answer.text.find("[") :]))
        return {
            without_kind(facts.get("Id")): tuple(_texts(_kind(dict, facts.get("RootFS") or {}).get("Layers")))
            for facts in (_kind(dict, item) for item in described)
        }


def without_kind(digest: object) -> str:
    """A digest as podman writes it, without `sha256:`."""
    return _kind(str, digest).removeprefix("sha256:")


def _config_facts(config: Mapping[str, Any]) -> tuple[Mapping[str, str], Mapping[str, str], tuple[str, ...]]:
    """The variables, the labels and the entrypoint of an image or a container."""
    variables = dict(entry.partition("=")[::2] for entry in _texts(config.get("Env")))
    labels = _kind(dict, config.get("Labels") or {})
    _texts([*labels.values()])
    return variables, labels, _words(config.get("Entrypoint"))


def _kind(kind: type[T], value: object) -> T:
    if not isinstance(value, kind):
        raise ValueError(value)
    return value


def _texts(value: object) -> list[str]:
    """A list of texts; the engines write null for an empty list."""
    return [_kind(str, text) for text in _kind(list, value or [])]


def _words(command: object) -> tuple[str, ...]:
    """A command as the engines have it: a list, nothing, or text in podman before 5."""
    return tuple(command.split() if isinstance(command, str) else _texts(command))
