"""`rosml dev`: when its image is made, what the engine gets, and what is said where nothing starts. The engine and the builder are
local replacements."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from collections.abc import Callable, Sequence
from itertools import pairwise
from pathlib import Path
from types import ModuleType, SimpleNamespace
from typing import Any

import pytest
from click.testing import CliRunner

import rosml
from fakes.desks import OURS, PODMAN, Desk
from fakes.stubs import executable, script_of_a_build
from rosml.base.errors import RosmlError
from rosml.cli import main
from rosml.cli.containerize import containerize, dev
from rosml.cli.run import container
from rosml.containerize.build import bake_file, dev_folder, step_order
from rosml.containerize.build.result import ShellImage
from rosml.containerize.ignored_files import IgnoredFiles
from rosml.containerize.packages import workspace
from rosml.machine import docker
from rosml.run.plugins import basic_options

COMMAND = bake_file.SCRIPTS / "containerize/desk_command.sh"


class Place:
    """A folder with a package, in which somebody calls `rosml dev`."""

    def __init__(self, tmp_path: Path) -> None:
        self.folder, self.desk = tmp_path / "my robot", Desk(tmp_path)
        self.builds = 0
        self.loaded = True  # the image goes to Docker, or else to a registry
        self.for_podman = False
        self.commands: list[Sequence[str]] = []  # the engine's commands that the calls became
        self.stderr = ""

    @property
    def image(self) -> str:
        return dev_folder.image_name(self.folder) + (":latest" if self.loaded else "@sha256:1")

    def new_call(self, folder: Path, values: Any, *_: object) -> SimpleNamespace:
        assert (folder, values.image_name, values.push) == (self.folder, dev_folder.image_name(folder), False)

        return SimpleNamespace(for_podman=lambda: "podman")

    def build(self, call: object) -> ShellImage:
        self.builds, self.for_podman = self.builds + 1, call == "podman"
        image = {self.image: OURS}
        self.desk.engine(images=image if self.loaded else {}, registry={} if self.loaded else image)
        return ShellImage(self.image, self.loaded)

    def become(self, argv: Sequence[str]) -> None:
        self.commands.append(argv)
        raise SystemExit(0)

    def call(self, *words: str) -> list[str]:
        """The engine's command that a call becomes."""
        before = len(self.commands)
        end = CliRunner().invoke(main.cli, ["dev", *words])
        self.stderr = end.stderr
        if isinstance(end.exception, RosmlError):
            raise end.exception
        assert len(self.commands) == before + 1, (end.output, end.exception)
        return [*self.commands[-1]]

    def mounts(self, *words: str) -> dict[str, str]:
        """The value of each `--mount`, by its target."""
        values = [value for word, value in pairwise(self.call(*words)) if word == "--mount"]
        return {value.partition("target=")[2].partition(",")[0]: value for value in values}


@pytest.fixture
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Place:
    place = Place(tmp_path)
    write("src/arm/package.xml", "<package><name>arm</name></package>")(place.folder)
    write(".env", "BASE_IMAGE=ros:jazzy-base\n")(place.folder)
    place.desk.engine(images={})
    for name in [name for name in os.environ if name.startswith(("ROSML_", "XDG_", "DOCKER_"))]:
        monkeypatch.delenv(name)
    monkeypatch.setenv("PATH", str(place.desk.bin))
    monkeypatch.setenv("HOME", str(tmp_path))
    monkeypatch.setattr(rosml, "STATE", tmp_path / "state")
    monkeypatch.setattr(step_order, "new_call", place.new_call)
    monkeypatch.setattr(step_order, "build_shell_image", place.build)
    monkeypatch.setattr(containerize, "services_for_builds", lambda: SimpleNamespace(require_builder=lambda: None))
    monkeypatch.setattr(container, "become", place.become)
    monkeypatch.chdir(place.folder)
    return place


def write(name: str, text: str = "x") -> Callable[[Path], None]:
    def change(folder: Path) -> None:
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)

    return change


@pytest.mark.parametrize("address", ["ssh://me@192.0.2.1", "tcp://192.0.2.1:2375"])
def test_an_engine_of_another_machine_does_not_have_the_folder(
    place: Place, monkeypatch: pytest.MonkeyPatch, address: str
) -> None:
    monkeypatch.setattr(docker, "address", lambda program: address)
    with pytest.raises(RosmlError, match=f"docker asks the one at {address}, which does not have .*my robot") as caught:
        place.call()
    assert "unset DOCKER_HOST" in caught.value.remedy and not place.builds
    for here in ("tcp://127.0.0.1:2375", "unix:///run/user/1/docker.sock", ""):
        monkeypatch.setattr(docker, "address", lambda program, here=here: here)
        place.call()


