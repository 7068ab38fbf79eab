"""A container with the counter as a component, and a node that asks it to count; the end of that one ends both."""

from launch import LaunchDescription
from launch.actions import RegisterEventHandler, Shutdown
from launch.event_handlers import OnProcessExit
from launch_ros.actions import ComposableNodeContainer, Node
from launch_ros.descriptions import ComposableNode


def generate_launch_description() -> LaunchDescription:
    """What `ros2 launch` starts."""
    counter = ComposableNode(
        package="example_cpp", plugin="example_cpp::Counter", name="counter", parameters=[{"step": 2}]
    )
    container = ComposableNodeContainer(
        package="rclcpp_components",
        executable="component_container",
        name="container",
        namespace="",
        composable_node_descriptions=[counter],
        output="screen",
    )
    asks = Node(package="example_py", executable="count", output="screen")
    return LaunchDescription(
        [container, asks, RegisterEventHandler(OnProcessExit(target_action=asks, on_exit=[Shutdown()]))]
    )
