#!/usr/bin/env python3
"""Prints what the structure tests found and writes `failed` into the report folder when something is wrong.

A test file without a report, or one with no tests in it, counts as a failure: silence is not success.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path


def failures(name: str, folder: Path) -> list[str]:
    """One line for each thing that went wrong in a test file."""
    report = folder / f"{name}.json"
    try:
        content = json.loads(report.read_text())
    except (OSError, ValueError):
        log = folder / f"{name}.log"
        return [f"{name}: no report: {log.read_text()[-400:] if log.exists() else 'the runner did not start'}"]
    if not content.get("Total"):
        return [f"{name}: no test ran"]
    print(f"{name}: {content['Pass']} passed, {content['Fail']} failed")
    return [
        f"{name}: {test['Name']}: {' '.join(test.get('Errors') or ['failed'])}\n{test.get('Stderr', '')[-3000:]}"
        for test in content["Results"]
        if not test["Pass"]
    ]


def main() -> None:
    folder, names = Path(sys.argv[1]), sys.argv[2:]
    lines = [line for name in names for line in failures(name, folder)]
    if lines:
        with (folder / "failed").open("a") as stream:
            stream.write("\n".join(lines) + "\n")
        print("\n".join(lines))


main()