# ---- The image -------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("change", "again"),
    [
        (write("src/arm/package.xml", "<package><name>arm</name><depend>tf2</depend></package>"), True),
        (write("docker/additional-debs.txt", "htop\nros-$ROS_DISTRO-rviz2\n"), True),
        (write(".env", "BASE_IMAGE=ros:humble-base\n"), True),
        (write("src/arm/arm.cpp"), False),
        (write(f"{dev_folder.KEPT}/install/arm/package.xml", "<package><name>arm</name></package>"), False),
    ],
)
def test_an_image_is_made_again_if_its_inputs_changed(
    place: Place, change: Callable[[Path], None], again: bool
) -> None:
    place.call()
    place.call("--", "colcon", "build")
    assert place.builds == 1
    change(place.folder)
    place.call()
    assert place.builds == 1 + again


def test_an_image_is_made_again_for_other_scripts_and_not_for_their_bytecode(
    place: Place, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    scripts = tmp_path / "components"
    for part in ("containerize", "build", "ros"):
        write(f"{part}/step.py")(scripts)
    monkeypatch.setattr(bake_file, "SCRIPTS", scripts)
    for name, builds in (("containerize/__pycache__/step.pyc", 1), ("containerize/step.py", 1), ("ros/step.py", 2)):
        place.call()
        assert place.builds == builds
        write(name, "other")(scripts)
    place.call()
    assert place.builds == 3


def test_an_image_is_made_again_if_the_engine_or_the_user_has_another(place: Place) -> None:
    place.call()
    place.desk.engine(images={})
    for words, builds in (([], 2), (["--build"], 3), (["--addons", "graph"], 4), (["--addons", "graph"], 4)):
        place.call(*words)
        assert place.builds == builds


def test_an_image_of_the_local_registry_is_pulled_by_its_digest(place: Place) -> None:
    place.loaded = False
    assert place.call()[-1] == place.image
    assert ["docker", "pull", place.image] in place.desk.calls


def test_podman_gets_it_from_the_local_registry(place: Place) -> None:
    """Also if Docker is the builder."""
    place.call()
    assert not place.for_podman
    place.desk.engine(info=PODMAN, images={})
    place.call("--build")
    assert place.for_podman


def test_an_image_that_another_engine_has_is_not_pulled(place: Place, monkeypatch: pytest.MonkeyPatch) -> None:
    """Docker Hub may have one of that name."""
    monkeypatch.setattr(place.desk, "engine", lambda **_: None)
    with pytest.raises(RosmlError, match="the image is in Docker, and docker does not have it"):
        place.call()
    assert not place.desk.called("pull")


# ---- What the engine gets --------------------------------------------------------------------------------------------


def test_the_folder_is_mounted_and_what_is_built_is_kept(place: Place) -> None:
    argv = place.call("--", "colcon", "build", "--packages-select", "a b")
    assert argv[-5:] == [place.image, "colcon", "build", "--packages-select", "a b"]
    assert argv[argv.index("--workdir") + 1] == dev.WORKSPACE
    assert not [word for word in argv if word.startswith(dev.LABEL)], "a shell in it would end with the command"
    mounts = place.mounts()
    assert mounts[dev.WORKSPACE] == f"type=bind,source={place.folder}/{dev_folder.KEPT},target={dev.WORKSPACE}"
    target = f"{dev.WORKSPACE}/src/target"
    assert mounts[target] == f"type=bind,source={place.folder},target={target}"
    for point in dev_folder.POINTS:
        assert (place.folder / dev_folder.KEPT / point).is_dir(), "the engine would make it, for root"


def test_imported_repositories_cannot_be_changed(place: Place, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    place.call()
    file = dev_folder.record_file(place.folder, tmp_path / "state")
    record = dev_folder.read_record(file)
    assert record
    dev_folder.write_record(file, record.model_copy(update={"upstream": "/imported"}))
    assert place.mounts()[f"{dev.WORKSPACE}/src/upstream"].endswith(",readonly")


def test_options_go_to_the_engine(place: Place, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """A relative path is one of the current folder, and not of the folder that is named."""
    monkeypatch.chdir(tmp_path)
    (place.folder / ".rosml.toml").write_text('image = "other"\ncommand = ["ls"]\noptions = ["--loc"]\n')
    argv = place.call("-v", "./bags:/bags", "-w", "/tmp", "my robot")
    assert argv[-1] == place.image
    assert f"{tmp_path}/bags:/bags" in argv and argv.count("--workdir") == 0


def test_git_and_builds_leave_out_what_is_kept(place: Place, tmp_path: Path) -> None:
    place.call()
    workspace.stage(place.folder, tmp_path / "staged", ignored=IgnoredFiles(place.folder))
    assert not (tmp_path / "staged/.rosml").exists()
    git = shutil.which("git", path=os.defpath)
    assert git
    subprocess.run([git, "init", "--quiet", place.folder], check=True)
    listed = subprocess.run([git, "status", "--short"], cwd=place.folder, capture_output=True, text=True, check=True)
    assert "src/" in listed.stdout and ".rosml" not in listed.stdout


# ---- A container that runs -------------------------------------------------------------------------------------------


def run_container(place: Place, key: str) -> None:
    labels = {basic_options.FOLDER_LABEL: str(place.folder), dev.LABEL: key}
    config = {"Image": place.image, "Env": OURS, "Labels": labels, "Entrypoint": ["/tini", "--", "/entrypoint.sh"]}
    place.desk.engine(images={place.image: OURS}, containers={"r": ["running", "/r", place.image, config]})


def test_a_second_call_enters_the_container_of_the_first(place: Place) -> None:
    argv = place.call()
    key = next(word for word in argv if word.startswith(f"{dev.LABEL}=")).partition("=")[2]
    run_container(place, key)
    argv = place.call("--", "colcon", "test")
    assert argv[:2] == ["docker", "exec"] and argv[-4:] == ["r", "/entrypoint.sh", "colcon", "test"]
    assert (place.stderr, place.builds) == ("", 1)


def test_a_container_with_an_older_image_is_entered_with_a_warning(place: Place) -> None:
    run_container(place, "older")
    assert place.call()[1] == "exec"
    assert "r has the dependencies of before" in place.stderr and "docker stop r" in place.stderr
    with pytest.raises(RosmlError, match="-p is for a container that starts, and r runs already"):
        place.call("-p", "127.0.0.1:5678:5678")
    assert place.call("--build")[1] == "run"


# ---- What is wrong ---------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("words", "says"),
    [
        (["colcon", "test"], "a command stands after --: rosml dev -- colcon test"),
        (["htop"], "there is no folder htop"),
        (["--rosdep-index", "lists of mine"], "set its variable: ROSDEP_INDEX='lists of mine' rosml dev"),
        (["--skip-keys"], "set its variable: SKIP_KEYS=VALUE rosml dev"),
        (["--no-base-entrypoint"], "set its variable: BASE_ENTRYPOINT=false rosml dev"),
        (["--image-tag", "mine"], "leave it out: rosml dev makes one image for this machine, without an app"),
        (["--platform", "linux/arm64"], "--platform: the image is for this machine"),
        (["--dry-run"], "the image of this folder is not made"),
        (["empty"], "there is no package.xml in"),
    ],
)
def test_a_wrong_call_is_refused_before_anything_is_made(place: Place, words: list[str], says: str) -> None:
    (place.folder / "empty").mkdir()
    with pytest.raises(RosmlError) as error:
        place.call(*words)
    assert says in f"{error.value.message} {error.value.remedy}"
    assert not place.builds and not (place.folder / ".rosml").exists()


def test_nothing_is_kept_in_a_folder_of_somebody_else(tmp_path: Path) -> None:
    uid = os.geteuid()
    dev_folder.require_owner(tmp_path, uid)
    dev_folder.make(tmp_path)
    dev_folder.require_owner(tmp_path, uid)
    with pytest.raises(RosmlError, match=r"\.rosml belongs to the user") as error:
        dev_folder.require_owner(tmp_path, uid + 1)
    assert error.value.remedy == f"remove it: sudo rm -rf '{tmp_path}/{dev_folder.KEPT}'"
    tmp_path.chmod(0o555)
    if uid:
        with pytest.raises(RosmlError, match="you cannot write there"):
            dev_folder.require_owner(tmp_path, uid)
        with pytest.raises(RosmlError, match="and you are root"):
            dev_folder.require_owner(tmp_path, 0)
    tmp_path.chmod(0o755)


@pytest.mark.parametrize(
    "place_of_link", [".rosml", dev_folder.KEPT, f"{dev_folder.KEPT}/src", f"{dev_folder.KEPT}/src/target"]
)
def test_nothing_is_kept_behind_a_link(place: Place, tmp_path: Path, place_of_link: str) -> None:
    """A repository may have one that leads to any folder of the person's."""
    link = place.folder / place_of_link
    link.parent.mkdir(parents=True, exist_ok=True)
    link.symlink_to(tmp_path)
    with pytest.raises(RosmlError, match="is no folder"):
        place.call()
    assert not place.builds


@pytest.mark.parametrize("name", ["COLCON_IGNORE", "CATKIN_IGNORE", ".gitignore"])
def test_no_file_is_made_behind_a_link_of_a_stranger(tmp_path: Path, name: str) -> None:
    folder = tmp_path / "robot"
    (folder / dev_folder.KEPT).mkdir(parents=True)
    (folder / dev_folder.KEPT / name).symlink_to(tmp_path / "outside")
    with pytest.raises(RosmlError, match=f"{name} is a link"):
        dev_folder.make(folder)
    assert not (tmp_path / "outside").exists()


# ---- In the container ------------------------------------------------------------------------------------------------


@pytest.fixture
def joiner() -> ModuleType:
    return script_of_a_build("containerize/compile_commands.py")


def entry(name: str, flags: str = "") -> dict[str, str]:
    file = f"/docker-ros/ws/src/target/src/{name}.cpp"
    return {"directory": f"/docker-ros/ws/build/{name}", "file": file, "command": f"c++ {flags} -c {file}"}


def test_commands_of_compilers_are_joined(joiner: ModuleType, tmp_path: Path) -> None:
    """colcon may write a file of its own for all packages; catkin_make has no other one."""
    write("build/compile_commands.json", json.dumps([entry("all")]))(tmp_path)
    joiner.main(tmp_path, "")
    file = tmp_path / "compile_commands.json"
    assert json.loads(file.read_text()) == [entry("all")]
    odd = [1, {"directory": 1, "file": "a", "command": "c++"}, {"directory": "/", "file": "a", "command": "c++ 'a"}]
    texts = {name: json.dumps([entry(name)]) for name in ("leg", "arm")} | {"half": "[{", "odd": json.dumps(odd)}
    for name, text in texts.items():
        write(f"build/{name}/compile_commands.json", text)(tmp_path)
    joiner.main(tmp_path, "")
    assert json.loads(file.read_text()) == [entry("arm"), entry("leg")]
    assert not (tmp_path / "host").exists()


def test_commands_have_paths_of_the_machine_as_well(joiner: ModuleType) -> None:
    home, workspace = "/home/jo/my robot", "/docker-ros/ws"
    places = {f"{workspace}/src/target": home, workspace: f"{home}/.rosml/dev"}
    file = f"{home}/src/arm.cpp"
    assert joiner.moved(entry("arm", f"-I{workspace}/install/arm -DA='\"b c\"'"), places) == {
        "directory": f"{home}/.rosml/dev/build/arm",
        "file": file,
        "arguments": ["c++", f"-I{home}/.rosml/dev/install/arm", '-DA="b c"', "-c", file],
    }


Colcon = Callable[..., tuple[int, list[str]]]


@pytest.fixture
def colcon(tmp_path: Path) -> Colcon:
    """Calls colcon as in the container. Returns its exit code, and the calls of the real one."""
    shim, real = tmp_path / "desk", tmp_path / "bin"
    for folder in (shim, real, tmp_path / "ws/src/target"):
        folder.mkdir(parents=True)
    shutil.copy(COMMAND, shim / "command.sh")
    shutil.copy(COMMAND.with_name("compile_commands.py"), shim)
    (shim / "colcon").symlink_to("command.sh")
    (shim / "colcon_args").write_text("--executor sequential 'a b'\n")
    fails = 'case $* in "${FAILS-nothing}"*) exit 3 ;; esac'
    executable(real / "colcon", f"printf '%s\\n' \"$*\" >>'{tmp_path}/calls'\n{fails}")

    def call(*words: str, **variables: str) -> tuple[int, list[str]]:
        (tmp_path / "calls").write_text("")
        env = {"PATH": f"{shim}:{real}:/usr/bin:/bin", "WORKSPACE": str(tmp_path / "ws"), "ROS_VERSION": "1"}
        end = subprocess.run([shim / "colcon", *words], env=env | variables, check=False)
        return end.returncode, (tmp_path / "calls").read_text().replace(str(tmp_path / "ws"), "WS").splitlines()

    return call


def test_colcon_builds_and_tests_as_in_ci(colcon: Colcon, tmp_path: Path) -> None:
    assert colcon("list") == (0, ["list"])
    assert colcon("build", "--packages-select", "arm") == (0, ["build --executor sequential a b --packages-select arm"])
    tests = "--cmake-args --cmake-target tests --cmake-target-skip-unavailable"
    words = ["test", "--packages-select", "arm", "leg", "--event-handlers", "x+", "--packages-skip", "b"]
    build = f"build --base-paths WS/src/target --packages-select arm leg --packages-skip b {tests}"
    assert colcon(*words) == (0, [build, " ".join(words)])
    assert colcon("test", ROS_VERSION="2") == (0, ["test"])
    (tmp_path / "ws/src/target/colcon.meta").touch()
    assert colcon("test", ROS_VERSION="2") == (0, ["test --metas WS/src/target/colcon.meta"])


def test_its_exit_code_is_colcons(colcon: Colcon) -> None:
    assert colcon("test", FAILS="test")[0] == 3
    code, calls = colcon("test", FAILS="build")
    assert (code, len(calls)) == (3, 1), "tests that do not build do not run"
