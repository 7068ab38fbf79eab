#!/usr/bin/env python3
"""Compiles headers: each one alone, then all of them together in three orders, without a compiler for GPU code.

  compile.py [--fails FILE] [--rest] LIST -- FLAG...

LIST has one header a line, as a program names it, or a pattern of files below the flags' include folders. FILE has those that
do not compile, each with the reason: wrong if one of them does. A reason that begins with `together:` is of a header that compiles
alone, and not behind others. With --rest every other header below the include folders is
read as well, many at a time. A line of either file that begins with # says why.

Exits 1 if a header fails that FILE does not name, and says with which error.
"""

from __future__ import annotations

import argparse
import contextlib
import os
import random
import re
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

TOGETHER = 500
"""How many of the other headers are read at a time: most of them compile, and have much in common."""
SUFFIXES = (".h", ".hpp")


def lines(file: Path) -> list[str]:
    """What a file says, without comments."""
    return [line.strip() for line in file.read_text().splitlines() if line.strip() and not line.startswith("#")]


def folders(flags: list[str]) -> list[Path]:
    """The include folders of a compiler's flags."""
    return [Path(folder) for folder in re.findall(r"(?:-isystem|-I) ?(\S+)", " ".join(flags))]


def below(folder: Path) -> set[str]:
    """Headers below a folder, as a program names them. Links are followed: to files, and to folders of other packages."""
    found = set()
    for place, _, names in os.walk(folder, followlinks=True):
        inside = Path(place).relative_to(folder)
        found |= {str(inside / name) for name in names if name.endswith(SUFFIXES)}
    return found


def wanted(patterns: list[str], places: list[Path]) -> list[str]:
    """The headers that a list names, each once, in its order."""
    found: dict[str, None] = {}
    for pattern in patterns:
        names = [pattern]
        if "*" in pattern:
            matches = {str(file.relative_to(place)) for place in places for file in place.glob(pattern)}
            names = sorted(name for name in matches if name.endswith(SUFFIXES))
            if not names:
                sys.exit(f"compile: no header is called {pattern}")
        found.update(dict.fromkeys(names))
    return list(found)


def compiled(headers: list[str], flags: list[str]) -> tuple[bool, str]:
    """Whether a program that includes headers in this order compiles, and what the compiler said."""
    source = "".join(f"#include <{header}>\n" for header in headers)
    command = ["g++", "-std=c++17", "-fsyntax-only", "-w", "-x", "c++", *flags, "-"]
    done = subprocess.run(command, input=source, capture_output=True, text=True, errors="replace", check=False)
    return done.returncode == 0, done.stderr


def failure(headers: list[str], flags: list[str]) -> str:
    """The first error of a program that includes headers in this order; empty if it compiles."""
    well, said = compiled(headers, flags)
    if well:
        return ""
    errors = [line for line in said.splitlines() if "error" in line]
    return errors[0] if errors else f"g++ ended: {said[-200:]}"


def stand_in(places: list[Path], folder: Path) -> None:
    """Writes a file for each that a header includes and no include folder has: it only says so. A compiler ends at a file that is
    missing, and goes on behind this one. What the system has comes before it."""
    for place in places:
        for header in below(place):
            text = (place / header).read_text(encoding="utf-8", errors="replace")
            for name in re.findall(r'^[ \t]*#[ \t]*include[ \t]*[<"]([\w./+-]+)[>"]', text, re.MULTILINE):
                file = folder / name
                if ".." in name or file.exists() or any((other / name).exists() for other in places):
                    continue
                # One that is missing can be below another.
                with contextlib.suppress(FileExistsError, NotADirectoryError, IsADirectoryError):
                    file.parent.mkdir(parents=True, exist_ok=True)
                    file.write_text(f"#error {name} is missing\n")


def failing(headers: list[str], flags: list[str], missing: Path) -> dict[str, str]:
    """Those among many headers that do not compile alone, with their errors: all at a time, again without those that the
    compiler blames, which are read alone."""
    found: dict[str, str] = {}
    while headers:
        well, said = compiled(headers, [*flags, f"-idirafter{missing}"])
        if well:
            break
        blamed = {headers[int(number) - 1] for number in re.findall(r"(?:from |^)<stdin>:(\d+)", said, re.MULTILINE)}
        for header in sorted(blamed) or headers:
            if error := failure([header], flags):
                found[header] = error
        headers = [header for header in headers if header not in blamed] if blamed else []
    return found


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("list", type=Path)
    parser.add_argument("flags", nargs="+", metavar="FLAG")
    parser.add_argument("--fails", type=Path)
    parser.add_argument("--rest", action="store_true")
    options = parser.parse_args()
    flags, places = options.flags, folders(options.flags)
    known = dict(line.split(maxsplit=1) for line in lines(options.fails)) if options.fails else {}
    headers = wanted(lines(options.list), places)
    errors: dict[str, str] = {}
    with ThreadPoolExecutor(len(os.sched_getaffinity(0))) as pool:
        alone = pool.map(lambda header: (header, failure([header], flags)), headers)
        for number, (header, error) in enumerate(alone, 1):
            if number % 50 == 0:
                print(f"compile: {number} of {len(headers)} headers were read", flush=True)
            if error:
                errors[header] = error
                if header not in known:  # now, and again at the end: this takes a quarter of an hour
                    print(f"{header}: {error}", flush=True)
        apart = {header for header, why in known.items() if why.startswith("together:")}
        read = [header for header in headers if header not in errors and header not in apart]
        print(f"compile: {len(headers) - len(errors)} of {len(headers)} headers compile alone", flush=True)
        shuffled = random.Random(len(read)).sample(read, len(read))
        orders = {"in this order": read, "in the reverse order": read[::-1], "in another order": shuffled}
        for order, error in pool.map(lambda item: (item[0], failure(item[1], flags)), orders.items()):
            print(f"compile: all of them together {order}: {error or 'they compile'}", flush=True)
            if error:
                errors[f"all together {order}"] = error
        if options.rest:
            rest = sorted(set().union(*map(below, places)) - set(headers))
            usual = [header for header in rest if header not in known]
            groups = [usual[start : start + TOGETHER] for start in range(0, len(usual), TOGETHER)]
            groups += [[header] for header in rest if header in known]
            others: dict[str, str] = {}
            with tempfile.TemporaryDirectory() as folder:
                missing = Path(folder)
                stand_in(places, missing)
                for number, part in enumerate(pool.map(lambda group: failing(group, flags, missing), groups), 1):
                    others.update(part)
                    for header in sorted(set(part) - set(known)):
                        print(f"{header}: {part[header]}", flush=True)
                    if number % 10 == 0:
                        print(f"compile: {number} of {len(groups)} groups of other headers were read", flush=True)
            print(f"compile: {len(rest) - len(others)} of {len(rest)} other headers compile", flush=True)
            headers, errors = headers + rest, {**errors, **others}
    wrong = {header: error for header, error in errors.items() if header not in known or header in apart}
    for header, error in wrong.items():
        print(f"{header}\n  {error}")
    unneeded = [header for header in known if header in headers and header not in errors and header not in apart]
    unneeded += [
        header for header in known if header not in headers and not any((place / header).exists() for place in places)
    ]
    for header in unneeded:
        print(f"{header} compiles, or is not there: remove it from {options.fails}")
    sys.exit(1 if wrong or unneeded else 0)


if __name__ == "__main__":
    main()
