"""The folders of examples/, built as they stand there: a test gives another base image, and replaces nothing else."""

from __future__ import annotations

import base64
import http.server
import json
import re
import secrets
import shlex
import shutil
import subprocess
import tempfile
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from functools import partial
from pathlib import Path
from typing import Any

import pytest
import yaml

from rosml import ROOT
from rosml.images.builds.push import COMPRESSION
from rosml.machine.services import Services
from tests.e2e import engine
from tests.e2e.app_builds import build_app, commit, write
from tests.e2e.calls import NAMESPACE, rosml, wait_until
from tests.e2e.images import Publish, build, build_file, build_parts, buildx
from tests.e2e.local_servers import serving

EXAMPLES = ROOT / "examples"
HERE = Path(__file__).parent / "examples_base"


def base(services: Services, reference: str, name: str, *steps: str) -> str:
    """An image with what the network has for others: lists for rosdep, the certificates of this machine, and `ros2 run` if
    ROS 2 is from wheels, which lack the command; then steps of a test's own."""
    image = f"{services.registry}/{NAMESPACE}/examples/base:{name}"
    options = ["--output", f"type=image,name={image},push=true", "--build-arg", f"BASE_IMAGE={reference}"]
    with tempfile.TemporaryDirectory() as folder:
        shutil.copytree(HERE, folder, dirs_exist_ok=True)
        with Path(folder, "Dockerfile").open("a") as file:
            file.write("".join(f"RUN {step}\n" for step in steps))
        buildx(services, *options, "--build-context", f"components={ROOT / 'components'}", folder)
    return image


def joined(services: Services, reference: str, name: str, *parts: str) -> str:
    """An image and parts that have been built."""
    prefix = f"{services.registry}/{NAMESPACE}"
    image = f"{prefix}/examples/joined:{name}"
    rosml("join", reference, *(f"{prefix}/part:{part}" for part in parts), "--tag", image)
    return image


def example(
    services: Services, name: str, image: str, folder: Path, *checks: str, options: tuple[str, ...] = ()
) -> str:
    """Builds the Dockerfile of an example on an image, then steps of its own; returns what the builder said."""
    place = folder / name
    shutil.copytree(EXAMPLES / name, place)
    with (place / "Dockerfile").open("a") as file:
        file.write("".join(f"RUN {check}\n" for check in checks))
    output = build(services, place, "--build-arg", f"BASE_IMAGE={image}", *options)
    assert re.search(r"Summary: [1-9]\d* tests?, 0 errors, 0 failures", output), output
    return output


def command(name: str) -> str:
    """What the image of an example starts."""
    [words] = re.findall(r"^CMD (\[.*\])$", (EXAMPLES / name / "Dockerfile").read_text(), re.MULTILINE)
    return shlex.join(json.loads(words))


def says(words: str, *commands: str) -> str:
    """A step that starts commands side by side, waits until one of them says something, and stops them as `docker stop` does."""
    script = "".join(f"/tini -s -- /entrypoint.sh {words} >>/said 2>&1 & " for words in commands)
    script += (
        f"for try in {{1..300}}; do if grep -q {shlex.quote(words)} /said; then break; fi; sleep 0.1; done; "
        f"cat /said; kill $(jobs -p); wait; grep -q {shlex.quote(words)} /said"
    )
    return f"bash -c {shlex.quote(script)}"


@pytest.fixture(scope="module")
def ros2(services: Services, published: Publish) -> str:
    """ROS 2 from wheels."""
    return base(services, published("jazzy-wheels-core").reference, "ros2")


@pytest.fixture(scope="module")
def ros2_tensorflow(services: Services, published: Publish) -> str:
    """The same with TensorFlow, joined in the registry: an image set's own would run tests that another image has passed."""
    parts = published("ros1-bookworm-core-tensorflow-cpu").image.parts
    image = joined(services, published("jazzy-wheels-core").reference, "tensorflow", *parts)
    return base(services, image, "ros2-tensorflow")


