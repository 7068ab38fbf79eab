"""An environment of Python packages goes onto real images, and ROS's own Python stays what it was."""

from __future__ import annotations

import json
import os
from pathlib import Path

from rosml.images.builds import contents
from rosml.images.image_set.model import ImageSet
from rosml.images.join.file_lists import Lists
from rosml.machine.services import Services
from rosml.registry.client import Registry
from tests.e2e.calls import LOG, NAMESPACE, rosml
from tests.e2e.images import Publish, build_file

BYTES = 20_000
"""What joining an image may upload, for each platform a manifest and a config with all its history."""

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


def test_another_numpy_beside_ros(services: Services, published: Publish, image_set: ImageSet, tmp_path: Path) -> None:
    """In one process with rospy; its layer is below its own prefix, and a second image costs only manifests."""
    ros, place = published("ros1-bookworm-core"), f"{services.registry}/{NAMESPACE}"
    client = Registry(services.registry)
    contents.attach(services, image_set, client, [(f"{NAMESPACE}/ros", ros.result["manifest"])], LOG.info)
    options = ("--folder", str(tmp_path / "environments"))
    path = {"PATH": f"{Path(services.uv).parent}:{os.environ['PATH']}"}
    output = rosml(
        "env", "add", "policy", "numpy>=2,<2.3", "gymnasium", "--image", "ros1-bookworm-core", *options, env=path
    ).out
    assert "amd64.txt: " in output and "arm64.txt: " in output and " to download" in output
    built = json.loads(rosml("env", "build", "policy", *options, "--namespace", NAMESPACE, "--json").out)
    again = json.loads(rosml("env", "build", "policy", *options, "--namespace", NAMESPACE, "--json").out)
    assert again["digest"] == built["digest"]

    for manifest in contents.manifests(client, f"{NAMESPACE}/env", built["digest"]):
        files = Lists().of(client, f"{NAMESPACE}/env", manifest.digest)
        assert files and {path for path in files.entries if not path.startswith("opt/env/policy/")} == set()
        assert any(path.endswith("/numpy/__pycache__/__init__.cpython-311.pyc") for path in files.entries)

    environment = built["reference"].partition("@")[0]
    for tag in ("first", "second"):
        joined = rosml(
            "join", f"{place}/ros:ros1-bookworm-core", environment, "--tag", f"{place}/with-env:{tag}", "--json"
        )
        report = json.loads(joined.out)
        assert report["uploaded"] < BYTES and report["copied"] == 0, report
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
