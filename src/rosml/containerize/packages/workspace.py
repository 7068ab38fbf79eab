"""Writes an app's sources for the build: the manifests apart from other files, and the requests of the repository's files."""

from __future__ import annotations

import contextlib
import glob
import os
import re
import shutil
import stat
from collections.abc import Callable, Iterable, Iterator, Mapping
from pathlib import Path
from xml.etree import ElementTree

from rosml.base import files
from rosml.base.errors import RosmlError
from rosml.base.problems import near
from rosml.containerize import inputs, within
from rosml.containerize.ignored_files import IgnoredFiles
from rosml.containerize.inputs import Values
from rosml.containerize.sources.store import is_pointer
from rosml.containerize.within import SECRET

BLACKLIST = "blacklist"
"""The request that names packages to leave out."""

IDENTIFICATION = "identification"
"""The folder of the request to run a script before dependencies are read. The script has the path there that it has in the repository."""

HIDING = ("COLCON_IGNORE", "CATKIN_IGNORE", "AMENT_IGNORE")
"""Files that keep colcon from looking for packages in a folder."""

MANIFEST, PLAIN = "package.xml", "CMakeLists.txt"
"""The file of a ROS package, and that of a package for CMake alone."""

PIP = "requirements.txt"
"""The file in which Python packages name what pip is to install. `rosml init` writes the input for it."""

LARGEST_TEXT = 1 << 20  # bytes of a list or a script of a repository
MOST_UNKNOWN = 20  # names that are told one by one

_PROJECT = re.compile(r"""^[ \t]*project[ \t]*\([ \t]*"?([\w.+-]+)""", re.IGNORECASE | re.MULTILINE)
"""The name of the package in a CMakeLists.txt, as colcon reads it."""

_DISTRIBUTION = re.compile(r"\$(ROS_DISTRO\b|\{ROS_DISTRO\})")
"""The one variable in the names of packages for apt, as docker-ros' shell expands it."""

_READABLE = 0o444
"""The permissions that let everybody read a file."""


def manifests(root: Path, beyond: list[Path] | None = None, ignored: IgnoredFiles | None = None) -> Iterator[Path]:
    """The package.xml of packages below a folder, as colcon finds them, files that hide packages, and CMakeLists.txt elsewhere.

    A folder behind a link counts once, unless the link leads out of the root, or to a secret: `beyond` gets such links.
    """
    visited: set[str] = set()
    for folder, folders, names in os.walk(root, followlinks=True):
        real = os.path.realpath(folder)
        if real in visited:
            folders.clear()
            continue
        visited.add(real)
        links = [path for name in folders if (path := Path(folder, name)).is_symlink()]
        out = [path for path in links if not within.is_inside(path, root)]
        if beyond is not None:
            beyond += out
        folders[:] = sorted(name for name in folders if not name.startswith(".") and Path(folder, name) not in out)
        if ignored:
            folders[:] = [name for name in folders if not ignored.whole(Path(folder, name))]
            names = [name for name in names if not ignored(Path(folder, name))]
        markers = [name for name in (*HIDING, MANIFEST, PLAIN) if name in names][:1]
        yield from (Path(folder, name) for name in markers)
        if markers and markers != [PLAIN]:
            folders.clear()


def names(root: Path) -> Iterator[str]:
    """The names of the packages below a folder, without those whose manifests cannot be read."""
    for path in manifests(root):
        with contextlib.suppress(ElementTree.ParseError, LookupError, ValueError, OSError):
            if path.name == MANIFEST and (name := ElementTree.parse(path).findtext("name", "").strip()):
                yield name


def write_manifests(
    roots: Mapping[str, Path], out: Path, say: Callable[[str], object] = lambda text: None
) -> dict[str, int]:
    """Copies the manifests of folders, each below its name. Returns the number of packages in each."""
    shutil.rmtree(out, ignore_errors=True)
    out.mkdir(parents=True)
    count = dict.fromkeys(roots, 0)
    for name, root in roots.items():
        (out / name).mkdir()
        beyond: list[Path] = []
        for path in manifests(root, beyond, IgnoredFiles(root) if name == "target" else None):
            count[name] += _write_manifest(path, root, out / name / path.relative_to(root))
        for path in beyond:
            say(f"{path} leads to {os.readlink(path)}, out of {root}: packages there are not yours, and are not built")
    if not count["target"] + count.get("upstream", 0):
        raise none_in(roots["target"])
    return count


def _write_manifest(path: Path, root: Path, target: Path) -> bool:
    """Copies what colcon needs of a file: of a CMakeLists.txt, the package's name. Returns whether it is a package's manifest."""
    if path.name == PLAIN and not (within.is_inside(path, root) and path.is_file()):
        return False  # in a workspace, catkin's own file is a link to /opt/ros
    target.parent.mkdir(parents=True, exist_ok=True)
    if path.name in HIDING:
        target.touch()
        return False
    within.exists(path, root)
    try:
        if path.name == PLAIN:
            text = path.read_text(errors="replace")
            target.write_text("".join(f"project({name})\n" for name in _PROJECT.findall(text)[:1]))
        else:
            shutil.copyfile(path, target)
    except OSError as error:
        raise RosmlError(f"cannot read {path}: {error.strerror}", "check the file", exit_code=2) from None
    return path.name == MANIFEST


