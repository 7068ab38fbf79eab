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
    "clash.h": "inline int good() { return 2; }\n",
    "wrong.h": "int wrong = ;\n",
}
CLASH = "clash.h together: it defines what good.h does\n"


@pytest.mark.parametrize(
    ("patterns", "fails", "status", "words"),
    [
        ("# why\napi/good.h\napi/also.h\n", "", 0, "2 of 2 headers compile alone"),
        ("api/*.h\n", "", 1, "nowhere.h: No such file"),
        ("api/*.h\n", "api/lacking.h it wants what nobody has\n", 0, ""),
        ("api/good.h\nclash.h\n", "", 1, "all together in this order\n"),
        ("api/good.h\nclash.h\n", CLASH, 0, "2 of 2 headers compile alone"),
        ("api/good.h\nwrong.h\n", CLASH.replace("clash", "wrong"), 1, "wrong.h\n"),
        ("api/good.h\n", "api/good.h why\n", 1, "api/good.h compiles, or is not there"),
        ("api/good.h\n", "api/gone.h why\n", 1, "api/gone.h compiles, or is not there"),
        ("apis/*.h\n", "", 1, "compile: no header is called apis/*.h\n"),
    ],
)
def test_headers_compile_alone_and_together_unless_they_are_named(
    patterns: str, fails: str, status: int, words: str, tmp_path: Path
) -> None:
    for name, text in {**HEADERS, "../list.txt": patterns, "../fails.txt": fails}.items():
        (tmp_path / "include" / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / "include" / name).write_text(text)
    program, include = ROOT / "tests/e2e/includes/compile.py", tmp_path / "include"
    command = [
        sys.executable,
        program,
        tmp_path / "list.txt",
        "--fails",
        tmp_path / "fails.txt",
        "--",
        "-isystem",
        include,
    ]
    done = subprocess.run([*map(str, command)], capture_output=True, text=True, check=False)
    assert done.returncode == status and words in done.stdout + done.stderr, done.stdout + done.stderr
