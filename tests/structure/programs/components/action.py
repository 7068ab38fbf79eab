#!/usr/bin/env python3
"""An action server and a client in one node: prints what the client was told."""

import sys

import actionlib
import rospy
from actionlib.msg import TestAction, TestGoal, TestResult
from actionlib_msgs.msg import GoalStatus

rospy.init_node("action", disable_signals=True)
server: actionlib.SimpleActionServer = actionlib.SimpleActionServer(
    "count", TestAction, lambda goal: server.set_succeeded(TestResult(result=goal.goal + 1)), auto_start=False
)
server.start()
client = actionlib.SimpleActionClient("count", TestAction)
if not client.wait_for_server(rospy.Duration(10)):
    sys.exit("no action server")
state = client.send_goal_and_wait(TestGoal(goal=41), rospy.Duration(10))
print("action:", state, client.get_result())
rospy.signal_shutdown("done")  # ends the server's thread
sys.exit(state != GoalStatus.SUCCEEDED or client.get_result().result != 42)
