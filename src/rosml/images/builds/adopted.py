"""ROS on an image of somebody else: the steps that make our own ROS images, on it in the place of an operating system's image.

What the image has stays: its variables, its user, its programs, its entrypoint, which ours calls.
"""

from __future__ import annotations

import hashlib
import json
import os
import re
import shutil
import tempfile
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path, PurePosixPath
from typing import Any

from pydantic import TypeAdapter, ValidationError

from rosml import ROOT
from rosml.base import files
from rosml.base.errors import RosmlError
from rosml.base.file_lock import turn
from rosml.images.bake import targets
from rosml.images.bake.inputs import Inputs
from rosml.images.bake.targets import NoInput, Overridable, Value
from rosml.images.image_set import labels
from rosml.images.image_set.model import Image, ImageSet
from rosml.images.image_set.system import OTHER, TOOLS, System, system
from rosml.machine import buildx, exported
from rosml.machine.services import Services
from rosml.registry import oci

BIN = "/usr/local/lib/rosml/bin"
"""A folder before all others on PATH: `python3` is that of ROS there, wherever the image has others."""

ENTRYPOINT = ("/tini", "--", "/entrypoint.sh")
"""What images start with (components/base)."""

MOVED = "/usr/local/lib/rosml/entrypoint.sh"
"""Where an /entrypoint.sh of the image's own goes (components/base/contract.sh)."""

_KEPT = ("LANG", "PYTHONIOENCODING", "NVIDIA_VISIBLE_DEVICES", "NVIDIA_DRIVER_CAPABILITIES")
"""Variables that our images set, and that stay as the image has them if it sets them."""

_OTHERWISE = re.compile(
    r"BASH_ENV|ENV|CDPATH|HOME|TMPDIR|LANG|LANGUAGE|(LC|LD|PYTHON)_?[A-Z0-9_]+|PIP_(REQUIRE_VIRTUALENV|TARGET|PREFIX|USER)"
)
"""Variables by which programs of our steps would read, load or write something else. They are empty for the steps."""

_INITS = ("tini", "tini-static", "docker-init", "dumb-init", "catatonit")

_INTERPRETERS = re.compile(r"(python|perl|ruby|node|java|php)[\d.]*")
_PROGRAMS = re.compile(rf"{_INTERPRETERS.pattern}|(ba|da|z)?sh")

_FACTS = exported.Limits(entries=200, each=4 << 20, total=8 << 20)
"""Of what is copied out of an image to see what it is: os-release, two programs, and files of ROS."""


@dataclass(frozen=True)
class Adopted:
    """An image of somebody else, on which ROS is installed.

    Attributes:
        reference: by its digest, or of the user's Docker.
        image_set: all that the matrix describes. image: the ROS image of it whose ROS the other one gets.
        environment, user, entrypoint, shell, labels: of its config.
        carries: CUDA and frameworks that it has.
        sync: of when ROS's apt repository is; empty if no repository of ROS's own has the packages.
        system: the image of the row's own operating system, if steps take a tool from it.
    """

    reference: str
    image_set: ImageSet
    image: Image
    environment: Mapping[str, str] = field(default_factory=dict)
    user: str = ""
    entrypoint: Sequence[str] = ()
    shell: Sequence[str] = ()
    labels: Mapping[str, str] = field(default_factory=dict)
    carries: Sequence[str] = ()
    sync: str = ""
    system: str = ""

    @cached_property
    def inputs(self) -> str:
        """A digest of what decides the base beside the image itself and its platforms."""
        inputs = Inputs(ROOT, self.image_set)
        found = [inputs.digest(self.image.target, architecture) for architecture in self.image.architectures]
        return hashlib.sha256(oci.encoded({"inputs": found, "sync": self.sync})).hexdigest()


def look(
    services: Services, reference: str, platform: str, ros: Iterable[str], frameworks: Iterable[str] = ()
) -> System:
    """What an image is. The builder copies a few files out of it, and runs nothing. Once is enough for a digest.

    Args:
        reference: as the builder takes it. platform: which of its images.
        ros: the distributions to look for in /opt/ros. frameworks: Python packages to look for.

    Raises:
        RosmlError: the image cannot be had.
    """
    asked = {"reference": reference, "platform": platform, "ros": sorted(set(ros)), "for": sorted(set(frameworks))}
    state = services.state / "adopted" / hashlib.sha256(oci.encoded(asked)).hexdigest()
    known = state / "known.json"
    with turn(state / "lock", lambda: None):
        if "@" in reference and known.is_file():
            try:
                return _SYSTEM.validate_json(known.read_bytes())
            except ValidationError:
                pass  # of another version of this program
        found = _look(services, reference, platform, state, sorted(set(ros)), sorted(set(frameworks)))
        files.write(known, _SYSTEM.dump_json(found).decode())
    return found


