"""The inputs that decide the content of an image or part, and their digest: the same inputs give the same digest anywhere.

Nobody lists them by hand. Targets and their contexts come from the bake file (`targets`), stages and their files from the
Dockerfile (`dockerfile`), so an input that is added there counts at once. Values that the caller decides (registry, proxies, the
commit of a label) are no inputs, and are declared so (`targets.NoInput`). Any other value is an error.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Collection, Iterable, Mapping
from functools import cached_property
from pathlib import Path
from string import Template

from rosml.base import files
from rosml.base.errors import RosmlError
from rosml.base.problems import listed
from rosml.images.bake import dockerfile, structure, targets
from rosml.images.bake.structure import StructureTests
from rosml.images.bake.targets import Dependency, Join, Locks, NoInput, Overridable, Value
from rosml.images.image_set.model import Image, ImageSet, Part

TARGET = "target "
"""The beginning of inputs whose value is the digest of another target: `target ros1-bookworm-core`."""

UNPINNED = "not pinned"
"""The value of a base image without a digest, and of a context from no target."""

MISSING = "missing"


class Inputs:
    """The inputs of all targets of an image set. `root` is the folder of the Dockerfile. Each file is read once."""

    def __init__(self, root: Path, image_set: ImageSet) -> None:
        self.root = root
        self.image_set = image_set
        self.targets = targets.of(image_set)
        file = root / "Dockerfile"
        self._ignored = _rules(root / ".dockerignore")
        self._stages = dockerfile.parse(files.text(file) if file.is_file() else "")
        self._files: dict[str, dict[str, str]] = {}
        self._inputs: dict[tuple[str, str], dict[str, str]] = {}
        self._digests: dict[tuple[str, str], str] = {}

    def of(self, target: str, architecture: str) -> dict[str, str]:
        """The inputs of a bake target, by readable names. `target x` stands for the inputs of the target x."""
        key = (target, architecture)
        if key not in self._inputs:
            bake_target = self.targets[target]
            arguments = _facts(bake_target.arguments, f"{target}, argument")
            inputs = {"platform": self.image_set.matrix.architectures[architecture].platform}
            contexts = self._contexts(target, architecture)
            if bake_target.join:
                form = Join(bake_target.join.parts, dict.fromkeys(bake_target.join.environment, ""))
                inputs["Dockerfile of the join"] = hashlib.sha256(form.dockerfile().encode()).hexdigest()
                inputs |= {f"environment {name}": value for name, value in bake_target.join.environment.items()}
                inputs |= {name: value for context in contexts.values() for name, value in context.items()}
            else:
                if bake_target.stage not in self._stages:
                    text = f"the Dockerfile has no stage {bake_target.stage}, from which {target} is built"
                    raise RosmlError(text, "write it there as 'FROM … AS name' on one line")
                inputs |= {
                    "Dockerfile: before the first stage": self._stages[""].digest,
                    ".dockerignore": self._ignored,
                }
                inputs |= self._stage(bake_target.stage, contexts, arguments, architecture)
            inputs |= {f"argument {name}": value for name, value in arguments.items()}
            inputs |= {f"label {name}": value for name, value in _facts(bake_target.labels, f"{target}, label").items()}
            if "TESTS" in arguments:
                inputs = self._of_files(inputs, arguments["TESTS"].split())
            self._inputs[key] = inputs
        return self._inputs[key]

    def of_tests(self, image: Image, architecture: str, names: tuple[str, ...]) -> dict[str, str]:
        inputs = self.of(image.test_target, architecture)
        if names == image.tests:
            return inputs
        all_files = self._source(structure.FOLDER)
        return self._of_files({**inputs, **all_files, "argument TESTS": " ".join(names)}, names)

    def _of_files(self, inputs: Mapping[str, str], names: Collection[str]) -> dict[str, str]:
        """Inputs with only the files of structure tests that belong to these names. The builder gets all files."""
        inside = f"{structure.FOLDER}/"
        used = self._structure.of(names)
        return {
            name: value
            for name, value in inputs.items()
            if not name.startswith(inside) or name.removeprefix(inside) in used
        }

    @cached_property
    def _structure(self) -> StructureTests:
        folder = self.root / structure.FOLDER
        paths = [self.root / name for name, value in self._source(structure.FOLDER).items() if value != MISSING]
        return StructureTests({path.relative_to(folder).as_posix(): _text(path) for path in paths})

    def check(self, things: Iterable[Image | Part] | None = None) -> None:
        """Checks that images and parts, all if None, can be built and tested once their locks exist."""
        checked = [*(things if things is not None else (*self.image_set.parts, *self.image_set.images))]
        if gone := self._gone(checked):
            text = f"{listed(gone)}: not there, and the Dockerfile builds parts or images from it"
            raise RosmlError(
                text, "restore it with git checkout, or write it; a new part has a file there, such as prune.txt"
            )
        folder = self.root / structure.FOLDER
        tests = dict.fromkeys(
            name for image in checked if isinstance(image, Image) for name in (*image.tests, *image.shared)
        )
        if untested := [
            f"{name}.yaml" for name in tests if folder.is_dir() and not (folder / f"{name}.yaml").is_file()
        ]:
            raise RosmlError(
                f"{structure.FOLDER} has no {listed(untested)}", "write what must hold in these images there"
            )

    def _gone(self, things: Iterable[Image | Part]) -> list[str]:
        """Missing files and folders from which targets are built, without locks, which are made later, and patterns."""
        for item in things:
            self.digests(item)  # this also reads the targets below it
        gone = {name for inputs in self._inputs.values() for name, value in inputs.items() if value == MISSING}
        return sorted(name for name in gone - self.image_set.locks if not set("*?[").intersection(name))

    def digest(self, target: str, architecture: str) -> str:
        key = (target, architecture)
        if key not in self._digests:
            self._digests[key] = _digest(self.of(target, architecture))
        return self._digests[key]

    def digests(self, item: Image | Part) -> dict[str, str]:
        """The digests of an image or part, by architecture."""
        return {architecture: self.digest(item.target, architecture) for architecture in item.architectures}

    def together(self, item: Image | Part) -> str:
        """The common digest of an image or part for all its architectures."""
        return _digest(self.digests(item))

    def _contexts(self, target: str, architecture: str) -> dict[str, dict[str, str]]:
        """The inputs behind each of a target's named contexts: another target, or a base image."""
        contexts: dict[str, dict[str, str]] = {}
        for name, value in self.targets[target].contexts.items():
            if isinstance(value, Dependency):
                contexts[name] = {TARGET + value.target: self.digest(value.target, architecture)}
            elif isinstance(value, Locks):
                contexts[name] = self._source(f"{value.folder}/{architecture}.txt")
            else:
                contexts[name] = _base_image(_fact(value, f"{target}, context {name}").removeprefix("docker-image://"))
        return contexts

    def _stage(
        self, name: str, contexts: Mapping[str, Mapping[str, str]], arguments: Mapping[str, str], architecture: str
    ) -> dict[str, str]:
        """The inputs of a stage, including those of its base."""
        stage = self._stages.get(name)
        if stage is None:
            return {} if name == "scratch" else _base_image(name)
        values = {**self._stages[""].defaults, **stage.defaults, **arguments, "TARGETARCH": architecture}
        inputs: dict[str, str] = {}
        for used in (_filled(used, values) for used in stage.stages):
            if used in contexts:
                inputs |= contexts[used]
            else:
                inputs |= self._stage(used, contexts, arguments, architecture)
        inputs[f"Dockerfile: stage {name}"] = stage.digest
        for source in stage.sources:
            inputs |= self._source(_filled(source, values))
        return inputs

    def _source(self, source: str) -> dict[str, str]:
        """Digests of a file, of all files in a folder, or of all matches of a pattern."""
        if source not in self._files:
            pattern = source.strip("/").removeprefix("./")
            if pattern in ("", "."):
                raise RosmlError("the Dockerfile takes the whole checkout", remedy="name what it uses")
            matches = sorted(self.root.glob(pattern))
            paths = [file for path in matches for file in (sorted(path.rglob("*")) if path.is_dir() else [path])]
            # Python's caches differ between checkouts; .dockerignore keeps them from the build.
            files = [
                path for path in paths if (path.is_file() or path.is_symlink()) and "__pycache__" not in path.parts
            ]
            digests = {path.relative_to(self.root).as_posix(): _file(path) for path in files}
            self._files[source] = digests or {pattern: MISSING}
        return self._files[source]


