"""Installs ROS on an image of somebody else, which keeps its variables, user, programs and entrypoint."""

from __future__ import annotations

import hashlib
import json
import os
import re
import shutil
import tempfile
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import asdict, dataclass, field, replace
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
from rosml.images.image_set.system import DPKG, OTHER, PROGRAMS, SOURCE, System, system
from rosml.machine import buildx, exported
from rosml.machine.services import Services
from rosml.registry import oci

BIN = "/usr/local/lib/rosml/bin"
"""The first folder on PATH. Its `python3` is the Python of ROS, even if the image has others."""

ENTRYPOINT = ("/tini", "--", "/entrypoint.sh")

MOVED = "/usr/local/lib/rosml/entrypoint.sh"
"""Where the image's own /entrypoint.sh goes (components/base/contract.sh)."""

_KEPT = ("LANG", "PYTHONIOENCODING", "NVIDIA_VISIBLE_DEVICES", "NVIDIA_DRIVER_CAPABILITIES")
"""Variables that our images set. If the image sets them, its values stay."""

_ROS = ("ROS_DISTRO", "ROS_VERSION", "ROS_SYNC_DATE")
"""Variables of the installed ROS. If the image sets them, ours count."""

_STEP = ROOT / "components/containerize/step.sh"

_DEFAULT_SHELL = ("/bin/sh", "-c")

_INITS = ("tini", "tini-static", "docker-init", "dumb-init", "catatonit")

_SHELLS = ("sh", "bash", "dash", "ash")
_SHEBANG = re.compile(r"#![ \t]*(/usr)?/bin/(env[ \t]+)?(ba|da|a)?sh\b")

_BECOMES = re.compile(r'exec (-- |(gosu|su-exec) [\w:.-]+ )?"\$(@|\{@\})"')
"""The line by which a script becomes the command that it gets."""

_ELSEWHERE = re.compile(r"exec (?![0-9]*[<>&])|exit\b|set -- ")
"""The beginning of a line after which a script is something else, or has another command. Only a line in no block begins so."""

_PATH = "/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin"
"""PATH of an image that sets none."""

_FOLDERS = 16
"""The most folders of PATH in which an entrypoint is looked for."""

_PLAIN = re.compile(r"(/[\w.+-]*[\w.])+", re.ASCII)
"""A path that means the same in a Dockerfile, and as a pattern."""

_FACTS = exported.Limits(entries=200, each=4 << 20, total=8 << 20)
"""Limits of what is copied out of an image to examine it. Of larger files it counts that they are there."""


@dataclass(frozen=True)
class Adopted:
    """An image of somebody else, on which ROS is installed. Environment, user, shell and labels are from its config."""

    reference: str  # by digest, or of an image in the user's Docker
    image_set: ImageSet
    image: Image  # the ROS image whose ROS is installed
    environment: Mapping[str, str] = field(default_factory=dict)
    user: str = ""
    entrypoint: Sequence[str] = ()  # the words of its entrypoint that ours calls before the command
    shell: Sequence[str] = ()
    labels: Mapping[str, str] = field(default_factory=dict)
    carries: Sequence[str] = ()  # CUDA and frameworks that the image has
    sync: str = ""  # the sync date of ROS's apt repository; empty if the packages come from elsewhere
    system: str = ""  # the base image of the distribution's operating system, if steps take a tool from it

    @cached_property
    def inputs(self) -> str:
        """A digest of everything that decides the result, except the image itself and its platforms."""
        inputs = Inputs(ROOT, self.image_set)
        digests = [inputs.digest(self.image.target, architecture) for architecture in self.image.architectures]
        facts = {"inputs": digests, "sync": self.sync, "entrypoint": [*self.entrypoint]}
        return hashlib.sha256(oci.encoded(facts)).hexdigest()


@dataclass(frozen=True)
class Query:
    """What to look for in an image."""

    ros: tuple[str, ...] = ()  # the distributions to look for in /opt/ros
    frameworks: tuple[str, ...] = ()
    scripts: tuple[str, ...] = ()  # paths of which the first existing one is its entrypoint


