"""What the builder is told of an image, and what its structure tests come to, with a local replacement for buildx."""

from __future__ import annotations

import json
import shutil
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, cast

import pytest
from conftest import changed, parse, write_locks

from fakes.stubs import buildx, calls, services
from rosml.base.errors import RosmlError
from rosml.images.builds import base_images, disk, sync
from rosml.images.builds.maker import BuildKitMaker, Checked, require_buildable
from rosml.images.image_set import apt_repository, locked
from rosml.images.image_set import model as sets
from rosml.machine.services import Services
from rosml.registry import documents
from rosml.registry.oci import Config, Manifest
from rosml.registry.place import Place

TARGET = "alpha-base"
MANIFEST = "sha256:" + "a" * 64
FILES = [
    *("contract", "tools", "ros2", "ros2-beside", "ros2-base", "ros2-components", "ros2-core", "ros2-workspace", "pip"),
    "metadata",
]
SYNC = "2026-11-20T21:14:09Z"

BAKE = """
env >"$here/env-$1"
[ ! -d "$here/report" ] || cp -r "$here/report" "$report"
exit "$(cat "$here/code")"
"""


def results(**passed: bool) -> str:
    """A report of container-structure-test."""
    outcomes = [
        {"Name": name, "Pass": value, **({} if value else {"Errors": ["it broke"]})} for name, value in passed.items()
    ]
    return json.dumps({"Results": outcomes})


def of_layers(*sizes: int) -> dict[str, Any]:
    """A manifest with layers of so many bytes."""
    layers = [{"mediaType": "x", "digest": f"sha256:{n:064}", "size": size} for n, size in enumerate(sizes)]
    return {"schemaVersion": 2, "layers": layers}


@dataclass
class OneManifest:
    """A registry that has one manifest."""

    content: dict[str, Any]
    host: str = "127.0.0.1:1"

    def manifest(self, _repository: str, reference: str) -> Manifest | None:
        return Manifest(self.content, MANIFEST, "", 1) if reference == MANIFEST else None

    def config(self, _repository: str, _manifest: Manifest) -> Config:
        content = {"config": {"Labels": {"io.rosml.torch": "2.10.0", "other": "1"}}}
        return Config(content, documents.Config())


@dataclass
class Stage:
    """A checkout with local replacements; its files say how they behave."""

    folder: Path
    image_set: sets.ImageSet
    registry: OneManifest = field(default_factory=lambda: OneManifest(of_layers(30)))
    said: list[str] = field(default_factory=list)

    def __post_init__(self) -> None:
        (self.folder / "report").mkdir()
        self.write("code", "0")
        for name in FILES:
            self.write(f"report/{name}.json", results(one=True, two=True))
        self.write("report/unpacked", "4 /")
        self.write("report/versions", "python3 3.12.3\n")
        write_locks(self.folder, self.image_set)
        services(self.folder, "127.0.0.1:1", buildx=buildx(self.folder, BAKE))

    def write(self, name: str, text: str) -> None:
        (self.folder / name).write_text(text)

    @property
    def maker(self) -> BuildKitMaker:
        found = Services.load(self.folder)
        return BuildKitMaker(found, self.image_set, Place(cast(Any, self.registry), "rosml"), self.said.append)

    def test(self, target: str = TARGET, architecture: str = "amd64", digest: str = MANIFEST) -> Checked:
        """Tests an image as a run does."""
        image = self.image_set.image(target)
        return self.maker.test(image, architecture, digest, {}, (*image.tests, *image.shared))

    def bakes(self) -> list[str]:
        """The calls that ran tests."""
        return [call for call in calls(self.folder) if call.startswith("buildx bake")]


@pytest.fixture
def stage(tmp_path: Path, small: sets.ImageSet, monkeypatch: pytest.MonkeyPatch) -> Stage:
    monkeypatch.setattr(base_images, "native_architecture", lambda: "amd64")
    monkeypatch.setattr(sync, "published", lambda source: SYNC)
    return Stage(tmp_path, small)


# ---- Structure tests -------------------------------------------------------------------------------------------------


