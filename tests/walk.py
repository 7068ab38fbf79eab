"""Walks a page of the documentation as a reader does: puts its entries into files, and runs its commands."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

from tests.pages import ROOT, Block, blocks, commands

EXTEND = (ROOT / "docs/extend.md", *sorted((ROOT / "docs/extend").glob("*.md")))
SET_PAGE = ROOT / "docs/own-set.md"
NEEDS_NETWORK = ("./rosml locks", "./rosml image", "make image", "gpg ")
"""Steps of the page that are not walked: tests run them with local replacements."""


def clone(folder: Path) -> Path:
    """Fills an empty folder with what a clone of this checkout has, changes of today included, as a first commit."""
    listed = ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"]
    names = subprocess.run(listed, cwd=ROOT, capture_output=True, text=True, check=True).stdout.split("\0")
    for name in filter(None, names):
        if (ROOT / name).exists():
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(ROOT / name, folder / name, follow_symlinks=False)
    for arguments in (["init", "--quiet"], ["add", "--all"], ["commit", "--quiet", "--message", "as it was cloned"]):
        git(folder, *arguments)
    return folder


def git(folder: Path, *arguments: str) -> str:
    """Calls git there, as somebody; gives what it prints."""
    names = [f"GIT_{who}_{what}" for who in ("AUTHOR", "COMMITTER") for what in ("NAME", "EMAIL")]
    environment = {**os.environ, **dict.fromkeys(names, "a")}
    done = subprocess.run(["git", *arguments], cwd=folder, env=environment, capture_output=True, text=True, check=True)
    return done.stdout


def section(name: str) -> Iterator[Block]:
    """The fenced blocks of a section of docs/extend.md, or of a page below it."""
    return (block for page in EXTEND for block in blocks(page) if block.section == name)


def insert(project: Path, block: Block) -> None:
    """Puts an entry where its title says: before the first thing that is less indented, or is there already."""
    file, _, place = block.title.partition(", ")
    lines = (project / file).read_text().split("\n")
    at = 0
    for key in [f"{'  ' * depth}{key}:" for depth, key in enumerate(place.split("."))]:
        at = next(number for number in range(at, len(lines)) if lines[number].split(" #")[0] == key) + 1
    indent = "  " * (place.count(".") + 1)
    while lines[at].startswith(indent) or lines[at].lstrip().startswith("#"):
        at += 1
    lines[at:at] = block.text.rstrip("\n").split("\n")
    (project / file).write_text("\n".join(lines))


def run(project: Path, command: str) -> str:
    """Runs a command of the page as a shell reads it, with this Python and nothing set up; gives what it printed."""
    command = re.sub(r"^\./rosml ", f"{sys.executable} src ", command)
    environment = {name: value for name, value in os.environ.items() if name != "ROSML_MATRIX"}
    argv = ["bash", "-c", command]
    done = subprocess.run(argv, cwd=project, env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0, f"{command}: {done.stdout}{done.stderr}"
    return f"$ {command}\n{done.stdout}{done.stderr}"


def follow(project: Path, name: str) -> str:
    """Follows a section of docs/extend.md, or of a page below it, block by block; gives what the commands printed."""
    output = ""
    for block in section(name):
        if block.title:
            insert(project, block)
        for command in commands(block) if block.language == "sh" else ():
            if not command.startswith(NEEDS_NETWORK):
                output += run(project, command)
    return output


def make_set(project: Path) -> str:
    """Makes a set of a fork, as docs/own-set.md says; gives what the commands printed."""
    [text] = [block.text for block in blocks(SET_PAGE) if block.title == "set.yaml"]
    (project / "set.yaml").write_text(text)
    return run(project, "./rosml generate")


def set_up(project: Path) -> None:
    """Installs uv and the Python packages in a clone, as the first call of ./rosml does."""
    argv = ["python3", "scripts/bootstrap.py", "python"]
    done = subprocess.run(argv, cwd=project, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr


def unit_tests(project: Path, *files: str, processes: int = 0) -> subprocess.CompletedProcess[str]:
    """Runs a project's unit tests, or some files of them, in a child process."""
    argv = [sys.executable, "-m", "pytest", "--quiet", "-o", "log_cli=false", *(files or ["tests/unit"])]
    argv += [f"--numprocesses={processes}"] if processes else []
    environment = {name: value for name, value in os.environ.items() if not name.startswith(("PYTEST_", "COV_"))}
    return subprocess.run(argv, cwd=project, env=environment, capture_output=True, text=True, check=False)
