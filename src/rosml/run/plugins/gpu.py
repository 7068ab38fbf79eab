"""GPUs and other devices: finds them by this machine's device files, and makes the engine's options."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator, Sequence

from rosml.base.errors import RosmlError
from rosml.base.gpu_code import covers
from rosml.base.problems import listed
from rosml.run.context import Context, Engine, Host
from rosml.run.plugin import NOTHING, Added, Plugin
from rosml.run.plugins import chips
from rosml.run.words import Line

DRIVER = "io.rosml.gpu.driver"
"""The label of an image that names the oldest driver on which its CUDA runs (docs/gpus.md)."""

BUILT = re.compile(r"io\.rosml\.gpu\.([a-z][a-z0-9-]{0,23})\.([a-z][a-z0-9]{0,23})")
"""The labels that say for which GPUs a library was built, on which architecture."""

CDI = ["--device", "nvidia.com/gpu=all"]
JETSON = ("/dev/nvmap", "/etc/nv_tegra_release")
WSL = ("/dev/dxg", "/usr/lib/wsl/lib/libcuda.so.1")
"""Windows shows every GPU as /dev/dxg; CUDA's library is there if NVIDIA's driver is."""

HOOKS = ("nvidia-container-runtime-hook", "nvidia-container-toolkit")
TOOLKIT = "install NVIDIA's Container Toolkit"
GUIDE = "https://docs.nvidia.com/datacenter/cloud-native/container-toolkit/"


def gpu(context: Context) -> Added:
    """All NVIDIA GPUs; if there are none, /dev/dri of other GPUs. GPUs of another machine are unknown."""
    line, host = context.line, context.host
    if line.has("gpus") and context.engine.podman:
        return Added(notes=[FOR_PODMAN])
    if line.asks("no-gpu") or not context.is_here or is_theirs(line):
        return NOTHING
    if not is_nvidia(host):
        return Added(_rendering(context), notes=_on_the_cpu(context))
    words = handed_in(context.engine, host)
    if not words:
        return Added(notes=[lacking(context.engine)])
    _check_driver(context)
    return Added(words, notes=tuple(_not_built_for(context)))


FOR_PODMAN = (
    "podman before 5.0 starts a container without a GPU for --gpus",
    "write --device nvidia.com/gpu=all instead",
)


def is_nvidia(host: Host) -> bool:
    """Whether the machine has an NVIDIA GPU with its driver."""
    return host.has(*JETSON) or host.has(*WSL) or host.has("/dev/nvidiactl")


def is_theirs(line: Line) -> bool:
    """Whether the user chooses the GPUs."""
    devices = any(x.startswith(("nvidia.com/", "/dev/nvidia", "/dev/dri", "/dev/dxg")) for x in line.values("device"))
    return devices or line.has("gpus", "runtime") or line.sets("NVIDIA_VISIBLE_DEVICES")


def require_present(context: Context) -> None:
    """Checks that this machine has the NVIDIA GPU for which --gpus asks: docker would say that it could not select a device driver."""
    line, engine, host = context.line, context.engine, context.host
    others = any(host.files(folder) for folder in engine.cdi)
    if line.has("gpus") and context.is_here and not (engine.podman or is_nvidia(host) or others):
        text = f"--gpus asks {engine.program} for a GPU, and this machine has none with NVIDIA's driver"
        raise RosmlError(
            text, f"leave --gpus out: CUDA's programs then compute on the CPU; {SMALLER}; or install the driver"
        )


SMALLER = "an image for the CPU is smaller (rosml list cpu)"


def _on_the_cpu(context: Context) -> Sequence[tuple[str, str]]:
    """A note about an image with CUDA on a machine without an NVIDIA GPU."""
    if DRIVER not in context.image.labels:
        return ()
    text = f"{context.line.image} has CUDA, and this machine has no GPU with NVIDIA's driver, so programs compute on the CPU"
    return [(text, f"{SMALLER}; --no-gpu leaves this line out")]


def handed_in(engine: Engine, host: Host) -> Sequence[str]:
    """The engine's words for all NVIDIA GPUs; none if it cannot hand them in."""
    if host.has(*JETSON) and not engine.podman:
        return ["--runtime", "nvidia"] if engine.nvidia else []
    if any("nvidia.com/gpu" in host.text(file) for folder in engine.cdi for file in host.files(folder)):
        return CDI
    if not engine.podman and (engine.nvidia or host.has(*WSL) or any(map(host.program, HOOKS))):
        return ["--gpus", "all"]
    return []


