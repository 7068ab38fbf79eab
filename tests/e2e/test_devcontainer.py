"""The dev container Feature, as a builder of dev containers calls it: copied into the image, with its option as a variable."""

from __future__ import annotations

from pathlib import Path

from rosml.machine.services import Services
from tests.e2e.images import Publish, build_on


def test_a_part_is_added_to_an_image(services: Services, published: Publish, tmp_path: Path) -> None:
    """With all that it needs, beside ROS."""
    image = published("ros1-bookworm-core-tensorflow-cpu")
    place, part = image.reference.partition("@")[0].rpartition("/")[0], image.image.parts[-1]
    steps = [
        f"nearby env PART={place}/part:{part} /part/install.sh",
        "/entrypoint.sh python3 -c 'import rospy, tensorflow; print(\"beside ROS:\", tensorflow.constant(6) * 7)'",
    ]
    said = build_on(services, published("ros1-bookworm-core"), tmp_path, steps, "../../devcontainer/src/part")
    assert "beside ROS: tf.Tensor(42" in said
