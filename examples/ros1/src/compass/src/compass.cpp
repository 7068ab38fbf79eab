#include "compass/compass.h"

#include <angles/angles.h>

#include <array>
#include <cmath>

namespace compass {

std::string direction(double heading) {
  static const std::array<const char*, 4> names{"east", "north", "west", "south"};
  const double quarters = angles::normalize_angle_positive(heading) / (M_PI / 2);
  return names[static_cast<std::size_t>(std::lround(quarters)) % names.size()];
}

}  // namespace compass
