"""Asks the engine, docker or podman, what it is and what it has. No other module of this package starts a process."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
from collections.abc import Callable, Mapping
from dataclasses import dataclass

from rosml.base.errors import RosmlError
from rosml.run import answers
from rosml.run.answers import Answer
from rosml.run.context import NEW_DOCKER, OLD_DOCKER, PODMAN_CDI, Container, Engine, Image
from rosml.run.host import host
from rosml.run.words import Line

ENGINE = "ROSML_ENGINE"
"""The environment variable that names an engine, or its path."""

ENGINES = ("docker", "podman")
SOCKET = "/var/run/docker.sock"
"""Where Docker listens, unless an environment variable or a context says otherwise."""
INFO = ("info", "--format", answers.JSON)
INSPECT_IMAGE = ("image", "inspect", "--format", answers.JSON)
INSPECT_CONTAINERS = ("container", "inspect", "--format", answers.CONTAINER)
PULL_OPTIONS = (
    *("arch", "authfile", "cert-dir", "creds", "decryption-key", "disable-content-trust", "os", "platform", "quiet"),
    *("retry", "retry-delay", "signature-policy", "tls-verify", "variant"),
)

LOCAL_REGISTRY = re.compile(r"(localhost|127(\.[0-9]+){3})(:[0-9]+)?/")
"""Images of a registry on this machine. Docker asks it without TLS; podman needs an option for that."""

COMPLETION_TIMEOUT = 1.0


@dataclass(frozen=True)
class Facts:
    """The answers of an engine; None for an image or a container that it does not have."""

    engine: Engine
    image: Image | None
    container: Container | None


def program(environment: Mapping[str, str]) -> str:
    """The engine's command. An error says how to install one."""
    path = environment.get("PATH")
    if choice := environment.get(ENGINE, ""):
        if shutil.which(choice, path=path):
            return choice
        if "/" in choice and os.path.exists(choice):
            reason = "it is a folder" if os.path.isdir(choice) else "it is no program, or not yours to run"
            remedy = f"name a program, such as {ENGINE}=podman, or unset it"
            raise RosmlError(f"{choice!r}, which {ENGINE} names, cannot be run: {reason}", remedy)
        raise RosmlError(f"no program {choice!r}, which {ENGINE} names", f"install it, or unset {ENGINE}")
    installed = next((name for name in ENGINES if shutil.which(name, path=path)), "")
    if not installed:
        remedy = "install one: apt-get install docker.io, or apt-get install podman"
        raise RosmlError("neither docker nor podman is installed, or not on PATH", f"{remedy}; {ENGINE} names another")
    return installed


def choose(environment: Mapping[str, str], say: Callable[[str], object]) -> str:
    """The engine's command, as `program`; podman if it answers and Docker has no daemon. Whoever names an engine gets that one."""
    command = program(environment)
    explicit = any(environment.get(name) for name in (ENGINE, "DOCKER_HOST", "DOCKER_CONTEXT"))
    if explicit or command != "docker" or not shutil.which("podman", path=environment.get("PATH")):
        return command
    if host(environment).answers(SOCKET):
        return command
    from rosml.base import silent_docker  # few people lack a daemon

    info = _ask(command, *INFO)
    if answers.engine(command, info) or silent_docker.denies(info.complaint + info.text):
        return command
    if answers.engine("podman", _ask("podman", *INFO)) is None:
        return command
    say(f"docker does not answer, so podman is taken; {ENGINE} names one of them")
    return "podman"


def ask(command: str, image: str, name: str) -> Facts:
    """All facts about an engine, an image as typed and, unless the name is empty, a container. It asks all at the same time."""
    processes = [_begin(command, *INFO), _begin(command, *INSPECT_IMAGE, image)]
    processes += [_begin(command, *INSPECT_CONTAINERS, name)] if name else []
    info, image_answer, *container_answers = map(_end, processes)
    engine = answers.engine(command, info)
    containers = [match for answer in container_answers for match in answers.containers(command, answer, name)]
    image_facts = answers.image(command, image_answer, image)
    if image_facts is None and engine is None:
        raise _silent(command, image_answer.complaint or info.complaint)
    # An engine also finds a container by the beginning of its id; that one has another name.
    container = next((container for container in containers if container.name == name), None)
    return Facts(engine or _guessed(command), image_facts, container)


