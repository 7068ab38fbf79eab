"""Plugins of `rosml run`: GPUs, windows, sound and ssh's agent of a machine whose files are in a folder; and those of other
packages, good and broken."""

from __future__ import annotations

import contextlib
import os
import re
import shutil
import socket
import stat
import subprocess
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import click
import pytest
from conftest import ROOT

from fakes.desks import BARE, DOCKER, OURS, PODMAN, Desk, plain
from rosml.base.errors import RosmlError
from rosml.cli.run import run
from rosml.images.image_set import labels
from rosml.run import host
from rosml.run.context import Address, Context, Engine, Host, Image, Person
from rosml.run.plan import make_plan
from rosml.run.plugin import Added, Plugin
from rosml.run.plugins import chips, devices, discovery, gpu, sockets, xauthority
from rosml.run.plugins.discovery import BUILT_IN, in_order
from rosml.run.plugins.xauthority import LOCAL, WILD, Entry
from rosml.run.words import split

UID, GID = os.geteuid(), os.getegid()
ME = Person(UID, GID, "me", "/home/me")
OWN = [name for option in run.main.get_params(click.Context(run.main)) for name in option.opts if name.startswith("--")]
CDI = ["--device", "nvidia.com/gpu=all"]
RUNTIME = f"/run/user/{UID}"


class Machine:
    """A machine whose files are in a folder. Attributes: root: the folder. listens: where something listens."""

    def __init__(self, root: Path) -> None:
        self.root = root
        self.listens: set[Address] = set()
        self.environment: dict[str, str] = {}

    def file(self, place: str, content: bytes = b"") -> Path:
        """Makes a file."""
        path = self.path(place)
        path.write_bytes(content)
        return path

    def path(self, place: str) -> Path:
        """A path of the machine, in a folder that is there."""
        path = self.root / place.lstrip("/")
        path.parent.mkdir(parents=True, exist_ok=True)
        return path

    def socket(self, place: str) -> None:
        """Has something listen at a path."""
        self.listens.add(str(self.file(place)))

    def context(
        self, *words: str, engine: Engine | None = None, image: Image | None = None, me: Person = ME
    ) -> Context:
        """What is known."""
        there = Host(self.root, self.environment, "robot", self.listens.__contains__, architecture="amd64")
        return Context(split([*words, "ros:jazzy"], OWN), engine or Engine(), me, image or Image(), there)


@pytest.fixture
def machine(tmp_path: Path) -> Machine:
    """A machine with nothing."""
    return Machine(tmp_path / "root")


# ---- GPUs ------------------------------------------------------------------------------------------------------------

KNOWS_CDI = ("/etc/cdi", "/var/run/cdi")
PODMAN_ENGINE = Engine("podman", podman=True, rootless=True, cdi=KNOWS_CDI)
CARD, TEGRA = "/dev/nvidiactl", ("/dev/nvmap", "/etc/nv_tegra_release")
SPEC, HOOK = "/var/run/cdi/nvidia.yaml", "/usr/bin/nvidia-container-runtime-hook"
WSL = ("/dev/dxg", "/usr/lib/wsl/lib/libcuda.so.1")


@pytest.mark.parametrize(
    ("files", "engine", "expected"),
    [
        ([], Engine(nvidia=True), []),
        ([HOOK, SPEC], Engine(nvidia=True, cdi=KNOWS_CDI), []),
        ([CARD, HOOK], Engine(), ["--gpus", "all"]),
        ([CARD], Engine(nvidia=True), ["--gpus", "all"]),
        ([CARD, HOOK, SPEC], Engine(), ["--gpus", "all"]),  # a docker that does not know CDI
        ([CARD, HOOK, SPEC], Engine(cdi=KNOWS_CDI), CDI),
        ([CARD, HOOK, "/etc/cdi/nvidia.yaml"], Engine(cdi=KNOWS_CDI), CDI),
        ([CARD, HOOK, "/etc/cdi/other.json"], Engine(cdi=KNOWS_CDI), ["--gpus", "all"]),
        ([CARD, SPEC], PODMAN_ENGINE, CDI),
        (WSL, Engine(), ["--gpus", "all"]),
        (["/dev/dxg", HOOK], Engine(), []),  # WSL with the GPU of somebody else
        (TEGRA, Engine(nvidia=True), ["--runtime", "nvidia"]),
        ([*TEGRA, SPEC], PODMAN_ENGINE, CDI),
        (["/dev/nvmap"], Engine(nvidia=True), []),
    ],
)
def test_gpus_of_nvidia(machine: Machine, files: list[str], engine: Engine, expected: list[str]) -> None:
    for file in files:
        machine.file(file, b"kind: nvidia.com/gpu" if "nvidia.yaml" in file else b"")
    assert gpu.gpu(machine.context(engine=engine)) == Added(expected)


