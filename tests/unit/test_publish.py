"""One image, all the way, with stand-ins for buildx, regctl and the registry: above all, that no untested tag moves."""

from __future__ import annotations

import json
import os
import re
import shutil
import signal
import subprocess
import sys
import time
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import pytest
from conftest import ROOT, SMALL, changed, parse, write_locks
from stubs import buildx, calls, executable, services

from rosml.bake.inputs import Inputs
from rosml.base.errors import RosmlError
from rosml.build import sync
from rosml.build.publisher import Publisher, Result, TestsFailed, require_buildable
from rosml.cli import command, summary
from rosml.images import apt_source, image_set, locked
from rosml.machine import base_images
from rosml.records import ledger
from rosml.records.ledger import Entry
from scripts import publish as script

TARGET = "alpha-base-torch-cu1"
MANIFEST, INDEX = "sha256:" + "a" * 64, "sha256:" + "b" * 64
TAGS = ["alpha-base-cu1", "alpha-base-cu1-torch2.10.0", "alpha", "latest"]
FILES = ["contract", "ros2", "ros2-core", "ros2-base", "cuda", "torch", "metadata"]

BAKE = """
case $target in
*-test) [ ! -d "$here/report" ] || cp -r "$here/report" "$report" ;;
*) printf '{"%s": {"containerimage.digest": "%s"}}' "$target" "$(cat "$here/digest")" >"$metadata" ;;
esac
cat "$here/progress-${target##*-}" >&2
exit "$(cat "$here/code")"
"""

REGCTL = """
here='{folder}'
echo "regctl $*" >>"$here/calls"
for word; do :; done
tag="$here/tags/${{word##*:}}"
case "$1 $2" in
"manifest get") cat "$here/manifest.json" ;;
"image config") cat "$here/config.json" ;;
"index create") cat "$here/index" ;;
"manifest head") [ -e "$tag" ] && cat "$tag" || {{ echo "$word: not found" >&2; exit 1; }} ;;
"image copy") source=${{3#*@}}; echo "$source" >"$tag" ;;
*) echo "unknown: $*" >&2; exit 1 ;;
esac
"""


def line(name: str, **facts: Any) -> str:
    """A line of buildx' rawjson."""
    step = {"digest": name, "name": name, "started": "2026-11-21T11:03:10.123456789Z", **facts}
    return json.dumps({"vertexes": [step]}) + "\n"


SYNC = "2026-11-20T21:14:09Z"
ENDED = {"completed": "2026-11-21T11:03:13.123456789Z"}
BUILD = (
    line("[_files-torch x 2/2] RUN --mount=type=bind,source=components/torch,target=/run/components/part x", **ENDED)
    + line("[alpha-base ros 1/2] RUN x", cached=True, **ENDED)
    + line("[alpha-core ros 1/2] RUN x", cached=True, **ENDED)
    + line("[alpha-base-torch-cu1 torch 1/1] LINK COPY --link --from=x / /", cached=True, **ENDED)
    + line("[alpha-base-torch-cu1] exporting to image", **ENDED)
)
TEST = line("[alpha-base-torch-cu1-test test-run 1/2] RUN /run/tests/run.sh /structure-report", **ENDED)


def results(**passed: bool) -> str:
    """A report of container-structure-test."""
    outcomes = [
        {"Name": name, "Pass": value, **({} if value else {"Errors": ["it broke"]})} for name, value in passed.items()
    ]
    return json.dumps({"Results": outcomes})


