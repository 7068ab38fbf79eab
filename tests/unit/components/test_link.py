"""What a step says that an app does not find: real programs, linked to libraries that lost something since."""

from __future__ import annotations

import json
import shutil
import subprocess
from pathlib import Path
from types import ModuleType

import pytest

from fakes.stubs import script_of_a_build
from rosml.base.errors import RosmlError
from rosml.containerize.rebase import trial

pytestmark = pytest.mark.skipif(not shutil.which("gcc"), reason="there is no compiler")


@pytest.fixture
def script(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    script = script_of_a_build("containerize/link.py")
    monkeypatch.setattr(script, "INSTALL", tmp_path / "install")
    return script


def compiled(folder: Path, name: str, source: str, *options: str) -> None:
    (folder / "source.c").write_text(source)
    subprocess.run(["gcc", "source.c", "-o", name, *options], cwd=folder, check=True)


def lines_of(script: ModuleType, tmp_path: Path) -> list[str]:
    script.main(str(tmp_path / "out"))
    return sorted(trial.lines((tmp_path / "out").read_bytes()))


def test_what_is_missing_is_named(script: ModuleType, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    libraries, install = tmp_path / "libraries", tmp_path / "install"
    for folder in (libraries, install / "lib", install / "robot.egg-info"):
        folder.mkdir(parents=True)
    compiled(libraries, "libone.so", "int one(void) { return 1; } int two(void) { return 2; }", "-shared", "-fPIC")
    compiled(libraries, "libgone.so", "int gone(void) { return 1; }", "-shared", "-fPIC")
    program = "int one(void); int two(void); int gone(void); int main(void) { return one() + two() + gone(); }"
    compiled(install / "lib", "node", program, f"-L{libraries}", f"-Wl,-rpath,{libraries}", "-lone", "-lgone")
    (install / "lib/text").write_text("no program\n")
    (install / "robot.egg-info/entry_points.txt").write_text(
        "[console_scripts]\ngood = json:main\nbad = robot_that_is_gone.node:main\nodd = 1; import os:x\n"
    )
    monkeypatch.delenv("LD_LIBRARY_PATH", raising=False)
    module = "import robot_that_is_gone.node: ModuleNotFoundError: No module named 'robot_that_is_gone'"
    assert lines_of(script, tmp_path) == [module]

    compiled(libraries, "libone.so", "int one(void) { return 1; }", "-shared", "-fPIC")
    (libraries / "libgone.so").unlink()
    lines = lines_of(script, tmp_path)
    assert module in lines and "lib/node: libgone.so => not found" in lines
    assert any(line.startswith("lib/node: undefined symbol: two") for line in lines)


def test_a_module_that_a_script_imports(script: ModuleType, tmp_path: Path) -> None:
    """catkin and ament install scripts that no entry point names. What is beside a script is found there."""
    folder = tmp_path / "install/lib/robot"
    folder.mkdir(parents=True)
    (folder / "node.py").write_text(
        "#!/usr/bin/env python3\nimport json, beside, robot_that_is_gone.a\nimport beside\n"
    )
    (folder / "beside.py").write_text("from robot_that_is_gone_too import b\n")
    (folder / "run").write_text("#!/bin/sh\nimport nothing\n")
    assert lines_of(script, tmp_path) == [
        "lib/robot/beside.py: import robot_that_is_gone_too: there is no such module",
        "lib/robot/node.py: import robot_that_is_gone: there is no such module",
    ]


def test_a_module_that_never_ends(script: ModuleType, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "install/x.egg-info").mkdir(parents=True)
    (tmp_path / "install/x.egg-info/entry_points.txt").write_text("[console_scripts]\na = waits:main\n")
    (tmp_path / "waits.py").write_text("import time\ntime.sleep(60)\n")
    monkeypatch.setenv("PYTHONPATH", str(tmp_path))
    monkeypatch.setattr(script, "SECONDS", 1)
    assert lines_of(script, tmp_path) == ["import waits: nothing for 1 s"]


@pytest.mark.parametrize(
    "content",
    [
        b"text\n",
        b"{}\n",
        b"[1]\n",
        b'"a"\n' + b"\xff\n",
        bytes(range(128, 192)),
        b"".join(b'"%d"\n' % n for n in range(10_001)),
    ],
)
def test_what_is_no_list_of_lines_is_refused(content: bytes) -> None:
    with pytest.raises(RosmlError, match="left something else than its lines"):
        trial.lines(content)


def test_lines_are_printed_as_text() -> None:
    assert trial.lines(json.dumps("a\x1b]0;harm\x07\n::error::b").encode()) == {"a?]0;harm??::error::b"}