@pytest.mark.parametrize(
    ("files", "engine", "says"),
    [([CARD], Engine(cdi=KNOWS_CDI), "docker"), (TEGRA, Engine(), "docker"), ([CARD, HOOK], PODMAN_ENGINE, "podman")],
)
def test_an_engine_that_cannot_hand_in_a_gpu(machine: Machine, files: list[str], engine: Engine, says: str) -> None:
    """The container starts without it, and it is said why."""
    for file in files:
        machine.file(file)
    added = gpu.gpu(machine.context(engine=engine))
    ((text, remedy),) = added.notes
    assert added.words == () and f"no GPU: {says} cannot" in text and "Container Toolkit" in remedy
    assert ("nvidia-ctk cdi generate" in remedy) == engine.podman


@pytest.mark.parametrize(
    "words",
    [
        ["--no-gpu"],
        ["--gpus", "device=0"],
        ["--runtime=nvidia"],
        ["--device", "nvidia.com/gpu=1"],
        ["--device=/dev/dri"],
        ["-e", "NVIDIA_VISIBLE_DEVICES=1"],
        ["-ite", "NVIDIA_VISIBLE_DEVICES"],
    ],
)
def test_whoever_says_which_gpus_is_heard(machine: Machine, words: list[str]) -> None:
    """Also where the driver is too old, and where docker cannot hand them in."""
    old = Image(labels={gpu.DRIVER: "580"})
    machine.file("/sys/module/nvidia/version", b"470.1\n")
    for file in (CARD, HOOK, "/dev/dri/renderD128"):
        machine.file(file)
    assert gpu.gpu(machine.context(*words, image=old)) == Added()
    with pytest.raises(RosmlError):
        gpu.gpu(machine.context("--device", "/dev/video0", "-e", "A=NVIDIA_VISIBLE_DEVICES", image=old))


def test_gpus_of_others(machine: Machine) -> None:
    nodes = [machine.file(f"/dev/dri/{name}") for name in ("card0", "renderD128", "by-path")]
    there = machine.context(me=Person(1, GID + 1, "me", "/"))
    groups = ["--group-add", str(GID)] if GID else []
    assert gpu.gpu(there).words == ["--device", "/dev/dri", *groups]
    if UID == 0:
        os.chown(nodes[0], 0, 44)
        os.chown(nodes[1], 0, 992)
        added = ["--group-add", "44", "--group-add", "992"]
        assert gpu.gpu(there).words == ["--device", "/dev/dri", *added]
    assert gpu.gpu(machine.context(engine=PODMAN_ENGINE)).words == ["--device", "/dev/dri"]
    for node in nodes[:2]:
        node.unlink()
    assert gpu.gpu(there).words == []


def test_the_groups_of_devices(machine: Machine) -> None:
    """A serial port, a folder of sound devices, and what is no file of this machine."""
    nodes = [machine.file(f"/dev/{name}") for name in ("ttyUSB0", "snd/controlC0", "snd/by-id/usb")]
    words = ["--device=/dev/ttyUSB0:/dev/lidar:rw", "--device", "/dev/snd", "--device", "/dev/none", "--device=a/b=c"]
    there = machine.context(*words, me=Person(1, GID + 1, "me", "/"))
    groups = {str(GID)} - {"0"}
    if UID == 0:
        groups = {"20", "29", "1005"}
        for node, group in zip(nodes, (20, 29, 1005), strict=True):
            os.chown(node, 0, group)
    assert {*devices.devices(there)} - {"--group-add"} == groups
    own = 20 if UID == 0 else GID
    mine = machine.context(*words, me=Person(1, own, "me", "/"))
    assert {*devices.devices(mine)} - {"--group-add"} == groups - {str(own)}, "they are in their own group anyway"
    assert devices.devices(machine.context(*words, engine=PODMAN_ENGINE)) == []
    assert devices.devices(machine.context(*words, engine=Engine(machine="elsewhere"))) == []
    assert devices.devices(machine.context(*words, "--group-add", "keep-groups")) == []


@pytest.mark.parametrize(
    ("place", "content", "version"),
    [
        (
            "/proc/driver/nvidia/version",
            b"NVRM version: NVIDIA UNIX x86_64 Kernel Module  535.183.01  Sun May 12 19:39:15 UTC 2024\nGCC version: 12\n",
            "535.183.01",
        ),
        (
            "/proc/driver/nvidia/version",
            b"NVRM version: NVIDIA UNIX Open Kernel Module for x86_64  580.159.04  Release Build  (x@y)\n",
            "580.159.04",
        ),
        ("/sys/module/nvidia/version", b"525.60.13\n", "525.60.13"),
        ("/proc/driver/nvidia/version", b"something else\n", ""),
    ],
)
def test_the_drivers_version(machine: Machine, place: str, content: bytes, version: str) -> None:
    machine.file(place, content)
    assert gpu.driver(machine.context().host) == version


