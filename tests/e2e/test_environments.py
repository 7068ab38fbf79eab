"""An environment of Python packages goes onto real images, and ROS's own Python stays what it was."""

from __future__ import annotations

import json
import os
import re
import shutil
from pathlib import Path
from typing import Any

import pytest

from rosml.images.builds import contents
from rosml.images.image_set.model import ImageSet
from rosml.images.join.file_lists import Lists
from rosml.images.join.layers import platform
from rosml.images.scan import attached, cyclonedx
from rosml.machine.services import Services
from rosml.registry.client import Registry
from tests.e2e.app_builds import BASE, build_app, package
from tests.e2e.calls import LOG, NAMESPACE, rosml
from tests.e2e.images import PLATFORM, Publish, build_file, config, layers

BYTES = 20_000
"""What joining an image may upload, for each platform a manifest and a config with all its history."""

POLICIES = Path(__file__).parent / "policies"

PROGRAM = """\
import gymnasium, numpy, rospy, sys
from sensor_msgs.msg import Image, JointState

assert int(numpy.__version__.partition(".")[0]) == {numpy}, numpy
values = numpy.array([0.5, 1.5])
message = JointState(name=["a", "b"], position=values, velocity=values, effort=values)
message.header.stamp = rospy.Time(1)
import io
raw = io.BytesIO()
message.serialize_numpy(raw, numpy)
again = JointState().deserialize_numpy(raw.getvalue(), numpy)
assert again.position.tolist() == [0.5, 1.5] and sys.prefix == "{prefix}", sys.prefix
print("both:", gymnasium.__name__, numpy.__version__)
"""


@pytest.fixture(scope="module")
def policy(
    services: Services, published: Publish, image_set: ImageSet, tmp_path_factory: pytest.TempPathFactory
) -> dict[str, Any]:
    """What the second build of an environment reported; its ROS image has a list of files."""
    ros, folder = published(BASE), tmp_path_factory.mktemp("environments")
    client = Registry(services.registry)
    contents.attach(services, image_set, client, [(f"{NAMESPACE}/ros", ros.result["manifest"])], LOG.info)
    options = ("--folder", str(folder))
    path = {"PATH": f"{Path(services.uv).parent}:{os.environ['PATH']}"}
    output = rosml("env", "add", "policy", "numpy>=2,<2.3", "gymnasium", "--image", BASE, *options, env=path).out
    assert "amd64.txt: " in output and "arm64.txt: " in output and " to download" in output
    call = ("env", "build", "policy", *options, "--namespace", NAMESPACE, "--json")
    [built] = json.loads(rosml(*call).out)
    again: dict[str, Any]
    [again] = json.loads(rosml(*call).out)
    assert again["digest"] == built["digest"]
    return again


def test_another_numpy_beside_ros(services: Services, policy: dict[str, Any], tmp_path: Path) -> None:
    """In one process with rospy; its layer is below its own prefix, and a second image costs only manifests."""
    place, client = f"{services.registry}/{NAMESPACE}", Registry(services.registry)

    for manifest in contents.manifests(client, f"{NAMESPACE}/env", policy["digest"]):
        files = Lists().of(client, f"{NAMESPACE}/env", manifest.digest)
        assert files and {path for path in files.entries if not path.startswith("opt/env/policy/")} == set()
        assert any(path.endswith("/numpy/__pycache__/__init__.cpython-311.pyc") for path in files.entries)

    environment = policy["reference"].partition("@")[0]
    for tag, name in {"first": environment, "second": "env:policy"}.items():
        joined = rosml("join", f"{place}/ros:{BASE}", name, "--tag", f"{place}/with-env:{tag}", "--json")
        report = json.loads(joined.out)
        assert report["uploaded"] < BYTES and report["copied"] == 0, report
        (sbom,) = attached.read(client, f"{NAMESPACE}/with-env", report["manifests"][PLATFORM]).sboms
        parts = {component["name"]: cyclonedx.part(component) for component in sbom.components}
        assert parts["gymnasium"] == parts["numpy"] == "env:policy-py311" and parts["bash"] == BASE
    programs = {
        "env.py": PROGRAM.format(numpy=2, prefix="/opt/env/policy"),
        "ros.py": "import importlib.util, rospy; assert not importlib.util.find_spec('numpy'); print('ROS is as it was')",
    }
    for name, text in programs.items():
        (tmp_path / name).write_text(text)
    output = build_file(
        services,
        tmp_path,
        f"FROM {place}/with-env:second\nCOPY *.py /\n"
        "RUN /entrypoint.sh python3 /ros.py\n"
        "RUN /entrypoint.sh /opt/env/policy/bin/python /env.py\n"
        "RUN /entrypoint.sh bash -c 'source /opt/env/policy/bin/activate && python /env.py && deactivate && python3 /ros.py'\n",
    )
    assert output.count("both: gymnasium 2.") == 2 and output.count("ROS is as it was") == 2


