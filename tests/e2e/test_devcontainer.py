"""The dev container Feature, as a builder of dev containers calls it: copied into the image, with its option as a variable."""

from __future__ import annotations

from tests.e2e.images import BuildOn, Publish


def test_a_part_is_added_to_an_image(build_on: BuildOn, published: Publish) -> None:
    """With all that it needs, beside ROS."""
    image = published("ros1-bookworm-core-tensorflow-cpu")
    place, part = image.reference.partition("@")[0].rpartition("/")[0], image.image.parts[-1]
    steps = [
        f"nearby env PART={place}/part:{part} /part/install.sh",
        "/entrypoint.sh python3 -c 'import rospy, tensorflow; print(\"beside ROS:\", tensorflow.constant(6) * 7)'",
    ]
    assert "beside ROS: tf.Tensor(42" in build_on("ros1-bookworm-core", steps, "../../devcontainer/src/part")
