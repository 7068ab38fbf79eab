"""Scripts of a repository around the installation of dependencies: one shell, in which packages are installed between them."""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path

import pytest
from conftest import ROOT

from fakes.stubs import executable

FOLDER = ROOT / "components/containerize"
PASSWORD = "canary-77"


def run(
    tmp_path: Path, before: list[str], after: list[str], steps: str = "env; pwd"
) -> subprocess.CompletedProcess[str]:
    """Runs the scripts in an image with the variable SDK. `steps`: what installs packages."""
    here = tmp_path / "here"
    here.mkdir()
    (tmp_path / "secrets").mkdir()
    for name in ("server", "user", "password"):
        (tmp_path / f"secrets/git-https-{name}").write_text(PASSWORD)
    for name in ("image_variables.sh", "script_variables.sh"):
        shutil.copy(FOLDER / name, here)
    executable(here / "install_packages.sh", f"echo packages $*; {steps}")
    for kind, texts in (("before", before), ("after", after)):
        for number, text in enumerate(texts):
            (tmp_path / kind).mkdir(exist_ok=True)
            (tmp_path / kind / f"{number:04}").write_text(text)
    (tmp_path / "image").write_bytes(b"SDK=theirs\0HOME=/theirs\0")
    text = (FOLDER / "install.sh").read_text()
    functions = text[text.index("# run_scripts KIND") : text.index("use_mirror")].replace("/run/", f"{tmp_path}/")
    program = f"""shopt -s nullglob
fail() {{ echo "error: $1" >&2; exit 1; }}
scratch={tmp_path} here={here} before=({tmp_path}/before/*) after=({tmp_path}/after/*)
{functions}
run_scripts build exec
"""
    env = {"PATH": os.environ["PATH"], "IMAGE_ENVIRONMENT": str(tmp_path / "image"), "WORKSPACE": str(tmp_path / "ws")}
    command = ["bash", "-euo", "pipefail", "-c", program]
    return subprocess.run(command, env={**env, "HOME": "/root"}, capture_output=True, text=True, check=False)


def test_what_a_script_sets_and_its_folder_reach_what_follows(tmp_path: Path) -> None:
    """What it exports, for apt and pip; all, for the next script. Shell options are for scripts alone, as in docker-ros."""
    first = "export SET=by-script \nplain=variable\nset -u -o pipefail\ncd /usr"
    second = 'echo "next $SET $plain in $PWD of $0 on $SDK"'
    done = run(tmp_path, [first], [second], 'echo "$SET in $PWD$NONE"; env')
    assert done.returncode == 0, done.stderr
    lines = done.stdout.splitlines()
    assert lines[:2] == ["packages build exec", "by-script in /usr"]
    assert f"next by-script variable in /usr of {tmp_path}/ws/.install-dependencies.sh on theirs" in lines
    assert list((tmp_path / "ws").iterdir()) == []


def test_packages_are_installed_without_the_variables_of_the_image(tmp_path: Path) -> None:
    """They would change what apt and pip do. A script may set one of them again."""
    done = run(tmp_path, ["echo $SDK $HOME"], [])
    lines = done.stdout.splitlines()
    assert lines[0] == "theirs /theirs" and "HOME=/root" in lines and "SDK=theirs" not in lines
    shutil.rmtree(tmp_path)
    tmp_path.mkdir()
    assert "SDK=mine" in run(tmp_path, ["export SDK=mine"], []).stdout.splitlines()


def test_a_script_that_calls_exit_ends_alone(tmp_path: Path) -> None:
    """In docker-ros nothing would be installed, and no further script would run, without a word."""
    done = run(tmp_path, ["exit 0", "export KEPT=1; echo two"], ["echo three; exit", "echo four $KEPT"], "echo $KEPT")
    assert done.returncode == 0, done.stderr
    assert done.stdout.split("\n")[:5] == ["two", "packages build exec", "1", "three", "four"]
    assert done.stderr.count("called exit") == 2


@pytest.mark.parametrize(
    ("before", "after", "steps", "code", "says"),
    [
        ("(exit 3)", "echo never", "true", 1, "error: the script before the installation of dependencies ended with 3"),
        ("true", "set +e; false; exit 4", "true", 1, "error: the script after the installation of dependencies ended with 4"),
        ("set +e; false", "echo never", "exit 5", 5, ""),
    ],
)  # fmt: skip
def test_what_fails_ends_the_step(before: str, after: str, steps: str, code: int, says: str, tmp_path: Path) -> None:
    done = run(tmp_path, [before], [after], steps)
    assert (done.returncode, done.stderr.strip()) == (code, says) and "never" not in done.stdout


def test_only_scripts_have_the_password_for_git(tmp_path: Path) -> None:
    done = run(tmp_path, ["echo before $GIT_HTTPS_USER"], ["echo after $GIT_HTTPS_PASSWORD $GIT_HTTPS_SERVER"])
    lines = done.stdout.splitlines()
    assert lines[0] == f"before {PASSWORD}" and lines[-1] == f"after {PASSWORD} {PASSWORD}"
    assert PASSWORD not in "\n".join(lines[1:-1])
    kept = [path for path in tmp_path.rglob("*") if path.is_file() and path.parent.name != "secrets"]
    assert not [path for path in kept if PASSWORD in path.read_text()]
