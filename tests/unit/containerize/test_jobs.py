"""How many compilers a build of packages starts, and what it says of one that was killed."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest
from conftest import ROOT

from fakes.stubs import executable

STEPS = ROOT / "components/containerize"


def bash(text: str, tmp_path: Path, **environment: str) -> str:
    """What a shell prints that has setup.sh, in a workspace without anything."""
    script = f"set -euo pipefail\nsource {STEPS}/setup.sh\n{text}"
    env = {"PATH": f"{tmp_path}:{os.environ['PATH']}", "WORKSPACE": str(tmp_path), **environment}
    return subprocess.run(["bash", "-c", script], env=env, check=True, capture_output=True, text=True).stdout


@pytest.mark.parametrize(
    ("cores", "memory", "asked", "packages", "expected"),
    [
        (8, 64_000, "", 20, " |"),  # as colcon does it
        (8, 16_000, "", 20, " |"),
        (8, 15_900, "", 20, "--parallel-workers 2|-j3"),
        (8, 15_900, "", 1, "--parallel-workers 1|-j7"),
        (64, 64_000, "", 100, "--parallel-workers 5|-j6"),
        (4, 3_000, "", 20, "--parallel-workers 1|-j1"),
        (4, 900, "", 20, "--parallel-workers 1|-j1"),
        (4, 64_000, "1", 20, "--parallel-workers 1|-j1"),
        (4, 900, "16", 20, "--parallel-workers 4|-j4"),
    ],
)
def test_compilers_are_as_many_as_memory_has_room_for(
    cores: int, memory: int, asked: str, packages: int, expected: str, tmp_path: Path
) -> None:
    executable(tmp_path / "nproc", f"echo {cores}")
    text = f"asked_jobs() {{ echo '{asked}'; }}; memory() {{ echo {memory}; }}\nlimit_jobs {packages}\n"
    said = bash(f'{text}echo "${{workers[*]:- }}|${{MAKEFLAGS:-}}"', tmp_path)
    assert said == f"{expected}\n"


def test_all_that_a_base_image_built_is_sourced(tmp_path: Path) -> None:
    """In images for Jetson, ROS is in /opt/ros/humble/install."""
    text = (STEPS / "setup.sh").read_text().replace("/opt/", f"{tmp_path}/opt/")
    for place in ("opt/ros/humble", "opt/ros/humble/install", "opt/ws_base_image/install", "install"):
        (tmp_path / place).mkdir(parents=True, exist_ok=True)
        (tmp_path / place / "setup.bash").write_text(f"echo {place}\n")
    env = {"PATH": os.environ["PATH"], "WORKSPACE": str(tmp_path), "ROS_DISTRO": "humble"}
    done = subprocess.run(["bash", "-euc", text], env=env, check=True, capture_output=True, text=True)
    assert done.stdout.split() == ["opt/ros/humble", "opt/ros/humble/install", "opt/ws_base_image/install", "install"]


def test_the_memory_of_this_machine(tmp_path: Path) -> None:
    said = int(bash("memory", tmp_path))
    assert 0 < said <= os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE") >> 20


COLCON = """
case $1 in
list) mkdir -p src/target/a && echo src/target/a ;;
build)
  echo "$* $MAKEFLAGS" >calls
  mkdir -p "$COLCON_LOG_PATH/build_1/a" && ln -sfn build_1 "$COLCON_LOG_PATH/latest_build"
  printf '%s\\n' "begins" {line} "Summary: 1 package failed" | tee "$COLCON_LOG_PATH/build_1/a/stdout_stderr.log"
  exit 2 ;;