def test_tests_that_pass(stage: Stage) -> None:
    assert stage.test() == Checked(2 * len(FILES), (), 4096, {"python3": "3.12.3"})
    (call,) = stage.bakes()
    assert f"{TARGET}-test.target=test-report" in call
    assert f"{TARGET}-test.args.TESTS={' '.join(FILES[:-1])}" in call
    assert json.loads(line(stage, "DIGESTS")) == {TARGET: MANIFEST}, "the very digest is tested"
    config = json.loads((stage.folder / f".state/tests/{TARGET}/metadata/config.json").read_text())
    assert config["config"]["Labels"] == {"io.rosml.torch": "2.10.0"}, "what changes with a commit runs no test again"


def line(stage: Stage, variable: str) -> str:
    """What buildx found in a variable of its environment."""
    lines = (stage.folder / "env-bake").read_text().splitlines()
    return next(text.partition("=")[2] for text in lines if text.startswith(f"{variable}="))


def test_room_is_made_for_what_the_builder_does_not_have_yet(stage: Stage, monkeypatch: pytest.MonkeyPatch) -> None:
    """A second test of an image needs none, unless the builder forgot something for another one meanwhile."""
    needed: list[int] = []
    forgets = iter([False, False, True, False])

    def make_room(_services: Services, room: int, _say: object) -> bool:
        needed.append(room)
        return next(forgets)

    monkeypatch.setattr(disk, "make_room", make_room)
    maker = stage.maker
    for target in (TARGET, TARGET, "alpha-core", TARGET):
        maker.test(stage.image_set.image(target), "amd64", MANIFEST, {}, ("contract",))
    core, base = (
        disk.tested_mb(stage.image_set, stage.image_set.image(name), set()) for name in ("alpha-core", TARGET)
    )
    assert needed == [base, 0, 0, base - core] and 0 < core < base


def test_a_test_fails(stage: Stage) -> None:
    stage.write("report/ros2.json", results(good=True, bad=False))
    found = stage.test()
    assert (found.passed, found.failures) == (2 * len(FILES) - 1, ("ros2: bad",))
    assert found.said == "    ros2: bad\n      it broke"
    (said,) = [text for text in stage.said if "structure tests" in text]
    assert said.startswith(f"1 of {2 * len(FILES)} structure tests of {TARGET} failed; it gets no tag\n")
    assert "    ros2: bad\n      it broke\n" in said
    assert f"all reports: {stage.folder}/.state/tests/{TARGET}/report" in said
    assert said.endswith(f"rosml/ros@{MANIFEST}"), "whoever looks into it finds it"


def test_an_image_that_is_gone(stage: Stage) -> None:
    with pytest.raises(RosmlError, match="alpha-base is not in the registry any more") as caught:
        stage.test(digest="sha256:other")
    assert caught.value.remedy == "run it again"
    assert not stage.bakes()


@pytest.mark.parametrize(
    ("budget", "counted", "failures"),
    [(4, slice(None), 1), (5, slice(None), 0), (1, slice(1, 2), 1), (2, slice(1, 2), 0)],
)
def test_parts_beyond_the_budget_fail(stage: Stage, budget: int, counted: slice, failures: int) -> None:
    """The budget is a test like any other. That of an add-on counts its own parts alone."""
    image_set = parse(changed("  parts:\n    cu1:", f"  budgets: {{cu1: {{torch: {budget}}}}}\n  parts:\n    cu1:"))
    stage.image_set = locked.with_locks(image_set, {lock for part in image_set.parts for lock in part.locks})
    image = stage.image_set.image("alpha-base-torch-cu1")
    image = replace(image, budgeted=image.parts[counted])
    stage.registry.content = of_layers(*[2_000_000] * len(image.parts), 1)
    for name in image.tests:
        stage.write(f"report/{name}.json", results(one=True))
    maker = stage.maker
    maker.place = Place(cast(Any, stage.registry), "rosml")
    parts = {image.parent: MANIFEST}
    found = maker.test(image, "amd64", MANIFEST, parts, image.tests)
    assert len(found.failures) == failures
    assert found.failures[:1] == ("size: the parts keep within their budget",)[:failures]


