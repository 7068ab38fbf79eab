#include <nodelet/nodelet.h>
#include <pluginlib/class_list_macros.hpp>
#include <ros/ros.h>
#include <std_msgs/String.h>
#include <torch/version.h>

#include <memory>

#include "model.h"

namespace bright {

// Hears `image`, and publishes `place`. In one process with the camera's nodelet, no picture is copied between them.
class Nodelet : public nodelet::Nodelet {
  void onInit() override {
    model_ = std::make_unique<Model>(torch::jit::load(getPrivateNodeHandle().param<std::string>("model", "model.pt")));
    NODELET_INFO("PyTorch %s on %s", TORCH_VERSION, model_->device().str().c_str());
    publisher_ = getNodeHandle().advertise<std_msgs::String>("place", 1);
    subscriber_ = getNodeHandle().subscribe("image", 1, &Nodelet::look, this);
  }

  void look(const sensor_msgs::ImageConstPtr& image) try {
    std_msgs::String place;
    place.data = model_->place(*image);
    publisher_.publish(place);
  } catch (const std::invalid_argument& error) {
    NODELET_ERROR_THROTTLE(5, "%s", error.what());
  }

  std::unique_ptr<Model> model_;
  ros::Publisher publisher_;
  ros::Subscriber subscriber_;
};

}  // namespace bright

PLUGINLIB_EXPORT_CLASS(bright::Nodelet, nodelet::Nodelet)
