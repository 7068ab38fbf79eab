"""The program that compiles a framework's headers, on a few made-up ones."""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from conftest import ROOT

pytestmark = pytest.mark.skipif(shutil.which("g++") is None, reason="needs g++")

HEADERS = {
    "api/good.h": "#pragma once\ninline int good() { return 1; }\n",
    "api/also.h": '#pragma once\n#include "api/good.h"\n',
    "api/lacking.h": "#include <nowhere.h>\n",
}


def compiled(folder: Path, wanted: str, fails: str = "") -> tuple[int, str]:
    for name, text in HEADERS.items():
        (folder / "include" / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / "include" / name).write_text(text)
    (folder / "list.txt").write_text(wanted)
    (folder / "fails.txt").write_text(fails)
    program = ROOT / "tests/e2e/includes/compile.py"
    command = [sys.executable, program, folder / "list.txt", "--fails", folder / "fails.txt"]
    command += ["--", "-isystem", folder / "include"]
    done = subprocess.run([*map(str, command)], capture_output=True, text=True, check=False)
    return done.returncode, done.stdout + done.stderr


def test_what_compiles_alone_and_together(tmp_path: Path) -> None:
    status, said = compiled(tmp_path, "# why\napi/good.h\napi/also.h\n")
    assert status == 0, said
    assert "2 of 2 headers compile alone" in said
    assert said.count("they compile") == 3


def test_what_fails_is_named_with_its_error_unless_it_is_known_to(tmp_path: Path) -> None:
    status, said = compiled(tmp_path, "api/*.h\n")
    assert status == 1
    assert "api/lacking.h\n" in said
    assert "nowhere.h: No such file" in said
    assert compiled(tmp_path, "api/*.h\n", fails="api/lacking.h it wants what nobody has\n")[0] == 0


def test_one_that_clashes_with_another_fails_all_together(tmp_path: Path) -> None:
    clash = tmp_path / "include/clash.h"
    clash.parent.mkdir()
    clash.write_text("inline int good() { return 2; }\n")
    status, said = compiled(tmp_path, "api/good.h\nclash.h\n")
    assert status == 1
    assert "2 of 2 headers compile alone" in said
    assert "all together in this order\n" in said
    known = "clash.h together: it defines what good.h does\n"
    assert compiled(tmp_path, "api/good.h\nclash.h\n", fails=known)[0] == 0
    clash.write_text("int wrong = ;\n")
    status, said = compiled(tmp_path, "api/good.h\nclash.h\n", fails=known)
    assert status == 1 and "clash.h\n" in said


@pytest.mark.parametrize("name", ["api/good.h", "api/gone.h"])
def test_a_failure_that_is_none_is_wrong(tmp_path: Path, name: str) -> None:
    status, said = compiled(tmp_path, "api/good.h\n", fails=f"{name} why\n")
    assert status == 1
    assert f"{name} compiles, or is not there" in said


def test_a_pattern_that_no_header_matches_is_wrong(tmp_path: Path) -> None:
    assert compiled(tmp_path, "apis/*.h\n") == (1, "compile: no header is called apis/*.h\n")
