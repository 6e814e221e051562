// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "augicp/io/trajectory_file.h"

namespace augicp {

// Takes the poses of a file in its order, by the rules of every form: stamps increase, and of equal ones the first pose
// is kept, with a warning.
class TrajectoryBuilder {
 public:
  // Throws std::invalid_argument, for a message that names the line, if the stamp is below the one before, or too large
  // for seconds.
  void add(const StampedPose& pose, std::uint64_t line);

  // REQUIRES: once.
  TrajectoryFile finished();

 private:
  TrajectoryFile file_;
  std::uint64_t first_repeated_ = 0;
};

// timestamp tx ty tz qx qy qz qw.
using PoseNumbers = std::array<double, 8>;

// A pose of a table whose stamps have another unit than seconds. Throws std::invalid_argument for a quaternion that is
// not of unit length.
StampedPose pose_of_table(const PoseNumbers& numbers, double stamps_per_s);

// Stamps a second of the usual unit in which the largest stamp is a time since 1970, and below it since any start.
double stamps_per_s_by_magnitude(double largest_stamp);

// A sentence that says how the stamps are read; empty for seconds.
std::string unit_sentence(double stamps_per_s);

}  // namespace augicp
