// Sends itself numbers, and has each framework compute their mean in a callback, on a thread of ROS's.
#include "means.h"

#include <atomic>
#include <chrono>
#include <cmath>
#include <iostream>
#include <memory>
#include <rclcpp/rclcpp.hpp>
#include <std_msgs/msg/float32_multi_array.hpp>
#include <thread>

using std_msgs::msg::Float32MultiArray;

int main(int argc, char** argv) {
  using namespace std::chrono_literals;
  rclcpp::init(argc, argv);
  const auto node = std::make_shared<rclcpp::Node>("coexist2");
  std::atomic<int> heard{0}, wrong{0};
  const auto compute = [&](Float32MultiArray::ConstSharedPtr message) {
    std::vector<float> means;
#ifdef WITH_TORCH
    means.push_back(torch_mean(message->data));
#endif
#ifdef WITH_TENSORFLOW
    means.push_back(tensorflow_mean(message->data));
#endif
    for (const float mean : means)
      if (std::abs(mean - 2.5f) > 1e-6f) ++wrong;
    ++heard;
  };
  const auto subscription = node->create_subscription<Float32MultiArray>("numbers", 10, compute);
  const auto publisher = node->create_publisher<Float32MultiArray>("numbers", 10);
  Float32MultiArray message;
  message.data = {1.f, 2.f, 3.f, 4.f};
  rclcpp::executors::MultiThreadedExecutor executor;
  executor.add_node(node);
  std::thread spinning([&] { executor.spin(); });
  for (int i = 0; i < 600 && heard < 3; ++i) {
    publisher->publish(message);
    rclcpp::sleep_for(100ms);
  }
  executor.cancel();
  spinning.join();
  rclcpp::shutdown();
  if (heard < 3) std::cout << "heard " << heard << " of 3 messages in 60 s" << std::endl;
  if (wrong) std::cout << wrong << " means were wrong" << std::endl;
  if (heard >= 3 && !wrong) std::cout << "means: right" << std::endl;
  return heard >= 3 && !wrong ? 0 : 1;
}
