"""The workflow that proposes new locks, its steps read from its file and run one after the other, on a copy of the project
with the small matrix and a local replacement for uv; what it proposes is whole: the second job has nothing but the files it is given."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
from conftest import ROOT, SMALL, parse, write_locks

from fakes.projects import copy_for_generator
from fakes.uv import fake_uv
from fakes.workflows import load
from rosml.containerize.ci import files as ci_files

UPGRADE, PROPOSE = (load("locks")["jobs"][name] for name in ("upgrade", "propose"))
GIT = {f"GIT_{who}_{what}": "a" for who in ("AUTHOR", "COMMITTER") for what in ("NAME", "EMAIL")}


def action(job: dict[str, Any], name: str) -> dict[str, str]:
    [step] = [step for step in job["steps"] if step.get("uses", "").startswith(f"{name}@")]
    options: dict[str, str] = step["with"]
    return options


KEPT = action(UPGRADE, "actions/upload-artifact")["path"].split()
PROPOSED = action(PROPOSE, "peter-evans/create-pull-request")["add-paths"].split()


def git(folder: Path, *arguments: str) -> str:
    command = ["git", *arguments]
    return subprocess.run(
        command, cwd=folder, env={**os.environ, **GIT}, capture_output=True, text=True, check=True
    ).stdout


@pytest.fixture
def checkout(tmp_path: Path) -> Path:
    project = copy_for_generator(tmp_path)
    shutil.rmtree(project / "locks")
    (project / "matrix.yaml").write_text(SMALL)
    write_locks(project, parse(SMALL))
    shutil.copy(ROOT / ".gitignore", project)
    step("./rosml generate", project)
    git(project, "init", "--quiet")
    git(project, "add", "--all")
    git(project, "commit", "--quiet", "--message", "before")
    return project


def step(command: str, folder: Path, **environment: str) -> str:
    (folder / ".state").mkdir(exist_ok=True)
    fake_uv(folder / ".state")
    done = subprocess.run(
        ["bash", "-euo", "pipefail", "-c", command.replace("./rosml ", f"{sys.executable} src ")],
        cwd=folder,
        env={**os.environ, "ROSML_DOCKER_HUB": "0", **environment, "PATH": f"{folder}/.state:{os.environ['PATH']}"},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout + done.stderr


def test_what_is_proposed_is_whole(checkout: Path, tmp_path_factory: pytest.TempPathFactory) -> None:
    for item in UPGRADE["steps"]:
        if "run" in item and " setup " not in item["run"]:
            step(item["run"], checkout, **item.get("env", {}))
    changed = [line[3:] for line in git(checkout, "status", "--porcelain", "--untracked-files=all").splitlines()]
    assert any(name.startswith("locks/") for name in changed), "the local replacement for uv has other versions"
    report = (checkout / "versions.md").read_text()
    assert "moved" in report
    assert "No release on the index is newer than those that the matrix names." in report
    assert [name for name in changed if not name.startswith(tuple(KEPT))] == [], "made, and thrown away"
    assert sorted(PROPOSED) == sorted(set(KEPT) - {"versions.md"})
    second = tmp_path_factory.mktemp("second") / "checkout"
    git(checkout, "clone", "--quiet", str(checkout), str(second))
    for name in KEPT:
        source = checkout / name
        shutil.copytree(source, second / name, dirs_exist_ok=True) if source.is_dir() else shutil.copy(
            source, second / name
        )
    step("./rosml generate", second)
    assert set(git(second, "status", "--porcelain", "--untracked-files=all").splitlines()) == set(
        git(checkout, "status", "--porcelain", "--untracked-files=all").splitlines()
    )


def test_whatever_is_generated_is_handed_over(checkout: Path) -> None:
    """Also what new versions happen to leave alone today: every file that the generator can write, but for those that come
    from the table of inputs of rosml containerize."""
    generated = [
        line.split(":")[0] for line in step("./rosml generate", checkout).splitlines() if "is up to date" in line
    ]
    written = [name for name in generated if name not in ci_files.FILES]
    assert len(written) == 8
    assert [name for name in written if not name.startswith(tuple(KEPT))] == []
