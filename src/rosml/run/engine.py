"""Asks the engine, docker or podman, what it is and what it has. No other module of this package starts a process."""

from __future__ import annotations

import contextlib
import os
import re
import shlex
import shutil
import subprocess
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any, TypeVar

from rosml.base import untrusted
from rosml.base.errors import RosmlError
from rosml.run.context import Container, Engine, Health, Image
from rosml.run.words import Line

T = TypeVar("T")

ENGINE = "ROSML_ENGINE"
"""The environment variable that names an engine, or its path."""

ENGINES = ("docker", "podman")
"""The engines to look for, in this order."""

FOR_PULL = (
    *("arch", "authfile", "cert-dir", "creds", "decryption-key", "disable-content-trust", "os", "platform", "quiet"),
    *("retry", "retry-delay", "signature-policy", "tls-verify", "variant"),
)
"""Options of `run` about pulling an image; `pull` has them as well."""


HERE = re.compile(r"(localhost|127(\.[0-9]+){3})(:[0-9]+)?/")
"""Images of a registry on this machine. Docker asks it without TLS; podman needs an option for that."""


def program(environment: Mapping[str, str]) -> str:
    """The engine's command.

    Raises:
        RosmlError: no engine is installed.
    """
    path = environment.get("PATH")
    if named := environment.get(ENGINE, ""):
        if shutil.which(named, path=path):
            return named
        if "/" in named and os.path.exists(named):
            kind = "it is a folder" if os.path.isdir(named) else "it is no program, or not yours to run"
            remedy = f"name a program, such as {ENGINE}=podman, or unset it"
            raise RosmlError(f"{named!r}, which {ENGINE} names, cannot be run: {kind}", remedy)
        raise RosmlError(f"no program {named!r}, which {ENGINE} names", f"install it, or unset {ENGINE}")
    found = next((name for name in ENGINES if shutil.which(name, path=path)), "")
    if not found:
        remedy = "install one: apt-get install docker.io, or apt-get install podman"
        raise RosmlError("neither docker nor podman is installed, or not on PATH", f"{remedy}; {ENGINE} names another")
    return found


INFO = "{{json .}}"
"""The template for `info`."""

PATIENCE = 1.0
"""Seconds to wait for an engine after the Tab key."""

ID = re.compile("[A-Za-z0-9][A-Za-z0-9_.-]*")
"""The id or the name of a container."""

PASSWD = (4, 1)
"""The first podman with both --passwd and --passwd-entry: its release notes of 4.0.0 and 4.1.0."""

CDI = ("/etc/cdi", "/var/run/cdi")
"""The folders in which podman looks for CDI files."""

IMAGE = "{{json .}}"
"""The template for an image: all facts. docker and podman name its id differently in a template, and alike in JSON."""

NAMED = re.compile(r"[A-Za-z0-9][A-Za-z0-9._:/-]*@sha256:[0-9a-f]{64}")
"""The name of an image in a registry by its digest."""

IMAGE_ID = re.compile("(?:sha256:)?[0-9a-f]{64}")
"""The whole id of an image."""

CONTAINER = (
    "{{json .Name}} {{json .State.Status}} {{json .Image}} {{json .Config}} {{json .Mounts}} {{json .HostConfig}}"
)
"""The template for a container."""


@dataclass(frozen=True)
class Facts:
    """The answers of an engine.

    Attributes:
        engine: the engine itself.
        image: the image; None if the engine does not have it.
        taken: the container with the wanted name; None if there is none.
    """

    engine: Engine
    image: Image | None
    taken: Container | None


CONTAINERD = "io.containerd.snapshotter"
"""What docker says of itself if containerd keeps its images."""


@dataclass(frozen=True)
class Store:
    """How an engine keeps images.

    Attributes:
        podman: it is podman, which finds layers that it pulled by their digests.
        chains: it is docker's classic store, which finds a layer by all that is below it.
        zstd: it reads layers that are compressed with zstd. docker does since 23.
    """

    podman: bool
    chains: bool
    zstd: bool


