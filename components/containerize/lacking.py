"""What an install space lacks in an image: libraries, modules and programs that its files name. Files are read; none of them runs.

What the build had and the image does not is *lost*: somebody forgot to install it, or to name a package as `exec_depend`. What the
build lacked, too, is *absent*, and no error: a driver may bring it, or nobody uses it.
"""

from __future__ import annotations

import ast
import copy
import itertools
import os
import re
import sys
import warnings
import xml.etree.ElementTree as ElementTree
from pathlib import Path
from typing import Iterable, Iterator, Sequence

from elf import elf

INSTALL = "docker-ros/ws/install"
WORK = re.compile(r"docker-ros/ws/(src|build)/")
"""Where packages are built and tested: no image to run has it."""

DRIVER = re.compile(
    r"lib(cuda|nvcuvid|nvidia-[a-z0-9-]+|nvoptix|cudadebugger|GLX_nvidia|EGL_nvidia|dxcore)\.so(\.[0-9.]+)?"
)
"""Libraries that a driver brings when a container starts."""

LIBRARY = re.compile(r".+\.so(\.[^/]+)?")
MODULES = re.compile(
    r".*/(site|dist)-packages|.*/lib/python3(\.\d+)?(/lib-dynload)?|usr/lib/python3(\.\d+)?(/lib-dynload)?"
)
"""Folders that Python looks into."""

LAUNCH = (".launch", ".launch.xml", ".launch.py", ".launch.yaml", "_launch.xml", "_launch.py", "_launch.yaml")

READ = {"include": ["file"], "rosparam": ["file"], "param": ["textfile", "binfile", "command", "from"]}
"""What launch files read, by element and attribute."""

DISTRIBUTION = re.compile(r"([A-Za-z0-9._]+)(-.*)?\.(dist|egg)-info")
"""Where a package of pip, or one of Debian's Python, says what it is."""

FOUND = re.compile(r"\$\(find(?:-pkg-share)?\s+([\w.-]+)\s*\)/([\w./+-]+)(?![\w./+$-])")
"""A path in a package."""

COMMANDS = ("bin", "sbin")
"""Names of folders with programs."""

POINTER = b"version https://git-lfs.github.com/spec/v1\n"
"""How a file begins that Git LFS has not fetched."""

STANDARD = {*sys.builtin_module_names, *getattr(sys, "stdlib_module_names", ())}
"""Modules that Python itself has, as far as it says; before 3.10, they count as those of the image."""

LINE, SIZE = 4096, 4 << 20
"""The most bytes of a line and of a text that are read."""

SOURCE, STATEMENTS = 256 << 10, 20_000
"""The most bytes, and lines, of a file of Python that is parsed: a megabyte of short lines takes a gigabyte."""

MOST = 10_000
"""The most files that a launch file may read."""

NAME = 250
"""The most bytes of a module's name: no file has a longer one."""


class Files:
    """Files by name, with their places."""

    def __init__(self) -> None:
        self.libraries: dict[str, str] = {}
        self.programs: dict[str, list[str]] = {}  # in the workspace
        self.commands: dict[str, str] = {}  # in folders for programs
        self.launches: dict[str, list[str]] = {}  # launch files
        self.modules: dict[str, set[Path]] = {}  # of Python, with the folders that have them
        self.distributions: set[str] = set()  # names of packages of Python, as indexes compare them
        self.sources: set[str] = set()  # of Python in the workspace: paths without their endings
        self.manifests: dict[str, str] = {}  # names of packages, by their folders of sources

    def add(self, root: Path, below: str = "") -> Files:
        """Adds what a folder of a root has."""
        for above, folders, names in os.walk(root / below):
            place = os.path.relpath(above, root)
            if MODULES.fullmatch(place):
                for name in folders + names:
                    self.modules.setdefault(name.partition(".")[0], set()).add(Path(above))
                    match = DISTRIBUTION.fullmatch(name)
                    if match:
                        self.distributions.add(normal(match.group(1)))
            for name in names:
                path, where = os.path.join(above, name), os.path.normpath(os.path.join(place, name))
                if LIBRARY.fullmatch(name) and _leads_somewhere(path):
                    self.libraries.setdefault(name, where)
                if os.path.basename(place) in COMMANDS:
                    self.commands.setdefault(name, where)
                if not where.startswith("docker-ros/"):
                    continue
                if name.endswith(".py"):
                    self.sources.add(place if name == "__init__.py" else where[:-3])
                if name.endswith(LAUNCH):  # also one that Windows made a program
                    self.launches.setdefault(name, []).append(where)
                elif os.access(path, os.X_OK):
                    self.programs.setdefault(name, []).append(where)
                if name == "package.xml" and WORK.match(where):
                    self.manifests[place] = _package(Path(path))
        return self

    def owner(self, place: str) -> str:
        """The package of a file in the sources or the build."""
        parts = place.split("/")
        if parts[2] == "build":
            return parts[3]
        above = ("/".join(parts[:number]) for number in range(len(parts) - 1, 2, -1))
        return next((self.manifests[folder] for folder in above if folder in self.manifests), "")

    def has_module(self, name: str, beside: Path) -> bool:
        """Whether Python finds a module: in its folders, or beside the script that asks. Packages outside of the install space may make
        modules as they like, so only their first name counts."""
        is_odd = "" in name.split(".") or "/" in name  # an entry point may say anything
        if is_odd or len(name.encode("utf-8", "replace")) > NAME:
            return False
        first, _, rest = name.partition(".")
        folders = {*self.modules.get(first, ())}
        if _is_module(beside / first):
            folders.add(beside)
        if not rest or not all(INSTALL in str(folder) for folder in folders):
            return bool(folders)
        return any(_is_module(folder / name.replace(".", "/")) for folder in folders)

    def has_source(self, name: str) -> bool:
        """Whether a module is in the working folder."""
        ending = f"/{name.replace('.', '/')}"
        return any(source.endswith(ending) for source in self.sources)


