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
from rosml.images.image_set.locked import with_locks
from rosml.images.publish import revision


def found(folder: Path, *arguments: str) -> dict[str, Any]:
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
    """Neither in a clean checkout, nor after changes that reach no image."""
    count = len(parse(SMALL).images)
    nothing: dict[str, Any] = {
        "added": [],
        "removed": [],
        "changed": {},
        "tags": {},
        "unbuildable": [],
        "registry": None,
    }
    assert found(repository, "HEAD") == nothing | {"same": count}
    (repository / "matrix.yaml").write_text(f"# A comment.\n{SMALL}")
    (repository / "README.md").write_text("")
    cache = repository / "components/part/__pycache__"
    cache.mkdir(exist_ok=True)
    (cache / "x.pyc").touch()
    done = diff(repository, "HEAD")
    assert (done.returncode, done.stdout) == (0, f"0 added, 0 removed, 0 changed, {count} same\n")


def test_a_revision_counts_with_all_of_its_files(repository: Path) -> None:
    script = repository / INSTALL
    script.write_text(script.read_text() + "true\n")
    commit(repository)
    assert found(repository, "HEAD")["changed"] == {}
    result = found(repository, "HEAD~1")
    assert result["changed"].keys() == parse(SMALL).by_target.keys()
    for (change,) in result["changed"].values():
        assert change["input"] == INSTALL
        assert len(change["old"]) == len(change["new"]) == len(f"{'0' * 64} executable")
        assert change["old"] != change["new"]


def test_added_removed_and_changed(repository: Path) -> None:
    text = changed("components: [core, base]\n", "components: [core, base, robot]\n")
    text = changed("components: [core, base, desktop]\n", "components: [core, desktop]\n", text)
    (repository / "matrix.yaml").write_text(text)
    result = found(repository, "HEAD")
    before, after = parse(SMALL).by_target, parse(text).by_target
    assert set(result["added"]) == after.keys() - before.keys() == {name for name in after if "omega-robot" in name}
    assert set(result["removed"]) == before.keys() - after.keys() == {name for name in before if "alpha-base" in name}
    assert set(result["changed"]) == {name for name in after if "alpha-desktop" in name}
    parent = {"input": "parent", "old": "alpha-base", "new": "alpha-core"}
    assert result["changed"]["alpha-desktop"] == [parent]


def test_another_matrix(repository: Path, tmp_path: Path) -> None:
    """Only the matrix is another one: changed scripts are the same on both sides."""
    (tmp_path / "other.yaml").write_text(changed("1" * 64, "3" * 64))
    (repository / INSTALL).write_text("")
    result = found(repository, "../other.yaml")
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
    assert "does not understand the matrix of revision HEAD:\nHEAD:matrix.yaml:1:1: version:" in done.stderr
    assert "remedy: compare with a later revision" in done.stderr


def test_an_older_version_without_a_matrix(repository: Path) -> None:
    (repository / "matrix.yaml").unlink()
    commit(repository)
    (repository / "matrix.yaml").write_text(SMALL)
    done = diff(repository, "HEAD")
    assert (done.returncode, "revision HEAD has no matrix.yaml" in done.stderr) == (2, True)


@pytest.mark.parametrize("revision", ["nowhere", "", "-x", "HEAD:matrix.yaml", "HEAD~9", "components"])
def test_an_unknown_revision(revision: str, repository: Path) -> None:
    done = diff(repository, revision)
    assert (done.returncode, done.stdout) == (2, "")
    assert f"error: no revision and no file named {revision!r}\nremedy: see the revisions" in done.stderr


