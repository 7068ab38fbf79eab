#include <detector_msgs/Boxes.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include "detector.h"

// Hears `image`, and publishes `boxes`.
int main(int argc, char** argv) try {
  ros::init(argc, argv, "detector");
  ros::NodeHandle node, own("~");
  detector::Settings settings;
  own.param<std::string>("model", settings.model, "");
  own.param("threshold", settings.threshold, settings.threshold);
  own.param("device", settings.device, settings.device);
  own.param("width", settings.width, settings.width);
  own.param("height", settings.height, settings.height);
  detector::Detector detector(settings);
  ROS_INFO("%s", detector.about().c_str());
  auto publisher = node.advertise<detector_msgs::Boxes>("boxes", 1);
  const boost::function<void(const sensor_msgs::ImageConstPtr&)> look = [&](const auto& image) {
    detector_msgs::Boxes message;
    message.header = image->header;
    try {
      for (const auto& box : detector.look(detector::picture(*image))) {
        auto& next = message.boxes.emplace_back();
        next.x1 = box.x1, next.y1 = box.y1, next.x2 = box.x2, next.y2 = box.y2;
        next.score = box.score, next.label = box.label;
      }
    } catch (const std::invalid_argument& error) {
      ROS_ERROR_THROTTLE(5, "%s", error.what());
      return;
    }
    publisher.publish(message);
  };
  const auto subscriber = node.subscribe<sensor_msgs::Image>("image", 1, look);
  ros::spin();
} catch (const std::exception& error) {
  ROS_FATAL("%s", error.what());
  return 1;
}
