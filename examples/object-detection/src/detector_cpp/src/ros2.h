#pragma once

#include <detector_msgs/msg/boxes.hpp>
#include <rclcpp/rclcpp.hpp>
#include <sensor_msgs/msg/image.hpp>

#include "detector.h"

namespace detector {

// Hears `image`, and publishes `boxes`. A component: it can be in one process with the camera's.
class Node : public rclcpp::Node {
 public:
  // Throws std::exception as Detector does, and if a parameter has another type.
  explicit Node(const rclcpp::NodeOptions& options);

 private:
  Settings settings();
  void look(const sensor_msgs::msg::Image& image);

  Detector detector_;
  rclcpp::Publisher<detector_msgs::msg::Boxes>::SharedPtr publisher_;
  rclcpp::Subscription<sensor_msgs::msg::Image>::SharedPtr subscription_;
};

}  // namespace detector
