// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string_view>

#include "augicp/geometry/rigid3.h"

namespace augicp {

// The motion of tx ty tz qx qy qz qw: metres, and a quaternion of unit length to within 1e-3, because files may have as
// few as four digits. The quaternion is normalised. One that is normalised to the last digits stays bit-identical, so
// that numbers written with all digits read back unchanged. Throws std::invalid_argument "what: expected ..., found
// ...".
Rigid3 pose_of_numbers(std::string_view what, std::span<const double, 7> numbers);

}  // namespace augicp
