"""Windows, sound and ssh's agent in a container, by the files and listeners of a machine."""

from __future__ import annotations

import contextlib
import os
import shutil
import socket
import stat
import subprocess
from collections.abc import Iterator
from pathlib import Path

import pytest

from fakes.desks import docker_desk
from fakes.run_machines import Machine
from rosml.base.errors import RosmlError
from rosml.run import host
from rosml.run.context import Engine, Person
from rosml.run.plugin import Added
from rosml.run.plugins import gpu, sockets, xauthority
from rosml.run.plugins.xauthority import LOCAL, WILD, Entry

UID, GID = os.geteuid(), os.getegid()
RUNTIME = f"/run/user/{UID}"
COOKIE = Entry(LOCAL, b"robot", b"0", b"MIT-MAGIC-COOKIE-1", bytes(range(16)))
SSH = Entry(LOCAL, b"robot", b"10", b"MIT-MAGIC-COOKIE-1", b"s" * 16)
OTHER_MACHINE = Entry(LOCAL, b"laptop", b"0", b"MIT-MAGIC-COOKIE-1", b"x" * 16)
ANYWHERE = Entry(WILD, b"", b"0", COOKIE.kind, COOKIE.secret)
X0 = "/tmp/.X11-unix/X0"
SHOWN = ["--mount", f"type=bind,source={X0},target={X0}", "-e", "DISPLAY=:0", "-e", "QT_X11_NO_MITSHM=1"]
WITH_COOKIE = [
    *("--mount", f"type=bind,source={RUNTIME}/rosml/xauth-0,target=/run/rosml/xauth,readonly"),
    *("-e", "XAUTHORITY=/run/rosml/xauth"),
]
WAYLAND = [
    *("--mount", f"type=bind,source={RUNTIME}/wayland-1,target={RUNTIME}/wayland-1"),
    *("-e", f"XDG_RUNTIME_DIR={RUNTIME}", "-e", "WAYLAND_DISPLAY=wayland-1"),
    *("-e", "QT_QPA_PLATFORM=wayland;xcb", "-e", "GDK_BACKEND=wayland,x11"),
]


@pytest.fixture
def x11(tmp_path: Path) -> Machine:
    """A machine on whose display :0 somebody works."""
    machine = Machine(tmp_path / "root", Person(UID, GID, "me", "/home/me"))
    machine.socket(X0)
    machine.file("/home/me/.Xauthority", xauthority.written([OTHER_MACHINE, COOKIE, SSH]))
    machine.file(f"{RUNTIME}/bus")
    machine.environment |= {"DISPLAY": ":0", "HOME": "/home/me", "XDG_RUNTIME_DIR": RUNTIME}
    return machine


@pytest.mark.parametrize("display", [":0", ":0.0", "unix:0", "robot/unix:0.1"])
def test_a_display_that_answers(x11: Machine, display: str) -> None:
    """The container gets the cookie of its display alone, also if the file has others of another call."""
    x11.environment["DISPLAY"] = display
    x11.listens.add(("robot", 6000))
    x11.file(f"{RUNTIME}/rosml/xauth-0", xauthority.written([Entry(WILD, b"", b"10", b"k", b"o"), COOKIE]))
    added = sockets.windows(x11.context())
    assert [*added.words[-4:]] == WITH_COOKIE and ("robot" in display or [*added.words[:-4]] == SHOWN)
    assert xauthority.read(added.files[f"{RUNTIME}/rosml/xauth-0"]) == [ANYWHERE]


@pytest.mark.parametrize("display", ["", ":1", "nonsense", ":0x", "localhost:10", "/private/tmp/x:0"])
def test_a_display_that_does_not_answer(x11: Machine, display: str) -> None:
    x11.environment["DISPLAY"] = display
    assert sockets.windows(x11.context()) == Added()


@pytest.mark.parametrize("words", [["--no-x11"], ["-e", "DISPLAY=:7"], ["--env=DISPLAY"]])
def test_the_user_chooses_the_display(x11: Machine, words: list[str]) -> None:
    x11.socket(f"{RUNTIME}/wayland-0")
    assert sockets.windows(x11.context(*words)) == Added()