NODE = """#!/opt/env/policy/bin/python
import gymnasium, numpy, rospy
from sensor_msgs.msg import JointState
assert numpy.__version__.startswith("2."), numpy
print("acts with", gymnasium.__name__, JointState(name=["a"]).name)
"""
INSTALL = "install(PROGRAMS act DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})\n"


@pytest.mark.full(proof="environments")
def test_apps_with_an_environment(
    services: Services, published: Publish, policy: dict[str, Any], tmp_path: Path
) -> None:
    """Two apps share its layers, the lock file has its digest, and it stays in a rebase."""
    place, client, apps = f"{services.registry}/{NAMESPACE}", Registry(services.registry), {}
    images = contents.manifests(client, f"{NAMESPACE}/env", policy["digest"])
    by_platform = {platform(client.config(f"{NAMESPACE}/env", image).facts): image for image in images}
    of_environment = [layer.digest for layer in by_platform[PLATFORM].layers]
    options = {"base-image": published(BASE).reference, "env": "policy", "target": "run", "push": "true"}
    for name in ("grasp", "walk"):
        folder = package(tmp_path / name, lines=INSTALL, files={"act": NODE})
        image = {"image-name": f"{place}/{name}", "command": f"rosrun {name} act"}
        apps[name] = build_app(folder, {**options, **image}, "--lock")
        assert config(services, f"{place}/{name}:latest")["Labels"]["io.rosml.environments"] == "policy"
        assert layers(services, f"{place}/{name}:latest")[-1 - len(of_environment) : -1] == of_environment
        lock = json.loads((folder / "containerize.lock").read_text())
        assert lock["addons"] == {f"{place}/env:policy-py311": policy["digest"]}
    again = build_app(tmp_path / "walk", {**options, **image})
    assert again["run"]["digest"] == apps["walk"]["run"]["digest"], "from the lock file, the same"

    onto = ("--base", f"{place}/ros:{BASE}", "--tag", f"{place}/grasp:moved")
    report = json.loads(rosml("rebase", f"{place}/grasp:latest", *onto, "--json").out)
    assert report["copied"] == 0
    assert layers(services, f"{place}/grasp:moved") == layers(services, f"{place}/grasp:latest")
    output = build_file(services, tmp_path / "run", f"FROM {place}/grasp:moved\nRUN /entrypoint.sh rosrun grasp act\n")
    assert "acts with gymnasium ['a']" in output


@pytest.mark.full(proof="environments")
def test_messages_of_ros_2_with_both_numpys(
    services: Services, published: Publish, policy: dict[str, Any], tmp_path: Path
) -> None:
    ros, image = published("jazzy-wheels-core").reference, f"{services.registry}/{NAMESPACE}/with-env:ros2"
    rosml("join", ros, policy["reference"].partition("@")[0], "--tag", image)
    steps = [f"RUN /entrypoint.sh {python} /messages.py" for python in ("python3", "/opt/env/policy/bin/python")]
    shutil.copy(POLICIES / "messages.py", tmp_path)
    output = build_file(services, tmp_path, "\n".join([f"FROM {image}", "COPY messages.py /", *steps, ""]))
    versions = re.findall(r"messages: \d+ types, \d+ with arrays, numpy (\d)", output)
    assert versions == ["1", "2"]