def look(services: Services, reference: str, platform: str, query: Query) -> System:
    """Examines an image. The builder copies a few files out of it, and runs nothing. The result is kept for its digest."""
    key = {"reference": reference, "platform": platform, **asdict(query)}
    state = services.state / "adopted" / hashlib.sha256(oci.encoded(key)).hexdigest()
    kept_facts = state / "known.json"
    with turn(state / "lock", lambda: None):
        if "@" in reference and kept_facts.is_file():
            try:
                return _SYSTEM.validate_json(kept_facts.read_bytes())
            except ValidationError:
                pass  # from another version of this program
        facts = _look(services, reference, platform, state, query)
        files.write(kept_facts, _SYSTEM.dump_json(facts).decode())
    return facts


_SYSTEM = adapter(System)

_LINK = "failed to calculate checksum of ref"
"""The builder's message about a link that leads nowhere."""


def _copies(query: Query) -> list[str]:
    """What to copy out of an image: sources and destination of each COPY. Links are followed."""
    copies = [f"{_if_there('/etc/os-release')} /etc/", f"{_if_there('/usr/lib/os-release')} /usr/lib/"]
    copies += [f"{_if_there(f'/usr/bin/{tool}')} {_if_there(f'/bin/{tool}')} /bin/" for tool in PROGRAMS]
    copies.append(f"{_if_there(DPKG)} /dpkg/")
    copies.append(" ".join([*map(_if_there, _SOURCES), "/apt/"]))
    # Images for Jetson have it in the folder `install` of the distribution's folder.
    places = [(f"/opt/ros/{name}", name) for name in query.ros] + [("/opt/ros/*", "")]  # any other ROS
    for place, name in places:
        setups = (f"{place}/setup.bash", f"{place}/install/setup.bash")
        copies.append(f"{' '.join(map(_if_there, setups))} {PurePosixPath('/opt/ros', name)}/")
    cuda = ("/usr/local/cuda/version.json", "/usr/local/cuda-*/version.json")
    copies.append(f"{' '.join(map(_if_there, cuda))} /carries/cuda/")
    for name in query.frameworks:  # where pip and apt put them
        modules = (f"{folder}/python3*/*-packages/{name}/__init__.py" for folder in ("/usr/local/lib", "/usr/lib"))
        copies.append(f"{' '.join(map(_if_there, modules))} /carries/{name}/")
    copies += [f"{_if_there(path)} /entrypoint/{number}/" for number, path in enumerate(query.scripts)]
    return copies


_SOURCES = ("/etc/apt/sources.list", "/etc/apt/sources.list.d/*.list", "/etc/apt/sources.list.d/*.sources")


def _if_there(path: str) -> str:
    """A pattern for COPY that matches a path, or nothing: each part of it is a pattern."""
    return "/".join(part if "*" in part else f"{part[:-1]}[{part[-1]}]" if part else "" for part in path.split("/"))


def _look(services: Services, reference: str, platform: str, state: Path, query: Query) -> System:
    archive = state / "system.tar"
    target = {
        "context": str(empty(state)),
        "dockerfile-inline": "\n".join(["FROM scratch", *(f"COPY --from=os {copy}" for copy in _copies(query)), ""]),
        "contexts": {"os": f"docker-image://{reference}"},
        "platforms": [platform],
        "output": [exported.output(archive)],
    }
    file = state / "system.json"
    files.write(file, json.dumps({"target": {"system": target}}, indent=2) + "\n")
    archive.unlink(missing_ok=True)
    remedy = "name another base image"
    try:
        call = buildx.Bake("system", f"system-{state.name[:12]}", file, glance=f"looking into {reference}")
        buildx.run(services, call)
    except RosmlError as error:
        if _LINK not in error.message:
            raise
        files_read = "os-release, apt-get, bash, a list of apt or dpkg, its entrypoint or a setup.bash below /opt/ros"
        raise RosmlError(f"{reference} cannot be examined: {files_read} is a link that leads nowhere", remedy) from None
    folder = state / "system"
    try:
        larger = exported.unpack(archive, folder, limits=_FACTS)
    except RosmlError as error:
        raise RosmlError(f"{reference} cannot be examined: {error.message}", remedy) from None
    finally:
        archive.unlink(missing_ok=True)  # the archive may be large
    facts = _facts(folder, larger, query)
    shutil.rmtree(folder)
    return facts