def test_tensorflow_node(services: Services, ros2_tensorflow: str, tmp_path: Path) -> None:
    check = says("TensorFlow .* on the CPU", command("tensorflow-node"))
    example(services, "tensorflow-node", ros2_tensorflow, tmp_path, check)


MOVES = "import rclpy; from test_node import Robot; rclpy.init(); print('moves', Robot().moves(60))"


@pytest.mark.full(proof="examples")
def test_remote_policy(services: Services, ros2: str, published: Publish, tmp_path: Path) -> None:
    """In one container by its own test; then each in its container of Docker, with what compose.yaml says of it."""
    file = yaml.safe_load((EXAMPLES / "remote-policy/compose.yaml").read_text())
    example(services, "remote-policy", ros2, tmp_path)
    folders = {"robot": tmp_path / "remote-policy", "policy": tmp_path / "remote-policy/server"}
    bases = {"robot": ros2, "policy": base(services, published("ros1-bookworm-core").reference, "policy-server")}
    with engine.running() as docker, ExitStack() as after:
        for service, facts in file["services"].items():
            image = f"{services.registry}/{NAMESPACE}/examples/{facts['image']}:latest"
            output = ("--output", f"type=image,name={image},push=true,{COMPRESSION}")
            buildx(services, *output, "--build-arg", f"BASE_IMAGE={bases[service]}", str(folders[service]))
            name = docker.image(services, image, facts["image"], tmp_path)
            after.callback(docker.docker, "rm", "--force", service)
            options = (
                "--network",
                facts["network_mode"],
                "--ipc",
                facts["ipc"],
                *(["--init"] if "init" in facts else []),
            )
            started = docker.docker("run", "--detach", "--name", service, *options, name)
            assert started.code == 0, started.err
        tests = "/docker-ros/ws/src/remote_policy/test"
        moves = docker.docker("exec", "--workdir", tests, "robot", "/entrypoint.sh", "python3", "-c", MOVES)
        assert "moves [1.0, 1.5]" in moves.out, moves.err + docker.docker("logs", "robot").err
        stopped = docker.docker("stop", *file["services"])
        assert stopped.code == 0 and stopped.out.split() == [*file["services"]], stopped.err


def test_compose(services: Services, ros2: str, tmp_path: Path) -> None:
    """Both services in Docker, each by `docker run` with what compose.yaml says of it; Docker's compose has not run them."""
    file = yaml.safe_load((EXAMPLES / "compose/compose.yaml").read_text())
    example(services, "compose", ros2, tmp_path)
    image = f"{services.registry}/{NAMESPACE}/examples/lights:latest"
    output = ("--output", f"type=image,name={image},push=true,{COMPRESSION}", "--build-arg", f"BASE_IMAGE={ros2}")
    buildx(services, *output, str(tmp_path / "compose"))
    with engine.running() as docker, ExitStack() as after:
        name = docker.image(services, image, "lights", tmp_path)
        for service, facts in file["services"].items():
            after.callback(docker.docker, "rm", "--force", service)
            options = ("--network", facts["network_mode"], "--ipc", facts["ipc"], "--env", "ROS_DOMAIN_ID=66")
            started = docker.docker(
                "run", "--detach", "--name", service, *options, name, *shlex.split(facts["command"])
            )
            assert started.code == 0, started.err
        logs = partial(docker.docker, "logs", "watcher")
        wait_until(lambda: "the light is in column" in logs().out + logs().err, 60.0, logs)
        stopped = docker.docker("stop", *file["services"])
        assert stopped.code == 0 and stopped.out.split() == [*file["services"]], stopped.err


@pytest.mark.full(proof="cuda")
def test_torch_node(services: Services, published: Publish, tmp_path: Path) -> None:
    image = base(services, published("jazzy-wheels-core-torch-cu128").reference, "torch-node")
    output = example(services, "torch-node", image, tmp_path, says("PyTorch .* on cpu", command("torch-node")))
    assert re.search(r"PyTorch [\d.]+\S* on cpu", output)


