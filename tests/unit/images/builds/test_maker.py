"""What the builder gets for an image, and the results of its structure tests, with a local replacement for buildx."""

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
from rosml.images.builds.maker import BuildKitMaker, Verdict, require_buildable
from rosml.images.image_set import locked
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
exit 0
"""


def results(**passed: bool) -> str:
    """A report of container-structure-test."""
    return json.dumps(
        {"Results": [{"Name": name, "Pass": it, "Errors": None if it else ["it broke"]} for name, it in passed.items()]}
    )


@dataclass
class OneManifest:
    """A registry that has one manifest, with layers of some sizes."""

    sizes: tuple[int, ...] = (30,)
    host: str = "127.0.0.1:1"

    def manifest(self, _repository: str, reference: str) -> Manifest | None:
        sizes = enumerate(self.sizes)
        layers = [{"mediaType": "x", "digest": f"sha256:{number:064}", "size": size} for number, size in sizes]
        return Manifest({"schemaVersion": 2, "layers": layers}, MANIFEST, "", 1) if reference == MANIFEST else None

    def config(self, _repository: str, _manifest: Manifest) -> Config:
        return Config({"config": {"Labels": {"io.rosml.torch": "2.10.0", "other": "1"}}}, documents.Config())


@dataclass
class Stage:
    """A checkout with local replacements; its files say how they behave."""

    folder: Path
    image_set: sets.ImageSet
    registry: OneManifest = field(default_factory=OneManifest)
    lines: list[str] = field(default_factory=list)

    def __post_init__(self) -> None:
        (self.folder / "report").mkdir()
        for name in FILES:
            self.report(name, results(one=True, two=True))
        (self.folder / "report/unpacked").write_text("4 /")
        (self.folder / "report/versions").write_text("python3 3.12.3\n")
        write_locks(self.folder, self.image_set)
        services(self.folder, "127.0.0.1:1", buildx=buildx(self.folder, BAKE))

    def report(self, name: str, text: str) -> None:
        (self.folder / f"report/{name}.json").write_text(text)

    @property
    def maker(self) -> BuildKitMaker:
        place = Place(cast(Any, self.registry), "rosml")
        return BuildKitMaker(Services.load(self.folder), self.image_set, place, self.lines.append)

    def test(self, target: str = TARGET, architecture: str = "amd64") -> Verdict:
        """Tests an image as a run does."""
        image = self.image_set.image(target)
        return self.maker.test(image, architecture, MANIFEST, {}, (*image.tests, *image.shared))

    def bakes(self) -> list[str]:
        return [call for call in calls(self.folder) if call.startswith("buildx bake")]


@pytest.fixture
def stage(tmp_path: Path, small: sets.ImageSet, monkeypatch: pytest.MonkeyPatch) -> Stage:
    monkeypatch.setattr(base_images, "native_architecture", lambda: "amd64")
    monkeypatch.setattr(sync, "published", lambda source: SYNC)
    return Stage(tmp_path, small)


# ---- Structure tests -------------------------------------------------------------------------------------------------


def test_tests_that_pass(stage: Stage) -> None:
    assert stage.test() == Verdict(2 * len(FILES), (), 4096, {"python3": "3.12.3"})
    (call,) = stage.bakes()
    assert f"{TARGET}-test.target=test-report" in call
    assert f"{TARGET}-test.args.TESTS={' '.join(FILES[:-1])}" in call
    environment = dict(line.partition("=")[::2] for line in (stage.folder / "env-bake").read_text().splitlines())
    assert json.loads(environment["DIGESTS"]) == {TARGET: MANIFEST}, "the very digest is tested"
    config = json.loads((stage.folder / f".state/tests/{TARGET}/metadata/config.json").read_text())
    assert config["config"]["Labels"] == {"io.rosml.torch": "2.10.0"}, "what changes with a commit runs no test again"


def test_room_is_made_only_for_what_the_builder_lacks(stage: Stage, monkeypatch: pytest.MonkeyPatch) -> None:
    """A second test of an image needs none, unless the builder forgot something for another one meanwhile."""
    needed: list[int] = []
    prunes = iter([False, False, True, False])

    def make_room(_services: Services, room: int, _say: object) -> bool:
        needed.append(room)
        return next(prunes)

    monkeypatch.setattr(disk, "make_room", make_room)
    maker = stage.maker
    for target in (TARGET, TARGET, "alpha-core", TARGET):
        maker.test(stage.image_set.image(target), "amd64", MANIFEST, {}, ("contract",))
    images = [stage.image_set.image(name) for name in ("alpha-core", TARGET)]
    core, base = (disk.tested_mb(stage.image_set, image, set()) for image in images)
    assert needed == [base, 0, 0, base - core] and 0 < core < base


def test_a_failed_test(stage: Stage) -> None:
    stage.report("ros2", results(good=True, bad=False))
    verdict = stage.test()
    assert (verdict.passed, verdict.failures) == (2 * len(FILES) - 1, ("ros2: bad",))
    assert verdict.output == "    ros2: bad\n      it broke"
    (text,) = [line for line in stage.lines if "structure tests" in line]
    assert text.startswith(f"1 of {2 * len(FILES)} structure tests of {TARGET} failed")
    assert verdict.output in text and f"{stage.folder}/.state/tests/{TARGET}/report" in text


def test_an_image_that_is_gone_or_has_other_layers_than_its_parts(stage: Stage) -> None:
    for digest, words in (("sha256:other", "is not in the registry any more"), (MANIFEST, "does not consist of")):
        image = stage.image_set.image("alpha-base-torch-cu1")
        with pytest.raises(RosmlError, match=words):
            stage.maker.test(image, "amd64", digest, dict.fromkeys((image.parent, "part-cuda-cu1"), MANIFEST), ())
    assert not stage.bakes()


@pytest.mark.parametrize(
    ("budget", "budgeted", "failures"),
    [(4, slice(None), 1), (5, slice(None), 0), (1, slice(1, 2), 1), (2, slice(1, 2), 0)],
)
def test_parts_beyond_the_budget_fail(stage: Stage, budget: int, budgeted: slice, failures: int) -> None:
    """The budget is a test like any other. That of an add-on counts its own parts alone."""
    image_set = parse(changed("  parts:\n    cu1:", f"  budgets: {{cu1: {{torch: {budget}}}}}\n  parts:\n    cu1:"))
    stage.image_set = locked.with_locks(image_set, {lock for part in image_set.parts for lock in part.locks})
    image = stage.image_set.image("alpha-base-torch-cu1")
    image = replace(image, budgeted=image.parts[budgeted])
    stage.registry.sizes = (*[2_000_000] * len(image.parts), 1)
    for name in image.tests:
        stage.report(name, results(one=True))
    verdict = stage.maker.test(image, "amd64", MANIFEST, {image.parent: MANIFEST}, image.tests)
    assert verdict.failures == ("size: the parts keep within their budget",)[:failures]


def test_a_report_of_an_earlier_run_does_not_count(stage: Stage) -> None:
    stage.test()
    shutil.rmtree(stage.folder / "report")
    with pytest.raises(RosmlError, match="left no report"):
        stage.test()


def test_a_failed_test_is_run_again(stage: Stage) -> None:
    """Its outcome is in the builder's cache: the next attempt has to look different."""
    for passed in (False, True):
        stage.report("ros2", results(bad=passed))
        assert [bool(stage.test().failures) for _ in range(2)] == [not passed] * 2
    attempts = [call.split("TEST_ATTEMPT=")[1].split()[0] for call in stage.bakes()]
    assert len(set(attempts[:3])) == 3, "every attempt after a failure is a new one"
    assert attempts[2] == attempts[3], "what passed is taken from the cache"


