"""Images are put together in the registry: the same as a build gives, in next to no bytes."""

from __future__ import annotations

import gzip
import json
import sys
from collections.abc import Callable
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
from tests.e2e import mini as minis
from tests.e2e.conftest import LOG, NAMESPACE, Published, Run, run
from tests.e2e.images import build, push_part
from tests.e2e.mini import Mini

PARTS = ("common-cpu-py311", "grpc-cpu-py311", "tensorflow-cc-cpu", "tensorflow-cpu-py311")
BYTES = 10_000
"""What joining an image may upload."""


@pytest.fixture(scope="module")
def mini(beside: Services, tmp_path_factory: pytest.TempPathFactory) -> Mini:
    """The small project, published."""
    found = minis.make(tmp_path_factory.mktemp("mini"), beside)
    found.all()
    return found


def joined(checkout: Path, *arguments: str) -> Run:
    return run(sys.executable, str(ROOT / "src"), "join", *arguments, cwd=checkout)


def small(checkout: Path, tag: str, *images: str) -> dict[str, Any]:
    """Joins an image, of which no layer is moved, and holds it to its bytes; what the command says."""
    outcome = joined(checkout, *images, "--tag", tag, "--json")
    assert outcome.code == 0, outcome.err
    said: dict[str, Any] = json.loads(outcome.out)
    assert said["uploaded"] < BYTES and said["copied"] == 0
    return said


def parts(mini: Mini) -> list[str]:
    return [f"{mini.registry}/part:{name}" for name in PARTS]


def config(client: Registry, repository: str, reference: str) -> tuple[list[str], dict[str, Any]]:
    """Layers and config of an image for one platform, through its index."""
    found = client.manifest(repository, reference)
    assert found
    if found.is_index:
        found = client.manifest(repository, found.content["manifests"][0]["digest"])
        assert found
    layers = [layer["digest"] for layer in found.content["layers"]]
    return layers, client.json_blob(repository, found.content["config"]["digest"])


def test_as_a_build_would_make_it(mini: Mini) -> None:
    """Layers, environment, entrypoint, labels: a joined image and one of `buildx bake` are the same."""
    client = mini.client()
    target = "ros1-bookworm-core-tensorflow-cpu"
    namespace = f"{mini.prefix}/built"
    outcome = run(*mini.command("image", target, "--namespace", namespace, "--json"), cwd=mini.folder)
    assert outcome.code == 0, outcome.err
    built = config(client, f"{namespace}/ros-tf", json.loads(outcome.out)["manifest"])
    ours = config(client, f"{mini.prefix}/ros-tf", "ros1-bookworm-core-cpu")
    assert ours[0] == built[0]
    for name in ("Entrypoint", "Cmd", "WorkingDir", "Labels"):
        assert ours[1]["config"].get(name) == built[1]["config"].get(name), name
    assert sorted(ours[1]["config"]["Env"]) == sorted(built[1]["config"]["Env"])
    assert ours[1]["rootfs"] == built[1]["rootfs"]
    assert {key: ours[1][key] for key in ("os", "architecture")} == {
        key: built[1][key] for key in ("os", "architecture")
    }


def test_for_users(mini: Mini) -> None:
    """Under ten kilobytes, whatever the order; a second call changes nothing."""
    tag = f"{mini.registry}/mine:latest"
    said = small(mini.folder, tag, f"{mini.registry}/ros:ros1-bookworm-core", *parts(mini))
    assert said["mounted"] == said["layers"]
    again = joined(mini.folder, f"{mini.registry}/ros:ros1-bookworm-core", *parts(mini)[::-1], "--tag", tag, "--json")
    assert json.loads(again.out)["digest"] == said["digest"]
    layers, found = config(mini.client(), f"{mini.prefix}/mine", "latest")
    assert len(layers) == len(found["rootfs"]["diff_ids"])
    assert found["config"]["Labels"]["io.rosml.framework"] == "tensorflow"
    assert "TENSORFLOW_VERSION=2.21.0" in found["config"]["Env"]


