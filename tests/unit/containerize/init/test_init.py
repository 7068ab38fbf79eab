"""The files that `rosml init` writes, which their readers understand, and its questions. What it proposes: test_init_choices.py."""

from __future__ import annotations

import json
import os
import re
import shlex
import subprocess
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
import yaml
from conftest import ROOT

from fakes.desks import OURS, Desk
from fakes.package_folders import (
    REGISTRY,
    TORCH,
    WITH_CI,
    called,
    chosen,
    machine,
    manifest,
    snapshot,
    terminal,
    values_of,
    write,
)
from fakes.stubs import HOSTILE
from rosml.base.errors import RosmlError
from rosml.cli.containerize import init
from rosml.containerize import inputs as app_inputs
from rosml.containerize.ignored_files import IgnoredFiles
from rosml.containerize.init import file_texts, forge
from rosml.containerize.packages import workspace
from rosml.images.builds import base_images
from rosml.machine import git
from rosml.run import defaults

__all__ = ["machine", "terminal"]


def ci_inputs(folder: Path, forge: str = "github") -> dict[str, Any]:
    document = yaml.safe_load((folder / file_texts.FORGES[forge]).read_text())
    [step] = document["jobs"]["images"]["steps"] if forge == "github" else document["include"]
    return dict(step["with" if forge == "github" else "inputs"])


# ---- What the repository says already --------------------------------------------------------------------------------


LOCKED = {"name": "ghcr.io/me/rosml/ros-torch:latest", "digest": f"sha256:{'1' * 64}"}


@pytest.mark.parametrize("words", [REGISTRY, [*REGISTRY, "--distribution", "jazzy"]])
def test_the_base_image_of_a_lock_file_stays(tmp_path: Path, words: list[str]) -> None:
    """Spelled as there: another name of the same image would not fit the lock file."""
    write(tmp_path, {"containerize.lock": json.dumps({"base_image": LOCKED})})
    done = called(tmp_path, "--yes", *words)
    assert values_of(tmp_path).base_image == LOCKED["name"] and "the lock file is of it" in done.stdout
    assert f"\nARG BASE_IMAGE={LOCKED['name']}\n" in (tmp_path / "Dockerfile").read_text()
    assert "lock file" not in done.stderr


@pytest.mark.parametrize(
    ("locked", "words", "base_image"),
    [
        (
            "ghcr.io/me/rosml/ros-torch:latest",
            ["--distribution", "humble", *REGISTRY],
            "ghcr.io/me/rosml/ros:humble-base",
        ),
        ("evil.example/x/ros:humble-base", [], "ros:humble-base"),
        ("ubuntu:24.04", REGISTRY, "ghcr.io/me/rosml/ros:jazzy-base"),
    ],
)
def test_another_base_image_than_that_of_the_lock_file_is_said(
    tmp_path: Path, locked: str, words: list[str], base_image: str
) -> None:
    """Nobody has confirmed that a registry is trusted that the repository names."""
    write(tmp_path, {"containerize.lock": json.dumps({"base_image": {**LOCKED, "name": locked}})})
    errors = called(tmp_path, "--yes", *words).stderr
    assert values_of(tmp_path).base_image == base_image
    assert f"the lock file is of the base image {locked}, and not of {base_image}\n" in errors


