"""An app's build: what the builder gets, what is said of sources, and what a lock file and a cache decide."""

from __future__ import annotations

import json
import re
import shutil
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from fakes.apps import NATIVE, Robot, robot, services
from rosml.base.errors import RosmlError
from rosml.containerize import lock
from rosml.containerize.base_image import rosdep_index
from rosml.containerize.build import attachments, bake_file, dev_folder, stage_cache, step_order
from rosml.containerize.build.result import ShellImage
from rosml.containerize.names import DESK
from rosml.images.builds import variables
from rosml.images.builds.contents import FACTS, FILES, PACKAGES
from rosml.images.image_set.labels import BASE_DIGEST, COMPRESSED, LOCK
from rosml.images.scan import packages as packages_of_build
from rosml.machine import git

__all__ = ["robot", "services"]


# ---- What the builder gets -------------------------------------------------------------------------------------------


def test_images_are_joined_after_the_report_is_read(robot: Robot) -> None:
    digest = robot.put()
    command = 'ros2 run robot "a $b" \\\n${HOME} %{x}'
    result = robot.build(command=command, rmw_implementation="rmw_zenoh_cpp")
    local = robot.services.registry
    assert [image.reference for image in result.images] == [f"{local}/robot:latest", f"{local}/robot:latest-dev"]
    report, run, dev = robot.targets
    assert report["contexts"]["base"] == f"docker-image://{local}/rosml/ros@{digest}"
    assert report["args"]["ROS_DISTRO"] == "jazzy"
    assert (run["name"], dev["name"]) == ("run", "dev")
    assert run["contexts"].keys() == {"base", "app"}, "the builder makes all contexts, also those that no line names"
    assert dev["contexts"].keys() == {"base", "workspace"}
    lines = run["dockerfile-inline"].splitlines()
    assert lines[1:3] == ["FROM base", "COPY --link --from=app / /"]
    assert not [line for line in lines if line.startswith("RUN")]
    assert "ENV DEFAULT_CMD=$${APP_DEFAULT_CMD}" in lines, "bake makes one $ of it"
    assert lines[0] == "ARG APP_TARGETARCH=$${TARGETARCH}" and "ENV TARGETARCH=$${APP_TARGETARCH}" in lines
    assert run["args"]["APP_DEFAULT_CMD"] == command.replace("${", "$${").replace("%{", "%%{")
    assert run["args"]["APP_RMW_IMPLEMENTATION"] == "rmw_zenoh_cpp"
    assert run["labels"][BASE_DIGEST] == digest
    assert dev["dockerfile-inline"].splitlines()[1] == "FROM workspace"


def test_each_image_gets_an_sbom_and_those_to_run_lists_of_files(robot: Robot, monkeypatch: pytest.MonkeyPatch) -> None:
    system = {"name": "debian", "version": "12"}
    packages = {"system": system, "apt": [], "python": [], "ros": [{"name": "robot", "version": "1", "licenses": []}]}
    robot.contents = {
        "contents-run/packages.json": json.dumps(packages),
        "contents-slim/packages.json": json.dumps(packages),
        "contents-dev/packages.json": json.dumps(packages | {"ros": []}),
    }
    robot.put("rosml/ros:small")
    calls = list[tuple[list[str], bool]]()

    def attach(_registry: object, _repository: str, _digest: str, load: Any, _origins: object, kinds: Any) -> None:
        [ros] = packages_of_build.read(load(NATIVE, PACKAGES)).ros
        calls.append(([*kinds], ros.is_source))

    monkeypatch.setattr(attachments, "attach", attach)
    robot.slim_app["replaced"] = ["libfoo:all"]
    robot.build(enable_slim="true", slim_base_image="ros:small")
    assert calls == [([PACKAGES, FILES, FACTS], False), ([PACKAGES], True), ([PACKAGES, FILES], False)]


def test_each_step_has_a_heading_with_the_time_of_the_one_before(robot: Robot, monkeypatch: pytest.MonkeyPatch) -> None:
    robot.put()
    clock = iter(range(0, 1000, 7))
    monkeypatch.setattr("rosml.containerize.build.call.monotonic", lambda: next(clock))

    def headings() -> list[str]:
        lines = [re.sub(r"\d+\.0 s", "N s", line) for line in robot.messages if line.startswith("step ")]
        robot.messages.clear()
        return lines

    robot.build()
    assert robot.messages[:2] == [
        "step 1 of 3: find the base image, fetch sources",
        robot.messages_with("base image")[1],
    ]
    assert headings()[1:] == [
        "step 2 of 3: build and test the packages (step 1 took N s)",
        "step 3 of 3: join the images (step 2 took N s)",
    ]
    robot.build(tests="false")
    assert headings()[1].startswith("step 2 of 3: build the packages (")
    step_order.build_shell_image(robot.call())
    assert headings()[1].startswith("step 2 of 2: install what the packages need (")