@pytest.mark.full(proof="cuda")
def test_policy(services: Services, published: Publish, tmp_path: Path) -> None:
    """A policy of LeRobot in its environment, in one process with rclpy."""
    reference = published("jazzy-wheels-core-torch-cu128").reference
    rosml("env", "build", "lerobot", "--python", "3.11", "--namespace", NAMESPACE)
    environment, image = f"{NAMESPACE}/env:lerobot-py311", f"{services.registry}/{NAMESPACE}/examples/joined:policy"
    rosml("join", reference, f"{services.registry}/{environment}", "--tag", image)
    check = says("act with PyTorch .* on cpu", command("policy"))
    example(services, "policy", base(services, image, "policy"), tmp_path, check)


@pytest.mark.full(proof="cuda")
def test_torch_nodelet(services: Services, published: Publish, tmp_path: Path) -> None:
    image = base(services, published("ros1-bookworm-core-torch-cu128").reference, "torch-nodelet")
    example(services, "torch-nodelet", image, tmp_path, says("PyTorch .* on cpu", command("torch-nodelet")))


PYTEST = "python3-pytest: {debian: [python3-pytest]}\n"


def index(folder: Path, rules: str) -> str:
    """Lists for rosdep with some rules, in a folder; gives their place."""
    return str(write(folder / "index", {"rosdep/base.yaml": rules}))


ONNX = ("common-cpu-py311", "grpc-cpu-py311", "onnxruntime-cc-cpu", "onnxruntime-cpu-py311")


@pytest.mark.parametrize(
    ("target", "addon", "parts"),
    [
        pytest.param("ros1-bookworm-core", "onnx-cpu", ONNX, marks=pytest.mark.full(proof="examples")),
        pytest.param(
            "ros1-bookworm-core-torch-cu128",
            "onnx",
            ("grpc-cu128-py311", "onnxruntime-cc-cu128", "onnxruntime-cu128-py311"),
            marks=pytest.mark.full(proof="cuda"),
        ),
    ],
)
def test_object_detection(
    services: Services, published: Publish, tmp_path: Path, target: str, addon: str, parts: tuple[str, ...]
) -> None:
    """The tests pass for each backend of the image. The image's command starts the node, which hears the camera of the example."""
    image = published(target).reference
    build_parts(services, *parts)
    shutil.copytree(EXAMPLES / "object-detection", tmp_path / "detector")
    [starts] = re.findall(
        '--command "(.*roslaunch.*)"', (ROOT / "docs/examples/object-detection.md").read_text(), re.MULTILINE
    )
    options = {"base-image": image, "addons": addon, "image-name": f"{NAMESPACE}/detector", "command": starts}
    # Debian's own list has the other keys.
    result = build_app(tmp_path / "detector", options | {"target": "run", "rosdep-index": index(tmp_path, PYTEST)})
    assert result["packages"] == ["detector", "detector_cpp", "detector_msgs"]
    assert result["tests"]["count"] >= 10
    # Those of ROS 2: one for each backend. With one backend, there is nothing to compare.
    assert result["tests"]["skipped"] == 2
    assert list(Path(result["reports"]).rglob("gtest-*.xml")), "C++ has tests as well"
    heard = (
        "/tini -s -- /entrypoint.sh bash -c 'exec bash -c \"$DEFAULT_CMD\"' >/said 2>&1 & "
        "until grep -q 'ONNX Runtime .* on cpu' /said; do sleep 0.1; done; "
        "/entrypoint.sh rosrun detector camera & /entrypoint.sh rostopic echo -n 1 /boxes >/boxes; kill $(jobs -p); wait; "
        "grep 'ONNX Runtime' /said; test $(grep -c -E 'x1: (64|160).0|label: (0|1)' /boxes) = 4"
    )
    text = f"FROM {result['run']['reference']}\nRUN timeout 60 bash -c {shlex.quote(heard)}\n"
    build_file(services, tmp_path / "chk", text)


