#!/usr/bin/env python3
"""Installs packages of pip, and writes down what it installed: each at its version, with the hash of its archive.

    pip_install.py WRITTEN LOCKED ARGUMENT…

WRITTEN gets more lines, one for each package. LOCKED is such a list: if it exists, its archives are installed by their hashes, and this
fails if pip then installs something else. pip before 22.2 says no hashes, and a folder has no line. The lines go into images and lock
files, so their addresses have no user, password or query, which may be a secret.
"""

from __future__ import annotations

import base64
import csv
import hashlib
import json
import os
import re
import shlex
import subprocess
import sys
import tempfile
from collections import deque
from functools import partial
from importlib.metadata import distributions
from pathlib import Path
from typing import Any, Callable, Container, Iterable, NoReturn, Sequence
from urllib.parse import urlsplit, urlunsplit
from urllib.request import url2pathname


def normal(name: str) -> str:
    """A name as indexes compare names."""
    return re.sub(r"[-_.]+", "-", name).lower()


def fail(message: str, remedy: str) -> NoReturn:
    sys.exit(f"error: {message}; {remedy}")


def address(url: str) -> str:
    """An address without a user, a password and a query. The user of ssh stays: it is needed, and no secret. May raise ValueError."""
    parts = urlsplit(url)
    user, at, host = parts.netloc.rpartition("@")
    kept = user.partition(":")[0] + at if parts.scheme.endswith("ssh") else ""
    return urlunsplit((parts.scheme, kept + host, parts.path, "", ""))


def line(name: str, version: str, info: dict[str, Any], direct: bool) -> str:
    """A requirement of exactly this archive or commit; empty for a folder. Raises an error of DAMAGED if pip describes no place so.

    Args:
        info: where it is from, as in direct_url.json. direct: the user named that place.
    """
    if not (NAME.fullmatch(name) and VERSION.fullmatch(version)):
        raise ValueError(f"{name!r} {version!r} is no package")
    if "dir_info" in info:
        return ""
    if "vcs_info" in info:
        vcs, commit = info["vcs_info"]["vcs"], info["vcs_info"]["commit_id"]
        return f"{normal(name)} @ {vcs}+{address(info['url'])}@{commit}{fragment('', info)}"
    sha256 = digest(info.get("archive_info", {}))
    if direct:
        return f"{normal(name)} @ {address(info['url'])}{fragment(sha256, info)}"
    return f"{normal(name)}=={version}" + (f" --hash=sha256:{sha256}" if sha256 else "")


NAME = re.compile(r"[A-Za-z0-9]([A-Za-z0-9._-]*[A-Za-z0-9])?")
VERSION = re.compile(r"[A-Za-z0-9.+!_-]+")
SHA256 = re.compile("[0-9a-f]{64}")


def digest(archive: dict[str, Any]) -> str:
    """The SHA-256 of an archive; empty if pip says none."""
    kind, _, value = archive.get("hash", "").partition("=")
    sha256 = archive.get("hashes", {}).get("sha256", value if kind == "sha256" else "")
    return sha256 if SHA256.fullmatch(sha256) else ""


def fragment(sha256: str, info: dict[str, Any]) -> str:
    parameters = (("sha256", sha256), ("subdirectory", info.get("subdirectory", "")))
    text = "&".join(f"{name}={value}" for name, value in parameters if value)
    return f"#{text}" if text else ""


def run(arguments: Sequence[str]) -> None:
    """Installs, and prints what pip prints. Ends the program if pip fails."""
    last: deque[str] = deque(maxlen=KEPT_LINES)
    with subprocess.Popen(
        [sys.executable, "-m", "pip", "install", *arguments], stdout=subprocess.PIPE, stderr=subprocess.STDOUT
    ) as pip:
        assert pip.stdout
        for piece in iter(partial(pip.stdout.readline, LONGEST), b""):
            sys.stdout.buffer.write(piece)
            sys.stdout.flush()
            last.append(piece.decode("utf-8", "replace"))
    if pip.returncode:
        refused = refusal("".join(last))
        fail(*refused or (f"pip ended with {pip.returncode}", "the lines above say why"))


KEPT_LINES = 200
"""How many of pip's last lines may say why it refuses something."""