def test_json_has_the_fields_of_the_result_and_of_its_outcome(robot: Robot) -> None:
    fields = json.loads(json.dumps(robot.build().to_json()))
    image = {"target": "run", "reference": f"{robot.services.registry}/robot:latest", "digest": "sha256:1"}
    assert fields["images"][0] == image
    assert {"tests", "slim_tests", "downstream_tests", "reports", "locked", "described", "waited"} <= fields.keys()
    assert fields["tests"] == {"count": 0, "skipped": 0, "failures": []}
    assert (fields["packages"], fields["installed"], fields["lock"]["format"]) == (["robot"], ["libfoo:all"], 1)


def test_the_image_for_rosml_dev_is_the_same_for_each_commit(robot: Robot, monkeypatch: pytest.MonkeyPatch) -> None:
    """It is no reason to leave a container that runs. The packages are neither built nor tested for it."""
    values = replace(robot.values(), image_name="ghcr.io/me/robot", push=True)
    for commit in ("a", "b"):
        monkeypatch.setattr(git, "commit", lambda *_, commit=commit: git.Commit(commit, ord(commit)))
        call = step_order.new_call(
            robot.folder, dev_folder.image_values(values, robot.folder), {}, robot.services, print
        )
        name = f"{robot.services.registry}/{dev_folder.image_name(robot.folder)}"
        assert step_order.build_shell_image(call) == ShellImage(f"{name}@sha256:1", False, None)
    first, second = robot.targets
    assert first == second and first["name"] == DESK and first["dockerfile-inline"].splitlines()[1] == f"FROM {DESK}"
    assert "APP_DEFAULT_CMD" not in first["args"]


def test_the_number_of_compilers_is_no_part_of_what_a_step_is_made_from(robot: Robot) -> None:
    """Who lowers it after a failure goes on from there."""
    for jobs in ("", "3"):
        robot.build(target="run", parallel_jobs=jobs)
    plain, limited = robot.targets[0], robot.targets[2]
    secret = "type=env,id=parallel-jobs,env=PARALLEL_JOBS"
    assert secret in limited["secret"] and secret not in plain["secret"]
    assert limited["variables"] == {"PARALLEL_JOBS": "3"}
    assert {**limited, "secret": [], "variables": {}} == {**plain, "secret": [], "variables": {}}


def test_scripts_that_run_code_of_packages_are_those_of_the_build() -> None:
    """Their output is not searched for reasons of ours."""
    dockerfile = (bake_file.SCRIPTS / "containerize/Dockerfile").read_text()
    called = set(re.findall(r"/run/(scripts/containerize/\w+\.sh)(?= \w+$| /tests)", dockerfile, re.M))
    texts = {name: (bake_file.SCRIPTS / name.removeprefix("scripts/")).read_text() for name in called}
    runs = {name for name, text in texts.items() if re.search(r"^ *colcon (build|test)\b", text, re.M)}
    assert runs == set(bake_file.FOREIGN)


def test_a_run_image_starts_from_its_packages_if_they_replace_some_of_the_base(robot: Robot) -> None:
    robot.put(config={"User": "robot:1000"})
    robot.app["replaced"] = ["libbar:amd64"]
    result = robot.build()
    lines = robot.targets[1]["dockerfile-inline"].splitlines()
    assert lines[1:4] == ["FROM runtime", "COPY --link --from=app / /", "USER robot:1000"], "as the base image starts"
    assert robot.targets[1]["contexts"].keys() == {"base", "runtime", "app"}
    assert "libbar:amd64" in dict(result.summary())[""]


OURS = {"io.rosml.distribution": "jazzy", "io.rosml.runtime": "base-run"}