def none_in(folder: Path) -> RosmlError:
    """The error about a folder without a package that counts."""
    hides = any(path.name == MANIFEST for path in manifests(folder))
    return RosmlError(
        f"there is no package.xml in {folder}" + (", except what .dockerignore leaves out" if hides else ""),
        "call it in a folder with ROS packages, or name one"
        + ("; bring packages back with lines such as !src" if hides else ""),
        exit_code=2,
    )


def stage(folder: Path, out: Path, without: Path | None = None, ignored: IgnoredFiles | None = None) -> list[str]:
    """Makes the folder that the builder gets: links to the files of a repository, without secret and ignored ones. It is one level
    deeper than the context of the build, so that the builder does not read `.dockerignore` again. Returns the files that only their
    owner may read, as a checkout with umask 077 has them: in `out`, everybody may, since an image has many users."""
    private: list[str] = []
    shutil.rmtree(out, ignore_errors=True)
    out.mkdir(parents=True)
    out.chmod(0o755)
    for path, folders, names in os.walk(folder):
        place = out / os.path.relpath(path, folder)
        below = [Path(path, name) for name in folders if name not in SECRET]
        links = [source for source in below if source.is_symlink()]
        folders[:] = [it.name for it in below if it not in links and not (ignored and ignored.whole(it))]
        for name in folders:
            (place / name).mkdir()
            (place / name).chmod(0o755)
        for source in (*(Path(path, name) for name in names if name not in SECRET), *links):
            stays = source == without or (ignored and ignored(source))
            if not stays and _link(source, place / source.name, folder):
                private.append(os.path.relpath(source, folder))
    return private


def _link(source: Path, target: Path, root: Path) -> bool:
    """Links a file to another name, or copies it. Skips sockets and pipes. Returns whether not everybody may read it."""
    facts = source.lstat()
    if stat.S_ISLNK(facts.st_mode):
        leads = os.readlink(source)  # an absolute path would lead elsewhere in the build
        if os.path.isabs(leads) and within.is_inside(source, root):
            leads = os.path.relpath(os.path.realpath(source), os.path.realpath(source.parent))
        target.symlink_to(leads)
    elif stat.S_ISREG(facts.st_mode):
        if facts.st_mode & _READABLE != _READABLE:
            shutil.copy2(source, target)
            target.chmod(stat.S_IMODE(facts.st_mode) | _READABLE | (0o111 if facts.st_mode & stat.S_IXUSR else 0))
            return True
        try:
            os.link(source, target)
        except OSError:
            shutil.copy2(source, target)
    return False


def empty_submodules(folder: Path) -> list[str]:
    """The submodules of a repository that were not fetched: after a plain `git clone`, their folders are empty."""
    try:
        text = files.limited(folder / ".gitmodules", LARGEST_TEXT).decode(errors="replace")
    except OSError:
        return []
    values = (value.strip() for value in re.findall(r"^[ \t]*+path[ \t]*+=(.*)$", text, re.MULTILINE))
    paths = (value.removeprefix('"').removesuffix('"').strip() for value in values)
    return sorted(
        path for path in paths if path and '"' not in path and path.isprintable() and _is_empty(folder / path)
    )


def _is_empty(folder: Path) -> bool:
    """Whether a folder is empty, missing or unreadable."""
    try:
        with os.scandir(folder) as entries:
            return next(entries, None) is None
    except OSError:
        return True


def pointers(staged: Path) -> list[str]:
    """Files of Git LFS in the folder of `stage` that only point to the real ones, as after a `git clone` without git-lfs."""
    paths = [Path(path, name) for path, _, names in os.walk(staged) for name in names]
    attributes = (path for path in paths if path.name == ".gitattributes" and path.is_file())
    if not any(b"filter=lfs" in path.read_bytes() for path in attributes):
        return []
    return sorted(str(path.relative_to(staged)) for path in paths if is_pointer(path))


def stale(requests: Path, manifests: Path) -> Iterator[str]:
    """A sentence for each unknown name among the packages to leave out: a list may be older than the sources."""
    packages = {*names(manifests)}
    unknown = [*dict.fromkeys(name for name in (requests / BLACKLIST).read_text().split() if name not in packages)]
    for name in unknown[:MOST_UNKNOWN]:
        hint = near(name, sorted(packages))
        yield f"no package is called {name}, which is to be left out{f'; {hint}' if hint else ''}"
    if len(unknown) > MOST_UNKNOWN:
        yield f"{len(unknown) - MOST_UNKNOWN:,} more names are to be left out, and no package has them"


def unread_lists(requests: Path, staged: Path) -> list[str]:
    """The repository's lists for pip, if it reads none."""
    read = (requests / "pip").read_text()
    return [] if read else [str(path.relative_to(staged)) for path in _of_name(PIP, staged)]


