"""A node's parameters: read and set by the command `ros2 param`, and refused where the node refuses them."""

import threading

import rclpy
from rcl_interfaces.msg import SetParametersResult
from rclpy.executors import SingleThreadedExecutor
from waiting import says

rclpy.init()
node = rclpy.create_node("parameters")
node.declare_parameter("rate", 10)
node.add_on_set_parameters_callback(
    lambda changes: SetParametersResult(
        successful=all(parameter.value > 0 for parameter in changes), reason="not above 0"
    )
)
executor = SingleThreadedExecutor()
executor.add_node(node)
spinning = threading.Thread(target=executor.spin, daemon=True)
spinning.start()

param = ["ros2", "param"]
says([*param, "get", "--no-daemon", "/parameters", "rate"], "Integer value is: 10")
says([*param, "set", "--no-daemon", "/parameters", "rate", "20"], "Set parameter successful")
assert node.get_parameter("rate").value == 20, node.get_parameter("rate").value
refused = node.set_parameters([rclpy.parameter.Parameter("rate", value=-1)])[0]
assert not refused.successful and refused.reason == "not above 0", refused
assert node.get_parameter("rate").value == 20, node.get_parameter("rate").value

executor.shutdown()
spinning.join(10)
node.destroy_node()
rclpy.shutdown()
print("parameters: read, set, refused")
