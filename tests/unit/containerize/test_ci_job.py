"""`rosml ci`: inputs that forges pass, tags of a commit's images, indexes of several jobs, and what a failed test leaves."""

from __future__ import annotations

import dataclasses
import json
import os
from collections.abc import Mapping
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from click.testing import CliRunner
from test_report import APP, DEPENDENCIES

from fakes import archives
from fakes.http_registry import StandIn
from rosml.base.errors import RosmlError
from rosml.cli.containerize import ci as command
from rosml.containerize import inputs as app_inputs
from rosml.containerize.base_image import base as app_base
from rosml.containerize.build import app as build
from rosml.containerize.build.outcome import Outcome
from rosml.containerize.build.result import Image, Result
from rosml.containerize.ci import inputs as ci_inputs
from rosml.containerize.ci import job as ci_job
from rosml.machine import buildx
from rosml.machine.services import Services
from rosml.registry import oci, references
from rosml.registry.client import Registries, Registry

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
    assert ci_inputs.given_inputs(environment) == {"target": "dev", "platform": "arm64", "registry": "registry.example.org"}


def test_a_flag_that_only_ci_has_is_true_or_false() -> None:
    assert [ci_inputs.flag("x", told) for told in ({}, {"x": "True"}, {"x": "false"})] == [False, True, False]
    with pytest.raises(RosmlError, match="x is true or false, not 'yes'"):
        ci_inputs.flag("x", {"x": "yes"})