@pytest.mark.parametrize(
    ("needed", "version", "fits"),
    [
        ("580", "579.99", False),
        ("580", "580.10", True),
        ("580.10", "580.10", True),
        ("525", "580.10", True),
        ("1000", "580.10", False),
        ("525.60.13", "525.60.11", False),
        ("", "1.0", True),
        ("580", "", True),
        ("9" * 5000, "580.10", True),
        ("next year", "580.10", True),
        ("580", "9" * 5000, True),
    ],
)
def test_a_driver_that_is_too_old(machine: Machine, needed: str, version: str, fits: bool) -> None:
    machine.file("/sys/module/nvidia/version", version.encode())
    machine.file(CARD)
    image = Image(labels={gpu.DRIVER: needed} if needed else {})
    there = machine.context(image=image, engine=Engine(nvidia=True))
    if fits:
        assert gpu.gpu(there).words == ["--gpus", "all"]
        return
    with pytest.raises(RosmlError) as caught:
        gpu.gpu(there)
    assert f"needs NVIDIA's driver {needed} or newer, and this machine has {version}" in caught.value.message
    assert "\n" not in caught.value.message and "--no-gpu" in caught.value.remedy
    disabled = machine.context("-e", "NVIDIA_DISABLE_REQUIRE=1", image=image, engine=Engine(nvidia=True))
    assert gpu.gpu(disabled).words == ["--gpus", "all"]


def test_the_labels_are_those_of_images() -> None:
    assert f"{labels.GPU}driver" == gpu.DRIVER
    assert [gpu.BUILT.fullmatch(name) is not None for name in labels.about_gpus({"torch.amd64": "", "driver": ""})] == [
        True,
        False,
    ]


def pci(machine: Machine, *numbers: str) -> None:
    """Graphics cards that NVIDIA's driver has, by their numbers."""
    machine.file(CARD)
    for slot, number in enumerate(numbers):
        device = machine.file(f"/sys/devices/pci0000:00/0000:0{slot}:00.0/device", f"0x{number}\n".encode()).parent
        link = machine.path(f"{chips.DRIVEN}/0000:0{slot}:00.0")
        link.symlink_to(device)
    machine.file(f"{chips.DRIVEN}/new_id")


@pytest.mark.parametrize(
    ("number", "capability"),
    [  # as the list of PCI devices names them: a P100, a GTX 1080, an MX150, a V100, an RTX 2080, a GTX 1650, an A100, an RTX 3090,
        # an RTX 3060, an H100, an RTX 4090, an L4, a B200, a B300, Thor, an RTX 5090, an RTX 5070, a GB10, one that nobody knows
        *(("15f8", (6, 0)), ("1b80", (6, 1)), ("1d10", (6, 1)), ("1db4", (7, 0)), ("1e82", (7, 5)), ("1f82", (7, 5))),
        *(("20b0", (8, 0)), ("2204", (8, 6)), ("2503", (8, 6)), ("2330", (9, 0)), ("2684", (8, 9)), ("27b8", (8, 9))),
        *(
            ("2901", (10, 0)),
            ("3182", (10, 3)),
            ("2b00", (11, 0)),
            ("2b85", (12, 0)),
            ("2f04", (12, 0)),
            ("2e12", (12, 1)),
        ),
        ("ffff", None),
    ],
)
def test_the_kind_of_a_gpu(machine: Machine, number: str, capability: tuple[int, int] | None) -> None:
    pci(machine, number, number)
    assert chips.capabilities(machine.context().host) == ([capability] if capability else [])


@pytest.mark.parametrize(
    ("board", "capability"),
    [
        (b"nvidia,p3971-0089+p3834-0008\0nvidia,p3834-0008\0nvidia,tegra264\0", (11, 0)),
        (b"nvidia,p3737-0000+p3701-0005\0nvidia,p3701-0005\0nvidia,tegra234\0", (8, 7)),
        (b"raspberrypi,4-model-b\0brcm,bcm2711\0", None),
        (b"nvidia,tegra999\0", None),
    ],
)
def test_the_kind_of_a_jetson(machine: Machine, board: bytes, capability: tuple[int, int] | None) -> None:
    machine.file(chips.BOARD, board)
    assert chips.capabilities(machine.context().host) == ([capability] if capability else [])


@pytest.mark.parametrize(
    ("built", "runs", "fails"),
    [
        ("sm_80", [(8, 0), (8, 6), (8, 7)], [(7, 5), (9, 0), (12, 0)]),
        ("sm_86", [(8, 6), (8, 9)], [(8, 0)]),
        ("sm_90a", [(9, 0)], [(10, 0)]),
        ("sm_100a", [(10, 0)], [(10, 3)]),
        ("sm_100f", [(10, 0), (10, 3)], [(11, 0)]),
        ("sm_120a sm_121a", [(12, 0), (12, 1)], [(11, 0)]),
        ("compute_90", [(9, 0), (12, 1)], [(8, 9)]),
        ("compute_90a", [(9, 0)], [(10, 0)]),
        ("compute_100f", [(10, 3)], [(12, 0)]),
        ("sm_80 gfx90a", [(12, 0)], []),
        ("\x1b[31m", [(8, 0)], []),
        ("", [], [(8, 0)]),
    ],
)
def test_what_code_runs_on(built: str, runs: list[chips.Capability], fails: list[chips.Capability]) -> None:
    assert [each for each in [*runs, *fails] if chips.covers(built.split(), each)] == runs