def about(command: str) -> Engine:
    """The facts about an engine; guessed from its name if it says nothing."""
    return answers.engine(command, _ask(command, *INFO)) or _guessed(command)


def answering(command: str) -> Engine:
    """The facts about an engine. It is an error if it does not answer."""
    info = _ask(command, *INFO)
    if engine := answers.engine(command, info):
        return engine
    raise _silent(command, info.complaint)


def image(command: str, identity: str) -> Image | None:
    """An image by its name or digest; None if the engine does not have it."""
    return answers.image(command, _ask(command, *INSPECT_IMAGE, identity), identity)


def container(command: str, name: str) -> Container | None:
    """A container by its name or id; None if there is none."""
    answer = _ask(command, *INSPECT_CONTAINERS, name)
    containers = answers.containers(command, answer, name)
    if not containers and answers.engine(command, _ask(command, *INFO)) is None:
        raise _silent(command, answer.complaint)
    return containers[0] if containers else None


def containers(command: str, label: str) -> list[Container]:
    """The containers with a label of this key, running or stopped."""
    return _listed(command, "--all", "--quiet", "--no-trunc", "--filter", f"label={label}")


def running(command: str) -> list[Container]:
    """The containers that run."""
    return _listed(command, "--quiet", "--no-trunc")


def _listed(command: str, *options: str) -> list[Container]:
    listing = _ask(command, "ps", *options)
    if listing.code:
        raise _silent(command, listing.complaint)
    ids = answers.ids(command, listing, answers.CONTAINER_ID, "ps", "--all", "--quiet")
    # A container that ends meanwhile is missing in the answer.
    return answers.containers(command, _ask(command, *INSPECT_CONTAINERS, *ids), *ids) if ids else []


def folder(command: str, image: str, place: str) -> list[str]:
    """The names in a folder of an image, listed by a container of it; none if that fails."""
    listing = _ask(command, "run", "--rm", "--network", "none", "--entrypoint", "ls", image, place)
    return [] if listing.code else listing.text.split()


def layers(command: str) -> dict[str, tuple[str, ...]]:
    """All images of an engine by id, each with the digests of its layers before they were compressed, lowest first."""
    listing = _ask(command, "image", "ls", "--quiet", "--no-trunc")
    if listing.code:
        raise _silent(command, listing.complaint)
    ids = answers.ids(command, listing, answers.IMAGE_ID, "image", "ls")
    # An image that is removed meanwhile is missing in the answer.
    return answers.layers(command, _ask(command, "image", "inspect", *ids), *ids) if ids else {}


def image_names(command: str) -> list[str]:
    """The names of all images with their tags; none if the engine does not answer at once."""
    return [name for name in _lines(command, "images", "{{.Repository}}:{{.Tag}}") if "<none>" not in name]


def container_names(command: str) -> list[str]:
    """The names of all containers; none if the engine does not answer at once."""
    return _lines(command, "ps", "{{.Names}}", "--all")


def _lines(command: str, list_: str, template: str, *options: str) -> list[str]:
    argv, quiet = [command, list_, *options, "--format", template], subprocess.DEVNULL
    try:
        done = subprocess.run(argv, stdin=quiet, capture_output=True, timeout=COMPLETION_TIMEOUT, check=False)
    except (OSError, subprocess.TimeoutExpired):
        return []
    return done.stdout.decode(errors="replace").split() if done.returncode == 0 else []


def start(command: str, stopped: Container, here: bool) -> None:
    """Starts a container that has stopped. `here`: the engine runs on this machine, so that mounts can be checked."""
    name, removal = stopped.name, f"{command} rm {stopped.name} removes it {stopped.loss(command)}"
    if subprocess.run([command, "start", name], stdout=subprocess.DEVNULL, check=False).returncode:
        gone = sorted({path for path in stopped.sources.values() if here and path and not os.path.lexists(path)})
        if gone:
            text = f"{command} cannot start {name}: {gone[0]}, which is mounted in it, is gone"
            raise RosmlError(text, f"make it again, and try once more; {removal}")
        raise RosmlError(f"{command} cannot start {name}", removal)
    started = container(command, name)
    if started is None or started.state != "running":
        remedy = f"{command} logs {name} shows why; {removal}"
        raise RosmlError(f"{name} has ended at once: its command had nothing to wait for", remedy)