@dataclass
class Stage:
    """A checkout with stand-ins; its files say how they behave."""

    folder: Path
    registry: str
    catalogue: image_set.Catalogue
    said: list[str] = field(default_factory=list)

    def __post_init__(self) -> None:
        (self.folder / "tags").mkdir()
        (self.folder / "report").mkdir()
        self.write("digest", MANIFEST)
        self.write("index", INDEX)
        self.write("code", "0")
        self.write("progress-cu1", BUILD)
        self.write("progress-test", TEST)
        self.write("manifest.json", '{"layers": [{"digest": "x", "size": 30}, {"digest": "y", "size": 12}]}')
        labels = {"io.rosml.torch": "2.10.0", "org.opencontainers.image.version": "1"}
        self.write("config.json", json.dumps({"config": {"Labels": labels}}))
        for name in FILES:
            self.write(f"report/{name}.json", results(one=True, two=True))
        self.write("report/unpacked", "4 /")
        write_locks(self.folder, self.catalogue)
        regctl = executable(self.folder / "regctl", REGCTL.format(folder=self.folder))
        services(self.folder, self.registry, buildx=buildx(self.folder, BAKE), regctl=regctl)

    def write(self, name: str, text: str) -> None:
        (self.folder / name).write_text(text)

    def publish(self, target: str = TARGET, architecture: str = "amd64", **changes: Any) -> Result:
        """Publishes as the command does."""
        facts = json.loads((self.folder / ".state/services.json").read_text())
        found = services(self.folder, **{**facts, **changes})
        return Publisher(found, self.catalogue, self.said.append, architecture=architecture).publish(target)

    def calls(self, start: str) -> list[str]:
        """The calls that start in some way."""
        return [call for call in calls(self.folder) if call.startswith(start)]

    def tags(self) -> dict[str, str]:
        """Every tag and what it points at."""
        return {file.name: file.read_text().strip() for file in (self.folder / "tags").iterdir()}

    def untouched(self) -> bool:
        """Whether no tag was made or moved, nor an index."""
        return not self.tags() and not self.calls("regctl image copy") and not self.calls("regctl index create")


@pytest.fixture
def stage(tmp_path: Path, registry: str, small: image_set.Catalogue, monkeypatch: pytest.MonkeyPatch) -> Stage:
    free(monkeypatch, 1_000_000)
    monkeypatch.setattr(base_images, "native_architecture", lambda: "amd64")
    monkeypatch.setattr(sync, "published", lambda source: SYNC)
    return Stage(tmp_path, registry, small)


def free(monkeypatch: pytest.MonkeyPatch, megabytes: int) -> None:
    """Makes every file system have this much room."""
    usage = shutil.disk_usage("/")._replace(free=megabytes * 1_000_000)
    monkeypatch.setattr(shutil, "disk_usage", lambda path: usage)


# ---- All goes well ---------------------------------------------------------------------------------------------------


def test_publish(stage: Stage) -> None:
    result = stage.publish()
    repository = f"{stage.registry}/rosml/ros-torch"
    assert (result.digest, result.manifest) == (INDEX, MANIFEST)
    assert result.reference == f"{repository}:alpha-base-cu1"
    assert result.tags == [f"{repository}:{tag}" for tag in TAGS]
    assert result.moved == TAGS
    assert stage.tags() == dict.fromkeys(TAGS, INDEX)
    assert (result.passed, result.failed, result.unpacked, result.compressed) == (14, 0, 4096, 42)
    assert result.work == pytest.approx({"assemble payloads": 3.0, "compress and push": 3.0, "structure tests": 3.0})
    assert result.reused == ["ROS packages"]
    assert result.base == f"docker.io/library/ubuntu:24.04@sha256:{'1' * 64} (the official image)"
    assert list(result.seconds) == ["base image", "build and push", "structure tests", "index and tags"]
    assert stage.said == [
        "base image",
        f"ROS's apt repository http://ros.test/ros2/ubuntu, published {SYNC}",
        f"build {TARGET} and push it by digest",
        "structure tests, inside the image",
        "index and tags",
    ]