def test_a_library_that_was_not_built_for_the_gpu(machine: Machine) -> None:
    """The warning names that one alone, and the container starts with the GPU."""
    pci(machine, "2901", "2330")
    built = {"torch.amd64": "sm_80 sm_90 sm_100", "torch.arm64": "sm_80", "onnxruntime.amd64": "sm_80 sm_90a sm_120a"}
    image = Image(
        labels={"io.rosml.gpu.driver": "580", **{f"io.rosml.gpu.{name}": value for name, value in built.items()}}
    )
    found = gpu.gpu(machine.context(image=image, engine=Engine(nvidia=True)))
    assert found.words == ["--gpus", "all"]
    assert [*found.notes] == [
        (
            "onnxruntime in ros:jazzy was built for sm_80 sm_90a sm_120a, and this machine has the GPU sm_100",
            "take an image of another stack, or let onnxruntime compute on the CPU",
        )
    ]
    assert not gpu.gpu(machine.context(image=Image(), engine=Engine(nvidia=True))).notes
    assert not gpu.gpu(machine.context("--no-gpu", image=image, engine=Engine(nvidia=True))).notes


# ---- X11 -------------------------------------------------------------------------------------------------------------

COOKIE = Entry(LOCAL, b"robot", b"0", b"MIT-MAGIC-COOKIE-1", bytes(range(16)))
SSH = Entry(LOCAL, b"robot", b"10", b"MIT-MAGIC-COOKIE-1", b"s" * 16)
OTHER_MACHINE = Entry(LOCAL, b"laptop", b"0", b"MIT-MAGIC-COOKIE-1", b"x" * 16)
X0 = "/tmp/.X11-unix/X0"
SHOWN = ["--mount", f"type=bind,source={X0},target={X0}", "-e", "DISPLAY=:0", "-e", "QT_X11_NO_MITSHM=1"]
WITH_COOKIE = [
    *("--mount", f"type=bind,source={RUNTIME}/rosml/xauth-0,target=/run/rosml/xauth,readonly"),
    *("-e", "XAUTHORITY=/run/rosml/xauth"),
]
SSH_COOKIE = [word.replace("xauth-0", "xauth-10") for word in WITH_COOKIE]


@pytest.fixture
def x11(machine: Machine) -> Machine:
    """A machine on whose display :0 somebody works."""
    machine.socket(X0)
    machine.file("/home/me/.Xauthority", xauthority.written([OTHER_MACHINE, COOKIE, SSH]))
    machine.file(f"{RUNTIME}/bus")
    machine.environment |= {"DISPLAY": ":0", "HOME": "/home/me", "XDG_RUNTIME_DIR": RUNTIME}
    return machine


@pytest.mark.parametrize("display", [":0", ":0.0", "unix:0", "robot/unix:0.1"])
def test_a_display_that_answers(x11: Machine, display: str) -> None:
    x11.environment["DISPLAY"] = display
    if "robot" in display:
        x11.listens.add(("robot", 6000))
    added = sockets.windows(x11.context())
    assert [*added.words[-4:]] == WITH_COOKIE
    if "robot" not in display:
        assert [*added.words] == [*SHOWN, *WITH_COOKIE]
    (entry,) = xauthority.read(added.files[f"{RUNTIME}/rosml/xauth-0"])
    assert entry == Entry(WILD, b"", b"0", COOKIE.kind, COOKIE.secret), "that of this machine, good for any"


@pytest.mark.parametrize("display", ["", ":1", "nonsense", ":0x", "localhost:10", "/private/tmp/x:0"])
def test_a_display_that_does_not_answer(x11: Machine, display: str) -> None:
    x11.environment["DISPLAY"] = display
    assert sockets.windows(x11.context()) == Added()


@pytest.mark.parametrize("words", [["--no-x11"], ["-e", "DISPLAY=:7"], ["--env=DISPLAY"]])
def test_whoever_says_what_the_display_is_is_heard(x11: Machine, words: list[str]) -> None:
    x11.socket(f"{RUNTIME}/wayland-0")
    assert sockets.windows(x11.context(*words)) == Added()


def test_the_container_gets_the_cookie_of_its_display_alone(x11: Machine) -> None:
    """Also if there is one for another display, from another call."""
    other = Entry(WILD, b"", b"10", b"MIT-MAGIC-COOKIE-1", b"o" * 16)
    stale = Entry(WILD, b"", b"0", b"MIT-MAGIC-COOKIE-1", b"p" * 16)
    for name in ("xauth", "xauth-0"):
        x11.file(f"{RUNTIME}/rosml/{name}", xauthority.written([stale, other]))
    ((place, content),) = sockets.windows(x11.context()).files.items()
    assert place == f"{RUNTIME}/rosml/xauth-0" and xauthority.read(content) == [
        Entry(WILD, b"", b"0", COOKIE.kind, COOKIE.secret)
    ]


