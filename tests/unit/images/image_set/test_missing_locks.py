"""Locks that are not there: those that got lost are told, those that wait for PyTorch's own index make no noise."""

from __future__ import annotations

from pathlib import Path

import pytest
from conftest import SMALL, changed, parse, write_locks

from rosml.cli import command
from rosml.cli.images import generate as generate_bake
from rosml.cli.images import tables
from rosml.images.image_set import load as loading
from rosml.images.image_set import missing_locks
from rosml.images.image_set.explain import explained
from rosml.images.image_set.locked import with_locks
from rosml.images.image_set.model import ImageSet

TORCH = "locks/cu1/amd64/3.12/torch.txt"
COMMON = "locks/cpu/amd64/3.14/common.txt"
GONE = "locks/cu1/amd64/3.14/torch.txt"
WAITING = "locks/cpu/amd64/3.12/torch.txt"
ELSEWHERE = 'cpu: [arm64]}, elsewhere: {cpu: {amd64: {"3.14": sha256:' + "4" * 64 + "}}}, requires: [jinja2]}"


@pytest.fixture
def elsewhere() -> ImageSet:
    """The small matrix, where PyTorch's own index has torch for amd64's CPU: with a digest for Python 3.14 alone."""
    return parse(changed("cpu: [arm64]}}", ELSEWHERE))


def without(image_set: ImageSet, *locks: str) -> ImageSet:
    return with_locks(image_set, {lock for part in image_set.parts for lock in part.locks}.difference(locks))


def test_a_lock_waits_where_the_digest_of_its_wheel_is_not_known(elsewhere: ImageSet) -> None:
    assert missing_locks.waiting(elsewhere.matrix, elsewhere.parts) == {WAITING}
    image_set = without(elsewhere, TORCH, WAITING)
    lost, waiting = image_set.image("alpha-core-torch-cu1"), image_set.image("alpha-core-torch-cpu")
    assert (missing_locks.reason(lost), missing_locks.remedy(lost)) == (f"{TORCH} is missing", "run 'rosml locks'")
    assert (missing_locks.reason(waiting), missing_locks.remedy(waiting)) == (
        f"{WAITING} is missing",
        missing_locks.ASK_PYTORCH,
    )
    assert missing_locks.lost(without(elsewhere, WAITING)) is None


def test_what_is_common_to_waiting_releases_alone_waits_with_them() -> None:
    nothing = parse(changed("cpu: [arm64]}}", "cpu: [arm64]}, elsewhere: {cpu: {amd64: {}}}, requires: [jinja2]}"))
    assert missing_locks.waiting(nothing.matrix, nothing.parts) == {WAITING, WAITING.replace("3.12", "3.14"), COMMON}


def test_lost_locks_name_their_images(elsewhere: ImageSet) -> None:
    one = missing_locks.lost(without(elsewhere, TORCH, WAITING))
    assert one and one.message.startswith("6 images cannot be built (alpha-core-torch-cu1, ")
    assert one.message.endswith(f"alpha-core-ml-cu1 and 2 more): {TORCH} is missing") and "git checkout" in one.remedy
    two = missing_locks.lost(without(elsewhere, TORCH, COMMON))
    assert two and f"): {TORCH}, {COMMON} are missing" in two.message


@pytest.fixture
def project(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Arguments of the command for a project of its own with all locks but one."""
    (tmp_path / "matrix.yaml").write_text(SMALL)
    write_locks(tmp_path, parse(SMALL))
    (tmp_path / TORCH).unlink()
    load = loading.load
    monkeypatch.setattr(loading, "load", lambda file, root: load(file, tmp_path))
    return ["--matrix", str(tmp_path / "matrix.yaml"), "--output", str(tmp_path / "out.hcl")]


@pytest.mark.parametrize("damage", ["cut", "a link to nothing"])
def test_a_damaged_lock_is_not_called_missing(tmp_path: Path, damage: str) -> None:
    (tmp_path / "matrix.yaml").write_text(SMALL)
    write_locks(tmp_path, parse(SMALL))
    lock = tmp_path / TORCH
    text = lock.read_text()
    lock.unlink()
    if damage == "cut":
        lock.write_text(text[:-9])
    else:
        lock.symlink_to("nowhere")
    (tmp_path / GONE).unlink()
    image_set = loading.load(tmp_path / "matrix.yaml", tmp_path)
    damaged = f"{TORCH} is damaged, or not of the release that matrix.yaml names"
    assert missing_locks.reason(image_set.image("alpha-core-torch-cu1")) == damaged
    error = missing_locks.lost(image_set)
    assert error and error.message.endswith(f"): {GONE} is missing; {damaged}")
    assert explained(image_set, "alpha-core-torch-cu1").text.endswith(f"{damaged}; run 'rosml locks'")


def test_checking_does_not_ask_to_commit_a_loss(project: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert command.run(generate_bake.main, arguments=[*project, "--check"]) == 1
    stale = capsys.readouterr().err.splitlines()
    assert stale[0].startswith("error: 6 images cannot be built")
    assert stale[1].endswith("out.hcl: outdated")
    restore = command.as_called(missing_locks.RESTORE)
    assert stale[2:] == [f"remedy: {restore}; then run './rosml generate' and commit the result"]
    assert command.run(generate_bake.main, arguments=project) == 0
    lines = capsys.readouterr().err.splitlines()
    assert lines[0].endswith("out.hcl: written")
    assert lines[1].startswith("warning: 6 images cannot be built (alpha-core-torch-cu1, ")
    assert command.run(generate_bake.main, arguments=[*project, "--check"]) == 1
    assert capsys.readouterr().err.splitlines()[1:] == [f"remedy: {restore}"]


def test_listing_tells_both_apart(elsewhere: ImageSet, capsys: pytest.CaptureFixture[str]) -> None:
    tables.print_images(without(elsewhere, TORCH, WAITING).images)
    assert [line.strip() for line in capsys.readouterr().out.splitlines()[-2:]] == [
        f"6 images without a lock, which cannot be built yet: {command.as_called(missing_locks.RESTORE)}",
        f"6 images without a lock, which cannot be built yet: {command.as_called(missing_locks.ASK_PYTORCH)}",
    ]
