"""Steps of a build that call colcon: how many compilers they start, what they build, and what they say of a failure."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest
from conftest import ROOT

from fakes.stubs import executable

STEPS = ROOT / "components/containerize"


@pytest.mark.parametrize(
    ("cores", "memory", "jobs", "packages", "expected"),
    [
        (8, 64_000, "", 20, " |"),  # as colcon does it
        (8, 15_900, "", 20, "--parallel-workers 2|-j3"),
        (8, 15_900, "", 1, "--parallel-workers 1|-j7"),
        (64, 64_000, "", 100, "--parallel-workers 5|-j6"),
        (4, 900, "", 20, "--parallel-workers 1|-j1"),
        (4, 64_000, "1", 20, "--parallel-workers 1|-j1"),
        (4, 900, "16", 20, "--parallel-workers 4|-j4"),
    ],
)
def test_compilers_are_as_many_as_memory_has_room_for(
    cores: int, memory: int, jobs: str, packages: int, expected: str, tmp_path: Path
) -> None:
    executable(tmp_path / "nproc", f"echo {cores}")
    text = f"asked_jobs() {{ echo '{jobs}'; }}; memory() {{ echo {memory}; }}\nlimit_jobs {packages}\n"
    assert setup(f'{text}echo "${{workers[*]:- }}|${{MAKEFLAGS:-}}"', tmp_path) == f"{expected}\n"


def setup(text: str, tmp_path: Path) -> str:
    """What a shell prints that has setup.sh, in a workspace without anything."""
    script = f"set -euo pipefail\nsource {STEPS}/setup.sh\n{text}"
    env = {"PATH": f"{tmp_path}:{os.environ['PATH']}", "WORKSPACE": str(tmp_path)}
    return subprocess.run(["bash", "-c", script], env=env, check=True, capture_output=True, text=True).stdout


def test_all_that_a_base_image_built_is_sourced(tmp_path: Path) -> None:
    """In images for Jetson, ROS is in /opt/ros/humble/install."""
    text = (STEPS / "setup.sh").read_text().replace("/opt/", f"{tmp_path}/opt/")
    places = ["opt/ros/humble", "opt/ros/humble/install", "opt/ws_base_image/install", "install"]
    for place in places:
        (tmp_path / place).mkdir(parents=True, exist_ok=True)
        (tmp_path / place / "setup.bash").write_text(f"echo {place}\n")
    env = {"PATH": os.environ["PATH"], "WORKSPACE": str(tmp_path), "ROS_DISTRO": "humble"}
    shell = subprocess.run(["bash", "-euc", text], env=env, check=True, capture_output=True, text=True)
    assert shell.stdout.split() == places


# ---- Building --------------------------------------------------------------------------------------------------------

COLCON = """
case $1 in
list) mkdir -p src/target/a && echo src/target/a ;;
build)
  echo "$* $MAKEFLAGS" >calls
  mkdir -p "$COLCON_LOG_PATH/build_1/a" && ln -sfn build_1 "$COLCON_LOG_PATH/latest_build"
  printf '%s\\n' "begins" '{line}' "Summary: 1 package failed" | tee "$COLCON_LOG_PATH/build_1/a/stdout_stderr.log"
  exit 2 ;;
