#!/usr/bin/env python3
"""Turns once around, a quarter at a time."""

import math

import rospy
from std_msgs.msg import Float64

if __name__ == "__main__":
    rospy.init_node("turn")
    publisher = rospy.Publisher("heading", Float64, queue_size=1)
    rate = rospy.Rate(2)
    heading = 0.0
    while not rospy.is_shutdown():
        publisher.publish(heading)
        heading += math.pi / 2
        rate.sleep()