def ask(command: str, image: str, name: str) -> Facts:
    """Asks an engine for all facts at once.

    Args:
        command: the engine's command.
        image: the image as typed.
        name: the wanted name of a container, or an empty text.

    Raises:
        RosmlError: the engine does not answer, or we cannot read its answer.
    """
    about = _begun(command, "info", "--format", INFO)
    inspected = _begun(command, "image", "inspect", "--format", IMAGE, image)
    containers = _begun(command, "container", "inspect", "--format", CONTAINER, name) if name else None
    said, described = _ended(about), _ended(inspected)
    named = _ended(containers) if containers else _Answer(0, "", "")
    engine = _engine(command, said)
    taken = _containers(command, named, name)
    found = _image(command, described, image)
    if found is None and engine is None:
        raise _silent(command, described.complaint or said.complaint)
    # An engine also finds a container by the beginning of its id; that one has another name.
    return Facts(engine or _guessed(command), found, next((x for x in taken if x.name == name), None))


def about(command: str) -> Engine:
    """The facts about an engine."""
    return _engine(command, _ended(_begun(command, "info", "--format", INFO))) or _guessed(command)


def answering(command: str) -> Engine:
    """The facts about an engine that answers.

    Raises:
        RosmlError: it does not answer, or we cannot read its answer.
    """
    said = _ended(_begun(command, "info", "--format", INFO))
    if found := _engine(command, said):
        return found
    raise _silent(command, said.complaint)


def image(command: str, identity: str) -> Image | None:
    """An image by its name or digest; None if the engine does not have it.

    Raises:
        RosmlError: we cannot read the engine's answer.
    """
    return _image(command, _ended(_begun(command, "image", "inspect", "--format", IMAGE, identity)), identity)


def container(command: str, name: str) -> Container | None:
    """A container by its name or id; None if there is none.

    Raises:
        RosmlError: the engine does not answer.
    """
    inspected = _ended(_begun(command, "container", "inspect", "--format", CONTAINER, name))
    found = _containers(command, inspected, name)
    if not found and _engine(command, _ended(_begun(command, "info", "--format", INFO))) is None:
        raise _silent(command, inspected.complaint)
    return found[0] if found else None


def containers(command: str, label: str) -> list[Container]:
    """The containers with a label, running or stopped.

    Args:
        label: its key.

    Raises:
        RosmlError: the engine does not answer.
    """
    return _listed(command, "--all", "--quiet", "--no-trunc", "--filter", f"label={label}")


def running(command: str) -> list[Container]:
    """The containers that run.

    Raises:
        RosmlError: the engine does not answer.
    """
    return _listed(command, "--quiet", "--no-trunc")


def _listed(command: str, *options: str) -> list[Container]:
    """The containers that `ps` lists.

    Raises:
        RosmlError: the engine does not answer.
    """
    listed = _ended(_begun(command, "ps", *options))
    if listed.code:
        raise _silent(command, listed.complaint)
    ids = listed.text.split()
    with _understood(command, listed, "ps", "--all", "--quiet"):
        if not all(map(ID.fullmatch, ids)):
            raise ValueError(listed.text)
    if not ids:
        return []
    # A container that ends meanwhile is missing in the answer.
    return _containers(command, _ended(_begun(command, "container", "inspect", "--format", CONTAINER, *ids)), *ids)


def folder(command: str, image: str, place: str) -> list[str]:
    """The names in a folder of an image, listed by a container of it; none if that fails."""
    alone = ("--rm", "--network", "none", "--entrypoint", "ls")
    listed = _ended(_begun(command, "run", *alone, image, place))
    return [] if listed.code else listed.text.split()


def layers(command: str) -> dict[str, tuple[str, ...]]:
    """All images of an engine by id, each with the digests of its layers before they were compressed, lowest first.

    Raises:
        RosmlError: the engine does not answer, or we cannot read its answer.
    """
    listed = _ended(_begun(command, "image", "ls", "--quiet", "--no-trunc"))
    if listed.code:
        raise _silent(command, listed.complaint)
    ids = list(dict.fromkeys(listed.text.split()))
    with _understood(command, listed, "image", "ls"):
        if not all(map(IMAGE_ID.fullmatch, ids)):
            raise ValueError(listed.text)
    found = dict[str, tuple[str, ...]]()
    if not ids:
        return found
    # An image that is removed meanwhile is missing in the answer.
    answer = _ended(_begun(command, "image", "inspect", *ids))
    with _understood(command, answer, "image", "inspect", *ids):
        for said in _kind(list, untrusted.json_value(answer.text[answer.text.find("[") :])):
            root = _kind(dict, _kind(dict, said).get("RootFS") or {})
            found[_bare(said.get("Id"))] = tuple(_texts(root.get("Layers")))
    return found