def test_order_of_the_work(stage: Stage) -> None:
    """Built, tested, and only then an index and tags; the very digest that was tested."""
    stage.publish()
    found = [call for call in calls(stage.folder) if not call.startswith(("buildx inspect", "regctl manifest"))]
    assert [" ".join(call.split()[:3]) for call in found[1:]] == [
        *("regctl image config", "buildx bake --file", "regctl index create"),
        *["regctl image copy"] * 4,
    ]
    repository = f"{stage.registry}/rosml/ros-torch"
    output = f"--set {TARGET}.output=type=image,name={repository},push=true,push-by-digest=true,"
    assert output in found[0]
    assert f"--set {TARGET}.tags= {TARGET}" in found[0]
    assert found[1].endswith(f"--platform linux/amd64 {repository}@{MANIFEST}")
    assert f"{TARGET}-test.target=test-report" in found[2]
    assert f"--ref {repository}@{MANIFEST}" in found[3]
    assert "--annotation org.opencontainers.image.version=1" in found[3] and "io.rosml" not in found[3]
    assert found[4] == f"regctl image copy {repository}@{INDEX} {repository}:alpha-base-cu1"


def test_the_builder_is_told_of_when_ros_repository_is(stage: Stage, monkeypatch: pytest.MonkeyPatch) -> None:
    """A new state is a new argument; where nobody can be asked, what is known of last time keeps the builder's cache."""
    stage.write("buildx", (stage.folder / "buildx").read_text().replace("case $1", 'env >"$here/env-$1"\ncase $1', 1))

    def silent(source: apt_source.Source) -> str:
        raise RosmlError("nobody answers", "wait")

    monkeypatch.setattr(sync, "published", silent)
    stage.publish()
    assert 'ROS_SYNC_DATES={"alpha": ""}\n' in (stage.folder / "env-bake").read_text()
    assert "nobody answers; taken for as it was last time: never asked" in stage.said
    monkeypatch.setattr(sync, "published", lambda source: SYNC)
    stage.publish()
    monkeypatch.setattr(sync, "published", silent)
    stage.publish()
    assert f'ROS_SYNC_DATES={{"alpha": "{SYNC}"}}\n' in (stage.folder / "env-bake").read_text()


def test_base_images_of_parts_and_tools(stage: Stage) -> None:
    """Of the image itself, and of what payloads and tests are assembled on."""
    stage.write("buildx", (stage.folder / "buildx").read_text().replace("case $1", 'env >"$here/env-$1"\ncase $1', 1))
    for name in ("ros2-workspace", "ros2-components", "pip"):  # omega has no image with both frameworks
        stage.write(f"report/{name}.json", results(one=True))
    result = stage.publish("omega-base-torch-cu1")
    env = (stage.folder / "env-bake").read_text()
    assert f"OS_UBUNTU_24_04=docker-image://docker.io/library/ubuntu:24.04@sha256:{'1' * 64}\n" in env
    assert f"OS_UBUNTU_26_04=docker-image://docker.io/library/ubuntu:26.04@sha256:{'2' * 64}\n" in env
    assert f"REGISTRY={stage.registry}/rosml\n" in env
    assert result.base.startswith("docker.io/library/ubuntu:26.04@")


def test_a_second_call_moves_only_what_pointed_elsewhere(stage: Stage) -> None:
    stage.publish()
    stage.write("tags/alpha", "sha256:other")
    stage.write("progress-test", TEST.replace('"completed"', '"cached": true, "completed"'))
    result = stage.publish()
    assert result.moved == ["alpha"]
    assert stage.tags() == dict.fromkeys(TAGS, INDEX)
    assert "structure tests (same image, same tests)" in result.reused
    assert "structure tests" not in result.work


def test_what_was_built_is_remembered(stage: Stage, monkeypatch: pytest.MonkeyPatch) -> None:
    stage.publish()
    built = json.loads((stage.folder / ".state/built.json").read_text())
    assert {TARGET, "alpha-base", "cuda-cu1", "common-cu1-py312", "torch-cu1-py312"} <= set(built)
    free(monkeypatch, 1)
    assert stage.publish().digest == INDEX, "a second call needs no room"