def test_lists_of_docker_ros_are_read(tmp_path: Path) -> None:
    lists = {"docker/additional-debs.txt": "htop # a comment\n", "docker/additional-pip-requirements.txt": "torch\n"}
    write(tmp_path / "a", {**lists, "requirements.txt": "einops\n"})
    done = called(tmp_path / "a", "--yes")
    assert values_of(tmp_path / "a").base_image.startswith("ros-torch:"), "a list asks for it"
    text = (tmp_path / "a/.env").read_text()
    assert "ADDITIONAL" not in text, "rosml containerize reads these by themselves"
    assert "reads docker/additional-pip-requirements.txt, and not requirements.txt\n" in done.stderr
    dockerfile = (tmp_path / "a/Dockerfile").read_text()
    assert dockerfile.count("/run/src/target/docker/additional-debs.txt | xargs -r apt-get install ") == 2
    [words] = {line.partition("sed ")[2].partition(" /run/")[0] for line in dockerfile.splitlines() if "sed " in line}
    debs = "ros-$ROS_DISTRO-rviz2 # a comment\nros-${ROS_DISTRO}-gps-msgs\n#htop\n"
    command, env = ["bash", "-c", f"sed {words}"], {**os.environ, "ROS_DISTRO": "jazzy"}
    assert subprocess.check_output(command, env=env, input=debs, text=True).split() == [
        "ros-jazzy-rviz2",
        "ros-jazzy-gps-msgs",
    ]
    assert dockerfile.count("pip install -r /run/src/target/docker/additional-pip-requirements.txt") == 2
    [kept] = [line for line in dockerfile.splitlines() if line.startswith("RUN find /src ")]
    assert all(f"! -name {name} " in kept for name in ("additional-debs.txt", "additional-pip-requirements.txt"))
    at_top = {Path(name).name: text for name, text in lists.items()} | {"blacklisted-packages.txt": "leg\n"}
    write(tmp_path / "b", {**at_top, "elsewhere/debs": "vim\n"})
    called(tmp_path / "b", "--yes")
    values = values_of(tmp_path / "b")
    assert values.additional_debs_file == "additional-debs.txt"
    assert values.additional_pip_file == "additional-pip-requirements.txt"
    assert values.blacklisted_packages_file == "blacklisted-packages.txt"
    write(tmp_path / "c", {**at_top, "elsewhere/debs": "vim\n", ".env": "ADDITIONAL_DEBS_FILE=elsewhere/debs\n"})
    called(tmp_path / "c", "--yes")
    assert "/run/src/target/elsewhere/debs | xargs" in (tmp_path / "c/Dockerfile").read_text()
    (tmp_path / "secret").write_text("torch\n")
    write(tmp_path / "d", {".env": f"ADDITIONAL_PIP_FILE=../secret\nADDITIONAL_DEBS_FILE={'x' * 999}\n"})
    (tmp_path / "d/requirements.txt").symlink_to("../secret")
    called(tmp_path / "d", "--yes")
    dockerfile = (tmp_path / "d/Dockerfile").read_text()
    assert "secret" not in dockerfile and "xargs" not in dockerfile
    assert chosen(tmp_path / "d")["framework"] == "none", "nothing outside of the folder is read"


# ---- Files -----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("registry", [[], REGISTRY])
def test_those_who_read_the_files_understand_them(tmp_path: Path, registry: list[str]) -> None:
    files = {
        "arm/package.xml": manifest(),
        "arm/launch/it's $HOME.launch.py": "",
        ".git/HEAD": "ref: refs/heads/jazzy\n",
    }
    folder = write(tmp_path / "My Robot", files)
    called(folder, "--yes", "--gpu", "--framework", "torch", *registry)
    values, place = values_of(folder), "ghcr.io/me/rosml/" if registry else ""
    assert values.base_image == f"{place}ros-torch:jazzy-base-cu130"
    assert shlex.split(values.command) == ["ros2", "launch", "arm", "it's $HOME.launch.py"]
    assert values.image_name == "my-robot"
    assert list(app_inputs.answers(folder, {})) == []
    project = defaults.files({"XDG_CONFIG_HOME": str(tmp_path)}, str(folder), ["--mws"], []).project
    assert project and (project.line.image, project.line.rosml) == ("my-robot:latest-dev", ("--mws",))
    ignored = IgnoredFiles(folder)
    assert ignored(folder / ".env") and ignored.whole(folder / ".git") and ignored.whole(folder / "build")
    assert [path.parent.name for path in workspace.manifests(folder, ignored=ignored)] == ["arm"]


