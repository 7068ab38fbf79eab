// node talk TOPIC TEXT: publishes TEXT until it is stopped. node listen TOPIC: prints one message and ends.
#include <ros/ros.h>
#include <ros/topic.h>
#include <std_msgs/String.h>

#include <iostream>
#include <string>

int main(int argc, char** argv) {
  const std::string action = argv[1];
  ros::init(argc, argv, action, ros::init_options::AnonymousName);
  ros::NodeHandle node;
  if (action == "listen") {
    const auto message = ros::topic::waitForMessage<std_msgs::String>(argv[2], node, ros::Duration(20));
    if (!message) return 1;
    std::cout << message->data << std::endl;
    return 0;
  }
  auto publisher = node.advertise<std_msgs::String>(argv[2], 1);
  std_msgs::String message;
  message.data = argv[3];
  for (ros::Rate rate(20); ros::ok(); rate.sleep()) publisher.publish(message);
}
