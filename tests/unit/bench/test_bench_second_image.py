"""Our second image beside the usual one, with local replacements for buildx and regctl: the arithmetic, the table, failures."""

from __future__ import annotations

import json
import re
import shutil
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any

import pytest
from conftest import write_locks
from stubs import buildx, calls, executable, services

from bench import cli, generator, many_tags, second_image
from bench.here import Here
from bench.idle_run import IdleRun
from bench.many_tags import Grown, Growth
from bench.second_image import Comparison, Side
from rosml.base.errors import RosmlError
from rosml.cli import command
from rosml.images.builds.push import COMPRESSION
from rosml.images.image_set import model as sets

TARGET = "alpha-base-torch-cu1"
REPOSITORY = "/bench/ros-torch@sha256:"

BAKE = """
case $1 in prune) exit 0 ;; esac
[ "$target" != "$(cat "$here/broken" 2>/dev/null)" ] || exit 1
if [ -n "$report" ]; then mkdir -p "$report" && cp "$here/${target##*-}.json" "$report/result.json"; exit; fi
echo "$target" >>"$here/pushed"
printf '{"%s": {"containerimage.digest": "sha256:%s"}}' "$target" "$(grep -c . "$here/pushed")" >"$metadata"
cat "$here/progress" >&2
"""
"""Every image that is pushed gets the next number as its digest."""

REGCTL = """
here='{folder}'
echo "regctl $*" >>"$here/calls"
for word; do :; done
case "$1 $2" in
"manifest get") cat "$here/manifest-${{word##*:}}" ;;
"manifest head") echo 50 ;;
"manifest delete") [ ! -e "$here/kept" ] ;;
*) echo "unknown: $*" >&2; exit 1 ;;
esac
"""

PUSHED = {
    "ros-yesterday": {"os": 100, "change 1": 5},
    "ros-today": {"os": 100, "change 2": 6},
    "ours-yesterday": {"os": 100, "change 1": 5, "part": 1_000},
    "usual-yesterday": {"os": 100, "change 1": 5, "pip 1": 1_100},
    "ours-today": {"os": 100, "change 2": 6, "part": 1_000},
    "usual-today": {"os": 100, "change 2": 6, "pip 2": 1_101},
}
"""Layers of the images in the order in which they are pushed, with their sizes."""

CONFIG = 7


def step(name: str, **facts: Any) -> str:
    """A line of buildx' rawjson: a step of three seconds."""
    times = {"started": "2026-11-21T11:03:10.123456789Z", "completed": "2026-11-21T11:03:13.123456789Z"}
    return json.dumps({"vertexes": [{"digest": name, "name": name, **times, **facts}]}) + "\n"


class Stage:
    """A checkout with local replacements."""

    def __init__(self, folder: Path, registry: str, image_set: sets.ImageSet) -> None:
        self.folder, self.image_set, self.said = folder, image_set, list[str]()
        for number, layers in enumerate(PUSHED.values(), 1):
            entries = [{"digest": name, "size": size} for name, size in layers.items()]
            config = {"digest": f"config {number}", "size": CONFIG}
            self.write(f"manifest-{number}", json.dumps({"layers": entries, "config": config}))
        self.write("progress", step("[bench x 2/2] RUN pip install y"))
        for number, seconds in enumerate((4.0, 2.0)):
            self.imports(number, seconds)
        write_locks(folder, image_set)
        regctl = executable(folder / "regctl", REGCTL.format(folder=folder))
        found = services(folder, registry, buildx=buildx(folder, BAKE), regctl=regctl)
        self.here = Here(found, image_set, self.said.append, second_image.NAMESPACE)

    def write(self, name: str, text: str) -> None:
        (self.folder / name).write_text(text)

    def imports(self, number: int, seconds: float, version: str = "2.10.0") -> None:
        """What imports of a round say."""
        self.write(
            f"{number}.json",
            json.dumps(
                {
                    "import_seconds": seconds,
                    "shell_seconds": seconds / 4,
                    "start_seconds": seconds / 200,
                    "versions": {"torch": version},
                }
            ),
        )

    def compare(self, target: str = TARGET) -> Comparison:
        return second_image.compare(self.here, target)

    def calls(self, start: str) -> list[str]:
        return [call for call in calls(self.folder) if call.startswith(start)]

    @property
    def removed(self) -> list[str]:
        """The numbers of the manifests that were removed."""
        return [call.rpartition(":")[2] for call in self.calls("regctl manifest delete")]