def test_a_display_of_another_machine_gets_no_cookie_of_this_one(x11: Machine) -> None:
    """Both may have the same number."""
    x11.environment["DISPLAY"] = "laptop:0"
    x11.listens.add(("laptop", 6000))
    (content,) = sockets.windows(x11.context()).files.values()
    assert [entry.secret for entry in xauthority.read(content)] == [OTHER_MACHINE.secret]
    x11.file("/home/me/.Xauthority", xauthority.written([COOKIE]))
    assert sockets.windows(x11.context()).files == {}
    x11.environment |= {"DISPLAY": ":0", "XAUTHORITY": "/none"}
    assert sockets.windows(x11.context()) == Added(SHOWN), "a display may need none"


def test_a_cookie_without_a_place(x11: Machine) -> None:
    """The folder of somebody else's session, as sudo leaves it in the environment, is none."""
    shutil.rmtree(x11.root / "run")
    x11.environment["XDG_RUNTIME_DIR"] = "/run/user/77"
    added = sockets.windows(x11.context())
    assert not added.words and not added.files and "no place for the display's cookie" in added.notes[0][0]
    x11.file(f"{RUNTIME}/bus")
    assert [*sockets.windows(x11.context()).files] == [f"{RUNTIME}/rosml/xauth-0"]
    assert sockets.windows(x11.context(me=Person(UID + 1, GID, "nobody", "/"))).files == {}


@pytest.mark.parametrize(
    ("words", "engine", "reason"),
    [
        ([], Engine(), ""),
        (["--network", "host"], Engine(), ""),
        (["-p", "80:80"], Engine(), "does not go with -p"),
        ([], Engine(rootless=True), "docker without root does not reach this machine"),
        ([], Engine("podman", podman=True, rootless=True), ""),
    ],
)
def test_a_display_of_ssh(x11: Machine, words: list[str], engine: Engine, reason: str) -> None:
    """It listens on this machine's localhost alone."""
    x11.environment["DISPLAY"] = "localhost:10.0"
    x11.listens = {("localhost", 6010)}
    added = sockets.windows(x11.context(*words, engine=engine))
    if reason:
        ((text, _),) = added.notes
        assert added.words == () and "DISPLAY=localhost:10.0 is ssh's" in text and reason in text
        x11.socket(f"{RUNTIME}/wayland-0")
        assert "WAYLAND_DISPLAY=wayland-0" in sockets.windows(x11.context(*words, engine=engine)).words
        return
    network = [] if words else ["--network", "host"]
    cookie = [word.replace("xauth-0", "xauth-10") for word in WITH_COOKIE]
    assert [*added.words] == [*network, "-e", "DISPLAY=localhost:10.0", "-e", "QT_X11_NO_MITSHM=1", *cookie]
    (entry,) = xauthority.read(added.files[f"{RUNTIME}/rosml/xauth-10"])
    assert (entry.number, entry.secret) == (b"10", SSH.secret)


def test_a_damaged_file_of_cookies() -> None:
    whole = xauthority.written([COOKIE, SSH])
    assert xauthority.read(whole) == [COOKIE, SSH]
    assert all(xauthority.read(whole[:end]) in ([], [COOKIE]) for end in range(len(whole)))
    assert xauthority.read(b"\xff" * 5) == [] and xauthority.cookie([], "0", "robot", "robot") is None


@pytest.mark.skipif(not shutil.which("xauth"), reason="no xauth is here")
def test_xauth_reads_and_writes_the_same_files(tmp_path: Path) -> None:
    theirs, ours = tmp_path / "theirs", tmp_path / "ours"
    add = ["xauth", "-f", str(theirs), "add", "robot/unix:3", ".", "ab" * 16]
    subprocess.run(add, check=True, capture_output=True)
    (entry,) = xauthority.read(theirs.read_bytes())
    assert (entry.number, entry.secret.hex()) == (b"3", "ab" * 16)
    cookie = xauthority.cookie([entry], "3", "robot", "robot")
    ours.write_bytes(xauthority.written([cookie] if cookie else []))
    listed = subprocess.run(["xauth", "-f", str(ours), "nlist"], capture_output=True, text=True, check=True).stdout
    assert listed.split() == ["ffff", "0000", "0001", "33", "0012", b"MIT-MAGIC-COOKIE-1".hex(), "0010", "ab" * 16]


