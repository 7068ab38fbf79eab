"""What a registry keeps once, in numbers and as a picture."""

from __future__ import annotations

import xml.etree.ElementTree

from rosml.images.builds import disk
from rosml.images.catalogue import layers_picture
from rosml.images.image_set.model import ImageSet


def test_a_registry_keeps_layers_once(real: ImageSet) -> None:
    base, torch, ml = (real.image(name) for name in ("jazzy-base", "jazzy-base-torch-cpu", "jazzy-base-ml-cpu"))
    part = {kind: size.compressed for kind, size in real.matrix.disk.parts["cpu"].items()}
    assert disk.registry_mb(real, [base], ["amd64"]) == base.disk.compressed
    assert disk.registry_mb(real, [torch], ["amd64"]) == base.disk.compressed + part["common"] + part["torch"]
    both = disk.registry_mb(real, [base, torch, ml], ["amd64", "arm64"])
    parts = ("common", "grpc", "torch", "tensorflow-cc", "tensorflow")
    assert both == 2 * (base.disk.compressed + sum(part[name] for name in parts))


def test_the_picture_says_what_each_image_adds(real: ImageSet) -> None:
    images = layers_picture.shown(real)
    assert [image.target for image in images] == [
        "jazzy-base-torch-cu130",
        "jazzy-base",
        "jazzy-desktop-full-torch-cu130",
        "kilted-base-torch-cu130",
    ]
    added = [megabytes for *_, megabytes in layers_picture.one_after_another(real, images)]
    assert added[1] == 0 and sum(added) == disk.registry_mb(real, images, ["amd64"])
    xml.etree.ElementTree.fromstring(layers_picture.render(real))
