"""Words by which people look for images: each leads to what it means."""

from __future__ import annotations

import pytest

from rosml.base.errors import RosmlError
from rosml.images.image_set.explain import explained
from rosml.images.image_set.model import ImageSet
from rosml.images.image_set.search import search


@pytest.mark.parametrize(
    ("text", "targets", "others"),
    [
        ("libtorch", "jazzy-base-torch-cu130", "jazzy-base-tensorflow-cu128 jazzy-wheels-core-torch-cu128 jazzy-base"),
        ("tensorflow c++", "jazzy-base-tensorflow-cpu", "jazzy-base-torch-cu130 jazzy-wheels-core-tensorflow-cpu"),
        ("c++", "jazzy-base noetic-core", "jazzy-wheels-core jazzy-core-run"),
        ("cv_bridge", "jazzy-perception jazzy-desktop", "jazzy-base jazzy-wheels-core"),
        ("noble", "jazzy-base kilted-core", "humble-base"),
        ("ubuntu 24.04 torch", "jazzy-base-torch-cu130", "jazzy-base humble-base-torch-cu128"),
        ("py3.12", "jazzy-base", "humble-base"),
        ("lts", "jazzy-base humble-base", "kilted-base ros1-bookworm-core"),
        ("jazzy gpu", "jazzy-base-torch-cu130 jazzy-base-torch-cu128", "jazzy-base humble-base-torch-cu128"),
        ("driver 550", "jazzy-base-torch-cu128", "jazzy-base-torch-cu130"),
        ("driver:580.95", "jazzy-base-torch-cu128 jazzy-base-torch-cu130", "jazzy-base"),
        ("rtx 4090", "jazzy-base-torch-cu128 jazzy-base-torch-cu130", "jazzy-base-torch-cpu"),
        ("v100", "noetic-base-torch-cu121", "jazzy-base-torch-cu130"),
        ("thor", "jazzy-base-torch-cu130", "jazzy-base-torch-cu128 jazzy-base-onnx-cu130"),
        ("orin", "jazzy-base-torch-cu130", "jazzy-base-torch-cu128 jazzy-base-onnx-cu130"),
        ("cuda 12.8", "jazzy-base-torch-cu128", "jazzy-base-torch-cu130"),
        ("ros2 pytorch", "jazzy-base-torch-cu130", "noetic-base-torch-cu121 jazzy-base"),
        ("onnxruntime", "jazzy-base-onnx-cu130", "jazzy-base"),
    ],
)
def test_a_word_leads_to_what_it_means(real: ImageSet, text: str, targets: str, others: str) -> None:
    matches = {image.target for image in search(real, text.split())}
    assert matches >= {*targets.split()} and matches.isdisjoint(others.split())
    assert {*targets.split(), *others.split()} <= {*real.by_target}, "images of the matrix"


def test_a_word_is_explained_as_well(real: ImageSet) -> None:
    assert "see them with: rosml list rtx 4090" in explained(real, "rtx 4090").text


def test_a_word_that_means_nothing_is_named(real: ImageSet) -> None:
    with pytest.raises(RosmlError, match="no group named 'jazy'; did you mean 'jazzy'") as caught:
        search(real, ["jazy", "rtx", "4090"])
    assert caught.value.exit_code == 2
