"""ROS on an image of somebody else: what it has stays, the example is built, tested and started on it, and nothing is installed twice."""

from __future__ import annotations

import dataclasses
import json
import secrets
import shutil
from pathlib import Path

import pytest

from rosml import ROOT
from rosml.containerize import inputs as app_inputs
from rosml.containerize.build import step_order as apps
from rosml.machine.services import Services
from tests.e2e.app_builds import BASE, build_app, containerize, hears, stages_run
from tests.e2e.calls import LOG, NAMESPACE, publish
from tests.e2e.images import build, build_file, config, system

VENDOR = """FROM {0} AS vendor
RUN useradd --uid 1000 --create-home --groups sudo vendor && mkdir -p /root/.cache/pip /tmp/sdk && touch /root/.cache/model /root/.cache/pip/wheel /tmp/sdk/licence /var/log/sdk.log
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
"""


@pytest.fixture(scope="module")
def vendor(services: Services, tmp_path_factory: pytest.TempPathFactory) -> str:
    """The name of a repository with the images above, each under the tag of its name."""
    folder = tmp_path_factory.mktemp("vendor")
    (folder / "Dockerfile").write_text(VENDOR.format(system(services, "bookworm")))
    name = f"{services.registry}/{NAMESPACE}/vendor"
    for target in ("vendor", "half", "broken"):
        build(services, folder, "--target", target, "--output", f"type=image,name={name}:{target},push=true")
    return name


def test_what_an_image_has_stays(services: Services, beside: Services, vendor: str, tmp_path: Path) -> None:
    folder, name = tmp_path / "compass", f"{NAMESPACE}/adopted"
    shutil.copytree(ROOT / "examples/ros1", folder)
    cache = f"{services.registry}/{NAMESPACE}/adopted-cache"
    options = {"base-image": f"{vendor}:vendor", "image-name": name, "cache": cache, "target": "run"}
    result = build_app(folder, options)
    assert result["tests"]["count"] == 2 and not result["tests"]["failures"]
    starts = config(services, result["run"]["reference"])
    assert (starts["User"], starts["StopSignal"]) == ("vendor", "SIGTERM")
    assert starts["Entrypoint"] == ["/tini", "--", "/entrypoint.sh", "/usr/local/lib/rosml/entrypoint.sh"]
    assert {"SDK_HOME=/opt/sdk", "NVIDIA_DRIVER_CAPABILITIES=compute", "ROS_DISTRO=Debian"} <= {*starts["Env"]}
    assert {"PERL5OPT=-Mnone", "DPKG_ROOT=/none", "RUNTIME=vendor"} <= {*starts["Env"]}

    entrypoint = " ".join(["/tini -s --", *starts["Entrypoint"][2:]])
    build_file(
        services,
        tmp_path / "chk",
        f"""FROM {result["run"]["reference"]}
RUN {entrypoint} bash -c 'test "$SDK $(id -u) $(command -v rospack)" = "ready 1000 /usr/bin/rospack" && \\
      python3 -c "import rospy, sys; assert sys.executable == \\"/usr/local/lib/rosml/bin/python3\\", sys.executable"' && \\
    bash -lc 'python3 -c "import rospy"' && ! sudo -n true && \\
    python3 -m pip config list | grep -F "timeout='77'" && python3 -m pip config list | grep rosml/constraints && \\
    /usr/local/lib/rosml/entrypoint.sh /tini -s -- /entrypoint.sh bash -c 'test "$SDK" = ready && rospack find roscpp'
{hears(1, "/tmp/said", " ".join(starts["Entrypoint"][2:]))} && \\
    grep -E "east|north|west|south" /tmp/said
USER root
RUN test -e /root/.cache/model -a -e /root/.cache/pip/wheel -a -e /tmp/sdk/licence -a -e /var/log/sdk.log -a ! -e /var/log/dpkg.log && \\
    DOCKER_UID=1000 DOCKER_GID=1000 {entrypoint} bash -c 'test "$(id -un) $SDK" = "vendor ready"' && \\
    DOCKER_UID=1234 DOCKER_GID=1234 {entrypoint} sudo -n true
""",
    )

    source = folder / "src/compass/src/compass.cpp"
    source.write_text(source.read_text() + f"// {secrets.token_hex()}\n")
    fresh = dataclasses.replace(services, builder=beside.builder)
    again = apps.build_images(apps.new_call(folder, app_inputs.values(options, folder, {}), {}, fresh, LOG.info))
    assert again.tests.target.count == 2
    assert stages_run(services, name) == {"sources", "built", "tested", "app-files", "dev-files"}, (
        "ROS is not installed again"
    )


def test_a_base_of_it_alone(services: Services, vendor: str, tmp_path: Path) -> None:
    done = publish(BASE, "--on", f"{vendor}:vendor")
    assert done.code == 0, done.err
    reference = json.loads(done.out)["reference"]
    host, _, path = vendor.partition("/")
    assert reference == f"{host}/{NAMESPACE}/on/{path}:vendor-ros1-bookworm-core"
    labels = config(services, reference)["Labels"]
    assert labels["org.opencontainers.image.base.name"] == f"{vendor}:vendor" and labels["io.rosml.python"] == "3.11"
    assert "io.rosml.runtime" not in labels, "what runs on it is none of ours"
    again = publish(BASE, "--on", reference)
    assert again.code == 2 and "has ROS already: Debian" in again.err


@pytest.mark.parametrize(
    ("image", "says"),
    [
        ("half", "vendor:half has jazzy in /opt/ros, and does not say which ROS it is; add --ros-distro jazzy"),
        ("broken", "apt cannot read all of its sources, which the lines above name"),
    ],
)
def test_what_does_not_fit_is_named(image: str, says: str, vendor: str, tmp_path: Path) -> None:
    shutil.copytree(ROOT / "examples/ros1", tmp_path / "compass")
    options = {"base-image": f"{vendor}:{image}", "image-name": f"{NAMESPACE}/unfit"}
    outcome = containerize(tmp_path / "compass", options)
    assert outcome.code
    error = json.loads(outcome.out)
    assert says in f"{error['error']}; {error['remedy']}"
