"""The whole matrix of the project, in a registry in memory: published once, and called again."""

from __future__ import annotations

from pathlib import Path

import pytest
from conftest import ROOT

from fakes.memory_registry import NEXT, publisher
from fakes.projects import copy
from fakes.stubs import services
from rosml.images.image_set import load
from rosml.images.image_set.model import Image, ImageSet, Part
from rosml.images.matrix import source


def whole(root: Path) -> ImageSet:
    """The project's matrix with all its locks: those that cannot be resolved yet are empty files, which do for an input."""
    image_set = load.image_set(source.read(ROOT / "matrix.yaml"))
    for lock in image_set.locks:
        if not (root / lock).is_file():
            (root / lock).parent.mkdir(parents=True, exist_ok=True)
            (root / lock).write_text("")
    return image_set


def test_a_second_run_over_the_whole_matrix_does_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Every image and part on every architecture: nothing is built, tested, written, or told once more."""
    project = copy(tmp_path / "project")
    image_set = whole(project)
    here = publisher(project, services(project), monkeypatch)
    here.packages = dict.fromkeys(image_set.matrix.distributions, "monday")
    things: list[Image | Part] = [*image_set.images, *image_set.parts]
    items = {(thing.target, name) for thing in things for name in thing.architectures}
    assert len(image_set.images) >= 350 and len(items) > 800
    first = here.publish(image_set)
    assert not first.failed
    assert first.uploaded > first.pushed > 0
    assert {(target, name) for step, target, name in first.actions if step in ("build", "join")} == items
    tagged = {path: dict(names) for path, names in here.registry.names.items()}
    main = {image.tags[0] for image in image_set.images if image.tags}
    assert main <= {f"{path.partition('/')[2]}:{name}" for path, names in tagged.items() for name in names}
    here.registry.writes = 0
    here.registry.uploaded = 0
    again = here.publish(image_set, date=NEXT)
    assert (again.actions, again.outcomes, here.registry.writes) == ([], [], 0)
    assert (again.uploaded, again.outcomes) == (0, [])
    assert here.registry.names == tagged
    one = here.publish(image_set, date=NEXT, packages="2", only=["ros1-bookworm-core"], force=True)
    assert one.actions and here.registry.writes, "this test cannot tell a run that does something"
