// A message that was generated in the same workspace, as ROS sends it.
#include <example_msgs/Score.h>
#include <ros/serialization.h>

#include <iostream>

int main() {
  example_msgs::Score sent, received;
  sent.label = "c++";
  sent.scores = {0.5f, 0.25f};
  const auto buffer = ros::serialization::serializeMessage(sent);
  ros::serialization::IStream stream(buffer.message_start, buffer.num_bytes - 4); // after the length
  ros::serialization::deserialize(stream, received);
  std::cout << "score: " << received.label << " " << received.scores.at(1) << std::endl;
}
