"""The names of targets, parts and variables."""

from __future__ import annotations

from collections.abc import Iterable

from rosml.images.matrix.model import ANY_PYTHON, Matrix

ROS = "ros"
"""Stands for a part in the paths of locks of distributions from wheels. The distribution takes the place of a stack; no stack has
the same name."""

AXES = ("distributions", "components", "frameworks", "addons", "environments", "stacks")
"""The sections of the matrix whose names are groups of the bake file."""

RESERVED_GROUPS = ("all", "default", "every", "files", "image", "latest", "parts", "test", "tests")
"""Names of groups, tags and abstract targets that do not come from an axis of the matrix."""


ENVIRONMENTS = "environments"
"""The folder with the locks of environments, in the project's root."""

NONE = "none"
"""The usual name of the framework without parts."""


def our_words(matrix: Matrix) -> dict[str, str]:
    """Words that people try in names and groups, and ours for each: titles of parts, parts of add-ons, names of repositories, machines."""
    titles = {part.title.lower(): part.name for part in matrix.parts if part.title}
    for addon, entry in matrix.addons.items():
        names = dict.fromkeys(entry.parts, addon)
        titles |= names | {title: names[part] for title, part in titles.items() if part in names}
    repositories = {facts.repository.removeprefix(f"{ROS}-"): name for name, facts in matrix.frameworks.items()}
    return {**titles, **repositories, "x86_64": "amd64", "aarch64": "arm64"}


def our_word(matrix: Matrix, word: str) -> str:
    """Our word for one that people try, also with a version at its end: `tensorflow2`. The word itself if we have no other."""
    ours, lower = our_words(matrix), word.lower()
    bare = lower.rstrip(".0123456789")
    return ours.get(lower) or (ours.get(bare) if bare != ROS else None) or lower  # ros1 is no framework


def image_target(
    distribution: str,
    component: str,
    framework: str = NONE,
    stack: str | None = None,
    addons: Iterable[str] = (),
) -> str:
    """The bake target of an image: `jazzy-base`, `jazzy-base-torch-cu128`, `jazzy-base-torch-onnx-cu128`."""
    parts_of_name = [name for name in (framework, *addons) if name != NONE]
    return "-".join([distribution, component, *([*parts_of_name, stack] if stack else [])])


def environments_end(environments: Iterable[str]) -> str:
    """What names and tags of an image with environments have at their end; empty without any. No name has `_`, so other environments
    have another end."""
    sorted_names = sorted(filter(None, environments))
    return f"-env-{'_'.join(sorted_names)}" if sorted_names else ""


def test_target(image: str) -> str:
    """The target that tests an image."""
    return f"{image}-test"


def os_slug(os: str) -> str:
    """An operating system in the name of a target: bake allows no points there."""
    return os.replace(".", "-")


def os_target(os: str, runtime: bool = False) -> str:
    """The target of an operating system with the essentials: to build programs, or only to run them."""
    return f"_os-{os_slug(os)}{'-run' if runtime else ''}"


def os_variable(os: str) -> str:
    """The bake variable that holds an operating system's base image."""
    return "OS_" + os_slug(os).replace("-", "_").upper()


def part_name(part: str, stack: str, python: str) -> str:
    """The name of a part, which is also its tag: `torch-cu128-py311`; `cuda-cu128` if it is for any Python."""
    return f"{part}-{stack}" + ("" if python == ANY_PYTHON else f"-py{python.replace('.', '')}")


def environment_name(name: str, python: str) -> str:
    """The tag of an environment: `lerobot-py311`."""
    return f"{name}-py{python.replace('.', '')}"


def environment_part(name: str, python: str) -> str:
    """The name of an environment among the parts of an image: `env:lerobot-py311`."""
    return f"env:{environment_name(name, python)}"


def files_target(part: str) -> str:
    """The target that builds a part's files below /out."""
    return f"_files-{part.replace(':', '-')}"


def part_target(part: str) -> str:
    """The target of a part as an image of its own: `part-torch-cu128-py311`, `part-env-lerobot-py311`."""
    return f"part-{part.replace(':', '-')}"


def lock_path(stack: str, architecture: str, python: str, part: str) -> str:
    """The path of a part's lock, relative to the project's root. The Dockerfile has the same path."""
    return f"locks/{stack}/{architecture}/{python}/{part}.txt"


def environment_locks(name: str, python: str) -> str:
    """The folder of an environment's locks, relative to the project's root. Each lock is named by its architecture."""
    return f"{ENVIRONMENTS}/{name}/{python}"


def lock_architecture(lock: str) -> str:
    """The architecture of a lock, by its path."""
    folder, _, third, *_, file = lock.split("/")
    return file.removesuffix(".txt") if folder == ENVIRONMENTS else third


def lock_head(stack: str, architecture: str, python: str, part: str) -> str:
    """The first line of a lock, which names its part."""
    return f"# Part '{part}' of stack {stack}, Python {python}, {architecture}."


def adapted_line(package: str, requirement: str) -> str:
    """The line of a lock with a requirement of a package that replaces its wheel's."""
    return f"# adapted: {package} {requirement}"


def wheels_head(distribution: str, architecture: str, python: str) -> str:
    """The first line of the lock of a distribution from wheels."""
    return f"# ROS of {distribution}, Python {python}, {architecture}."