_SYSTEM = TypeAdapter(System)

_LINK = "failed to calculate checksum of ref"
"""What the builder says of a link that leads nowhere."""


def _look(
    services: Services, reference: str, platform: str, state: Path, ros: Iterable[str], frameworks: Iterable[str]
) -> System:
    archive = state / "system.tar"
    # Each part of a path is a pattern: it may match nothing. Links are followed.
    copies = ["/et[c]/os-releas[e] /etc/", "/us[r]/li[b]/os-releas[e] /usr/lib/"]
    copies += [f"/us[r]/bi[n]/{tool[:-1]}[{tool[-1]}] /bi[n]/{tool[:-1]}[{tool[-1]}] /bin/" for tool in TOOLS]
    # In images for Jetson, it is in a folder of that one.
    for name in ros:
        place = f"/op[t]/ro[s]/{name[:-1]}[{name[-1]}]"
        copies.append(f"{place}/setup.bas[h] {place}/instal[l]/setup.bas[h] /opt/ros/{name}/")
    copies.append("/op[t]/ro[s]/*/setup.bas[h] /op[t]/ro[s]/*/instal[l]/setup.bas[h] /opt/ros/")  # of whatever name
    copies.append("/us[r]/loca[l]/cud[a]/version.jso[n] /us[r]/loca[l]/cuda-*/version.jso[n] /carries/cuda/")
    for name in frameworks:  # where pip and apt put them
        package = f"python3*/*-packages/{name}/__init__.p[y]"
        copies.append(f"/us[r]/loca[l]/li[b]/{package} /us[r]/li[b]/{package} /carries/{name}/")
    target = {
        "context": str(empty(state)),
        "dockerfile-inline": "\n".join(["FROM scratch", *(f"COPY --from=os {copy}" for copy in copies), ""]),
        "contexts": {"os": f"docker-image://{reference}"},
        "platforms": [platform],
        "output": [exported.output(archive)],
    }
    file = state / "system.json"
    files.write(file, json.dumps({"target": {"system": target}}, indent=2) + "\n")
    archive.unlink(missing_ok=True)
    remedy = "name another base image"
    try:
        buildx.run(services, buildx.Bake("system", f"system-{state.name[:12]}", file))
    except RosmlError as error:
        if _LINK not in error.message:
            raise
        files_read = "os-release, apt-get, bash or a setup.bash below /opt/ros"
        raise RosmlError(
            f"{reference} cannot be looked at: {files_read} is a link that leads nowhere", remedy
        ) from None
    folder = state / "system"
    try:
        exported.unpack(archive, folder, limits=_FACTS)
    except RosmlError as error:
        raise RosmlError(f"{reference} cannot be looked at: {error.message}", remedy) from None
    finally:
        archive.unlink(missing_ok=True)  # it may be large
    releases = (folder / name for name in ("etc/os-release", "usr/lib/os-release"))
    text = next((path.read_text(errors="replace") for path in releases if path.is_file()), "")
    found = {path.parent.name for path in (folder / "opt/ros").glob("*/setup.bash")}
    other = {OTHER} if (folder / "opt/ros/setup.bash").is_file() else set()
    tools = {tool for tool in TOOLS if (folder / "bin" / tool).is_file()}
    carries = sorted({path.parent.name for path in (folder / "carries").glob("*/*") if path.is_file()})
    shutil.rmtree(folder)
    return replace(system(text, found or other, tools), carries=tuple(carries))


def stage(services: Services, adopted: Adopted) -> Path:
    """A folder with what the steps read. buildx looks at every file of its context, and a checkout may have a million."""
    place = services.state / "adopted" / f"steps-{adopted.inputs}"
    if not place.is_dir():
        place.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=place.parent) as made:
            folder = Path(made, "steps")
            for name in ("components", "locks", "tools"):
                shutil.copytree(ROOT / name, folder / name, ignore=shutil.ignore_patterns("__pycache__"))
            shutil.copy2(ROOT / "Dockerfile", folder)
            try:
                folder.rename(place)
            except OSError:
                if not place.is_dir():  # another call was quicker otherwise
                    raise
    return place


def empty(folder: Path) -> Path:
    """A folder without files, for a build that gets none."""
    place = folder / "empty"
    place.mkdir(parents=True, exist_ok=True)
    return place


