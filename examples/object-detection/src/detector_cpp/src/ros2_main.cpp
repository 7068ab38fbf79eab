#include <exception>

#include "ros2.h"

int main(int argc, char** argv) {
  rclcpp::init(argc, argv);
  try {
    rclcpp::spin(std::make_shared<detector::Node>(rclcpp::NodeOptions()));
  } catch (const std::exception& error) {
    RCLCPP_FATAL(rclcpp::get_logger("detector"), "%s", error.what());
    rclcpp::shutdown();
    return 1;
  }
  rclcpp::shutdown();
}