def test_not_a_checkout(repository: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("GIT_CEILING_DIRECTORIES", str(repository.parent))
    shutil.rmtree(repository / ".git")
    done = diff(repository, "HEAD")
    assert (done.returncode, done.stdout) == (1, "")
    assert "not a git repository" in done.stderr
    assert "remedy: call it in a git checkout" in done.stderr


def test_no_git(repository: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PATH", "/nowhere")
    with pytest.raises(RosmlError, match="git is not installed"):
        revision.since("HEAD", Inputs(repository, parse(SMALL)))


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
    shown = list(result.changed)[: problems.SOME]
    assert images == f"{', '.join(shown)} and {len(result.changed) - problems.SOME} more"
    tables.print_difference(result)
    lines = capsys.readouterr().out.splitlines()
    assert len(lines) == 3
    assert lines[-1] == f"0 added, 0 removed, {len(result.changed)} changed, {result.same} same"


def test_reasons_that_overlap_have_rows_of_their_own() -> None:
    """Not a row for every combination: those would be many where several things changed."""
    packages = "packages: ros-{ros_distro}-{metapackage}\n    components: [core, base, desktop]"
    text = changed(packages, packages.replace("}\n", "} x\n"))
    result = since(changed("digest: sha256:" + "1" * 64, "digest: sha256:" + "3" * 64, text))
    reasons = [(why, images.split(",")[0]) for _, why, images in differences.rows(result)]
    packages = "argument ROS_PACKAGES: nothing → x"
    assert [image for why, image in reasons if why == packages] == ["alpha-core", "alpha-base", "alpha-desktop"]
    assert [why for why, _ in reasons if why != packages] == [
        "base image docker.io/library/ubuntu:24.04: sha256:111111111111 → sha256:333333333333"
    ]


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("a b c", "a d c", "b → d"),
        ("a b", "a b c", "nothing → c"),
        ("a b", "b a", "a b → b a"),
        (None, "a", "nothing → a"),
    ],
)
def test_only_the_words_that_differ_are_shown(old: str | None, new: str, words: str) -> None:
    result = differences.Difference((), (), {"image": (differences.Change("packages", old, new),)}, 0)
    assert list(differences.rows(result)) == [("changed", f"packages: {words}", "image")]


def test_labels_are_told_where_nothing_else_changed() -> None:
    """They name each image's versions in words of its own, and would put each image on a row of its own."""
    version = since(changed("cudnn: 9.10.2.21", "cudnn: 9.10.2.22"))
    assert {item.input for why in version.changed.values() for item in why} == {
        "environment CUDNN_VERSION",
        "label io.rosml.cudnn",
    }
    assert [why for _, why, _ in differences.rows(version)] == ["environment CUDNN_VERSION: 9.10.2.21 → 9.10.2.22"]
    address = since(changed("source: https://example.org/images\n", ""))
    ((_, why, _),) = differences.rows(address)
    assert why == "label org.opencontainers.image.source: https://example.org/images → nothing"


def test_tags_that_move(capsys: pytest.CaptureFixture[str]) -> None:
    """Another stack takes the short tags: nobody should learn of that from their own image."""
    newer = changed("    default_stack: cu1\n", "    default_stack: cpu\n")
    found = differences.between(Inputs(ROOT, parse(SMALL)), Inputs(ROOT, parse(newer)))
    assert found.tags == {
        "ros-torch:alpha": ("alpha-base-torch-cu1", "alpha-base-torch-cpu"),
        "ros-torch:latest": ("alpha-base-torch-cu1", "alpha-base-torch-cpu"),
        "ros-ml:alpha": ("alpha-base-ml-cu1", "alpha-base-ml-cpu"),
        "ros-ml:latest": ("alpha-base-ml-cu1", "alpha-base-ml-cpu"),
        "ros-cuda:alpha": ("alpha-base-cuda-cu1", None),
        "ros-cuda:latest": ("alpha-base-cuda-cu1", None),
    }
    tables.print_difference(found)
    lines = [line.split() for line in capsys.readouterr().out.splitlines()]
    assert lines[1:-1] == [
        ["tags", "moved", "alpha-base-torch-cu1", "→", "alpha-base-torch-cpu", "ros-torch:alpha,", "ros-torch:latest"],
        ["tags", "moved", "alpha-base-ml-cu1", "→", "alpha-base-ml-cpu", "ros-ml:alpha,", "ros-ml:latest"],
        ["2", "tags", "gone", "ros-cuda:alpha,", "ros-cuda:latest"],
    ]


def test_an_architecture_that_is_added() -> None:
    result = since(changed("wheels: {cu1: [amd64], cpu: [arm64]}", "wheels: {cu1: [amd64], cpu: [amd64, arm64]}"))
    (change,) = result.changed["alpha-core-torch-cpu"]
    assert change == differences.Change("architecture amd64", None, "built")
    assert len(list(differences.rows(result))) == 1


