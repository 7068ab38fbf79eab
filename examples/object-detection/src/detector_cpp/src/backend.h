#pragma once

#include <memory>
#include <string>
#include <vector>

namespace detector {

struct Box {
  float x1, y1, x2, y2, score;
  int label;
};

enum class Device { automatic, cpu, cuda };

// A model that is loaded. It takes red, green and blue between 0 and 1, 3 x height x width, and gives all boxes, in its own pixels.
class Backend {
 public:
  virtual ~Backend() = default;
  virtual std::vector<Box> run(std::vector<float>& picture, int width, int height) = 0;
  // By what and where it runs, such as "ONNX Runtime 1.23.2 on cpu".
  virtual std::string about() const = 0;
};

// Each is there if the image has what it needs. They throw if the file is no model, or if there is no GPU for Device::cuda.
std::unique_ptr<Backend> onnx_runtime(const std::string& model, Device device);
std::unique_ptr<Backend> libtorch(const std::string& model, Device device);

// The boxes of a model's result, N x 6: x1, y1, x2, y2, score, label.
inline std::vector<Box> boxes(const float* rows, std::size_t count) {
  std::vector<Box> found;
  for (const float* row = rows; row != rows + 6 * count; row += 6) {
    found.push_back({row[0], row[1], row[2], row[3], row[4], static_cast<int>(row[5])});
  }
  return found;
}

}  // namespace detector
