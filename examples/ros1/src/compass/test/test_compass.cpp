#include <gtest/gtest.h>

#include <cmath>

#include "compass/compass.h"

TEST(Compass, Quarters) {
  EXPECT_EQ(compass::direction(0), "east");
  EXPECT_EQ(compass::direction(M_PI / 2), "north");
  EXPECT_EQ(compass::direction(M_PI), "west");
  EXPECT_EQ(compass::direction(-M_PI / 2), "south");
}

TEST(Compass, NearlyEast) { EXPECT_EQ(compass::direction(2 * M_PI - 0.1), "east"); }

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
