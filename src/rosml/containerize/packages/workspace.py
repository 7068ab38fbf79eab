"""Writes an app's sources for the build: the manifests apart from other files, and the requests of the repository's files."""

from __future__ import annotations

import contextlib
import os
import re
import shutil
import stat
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path
from xml.etree import ElementTree

from rosml.base import files
from rosml.base.errors import RosmlError
from rosml.base.problems import near
from rosml.containerize import inputs as app_inputs
from rosml.containerize import within
from rosml.containerize.inputs import Values
from rosml.containerize.packages.ignored import LeftOut
from rosml.containerize.sources.store import is_pointer
from rosml.containerize.within import SECRET

BLACKLIST = "blacklist"
"""The request that names packages to leave out."""

IGNORED = ("COLCON_IGNORE", "CATKIN_IGNORE", "AMENT_IGNORE")
"""Files that keep colcon from looking for packages in a folder."""

MANIFEST, PLAIN = "package.xml", "CMakeLists.txt"
"""The file of a ROS package, and that of a package for CMake alone."""

_PROJECT = re.compile(r"""^[ \t]*project[ \t]*\([ \t]*"?([\w.+-]+)""", re.IGNORECASE | re.MULTILINE)
"""The name of the package in a CMakeLists.txt, as colcon reads it."""


def manifests(root: Path, beyond: list[Path] | None = None, left: LeftOut | None = None) -> Iterator[Path]:
    """The package.xml of the packages below a folder, as colcon finds them, and the files that hide packages. For folders outside of
    packages, the CMakeLists.txt.

    A folder behind a link counts once, unless the link leads out of the root, or to a secret.

    Args:
        beyond: a list that gets such links.
        left: files and folders that are not sent to the builder; they have no packages.
    """
    seen: set[str] = set()
    for folder, folders, names in os.walk(root, followlinks=True):
        real = os.path.realpath(folder)
        if real in seen:
            folders.clear()
            continue
        seen.add(real)
        out = [
            name for name in folders if Path(folder, name).is_symlink() and not within.is_own(Path(folder, name), root)
        ]
        if beyond is not None:
            beyond += [Path(folder, name) for name in out]
        folders[:] = sorted(name for name in folders if not name.startswith(".") and name not in out)
        if left:
            folders[:] = [name for name in folders if not left.whole(Path(folder, name))]
            names = [name for name in names if not left(Path(folder, name))]
        hidden = [name for name in IGNORED if name in names]
        if hidden:
            yield Path(folder, hidden[0])
        elif found := next((name for name in (MANIFEST, PLAIN) if name in names), ""):
            yield Path(folder, found)
        if hidden or MANIFEST in names:
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
    """Copies the manifests of some folders, each below its name. Returns the number of packages in each. A CMakeLists.txt is
    reduced to the name of its package.

    Args:
        say: tells the user of links that are not searched for packages.

    Raises:
        RosmlError: the target and upstream have no package, or a manifest cannot be read or leads out of its folder (exit code 2).
    """
    shutil.rmtree(out, ignore_errors=True)
    out.mkdir(parents=True)
    count = dict.fromkeys(roots, 0)
    for name, root in roots.items():
        (out / name).mkdir()
        beyond: list[Path] = []
        left = LeftOut(root) if name == "target" else None
        for path in manifests(root, beyond, left):
            if path.name == PLAIN and not (within.is_own(path, root) and path.is_file()):
                continue  # in a workspace, catkin's own file is a link to /opt/ros
            target = out / name / path.relative_to(root)
            target.parent.mkdir(parents=True, exist_ok=True)
            if path.name in IGNORED:
                target.touch()
                continue
            within.there(path, root)
            try:
                if path.name == PLAIN:
                    text = path.read_text(errors="replace")
                    target.write_text("".join(f"project({name})\n" for name in _PROJECT.findall(text)[:1]))
                    continue
                shutil.copyfile(path, target)
            except OSError as error:
                raise RosmlError(f"cannot read {path}: {error.strerror}", "check the file", exit_code=2) from None
            count[name] += 1
        for path in beyond:
            say(f"{path} leads to {os.readlink(path)}, out of {root}: packages there are not yours, and are not built")
    if not count["target"] + count.get("upstream", 0):
        raise none_in(roots["target"])
    return count


def none_in(folder: Path) -> RosmlError:
    """The error about a folder without a package that counts (exit code 2)."""
    hides = any(path.name == MANIFEST for path in manifests(folder))
    return RosmlError(
        f"there is no package.xml in {folder}" + (", except what .dockerignore leaves out" if hides else ""),
        "call it in a folder with ROS packages, or name one"
        + ("; bring packages back with lines such as !src" if hides else ""),
        exit_code=2,
    )


def stage(folder: Path, out: Path, without: Path | None = None, left: LeftOut | None = None) -> list[str]:
    """Makes the folder that the builder gets: links to the files of a repository, without git's folder, files of secrets and files
    that stay. If a link has an absolute path to another place of the folder, it becomes relative.

    The folder is one level deeper than the context of the build, so that the builder does not read `.dockerignore` again.

    Args:
        without: one file that stays.
        left: other files and folders that stay.

    Returns:
        Files that others may not read in the folder, as a checkout with umask 077 has them. Everybody may read them in `out`, since an
        image has many users.
    """
    private: list[str] = []
    shutil.rmtree(out, ignore_errors=True)
    out.mkdir(parents=True)
    out.chmod(0o755)
    for path, folders, names in os.walk(folder):
        place = out / os.path.relpath(path, folder)
        links = [name for name in folders if Path(path, name).is_symlink()]
        folders[:] = [
            name
            for name in folders
            if name not in SECRET and name not in links and not (left and left.whole(Path(path, name)))
        ]
        for name in folders:
            (place / name).mkdir()
            (place / name).chmod(0o755)
        for name in [*names, *links]:
            source = Path(path, name)
            stays = name in SECRET or source == without or (left and left(source))
            if not stays and _link(source, place / name, folder):
                private.append(os.path.relpath(source, folder))
    return private


