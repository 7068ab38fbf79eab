"""The folders of examples/ and their pages: what is copied is whole, and installs what it needs as the pages say."""

from __future__ import annotations

import re
import shutil
import socket
from pathlib import Path

import pytest
import yaml
from conftest import ROOT

from fakes.desks import OURS, Desk
from tests.pages import pages

LINES = 100
INSTALL = (
    "apt-get update && rosdep update && rosdep install --from-paths src --ignore-src -y && rm -rf /var/lib/apt/lists/*"
)

EXAMPLES = sorted(path.name for path in (ROOT / "examples").iterdir() if path.name not in ("ros1", "ros2"))


@pytest.mark.parametrize("name", EXAMPLES)
def test_an_example_has_a_short_page(name: str) -> None:
    page = (ROOT / f"docs/examples/{name}.md").read_text()
    assert page.count("\n") <= LINES
    assert f"({name}.md)" in (ROOT / "docs/examples/index.md").read_text()
    assert f"../../examples/{name}/" in page, "code is shown by reference"


DOCKERFILES = [file for file in sorted((ROOT / "examples").rglob("Dockerfile")) if file.parent.name != "server"]
"""Those of images with ROS."""


@pytest.mark.parametrize("file", DOCKERFILES, ids=lambda file: file.parent.name)
def test_a_dockerfile_installs_what_packages_need(file: Path) -> None:
    text = file.read_text()
    assert re.match(r"ARG BASE_IMAGE=<registry>/ros\S*\nFROM \$\{BASE_IMAGE\}\n", text)
    if file.parent.name != "jupyter":  # which has no package
        assert f" {INSTALL}\n" in text


def test_every_page_installs_dependencies_by_the_line_that_is_built() -> None:
    """rosdep of the images refuses `--yes`, which an earlier line had."""
    lines = [
        line for page in pages() for line in re.findall(r"apt-get update && .*rosdep install [^`\n]*", page.read_text())
    ]
    assert len(lines) >= 4
    assert [line for line in lines if not INSTALL.startswith(line.replace("--from-paths .", "--from-paths src"))] == []


def test_rosml_run_shows_the_windows_of_the_example(tmp_path: Path) -> None:
    desk = Desk(tmp_path)
    desk.engine(images={"scene": OURS})
    desk.trust(scene=True)
    shutil.copy(ROOT / "examples/rviz/.rosml.toml", desk.folder)
    place = desk.root / "tmp/.X11-unix"
    place.mkdir(parents=True)
    with socket.socket(socket.AF_UNIX) as display:
        display.bind(str(place / "X1"))
        display.listen()
        words = desk.call("--dry-run", DISPLAY=":1").stdout.split()
    shown = re.findall(r"^docker run (.*)$", (ROOT / "docs/examples/rviz.md").read_text(), re.MULTILINE)[0].split()
    assert words[-5:] == ["--network", "host", "--ipc", "host", "scene"] == shown[-5:]
    assert {word for word in shown if word != "…"} <= {*words}, "the page shows what is printed"


def test_a_job_of_gitlab_has_a_name_of_its_own() -> None:
    """Not one that GitLab's syntax has for something else: https://docs.gitlab.com/ci/jobs/#job-name-limitations."""
    theirs = {"image", "services", "stages", "before_script", "after_script", "variables", "cache", "include", "pages"}
    theirs |= {"default", "workflow", "true", "false", "nil", "pages:deploy"}
    jobs = yaml.safe_load((ROOT / "examples/ci/.gitlab-ci.yml").read_text())
    assert jobs and not theirs & {*jobs}
