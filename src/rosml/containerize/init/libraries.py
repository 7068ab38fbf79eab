"""The libraries that manifests and sources name: which of them the base image has, and what brings the others."""

from __future__ import annotations

import contextlib
import re
from collections.abc import Collection, Iterator

from rosml import ROOT
from rosml.containerize import inputs as app_inputs
from rosml.containerize.init.packages import FolderScan, Mention
from rosml.containerize.init.situation import Note
from rosml.images.image_set.model import Image
from rosml.images.matrix import combinations
from rosml.images.matrix.model import Matrix

CUPY, CUDA, OPENCV = "CuPy", "CUDA", "OpenCV"

OTHERS = {
    CUPY: ("cupy",),
    CUDA: ("cuda",),
    OPENCV: ("opencv", "opencv2", "cv2", "libopencv", "cv_bridge"),
}

_PIP = f"a line in {app_inputs.default('additional-pip-file')}"

LACKING = {
    CUPY: ("no package.xml does", _PIP),
    CUDA: (
        "base images have CUDA's libraries, and no nvcc",
        "if it is to be compiled, take the add-on devel on a stack with CUDA 13 (docs/addons/devel.md), or NVIDIA's image with -devel"
        " as BASE_IMAGE: containerize installs ROS on it",
    ),
    OPENCV: (
        "no package.xml does",
        "write <depend>libopencv-dev</depend> for C++, <depend>python3-opencv</depend> for Python",
    ),
}
"""What is missing if only sources name them, and the remedy."""


def words(matrix: Matrix) -> dict[str, set[str]]:
    """The words for what the parts of the matrix bring, by title, and for other libraries."""
    by_title: dict[str, set[str]] = {}
    for part in matrix.parts:
        if part.title and part.release:
            releases = matrix.releases.get(part.release, {}).values()
            beside = {name for release in releases for name in release.beside}
            by_title[part.title] = {part.name, f"lib{part.name}", part.title.lower(), *beside}
    return by_title | {name: set(words) for name, words in OTHERS.items()}


def keys_in_base(matrix: Matrix, image: Image, keys: Collection[str]) -> tuple[str, ...]:
    """Those of rosdep's keys that stand for Python packages which parts of an image bring, such as `python3-torch`; and for ROS packages
    that an image has as wheels."""
    families = combinations.families(matrix, matrix.frameworks[image.framework])
    python = {*families, *combinations.company(matrix, image.stack, families)}
    python |= {part.title.lower() for part in matrix.parts if part.title and part.release in families}
    matches = {key: re.fullmatch(r"python3?-(.+?)(-gpu)?(-pip)?", key) for key in keys}
    wheels = set[str]()
    for lock in image.locks if image.wheels else ():
        with contextlib.suppress(OSError):
            locked_names = re.findall(r"^ros-([a-z0-9-]+)==", (ROOT / lock).read_text(), re.MULTILINE)
            wheels |= {name.replace("-", "_") for name in locked_names}
    return tuple(sorted(key for key, match in matches.items() if key in wheels or (match and match[1] in python)))


def missing(scan: FolderScan) -> Iterator[Note]:
    """The libraries that only sources name, and that no part brings."""
    for library, (lacks, remedy) in LACKING.items():
        mention = scan.mentions.get(library)
        if mention and not mention.by_manifest and not (scan.pip and remedy == _PIP):
            yield f"{mention.place} names {mention.word}, and {lacks}", remedy


def addons(matrix: Matrix, scan: FolderScan, image: Image) -> tuple[list[str], list[Note]]:
    """The add-ons whose libraries sources name and the base image lacks, if a stack has them, as `containerize --addons` takes them.
    With a list for pip, none: it says what the packages get."""
    chosen, notes = [], []
    for addon, mention in () if scan.pip else _mentioned_addons(matrix, scan, image):
        stack, why = _addon_stack(matrix, image, addon, mention)
        text = f"{mention.place} names {mention.word}"
        if stack:
            chosen.append(addon if image.stack else f"{addon}-{stack}")
            addition = f"{text}: containerize adds the add-on {addon}"
            notes.append((addition, "a Dockerfile gets it by the lines in docs/addons.md"))
        else:
            notes.append((f"{text}, and {why}", _PIP))
    return chosen, notes


def _mentioned_addons(matrix: Matrix, scan: FolderScan, image: Image) -> Iterator[tuple[str, Mention]]:
    present = {name.rpartition("-")[0] for name in image.parts}
    for addon, facts in matrix.addons.items():
        titles = (matrix.part[name].title or "" for name in facts.parts)
        mention = next((scan.mentions[title] for title in titles if title in scan.mentions), None)
        if mention and not any(name.startswith(facts.parts[-1]) for name in present):
            yield addon, mention


def _addon_stack(matrix: Matrix, image: Image, addon: str, mention: Mention) -> tuple[str, str]:
    on_gpu = mention.word.lower().endswith("gpu")
    by_kind = sorted(matrix.stacks, key=lambda name: bool(matrix.stacks[name].cuda) != on_gpu)
    stacks = [image.stack] if image.stack else by_kind
    reasons = {
        stack: combinations.stack_reason(matrix, image.distribution, image.framework, stack, addon) for stack in stacks
    }
    stack = next((stack for stack, reason in reasons.items() if reason is None), "")
    return stack, next(filter(None, reasons.values()), "")
