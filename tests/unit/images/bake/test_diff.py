"""What differs between two versions, and why: in a git repository of its own, by the command as a user calls it."""

from __future__ import annotations

import json
import shutil
from pathlib import Path
from typing import Any

import pytest
from conftest import ROOT, SMALL, changed, parse

from fakes.projects import INSTALL, commit, diff
from rosml.base import problems
from rosml.base.errors import RosmlError
from rosml.cli.images import tables
from rosml.images.bake import diff as differences
from rosml.images.bake.inputs import Inputs
from rosml.images.environments.lock import Lock
from rosml.images.image_set.locked import with_locks
from rosml.images.publish import revision


def changes(folder: Path, *arguments: str) -> dict[str, Any]:
    done = diff(folder, *arguments, "--json")
    assert (done.returncode, done.stderr) == (0, "")
    result: dict[str, Any] = json.loads(done.stdout)
    assert list(result) == ["added", "removed", "changed", "same", "tags", "unbuildable", "registry"]
    return result


def since(text: str, root: Path = ROOT) -> differences.Difference:
    """From the small matrix to another one."""
    return differences.between(Inputs(root, parse(SMALL)), Inputs(root, parse(text)))


# ---- The command -----------------------------------------------------------------------------------------------------


def test_nothing_differs(repository: Path) -> None:
    count = len(parse(SMALL).images)
    result = changes(repository, "HEAD")
    assert result.pop("same") == count and not any(result.values())
    (repository / "matrix.yaml").write_text(f"# A comment.\n{SMALL}")
    (repository / "README.md").write_text("")
    cache = repository / "components/part/__pycache__"
    cache.mkdir(exist_ok=True)
    (cache / "x.pyc").touch()
    done = diff(repository, "HEAD")
    assert (done.returncode, done.stdout) == (0, f"0 added, 0 removed, 0 changed, {count} same\n")


def test_an_environment_counts_with_its_locks(repository: Path) -> None:
    """What their heads say is in the bake file, so both sides read them."""
    entry = "environments:\n  grasp: {images: [alpha-core-torch-cu1], architectures: [amd64], disk: {unpacked: 1, compressed: 1}}\n"
    (repository / "matrix.yaml").write_text(changed("\nreleases:\n", f"\n{entry}releases:\n", SMALL))
    place = repository / "environments/grasp/3.12/amd64.txt"
    place.parent.mkdir(parents=True)
    place.write_text(str(Lock("grasp", "3.12", "amd64", 39, {}, {})))
    (repository / "tests/structure/environment.yaml").write_text("schemaVersion: 2.0.0\n")
    commit(repository)
    result = changes(repository, "HEAD")
    assert not result["changed"] and changes(repository, "HEAD~1")["added"] == ["alpha-core-torch-cu1-env-grasp"]


def test_a_revision_counts_with_all_of_its_files(repository: Path) -> None:
    script = repository / INSTALL
    script.write_text(script.read_text() + "true\n")
    commit(repository)
    assert changes(repository, "HEAD")["changed"] == {}
    result = changes(repository, "HEAD~1")
    assert result["changed"].keys() == parse(SMALL).by_target.keys()
    for (change,) in result["changed"].values():
        assert change["input"] == INSTALL and change["old"] != change["new"]


def test_added_removed_and_changed(repository: Path) -> None:
    text = changed("components: [core, base]\n", "components: [core, base, robot]\n")
    text = changed("components: [core, base, desktop]\n", "components: [core, desktop]\n", text)
    (repository / "matrix.yaml").write_text(text)
    result = changes(repository, "HEAD")
    before, after = parse(SMALL).by_target, parse(text).by_target
    assert set(result["added"]) == after.keys() - before.keys() == {name for name in after if "omega-robot" in name}
    assert set(result["removed"]) == before.keys() - after.keys() == {name for name in before if "alpha-base" in name}
    assert set(result["changed"]) == {name for name in after if "alpha-desktop" in name}
    parent = {"input": "parent", "old": "alpha-base", "new": "alpha-core"}
    assert result["changed"]["alpha-desktop"] == [parent]


