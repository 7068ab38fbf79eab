"""The description of a call without its passing parts, from which other programs' files are written."""

from __future__ import annotations

import os
import re
from collections.abc import Sequence
from dataclasses import dataclass, replace

from rosml.base.errors import RosmlError
from rosml.run import attach, paths
from rosml.run.context import Context, Engine, Image
from rosml.run.plugins import basic_options, sockets
from rosml.run.words import Line, TypedOption, split

OF_A_CALL = ("attach", "detach", "detach-keys", "quiet", "replace", "rm", "rmi", "sig-proxy")
"""Options about how a single call waits and cleans up. Programs that start the file have their own."""

SYNONYMS = {"net": "network", "dns-option": "dns-opt"}
FIELD_SYNONYMS = {"src": "source", "dst": "target", "destination": "target", "ro": "readonly"}
WITH_NAME = ("annotation", "env", "label")
X11 = ("-v", "/tmp/.X11-unix:/tmp/.X11-unix", "-e", "DISPLAY", "-e", "QT_X11_NO_MITSHM=1")
"""Options for windows that last as long as a file: the sockets of all displays, and the DISPLAY of the user who starts it."""


@dataclass(frozen=True)
class Option:
    """An option of the engine by its long name; the value of a switch is None."""

    name: str
    value: str | None = None

    @property
    def is_on(self) -> bool:
        return self.value is None or self.value.lower() in ("1", "t", "true")


@dataclass(frozen=True)
class Call:
    """A call: the one description from which all files are written."""

    name: str  # that of --name, or from the folder
    options: tuple[Option, ...]  # if two set the same thing, the last one counts
    image: str
    command: tuple[str, ...]
    folder: str  # the current one
    place: str  # the folder for which the file is; paths in it are relative there
    engine: Engine
    about: Image

    def values(self, name: str) -> list[str]:
        """The values of an option, in their order."""
        return [option.value or "" for option in self.options if option.name == name]

    def value(self, name: str) -> str:
        """The last value of an option; empty if there is none."""
        return (self.values(name) or [""])[-1]


def lasting(context: Context) -> Context:
    """The context as on a terminal, without the parts of a session: the cookie of X11, and the socket of ssh's agent."""
    line = context.line
    if line.asks("ssh-agent"):
        text = "--ssh-agent does not go with --export: the agent's socket has another path in each session"
        raise RosmlError(text, "leave it out; editors pass your agent themselves", exit_code=2)
    line = replace(line, rosml=(*line.rosml, "--no-name", "--no-x11"))
    line = preceded(line, *(X11 if _has_windows(context) else ()))
    return replace(context, line=line, person=replace(context.person, terminal=True, reads=True))


def sessionless(context: Context, kind: str) -> Context:
    """The context of a service, which starts before anybody logs in: no terminal, no windows, no sockets of a session."""
    if option := next((name for name in ("ssh-agent", "sound", "wayland") if context.line.asks(name)), ""):
        text = f"--{option} does not go with --export {kind}: its socket is there while you are logged in"
        raise RosmlError(text, "leave it out, or mount a socket that lasts with -v", exit_code=2)
    rosml_words = (*context.line.rosml, "--no-name", "--no-x11", "--no-it")
    return replace(context, line=replace(context.line, rosml=rosml_words))


def lacking_command(call: Call) -> list[tuple[str, str]]:
    """A warning if a service would start a shell, which ends at once because it has no terminal; with its remedy."""
    if call.command or call.values("entrypoint") or not attach.is_shell(call.about.command):
        return []
    text = f"no command is written, and {call.image} starts {call.about.command[0]!a}, which ends at once without a terminal"
    return [(text, "write the command after the image, such as ros2 launch PACKAGE FILE")]


def preceded(line: Line, *words: str) -> Line:
    """The line with more options of the engine before the typed ones."""
    return replace(line, engine=(*split([*words, line.image], ()).engine, *line.engine))


def _has_windows(context: Context) -> bool:
    """Whether X11 shows windows of this machine. A display of `ssh -X` is gone when the file is used."""
    line, host = context.line, context.host
    display = sockets.DISPLAY.fullmatch(host.environment.get("DISPLAY", ""))
    if line.asks("no-x11") or line.sets("DISPLAY") or not context.is_here or not display:
        return False
    return display["machine"] in ("", "unix") and host.has(f"/tmp/.X11-unix/X{display['number']}")


