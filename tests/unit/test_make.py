"""The Makefile's variables reach the commands."""

from __future__ import annotations

import subprocess

import pytest
from conftest import ROOT

CALLS = {
    "locks STACK=cpu": "scripts/lock.py --stack=cpu",
    "locks UPGRADE=1": "scripts/lock.py --upgrade",
    "list JSON=1": "scripts/generate_bake.py --list --json",
    "list GROUP=jazzy\\ torch": "scripts/generate_bake.py --list --group=jazzy --group=torch",
    "bench TARGET=x": 'scripts/bench.py --target="$TARGET"',
    "plan JSON=1": 'scripts/generate_bake.py --shards "8" --json',
    "diff JSON=1": 'scripts/generate_bake.py --diff "$REV" --json',
}


@pytest.mark.parametrize("call", CALLS)
def test_variables_reach_the_command(call: str) -> None:
    argv = ["bash", "-c", f"make --dry-run {call}"]
    lines = subprocess.run(argv, cwd=ROOT, capture_output=True, text=True, check=True).stdout.splitlines()
    assert " ".join(lines[-1].split()) == f"uv run --quiet {CALLS[call]}"


def test_help_names_the_variables() -> None:
    told = subprocess.run(["make", "help"], cwd=ROOT, capture_output=True, text=True, check=True).stdout
    assert {
        name for name in ("TARGET", "GROUP", "REV", "SHARDS", "STACK", "UPGRADE", "JSON") if f"{name}=" in told
    } == {*("TARGET", "GROUP", "REV", "SHARDS", "STACK", "UPGRADE", "JSON")}