def test_another_architecture_needs_emulation(stage: Stage) -> None:
    with pytest.raises(RosmlError, match="does not run programs for linux/arm64"):
        stage.test("alpha-core-ml-cpu", "arm64")


# ---- Variables -------------------------------------------------------------------------------------------------------


def test_the_sync_date_is_an_argument(stage: Stage, monkeypatch: pytest.MonkeyPatch) -> None:
    """If the repository does not answer, that of last time keeps the builder's cache."""

    def silent(_source: object) -> str:
        raise RosmlError("nobody answers", "wait")

    def dates(date: str = "") -> str:
        return stage.maker.variables(stage.image_set.image(TARGET), "amd64", date)["ROS_SYNC_DATES"]

    monkeypatch.setattr(sync, "published", silent)
    assert dates() == '{"alpha": ""}'
    assert "nobody answers; using the date of last time: unknown" in stage.lines
    assert dates("monday") == '{"alpha": "monday"}'
    monkeypatch.setattr(sync, "published", lambda source: SYNC)
    assert dates() == f'{{"alpha": "{SYNC}"}}'
    monkeypatch.setattr(sync, "published", silent)
    assert dates() == f'{{"alpha": "{SYNC}"}}'


def test_base_images_of_the_image_and_of_its_parts(stage: Stage) -> None:
    values = stage.maker.variables(stage.image_set.image("omega-base-torch-cu1"), "amd64")
    for system, digit in (("24", 1), ("26", 2)):
        image = f"docker-image://docker.io/library/ubuntu:{system}.04@sha256:{str(digit) * 64}"
        assert values[f"OS_UBUNTU_{system}_04"] == image
    assert (values["REGISTRY"], values["PLATFORM"]) == ("127.0.0.1:1/rosml", "linux/amd64")


def test_one_architecture_needs_no_lock_of_another(stage: Stage) -> None:
    image_set = parse(changed("cpu: [arm64]}", "cpu: [amd64, arm64]}"))
    present = {lock for part in image_set.parts for lock in part.locks} - {"locks/cpu/amd64/3.12/torch.txt"}
    image = locked.with_locks(image_set, present).image("alpha-core-torch-cpu")
    require_buildable(image, "arm64")
    with pytest.raises(RosmlError, match="cannot be built yet"):
        require_buildable(image, "amd64")
