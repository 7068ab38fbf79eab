"""The Makefile's variables reach the commands."""

from __future__ import annotations

import os
import re
import shlex
import subprocess
import sys

import pytest
from conftest import ROOT

from rosml.images.image_set import ImageSet

CALLS = {
    "locks STACK=cpu": "scripts/lock.py --stack=cpu",
    "locks UPGRADE=1": "scripts/lock.py --upgrade",
    "list JSON=1": "-m rosml list --json",
    "list GROUP=jazzy\\ torch": "-m rosml list jazzy torch",
    "locks REPORT=x.md": 'scripts/lock.py --report "$REPORT"',
    "publish ONLY=x": 'scripts/publish.py all --only "$ONLY" --registry "$PLACE" --since "$SINCE" --at-most "4" --serve "$SERVE"',
    "status": 'scripts/publish.py status --only "$ONLY" --registry "$PLACE"',
    "locks JSON=1": "scripts/lock.py --json",
    "explain TARGET=x JSON=1": '-m rosml explain --json -- "$TARGET"',
    "catalogue JSON=1": 'scripts/catalogue.py --only "$ONLY" --registry "$PLACE" --json',
    "catalogue OUTPUT=x": 'scripts/catalogue.py --only "$ONLY" --registry "$PLACE" --output "$OUTPUT"',
    "bench TARGET=x": 'python -m bench --target="$TARGET"',
    "plan JSON=1": 'scripts/generate_bake.py --shards "8" --json',
    "status JSON=1": 'scripts/publish.py status --only "$ONLY" --registry "$PLACE" --json',
    "unit": "python -m tests.suite --phase unit",
    "unit COVERAGE=1": "python -m tests.suite --phase unit --coverage",
    "page": "python -m tests.suite --phase page",
    "diff JSON=1": '-m rosml diff --json -- "$REV"',
}


@pytest.mark.parametrize("call", CALLS)
def test_variables_reach_the_command(call: str) -> None:
    argv = ["bash", "-c", f"make --dry-run {call}"]
    lines = subprocess.run(argv, cwd=ROOT, capture_output=True, text=True, check=True).stdout.splitlines()
    assert " ".join(lines[-1].replace("uv run --quiet ", "").split()) == CALLS[call]


def test_explain_knows_the_channel() -> None:
    here = ["BOOTSTRAP=:", f"RUN={shlex.quote(sys.executable)}"]  # without setting anything up
    argv = ["make", "--silent", "explain", "TARGET=jazzy-core", "CHANNEL=snapshot", "SNAPSHOT=2026-08-07"]
    told = subprocess.run([*argv, *here], cwd=ROOT, capture_output=True, text=True, check=True).stdout
    assert "this time, packages come from ROS's apt snapshot: of 2026-08-07" in told


def test_help_names_the_variables() -> None:
    told = subprocess.run(["make", "help"], cwd=ROOT, capture_output=True, text=True, check=True).stdout
    assert {
        name for name in ("TARGET", "GROUP", "REV", "SHARDS", "STACK", "UPGRADE", "JSON") if f"{name}=" in told
    } == {*("TARGET", "GROUP", "REV", "SHARDS", "STACK", "UPGRADE", "JSON")}


def test_a_registry_is_no_variable_of_the_bake_file() -> None:
    """Where images are published must not change what bake prints, least of all to nothing."""
    for given in ([], ["REGISTRY=ghcr.io/me/x"]):
        done = subprocess.run(
            ["make", "list", "BOOTSTRAP=:", 'RUN=echo "[$${REGISTRY-none}] $$PLACE"; :', *given],
            cwd=ROOT,
            env={name: value for name, value in os.environ.items() if name != "REGISTRY"},
            capture_output=True,
            text=True,
            check=True,
        )
        assert done.stdout.strip() == f"[none] {given[0].partition('=')[2] if given else ''}".strip()


# ---- What make prints ------------------------------------------------------------------------------------------------


WORDS = set(re.findall(r"^([a-z-]+):.*## ", (ROOT / "Makefile").read_text(), re.MULTILINE))


