"""count: leads the lifecycle node /counter through its states, and has it count by its action."""

import sys
import time

import rclpy
from example_msgs.action import Count
from lifecycle_msgs.msg import State, Transition
from lifecycle_msgs.srv import ChangeState, GetState
from rclpy.action import ActionClient
from rclpy.node import Node

SECONDS = 60
"""Longest wait for one thing; a second or two are usual."""


class Asker(Node):
    """Asks the counter, and ends the process with what it waited for in vain."""

    def __init__(self) -> None:
        super().__init__("asker")
        self.changes = self.create_client(ChangeState, "/counter/change_state")
        self.states = self.create_client(GetState, "/counter/get_state")
        self.counts = ActionClient(self, Count, "count")

    def until(self, what, holds):
        """Works until something holds."""
        end = time.monotonic() + SECONDS
        while not holds():
            if time.monotonic() > end:
                sys.exit(f"waited {SECONDS} s in vain: {what}")
            rclpy.spin_once(self, timeout_sec=0.1)

    def answer(self, what, future):
        """What a service or an action answers."""
        self.until(what, future.done)
        return future.result()

    def change(self, what, transition, state):
        """Takes the counter to a state."""
        self.until(f"{what}: the service is found", self.changes.service_is_ready)
        request = ChangeState.Request()
        request.transition.id = transition
        if not self.answer(f"{what}: an answer", self.changes.call_async(request)).success:
            sys.exit(f"{what}: the counter did not")
        self.until(f"{what}: the state can be asked for", self.states.service_is_ready)
        state_now = self.answer(f"{what}: the state", self.states.call_async(GetState.Request())).current_state
        if state_now.id != state:
            sys.exit(f"{what}: the counter is '{state_now.label}'")

    def count(self, what):
        """What the action answers to a goal."""
        self.until(f"{what}: the action server is found", self.counts.server_is_ready)
        return self.answer(f"{what}: an answer to the goal", self.counts.send_goal_async(Count.Goal(to=7)))


def main() -> None:
    """The node."""
    rclpy.init()
    asker = Asker()
    asker.change("configure", Transition.TRANSITION_CONFIGURE, State.PRIMARY_STATE_INACTIVE)
    if asker.count("while inactive").accepted:
        sys.exit("an inactive counter took a goal")
    asker.change("activate", Transition.TRANSITION_ACTIVATE, State.PRIMARY_STATE_ACTIVE)
    goal = asker.count("while active")
    if not goal.accepted:
        sys.exit("the active counter refused a goal")
    numbers = list(asker.answer("while active: the result", goal.get_result_async()).result.numbers)
    asker.change("deactivate", Transition.TRANSITION_DEACTIVATE, State.PRIMARY_STATE_INACTIVE)
    asker.counts.destroy()
    asker.destroy_node()
    rclpy.shutdown()
    if numbers != [2, 4, 6]:
        sys.exit(f"counted {numbers}")
    print("counted:", *numbers, flush=True)