_READABLE = 0o444
"""The permissions that let everybody read a file."""


def _link(source: Path, target: Path, root: Path) -> bool:
    """Links a file to another name, or copies it if that is on another file system or if not everybody may read it. Skips sockets and
    pipes. Returns whether not everybody may read it."""
    facts = source.lstat()
    if stat.S_ISLNK(facts.st_mode):
        leads = os.readlink(source)
        if os.path.isabs(leads) and within.is_own(source, root):
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
    with contextlib.suppress(OSError, RosmlError):
        text = files.limited(folder / ".gitmodules", app_inputs.LARGEST_TEXT).decode(errors="replace")
        values = re.findall(r"^[ \t]*+path[ \t]*+=(.*)$", text, re.MULTILINE)
        paths = [
            path
            for value in values
            if (path := value.strip().removeprefix('"').removesuffix('"').strip()) and '"' not in path
        ]
        return sorted(path for path in paths if path.isprintable() and not any(_listed(folder / path)))
    return []


def pointers(staged: Path) -> list[str]:
    """Files of Git LFS that were not fetched: after a `git clone` without git-lfs, they only point to the real ones.

    Args:
        staged: the folder that `stage` wrote.
    """
    there = [Path(path, name) for path, _, names in os.walk(staged) for name in names]
    attributes = (path for path in there if path.name == ".gitattributes" and path.is_file())
    if not any(b"filter=lfs" in path.read_bytes() for path in attributes):
        return []
    return sorted(str(path.relative_to(staged)) for path in there if is_pointer(path))


def _listed(folder: Path) -> Iterator[os.DirEntry[str]]:
    try:
        with os.scandir(folder) as entries:
            yield from entries
    except OSError:
        return


def stale(requests: Path, manifests: Path) -> Iterator[str]:
    """A sentence for each unknown name among the packages to leave out: a list may be older than the sources.

    Args:
        requests, manifests: the folders that `write_requests` and `write_manifests` wrote.
    """
    known = sorted(names(manifests))
    for name in (requests / BLACKLIST).read_text().split():
        if name not in known:
            yield f"no package is called {name}, which is to be left out" + (
                f"; {text}" if (text := near(name, known)) else ""
            )


def additional_files(name: str, folder: Path) -> Path | None:
    """The repository's folder of additional files; None if it has none.

    Raises:
        RosmlError: the named folder is missing, is no folder, or leads out of the repository (exit code 2).
    """
    if not name:
        return None
    _require_named("additional-files-dir", name, folder, "folder")
    return folder / name if within.there(folder / name, folder, folder=True) else None


def _require_named(name: str, value: str, folder: Path, kind: str) -> None:
    """Checks that a file or folder exists if the user named it; a default may be missing."""
    if value != app_inputs.default(name) and not os.path.lexists(folder / value):
        raise RosmlError(f"{name}: there is no {kind} {value} in {folder}", "check its name", exit_code=2)


def write_requests(values: Values, folder: Path, upstream: Path, environment: Mapping[str, str], out: Path) -> None:
    """Writes the requests: additional packages, scripts, and packages to leave out. Each has a file, which is empty if the repository
    has none.

    Raises:
        RosmlError: a named file is missing, or cannot be read (exit code 2).
    """
    shutil.rmtree(out, ignore_errors=True)
    out.mkdir(parents=True)
    roots = (folder, upstream)

    def said(name: str, recursive: str = "") -> str:
        every = bool(recursive) and values.named(recursive) == "true"
        if not values.named(name):
            return ""
        if not every:
            _require_named(name, values.named(name), folder, "file")
        return app_inputs.text_of(folder, values.named(name), every, roots)

    debs = app_inputs.lines_of(said("additional-debs-file", "enable-recursive-additional-debs"))
    if values.rmw_implementation and environment.get("ROS_VERSION") != "1":
        distribution = values.ros_distro or environment.get("ROS_DISTRO", "")
        debs.append(f"ros-{distribution}-{values.rmw_implementation.replace('_', '-')}")
    for name in debs:
        if not re.fullmatch(r"[a-z0-9][a-z0-9.+-]*(:[a-z0-9-]+)?(=\S+)?", name):
            where = values.additional_debs_file
            raise RosmlError(f"{where}: {name!r} is no package of apt", "write one a line: name or name=version", 2)
    texts = {
        "apt": "".join(f"{line}\n" for line in debs),
        "pip": said("additional-pip-file", "enable-recursive-additional-pip"),
        BLACKLIST: "".join(
            f"{line}\n"
            for line in app_inputs.lines_of(said("blacklisted-packages-file", "enable-recursive-blacklisted-packages"))
        ),
        "identification.sh": said("before-dependency-identification-script"),
        "before.sh": said(
            "before-dependency-installation-script", "enable-recursive-before-dependency-installation-script"
        ),
        "after.sh": said(
            "after-dependency-installation-script", "enable-recursive-after-dependency-installation-script"
        ),
    }
    for name, text in texts.items():
        (out / name).write_text(text)
    (out / "identification.sh").chmod(0o755)  # it runs by its first line