GENERATORS = (
    # A virtual environment lets pip install below that folder in the places that the other wheels there have.
    "--mount=type=bind,source=generators.txt,target=/generators.txt cd /opt/ros/jazzy && python3 -m venv --without-pip . && "
    "PIP_CONSTRAINT=/dev/null pip --python bin/python install --no-deps --require-hashes --only-binary :all: "
    "--requirement /generators.txt && rm bin/python* pyvenv.cfg && "
    "echo export CMAKE_PREFIX_PATH=/opt/ros/jazzy >>setup.sh && "
    "cd /opt && mkdir -p python/cp311-cp311/include python/cp311-cp311/lib/python3.11/site-packages/numpy/_core/include && "
    "ln -s /usr/include/python3.11 python/cp311-cp311/include/"
)
"""A step that installs what generates messages. The wheels name folders of the machine that made them; CMake wants them to exist."""


@pytest.mark.full(proof="wheels")
def test_object_detection_of_ros_2(services: Services, published: Publish, tmp_path: Path) -> None:
    """The node in Python: a test of the example hears its boxes. No wheel has rclcpp."""
    build_parts(services, *ONNX)
    image = joined(services, published("jazzy-wheels-core").reference, "onnx", *ONNX)
    image = base(services, image, "object-detection", GENERATORS)
    folder = tmp_path / "detector"
    shutil.copytree(EXAMPLES / "object-detection", folder, ignore=shutil.ignore_patterns("detector_cpp"))
    keys = ("ament_cmake", "rclpy", "rosidl_default_generators", "rosidl_default_runtime", "sensor_msgs", "std_msgs")
    rules = "".join(f"{key}: {{debian: []}}\n" for key in keys) + PYTEST
    options = {"base-image": image, "addons": "", "image-name": f"{NAMESPACE}/detector2", "target": "run"}
    result = build_app(folder, options | {"rosdep-index": index(tmp_path, rules)})
    assert result["packages"] == ["detector", "detector_msgs"]
    assert result["tests"]["count"] == 8 and result["tests"]["skipped"] == 1, "there is no second backend to compare"


@pytest.mark.full(proof="wheels")
def test_vscode(services: Services, ros2: str, tmp_path: Path) -> None:
    """The dev container's image, and what the editor does in it: it mounts the folder, builds, and runs its tasks."""
    folder = EXAMPLES / "vscode"
    container = json.loads((folder / ".devcontainer/devcontainer.json").read_text())
    tasks = json.loads((folder / ".vscode/tasks.json").read_text())["tasks"]
    shutil.copytree(folder, tmp_path, dirs_exist_ok=True)
    lines = [
        (folder / ".devcontainer/Dockerfile").read_text(),
        f"USER {container['remoteUser']}",
        "COPY --chown=dev . .",
    ]
    lines += [f"RUN {line}" for line in (container["postCreateCommand"], *(task["command"] for task in tasks))]
    output = build_file(services, tmp_path, "\n".join(lines) + "\n", "--build-arg", f"BASE_IMAGE={ros2}")
    assert "Summary: 1 test, 0 errors, 0 failures" in output


@pytest.mark.full(proof="wheels")
def test_jupyter(services: Services, ros2_tensorflow: str, tmp_path: Path) -> None:
    """A kernel of the image runs the notebook in the build; the server starts."""
    shutil.copytree(EXAMPLES / "jupyter", tmp_path, dirs_exist_ok=True)
    with (tmp_path / "Dockerfile").open("a") as file:
        file.write("RUN grep 'the nearest thing is 2.5 m away' /tmp/ran.ipynb\n")
        file.write(f"RUN {says('127.0.0.1:8888/lab', command('jupyter'))}\n")
    build(services, tmp_path, "--build-arg", f"BASE_IMAGE={ros2_tensorflow}")


DRIVER = {
    "package.xml": """<package format="3"><name>driver</name><version>1.0.0</version><description>A driver</description>
<maintainer email="nobody@example.org">nobody</maintainer><license>Proprietary</license>
<export><build_type>ament_python</build_type></export></package>
""",
    "setup.py": """from setuptools import setup
setup(name="driver", version="1.0.0", packages=["driver"], data_files=[
    ("share/ament_index/resource_index/packages", ["resource/driver"]), ("share/driver", ["package.xml"])])
""",
    "setup.cfg": "[install]\ninstall_scripts=$base/lib/driver\n",
    "resource/driver": "",
    "driver/__init__.py": "FASTEST = 1.5\n",
}
"""The package in a private repository that the example of CI asks for."""