def test_another_matrix(repository: Path, tmp_path: Path) -> None:
    (tmp_path / "other.yaml").write_text(changed("1" * 64, "3" * 64))
    (repository / INSTALL).write_text("")
    result = changes(repository, "../other.yaml")
    reason = {
        "input": "base image docker.io/library/ubuntu:24.04",
        "old": f"sha256:{'3' * 64}",
        "new": f"sha256:{'1' * 64}",
    }
    assert result["changed"]["alpha-core"] == [reason]
    assert "omega-core" not in result["changed"]


def test_an_older_matrix_that_is_refused(repository: Path) -> None:
    (repository / "matrix.yaml").write_text(changed("version: 1\n", "version: 9\n"))
    commit(repository)
    (repository / "matrix.yaml").write_text(SMALL)
    done = diff(repository, "HEAD")
    assert (done.returncode, done.stdout) == (2, "")
    assert "HEAD:matrix.yaml:1:1: version:" in done.stderr and "remedy: " in done.stderr


@pytest.mark.parametrize("revision", ["nowhere", "", "-x", "HEAD:matrix.yaml"])
def test_an_unknown_revision(revision: str, repository: Path) -> None:
    done = diff(repository, revision)
    assert (done.returncode, done.stdout) == (2, "")
    assert f"no revision and no file named {revision!r}" in done.stderr