def test_a_display_of_another_machine_gets_no_cookie_of_this_one(x11: Machine) -> None:
    """Both may have the same number."""
    x11.environment["DISPLAY"] = "laptop:0"
    x11.listens.add(("laptop", 6000))
    (content,) = sockets.windows(x11.context()).files.values()
    assert [entry.secret for entry in xauthority.read(content)] == [OTHER_MACHINE.secret]
    x11.file("/home/me/.Xauthority", xauthority.written([COOKIE]))
    assert sockets.windows(x11.context()).files == {}


def test_a_display_that_needs_no_cookie(x11: Machine) -> None:
    x11.environment["XAUTHORITY"] = "/none"
    assert sockets.windows(x11.context()) == Added(SHOWN)


def test_a_cookie_without_a_place(x11: Machine) -> None:
    """The folder of somebody else's session, as sudo leaves it in the environment, is none."""
    shutil.rmtree(x11.root / "run")
    x11.environment["XDG_RUNTIME_DIR"] = "/run/user/77"
    added = sockets.windows(x11.context())
    assert not added.words and not added.files and "no place for the display's cookie" in added.notes[0][0]
    x11.file(f"{RUNTIME}/bus")
    assert [*sockets.windows(x11.context()).files] == [f"{RUNTIME}/rosml/xauth-0"]
    nobody = Person(UID + 1, GID, "nobody", "/")
    assert sockets.windows(x11.context(me=nobody)).files == {}