def _facts(values: Mapping[str, Value], where: str) -> dict[str, str]:
    """The arguments or labels that the image set decides."""
    return {name: fact for name, value in values.items() if (fact := _fact(value, f"{where} {name}"))}


def _fact(value: Value, where: str) -> str:
    """The fact that decides a value; empty if it is no input. An undeclared value would change an image without a new digest."""
    if isinstance(value, str):
        return value
    if isinstance(value, Overridable):
        return value.fact
    if isinstance(value, NoInput):
        return ""
    text = f"{where} is {value!r}, and nothing says which fact of matrix.yaml decides it"
    raise RosmlError(
        text, "declare in src/rosml/images/bake/targets.py what it is: Overridable with its fact, or NoInput"
    )


def _base_image(reference: str) -> dict[str, str]:
    name, _, digest = reference.partition("@")
    return {f"base image {name}": digest or UNPINNED}


def _filled(text: str, values: Mapping[str, str]) -> str:
    """A text of the Dockerfile with values for its arguments."""
    if "$" not in text:
        return text
    try:
        return Template(text).substitute(values)
    except (KeyError, ValueError):
        raise RosmlError(f"Dockerfile: {text}: no target says what to fill in", remedy="give it a value") from None


def _rules(file: Path) -> str:
    """A digest of a .dockerignore's rules, which decide what the builder gets."""
    text = file.read_text(encoding="utf-8", errors="replace") if file.is_file() else ""
    rules = [line.strip() for line in text.splitlines() if line.strip() and not line.strip().startswith("#")]
    return hashlib.sha256("\n".join(rules).encode()).hexdigest()


def _file(path: Path) -> str:
    if path.is_symlink():  # the builder gets links unchanged
        return f"link to {path.readlink()}"
    digest = hashlib.sha256(path.read_bytes()).hexdigest()
    return f"{digest} executable" if path.stat().st_mode & 0o100 else digest


def _text(path: Path) -> str:
    """The content of a file; of a link also its target."""
    link = f"{path.readlink()}\n" if path.is_symlink() else ""
    return link + (path.read_text(encoding="utf-8", errors="replace") if path.is_file() else "")


def _digest(content: Mapping[str, str]) -> str:
    return hashlib.sha256(json.dumps(content, sort_keys=True, separators=(",", ":")).encode()).hexdigest()
