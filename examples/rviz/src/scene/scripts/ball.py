#!/usr/bin/env python3
"""A ball that moves on a circle, for rviz."""

import math

import rospy
from geometry_msgs.msg import Point, Pose, Quaternion, Vector3
from std_msgs.msg import ColorRGBA, Header
from visualization_msgs.msg import Marker

SECONDS = 5.0
"""For one round."""


def position(seconds: float) -> Point:
    """Where the ball is after some time, in m."""
    angle = 2 * math.pi * seconds / SECONDS
    return Point(math.cos(angle), math.sin(angle), 0.0)


def ball(seconds: float) -> Marker:
    """The ball after some time."""
    return Marker(
        header=Header(frame_id="map"),
        type=Marker.SPHERE,
        pose=Pose(position(seconds), Quaternion(0, 0, 0, 1)),
        scale=Vector3(0.3, 0.3, 0.3),
        color=ColorRGBA(1.0, 0.5, 0.0, 1.0),
    )


if __name__ == "__main__":
    rospy.init_node("ball")
    publisher = rospy.Publisher("ball", Marker, queue_size=1)
    rate = rospy.Rate(30)
    while not rospy.is_shutdown():
        publisher.publish(ball(rospy.get_time()))
        rate.sleep()
