"""A service, asked twice: what the client was told is what the server answered."""

import rclpy
from std_srvs.srv import SetBool
from waiting import answer, until

rclpy.init()
node = rclpy.create_node("service")


def switch(request: SetBool.Request, response: SetBool.Response) -> SetBool.Response:
    """Answers."""
    response.success = True
    response.message = "on" if request.data else "off"
    return response


node.create_service(SetBool, "switch", switch)
client = node.create_client(SetBool, "switch")
step = lambda: rclpy.spin_once(node, timeout_sec=0.1)  # noqa: E731
until("the service /switch is found", client.service_is_ready, step)
for state, answer_text in ((True, "on"), (False, "off")):
    response = answer(f"/switch answers {answer_text}", client.call_async(SetBool.Request(data=state)), step)
    assert response.success and response.message == answer_text, response
node.destroy_node()
rclpy.shutdown()
print("service: on, off")
