"""Writes a call as a `.container` file, from which podman makes a unit of systemd: podman-systemd.unit(5).

podman's generator reads the file and writes podman's command into a unit, which systemd reads in turn. Both remove quotes and
escapes. systemd also takes `%` and `$` for the beginning of something else, so each of them is written twice.

Only some keys of the file have quotes. An option whose value needs them, or whose key podman 4.9 does not know, is a word of
PodmanArgs, which has them.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import replace

from rosml.base.errors import RosmlError
from rosml.run import paths, trust
from rosml.run.context import PODMAN_CDI, Context, Engine
from rosml.run.exports.description import COUNT, Call, Option, gpus, sessionless
from rosml.run.words import TypedOption

KIND = "quadlet"
KEYS = {
    "cap-add": "AddCapability",
    "cap-drop": "DropCapability",
    "device": "AddDevice",
    "env-file": "EnvironmentFile",
    "hostname": "HostName",
    "name": "ContainerName",
    "network": "Network",
    "publish": "PublishPort",
    "pull": "Pull",
    "userns": "UserNS",
    "volume": "Volume",
    "workdir": "WorkingDir",
}
"""Keys without quotes, known to podman 4.9."""

SINGLE = ("hostname", "name", "pull", "user", "userns", "workdir")
"""Options of which the last one counts; the generator puts PodmanArgs after all keys."""

QUOTED_KEYS = {"annotation": "Annotation", "env": "Environment", "label": "Label"}
SECURITY_KEYS = {"label=disable": "SecurityLabelDisable", "no-new-privileges": "NoNewPrivileges"}
DROPPED = ("interactive", "tty")
OF_DOCKER = (
    *("cpu-count", "cpu-percent", "domainname", "health-start-interval", "io-maxbandwidth", "io-maxiops", "isolation"),
    *("kernel-memory", "link", "link-local-ip", "use-api-socket", "volume-driver"),
)

OF_THE_GENERATOR = ("cidfile", "rootfs", "sdnotify")
"""Options that the generator writes itself, or that change what the image is."""

RESTARTS = {"always": "always", "no": "no", "on-failure": "on-failure", "unless-stopped": "always"}
UNIT_SUFFIXES = (".build", ".container", ".image", ".kube", ".network", ".pod", ".volume")
"""Ends of names that the generator takes for other files of its kind."""

PLAIN = re.compile(r"[A-Za-z0-9_/.@+][A-Za-z0-9_/.@:+=,-]*")
"""Values that neither the generator nor systemd change."""

PORT = re.compile(r"(?:(?:[0-9]{1,3}(?:\.[0-9]{1,3}){3}:)?[0-9]{1,5}:)?[0-9]{1,5}(?:/(?:tcp|udp))?")
VARIABLE = re.compile("[A-Za-z_][A-Za-z0-9_.-]*")
ESCAPES = {'"': r"\"", "\\": r"\\", "\n": r"\n", "\r": r"\r", "\t": r"\t", "%": "%%", "$": "$$"}
ESCAPED = str.maketrans({**{code: f"\\x{code:02x}" for code in (*range(32), 127)}, **str.maketrans(ESCAPES)})

STOP_TIMEOUT = 60
"""Seconds for a stop for which systemd's default of 90 is enough."""


def service(context: Context) -> Context:
    """The context of podman's: without root unless you are root. Another engine of this machine does not count."""
    engine, line = context.engine, context.line
    if not engine.podman:
        rootless = context.person.uid != 0
        engine = Engine("podman", True, rootless, cdi=PODMAN_CDI, machine=engine.machine, selinux=engine.selinux)
        line = replace(line, image=_whole_name(line.image, context.image.id))
    return sessionless(replace(context, engine=engine, line=line), KIND)