def store(command: str) -> Store:
    """How an engine keeps images.

    Raises:
        RosmlError: the engine does not answer, or we cannot read its answer.
    """
    said = _ended(_begun(command, "info", "--format", INFO))
    if (found := _engine(command, said)) is None:
        raise _silent(command, said.complaint)
    version = re.search(r'"ServerVersion":\s*"([0-9]{1,4})\.', said.text)
    zstd = found.podman or not version or int(version[1]) >= 23
    return Store(found.podman, not found.podman and CONTAINERD not in said.text, zstd)


def image_names(command: str) -> list[str]:
    """The names of all images, with their tags: as many as the engine says at once."""
    return [name for name in _lines(command, "images", "{{.Repository}}:{{.Tag}}") if "<none>" not in name]


def container_names(command: str) -> list[str]:
    """The names of all containers: as many as the engine says at once."""
    return _lines(command, "ps", "{{.Names}}", "--all")


def _lines(command: str, what: str, form: str, *options: str) -> list[str]:
    """The lines of a list. None if the engine fails or takes long: the user waits after the Tab key."""
    try:
        done = subprocess.run(
            [command, what, *options, "--format", form],
            stdin=subprocess.DEVNULL,
            capture_output=True,
            timeout=PATIENCE,
            check=False,
        )
    except (OSError, subprocess.TimeoutExpired):
        return []
    return done.stdout.decode(errors="replace").split() if done.returncode == 0 else []


def start(command: str, kept: Container, here: bool) -> None:
    """Starts a container that has stopped.

    Args:
        kept: the container.
        here: the engine runs on this machine.

    Raises:
        RosmlError: the engine cannot start it, or it ends at once.
    """
    name, removal = kept.name, f"{command} rm {kept.name} removes it {kept.loss(command)}"
    if subprocess.run([command, "start", name], stdout=subprocess.DEVNULL, check=False).returncode:
        gone = sorted({path for path in kept.sources.values() if here and path and not os.path.lexists(path)})
        if gone:
            text = f"{command} cannot start {name}: {gone[0]}, which is mounted in it, is gone"
            raise RosmlError(text, f"make it again, and try once more; {removal}")
        raise RosmlError(f"{command} cannot start {name}", removal)
    found = container(command, name)
    if found is None or found.state != "running":
        remedy = f"{command} logs {name} shows why; {removal}"
        raise RosmlError(f"{name} has ended at once: its command had nothing to wait for", remedy)


def pull(command: str, line: Line) -> None:
    """Lets the engine pull an image. Progress goes to standard error, as with `docker run`.

    Raises:
        RosmlError: the engine cannot pull it, or the user forbids it.
    """
    if line.value("pull") == "never":
        raise RosmlError(f"no image {line.image} here, and --pull=never", f"{command} pull {line.image}")
    alone = [given for given in line.engine if len(given.names) == 1]  # `pull` does not know -i and -t of -itq
    options = [word for given in alone if given.names[0] in FOR_PULL for word in given.words]
    plain = "" if line.has("tls-verify") or not about(command).podman else "--tls-verify=false"
    if plain and HERE.match(line.image):
        options.append(plain)
    argv = [command, "pull", *options, line.image]
    if subprocess.run(argv, stdout=2, check=False).returncode:
        remedy = f"{_about_the_name(line.image)}; if it is private: {command} login REGISTRY"
        remedy += f"; if its registry has no TLS: rosml run {plain} {line.image}" if plain else ""
        raise RosmlError(f"no image {line.image} here, and {command} cannot pull it", remedy)


def _about_the_name(image: str) -> str:
    """What may be wrong with the name of an image that cannot be pulled."""
    if image == "IMAGE":
        return "IMAGE stands for an image: write one that you have"
    if image == ".." or image.startswith(("./", "../", "/")):
        return "it is a path: rosml run -v FOLDER:/mnt IMAGE mounts it, rosml containerize FOLDER builds an image of its packages"
    if image.startswith("ghcr.io/me/"):
        return "ghcr.io/me is an example: write the place that has your images"
    if "@" in image:
        return f"check its digest, or take its tag: {image.partition('@')[0]}"
    if "/" in image:
        return "check its name"
    if ":" in image:
        return f"if it is one of rosml's, write its place as well, such as 127.0.0.1:40123/rosml/{image}"
    if "-" in image:
        return f"if it is a target, `rosml image {image}` builds it and says what to run"
    return f"if it is the command, an image goes before it: rosml run IMAGE {image}"


@dataclass(frozen=True)
class _Answer:
    code: int
    text: str
    complaint: str


