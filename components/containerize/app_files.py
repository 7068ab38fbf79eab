#!/usr/bin/env python3
"""What an app adds to its base image: the files that its packages bring, and its install space.

    app_files.py BASE RUNTIME ENVIRONMENT WORKSPACE OUTSIDE OUT LOCKED…

BASE is the base image, RUNTIME the same with the packages that the app needs to run, ENVIRONMENT where the app was built. WORKSPACE has
the workspace afterwards, and OUTSIDE what was installed elsewhere: BuildKit hashes all that a step mounts, so these are no whole images.
OUT/root gets the files, OUT/app.json facts about them. If packages remove or replace something of the base image, OUT/root gets the
install space alone, and the run image starts from RUNTIME. The packages of LOCKED beyond BASE are for a lock file. OUT/packages.json,
OUT/files.gz and OUT/facts.gz describe the image; an app that cannot move to another base has no facts.

dpkg's database would be that of one base, so the app's packages are in `/var/lib/dpkg/status.d`, where scanners look for them.
"""

from __future__ import annotations

import compileall
import filecmp
import os
import py_compile
import re
import shutil
import stat
import subprocess
import sys
from pathlib import Path
from typing import Any, Container, Mapping, Sequence

import contents
import lacking
from contents import STATUS, entries, status, walk
from facts import shown, write_app

LEFT_OUT = re.compile(
    r"etc/ld\.so\.cache|etc/(passwd|group|shadow|gshadow|subuid|subgid)-|(etc|var/lib/dbus)/machine-id"
    r"|var/lib/dpkg/(?!status\.d).*|var/lib/apt/.*|var/cache/(apt|debconf|ldconfig|man)(/.*)?|(var/)?tmp/.*"
    r"|(run|proc|sys|dev)/.*|usr/local/share/rosml/(debs\.txt|pip\.lock)"
)
"""What differs and belongs to no app: the state of dpkg and apt, caches, backups, a machine's identity."""

EMPTIED = re.compile(r"var/(cache|log)/.*")
"""Of what is there, folders belong to an app, and files do not."""

FOUND_ALONE = re.compile(r"/(usr/)?lib(32|64|x32)?/[^/]+|/(usr/)?lib/[^/]+-linux-gnu[^/]*/[^/]+")
"""Libraries that glibc finds without ld.so.cache."""

WORKING = re.compile(r"docker-ros(/ws(/.*)?)?|root/\.(ros|colcon|cache|ccache)(/.*)?|.*/__pycache__(/.*)?|.*\.pyc")
"""What building a workspace leaves, and no package installs."""

CAPABILITY = "security.capability"
"""What lets a program do without root, such as ping."""

ASKED = Path("/run")
"""The folder with the lists of packages that were asked for."""

REQUIRED = re.compile(r"\s*([A-Za-z0-9][A-Za-z0-9._-]*)")
"""The name at the beginning of a requirement of pip."""

NAMED = re.compile(r"\s*(?:-r|--requirement)[ \t=]*(\S+)")
"""A line that names another list for pip."""

DEEPEST = 10
"""How deep lists for pip may name others."""

METADATA = "usr/**/*-packages/*.dist-info/METADATA"
"""What the packages of Python in a layer say of themselves."""

TIME = 1767225600
"""2026-01-01T00:00:00Z, as the layers of all parts have it."""


def same(path: str, one: Path, other: Path, before: os.stat_result, after: os.stat_result) -> bool:
    """Whether a file is as it was; of a folder, only its owner and mode."""
    if (before.st_mode, before.st_uid, before.st_gid) != (after.st_mode, after.st_uid, after.st_gid):
        return False
    if stat.S_ISLNK(after.st_mode):
        return os.readlink(one / path) == os.readlink(other / path)
    if not stat.S_ISREG(after.st_mode):
        return True
    if before.st_size != after.st_size:
        return False
    # What a step changes gets the time of all parts: then the time says nothing.
    if before.st_mtime_ns == after.st_mtime_ns and int(after.st_mtime) != TIME:
        return True
    return filecmp.cmp(one / path, other / path, shallow=False)


def belongs(path: str, facts: os.stat_result) -> bool:
    return not LEFT_OUT.fullmatch(path) and (stat.S_ISDIR(facts.st_mode) or not EMPTIED.fullmatch(path))


def libraries(root: Path) -> set[str]:
    """The libraries that only ld.so.cache finds, such as those in /usr/local/lib."""
    command = ["ldconfig", "-p", "-C", str(root / "etc/ld.so.cache")]
    listing = os.fsdecode(subprocess.run(command, capture_output=True, check=False).stdout)
    paths = {line.rpartition(" => ")[2].strip() for line in listing.split("\n") if " => " in line}
    return {path for path in paths if not FOUND_ALONE.fullmatch(path)}


