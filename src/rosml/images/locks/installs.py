"""The releases that people get of packages that they install into images, and the reasons why they get no newer ones.

Each package is resolved three times for the Python of an image: with the constraints of pip and uv there, beside the packages that
have one version in the image, and by itself. The first two must agree: if a constraint leads to an older release, or to none, it
pins more than necessary. Nothing is installed, and no wheel is downloaded.
"""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from functools import cache, partial
from pathlib import Path

from rosml.base import progress_bar, web
from rosml.base.errors import RosmlError
from rosml.base.side_by_side import side_by_side
from rosml.images.image_set.lock_file import package_name, versions
from rosml.images.image_set.model import ImageSet
from rosml.images.locks.index import Index, WheelTarget
from rosml.images.locks.uv import WORKERS, Uv, with_glibc
from rosml.images.matrix import names
from rosml.images.matrix.model import ANY_PYTHON

PACKAGES = (
    "accelerate", "bitsandbytes", "diffusers", "gradio", "gymnasium", "jax", "jax[cuda12]", "jax[cuda13]", "lerobot", "matplotlib",
    "mediapipe", "mlflow", "onnx", "open3d", "opencv-python", "pandas", "peft", "pytorch-lightning",
    "ray", "scikit-learn", "scipy", "sentence-transformers", "stable-baselines3", "tensorboard", "timm", "transformers",
    "ultralytics", "vllm", "wandb",
)  # fmt: skip
"""The packages to check. An extra may get lost: if an older release lacks it, pip and uv only warn."""

GLIBC = {"bookworm": 36, "trixie": 40, "ubuntu-20.04": 31, "ubuntu-22.04": 35, "ubuntu-24.04": 39, "ubuntu-26.04": 40}
"""For each system, the N of the newest glibc 2.N for its wheels. uv knows none above 2.40."""

FILE, PAGE = "locks/installs.json", "docs/installs.md"
"""The file with the answer, and the page that shows it between two markers; both below the project's root."""

BEGIN, END = "<!-- installs: written by 'rosml locks --installs' -->\n", "<!-- /installs -->"


@dataclass(frozen=True, order=True)
class Environment:
    """The Python of images with one stack. `framework` is the one with the most parts, `architecture` the images' first."""

    framework: str
    stack: str
    python: str
    architecture: str


@dataclass(frozen=True, order=True)
class Resolved:
    """The release that people get of a package."""

    package: str  # with its extras
    version: str  # empty if it is refused
    newest: str  # for this Python by itself; empty if the index has no wheel of it
    held_by: tuple[str, ...] = ()  # constraints that keep it from the newest version
    extra: bool = True  # whether that release has the extra
    beside: str = ""  # the version beside the packages that have one version in the image


def environments(image_set: ImageSet) -> list[Environment]:
    """An environment for each stack and Python of images with a lock, with the most parts, the oldest Python first."""
    environments_by_key: dict[tuple[str, str], Environment] = {}
    for image in sorted(image_set.images, key=lambda image: len(image.parts)):
        if image.locked and not image.addons and not image.environment and _slots(image_set, image.framework):
            environment = Environment(image.framework, image.stack or "", image.python, image.architectures[0])
            environments_by_key[environment.stack, environment.python] = environment
    return sorted(environments_by_key.values(), key=lambda item: (int(item.python.split(".")[1]), item.stack))


def _slots(image_set: ImageSet, framework: str) -> list[str]:
    """The parts of a framework whose packages pip and uv see."""
    return [name for name in image_set.matrix.frameworks[framework].parts if image_set.matrix.part[name].slot]


def look(
    image_set: ImageSet, root: Path, uv: str = "uv", say: Callable[[str], None] = lambda line: None
) -> dict[Environment, list[Resolved]]:
    """The releases that people get in every environment."""
    everywhere = environments(image_set)
    resolved: dict[Environment, list[Resolved]] = {}
    with web.client(timeout=60) as client:
        index = Index(Uv(uv), client)
        newest = cache(lambda *about: _version(*index.resolve(WheelTarget(*about[:2]), [about[2]]), about[2])[0])
        for environment in progress_bar.over(everywhere, "environments", len(everywhere)):
            where = _wheels(image_set, environment)
            lines = constraints(image_set, root, environment, index)
            ask = partial(of_package, index, where, lines, newest=newest)
            resolved[environment] = side_by_side(ask, PACKAGES, WORKERS)
            say(f"[{len(resolved)} of {len(everywhere)}] {words(environment)}")
    return resolved