def lacking(engine: Engine) -> tuple[str, str]:
    """Why there is no GPU, and the remedy."""
    text = f"the container gets no GPU: {engine.program} cannot hand in NVIDIA's"
    cdi_step = ", then sudo nvidia-ctk cdi generate --output=/etc/cdi/nvidia.yaml" if engine.podman else ""
    return text, f"{TOOLKIT}{cdi_step} ({GUIDE}); --no-gpu asks for none"


def _check_driver(context: Context) -> None:
    needed, present = context.image.labels.get(DRIVER, ""), driver(context.host)
    if numbers(present) and numbers(present) < numbers(needed) and not context.line.sets("NVIDIA_DISABLE_REQUIRE"):
        text = f"{context.line.image} needs NVIDIA's driver {needed} or newer, and this machine has {present}"
        raise RosmlError(text, "take an image with an older CUDA, or update the driver; --no-gpu computes on the CPU")


def _not_built_for(context: Context) -> Iterator[tuple[str, str]]:
    """A note for each library of the image that has no code for a GPU of this machine."""
    image, capabilities = context.line.image, chips.capabilities(context.host)
    for label, value in context.image.labels.items():
        library, targets = BUILT.fullmatch(label), value.split()
        uncovered = [f"sm_{major}{minor}" for major, minor in capabilities if not covers(targets, (major, minor))]
        if library and library[2] == context.host.architecture and uncovered:
            gpus = f"this machine has the GPU {listed(uncovered)}"
            text = f"{library[1]} in {image} was built for {' '.join(targets)}, and {gpus}"
            yield text, f"take an image of another stack, or let {library[1]} compute on the CPU"


def driver(host: Host) -> str:
    """The version of NVIDIA's driver, such as `580.159.04`; empty if unknown."""
    loaded = re.search(r"Kernel Module\b.*?\s(\d+\.\d[\d.]*)", host.text("/proc/driver/nvidia/version"))
    return loaded[1] if loaded else host.text("/sys/module/nvidia/version").strip()


def numbers(version: str) -> tuple[int, ...]:
    """The numbers of a version, for comparisons; none if the text is no version, as an image may say anything."""
    match = re.fullmatch(r"[0-9]{1,9}(\.[0-9]{1,9}){0,9}", version.strip())
    return tuple(map(int, match[0].split("."))) if match else ()


def _rendering(context: Context) -> Sequence[str]:
    """The device files of Intel's and AMD's GPUs, with the groups that may open them."""
    nodes = [file for file in context.host.files("/dev/dri") if re.search(r"/(card|renderD)\d+$", file)]
    return ["--device", "/dev/dri", *groups(context, nodes)] if nodes else []


def devices(context: Context) -> Sequence[str]:
    """The groups of device files that the user hands in by `--device`. A user in the container is in none of this machine's
    groups."""
    places = [place for value in context.line.values("device") if (place := value.partition(":")[0]).startswith("/")]
    if not context.is_here or "keep-groups" in context.line.values("group-add"):
        return []
    return groups(context, (node for place in places for node in _nodes(context, place)))


def groups(context: Context, nodes: Iterable[str]) -> list[str]:
    """The words for the groups that may open device files. Their numbers differ between machines. Without root's rights, the engine
    cannot give groups."""
    if context.engine.rootless:
        return []
    group_ids = {context.host.owner(node)[1] for node in nodes} - {0, -1, context.person.gid}
    return [word for group in sorted(group_ids) for word in ("--group-add", str(group))]


def _nodes(context: Context, place: str) -> list[str]:
    """A device file, or all device files in a folder, as with the engines."""
    within = [f"{folder}/{file}" for folder, _, files in os.walk(context.host.path(place)) for file in files]
    top = str(context.host.root).rstrip("/")
    return [file.removeprefix(top) for file in within] or [place]


PLUGINS = (Plugin("devices", devices), Plugin("gpu", gpu, {"no-gpu": "no GPUs"}))