esac
"""


class Workspace:
    """A folder in which the script that builds packages runs, with a colcon that fails."""

    def __init__(self, folder: Path, line: str = "Killed") -> None:
        self.folder, self.sources, self.calls = folder, folder / "src", folder / "ws/calls"
        executable(folder / "colcon", COLCON.format(line=line))
        (folder / "ws/src/target").mkdir(parents=True)
        self.sources.mkdir()
        (self.sources / "README").touch()
        self.script = (STEPS / "workspace.sh").read_text()
        for text, replacement in (
            ("/run/sources/.", f"{folder}/src/."),
            ('$(dirname "${BASH_SOURCE[0]}")', str(STEPS)),
            ("=/tmp/log", f"={folder}/log"),
            ("=/rosml-outside", f"={folder}/outside"),
            ("mkdir -p /docker-ros/ws", f"mkdir -p {folder}/docker-ros"),
            ("/usr/local/lib/rosml/bin/", f"{folder}/"),
        ):
            assert text in self.script
            self.script = self.script.replace(text, replacement)

    def build(self, stage: str = "target", **variables: str) -> subprocess.CompletedProcess[str]:
        env = {"PATH": f"{self.folder}:{os.environ['PATH']}", "WORKSPACE": str(self.folder / "ws"), "MAKEFLAGS": ""}
        command = ["bash", "-c", self.script, "workspace.sh", stage]
        return subprocess.run(command, env=env | variables, capture_output=True, text=True, check=False)


OUT_OF_MEMORY = "memory may have run out"
NO_GIT = "fatal: not a git repository (or any of the parent directories): .git"
NO_PACKAGE = 'CMake {0} at x:3:\n  Could not find a package configuration file provided by "tf2_ros"{1}'


@pytest.mark.parametrize(
    ("line", "says"),
    [
        ("gmake[2]: *** [CMakeFiles/k.dir/build.make:70: CMakeFiles/k] Error 137", OUT_OF_MEMORY),
        ("c++: fatal error: Killed signal terminated program cc1plus", OUT_OF_MEMORY),
        ("g++: internal compiler error: Killed (program cc1plus)", OUT_OF_MEMORY),
        ("Killed", OUT_OF_MEMORY),
        ("fatal error: error writing to /tmp/a.s: No space left on device", "a package does not build: No space left"),
        (NO_GIT, "error: a package asks git for its version"),
        ("LookupError: setuptools-scm was unable to detect version for /x.", "fallback_version of setuptools_scm"),
        ("CalledProcessError: Command [python3, -c, run_setup(]", "fallback_version of setuptools_scm"),
        (NO_PACKAGE.format("Error", " with any"), "such as <depend>tf2_ros</depend>"),
        ("a.cpp:1:10: fatal error: tf2_ros/buffer.h: No such file or directory", "such as <depend>tf2_ros</depend>"),
        *(
            (f"a.cpp:1:10: fatal error: {header}: No such file or directory", header)
            for header in ("named/buffer.h", "has/old.h")
        ),
        ("a.cpp:1:10: fatal error: has/new.h: No such file or directory", "such as <depend>has</depend>"),
        ("/src/a.cpp:4:50: error: _1 was not declared", "/src/a.cpp:4:50: error: _1 was not declared"),
        (NO_PACKAGE.format("Warning", ""), ""),
        ("warning: Killed is a nice name; Error 1370", ""),
        ("gmake: *** [Makefile:146: all] Error 2", ""),
    ],
)
def test_a_build_says_why_it_failed_if_it_knows(line: str, says: str, tmp_path: Path) -> None:
    """And it ends as colcon did."""
    workspace = Workspace(tmp_path, line)
    files = {"colcon.meta": "{}", "setup.py": "setup(use_scm_version=True)", "package.xml": "<depend>named</depend>"}
    for name, text in files.items():
        (tmp_path / "ws/src/target" / name).write_text(text)
    (tmp_path / "ros/include/has/has").mkdir(parents=True)
    (tmp_path / "ros/include/has/has/new.h").touch()
    words = {"COLCON_ARGS": "--executor sequential", "CMAKE_ARGS": "-DA='b c'"}
    end = workspace.build(**words, CMAKE_PREFIX_PATH=f"/nothing:{tmp_path}/ros")
    assert end.returncode == 2, end.stderr
    call = workspace.calls.read_text()
    assert "build --base-paths src/target --metas src/target/colcon.meta " in call
    assert "--executor sequential --cmake-args -DA=b c" in call
    last = end.stderr.splitlines()[-1:]
    assert says in "".join(last) and bool(last) == bool(says)
    assert says != OUT_OF_MEMORY or last[0].startswith(f"error: a program was killed ({line}); ")


@pytest.mark.parametrize("has_python", [True, False])
def test_what_cmake_writes_names_the_systems_python(has_python: bool, tmp_path: Path) -> None:
    """On an image on which rosml installed ROS, another path to it is first; other images do not have that one."""
    workspace = Workspace(tmp_path)
    if has_python:
        executable(tmp_path / "python3", "")
    workspace.build(CMAKE_ARGS="-DA=b")
    arguments = "-DPython3_EXECUTABLE=/usr/bin/python3 -DA=b" if has_python else "--cmake-args -DA=b"
    assert arguments in workspace.calls.read_text()


def test_a_workspace_that_imports_nothing_calls_no_colcon(tmp_path: Path) -> None:
    workspace = Workspace(tmp_path)
    (workspace.sources / "README").unlink()
    assert workspace.build("upstream").returncode == 0
    assert (tmp_path / "ws/src/upstream").is_dir() and not workspace.calls.exists()
    (tmp_path / "ws/src/upstream/late").mkdir()
    workspace.build("upstream")
    assert workspace.calls.exists(), "docker/custom.sh may add packages, as in docker-ros"


@pytest.mark.parametrize(("version", "skips"), [("1", True), ("2", False)])
def test_only_a_step_with_tests_compiles_them(version: str, skips: bool, tmp_path: Path) -> None:
    """Those of catkin, which the step of the tests compiles by a target of their own."""
    workspace = Workspace(tmp_path)
    workspace.build(ROS_VERSION=version, COLCON_ARGS="--executor sequential")
    call = workspace.calls.read_text()
    assert ("--catkin-skip-building-tests --executor sequential" in call) == skips and "--executor sequential" in call


@pytest.mark.parametrize("script", ["workspace.sh target", "test.sh out"])
def test_a_colcon_that_cannot_list_is_no_empty_workspace(script: str, tmp_path: Path) -> None:
    """As with few of its extensions: an image without one file of the app would be made."""
    executable(tmp_path / "colcon", "[ $1 != list ] || { echo \"invalid choice: 'list'\" >&2; exit 2; }")
    end = step(script, tmp_path)
    assert end.returncode != 0 and "invalid choice: 'list'" in end.stderr


@pytest.mark.parametrize(
    ("files", "hides"),
    [
        (["setup.py", "ros/a/package.xml"], "src/target/ros/a"),
        (["CMakeLists.txt", "a/COLCON_IGNORE", "a/b/package.xml", ".git/package.xml"], ""),
        (["package.xml", "templates/a/package.xml"], ""),
    ],
)
def test_a_package_of_another_kind_hides_none_with_a_manifest(files: list[str], hides: str, tmp_path: Path) -> None:
    """As a setup.py beside the folder with ROS packages: colcon builds that alone, and ends well."""
    for name in files:
        place = tmp_path / "ws/src/target" / name
        place.parent.mkdir(parents=True, exist_ok=True)
        place.touch()
    executable(tmp_path / "colcon", "[ $1 = list ] || exit 9; echo src/target")
    end = step("workspace.sh target", tmp_path)
    assert end.returncode == (1 if hides else 9) and (f"does not build {hides} inside" in end.stderr) == bool(hides)


def step(script: str, folder: Path) -> subprocess.CompletedProcess[str]:
    """Runs a script of a step with programs of a folder, up to its first call of colcon that fails."""
    (folder / "ws").mkdir(exist_ok=True)
    for name in ("cp", "mkdir"):  # /run/sources is a mount of the build, and this machine gets no folders in /
        (folder / name).symlink_to("/bin/true")
    environment = {"PATH": f"{folder}:{os.environ['PATH']}", "WORKSPACE": str(folder / "ws")}
    name, argument = script.split()
    command = [str(STEPS / name), argument]
    return subprocess.run(command, env=environment, cwd=folder, capture_output=True, text=True, check=False)


# ---- Testing ---------------------------------------------------------------------------------------------------------

TESTING = """
case $1 in
list) printf '%s\\n' robot arm bare ;;
test)
  sleep 0.05 # times of files are not exact
  mkdir -p "$COLCON_LOG_PATH/latest_test"
  for name in robot arm bare; do mkdir -p "$COLCON_LOG_PATH/latest_test/$name"; done
  cd "$COLCON_LOG_PATH/latest_test"
  printf "[0.1] (robot) JobStarted: {}\\n[0.2] (robot) TestFailure: {'identifier': 'robot'}\\n" >events.log
  printf "[0.2] (robot) JobEnded: {'identifier': 'robot', 'rc': 0}\\n" >>events.log
  printf "[0.3] (arm) JobEnded: {'identifier': 'arm', 'rc': 1}\\n" >>events.log # as with tests of Python's unittest
  printf "[0.3] (bare) JobEnded: {'identifier': 'bare', 'rc': 5}\\n" >>events.log
  echo 'core dumped' >robot/stdout_stderr.log
  echo '1 != 2' >arm/stdout_stderr.log
  printf 'Ran 0 tests in 0.000s\\n\\nNO TESTS RAN\\n' >bare/stdout_stderr.log
  cd "$OLDPWD"
  echo '<testsuite/>' >build/robot/new.xml
  echo '<Site><TestList></TestList></Site>' >build/robot/Test.xml
  echo '<other/>' >build/robot/other.xml
  exit 1 ;;
esac
"""


def test_what_a_build_wrote_is_no_result_of_tests(tmp_path: Path) -> None:
    work, out = tmp_path / "ws", tmp_path / "results"
    for name in ("robot/data", "arm", "bare"):
        (work / "build" / name).mkdir(parents=True)
    (work / "build/robot/data/sample.xml").write_text("<testsuite/>")
    executable(tmp_path / "colcon", TESTING)
    environment = {"PATH": f"{tmp_path}:{os.environ['PATH']}", "WORKSPACE": str(work), "TMPDIR": str(tmp_path)}
    subprocess.run([STEPS / "test.sh", out], env=environment, check=True)
    files = sorted(str(path.relative_to(out)) for path in out.rglob("*") if path.is_file())
    assert files == ["arm/output.log", "failed", "robot/Test.xml", "robot/new.xml", "robot/output.log"]
    text = "{0}: its tests failed and left no report; {0}/output.log has what they printed\n"
    assert (out / "failed").read_text() == text.format("arm") + text.format("robot")
    assert (out / "arm/output.log").read_text() == "1 != 2\n"
