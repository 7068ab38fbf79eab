"""`rosml ci`: inputs that forges pass, tags of a commit's images, indexes of several jobs, and what a failed test leaves."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from click.testing import CliRunner

from fakes.apps import Robot, robot, services
from fakes.http_registry import LocalRegistry
from rosml.base.errors import RosmlError
from rosml.cli.containerize import ci as command
from rosml.containerize import inputs as app_inputs
from rosml.containerize.build.outcome import Outcome
from rosml.containerize.build.result import Image, Result
from rosml.containerize.build.step_order import build_images, new_call
from rosml.containerize.ci import inputs as ci_inputs
from rosml.containerize.ci import job as ci_job
from rosml.containerize.inputs import Values
from rosml.machine.services import Services
from rosml.registry import oci, references
from rosml.registry.client import Registries, Registry

__all__ = ["robot", "services"]

GITHUB = {
    "GITHUB_ACTIONS": "true",
    "GITHUB_WORKSPACE": "/work",
    "GITHUB_REF": "refs/heads/main",
    "GITHUB_REF_NAME": "main",
    "GITHUB_REF_TYPE": "branch",
    "DEFAULT_BRANCH": "main",
}
GITLAB = {
    "GITLAB_CI": "true",
    "CI_PROJECT_DIR": "/work",
    "CI_COMMIT_REF_NAME": "main",
    "CI_COMMIT_BRANCH": "main",
    "CI_DEFAULT_BRANCH": "main",
}
MAIN = ci_job.Commit("main", "", True, Path())


# ---- Inputs ----------------------------------------------------------------------------------------------------------


def test_an_input_counts_before_a_variable_and_before_the_forges_default() -> None:
    environment = {"INPUT_TARGET": "dev", "TARGET": "run", "DEFAULT_TARGET": "run", "INPUT_PLATFORM": ""}
    environment |= {"PLATFORM": "arm64", "DEFAULT_PLATFORM": "amd64", "DEFAULT_REGISTRY": "registry.example.org"}
    inputs = {"target": "dev", "platform": "arm64", "registry": "registry.example.org"}
    assert ci_inputs.inputs_of(environment) == inputs


def test_a_flag_that_only_ci_has_is_true_or_false() -> None:
    assert [ci_inputs.flag("x", inputs) for inputs in ({}, {"x": "True"}, {"x": "false"})] == [False, True, False]
    with pytest.raises(RosmlError, match="x is true or false, not 'yes'"):
        ci_inputs.flag("x", {"x": "yes"})


def test_the_password_reaches_docker_on_no_command_line(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    docker = tmp_path / "docker"
    docker.write_text(f'#!/bin/sh\n{{ echo "$*"; cat; }} >{tmp_path}/call\n[ "$3" = me ]\n')
    docker.chmod(0o755)
    monkeypatch.setenv("PATH", str(tmp_path), prepend=os.pathsep)
    environment = {"DEFAULT_REGISTRY": "registry.example.org", "REGISTRY_PASSWORD": "p$ss '", "REGISTRY_USER": "me"}
    assert CliRunner().invoke(command.main, ["login"], env=environment).exit_code == 0
    call = "login --username me --password-stdin registry.example.org\np$ss '"
    assert (tmp_path / "call").read_text() == call
    end = CliRunner().invoke(command.main, ["login"], env={**environment, "REGISTRY_USER": "you"})
    assert str(end.exception) == "registry.example.org refuses you"


# ---- Tags ------------------------------------------------------------------------------------------------------------

TAG = {"GITHUB_REF": "refs/tags/v1.2", "GITHUB_REF_NAME": "v1.2", "GITHUB_REF_TYPE": "tag"}
BRANCH = {"GITHUB_REF": "refs/heads/feat/Lidar_2", "GITHUB_REF_NAME": "feat/Lidar_2"}
PULL = {"GITHUB_REF": "refs/pull/7/merge", "GITHUB_REF_NAME": "7/merge", "GITHUB_HEAD_REF": "feat/Lidar_2"}
NIGHT = {"GITHUB_EVENT_NAME": "schedule", "DEFAULT_BRANCH": ""}
LATEST = {"enable-push-as-latest": "true"}
JAZZY = {"image-tag": "jazzy"}
REQUEST = {"CI_COMMIT_REF_NAME": "feat/x", "CI_COMMIT_BRANCH": ""}
RELEASE = {"CI_COMMIT_REF_NAME": "v1", "CI_COMMIT_BRANCH": "", "CI_COMMIT_TAG": "release/v1"}


@pytest.mark.parametrize(
    ("forge", "changes", "inputs", "run", "dev"),
    [
        (GITHUB, {}, {}, ["latest"], ["latest-dev"]),
        (GITHUB, {}, {**JAZZY, **LATEST}, ["jazzy", "latest"], ["jazzy-dev", "latest-dev"]),
        (GITHUB, NIGHT, {}, ["latest"], ["latest-dev"]),
        (GITHUB, BRANCH, LATEST, ["latest_feat-lidar-2_ci"], ["latest-dev_feat-lidar-2_ci"]),
        (GITHUB, PULL, {}, ["latest_feat-lidar-2_ci"], ["latest-dev_feat-lidar-2_ci"]),
        # Of an event pull_request_target, whose ref is the default branch.
        (GITHUB, {"GITHUB_HEAD_REF": "main"}, {}, ["latest_main_ci"], ["latest-dev_main_ci"]),
        (GITHUB, TAG, {}, ["v1.2", "latest-v1.2"], ["v1.2-dev", "latest-dev-v1.2"]),
        (GITHUB, TAG, {**JAZZY, "dev-image-tag": "work"}, ["jazzy-v1.2"], ["work-v1.2"]),
        (GITHUB, TAG, {**JAZZY, **LATEST}, ["v1.2", "jazzy-v1.2"], ["v1.2-dev", "jazzy-dev-v1.2"]),
        (GITLAB, {}, {}, ["latest"], ["latest-dev"]),
        (GITLAB, REQUEST, {}, ["latest_feat-x_ci"], ["latest-dev_feat-x_ci"]),
        (GITLAB, RELEASE, {}, ["release-v1", "latest-release-v1"], ["release-v1-dev", "latest-dev-release-v1"]),
    ],
)
def test_only_the_default_branch_moves_the_tag_that_inputs_name(
    forge: Mapping[str, str],
    changes: Mapping[str, str],
    inputs: Mapping[str, str],
    run: list[str],
    dev: list[str],
    tmp_path: Path,
) -> None:
    commit, values = ci_job.commit({**forge, **changes}), app_inputs.values(inputs, tmp_path, {})
    assert [ci_job.tags(target, values, commit) for target in ("run", "dev")] == [run, dev]


def test_elsewhere_is_no_job() -> None:
    with pytest.raises(RosmlError, match="no job of GitHub or GitLab") as caught:
        ci_job.commit({"CI": "true"})
    assert caught.value.exit_code == 2


# ---- Images ----------------------------------------------------------------------------------------------------------

SUITE = """<testsuite><testcase name="good" classname="a"/>
<testcase name="bad" classname="a"><failure message="1% is not 2"/></testcase></testsuite>"""


class Machine:
    """Jobs with a build that pushes an image for each target and leaves reports, or else an error."""

    def __init__(self, services: Services, server: LocalRegistry, out: Path) -> None:
        self.services, self.server, self.out = services, server, out
        self.error = ""

    def new_call(self, _: object, values: Values, *__: object) -> SimpleNamespace:
        return SimpleNamespace(values=values, reports=self.services.state / "report")

    def build_images(self, call: Any) -> Result:
        values, images = call.values, []
        platforms = values.platform.split(",")
        for platform in platforms:
            folder = call.reports if len(platforms) == 1 else call.reports / platform.replace("/", "_")
            (folder / "results/robot").mkdir(parents=True)
            (folder / "results/robot/a.xml").write_text(SUITE)
        if self.error:
            raise RosmlError(self.error, "correct them")
        for target in values.target.split(","):
            before = "" if target == "run" else f"{target}-"
            reference = f"{values.text(f'{before}image-name') or values.image_name}:{values.text(f'{before}image-tag')}"
            images.append(Image(target, reference, self.push(reference)))
        return Result("base", images, Outcome())

    def push(self, reference: str) -> str:
        """Pushes an image that is not there a second time. Returns its digest."""
        place = references.parse(reference)
        with Registry(self.services.registry) as client:
            blob = oci.encoded({"os": "linux", "of": reference})
            client.put_blob(place.repository, blob)
            config = oci.descriptor(oci.CONFIG, blob)
            manifest = {"schemaVersion": 2, "mediaType": oci.IMAGE, "config": config, "layers": []}
            return client.put_manifest(place.repository, place.reference, oci.encoded(manifest))

    def job(self, commit: ci_job.Commit = MAIN, /, **inputs: str) -> ci_job.Job:
        inputs = {"image_name": f"{self.services.registry}/Me/Robot", "target": "run", "push": "true", **inputs}
        values = app_inputs.values({name.replace("_", "-"): text for name, text in inputs.items()}, self.out, {})
        return ci_job.Job(values, {}, commit, lambda line: None)

    def build(
        self, apart: bool = True, commit: ci_job.Commit = MAIN, /, **inputs: str
    ) -> tuple[list[ci_job.Image], Path]:
        """Runs a job. Returns its images, and the folder that the job for the index gets as an artifact."""
        job = self.job(commit, **inputs)
        return job.build(self.out, self.services, self.out / job.name, apart), self.out / job.name

    def index(self, **inputs: str) -> list[ci_job.Image]:
        with Registries() as registries:
            return self.job(**inputs).index(self.out, registries)

    def entries(self, image: ci_job.Image) -> dict[str, str]:
        """The digests of an index, by architecture."""
        index = json.loads(self.server.manifests["me/robot", image.digest][1])
        return {entry["platform"]["architecture"]: entry["digest"] for entry in index["manifests"]}

    @property
    def tags(self) -> dict[str, str]:
        return dict(self.server.tags["me/robot"])


@pytest.fixture
def machine(services: Services, server: LocalRegistry, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Machine:
    machine = Machine(services, server, tmp_path / "artifacts")
    monkeypatch.setattr(ci_job, "new_call", machine.new_call)
    monkeypatch.setattr(ci_job, "build_images", machine.build_images)
    return machine


PLATFORMS = ("amd64", "arm64")


def test_all_tags_of_a_commit_are_one_image(machine: Machine) -> None:
    commit = ci_job.Commit("v1", "v1", False, Path())
    images, _ = machine.build(False, commit, target="run,dev", platform="amd64")
    tags, name = machine.tags, f"{machine.services.registry}/me/robot"
    assert tags.keys() == {"v1", "latest-v1", "v1-dev", "latest-dev-v1"}
    assert tags["v1"] == tags["latest-v1"] != tags["v1-dev"]
    assert ci_job.outputs(images) == {
        "image": f"{name}:v1",
        "digest": tags["v1"],
        "dev-image": f"{name}:v1-dev",
        "dev-digest": tags["v1-dev"],
    }


def test_an_index_has_every_platform_and_gets_all_tags(machine: Machine) -> None:
    """Of what jobs left, that of a call with another tag is passed over."""
    inputs = {"image_tag": "v1", "enable_push_as_latest": "true"}
    machine.build(platform="amd64", image_tag="v2")
    for platform in PLATFORMS:
        machine.build(platform=platform, **inputs)
    [image] = machine.index(platform="amd64,arm64", **inputs)
    tags = machine.tags
    assert tags["v1"] == tags["latest"] == image.digest
    assert machine.entries(image) == {"amd64": tags["v1-amd64"], "arm64": tags["v1-arm64"]}


@pytest.mark.parametrize("place", ["reports/zz", "reports-amd64/linux_amd64/robot", "zz"])
def test_no_other_file_says_what_a_job_made(place: str, machine: Machine) -> None:
    """Such as one that a test wrote, or that a repository has where GitLab keeps artifacts."""
    folder, _ = (machine.build(platform=platform)[1] for platform in PLATFORMS)
    images = json.loads((folder / ci_job.FILE).read_text())
    images[0]["digest"] = machine.push(f"{machine.services.registry}/me/robot:evil")
    for above in (folder, machine.out):
        (above / place).mkdir(parents=True, exist_ok=True)
        (above / place / ci_job.FILE).write_text(json.dumps(images))
    [image] = machine.index(platform="amd64,arm64")
    assert images[0]["digest"] not in machine.entries(image).values()


@pytest.mark.parametrize("content", ["[" * 99_999, '[{"target": "run"}]', None], ids=lambda text: str(text)[:20])
def test_a_damaged_file_of_a_job_is_refused(content: str | None, machine: Machine) -> None:
    file = machine.build(platform="amd64")[1] / ci_job.FILE
    file.unlink()
    if content is None:
        file.symlink_to("/proc/self/environ")
    else:
        file.write_text(content)
    with pytest.raises(RosmlError, match=r"images\.json.*(damaged|link)") as caught:
        machine.index(platform="amd64")
    assert caught.value.remedy


def test_a_slim_image_has_tags_and_an_index_as_others(machine: Machine) -> None:
    for platform in PLATFORMS:
        machine.build(platform=platform, target="run,slim")
    images = machine.index(platform="amd64,arm64")
    assert [image.target for image in images] == ["run", "slim"]
    assert ci_job.outputs(images)["slim-image"] == f"{machine.services.registry}/me/robot:latest-slim"
    assert {"latest", "latest-slim"} <= machine.tags.keys()


@pytest.mark.parametrize("base", ["", "small:1"])
def test_a_slim_image_that_one_platform_lacks(base: str, machine: Machine) -> None:
    """Its own base image has none without compilers there. If somebody named the base image, a job has failed."""
    machine.build(platform="amd64", target="run,slim")
    machine.build(platform="arm64")
    inputs = {"platform": "amd64,arm64", "slim_base_image": base}
    if base:
        with pytest.raises(RosmlError, match=r"there is no slim image .* for linux/arm64; no tag was moved"):
            machine.index(**inputs)
    else:
        assert [image.target for image in machine.index(**inputs)] == ["run"]
    assert ("latest" in machine.tags) is (not base)


def test_no_tag_moves_if_a_platform_is_missing(machine: Machine) -> None:
    machine.build(platform="amd64")
    with pytest.raises(RosmlError, match="for linux/arm64; no tag was moved"):
        machine.index(platform="amd64,arm64")
    assert machine.index(platform="amd64", push="false") == [], "what is not pushed gets no index"
    assert machine.tags.keys() == {"latest-amd64"}


def test_no_tag_of_ci_loses_a_platform(machine: Machine) -> None:
    """Of a job, nor of the index of several: all are looked at before the first one moves."""
    latest = {"enable_push_as_latest": "true"}
    for platform in PLATFORMS:
        machine.build(platform=platform, image_tag="v1", **latest)
    machine.index(platform="amd64,arm64", image_tag="v1", **latest)
    before = machine.tags
    for tag in ("v1", "v2"):
        with pytest.raises(RosmlError, match="is for linux/amd64, linux/arm64, and would be for linux/amd64 alone"):
            machine.build(False, platform="amd64", image_tag=tag, **latest)
    assert machine.tags == before
    machine.build(platform="amd64", image_tag="v2", **latest)
    with pytest.raises(RosmlError, match=":latest is for linux/amd64, linux/arm64, and would be"):
        machine.index(platform="amd64", image_tag="v2", **latest)
    assert all(machine.tags[name] == before[name] for name in ("v1", "latest"))


def test_a_build_takes_what_ci_makes_of_the_inputs(
    machine: Machine, robot: Robot, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(ci_job, "new_call", new_call)
    monkeypatch.setattr(ci_job, "build_images", build_images)
    robot.put("rosml/ros:jazzy", "linux/arm64")
    robot.app |= {"architecture": "arm64", "apt": {"tree": "2.1"}}
    inputs = {"base_image": "ros:jazzy", "command": "true", "target": "run,dev", "platform": "arm64", "push": "false"}
    job = machine.job(ci_job.Commit("x", "", False, Path()), **inputs)
    images = job.build(robot.folder, robot.services, machine.out, True)
    name, [_, run, dev] = f"{machine.services.registry}/me/robot", robot.targets
    assert run["tags"] == [f"{name}:latest_x_ci-arm64"] == [images[0].reference]
    assert dev["tags"] == [f"{name}:latest-dev_x_ci-arm64"] == [images[1].reference]
    lock = json.loads((machine.out / "containerize-arm64.lock").read_text())
    assert lock["apt"] == {"arm64": {"tree": "2.1"}}, "also if no test left a report"


def test_a_name_without_a_registry_is_docker_hubs(machine: Machine) -> None:
    images, _ = machine.build(False, image_name="Me/Robot", push="false")
    assert images[0].reference == "docker.io/me/robot:latest"


def test_a_slim_image_that_nobody_made_is_no_secret(
    machine: Machine, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The job is green, and who deploys its tag goes on with an older one."""
    monkeypatch.setattr(Services, "of_docker", lambda *_: machine.services)
    monkeypatch.setattr(Services, "require_builder", lambda self: None)
    environment: dict[str, Any] = {
        **GITHUB,
        "GITHUB_WORKSPACE": str(tmp_path),
        "IMAGE_NAME": f"{machine.services.registry}/me/robot",
    }
    environment |= {"GITHUB_STEP_SUMMARY": str(tmp_path / "page.md"), "ENABLE_SLIM": "true"}
    for target, warns in (("run", True), ("run,slim", False), ("dev", False)):
        words = ["build", "--out", str(tmp_path / "out")]
        end = CliRunner().invoke(command.main, words, env={**environment, "TARGET": target})
        text = f"::warning title=rosml containerize::no slim image: {machine.services.registry}/me/robot:latest-slim stays as"
        assert end.exit_code == 0 and (text in end.stdout) == warns


