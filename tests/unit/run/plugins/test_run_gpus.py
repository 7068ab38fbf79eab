"""GPUs and devices that `rosml run` hands in, by the files of a machine."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import pytest

from fakes.desks import DOCKER, PODMAN, Desk, docker_desk
from fakes.run_machines import Machine
from rosml.base.errors import RosmlError
from rosml.base.gpu_code import Capability, covers
from rosml.images.image_set import labels
from rosml.run.context import Engine, Image, Person
from rosml.run.plugin import Added
from rosml.run.plugins import chips, gpu

UID, GID = os.geteuid(), os.getegid()
CDI = ["--device", "nvidia.com/gpu=all"]
CDI_FOLDERS = ("/etc/cdi", "/var/run/cdi")
PODMAN_ENGINE = Engine("podman", podman=True, rootless=True, cdi=CDI_FOLDERS)
NVIDIA = Engine(nvidia=True)
CARD, TEGRA = "/dev/nvidiactl", ("/dev/nvmap", "/etc/nv_tegra_release")
SPEC, HOOK = "/var/run/cdi/nvidia.yaml", "/usr/bin/nvidia-container-runtime-hook"
WSL = ("/dev/dxg", "/usr/lib/wsl/lib/libcuda.so.1")


@pytest.fixture
def machine(tmp_path: Path) -> Machine:
    return Machine(tmp_path / "root", Person(UID, GID, "me", "/home/me"))


@pytest.mark.parametrize(
    ("files", "engine", "expected"),
    [
        ([], NVIDIA, []),
        ([CARD, HOOK], Engine(), ["--gpus", "all"]),
        ([CARD], NVIDIA, ["--gpus", "all"]),
        ([CARD, HOOK, SPEC], Engine(), ["--gpus", "all"]),  # a docker without CDI
        ([CARD, HOOK, SPEC], Engine(cdi=CDI_FOLDERS), CDI),
        ([CARD, SPEC], PODMAN_ENGINE, CDI),
        (WSL, Engine(), ["--gpus", "all"]),
        (["/dev/dxg", HOOK], Engine(), []),  # WSL with the GPU of another maker
        (TEGRA, NVIDIA, ["--runtime", "nvidia"]),
        ([*TEGRA, SPEC], PODMAN_ENGINE, CDI),
    ],
)
def test_gpus_of_nvidia(machine: Machine, files: list[str], engine: Engine, expected: list[str]) -> None:
    for file in files:
        machine.file(file, b"kind: nvidia.com/gpu" if "nvidia.yaml" in file else b"")
    assert gpu.gpu(machine.context(engine=engine)) == Added(expected)


@pytest.mark.parametrize(
    ("files", "engine"), [([CARD], Engine(cdi=CDI_FOLDERS)), (TEGRA, Engine()), ([CARD, HOOK], PODMAN_ENGINE)]
)
def test_an_engine_that_cannot_hand_in_a_gpu(machine: Machine, files: list[str], engine: Engine) -> None:
    for file in files:
        machine.file(file)
    added = gpu.gpu(machine.context(engine=engine))
    ((text, remedy),) = added.notes
    assert added.words == () and f"no GPU: {engine.program} cannot" in text and "Container Toolkit" in remedy
    assert ("nvidia-ctk cdi generate" in remedy) == engine.podman


@pytest.mark.parametrize(
    "words",
    [
        *(["--no-gpu"], ["--gpus", "device=0"], ["--runtime=nvidia"], ["--device", "nvidia.com/gpu=1"]),
        *(["--device=/dev/dri"], ["-e", "NVIDIA_VISIBLE_DEVICES=1"], ["-ite", "NVIDIA_VISIBLE_DEVICES"]),
    ],
)
def test_the_user_chooses_the_gpus(machine: Machine, words: list[str]) -> None:
    """Also if the driver is too old, and if docker cannot hand them in."""
    image = Image(labels={gpu.DRIVER: "580"})
    machine.file("/sys/module/nvidia/version", b"470.1\n")
    for file in (CARD, HOOK, "/dev/dri/renderD128"):
        machine.file(file)
    assert gpu.gpu(machine.context(*words, image=image)) == Added()
    with pytest.raises(RosmlError):
        gpu.gpu(machine.context("--device", "/dev/video0", "-e", "A=NVIDIA_VISIBLE_DEVICES", image=image))


@pytest.mark.parametrize(
    ("words", "files", "engine", "refused"),
    [
        (["--gpus", "all"], [], Engine(), True),
        (["--gpus", "all"], [], NVIDIA, True),  # NVIDIA's runtime is installed, and the GPU is gone
        (["--gpus", "all"], [CARD], Engine(), False),
        (["--gpus", "all"], ["/etc/cdi/amd.json"], Engine(cdi=CDI_FOLDERS), False),
        (["--gpus", "all"], [], Engine(machine="elsewhere"), False),
        (["--gpus", "all"], [], PODMAN_ENGINE, False),
        ([], [], Engine(), False),
    ],
)
def test_a_gpu_that_the_machine_lacks(
    machine: Machine, words: list[str], files: list[str], engine: Engine, refused: bool
) -> None:
    for file in files:
        machine.file(file)
    context = machine.context(*words, engine=engine)
    if not refused:
        gpu.require_present(context)
        return
    with pytest.raises(RosmlError, match="this machine has none with NVIDIA's driver") as caught:
        gpu.require_present(context)
    assert caught.value.remedy.startswith("leave --gpus out") and "rosml list cpu" in caught.value.remedy


def test_an_image_with_cuda_computes_on_the_cpu_of_a_machine_without_a_gpu(machine: Machine) -> None:
    image = Image(labels={gpu.DRIVER: "580"})
    ((text, remedy),) = gpu.gpu(machine.context(image=image)).notes
    assert text.startswith("ros:jazzy has CUDA, and this machine has no GPU") and "rosml list cpu" in remedy
    assert not gpu.gpu(machine.context("--no-gpu", image=image)).notes and not gpu.gpu(machine.context()).notes


def test_podman_needs_another_option() -> None:
    context = Machine(Path("/nowhere"), Person(1, 1, "me", "/")).context("--gpus=all", engine=PODMAN_ENGINE)
    assert gpu.gpu(context) == Added(notes=[gpu.FOR_PODMAN])


def test_gpus_of_others(machine: Machine) -> None:
    nodes = [machine.file(f"/dev/dri/{name}") for name in ("card0", "renderD128", "by-path")][:2]
    context = machine.context(me=Person(1, GID + 1, "me", "/"))
    groups = ["--group-add", str(GID)] if GID else []
    if UID == 0:
        for node, group in zip(nodes, (44, 992), strict=True):
            os.chown(node, 0, group)
        groups = ["--group-add", "44", "--group-add", "992"]
    assert gpu.gpu(context).words == ["--device", "/dev/dri", *groups]
    assert gpu.gpu(machine.context(engine=PODMAN_ENGINE)).words == ["--device", "/dev/dri"]
    for node in nodes:
        node.unlink()
    assert gpu.gpu(context).words == []


def test_the_groups_of_devices(machine: Machine) -> None:
    """A serial port, a folder of sound devices, and paths that are no files of this machine."""
    nodes = [machine.file(f"/dev/{name}") for name in ("ttyUSB0", "snd/controlC0", "snd/by-id/usb")]
    words = ["--device=/dev/ttyUSB0:/dev/lidar:rw", "--device", "/dev/snd", "--device", "/dev/none", "--device=a/b=c"]
    groups = {str(GID)} - {"0"}
    if UID == 0:
        groups = {"20", "29", "1005"}
        for node, group in zip(nodes, (20, 29, 1005), strict=True):
            os.chown(node, 0, group)
    caller_gid = 20 if UID == 0 else GID
    for gid, expected in ((GID + 1, groups), (caller_gid, groups - {str(caller_gid)})):
        context = machine.context(*words, me=Person(1, gid, "me", "/"))
        assert {*gpu.devices(context)} - {"--group-add"} == expected
    for engine in (PODMAN_ENGINE, Engine(machine="elsewhere")):
        assert gpu.devices(machine.context(*words, engine=engine)) == []
    assert gpu.devices(machine.context(*words, "--group-add", "keep-groups")) == []


PROC = "/proc/driver/nvidia/version"


@pytest.mark.parametrize(
    ("place", "content", "version"),
    [
        (PROC, b"NVRM version: NVIDIA UNIX x86_64 Kernel Module  535.183.01  Sun May 12 2024\nGCC version: 12\n", "535.183.01"),
        (PROC, b"NVRM version: NVIDIA UNIX Open Kernel Module for x86_64  580.159.04  Release Build  (x@y)\n", "580.159.04"),
        ("/sys/module/nvidia/version", b"525.60.13\n", "525.60.13"),
        (PROC, b"something else\n", ""),
    ],
)  # fmt: skip
def test_the_drivers_version(machine: Machine, place: str, content: bytes, version: str) -> None:
    machine.file(place, content)
    assert gpu.driver(machine.context().host) == version


@pytest.mark.parametrize(
    ("needed", "version", "fits"),
    [
        *(("580", "579.99", False), ("580", "580.10", True), ("580.10", "580.10", True), ("525", "580.10", True)),
        *(("1000", "580.10", False), ("525.60.13", "525.60.11", False), ("", "1.0", True), ("580", "", True)),
        *(("9" * 5000, "580.10", True), ("next year", "580.10", True), ("580", "9" * 5000, True)),
    ],
)
def test_a_driver_that_is_too_old(machine: Machine, needed: str, version: str, fits: bool) -> None:
    machine.file("/sys/module/nvidia/version", version.encode())
    machine.file(CARD)
    image = Image(labels={gpu.DRIVER: needed} if needed else {})
    disabled = machine.context("-e", "NVIDIA_DISABLE_REQUIRE=1", image=image, engine=NVIDIA)
    assert gpu.gpu(disabled).words == ["--gpus", "all"]
    context = machine.context(image=image, engine=NVIDIA)
    if fits:
        assert gpu.gpu(context).words == ["--gpus", "all"]
        return
    with pytest.raises(RosmlError) as caught:
        gpu.gpu(context)
    assert f"needs NVIDIA's driver {needed} or newer, and this machine has {version}" in caught.value.message
    assert "\n" not in caught.value.message and "--no-gpu" in caught.value.remedy


def test_the_labels_are_those_of_images() -> None:
    assert f"{labels.GPU}driver" == gpu.DRIVER
    library, driver = labels.about_gpus({"torch.amd64": "", "driver": ""})
    assert gpu.BUILT.fullmatch(library) and not gpu.BUILT.fullmatch(driver)


def pci(machine: Machine, *numbers: str) -> None:
    """Graphics cards of NVIDIA's driver, by their numbers."""
    machine.file(CARD)
    machine.file(f"{chips.DRIVEN}/new_id")
    for slot, number in enumerate(numbers):
        device = machine.file(f"/sys/devices/pci0000:00/0000:0{slot}:00.0/device", f"0x{number}\n".encode()).parent
        (machine.root / chips.DRIVEN[1:] / f"0000:0{slot}:00.0").symlink_to(device)


