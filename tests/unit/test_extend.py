"""A newcomer adds a distribution, a release and a stack by the page that says how, on a copy of the project."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from conftest import ROOT

from rosml import expand
from rosml.expand import Catalogue
from tests import fork
from tests.documented import Block, blocks, commands

PAGE = ROOT / "docs/extend.md"
NEEDS_NETWORK = ("make locks", "make image")
"""Steps of the page that are not followed here: tests/documented.yaml says what shows that they work."""


@pytest.fixture
def project(tmp_path: Path) -> Path:
    """A copy of all that the generator reads and writes."""
    for name in ("components", "locks", "rosml", "scripts", "tests/structure", "tools"):
        shutil.copytree(ROOT / name, tmp_path / name, ignore=shutil.ignore_patterns("__pycache__"))
    for name in ("matrix.yaml", "matrix.schema.json", "docker-bake.hcl", "Dockerfile", "Makefile", "README.md"):
        shutil.copy(ROOT / name, tmp_path)
    for name in ("catalogue.schema.json", "docs/built.json", "docs/built.md"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        shutil.copy(ROOT / name, tmp_path / name)
    return tmp_path


def section(name: str) -> Iterator[Block]:
    return (block for block in blocks(PAGE) if block.section == name)


def insert(project: Path, block: Block) -> None:
    """Puts an entry where its title says, before the first thing that is less indented, or is there already."""
    file, _, place = block.title.partition(", ")
    path = [f"{'  ' * depth}{key}:" for depth, key in enumerate(place.split("."))]
    lines = (project / file).read_text().split("\n")
    at = 0
    for key in path:
        at = next(number for number in range(at, len(lines)) if lines[number].split(" #")[0] == key) + 1
    indent = "  " * len(path)
    while lines[at].startswith(indent) or lines[at].lstrip().startswith("#"):
        at += 1
    lines[at:at] = block.text.rstrip("\n").split("\n")
    (project / file).write_text("\n".join(lines))


def follow(project: Path, name: str) -> str:
    """Follows a section of the page, step by step; gives what the commands printed."""
    said = ""
    for block in section(name):
        if block.title:
            insert(project, block)
        for command in commands(block) if block.language == "sh" else ():
            if not command.startswith(NEEDS_NETWORK):
                argv = [*command.split(), "BOOTSTRAP=:", f"RUN={sys.executable}"]
                done = subprocess.run(argv, cwd=project, env=os.environ, capture_output=True, text=True, check=False)
                assert done.returncode == 0, f"{command}: {done.stderr}"
                said += f"$ {command}\n{done.stdout}{done.stderr}"
    return said


def test_a_distribution(project: Path, real: Catalogue) -> None:
    [entry] = [block for block in section("A distribution") if block.title]
    assert entry.text.count("\n") <= 10
    said = follow(project, "A distribution")
    assert "docker-bake.hcl: written" in said and "README.md: written" in said
    assert "warning" not in said
    assert "example-desktop-ml-cu128" in said
    assert "example-base-torch-cu128 exists:" in said
    assert "locks/" not in said, "no lock is new"
    assert (
        "| `example` | 2 | ubuntu-24.04, 3.12 | core, base, desktop | 2032-05-31 (LTS) |"
        in (project / "README.md").read_text()
    )
    made = expand.load(project / "matrix.yaml", project)
    new = {image.target for image in made.images} - {image.target for image in real.images}
    assert new and all(target.startswith("example-") for target in new)
    assert all(image.locked for image in made.images if image.target in new and not image.target.endswith("-cpu"))


def test_a_release_and_a_stack(project: Path, real: Catalogue) -> None:
    insert(project, next(section("A release of PyTorch or TensorFlow")))
    said = follow(project, "A stack")
    assert "jazzy-base-torch-cu126 exists, but cannot be built yet:" in said
    assert "run 'make locks'" in said
    assert "stack cu126 carries torch 2.7.1, cuda 12.6.77, cudnn 9.5.1.17 and nccl 2.26.2" in said
    made = expand.load(project / "matrix.yaml", project)
    new = {image.target for image in made.images} - {image.target for image in real.images}
    assert new and all(target.endswith("-cu126") for target in new)


def test_a_step_that_is_left_out_is_told(project: Path) -> None:
    """A stack without its forecast."""
    blocks_of_stack = [block for block in section("A stack") if block.title]
    insert(project, next(section("A release of PyTorch or TensorFlow")))
    insert(project, blocks_of_stack[0])
    argv = ["make", "generate", "BOOTSTRAP=:", f"RUN={sys.executable}"]
    done = subprocess.run(argv, cwd=project, capture_output=True, text=True, check=False)
    assert done.returncode != 0
    assert "cu126" in done.stderr and "disk" in done.stderr


def test_a_set_of_ones_own(project: Path) -> None:
    """Two rows of ours, as a fork would keep them: what nothing uses any more is in nobody's way."""
    matrix = project / "matrix.yaml"
    before, _, rest = matrix.read_text().partition("\ndistributions:\n")
    rows, _, after = rest.partition("\ndisk:")
    kept = "".join(row for row in re.split(r"(?m)^(?=  \S+:$)", rows) if row.startswith(("  humble:", "  jazzy:")))
    for ours, theirs in (("bookworm-core-torch-cu128", "jazzy-base-torch-cu128"), ("[bookworm-core]", "[jazzy-core]")):
        assert ours in before
        before = before.replace(ours, theirs)
    matrix.write_text(f"{before}\ndistributions:\n{kept}\ndisk:{after}")
    argv = ["make", "generate", "BOOTSTRAP=:", f"RUN={sys.executable}"]
    refused = subprocess.run(argv, cwd=project, capture_output=True, text=True, check=False)
    assert refused.returncode != 0 and "remedy: remove that section" in refused.stderr, "what we built is not theirs"
    page = project / "docs/built.md"
    page.write_text(page.read_text().partition("\n## On ")[0] + "\n")
    done = subprocess.run(argv, cwd=project, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert "noetic" not in (project / "README.md").read_text().partition("<!-- images:")[2]
    made = expand.load(matrix, project)
    assert {image.target.split("-")[0] for image in made.images} == {"humble", "jazzy"}
    check = [sys.executable, "scripts/generate_bake.py", "--check"]
    assert subprocess.run(check, cwd=project, check=False).returncode == 0


def test_what_a_fork_skips_is_there() -> None:
    """A test of ours that is renamed would fail in every fork."""
    for name in fork.OURS:
        file, _, function = name.partition("::")
        assert (ROOT / "tests" / file).exists(), name
        assert not function or f"\ndef {function}(" in (ROOT / "tests" / file).read_text(), name
