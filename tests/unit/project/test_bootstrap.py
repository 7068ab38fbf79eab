"""What a bare Python does before `rosml setup`: uv, packages, the call itself; and what it does where these are lost."""

from __future__ import annotations

import json
import os
import re
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from conftest import ROOT

from rosml.cli.machine import setup
from tests.bare import Bootstrap

SETUP = """\
import json, os, sys
names = ("ROSML_UV", "ROSML_CA_BUNDLE", "PYTHONPATH")
print(json.dumps([sys.argv[1:], {name: os.environ.get(name) for name in names}]))
print("remains", file=sys.stderr)
sys.exit(int(os.environ.get("CODE", "0")))
"""
"""In the place of the package `rosml`: says how it was called."""


@pytest.fixture
def bare(tmp_path: Path) -> Bootstrap:
    return Bootstrap(tmp_path / "checkout")


@pytest.fixture
def ready(bare: Bootstrap, monkeypatch: pytest.MonkeyPatch) -> Bootstrap:
    for folder in ("src/rosml/cli", "tools", ".venv/bin", "mine", ".state"):
        (bare.root / folder).mkdir(parents=True)
    (bare.root / ".venv/bin/python").symlink_to(sys.executable)
    (bare.root / "src/__main__.py").write_text(SETUP)
    for name in ("src/rosml/__init__.py", "src/rosml/cli/__init__.py", "src/rosml/cli/main.py"):
        (bare.root / name).touch()
    uv(bare, "0.13.8")
    monkeypatch.setenv("PATH", str(bare.root / "mine"), prepend=os.pathsep)
    for name in ("ROSML_CA_BUNDLE", "SSL_CERT_FILE", "REQUESTS_CA_BUNDLE", "CURL_CA_BUNDLE"):
        monkeypatch.delenv(name, raising=False)
    return bare


def uv(bare: Bootstrap, version: str) -> Path:
    file = bare.root / "mine/uv"
    file.write_text(f'#!/bin/sh\n[ $1 = --version ] && echo uv {version} || echo "$@" >>{bare.root}/calls\n')
    file.chmod(0o755)
    return file


def test_its_commands_are_those_of_rosml(bare: Bootstrap) -> None:
    assert bare.module.COMMANDS.keys() - {"python"} == setup.main.commands.keys()


@pytest.mark.parametrize("arguments", [[], ["upp"]])
def test_wrong_usage(bare: Bootstrap, arguments: list[str]) -> None:
    done = bare(*arguments)
    assert (done.returncode, done.stdout) == (2, "")
    assert not (bare.root / ".state").exists()


@pytest.mark.parametrize(
    ("words", "group"),
    [
        ("up", "app"),
        ("suite", "page"),
        ("client", "app"),
        ("scanner", "app"),
        ("scanner --tests", "dev"),
        ("python", "app"),
        ("linters", "dev"),
        ("down", ""),
        ("status --json", ""),
    ],
)
def test_it_hands_over(ready: Bootstrap, words: str, group: str) -> None:
    done = ready(*words.split(), PYTHONPATH="/opt/ros", CODE="3")
    calls = (ready.root / "calls").read_text() if group else ""
    assert not group or calls.endswith(f" --require-hashes --no-build {ready.root}/tools/requirements-{group}.txt\n")
    if words == "python":
        assert (done.returncode, done.stdout) == (0, "")
        return
    uv = str(ready.root / "mine/uv") if group else ""
    called, environment = json.loads(done.stdout)
    assert called == ["setup", *words.split()]
    assert environment == {"ROSML_UV": uv, "ROSML_CA_BUNDLE": "", "PYTHONPATH": None}
    assert done.returncode == 3


def test_packages_of_somebody_who_may_not_write_to_the_checkout(ready: Bootstrap, tmp_path: Path) -> None:
    place = tmp_path / "cache"
    (place / ".venv").mkdir(parents=True)
    (ready.root / ".state").rmdir()
    done = ready("python", ROSML_PLACE=str(place))
    assert (done.returncode, done.stderr) == (0, "")
    assert f"Python packages: installing into {place}/.venv\n" in done.stdout
    venv_call, sync_call = (ready.root / "calls").read_text().splitlines()
    assert venv_call.endswith(f" {place}/.venv") and f" --python {place}/.venv/bin/python " in sync_call
    assert (place / ".venv/group").read_text() == "app" and not (ready.root / ".state").exists()
    (tmp_path / "file").touch()
    failed = ready("python", ROSML_PLACE=str(tmp_path / "file/cache"))
    assert failed.returncode == 1 and "remedy: name a folder that you may write to with XDG_CACHE_HOME" in failed.stderr