def test_a_slim_image_starts_from_the_base_image_without_compilers(robot: Robot) -> None:
    robot.put(config={"Labels": OURS})
    labels = {"io.rosml.distribution": "jazzy", "io.rosml.component": "base-run"}
    digest = robot.put("rosml/ros:jazzy-base-run", config={"Labels": labels})
    local = robot.services.registry
    result = robot.build(target="run", enable_slim="true")
    assert [image.reference for image in result.images] == [f"{local}/robot:{tag}" for tag in ("latest", "latest-slim")]
    slim = robot.targets[-1]
    assert slim["contexts"]["slim"] == f"docker-image://{local}/rosml/ros@{digest}"
    assert slim["dockerfile-inline"].splitlines()[1:3] == ["FROM slim", "COPY --link --from=slim-app / /"]
    assert slim["args"]["APP_DEFAULT_CMD"] == "true" and slim["labels"][BASE_DIGEST] == digest
    assert robot.targets[0]["target"] == "slim-report"

    robot.slim_app["removed"] = ["usr/bin/less"]
    result = robot.build(target="run", enable_slim="true", slim_image_name="small", slim_image_tag="1")
    run, slim = robot.targets[-2:]
    assert [target["dockerfile-inline"].splitlines()[1] for target in (run, slim)] == ["FROM base", "FROM slim-runtime"]
    assert slim["tags"] == [f"{local}/small:1"]
    assert (
        "the slim one, and rosml rebase cannot move it: its packages change 1 thing: usr/bin/less"
        in dict(result.summary())[""]
    )


def test_no_slim_image_is_made_if_no_base_image_is_found(robot: Robot) -> None:
    """It is said. If somebody names one, it is an error."""
    local = robot.services.registry
    robot.put(config={"Labels": OURS})
    robot.put("plain:1")
    for name, why in (("ros:jazzy", "there is no"), (f"{local}/plain:1", f"{local}/plain:1 does not say")):
        robot.build(base_image=name, target="run", enable_slim="true")
        assert robot.names[-1] == "run" and robot.messages_with(f"no slim image: {why}")
    with pytest.raises(RosmlError, match="there is no image typo"):
        robot.build(enable_slim="true", slim_base_image="typo")


def test_ros_is_installed_on_a_base_that_has_none(robot: Robot, monkeypatch: pytest.MonkeyPatch) -> None:
    """By the steps of our own images, on it by its digest, and kept as a stage of its own. An image is looked at once."""
    starts = {"WorkingDir": "/opt/sdk", "Entrypoint": ["./start.sh"], "Env": ["LANG=de", "CUDA_VERSION=13.0.1"]}
    digest = robot.put("rosml/plain:1", config=starts)
    monkeypatch.setattr(variables, "sync_date", lambda *_: "2026-11-20T21:14:09Z")
    inputs = {"base_image": "plain:1", "cache": robot.cache}
    for _ in range(2):
        robot.build(**inputs)
    assert robot.messages_with("its entrypoint runs before each command: /opt/sdk/start.sh")
    assert robot.names.count("system") == 1
    targets = robot.bake_file["target"]
    assert targets["report"]["contexts"]["base"] == targets["run"]["contexts"]["base"] == "target:base"
    names = [name := "base"]
    while name := targets[name]["contexts"][next(iter(targets[name]["contexts"]))].partition("target:")[2]:
        names.append(name)
    assert names == ["base", "base-jazzy-core", "base-os-ubuntu-24-04", "base-system"]
    reference = f"docker-image://{robot.services.registry}/rosml/plain@{digest}"
    assert targets["base-system"]["contexts"] == {"os": reference}
    assert targets["base-jazzy-core"]["args"]["ROS_SYNC_DATE"] == "2026-11-20T21:14:09Z"
    assert targets["base"]["args"] == {"KEPT_LANG": "de"}
    entrypoint = 'ENTRYPOINT ["/tini", "--", "/entrypoint.sh", "/opt/sdk/start.sh"]'
    assert entrypoint in targets["base"]["dockerfile-inline"].splitlines()
    assert targets["base"]["labels"]["io.rosml.own"] == "CUDA_VERSION"
    assert targets["base"]["labels"]["io.rosml.distribution"] == "jazzy"
    monkeypatch.setattr(variables, "sync_date", lambda *_: "2026-11-27T21:14:09Z")
    robot.build(**inputs)
    kept = [content["target"]["keep-base"]["output"] for content in ({"target": targets}, robot.bake_file)]
    assert kept[0] != kept[1], "ROS has other packages"
    robot.renew(**inputs)
    assert "it has no versions of the ROS that was installed" in robot.messages[-1]


@pytest.mark.parametrize(("distribution", "count"), [("foxy", 1), ("jazzy", 0), ("nowhere", 0)])
def test_a_base_image_past_its_end_of_life_is_named(distribution: str, count: int, robot: Robot) -> None:
    robot.put(config={"Env": ["ROS_DISTRO=foxy"], "Labels": {"io.rosml.distribution": distribution}})
    robot.build()
    lines = robot.messages_with("had its end of life on")
    assert len(lines) == count and all(line.startswith("foxy had") and "take lyrical" in line for line in lines)