def _leads_somewhere(path: str) -> bool:
    """Whether a file is no link to nothing. An absolute link cannot be followed here, and counts."""
    return not os.path.islink(path) or os.path.isabs(os.readlink(path)) or os.path.exists(path)


def _is_module(path: Path) -> bool:
    try:
        return path.is_dir() or any(path.parent.glob(f"{path.name}.*"))
    except (OSError, ValueError):  # no file can have such a name, or glob takes it for a pattern
        return False


class Lacking:
    """What is lost and what is absent, each in a sentence.

    Args:
        runtime: the image without the app.
        workspace: a root that has only the workspace with the install space.
        around: other roots of the build.
    """

    def __init__(self, runtime: Path, workspace: Path, around: Sequence[Path], packages: Iterable[str]) -> None:
        self._root, self._install, self._packages = workspace, workspace / INSTALL, {*packages}
        self._runtime, self._roots = runtime, (workspace, *around)
        self._of_image = Files().add(runtime)
        self._image = copy.deepcopy(self._of_image).add(workspace, INSTALL)
        self._before = Files()
        for root in self._roots:
            self._before.add(root)
        shells = (elf(runtime / name) for name in ("usr/bin/dash", "bin/dash", "usr/bin/bash", "bin/bash"))
        self._machine = next((shell.machine for shell in shells if shell), None)
        self._seen: set[Path] = set()
        self.lost: set[str] = set()
        self.absent: set[str] = set()
        for above, folders, names in os.walk(self._install):
            for name in sorted(folders + names):
                path = Path(above, name)
                if path.is_symlink():
                    self._link(path)
                elif path.is_file():
                    self._file(path)

    def _shown(self, path: Path) -> str:
        return str(path.relative_to(self._install))

    def _say(self, path: Path, what: str, before: str) -> None:
        """`before`: where it was when the packages were built; empty if nowhere."""
        if before:
            self.lost.add(f"{self._shown(path)} needs {what}, which is in no image: {before}")
        else:
            self.absent.add(f"{self._shown(path)} needs {what}")

    def _link(self, path: Path) -> None:
        target = os.path.normpath(os.path.join("/", os.path.relpath(path.parent, self._root), os.readlink(path)))
        if WORK.match(target[1:]):
            self.lost.add(f"{self._shown(path)} is a link to {target}, which is in no image")

    def _file(self, path: Path) -> None:
        binary = elf(path)
        if binary:
            if self._machine in (None, binary.machine):  # otherwise it is for another processor
                for name in binary.needed:
                    if os.path.basename(name) not in self._image.libraries and not DRIVER.fullmatch(name):
                        self._say(path, name, self._before.libraries.get(os.path.basename(name), ""))
        elif os.access(path, os.X_OK) and re.match(rb"#![^\n]*\r\n", _bytes(path, LINE)):
            what = "cannot start: its lines end with CR LF, as on Windows; dos2unix corrects them"
            self.lost.add(f"{self._shown(path)} {what}")
        elif _bytes(path, len(POINTER)) == POINTER:
            what = "is a pointer of Git LFS in the place of the file: git lfs pull fetches it"
            self.lost.add(f"{self._shown(path)} {what}")
        elif path.name == "entry_points.txt" and path.parent.suffix in (".egg-info", ".dist-info"):
            self._entry_points(path)
        elif path.name.endswith(LAUNCH):
            for package, program in _launched(path):
                self._launch(path, package, program)
            for package, file in sorted({*itertools.islice(_read(path), MOST)}):
                self._data(path, package, file)
        elif path.parent.parent.name == "lib" and path.parent.name in self._packages:
            self._interpreter(path)
            if _is_python(path):
                self._imports(path, path.parent)

    def _interpreter(self, path: Path) -> None:
        """Looks for the program that starts a script. `env` looks for it in PATH, which may have any folder of programs."""
        line = _text(path, LINE).partition("\n")[0]
        words = line[2:].split()
        if not line.startswith("#!") or not words or not os.access(path, os.X_OK):
            return
        program = words[0]
        if os.path.basename(program) == "env":
            program = next((word for word in words[1:] if not word.startswith("-") and "=" not in word), "")
            exists, before = program in self._image.commands, self._before.commands.get(program, "")
        else:
            place = program.lstrip("/")
            exists = os.path.lexists((self._root if place.startswith(INSTALL) else self._runtime) / place)
            before = place if any(os.path.lexists(root / place) for root in self._roots) else ""
        if program and not exists:
            self._say(path, f"{program} to start", before)

    def _launch(self, path: Path, package: str, program: str) -> None:
        if package not in self._packages or not program or "$" in program:
            return
        name = os.path.basename(program)
        if not _is_of(self._image.programs.get(name, []), package):
            before = self._before_of(self._before.programs.get(name, []), package)
            self._say(path, f"the program {program} of {package}", before)

    def _data(self, path: Path, package: str, file: str) -> None:
        if package not in self._packages:
            return
        folders = [self._install / below / kind / package for below in ("", package) for kind in ("share", "lib")]
        if not any(os.path.exists(folder / name) for folder in folders for name in (file, os.path.basename(file))):
            folders_of_package = [folder for folder, name in self._before.manifests.items() if name == package]
            before = [f"{folder}/{file}" for folder in folders_of_package if os.path.exists(self._root / folder / file)]
            self._say(path, f"{file} of {package}", min(before, default=""))

    def _before_of(self, places: Iterable[str], package: str) -> str:
        """Where the sources or the build of a package have a file; empty if they do not."""
        return min((x for x in places if WORK.match(x) and self._before.owner(x) == package), default="")

    def imported(self, layer: Path) -> dict[str, str]:
        """Modules of the image, and not of the app's layer, that files of the install space import in any case: each with the first."""
        of_app, of_image = Files().add(layer).modules, self._of_image.modules
        imports: dict[str, str] = {}
        for path in sorted(self._install.rglob("*")):
            if path.is_symlink() or not path.is_file() or not _is_python(path):
                continue
            for level, whole_name in _imports(path):
                name = whole_name.partition(".")[0]
                if not level and name in of_image and name not in of_app and name not in STANDARD:
                    imports.setdefault(name, self._shown(path))
        return imports

    def distributions(self, layer: Path) -> set[str]:
        """Names of packages of Python that the image has, and the app's layer does not."""
        return self._of_image.distributions - Files().add(layer).distributions

    def forgotten(self) -> dict[str, str]:
        """Launch files and programs that no image has: `PACKAGE NAME`, with their places in the sources or the build."""
        places_by_name = {}
        pairs = [(self._before.launches, self._image.launches), (self._before.programs, self._image.programs)]
        for before, image in pairs:
            for name, places in before.items():
                for package in {self._before.owner(place) for place in places if WORK.match(place)} & self._packages:
                    if not _is_of(image.get(name, []), package):
                        places_by_name[f"{package} {name}"] = self._before_of(places, package)
        return places_by_name

    def _entry_points(self, path: Path) -> None:
        group = ""
        for line in _text(path).split("\n"):
            if line.startswith("["):
                group = line.strip("[] \t")
            name, _, module = (part.strip() for part in line.partition("="))
            if group in ("console_scripts", "gui_scripts") and module:
                self._import(path, module.partition(":")[0].partition("[")[0].strip(), path.parent.parent, name)

    def _imports(self, path: Path, beside: Path) -> None:
        """Looks for what a script, or a module that it imports, imports in any case."""
        if path in self._seen:
            return
        self._seen.add(path)
        parts = path.relative_to(self._install).parts
        start = next((number for number, part in enumerate(parts) if part in ("site-packages", "dist-packages")), None)
        for level, name in _imports(path):
            above = parts[start + 1 : len(parts) - level] if level and start is not None else ()
            if above or not level:
                self._import(path, ".".join([*above, name]).strip("."), beside)

    def _import(self, path: Path, name: str, beside: Path, entry: str = "") -> None:
        first = name.partition(".")[0]
        if first in sys.builtin_module_names:
            return
        if not self._image.has_module(name, beside):
            before = "its sources have it" if self._before.has_source(name) else ""
            if not before and first in self._before.modules and first not in self._image.modules:
                places = [(place, root) for place in self._before.modules[first] for root in self._roots]
                before = min(str(place.relative_to(root)) for place, root in places if root in place.parents)
            what = f"the module {name}" + (f" for {entry}" if entry else "")
            self._say(path, what, before or ("nor is it in its sources" if entry else ""))
            return
        folders = [folder for folder in self._image.modules.get(first, ()) if INSTALL in str(folder)]
        for folder in [*folders, beside]:
            for number in range(1, name.count(".") + 2):
                place = folder / "/".join(name.split(".")[:number])
                for file in (place / "__init__.py", place.with_name(f"{place.name}.py")):
                    if file.is_file():
                        self._imports(file, beside)