def test_what_does_not_go_together(mini: Mini) -> None:
    ros, tag = f"{mini.registry}/ros:ros1-bookworm-core", f"{mini.registry}/mine:never"
    common, grpc, cc, tensorflow = parts(mini)
    for arguments, words in {
        (ros, tensorflow): "common",
        (ros, common, grpc, cc, tensorflow, tensorflow): "twice",
        (common, cc): "is a part",
        (ros, ros): "is a ROS image",
        (f"{mini.registry}/ros-tf:ros1-bookworm-core-cpu", common): "already",
        (f"{mini.registry}/ros:ros1-bookworm-corn", common): "did you mean 'ros1-bookworm-core'",
    }.items():
        outcome = joined(mini.folder, *arguments, "--tag", tag)
        assert outcome.code == 2, (arguments, outcome.err)
        assert words in outcome.err and "Traceback" not in outcome.err, outcome.err
    assert mini.client().head(f"{mini.prefix}/mine", "never") == ""


def test_two_parts_that_carry_the_same_file(mini: Mini) -> None:
    """Known from the lists that are attached to them; nothing is pulled for it."""
    client = mini.client()
    repository = f"{mini.prefix}/part"
    index = client.manifest(repository, PARTS[0])
    assert index
    manifest = client.manifest(repository, index.content["manifests"][0]["digest"])
    assert manifest
    (entry,) = client.referrers(repository, manifest.digest, file_lists.ARTIFACT)
    listed = client.manifest(repository, entry["digest"])
    assert listed
    names = file_lists.unpacked(client.blob(repository, listed.content["layers"][0]["digest"])).decode().split()
    assert "opt/mini-part/common" in names

    other = {**manifest.content, "annotations": {"another": "one"}}
    digest = client.put_manifest(repository, "", oci.encoded(other), oci.IMAGE)
    changed = client.manifest(repository, digest)
    assert changed
    others = gzip.compress(b"opt/mini-part/tensorflow-cc\n")
    client.attach(repository, changed.descriptor, file_lists.ARTIFACT, others, file_lists.MEDIA_TYPE)
    arguments = [f"{mini.registry}/part@{digest}", *parts(mini)[1:]]
    outcome = joined(
        mini.folder, f"{mini.registry}/ros:ros1-bookworm-core", *arguments, "--tag", f"{mini.registry}/mine:never"
    )
    assert outcome.code == 2
    assert "both carry /opt/mini-part/tensorflow-cc" in outcome.err


def test_two_hundred_images(mini: Mini) -> None:
    """Each of a ROS image of its own: a config of its own over layers that are there."""
    client = mini.client()
    layers, found = config(client, f"{mini.prefix}/ros", "ros1-bookworm-core")
    index = client.manifest(f"{mini.prefix}/ros", "ros1-bookworm-core")
    assert index
    manifest = client.manifest(f"{mini.prefix}/ros", index.content["manifests"][0]["digest"])
    assert manifest and layers
    images = []
    for number in range(200):
        own = {**found, "config": {**found["config"], "Env": [*found["config"]["Env"], f"NUMBER={number}"]}}
        data = oci.encoded(own)
        client.put_blob(f"{mini.prefix}/ros", data)
        content = {**manifest.content, "config": oci.descriptor(oci.CONFIG, data)}
        images.append(client.put_manifest(f"{mini.prefix}/ros", "", oci.encoded(content), oci.IMAGE))
    said: list[str] = []
    with (
        joining.Joiner(lambda _: client, allow_unlisted=True, say=said.append) as joiner,
        ThreadPoolExecutor(8) as pool,
    ):

        def one(number: int) -> joining.JoinReport:
            target = f"{mini.registry}/many:{number}"
            return joiner.join(f"{mini.registry}/ros@{images[number]}", parts(mini), target)

        results = list(pool.map(one, range(200)))
    assert len({result.digest for result in results}) == 200
    assert max(result.uploaded for result in results) < BYTES
    assert len(client.tags(f"{mini.prefix}/many")) == 200
    LOG.info("200 images, %d bytes", sum(result.uploaded for result in results))


def test_a_real_one_runs(
    services: Services, published: Callable[[str], Published], image_set: ImageSet, tmp_path: Path
) -> None:
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
    layers, found = config(client, f"{NAMESPACE}/joined", "latest")
    assert layers == image.layers
    built = config(client, f"{NAMESPACE}/{image.image.repository}", image.result["manifest"])[1]
    assert found["config"]["Labels"] == built["config"]["Labels"]
    assert sorted(found["config"]["Env"]) == sorted(built["config"]["Env"])
    program = "import rospy, tensorflow as tf; print('sum:', int(tf.reduce_sum([1, 2, 3])))"
    (tmp_path / "Dockerfile").write_text(f'FROM {tag}\nRUN /entrypoint.sh python3 -c "{program}"\n')
    assert "sum: 6" in build(services, tmp_path)