def test_a_base_without_ros_stays_without_if_somebody_says_so(robot: Robot) -> None:
    robot.put("rosml/plain:1", config={"Env": []})
    inputs = {"base_image": "plain:1", "disable_ros_installation": "true"}
    with pytest.raises(RosmlError, match="does not say which ROS it has") as caught:
        robot.build(**inputs)
    assert "--ros-distro" in caught.value.remedy
    robot.build(**inputs, ros_distro="jazzy")
    assert robot.targets[-1]["args"]["APP_ROS_DISTRO"] == "jazzy" and robot.names[0] == "packages"


def test_layers_are_compressed_as_those_of_the_base_image(robot: Robot) -> None:
    """If that is for an older Docker, the app is as well."""
    for labels, option in (({}, "compression=zstd"), ({COMPRESSED: "gzip"}, "compression=gzip,force-compression=true")):
        robot.put(config={"Labels": {"io.rosml.distribution": "jazzy", **labels}})
        robot.build(target="run")
        assert option in robot.targets[-1]["output"][0]


# ---- What is said of the sources -------------------------------------------------------------------------------------


def test_a_name_to_leave_out_that_no_package_has_is_a_warning(robot: Robot) -> None:
    robot.write("docker/blacklisted-packages.txt", "robott # once\nrobot\nof_another_time\n")
    robot.build()
    first, second = robot.messages_with("which is to be left out")
    assert "called robott" in first and "did you mean 'robot'?" in first and "of_another_time" in second
    robot.messages.clear()
    robot.write("docker/blacklisted-packages.txt", "".join(f"a{number}\n" for number in range(1000)))
    robot.build()
    assert len(robot.messages_with("left out")) < 30
    robot.messages.clear()
    robot.write("docker/before_dependency_identification.sh", "true\n")
    robot.build()
    assert not robot.messages_with("left out"), "a script may make such a package"


def test_what_git_clone_alone_leaves_is_named(robot: Robot) -> None:
    """Submodules are empty, and without git-lfs a mesh is a line of text."""
    (robot.folder / "src/empty").mkdir()
    for name in ("arm.dae", "leg.dae"):
        robot.write(name, "version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 12345\n")
    robot.build()
    assert not robot.messages_with("Git LFS"), "a test of something that reads pointers, perhaps"
    names = ("src/robot", "src/empty", "src/gone away")
    sections = "".join(f'[submodule "{name}"]\n\tpath = {name}\n' for name in names)
    robot.write(".gitmodules", f"{sections}\turl = ../x\n")
    robot.write(".gitattributes", "*.dae filter=lfs diff=lfs merge=lfs -text\n")
    robot.build()
    lines = robot.messages_with("is not there: git submodule update --init --recursive")
    assert [line.partition(" is not")[0] for line in lines] == [f"the submodule {name}" for name in names[1:]]
    [line] = robot.messages_with("Git LFS")
    assert line.startswith("arm.dae and 1 file more") and "git lfs pull" in line


def test_a_list_for_pip_that_no_input_names_is_said(robot: Robot) -> None:
    robot.write("arm/requirements.txt", "tinydb\n")
    robot.build()
    assert robot.messages_with("--additional-pip-file arm/requirements.txt")
    robot.messages.clear()
    robot.build(additional_pip_file="arm/requirements.txt")
    assert not robot.messages_with("additional-pip-file")


@pytest.mark.parametrize(
    ("base_has", "ros_distro", "compared"),
    [("Debian", "", "noetic"), ("Debian", "melodic", "melodic"), ("jazzy", "humble", "jazzy")],
)
def test_conditions_compare_with_a_release(base_has: str, ros_distro: str, compared: str, robot: Robot) -> None:
    """No manifest compares with what Debian calls its own ROS."""
    robot.put(ROS_DISTRO=base_has)
    robot.build(ros_distro=ros_distro)
    arguments = robot.targets[0]["args"]
    assert (arguments["ROS_DISTRO"], arguments["CONDITIONS"]) == (base_has, compared)
    assert bool(robot.messages_with("ROS_DISTRO=humble is not used")) is (base_has == "jazzy")


# ---- Lock files and caches -------------------------------------------------------------------------------------------