def test_only_one_set_up_at_a_time(ready: Bootstrap) -> None:
    (ready.root / "src/__main__.py").write_text("import time\nprint('begins', flush=True)\ntime.sleep(60)\n")
    argv = [sys.executable, str(ready.file), "up"]
    with subprocess.Popen(argv, stdout=subprocess.PIPE, text=True) as first:
        assert first.stdout and first.stdout.readline() == "begins\n"
        with subprocess.Popen(argv, stdout=subprocess.PIPE, text=True) as second:
            assert second.stdout
            assert second.stdout.readline() == "waiting for another setup of this checkout\n"
            first.kill()
            assert second.stdout.readline() == "begins\n"
            second.kill()


@pytest.mark.parametrize(
    ("version", "used"), [("0.9.0", True), ("0.10", True), ("1.0.1", True), ("0.8.24", False), ("", False)]
)
def test_a_uv_on_path_is_used_if_it_is_new_enough(
    ready: Bootstrap, capsys: pytest.CaptureFixture[str], version: str, used: bool
) -> None:
    file = uv(ready, version)
    assert ready.module.uv_on_path() == (str(file) if used else "")
    assert ("is older than v0.9: not used" in capsys.readouterr().out) is not used


def test_the_uv_of_state_is_not_the_machines(bare: Bootstrap, monkeypatch: pytest.MonkeyPatch) -> None:
    (bare.root / ".state/bin").mkdir(parents=True)
    (bare.root / "mine").mkdir()
    shutil.move(uv(bare, "9.9.9"), bare.root / ".state/bin/uv")
    monkeypatch.setenv("PATH", str(bare.root / ".state/bin"))
    assert bare.module.uv_on_path() == ""


def test_the_pinned_uv_is_installed_once(bare: Bootstrap, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    pip: list[list[str]] = []

    def run(what: str, argv: list[str], *_: object) -> None:
        pip.append(argv)
        (bare.root / ".state/tools/bin").mkdir(parents=True, exist_ok=True)
        (bare.root / ".state/tools/bin/uv").touch()

    (bare.root / "tools").mkdir()
    requirements = bare.root / "tools/requirements.txt"
    requirements.write_text("uv==1\n")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "file/no folder"))
    (tmp_path / "file").touch()
    monkeypatch.setattr(bare.module, "run", run)
    with bare.module.lock():
        for _ in range(2):
            assert bare.module.pinned_uv() == f"{bare.root}/.state/bin/uv"
        assert len(pip) == 2
        assert {"--require-hashes", "--no-deps", str(requirements)} <= set(pip[1])
        requirements.write_text("uv==2\n")
        bare.module.pinned_uv()
    assert len(pip) == 4


def test_the_pinned_uv_is_shared_with_other_checkouts(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """As long as it is of this user, and of the same pins."""
    installed: list[Path] = []
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))

    def uv_of(name: str, pins: str = "uv==1.2\n") -> str:
        bare = Bootstrap(tmp_path / name)
        (bare.root / "tools").mkdir()
        (bare.root / "tools/requirements.txt").write_text(pins)

        def install(_: Path, program: Path) -> None:
            program.write_text(f"of {name}")
            program.chmod(0o755)
            installed.append(bare.root)

        monkeypatch.setattr(bare.module, "install_uv", install)
        with bare.module.lock():
            program = Path(bare.module.pinned_uv())
        assert program == bare.root / ".state/bin/uv" and os.access(program, os.X_OK)
        assert [file.name for file in program.parent.iterdir() if file.name.endswith(".partial")] == []
        return program.read_text()

    assert [uv_of("one"), uv_of("two"), uv_of("other pins", "uv==1.2 \\\n")] == ["of one", "of one", "of other pins"]
    (kept, _) = sorted((tmp_path / "cache/rosml/tools").glob("uv-1.2-*"), key=lambda file: file.read_text())
    kept.chmod(0o777)
    assert uv_of("after others could write to it") == "of after others could write to it"
    kept.unlink()
    kept.symlink_to("/bin/true")
    assert uv_of("after a link") == "of after a link"
    assert len(installed) == 4


def test_uv_is_pinned_by_hash() -> None:
    text = (ROOT / "tools/requirements.txt").read_text()
    assert re.search(r"^uv==\d+\.\d+\.\d+ ", text, re.MULTILINE)
    assert text.count("--hash=sha256:") == 2
    assert "http" not in text


def test_the_users_certificates(ready: Bootstrap, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "ca.pem").touch()
    monkeypatch.setenv("SSL_CERT_FILE", str(tmp_path / "gone"))
    assert json.loads(ready("up").stdout)[1]["ROSML_CA_BUNDLE"] == ""
    monkeypatch.setenv("CURL_CA_BUNDLE", str(tmp_path / "ca.pem"))
    assert json.loads(ready("up").stdout)[1]["ROSML_CA_BUNDLE"] == str(tmp_path / "ca.pem")
    done = ready("up", ROSML_CA_BUNDLE=str(tmp_path / "gone"))
    assert (done.returncode, done.stdout) == (1, "")
    assert done.stderr.startswith(f"error: ROSML_CA_BUNDLE={tmp_path}/gone: no such file\nremedy: ")