def test_the_password_reaches_docker_on_no_command_line(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    docker = tmp_path / "docker"
    docker.write_text(f'#!/bin/sh\n{{ echo "$*"; cat; }} >{tmp_path}/told\n[ "$3" = me ]\n')
    docker.chmod(0o755)
    monkeypatch.setenv("PATH", str(tmp_path), prepend=os.pathsep)
    environment = {"DEFAULT_REGISTRY": "registry.example.org", "REGISTRY_PASSWORD": "p$ss '", "REGISTRY_USER": "me"}
    assert CliRunner().invoke(command.main, ["login"], env=environment).exit_code == 0
    told = (tmp_path / "told").read_text()
    assert told == "login --username me --password-stdin registry.example.org\np$ss '"
    done = CliRunner().invoke(command.main, ["login"], env={**environment, "REGISTRY_USER": "you"})
    assert str(done.exception) == "registry.example.org refuses you"


# ---- Tags ------------------------------------------------------------------------------------------------------------

TAG = {"GITHUB_REF": "refs/tags/v1.2", "GITHUB_REF_NAME": "v1.2", "GITHUB_REF_TYPE": "tag"}
BRANCH = {"GITHUB_REF": "refs/heads/feat/Lidar_2", "GITHUB_REF_NAME": "feat/Lidar_2"}
PULL = {"GITHUB_REF": "refs/pull/7/merge", "GITHUB_REF_NAME": "7/merge", "GITHUB_HEAD_REF": "feat/Lidar_2"}
NIGHT = {"GITHUB_EVENT_NAME": "schedule", "DEFAULT_BRANCH": ""}
LATEST = {"enable-push-as-latest": "true"}
JAZZY = {"image-tag": "jazzy"}
OTHER = {"CI_COMMIT_REF_NAME": "feat/x", "CI_COMMIT_BRANCH": "feat/x"}
REQUEST = {"CI_COMMIT_REF_NAME": "feat/x", "CI_COMMIT_BRANCH": ""}
RELEASE = {"CI_COMMIT_REF_NAME": "v1", "CI_COMMIT_BRANCH": "", "CI_COMMIT_TAG": "release/v1"}


@pytest.mark.parametrize(
    ("forge", "changes", "given", "run", "dev"),
    [
        (GITHUB, {}, {}, ["latest"], ["latest-dev"]),
        (GITHUB, {}, {**JAZZY, **LATEST}, ["jazzy", "latest"], ["jazzy-dev", "latest-dev"]),
        (GITHUB, {}, {"dev-image-tag": "work"}, ["latest"], ["work"]),
        (GITHUB, NIGHT, {}, ["latest"], ["latest-dev"]),
        (GITHUB, BRANCH, LATEST, ["latest_feat-lidar-2_ci"], ["latest-dev_feat-lidar-2_ci"]),
        (GITHUB, PULL, {}, ["latest_feat-lidar-2_ci"], ["latest-dev_feat-lidar-2_ci"]),
        # Of an event pull_request_target, whose ref is the default branch.
        (GITHUB, {"GITHUB_HEAD_REF": "main"}, {}, ["latest_main_ci"], ["latest-dev_main_ci"]),
        (GITHUB, TAG, {}, ["v1.2", "latest-v1.2"], ["v1.2-dev", "latest-dev-v1.2"]),
        (GITHUB, TAG, JAZZY, ["jazzy-v1.2"], ["jazzy-dev-v1.2"]),
        (GITHUB, TAG, {**JAZZY, **LATEST}, ["v1.2", "jazzy-v1.2"], ["v1.2-dev", "jazzy-dev-v1.2"]),
        (GITLAB, {}, {}, ["latest"], ["latest-dev"]),
        (GITLAB, OTHER, {}, ["latest_feat-x_ci"], ["latest-dev_feat-x_ci"]),
        (GITLAB, REQUEST, {}, ["latest_feat-x_ci"], ["latest-dev_feat-x_ci"]),
        (GITLAB, RELEASE, {}, ["release-v1", "latest-release-v1"], ["release-v1-dev", "latest-dev-release-v1"]),
    ],
)
def test_only_the_default_branch_moves_the_tag_that_inputs_name(
    forge: Mapping[str, str],
    changes: Mapping[str, str],
    given: Mapping[str, str],
    run: list[str],
    dev: list[str],
    tmp_path: Path,
) -> None:
    what, values = ci_job.commit({**forge, **changes}), app_inputs.values(given, tmp_path, {})
    assert [ci_job.tags(target, values, what) for target in ("run", "dev")] == [run, dev]


def test_elsewhere_is_no_job() -> None:
    with pytest.raises(RosmlError, match="no job of GitHub or GitLab") as caught:
        ci_job.commit({"CI": "true"})
    assert caught.value.exit_code == 2


# ---- Images ----------------------------------------------------------------------------------------------------------


@pytest.fixture
def services(stand_in: StandIn, tmp_path: Path) -> Services:
    return Services(tmp_path / "state", stand_in.address, ("buildx",), "rosml", "user", None, "", "", bases=())


class App:
    """In the place of a build: pushes an image for each target, and leaves the reports that it is given."""

    failed = ""


def new_call(_: object, values: app_inputs.Values, __: object, services: Services, ___: object) -> SimpleNamespace:
    return SimpleNamespace(values=values, services=services, reports=services.state / "report")


def build_images(call: Any) -> Result:
    values = call.values
    platforms = values.platform.split(",")
    for platform in platforms:
        folder = call.reports if len(platforms) == 1 else call.reports / platform.replace("/", "_")
        (folder / "results/robot").mkdir(parents=True)
        (folder / "results/robot/a.xml").write_text(SUITE)
    if App.failed:
        raise RosmlError(App.failed, "correct them")
    images = []
    for target in values.target.split(","):
        before = "" if target == "run" else f"{target}-"
        tag, name = values.named(f"{before}image-tag"), values.named(f"{before}image-name")
        digest = put(call.services, f"{name or values.image_name}:{tag}")
        images.append(Image(target, f"{name}:{tag}", digest))
    return Result("base", images, Outcome())


SUITE = """<testsuite><testcase name="good" classname="a"/>
<testcase name="bad" classname="a"><failure message="1% is not 2"/></testcase></testsuite>"""


def put(services: Services, reference: str) -> str:
    """An image that is not there a second time; gives its digest."""
    place = references.parse(reference)
    with Registry(services.registry) as client:
        blob = oci.encoded({"os": "linux", "of": reference})
        client.put_blob(place.repository, blob)
        manifest = {
            "schemaVersion": 2,
            "mediaType": oci.IMAGE,
            "config": oci.descriptor(oci.CONFIG, blob),
            "layers": [],
        }
        return client.put_manifest(place.repository, place.reference, oci.encoded(manifest))


def job(services: Services, tmp_path: Path, *, what: ci_job.Commit = MAIN, **given: str) -> ci_job.Job:
    values = {"image-name": f"{services.registry}/Me/Robot", "target": "run", "push": "true"}
    values |= {name.replace("_", "-"): value for name, value in given.items()}
    return ci_job.Job(app_inputs.values(values, tmp_path, {}), {}, what, lambda line: None)


def left(call: ci_job.Job, services: Services, tmp_path: Path) -> Path:
    """What a job leaves for the one that makes the index, as its artifact is called."""
    out = tmp_path / "made" / call.name
    call.build(tmp_path, services, out, True)
    return out


@pytest.fixture(autouse=True)
def app(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(ci_job, "new_call", new_call)
    monkeypatch.setattr(ci_job, "build_images", build_images)


def tags(services: Services, stand_in: StandIn) -> dict[str, str]:
    return dict(stand_in.tags["me/robot"])


def test_all_tags_of_a_commit_are_one_image(stand_in: StandIn, services: Services, tmp_path: Path) -> None:
    what = ci_job.Commit("v1", "v1", False, Path())
    made = job(services, tmp_path, what=what, target="run,dev", platform="amd64").build(
        tmp_path, services, tmp_path / "out", False
    )
    found = tags(services, stand_in)
    assert found.keys() == {"v1", "latest-v1", "v1-dev", "latest-dev-v1"}
    assert found["v1"] == found["latest-v1"] != found["v1-dev"]
    assert [image.reference for image in made] == [f"{services.registry}/me/robot:{tag}" for tag in ("v1", "v1-dev")]
    assert ci_job.outputs(made) == {
        "image": f"{services.registry}/me/robot:v1",
        "digest": found["v1"],
        "dev-image": f"{services.registry}/me/robot:v1-dev",
        "dev-digest": found["v1-dev"],
    }


def test_an_index_has_every_platform_and_gets_all_tags(stand_in: StandIn, services: Services, tmp_path: Path) -> None:
    """Of what jobs left, that of a call with another tag is passed over."""
    given: dict[str, Any] = {"image_tag": "v1", "enable_push_as_latest": "true"}
    left(job(services, tmp_path, platform="amd64", image_tag="v2"), services, tmp_path)
    for platform in ("amd64", "arm64"):
        left(job(services, tmp_path, platform=platform, **given), services, tmp_path)
    with Registries() as registries:
        [made] = job(services, tmp_path, platform="amd64,arm64", **given).index(tmp_path / "made", registries)
    found = tags(services, stand_in)
    assert found["v1"] == found["latest"] == made.digest
    index = json.loads(stand_in.manifests["me/robot", made.digest][1])
    there = {entry["platform"]["architecture"]: entry["digest"] for entry in index["manifests"]}
    assert there == {"amd64": found["v1-amd64"], "arm64": found["v1-arm64"]}


@pytest.mark.parametrize("place", ["reports/zz", "reports-amd64/linux_amd64/robot", "zz"])
def test_no_other_file_says_what_a_job_made(place: str, stand_in: StandIn, services: Services, tmp_path: Path) -> None:
    """Such as one that a test wrote, or that a repository has where GitLab keeps artifacts."""
    outs = [left(job(services, tmp_path, platform=name), services, tmp_path) for name in ("amd64", "arm64")]
    other = json.loads((outs[0] / ci_job.FILE).read_text())
    other[0]["digest"] = put(services, f"{services.registry}/me/robot:evil")
    for folder in (outs[0], tmp_path / "made"):
        (folder / place).mkdir(parents=True, exist_ok=True)
        (folder / place / ci_job.FILE).write_text(json.dumps(other))
    with Registries() as registries:
        [made] = job(services, tmp_path, platform="amd64,arm64").index(tmp_path / "made", registries)
    index = json.loads(stand_in.manifests["me/robot", made.digest][1])
    assert other[0]["digest"] not in {entry["digest"] for entry in index["manifests"]}


@pytest.mark.parametrize(
    "content", ["{}", "[[]]", "[" * 99_999, '[{"target": "run"}]', "\xff", None], ids=lambda text: str(text)[:20]
)
def test_a_damaged_file_of_a_job_is_said(content: str | None, services: Services, tmp_path: Path) -> None:
    file = left(job(services, tmp_path, platform="amd64"), services, tmp_path) / ci_job.FILE
    file.unlink()
    if content is None:
        file.symlink_to("/proc/self/environ")
    else:
        file.write_text(content)
    with Registries() as registries, pytest.raises(RosmlError, match=r"images\.json.*(damaged|link)") as caught:
        job(services, tmp_path, platform="amd64").index(tmp_path / "made", registries)
    assert caught.value.remedy


def test_a_slim_image_has_tags_and_an_index_as_others(stand_in: StandIn, services: Services, tmp_path: Path) -> None:
    """Where there is one."""
    for platform in ("amd64", "arm64"):
        left(job(services, tmp_path, platform=platform, target="run,slim"), services, tmp_path)
    with Registries() as registries:
        made = job(services, tmp_path, platform="amd64,arm64").index(tmp_path / "made", registries)
    assert [image.target for image in made] == ["run", "slim"]
    assert ci_job.outputs(made)["slim-image"] == f"{services.registry}/me/robot:latest-slim"
    assert {"latest", "latest-slim"} <= tags(services, stand_in).keys()


def test_a_build_takes_what_ci_makes_of_the_inputs(
    services: Services, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    seen: dict[str, list[str]] = {}

    def run(_: Services, bake: buildx.Bake) -> tuple[None, dict[str, str]]:
        targets = json.loads(bake.file.read_text())["target"]
        seen[bake.target] = targets.get(bake.target, {}).get("tags", [])
        if bake.target == "packages":
            app = {**APP, "architecture": "arm64", "apt": {"tree": "2.1"}}
            said = {"dependencies.json": json.dumps(DEPENDENCIES), "app.json": json.dumps(app)}
            for name, left in (("report", said), ("results", {"results/robot/a.xml": "<testsuite/>"})):
                archives.write(Path(targets[name]["output"][0].partition("dest=")[2]), left)
        return None, {"containerimage.digest": "sha256:1"}

    def run_all(services: Services, bake: buildx.Bake) -> tuple[None, dict[str, dict[str, str]]]:
        one = {target: dataclasses.replace(bake, target=target) for target in (bake.target, *bake.beside)}
        return None, {target: run(services, call)[1] for target, call in one.items()}

    monkeypatch.setattr(buildx, "run_all", run_all)
    monkeypatch.setattr(ci_job, "new_call", build.new_call)
    monkeypatch.setattr(ci_job, "build_images", build.build_images)
    facts = app_base.Base("ros:jazzy", f"sha256:{'0' * 64}", {"ROS_DISTRO": "jazzy"})
    monkeypatch.setattr(app_base, "find", lambda *_: facts)
    (tmp_path / "robot").mkdir()
    (tmp_path / "robot/package.xml").write_text("<package><name>robot</name></package>")
    given = {"base_image": "ros:jazzy", "command": "true", "target": "run,dev", "platform": "arm64", "push": "false"}
    what = ci_job.Commit("x", "", False, Path())
    made = job(services, tmp_path, what=what, **given).build(tmp_path / "robot", services, tmp_path / "out", True)
    name = f"{services.registry}/me/robot"
    assert seen["run"] == [f"{name}:latest_x_ci-arm64"] == [made[0].reference]
    assert seen["dev"] == [f"{name}:latest-dev_x_ci-arm64"] == [made[1].reference]
    kept = json.loads((tmp_path / "out/containerize-arm64.lock").read_text())
    assert kept["apt"] == {"arm64": {"tree": "2.1"}}, "whoever wants to build it again has what it was built from"


def test_a_name_without_a_registry_is_docker_hubs(services: Services, tmp_path: Path) -> None:
    made = job(services, tmp_path, image_name="Me/Robot", push="false").build(
        tmp_path, services, tmp_path / "out", False
    )
    assert made[0].reference == "docker.io/me/robot:latest"


def test_no_tag_moves_where_a_platform_is_missing(stand_in: StandIn, services: Services, tmp_path: Path) -> None:
    left(job(services, tmp_path, platform="amd64"), services, tmp_path)
    with Registries() as registries, pytest.raises(RosmlError, match="for linux/arm64; no tag was moved"):
        job(services, tmp_path, platform="amd64,arm64").index(tmp_path / "made", registries)
    assert tags(services, stand_in).keys() == {"latest-amd64"}


def test_what_is_not_pushed_gets_no_index(stand_in: StandIn, services: Services, tmp_path: Path) -> None:
    left(job(services, tmp_path, platform="amd64"), services, tmp_path)
    with Registries() as registries:
        assert job(services, tmp_path, platform="amd64", push="false").index(tmp_path / "made", registries) == []
    assert tags(services, stand_in).keys() == {"latest-amd64"}


@pytest.mark.parametrize("named", ["", "small:1"])
def test_a_slim_image_that_one_platform_lacks(
    named: str, stand_in: StandIn, services: Services, tmp_path: Path
) -> None:
    """Its own base image has none without compilers there. Where somebody named the base image, a job has failed."""
    left(job(services, tmp_path, platform="amd64", target="run,slim"), services, tmp_path)
    left(job(services, tmp_path, platform="arm64", target="run"), services, tmp_path)
    last = job(services, tmp_path, platform="amd64,arm64", slim_base_image=named)
    with Registries() as registries:
        if named:
            with pytest.raises(RosmlError, match=r"there is no slim image .* for linux/arm64; no tag was moved"):
                last.index(tmp_path / "made", registries)
        else:
            assert [image.target for image in last.index(tmp_path / "made", registries)] == ["run"]
    assert ("latest" in tags(services, stand_in)) is (not named)


# ---- Tests -----------------------------------------------------------------------------------------------------------


def test_a_failed_test_is_told_and_its_reports_are_kept(
    services: Services, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(App, "failed", "1 of 2 tests failed; no image was made")
    monkeypatch.setattr(Services, "of_docker", lambda folder: services)
    monkeypatch.setattr(Services, "require_builder", lambda self: None)
    page, outputs = tmp_path / "page.md", tmp_path / "outputs"
    environment: dict[str, Any] = {**GITHUB, "GITHUB_WORKSPACE": str(tmp_path), "GITHUB_STEP_SUMMARY": str(page)}
    environment |= {"GITHUB_OUTPUT": str(outputs), "IMAGE_NAME": "ghcr.io/Me/Robot", "PLATFORM": "amd64,arm64"}
    done = CliRunner().invoke(command.main, ["build", "--out", str(tmp_path / "out")], env=environment)
    assert isinstance(done.exception, RosmlError)
    assert done.stdout.splitlines() == ["::error title=Test failed::robot: a.bad: 1%25 is not 2"] * 2
    assert "4 tests, 2 failed, 0 skipped" in page.read_text()
    told = dict(line.split("=", 1) for line in outputs.read_text().splitlines())
    assert told["artifact"] == "containerize-ghcr.io-me-robot-latest-linux-amd64-linux-arm64"
    files = sorted(str(path.relative_to(told["folder"])) for path in Path(told["folder"]).rglob("*.xml"))
    assert files == [f"reports/linux_{name}/robot/a.xml" for name in ("amd64", "arm64")]
    monkeypatch.setattr(Services, "of_docker", refuse)
    done = CliRunner().invoke(command.main, ["build", "--out", str(tmp_path / "other")], env=environment)
    assert done.stdout.splitlines() == ["::error title=rosml containerize::docker buildx does not answer"]


def refuse(folder: Path) -> Services:
    raise RosmlError("docker buildx does not answer", "install Docker")


def test_no_tag_of_ci_loses_a_platform(stand_in: StandIn, services: Services, tmp_path: Path) -> None:
    """Of a job, nor of the index of several: all are looked at before the first one moves."""
    given: dict[str, Any] = {"image_tag": "v1", "enable_push_as_latest": "true"}
    for platform in ("amd64", "arm64"):
        left(job(services, tmp_path, platform=platform, **given), services, tmp_path)
    with Registries() as registries:
        job(services, tmp_path, platform="amd64,arm64", **given).index(tmp_path / "made", registries)
        before = tags(services, stand_in)
        for image_tag in ("v1", "v2"):
            given["image_tag"] = image_tag
            one = job(services, tmp_path, platform="amd64", **given)
            with pytest.raises(RosmlError, match="is for linux/amd64, linux/arm64, and would be for linux/amd64 alone"):
                one.build(tmp_path, services, tmp_path / "out", False)
        assert tags(services, stand_in) == before
        left(job(services, tmp_path, platform="amd64", **given), services, tmp_path)
        with pytest.raises(RosmlError, match=":latest is for linux/amd64, linux/arm64, and would be"):
            job(services, tmp_path, platform="amd64", **given).index(tmp_path / "made", registries)
    assert all(tags(services, stand_in)[name] == before[name] for name in ("v1", "latest"))
