#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

#include "detector.h"

namespace {

// The model for each backend that the image has.
std::vector<std::string> models() {
  static const std::vector<std::string> made = [] {
    char folder[] = "/tmp/modelsXXXXXX";
    if (mkdtemp(folder) == nullptr) throw std::runtime_error("no folder");
    const std::string place = folder;
    if (std::system(("python3 -m detector.make_model " + place).c_str()) != 0) throw std::runtime_error("no model");
    std::vector<std::string> found;
#ifdef WITH_ONNX_RUNTIME
    found.push_back(place + "/boxes.onnx");
#endif
#ifdef WITH_LIBTORCH
    found.push_back(place + "/boxes.pt");
#endif
    return found;
  }();
  return made;
}

detector::Settings settings(const std::string& model) {
  detector::Settings found;
  found.model = model;
  return found;
}

// Twice as large as the model's pictures, with four bytes of padding behind each row.
struct Image {
  std::uint32_t width = 256, height = 192, step = 3 * 256 + 4;
  std::string encoding = "rgb8";
  std::vector<std::uint8_t> data = std::vector<std::uint8_t>(static_cast<std::size_t>(step) * height, 20);

  void square(std::size_t left, std::size_t top, const std::vector<std::uint8_t>& color) {
    for (auto y = top; y < top + 32; ++y) {
      for (auto x = left; x < left + 32; ++x) std::copy(color.begin(), color.end(), data.begin() + y * step + 3 * x);
    }
  }
};

}  // namespace

TEST(Detector, TwoSquaresAreTwoBoxes) {
  ASSERT_FALSE(models().empty());
  Image image;
  image.square(64, 32, {255, 0, 0});
  image.square(160, 128, {0, 0, 240});
  for (const auto& model : models()) {
    detector::Detector detector(settings(model));
    const auto found = detector.look(detector::picture(image));
    ASSERT_EQ(found.size(), 2U) << detector.about();
    const float corners[2][5] = {{64, 32, 96, 64, 1}, {160, 128, 192, 160, 240.F / 255}};
    for (int label = 0; label < 2; ++label) {
      const auto& box = found[label];
      EXPECT_EQ(box.label, label);
      const float values[] = {box.x1, box.y1, box.x2, box.y2, box.score};
      for (int i = 0; i < 5; ++i) EXPECT_NEAR(values[i], corners[label][i], 1e-4) << detector.about();
    }
    image.encoding = "bgr8";  // what was red is blue
    EXPECT_EQ(detector.look(detector::picture(image)).front().label, 1);
    image.encoding = "rgb8";
  }
}

#if defined(WITH_ONNX_RUNTIME) && defined(WITH_LIBTORCH)
TEST(Detector, BackendsSayTheSame) {
  std::vector<float> noise(3 * 96 * 128);
  for (std::size_t i = 0; i < noise.size(); ++i) noise[i] = static_cast<float>(i * 7919 % 251) / 250;
  const auto one = detector::onnx_runtime(models()[0], detector::Device::cpu)->run(noise, 128, 96);
  const auto two = detector::libtorch(models()[1], detector::Device::cpu)->run(noise, 128, 96);
  ASSERT_EQ(one.size(), 2U * 11 * 15);
  ASSERT_EQ(one.size(), two.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].x1, two[i].x1);
    EXPECT_EQ(one[i].label, two[i].label);
    EXPECT_NEAR(one[i].score, two[i].score, 1e-4);
  }
}
#endif

TEST(Detector, RefusesWhatItCannotUse) {
  auto image = Image();
  image.encoding = "mono16";
  EXPECT_THROW(detector::Detector(settings(models().front())).look(detector::picture(image)), std::invalid_argument);
  auto wrong = settings(models().front());
  wrong.device = "gpu";
  EXPECT_THROW(detector::Detector{wrong}, std::invalid_argument);
}

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