@contextmanager
def private(folder: Path, password: str) -> Iterator[str]:
    """A server with a repository `driver.git`, for whoever has the password; gives its place, such as 127.0.0.1:1234."""
    source, served = write(folder / "driver", DRIVER), folder / "served"
    commit(source)
    git = ("git", "-C", str(served / "driver.git"))
    subprocess.run(["git", "clone", "--quiet", "--bare", str(source), str(served / "driver.git")], check=True)
    subprocess.run([*git, "branch", "--move", "--force", "main"], check=True)
    subprocess.run([*git, "update-server-info"], check=True)
    header = "Basic " + base64.b64encode(f"x-access-token:{password}".encode()).decode()

    class Server(http.server.SimpleHTTPRequestHandler):
        def __init__(self, *arguments: Any) -> None:
            super().__init__(*arguments, directory=str(served))

        def do_GET(self) -> None:
            if self.headers.get("Authorization") == header:
                super().do_GET()
                return
            self.send_response(401)
            self.send_header("WWW-Authenticate", 'Basic realm="private"')
            self.end_headers()

    with serving(Server) as address:
        yield address


def test_ci(services: Services, published: Publish, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The Dockerfile gets a package from a private repository, and nothing of the password stays; CI calls it this way."""
    files = [(EXAMPLES / "ci" / name).read_text() for name in (".github/workflows/image.yml", ".gitlab-ci.yml")]
    assert [re.findall(r"--secret (\S+) --build-arg BASE_IMAGE ", file) for file in files] == [["id=git,env=GIT"]] * 2
    password = secrets.token_hex()
    with private(tmp_path, password) as place:
        instead = f"git config --system url.http://{place}/.insteadOf https://github.com/me/"
        image = base(services, published("jazzy-wheels-core").reference, "ci", instead)
        monkeypatch.setenv("GIT", f"http://x-access-token:{password}@{place}")
        reach = ("--network", "host", "--allow", "network.host", "--secret", "id=git,env=GIT")
        check = f"test -e install/driver && ! grep -rsq {password} /docker-ros /root /etc /tmp /run"
        example(services, "ci", image, tmp_path, check, options=reach)


@pytest.mark.full(proof="desktop")
def test_rviz(services: Services, published: Publish, tmp_path: Path) -> None:
    """On a virtual display, which the image does not have; `rosml run` hands in a real one (test_windows.py)."""
    screen = "apt-get update && apt-get install --yes --no-install-recommends xvfb x11-utils"
    image = base(services, published("ros1-bookworm-desktop").reference, "rviz", screen)
    lines = [
        "export DISPLAY=:9 LIBGL_ALWAYS_SOFTWARE=1 QT_X11_NO_MITSHM=1; Xvfb :9 -screen 0 1024x768x24 -nolisten tcp &",
        f"/tini -s -- /entrypoint.sh {command('rviz')} >/said 2>&1 &",
        "for try in {1..600}; do if xwininfo -root -tree | grep -q 'scene.rviz.* - RViz'; then break; fi; sleep 0.1; done;",
        "timeout 20 /entrypoint.sh rostopic echo -n 1 /ball/header; cat /said; xwininfo -root -tree >/windows;",
        "kill $(jobs -p); wait; grep 'scene.rviz.* - RViz' /windows",
    ]
    output = example(services, "rviz", image, tmp_path, f"bash -c {shlex.quote(' '.join(lines))}")
    assert re.search(r'frame_id: "?map', output)


@pytest.mark.full(proof="includes")
def test_cuda(services: Services, published: Publish, tmp_path: Path) -> None:
    """A kernel is compiled beside the image's own CUDA, and the operator works; no GPU is there in a build."""
    image = base(services, published("ros1-bookworm-core-torch-cu130").reference, "cuda")
    example(services, "cuda", image, tmp_path, says("gray on cpu: right", command("cuda")))
