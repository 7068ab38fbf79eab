#include "model.h"

#include <torch/cuda.h>

#include <array>
#include <stdexcept>
#include <utility>

namespace bright {

Model::Model(torch::jit::Module module)
    : device_(torch::cuda::is_available() ? torch::kCUDA : torch::kCPU), module_(std::move(module)) {
  module_.to(device_);
  module_.eval();
}

std::string Model::place(const sensor_msgs::Image& image) {
  static const std::array<const char*, 3> places{"left", "middle", "right"};
  if (image.encoding != "rgb8" || image.step < 3 * image.width || image.data.size() < image.step * image.height) {
    throw std::invalid_argument("no whole picture in rgb8, but " + image.encoding);
  }
  const c10::InferenceMode guard;
  const auto pixels = torch::from_blob(const_cast<std::uint8_t*>(image.data.data()), {image.height, image.width, 3},
                                       {image.step, 3, 1}, torch::kUInt8);
  const auto picture = pixels.to(device_).permute({2, 0, 1}).unsqueeze(0).to(torch::kFloat) / 255;
  return places.at(module_.forward({picture}).toTensor().argmax().item<int64_t>());
}

}  // namespace bright
