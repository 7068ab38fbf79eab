"""Images, all the way from matrix.yaml to a tag in a registry, and what users do with them."""

from __future__ import annotations

import os
import shutil
import textwrap
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

from rosml import ROOT, base_images, builder, names, registry, verify
from rosml.expand import Catalogue, Payload
from rosml.labels import OCI
from rosml.progress import WAITING
from rosml.publish import COMPRESSION
from rosml.services import Services
from tests.e2e.conftest import NAMESPACE, Published, publish, run

Publish = Callable[[str], Published]

PLATFORM = f"linux/{base_images.native_architecture()}"
FIRST = "bookworm-core-torch-cu128"
SECOND = "bookworm-base-torch-cu128"
PAYLOAD_PARTS = 3
"""cuda, common, torch."""

SECOND_IMAGE_SECONDS = 20.0
"""What building, testing and tagging a second image with the same payload may take beyond the ROS packages, on an idle
machine."""

BESIDE = 4.0
"""How much longer it may take here, where other tests compute beside it. To assemble the payload anew takes fifteen times
as long; that no step of it ran is asserted by itself."""

OCI_SET = {"title", "description", "version", "created", "licenses", "base.name", "base.digest"}
"""What an image says of itself, and its index repeats; `source` where matrix.yaml has one. tests/e2e/mini.py has them with
their values, and what a publishing run adds."""

SECOND_IMAGE_BYTES = 100_000_000


def test_an_image_is_built_tested_and_published(published: Publish, services: Services) -> None:
    image = published(FIRST)
    assert image.result["failed"] == 0
    assert image.result["passed"] > 20
    for tag in image.result["tags"]:
        assert registry.digest(services, tag) == image.result["digest"]
    index = registry.manifest(services, image.result["reference"])
    assert [entry["digest"] for entry in index["manifests"]] == [image.result["manifest"]]
    assert index["manifests"][0]["platform"] == {"architecture": "amd64", "os": "linux"}
    config = registry.image_config(services, image.reference, "linux/amd64")["config"]
    assert verify.expected_labels(image.image).items() <= config["Labels"].items()
    said = {name: text for name, text in config["Labels"].items() if name.startswith(OCI)}
    assert {name.removeprefix(OCI) for name in said} - {"source"} == OCI_SET
    assert index["annotations"] == said
    assert config["Entrypoint"] == ["/tini", "--", "/entrypoint.sh"]


def test_a_second_call_changes_nothing(published: Publish) -> None:
    first = published(FIRST)
    again = publish(FIRST)
    assert again.code == 0, again.err
    assert f'"digest": "{first.result["digest"]}"' in again.out
    assert '"moved": []' in again.out
    assert "structure tests (same image, same tests)" in again.out


def test_a_second_image_with_the_same_payload_costs_next_to_nothing(published: Publish) -> None:
    first, second = published(FIRST), published(SECOND)
    assert second.layers[-PAYLOAD_PARTS:] == first.layers[-PAYLOAD_PARTS:]
    assert second.layers[:-PAYLOAD_PARTS] != first.layers[:-PAYLOAD_PARTS]
    assert second.result["uploaded"] < SECOND_IMAGE_BYTES
    assert "assemble payloads" not in second.result["work"]
    assert seconds_beyond_ros(second) <= SECOND_IMAGE_SECONDS * BESIDE, second.result["work"]


def seconds_beyond_ros(image: Published) -> float:
    """Wall time of building, testing and tagging, without the installation of the ROS packages and the other lane's turns."""
    without = sum(image.result["work"].get(phase, 0.0) for phase in ("install ROS packages", WAITING))
    return float(sum(image.result["seconds"].values()) - without)


def test_nothing_runs_after_the_join(published: Publish, catalogue: Catalogue) -> None:
    """The image is the ROS image's layers and the payloads' layers, and nothing else."""
    joined = published(FIRST)
    ros = published(joined.image.parent)
    assert joined.layers[: len(ros.layers)] == ros.layers
    assert len(joined.layers) == len(ros.layers) + len(joined.image.parts)


BOTH = os.environ.get("ROSML_TEST_BOTH", "bookworm-perception-ml-cu128")
"""An image with cv_bridge and both frameworks; another one takes minutes more: ROSML_TEST_BOTH=trixie-perception-ml-cu128."""

TALK_SECONDS = 600
"""Longest that two processes may talk, for all orders of imports; 90 seconds are usual."""


def test_both_frameworks_share_their_layers_and_import_in_either_order(published: Publish) -> None:
    both = published(BOTH)
    torch = published(names.image_target(both.image.distribution, "core", "torch", both.image.stack))
    more = len(both.image.parts) - PAYLOAD_PARTS
    assert both.layers[-PAYLOAD_PARTS - more : -more] == torch.layers[-PAYLOAD_PARTS:]
    report = verify.read_report(ROOT / ".state" / "tests" / both.image.target / "report", ("ml", "ros1-perception"))
    assert {outcome.name for outcome in report.outcomes if outcome.passed} >= {
        "import torch, then tensorflow",
        "import tensorflow, then torch",
        "one process with ROS, numpy, cv_bridge, cv2 and the frameworks, whichever is imported first",
    }