@pytest.mark.parametrize(
    ("number", "capability"),
    [  # as the list of PCI devices names them: a P100, a GTX 1080, an MX150, a V100, an RTX 2080, a GTX 1650, an A100, an RTX 3090,
        # an RTX 3060, an H100, an RTX 4090, an L4, a B200, a B300, Thor, an RTX 5090, an RTX 5070, a GB10, an unknown one
        *(("15f8", (6, 0)), ("1b80", (6, 1)), ("1d10", (6, 1)), ("1db4", (7, 0)), ("1e82", (7, 5)), ("1f82", (7, 5))),
        *(("20b0", (8, 0)), ("2204", (8, 6)), ("2503", (8, 6)), ("2330", (9, 0)), ("2684", (8, 9)), ("27b8", (8, 9))),
        *(("2901", (10, 0)), ("3182", (10, 3)), ("2b00", (11, 0)), ("2b85", (12, 0)), ("2f04", (12, 0))),
        *(("2e12", (12, 1)), ("ffff", None)),
    ],
)
def test_the_capability_of_a_gpu(machine: Machine, number: str, capability: tuple[int, int] | None) -> None:
    pci(machine, number, number)
    assert chips.capabilities(machine.context().host) == ([capability] if capability else [])


@pytest.mark.parametrize(
    ("board", "capability"),
    [
        (b"nvidia,p3737-0000+p3701-0005\0nvidia,p3701-0005\0nvidia,tegra234\0", (8, 7)),
        (b"raspberrypi,4-model-b\0brcm,bcm2711\0", None),
        (b"nvidia,tegra999\0", None),
    ],
)
def test_the_capability_of_a_jetson(machine: Machine, board: bytes, capability: tuple[int, int] | None) -> None:
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
        ("compute_90", [(9, 0), (12, 1)], [(8, 9)]),
        ("compute_100f", [(10, 3)], [(12, 0)]),
        ("sm_80 gfx90a", [(12, 0)], []),
        ("\x1b[31m", [(8, 0)], []),
        ("", [], [(8, 0)]),
    ],
)
def test_the_gpus_on_which_code_runs(built: str, runs: list[Capability], fails: list[Capability]) -> None:
    assert [capability for capability in [*runs, *fails] if covers(built.split(), capability)] == runs


