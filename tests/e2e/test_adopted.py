"""ROS on an image of somebody else: what it has stays, the example is built, tested and started on it, and nothing is installed twice."""

from __future__ import annotations

import dataclasses
import json
import secrets
import shutil
import sys
from pathlib import Path

import pytest

from rosml import ROOT
from rosml.containerize import inputs as app_inputs
from rosml.containerize.build import step_order as build
from rosml.images.builds import base_images
from rosml.images.image_set import load
from rosml.machine.services import Services
from tests.e2e.conftest import NAMESPACE, run
from tests.e2e.images import build as build_folder
from tests.e2e.test_containerize import config, containerize, made, ran

HERE = base_images.native_architecture()

VENDOR = """FROM {0} AS vendor
RUN useradd --uid 1000 --create-home --groups sudo vendor && mkdir -p /root/.cache /tmp/sdk && touch /root/.cache/model /tmp/sdk/licence /var/log/sdk.log
# A Python before the system's: whoever starts it fails.
RUN printf '#!/bin/sh\\necho "the other Python was started" >&2; exit 3\\n' >/usr/local/bin/python3 && chmod 755 /usr/local/bin/python3 && \\
    printf '[global]\\ntimeout = 77\\n' >/etc/pip.conf && \\
    printf '#!/bin/sh\\nexport SDK=ready\\nexec "$@"\\n' >/entrypoint.sh && chmod 755 /entrypoint.sh
# The last ones would stop apt, and leave out what compilers need.
ENV SDK_HOME=/opt/sdk NVIDIA_DRIVER_CAPABILITIES=compute PERL5OPT=-Mnone DPKG_ROOT=/none RUNTIME=vendor
USER vendor
STOPSIGNAL SIGQUIT
ENTRYPOINT ["/entrypoint.sh"]
CMD ["serve"]

FROM {0} AS half
RUN mkdir -p /opt/ros/jazzy && touch /opt/ros/jazzy/setup.bash

FROM {0} AS broken
RUN echo 'deb [trusted=yes] http://127.0.0.1:1/sdk stable main' >/etc/apt/sources.list.d/sdk.list

FROM {0} AS bare
RUN rm -r /etc/apt/sources.list*

FROM scratch AS small
COPY Dockerfile /
"""


def debian(services: Services) -> str:
    """Debian's image, as somebody names it who has never heard of ours."""
    systems = load.load(ROOT / "matrix.yaml").matrix.operating_systems
    return base_images.reference(services, systems, "bookworm", HERE)


@pytest.fixture(scope="module")
def vendor(services: Services, tmp_path_factory: pytest.TempPathFactory) -> str:
    """The name of a repository with the images above, each under the tag of its name."""
    folder = tmp_path_factory.mktemp("vendor")
    (folder / "Dockerfile").write_text(VENDOR.format(debian(services)))
    name = f"{services.registry}/{NAMESPACE}/vendor"
    for target in ("vendor", "half", "broken", "bare", "small"):
        build_folder(services, folder, "--target", target, "--output", f"type=image,name={name}:{target},push=true")
    return name