CONSTRAINTS = Path("/usr/local/share/rosml")
"""Where our images have constraints.txt, what ROS needs, and constraints.d with what their parts hold."""

HELD = re.compile(r"^ +The user requested \(constraint\) ([A-Za-z0-9][A-Za-z0-9._-]*)(.*)$", re.MULTILINE)
DEMAND = re.compile(r"^ +(?:(\S+)( \S+) depends on|The user requested) ([A-Za-z0-9][A-Za-z0-9._-]*)(.*)$", re.MULTILINE)
"""What pip says of a conflict: a constraint, and a requirement with the package that has it."""


def refusal(output: str) -> tuple[str, str] | None:
    """The error and its remedy if pip refuses a package because of what the image keeps to; None if it failed for another reason."""
    demands = {normal(name): (user, version, name + rest) for user, version, name, rest in DEMAND.findall(output)}
    for name, rest in HELD.findall(output):
        if normal(name) not in demands:
            continue
        user, version, need = demands[normal(name)]
        text = f"{user}{version} needs {need}" if user else f"the requirements for pip name {need}"
        fitting = f"a release of {user} that takes {name}{rest}" if user else f"{name} without a version"
        if normal(name) in names_in(CONSTRAINTS.glob("constraints.txt")):
            return (
                f"{text[:300]}, and ROS's packages in this image work with {name}{rest}",
                f"ask for {fitting}; or take a base image with another {name} (docs/installs.md); or install it into an"
                " environment of its own, which ROS does not use (docs/use/python.md)",
            )
        if normal(name) in names_in(CONSTRAINTS.glob("constraints.d/*.txt")):
            return (
                f"{text[:300]}, and the image has {name}{rest}",
                f"ask for {fitting}; or take a base image of another stack (rosml list); or replace {name} for Python"
                " by the command unpinned, in a script after the installation of dependencies (docs/use/python.md)",
            )
    return None


def names_in(files: Iterable[Path]) -> set[str]:
    """The packages that files of constraints name."""
    return {normal(re.split("[^A-Za-z0-9._-]", item, maxsplit=1)[0]) for file in files for item in lines_of(file)}


PLACE = "direct_url.json"
"""Where a package says what place a user named for it."""

DAMAGED = (AttributeError, KeyError, RecursionError, TypeError, ValueError)


def requirements(report: bytes) -> list[str]:
    """A line for each package of pip's report."""
    try:
        items = json.loads(report)["install"]
        metadata = [(item["metadata"], item["download_info"], item["is_direct"]) for item in items]
        return [line(data["name"], data["version"], info, direct) for data, info, direct in metadata]
    except DAMAGED as error:
        fail(f"pip's report cannot be read: {error!r}"[:300], "install another version of pip in the base image")


def reported(arguments: Sequence[str]) -> list[str]:
    """Installs. Returns a line for each package of pip's report."""
    with tempfile.TemporaryDirectory() as folder:
        report = Path(folder) / "report.json"
        run(["--report", str(report), *arguments])
        return requirements(report.read_bytes())


def installed() -> set[str]:
    """What is installed, as lines without hashes. A damaged folder counts for none, as for pip."""
    lines = set()
    for item in distributions():
        try:
            text = item.read_text(PLACE)
            lines.add(line(item.metadata["Name"], item.version, json.loads(text) if text else {}, bool(text)))
        except DAMAGED:
            continue
    return lines


def compared(arguments: Sequence[str]) -> list[str]:
    """Installs. Returns a line for each package that is new."""
    before = installed()
    run(arguments)
    return [item for item in installed() if item not in before]


def forget_secrets(names: Container[str]) -> None:
    """Removes users, passwords and queries from the addresses of packages, which pip keeps in the image. `names`: of new ones."""
    for item in distributions():
        try:
            direct_url_files = [
                file for file in item.files or () if file.name == PLACE and normal(item.metadata["Name"]) in names
            ]
            facts = json.loads(item.read_text(PLACE) or "{}") if direct_url_files else {}
            url = address(facts["url"]) if facts else ""
        except DAMAGED:
            continue
        if not facts or url == facts["url"]:
            continue
        content = json.dumps({**facts, "url": url}).encode()
        file = Path(str(direct_url_files[0].locate()))
        file.write_bytes(content)
        with file.with_name("RECORD").open(newline="", encoding="utf-8") as stream:
            rows = [row for row in csv.reader(stream) if row]
        state = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
        record = [str(direct_url_files[0]), f"sha256={state}", str(len(content))]
        with file.with_name("RECORD").open("w", newline="", encoding="utf-8") as stream:
            csv.writer(stream, lineterminator="\n").writerows(record if row[0] == record[0] else row for row in rows)


