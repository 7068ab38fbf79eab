"""What of a folder is not sent to the builder."""

from __future__ import annotations

import os
import stat
import subprocess
import time
from pathlib import Path

import pytest

from rosml import ROOT
from rosml.base.errors import RosmlError
from rosml.containerize.ignored_files import IgnoredFiles
from rosml.containerize.packages import workspace


def write(folder: Path, *names: str) -> None:
    for name in names:
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text("<package><name>a</name></package>")


def staged(folder: Path, out: Path) -> set[str]:
    workspace.stage(folder, out, ignored=IgnoredFiles(folder))
    return {str(path.relative_to(out)) for path in out.rglob("*") if path.is_file()}


def test_secret_files_and_gits_folder_are_sent_to_no_builder(tmp_path: Path) -> None:
    write(tmp_path / "robot", "package.xml", ".env", "src/arm/.env", ".git/config", "src/arm/.git", "src/arm/env")
    assert staged(tmp_path / "robot", tmp_path / "out") == {"package.xml", "src/arm/env"}


EVERY = {"a.txt", "b/c.txt", "b/d/e.txt", "b/f.md"}
IN_B = EVERY - {"a.txt"}


@pytest.mark.parametrize(
    ("text", "ignored"),
    [
        ("# a.txt\n\n", set()),
        ("a.txt", {"a.txt"}),
        ("/a.txt", {"a.txt"}),
        ("*.txt", {"a.txt"}),
        ("**/*.txt", EVERY - {"b/f.md"}),
        ("b/", IN_B),
        ("b/**", IN_B),
        ("b\n!b/d", {"b/c.txt", "b/f.md"}),
        ("*\n!b/**/*.txt", {"a.txt", "b/f.md", ".dockerignore"}),
        ("!a.txt\n*.txt", {"a.txt"}),
        ("b/?.md", {"b/f.md"}),
        ("b/[a-c].txt", {"b/c.txt"}),
        ("**/d", {"b/d/e.txt"}),
        ("d", set()),
        ("b/[^a-c].md", {"b/f.md"}),
        ("b/\\f.md", {"b/f.md"}),
        ("b/\\*.md", set()),
        ("**/b/**/**/e.*", {"b/d/e.txt"}),
        ("[", set()),
        ("(a.txt|b)", set()),
    ],
)
def test_dockerignore_counts_as_for_docker(text: str, ignored: set[str], tmp_path: Path) -> None:
    write(tmp_path / "robot", *EVERY)
    (tmp_path / "robot/.dockerignore").write_text(text)
    assert staged(tmp_path / "robot", tmp_path / "out") == (EVERY | {".dockerignore"}) - ignored


def test_output_of_tools_stays_where_it_is(tmp_path: Path) -> None:
    robot = tmp_path / "robot"
    kept = {"src/a/package.xml", "src/build/package.xml", "log/of_the_robot.txt", "tools/install"}
    write(robot, *kept, "build/COLCON_IGNORE", "build/a/x", "install/COLCON_IGNORE", "build_isolated/CATKIN_IGNORE")
    write(robot, "devel/.catkin", "devel/.private/a/setup.sh", "ws/install/.catkin", "ws/install/share/a/package.xml")
    write(robot, ".catkin_tools/CATKIN_IGNORE", "logs/a/build.log", "venv/pyvenv.cfg", "venv/b/package.xml")
    assert staged(robot, tmp_path / "out") == kept
    assert {path.parent.name for path in workspace.manifests(robot, ignored=IgnoredFiles(robot))} == {"a", "build"}


def test_a_link_to_an_environment_of_python_is_a_link(tmp_path: Path) -> None:
    """It is sent as it is, and nothing of the folder that it leads to is looked at."""
    robot = tmp_path / "robot"
    write(tmp_path, "elsewhere/pyvenv.cfg", "robot/a/package.xml")
    (robot / "env").symlink_to(tmp_path / "elsewhere")
    assert not IgnoredFiles(robot).whole(robot / "env")
    assert IgnoredFiles(tmp_path).whole(tmp_path / "elsewhere")


