#include <ros/ros.h>
#include <std_msgs/Float64.h>
#include <std_msgs/String.h>

#include "compass/compass.h"

int main(int argc, char** argv) {
  ros::init(argc, argv, "compass");
  ros::NodeHandle node;
  auto publisher = node.advertise<std_msgs::String>("direction", 1, true);
  const boost::function<void(const std_msgs::Float64::ConstPtr&)> tell = [&publisher](const auto& heading) {
    std_msgs::String direction;
    direction.data = compass::direction(heading->data);
    publisher.publish(direction);
  };
  auto subscriber = node.subscribe<std_msgs::Float64>("heading", 1, tell);
  ros::spin();
}
