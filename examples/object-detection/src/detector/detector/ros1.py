"""The nodes for ROS 1."""

from __future__ import annotations

import rospy
from detector_msgs.msg import Box, Boxes
from sensor_msgs.msg import Image

from detector import scene
from detector.boxes import HEIGHT, WIDTH, Detector, pixels


def detect() -> int:
    """Hears `image`, and publishes `boxes`. The exit code is 1 if it cannot start, as without its model."""
    rospy.init_node("detector")
    defaults = {"model": "", "threshold": 0.6, "device": "auto", "width": WIDTH, "height": HEIGHT}
    try:
        detector = Detector(**{name: rospy.get_param(f"~{name}", value) for name, value in defaults.items()})
    except Exception as error:
        rospy.logfatal(str(error))
        return 1
    publisher = rospy.Publisher("boxes", Boxes, queue_size=1)

    def look(image: Image) -> None:
        try:
            found = detector.look(pixels(image))
        except ValueError as error:
            rospy.logerr_throttle(5, str(error))
            return
        publisher.publish(Boxes(image.header, [Box(**box._asdict()) for box in found]))

    # A buffer for a whole picture: with a smaller one, a slow model hears old pictures.
    rospy.Subscriber("image", Image, look, queue_size=1, buff_size=1 << 25)
    rospy.loginfo(detector.about)
    rospy.spin()
    return 0


def camera() -> None:
    """Publishes a picture with a red and a blue square ten times a second."""
    rospy.init_node("camera")
    publisher = rospy.Publisher("image", Image, queue_size=1)
    image = Image(height=scene.HEIGHT, width=scene.WIDTH, encoding="rgb8", step=3 * scene.WIDTH)
    image.data, image.header.frame_id = scene.picture().tobytes(), "camera"
    rate = rospy.Rate(10)
    while not rospy.is_shutdown():
        image.header.stamp = rospy.Time.now()
        publisher.publish(image)
        try:
            rate.sleep()
        except rospy.ROSInterruptException:
            return
