#include "detector.h"

#include <algorithm>
#include <fstream>
#include <stdexcept>
#include <utility>

namespace detector {
namespace {

constexpr float overlap = 0.3F;

Device device(const std::string& name) {
  if (name == "auto") return Device::automatic;
  if (name == "cpu") return Device::cpu;
  if (name == "cuda") return Device::cuda;
  throw std::invalid_argument("device is '" + name + "', and can be auto, cpu, cuda");
}

std::unique_ptr<Backend> load(const std::string& model, Device where) {
  if (!std::ifstream(model)) throw std::runtime_error("model is '" + model + "', and there is no such file");
  const std::string suffix = ".onnx";
  if (model.size() > suffix.size() && model.compare(model.size() - suffix.size(), suffix.size(), suffix) == 0) {
#ifdef WITH_ONNX_RUNTIME
    return onnx_runtime(model, where);
#endif
  } else {
#ifdef WITH_LIBTORCH
    return libtorch(model, where);
#endif
  }
  (void)where;
  throw std::runtime_error(model + ": the image lacked what runs it when this was built");
}

// What two boxes share of what they cover.
float shared(const Box& one, const Box& two) {
  const float width = std::max(0.F, std::min(one.x2, two.x2) - std::max(one.x1, two.x1));
  const float height = std::max(0.F, std::min(one.y2, two.y2) - std::max(one.y1, two.y1));
  const auto area = [](const Box& box) { return (box.x2 - box.x1) * (box.y2 - box.y1); };
  return width * height / (area(one) + area(two) - width * height);
}

}  // namespace

Detector::Detector(Settings settings)
    : settings_(std::move(settings)), backend_(load(settings_.model, device(settings_.device))) {}

std::vector<Box> Detector::look(const Picture& picture) {
  auto prepared = prepare(picture);
  auto found = select(backend_->run(prepared, settings_.width, settings_.height));
  const float x = static_cast<float>(picture.width) / settings_.width, y = static_cast<float>(picture.height) / settings_.height;
  for (auto& box : found) box = {box.x1 * x, box.y1 * y, box.x2 * x, box.y2 * y, box.score, box.label};
  return found;
}

// Scaled to the model's size; the nearest pixel counts.
std::vector<float> Detector::prepare(const Picture& picture) const {
  const bool red_first = picture.encoding == "rgb8";
  if ((!red_first && picture.encoding != "bgr8") || picture.width == 0 || picture.height == 0 ||
      picture.step < 3 * picture.width || picture.size < picture.step * picture.height) {
    throw std::invalid_argument("no whole picture in rgb8 or bgr8, but " + picture.encoding);
  }
  const std::size_t width = settings_.width, height = settings_.height;
  std::vector<float> found(3 * width * height);
  for (std::size_t y = 0; y < height; ++y) {
    const auto* row = picture.data + y * picture.height / height * picture.step;
    for (std::size_t x = 0; x < width; ++x) {
      const auto* pixel = row + 3 * (x * picture.width / width);
      for (std::size_t color = 0; color < 3; ++color) {
        found[(color * height + y) * width + x] = static_cast<float>(pixel[red_first ? color : 2 - color]) / 255;
      }
    }
  }
  return found;
}

// The best of those that overlap and have the same label.
std::vector<Box> Detector::select(std::vector<Box> boxes) const {
  boxes.erase(std::remove_if(boxes.begin(), boxes.end(), [this](const Box& box) { return !(box.score > settings_.threshold); }),
              boxes.end());
  std::stable_sort(boxes.begin(), boxes.end(), [](const Box& one, const Box& two) { return one.score > two.score; });
  std::vector<Box> found;
  for (const auto& box : boxes) {
    const auto same = [&box](const Box& other) { return other.label == box.label && shared(box, other) > overlap; };
    if (std::none_of(found.begin(), found.end(), same)) found.push_back(box);
  }
  return found;
}

}  // namespace detector
