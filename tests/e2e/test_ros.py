"""ROS images: the same layers from the same packages, and what users build on them."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

import pytest

from offline import debian
from rosml import ROOT
from rosml.images.builds import push, structure_tests
from rosml.images.builds.variables import sync_dates, variables
from rosml.images.image_set.model import ImageSet
from rosml.machine import buildx
from rosml.machine.services import Services
from tests.e2e.calls import NAMESPACE
from tests.e2e.images import NATIVE, BuildOn, Publish, build, layers


@pytest.mark.full(proof="rebuild")
@pytest.mark.parametrize("target", ["ros1-bookworm-core"])
def test_the_same_packages_give_the_same_layers(
    target: str, published: Publish, services: Services, image_set: ImageSet
) -> None:
    """Another build without any cache: every layer of every component, from the base image on."""
    image = published(target)
    prefix = f"{services.registry}/{NAMESPACE}"
    values = variables(services, image_set, image.image, NATIVE, prefix)
    values |= sync_dates(services, image_set, image.image.distribution, print)
    bake_file = push.write_excerpt(services, image_set, target)
    call = buildx.Bake(target, f"again-{target}", bake_file, (f"{target}.tags=", "*.no-cache=true"), values)
    repository = f"{prefix}/again"
    manifest = push.push(services, push.Push(call, repository))
    assert layers(services, f"{repository}@{manifest}") == image.layers
    assert manifest == image.result["manifest"]


def test_one_more_package_from_the_images_own_apt_source(build_on: BuildOn) -> None:
    """And it works with what is there: a transform is published and heard."""
    talk = (
        "timeout 120 /entrypoint.sh bash -c 'roscore >/dev/null 2>&1 & "
        "for _ in {1..100}; do if rostopic list >/dev/null 2>&1; then break; fi; sleep 0.2; done; "
        "rosrun tf2_ros static_transform_publisher 1 2 3 0 0 0 1 base camera >/dev/null 2>&1 & "
        "timeout 60 rostopic echo -n 1 /tf_static'"
    )
    output = build_on("ros1-bookworm-core", ["install-packages tf2-tools", talk])
    assert 'child_frame_id: "camera"' in output


@pytest.mark.full(proof="desktop")
@pytest.mark.parametrize("target", ["ros1-bookworm-desktop", "ros1-trixie-desktop"])
def test_windows_open(build_on: BuildOn, target: str) -> None:
    """rviz and a program of Qt's on a virtual display, which no image has: the structure tests have no network."""
    steps = ["install-packages xvfb x11-utils", "timeout --kill-after=10 400 /entrypoint.sh /desktop/run.sh"]
    output = build_on(target, steps, "desktop")
    windows = re.findall('window: "(.*)":', output)
    assert "RViz" in windows[0] and len(windows) > 1, output


def test_a_containerizers_flow(services: Services, published: Publish, tmp_path: Path) -> None:
    """dependencies, install, dev, build, run, as docker-ros does it."""
    image = published("ros1-bookworm-core")
    shutil.copytree(Path(__file__).parent / "docker_ros", tmp_path, dirs_exist_ok=True)
    shutil.copytree(ROOT / "tests/structure/programs/workspace/src", tmp_path / "src")
    shutil.copy(ROOT / "components/build/network.sh", tmp_path)
    package = tmp_path / "src/example/package.xml"
    package.write_text(package.read_text().replace("</package>", "  <depend>a-key-of-ours</depend>\n</package>"))
    sources = tmp_path / "rosdep" / "sources"
    sources.mkdir(parents=True)
    (sources / "20-default.list").write_text("yaml file:///rosdep/base.yaml\n")
    (tmp_path / "rosdep/base.yaml").write_text("a-key-of-ours:\n  debian: [python3-tabulate]\n")
    (tmp_path / "rosdep/index.yaml").write_text("%YAML 1.1\n---\ndistributions: {}\ntype: index\nversion: 4\n")
    output = build(services, tmp_path, "--build-arg", f"BASE_IMAGE={image.result['reference']}")
    assert "score: python" in output and "score: c++" in output


@pytest.mark.full(proof="wheels")
def test_ros_2_from_wheels_is_a_row_of_its_own(published: Publish) -> None:
    """rclpy talks under the entrypoint, as root and as a user: its structure tests say so."""
    image = published("jazzy-wheels-core")
    report = structure_tests.read_report(ROOT / ".state" / "tests" / image.image.target / "report", ("ros2-wheels",))
    assert [outcome.name for outcome in report.outcomes if outcome.passed and "talk" in outcome.name]


@pytest.mark.full(proof="rebuild")
def test_a_base_image_is_the_same_wherever_it_is_made(services: Services, tmp_path: Path) -> None:
    """Also in a folder that no other user may enter, where mmdebstrap gives apt's user nothing."""
    if not services.bases:
        pytest.skip("Docker Hub answers: its base images are used")
    suite = "bookworm"
    closed = tmp_path / "closed"
    closed.mkdir(mode=0o700)
    elsewhere = debian.make(services, suite, NATIVE, closed / "made", tag="elsewhere")
    place = f"{services.registry}/library/debian"
    here = debian.find(services, suite, NATIVE)
    assert here, "the tests before have made it"
    assert layers(services, f"{place}@{elsewhere}") == layers(services, f"{place}@{here}")
