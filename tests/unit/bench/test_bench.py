"""`make bench`: both ways are built alike and counted rightly, and nothing is left; with local replacements for buildx and the
registry. The start of `rosml run`. And joins of add-ons, in a registry in this process."""

from __future__ import annotations

import gzip
import json
import re
import shutil
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from conftest import write_locks

from bench import addons, cli, second_image, start
from bench.second_image import Side
from fakes.bakes import printed
from fakes.rebasing import moving
from fakes.stubs import buildx, calls, services
from rosml.base.errors import RosmlError
from rosml.cli import command
from rosml.images.builds.push import COMPRESSION
from rosml.images.image_set.model import ImageSet
from rosml.images.join import file_lists
from rosml.machine.services import Services
from rosml.registry.client import Registry
from tests.e2e.parts import ADDONS, stack

TARGET = "alpha-base-torch-cu1"

BAKE = """
case $1 in prune) exit 0 ;; esac
[ "$target" != "$(cat "$here/broken" 2>/dev/null)" ] || exit 1
if [ -n "$report" ]; then mkdir -p "$report" && cp "$here/${target##*-}.json" "$report/result.json"; exit; fi
echo "$target" >>"$here/pushed"
printf '{"%s": {"containerimage.digest": "sha256:%064d"}}' "$target" "$(grep -c . "$here/pushed")" >"$metadata"
"""
"""Every image that is pushed gets the next number as its digest."""

PUSHED = {
    "ros-yesterday": {"os": 100, "change 1": 5},
    "ros-today": {"os": 100, "change 2": 6},
    "ours-yesterday": {"os": 100, "change 1": 5, "part": 1_000},
    "usual-yesterday": {"os": 100, "change 1": 5, "pip 1": 1_100},
    "ours-today": {"os": 100, "change 2": 6, "part": 1_000},
    "usual-today": {"os": 100, "change 2": 6, "pip 2": 1_101},
}
"""Layers of the images in the order in which they are pushed, with their sizes."""

CONFIG, MANIFEST = 7, 50


class Stage:
    """A checkout with local replacements."""

    def __init__(self, folder: Path, registry: str, image_set: ImageSet) -> None:
        self.folder, self.image_set, self.lines = folder, image_set, list[str]()
        self.removed: list[str] = []
        for number, seconds in enumerate((4.0, 2.0)):
            self.imports(number, seconds)
        write_locks(folder, image_set)
        self.services = services(folder, registry, buildx=buildx(folder, BAKE))

    def imports(self, number: int, seconds: float, version: str = "2.10.0") -> None:
        """What imports of a round say."""
        content = {"seconds": seconds, "versions": {"torch": version}}
        (self.folder / f"{number}.json").write_text(json.dumps(content))

    def compare(self) -> dict[str, Side]:
        return second_image.compare(self.services, self.image_set, self.image_set.image(TARGET), self.lines.append)

    def calls(self, start: str) -> list[str]:
        return [call for call in calls(self.folder) if call.startswith(start)]

    def manifest(self, _registry: Registry, _repository: str, digest: str) -> Any:
        """What was pushed under a number."""
        number = int(digest.rpartition(":")[2])
        layers = [SimpleNamespace(digest=name, size=size) for name, size in list(PUSHED.values())[number - 1].items()]
        config = SimpleNamespace(digest=f"config {number}", size=CONFIG)
        return SimpleNamespace(layers=layers, config=config, digest=digest, size=MANIFEST)

    def delete(self, _registry: Registry, _repository: str, digest: str) -> None:
        """Keeps the number of the manifest."""
        self.removed.append(digest.rpartition(":")[2].lstrip("0"))


@pytest.fixture
def stage(tmp_path: Path, registry: str, small: ImageSet, monkeypatch: pytest.MonkeyPatch) -> Stage:
    free(monkeypatch, 1_000_000)
    new = Stage(tmp_path, registry, small)
    monkeypatch.setattr(Registry, "manifest", lambda *call: new.manifest(*call))
    monkeypatch.setattr(Registry, "delete", lambda *call: new.delete(*call))
    return new


def free(monkeypatch: pytest.MonkeyPatch, megabytes: int) -> None:
    """A file system with so much free space."""
    usage = shutil.disk_usage("/")
    monkeypatch.setattr(shutil, "disk_usage", lambda path: usage._replace(free=megabytes * 1_000_000))


def test_what_is_counted(stage: Stage, capsys: pytest.CaptureFixture[str]) -> None:
    """Of today's image: the registry had the ROS image of today, somebody's machine only yesterday's image."""
    sides = stage.compare()
    ours, usual = sides["ours"], sides["usual"]
    assert (ours.new, usual.new) == (CONFIG + MANIFEST, 1_101 + CONFIG + MANIFEST)
    assert (ours.pulled, usual.pulled) == (6, 6 + 1_101)
    assert ours.imported == usual.imported == 2.0, "the faster one"
    assert min(ours.second, ours.first, usual.second, usual.first) > 0
    second_image.print_table(stage.image_set.image(TARGET), sides)
    assert re.search(r"to pull after a change of ROS +6 B +1\.1 kB", capsys.readouterr().out)