@pytest.fixture
def stage(tmp_path: Path, registry: str, small: sets.ImageSet, monkeypatch: pytest.MonkeyPatch) -> Stage:
    free(monkeypatch, 1_000_000)
    return Stage(tmp_path, registry, small)


def free(monkeypatch: pytest.MonkeyPatch, megabytes: int) -> None:
    """A file system with so much free space."""
    usage = shutil.disk_usage("/")
    monkeypatch.setattr(shutil, "disk_usage", lambda path: usage._replace(free=megabytes * 1_000_000))


def test_bytes(stage: Stage) -> None:
    """Of today's image: the registry had the ROS image of today, somebody's machine only yesterday's image."""
    found = stage.compare()
    assert found.ours.registry_new_bytes == CONFIG + 50
    assert found.usual.registry_new_bytes == 1_101 + CONFIG + 50
    assert found.ours.pull_bytes == 6
    assert found.usual.pull_bytes == 6 + 1_101
    assert found.ours.image_bytes == 1_106
    assert found.usual.image_bytes == 1_207
    assert found.ratios["pull_bytes"] == 1_107 / 6


def test_seconds(stage: Stage) -> None:
    found = stage.compare()
    assert found.ours.import_seconds == found.usual.import_seconds == 2.0
    assert found.ours.shell_seconds == found.usual.shell_seconds == 0.5
    assert found.ours.start_seconds == 0.01
    assert found.usual.install_seconds == pytest.approx(3.0)
    assert found.ours.build_and_push_seconds > 0
    assert found.usual.first_image_seconds > 0
    assert found.assembling_seconds == 0


def test_assembling_parts_is_told_apart(stage: Stage) -> None:
    run = "[_files-torch part-files 2/2] RUN --mount=type=bind,source=x,target=/y /run/components/part/assemble.sh"
    stage.write("progress", step(run))
    found = stage.compare()
    assert found.assembling_seconds == pytest.approx(3.0)
    assert any("assembled once, 3.0 s of work in this run" in line for line in second_image.notes(found))


def test_both_ways_are_built_alike(stage: Stage) -> None:
    """On the same ROS images, compressed alike, pushed by digest, from the same locks."""
    stage.compare()
    pushes = [call for call in stage.calls("buildx bake") if "push=true" in call]
    assert len(pushes) == len(PUSHED)
    assert all(f",push=true,push-by-digest=true,{COMPRESSION} " in call for call in pushes)
    address = stage.here.services.registry
    for day, number in (("yesterday", 1), ("today", 2)):
        parent = f".contexts.ros=docker-image://{address}/bench/ros@sha256:{number} "
        on_it = [call.split()[-1] for call in pushes if parent in call]
        assert len(on_it) == 2
        assert on_it[0] == TARGET
        assert on_it[1].endswith(f"-usual-{day}")
    text = (stage.folder / f".state/bake/bench-{TARGET}.hcl").read_text()
    locks = (stage.image_set.part_by_name[name].locks[0] for name in stage.image_set.image(TARGET).parts)
    assert text.count(" ".join(f"--requirement /{lock}" for lock in locks)) == 2


def test_imports_alternate(stage: Stage) -> None:
    stage.compare()
    made = [call for call in stage.calls("buildx bake") if "type=local" in call]
    images = [call.partition(REPOSITORY)[2].split()[0] for call in made]
    assert images == ["5", "6", "5", "6"]
    assert len({call.split()[-1] for call in made}) == 4, "none is found in the builder's cache"