def test_another_architecture_is_built_and_tested_and_gets_no_tag(stage: Stage) -> None:
    """A tag is for all platforms of an image: one of them alone does not move it."""
    target = "alpha-core-ml-cpu"
    stage.write("buildx", (stage.folder / "buildx").read_text().replace("case $1", 'env >"$here/env-$1"\ncase $1', 1))
    with pytest.raises(RosmlError, match="does not run programs for linux/arm64") as caught:
        stage.publish(target, architecture="arm64")
    assert caught.value.remedy == "run 'make emulation'"
    stage.write("status", "Status: running\nPlatforms: linux/amd64, linux/arm64*\n")
    stage.write("progress-cpu", "")
    for name in ("ros2-core", "ros2-workspace", "ros2-components", "tensorflow", "torch", "ml", "pip"):
        stage.write(f"report/{name}.json", results(one=True))
    result = stage.publish(target, architecture="arm64")
    assert stage.untouched()
    assert "PLATFORM=linux/arm64\n" in (stage.folder / "env-bake").read_text()
    assert result.reference == f"{stage.registry}/rosml/ros-ml@{MANIFEST}"
    assert result.passed and not result.tags
    assert not (stage.folder / ".state/built.json").exists(), "the forecast is the machine's own architecture's"
    shown = summary.text(result)
    assert f"{target} is built, tested and pushed by its digest" in shown
    assert "none: a tag is for all platforms of an image" in shown


def test_one_architecture_needs_no_lock_of_another(stage: Stage) -> None:
    catalogue = parse(changed("cpu: [arm64]}", "cpu: [amd64, arm64]}"))
    present = {lock for payload in catalogue.payloads for lock in payload.locks} - {"locks/cpu/amd64/3.12/torch.txt"}
    image = locked.with_locks(catalogue, present).image("alpha-core-torch-cpu")
    require_buildable(image, "arm64")
    for architecture in ("", "amd64"):
        with pytest.raises(RosmlError, match="cannot be built yet"):
            require_buildable(image, architecture)


