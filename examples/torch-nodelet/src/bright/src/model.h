#pragma once

#include <sensor_msgs/Image.h>
#include <torch/script.h>

#include <string>

namespace bright {

// A model in TorchScript: it takes 1 x 3 x height x width between 0 and 1, and gives 1 x 3 scores. On the GPU if there is one.
class Model {
 public:
  explicit Model(torch::jit::Module module);

  // In which third of a picture, in the encoding rgb8, something bright is: left, middle or right.
  std::string place(const sensor_msgs::Image& image);

  const torch::Device& device() const { return device_; }

 private:
  torch::Device device_;
  torch::jit::Module module_;
};

}  // namespace bright
