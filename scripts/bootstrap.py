#!/usr/bin/env python3
"""Starts `rosml setup` from a bare Python: finds or installs uv, installs Python packages with it, and hands over."""

from __future__ import annotations

import argparse
import fcntl
import hashlib
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from types import FrameType
from typing import TYPE_CHECKING, NoReturn

if TYPE_CHECKING:
    from rosml.machine.setup.tool_cache import ToolCache

if sys.version_info < (3, 9):  # noqa: UP036 (an old one may well call this)
    sys.exit("error: this needs Python 3.9 or newer, and this is {}.{}".format(*sys.version_info[:2]))

ROOT = Path(__file__).resolve().parent.parent
PLACE = Path(os.environ.get("ROSML_PLACE") or ROOT)
"""The folder of .state and .venv: the checkout, or a folder of somebody who may not write to it, as `rosml` names it."""

STATE, VENV = PLACE / ".state", PLACE / ".venv"
BIN, LOG, RUN = STATE / "bin", STATE / "log", STATE / "run"
PYTHON = VENV / "bin" / "python"
SOURCES = ROOT / "src"
OLDEST_UV = [0, 9]
OLDEST_PYTHON = "3.11"

GROUPS = ("app", "dev", "page")
"""Groups of Python packages, each with those before it: for the commands; for linters and tests; for the page's tests."""

COMMANDS = {
    **dict.fromkeys(
        ("python", "up", "tools", "emulate", "client", "regctl", "scanner", "signer", "engine", "room"), "app"
    ),
    "linters": "dev",
    **dict.fromkeys(("suite", "browser"), "page"),
    **dict.fromkeys(("down", "status", "clean"), ""),
}
"""The commands of `rosml setup`, and the group of packages that each needs; empty if the installed ones are enough."""

EPILOG = """\
Options and environment variables are those of `rosml setup`. `python` only installs uv and Python packages.

Examples:
  python3 scripts/bootstrap.py up
  python3 scripts/bootstrap.py status --json
"""


UNREACHED = "check the network and proxies (HTTPS_PROXY); a company's certificates go into ROSML_CA_BUNDLE; docs/registry/networks.md has more"


class Failure(Exception):
    """Setup cannot go on: a message and its remedy, which may be empty."""


def say(text: str) -> None:
    print(text, flush=True)


def output_of(*argv: str) -> str | None:
    """The output of a short command; None if it is missing, fails or hangs."""
    try:
        done = subprocess.run(argv, stdin=subprocess.DEVNULL, capture_output=True, text=True, timeout=20, cwd=ROOT)
    except (OSError, subprocess.TimeoutExpired):
        return None
    return done.stdout if done.returncode == 0 else None


@contextmanager
def interruptions_held() -> Iterator[None]:
    """Lets Ctrl-C and SIGTERM wait until the block is done. What the block starts gets them at once."""
    signals: list[int] = []
    handlers = {
        kind: signal.signal(kind, lambda number, _frame: signals.append(number))
        for kind in (signal.SIGINT, signal.SIGTERM)
    }
    try:
        yield
    finally:
        for kind, handler in handlers.items():
            signal.signal(kind, handler)
    if signals:
        raise KeyboardInterrupt


def run(what: str, argv: Sequence[str], log: Path, env: Mapping[str, str], remedy: str = "") -> None:
    started, devnull = time.monotonic(), subprocess.DEVNULL
    with log.open("w") as out:
        process = None
        try:
            with interruptions_held():  # or nobody would know the process that was started
                process = subprocess.Popen(argv, stdin=devnull, stdout=out, stderr=out, env=env, cwd=ROOT)
            while process.returncode is None:
                try:
                    process.wait(20)
                except subprocess.TimeoutExpired:
                    say(f"  {what}: still at work ({time.monotonic() - started:.0f} s)")
        finally:
            if process:
                process.terminate()  # if this was interrupted
                process.wait()
    if process.returncode:
        end = "".join(f"    {line}\n" for line in log.read_text(errors="replace").splitlines()[-20:])
        text = f"{what}: failed (exit code {process.returncode}). The end of its log:\n{end}  whole log: {log}"
        raise Failure(text, remedy)


