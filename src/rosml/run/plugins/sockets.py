"""Sockets of the user's session: windows of X11 and Wayland, sound, ssh's agent."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence

from rosml.base.errors import RosmlError
from rosml.run.context import Container, Context, Host, Person
from rosml.run.paths import bind
from rosml.run.plugin import NOTHING, Added, Plugin
from rosml.run.plugins import xauthority
from rosml.run.plugins.places import OWN_NETWORK, ROS_NETWORK, no_network
from rosml.run.words import variables

MOUNT_FOLDER = "/run/rosml"
COOKIE = f"{MOUNT_FOLDER}/xauth"
DISPLAY = re.compile(r"(?P<machine>[^:/]*)(?:/unix)?:(?P<number>[0-9]{1,4})(?:\.[0-9]+)?")
LOCALHOST = ("localhost", "127.0.0.1")
SNAP = "docker is a snap here, and a snap does not see the sockets of your session"
OTHER = "install another docker: snap remove docker; apt-get install docker.io"


def runtime(host: Host, person: Person) -> str:
    """The folder of the user's session, until they log out; empty if they have none. sudo may leave another user's folder in the
    environment."""
    places = (host.environment.get("XDG_RUNTIME_DIR", "").rstrip("/"), f"/run/user/{person.uid}")
    return next((x for x in places if x.startswith("/") and host.owner(x)[0] == person.uid), "")


def mounted(source: str, target: str) -> list[str]:
    return ["--mount", bind(source, target)]


def _reaches(context: Context, option: str) -> bool:
    """Whether the engine sees the sockets of the user's session: another machine or a snap does not. If the user asks for one of
    them by an option, that is an error."""
    engine = context.engine
    if context.is_here and not engine.snap:
        return True
    if context.line.asks(option) and engine.snap:
        raise RosmlError(f"--{option}: {SNAP}", f"leave out --{option}, or {OTHER}")
    if context.line.asks(option):
        text = f"--{option}: {engine.program} runs containers on {engine.machine}, and not here"
        raise RosmlError(text, f"leave out --{option}, or call it there")
    return False


def windows(context: Context) -> Added:
    """The display that answers: X11's; Wayland's if there is no X11, or if the user asks for it."""
    line = context.line
    wants_x11 = not (line.asks("no-x11") or line.sets("DISPLAY"))
    if not _reaches(context, "wayland"):
        misses_x11 = wants_x11 and context.host.environment.get("DISPLAY") and context.is_here
        return Added(notes=[(f"no windows: {SNAP}", f"{OTHER}; --no-x11 asks for none")] if misses_x11 else [])
    x11 = _x11(context) if wants_x11 else NOTHING
    if not line.asks("wayland") and (x11.words or not wants_x11 or line.sets("WAYLAND_DISPLAY")):
        return x11
    wayland = _wayland(context)
    if line.asks("wayland") and not wayland:
        text = "--wayland: no Wayland socket answers here"
        raise RosmlError(text, "call it in a Wayland session; X11 needs no option")
    return Added([*x11.words, *wayland], x11.files) if wayland else x11


def _x11(context: Context) -> Added:
    """X11, if DISPLAY answers. Its cookie alone is in a file for each display, which only this user can read."""
    host, display = context.host, context.host.environment.get("DISPLAY", "")
    match = DISPLAY.fullmatch(display)
    if not match:
        return NOTHING
    machine, number = match["machine"], match["number"]
    socket = f"/tmp/.X11-unix/X{number}"
    if machine in ("", "unix"):
        if not host.answers(socket):
            return NOTHING
        words = [*mounted(socket, socket), *variables({"DISPLAY": f":{number}"})]
    else:
        if not host.connects((machine, 6000 + int(number))):
            return NOTHING
        local = machine in LOCALHOST
        if local and (reason := no_network(context)):
            return Added(notes=[(f"no windows: DISPLAY={display} is ssh's, and {reason}", "--no-x11 asks for none")])
        chooses_network = context.line.has(*OWN_NETWORK) or context.line.asks(ROS_NETWORK)
        words = [*(["--network", "host"] if local and not chooses_network else []), *variables({"DISPLAY": display})]
    words += variables({"QT_X11_NO_MITSHM": "1"})  # the container shares no memory with the display
    cookie = _cookie(host, machine, number)
    if not cookie:  # the display may admit every process of this uid
        return Added(words)
    folder = runtime(context.host, context.person)
    if not folder:
        remedy = "log in again, or name a folder of yours with XDG_RUNTIME_DIR; --no-x11 asks for none"
        return Added(notes=[("no windows: there is no place for the display's cookie", remedy)])
    file = f"{folder}/rosml/xauth-{number}"
    words += ["--mount", f"{bind(file, COOKIE)},readonly", *variables({"XAUTHORITY": COOKIE})]
    return Added(words, {file: xauthority.written([cookie])})


def _cookie(host: Host, machine: str, number: str) -> xauthority.Entry | None:
    """The user's cookie for a display, from the machine and the number of `DISPLAY`."""
    place = host.environment.get("XAUTHORITY") or f"{host.environment.get('HOME', '')}/.Xauthority"
    owner = host.name if machine in ("", "unix", *LOCALHOST) else machine
    return xauthority.cookie(xauthority.read(host.content(place)), number, owner, host.name)


