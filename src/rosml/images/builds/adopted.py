"""Installs ROS on an image of somebody else, with the same steps that build our own ROS images.

The image keeps its variables, its user, its programs, and its entrypoint, which our entrypoint calls.
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

from pydantic import ValidationError

from rosml import ROOT
from rosml.base import files
from rosml.base.errors import RosmlError
from rosml.base.file_lock import turn
from rosml.base.shapes import adapter
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
"""The first folder on PATH. Its `python3` is the Python of ROS, even if the image has others."""

ENTRYPOINT = ("/tini", "--", "/entrypoint.sh")
"""The entrypoint of our images (components/base)."""

MOVED = "/usr/local/lib/rosml/entrypoint.sh"
"""Where the image's own /entrypoint.sh goes (components/base/contract.sh)."""

_KEPT = ("LANG", "PYTHONIOENCODING", "NVIDIA_VISIBLE_DEVICES", "NVIDIA_DRIVER_CAPABILITIES")
"""Variables that our images set. If the image sets them, its values stay."""

_ROS = ("ROS_DISTRO", "ROS_VERSION", "ROS_SYNC_DATE")
"""Variables of the installed ROS. If the image sets them, ours count."""

_STEP = ROOT / "components/containerize/step.sh"
"""The script that starts a step with the variables that it may have."""

_DEFAULT_SHELL = ("/bin/sh", "-c")
"""What runs steps if an image names no shell."""

_INITS = ("tini", "tini-static", "docker-init", "dumb-init", "catatonit")

_INTERPRETERS = re.compile(r"(python|perl|ruby|node|java|php)[\d.]*")
_PROGRAMS = re.compile(rf"{_INTERPRETERS.pattern}|(ba|da|z)?sh")

_FACTS = exported.Limits(entries=200, each=4 << 20, total=8 << 20)
"""Limits of what is copied out of an image to examine it: os-release, two programs, and files of ROS."""


@dataclass(frozen=True)
class Adopted:
    """An image of somebody else, on which ROS is installed.

    Attributes:
        reference: by digest, or of an image in the user's Docker.
        image_set: all that the matrix describes.
        image: the ROS image whose ROS is installed.
        environment: from the config.
        user: from the config.
        entrypoint: from the config.
        shell: from the config.
        labels: from the config.
        carries: CUDA and frameworks that the image has.
        sync: the sync date of ROS's apt repository; empty if the packages come from elsewhere.
        system: the base image of the distribution's operating system, if steps take a tool from it.
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
        """A digest of everything that decides the result, except the image itself and its platforms."""
        inputs = Inputs(ROOT, self.image_set)
        found = [inputs.digest(self.image.target, architecture) for architecture in self.image.architectures]
        return hashlib.sha256(oci.encoded({"inputs": found, "sync": self.sync})).hexdigest()


def look(
    services: Services, reference: str, platform: str, ros: Iterable[str], frameworks: Iterable[str] = ()
) -> System:
    """Examines an image. The builder copies a few files out of it, and runs nothing. The result is kept for its digest.

    Args:
        services: the builder.
        reference: as the builder takes it.
        platform: which image of an index.
        ros: the distributions to look for in /opt/ros.
        frameworks: Python packages to look for.

    Raises:
        RosmlError: the image is not available, or cannot be examined.
    """
    asked = {"reference": reference, "platform": platform, "ros": sorted(set(ros)), "for": sorted(set(frameworks))}
    state = services.state / "adopted" / hashlib.sha256(oci.encoded(asked)).hexdigest()
    known = state / "known.json"
    with turn(state / "lock", lambda: None):
        if "@" in reference and known.is_file():
            try:
                return _SYSTEM.validate_json(known.read_bytes())
            except ValidationError:
                pass  # from another version of this program
        found = _look(services, reference, platform, state, sorted(set(ros)), sorted(set(frameworks)))
        files.write(known, _SYSTEM.dump_json(found).decode())
    return found


_SYSTEM = adapter(System)

_LINK = "failed to calculate checksum of ref"
"""The builder's message about a link that leads nowhere."""


def _look(
    services: Services, reference: str, platform: str, state: Path, ros: Iterable[str], frameworks: Iterable[str]
) -> System:
    archive = state / "system.tar"
    # Each part of a path is a pattern, so that it may match nothing. Links are followed.
    copies = ["/et[c]/os-releas[e] /etc/", "/us[r]/li[b]/os-releas[e] /usr/lib/"]
    copies += [f"/us[r]/bi[n]/{tool[:-1]}[{tool[-1]}] /bi[n]/{tool[:-1]}[{tool[-1]}] /bin/" for tool in TOOLS]
    # Images for Jetson have it in the folder `install` of the distribution's folder.
    for name in ros:
        place = f"/op[t]/ro[s]/{name[:-1]}[{name[-1]}]"
        copies.append(f"{place}/setup.bas[h] {place}/instal[l]/setup.bas[h] /opt/ros/{name}/")
    copies.append("/op[t]/ro[s]/*/setup.bas[h] /op[t]/ro[s]/*/instal[l]/setup.bas[h] /opt/ros/")  # any other ROS
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
        raise RosmlError(f"{reference} cannot be examined: {files_read} is a link that leads nowhere", remedy) from None
    folder = state / "system"
    try:
        exported.unpack(archive, folder, limits=_FACTS)
    except RosmlError as error:
        raise RosmlError(f"{reference} cannot be examined: {error.message}", remedy) from None
    finally:
        archive.unlink(missing_ok=True)  # the archive may be large
    releases = (folder / name for name in ("etc/os-release", "usr/lib/os-release"))
    text = next((path.read_text(errors="replace") for path in releases if path.is_file()), "")
    found = {path.parent.name for path in (folder / "opt/ros").glob("*/setup.bash")}
    other = {OTHER} if (folder / "opt/ros/setup.bash").is_file() else set()
    tools = {tool for tool in TOOLS if (folder / "bin" / tool).is_file()}
    carries = sorted({path.parent.name for path in (folder / "carries").glob("*/*") if path.is_file()})
    shutil.rmtree(folder)
    return replace(system(text, found or other, tools), carries=tuple(carries))