esac
"""


@pytest.mark.parametrize(
    ("line", "says"),
    [
        ("gmake[2]: *** [CMakeFiles/k.dir/build.make:70: CMakeFiles/k] Error 137", "memory may have run out"),
        ("c++: fatal error: Killed signal terminated program cc1plus", "memory may have run out"),
        ("g++: internal compiler error: Killed (program cc1plus)", "memory may have run out"),
        ("collect2: fatal error: ld terminated with signal 9 [Killed]", "memory may have run out"),
        ("clang: error: unable to execute command: Killed", "memory may have run out"),
        ("cc1plus: out of memory allocating 65536 bytes", "memory may have run out"),
        ("Killed", "memory may have run out"),
        (
            "fatal error: error writing to /tmp/a.s: No space left on device",
            "error: a package does not build: No space left",
        ),
        (
            "fatal: not a git repository (or any of the parent directories): .git",
            "error: a package asks git for its version",
        ),
        ("LookupError: setuptools-scm was unable to detect version for /x.", "fallback_version of setuptools_scm"),
        ("CalledProcessError: Command [python3, -c, run_setup(]", "fallback_version of setuptools_scm"),
        (
            'CMake Error at CMakeLists.txt:3:\n  Could not find a package configuration file provided by "tf2_ros" with any',
            "such as <depend>tf2_ros</depend>",
        ),
        ("a.cpp:1:10: fatal error: tf2_ros/buffer.h: No such file or directory", "such as <depend>tf2_ros</depend>"),
        ("a.cpp:1:10: fatal error: named/buffer.h: No such file or directory", ""),
        ('CMake Warning:\n  Could not find a package configuration file provided by "tf2_ros"', ""),
        ("warning: Killed is a nice name; Error 1370", ""),
        ("gmake: *** [Makefile:146: all] Error 2", ""),
    ],
)
def test_a_build_says_why_it_failed_if_it_knows(line: str, says: str, tmp_path: Path) -> None:
    """And it ends as colcon did."""
    executable(tmp_path / "colcon", COLCON.format(line=f"'{line}'"))
    script = workspace(tmp_path)
    env = {"PATH": f"{tmp_path}:{os.environ['PATH']}", "WORKSPACE": str(tmp_path / "ws"), "MAKEFLAGS": ""}
    env |= {"COLCON_ARGS": "--executor sequential", "CMAKE_ARGS": "-DA='b c'"}
    (tmp_path / "ws/src/target").mkdir(parents=True)
    (tmp_path / "ws/src/target/colcon.meta").write_text("{}")
    (tmp_path / "ws/src/target/setup.py").write_text("setup(use_scm_version=True)")
    (tmp_path / "ws/src/target/package.xml").write_text("<depend>named</depend>")
    done = subprocess.run(["bash", "-c", script, "workspace.sh", "target"], env=env, capture_output=True, text=True)
    assert done.returncode == 2, done.stderr
    assert "build --base-paths src/target --metas src/target/colcon.meta " in (tmp_path / "ws/calls").read_text()
    assert "--executor sequential --cmake-args -DA=b c" in (tmp_path / "ws/calls").read_text()
    last = done.stderr.splitlines()[-1:]
    assert says in "".join(last) and bool(last) == bool(says)
    assert says != "memory may have run out" or last[0].startswith(f"error: a program was killed ({line}); ")


def test_what_cmake_writes_names_the_systems_python(tmp_path: Path) -> None:
    """On an image on which rosml installed ROS, another path to it is first; other images do not have that one."""
    executable(tmp_path / "colcon", COLCON.format(line="Killed"))
    executable(tmp_path / "python3", "")
    env = {"PATH": f"{tmp_path}:{os.environ['PATH']}", "WORKSPACE": str(tmp_path / "ws"), "CMAKE_ARGS": "-DA=b"}
    script = workspace(tmp_path)
    for there, says in ((True, "-DPython3_EXECUTABLE=/usr/bin/python3 -DA=b"), (False, "--cmake-args -DA=b")):
        (tmp_path / "ws/calls").unlink(missing_ok=True)
        if not there:
            (tmp_path / "python3").unlink()
        subprocess.run(["bash", "-c", script, "workspace.sh", "target"], env=env, capture_output=True, check=False)
        assert says in (tmp_path / "ws/calls").read_text()


def test_a_workspace_that_imports_nothing_calls_no_colcon(tmp_path: Path) -> None:
    executable(tmp_path / "colcon", COLCON.format(line="Killed"))
    script = workspace(tmp_path)
    (tmp_path / "src/README").unlink()
    env = {"PATH": f"{tmp_path}:{os.environ['PATH']}", "WORKSPACE": str(tmp_path / "ws")}
    subprocess.run(["bash", "-c", script, "workspace.sh", "upstream"], env=env, check=True)
    assert (tmp_path / "ws/src/upstream").is_dir() and not (tmp_path / "ws/calls").exists()


@pytest.mark.parametrize(("version", "skips"), [("1", True), ("2", False)])
def test_only_a_step_with_tests_compiles_them(version: str, skips: bool, tmp_path: Path) -> None:
    """Those of catkin, which the step of the tests compiles by a target of their own."""
    executable(tmp_path / "colcon", COLCON.format(line="Killed"))
    script = workspace(tmp_path)
    env = {"PATH": f"{tmp_path}:{os.environ['PATH']}", "WORKSPACE": str(tmp_path / "ws"), "ROS_VERSION": version}
    env["COLCON_ARGS"] = "--executor sequential"
    subprocess.run(["bash", "-c", script, "workspace.sh", "target"], env=env, capture_output=True, check=False)
    built = (tmp_path / "ws/calls").read_text()
    assert ("--catkin-skip-building-tests --executor sequential" in built) == skips and "--executor sequential" in built


def workspace(folder: Path) -> str:
    """The script that builds packages, of folders of a test; sources are in one of them."""
    script = (STEPS / "workspace.sh").read_text()
    for old, new in (
        ("/run/sources/.", f"{folder}/src/."),
        ('$(dirname "${BASH_SOURCE[0]}")', str(STEPS)),
        ("=/tmp/log", f"={folder}/log"),
        ("/usr/local/lib/rosml/bin/", f"{folder}/"),
    ):
        assert old in script
        script = script.replace(old, new)
    (folder / "src").mkdir()
    (folder / "src/README").touch()
    return script