def test_images_with_less_have_the_same_layers(services: Services, published: Publish, catalogue: Catalogue) -> None:
    """Of CUDA alone and of TensorFlow alone, as in the image with both frameworks: built here and not tested, as all that
    they hold was."""
    both = published(BOTH)
    parts = dict(zip(both.image.parts, both.layers[-len(both.image.parts) :], strict=True))
    prefix = f"{services.registry}/{NAMESPACE}-layers"
    for framework in ("cuda", "tensorflow"):
        target = names.image_target(both.image.distribution, both.image.component, framework, both.image.stack)
        image = catalogue.image(target)
        push(services, both, target, prefix)
        layers = [layer.digest for layer in registry.layers(services, f"{prefix}/{image.tags[0]}")]
        assert layers == [*both.layers[: -len(parts)], *(parts[name] for name in image.parts)], target


def build(services: Services, folder: Path, *options: str) -> str:
    """Builds a folder's Dockerfile as a user would; returns what the builder said: of every step, because what another run or
    another test left in the cache says nothing."""
    if not any(option.startswith("--no-cache") for option in options):
        options = ("--no-cache", *options)
    secret = ["--secret", f"id=ca-bundle,src={services.ca_bundle}"] if services.ca_bundle else []
    command = [*services.buildx, "build", "--progress", "plain", "--output", "type=cacheonly", *secret, *options]
    outcome = run(*command, str(folder), env=services.environment())
    assert outcome.code == 0, outcome.err
    return outcome.err


INSTALL = """\
#!/bin/bash
set -e
source /run/network.sh
apt-get update
apt-get install --yes "$@"
"""


def build_on(services: Services, image: Published, folder: Path, steps: Sequence[str], name: str = "") -> str:
    """Builds on an image; returns what the builder said.

    Args:
        services: what `make up` started.
        image: to build on.
        folder: an empty one.
        steps: commands; one of them may be `install-packages PACKAGE…`, from the image's own apt source.
        name: of a folder beside this file, which becomes /NAME.
    """
    shutil.copy(ROOT / "components/build/network.sh", folder)
    (folder / "install-packages").write_text(INSTALL)
    (folder / "install-packages").chmod(0o755)
    if name:
        shutil.copytree(Path(__file__).parent / name, folder / name)
    mounts = (
        "--mount=type=bind,source=network.sh,target=/run/network.sh --mount=type=secret,id=ca-bundle "
        "--mount=type=bind,source=install-packages,target=/usr/local/bin/install-packages"
    )
    lines = [f"FROM {image.result['reference']}", *([f"COPY {name} /{name}"] if name else [])]
    lines += [f"RUN {mounts if step.startswith('install-packages') else ''} {step}" for step in steps]
    (folder / "Dockerfile").write_text("\n".join(lines) + "\n")
    return build(services, folder)


def test_ros_and_both_frameworks_in_one_c_plus_plus_program(
    services: Services, published: Publish, tmp_path: Path
) -> None:
    """A catkin package with roscpp, cv_bridge, libtorch (TorchScript) and tensorflow_cc (SavedModel)."""
    said = build_on(services, published(BOTH), tmp_path, ["/entrypoint.sh /coexist/run.sh"], "coexist")
    assert "pictures: seen, wrong: 0" in said


def test_the_usual_examples_of_both_frameworks_in_c_plus_plus(
    services: Services, published: Publish, tmp_path: Path
) -> None:
    """MNIST with libtorch's C++ frontend; gradient descent and label_image with TensorFlow's ClientSession."""
    steps = [f"/examples/{framework}/run.sh" for framework in ("torch", "tensorflow")]
    said = build_on(services, published(BOTH), tmp_path, steps, "examples")
    for words in ("mnist: accuracy", "train: loss", "label_image: green"):
        assert words in said


def test_tensorflow_and_the_systems_protobuf_in_one_program(
    services: Services, published: Publish, tmp_path: Path
) -> None:
    """Each target sees the protobuf, abseil and Eigen that it links; no image has the system's, but for Eigen."""
    steps = ["install-packages libprotobuf-dev protobuf-compiler libabsl-dev", "/headers/run.sh"]
    said = build_on(services, published(BOTH), tmp_path, steps, "headers")
    assert "both: done" in said