def normal(name: str) -> str:
    """The name of a package of Python as indexes compare names."""
    return re.sub(r"[-_.]+", "-", name).lower()


def _is_of(places: Iterable[str], package: str) -> bool:
    """Whether one of these files is where ROS looks for a package's."""
    return any(way in place for place in places for way in (f"/lib/{package}/", f"/share/{package}/"))


def _package(manifest: Path) -> str:
    """The name in a manifest; empty if it is none."""
    try:
        return (ElementTree.fromstring(_text(manifest)).findtext("name") or "").strip()
    except (ElementTree.ParseError, ValueError, OSError):
        return ""


def _launched(path: Path) -> Iterator[tuple[str, str]]:
    """The nodes of a launch file: packages and programs, as they are written."""
    if path.suffix != ".py":
        try:
            nodes = [*ElementTree.fromstring(_text(path)).iter("node")]
        except (ElementTree.ParseError, ValueError):
            return
        for node in nodes:
            yield node.get("pkg", ""), node.get("type", "") or node.get("exec", "")
        return
    for call in (node for line in _body(path) for node in ast.walk(line) if isinstance(node, ast.Call)):
        arguments = {word.arg: word.value.value for word in call.keywords if isinstance(word.value, ast.Constant)}
        package, program = arguments.get("package"), arguments.get("executable")
        if isinstance(package, str) and isinstance(program, str):
            yield package, program