def test_wayland(x11: Machine) -> None:
    """If no X11 answers, or somebody asks for it."""
    x11.environment["WAYLAND_DISPLAY"] = "wayland-1"
    x11.socket(f"{RUNTIME}/wayland-1")
    assert [*sockets.windows(x11.context()).words] == [*SHOWN, *WITH_COOKIE]
    assert [*sockets.windows(x11.context("--wayland")).words] == [*SHOWN, *WITH_COOKIE, *WAYLAND]
    assert [*sockets.windows(x11.context("--wayland", "--no-x11")).words] == WAYLAND
    x11.listens.discard(str(x11.root / X0[1:]))
    assert [*sockets.windows(x11.context()).words] == WAYLAND
    assert sockets.windows(x11.context("-e", "WAYLAND_DISPLAY=x")) == Added()
    x11.environment["WAYLAND_DISPLAY"] = f"{RUNTIME}/wayland-1"
    assert [*sockets.windows(x11.context()).words] == WAYLAND
    x11.listens.clear()
    assert sockets.windows(x11.context()) == Added()
    with pytest.raises(RosmlError, match="no Wayland socket answers"):
        sockets.windows(x11.context("--wayland"))


def test_sound(x11: Machine) -> None:
    with pytest.raises(RosmlError, match="neither PulseAudio nor PipeWire"):
        sockets.sound(x11.context("--sound"))
    x11.socket(f"{RUNTIME}/pulse/native")
    pulse = ["--mount", f"type=bind,source={RUNTIME}/pulse/native,target={RUNTIME}/pulse/native"]
    pulse += ["-e", f"PULSE_SERVER=unix:{RUNTIME}/pulse/native"]
    assert sockets.sound(x11.context("--sound")) == pulse and sockets.sound(x11.context()) == []
    x11.socket(f"{RUNTIME}/pipewire-0")
    pipewire = ["--mount", f"type=bind,source={RUNTIME}/pipewire-0,target={RUNTIME}/pipewire-0"]
    pipewire += ["-e", f"PIPEWIRE_RUNTIME_DIR={RUNTIME}"]
    assert sockets.sound(x11.context("--sound")) == [*pulse, *pipewire]
    assert sockets.sound(x11.context("--sound", "-e", "PULSE_SERVER=x")) == []
    x11.environment["PULSE_SERVER"] = "unix:/tmp/pulse"
    assert sockets.sound(x11.context("--sound")) == pipewire
    x11.socket("/tmp/pulse")
    assert sockets.sound(x11.context("--sound"))[1].startswith("type=bind,source=/tmp/pulse,")


def test_the_agent_of_ssh(x11: Machine) -> None:
    for address in ("", "/tmp/ssh-x/agent.1"):
        x11.environment["SSH_AUTH_SOCK"] = address
        with pytest.raises(RosmlError, match="no agent answers"):
            sockets.ssh_agent(x11.context("--ssh-agent"))
    x11.socket("/tmp/ssh-x/agent.1")
    assert sockets.ssh_agent(x11.context()) == []
    assert sockets.ssh_agent(x11.context("--ssh-agent")) == [
        *("--mount", "type=bind,source=/tmp/ssh-x/agent.1,target=/run/rosml/ssh-agent"),
        *("-e", "SSH_AUTH_SOCK=/run/rosml/ssh-agent"),
    ]
    assert sockets.ssh_agent(x11.context("--ssh-agent", "-e", "SSH_AUTH_SOCK=x")) == []


@pytest.fixture
def session(x11: Machine) -> Machine:
    """A machine on which all sockets of a session answer, with a GPU."""
    for place in ("/agent", f"{RUNTIME}/pulse/native", f"{RUNTIME}/wayland-0", "/dev/dri/card0"):
        x11.socket(place)
    x11.environment["SSH_AUTH_SOCK"] = "/agent"
    return x11


def refused(session: Machine, engine: Engine, why: str) -> None:
    """Whoever asks for a socket that the engine does not see gets an error."""
    for concern, option in ((sockets.windows, "wayland"), (sockets.sound, "sound"), (sockets.ssh_agent, "ssh-agent")):
        with pytest.raises(RosmlError, match=f"--{option}: {why}"):
            concern(session.context(f"--{option}", engine=engine))