@pytest.mark.parametrize(
    ("name", "text"),
    [("contract", None), ("contract", '{"Results": []}'), ("metadata", '{"Results": null}'), ("metadata", "killed")],
)
def test_a_file_without_tests_or_report_fails(stage: Stage, name: str, text: str | None) -> None:
    file = stage.folder / f"report/{name}.json"
    file.unlink()
    if text is not None:
        file.write_text(text)
    (failure,) = stage.test().failures
    assert failure.startswith(f"{name}: ")


def test_an_old_report_is_not_believed(stage: Stage) -> None:
    stage.test()
    shutil.rmtree(stage.folder / "report")
    with pytest.raises(RosmlError, match="left no report"):
        stage.test()


def test_a_failed_test_is_run_again(stage: Stage) -> None:
    """Its outcome is in the builder's cache: the next attempt has to look different."""
    stage.write("report/ros2.json", results(bad=False))
    assert all(stage.test().failures for _ in range(2))
    stage.write("report/ros2.json", results(bad=True))
    assert not any(stage.test().failures for _ in range(2))
    runs = [call.split("TEST_ATTEMPT=")[1].split()[0] for call in stage.bakes()]
    assert len(set(runs[:3])) == 3, "every attempt after a failure is a new one"
    assert runs[2] == runs[3], "what passed is taken from the cache"


def test_another_architecture_needs_emulation(stage: Stage) -> None:
    target = "alpha-core-ml-cpu"
    with pytest.raises(RosmlError, match="does not run programs for linux/arm64") as caught:
        stage.test(target, "arm64")
    assert caught.value.remedy == "run 'rosml setup emulate'"


# ---- What the builder is told ----------------------------------------------------------------------------------------


def test_the_builder_is_told_of_when_ros_repository_is(stage: Stage, monkeypatch: pytest.MonkeyPatch) -> None:
    """A new state is a new argument; where nobody can be asked, what is known of last time keeps the builder's cache."""
    image = stage.image_set.image(TARGET)

    def silent(source: apt_repository.AptRepository) -> str:
        raise RosmlError("nobody answers", "wait")

    def told(moment: str = "") -> str:
        return stage.maker.variables(image, "amd64", moment)["ROS_SYNC_DATES"]

    monkeypatch.setattr(sync, "published", silent)
    assert told() == '{"alpha": ""}'
    assert "nobody answers; using the date of last time: unknown" in stage.said
    assert told("monday") == '{"alpha": "monday"}', "a run that knows it asks nobody"
    monkeypatch.setattr(sync, "published", lambda source: SYNC)
    assert told() == f'{{"alpha": "{SYNC}"}}'
    monkeypatch.setattr(sync, "published", silent)
    assert told() == f'{{"alpha": "{SYNC}"}}'


def test_base_images_of_parts_and_tools(stage: Stage) -> None:
    """Of the image itself, and of what parts and tests are assembled on."""
    found = stage.maker.variables(stage.image_set.image("omega-base-torch-cu1"), "amd64")
    assert found["OS_UBUNTU_24_04"] == f"docker-image://docker.io/library/ubuntu:24.04@sha256:{'1' * 64}"
    assert found["OS_UBUNTU_26_04"] == f"docker-image://docker.io/library/ubuntu:26.04@sha256:{'2' * 64}"
    assert (found["REGISTRY"], found["PLATFORM"]) == ("127.0.0.1:1/rosml", "linux/amd64")


def test_one_architecture_needs_no_lock_of_another(stage: Stage) -> None:
    image_set = parse(changed("cpu: [arm64]}", "cpu: [amd64, arm64]}"))
    present = {lock for part in image_set.parts for lock in part.locks} - {"locks/cpu/amd64/3.12/torch.txt"}
    image = locked.with_locks(image_set, present).image("alpha-core-torch-cpu")
    require_buildable(image, "arm64")
    with pytest.raises(RosmlError, match="cannot be built yet"):
        require_buildable(image, "amd64")