def test_a_failure_of_uv_ends_it(ready: Bootstrap) -> None:
    (ready.root / "mine/uv").write_text(
        "#!/bin/sh\n[ $1 = --version ] && echo uv 1.0 && exit\nseq 30; echo no index >&2; exit 2\n"
    )
    done = ready("up")
    assert (done.returncode, done.stdout) == (1, "")
    assert done.stderr.startswith("error: Python packages: failed (exit code 2). The end of its log:\n    12\n")
    assert f"    no index\n  whole log: {ready.root}/.state/log/packages.log" in done.stderr


def test_packages_serve_other_calls_until_others_are_installed(ready: Bootstrap) -> None:
    """Calls that share a .venv start as long as it has its file `group`."""
    group = ready.root / ".venv/group"
    group.write_text("dev")
    seen = ready.root / "seen"
    called = f'#!/bin/sh\n[ $1 = --version ] && echo uv 1.0 && exit\n{{ cat {group}; echo " $2"; }} >>{seen} 2>&1'
    (ready.root / "mine/uv").write_text(f"{called}; exit 2\n")
    assert ready("python").returncode == 1
    assert group.read_text() == "dev", "a failure leaves them"
    (ready.root / "mine/uv").write_text(f"{called}\n")
    assert ready("suite").returncode == 0
    assert (seen.read_text(), group.read_text()) == ("dev sync\ndev sync\n", "page")


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_interrupted(ready: Bootstrap, number: signal.Signals) -> None:
    (ready.root / "mine/uv").write_text(
        f"#!/bin/sh\n[ $1 = --version ] && echo uv 1.0 && exit\necho $$ >{ready.root}/pid; exec sleep 60\n"
    )
    with subprocess.Popen([sys.executable, str(ready.file), "up"], stderr=subprocess.PIPE, text=True) as process:
        while not (ready.root / "pid").exists() or not (ready.root / "pid").read_text():
            time.sleep(0.01)
        process.send_signal(number)
        _, output = process.communicate(timeout=20)
    assert (process.returncode, output) == (130, "interrupted; call it again to carry on\n")
    waited_for = Path(f"/proc/{(ready.root / 'pid').read_text().strip()}")
    end = time.monotonic() + 20
    while waited_for.exists() and time.monotonic() < end:
        time.sleep(0.01)
    assert not waited_for.exists()


@pytest.mark.parametrize("name", [".state", ".state/log"])
def test_a_file_in_a_folders_place_is_named(bare: Bootstrap, name: str) -> None:
    (bare.root / name).parent.mkdir(exist_ok=True)
    (bare.root / name).write_text("")
    done = bare("up")
    assert done.returncode == 1
    assert done.stderr.startswith(f"error: {bare.root}/.state") and "remedy: let .state" in done.stderr


# ---- where packages are lost, or nothing was ever set up ---------------------------------------------------------------
def test_nothing_there(bare: Bootstrap) -> None:
    assert bare("down").stdout == "nothing was running\n"
    assert bare("clean").stdout == "nothing to remove\n"
    assert bare("status").stdout == "services  not up (rosml setup)\n"
    assert json.loads(bare("status", "--json").stdout)["up"] is False
    assert not (bare.root / ".state").exists()


def test_clean_removes_what_was_made(ready: Bootstrap) -> None:
    (ready.root / "mine.txt").touch()
    (ready.root / "src/__pycache__").mkdir()
    failed = ready("clean", CODE="1")
    assert failed.returncode == 1 and (ready.root / ".state").exists(), "something still runs"
    done = ready("clean")
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout.splitlines()[0])[0] == ["setup", "clean"]
    assert done.stdout.endswith(" GB\n")
    assert sorted(path.name for path in ready.root.iterdir()) == ["mine", "mine.txt", "scripts", "src", "tools"]
    assert not (ready.root / "src/__pycache__").exists()


@pytest.mark.parametrize("word", ["down", "clean"])
def test_services_that_outlived_the_packages_are_stopped(ready: Bootstrap, word: str) -> None:
    (ready.root / ".venv/bin/python").unlink()
    (ready.root / ".state/bin").mkdir()
    program = Path(shutil.copy(shutil.which("sleep") or "", ready.root / ".state/bin/registry"))
    with subprocess.Popen([program, "60"]) as service:
        done = ready(word)
        assert service.wait(10) == -signal.SIGTERM
    assert done.returncode == 0, done.stderr
    assert done.stdout.startswith("stopped: registry\n")
    assert (ready.root / ".state").exists() == (word == "down")


def test_what_cannot_be_removed_is_named(ready: Bootstrap, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(shutil, "rmtree", lambda *_, **__: None)
    with pytest.raises(ready.module.Failure) as caught:
        ready.module.clean()
    message, remedy = caught.value.args
    assert message == f"cannot remove all of {ready.root}/.state" and "sudo rm -rf" in remedy