def files_again(host: Host, person: Person, container: Container) -> Mapping[str, bytes]:
    """The session's files that a container has mounted. Write them before it starts again: a logout has removed them, and the
    display has a new cookie. Without a cookie the file is empty, and the container starts without windows."""
    source, display = container.sources.get(COOKIE, ""), DISPLAY.fullmatch(container.environment.get("DISPLAY", ""))
    if not display or source != f"{runtime(host, person)}/rosml/xauth-{display['number']}":
        return {}
    cookie = _cookie(host, display["machine"], display["number"])
    return {source: xauthority.written([cookie] if cookie else [])}


def _wayland(context: Context) -> list[str]:
    """Wayland's socket, and the variables of Qt and GTK; nothing if none answers."""
    name, folder = context.host.environment.get("WAYLAND_DISPLAY") or "wayland-0", runtime(context.host, context.person)
    socket = name if name.startswith("/") else f"{folder}/{name}" if folder else ""
    if not socket or not context.host.answers(socket):
        return []
    inside, socket_name = f"/run/user/{context.person.uid}", name.rpartition("/")[2]
    toolkits = variables({"QT_QPA_PLATFORM": "wayland;xcb", "GDK_BACKEND": "wayland,x11"})
    session = variables({"XDG_RUNTIME_DIR": inside, "WAYLAND_DISPLAY": socket_name})
    return [*mounted(socket, f"{inside}/{socket_name}"), *session, *toolkits]


def sound(context: Context) -> Sequence[str]:
    """PulseAudio's socket, which PipeWire also has, and PipeWire's own."""
    host, line, folder = context.host, context.line, runtime(context.host, context.person)
    if not _reaches(context, "sound") or not line.asks("sound") or line.sets("PULSE_SERVER"):
        return []
    inside = f"/run/user/{context.person.uid}"
    server = host.environment.get("PULSE_SERVER", "").removeprefix("unix:")
    pulse = server if server.startswith("/") else f"{folder}/pulse/native"
    words = []
    if (server or folder) and host.answers(pulse):
        words += mounted(pulse, f"{inside}/pulse/native")
        words += variables({"PULSE_SERVER": f"unix:{inside}/pulse/native"})
    if folder and host.answers(f"{folder}/pipewire-0"):
        words += mounted(f"{folder}/pipewire-0", f"{inside}/pipewire-0")
        words += variables({"PIPEWIRE_RUNTIME_DIR": inside})
    if not words:
        raise RosmlError("--sound: neither PulseAudio nor PipeWire answers here", "start it, or leave out --sound")
    return words


def ssh_agent(context: Context) -> Sequence[str]:
    line = context.line
    if not _reaches(context, "ssh-agent") or not line.asks("ssh-agent") or line.sets("SSH_AUTH_SOCK"):
        return []
    socket, target = context.host.environment.get("SSH_AUTH_SOCK", ""), f"{MOUNT_FOLDER}/ssh-agent"
    if not socket.startswith("/") or not context.host.answers(socket):
        raise RosmlError("--ssh-agent: no agent answers here", 'eval "$(ssh-agent)"; ssh-add')
    return [*mounted(socket, target), *variables({"SSH_AUTH_SOCK": target})]


PLUGINS = (
    Plugin("windows", windows, {"no-x11": "no windows", "wayland": "windows by Wayland, also if X11 answers"}),
    Plugin("sound", sound, {"sound": "sound, by PulseAudio or PipeWire"}),
    Plugin(
        "ssh-agent", ssh_agent, {"ssh-agent": "the keys of your ssh agent, which the container can use but not read"}
    ),
)
