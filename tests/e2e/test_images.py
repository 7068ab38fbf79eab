"""Images, all the way from matrix.yaml to a tag in a registry, and what users do with them: with TensorFlow for the CPU in
`make test`, with PyTorch and CUDA in `make test-all`."""

from __future__ import annotations

import re
import shutil
import textwrap
from dataclasses import dataclass
from pathlib import Path

import pytest

from rosml import ROOT
from rosml.images.bake import bake_file
from rosml.images.builds import structure_tests
from rosml.images.image_set.labels import OCI
from rosml.images.image_set.model import ImageSet
from rosml.machine.services import Services
from tests import regctl
from tests.e2e.calls import NAMESPACE, publish, succeeds
from tests.e2e.images import NATIVE, PLATFORM, Publish, base_image, build_file, config, push_part, system
from tests.pages import blocks, commands

OCI_SET = {"title", "description", "version", "created", "licenses", "base.name", "base.digest"}
"""What an image says of itself, and its index repeats; `source` where matrix.yaml has one. tests/e2e/mini.py has them with
their values, and what a publishing run adds."""

SECOND_IMAGE_BYTES = 100_000_000


@dataclass(frozen=True)
class Pair:
    """Two images with the same parts.

    Attributes:
        first, second: targets. program: in Python, with the framework.
    """

    first: str
    second: str
    program: str


CPU = Pair(
    "ros1-bookworm-core-tensorflow-cpu",
    "ros1-bookworm-base-tensorflow-cpu",
    "import tensorflow as tf; assert tf.reduce_sum(tf.ones(3)).numpy() == 3; print(tf.__version__)",
)
CUDA = Pair(
    "ros1-bookworm-core-torch-cu128",
    "ros1-bookworm-base-torch-cu128",
    "import torch; assert (torch.ones(2) @ torch.ones(2)).item() == 2; print(torch.__version__)",
)


@pytest.fixture(
    scope="module", params=[CPU, pytest.param(CUDA, marks=pytest.mark.full(proof="cuda"))], ids=["cpu", "cuda"]
)
def pair(request: pytest.FixtureRequest) -> Pair:
    images: Pair = request.param
    return images


def test_an_image_is_built_tested_and_published(pair: Pair, published: Publish, services: Services) -> None:
    image = published(pair.first)
    assert image.result["failed"] == 0
    assert image.result["passed"] > 20
    for tag in image.result["tags"]:
        assert regctl.digest(services, tag) == image.result["digest"]
    index = regctl.manifest(services, image.result["reference"])
    assert [entry["digest"] for entry in index["manifests"]] == [image.result["manifest"]]
    assert index["manifests"][0]["platform"] == {"architecture": NATIVE, "os": "linux"}
    start = config(services, image.reference)
    assert structure_tests.expected_labels(image.image).items() <= start["Labels"].items()
    facts = {name: text for name, text in start["Labels"].items() if name.startswith(OCI)}
    assert {name.removeprefix(OCI) for name in facts} - {"source"} == OCI_SET
    assert facts.items() <= index["annotations"].items()
    assert start["Entrypoint"] == ["/tini", "--", "/entrypoint.sh"]
    if image.image.budget:
        parts = regctl.layers(services, image.reference)[-len(image.image.parts) :]
        assert sum(layer.size for layer in parts) <= image.image.budget * 1_000_000


def test_make_image(published: Publish, services: Services) -> None:
    """The front door, as it stands in the README; with a builder that has built the image before."""
    image = published("ros1-bookworm-core")
    done = succeeds("make", "image", "TARGET=ros1-bookworm-core")
    reference = f"{services.registry}/rosml/{image.image.tags[0]}"
    assert re.search(rf"^FROM +{re.escape(reference)}$", done.out, re.MULTILINE), done.out
    index = regctl.manifest(services, reference)
    assert [entry["digest"] for entry in index["manifests"]] == [image.result["manifest"]]


def test_a_second_call_changes_nothing(pair: Pair, published: Publish) -> None:
    first = published(pair.first)
    again = publish(pair.first)
    assert again.code == 0, again.err
    assert f'"digest": "{first.result["digest"]}"' in again.out
    assert '"moved": []' in again.out
    assert '"made": []' in again.out
    assert '"seconds": {}' in again.out, "nothing was tested once more"