def _facts(folder: Path, larger: Collection[str], query: Query) -> System:
    """The facts in copied files; `larger` are paths of files that are too large to be copied."""
    releases = (folder / name for name in ("etc/os-release", "usr/lib/os-release"))
    text = next((path.read_text(errors="replace") for path in releases if path.is_file()), "")
    ros = {path.parent.name for path in (folder / "opt/ros").glob("*/setup.bash")}
    other = {OTHER} if (folder / "opt/ros/setup.bash").is_file() else set()
    tools = {name for name in PROGRAMS if (folder / "bin" / name).is_file()}
    if (folder / "dpkg/status").is_file() or "dpkg/status" in larger:
        tools.add(DPKG)
    if any(_SOURCE.search(path.read_text(errors="replace")) for path in (folder / "apt").glob("*") if path.is_file()):
        tools.add(SOURCE)
    carries = sorted({path.parent.name for path in (folder / "carries").glob("*/*") if path.is_file()})
    numbers = (str(number) for number in range(len(query.scripts)))
    script = next((path for number in numbers for path in (folder / "entrypoint" / number).glob("*")), None)
    passes_on = script is not None and script.is_file() and ends_in_the_command(script.read_text(errors="replace"))
    return replace(system(text, ros or other, tools), carries=tuple(carries), passes_on=passes_on)


_SOURCE = re.compile(r"^[ \t]*(deb[ \t]|Types:(.*[ \t])?deb([ \t]|$))", re.MULTILINE)
"""A line of apt's list that names a source of packages."""


