// SPDX-License-Identifier: MIT
#include "augicp/io/pose_numbers.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "augicp/io/format.h"

namespace augicp {

Rigid3 pose_of_numbers(std::string_view what, std::span<const double, 7> numbers) {
  const Vec3d translation(numbers[0], numbers[1], numbers[2]);
  if (!translation.allFinite()) throw std::invalid_argument(fmt::format("{}: its translation is not finite", what));
  const Eigen::Quaterniond rotation(numbers[6], numbers[3], numbers[4], numbers[5]);  // w is last in files
  constexpr double kTolerance = 1e-3;
  const double length = rotation.norm();
  if (!(std::abs(length - 1.0) <= kTolerance))
    throw std::invalid_argument(
        fmt::format("{}: expected a quaternion qx qy qz qw of length 1, found length {}", what, length));
  // Rounding error of the normalisation of four squares and their sum.
  constexpr double kRounding = 8.0 * std::numeric_limits<double>::epsilon();
  return {std::abs(length - 1.0) <= kRounding ? rotation : rotation.normalized(), translation};
}

}  // namespace augicp
