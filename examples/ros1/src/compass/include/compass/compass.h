#pragma once

#include <string>

namespace compass {

// The direction of a heading in radians, counterclockwise from the east: east, north, west or south.
std::string direction(double heading);

}  // namespace compass