def test_nothing_is_tagged_and_nothing_is_left(stage: Stage) -> None:
    found = stage.compare()
    assert found.left == ()
    assert stage.removed == list("123456")
    assert not stage.calls("regctl image copy")
    yesterday, marked, pulled = [call.partition("description~=")[2].split()[0] for call in stage.calls("buildx prune")]
    file = (stage.folder / f".state/bake/bench-{TARGET}.hcl").read_text()
    assert yesterday == f"{marked}-usual-yesterday"
    assert all(f"# {marked}-usual-{day}\\n" in file for day in ("yesterday", "today")), "pip's step is among them"
    assert pulled == f"{stage.here.services.registry}/bench/", "what others built is left alone"


def test_a_registry_that_removes_nothing(stage: Stage) -> None:
    stage.write("kept", "")
    assert len(stage.compare().left) == len(PUSHED)
    assert "left in the registry" in stage.said[-1]


def test_a_build_that_fails_leaves_nothing(stage: Stage) -> None:
    stage.write("broken", TARGET)
    with pytest.raises(RosmlError, match=f"building {TARGET} failed"):
        stage.compare()
    assert stage.removed == ["1", "2"]


def test_interrupted(stage: Stage) -> None:
    """Ctrl-C while our first image is built: what was pushed is removed."""
    program = stage.folder / "buildx"
    stop = f"case $target in {TARGET}) kill -INT $PPID; exec sleep 1 ;; esac\n"
    program.write_text(program.read_text().replace("if [ -n", f"{stop}if [ -n"))
    with pytest.raises(KeyboardInterrupt):
        stage.compare()
    assert stage.removed == ["1", "2"]
    assert stage.calls("buildx prune")


def test_other_versions_are_no_comparison(stage: Stage) -> None:
    stage.imports(1, 2.0, "2.11.0")
    with pytest.raises(RosmlError, match="did not install the same"):
        stage.compare()


@pytest.mark.parametrize("text", ["", "[]", '{"import_seconds": "soon", "versions": {}}', '{"import_seconds": 1}'])
def test_an_import_without_a_result(stage: Stage, text: str) -> None:
    stage.write("1.json", text)
    with pytest.raises(RosmlError, match="gave no result"):
        stage.compare()


def test_a_push_without_a_digest(stage: Stage) -> None:
    program = stage.folder / "buildx"
    program.write_text(program.read_text().replace('>"$metadata"', ">/dev/null"))
    with pytest.raises(RosmlError, match="which digest it pushed for bench-"):
        stage.compare()


def test_no_room(stage: Stage, monkeypatch: pytest.MonkeyPatch) -> None:
    """torch, cuda and common: 3,300 MB unpacked and 330 MB compressed; the usual image twice, its wheels, and ours."""
    image = stage.image_set.image(TARGET)
    ours = 2 * 3_300 + 2 * 330
    alone = second_image.needed_mb(stage.image_set, image, {image.target, *image.parts})
    assert alone == 2 * (3_300 + 2 * 330) + 330
    assert second_image.needed_mb(stage.image_set, image, {image.target}) == alone + ours
    free(monkeypatch, alone)
    with pytest.raises(RosmlError, match=f"not enough disk space to build {TARGET} in both ways"):
        stage.compare()
    assert not stage.calls("buildx bake")


@pytest.mark.parametrize("target", ["alpha-base", "alpha-base-cuda-cu1"])
def test_nothing_to_compare(stage: Stage, target: str) -> None:
    with pytest.raises(RosmlError, match=f"{target} has no framework") as caught:
        stage.compare(target)
    assert caught.value.exit_code == 2
    assert caught.value.remedy


def test_a_lock_for_another_index(stage: Stage) -> None:
    part = stage.image_set.part_by_name[stage.image_set.image(TARGET).parts[-1]]
    lock = stage.folder / part.locks[0]
    lock.write_text(lock.read_text().replace("torch==2.10.0", "torch==2.10.0+cpu"))
    with pytest.raises(RosmlError, match=r"torch 2\.10\.0\+cpu is on PyTorch's own index alone") as caught:
        stage.compare()
    assert caught.value.exit_code == 2


def test_services_that_are_down(tmp_path: Path, small: sets.ImageSet) -> None:
    write_locks(tmp_path, small)
    here = Here(services(tmp_path), small, print, second_image.NAMESPACE)
    with pytest.raises(RosmlError, match=r"the local registry at .* does not answer"):
        second_image.compare(here, TARGET)


