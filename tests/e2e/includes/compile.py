#!/usr/bin/env python3
"""Compiles headers: each one alone, then all of them together in three orders, without a compiler for GPU code.

  compile.py [--fails FILE] LIST -- FLAG...

LIST has one header a line, as a program names it, or a pattern of files below the flags' include folders. FILE has those that
do not compile, each with the reason: wrong if one of them does. A reason that begins with `together:` is of a header that compiles
alone, and not behind others. A line of either file that begins with # says why.

Exits 1 if a header fails that FILE does not name, and says with which error.
"""

from __future__ import annotations

import argparse
import os
import random
import re
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

SUFFIXES = (".h", ".hpp")


def lines(file: Path) -> list[str]:
    """What a file says, without comments."""
    return [line.strip() for line in file.read_text().splitlines() if line.strip() and not line.startswith("#")]


def folders(flags: list[str]) -> list[Path]:
    """The include folders of a compiler's flags."""
    return [Path(folder) for folder in re.findall(r"(?:-isystem|-I) ?(\S+)", " ".join(flags))]


def listed(patterns: list[str], places: list[Path]) -> list[str]:
    """The headers that a list names, each once, in its order."""
    headers: dict[str, None] = {}
    for pattern in patterns:
        names = [pattern]
        if "*" in pattern:
            matches = {str(file.relative_to(place)) for place in places for file in place.glob(pattern)}
            names = sorted(name for name in matches if name.endswith(SUFFIXES))
            if not names:
                sys.exit(f"compile: no header is called {pattern}")
        headers.update(dict.fromkeys(names))
    return list(headers)


def failure(headers: list[str], flags: list[str]) -> str:
    """The first error of a program that includes headers in this order; empty if it compiles."""
    source = "".join(f"#include <{header}>\n" for header in headers)
    command = ["g++", "-std=c++17", "-fsyntax-only", "-w", "-x", "c++", *flags, "-"]
    done = subprocess.run(command, input=source, capture_output=True, text=True, errors="replace", check=False)
    if done.returncode == 0:
        return ""
    errors = [line for line in done.stderr.splitlines() if "error" in line]
    return errors[0] if errors else f"g++ ended: {done.stderr[-200:]}"


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("list", type=Path)
    parser.add_argument("flags", nargs="+", metavar="FLAG")
    parser.add_argument("--fails", type=Path)
    options = parser.parse_args()
    flags, places = options.flags, folders(options.flags)
    failing = dict(line.split(maxsplit=1) for line in lines(options.fails)) if options.fails else {}
    headers = listed(lines(options.list), places)
    errors: dict[str, str] = {}
    with ThreadPoolExecutor(len(os.sched_getaffinity(0))) as pool:
        alone = pool.map(lambda header: (header, failure([header], flags)), headers)
        for number, (header, error) in enumerate(alone, 1):
            if number % 50 == 0:
                print(f"compile: {number} of {len(headers)} headers were read", flush=True)
            if error:
                errors[header] = error
                if header not in failing:  # now, and again at the end: this takes a quarter of an hour
                    print(f"{header}: {error}", flush=True)
        apart = {header for header, why in failing.items() if why.startswith("together:")}
        read = [header for header in headers if header not in errors and header not in apart]
        print(f"compile: {len(headers) - len(errors)} of {len(headers)} headers compile alone", flush=True)
        shuffled = random.Random(len(read)).sample(read, len(read))
        orders = {"in this order": read, "in the reverse order": read[::-1], "in another order": shuffled}
        for order, error in pool.map(lambda item: (item[0], failure(item[1], flags)), orders.items()):
            print(f"compile: all of them together {order}: {error or 'they compile'}", flush=True)
            if error:
                errors[f"all together {order}"] = error
    wrong = {header: error for header, error in errors.items() if header not in failing or header in apart}
    for header, error in wrong.items():
        print(f"{header}\n  {error}")
    unneeded = [header for header in failing if header in headers and header not in errors and header not in apart]
    unneeded += [
        header for header in failing if header not in headers and not any((place / header).exists() for place in places)
    ]
    for header in unneeded:
        print(f"{header} compiles, or is not there: remove it from {options.fails}")
    sys.exit(1 if wrong or unneeded else 0)


if __name__ == "__main__":
    main()
