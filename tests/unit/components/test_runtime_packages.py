"""What is installed for programs that are built, of the packages that they are built with: apt's answers are made up."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest
from conftest import ROOT

from fakes.stubs import executable

SCRIPT = ROOT / "components/ros/runtime_packages.py"

ARCHIVE = {
    "libfoo-dev": "Section: libdevel\nDepends: libfoo1 (= 1.0), libbar-dev | libbaz-dev, foo-tools",
    "libfoo1": "Section: libs\nDepends: libc6 (>= 2.36)",
    "libbar-dev": "Section: libdevel\nPre-Depends: libbar2\nDepends: libfoo-dev, libc6-dev, ros-std-msgs",
    "libbar2": "Section: libs\nProvides: libbar-abi-1",
    "foo-tools": "Section: devel\nDepends: perl, cmake-things",
    "cmake-things": "Section: devel\nDepends: g++ (>= 12)",
    "g++": "Section: devel\nDepends: g++-12, gcc-12, libc6-dev",
    "ros-std-msgs": "Section: devel",
    "ros-core-dev": "Section: metapackages\nDepends: ros-core, libfoo-dev",
    "ros-core": "Section: metapackages\nDepends: libfoo-dev",
    "python3-uhd": "Section: libdevel\nDepends: python3",
    "libzeta1g-dev": "Section: libdevel\nDepends: zeta1g\nProvides: libzeta-dev (= 1.2), libother-dev",
    "zeta1g": "Section: libs",
}


@pytest.fixture
def programs(tmp_path: Path) -> Path:
    text = "\n".join(f"Package: {name}\n{fields}\n" for name, fields in ARCHIVE.items())
    (tmp_path / "avail").write_text(text)
    executable(tmp_path / "apt-cache", f'test "$1" = dumpavail && cat {tmp_path}/avail')
    return tmp_path


@pytest.mark.parametrize(
    ("packages", "needed"),
    [
        ("libfoo-dev", "libbar2 libfoo1 ros-std-msgs"),
        ("ros-core-dev", "libbar2 libfoo1 ros-core ros-std-msgs"),
        ("ros-core libfoo1", "libfoo1 ros-core"),
        ("python3-uhd", "python3-uhd"),
        ("libzeta-dev", "zeta1g"),
        ("libother-dev", "zeta1g"),
        ("nobody-has-this-dev nobody-has-this", "nobody-has-this nobody-has-this-dev"),
        ("libfoo-dev=1.0 libfoo-dev:arm64", "libfoo-dev:arm64 libfoo-dev=1.0"),
        ("g++ gcc-12 libstdc++-12-dev build-essential foo-tools", ""),
    ],
)
def test_what_programs_need(packages: str, needed: str, programs: Path) -> None:
    env = {"PATH": f"{programs}:/usr/bin:/bin"}
    done = subprocess.run([SCRIPT, *packages.split()], env=env, capture_output=True, text=True, check=True)
    assert done.stdout.split() == needed.split()
