#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "backend.h"

namespace detector {

// A picture as sensor_msgs/Image has it, of either ROS.
struct Picture {
  const std::uint8_t* data;
  std::size_t size, width, height, step;
  std::string encoding;
};

template <typename Image>
Picture picture(const Image& image) {
  return {image.data.data(), image.data.size(), image.width, image.height, image.step, image.encoding};
}

struct Settings {
  std::string model;             // the file: .onnx for ONNX Runtime, any other for PyTorch
  double threshold = 0.6;        // boxes with a lower score do not count
  std::string device = "auto";   // or cpu, cuda
  int width = 128, height = 96;  // what the model takes
};

// A model, and what is around it. With another model, change `prepare` and `select`.
class Detector {
 public:
  // Throws std::exception if the model cannot be loaded, or if there is no such device.
  explicit Detector(Settings settings);

  // What is in a picture, in its pixels; the surest comes first. Throws std::invalid_argument for encodings other than rgb8 and bgr8.
  std::vector<Box> look(const Picture& picture);

  std::string about() const { return backend_->about(); }

 private:
  std::vector<float> prepare(const Picture& picture) const;
  std::vector<Box> select(std::vector<Box> boxes) const;

  Settings settings_;
  std::unique_ptr<Backend> backend_;
};

}  // namespace detector