def versions(base: Path, roots: Sequence[Path]) -> dict[str, Any]:
    """For a lock file: packages of apt with their versions, and requirements of pip as install.sh left them."""
    of_base = _versions(base)
    architecture = next((key.partition(":")[2] for key in of_base if key.startswith("dpkg:")), "")
    apt: dict[str, str] = {}
    pip: set[str] = set()
    for root in roots:
        for key, version in _versions(root).items():
            name, _, of = key.partition(":")
            if of_base.get(key) != version:
                apt.setdefault(name if of in ("all", architecture) else key, version)
        file = root / "usr/local/share/rosml/pip.lock"
        pip.update(file.read_text("utf-8", "replace").split("\n")[:-1] if file.exists() else [])
    return {"architecture": architecture, "apt": apt, "pip": sorted(pip)}


def _versions(root: Path) -> dict[str, str]:
    matches = {key: re.search(r"^Version: (.*)$", text, re.MULTILINE) for key, text in status(root).items()}
    return {key: version[1] for key, version in matches.items() if version}


def put(source: Path, target: Path) -> None:
    facts = os.lstat(source)
    if stat.S_ISDIR(facts.st_mode):
        target.mkdir(exist_ok=True)
    elif stat.S_ISLNK(facts.st_mode):
        target.symlink_to(os.readlink(source))
        os.lchown(target, facts.st_uid, facts.st_gid)
        return
    elif stat.S_ISREG(facts.st_mode):
        shutil.copyfile(source, target)
    else:
        return
    os.chown(target, facts.st_uid, facts.st_gid)
    os.chmod(target, stat.S_IMODE(facts.st_mode))
    if CAPABILITY in os.listxattr(source):  # after the change of the owner, which takes it away
        os.setxattr(target, CAPABILITY, os.getxattr(source, CAPABILITY))


def require_folder(place: Path, path: Path) -> None:
    """Ends the program if a folder is a link: files would be read, or written, at a place that is not the app's."""
    if not stat.S_ISDIR(os.lstat(place).st_mode):
        what = f"/{path} is no folder, and should have the app's files"
        sys.exit(f"error: {what}; let your scripts and packages leave it one")


def copy(source: Path, path: str, out: Path) -> None:
    """Copies a file with the folders above it. A link among these would lead to a place that is not the app's."""
    parts = Path(path).parts
    for number in range(1, len(parts)):
        folder = Path(*parts[:number])
        if not os.path.lexists(out / folder):
            require_folder(source / folder, folder)
            put(source / folder, out / folder)
        require_folder(out / folder, folder)
    put(source / path, out / path)


def packages(base: Path, runtime: Path, root: Path) -> dict[str, list[str]]:
    """Copies the files that packages bring to a root; returns what they change. Copies nothing if they remove or replace something of
    the base image: a layer on top of it cannot say that."""
    before, after = entries(base), entries(runtime)
    of_base, installed = status(base), status(runtime)
    paths = [path for path in sorted(after) if belongs(path, after[path])]
    facts = {
        "packages": sorted(installed.keys() - of_base.keys()),
        "replaced": sorted(name for name in of_base if installed.get(name) != of_base[name]),
        "changed": [
            path for path in paths if path in before and not same(path, base, runtime, before[path], after[path])
        ],
        "removed": [path for path in sorted(before) if path not in after and belongs(path, before[path])],
    }
    if libraries(runtime) - libraries(base):
        facts["changed"].append("etc/ld.so.cache")
    changed = {*facts["changed"]}
    facts.update(changed=shown(facts["changed"]), removed=shown(facts["removed"]))
    if facts["replaced"] or facts["removed"]:
        return facts
    for path in [*paths, *changed.difference(paths)]:
        if path not in before or path in changed:
            copy(runtime, path, root)
    if facts["packages"]:
        folder = root / "var/lib/dpkg/status.d"
        copy(runtime, STATUS, root)
        (root / STATUS).unlink()
        folder.mkdir()
        digests = contents.deb_digests(str(runtime / contents.DEBS))
        for name in facts["packages"]:
            (folder / name.partition(":")[0]).write_text(with_digest(installed[name], digests), encoding="utf-8")
    return facts


def with_digest(text: str, digests: Mapping[tuple[str, ...], str]) -> str:
    """An entry of dpkg's database with the hash of the package's archive, by the name that it has in apt's lists."""
    fields = dict(re.findall(r"^(Package|Architecture|Version): (.*)$", text, re.MULTILINE))
    digest = digests.get((fields["Package"], fields["Architecture"], fields.get("Version", "")))
    return f"{text}SHA{len(digest) * 4}: {digest}\n" if digest else text


def built_packages(install: Path) -> list[str]:
    files = (path for below in ("", "*/") for path in install.glob(f"{below}share/colcon-core/packages/*"))
    return sorted({path.name for path in files})