@pytest.mark.parametrize(
    ("words", "engine", "reason"),
    [
        ([], Engine(), ""),
        (["--network", "host"], Engine(), ""),
        (["--net=host"], Engine(), ""),
        (["-p", "80:80"], Engine(), "does not go with -p"),
        (["--network=bridge"], Engine(), "does not go with --network=bridge"),
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
        x11.socket(f"{RUNTIME}/wayland-0")
        assert "WAYLAND_DISPLAY=wayland-0" in sockets.windows(x11.context(*words, engine=engine)).words
        ((text, _),) = added.notes
        assert added.words == () and "DISPLAY=localhost:10.0 is ssh's" in text and reason in text
        return
    own = [] if words else ["--network", "host"]
    assert [*added.words] == [*own, "-e", "DISPLAY=localhost:10.0", "-e", "QT_X11_NO_MITSHM=1", *SSH_COOKIE]
    (entry,) = xauthority.read(added.files[f"{RUNTIME}/rosml/xauth-10"])
    assert (entry.number, entry.secret) == (b"10", SSH.secret)


def test_a_damaged_file_of_cookies() -> None:
    whole = xauthority.written([COOKIE, SSH])
    assert xauthority.read(whole) == [COOKIE, SSH]
    for end in range(len(whole)):
        assert xauthority.read(whole[:end]) in ([], [COOKIE])
    assert xauthority.read(b"\xff" * 5) == [] and xauthority.cookie([], "0", "robot", "robot") is None


@pytest.mark.skipif(not shutil.which("xauth"), reason="xauth is not installed")
def test_xauth_reads_what_is_written(tmp_path: Path) -> None:
    """And the other way round."""
    file = tmp_path / "theirs"
    add = ["xauth", "-f", str(file), "add", "robot/unix:3", ".", "ab" * 16]
    subprocess.run(add, check=True, capture_output=True)
    (entry,) = xauthority.read(file.read_bytes())
    assert (entry.number, entry.secret.hex()) == (b"3", "ab" * 16)
    ours = tmp_path / "ours"
    found = xauthority.cookie([entry], "3", "robot", "robot")
    assert found
    ours.write_bytes(xauthority.written([found]))
    listed = subprocess.run(["xauth", "-f", str(ours), "nlist"], capture_output=True, text=True, check=True).stdout
    assert listed.split() == ["ffff", "0000", "0001", "33", "0012", b"MIT-MAGIC-COOKIE-1".hex(), "0010", "ab" * 16]


# ---- Wayland, sound, ssh's agent -------------------------------------------------------------------------------------

WAYLAND = [
    *("--mount", f"type=bind,source={RUNTIME}/wayland-1,target={RUNTIME}/wayland-1"),
    *("-e", f"XDG_RUNTIME_DIR={RUNTIME}", "-e", "WAYLAND_DISPLAY=wayland-1"),
    *("-e", "QT_QPA_PLATFORM=wayland;xcb", "-e", "GDK_BACKEND=wayland,x11"),
]


def test_wayland(x11: Machine) -> None:
    """Where no X11 answers, or somebody asks for it."""
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
    assert sockets.sound(x11.context()) == []
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


def test_the_agent_of_ssh(machine: Machine) -> None:
    with pytest.raises(RosmlError, match="no agent answers"):
        sockets.ssh_agent(machine.context("--ssh-agent"))
    machine.environment["SSH_AUTH_SOCK"] = "/tmp/ssh-x/agent.1"
    with pytest.raises(RosmlError, match="no agent answers"):
        sockets.ssh_agent(machine.context("--ssh-agent"))
    machine.socket("/tmp/ssh-x/agent.1")
    assert sockets.ssh_agent(machine.context()) == []
    assert sockets.ssh_agent(machine.context("--ssh-agent")) == [
        *("--mount", "type=bind,source=/tmp/ssh-x/agent.1,target=/run/rosml/ssh-agent"),
        *("-e", "SSH_AUTH_SOCK=/run/rosml/ssh-agent"),
    ]
    assert sockets.ssh_agent(machine.context("--ssh-agent", "-e", "SSH_AUTH_SOCK=x")) == []


@pytest.mark.parametrize(
    ("engine", "files", "here"),
    [
        (Engine(machine="robot"), [], True),
        (Engine(machine="server"), [], False),
        (Engine("podman", podman=True, machine="server"), [], False),
        (Engine(machine="docker-desktop"), [], False),
        (Engine(machine="docker-desktop"), ["/dev/dxg"], True),
    ],
)
def test_an_engine_on_another_machine(x11: Machine, engine: Engine, files: list[str], here: bool) -> None:
    """It gets nothing of this one: it would not start."""
    x11.socket("/agent")
    x11.socket(f"{RUNTIME}/pulse/native")
    x11.environment["SSH_AUTH_SOCK"] = "/agent"
    for file in ("/dev/dri/card0", *files):
        x11.file(file)
    asked = x11.context("--sound", "--ssh-agent", engine=engine)
    if not here:
        with pytest.raises(RosmlError, match="--wayland: "):
            sockets.windows(x11.context("--wayland", engine=engine))
    assert bool(gpu.gpu(asked).words) == bool(sockets.windows(asked).words) == here
    assert here or not sockets.windows(asked).files
    for concern in (sockets.sound, sockets.ssh_agent):
        if here:
            assert concern(asked)
            continue
        assert concern(x11.context(engine=engine)) == []
        with pytest.raises(RosmlError, match=f"runs containers on {engine.machine}, and not here"):
            concern(asked)


def test_an_engine_that_is_a_snap(x11: Machine) -> None:
    """It has its own /tmp and /run: with a mount of what is not there, nothing would start. GPUs are there."""
    snap = Engine(snap=True)
    for place in ("/agent", f"{RUNTIME}/pulse/native", f"{RUNTIME}/wayland-0", "/dev/dri/card0"):
        x11.socket(place)
    x11.environment["SSH_AUTH_SOCK"] = "/agent"
    added = sockets.windows(x11.context(engine=snap))
    ((text, remedy),) = added.notes
    assert (added.words, added.files) == ([], {}) and "docker is a snap" in text and "--no-x11" in remedy
    assert sockets.windows(x11.context("--no-x11", engine=snap)) == Added([], notes=[])
    assert gpu.gpu(x11.context(engine=snap)).words
    for concern, option in ((sockets.windows, "wayland"), (sockets.sound, "sound"), (sockets.ssh_agent, "ssh-agent")):
        with pytest.raises(RosmlError, match=f"--{option}: docker is a snap"):
            concern(x11.context(f"--{option}", engine=snap))


# ---- What the command does with it -----------------------------------------------------------------------------------


@pytest.fixture
def desk(tmp_path: Path) -> Desk:
    """A desk on a machine with nothing. The image `ours` is trusted."""
    made = Desk(tmp_path)
    made.engine()
    made.trust(ours=True)
    return made


@contextlib.contextmanager
def listening(path: Path) -> Iterator[None]:
    """Listens at a path, which may be longer than an address can be."""
    path.parent.mkdir(parents=True)
    with socket.socket(socket.AF_UNIX) as server, contextlib.chdir(path.parent):
        server.bind(path.name)
        server.listen()
        yield


def test_the_cookie_is_in_a_private_file(desk: Desk) -> None:
    """Which is written when the container starts, and is all that is left."""
    session = desk.root / f"run/user/{UID}"
    session.mkdir(parents=True)
    (desk.root / "c").write_bytes(xauthority.written([Entry(LOCAL, b"x", b"0", b"k", b"secret")]))
    env = {"DISPLAY": ":0", "XAUTHORITY": "/c", "XDG_RUNTIME_DIR": RUNTIME}
    file = session / "rosml/xauth-0"
    with listening(desk.root / X0[1:]):
        shown = desk.call("--dry-run", "ubuntu", **env)
        assert "DISPLAY=:0" in shown.stdout and "secret" not in shown.stdout and not [*session.iterdir()]
        old = os.umask(0)
        try:
            done = desk.call("ubuntu", **env)
        finally:
            os.umask(old)
        assert (done.returncode, done.stderr) == (0, "")
        first = file.stat()
        assert stat.S_IMODE(first.st_mode) == 0o600 and stat.S_IMODE(file.parent.stat().st_mode) == 0o700
        assert desk.call("ubuntu", **env).returncode == 0
        assert file.stat().st_ino == first.st_ino, "containers have it mounted"
        file.chmod(0o644)
        assert desk.call("ubuntu", **env).returncode == 0 and stat.S_IMODE(file.stat().st_mode) == 0o600
    assert [path.name for path in session.rglob("*")] == ["rosml", "xauth-0"] and b"secret" in file.read_bytes()
    assert desk.call("ubuntu", **env).returncode == 0 and "DISPLAY=:0" not in desk.calls[-1]


def test_a_file_that_cannot_be_written(tmp_path: Path) -> None:
    (tmp_path / "xauth").mkdir()
    with pytest.raises(OSError):
        host.write(tmp_path / "xauth", b"")
    assert [path.name for path in tmp_path.iterdir()] == ["xauth"]


def test_what_listens(tmp_path: Path) -> None:
    with listening(tmp_path / "x/s"), contextlib.chdir(tmp_path / "x"):
        assert host.connects("s") and not host.connects("t")
    with contextlib.chdir(tmp_path / "x"):
        assert not host.connects("s"), "the socket of a server that is gone"
    with socket.create_server(("127.0.0.1", 0)) as server:
        port = server.getsockname()[1]
        assert host.connects(("localhost", port))
    assert not host.connects(("localhost", port)) and not host.connects("x" * 200)


def test_gpus_of_this_machine(desk: Desk) -> None:
    (desk.root / "dev").mkdir()
    (desk.root / "dev/nvidiactl").touch()
    done = desk.call("--no-tz", "ubuntu")
    assert done.returncode == 0 and desk.calls[-1] == [*plain(desk), "ubuntu"]
    assert "warning: the container gets no GPU" in done.stderr and "remedy: install NVIDIA's" in done.stderr
    desk.engine(info={**DOCKER, "Runtimes": {"runc": {}, "nvidia": {}}})
    assert desk.call("--no-tz", "ubuntu").returncode == 0
    assert desk.calls[-1] == [*plain(desk), "--gpus", "all", "ubuntu"]
    (desk.root / "etc/cdi").mkdir(parents=True)
    (desk.root / "etc/cdi/nvidia.json").write_text('{"kind": "nvidia.com/gpu"}')
    name = os.uname().nodename
    here: dict[str, Any] = {"hostname": name, **PODMAN["host"]}
    for info in ({**DOCKER, "CDISpecDirs": ["/etc/cdi"], "Name": name}, {"host": here}, PODMAN):
        desk.engine(info=info)
        assert desk.call("ubuntu").returncode == 0 and desk.calls[-1][-3:] == [*CDI, "ubuntu"]
    for info in ({**DOCKER, "CDISpecDirs": ["/etc/cdi"], "Name": "x"}, {"host": {**here, "hostname": "x"}}):
        desk.engine(info=info)
        assert desk.call("ubuntu").returncode == 0 and CDI[1] not in desk.calls[-1]


def test_a_driver_that_is_too_old_for_an_image(desk: Desk) -> None:
    """Nothing is started."""
    for name, content in (("dev/nvidiactl", ""), ("sys/module/nvidia/version", "535.1")):
        (desk.root / name).parent.mkdir(parents=True)
        (desk.root / name).write_text(content)
    labelled = {"ours": {"Labels": {"io.rosml.gpu.driver": "580"}}}
    desk.engine(info={**DOCKER, "Runtimes": {"nvidia": {}}}, images={"ours": OURS}, configs=labelled)
    done = desk.call("ours")
    assert done.returncode == 125 and not desk.called("run")
    assert done.stderr.startswith(
        "error: ours needs NVIDIA's driver 580 or newer, and this machine has 535.1\nremedy: "
    )
    assert desk.call("--no-gpu", "ours").returncode == 0 and desk.called("run")


# ---- Plugins of other packages ---------------------------------------------------------------------------------------

THEIRS = """\
from rosml.run.plugin import Added, Plugin

def lidar(context):
    return ["--device", "/dev/lidar"] if context.line.asks("lidar") else []

good = Plugin("lidar", lidar, {"lidar": "the lidar"}, before=("user",))
late = Plugin("late", lambda context: Added(["--label", "a=b"], notes=[("mind the robot", "stop it")]))
clash = Plugin("clash", lidar, {"privileged": "as docker's"})
twice = Plugin("gpu", lidar)
raises = Plugin("raises", lambda context: 1 / 0)
numbers = Plugin("numbers", lambda context: [1])
text = Plugin("text", lambda context: "--rm")
odd = Plugin("odd", lidar, {"--odd": "with hyphens"})
files = Plugin("files", lambda context: Added(files={"x": b""}))
circle = Plugin("circle", lidar, before=("user",), after=("user",))
function = lidar
"""


def package(folder: Path, entries: str, name: str = "theirs") -> None:
    """Installs a package with plugins."""
    (folder / f"{name}-1.0.dist-info").mkdir(parents=True)
    text = f"[console_scripts]\nx = theirs:x\n\n[rosml.run]\n{entries}\n[other]\ny = theirs:y\n"
    (folder / f"{name}-1.0.dist-info/entry_points.txt").write_text(text)
    (folder / f"{name}.py").write_text(THEIRS)


def test_a_plugin_of_another_package(desk: Desk, tmp_path: Path) -> None:
    package(tmp_path / "site", "lidar = theirs:good\nlate = theirs:late")
    paths = f"{ROOT / 'src'}:{tmp_path / 'site'}"
    assert "--lidar" in desk.call("--help", PYTHONPATH=paths).stdout
    assert "--lidar" not in desk.call("--help").stdout
    done = desk.call("--no-tz", "--lidar", "ubuntu", "ls", "--lidar", PYTHONPATH=paths)
    assert (done.returncode, done.stderr) == (0, "warning: mind the robot\nremedy: stop it\n")
    before, _, after = " ".join(plain(desk)).partition(" --user")
    assert " ".join(desk.ran) == f"{before} --device /dev/lidar --user{after} --label a=b ubuntu ls --lidar"


@pytest.mark.parametrize(
    ("place", "says"),
    [
        ("theirs:clash", "ValueError: its option --privileged is taken"),
        ("theirs:twice", "ValueError: another plugin is called gpu"),
        ("theirs:raises", "ZeroDivisionError: division by zero"),
        ("theirs:numbers", "TypeError: it adds something else than words"),
        ("theirs:text", "TypeError: it adds something else than words"),
        ("theirs:odd", "ValueError: '--odd' is no name of an option"),
        ("theirs:files", "TypeError: it adds something else than bytes for absolute paths"),
        ("theirs:circle", "ValueError: its before and after contradict others"),
        ("theirs:function", "TypeError: theirs:function is no rosml.run.plugin.Plugin"),
        ("theirs:missing", "AttributeError: "),
        ("nowhere:x", "ModuleNotFoundError: "),
    ],
)
def test_a_broken_plugin_is_left_out(desk: Desk, tmp_path: Path, place: str, says: str) -> None:
    """It is named, and the container starts."""
    package(tmp_path / "site", f"it = {place}")
    done = desk.call("--no-tz", "ubuntu", PYTHONPATH=f"{ROOT / 'src'}:{tmp_path / 'site'}")
    assert done.returncode == 0 and desk.ran == [*plain(desk), "ubuntu"]
    assert done.stderr.startswith("warning: the plugin ") and f" of theirs is left out: {says}" in done.stderr
    assert "remedy: update theirs, or remove it" in done.stderr


def test_where_plugins_are_looked_for(tmp_path: Path) -> None:
    package(tmp_path / "a", "one = theirs:good [extra]\n two=theirs:late")
    (tmp_path / "a/odd-1.dist-info").mkdir()
    (tmp_path / "a/odd-1.dist-info/entry_points.txt").write_bytes(b"\xff")
    (tmp_path / "a/none-1.dist-info").mkdir()
    places = [str(tmp_path / "a"), str(tmp_path / "a"), str(tmp_path / "missing"), ""]
    assert [*discovery.registered(places)] == [("theirs", "one", "theirs:good"), ("theirs", "two", "theirs:late")]


def test_the_order_of_plugins() -> None:
    def named(name: str, **order: Any) -> Plugin:
        return Plugin(name, lambda context: [], **order)

    given = [named("a", after=("c",)), named("b"), named("c", before=("b",)), named("d", after=("x",))]
    ordered, refused = in_order(given)
    assert ([plugin.name for plugin in ordered], refused) == (["c", "a", "b", "d"], [])
    ordered, refused = in_order([named("a"), named("b", before=("a",), after=("a",))])
    assert [plugin.name for plugin in ordered] == ["a"] and [plugin.name for plugin in refused] == ["b"]


def test_rosmls_own_plugins() -> None:
    found = discovery.discover((), [])
    assert (found.plugins, found.notes) == (BUILT_IN, ())
    assert len({plugin.name for plugin in BUILT_IN}) == len(BUILT_IN)
    broken = Plugin("broken", lambda context: [][1])
    with pytest.raises(IndexError):  # a fault of rosml's is not passed over
        make_plan(Context(split(["x"], ()), Engine(), ME, Image(), BARE), [broken])


def test_the_plugin_that_the_docs_show() -> None:
    """It works as it stands there, and the names to put in `before` and `after` are all of them."""
    page = (ROOT / "docs/run/plugins.md").read_text()
    (code,) = re.findall(r"```python\n(.*?)```", page, re.DOTALL)
    names: dict[str, Any] = {}
    exec(code, names)
    context = Context(split(["--lidar", "x"], ["--lidar"]), Engine(), ME, Image(), BARE)
    assert make_plan(context, [names["lidar"]]).argv == ("docker", "run", "--device", "/dev/ttyUSB0", "x")
    listed = re.findall(r"`([a-z-]+)`", page.partition("order it among the others: ")[2].partition(".")[0])
    assert listed == [plugin.name for plugin in BUILT_IN]