def words(environment: Environment) -> str:
    """`torch cu128, Python 3.12`."""
    return f"{environment.framework} {environment.stack}, Python {environment.python}"


def constraints(image_set: ImageSet, root: Path, environment: Environment, index: Index) -> list[str]:
    """The constraints of pip and uv in an environment, from locks, by the scripts that build images; without local versions."""
    system = image_set.matrix.operating_systems[_system(image_set, environment)]
    script = [str(root / "components/base/constraints.sh")]
    variables = {"NUMPY": system.numpy, "SETUPTOOLS": system.provides["setuptools"]}
    lines = subprocess.run(
        script, env={**os.environ, **variables}, stdout=subprocess.PIPE, text=True, check=True
    ).stdout
    where = _wheels(image_set, environment)
    for part in _slots(image_set, environment.framework):
        lines += _slot(image_set, root, environment, part, where, index)
    return [re.sub(r"(==[^+;]+)\+\w+", r"\1", line) for line in lines.splitlines() if not line.startswith("#")]


def _system(image_set: ImageSet, environment: Environment) -> str:
    return next(image.os for image in image_set.images if image.python == environment.python)


def _wheels(image_set: ImageSet, environment: Environment) -> WheelTarget:
    """The Python of an environment, and the platform of pip's wheels there."""
    oldest = image_set.matrix.architectures[environment.architecture].wheels
    glibc = GLIBC[_system(image_set, environment)]
    return WheelTarget(environment.python, with_glibc(oldest, glibc))


def _slot(
    image_set: ImageSet, root: Path, environment: Environment, part: str, where: WheelTarget, index: Index
) -> str:
    """The constraints that `components/part/packages.py` writes for a part."""
    place = (environment.stack, environment.architecture)
    text = _lock(root, *place, environment.python, part)
    pins = versions(text)
    local = {name for name, version in pins.items() if "+" in version}
    nvidia = {name for name in pins if name.startswith("nvidia-")}  # they only require each other
    wheels = index.wheels(where, {name: pins[name] for name in pins.keys() - local - nvidia}) if pins else {}
    metadata = {name: index.metadata(wheel) for name, wheel in wheels.items()}
    for name in local:
        requires = image_set.matrix.releases[name][pins[name].partition("+")[0]].requires
        metadata[name] = "".join(f"Requires-Dist: {requirement}\n" for requirement in requires)
    with tempfile.TemporaryDirectory() as folder:
        site = Path(folder, "site")
        for name, version in pins.items():
            (site / f"{name}-{version}.dist-info").mkdir(parents=True)
            if name in metadata:
                (site / f"{name}-{version}.dist-info/METADATA").write_text(metadata[name], encoding="utf-8")
        site.mkdir(exist_ok=True)
        lock, shown = Path(folder, "lock.txt"), []
        lock.write_text(text)
        for other in image_set.matrix.part[part].needs:
            if image_set.matrix.part[other].any_python and not image_set.matrix.part[other].release:
                shown.append(Path(folder, f"{other}.txt"))
                shown[-1].write_text(_lock(root, *place, ANY_PYTHON, other))
        variables = {**os.environ, "OUT": folder, "SITE": "/site", "PART": part, "LOCK": str(lock)}
        for script, *arguments in (["adapt_metadata.py"], ["packages.py", "01", *map(str, shown)]):
            command = [sys.executable, str(root / "components/part" / script), *arguments]
            subprocess.run(command, env=variables, check=True, stdout=subprocess.DEVNULL)
        return Path(folder, "usr/local/share/rosml/constraints.d/01.txt").read_text(encoding="utf-8")


def _lock(root: Path, *place: str) -> str:
    file = root / names.lock_path(*place)
    return file.read_text(encoding="utf-8") if file.exists() else ""