def test_rosml_run_takes_the_image_to_work_in_and_mounts_the_folder(tmp_path: Path) -> None:
    desk = Desk(tmp_path)
    desk.engine(images={"dr:latest-dev": OURS})
    called(write(desk.folder, {}), "--yes")
    done = desk.call("--dry-run")
    assert done.returncode == 0, done.stderr
    words = shlex.split(done.stdout)
    [mount] = [word for word in words if word.endswith("/docker-ros/ws/src/target")]
    assert str(desk.folder) in mount and words[-1] == "dr:latest-dev"


def test_a_dockerfile_says_where_its_base_image_is_and_how_it_gets_gpus(tmp_path: Path) -> None:
    """Without a registry, Docker would look for `ros:jazzy-base` on Docker Hub, where others have a repository of that name."""
    called(write(tmp_path / "a", TORCH), "--yes", "--gpu")
    called(write(tmp_path / "b", TORCH), "--yes", "--cpu", *REGISTRY)
    with_gpu, without = ((tmp_path / name / "Dockerfile").read_text() for name in ("a", "b"))
    assert "\nARG BASE_IMAGE\n" in with_gpu and "docker run --rm -it --gpus all -e" in with_gpu
    assert "\nARG BASE_IMAGE=ghcr.io/me/rosml/ros-torch:jazzy-base-cpu\n" in without and "--gpus" not in without


@pytest.mark.parametrize(
    ("command", "last"),
    [
        ("ros2 run arm 'a b'", 'CMD ["ros2", "run", "arm", "a b"]'),
        ("a && b $X", 'CMD ["bash", "-c", "a && b $X"]'),
        ("", 'CMD ["bash"]'),
    ],
)
def test_the_command_of_a_dockerfile(tmp_path: Path, command: str, last: str) -> None:
    called(write(tmp_path, {}), "--yes", "--command", command)
    assert (tmp_path / "Dockerfile").read_text().splitlines()[-1] == last


def test_a_folder_of_a_package_is_sent_although_builds_make_folders_of_that_name(tmp_path: Path) -> None:
    called(write(tmp_path, {"install/package.xml": manifest(), "src/package.xml": manifest("leg")}), "--yes")
    lines = (tmp_path / ".dockerignore").read_text().splitlines()
    assert "install" not in lines and "build" in lines


def test_a_second_call_changes_nothing_and_keeps_to_the_first(tmp_path: Path) -> None:
    write(tmp_path, {**WITH_CI, "Dockerfile": "FROM mine\n"})
    words = ["--distribution", "humble", "--component", "core", "--framework", "torch", "--accelerator", "cu128"]
    called(tmp_path, "--yes", *words, "--command", "mine", *REGISTRY)
    before = snapshot(tmp_path)
    assert before["Dockerfile"][0] == b"FROM mine\n" and ".github/workflows/images.yml" in before
    done = called(tmp_path, "--yes", *REGISTRY)
    assert snapshot(tmp_path) == before
    assert re.findall(r"^(same|kept) +(\S+)", done.stdout, re.MULTILINE) == [
        ("kept", "Dockerfile"),
        *(("same", name) for name in (".dockerignore", ".env", ".rosml.toml", ".github/workflows/images.yml")),
    ]
    assert "does not start from ghcr.io/me/rosml/ros-torch:humble-core-cu128, and does not call rosdep" in done.stderr
    assert "docker build" not in done.stdout, "the Dockerfile is somebody else's"


GOOD = "FROM x/ros-torch:jazzy-base-cpu\nRUN rosdep \\\n    install -y{}\n"
WORKFLOW = ".github/workflows/images.yml"


@pytest.mark.parametrize(
    ("name", "text", "says"),
    [
        ("Dockerfile", GOOD.format(" --skip-keys python3-torch"), ""),
        ("Dockerfile", GOOD.format(""), "lets rosdep install python3-torch, which the base image has"),
        ("Dockerfile", "FROM ubuntu\nRUN rosdep update && apt-get install x", "does not call rosdep install"),
        (WORKFLOW, "jobs: {}\n", "does not use rosml containerize\nremedy: add the step uses: me/rosml/cont"),
        (WORKFLOW, "- uses: x/rosml/containerize@1\n", ""),
    ],
)
def test_what_a_file_that_stays_lacks(tmp_path: Path, name: str, text: str, says: str) -> None:
    write(tmp_path, {**WITH_CI, name: text}, depends="python3-torch")
    errors = called(tmp_path, "--yes", *REGISTRY).stderr
    assert (f"{name} stays as it is" in errors) == bool(says) and says in errors
    assert (tmp_path / name).read_text() == text


