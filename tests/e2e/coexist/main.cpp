// coexist SCRIPT SAVED_MODEL: sends itself a picture through ROS, turns it into OpenCV's with cv_bridge, and lets a model
// of each framework look at it, on ROS's own threads; then ends cleanly.
#include "models.h"

#include <cv_bridge/cv_bridge.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <cmath>
#include <iostream>
#include <opencv2/core.hpp>

int main(int argc, char** argv) {
  ros::init(argc, argv, "coexist");
  ros::NodeHandle node;
  int seen = 0, wrong = 0;
  const auto look = [&](const sensor_msgs::ImageConstPtr& message) {
    const cv::Mat picture = cv_bridge::toCvShare(message, "mono8")->image;
    const float mean = static_cast<float>(cv::mean(picture)[0]);
    std::vector<float> numbers(picture.begin<uchar>(), picture.end<uchar>());
    for (const float found : {torch_mean(argv[1], numbers), tensorflow_mean(argv[2], numbers)})
      if (std::abs(found - mean) > 1e-3f) ++wrong;
    ++seen;
  };
  const auto subscriber = node.subscribe<sensor_msgs::Image>("pictures", 1, look);
  const auto publisher = node.advertise<sensor_msgs::Image>("pictures", 1);
  cv::Mat picture(12, 16, CV_8UC1);
  ros::AsyncSpinner spinner(2);
  spinner.start();
  ros::Rate rate(20);
  for (int i = 0; i < 600 && seen < 3; ++i, rate.sleep()) {
    picture.setTo(i % 256);
    picture.at<uchar>(0, 0) = 255;
    publisher.publish(cv_bridge::CvImage(std_msgs::Header(), "mono8", picture).toImageMsg());
  }
  spinner.stop();
  std::cout << "pictures: " << (seen >= 3 ? "seen" : "none") << ", wrong: " << wrong << std::endl;
  return seen >= 3 && wrong == 0 ? 0 : 1;
}
