#!/usr/bin/env python3
"""Whether an app finds all that its programs, libraries and modules of Python need in an image.

    link.py OUT

OUT gets a line for each thing that it does not find, in JSON. Nothing of the app runs but the dynamic linker, and what its modules do
when they are imported, for `SECONDS` each.
"""

from __future__ import annotations

import ast
import importlib.util
import json
import os
import re
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Iterator

INSTALL = Path("/docker-ros/ws/install")
SECONDS = 60

LACKS = re.compile(r"undefined symbol: .*|.*=> not found|.*version `[^']*' not found.*|symbol lookup error: .*")
"""Lines of ldd about what is missing."""

ADDRESS = re.compile(r"\s*\(0x[0-9a-f]+\)|\t")
LINE = 500
SOURCE, STATEMENTS = 256 << 10, 20_000
"""The most bytes, and lines, of a file of Python that is parsed: a megabyte of short lines takes a gigabyte."""


def files() -> Iterator[Path]:
    """Programs and libraries."""
    for above, _, names in os.walk(INSTALL):
        for name in sorted(names):
            path = Path(above, name)
            if path.is_file() and not path.is_symlink():
                with open(path, "rb") as file:
                    if file.read(4) == b"\x7fELF":
                        yield path


def modules() -> Iterator[str]:
    """Those that entry points name."""
    names = set()
    for path in INSTALL.rglob("entry_points.txt"):
        for line in path.read_text("utf-8", "replace").split("\n"):
            target = line.partition("=")[2].partition("[")[0].strip()
            module = target.partition(":")[0].strip()
            if re.fullmatch(r"\w+(\.\w+)*", module):
                names.add(module)
    yield from sorted(names)


def sources() -> Iterator[Path]:
    """Scripts and modules of Python, also launch files."""
    for path in sorted(INSTALL.rglob("*")):
        if path.is_file() and not path.is_symlink():
            with open(path, "rb") as file:
                first = file.readline(LINE)
            if path.suffix == ".py" or re.match(rb"#!.*\bpython3?\b", first):
                yield path


def not_found() -> Iterator[str]:
    """Modules that a file imports in any case, and no folder of Python has. Nothing of them runs."""
    looked: dict[str, bool] = {}
    for path in sources():
        with open(path, "rb") as file:
            text = file.read(SOURCE + 1)
        if len(text) > SOURCE or text.count(b"\n") + text.count(b";") > STATEMENTS:
            continue
        try:
            body = ast.parse(text).body
        except (SyntaxError, ValueError, RecursionError, MemoryError):
            continue
        names = [item.name for line in body if isinstance(line, ast.Import) for item in line.names]
        names += [line.module for line in body if isinstance(line, ast.ImportFrom) and line.module and not line.level]
        for first in sorted({name.partition(".")[0] for name in names}):
            if first not in looked:
                # Not all that is loaded has a spec: __main__ has none.
                looked[first] = first in sys.modules or importlib.util.find_spec(first) is not None
            if not looked[first] and not any(path.parent.glob(f"{first}*")):  # a neighbour, which a script finds
                yield f"{path.relative_to(INSTALL)}: import {first}: there is no such module"


def called(command: list[str]) -> tuple[int, str]:
    """The exit code and the output of a program."""
    null, pipe, same = subprocess.DEVNULL, subprocess.PIPE, subprocess.STDOUT
    try:
        done = subprocess.run(command, stdin=null, stdout=pipe, stderr=same, timeout=SECONDS, check=False)
    except subprocess.TimeoutExpired:
        return 124, f"nothing for {SECONDS} s"
    except OSError as error:  # such as a name of a module that no call can have
        return 126, error.strerror or str(error)
    return done.returncode, done.stdout.decode("utf-8", "replace")


def linked(path: Path) -> list[str]:
    output = called(["ldd", "-r", str(path)])[1]
    name = str(path.relative_to(INSTALL))
    lines = (ADDRESS.sub("", line).strip() for line in output.split("\n"))
    return [f"{name}: {line[:LINE]}" for line in lines if LACKS.search(line)]


def imported(module: str) -> list[str]:
    code, output = called([sys.executable, "-c", f"import {module}"])
    lines = [line for line in output.split("\n") if line.strip()]
    return [f"import {module}: {lines[-1].strip()[:LINE] if lines else f'exit code {code}'}"] if code else []


def main(out: str) -> None:
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        problems = [line for lines in pool.map(linked, files()) for line in lines]
        problems += [line for lines in pool.map(imported, modules()) for line in lines]
    problems += not_found()
    text = "".join(json.dumps(line, ensure_ascii=True) + "\n" for line in sorted({*problems}))
    Path(out).write_text(text, encoding="ascii")


if __name__ == "__main__":
    main(sys.argv[1])