def test_commands_are_listed() -> None:
    told = subprocess.run(["make"], cwd=ROOT, capture_output=True, text=True, check=True).stdout
    assert set(re.findall(r"^  make ([a-z-]+) +\S", told, re.MULTILINE)) == WORDS
    assert "  make list         every image of the matrix, or those of groups\n" in told
    assert '                    make list GROUP="jazzy torch"; JSON=1\n' in told


@pytest.mark.parametrize(
    ("given", "wrong"),
    [
        ("imge", "imge"),
        ("image jazzy-base", "jazzy-base"),
        ("jazzy-base image", "jazzy-base"),
        ("up imge", "imge"),
        ("image TRAGET=x", "TRAGET"),
        ("image target=x", "target"),
        ("locks UPGARDE=1", "UPGARDE"),
        ("image PLATFORMS=linux/arm64", "PLATFORMS"),
    ],
)
@pytest.mark.parametrize("options", [[], ["--dry-run"]])
def test_a_slip_does_nothing(given: str, wrong: str, options: list[str]) -> None:
    """`make image jazzy-base` would build the default image, and then say that it knows no jazzy-base."""
    argv = ["make", *options, *given.split(), "BOOTSTRAP=echo set up", "RUN=echo run"]
    done = subprocess.run(argv, cwd=ROOT, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout) == (2, "")
    assert f"nothing was done: make has no command or variable {wrong}; see all with: make" in done.stderr


def test_what_the_makefile_reads_is_let_through() -> None:
    """A value may look like a slip."""
    text = (ROOT / "Makefile").read_text()
    ours = {
        name
        for pair in re.findall(r"^([A-Z_]+) (?:\?=|:=$)|\$\(if \$\(([A-Z_]+)\)", text, re.M)
        for name in pair
        if name
    }
    assert {"TARGET", "REV", "PLATFORM", "UPGRADE", "AT_MOST"} <= ours
    given = [f"{name}=" for name in sorted(ours)]
    given += [f"PATH={os.environ['PATH']}", "BOOTSTRAP=:", "SHELL=/bin/bash", "ROSML_DOCKER_HUB=0", "ONLY=x TRAGET=y"]
    done = subprocess.run(["make", "--dry-run", "list", *given], cwd=ROOT, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (0, "")


@pytest.mark.parametrize("word", sorted(WORDS))
def test_every_command_is_known(word: str) -> None:
    done = subprocess.run(["make", "--dry-run", word], cwd=ROOT, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (0, "")


# ---- Completion ------------------------------------------------------------------------------------------------------


def completed(*words: str, folder: str = str(ROOT)) -> list[str]:
    """What bash offers for the last word; it splits words at `=`."""
    script = (
        'source tools/completion.bash; cd "$FOLDER"; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); COMPREPLY=(); '
        "_rosml_make make; printf '%s\\n' \"${COMPREPLY[@]}\""
    )
    env = {**os.environ, "FOLDER": folder}
    argv = ["bash", "--norc", "-c", script, "bash", *words]
    return subprocess.run(argv, cwd=ROOT, env=env, capture_output=True, text=True, check=True).stdout.split()


def test_commands_are_completed() -> None:
    assert completed("make", "ex") == ["explain"]
    assert set(completed("make", "")) == WORDS


def test_targets_are_completed(real: ImageSet) -> None:
    assert set(completed("make", "image", "TARGET", "=")) == {image.target for image in real.images}
    assert completed("make", "image", "TARGET", "=", "trixie-core-tens") == [
        "trixie-core-tensorflow-cu128",
        "trixie-core-tensorflow-cpu",
    ]


def test_groups_and_stacks_are_completed(real: ImageSet) -> None:
    groups = set(completed("make", "list", "GROUP", "="))
    assert {*real.matrix.distributions, *real.matrix.components, *real.matrix.stacks} <= groups
    assert set(completed("make", "locks", "STACK", "=")) == {*real.matrix.stacks, "jazzy-wheels"}
    assert {"jazzy-desktop", "jazzy"} <= set(completed("make", "publish", "ONLY", "=", "jazzy"))


def test_other_folders_are_left_alone() -> None:
    assert completed("make", "ex", folder="/") == []