def test_packages_that_dockerignore_leaves_out_are_not_built(tmp_path: Path) -> None:
    robot = tmp_path / "robot"
    write(robot, "src/a/package.xml", "src/b/package.xml")
    (robot / ".dockerignore").write_text("src/b\n")
    assert workspace.write_manifests({"target": robot}, tmp_path / "out") == {"target": 1}
    (robot / ".dockerignore").write_text("*\n!docker\n")
    with pytest.raises(RosmlError, match=r"no package\.xml in .*except what \.dockerignore leaves out") as caught:
        workspace.write_manifests({"target": robot}, tmp_path / "out")
    assert "!src" in caught.value.remedy


def test_a_dockerignore_is_a_file_of_the_folder(tmp_path: Path) -> None:
    (tmp_path / "robot").mkdir()
    (tmp_path / "robot/.dockerignore").symlink_to("/etc/hostname")
    with pytest.raises(RosmlError, match="leads out of"):
        IgnoredFiles(tmp_path / "robot")
    (tmp_path / "robot/.dockerignore").unlink()
    os.mkfifo(tmp_path / "robot/.dockerignore")
    with pytest.raises(RosmlError, match="neither a file nor a folder"):
        IgnoredFiles(tmp_path / "robot")


def test_files_about_a_repository_are_no_input(tmp_path: Path) -> None:
    """A package's own files are inputs, and what a build names stays, wherever it is."""
    kept = {"a/package.xml", "a/README.md", "a/.hidden", "plain/CMakeLists.txt", "plain/README"}
    kept = {f"target/src/{name}" for name in kept} | {"upstream/whole/package.xml", "upstream/whole/README.md"}
    kept |= {"target/LICENSE", "target/shared/a.h", "target/CONTRIBUTING.md"}
    write(tmp_path, *kept, "target/README.md", "target/src/CHANGELOG.rst", "target/.github/workflows/ci.yml")
    write(tmp_path, "upstream/two/readme.txt")
    (tmp_path / "target/src/plain/CMakeLists.txt").write_text("file(READ ../../CONTRIBUTING.md text)\n")
    subprocess.run([ROOT / "components/containerize/packages.sh", tmp_path], check=True)
    assert {str(path.relative_to(tmp_path)) for path in tmp_path.rglob("*") if path.is_file()} == kept


def test_no_pattern_takes_long(tmp_path: Path) -> None:
    """Whoever wrote the repository wrote it."""
    deep = tmp_path / "robot" / "/".join(["a" * 20] * 60)
    write(deep, "a" * 200)
    (tmp_path / "robot/.dockerignore").write_text(f"{'**/a*a*a*a*a*a*b/' * 40}x\n{'a*' * 100}b\n" * 20)
    started = time.monotonic()
    assert len(staged(tmp_path / "robot", tmp_path / "out")) == 2
    assert time.monotonic() - started < 10


def test_a_checkout_with_umask_077_gives_files_that_everybody_may_read(tmp_path: Path) -> None:
    """An image may start as any user. The files of the checkout stay as they are."""
    write(tmp_path / "robot", "package.xml", "scripts/talk")
    (tmp_path / "robot/scripts/talk").chmod(0o700)
    (tmp_path / "robot/scripts").chmod(0o700)
    before = os.umask(0o077)
    try:
        private = workspace.stage(tmp_path / "robot", tmp_path / "out")
    finally:
        os.umask(before)
    assert private == ["scripts/talk"]
    modes = {
        path.name: stat.S_IMODE(path.stat().st_mode) for path in (tmp_path / "out", *(tmp_path / "out").rglob("*"))
    }
    assert modes == {"out": 0o755, "scripts": 0o755, "talk": 0o755, "package.xml": 0o644}
    assert stat.S_IMODE((tmp_path / "robot/scripts/talk").stat().st_mode) == 0o700