def additional_files(name: str, folder: Path) -> list[Path]:
    """The repository's files and folders whose paths begin with a name, as `ADD name*` of a Dockerfile takes them."""
    pattern = f"{name.lstrip('/')}*"
    names = sorted(glob.glob(pattern, root_dir=folder, include_hidden=True)) if name else []
    if name and not names and name != inputs.default("additional-files-dir"):
        text = f"additional-files-dir: there is no {pattern} in {folder}"
        raise RosmlError(text, "check its name", exit_code=2)
    paths = [folder / item for item in names if Path(item).name not in SECRET]
    return [path for path in paths if within.exists(path, folder, folder=path.is_dir())]


def stage_additional(paths: Iterable[Path], out: Path, ignored: IgnoredFiles) -> None:
    """Makes the folder that the builder gets of additional files: files apart, since archives among them are unpacked."""
    shutil.rmtree(out, ignore_errors=True)
    for number, path in enumerate(path for path in paths if not ignored(path)):
        place = out / ("folders" if path.is_dir() else "files") / f"{number:04}"
        if path.is_dir():
            stage(path, place, ignored=ignored)
        else:
            place.mkdir(parents=True)
            _link(path.resolve(), place / path.name, path.parent)


def _require_named(name: str, value: str, folder: Path, kind: str = "file") -> None:
    """Checks that a file or folder exists if the user named it; a default may be missing."""
    if value != inputs.default(name) and not os.path.lexists(folder / value):
        raise RosmlError(f"{name}: there is no {kind} {value} in {folder}", "check its name", exit_code=2)


def write_requests(values: Values, folder: Path, upstream: Path, environment: Mapping[str, str], out: Path) -> None:
    """Writes additional packages and packages to leave out, each into a file, and scripts, each into a folder."""
    shutil.rmtree(out, ignore_errors=True)
    out.mkdir(parents=True)

    def texts(name: str, recursive: str = "") -> list[str]:
        path = values.text(name)
        every = bool(recursive) and values.text(recursive) == "true"
        if path and not every:
            _require_named(name, path, folder)
        return texts_of(folder, path, (folder, upstream) if every else ()) if path else []

    distribution = values.ros_distro or environment.get("ROS_DISTRO", "")
    lines = lines_of("".join(texts("additional-debs-file", "enable-recursive-additional-debs")))
    debs = [_DISTRIBUTION.sub(distribution, word) for line in lines for word in line.split()]
    if values.rmw_implementation and environment.get("ROS_VERSION") != "1":
        debs.append(f"ros-{distribution}-{values.rmw_implementation.replace('_', '-')}")
    for name in debs:
        if not re.fullmatch(r"[a-z0-9][a-z0-9.+-]*(:[a-z0-9-]+)?(=\S+)?", name):
            problem = f"{values.additional_debs_file}: {name!r} is no package of apt"
            raise RosmlError(problem, "write one a line: name or name=version", exit_code=2)
    blacklist = lines_of("".join(texts("blacklisted-packages-file", "enable-recursive-blacklisted-packages")))
    identification = os.path.normpath(values.before_dependency_identification_script)
    requests = {
        "apt": "".join(f"{line}\n" for line in debs),
        "pip": "".join(texts("additional-pip-file", "enable-recursive-additional-pip")),
        BLACKLIST: "".join(f"{line}\n" for line in blacklist),
        **{f"{IDENTIFICATION}/{identification}": text for text in texts("before-dependency-identification-script")},
    }
    for kind in ("before", "after"):
        name = f"{kind}-dependency-installation-script"
        requests |= {f"{kind}/{number:04}": text for number, text in enumerate(texts(name, f"enable-recursive-{name}"))}
    (out / IDENTIFICATION).mkdir()
    for name, content in requests.items():
        (out / name).parent.mkdir(parents=True, exist_ok=True)
        (out / name).write_text(content)


def texts_of(folder: Path, name: str, roots: tuple[Path, ...] = ()) -> list[str]:
    """The text of a file of the repository, or with roots those of all files of its name below them, without those of git. None is empty."""
    paths = [(path, root) for root in roots for path in _of_name(os.path.basename(name), root)]
    texts = [_text(path, root) for path, root in (paths if roots else [(folder / name, folder)])]
    return [text if text.endswith("\n") else f"{text}\n" for text in texts if text]


def _text(path: Path, root: Path) -> str:
    try:
        return (within.read(path, root, LARGEST_TEXT) or b"").decode().replace("\r\n", "\n")
    except UnicodeDecodeError:
        raise RosmlError(f"{path}: not UTF-8", "save the file as UTF-8", exit_code=2) from None


def _of_name(name: str, root: Path) -> list[Path]:
    paths = []
    for path, folders, names in os.walk(root):
        folders[:] = [below for below in folders if below != ".git"]
        if name in folders or name in names:
            paths.append(Path(path, name))
    return sorted(paths)


def lines_of(text: str) -> list[str]:
    """The lines of a list, without comments and empty ones."""
    stripped = ((re.sub(r"(^|\s)#.*", "", line) if "#" in line else line).strip() for line in text.split("\n"))
    return [line for line in stripped if line]