def write(file: Path, text: str, mode: int = 0o644) -> None:
    """Writes a file at once: a reader sees the old text or the new one, never a part."""
    partial = file.with_name(f".{file.name}.{os.getpid()}")
    partial.write_text(text)
    partial.chmod(mode)
    partial.replace(file)


@contextmanager
def lock() -> Iterator[None]:
    """Lets one setup at a time work on this checkout. The process keeps the lock, also if it becomes another program."""
    try:
        for folder in (BIN, LOG, RUN):
            folder.mkdir(parents=True, exist_ok=True)
        stream = (RUN / "lock").open("a")
    except OSError as error:
        remedy = "let .state and what is in it be folders that this user may write to"
        if PLACE != ROOT:
            remedy = f"name a folder that you may write to with XDG_CACHE_HOME; or call {ROOT}/rosml once as its owner"
        raise Failure(f"{error.filename}: {error.strerror}", remedy) from None
    with stream:
        try:
            fcntl.flock(stream, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            say("waiting for another setup of this checkout")
            fcntl.flock(stream, fcntl.LOCK_EX)
        os.set_inheritable(stream.fileno(), True)
        yield


def ca_bundle() -> str:
    names = ("ROSML_CA_BUNDLE", "SSL_CERT_FILE", "REQUESTS_CA_BUNDLE", "CURL_CA_BUNDLE")
    paths = [path for path in (os.environ.get(name, "") for name in names) if os.path.isfile(path)]
    if (path := os.environ.get("ROSML_CA_BUNDLE", "")) and path not in paths:  # only this project reads this variable
        raise Failure(f"ROSML_CA_BUNDLE={path}: no such file", "set it to a file of PEM certificates, or unset it")
    return os.path.abspath(paths[0]) if paths else ""


def uv_on_path() -> str:
    """The user's own uv, if it is new enough; `.state/bin` does not count."""
    entries = os.environ.get("PATH", os.defpath).split(os.pathsep)
    path = shutil.which("uv", path=os.pathsep.join(entry for entry in entries if entry and Path(entry) != BIN))
    if path is None:
        return ""
    version = [int(part) for part in re.findall(r"\d+", output_of(path, "--version") or "")[:3]]
    if version >= OLDEST_UV:
        return path
    present, oldest = (".".join(map(str, numbers)) for numbers in (version, OLDEST_UV))
    say(f"uv: the one on PATH ({path}, v{present or '?'}) is older than v{oldest}: not used")
    return ""


def pinned_uv() -> str:
    requirements, program, stamp = ROOT / "tools" / "requirements.txt", BIN / "uv", BIN / ".uv.pin"
    pins = requirements.read_text()
    if program.exists() and stamp.exists() and stamp.read_text() == pins:
        return str(program)
    partial, key = BIN / f".uv.{os.getpid()}.partial", uv_key(pins)
    stamp.unlink(missing_ok=True)
    cache = tool_cache()
    if cache.take("uv", key, partial):
        say("uv: copied, as another checkout has installed it")
    else:
        install_uv(requirements, partial)
        cache.keep("uv", key, partial)
    partial.replace(program)
    write(stamp, pins)
    return str(program)


def uv_key(pins: str) -> str:
    """The version that the pins name, and a digest of all of them."""
    version = re.search(r"^uv==(\S+)", pins, re.MULTILINE)
    return f"{version[1] if version else '0'} {hashlib.sha256(pins.encode()).hexdigest()[:16]}"


def tool_cache() -> ToolCache:
    """The programs that the user's other checkouts have installed. Its module needs only Python itself."""
    sys.path.insert(0, str(SOURCES))
    from rosml import user_cache
    from rosml.machine.setup.tool_cache import ToolCache

    return ToolCache(user_cache() / "tools")


def install_uv(requirements: Path, program: Path) -> None:
    started, folder, log = time.monotonic(), STATE / "tools", LOG / "install-uv.log"
    env = {**os.environ, "PIP_DISABLE_PIP_VERSION_CHECK": "1", "PIP_NO_INPUT": "1", "DEBIAN_FRONTEND": "noninteractive"}
    env.update(PIP_USER="0", PIP_TARGET="", PIP_PREFIX="")  # the user's own settings would install it elsewhere
    if bundle := ca_bundle():
        env.setdefault("PIP_CERT", bundle)
    if output_of(sys.executable, "-c", "import ensurepip, venv") is None:
        say("this changes the system: installs the Debian package python3-venv (installs uv)")
        install = "apt-get update && apt-get install --yes --no-install-recommends python3-venv"
        run("python3-venv", ["sh", "-c", install], LOG / "apt.log", env, f"install it by hand: sudo sh -c '{install}'")
    say("uv: installing its Python package")
    run("uv", [sys.executable, "-m", "venv", "--clear", str(folder)], log, env)
    pip = [str(folder / "bin" / "python"), "-m", "pip", "install", "--require-hashes", "--no-deps", "--no-cache-dir"]
    run("uv", [*pip, "--requirement", str(requirements)], log, env, UNREACHED)
    os.replace(folder / "bin" / "uv", program)
    shutil.rmtree(folder, ignore_errors=True)
    say(f"uv: installed from its Python package in {time.monotonic() - started:.0f} s")


def packages(uv: str, group: str) -> None:
    """Installs the Python packages of `tools/requirements-<group>.txt` into `.venv`, and removes others.

    A larger group stays: otherwise a command would remove packages that running tests import. The file `group` changes last: `rosml` starts
    from the packages that it names as long as they are not older than their requirements, also while others come or if this is interrupted.
    """
    started, log = time.monotonic(), LOG / "packages.log"
    place = ".venv" if PLACE == ROOT else VENV
    env = {name: value for name, value in os.environ.items() if name not in ("UV_QUIET", "VIRTUAL_ENV", "UV_PYTHON")}
    env["UV_COMPILE_BYTECODE"] = "1"
    env.setdefault("UV_CACHE_DIR", str(STATE / "uv"))
    if bundle := ca_bundle():
        env["SSL_CERT_FILE"] = bundle
    fresh = output_of(str(PYTHON), "-c", "") is None
    if fresh:
        say(f"Python packages: installing into {place}")
        make = [uv, "venv", "--clear", "--no-project", "--python", f">={OLDEST_PYTHON}", str(VENV)]
        run("Python packages", make, log, env, UNREACHED)
    group_file = VENV / "group"
    installed = group_file.read_text() if group_file.exists() else ""
    group = max(group, installed if installed in GROUPS else group, key=GROUPS.index)
    # Only wheels: a build would fetch its own requirements, without hashes.
    sync = [uv, "pip", "sync", "--python", str(PYTHON), "--require-hashes", "--no-build"]
    run("Python packages", [*sync, str(ROOT / "tools" / f"requirements-{group}.txt")], log, env, UNREACHED)
    for folder in (VENV / "lib").glob("python3*/site-packages"):
        write(folder / "rosml.pth", f"{SOURCES}\n")  # so that tests and bench import rosml
    write(group_file, group)
    if fresh:
        say(f"Python packages: installed into {place} in {time.monotonic() - started:.0f} s")


def can_hand_over() -> bool:
    code = f"import sys; sys.path.insert(0, {str(SOURCES)!r}); import rosml.cli.main"
    return output_of(str(PYTHON), "-c", code) is not None


def hand_over(command: str, *options: str, uv: str = "", come_back: bool = False) -> int:
    """Becomes `rosml setup COMMAND`, or calls it and returns its exit code.

    ROSML_UV has the path of uv, and says that the packages are installed. The variables of a ROS workspace would change our Python's
    imports, so it removes them.
    """
    dropped = ("PYTHONPATH", "PYTHONHOME", "PYTHONOPTIMIZE", "PYTHONSAFEPATH")
    env = {name: value for name, value in os.environ.items() if name not in dropped}
    env.update(ROSML_UV=uv, ROSML_CA_BUNDLE=ca_bundle())
    with suppress(FileNotFoundError):  # a folder that is gone
        env["ROSML_CALLED_IN"] = os.getcwd()  # for messages that name the command
    argv = [str(PYTHON), str(SOURCES), "setup", command, *options]
    os.chdir(ROOT)
    if come_back:
        return subprocess.run(argv, env=env, check=False).returncode
    os.execve(argv[0], argv, env)


def stop() -> None:
    """Stops the services of this checkout if the packages for `rosml setup down` are lost."""
    stopped: dict[int, str] = {}
    for kind in (signal.SIGTERM, *[0] * 198, signal.SIGKILL):
        running = {}
        for file in Path("/proc").glob("[0-9]*/cmdline"):
            with suppress(FileNotFoundError, ProcessLookupError):  # the process ended meanwhile
                program = Path(os.fsdecode(file.read_bytes().partition(b"\0")[0]))
                if program in (BIN / "buildkitd", BIN / "registry"):
                    running[int(file.parent.name)] = program.name
                    os.kill(int(file.parent.name), kind)
        if not running:
            break
        stopped.update(running)
        time.sleep(0.1)
    (STATE / "services.json").unlink(missing_ok=True)
    say(f"stopped: {', '.join(sorted(stopped.values()))}" if stopped else "nothing was running")


def clean() -> int:
    if mounts := re.findall(rf" ({re.escape(str(STATE))}/\S*) ", Path("/proc/self/mounts").read_text()):
        raise Failure(f"still mounted: {', '.join(mounts)}", f"umount --lazy {mounts[-1]}")
    byte_code = [folder for name in ("src", "scripts", "tests") for folder in (ROOT / name).rglob("__pycache__")]
    before = shutil.disk_usage(ROOT).free
    folders = [folder for folder in (STATE, VENV, *byte_code) if folder.exists()]
    for folder in folders:
        if folder.name != "__pycache__":
            say(f"removing {folder}")
        shutil.rmtree(folder, ignore_errors=True)
        if folder.exists():
            raise Failure(f"cannot remove all of {folder}", f"remove it as the user who made it: sudo rm -rf {folder}")
    freed = max(0, shutil.disk_usage(ROOT).free - before) / 1e9
    say(f"freed {freed:.1f} GB" if folders else "nothing to remove")
    return 0


def work(command: str, options: Sequence[str]) -> int:
    if command == "status":
        if can_hand_over():
            return hand_over(command, *options)
        say(json.dumps({"state": str(STATE), "up": False}) if "--json" in options else "services  not up (rosml setup)")
        return 0
    if not sys.platform.startswith("linux"):
        raise Failure("setup needs Linux", "use a Linux machine, a virtual one, or WSL")
    if command == "clean" and not STATE.exists():
        return clean()
    if command == "down" and not STATE.exists():
        say("nothing was running")
        return 0
    with lock():
        if command in ("down", "clean"):
            if not can_hand_over():
                stop()
            elif code := hand_over(command, *options, come_back=True):
                return code
            return clean() if command == "clean" else 0
        uv = uv_on_path() or pinned_uv()
        packages(uv, "dev" if "--tests" in options else COMMANDS[command])
        return 0 if command == "python" else hand_over(command, *options, uv=uv)


def terminate(_number: int, _frame: FrameType | None) -> NoReturn:
    """Handles SIGTERM like Ctrl-C."""
    raise KeyboardInterrupt


def main(argv: Sequence[str]) -> int:
    """Returns the exit code: 0, 1 (failed), 2 (usage), 130 (interrupted)."""
    style = argparse.RawDescriptionHelpFormatter
    parser = argparse.ArgumentParser("rosml setup", description=__doc__, epilog=EPILOG, formatter_class=style)
    parser.add_argument("command", choices=COMMANDS, metavar="COMMAND", help=", ".join(COMMANDS))
    arguments, options = parser.parse_known_args(argv)
    signal.signal(signal.SIGTERM, terminate)
    try:
        return work(arguments.command, options)
    except (Failure, OSError) as error:
        message, remedy = error.args if isinstance(error, Failure) else (str(error), "")
        print(f"error: {message}" + (f"\nremedy: {remedy}" if remedy else ""), file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print("interrupted; call it again to carry on", file=sys.stderr)
        return 130


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