def _whole_name(image: str, identity: str) -> str:
    """The image's whole name: docker has a registry for names without one, podman asks which."""
    whole, reference = trust.repository(image, identity, podman=False), trust.REFERENCE.fullmatch(image)
    if whole.startswith("sha256:") and reference:
        raise RosmlError(f"{image} is an id of docker's, which podman does not have", trust.PUSHED, exit_code=2)
    return whole + image[len(reference["name"]) :] if reference else image


def text(call: Call) -> str:
    rootless = call.engine.rootless
    user, folder = ("--user ", "~/.config/containers/systemd") if rootless else ("", "/etc/containers/systemd")
    sudo = "" if rootless else "sudo "
    lines = [
        f"# {call.name} at boot, by podman 4.9 or newer. Written by rosml run --export quadlet.",
        f"#   mkdir -p {folder}, and put this file there as {call.name}.container",
        f"#   {sudo}systemctl {user}daemon-reload && {sudo}systemctl {user}start {call.name}",
        *(["#   loginctl enable-linger, so that it starts at boot and not when you log in"] if rootless else []),
        "",
        "[Unit]",
        f"Description={call.name}",
        *([] if rootless else ["Wants=network-online.target", "After=network-online.target"]),
        "",
        "[Container]",
        f"Image={_image(call.image)}",
        *dict.fromkeys(line for option in _last(call.options) for line in _lines(option, call)),
        *([f"Exec={' '.join(map(_argument, call.command))}"] if call.command else []),
        "",
        "[Service]",
        *_policy(call),
        "",
        "[Install]",
        f"WantedBy={'default' if rootless else 'multi-user'}.target",
    ]
    return "\n".join(lines) + "\n"


def _last(options: Sequence[Option]) -> list[Option]:
    """The options that count: of two that set the same thing, the last one."""
    by_key: dict[object, Option] = {}
    for number, option in enumerate(options):
        key: object = number
        if option.name in SINGLE:
            key = option.name
        elif option.name in QUOTED_KEYS:
            key = option.name, (option.value or "").partition("=")[0]
        by_key[key] = option
    return [*by_key.values()]


def _lines(option: Option, call: Call) -> Iterator[str]:
    name = option.name
    if name in (*DROPPED, "restart"):
        return
    if name in OF_DOCKER or name in OF_THE_GENERATOR:
        why = "podman has no such option" if name in OF_DOCKER else "podman's generator decides that"
        raise RosmlError(f"--{name} does not go with --export {KIND}: {why}", f"leave out --{name}", exit_code=2)
    if option.value is not None:
        anchored = paths.anchored(TypedOption((f"--{name}={option.value}",), (name,), option.value), call.folder)
        option = replace(option, value=anchored.value)
    value = option.value or ""
    if name == "gpus":
        yield from (f"AddDevice=nvidia.com/gpu={gpu_id}" for gpu_id in _gpu_ids(option))
    elif name in QUOTED_KEYS and ("=" in value or name != "env"):
        yield f"{QUOTED_KEYS[name]}={_quoted(value if '=' in value else f'{value}=')}"
    elif name == "env":
        if not VARIABLE.fullmatch(value):
            raise RosmlError(f"{value!a} is no name of a variable", "write -e NAME=VALUE", exit_code=2)
        yield f"# {value} has the value of systemd's environment: systemctl set-environment, or write -e {value}=…"
        yield f"PodmanArgs={_argument(f'--env={value}')}"
    elif name == "user" and (ids := re.fullmatch(r"([0-9]+)(?::([0-9]+))?", value)):
        yield f"User={ids[1]}"
        yield from [f"Group={ids[2]}"] if ids[2] else []
    elif name == "security-opt" and value in SECURITY_KEYS:
        yield f"{SECURITY_KEYS[value]}=true"
    elif name in KEYS and _fits(name, value):
        yield f"{KEYS[name]}={value}"
    else:
        long = {"dns-opt": "dns-option"}.get(name, name)
        yield f"PodmanArgs={_argument(f'--{long}' if option.value is None else f'--{long}={value}')}"