FOUND = Comparison(
    target=TARGET,
    ours=Side(2.0, 3_000, 0, 1.5, 60.0, 0.0, 1_200_000_000),
    usual=Side(90.0, 1_500_000_000, 1_500_000_100, 1.6, 95.0, 70.0, 1_600_000_000),
    versions={"torch": "2.10.0"},
    packages=40,
    assembling_seconds=0.0,
)


def test_table(capsys: pytest.CaptureFixture[str]) -> None:
    second_image.print_table(FOUND)
    lines = [line.split("  ") for line in capsys.readouterr().out.splitlines()]
    rows = {line[0]: [word.strip() for word in line[1:] if word.strip()] for line in lines}
    assert rows[TARGET] == ["ours", "RUN pip install", "ratio"]
    assert rows["second image: build and push"] == ["2.0 s", "1 min 30 s", "45 x"]
    assert rows["second image: new in the registry"] == ["3.0 kB", "1.50 GB", "> 1,000 x"]
    assert rows["to pull after a change of ROS"] == ["0 B", "1.50 GB"]
    assert rows["import, in a fresh container"] == ["1.5 s", "1.6 s", "1.1 x"]


def test_notes() -> None:
    told = "\n".join(second_image.notes(FOUND))
    assert "torch 2.10.0: the same 40 pinned packages both ways, compression=zstd,compression-level=7\n" in told
    assert "installation took 1 min 10 s" in told
    assert "assembled once, before this run" in told
    assert "rosml setup clean" in told


def test_json_has_everything() -> None:
    found = json.loads(json.dumps(replace(FOUND, left=("x",)).to_json()))
    assert found["usual"] == asdict(FOUND.usual)
    assert found["left"] == ["x"]
    assert found["compression"] == COMPRESSION
    assert found["ratios"]["build_and_push_seconds"] == 45
    assert found["ratios"]["pull_bytes"] is None
    for side in ("ours", "usual"):
        assert all(name.endswith(("_seconds", "_bytes")) for name in found[side])


def test_the_command(stage: Stage, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    """Both tables, or both as one JSON object."""
    monkeypatch.setattr(generator, "SIZES", (96, 192))
    monkeypatch.setattr(generator, "ROUNDS", 1)
    monkeypatch.setattr(generator, "RUNS", 1)
    monkeypatch.setattr(cli, "TARGET", TARGET)
    monkeypatch.setattr(cli, "REPORT", stage.folder / "report")
    monkeypatch.setattr(cli, "bench_here", lambda target: stage.here)

    def grown(_publisher: object, target: str, usual: Comparison) -> Grown:
        assert target == TARGET and usual.usual.registry_new_bytes
        return Grown((Growth(10, 2.5, 70_000, 600.0, 10_000_000_000),), IdleRun(843, 2967, 6.5, 0, 0), None)

    monkeypatch.setattr(many_tags, "measure", grown)
    assert command.run(cli.main, arguments=["--target="]) == 0
    out = capsys.readouterr().out
    assert "192 images" in out
    assert "RUN pip install" in out
    assert re.search(r"10 +2\.5 s +70\.0 kB +10 min 0 s +10\.00 GB +0\.25 s", out)
    assert "nothing changed: 843 images and parts on their architectures, 2967 tags, 6.5 s, 0 B uploaded" in " ".join(
        out.split()
    )
    (stage.folder / "pushed").unlink()
    assert command.run(cli.main, arguments=["--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["comparison"]["target"] == TARGET
    assert found["real_seconds"] > 0
    assert found["growth_of_tags"]["rows"][0]["tags"] == 10
    assert json.loads((stage.folder / "report/report.json").read_text()) == found


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--target=ros1-bookworm-base"], "ros1-bookworm-base has no framework"),
        (["--target=ros1-bookworm-bose-torch-cu128"], "ros1-bookworm-bose-torch-cu128"),
        (["--generator", "--target=x"], "leave --target out"),
    ],
)
def test_wrong_targets(arguments: list[str], message: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert command.run(cli.main, arguments=arguments) == 2
    assert message in capsys.readouterr().err