@pytest.mark.parametrize(
    ("depends", "words", "keys"),
    [
        ("python3-torch python3-pytorch-pip python3-numpy torch_msgs", [], "python3-pytorch-pip python3-torch"),
        ("python3-torch", ["--framework", "none"], ""),
        ("rclpy geometry_msgs nav_msgs", ["--distribution", "jazzy-wheels"], "geometry_msgs rclpy"),
        ("python3-torch python3-torchvision", ["--gpu"], "python3-torch python3-torchvision"),
        ("python3-torch-geometric-pip python-tensorflow-gpu-pip", ["--framework", "ml"], "python-tensorflow-gpu-pip"),
    ],
)
def test_nobody_installs_again_what_the_base_image_has(
    tmp_path: Path, depends: str, words: list[str], keys: str
) -> None:
    """Neither rosml containerize, nor the Dockerfile, nor a job."""
    called(write(tmp_path, WITH_CI, depends=depends), "--yes", *REGISTRY, *words)
    assert values_of(tmp_path).skip_keys == keys
    lines = [line for line in (tmp_path / "Dockerfile").read_text().splitlines() if "rosdep install" in line]
    skipped = [f" --skip-keys {shlex.quote(keys)} " in f"{line.rstrip(chr(92)).rstrip()} " for line in lines]
    assert skipped == [bool(keys)] * 2
    assert ci_inputs(tmp_path).get("skip-keys", "") == keys


def test_an_option_wins_over_the_file_of_variables(tmp_path: Path) -> None:
    write(tmp_path, {".env": "BASE_IMAGE=ros:humble-core\n"})
    assert list(chosen(tmp_path).values())[:4] == ["humble", "core", "none", ""]
    assert list(chosen(tmp_path, "--gpu").values())[:4] == ["humble", "core", "cuda", "cu130"]
    assert list(chosen(tmp_path, "--distribution", "jazzy").values())[:3] == ["jazzy", "base", "none"]


def test_a_dry_run_shows_the_files_and_writes_none(tmp_path: Path) -> None:
    before = snapshot(write(tmp_path, {}))
    assert "    BASE_IMAGE=ros:jazzy-base\n" in called(tmp_path, "--yes", "--dry-run").stdout
    assert snapshot(tmp_path) == before


@pytest.mark.parametrize(
    ("files", "says"),
    [
        ({".env": "IMAGE=r:1\nBASE_IMAGE=ros:humble-base\n"}, "does not say BASE_IMAGE=ros:jazzy-base, COMMAND=bash\n"),
        ({".env": "x y\n"}, "/.env:1: it is not NAME=VALUE"),
        ({".gitignore": "build/\n.env\n"}, ".gitignore leaves out .env"),
    ],
)  # fmt: skip
def test_a_file_of_variables_that_does_not_do(tmp_path: Path, files: dict[str, str], says: str) -> None:
    assert says in called(write(tmp_path, files), "--yes", "--distribution", "jazzy").stderr
    assert (tmp_path / "Dockerfile").exists()


@pytest.mark.parametrize("name", [".env", "Dockerfile", ".rosml.toml"])
def test_a_link_stays_wherever_it_leads(tmp_path: Path, name: str) -> None:
    folder = write(tmp_path / "robot", {})
    (folder / name).symlink_to(tmp_path / "outside")
    called(folder, "--yes")
    assert (folder / name).is_symlink() and not (tmp_path / "outside").exists()


def test_no_file_is_written_behind_a_link_out_of_the_folder(tmp_path: Path) -> None:
    folder, outside = write(tmp_path / "robot", {}), tmp_path / "outside"
    outside.mkdir()
    (folder / ".github").symlink_to(outside)
    before = outside.stat().st_mtime_ns
    done = called(folder, "--yes", "--ci", "github", *REGISTRY, code=1)
    assert "a link leads out of" in str(done.exception)
    assert [path.name for path in folder.iterdir() if path.name != ".github"] == ["package.xml"]
    assert list(outside.iterdir()) == [] and outside.stat().st_mtime_ns == before, "no folder was made there either"