@pytest.mark.full(proof="cuda")
def test_a_second_image_with_the_same_part_costs_next_to_nothing(pair: Pair, published: Publish) -> None:
    """No part is assembled or uploaded again; `make bench` says how many seconds that is."""
    first, second = published(pair.first), published(pair.second)
    assert second.part_layers == first.part_layers
    assert set(second.layers) - set(second.part_layers) != set(first.layers) - set(first.part_layers)
    assert second.result["uploaded"] < SECOND_IMAGE_BYTES
    assert not [target for target in second.result["made"] if target.startswith("part-")]


def test_nothing_runs_after_the_join(pair: Pair, published: Publish) -> None:
    """The image is the ROS image's layers and the parts' layers, and nothing else."""
    joined = published(pair.first)
    ros = published(joined.image.parent)
    assert joined.layers[: len(ros.layers)] == ros.layers
    assert len(joined.layers) == len(ros.layers) + len(joined.image.parts)


def test_parts_are_added_to_an_image_of_ones_own(
    pair: Pair, services: Services, published: Publish, image_set: ImageSet, tmp_path: Path
) -> None:
    """COPY --link, as the documentation shows it: a framework in a Debian image that has Python and nothing of ours."""
    image = published(pair.first)
    layers = [layer for name in image.image.parts for layer in push_part(services, image, image_set.part_by_name[name])]
    assert layers == image.part_layers, "the part as an image of its own is the same layer"
    shutil.copy(ROOT / "components/build/network.sh", tmp_path)
    page = ROOT / "docs/parts.md"
    (install,) = [command for block in blocks(page) for command in commands(block) if command.startswith("apt-get")]
    copies = [f"COPY --link --from={services.registry}/{NAMESPACE}/part:{name} / /" for name in image.image.parts]
    text = textwrap.dedent(f"""\
            FROM {system(services, image.image.os)}
            RUN --mount=type=bind,source=network.sh,target=/network.sh --mount=type=secret,id=ca-bundle \\
                bash -c '. /network.sh && apt-get update && {install}'
        """)
    build_file(services, tmp_path, "\n".join([f"{text}{copies[0]}", *copies[1:], f"RUN python3 -c '{pair.program}'\n"]))


def test_the_committed_bake_file_works_by_itself(services: Services, published: Publish) -> None:
    """`buildx bake -f … -f … <target>-test`, without our commands: as on a laptop, but for the base image's place."""
    image = published("ros1-bookworm-core")
    arguments = [*services.buildx, "bake", "--progress", "plain", "-f", bake_file.NAME, "-f", bake_file.TESTS]
    if services.ca_bundle:
        arguments += ["--allow", f"fs.read={services.ca_bundle}"]
    env = {
        **services.environment(),
        "OS_BOOKWORM": base_image(image),
        "CA_BUNDLE": services.ca_bundle,
        "PLATFORM": PLATFORM,
    }
    # Of when packages are, which the publisher tells the builder: so that what it built is taken from the cache.
    moment = ("--set", f"*.contexts.upstream={services.state / 'package-state/ros1-bookworm'}")
    succeeds(*arguments, *moment, "ros1-bookworm-core-test", env=env)


def test_a_user_builds_on_the_published_tag(pair: Pair, published: Publish, tmp_path: Path) -> None:
    """FROM, as the README shows it, with a ROS package; by the command that `rosml image` prints, in a shell that knows nothing
    of this machine's services. tests/e2e/test_documentation.py has C++."""
    image = published(pair.first)
    (tmp_path / "Dockerfile").write_text(
        textwrap.dedent(f"""\
            FROM {image.result["reference"]}
            RUN mkdir -p /ws/src && cd /ws/src && catkin_create_pkg example rospy std_msgs && \\
                cd /ws && catkin_make && . devel/setup.sh && rospack find example
        """)
    )
    unset = ("DOCKER_AUTH_CONFIG", "BUILDX_CONFIG", "BUILDX_BUILDER")
    succeeds("env", *(f"--unset={name}" for name in unset), "bash", "-c", image.result["builder"], cwd=tmp_path)
