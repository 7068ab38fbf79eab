#!/usr/bin/env python3
"""Publishes a picture on /sent and a plane as PCL has it, hears both, and turns a laser scan into points."""

import math

import cv2
import laser_geometry
import numpy as np
import rospy
from cv_bridge import CvBridge
from pcl_msgs.msg import ModelCoefficients
from sensor_msgs.msg import Image, LaserScan

rospy.init_node("picture", disable_signals=True)
sent = cv2.circle(np.zeros((32, 48, 3), np.uint8), (20, 10), 5, (0, 128, 255), -1)
publisher = rospy.Publisher("/sent", Image, queue_size=1)
heard: list = []
rospy.Subscriber("/received", Image, heard.append)
plane = rospy.Publisher("/plane", ModelCoefficients, queue_size=1)
planes: list = []
rospy.Subscriber("/plane", ModelCoefficients, planes.append)
while not heard or not planes:
    publisher.publish(CvBridge().cv2_to_imgmsg(sent, "bgr8"))
    plane.publish(ModelCoefficients(values=[0, 0, 1, -2.5]))
    rospy.sleep(0.05)
assert (CvBridge().imgmsg_to_cv2(heard[0], "bgr8") == sent).all()
assert planes[0].values == (0, 0, 1, -2.5)
scan = LaserScan(angle_min=0, angle_max=math.pi, angle_increment=math.pi / 2, range_max=9, ranges=[1, 2, 3])
assert laser_geometry.LaserProjection().projectLaser(scan).width == 3
print("picture, plane and points: as they were sent")
