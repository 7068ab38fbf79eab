// beside MODEL: takes numbers out of a message of ROS, as it comes over the network, and has ONNX Runtime and each framework compute
// their mean on threads of the program, twice; then ends cleanly.
#include <onnxruntime_cxx_api.h>

#include <cmath>
#include <functional>
#include <future>
#include <iostream>
#include <vector>

#include "means.h"

#if WITH_ROS == 1
#include <ros/ros.h>
#include <std_msgs/Float32MultiArray.h>
#elif WITH_ROS == 2
#include <rclcpp/rclcpp.hpp>
#include <rclcpp/serialization.hpp>
#include <std_msgs/msg/float32_multi_array.hpp>
#endif

using Numbers = std::vector<float>;

Numbers received(int argc, char** argv, const Numbers& numbers) {
#if WITH_ROS == 1
  ros::init(argc, argv, "beside");
  ros::Time::init();
  std_msgs::Float32MultiArray sent, message;
  sent.data = numbers;
  auto bytes = ros::serialization::serializeMessage(sent);
  ros::serialization::deserializeMessage(bytes, message);
  return message.data;
#elif WITH_ROS == 2
  rclcpp::init(argc, argv);
  const auto node = std::make_shared<rclcpp::Node>("beside");
  std_msgs::msg::Float32MultiArray sent, message;
  sent.data = numbers;
  rclcpp::SerializedMessage bytes;
  rclcpp::Serialization<std_msgs::msg::Float32MultiArray> serialization;
  serialization.serialize_message(&sent, &bytes);
  serialization.deserialize_message(&bytes, &message);
  rclcpp::shutdown();
  return message.data;
#else
  (void)argc, (void)argv;
  return numbers;
#endif
}

float onnxruntime_mean(Ort::Session& session, Numbers numbers) {
  const int64_t shape[] = {1, static_cast<int64_t>(numbers.size())};
  const auto memory = Ort::MemoryInfo::CreateCpu(OrtArenaAllocator, OrtMemTypeDefault);
  const auto tensor = Ort::Value::CreateTensor<float>(memory, numbers.data(), numbers.size(), shape, 2);
  const char *const input = "x", *const output = "y";
  return *session.Run(Ort::RunOptions{}, &input, &tensor, 1, &output, 1).front().GetTensorData<float>();
}

int main(int argc, char** argv) {
  const Numbers numbers = received(argc, argv, {1.f, 2.f, 3.f, 4.f});
  Ort::Env env(ORT_LOGGING_LEVEL_WARNING, "beside");
  Ort::Session session(env, argv[1], Ort::SessionOptions{});
  std::vector<std::future<float>> means;
  const auto compute = [&](const std::function<float()>& mean) { means.push_back(std::async(std::launch::async, mean)); };
  for (int round = 0; round < 2; ++round) {
    compute([&] { return onnxruntime_mean(session, numbers); });
#ifdef WITH_TORCH
    compute([&] { return torch_mean(numbers); });
#endif
#ifdef WITH_TENSORFLOW
    compute([&] { return tensorflow_mean(numbers); });
#endif
  }
  for (auto& mean : means)
    if (const float found = mean.get(); std::abs(found - 2.5f) > 1e-6f) return std::cout << found << " is wrong" << std::endl, 1;
  std::cout << means.size() << " means: right" << std::endl;
}