def test_a_runner_without_docker(tmp_path: Path) -> None:
    """A checkout is no help: the files for CI build with Docker there, too."""
    environment = {**GITHUB, "GITHUB_WORKSPACE": str(tmp_path), "PATH": str(tmp_path)}
    end = CliRunner().invoke(command.main, ["build", "--out", str(tmp_path / "out")], env=environment)
    assert isinstance(end.exception, RosmlError) and "docker buildx does not answer" in end.exception.message
    assert end.exception.remedy == "install Docker with buildx, and start it"


# ---- Tests -----------------------------------------------------------------------------------------------------------


def test_a_failed_test_is_shown_and_its_reports_are_kept(
    machine: Machine, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    machine.error = "1 of 2 tests failed; no image was made"
    monkeypatch.setattr(Services, "of_docker", lambda *_: machine.services)
    monkeypatch.setattr(Services, "require_builder", lambda self: None)
    page, outputs = tmp_path / "page.md", tmp_path / "outputs"
    environment: dict[str, Any] = {**GITHUB, "GITHUB_WORKSPACE": str(tmp_path), "GITHUB_STEP_SUMMARY": str(page)}
    environment |= {"GITHUB_OUTPUT": str(outputs), "IMAGE_NAME": "ghcr.io/Me/Robot", "PLATFORM": "amd64,arm64"}

    def build() -> list[str]:
        end = CliRunner().invoke(command.main, ["build", "--out", str(tmp_path / "out")], env=environment)
        assert isinstance(end.exception, RosmlError)
        return end.stdout.splitlines()

    assert build() == ["::error title=Test failed::robot: a.bad: 1%25 is not 2"] * 2
    assert "4 tests, 2 failed, 0 skipped" in page.read_text()
    values = dict(line.split("=", 1) for line in outputs.read_text().splitlines())
    assert values["artifact"] == "containerize-ghcr.io-me-robot-latest-linux-amd64-linux-arm64"
    folder = Path(values["folder"])
    files = sorted(str(path.relative_to(folder)) for path in folder.rglob("*.xml"))
    assert files == [f"reports/linux_{name}/robot/a.xml" for name in PLATFORMS]

    def refuse(_: Services) -> None:
        raise RosmlError("docker buildx does not answer", "install Docker")

    monkeypatch.setattr(Services, "require_builder", refuse)
    environment["IMAGE_TAG"] = "other"
    assert build() == ["::error title=rosml containerize::docker buildx does not answer"]


def test_a_build_context_that_is_not_there_is_named(tmp_path: Path) -> None:
    environment = {**GITHUB, "GITHUB_WORKSPACE": str(tmp_path), "BUILD_CONTEXT": "src"}
    end = CliRunner().invoke(command.main, ["build", "--out", str(tmp_path / "out")], env=environment)
    assert isinstance(end.exception, RosmlError) and str(tmp_path / "src") in end.exception.message