@pytest.mark.parametrize(
    ("engine", "files", "here"),
    [
        (Engine(machine="robot"), [], True),
        (Engine(machine="server"), [], False),
        (Engine(machine="docker-desktop"), [], False),
        (Engine(machine="docker-desktop"), ["/dev/dxg"], True),
    ],
)
def test_an_engine_on_another_machine_gets_nothing(
    session: Machine, engine: Engine, files: list[str], here: bool
) -> None:
    for file in files:
        session.file(file)
    context = session.context("--sound", "--ssh-agent", engine=engine)
    assert bool(gpu.gpu(context).words) == bool(sockets.windows(context).words) == here
    assert bool(sockets.windows(context).files) == here
    if here:
        assert sockets.sound(context) and sockets.ssh_agent(context)
        return
    refused(session, engine, "docker runs containers on")


def test_an_engine_that_is_a_snap(session: Machine) -> None:
    """It has its own /tmp and /run: with a mount from there, nothing would start. It has GPUs."""
    snap = Engine(snap=True)
    added = sockets.windows(session.context(engine=snap))
    ((text, remedy),) = added.notes
    assert not added.words and not added.files and "docker is a snap" in text and "--no-x11" in remedy
    assert not sockets.windows(session.context("--no-x11", engine=snap)).notes
    assert gpu.gpu(session.context(engine=snap)).words
    refused(session, snap, "docker is a snap")


@contextlib.contextmanager
def listening(path: Path) -> Iterator[None]:
    """Listens at a path, which may be longer than an address can be."""
    path.parent.mkdir(parents=True)
    with socket.socket(socket.AF_UNIX) as server, contextlib.chdir(path.parent):
        server.bind(path.name)
        server.listen()
        yield


def test_the_cookie_is_in_a_private_file(tmp_path: Path) -> None:
    """It is written when the container starts, and is the only file that remains."""
    desk = docker_desk(tmp_path)
    folder = desk.root / RUNTIME[1:]
    folder.mkdir(parents=True)
    (desk.root / "c").write_bytes(xauthority.written([Entry(LOCAL, b"x", b"0", b"k", b"secret")]))
    environment = {"DISPLAY": ":0", "XAUTHORITY": "/c", "XDG_RUNTIME_DIR": RUNTIME}
    file = folder / "rosml/xauth-0"
    with listening(desk.root / X0[1:]):
        shown = desk.call("--dry-run", "ubuntu", **environment)
        assert "DISPLAY=:0" in shown.stdout and "secret" not in shown.stdout and not [*folder.iterdir()]
        mask = os.umask(0)
        try:
            done = desk.call("ubuntu", **environment)
        finally:
            os.umask(mask)
        assert (done.returncode, done.stderr) == (0, "")
        first = file.stat()
        assert stat.S_IMODE(first.st_mode) == 0o600 and stat.S_IMODE(file.parent.stat().st_mode) == 0o700
        assert desk.call("ubuntu", **environment).returncode == 0
        assert file.stat().st_ino == first.st_ino, "containers have it mounted"
        file.chmod(0o644)
        assert desk.call("ubuntu", **environment).returncode == 0 and stat.S_IMODE(file.stat().st_mode) == 0o600
    assert [path.name for path in folder.rglob("*")] == ["rosml", "xauth-0"] and b"secret" in file.read_bytes()
    assert desk.call("ubuntu", **environment).returncode == 0 and "DISPLAY=:0" not in desk.calls[-1]


def test_what_listens(tmp_path: Path) -> None:
    with listening(tmp_path / "x/s"), contextlib.chdir(tmp_path / "x"):
        assert host.connects("s") and not host.connects("t")
    with contextlib.chdir(tmp_path / "x"):
        assert not host.connects("s"), "the socket of a server that is gone"
    with socket.create_server(("127.0.0.1", 0)) as server:
        port = server.getsockname()[1]
        assert host.connects(("localhost", port))
    assert not host.connects(("localhost", port)) and not host.connects("x" * 200)
    assert not host.connects(("a..b", 1)) and not host.connects(("127.0.0.1", 99999))


def test_addresses_and_multicast_of_this_machine() -> None:
    assert host.owns("127.0.0.1") and host.owns("localhost") and not host.owns("192.0.2.1") and not host.owns("a..b")
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as node:
        node.bind(("", 0))
        port = node.getsockname()[1]
        try:
            node.connect((host.GROUP, port))
            routed = True
        except OSError:
            routed = False
        assert host.echoes(port) == routed, "a node has the port for itself"
    assert host.echoes(port) == routed
