// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string_view>

#include "augicp/geometry/rigid3.h"

namespace augicp {

// The motion of tx ty tz qx qy qz qw, metres, a quaternion of unit length to within 1e-3: files carry as few as four
// digits. Its length is made 1; one that already has it to the last digits is kept bit for bit, so that what was
// written with all digits is read back as it was. Throws std::invalid_argument "what: expected ..., found ...".
Rigid3 pose_of_numbers(std::string_view what, std::span<const double, 7> numbers);

}  // namespace augicp