def knows_report() -> bool:
    """Whether pip can say what it installed."""
    command = [sys.executable, "-m", "pip", "--version"]
    output = subprocess.run(command, check=True, stdout=subprocess.PIPE).stdout
    version = re.match(rb"pip (\d+)\.(\d+)", output)
    return version is not None and (int(version[1]), int(version[2])) >= (22, 2)


def lines_of(file: Path) -> list[str]:
    return file.read_text(encoding="utf-8").split("\n")[:-1]


def constraints(locked: Iterable[str]) -> str:
    """What keeps pip at these versions. pip cannot constrain an address."""
    return "".join(f"{item.partition(' ')[0]}\n" for item in sorted(locked) if " @ " not in item)


FOLDERS = ("-f", "--find-links")
PLACES = (*FOLDERS, "-i", "--index-url", "--extra-index-url", "--no-binary", "--only-binary")
SWITCHES = ("--no-index", "--pre", "--prefer-binary")
"""Options of pip that say where archives come from and which kinds count, with a value and without."""


def from_where(arguments: Sequence[str], depth: int = 0) -> list[str]:
    """The options of pip that say where archives come from, also those in files of requirements."""
    options: list[str] = []
    words = iter(arguments)
    for word in words:
        name, equals, value = word.partition("=")
        if name in SWITCHES:
            options.append(name)
        elif name in (*PLACES, "-r", "--requirement"):
            value = value if equals else next(words, "")
            if name in PLACES:
                options += [name, value]
            elif depth < DEEPEST and os.path.isfile(value):
                folder = Path(value).parent
                for text in Path(value).read_text("utf-8", "replace").split("\n"):
                    inside = words_of(text) if text.lstrip().startswith("-") else []
                    files = inside[:1] in (["-r"], ["--requirement"])
                    if len(inside) == 2 and (files or (inside[0] in FOLDERS and (folder / inside[1]).is_dir())):
                        inside[1] = str(folder / inside[1])
                    options += from_where(inside, depth + 1)
    return options


DEEPEST, LONGEST = 10, 8192
"""How deep files of requirements may name others; and the most characters of a line with options."""


def words_of(text: str) -> list[str]:
    """The words of a line with options; none if pip refuses it. shlex takes a minute for a word of a megabyte."""
    try:
        return shlex.split(text[:LONGEST], comments=True)
    except ValueError:  # a quote does not close
        return []


def take_locked(
    locked: Iterable[str], arguments: Sequence[str], install: Callable[[Sequence[str]], list[str]]
) -> list[str]:
    """Installs the archives of a lock file by their hashes, so pip compares one before it runs or unpacks anything of it. Lines without
    a hash are left out: of a repository, whose commit they name, or by an old pip. Returns a line for each new package."""
    hashed = [item for item in sorted(locked) if "sha256" in item]
    if not hashed:
        return []
    hashes = hashes_of(hashed)
    names = {re.split("[ =]", item, maxsplit=1)[0] for item in hashed}
    with tempfile.TemporaryDirectory() as scratch:
        where = from_where(arguments)
        for at, option in enumerate(where[:-1]):
            if option in FOLDERS:
                where[at + 1] = without_others(where[at + 1], names, hashes, Path(scratch, str(at)))
        file = Path(scratch) / "locked.txt"
        file.write_text("".join(f"{item}\n" for item in hashed), encoding="utf-8")
        return install([*where, "--no-deps", "--require-hashes", "--requirement", str(file)])


def hashes_of(lines: Iterable[str]) -> set[str]:
    return {sha256 for item in lines for sha256 in SHA256.findall(item)}