def test_another_parent_is_told_once_for_both_architectures() -> None:
    """And not as the digests of two parents on each."""
    result = since(changed("desktop: {builds_on: robot}", "desktop: {builds_on: core}"))
    (first, *rest) = differences.rows(result)
    assert first[:2] == ("changed", "stands on alpha-core instead of alpha-base")
    assert rest == []


def test_another_system_and_its_parts() -> None:
    """Alpha moves to omega's system, and so to another Python."""
    text = changed("  alpha:\n    os: ubuntu-24.04", "  alpha:\n    os: ubuntu-26.04")
    text = changed("    apt: {channel: live}", "    apt: {channel: final}", text)
    reasons = "\n".join(why for _, why, _ in differences.rows(since(text)))
    assert "stands on ubuntu-26-04 instead of ubuntu-24-04" in reasons
    assert "with torch-cu1-py314" in reasons
    assert "without torch-cu1-py312" in reasons


def test_images_that_cannot_be_built(capsys: pytest.CaptureFixture[str]) -> None:
    """Two rows of components more, and only some locks; what changed comes first, what is added next."""
    text = changed("components: [core, base]\n", "components: [core, base, desktop]\n")
    text = changed("digest: sha256:" + "2" * 64, "digest: sha256:" + "3" * 64, text)
    locks = {lock for part in parse(text).parts for lock in part.locks if "/3.14/" not in lock}
    result = differences.between(Inputs(ROOT, parse(SMALL)), Inputs(ROOT, with_locks(parse(text), locks)))
    added = [f"omega-desktop-torch-{stack}" for stack in ("cu1", "cpu")]
    assert set(added) < set(result.unbuildable) <= {*result.added, *result.changed}
    rows = [(kind, why, which) for kind, why, which in differences.rows(result) if not why.startswith("base image")]
    assert [row[:2] for row in rows] == [
        ("changed", differences.NO_LOCK),
        ("added", differences.NO_LOCK),
        ("added", ""),
    ]
    assert rows[1][2] == ", ".join(added)
    assert "torch" not in rows[2][2]
    tables.print_difference(result)
    unlocked = len(result.unbuildable) - 2
    last = capsys.readouterr().out.splitlines()[-1]
    assert f"{len(result.added)} added (2 without a lock), 0 removed, " in last
    assert f"{len(result.changed)} changed ({unlocked} without a lock), " in last


def test_another_registry(capsys: pytest.CaptureFixture[str]) -> None:
    result = since(changed("registry: localhost:5000", "registry: example.org/x"))
    assert result.registry == ("localhost:5000", "example.org/x")
    tables.print_difference(result)
    lines = capsys.readouterr().out.splitlines()
    assert lines[0] == "registry: localhost:5000 → example.org/x; all names change"
    assert lines[1:] == [f"0 added, 0 removed, 0 changed, {result.same} same"]


def test_many_tags_that_come_and_go() -> None:
    """A renamed repository: no row for each of its tags."""
    rows = list(differences.rows(since(changed("repository: ros-torch", "repository: torch"))))
    assert [kind for kind, _, _ in rows] == ["23 tags gone", "23 tags gained"]
    assert rows[0][2] == (
        "ros-torch:alpha-core-cu1, ros-torch:alpha-core-cu1-torch2.10.0, ros-torch:alpha-base-cu1, "
        "ros-torch:alpha-base-cu1-torch2.10.0 and 19 more"
    )


def test_no_spaces_at_the_end_of_a_line(capsys: pytest.CaptureFixture[str]) -> None:
    tables.print_difference(since(changed("1" * 64, "3" * 64)))
    lines = capsys.readouterr().out.splitlines()
    assert [line for line in lines if line != line.rstrip()] == []


def test_few_names_are_all_shown() -> None:
    result = differences.Difference(("a", "b", "c", "d", "e"), tuple("abcdef"), {}, 0)
    assert list(differences.rows(result)) == [("added", "", "a, b, c, d, e"), ("removed", "", "a, b, c, d and 2 more")]