def stage(services: Services, adopted: Adopted) -> Path:
    """A folder with the files that the steps read. buildx visits every file of its context, and a checkout may have a
    million files."""
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
                if not place.is_dir():  # if it exists, another call was faster
                    raise
    return place


def empty(folder: Path) -> Path:
    """An empty folder, as the context of a build."""
    place = folder / "empty"
    place.mkdir(parents=True, exist_ok=True)
    return place


def base_targets(
    adopted: Adopted, name: str, common: Mapping[str, Any], nothing: Path, steps: Path
) -> dict[str, dict[str, Any]]:
    """The bake targets that install ROS on an image, each on the one before.

    Args:
        adopted: the image, and the ROS for it.
        name: of the last target. The names of the others begin with it.
        common: settings of all targets, such as platforms, secrets and network.
        nothing: an empty folder.
        steps: the folder from `stage`.
    """
    image_set = adopted.image_set
    every = targets.of(image_set)
    chain = [adopted.image]
    while below := image_set.by_target.get(chain[0].parent):
        chain.insert(0, below)
    inline = {**common, "context": str(nothing)}
    first, emptied = f"{name}-system", _arguments(adopted)
    found: dict[str, dict[str, Any]] = {
        first: {
            **inline,
            "dockerfile-inline": "\n".join(["FROM os", "USER root", *_plain(emptied), f"ENV PATH={BIN}:$PATH", ""]),
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
    kept = {key: value for key, value in adopted.environment.items() if key in _KEPT or key in {*emptied} - {*_ROS}}
    found[name] = {
        **inline,
        "dockerfile-inline": _last(adopted, kept),
        "contexts": {"ros": f"target:{on}"},
        "labels": _labels(adopted, every[adopted.image.target].labels),
        "args": {f"KEPT_{key}": value for key, value in kept.items()},
    }
    return found


def _arguments(adopted: Adopted) -> list[str]:
    """The variables of an image that have the name of an argument of our Dockerfile, and would count if it has no value."""
    lines = re.findall(r"^ARG (.+)$", (ROOT / "Dockerfile").read_text(), re.MULTILINE)
    declared = {word.partition("=")[0] for line in lines for word in line.split()}
    return [name for name in adopted.environment if name in declared]


def _plain(emptied: Iterable[str]) -> list[str]:
    """Lines of a Dockerfile that make steps run as on our own images, whatever shells and variables the image sets.

    Args:
        emptied: variables of the image that steps have empty.
    """
    script = re.sub("^#.*\n", "", files.text(_STEP), flags=re.MULTILINE)  # the image's history repeats it
    shell = [*_DEFAULT_SHELL, script, _STEP.name, *_DEFAULT_SHELL]
    return [f"SHELL {json.dumps(shell)}", *(f"ENV {name}=" for name in emptied)]


_OWN = re.compile(r"(NVIDIA_)?(CUDA|CUDNN|PYTORCH|TORCH|TENSORFLOW)_VERSION")
"""Variables that show that an image has CUDA or a framework."""


def _labels(adopted: Adopted, row: Mapping[str, Value]) -> dict[str, str]:
    """The labels that `rosml join` reads. Other labels with our prefix become empty, since a build cannot remove
    labels."""
    found = {
        name: str(value) for name, value in row.items() if name.startswith(labels.PREFIX) and isinstance(value, str)
    }
    own = " ".join([*adopted.carries, *(name for name in sorted(adopted.environment) if _OWN.fullmatch(name))])
    ours = {name: value for name, value in {**found, labels.OWN: own}.items() if value and name != labels.RUNTIME}
    return dict.fromkeys((name for name in adopted.labels if name.startswith(labels.PREFIX)), "") | ours


def _last(adopted: Adopted, kept: Iterable[str]) -> str:
    """The Dockerfile of the last target: variables, shell, user and entrypoint of the image."""
    lines = ["FROM ros"]
    for key in kept:
        lines += [f"ARG KEPT_{key}", f"ENV {key}=${{KEPT_{key}}}"]
    lines.append(f"SHELL {json.dumps(adopted.shell or _DEFAULT_SHELL)}")
    if adopted.user:
        lines.append(f"USER {adopted.user}")
    own = called(adopted.entrypoint)
    return "\n".join(
        [*lines, "STOPSIGNAL SIGTERM", f"ENTRYPOINT {json.dumps([*ENTRYPOINT, *own])}", 'CMD ["bash"]', ""]
    )


def called(entrypoint: Sequence[str]) -> tuple[str, ...]:
    """The words of an image's own entrypoint that our entrypoint calls before the command: without an init, which ours
    has; none if the entrypoint takes no command, such as a shell line or an interpreter."""
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
    """The value of a build argument of our own images; None if it has none."""
    if isinstance(value, str):
        return value
    if isinstance(value, Overridable):
        return (value.variable in targets.CHANNEL and os.environ.get(value.variable)) or value.fact
    if isinstance(value, NoInput) and value.what == "sync date":
        return sync or None
    return os.environ.get(value.of, "") or os.environ.get(value.of.lower(), "") or None