def test_ros_2_from_wheels_and_both_frameworks_in_one_process(
    services: Services, published: Publish, tmp_path: Path
) -> None:
    """rclpy, Fast DDS and messages in a virtual environment on the image's Python, beside ROS 1: a node in whose callback
    both frameworks infer answers another process, whichever of the three was imported first."""
    image = published(BOTH)
    shutil.copytree(Path(__file__).parent / "rclpy_wheels", tmp_path / "rclpy_wheels")
    (tmp_path / "Dockerfile").write_text(
        textwrap.dedent(f"""\
            FROM {image.result["reference"]} AS ros2
            COPY rclpy_wheels/requirements.txt /rclpy_wheels/
            RUN --mount=type=secret,id=ca-bundle \\
                if [ -s /run/secrets/ca-bundle ]; then export PIP_CERT=/run/secrets/ca-bundle; fi; \\
                python3 -m venv --system-site-packages /ros2 && /ros2/bin/pip install --no-cache-dir --no-deps \\
                  --require-hashes --only-binary :all: --requirement /rclpy_wheels/requirements.txt
            FROM ros2 AS talk
            COPY rclpy_wheels /rclpy_wheels
            RUN --network=none timeout {TALK_SECONDS} /entrypoint.sh /rclpy_wheels/run.sh /ros2/bin/python
        """)
    )
    said = build(services, tmp_path, "--no-cache-filter", "talk")
    assert said.count("20 answers, wrong: 0; exit codes 0 and 0") == 6, said


def push(
    services: Services,
    base: Published,
    target: str,
    prefix: str,
    *sets: str,
    variables: Mapping[str, str] | None = None,
) -> None:
    """Builds a target, on the operating system of a published image, and pushes it by its tags below a place."""
    bake = builder.Bake(
        target,
        f"push-{target}",
        ROOT / "docker-bake.hcl",
        (f"{target}.output=type=image,push=true,{COMPRESSION}", *sets),
        {
            "REGISTRY": prefix,
            names.os_variable(base.image.os): base_image(base),
            "PLATFORM": PLATFORM,
            **(variables or {}),
        },
    )
    builder.run(services, bake)


def push_payload(
    services: Services, image: Published, payload: Payload, *sets: str, variables: Mapping[str, str] | None = None
) -> list[str]:
    """Pushes a payload as an image of its own, by its name as a tag; returns its layers."""
    prefix = f"{services.registry}/{NAMESPACE}"
    push(services, image, payload.target, prefix, *sets, variables=variables)
    return [layer.digest for layer in registry.layers(services, f"{prefix}/payload:{payload.name}")]


def test_payloads_are_added_to_an_image_of_ones_own(
    services: Services, published: Publish, catalogue: Catalogue, tmp_path: Path
) -> None:
    """COPY --link, as the README shows it: PyTorch in a Debian image that has Python and nothing of ours."""
    image = published(FIRST)
    layers = [
        layer for name in image.image.parts for layer in push_payload(services, image, catalogue.payload_by_name[name])
    ]
    assert layers == image.layers[-PAYLOAD_PARTS:], "the payload as an image of its own is the same layer"
    shutil.copy(ROOT / "components/build/network.sh", tmp_path)
    copies = [f"COPY --link --from={services.registry}/{NAMESPACE}/payload:{name} / /" for name in image.image.parts]
    (tmp_path / "Dockerfile").write_text(
        textwrap.dedent(f"""\
            FROM {image.result["base"].split()[0]}
            RUN --mount=type=bind,source=network.sh,target=/network.sh --mount=type=secret,id=ca-bundle \\
                bash -c '. /network.sh && apt-get update && apt-get install --yes python3'
        """)
        + "\n".join(copies)
        + "\nRUN python3 -c 'import torch; assert (torch.ones(2) @ torch.ones(2)).item() == 2; print(torch.__version__)'\n"
    )
    build(services, tmp_path)


def base_image(image: Published) -> str:
    return f"docker-image://{image.result['base'].split()[0]}"


def test_the_committed_bake_file_works_by_itself(services: Services, published: Publish) -> None:
    """`buildx bake <target>-test`, without our commands: as on a laptop, but for the base image's place."""
    image = published("bookworm-core")
    arguments = [*services.buildx, "bake", "--progress", "plain"]
    if services.ca_bundle:
        arguments += ["--allow", f"fs.read={services.ca_bundle}"]
    env = {
        **services.environment(),
        "OS_BOOKWORM": base_image(image),
        "CA_BUNDLE": services.ca_bundle,
        "PLATFORM": PLATFORM,
    }
    outcome = run(*arguments, "bookworm-core-test", env=env)
    assert outcome.code == 0, outcome.err


def test_a_user_builds_on_the_published_tag(services: Services, published: Publish, tmp_path: Path) -> None:
    """FROM, as the README shows it, with a ROS package; tests/e2e/test_documentation.py has C++."""
    image = published(FIRST)
    (tmp_path / "Dockerfile").write_text(
        textwrap.dedent(f"""\
            FROM {image.result["reference"]}
            RUN mkdir -p /ws/src && cd /ws/src && catkin_create_pkg example rospy std_msgs && \\
                cd /ws && catkin_make && . devel/setup.sh && rospack find example
        """)
    )
    build(services, tmp_path)