def test_what_an_image_has_stays(services: Services, beside: Services, vendor: str, tmp_path: Path) -> None:
    folder, name = tmp_path / "compass", f"{NAMESPACE}/adopted"
    shutil.copytree(ROOT / "examples/ros1", folder)
    cache = f"{services.registry}/{NAMESPACE}/adopted-cache"
    options = {"base-image": f"{vendor}:vendor", "image-name": name, "cache": cache, "target": "run"}
    found = made(folder, *(word for key, value in options.items() for word in (f"--{key}", value)))
    assert found["tests"]["count"] == 2 and not found["tests"]["failures"]
    starts = config(services, found["run"]["reference"])["config"]
    assert (starts["User"], starts["StopSignal"]) == ("vendor", "SIGTERM")
    assert starts["Entrypoint"] == ["/tini", "--", "/entrypoint.sh", "/usr/local/lib/rosml/entrypoint.sh"]
    assert {"SDK_HOME=/opt/sdk", "NVIDIA_DRIVER_CAPABILITIES=compute", "ROS_DISTRO=Debian"} <= {*starts["Env"]}
    assert {"PERL5OPT=-Mnone", "DPKG_ROOT=/none", "RUNTIME=vendor"} <= {*starts["Env"]}

    (tmp_path / "chk").mkdir()
    entrypoint = " ".join(["/tini -s --", *starts["Entrypoint"][2:]])
    (tmp_path / "chk/Dockerfile").write_text(
        f"""FROM {found["run"]["reference"]}
RUN {entrypoint} bash -c 'test "$SDK $(id -u) $(command -v rospack)" = "ready 1000 /usr/bin/rospack" && \\
      python3 -c "import rospy, sys; assert sys.executable == \\"/usr/local/lib/rosml/bin/python3\\", sys.executable"' && \\
    bash -lc 'python3 -c "import rospy"' && ! sudo -n true && \\
    python3 -m pip config list | grep -F "timeout='77'" && python3 -m pip config list | grep rosml/constraints && \\
    /usr/local/lib/rosml/entrypoint.sh /tini -s -- /entrypoint.sh bash -c 'test "$SDK" = ready && rospack find roscpp'
RUN bash -c '(timeout 20 {entrypoint} bash -c "exec bash -c \\"$DEFAULT_CMD\\"" & \\
      for try in {{1..200}}; do /entrypoint.sh timeout 5 rostopic echo -n 1 /direction && break; done >/tmp/said; wait) 2>&1' && \\
    grep -E "east|north|west|south" /tmp/said
USER root
RUN test -e /root/.cache/model -a -e /tmp/sdk/licence -a -e /var/log/sdk.log -a ! -e /var/log/dpkg.log && \\
    DOCKER_UID=1000 DOCKER_GID=1000 {entrypoint} bash -c 'test "$(id -un) $SDK" = "vendor ready"' && \\
    DOCKER_UID=1234 DOCKER_GID=1234 {entrypoint} sudo -n true
"""
    )
    build_folder(services, tmp_path / "chk")

    source = folder / "src/compass/src/compass.cpp"
    source.write_text(source.read_text() + f"// {secrets.token_hex()}\n")
    said: list[str] = []
    fresh = dataclasses.replace(services, builder=beside.builder)
    again = build.build_images(build.new_call(folder, app_inputs.values(options, folder, {}), {}, fresh, said.append))
    assert again.tests.target.count == 2
    assert ran(services, name) == {"sources", "built", "tested", "app-files"}, "ROS is not installed again"


def test_a_base_of_it_alone(services: Services, vendor: str, tmp_path: Path) -> None:
    command = (
        sys.executable,
        str(ROOT / "src"),
        "image",
        "ros1-bookworm-core",
        "--namespace",
        NAMESPACE,
        "--json",
        "--on",
    )
    done = run(*command, f"{vendor}:vendor")
    assert done.code == 0, done.err
    made = json.loads(done.out)
    host, _, path = vendor.partition("/")
    assert made["reference"] == f"{host}/{NAMESPACE}/on/{path}:vendor-ros1-bookworm-core"
    labels = config(services, made["reference"])["config"]["Labels"]
    assert labels["org.opencontainers.image.base.name"] == f"{vendor}:vendor" and labels["io.rosml.python"] == "3.11"
    assert "io.rosml.runtime" not in labels, "what runs on it is none of ours"
    again = run(*command, made["reference"])
    assert again.code == 2 and "has ROS already: Debian" in again.err


@pytest.mark.parametrize(
    ("image", "options", "says"),
    [
        ("small", (), "vendor:small has no apt-get and no bash, so ROS cannot be installed on it"),
        ("bare", (), "vendor:bare has no source for apt, so ROS cannot be installed on it"),
        ("half", (), "vendor:half has jazzy in /opt/ros, and does not say which ROS it is; add --ros-distro jazzy"),
        ("vendor", ("--ros-distro", "humble"), "which has ros1-bookworm; humble stands on ubuntu:22.04"),
        ("broken", (), "apt cannot read all of its sources, which the lines above name"),
    ],
)
def test_what_does_not_fit_is_named(
    image: str, options: tuple[str, ...], says: str, vendor: str, services: Services, tmp_path: Path
) -> None:
    shutil.copytree(ROOT / "examples/ros1", tmp_path / "compass")
    name = ("--image-name", f"{NAMESPACE}/unfit")
    outcome = containerize(tmp_path / "compass", "--base-image", f"{vendor}:{image}", *name, *options)
    assert outcome.code
    error = json.loads(outcome.out)
    assert says in f"{error['error']}; {error['remedy']}"