def test_both_ways_are_built_alike(stage: Stage) -> None:
    """On the same ROS images, compressed alike, pushed by digest, from the same locks."""
    stage.compare()
    pushes = [call for call in stage.calls("buildx bake") if "push=true" in call]
    assert len(pushes) == len(PUSHED)
    assert all(f",push=true,push-by-digest=true,{COMPRESSION} " in call for call in pushes)
    for day, number in (("yesterday", 1), ("today", 2)):
        parent = f".contexts.ros=docker-image://{stage.services.registry}/bench/ros@sha256:{number:064d} "
        ours, usual = (call.split()[-1] for call in pushes if parent in call)
        assert ours == TARGET and usual.endswith(f"-usual-{day}")
    text = (stage.folder / f".state/bake/bench-{TARGET}.hcl").read_text()
    locks = (stage.image_set.part_by_name[name].locks[0] for name in stage.image_set.image(TARGET).parts)
    assert text.count(" ".join(f"--requirement /{lock}" for lock in locks)) == 2
    targets = [call.split()[-1] for call in stage.calls("buildx bake")]
    assert printed(*targets, file=stage.folder / f".state/bake/bench-{TARGET}.hcl").keys() >= {*targets}


def test_nothing_is_tagged_and_nothing_is_left(stage: Stage) -> None:
    stage.compare()
    assert stage.removed == list("123456")
    yesterday, marked, pulled = [call.partition("description~=")[2].split()[0] for call in stage.calls("buildx prune")]
    file = (stage.folder / f".state/bake/bench-{TARGET}.hcl").read_text()
    assert yesterday == f"{marked}-usual-yesterday"
    assert all(f"# {marked}-usual-{day}\\n" in file for day in ("yesterday", "today")), "pip's step is among them"
    assert pulled == f"{stage.services.registry}/bench/", "what others built is left alone"


def test_a_build_that_fails_leaves_nothing(stage: Stage) -> None:
    (stage.folder / "broken").write_text(TARGET)
    with pytest.raises(RosmlError, match=f"building {TARGET} failed"):
        stage.compare()
    assert stage.removed == ["1", "2"]


def test_other_versions_are_no_comparison(stage: Stage) -> None:
    stage.imports(1, 2.0, "2.11.0")
    with pytest.raises(RosmlError, match="did not install the same"):
        stage.compare()


def test_no_room(stage: Stage, monkeypatch: pytest.MonkeyPatch) -> None:
    """torch, cuda and common: 3,300 MB unpacked and 330 MB compressed; the usual image twice, its wheels, and ours."""
    free(monkeypatch, 3 * (3_300 + 2 * 330))
    with pytest.raises(RosmlError, match=f"not enough disk space to build {TARGET} in both ways"):
        stage.compare()
    assert not stage.calls("buildx bake")


def test_a_lock_for_another_index(stage: Stage) -> None:
    image = stage.image_set.image(TARGET)
    lock = stage.folder / second_image.locks(image, stage.image_set)[-1]
    lock.write_text(lock.read_text().replace("torch==2.10.0", "torch==2.10.0+cpu"))
    with pytest.raises(RosmlError, match="PyTorch's own index") as caught:
        second_image.require_comparable(image, stage.folder, stage.image_set)
    assert caught.value.exit_code == 2


@pytest.mark.parametrize("target", ["ros1-bookworm-base", "ros1-bookworm-bose-torch-cu128"])
def test_wrong_targets(target: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert command.run(cli.main, arguments=["image", f"--target={target}"]) == 2
    assert target in capsys.readouterr().err


def test_the_start_of_a_container(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    """It is measured beyond the engine's own, and reaches the engine."""
    monkeypatch.setattr(start, "ROUNDS", 1)
    assert command.run(cli.main, arguments=["start"]) == 0
    assert "longer than docker run (median of 1)" in capsys.readouterr().out
    monkeypatch.setattr(start, "ROSML", ("true",))
    with pytest.raises(RosmlError, match="run --rm ubuntu true failed"):
        start.seconds()


def test_joins_of_addons(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], registry: str
) -> None:
    """To an image, to the result, and to an app. Nothing is left, and what takes more than it may is an error."""
    with moving(tmp_path, monkeypatch) as place:
        base = place.base()
        app = place.app(base)
        app_manifest = place.registry.manifest("me/robot", "latest")
        assert app_manifest
        listed = gzip.compress(b"docker-ros/ws/install/lib/node\n", mtime=0)
        place.registry.attach("me/robot", app_manifest.descriptor, file_lists.ARTIFACT, listed, file_lists.MEDIA_TYPE)
        first, second = (stack(place.registry, "rosml/part", ADDONS[name]) for name in ("graph", "devel"))
        before = {*place.server.manifests}
        rows = addons.Bench(place.services, base, app, first, second, place.messages.append).measure()
        assert {*place.server.manifests} == before
    assert [row.what.split()[-1] for row in rows] == ["add-on", "one", "add-on"]
    assert all(row.seconds > 0 and 1_000 < row.uploaded < addons.BYTES for row in rows)
    local = services(tmp_path, registry)
    monkeypatch.setattr(Services, "load", lambda root: local)
    monkeypatch.setattr(addons, "measure", lambda *_: rows)
    assert command.run(cli.main, arguments=["addons"]) == 0
    monkeypatch.setattr(addons, "BYTES", 1_000)
    assert command.run(cli.main, arguments=["addons"]) == 1
    assert capsys.readouterr().err.count("and at most 1.0 kB") == 3
