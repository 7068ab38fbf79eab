#!/usr/bin/env python3
"""node.py talk TOPIC TEXT: publishes TEXT until it is stopped. node.py listen TOPIC: prints one message and ends."""

import sys

import rospy
from std_msgs.msg import String

action, topic = sys.argv[1:3]
rospy.init_node(action, anonymous=True, disable_signals=True)
if action == "listen":
    print(rospy.wait_for_message(topic, String, timeout=20).data, flush=True)
else:
    publisher = rospy.Publisher(topic, String, queue_size=1)
    while not rospy.is_shutdown():
        publisher.publish(sys.argv[3])
        rospy.sleep(0.05)
