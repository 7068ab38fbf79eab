"""An own set made as the documentation says, from an empty folder. Without a fork, it is listed, planned and published. In a fork,
all unit tests pass, and no step deletes a test or edits a workflow."""

from __future__ import annotations

import json
import re
import shutil
from pathlib import Path

import pytest

from rosml import ROOT
from rosml.machine.services import Services
from rosml.registry.place import Place
from tests import walk
from tests.e2e.calls import NAMESPACE, rosml, succeeds
from tests.e2e.images import NATIVE


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
    walk.make_set(fork)
    changed = [line.split() for line in walk.git(fork, "status", "--porcelain").splitlines()]
    assert ["??", "set.yaml"] in changed
    assert [name for _, name in changed if name.startswith(("tests/", ".github/")) or name == "matrix.yaml"] == []
    walk.git(fork, "add", "--all")
    walk.git(fork, "commit", "--quiet", "--message", "a set of our own")
    raise_an_action(fork)
    walk.set_up(fork)
    done = walk.unit_tests(fork, processes=2)
    assert done.returncode == 0, done.stdout
    passed = re.search(r"(\d+) passed", done.stdout)
    assert passed and int(passed[1]) > 1000, done.stdout


@pytest.mark.full(proof="fork")
@pytest.mark.timeout(1800)
def test_a_set_without_a_fork(services: Services, tmp_path: Path) -> None:
    """From rosml init --images to tags in a registry, by the set's own command and a rosml that it fetches."""
    program, folder = tmp_path / "rosml", tmp_path / "own"
    program.mkdir()
    walk.clone(program)
    place = f"{services.registry}/{NAMESPACE}/own-set"
    chosen = ("--distribution", "ros1-bookworm", "--registry", place, "--rosml", str(program))
    rosml("init", "--images", str(folder), *chosen, root=program)
    command = str(folder / "rosml")
    listed = succeeds(command, "list", "--json")
    assert {image["distribution"] for image in json.loads(listed.out)} == {"ros1-bookworm"}
    shutil.rmtree(folder / ".rosml/.state/bin")
    for name in ("bin", "buildx", "auth"):  # what `rosml setup` would make
        (folder / ".rosml/.state" / name).symlink_to(ROOT / ".state" / name)
    shutil.copy(ROOT / ".state/services.json", folder / ".rosml/.state")
    selected = ("--registry", place, "--only", "ros1-bookworm-core", "--serve", NATIVE)
    assert " GB in the registry" in succeeds(command, "plan", "--everywhere", *selected).out
    succeeds(command, "publish", "all", *selected)
    assert Place.at(place).client.head(Place.at(place).path("ros"), "ros1-bookworm-core")
