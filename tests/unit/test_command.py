"""How every command ends: exit codes, messages and remedies, never a traceback."""

from __future__ import annotations

import errno
import os
import re
import signal
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import click
import pytest
from conftest import ROOT

from rosml import command, environment
from rosml.errors import RosmlError
from rosml.problems import InputError, Problem


@pytest.fixture(autouse=True)
def signals() -> Iterator[None]:
    """Puts back what commands do with signals."""
    before = signal.getsignal(signal.SIGTERM), signal.getsignal(signal.SIGINT)
    yield
    signal.signal(signal.SIGTERM, before[0])
    signal.signal(signal.SIGINT, before[1])


def ending(body: Callable[[], None]) -> click.Command:
    """A command that does nothing but end in some way."""
    return click.Command("x", callback=body, params=[click.Option(["--number"], type=int, expose_value=False)])


def raising(error: BaseException) -> click.Command:
    def body() -> None:
        raise error

    return ending(body)


def test_success(capsys: pytest.CaptureFixture[str]) -> None:
    assert command.run(ending(lambda: click.echo("done")), arguments=[]) == 0
    assert capsys.readouterr() == ("done\n", "")


@pytest.mark.parametrize(
    ("error", "code", "says"),
    [
        (RosmlError("no room"), 1, "error: no room\n"),
        (RosmlError("no room", "make some"), 1, "error: no room\nremedy: make some\n"),
        (RosmlError("no image 'x'", exit_code=2), 2, "error: no image 'x'\n"),
        (InputError("m.yaml", [Problem(4, 2, "a.b", "no 'c'")]), 2, "m.yaml:4:2: a.b: no 'c'\n"),
        (click.ClickException("odd"), 1, "Error: odd\n"),
        (KeyboardInterrupt(), 130, "what was finished is kept\n"),
        (click.Abort(), 130, "what was finished is kept\n"),
        (PermissionError(errno.EACCES, "Permission denied", "/x"), 1, "error: [Errno 13] Permission denied: '/x'\n"),
        (OSError(errno.ENOSPC, "No space left on device"), 1, "error: [Errno 28] No space left on device\n"),
    ],
)
def test_failures(error: BaseException, code: int, says: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert command.run(raising(error), "what was finished is kept", []) == code
    done = capsys.readouterr()
    assert done.out == ""
    assert done.err.lstrip("\n") == says


@pytest.mark.parametrize("arguments", [["--nmber"], ["--number", "x"], ["extra"]])
def test_wrong_usage(arguments: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert command.run(ending(lambda: None), arguments=arguments) == 2
    assert "Usage: " in capsys.readouterr().err


def test_a_bug_is_not_hidden() -> None:
    with pytest.raises(ZeroDivisionError):
        command.run(raising(ZeroDivisionError()), arguments=[])


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_signals(number: signal.Signals, capsys: pytest.CaptureFixture[str]) -> None:
    signal.signal(signal.SIGINT, signal.default_int_handler)
    signal.signal(signal.SIGTERM, signal.SIG_IGN)  # a command that does not listen must not end the tests
    assert command.run(ending(lambda: os.kill(os.getpid(), number)), "kept", []) == 130
    assert capsys.readouterr().err.strip() == "kept"


@pytest.mark.parametrize("script", ["bench", "generate_bake", "lock", "publish"])
def test_outside_of_the_virtual_environment(script: str) -> None:
    """Without any packages: before the first of them is imported, wherever that is."""
    argv = [sys.executable, "-S", str(ROOT / f"scripts/{script}.py"), "--help"]
    done = subprocess.run(argv, capture_output=True, text=True, check=False)
    told = f"run it with: uv run scripts/{script}.py (click, pydantic, rich, yaml, zstandard: not installed)\n"
    assert (done.returncode, done.stdout, done.stderr) == (2, "", told)


def test_every_command_looks_for_its_packages() -> None:
    scripts = [file for file in (ROOT / "scripts").glob("*.py") if "import click" in file.read_text()]
    assert [file.name for file in scripts if "\nimport rosml.environment  # noqa" not in file.read_text()] == []


def test_what_is_looked_for_is_what_the_project_asks_for() -> None:
    asked = re.findall(r"^dependencies = \[(.*)\]", (ROOT / "pyproject.toml").read_text(), re.M)[0]
    names = {word.partition("==")[0].strip(' "').lower() for word in asked.split(",")}
    assert {name.replace("pyyaml", "yaml") for name in names} == set(environment.REQUIRED)


def test_reader_of_our_output_is_gone(tmp_path: Path) -> None:
    script = tmp_path / "x.py"
    script.write_text(
        f"import sys; sys.path.insert(0, {str(ROOT)!r})\n"
        "import click; from rosml import command\n"
        "@click.command()\n"
        "def main() -> None:\n"
        "    for _ in range(100_000): click.echo('line')\n"
        "sys.exit(command.run(main))\n"
    )
    pipe = f"set -o pipefail; '{sys.executable}' '{script}' | head -1"
    done = subprocess.run(["bash", "-c", pipe], capture_output=True, text=True, check=False, timeout=30)
    assert (done.returncode, done.stdout, done.stderr) == (0, "line\n", "")


@pytest.mark.parametrize(
    "shell", ['"$0" "$1" >&-', 'PYTHONIOENCODING=latin-1 "$0" "$1"', 'LC_ALL=C PYTHONUTF8=0 "$0" "$1"']
)
def test_output_that_is_closed_or_knows_few_letters(shell: str, tmp_path: Path) -> None:
    script = tmp_path / "x.py"
    script.write_text(
        f"import sys; sys.path.insert(0, {str(ROOT)!r})\n"
        "import click; from rosml import command\n"
        "@click.command()\n"
        "def main() -> None: click.echo('a → b')\n"
        "sys.exit(command.run(main))\n"
    )
    done = subprocess.run(["bash", "-c", shell, sys.executable, script], capture_output=True, check=False, timeout=30)
    assert (done.returncode, done.stderr) == (0, b"")
    assert done.stdout in (b"", b"a \\u2192 b\n", "a → b\n".encode())


def test_a_command_that_works_says_that_its_reader_is_gone() -> None:
    """`make image | head` is not done when head is."""
    code = (
        "import sys, click; from rosml import command\n"
        "work = click.Command('work', callback=lambda: (_ for _ in ()).throw(BrokenPipeError))\n"
        "sys.exit(command.run(work, arguments=[], reader_gone=command.BROKEN_PIPE))"
    )
    env = {**os.environ, "PYTHONPATH": str(ROOT)}
    done = subprocess.run([sys.executable, "-c", code], env=env, capture_output=True, check=False)
    assert (done.returncode, done.stderr) == (141, b"")
