#include <gtest/gtest.h>

#include <stdexcept>

#include "model.h"

namespace {

torch::jit::Module brightest_third() {
  torch::jit::Module module("brightest_third");
  module.define("def forward(self, x):\n  return torch.adaptive_avg_pool2d(x.mean([1]), [1, 3]).flatten(1)\n");
  return module;
}

// A dark picture with a bright column, and four bytes of padding behind each row.
sensor_msgs::Image picture(std::uint32_t bright_column) {
  sensor_msgs::Image image;
  image.height = 20;
  image.width = 30;
  image.encoding = "rgb8";
  image.step = 3 * image.width + 4;
  image.data.resize(image.step * image.height);
  for (std::uint32_t row = 0; row < image.height; ++row) {
    for (std::uint32_t color = 0; color < 3; ++color) image.data[row * image.step + 3 * bright_column + color] = 255;
  }
  return image;
}

}  // namespace

TEST(Model, SaysWhereSomethingBrightIs) {
  bright::Model model(brightest_third());
  EXPECT_EQ(model.place(picture(3)), "left");
  EXPECT_EQ(model.place(picture(14)), "middle");
  EXPECT_EQ(model.place(picture(29)), "right");
}

TEST(Model, RefusesOtherEncodings) {
  auto image = picture(3);
  image.encoding = "mono16";
  EXPECT_THROW(bright::Model(brightest_third()).place(image), std::invalid_argument);
}

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
