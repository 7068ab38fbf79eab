"""The Makefile's variables reach the commands."""

from __future__ import annotations

import os
import shlex
import subprocess
import sys

import make_help
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
    "standing": 'scripts/publish.py status --only "$ONLY" --registry "$PLACE"',
    "locks JSON=1": "scripts/lock.py --json",
    "explain TARGET=x JSON=1": '-m rosml explain --json -- "$TARGET"',
    "catalogue JSON=1": 'scripts/catalogue.py --only "$ONLY" --registry "$PLACE" --json',
    "catalogue OUTPUT=x": 'scripts/catalogue.py --only "$ONLY" --registry "$PLACE" --output "$OUTPUT"',
    "bench TARGET=x": 'python -m bench --target="$TARGET"',
    "plan JSON=1": 'scripts/generate_bake.py --shards "8" --json',
    "standing JSON=1": 'scripts/publish.py status --only "$ONLY" --registry "$PLACE" --json',
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


def test_commands_are_in_groups() -> None:
    told = subprocess.run(["make"], cwd=ROOT, capture_output=True, text=True, check=True).stdout
    titles = [line for line in told.splitlines() if not line.startswith(" ")]
    assert titles == [*make_help.GROUPS, make_help.REST]
    assert "\x1b" not in told
    assert "  make list         every image of the matrix, or those of groups\n" in told
    assert '                   make list GROUP="jazzy torch"; JSON=1\n' in told


def test_no_group_names_what_there_is_not() -> None:
    named = {name for names in make_help.GROUPS.values() for name in names}
    assert named <= make_help.commands((ROOT / "Makefile").read_text()).keys()


@pytest.mark.parametrize(
    ("no_color", "term", "terminal", "coloured"),
    [("", "xterm", True, True), ("1", "xterm", True, False), ("", "dumb", True, False), ("", "xterm", False, False)],
)
def test_colour(no_color: str, term: str, terminal: bool, coloured: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("NO_COLOR", no_color)
    monkeypatch.setenv("TERM", term)
    assert make_help.coloured(terminal) == coloured
    assert ("\x1b[" in "".join(make_help.lines({"image": ("build", "make image")}, coloured))) == coloured


@pytest.mark.parametrize(
    ("given", "meant"),
    [("imge", "make image"), ("explian", "make explain"), ("tset", "make test"), ("xyzzy", "")],
)
@pytest.mark.parametrize("options", [[], ["--dry-run"]])
def test_a_command_that_is_mistyped(given: str, meant: str, options: list[str]) -> None:
    done = subprocess.run(["make", *options, given], cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == 2
    assert f"error: make has no command '{given}'" in done.stderr
    assert (f"did you mean {meant}" in done.stderr) == bool(meant)
    assert "remedy: see all with: make\n" in done.stderr


@pytest.mark.parametrize(
    ("goals", "meant"),
    [
        ("image jazzy-base", "make image TARGET=jazzy-base"),
        ("explain jazzy-robot", "make explain TARGET=jazzy-robot"),
        ("list jazzy", "make list GROUP=jazzy"),
        ("bench jazzy-base", "make bench TARGET=jazzy-base"),
        ("standing jazzy-base", ""),
        ("up imge", "make image"),
        ("jazzy-base image", "make image TARGET=jazzy-base"),
    ],
)
@pytest.mark.parametrize("options", [[], ["--dry-run"]])
def test_a_word_behind_a_command(goals: str, meant: str, options: list[str]) -> None:
    """`make image jazzy-base` would build the default image, and then say that it knows no jazzy-base."""
    argv = ["make", *options, *goals.split(), "BOOTSTRAP=echo set up", "RUN=echo run"]
    done = subprocess.run(argv, cwd=ROOT, capture_output=True, text=True, check=False)
    wrong = next(word for word in goals.split() if word in ("jazzy-base", "jazzy-robot", "jazzy", "imge"))
    assert (done.returncode, done.stdout) == (2, "")
    assert f"error: make has no command '{wrong}'" in done.stderr
    assert (f"; did you mean {meant}" in done.stderr) == bool(meant)
    assert "nothing was done" in done.stderr


@pytest.mark.parametrize(
    ("given", "meant"),
    [
        ("TRAGET=x", "TARGET="),
        ("target=x", "TARGET="),
        ("UPGARDE=1", "UPGRADE="),
        ("PLATFORMS=linux/arm64", "PLATFORM="),
    ],
)
@pytest.mark.parametrize("options", [[], ["--dry-run"]])
def test_a_variable_that_is_mistyped(given: str, meant: str, options: list[str]) -> None:
    """It would be nothing to make, and the default would be built."""
    argv = ["make", *options, "image", given, "BOOTSTRAP=:", "RUN=:"]  # whatever make thinks of it, nothing is built
    done = subprocess.run(argv, cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == 2
    assert f"error: make has no variable '{given.partition('=')[0]}'; did you mean {meant}?\n" in done.stderr
    assert "remedy: see commands with their variables: make\n" in done.stderr
    assert done.stdout == ""


def test_other_variables_are_let_through() -> None:
    """Ours, those that make has by itself, and what is like none; a value may look like a slip."""
    ours, known = make_help.variables(make_help.MAKEFILE.read_text())
    assert {"TARGET", "REV", "PLATFORM", "UPGRADE", "AT_MOST"} <= ours
    assert ours.isdisjoint({"PATH", "SHELL", "RUN", "BOOTSTRAP"})
    given = [f"{name}=" for name in sorted(ours)]
    given += [
        f"PATH={os.environ['PATH']}",
        "CC=gcc",
        "TARGET_ARCH=",
        "V=1",
        "BOOTSTRAP=:",
        "SHELL=/bin/bash",
        "ONLY=x TRAGET=y",
    ]
    done = subprocess.run(["make", "--dry-run", "list", *given], cwd=ROOT, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (0, "")
    assert all(not make_help.mistyped(name, make_help.MAKEFILE.read_text()) for name in known)


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
    assert set(completed("make", "")) == make_help.commands((ROOT / "Makefile").read_text()).keys()


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