def without_others(place: str, names: Container[str], hashes: Container[str], new: Path) -> str:
    """A folder without other archives of locked packages than the locked ones; any other place as it is.

    Of a folder, pip takes the best archive by its name and only then compares hashes. What a package is built with is in no lock file,
    and stays.
    """
    folder = Path(url2pathname(place[len("file:") :]) if place.startswith("file:") else place)
    if not folder.is_dir():
        return place
    new.mkdir()
    for file in sorted(folder.iterdir()):
        match = ARCHIVE.fullmatch(file.name)
        if not match or normal(match[1] or match[2]) not in names or sha256_of(file) in hashes:
            (new / file.name).symlink_to(file.resolve())
    return str(new)


ARCHIVE = re.compile(r"([A-Za-z0-9._]+)-.*\.whl|(.+)-[^-]+\.(?:tar\.gz|tar\.bz2|tar\.xz|zip|tgz)")
"""The file name of a wheel, or of a package's sources."""


def sha256_of(file: Path) -> str:
    return hashlib.sha256(file.read_bytes()).hexdigest() if file.is_file() else ""


def require_locked(locked: Iterable[str], arguments: Sequence[str]) -> None:
    """Checks that a lock file has the packages and archives that are asked for, before pip runs anything of them."""
    lines = list(locked)
    names, hashes = {normal(re.split("[ =]", item, maxsplit=1)[0]) for item in lines}, hashes_of(lines)
    names |= {normal(item.metadata["Name"] or "") for item in distributions()}  # what is there, pip leaves alone
    for word in requested(arguments):
        file = Path(url2pathname(word[len("file:") :]) if word.startswith("file:") else word.partition("#")[0])
        if ARCHIVE.fullmatch(file.name) and file.is_file():
            lacking = sha256_of(file) not in hashes
        else:
            match = ASKED.fullmatch(word)
            lacking = match is not None and normal(match[1]) not in names
        if lacking:
            fail(f"the lock file does not have {word}, which is asked for", "write it anew with --lock")


ASKED = re.compile(r"([A-Za-z0-9](?:[A-Za-z0-9._-]*[A-Za-z0-9])?)(?:\[[^]]*\])?(?:[ ]*[<>=!~(][^;]*)?")
"""A requirement by its name. pip alone knows whether one with a marker counts here."""


def requested(arguments: Sequence[str], depth: int = 0) -> list[str]:
    """What arguments of pip ask for, also in files of requirements."""
    requirements: list[str] = []
    words = iter(arguments)
    for word in words:
        name, equals, value = word.partition("=")
        if name in ("-r", "--requirement"):
            file = Path(value if equals else next(words, ""))
            for text in file.read_text("utf-8", "replace").splitlines() if depth < DEEPEST and file.is_file() else []:
                line = re.sub(r"(^|\s)#.*", "", text).strip()
                if not line.startswith("-"):
                    requirements += [line] if line else []
                elif words_of(line)[:1] in (["-r"], ["--requirement"]):
                    requirements += requested(["-r", str(file.parent / " ".join(words_of(line)[1:]))], depth + 1)
        elif word.startswith("-"):
            if name in VALUED and not equals:
                next(words, "")
        else:
            requirements.append(word)
    return requirements


VALUED = (*PLACES, "-c", "--constraint", "-e", "--editable", "-t", "--target")
"""Options of pip with a value."""


def main(written: Path, lock: Path, *arguments: str) -> None:
    locked = set(lines_of(lock)) if lock.exists() else set()
    install = reported if knows_report() else compared
    if lock.exists():
        require_locked(locked, arguments)
    new = take_locked(locked, arguments, install)
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "constraints"
        file.write_text(constraints(locked))
        new += install([*arguments, "--constraint", str(file)] if locked else arguments)
    new = sorted(set(filter(None, new)))
    forget_secrets({item.partition(" @ ")[0] for item in new if " @ " in item})
    others = [item for item in new if item not in locked]
    if lock.exists() and others:
        sys.exit(
            f"error: the lock file does not have what pip installed: {', '.join(others)}; write it anew with --lock"
        )
    before = lines_of(written) if written.exists() else []
    written.parent.mkdir(parents=True, exist_ok=True)
    written.write_text("".join(f"{item}\n" for item in sorted({*before, *new})))


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]), *sys.argv[3:])