@pytest.mark.full(proof="environments")
@pytest.mark.usefixtures("policy")  # it gives the ROS image a list of files
def test_pictures_with_both_numpys(services: Services, published: Publish, tmp_path: Path) -> None:
    """The cv_bridge of bookworm converts them in ROS's Python; the environment's OpenCV does it alike."""
    place, options = f"{services.registry}/{NAMESPACE}", ("--folder", str(tmp_path / "environments"))
    path = {"PATH": f"{Path(services.uv).parent}:{os.environ['PATH']}"}
    packages = ("numpy>=2,<2.3", "opencv-python-headless")
    rosml("env", "add", "vision", *packages, "--image", BASE, *options, env=path)
    rosml("env", "build", "vision", *options, "--namespace", NAMESPACE)
    rosml("join", published(BASE).reference, f"{place}/env:vision-py311", "--tag", f"{place}/with-env:vision")
    shutil.copy(POLICIES / "pictures.py", tmp_path)
    output = build_file(
        services,
        tmp_path,
        f"FROM {place}/with-env:vision\nCOPY pictures.py /\n"
        "RUN apt-get update && apt-get install -y --no-install-recommends python3-cv-bridge python3-opencv\n"
        "RUN /entrypoint.sh python3 /pictures.py write /pictures.npz\n"
        "RUN /entrypoint.sh /opt/env/vision/bin/python /pictures.py compare /pictures.npz\n",
    )
    converted = re.findall(r"pictures: (2209 pairs, \d+ converted), numpy (\d)", output)
    assert [numpy for _, numpy in converted] == ["1", "2"] and len({same for same, _ in converted}) == 1


@pytest.mark.full(proof="cuda")
def test_lerobot(published: Publish) -> None:
    """As it is built each night: ACT and diffusion act in it. Its layer is the last one."""
    with_it = published("ros1-bookworm-core-torch-cu128-env-lerobot")
    assert with_it.layers[:-1] == published("ros1-bookworm-core-torch-cu128").layers
    config_labels = config(with_it.services, with_it.reference)["Labels"]
    assert config_labels["io.rosml.environments"] == "lerobot"


@pytest.mark.full(proof="cuda")
def test_policies(services: Services, published: Publish, tmp_path: Path) -> None:
    """Each in one process with messages of ROS. They take PyTorch and numpy of the image."""
    target, image = "ros1-bookworm-core-torch-cu128", f"{services.registry}/{NAMESPACE}/with-env:policies"
    reference = published(target).reference
    packages = ("stable-baselines3", "jax", "onnxruntime", "onnx", "diffusers", "transformers")
    options = ("--folder", str(tmp_path / "environments"))
    path = {"PATH": f"{Path(services.uv).parent}:{os.environ['PATH']}"}
    rosml("env", "add", "policies", *packages, "--image", target, *options, env=path)
    [built] = json.loads(rosml("env", "build", "policies", *options, "--namespace", NAMESPACE, "--json").out)
    rosml("join", reference, built["reference"].partition("@")[0], "--tag", image)
    shutil.copytree(POLICIES, tmp_path / "policies")
    programs = ("stable_baselines", "in_jax", "in_onnx", "in_diffusers")
    steps = [f"RUN --network=none /entrypoint.sh /opt/env/policies/bin/python /policies/{name}.py" for name in programs]
    output = build_file(services, tmp_path, "\n".join([f"FROM {image}", "COPY policies /policies", *steps, ""]))
    acting = re.findall(r"acts: (\S+) \S+ with numpy 1\S+ in /opt/env/policies", output)
    assert acting == ["stable-baselines3", "jax", "onnxruntime", "diffusers"]