def outside(environment: Path, installed: Path) -> list[str]:
    """What the app's packages installed outside of the workspace, and what was not there before."""
    before = {path for path, _ in walk(environment)}
    new = sorted(path for path, _ in walk(installed) if path not in before and not WORKING.fullmatch(path))
    return [path for path in new if belongs(path, os.lstat(installed / path))]


def requested(runtime: Path, brought: Sequence[str]) -> set[str]:
    """The packages of apt that the app asks for by name and its base image has, without those that it brings itself."""
    listed = (ASKED / "needed/exec.apt", ASKED / "requests/apt")
    words = " ".join(file.read_text("utf-8", "replace") for file in listed if file.is_file()).split()
    names = {word.partition("=")[0].partition(":")[0] for word in words}
    return {key.partition(":")[0] for key in status(runtime).keys() - {*brought}} & names


def asked_of_pip(brought: Container[str], runtime: Path, layer: Path) -> set[str]:
    """The packages of pip that its base image brings, and that the app asks for by name or a package of its layer needs."""
    listed = (ASKED / "needed/exec.pip", ASKED / "requests/pip")
    lines = [line for file in listed for line in requirements(file, runtime)]
    lines += [line for file in sorted(layer.glob(METADATA)) for line in required(file)]
    names = {lacking.normal(match.group(1)) for match in map(REQUIRED.match, lines) if match}
    return {name for name in names if name in brought}


def requirements(file: Path, root: Path, depth: int = 0) -> list[str]:
    """The lines of a list for pip, and of those that it names."""
    if not file.is_file() or depth > DEEPEST:
        return []
    lines: list[str] = []
    for line in file.read_text("utf-8", "replace").splitlines():
        include = NAMED.match(line)
        if include and include.group(1).startswith("/"):
            lines += requirements(root / include.group(1).lstrip("/"), root, depth + 1)
        elif include:
            lines += requirements(file.parent / include.group(1), root, depth + 1)
        else:
            lines.append(line)
    return lines


def required(metadata: Path) -> list[str]:
    """What a package of Python needs on any machine, without any extra."""
    lines = metadata.read_text("utf-8", "replace").partition("\n\n")[0].splitlines() if metadata.is_file() else []
    requirements = [line.partition(":")[2] for line in lines if line.startswith("Requires-Dist:")]
    return [line for line in requirements if ";" not in line]


def main(
    base: Path, runtime: Path, environment: Path, workspace: Path, elsewhere: Path, out: Path, *locked: Path
) -> None:
    root = out / "root"
    root.mkdir(parents=True)
    install = "docker-ros/ws/install"
    if os.path.lexists(workspace / install):
        require_folder(workspace / install, Path(install))
    names = built_packages(workspace / install)
    lacks = lacking.Lacking(runtime, workspace, [environment, elsewhere], names)
    forgotten = lacks.forgotten()
    facts = {
        **packages(base, runtime, root),
        "built": shown(names),
        "lost": shown(sorted(lacks.lost)),
        "absent": shown(sorted(lacks.absent)),
        "forgotten": dict(zip(shown(forgotten), shown(forgotten.values()))),
        "outside": shown(outside(environment, elsewhere)),
        **versions(base, locked),
    }

    # Of a base image that is an app itself, what it has built stays of_base.
    of_base = {os.path.join(install, path): stats for path, stats in entries(base / install).items()}
    for above, folders, names in os.walk(workspace / install):
        if "__pycache__" in folders:
            folders.remove("__pycache__")
        for name in [*folders, *names, "."]:
            path = os.path.normpath(os.path.relpath(os.path.join(above, name), workspace))
            unchanged = path in of_base and same(path, base, workspace, of_base[path], os.lstat(workspace / path))
            if not unchanged and not os.path.lexists(root / path):
                copy(workspace, path, root)

    # Compiled by the time of a source it would hold when it was built, and be stale now. Pythons up to 3.10 write sets in the order
    # of PYTHONHASHSEED, which the Dockerfile sets.
    compileall.compile_dir(
        str(root / install),
        maxlevels=100,
        ddir=f"/{install}",
        quiet=2,
        invalidation_mode=py_compile.PycInvalidationMode.CHECKED_HASH,
    )

    for above, folders, names in os.walk(root):
        for name in [*folders, *names, "."]:
            os.utime(os.path.join(above, name), (TIME, TIME), follow_symlinks=False)
    (out / "app.json").write_text(contents.as_json(facts, indent=2))
    linked = not (facts["replaced"] or facts["removed"])
    below = base if linked else runtime
    contents.write(contents.files([below, root]), status(runtime).values(), contents.owned(runtime), out)
    if linked:
        of_pip = asked_of_pip(lacks.distributions(root), runtime, root)
        write_app(root, runtime, out, lacks.imported(root), requested(runtime, facts["packages"]), of_pip)


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))