def base_targets(
    adopted: Adopted, name: str, common: Mapping[str, Any], nothing: Path, steps: Path
) -> dict[str, dict[str, Any]]:
    """The bake targets that make a base of an image, each on the one before.

    Args:
        name: of the last one, which is the base; others are called after it.
        common: what all targets of the bake file have: platforms, secrets, a network.
        nothing: an empty folder. steps: what `stage` gave.
    """
    image_set = adopted.image_set
    every = targets.of(image_set)
    chain = [adopted.image]
    while below := image_set.by_target.get(chain[0].parent):
        chain.insert(0, below)
    inline = {**common, "context": str(nothing)}
    first = f"{name}-system"
    found: dict[str, dict[str, Any]] = {
        first: {
            **inline,
            "dockerfile-inline": "\n".join(["FROM os", "USER root", *_plain(adopted), f"ENV PATH={BIN}:$PATH", ""]),
            "contexts": {"os": f"docker-image://{adopted.reference}"},
        }
    }
    on = first
    for step in (chain[0].parent, *(image.target for image in chain)):
        target = every[step]
        contexts = {
            context: f"docker-image://{adopted.system}"
            if context == "os" and target.stage != "base"
            else f"target:{on}"
            for context in target.contexts
        }
        arguments = {
            key: text for key, value in target.arguments.items() if (text := _argument(value, adopted.sync)) is not None
        }
        on = f"{name}-{step.lstrip('_')}"
        found[on] = {
            **common,
            "context": str(steps),
            "dockerfile": str(steps / "Dockerfile"),
            "target": target.stage,
            "contexts": contexts,
            "args": arguments | ({"ADOPTED": "true"} if target.stage == "base" else {}),
        }
    kept = {key: value for key, value in adopted.environment.items() if key in _KEPT or _OTHERWISE.fullmatch(key)}
    found[name] = {
        **inline,
        "dockerfile-inline": _last(adopted, kept),
        "contexts": {"ros": f"target:{on}"},
        "labels": _labels(adopted, every[adopted.image.target].labels),
        "args": {f"KEPT_{key}": value for key, value in kept.items()},
    }
    return found


def _plain(adopted: Adopted) -> list[str]:
    """Lines by which steps run as on our own images, whatever the image says of shells and programs."""
    lines = [
        f"ENV {key}={'/root' if key == 'HOME' else ''}" for key in adopted.environment if _OTHERWISE.fullmatch(key)
    ]
    return ['SHELL ["/bin/sh", "-c"]', *lines] if adopted.shell else lines


_OWN = re.compile(r"(NVIDIA_)?(CUDA|CUDNN|PYTORCH|TORCH|TENSORFLOW)_VERSION")
"""Variables by which images say that they have CUDA or a framework."""


def _labels(adopted: Adopted, row: Mapping[str, Value]) -> dict[str, str]:
    """What `rosml join` asks an image for, and no claim about what is somebody else's: a label cannot be taken away, but be empty."""
    found = {
        name: str(value) for name, value in row.items() if name.startswith(labels.PREFIX) and isinstance(value, str)
    }
    own = " ".join([*adopted.carries, *(name for name in sorted(adopted.environment) if _OWN.fullmatch(name))])
    ours = {name: value for name, value in {**found, labels.OWN: own}.items() if value and name != labels.RUNTIME}
    return dict.fromkeys((name for name in adopted.labels if name.startswith(labels.PREFIX)), "") | ours


def _last(adopted: Adopted, kept: Iterable[str]) -> str:
    """What stands on ROS: how the image starts, as whom, and with what."""
    lines = ["FROM ros"]
    for key in kept:
        lines += [f"ARG KEPT_{key}", f"ENV {key}=${{KEPT_{key}}}"]
    if adopted.shell:
        lines.append(f"SHELL {json.dumps(adopted.shell)}")
    if adopted.user:
        lines.append(f"USER {adopted.user}")
    own = called(adopted.entrypoint)
    return "\n".join(
        [*lines, "STOPSIGNAL SIGTERM", f"ENTRYPOINT {json.dumps([*ENTRYPOINT, *own])}", 'CMD ["bash"]', ""]
    )


def called(entrypoint: Sequence[str]) -> tuple[str, ...]:
    """What ours calls of an image's own entrypoint, before the command: nothing of one that takes no command, such as a line for a
    shell or an interpreter; and no init, which ours has."""
    words = list(entrypoint)
    if words and PurePosixPath(words[0]).name in _INITS:
        del words[0]
        while words and words[0].startswith("-"):
            if words.pop(0) == "--":
                break
    shell = len(words) > 1 and re.fullmatch(r"-[a-z]*c[a-z]*", words[1])
    if words and (_PROGRAMS if len(words) == 1 or shell else _INTERPRETERS).fullmatch(PurePosixPath(words[0]).name):
        return ()
    return tuple(MOVED if word == "/entrypoint.sh" else word for word in words)


def _argument(value: Value, sync: str) -> str | None:
    """What an argument of our own images says; None if nothing."""
    if isinstance(value, str):
        return value
    if isinstance(value, Overridable):
        return (value.variable in targets.CHANNEL and os.environ.get(value.variable)) or value.fact
    if isinstance(value, NoInput) and value.what == "sync date":
        return sync or None
    return os.environ.get(value.of, "") or os.environ.get(value.of.lower(), "") or None