def stage(services: Services, adopted: Adopted) -> Path:
    """A folder with the files that the steps read: buildx visits every file of its context, and a checkout has many."""
    place = services.state / "adopted" / f"steps-{adopted.inputs}"
    if not place.is_dir():
        place.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=place.parent) as temporary:
            folder = Path(temporary, "steps")
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
    """The bake targets that install ROS on an image, each on the one before. `common` are settings of all, such as platforms and secrets."""
    image_set = adopted.image_set
    every = targets.of(image_set)
    chain = [adopted.image]
    while below := image_set.by_target.get(chain[0].parent):
        chain.insert(0, below)
    inline = {**common, "context": str(nothing)}
    first, emptied = f"{name}-system", _arguments(adopted)
    bake_targets: dict[str, dict[str, Any]] = {
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
        values = ((key, _argument(value, adopted.sync)) for key, value in target.arguments.items())
        arguments = {key: text for key, text in values if text is not None}
        on = f"{name}-{step.lstrip('_')}"
        bake_targets[on] = {
            **common,
            "context": str(steps),
            "dockerfile": str(steps / "Dockerfile"),
            "target": target.stage,
            "contexts": contexts,
            "args": arguments | ({"ADOPTED": "true"} if target.stage == "base" else {}),
        }
    kept = {key: value for key, value in adopted.environment.items() if key in _KEPT or key in {*emptied} - {*_ROS}}
    bake_targets[name] = {
        **inline,
        "dockerfile-inline": _last(adopted, kept),
        "contexts": {"ros": f"target:{on}"},
        "labels": _labels(adopted, every[adopted.image.target].labels),
        "args": {f"KEPT_{key}": value for key, value in kept.items()},
    }
    return bake_targets


def _arguments(adopted: Adopted) -> list[str]:
    """The image's variables with the name of an argument of our Dockerfile. They would count if it has no value."""
    lines = re.findall(r"^ARG (.+)$", (ROOT / "Dockerfile").read_text(), re.MULTILINE)
    declared = {word.partition("=")[0] for line in lines for word in line.split()}
    return [name for name in adopted.environment if name in declared]


def _plain(emptied: Iterable[str]) -> list[str]:
    """Lines of a Dockerfile that make steps run as on our own images, whatever shells and variables the image sets."""
    script = re.sub("^#.*\n", "", files.text(_STEP), flags=re.MULTILINE)  # the image's history repeats it
    shell = [*_DEFAULT_SHELL, script, _STEP.name, *_DEFAULT_SHELL]
    return [f"SHELL {json.dumps(shell)}", *(f"ENV {name}=" for name in emptied)]


_OWN = re.compile(r"(NVIDIA_)?(CUDA|CUDNN|PYTORCH|TORCH|TENSORFLOW)_VERSION")
"""Variables that show that an image has CUDA or a framework."""


def _labels(adopted: Adopted, row: Mapping[str, Value]) -> dict[str, str]:
    """The labels that `rosml join` reads. A build cannot remove others with our prefix, so they become empty."""
    carried = " ".join([*adopted.carries, *filter(_OWN.fullmatch, sorted(adopted.environment))])
    texts = {name: value for name, value in row.items() if isinstance(value, str)} | {labels.OWN: carried}
    ours = {name: value for name, value in texts.items() if name.startswith(labels.PREFIX) and value}
    ours.pop(labels.RUNTIME, None)
    return dict.fromkeys((name for name in adopted.labels if name.startswith(labels.PREFIX)), "") | ours


def _last(adopted: Adopted, kept: Iterable[str]) -> str:
    lines = ["FROM ros"]
    for key in kept:
        lines += [f"ARG KEPT_{key}", f"ENV {key}=${{KEPT_{key}}}"]
    lines.append(f"SHELL {json.dumps(adopted.shell or _DEFAULT_SHELL)}")
    if adopted.user:
        lines.append(f"USER {adopted.user}")
    entrypoint = json.dumps([*ENTRYPOINT, *adopted.entrypoint])
    return "\n".join([*lines, "STOPSIGNAL SIGTERM", f"ENTRYPOINT {entrypoint}", 'CMD ["bash"]', ""])


def scripts(entrypoint: Sequence[str], environment: Mapping[str, str]) -> tuple[str, ...]:
    """The paths at which the script of an image's entrypoint may be, if it has no other words but an init and a shell."""
    words = _without_init(entrypoint)
    if len(words) == 2 and PurePosixPath(words[0]).name in _SHELLS:
        words = words[1:]
    if len(words) != 1:
        return ()
    [word] = words
    folders = environment.get("PATH", _PATH).split(":")[:_FOLDERS]
    places = [word] if "/" in word else [f"{folder}/{word}" for folder in folders if folder]
    places += [f"/usr{place}" for place in places if place.startswith(("/bin/", "/sbin/"))]  # links to these, by now
    return tuple(place for place in places if _PLAIN.fullmatch(place))


def ends_in_the_command(script: str) -> bool:
    lines = [line for raw in script.splitlines() if (line := raw.strip()) and not line.startswith("#")]
    if not _SHEBANG.match(script) or not lines:
        return False
    outside = [raw for raw in script.splitlines() if raw.strip() and not raw.lstrip().startswith("#")]
    if any(map(_ELSEWHERE.match, outside[:-1])):
        return False
    if lines[-1] == "fi" and lines[-3:-2] == ["else"]:  # such as NVIDIA's, which becomes bash if there is no command
        lines.pop()
    return _BECOMES.fullmatch(lines[-1]) is not None


def called(entrypoint: Sequence[str]) -> tuple[str, ...]:
    """The words of an image's own entrypoint that our entrypoint calls before the command: without an init, which ours has."""
    return tuple(MOVED if word == "/entrypoint.sh" else word for word in _without_init(entrypoint))


def _without_init(entrypoint: Sequence[str]) -> list[str]:
    words = list(entrypoint)
    if words and PurePosixPath(words[0]).name in _INITS:
        del words[0]
        while words and words[0].startswith("-"):
            if words.pop(0) == "--":
                break
    return words


def _argument(value: Value, sync: str) -> str | None:
    if isinstance(value, str):
        return value
    if isinstance(value, Overridable):
        return (value.variable in targets.CHANNEL and os.environ.get(value.variable)) or value.fact
    if isinstance(value, NoInput) and value.what == "sync date":
        return sync or None
    return os.environ.get(value.of, "") or os.environ.get(value.of.lower(), "") or None
