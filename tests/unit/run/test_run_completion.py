"""What shells complete for `rosml run` and `rosml attach`: bash by typed keys, zsh and fish by the answers to them."""

from __future__ import annotations

import contextlib
import os
import pty
import subprocess
import sys
import time
from pathlib import Path

import pytest
from conftest import ROOT

DOCKER = """\
#!/bin/sh
case "$*" in
  "images --format {{.Repository}}:{{.Tag}}") printf 'ros:jazzy-base\\nros:jazzy-core\\nreg.test:5000/me/x:y\\n<none>:<none>\\n' ;;
  "ps --all --format {{.Names}}") printf 'robot\\nother\\n' ;;
  *) echo "unexpected: $*" >&2; exit 1 ;;
esac
"""


@pytest.fixture
def path(tmp_path: Path) -> Path:
    """A folder with `rosml` and a local replacement for docker."""
    for name, text in {"docker": DOCKER, "rosml": f'#!/bin/sh\nexec {sys.executable} {ROOT}/src "$@"\n'}.items():
        (tmp_path / name).write_text(text)
        (tmp_path / name).chmod(0o755)
    return tmp_path


def answer(path: Path, shell: str, instruction: str = "complete", **facts: str) -> list[str]:
    """The answer to a shell."""
    env = {"PATH": f"{path}:/usr/bin:/bin", "HOME": str(path), "_ROSML_COMPLETE": f"{shell}_{instruction}", **facts}
    done = subprocess.run(["rosml"], env=env, capture_output=True, text=True, check=True)
    assert done.stderr == ""
    return done.stdout.splitlines()


def completed(path: Path, line: str) -> list[str]:
    """The answer to fish for a line."""
    return answer(path, "fish", COMP_WORDS=line, COMP_CWORD=line.rpartition(" ")[2])


@pytest.mark.parametrize(
    ("line", "expected"),
    [
        ("rosml run ", ["plain,reg.test:5000/me/x:y", "plain,ros:jazzy-base", "plain,ros:jazzy-core"]),
        ("rosml run --privileged -e A=b ros:jazzy-c", ["plain,ros:jazzy-core"]),
        ("rosml run --no-g", ["plain,--no-gpu\tno GPUs"]),
        ("rosml run --export c", ["plain,compose"]),
        ("rosml run --export=c", ["plain,--export=compose"]),
        ("rosml run -itv ./a", ["file,./a"]),
        ("rosml run -e ros", [""]),
        ("rosml run --nonsense ros", [""]),
        ("rosml run ros:x --privi", ["file,--privi"]),
        ("rosml attach ro", ["plain,robot"]),
        ("rosml attach --wo", ["plain,--workdir"]),
        ("rosml attach --volu", [""]),
    ],
)
def test_how_a_word_goes_on(path: Path, line: str, expected: list[str]) -> None:
    assert completed(path, line) == expected


def test_zsh_is_told(path: Path) -> None:
    assert answer(path, "zsh", COMP_WORDS="rosml run ros:jazzy-b", COMP_CWORD="2") == ["plain", "ros:jazzy-base", "_"]
    containers = ["plain", "other", "_", "plain", "robot", "_"]
    assert answer(path, "zsh", COMP_WORDS="rosml attach ", COMP_CWORD="2") == containers
    assert any("compdef" in line for line in answer(path, "zsh", "source"))


@pytest.mark.parametrize("engine", ["exit 1", "sleep 60", None])
def test_an_engine_that_has_no_answer(path: Path, engine: str | None) -> None:
    (path / "docker").write_text(f"#!/bin/sh\n{engine}\n") if engine else (path / "docker").unlink()
    begun = time.monotonic()
    assert answer(path, "fish", COMP_WORDS="rosml run ", COMP_CWORD="", ROSML_ENGINE=str(path / "docker")) in ([], [""])
    assert time.monotonic() - begun < 10


def typed(path: Path, keys: str) -> str:
    """The words that bash gives to `rosml` after typed keys, with Tab for a `\t`, and Enter."""
    env = {"PATH": f"{path}:/usr/bin:/bin", "HOME": str(path), "TERM": "dumb", "INPUTRC": "/dev/null"}
    ours, theirs = pty.openpty()
    with subprocess.Popen(
        ["bash", "--norc", "--noprofile", "-i"], stdin=theirs, stdout=theirs, stderr=theirs, env=env, cwd=path
    ) as shell:
        os.close(theirs)
        begin = 'PS1=; eval "$(_ROSML_COMPLETE=bash_source rosml)"; rosml() { printf "<%s>" "$@"; echo; }\n'
        os.write(ours, f"{begin}rosml {keys}\nexit\n".encode())
        screen = b""
        with contextlib.suppress(OSError):  # bash has ended
            while part := os.read(ours, 4096):
                screen += part
        shell.wait(20)
    os.close(ours)
    return next(line for line in reversed(screen.decode().replace("\r", "").splitlines()) if line.startswith("<"))


@pytest.mark.parametrize(
    ("keys", "words"),
    [
        ("run ros:jazzy-b\tls", "<run><ros:jazzy-base><ls>"),
        ("run reg.test:50\tls", "<run><reg.test:5000/me/x:y><ls>"),
        ("run --export=com\tx", "<run><--export=compose><x>"),
        ("run -v ./do\tx", "<run><-v><./docker><x>"),
        ("att\trob\thtop", "<attach><robot><htop>"),
    ],
)
def test_bash_completes_what_somebody_types(path: Path, keys: str, words: str) -> None:
    assert typed(path, keys) == words