def test_not_a_checkout(repository: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("GIT_CEILING_DIRECTORIES", str(repository.parent))
    shutil.rmtree(repository / ".git")
    done = diff(repository, "HEAD")
    assert (done.returncode, done.stdout) == (1, "") and "not a git repository" in done.stderr


def test_a_link_out_of_the_checkout(repository: Path) -> None:
    (repository / "link").symlink_to("/etc/passwd")
    commit(repository)
    with pytest.raises(RosmlError, match="cannot be unpacked"):
        revision.since("HEAD", Inputs(repository, parse(SMALL)))


# ---- The table -------------------------------------------------------------------------------------------------------


def test_images_that_change_for_one_reason_share_a_row(capsys: pytest.CaptureFixture[str]) -> None:
    result = since(changed("1" * 64, "3" * 64))
    ((kind, why, images),) = differences.rows(result)
    assert kind == "changed"
    assert why == "base image docker.io/library/ubuntu:24.04: sha256:111111111111 → sha256:333333333333"
    assert images.endswith(f" and {len(result.changed) - problems.SOME} more")
    tables.print_difference(result)
    lines = capsys.readouterr().out.splitlines()
    assert len(lines) == 3
    assert lines[-1] == f"0 added, 0 removed, {len(result.changed)} changed, {result.same} same"


def test_reasons_that_overlap_have_rows_of_their_own() -> None:
    packages = "packages: ros-{ros_distro}-{metapackage}\n    components: [core, base, desktop]"
    text = changed(packages, packages.replace("}\n", "} x\n"))
    result = since(changed("digest: sha256:" + "1" * 64, "digest: sha256:" + "3" * 64, text))
    reasons = [(why, images.split(",")[0]) for _, why, images in differences.rows(result)]
    packages = "argument ROS_PACKAGES: nothing → x"
    assert [image for why, image in reasons if why == packages] == ["alpha-core", "alpha-base", "alpha-desktop"]
    assert [why for why, _ in reasons if why != packages] == [
        "base image docker.io/library/ubuntu:24.04: sha256:111111111111 → sha256:333333333333"
    ]


def test_labels_are_told_where_nothing_else_changed() -> None:
    version = since(changed("cudnn: 9.10.2.21", "cudnn: 9.10.2.22"))
    assert {item.input for why in version.changed.values() for item in why} == {
        "environment CUDNN_VERSION",
        "label io.rosml.cudnn",
    }
    assert [why for _, why, _ in differences.rows(version)] == ["environment CUDNN_VERSION: 9.10.2.21 → 9.10.2.22"]
    address = since(changed("source: https://example.org/images\n", ""))
    ((_, why, _),) = differences.rows(address)
    assert why == "label org.opencontainers.image.source: https://example.org/images → nothing"


@pytest.mark.parametrize(
    ("before", "after", "rows"),
    [
        ("cu1: [amd64], cpu: [arm64]}", "cu1: [amd64], cpu: [amd64, arm64]}", ["architecture amd64: nothing → built"]),
        ("desktop: {builds_on: robot}", "desktop: {builds_on: core}", ["stands on alpha-core instead of alpha-base"]),
        ("repository: ros-torch", "repository: torch", ["23 tags gone", "23 tags gained"]),
        ("registry: localhost:5000", "registry: example.org/x", []),
    ],
)
def test_one_reason_has_one_row(before: str, after: str, rows: list[str]) -> None:
    result = since(changed(before, after))
    assert [why if kind == "changed" else kind for kind, why, _ in differences.rows(result)] == rows
    assert (result.registry is not None) == ("registry" in before)


@pytest.mark.parametrize(
    ("old_words", "new_words", "shown"),
    [("a b c", "a d c", "b → d"), ("a b", "b a", "a b → b a"), (None, "a", "nothing → a")],
)
def test_only_the_words_that_differ_are_shown(old_words: str | None, new_words: str, shown: str) -> None:
    change = differences.Change("packages", old_words, new_words)
    result = differences.Difference((), tuple("abcdef"), {"image": (change,)}, 0)
    assert [*differences.rows(result)] == [
        ("changed", f"packages: {shown}", "image"),
        ("removed", "", "a, b, c, d and 2 more"),
    ]


def test_tags_that_move() -> None:
    changes = since(changed("    default_stack: cu1\n", "    default_stack: cpu\n"))
    assert changes.tags == {
        "ros-torch:alpha": ("alpha-base-torch-cu1", "alpha-base-torch-cpu"),
        "ros-torch:latest": ("alpha-base-torch-cu1", "alpha-base-torch-cpu"),
        "ros-ml:alpha": ("alpha-base-ml-cu1", "alpha-base-ml-cpu"),
        "ros-ml:latest": ("alpha-base-ml-cu1", "alpha-base-ml-cpu"),
        "ros-cuda:alpha": ("alpha-base-cuda-cu1", None),
        "ros-cuda:latest": ("alpha-base-cuda-cu1", None),
    }
    assert [*differences.rows(changes)] == [
        ("tags moved", "alpha-base-torch-cu1 → alpha-base-torch-cpu", "ros-torch:alpha, ros-torch:latest"),
        ("tags moved", "alpha-base-ml-cu1 → alpha-base-ml-cpu", "ros-ml:alpha, ros-ml:latest"),
        ("2 tags gone", "", "ros-cuda:alpha, ros-cuda:latest"),
    ]


def test_images_that_cannot_be_built(capsys: pytest.CaptureFixture[str]) -> None:
    text = changed("components: [core, base]\n", "components: [core, base, desktop]\n")
    text = changed("digest: sha256:" + "2" * 64, "digest: sha256:" + "3" * 64, text)
    locks = {lock for part in parse(text).parts for lock in part.locks if "/3.14/" not in lock}
    result = differences.between(Inputs(ROOT, parse(SMALL)), Inputs(ROOT, with_locks(parse(text), locks)))
    added = [f"omega-desktop-torch-{stack}" for stack in ("cu1", "cpu")]
    assert set(added) < set(result.unbuildable) <= {*result.added, *result.changed}
    rows = [row for row in differences.rows(result) if not row[1].startswith("base image")]
    assert [row[:2] for row in rows] == [
        ("changed", differences.NO_LOCK),
        ("added", differences.NO_LOCK),
        ("added", ""),
    ]
    assert rows[1][2] == ", ".join(added) and "torch" not in rows[2][2]
    tables.print_difference(result)
    unlocked = len(result.unbuildable) - 2
    last = capsys.readouterr().out.splitlines()[-1]
    assert f"{len(result.added)} added (2 without a lock), 0 removed, " in last
    assert f"{len(result.changed)} changed ({unlocked} without a lock), " in last
