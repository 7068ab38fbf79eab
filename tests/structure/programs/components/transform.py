#!/usr/bin/env python3
"""Looks a transform up and prints it."""

import rospy
import tf2_ros

rospy.init_node("transform", disable_signals=True)
buffer = tf2_ros.Buffer()
listener = tf2_ros.TransformListener(buffer)
translation = buffer.lookup_transform("base", "camera", rospy.Time(0), rospy.Duration(20)).transform.translation
print("transform:", translation)
assert (translation.x, translation.y, translation.z) == (1, 2, 3)
