"""A release from the first command to the last, with a remote on this machine, and a program in the place of gh."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
import zipfile
from datetime import UTC, datetime
from pathlib import Path

import pytest
from conftest import ROOT

from rosml.images.image_set.model import ImageSet
from tests import walk

GH = """\
#!/bin/sh
echo "$*" >>"$CALLS"
case "$*" in "release view "*|"api repos"*) [ -e "$CALLS.there" ] ;; esac
"""


@pytest.fixture
def project(tmp_path: Path) -> Path:
    folder = tmp_path / "project"
    folder.mkdir()
    walk.clone(folder)
    subprocess.run(["git", "init", "--quiet", "--bare", str(tmp_path / "remote.git")], check=True)
    walk.git(folder, "remote", "add", "origin", str(tmp_path / "remote.git"))
    for name in ("user.name", "user.email"):
        walk.git(folder, "config", name, "a")
    return folder


def release(folder: Path, *words: str) -> subprocess.CompletedProcess[str]:
    tools = folder.parent / "programs"
    tools.mkdir(exist_ok=True)
    (tools / "gh").write_text(GH)
    (tools / "gh").chmod(0o755)
    path = f"{tools}{os.pathsep}{ROOT / '.state/bin'}{os.pathsep}{os.environ['PATH']}"
    environment = {**os.environ, "PATH": path, "PYTHONPATH": str(folder / "src"), "CALLS": str(folder.parent / "calls")}
    argv = [sys.executable, "scripts/release.py", *words]
    return subprocess.run(argv, cwd=folder, env=environment, capture_output=True, text=True, check=False)


def test_a_release(project: Path, tmp_path: Path) -> None:
    done = release(project, "start", "9.8.7")
    assert done.returncode == 0, done.stderr
    push = done.stdout.splitlines()[-1].split()
    assert push[:4] == ["git", "push", "--atomic", "origin"] and push[-1] == "v9.8.7"
    walk.git(project, *push[1:])
    assert walk.git(project, "status", "--porcelain") == ""
    clone = tmp_path / "clone"
    walk.git(tmp_path, "clone", "--quiet", "--branch", "v9.8.7", str(tmp_path / "remote.git"), str(clone))
    done = release(clone, "build")
    assert done.returncode == 0, done.stderr
    assert done.stdout.split() == [".state/release/notes.md", ".state/release/rosml-9.8.7-py3-none-any.whl"]
    text = (clone / "CHANGELOG.md").read_text()
    assert f"\n## 9.8.7 ({datetime.now(UTC).date().isoformat()})\n" in text
    assert (clone / ".state/release/notes.md").read_text().strip() in text
    wheel = clone / ".state/release/rosml-9.8.7-py3-none-any.whl"
    zipfile.ZipFile(wheel).extractall(tmp_path / "installed")
    message = subprocess.run(
        [sys.executable, "-m", "rosml", "--version"],
        cwd=tmp_path,
        env={**os.environ, "PYTHONPATH": str(tmp_path / "installed")},
        capture_output=True,
        text=True,
        check=True,
    )
    assert "9.8.7" in message.stdout
    before = wheel.read_bytes()
    assert release(clone, "build").returncode == 0 and wheel.read_bytes() == before
    commit = walk.git(clone, "rev-parse", "HEAD").strip()
    assert release(clone, "publish").returncode == 0
    calls = (tmp_path / "calls").read_text().splitlines()
    assert calls[1].startswith(f"release create v9.8.7 {wheel} --verify-tag ")
    assert calls[-1].endswith(
        f"--method POST repos/{{owner}}/{{repo}}/git/refs --field ref=refs/tags/v9 --field sha={commit}"
    )
    (tmp_path / "calls.there").touch()
    (tmp_path / "calls").unlink()
    assert release(clone, "publish").returncode == 0, "once more, as a job that is run again"
    calls = (tmp_path / "calls").read_text().splitlines()
    assert [call.split()[:2] for call in calls] == [
        ["release", "view"],
        ["release", "upload"],
        ["api", *calls[2].split()[1:2]],
        ["api", "--method"],
    ]
    assert " PATCH " in calls[3] and f"sha={commit}" in calls[3]


@pytest.mark.parametrize(
    ("version", "broken", "message"),
    [
        ("", "", "nothing is no version"),
        ("1.2", "", "1.2 is no version"),
        ("01.2.3", "", "01.2.3 is no version"),
        ("0.0.1", "tag", "0.0.1 is released already"),
        ("0.0.2", "change", "the checkout has changes"),
        ("0.0.2", "changelog", "CHANGELOG.md has no section of what is new"),
        ("0.0.2", "hook", "git commit --all: no"),
    ],
)
def test_what_is_no_release_changes_nothing(version: str, broken: str, message: str, project: Path) -> None:
    if broken == "tag":
        walk.git(project, "tag", "v0.0.1")
    if broken == "change":
        (project / "README.md").write_text("")
    if broken == "changelog":
        (project / "CHANGELOG.md").write_text("# Changes\n")
        walk.git(project, "commit", "--quiet", "--all", "--message", "a")
    if broken == "hook":
        hook = project / ".git/hooks/pre-commit"
        hook.write_text("#!/bin/sh\necho no >&2\nexit 1\n")
        hook.chmod(0o755)
    before = walk.git(project, "rev-parse", "HEAD"), walk.git(project, "diff"), walk.git(project, "tag")
    done = release(project, "start", version)
    assert done.returncode in (1, 2) and message in done.stderr and "\nremedy: " in done.stderr
    assert before == (walk.git(project, "rev-parse", "HEAD"), walk.git(project, "diff"), walk.git(project, "tag"))


def test_only_a_tag_of_this_version_is_built(project: Path) -> None:
    done = release(project, "build")
    assert done.returncode == 1 and "this commit has no tag v" in done.stderr


def test_renovate_raises_the_date_of_a_tag_and_nothing_else(real: ImageSet) -> None:
    """The preset for those who pin dated tags: it knows all of our repositories, and each tag with a date is a version of its own name."""
    [rule] = json.loads((ROOT / "default.json").read_text())["packageRules"]
    repository = re.compile(rule["matchPackageNames"][0].strip("/").replace("\\/", "/"))
    tag = re.compile(rule["versioning"].removeprefix("regex:").replace("(?<", "(?P<"))
    dated = re.compile(rule["matchCurrentValue"].strip("/"))
    for image in real.images:
        for name in image.tags:
            path, _, text = name.partition(":")
            assert repository.search(f"ghcr.io/me/rosml/{path}") and not dated.search(text), "only dated ones"
            match = tag.match(f"{text}-20261126")
            assert match and match.groupdict() == {"compatibility": text, "major": "2026", "minor": "11", "patch": "26"}
            assert dated.search(f"{text}-20261126")
    assert not repository.search("ghcr.io/me/rosml/part") and not repository.search("docker.io/library/debian")
