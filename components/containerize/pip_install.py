#!/usr/bin/env python3
"""Installs packages of pip, and writes down what it installed: each at its version, with the hash of its archive.

    pip_install.py WRITTEN LOCKED ARGUMENT…

The arguments are those of pip. WRITTEN gets a line for each package, beside those that it has. LOCKED is such a list: if it is
there and pip installs something else, this fails. pip before 22.2 says no hashes. A requirement that is a folder has no line.
"""

from __future__ import annotations

import json
import re
import subprocess
import sys
import tempfile
from importlib.metadata import distributions
from pathlib import Path
from typing import Any, Iterable, Sequence


def normal(name: str) -> str:
    """A name as indexes compare names."""
    return re.sub(r"[-_.]+", "-", name).lower()


def line(name: str, version: str, info: dict[str, Any], direct: bool) -> str:
    """A requirement that means this archive, or this commit, and no other; empty for a folder.

    Args:
        info: where it is from, as in direct_url.json. direct: the user named that place.
    """
    if "dir_info" in info:
        return ""
    if "vcs_info" in info:
        return f"{normal(name)} @ {info['vcs_info']['vcs']}+{info['url']}@{info['vcs_info']['commit_id']}"
    archive = info.get("archive_info", {})
    hashes = archive.get("hashes") or dict([archive.get("hash", "=").split("=", 1)])
    sha256 = hashes.get("sha256", "")
    if direct:
        return f"{normal(name)} @ {info['url']}#sha256={sha256}"
    return f"{normal(name)}=={version}" + (f" --hash=sha256:{sha256}" if sha256 else "")


def run(arguments: Sequence[str]) -> None:
    done = subprocess.run([sys.executable, "-m", "pip", "install", *arguments])
    if done.returncode:
        sys.exit(done.returncode)


def reported(arguments: Sequence[str]) -> list[str]:
    """Installs; gives a line for each package, as pip says them."""
    with tempfile.TemporaryDirectory() as folder:
        report = Path(folder) / "report.json"
        run(["--report", str(report), *arguments])
        items = json.loads(report.read_text())["install"]
    metadata = [(item["metadata"], item["download_info"], item["is_direct"]) for item in items]
    return [line(data["name"], data["version"], info, direct) for data, info, direct in metadata]


def installed() -> set[str]:
    """What is installed, as lines without hashes."""
    found = set()
    for item in distributions():
        text = item.read_text("direct_url.json")
        found.add(line(item.metadata["Name"], item.version, json.loads(text) if text else {}, bool(text)))
    return found


def compared(arguments: Sequence[str]) -> list[str]:
    """Installs; gives a line for each package that was not there before."""
    before = installed()
    run(arguments)
    return [item for item in installed() if item not in before]


def knows_report() -> bool:
    """Whether pip can say what it installed."""
    said = subprocess.run(
        [sys.executable, "-m", "pip", "--version"], check=True, stdout=subprocess.PIPE
    ).stdout.decode()
    version = re.match(r"pip (\d+)\.(\d+)", said)
    return version is not None and (int(version[1]), int(version[2])) >= (22, 2)


def constraints(locked: Iterable[str]) -> str:
    """What keeps pip at these versions. A place cannot be constrained that the user names another way."""
    return "".join(f"{item.partition(' ')[0]}\n" for item in sorted(locked) if " @ " not in item)


def main(written: Path, lock: Path, *arguments: str) -> None:
    locked = set(lock.read_text().splitlines()) if lock.exists() else set()
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "constraints"
        file.write_text(constraints(locked))
        install = reported if knows_report() else compared
        new = sorted(filter(None, install([*arguments, "--constraint", str(file)] if locked else arguments)))
    others = [item for item in new if item not in locked]
    if lock.exists() and others:
        sys.exit(
            f"error: the lock file does not have what pip installed: {', '.join(others)}; write it anew with --lock"
        )
    before = written.read_text().splitlines() if written.exists() else []
    written.parent.mkdir(parents=True, exist_ok=True)
    written.write_text("".join(f"{item}\n" for item in sorted({*before, *new})))


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]), *sys.argv[3:])