def test_a_folder_that_cannot_be_written(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The third file cannot be written: the first two are not there either, nor is the folder for the last one."""
    write(tmp_path, {})
    calls, real = iter(range(9)), os.fdopen

    def full(*words: Any, **more: Any) -> Any:
        if words[1:] == ("w",) and next(calls) == 2:
            raise PermissionError(13, "Permission denied")
        return real(*words, **more)

    monkeypatch.setattr(os, "fdopen", full)
    done = called(tmp_path, "--yes", "--ci", "github", *REGISTRY, code=1)
    assert "cannot be written: Permission denied" in str(done.exception)
    assert [path.name for path in tmp_path.iterdir()] == ["package.xml"]


# ---- CI --------------------------------------------------------------------------------------------------------------

GITHUB = {".git/HEAD": "", ".git/config": '[remote "origin"]\n\turl = git@github.com:me/robot.git\n'}
GITLAB = {".git/HEAD": "", ".git/config": '[remote "origin"]\n\turl = https://gitlab.example.com/me/robot.git\n'}


def test_a_terminal_is_asked_for_ci_and_where_it_pushes(tmp_path: Path, terminal: None) -> None:
    write(tmp_path, GITHUB)
    typed = "\n" * 5 + "ghcr.io/Me/rosml\n{}\n"
    done = called(tmp_path, "--dry-run", typed=typed.format(""))
    assert "CI file for [github] (git's remote is github.com:me/robot.git): " in done.stderr
    assert "Registry of the base images [none] (such as ghcr.io/me/rosml: jobs do not reach this" in done.stderr
    assert "Push images to [ghcr.io/me/robot] (the repository's own place): " in done.stderr
    assert "image-name" not in done.stdout and re.search("^push to +ghcr.io/me/robot ", done.stdout, re.MULTILINE)
    done = called(tmp_path, typed=typed.format("quay.io/me/robot"))
    secrets = {f"registry-{name}": f"${{{{ secrets.REGISTRY_{name.upper()} }}}}" for name in ("user", "password")}
    expected = {"image-name": "quay.io/me/robot", "registry": "quay.io", **secrets}
    assert ci_inputs(tmp_path).items() >= expected.items()
    assert "CI logs in to quay.io alone" in done.stderr


@pytest.mark.parametrize(
    ("name", "base", "place", "inputs"),
    [
        ("github", "ghcr.io/me/rosml", "ghcr.io/me/arm", {"image-name": "ghcr.io/me/arm"}),
        ("gitlab", "registry.gitlab.com/me/rosml", "quay.io/me/arm", {"image-name": "quay.io/me/arm", "registry": "quay.io"}),
    ],
)  # fmt: skip
def test_where_ci_pushes(tmp_path: Path, name: str, base: str, place: str, inputs: dict[str, str]) -> None:
    done = called(write(tmp_path, {}), "--yes", "--ci", name, "--push-to", place, "--registry", base)
    about_place = {key: value for key, value in ci_inputs(tmp_path, name).items() if key.startswith(("image", "regis"))}
    assert about_place == inputs and ("masked variables" in done.stderr) == (name == "gitlab")


def test_without_ci_a_call_pushes(tmp_path: Path) -> None:
    out = called(write(tmp_path, {}), "--yes", "--push-to", "quay.io/me/arm").stdout
    assert f"containerize {tmp_path} --push --image-name quay.io/me/arm\n" in out


@pytest.mark.parametrize(
    ("files", "words", "name"),
    [
        ({}, REGISTRY, "none"),
        (WITH_CI, [], "none"),
        (WITH_CI, [*REGISTRY, "--ci", "none"], "none"),
        (GITHUB, REGISTRY, "github"),
        (GITLAB, REGISTRY, "none"),
        (GITLAB, ["--registry", "registry.example.com/me/rosml"], "gitlab"),
    ],
)
def test_the_forge_of_a_repository(tmp_path: Path, files: dict[str, str], words: list[str], name: str) -> None:
    assert chosen(write(tmp_path, files), *words)["ci"] == name


def test_ci_files_belong_to_the_top_of_a_repository(tmp_path: Path) -> None:
    write(tmp_path, {"ros/package.xml": manifest(), ".git/HEAD": ""})
    error = called(tmp_path / "ros", "--ci", "github", *REGISTRY, code=2).exception
    assert f"CI files belong into {tmp_path}" in str(error)


@pytest.mark.parametrize(
    ("name", "place"), [("github", "ghcr.io/me/rosml"), ("gitlab", "registry.gitlab.com/me/rosml")]
)
def test_inputs_of_a_ci_file_exist(tmp_path: Path, name: str, place: str) -> None:
    write(tmp_path, {"a/x.jazzy.repos": "", "b/x.humble.repos": "", "requirements.txt": "scipy\n"})
    command = 'ros2 run "a b" c: d # é'
    called(tmp_path, "--yes", "--ci", name, "--registry", place, "--command", command)
    document, inputs = yaml.safe_load((tmp_path / file_texts.FORGES[name]).read_text()), ci_inputs(tmp_path, name)
    if name == "github":
        assert document["jobs"]["images"]["steps"][0]["uses"].startswith("me/rosml/containerize@")
        ours = yaml.safe_load((ROOT / "containerize/action.yml").read_text())["inputs"]
    else:
        [included] = document["include"]
        assert included["project"] == "me/rosml"
        ours = next(yaml.safe_load_all((ROOT / included["file"]).read_text()))["spec"]["inputs"]
    assert set(inputs) <= set(ours)
    assert (inputs["base-image"], inputs["command"]) == (f"{place}/ros:jazzy-base", command)
    assert (inputs["vcs-import-file"], inputs["additional-pip-file"]) == ("a/x.jazzy.repos", "requirements.txt")


def test_a_job_gets_a_commit_only_if_a_remote_has_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(git, "commit", lambda _: git.Commit("1" * 40, 0))
    monkeypatch.setattr(git, "ask", lambda *_: b"1 commit refs/remotes/origin/main\n")
    assert (forge.revision("github"), forge.revision("gitlab")) == ("1" * 40, "main")
    monkeypatch.setattr(git, "ask", lambda *_: b"")
    assert forge.revision("github") == "main"


# ---- What comes next -------------------------------------------------------------------------------------------------


def test_what_comes_next(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    write(tmp_path, {}, name="robot")
    monkeypatch.chdir(tmp_path)
    document = json.loads(called(Path("."), "--json").stdout)
    name = file_texts.image_name(tmp_path.name)
    assert document["next"] == [
        f"{ROOT}/rosml image jazzy-base",
        f"{ROOT}/rosml containerize",
        f"{ROOT}/rosml run",
        f"docker build --build-arg BASE_IMAGE=REGISTRY/ros:jazzy-base -t {name} .",
    ]
    assert document["packages"] == [{"name": "robot", "folder": ".", "languages": []}]
    monkeypatch.setattr(init, "_local", lambda _: ("127.0.0.1:5000/rosml", True))
    commands = json.loads(called(Path("."), "--json").stdout)["next"]
    assert commands[0] == f"{ROOT}/rosml containerize"
    assert "BASE_IMAGE=127.0.0.1:5000/rosml/ros:jazzy-base" in commands[2]


def test_a_base_image_in_a_registry_is_published_first(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    write(tmp_path, {})
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(base_images, "native_architecture", lambda: "amd64")
    line = f"{ROOT}/rosml publish all --registry ghcr.io/me/rosml --only jazzy-base{{}} --serve amd64"
    for words, slim in (([], ""), (["--ci", "github"], " --only jazzy-base-run")):  # CI makes a slim image, too
        commands = json.loads(called(tmp_path, "--json", *words, *REGISTRY).stdout)["next"]
        assert commands[:2] == [line.format(slim), f"{ROOT}/rosml containerize"]
    monkeypatch.setattr(init, "IN_CHECKOUT", False)
    assert "in a clone of rosml: publishes" in called(tmp_path, "--yes", *REGISTRY).stdout


@pytest.mark.parametrize(
    ("folder", "name"), [("My_Robot!", "my_robot"), ("a..b", "a.b"), ("機械", "app"), ("a-_b", "a-b")]
)
def test_the_name_of_an_image(folder: str, name: str) -> None:
    assert file_texts.image_name(folder) == name


# ---- What a repository says is written into files of others ----------------------------------------------------------


def project_of(text: str) -> file_texts.Project:
    """A project in which all that a repository may choose has a text."""
    return file_texts.Project(
        name="robot", tag="ros:jazzy-base", place="ghcr.io/me/rosml", ros=2, gpu=False, command=f"ros2 launch a '{text}'", ended=False,
        pip=(f"{text}.txt",), repos=f"{text}.repos", is_one_of_several=True, packages=(text,), forge="github", source="me/rosml",
        revision="main", keys=(text,),
    )  # fmt: skip


@pytest.mark.parametrize("text", HOSTILE)
def test_texts_of_a_repository_are_only_texts_in_all_files(text: str) -> None:
    """Each file is read as its system reads it."""
    project = project_of(text)
    expected = {name.lower().replace("_", "-"): value for name, value in file_texts.variables(project).items()}
    github = file_texts.texts(project)[file_texts.GITHUB]
    literal = "${{ '${{' }}"
    for name, value in yaml.safe_load(github)["jobs"]["images"]["steps"][0]["with"].items():
        if name != "push":
            assert "${{" not in value.replace(literal, "")
            assert value.replace(literal, "${{") == expected[name]
    gitlab = file_texts.texts(replace(project, forge="gitlab"))[file_texts.GITLAB]
    (include,) = yaml.safe_load(gitlab)["include"]
    for name, value in include["inputs"].items():
        if name not in ("rosml-url", "rosml-ref"):
            assert (value if name in file_texts.AS_IT_IS else value.replace("$$", "$")) == expected[name]
            assert name in file_texts.AS_IT_IS or "$" not in value.replace("$$", "")
    dockerfile = file_texts.texts(project)[file_texts.DOCKERFILE]
    instructions = [line for line in dockerfile.split("\n") if line and not line.startswith((" ", "#"))]
    assert {line.split(" ")[0] for line in instructions} <= {"ARG", "FROM", "COPY", "RUN", "CMD"}
    (copied,) = [json.loads(line[5:]) for line in instructions if line.startswith("COPY [")]
    assert re.sub(r"\\(.)", r"\1", copied[0]) == project.repos and not re.search(r"(?<!\\)(\\\\)*\$", copied[0])


@pytest.mark.parametrize("text", ["a\nRUN id", "a\x00", "a\u2028b"])
def test_a_name_of_several_lines_is_refused(text: str) -> None:
    with pytest.raises(RosmlError, match="has the character"):
        file_texts.texts(project_of(text))


def test_a_registry_of_the_repository_is_a_proposal(tmp_path: Path) -> None:
    """A stranger's .env would choose whose workflow may write packages."""
    folder = write(tmp_path, {**WITH_CI, ".env": "BASE_IMAGE=ghcr.io/attacker/rosml/ros:jazzy-base\n"})
    done = called(folder, "--yes", "--distribution", "jazzy")
    assert "names the registry ghcr.io/attacker/rosml, and nobody has confirmed it" in done.stderr
    assert not (folder / ".github/workflows").exists()
    assert "attacker" not in (folder / "Dockerfile").read_text()
    (folder / "Dockerfile").unlink()
    (folder / ".env").write_text('BASE_IMAGE="x.y/a\nFROM debian AS z\nRUN id >/evil\n# /ros:jazzy-base"\n')
    called(folder, "--yes", "--distribution", "jazzy")
    assert "evil" not in (folder / "Dockerfile").read_text()