def test_a_lock_file_is_written_then_followed(robot: Robot) -> None:
    robot.app["apt"] = {"tree": "2.1"}
    digest = robot.put()
    result = robot.renew()
    assert (Path(robot.targets[0]["contexts"]["requests"]) / "renewed").exists(), "no step of an earlier build counts"
    file = robot.folder / "containerize.lock"
    assert dict(result.summary())["lock"] == str(file)
    label = robot.targets[1]["labels"][LOCK]
    robot.put(NEWER="1")
    robot.targets.clear()
    assert robot.build().lock_file == ""
    report, run, _ = robot.targets
    requests = Path(report["contexts"]["requests"])
    assert not (requests / "renewed").exists() and (requests / "lock/amd64/apt").read_text() == "tree 2.1\n"
    assert report["contexts"]["base"].endswith(f"@{digest}") and run["labels"][LOCK] == label
    assert not (Path(report["contexts"]["target"]) / "target/containerize.lock").exists(), "it is no source"

    robot.put("small:1")
    with pytest.raises(RosmlError, match="the lock file has no slim image"):
        robot.build(enable_slim="true", slim_base_image=f"{robot.services.registry}/small:1")
    file.write_text("<<<<<<< HEAD\n")
    robot.renew()
    assert robot.messages_with("is no lock file") and lock.read(file, robot.folder), "a damaged file is written again"
    with pytest.raises(RosmlError, match="the lock file is of ros:jazzy, and not of ros:other"):
        robot.build(base_image="ros:other")


def test_a_lock_file_that_is_renewed_takes_nothing_from_a_cache(robot: Robot, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(stage_cache.Cache, "stages", lambda *_: pytest.fail("what is there may be outdated"))
    robot.renew(cache=robot.cache)


def test_a_relative_index_of_rosdep_is_one_of_the_folder(robot: Robot) -> None:
    robot.write("lists/rosdep/own.yaml", "a: {}\n")
    robot.build(rosdep_index="lists")
    assert (Path(robot.targets[0]["contexts"]["rosdep"]) / "rosdep/own.yaml").read_text() == "a: {}\n"
    (robot.folder / "lists/rosdep/secret.yaml").symlink_to("/etc/hostname")
    with pytest.raises(RosmlError, match=r"secret\.yaml leads out of"):
        robot.build(rosdep_index="lists")


def cached(robot: Robot, monkeypatch: pytest.MonkeyPatch, *stages: str) -> None:
    """A cache that has these stages, and no report."""
    present = dict.fromkeys(stages, f"{robot.cache}@sha256:{'1' * 64}")
    monkeypatch.setattr(stage_cache.Cache, "stages", lambda *_: present)


def test_a_cache_with_the_dependencies_needs_no_lists_of_rosdep(robot: Robot, monkeypatch: pytest.MonkeyPatch) -> None:
    names: list[str] = []
    monkeypatch.setattr(rosdep_index.Finder, "find", lambda _self, name, *_: names.append(name))
    cached(robot, monkeypatch)
    robot.build(cache=robot.cache)
    cached(robot, monkeypatch, "identified")
    robot.build(cache=robot.cache)
    assert names == [""]
    robot.build(cache=robot.cache, rosdep_index="rosdep:1")
    assert names == ["", "rosdep:1"], "its digest is a part of the key"


def test_a_stage_that_a_cache_has_lost_is_built_although_its_report_is_there(
    robot: Robot, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Somebody pruned the registry."""
    stages = ("identified", "environment", "runtime", "upstream-built", "workspace", "app")
    for present in ((), stages, stages[:-1]):
        cached(robot, monkeypatch, *present)
        robot.build(cache=robot.cache, tests="false")
    assert robot.names == ["packages", "run", "dev", "run", "dev", "packages", "run", "dev"]
    assert robot.messages_with("nothing to build")


def test_each_script_that_a_build_calls_decides_what_a_cache_has(robot: Robot, monkeypatch: pytest.MonkeyPatch) -> None:
    scripts = robot.folder.parent / "components"
    shutil.copytree(bake_file.SCRIPTS, scripts)
    monkeypatch.setattr(bake_file, "SCRIPTS", scripts)

    def runtime() -> str:
        robot.build(cache=robot.cache)
        return json.dumps(robot.bake_file["target"]["keep-runtime"]["output"])

    tags = {runtime()}
    dockerfile = (scripts / "containerize/Dockerfile").read_text()
    called = sorted(set(re.findall(r"from=scripts,source=([a-z_/]+\.(?:sh|py))", dockerfile)))
    for name in called:
        (scripts / name).write_text("changed")
        tags.add(runtime())
    assert len(tags) == 1 + len(called)
