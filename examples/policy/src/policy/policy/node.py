"""A node that moves a robot by a policy of LeRobot."""

import contextlib

import numpy as np
import rclpy
import torch
from lerobot.configs.policies import PreTrainedConfig
from lerobot.policies.factory import get_policy_class, make_pre_post_processors
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from sensor_msgs.msg import Image, JointState
from std_msgs.msg import Float64MultiArray


class Policy(Node):
    """Hears `image` and `joint_states`, and publishes an action as `commands`, which a forward_command_controller of ros2_control takes."""

    def __init__(self) -> None:
        super().__init__("policy")
        folder = self.declare_parameter("policy", "policy").value
        config = PreTrainedConfig.from_pretrained(folder)
        config.device = "cuda" if torch.cuda.is_available() else "cpu"
        self._policy = get_policy_class(config.type).from_pretrained(folder, config=config).eval()
        on_device = {"device_processor": {"device": config.device}}
        self._before, self._after = make_pre_post_processors(config, folder, preprocessor_overrides=on_device)
        [self._camera] = config.image_features
        self._positions: list[float] = []
        self._publisher = self.create_publisher(Float64MultiArray, "commands", 1)
        self.create_subscription(JointState, "joint_states", self._hear, 1)
        self.create_subscription(Image, "image", self._act, qos_profile_sensor_data)
        self.get_logger().info(f"{config.type} with PyTorch {torch.__version__} on {config.device}")

    def _hear(self, joints: JointState) -> None:
        self._positions = list(joints.position)

    def _act(self, image: Image) -> None:
        if image.encoding != "rgb8":
            self.get_logger().error(f"rgb8 is wanted, and not {image.encoding}", throttle_duration_sec=5.0)
        elif self._positions:
            self._publisher.publish(Float64MultiArray(data=self._action(image)))

    @torch.inference_mode()
    def _action(self, image: Image) -> list[float]:
        rows = np.frombuffer(image.data, np.uint8).reshape(image.height, image.step)
        pixels = rows[:, : 3 * image.width].reshape(image.height, image.width, 3)
        observation = {
            self._camera: torch.from_numpy(pixels.copy()).permute(2, 0, 1).float() / 255,
            "observation.state": torch.tensor(self._positions),
        }
        return self._after(self._policy.select_action(self._before(observation)))[0].tolist()


def main() -> None:
    """Moves the robot until somebody stops it."""
    rclpy.init()
    with contextlib.suppress(KeyboardInterrupt, ExternalShutdownException):
        rclpy.spin(Policy())