def _fits(name: str, value: str) -> bool:
    """Whether a key without quotes takes a value, and takes it for nothing else."""
    if name == "publish":
        return PORT.fullmatch(value) is not None
    source = value.partition(":")[0]
    return PLAIN.fullmatch(value) is not None and not source.endswith(UNIT_SUFFIXES)


def _gpu_ids(option: Option) -> Sequence[str]:
    """The names of GPUs in CDI."""
    requested = gpus(option)
    if requested.driver not in ("", "nvidia") or requested.capabilities:
        text = f"--gpus {option.value} does not go with --export {KIND}: podman hands in whole GPUs of NVIDIA's"
        raise RosmlError(text, "write all, a number, or device= with ids", exit_code=2)
    if odd := [gpu_id for gpu_id in requested.ids if not PLAIN.fullmatch(gpu_id)]:
        raise RosmlError(f"--gpus: {odd[0]!a} is no id of a GPU", "nvidia-smi -L lists them", exit_code=2)
    if requested.ids or requested.count in ("all", "-1"):
        return requested.ids or ["all"]
    count = int(requested.count) if COUNT.fullmatch(requested.count) else 0
    if not 0 < count <= 64:
        raise RosmlError(f"--gpus {option.value} asks for no GPU", "leave out --gpus, or write all", exit_code=2)
    return [*map(str, range(count))]


def _policy(call: Call) -> Iterator[str]:
    """When systemd starts it again, and how long it waits for a start and a stop."""
    policy, timeout = (call.values("restart") or ["always"])[-1], call.value("stop-timeout")
    if policy not in RESTARTS:
        text = f"--restart {policy} does not go with --export {KIND}: systemd has no such rule"
        raise RosmlError(text, f"write one of {', '.join(RESTARTS)}", exit_code=2)
    yield f"Restart={RESTARTS[policy]}"
    yield "RestartSec=5"  # with less than 2, systemd gives up after 5 starts
    yield "TimeoutStartSec=900"  # the first start pulls the image; systemd's default is 90
    if timeout == "-1":
        yield "TimeoutStopSec=infinity"
    elif COUNT.fullmatch(timeout) and int(timeout) > STOP_TIMEOUT:
        yield f"TimeoutStopSec={int(timeout) + STOP_TIMEOUT}"


def _image(name: str) -> str:
    """The image's name. The generator takes `x.image` and `x.build` for files of its kind."""
    if not PLAIN.fullmatch(name):
        raise RosmlError(f"{name!a} is no name of an image in a unit", "docker tag gives it a plain name", exit_code=2)
    return f"{name}:latest" if name.endswith(UNIT_SUFFIXES) else name


def _argument(word: str) -> str:
    """A word of a command, with quotes if it needs them. The generator would lose `` and `;`, and all words after them."""
    if word in ("", ";"):
        text = f"the word {word!a} does not go with --export {KIND}: systemd does not hand it on"
        raise RosmlError(text, "write the command as one word: bash -c '…'", exit_code=2)
    return word if PLAIN.fullmatch(word) or re.fullmatch(r"-[A-Za-z0-9_/.@:+=,-]*", word) else _quoted(word)


def _quoted(word: str) -> str:
    """A word in quotes, as the generator and then systemd read it. It is an error if one of them would change a character."""
    if odd := next(filter(is_lost, word), ""):
        text = f"the character U+{ord(odd):04X} in {word[:40]!a} does not go with --export {KIND}: systemd changes it"
        raise RosmlError(text, "put it into a file that the command reads", exit_code=2)
    return f'"{word.translate(ESCAPED)}"'


def is_lost(character: str) -> bool:
    """Whether systemd refuses a character, or the generator writes it as a byte that is no text."""
    code = ord(character)
    return code in (0, 0x80) or 0xFDD0 <= code <= 0xFDEF or code & 0xFFFE == 0xFFFE
