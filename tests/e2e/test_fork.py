"""A fork made as the documentation says, from an empty folder: all of its unit tests pass, and no step deletes a test or
edits a workflow."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from tests import walk


def raise_an_action(fork: Path) -> None:
    """The last step of docs/nightly.md, "In a fork": another commit and version of an action, wherever it is used."""
    for file in [*(fork / ".github/workflows").glob("*.yml"), *(fork / "containerize").rglob("action.yml")]:
        pin = rf"docker/login-action@{'0' * 40} # v99.0.0"
        file.write_text(re.sub(r"docker/login-action@[0-9a-f]{40} # v[0-9.]+", pin, file.read_text()))
    assert "login-action" in walk.git(fork, "diff")


@pytest.mark.full(proof="fork")
@pytest.mark.timeout(3600)
def test_a_fork_by_the_documentation_passes_its_own_tests(tmp_path: Path) -> None:
    """docs/own-set.md, then docs/nightly.md: an own set, published to an own registry."""
    fork = walk.clone(tmp_path)
    walk.own_set(fork)
    changed = [line.split() for line in walk.git(fork, "status", "--porcelain").splitlines()]
    assert ["??", "set.yaml"] in changed
    assert [name for _, name in changed if name.startswith(("tests/", ".github/")) or name == "matrix.yaml"] == []
    walk.git(fork, "add", "--all")
    walk.git(fork, "commit", "--quiet", "--message", "a set of our own")
    raise_an_action(fork)
    walk.set_up(fork)
    done = walk.unit_tests(fork, processes=2)
    assert done.returncode == 0, done.stdout
    found = re.search(r"(\d+) passed", done.stdout)
    assert found and int(found[1]) > 1000, done.stdout