def _begun(*argv: str) -> subprocess.Popen[str]:
    pipe, quiet = subprocess.PIPE, subprocess.DEVNULL
    try:
        return subprocess.Popen(
            argv, stdin=quiet, stdout=pipe, stderr=pipe, text=True, errors="replace", encoding="utf-8"
        )
    except OSError as error:
        remedy = f"install it again, or name another one with {ENGINE}"
        raise RosmlError(f"{argv[0]} cannot be run: {error.strerror}", remedy) from None


def _ended(process: subprocess.Popen[str]) -> _Answer:
    text, complaint = process.communicate()
    return _Answer(process.returncode, text, complaint.strip())


@contextlib.contextmanager
def _understood(command: str, answer: _Answer, *words: str) -> Iterator[None]:
    """Runs code that reads an answer.

    Args:
        words: the words by which a user can ask the same.

    Raises:
        RosmlError: the code raised a ValueError.
    """
    try:
        yield
    except ValueError:
        lines = answer.text.strip().splitlines() or ["nothing at all"]
        text = f"{command} answers with something that rosml does not understand: {lines[0][:60]}"
        raise RosmlError(text, f"try `{shlex.join([command, *words])}`") from None


def _engine(command: str, said: _Answer) -> Engine | None:
    """The engine that `info` describes; None if none answers. podman may be called docker.

    Raises:
        RosmlError: we cannot read the answer.
    """
    if not said.text.strip():
        return None
    with _understood(command, said, "info", "--format", INFO):
        (found,) = untrusted.json_values(_answer(said.text))
        return _described_engine(command, _kind(dict, found))


def _described_engine(command: str, found: Mapping[str, Any]) -> Engine | None:
    """The engine of a description; None if docker's server does not answer.

    Raises:
        ValueError: it is no description.
    """
    if "host" in found:
        host = _kind(dict, found["host"])
        security, machine = _kind(dict, host.get("security", {})), str(host.get("hostname") or "")
        rootless, selinux = bool(security.get("rootless")), bool(security.get("selinuxEnabled"))
        version = _version(_kind(dict, found.get("version") or {}).get("Version"))
        passwd = not version or version >= PASSWD
        return Engine(command, podman=True, rootless=rootless, cdi=CDI, machine=machine, selinux=selinux, passwd=passwd)
    if found.get("ServerErrors") or not found.get("ServerVersion"):
        return None
    options = [option.partition(",")[0] for option in _texts(found.get("SecurityOptions"))]
    nvidia = "nvidia" in _kind(dict, found.get("Runtimes") or {})
    rootless, cdi = "name=rootless" in options, tuple(_texts(found.get("CDISpecDirs")))
    machine, selinux = str(found.get("Name") or ""), "name=selinux" in options
    snap = str(found.get("DockerRootDir") or "").startswith("/var/snap/")
    return Engine(command, rootless=rootless, nvidia=nvidia, cdi=cdi, machine=machine, selinux=selinux, snap=snap)


def _version(text: object) -> tuple[int, int] | None:
    """The first two numbers of a version; None if it is unknown."""
    found = re.match(r"([0-9]{1,4})\.([0-9]{1,4})", str(text))
    return (int(found[1]), int(found[2])) if found else None


def _guessed(command: str) -> Engine:
    """The engine by its name alone, if it has the image and yet `info` says nothing."""
    podman = os.path.basename(command).startswith("podman")
    return Engine(command, podman, rootless=podman and os.geteuid() != 0, cdi=CDI if podman else ())


def _kind(kind: type[T], found: object) -> T:
    """Returns a value of the wanted type.

    Raises:
        ValueError: it has another type.
    """
    if not isinstance(found, kind):
        raise ValueError(found)
    return found


def _texts(found: object) -> list[str]:
    """A list of texts; the engines write null for an empty list."""
    return [_kind(str, text) for text in _kind(list, found or [])]


def _image(command: str, answer: _Answer, name: str) -> Image | None:
    """An image, from the answer of `inspect`; None if the engine does not have it.

    Raises:
        RosmlError: we cannot read the answer. Who runs in the container depends on it.
    """
    if answer.code:
        return None
    with _understood(command, answer, "image", "inspect", name):
        (said,) = untrusted.json_values(_answer(answer.text))
        (found,) = said if isinstance(said, list) else [said]  # podman writes a list
        found = _kind(dict, found)
        config = _kind(dict, found.get("Config"))
        user, default = _kind(str, config.get("User") or ""), _words(config.get("Cmd"))
        digest, digests = (
            str(found.get("Digest") or ""),
            tuple(filter(NAMED.fullmatch, _texts(found.get("RepoDigests")))),
        )
        health = _health(config.get("Healthcheck") or found.get("HealthCheck"))  # docker's place, podman's place
        return Image(_bare(found.get("Id")), *_described(config), default, user, digest, digests, health)


