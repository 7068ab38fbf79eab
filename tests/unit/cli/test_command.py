"""How every command ends: exit codes, messages and remedies, never a traceback."""

from __future__ import annotations

import errno
import json
import os
import re
import shlex
import signal
import subprocess
import sys
import tomllib
from collections.abc import Callable, Iterator
from pathlib import Path

import click
import pytest
from conftest import ROOT

from bench import cli as bench
from fakes.stubs import on_a_terminal
from fakes.workflows import accepted
from rosml.base import environment
from rosml.base.errors import RosmlError
from rosml.base.problems import InputError, Problem
from rosml.cli import command, main
from scripts import docs, requirements


@pytest.fixture(autouse=True)
def signals() -> Iterator[None]:
    before = signal.getsignal(signal.SIGTERM), signal.getsignal(signal.SIGINT)
    yield
    signal.signal(signal.SIGTERM, before[0])
    signal.signal(signal.SIGINT, before[1])


def ending(body: Callable[[], None]) -> click.Command:
    return click.Command("x", callback=body, params=[click.Option(["--number"], type=int, expose_value=False)])


def raising(error: BaseException) -> click.Command:
    def body() -> None:
        raise error

    return ending(body)


KEPT = "what was finished is kept"


@pytest.mark.parametrize(
    ("error", "code", "message", "remedy"),
    [
        (RosmlError("no room", "make some"), 1, "no room", "make some"),
        (RosmlError("no image 'x'", exit_code=2), 2, "no image 'x'", ""),
        (InputError("m.yaml", [Problem(4, 2, "a.b", "no 'c'")]), 2, "m.yaml:4:2: a.b: no 'c'", ""),
        (click.ClickException("odd"), 1, "odd", "see --help"),
        (KeyboardInterrupt(), 130, KEPT, "run it again"),
        (click.Abort(), 130, KEPT, "run it again"),
        (
            PermissionError(errno.EACCES, "denied", "/x"),
            1,
            "/x: denied",
            "run it as a user with access, or give this one access",
        ),
        (OSError(errno.EIO, "Input/output error"), 1, "Input/output error", ""),
        (UnicodeDecodeError("utf-8", b"abc\xff", 3, 4, "x"), 1, "a file is not UTF-8, after 'abc'", ""),
    ],
)
def test_failures(
    error: BaseException, code: int, message: str, remedy: str, capsys: pytest.CaptureFixture[str]
) -> None:
    failing = raising(error)
    assert command.run(failing, KEPT, []) == code
    done = capsys.readouterr()
    assert done.out == "" and message in done.err
    assert ("remedy: " in done.err) == (
        bool(remedy) and not isinstance(error, KeyboardInterrupt | click.exceptions.Abort | click.ClickException)
    )
    failing.params.append(click.Option(["--json"], is_flag=True, expose_value=False))
    assert command.run(failing, KEPT, ["--json"]) == code
    done = capsys.readouterr()
    assert json.loads(done.out) == {"error": message, "remedy": remedy} and message in done.err


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


@pytest.mark.parametrize(
    ("called", "remedy"),
    [("src", "rm -r .venv, then call it again"), ("scripts/generate_bake.py", "run this with .venv/bin/python")],
)
def test_outside_of_the_virtual_environment(called: str, remedy: str) -> None:
    """Without any packages: before the first of them is imported, wherever that is."""
    done = subprocess.run(
        [sys.executable, "-S", called, "--help"], cwd=ROOT, capture_output=True, text=True, check=False
    )
    lacking = ", ".join((*environment.RUN, *environment.IMAGES))
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr.startswith(f"error: not installed: {lacking}\nremedy: {remedy}")


def all_commands(command: click.Command, name: str) -> Iterator[tuple[str, click.Command]]:
    yield name, command
    for inner, subcommand in command.commands.items() if isinstance(command, click.Group) else ():
        yield from all_commands(subcommand, f"{name} {inner}")


COMMANDS = {
    name: subcommand
    for word in ("catalogue", "generate", "join", "locks", "publish")
    for name, subcommand in all_commands(main.cli.commands[word], f"rosml {word}")
} | {"docs.py": docs.main, "requirements.py": requirements.main, "python -m bench": bench.main}
PROGRAMS = {"rosml ": main.cli, "scripts/docs.py": COMMANDS["docs.py"], "python -m bench": bench.main}
PROGRAMS["scripts/requirements.py"] = COMMANDS["requirements.py"]


@pytest.mark.parametrize("name", COMMANDS)
def test_help_has_an_example(name: str) -> None:
    text = COMMANDS[name].get_help(click.Context(COMMANDS[name], info_name=name, **COMMANDS[name].context_settings))
    _, heading, examples = text.partition("Example")
    assert heading, text
    lines = examples.partition("\n\n")[0].replace("\\\n", " ").splitlines()[1:]
    shown = [line.strip().removeprefix("uv run ") for line in lines]
    calls = [
        (program, line.removeprefix(program)) for line in shown for program in PROGRAMS if line.startswith(program)
    ]
    assert calls
    for program, rest in calls:
        accepted(PROGRAMS[program], shlex.split(re.split(r"  +", rest)[0]))


