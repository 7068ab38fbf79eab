#!/usr/bin/env python3
"""Installs packages of pip, and writes down what it installed: each at its version, with the hash of its archive.

    pip_install.py WRITTEN LOCKED FILE [REQUIREMENT…]

FILE has requirements as well; it may be empty. WRITTEN gets a line for each package, beside those that it has. LOCKED is such a
list: if it is there, nothing else is installed. pip before 22.2 says no hashes. A requirement that is a folder has no line.
"""

from __future__ import annotations

import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any, NamedTuple, NoReturn, Sequence

NOT_OF_INDEX = re.compile(r"^-(?!r\b|-requirement|e\b|-editable|c\b|-constraint)")
"""Lines of a file with requirements that say where pip looks, and how."""


class Wanted(NamedTuple):
    """What pip would install.

    Attributes:
        name: of the package, as PyPI compares names. line: a requirement that means this archive alone.
        locked: whether a lock file can have it.
    """

    name: str
    line: str
    locked: bool = True


def pip(*arguments: str) -> None:
    done = subprocess.run([sys.executable, "-m", "pip", *arguments])
    if done.returncode:
        sys.exit(done.returncode)


def fail(text: str, remedy: str) -> NoReturn:
    sys.exit(f"error: {text}; {remedy}")


def normal(name: str) -> str:
    return re.sub(r"[-_.]+", "-", name).lower()


def name_of(line: str) -> str:
    """The package of a line."""
    return normal(re.split(r"[ =@]", line, maxsplit=1)[0])


def planned(item: dict[str, Any]) -> Wanted:
    """One entry of a report of pip's."""
    name, info = normal(item["metadata"]["name"]), item["download_info"]
    if "vcs_info" in info:
        vcs = info["vcs_info"]
        part = f"#subdirectory={info['subdirectory']}" if "subdirectory" in info else ""
        return Wanted(name, f"{name} @ {vcs['vcs']}+{info['url']}@{vcs['commit_id']}{part}")
    if "dir_info" in info:
        return Wanted(name, f"{name} @ {info['url']}", locked=False)
    archive = info["archive_info"]
    hashes = archive.get("hashes") or dict([archive.get("hash", "=").split("=", 1)])
    if item["is_direct"]:
        return Wanted(name, f"{name} @ {info['url']}#sha256={hashes.get('sha256', '')}")
    return Wanted(name, f"{name}=={item['metadata']['version']} --hash=sha256:{hashes['sha256']}")


def plan(arguments: Sequence[str], scratch: Path) -> list[Wanted]:
    """What pip would install."""
    report = scratch / "report.json"
    pip("install", "--quiet", "--dry-run", "--report", str(report), *arguments)
    found = json.loads(report.read_text())["install"]
    return sorted(map(planned, found))


def installed() -> set[str]:
    """What is installed, as lines without hashes."""
    command = [sys.executable, "-m", "pip", "list", "--format=json"]
    said = subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout
    return {f"{normal(item['name'])}=={item['version']}" for item in json.loads(said)}


def knows_report() -> bool:
    """Whether pip can say what it would install."""
    said = subprocess.run(
        [sys.executable, "-m", "pip", "--version"], check=True, stdout=subprocess.PIPE, text=True
    ).stdout
    version = re.match(r"pip (\d+)\.(\d+)", said)
    return bool(version) and (int(version[1]), int(version[2])) >= (22, 2)


def without_hash(line: str) -> str:
    return line.split(" --hash=")[0]


def require_locked(lines: Sequence[str], locked: dict[str, str]) -> None:
    """Checks that a lock file has what is to be installed."""
    known = set(map(without_hash, locked.values()))
    missing = [line for line in map(without_hash, lines) if line not in known]
    if missing:
        fail(f"the lock file does not have {', '.join(missing)}", "write it anew with --lock")


def main(written: Path, lock: Path, file: Path, *requirements: str) -> None:
    locked = {name_of(line): line for line in lock.read_text().splitlines()} if lock.exists() else {}
    lines = set(written.read_text().splitlines()) if written.exists() else set()
    with tempfile.TemporaryDirectory() as folder:
        scratch = Path(folder)
        arguments = [*requirements, "--requirement", str(file)]
        if locked:
            constraints = scratch / "constraints"
            constraints.write_text("".join(f"{without_hash(line)}\n" for line in locked.values()))
            arguments += ["--constraint", str(constraints)]
        if knows_report():
            wanted = plan(arguments, scratch)
            if lock.exists():
                require_locked([item.line for item in wanted if item.locked], locked)
                wanted = [item._replace(line=locked.get(item.name, item.line)) for item in wanted]
            options = [line for line in file.read_text().splitlines() if NOT_OF_INDEX.match(line)]
            for hashed in (True, False):
                chosen = [item.line for item in wanted if (" --hash=" in item.line) is hashed]
                if chosen:
                    (scratch / "chosen").write_text("\n".join([*options, *chosen]) + "\n")
                    more = ["--require-hashes"] if hashed else []
                    pip("install", "--no-deps", *more, "--requirement", str(scratch / "chosen"))
            lines.update(item.line for item in wanted if item.locked)
        else:
            before = installed()
            pip("install", *arguments)
            new = sorted(installed() - before)
            if lock.exists():
                require_locked(new, locked)
            lines.update(new)
    written.parent.mkdir(parents=True, exist_ok=True)
    written.write_text("".join(f"{line}\n" for line in sorted(lines)))


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:4]), *sys.argv[4:])
