#include "ros2.h"

#include <rclcpp_components/register_node_macro.hpp>
#include <stdexcept>

namespace detector {

Node::Node(const rclcpp::NodeOptions& options) : rclcpp::Node("detector", options), detector_(settings()) {
  publisher_ = create_publisher<detector_msgs::msg::Boxes>("boxes", 1);
  // It hears any camera, and of several pictures that wait for a slow model, the last one.
  subscription_ = create_subscription<sensor_msgs::msg::Image>(
      "image", rclcpp::SensorDataQoS().keep_last(1),
      [this](const sensor_msgs::msg::Image::ConstSharedPtr& image) { look(*image); });
  RCLCPP_INFO(get_logger(), "%s", detector_.about().c_str());
}

Settings Node::settings() {
  Settings found;
  found.model = declare_parameter("model", found.model);
  found.threshold = declare_parameter("threshold", found.threshold);
  found.device = declare_parameter("device", found.device);
  found.width = static_cast<int>(declare_parameter("width", found.width));
  found.height = static_cast<int>(declare_parameter("height", found.height));
  return found;
}

void Node::look(const sensor_msgs::msg::Image& image) {
  detector_msgs::msg::Boxes message;
  message.header = image.header;
  try {
    for (const auto& box : detector_.look(picture(image))) {
      auto& next = message.boxes.emplace_back();
      next.x1 = box.x1, next.y1 = box.y1, next.x2 = box.x2, next.y2 = box.y2;
      next.score = box.score, next.label = box.label;
    }
  } catch (const std::invalid_argument& error) {
    RCLCPP_ERROR_THROTTLE(get_logger(), *get_clock(), 5000, "%s", error.what());
    return;
  }
  publisher_->publish(message);
}

}  // namespace detector

RCLCPP_COMPONENTS_REGISTER_NODE(detector::Node)