def pull(command: str, line: Line) -> None:
    """Lets the engine pull an image. Progress goes to standard error, as with `docker run`."""
    if line.value("pull") == "never":
        raise RosmlError(f"no image {line.image} here, and --pull=never", f"{command} pull {line.image}")
    single = [option for option in line.engine if len(option.names) == 1]  # `pull` does not know -i and -t of -itq
    options = [word for option in single if option.names[0] in PULL_OPTIONS for word in option.words]
    engine = about(command)
    plain = "" if line.has("tls-verify") or not engine.podman else "--tls-verify=false"
    if plain and LOCAL_REGISTRY.match(line.image):
        options.append(plain)
    argv = [command, "pull", *options, line.image]
    if subprocess.run(argv, stdout=2, check=False).returncode:
        remedy = f"{_name_advice(line.image)}; if it is private: {command} login REGISTRY"
        if LOCAL_REGISTRY.match(line.image):
            remedy = _advice_on_loopback(engine, line.image)
        remedy += f"; if its registry has no TLS: rosml run {plain} {line.image}" if plain else ""
        remedy = remedy if engine.zstd else f"{NEW_DOCKER}, as {OLD_DOCKER}; otherwise: {remedy}"
        raise RosmlError(f"no image {line.image} here, and {command} cannot pull it", remedy)


def _advice_on_loopback(engine: Engine, image: str) -> str:
    """What to do if an engine does not get an image from a registry on this machine's loopback."""
    by_file = f"give it a file: rosml save {image} -o image.tar, then rosml load image.tar"
    if not engine.is_on(host(os.environ)):
        return f"{engine.program} runs on another machine, {engine.machine}, whose loopback is another one; {by_file}"
    advice = "check its name; if its registry is down, call rosml setup in the checkout"
    has_network = engine.rootless and not engine.podman
    return (
        f"{advice}; if docker has a network of its own, as without root before version 29.5, {by_file}"
        if has_network
        else advice
    )


def _name_advice(image: str) -> str:
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
        place = f"if it is one of rosml's, write its place as well, such as ghcr.io/me/rosml/{image}"
        return f"{place}; if it is of your packages, rosml containerize builds it"
    if "-" in image:
        return f"if it is a target, `rosml image {image}` builds it and says what to run"
    return f"if it is the command, an image goes before it: rosml run IMAGE {image}"


def lacking(command: str, image: str) -> RosmlError:
    """The error if an image is missing and we may not pull it: who runs in the container depends on the image."""
    return RosmlError(f"no image {image} here", f"{command} pull {image}, then call it again")


def still_lacking(command: str, image: str) -> RosmlError:
    """The error if an image is missing although it was pulled."""
    remedy = f"`{command} image inspect {image}` says why; `{command} images` lists what is there"
    return RosmlError(f"{command} has pulled {image}, and yet does not have it", remedy)


def _silent(command: str, complaint: str) -> RosmlError:
    from rosml.base import silent_docker  # only needed when something is wrong

    words = complaint.splitlines()[-1] if complaint else "it says nothing"
    others = [name for name in ENGINES if name != command and shutil.which(name)]
    other = f"; or take the other one: {ENGINE}={others[0]}" if others and command in ENGINES else ""
    verb = "let you in" if silent_docker.denies(complaint) else "answer"
    remedy = f"{command} info says more" if _is_podman(command) else silent_docker.remedy(complaint)
    return RosmlError(f"{command} does not {verb}: {words}", remedy + other)


def _guessed(command: str) -> Engine:
    """The engine by its name alone, if it has the image and yet `info` says nothing."""
    podman = _is_podman(command)
    return Engine(command, podman, rootless=podman and os.geteuid() != 0, cdi=PODMAN_CDI if podman else ())


def _is_podman(command: str) -> bool:
    return os.path.basename(command).startswith("podman")


def _ask(*argv: str) -> Answer:
    return _end(_begin(*argv))


def _begin(*argv: str) -> subprocess.Popen[str]:
    pipe, quiet = subprocess.PIPE, subprocess.DEVNULL
    try:
        return subprocess.Popen(argv, stdin=quiet, stdout=pipe, stderr=pipe, errors="replace", encoding="utf-8")
    except OSError as error:
        remedy = f"install it again, or name another one with {ENGINE}"
        raise RosmlError(f"{argv[0]} cannot be run: {error.strerror}", remedy) from None


def _end(process: subprocess.Popen[str]) -> Answer:
    text, complaint = process.communicate()
    return Answer(process.returncode, text, complaint.strip())
