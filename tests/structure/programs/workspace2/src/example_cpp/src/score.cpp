// Publishes a message that was generated in the same workspace, and hears it.
#include <example_msgs/msg/score.hpp>
#include <rclcpp/rclcpp.hpp>

#include <chrono>
#include <iostream>

int main(int argc, char** argv) {
  using example_msgs::msg::Score;
  using namespace std::chrono_literals;
  rclcpp::init(argc, argv);
  const auto node = std::make_shared<rclcpp::Node>("score");
  std::string heard;
  const auto subscription =
      node->create_subscription<Score>("scores", 10, [&](Score::ConstSharedPtr score) { heard = score->label; });
  const auto publisher = node->create_publisher<Score>("scores", 10);
  Score score;
  score.label = "c++";
  score.scores = {0.5f};
  for (int i = 0; i < 300 && heard.empty(); ++i) {
    publisher->publish(score);
    rclcpp::spin_some(node);
    rclcpp::sleep_for(100ms);
  }
  rclcpp::shutdown();
  std::cout << "score: " << heard << std::endl;
  return heard == "c++" ? 0 : 1;
}