def describe(context: Context, argv: Sequence[str], place: str = "") -> Call:
    """Describes the engine's command. `place` is the folder for which the file is; by default the current one."""
    for word in argv:
        try:
            word.encode()
        except UnicodeEncodeError:
            raise RosmlError(f"--export: {word!a} is no text", "write it in UTF-8", exit_code=2) from None
    line, person = split(argv[2:], ()), replace(context.person, terminal=True)
    options = tuple(option for typed in line.engine for option in _options(typed) if option.name not in OF_A_CALL)
    name = _typed_name(options) or basic_options.name_of(Line((), (), line.image, ()), person) or "container"
    place = place or person.folder
    return Call(name, options, line.image, line.command, person.folder, place, context.engine, context.image)


def _options(typed: TypedOption) -> list[Option]:
    """The options in a word, such as `-itv`; only the last one can have a value."""
    *switches, last = (SYNONYMS.get(name, name) for name in typed.names)
    return [*map(Option, switches), Option(last, typed.value)]


def _typed_name(options: Sequence[Option]) -> str:
    """The value of --name; empty if there is none. The engines look at names before they start anything, so we do as well."""
    name = ""
    for option in options:
        value = option.value or ""
        if option.name == "name":
            name = value
            if basic_options.as_name(value) != value or not value:
                remedy = "write letters, digits, and then also _ . -"
                raise RosmlError(f"--name {value!a} is no name of a container", remedy, exit_code=2)
        elif option.name in WITH_NAME and not value.partition("=")[0]:
            raise RosmlError(f"--{option.name} {value!a} has no name", f"write --{option.name} NAME=VALUE", exit_code=2)
    return name


def fields(option: Option) -> list[tuple[str, str]]:
    """The fields of a value such as `type=bind,source=/a,target=/b`; a switch among them has an empty value."""
    row = paths.fields(option.value or "")
    if row is None:
        text = f"--{option.name}={option.value}: its quotes do not close"
        raise RosmlError(text, 'write one " at each end', exit_code=2)
    return [(FIELD_SYNONYMS.get(key, key), value) for key, _, value in (field.partition("=") for field in row)]


def placed(path: str, call: Call, start: str) -> str:
    """A path. If it lies in the folder of the file, it begins with `start` instead, so that the file works elsewhere."""
    if call.place == "/" or not f"{path}/".startswith(f"{call.place}/"):
        return path
    return start + path[len(call.place) :]


def file(option: Option, call: Call, start: str) -> str:
    """The value of an option that is a file of this machine; a relative path begins at the current folder."""
    return placed(os.path.normpath(os.path.join(call.folder, option.value or "")), call, start)


def volume(option: Option, call: Call, start: str) -> str:
    """The value of `-v`, with its folder as `placed` has it. Without a colon it is a place in the container."""
    source, colon, rest = (option.value or "").partition(":")
    return placed(source, call, start) + colon + rest if colon else source


CERTAIN = """for certain GPUs: --gpus '"device=0,1"'"""
COUNT = re.compile("[0-9]{1,18}")


@dataclass(frozen=True)
class Gpus:
    """The GPUs of `--gpus`. `count` is `all`, a number, or another text, which the engine refuses; empty if there are ids."""

    count: str
    ids: tuple[str, ...]
    driver: str
    capabilities: tuple[str, ...]


def gpus(option: Option) -> Gpus:
    """GPUs, from `all`, `2`, `device=0`, `"device=0,1"`, or more fields. Of several numbers such as `0,1`, docker takes the last one,
    which nobody means: they are an error."""
    values: dict[str, str] = {}
    for key, value in fields(option):
        is_count = key in ("all", "count") or COUNT.fullmatch(key)
        name, value = ("count", value or key) if is_count else (key, value)
        if name not in ("count", "device", "driver", "capabilities"):
            remedy = f"leave out {name}: write all, a number, or device= with ids"
            raise RosmlError(f"{name} of --gpus has no counterpart in such a file", remedy, exit_code=2)
        if name in values:
            raise RosmlError(f"--gpus {option.value} says {name} twice", CERTAIN, exit_code=2)
        values[name] = value
    ids, capabilities = (tuple(filter(None, values.get(name, "").split(","))) for name in ("device", "capabilities"))
    if ids and "count" in values:
        raise RosmlError(f"--gpus {option.value} says both how many and which", CERTAIN, exit_code=2)
    return Gpus(values.get("count", "" if ids else "1"), ids, values.get("driver", ""), capabilities)
