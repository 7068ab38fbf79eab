"""Images are put together in the registry: the same as a build gives, in next to no bytes."""

from __future__ import annotations

import json
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import pytest

from rosml import ROOT
from rosml.images.builds import contents
from rosml.images.image_set.model import ImageSet
from rosml.images.join import file_lists
from rosml.images.join import joiner as joining
from rosml.machine.services import Services
from rosml.registry import oci
from rosml.registry.client import Registry
from tests import regctl
from tests.e2e.calls import LOG, NAMESPACE, rosml
from tests.e2e.images import Publish, build_file, push_part
from tests.e2e.mini import PARTS, Mini

BYTES = 10_000
"""What joining an image may upload."""


@pytest.fixture(scope="module")
def mini(project: Mini) -> Mini:
    """The small project, published."""
    project.all()
    return project


def small(checkout: Path, tag: str, *images: str) -> dict[str, Any]:
    """Joins an image, of which no layer is moved, and holds it to its bytes; what the command says."""
    report: dict[str, Any] = json.loads(rosml("join", *images, "--tag", tag, "--json", root=checkout).out)
    assert report["uploaded"] < BYTES and report["copied"] == 0
    return report


def parts(mini: Mini) -> list[str]:
    return [f"{mini.registry}/part:{name}" for name in PARTS]


def config(client: Registry, repository: str, reference: str) -> tuple[list[str], dict[str, Any]]:
    """Layers and config of an image for one platform, through its index."""
    manifest = client.manifest(repository, reference)
    if manifest and manifest.is_index:
        manifest = client.manifest(repository, manifest.content["manifests"][0]["digest"])
    assert manifest
    layers = [layer["digest"] for layer in manifest.content["layers"]]
    return layers, client.json_blob(repository, manifest.content["config"]["digest"])


def test_as_a_build_would_make_it(mini: Mini) -> None:
    """Layers, environment, entrypoint, labels: a joined image and one of `buildx bake` are the same."""
    client = mini.client()
    target = "ros1-bookworm-core-tensorflow-cpu"
    namespace = f"{mini.prefix}/built"
    outcome = rosml("image", target, "--namespace", namespace, "--json", root=mini.folder)
    built = config(client, f"{namespace}/ros-tf", json.loads(outcome.out)["manifest"])
    ours = config(client, f"{mini.prefix}/ros-tf", "ros1-bookworm-core-cpu")
    assert ours[0] == built[0]
    for name in ("Entrypoint", "Cmd", "WorkingDir", "Labels"):
        assert ours[1]["config"].get(name) == built[1]["config"].get(name), name
    assert sorted(ours[1]["config"]["Env"]) == sorted(built[1]["config"]["Env"])
    assert ours[1]["rootfs"] == built[1]["rootfs"]
    assert [ours[1][key] for key in ("os", "architecture")] == [built[1][key] for key in ("os", "architecture")]


def test_for_users(mini: Mini) -> None:
    """Under ten kilobytes, whatever the order; a second call changes nothing."""
    tag = f"{mini.registry}/mine:latest"
    ros = f"{mini.registry}/ros:ros1-bookworm-core"
    report = small(mini.folder, tag, ros, *parts(mini))
    assert report["mounted"] == report["layers"]
    assert small(mini.folder, tag, ros, *parts(mini)[::-1])["digest"] == report["digest"]
    layers, image = config(mini.client(), f"{mini.prefix}/mine", "latest")
    assert len(layers) == len(image["rootfs"]["diff_ids"])
    assert image["config"]["Labels"]["io.rosml.framework"] == "tensorflow"
    assert "TENSORFLOW_VERSION=2.21.0" in image["config"]["Env"]


def test_two_hundred_images(mini: Mini) -> None:
    """Each of a ROS image of its own: a config of its own over layers that are there."""
    client = mini.client()
    layers, image = config(client, f"{mini.prefix}/ros", "ros1-bookworm-core")
    index = client.manifest(f"{mini.prefix}/ros", "ros1-bookworm-core")
    assert index
    manifest = client.manifest(f"{mini.prefix}/ros", index.content["manifests"][0]["digest"])
    assert manifest and layers
    images = []
    for number in range(200):
        changed = {**image["config"], "Env": [*image["config"]["Env"], f"NUMBER={number}"]}
        data = oci.encoded({**image, "config": changed})
        client.put_blob(f"{mini.prefix}/ros", data)
        content = {**manifest.content, "config": oci.descriptor(oci.CONFIG, data)}
        images.append(client.put_manifest(f"{mini.prefix}/ros", "", oci.encoded(content), oci.IMAGE))
    with joining.Joiner(lambda _: client, allow_unlisted=True, say=LOG.info) as joiner, ThreadPoolExecutor(8) as pool:

        def one(number: int) -> joining.JoinReport:
            target = f"{mini.registry}/many:{number}"
            return joiner.join(f"{mini.registry}/ros@{images[number]}", parts(mini), target)

        results = list(pool.map(one, range(200)))
    assert len({result.digest for result in results}) == 200
    assert max(result.uploaded for result in results) < BYTES
    assert len(client.tags(f"{mini.prefix}/many")) == 200
    LOG.info("200 images, %d bytes", sum(result.uploaded for result in results))


def test_a_real_one_runs(services: Services, published: Publish, image_set: ImageSet, tmp_path: Path) -> None:
    """ROS and TensorFlow as they are: the layers of the built image, and a program that uses both."""
    image, ros = published("ros1-bookworm-core-tensorflow-cpu"), published("ros1-bookworm-core")
    client = Registry(services.registry)
    place = f"{services.registry}/{NAMESPACE}"
    images = {"ros": ros.result["manifest"]}
    for name in image.image.parts:
        push_part(services, image, image_set.part_by_name[name])
        images[f"part:{name}"] = client.head(f"{NAMESPACE}/part", name)
    for name, digest in images.items():
        repository = f"{NAMESPACE}/{name.partition(':')[0]}"
        contents.attach(services, image_set, client, [(repository, digest)], LOG.info)
        listed = regctl.regctl(services, "artifact", "list", f"{services.registry}/{repository}@{digest}")
        assert file_lists.ARTIFACT in listed, "other tools find the list as well"
    tag = f"{place}/joined:latest"
    parts = [f"{place}/part:{name}" for name in image.image.parts]
    small(ROOT, tag, f"{place}/ros:ros1-bookworm-core", *parts)
    layers, joined = config(client, f"{NAMESPACE}/joined", "latest")
    assert layers == image.layers
    built = config(client, f"{NAMESPACE}/{image.image.repository}", image.result["manifest"])[1]
    assert joined["config"]["Labels"] == built["config"]["Labels"]
    assert sorted(joined["config"]["Env"]) == sorted(built["config"]["Env"])
    program = "import rospy, tensorflow as tf; print('sum:', int(tf.reduce_sum([1, 2, 3])))"
    assert "sum: 6" in build_file(services, tmp_path, f'FROM {tag}\nRUN /entrypoint.sh python3 -c "{program}"\n')