def _health(found: object) -> Health:
    """The HEALTHCHECK of an image. Durations are in nanoseconds.

    Raises:
        ValueError: it has another form.
    """
    said = _kind(dict, found or {})
    kind, *command = [*_texts(said.get("Test")), ""]
    words = (*(["/bin/sh", "-c"] if kind == "CMD-SHELL" else []), *command[:-1])
    numbers = [_kind(int, said.get(name) or 0) for name in ("Interval", "Timeout", "StartPeriod", "Retries")]
    if not all(0 <= number < 2**63 for number in numbers):
        raise ValueError(numbers)
    if kind not in ("CMD", "CMD-SHELL") or len(command) < 2:
        return Health()
    interval, timeout, start, retries = numbers
    return Health(words, interval / 1e9, timeout / 1e9, start / 1e9, min(retries, 2**31 - 1))


def _containers(command: str, answer: _Answer, *names: str) -> list[Container]:
    """Containers, from the answer of `inspect`, which leaves out missing ones.

    Raises:
        RosmlError: we cannot read the answer.
    """
    with _understood(command, answer, "container", "inspect", *names):
        return [_container(line) for line in _answer(answer.text).split("\n") if line.strip()]


def _container(line: str) -> Container:
    """A container, from a line of `inspect`.

    Raises:
        ValueError: we cannot read the line.
    """
    name, state, image, config, mounts, settings = untrusted.json_values(line)
    kinds = [_kind(dict, mount) for mount in _kind(list, mounts or [])]
    sources = {str(mount.get("Destination", "")): str(mount.get("Source") or "") for mount in kinds}
    variables, labels, entrypoint = _described(_kind(dict, config))
    named, user = str(config.get("Image") or ""), str(config.get("User") or "")
    given = _kind(str, name).removeprefix("/")  # docker's names begin with it
    network, ipc = (str(_kind(dict, settings or {}).get(key) or "") for key in ("NetworkMode", "IpcMode"))
    seen = (_kind(str, state), named, _bare(image), user)
    return Container(given, *seen, variables, labels, entrypoint, frozenset(sources), network, ipc, sources)


def _described(config: Mapping[str, Any]) -> tuple[Mapping[str, str], Mapping[str, str], tuple[str, ...]]:
    """The variables, the labels and the entrypoint of an image or a container."""
    variables = dict(entry.partition("=")[::2] for entry in _texts(config.get("Env")))
    labels = _kind(dict, config.get("Labels") or {})
    _texts([*labels.values()])
    return variables, labels, _words(config.get("Entrypoint"))


def _words(found: object) -> tuple[str, ...]:
    """A command as the engines have it: a list, nothing, or text in podman before 5."""
    return tuple(found.split() if isinstance(found, str) else _texts(found))


def _answer(text: str) -> str:
    """The answer of an engine without the warnings before it. It is an object, or begins with a text."""
    return re.sub(r'\A(?:(?!["{]).*\n)+(?=["{])', "", text)


def _bare(identity: object) -> str:
    """A digest, which podman writes without its kind."""
    return _kind(str, identity).removeprefix("sha256:")


def _silent(command: str, complaint: str) -> RosmlError:
    """The error if an engine does not answer: its own words and a remedy."""
    words = complaint.splitlines()[-1] if complaint else "it says nothing"
    others = [name for name in ENGINES if name != command and shutil.which(name)]
    other = f"; or take the other one: {ENGINE}={others[0]}" if others and command in ENGINES else ""
    if "permission denied" in complaint.lower():
        remedy = "sudo usermod -aG docker $USER, then log in again"
        return RosmlError(f"{command} does not let you in: {words}", remedy + other)
    return RosmlError(f"{command} does not answer: {words}", f"start it: sudo systemctl start {command}{other}")


def lacking(command: str, image: str) -> RosmlError:
    """The error if an image is missing and we may not pull it: who runs in the container depends on the image."""
    return RosmlError(f"no image {image} here", f"{command} pull {image}, then call it again")


def still_lacking(command: str, image: str) -> RosmlError:
    """The error if an image is missing although it was pulled."""
    remedy = f"`{command} image inspect {image}` says why; `{command} images` lists what is there"
    return RosmlError(f"{command} has pulled {image}, and yet does not have it", remedy)