def _read(path: Path) -> Iterator[tuple[str, str]]:
    """Files that a launch file in XML reads in any case: packages, and paths in them."""
    if path.suffix not in (".launch", ".xml"):
        return
    try:
        todo = [ElementTree.fromstring(_text(path))]
    except (ElementTree.ParseError, ValueError):
        return
    while todo:
        element = todo.pop()
        if not {"if", "unless"} & {*element.keys()}:
            todo += element
            for name in READ.get(element.tag, ()):
                yield from FOUND.findall(element.get(name, ""))


def _body(path: Path) -> list[ast.stmt]:
    """The statements of a file of Python that are in no other one; none if it cannot be read, or is too long."""
    text = _text(path, SOURCE + 1)
    if len(text) > SOURCE or text.count("\n") + text.count(";") > STATEMENTS:
        return []
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            return ast.parse(text).body
    except (SyntaxError, ValueError, RecursionError, MemoryError):
        return []


def _imports(path: Path) -> Iterator[tuple[int, str]]:
    """The modules that a file imports in any case: how many points stand before their names, and these."""
    for line in _body(path):
        if isinstance(line, ast.Import):
            yield from ((0, item.name) for item in line.names)
        elif isinstance(line, ast.ImportFrom):
            yield line.level, line.module or ""


def _is_python(path: Path) -> bool:
    return path.suffix == ".py" or re.match(r"#!.*\bpython3?\b", _text(path, LINE).partition("\n")[0]) is not None


def _text(path: Path, size: int = SIZE) -> str:
    return _bytes(path, size).decode("utf-8", "replace")


def _bytes(path: Path, size: int) -> bytes:
    with open(path, "rb") as file:
        return file.read(size)