def of_package(
    index: Index, where: WheelTarget, constraints: Sequence[str], package: str, newest: Callable[..., str]
) -> Resolved:
    version, extra = _version(*index.resolve(where, [package], constraints), package)
    resolved = Resolved(package, version, newest(*where, package), (), extra, version)
    if version == resolved.newest:
        return resolved
    name = package_name(package)
    core = [line for line in constraints if re.fullmatch(r"[a-z0-9-]+==[^;]+", line)]
    never = [line for line in constraints if line.startswith(f"{name}>=")]  # older ones cannot work
    beside, _ = _version(*index.resolve(where, [package, *core], never), package)
    resolved = replace(resolved, beside=beside)
    better = beside if version != beside else resolved.newest
    if not better:
        return resolved
    text, errors = index.resolve(where, [f"{package}=={better}"], constraints)
    mentioned = set(re.findall(r"[a-z0-9][a-z0-9-]*", errors))
    held = [line for line in constraints if package_name(line) in mentioned and line not in never]
    # First the package's own constraints, then those of packages with one version, then the rest.
    lines = [line for line in held if package_name(line) == name]
    pinned = [line for line in held if line in core]
    return replace(resolved, held_by=() if text else tuple(sorted(set(lines or pinned or held))))


def _version(text: str, errors: str, package: str) -> tuple[str, bool]:
    """The resolved version of a package, and whether that release has its extras."""
    version = versions(re.sub(r"\[[^]]*\]", "", text)).get(package_name(package), "")
    return version, "does not have an extra named" not in errors


def too_old(resolved: Mapping[Environment, Sequence[Resolved]]) -> list[str]:
    """Sentences about packages for which constraints take another release than the packages with one version in the image."""
    return [
        f"{words(environment)}: {item.package} {item.version or 'is refused'}, and {item.beside or 'none'} would go:"
        f" {', '.join(item.held_by) or 'unknown what holds it'}"
        for environment, items in resolved.items()
        for item in items
        if item.version != item.beside
    ]


def to_json(resolved: Mapping[Environment, Sequence[Resolved]]) -> str:
    """The content of `FILE`. The same answers give the same bytes."""
    rows = [
        {**asdict(environment), "packages": [asdict(item) for item in items]} for environment, items in resolved.items()
    ]
    return json.dumps(rows, indent=1, ensure_ascii=False) + "\n"


def render(page: str, resolved: Mapping[Environment, Sequence[Resolved]]) -> str:
    """The page with an up-to-date table."""
    head, begin, rest = page.partition(BEGIN)
    _, end, tail = rest.partition(END)
    if not begin or not end:
        raise RosmlError(f"{PAGE}: the markers {BEGIN.strip()} and {END} are missing", "put them back")
    return "".join((head, begin, *(f"{line}\n" for line in _table(resolved)), end, tail))


def _table(resolved: Mapping[Environment, Sequence[Resolved]]) -> Iterable[str]:
    """First the packages that are the newest everywhere, then the releases of others, newest first."""
    rows: dict[str, dict[tuple[str, str], list[Environment]]] = {package: {} for package in PACKAGES}
    for environment, items in resolved.items():
        for item in items:
            rows[item.package].setdefault((_release(item), _reason(item)), []).append(environment)
    newest = [package for package, releases in rows.items() if not any(why for _, why in releases)]
    yield f"On every distribution the newest that its Python has: {', '.join(f'`{package}`' for package in newest)}."
    yield ""
    yield "| package | release | Python (stacks) | why no newer one |"
    yield "| --- | --- | --- | --- |"
    for package, releases in rows.items():
        if package not in newest:
            for (release, why), places in reversed(releases.items()):
                yield f"| `{package}` | {release} | {_places(places, list(resolved))} | {why} |"


def _release(item: Resolved) -> str:
    if not item.version:
        return "refused" if item.newest else "none"
    return item.version if item.extra else f"**{item.version}, without the extra**"


def _reason(item: Resolved) -> str:
    if not item.newest:
        return "no wheel for this Python"
    if item.version == item.newest:
        return "" if item.extra else "no release has it for this Python"
    held = sorted({line.partition(";")[0] for line in item.held_by})
    return "newer ones do not go with " + (", ".join(f"`{line}`" for line in held) or "other packages")


def _places(places: Sequence[Environment], everywhere: Sequence[Environment]) -> str:
    """`3.11, 3.12 (cpu, cu128)`: Pythons, and stacks, if those are not all that a Python has."""
    words: list[tuple[list[str], list[str]]] = []
    for python in dict.fromkeys(item.python for item in everywhere):
        here, all_of_it = ([item.stack for item in items if item.python == python] for items in (places, everywhere))
        stacks = [] if here == all_of_it else here
        if here and words and words[-1][1] == stacks:
            words[-1][0].append(python)
        elif here:
            words.append(([python], stacks))
    return "; ".join(", ".join(pythons) + (f" ({', '.join(stacks)})" if stacks else "") for pythons, stacks in words)