def test_another_channel_is_checked_before_anything_happens(
    checkout: Stage, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("ROS_CHANNEL", "fina")
    assert run(checkout, TARGET, "--check") == 2
    assert "no channel 'fina'" in capsys.readouterr().err


def test_a_platform_that_nothing_has(checkout: Stage, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(checkout, TARGET, "--platform", "linux/riscv") == 2
    assert "linux/amd64 and linux/arm64" in capsys.readouterr().err
    assert run(checkout, TARGET, "--platform", "linux/arm64") == 2
    assert f"{TARGET} exists for amd64 only\n" in capsys.readouterr().err


# ---- Nothing is tagged -----------------------------------------------------------------------------------------------


def test_a_test_fails(stage: Stage) -> None:
    stage.write("report/torch.json", results(good=True, bad=False))
    with pytest.raises(TestsFailed) as caught:
        stage.publish()
    error = caught.value
    assert stage.untouched()
    assert error.message.startswith(f"1 of 14 structure tests of {TARGET} failed; no tag was moved\n")
    assert "    torch: bad\n      it broke\n" in error.message
    assert error.message.endswith(f"all reports: {stage.folder}/.state/tests/{TARGET}/report")
    assert MANIFEST in error.remedy
    assert (error.exit_code, error.result.failed, error.result.passed) == (1, 1, 13)


def test_payloads_beyond_the_budget_fail(stage: Stage) -> None:
    """The tag's budget is a test like any other."""

    def budget(megabytes: int) -> image_set.Catalogue:
        catalogue = parse(
            changed("  parts:\n    cu1:", f"  budgets: {{cu1: {{torch: {megabytes}}}}}\n  parts:\n    cu1:")
        )
        return locked.with_locks(catalogue, {lock for payload in catalogue.payloads for lock in payload.locks})

    stage.write("manifest.json", '{"layers": [{"digest": "x", "size": 2000000}, {"digest": "y", "size": 2000001}]}')
    stage.catalogue = budget(4)
    with pytest.raises(TestsFailed, match=r"size: the payloads keep within the tag's budget\n.* allows 4 MB"):
        stage.publish()
    assert stage.untouched()
    stage.catalogue = budget(5)
    result = stage.publish()
    assert (result.passed, result.payloads) == (15, 4_000_001)


def test_a_test_fails_and_tags_stay_where_they_were(stage: Stage) -> None:
    for tag in TAGS:
        stage.write(f"tags/{tag}", "sha256:good")
    stage.write("report/torch.json", results(bad=False))
    with pytest.raises(TestsFailed):
        stage.publish()
    assert stage.tags() == dict.fromkeys(TAGS, "sha256:good")


@pytest.mark.parametrize(
    ("name", "text"),
    [("contract", None), ("contract", '{"Results": []}'), ("metadata", '{"Results": null}'), ("metadata", "killed")],
)
def test_a_file_without_tests_or_report_fails(stage: Stage, name: str, text: str | None) -> None:
    file = stage.folder / f"report/{name}.json"
    file.unlink()
    if text is not None:
        file.write_text(text)
    with pytest.raises(TestsFailed, match=f"1 of 13 structure tests .*\n    {name}: "):
        stage.publish()
    assert stage.untouched()


def test_an_old_report_is_not_believed(stage: Stage) -> None:
    stage.publish()
    shutil.rmtree(stage.folder / "report")
    shutil.rmtree(stage.folder / "tags")
    (stage.folder / "tags").mkdir()
    with pytest.raises(RosmlError, match="left no report"):
        stage.publish()
    assert not stage.tags()


@pytest.mark.parametrize("noted", [None, ""])
def test_a_failed_test_is_run_again(stage: Stage, noted: str | None) -> None:
    """Its outcome is in the builder's cache: the next attempt has to look different. Also after a damaged note."""
    if noted is not None:
        (stage.folder / f".state/tests/{TARGET}").mkdir(parents=True)
        stage.write(f".state/tests/{TARGET}/failed-attempts", noted)
    stage.write("report/torch.json", results(bad=False))
    for _ in range(2):
        with pytest.raises(TestsFailed):
            stage.publish()
    stage.write("report/torch.json", results(bad=True))
    for _ in range(2):
        assert stage.publish().failed == 0
    runs = [call.split("TEST_ATTEMPT=")[1].split()[0] for call in stage.calls("buildx bake") if "-test" in call]
    assert len(set(runs[:3])) == 3, "every attempt after a failure is a new one"
    assert runs[2] == runs[3], "what passed is taken from the cache"


def test_the_build_fails(stage: Stage) -> None:
    stage.write("code", "1")
    stage.write("progress-cu1", line("[a ros 1/2] RUN apt", error="exit code: 100", **ENDED) + "ERROR: failed\n")
    with pytest.raises(RosmlError, match=rf"building {TARGET} failed in step \[a ros 1/2\] apt\n    exit code: 100"):
        stage.publish()
    assert stage.untouched()
    assert not (stage.folder / ".state/built.json").exists()
    assert len(stage.calls("buildx bake")) == 1, "nothing is tested"


def test_buildx_says_no_digest(stage: Stage) -> None:
    stage.write("digest", "")
    with pytest.raises(RosmlError, match=f"did not say which digest it pushed for {TARGET}") as caught:
        stage.publish()
    assert caught.value.remedy == "run it again"
    assert stage.untouched()
    assert len(stage.calls("buildx bake")) == 1


def test_no_room(stage: Stage, monkeypatch: pytest.MonkeyPatch) -> None:
    free(monkeypatch, 4_000)
    with pytest.raises(RosmlError, match=rf"build {TARGET}: 9\.4 GB are needed .*, 4\.0 GB are free at "):
        stage.publish()
    assert not stage.calls("buildx bake")


def test_services_are_down(stage: Stage) -> None:
    stage.write("status", "Status: stopped\n")
    with pytest.raises(RosmlError, match="builder 'rosml' is stopped"):
        stage.publish()
    with pytest.raises(RosmlError, match=r"registry at 127\.0\.0\.1:1 does not answer"):
        stage.publish(registry="127.0.0.1:1")
    assert not stage.calls("buildx bake")


def test_unknown_target(stage: Stage) -> None:
    with pytest.raises(RosmlError, match="did you mean 'alpha-base-torch-cu1'") as caught:
        stage.publish("alpha-bse-torch-cu1")
    assert caught.value.exit_code == 2
    assert calls(stage.folder) == []


# ---- The command -----------------------------------------------------------------------------------------------------


@pytest.fixture
def checkout(stage: Stage, monkeypatch: pytest.MonkeyPatch) -> Stage:
    """A stage on which the command runs in this process."""
    monkeypatch.setattr(script, "ROOT", stage.folder)
    monkeypatch.setattr(signal, "signal", lambda *_: None)  # a test run keeps its own
    stage.write("matrix.yaml", SMALL)
    return stage


@pytest.fixture(autouse=True)
def attached(monkeypatch: pytest.MonkeyPatch) -> list[tuple[str, Entry]]:
    """What the command attaches to images: repository and facts. The stand-in for the registry has no manifests."""
    found: list[tuple[str, Entry]] = []
    monkeypatch.setattr(
        ledger.Ledger, "attach", lambda book, entry, _: found.append((book.path(entry.repository), entry))
    )
    monkeypatch.setattr(Inputs, "digest", lambda self, target, architecture: f"inputs of {target}")
    return found


def run(stage: Stage, *arguments: str) -> int:
    return command.run(script.cli, arguments=["image", "--matrix", str(stage.folder / "matrix.yaml"), *arguments])


def test_command(checkout: Stage, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(checkout, TARGET) == 0
    done = capsys.readouterr()
    assert f"FROM             {checkout.registry}/rosml/ros-torch:alpha-base-cu1\n" in done.out
    assert "==> structure tests, inside the image\n" in done.err
    excerpt = checkout.folder / f".state/bake/{TARGET}.hcl"
    assert f"buildx bake --file {excerpt}" in checkout.calls("buildx bake")[0]
    assert re.findall(r"^  (alpha|omega) = {$", excerpt.read_text(), re.MULTILINE) == ["alpha"]


def test_command_leaves_committed_files_alone(checkout: Stage) -> None:
    """A stale docker-bake.hcl is no matter of a build, which reads an excerpt of its own: make generate writes it."""
    (checkout.folder / "docker-bake.hcl").write_text("# somebody's edit\n")
    assert run(checkout, TARGET) == 0
    assert (checkout.folder / "docker-bake.hcl").read_text() == "# somebody's edit\n"


def test_command_with_another_matrix_leaves_the_bake_file_alone(checkout: Stage) -> None:
    (checkout.folder / "matrix.yaml").rename(checkout.folder / "mine.yaml")
    arguments = ["image", "--matrix", str(checkout.folder / "mine.yaml"), "--namespace", "try", "--json", TARGET]
    assert command.run(script.cli, arguments=arguments) == 0
    assert not (checkout.folder / "docker-bake.hcl").exists()
    assert f"--file {checkout.folder}/.state/bake/{TARGET}.hcl" in checkout.calls("buildx bake")[0]


def test_what_was_found_out_is_attached_to_the_image(
    checkout: Stage, capsys: pytest.CaptureFixture[str], attached: list[tuple[str, Entry]]
) -> None:
    assert run(checkout, "--json", "--namespace", "try", TARGET) == 0
    result = json.loads(capsys.readouterr().out)
    ((repository, entry),) = attached
    assert repository == "try/ros-torch"
    assert (entry.target, entry.digest, entry.inputs) == (TARGET, result["manifest"], f"inputs of {TARGET}")
    assert (entry.passed, entry.versions) == (result["passed"], result["versions"]) and entry.passed
    assert (entry.size, entry.unpacked) == (result["compressed"], result["unpacked"])


def test_command_json(checkout: Stage, capsys: pytest.CaptureFixture[str]) -> None:
    assert run(checkout, "--json", "--namespace", "try", TARGET) == 0
    result = json.loads(capsys.readouterr().out)
    assert (result["target"], result["digest"]) == (TARGET, INDEX)
    assert result["reference"] == f"{checkout.registry}/try/ros-torch:alpha-base-cu1"


def test_command_near_miss(checkout: Stage, capsys: pytest.CaptureFixture[str]) -> None:
    """A typo is told before anything else, even where no service is up."""
    shutil.rmtree(checkout.folder / ".state")
    assert run(checkout, "alpha-bse-torch-cu1") == 2
    done = capsys.readouterr()
    assert done.out == ""
    assert "error: no image named 'alpha-bse-torch-cu1'; did you mean 'alpha-base-torch-cu1'" in done.err
    assert "remedy: see all with:" in done.err
    assert not (checkout.folder / "docker-bake.hcl").exists()
    assert run(checkout, "omega-base-ml-cu1") == 2
    assert "no release of tensorflow has a wheel for Python 3.14" in capsys.readouterr().err


def test_command_before_the_set_up(checkout: Stage, capsys: pytest.CaptureFixture[str]) -> None:
    shutil.rmtree(checkout.folder / ".state")
    assert run(checkout, TARGET) == 1
    assert "are not up\nremedy: run 'make up'\n" in capsys.readouterr().err


def test_command_when_tests_fail(checkout: Stage, capsys: pytest.CaptureFixture[str]) -> None:
    checkout.write("report/torch.json", results(bad=False))
    assert run(checkout, TARGET) == 1
    done = capsys.readouterr()
    assert done.out == ""
    assert "error: 1 of 13 structure tests" in done.err
    assert "remedy: mend the component or the test" in done.err
    assert checkout.untouched()


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_interrupted(stage: Stage, number: signal.Signals) -> None:
    """The real command in a process of its own: buildx is told, no tag moves, the exit code is a shell's."""
    stage.write("matrix.yaml", SMALL)
    stage.write(".state/built.json", json.dumps(["alpha-base", "cuda-cu1", "common-cu1-py312", "torch-cu1-py312"]))
    waits = "trap 'echo told >>$here/calls; exit 1' INT; touch $here/ready; while :; do sleep 0.02; done"
    buildx(stage.folder, waits)
    driver = (
        "import runpy, signal, sys; from pathlib import Path; import rosml\n"
        "signal.signal(signal.SIGINT, signal.default_int_handler)\n"
        f"rosml.ROOT = Path({str(stage.folder)!r})\n"
        f"sys.argv = ['publish', 'image', {TARGET!r}]\n"
        f"runpy.run_path({str(ROOT / 'scripts/publish.py')!r}, run_name='__main__')\n"
    )
    process = subprocess.Popen(
        [sys.executable, "-c", driver],
        env={**os.environ, "PYTHONPATH": str(ROOT)},
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    try:
        end = time.monotonic() + 10
        while not (stage.folder / "ready").exists() and process.poll() is None and time.monotonic() < end:
            time.sleep(0.01)
        process.send_signal(number)
        out, err = process.communicate(timeout=10)
    finally:
        process.kill()
    assert (process.returncode, out) == (130, "")
    assert err.endswith(
        "interrupted: no tag points at what is not finished; what was finished is kept, the next call carries on\n"
    )
    assert "Traceback" not in err
    assert calls(stage.folder)[-1] == "told"
    assert stage.untouched()
