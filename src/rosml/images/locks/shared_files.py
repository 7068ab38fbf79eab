"""Whether a part for every Python has the files that the parts on top of it expect.

TensorFlow's C++ library is in the wheel for each Python. The part `tensorflow-cc` takes it from one of these wheels, and the part
`tensorflow` of each Python links to it instead of its own files. So all wheels of the release must have the same files there. A test in
the image compares them (`components/part/records.py link`), for one Python. This module compares the wheels for all Pythons and
architectures before anything is built, by their lists of files (RECORD).
"""

from __future__ import annotations

import fnmatch
from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

from rosml.base.problems import some
from rosml.base.side_by_side import side_by_side
from rosml.images.image_set.lock_file import versions
from rosml.images.image_set.model import ImageSet, Part
from rosml.images.locks.index import Index, WheelTarget
from rosml.images.locks.uv import WORKERS
from rosml.images.matrix import combinations, names
from rosml.images.matrix.model import ANY_PYTHON


@dataclass(frozen=True)
class Difference:
    """Files of a part for every Python that the wheels for another Python have otherwise."""

    part: str  # its entry in the matrix, such as `tensorflow-cc`
    stack: str
    architecture: str
    package: str  # with its version, such as `tensorflow-cpu==2.21.0`
    built_from: str  # the Python whose wheel the part is taken from
    python: str  # that whose wheel differs
    files: tuple[str, ...]

    def __str__(self) -> str:
        return (
            f"part {self.part}, stack {self.stack}, {self.architecture}: {self.package} has other files for Python {self.python} than for"
            f" Python {self.built_from}, from which the part is built: {some(self.files)}"
        )


def differences(
    image_set: ImageSet, root: Path, index: Index, texts: Mapping[str, str], stacks: Collection[str] = ()
) -> list[Difference]:
    """Compares the wheels of every part for every Python, by less than 1 MB of each. `root` has the files that say what parts take."""

    def compare(lock: tuple[Part, str]) -> list[Difference]:
        part, architecture = lock
        pins = versions(texts.get(names.lock_path(part.stack, architecture, ANY_PYTHON, part.kind), ""))
        return list(_of_lock(image_set, root, index, part, architecture, pins)) if pins else []

    shared = [
        part for part in image_set.parts_of_stacks if part.python == ANY_PYTHON and (not stacks or part.stack in stacks)
    ]
    locks = [(part, architecture) for part in shared for architecture in part.architectures]
    return [difference for lock in side_by_side(compare, locks, WORKERS) for difference in lock]


def _of_lock(
    image_set: ImageSet, root: Path, index: Index, part: Part, architecture: str, pins: Mapping[str, str]
) -> Iterator[Difference]:
    matrix = image_set.matrix
    built_from = matrix.operating_systems[part.os].python
    others = _pythons(image_set, part, architecture) - {built_from}
    if not others:
        return
    platform = combinations.wheels(matrix, architecture, combinations.releases_of(matrix, part.stack, part.kind))
    index_address = combinations.index(matrix, part.stack, part.kind)
    wheels = {
        python: index.wheels(WheelTarget(python, platform), pins, index_address) for python in {built_from, *others}
    }
    files = _Files(root / "components" / part.kind)
    for name, version in pins.items():
        wheel = wheels[built_from][name]
        for python in sorted(others, key=lambda python: int(python.split(".")[1])):
            if wheels[python][name] == wheel:  # a wheel for every Python
                continue
            expected, present = files.of(index.record(wheel)), files.of(index.record(wheels[python][name]))
            if paths := {path for path, _ in expected.items() ^ present.items()}:
                package = f"{name}=={version}"
                yield Difference(part.kind, part.stack, architecture, package, built_from, python, tuple(sorted(paths)))


def _pythons(image_set: ImageSet, part: Part, architecture: str) -> set[str]:
    """The Pythons of the parts that stand on a part."""
    matrix = image_set.matrix
    return {
        other.python
        for other in image_set.parts_of_stacks
        if other.stack == part.stack
        and other.python != ANY_PYTHON
        and architecture in other.architectures
        and part.kind in matrix.part[other.kind].needs
    }


class _Files:
    """The files of wheels that a part has, by its keep.txt and prune.txt as `components/part/records.py` reads them, and differs.txt."""

    def __init__(self, folder: Path) -> None:
        self._keep = _patterns(folder / "keep.txt")
        self._leave_out = [*_patterns(folder / "prune.txt"), *_patterns(folder / "differs.txt"), "*.dist-info/*"]

    def of(self, record: Mapping[str, str]) -> dict[str, str]:
        """The entries of a RECORD that the part has: hashes by path."""
        return {
            path: digest
            for path, digest in record.items()
            if (not self._keep or _matches(path, self._keep)) and not _matches(path, self._leave_out)
        }


def _patterns(file: Path) -> list[str]:
    lines = file.read_text(encoding="utf-8").splitlines() if file.exists() else []
    return [line.strip() for line in lines if line.strip() and not line.startswith("#")]


def _matches(path: str, patterns: list[str]) -> bool:
    return any(fnmatch.fnmatchcase(path, pattern) for pattern in patterns)