@pytest.mark.parametrize(("words", "meant"), [(["imge"], "image"), (["publish", "undoo"], "undo")])
def test_a_command_that_is_mistyped(words: list[str], meant: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert command.run(main.cli, arguments=words) == 2
    assert re.search(f"Did you mean .*'{meant}'", capsys.readouterr().err)


@pytest.mark.parametrize(
    ("words", "remedy"),
    [
        (["up"], "rosml setup"),
        (["search", "jazzy"], "rosml list"),
        (["publish", "image", "x"], "rosml image"),
        (["publish", "join"], "rosml publish join-images"),
        (["stop"], "docker stop, for a container; rosml setup down, for the local registry and the builder"),
    ],
)
def test_a_command_that_is_elsewhere(words: list[str], remedy: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert command.run(main.cli, arguments=words) == 2
    assert capsys.readouterr().err.replace("./rosml", "rosml").endswith(f"It is: {remedy}\n")


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["--list"], "No such option '--list'. Options of a command stand after it."),
        (["--registry", "x", "list"], "No such option '--registry'. Options of a command stand after it."),
        (["--qiet", "list"], "Did you mean '--quiet'?"),
        (["status", "ghcr.io/me/rosml"], "a registry stands after --registry."),
        (["status", "--registry", "ghcr.io/me/rosml", "jazzy-base"], "names of images stand after --only, and "),
        (["explain", "jazzy", "torch"], "it is one name, such as jazzy-base-torch-cu130"),
    ],
)
def test_words_at_a_wrong_place(words: list[str], message: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert command.run(main.cli, arguments=words) == 2
    assert message in capsys.readouterr().err


@pytest.mark.parametrize(
    ("words", "shows"), [(["help"], "Run images:"), (["help", "publish", "undo"], "undo [OPTIONS]")]
)
def test_help_is_a_word_too(words: list[str], shows: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert command.run(main.cli, arguments=words) == 0
    assert shows in capsys.readouterr().out


def test_every_message_passes_through_the_helper(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(command, "call", lambda: "/opt/rosml/rosml")
    failing = raising(RosmlError("no lock: run 'rosml locks'", "or: rosml list"))
    failing.params.append(click.Option(["--json"], is_flag=True, expose_value=False))
    assert command.run(failing, "", ["--json"]) == 1
    command.warn("no services", "rosml setup")
    done = capsys.readouterr()
    assert json.loads(done.out) == {
        "error": "no lock: run '/opt/rosml/rosml locks'",
        "remedy": "or: /opt/rosml/rosml list",
    }
    assert done.err.splitlines()[:2] == [f"error: {json.loads(done.out)['error']}", "remedy: or: /opt/rosml/rosml list"]
    assert done.err.endswith("warning: no services\nremedy: /opt/rosml/rosml setup\n")
    assert command.run(main.cli, arguments=["up"]) == 2
    assert capsys.readouterr().err.endswith("It is: /opt/rosml/rosml setup\n")
    assert command.run(main.cli, arguments=["explain", "jazzy"]) == 0
    assert capsys.readouterr().out.endswith("see them with: /opt/rosml/rosml list jazzy\n")
    assert command.run(main.cli, arguments=["list", "onnx"]) == 0
    assert capsys.readouterr().out.endswith("test onnx: /opt/rosml/rosml explain onnx\n")


def test_a_quiet_command_prints_its_result_and_its_error(capfd: pytest.CaptureFixture[str]) -> None:
    def body() -> None:
        command.say("what begins")
        subprocess.run(["sh", "-c", "echo a program >&2"], check=True)
        click.echo("the result")
        raise RosmlError("it failed", "mend it")

    main.cli.add_command(ending(body), "loud")
    try:
        assert command.run(main.cli, arguments=["-q", "loud"]) == 1
        assert capfd.readouterr() == ("the result\n", "error: it failed\nremedy: mend it\n")
    finally:
        del main.cli.commands["loud"]


@pytest.mark.parametrize(("no_color", "coloured"), [("", True), ("1", False)])
def test_colour_on_a_terminal_only(no_color: str, coloured: bool) -> None:
    code = program("click.echo(click.style('==> work', bold=True)); raise OSError('no room')")[2]
    returned, output = on_a_terminal(code, env={**PATH, "NO_COLOR": no_color, "TERM": "xterm"})
    assert returned == 1 and b"==> work" in output and b"no room" in output
    assert (b"\x1b[" in output) == coloured


LOOKS = re.compile(r"\n(import rosml\.base\.environment  # noqa|from rosml\.__main__ import run\n)")


def test_every_command_looks_for_its_packages() -> None:
    scripts = [file for file in (ROOT / "scripts").glob("*.py") if file.name != "bootstrap.py"]
    assert [file.name for file in scripts if not LOOKS.search(file.read_text())] == []


def test_what_is_looked_for_is_what_the_project_asks_for() -> None:
    """A package's name on the index, and in Python."""
    modules = {"pyyaml": "yaml", "backports.zstd": environment.ZSTD, "packageurl-python": "packageurl"}
    modules["cyclonedx-python-lib"] = "cyclonedx"
    dependencies = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]["dependencies"]
    names = [item.lower().partition("==")[0] for item in dependencies]
    assert [modules.get(name, name) for name in names] == [*environment.RUN, *environment.IMAGES]


def program(body: str, run: str = "") -> list[str]:
    """The words that start Python with a command of its own."""
    code = f"import sys, click; from rosml.cli import command\ndef body() -> None:\n    {body}\n"
    return [sys.executable, "-c", f"{code}sys.exit(command.run(click.Command('x', callback=body), arguments=[]{run}))"]


PATH = {**os.environ, "PYTHONPATH": f"{ROOT}/src"}


def test_reader_of_our_output_is_gone() -> None:
    pipe = f"set -o pipefail; {shlex.join(program('for _ in range(100_000): click.echo(1)'))} | head -1"
    done = subprocess.run(["bash", "-c", pipe], env=PATH, capture_output=True, text=True, check=False, timeout=30)
    assert (done.returncode, done.stdout, done.stderr) == (0, "1\n", "")


@pytest.mark.parametrize("more", [[], ["--json"]])
def test_output_on_a_full_disk(more: list[str]) -> None:
    argv = [sys.executable, "src", "list", *more]
    with open("/dev/full", "w") as full:
        done = subprocess.run(argv, cwd=ROOT, stdout=full, stderr=subprocess.PIPE, text=True, check=False)
    assert done.returncode == 1
    assert re.fullmatch("error: No space left on device\nremedy: free some disk space .*\n", done.stderr)


@pytest.mark.parametrize("more", ["", "--json", "--json 2>&-"])
def test_output_that_is_closed(more: str) -> None:
    call = f'"$0" -m rosml list {more} >&-'
    done = subprocess.run(["bash", "-c", call, sys.executable], cwd=ROOT, capture_output=True, text=True, check=False)
    assert done.returncode == 1
    if "2>&-" not in more:
        assert re.fullmatch("error: standard output is closed.*\nremedy: send it .*\n", done.stderr)


@pytest.mark.parametrize("number", [1, 2])
def test_no_file_gets_the_number_of_closed_output(number: int) -> None:
    argv = program(f"sys.exit(open({os.devnull!r}).fileno() == {number})")
    assert subprocess.run(["bash", "-c", f"{shlex.join(argv)} {number}>&-"], env=PATH, check=False).returncode == 0


@pytest.mark.parametrize("variables", [{"PYTHONIOENCODING": "latin-1"}, {"LC_ALL": "C", "PYTHONUTF8": "0"}])
def test_output_that_knows_few_letters(variables: dict[str, str]) -> None:
    argv = program("click.echo('a \\u2192 b')")
    done = subprocess.run(argv, env=PATH | variables, capture_output=True, check=False, timeout=30)
    assert (done.returncode, done.stderr) == (0, b"")
    assert done.stdout in (b"a \\u2192 b\n", "a → b\n".encode())


def test_a_command_that_works_says_that_its_reader_is_gone() -> None:
    """`make image | head` is not done when head is."""
    argv = program("raise BrokenPipeError", ", reader_gone=command.BROKEN_PIPE")
    done = subprocess.run(argv, env=PATH, capture_output=True, check=False)
    assert (done.returncode, done.stderr) == (141, b"")


@pytest.mark.parametrize(
    ("work", "says"),
    [
        (lambda folder: (folder / "a/x/y").mkdir(parents=True), "{}/a is in the way: a folder is needed there"),
        (lambda folder: (folder / "a/x").write_text("x"), "{}/a is in the way: a folder is needed there"),
        (lambda folder: (folder / "b").write_text("x"), "{}/b is in the way: it is a folder, and a file is needed"),
        (lambda folder: (folder / "c").read_text(), "{}/c: No such file or directory"),
    ],
)
def test_what_is_in_the_way_is_named(
    work: Callable[[Path], object], says: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """As where `.state/log` is a file."""
    (tmp_path / "a").write_text("a file")
    (tmp_path / "b").mkdir()
    assert command.run(click.Command("x", callback=lambda: work(tmp_path)), arguments=[]) == 1
    err = capsys.readouterr().err
    assert err.startswith("error: " + says.format(tmp_path)) and "Errno" not in err


def test_a_message_does_not_quote_a_label_of_megabytes(capsys: pytest.CaptureFixture[str]) -> None:
    for words in ([], ["--json"]):
        failing = raising(RosmlError(f"its label is {'x' * 2_000_000}", "y" * 2_000_000))
        failing.params.append(click.Option(["--json"], is_flag=True, expose_value=False))
        command.run(failing, "", words)
        done = capsys.readouterr()
        assert len(done.out + done.err) < 50_000 and "characters more)" in done.err