def test_a_library_that_was_not_built_for_the_gpu(machine: Machine) -> None:
    pci(machine, "2901", "2330")
    targets = {"torch.amd64": "sm_80 sm_90 sm_100", "torch.arm64": "sm_80", "onnxruntime.amd64": "sm_80 sm_90a sm_120a"}
    image = Image(labels={f"io.rosml.gpu.{name}": value for name, value in {"driver": "580", **targets}.items()})
    added = gpu.gpu(machine.context(image=image, engine=NVIDIA))
    ((text, remedy),) = added.notes
    assert added.words == ["--gpus", "all"] and "let onnxruntime compute on the CPU" in remedy
    assert text.endswith("was built for sm_80 sm_90a sm_120a, and this machine has the GPU sm_100")
    assert not gpu.gpu(machine.context(engine=NVIDIA)).notes
    assert not gpu.gpu(machine.context("--no-gpu", image=image, engine=NVIDIA)).notes


@pytest.fixture
def desk(tmp_path: Path) -> Desk:
    return docker_desk(tmp_path)


def test_gpus_of_this_machine(desk: Desk) -> None:
    """What engines say of themselves decides how they get them."""
    for name, content in (("dev/nvidiactl", ""), ("sys/module/nvidia/version", "535.1")):
        (desk.root / name).parent.mkdir(parents=True)
        (desk.root / name).write_text(content)
    assert "the container gets no GPU" in desk.call("--dry-run", "ubuntu").stderr
    nvidia = {**DOCKER, "Runtimes": {"runc": {}, "nvidia": {}}}
    desk.engine(info=nvidia)
    assert " --gpus all ubuntu" in desk.call("--dry-run", "ubuntu").stdout
    (desk.root / "etc/cdi").mkdir(parents=True)
    (desk.root / "etc/cdi/nvidia.json").write_text('{"kind": "nvidia.com/gpu"}')
    here = os.uname().nodename
    for name in (here, "x"):
        podman: dict[str, Any] = {"hostname": name, **PODMAN["host"]}
        for info in ({**DOCKER, "CDISpecDirs": ["/etc/cdi"], "Name": name}, {"host": podman}):
            desk.engine(info=info)
            assert (CDI[1] in desk.call("--dry-run", "ubuntu").stdout) == (name == here)
    desk.engine(info=nvidia, configs={"ours": {"Labels": {"io.rosml.gpu.driver": "580"}}})
    done = desk.call("ours")
    assert done.returncode == 125 and "driver 580" in done.stderr and not desk.called("run")


def test_a_call_for_a_gpu_that_is_missing_starts_nothing(desk: Desk) -> None:
    """A file for another machine may ask for it."""
    done = desk.call("--gpus", "all", "ubuntu")
    assert done.returncode == 125 and not desk.called("run")
    assert "error: --gpus asks docker for a GPU, and this machine has none" in done.stderr
    assert desk.call("--export", "compose", "--gpus", "all", "ubuntu").stdout.startswith(
        "# For a machine with an NVIDIA"
    )
