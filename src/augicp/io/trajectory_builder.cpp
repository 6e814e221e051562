// SPDX-License-Identifier: MIT
#include "augicp/io/trajectory_builder.h"

#include <cmath>
#include <span>
#include <stdexcept>
#include <utility>

#include "augicp/io/format.h"
#include "augicp/io/pose_numbers.h"

namespace augicp {
namespace {

const char* unit_name(double stamps_per_s) {
  return stamps_per_s == 1e3 ? "milliseconds" : stamps_per_s == 1e6 ? "microseconds" : "nanoseconds";
}

}  // namespace

void TrajectoryBuilder::add(const StampedPose& pose, std::uint64_t line) {
  Trajectory& before = file_.trajectory;
  if (std::abs(pose.stamp_s) > kMaxStamp_s)
    throw std::invalid_argument(fmt::format("expected a timestamp in seconds, found {}: {}?", pose.stamp_s,
                                            unit_name(stamps_per_s_by_magnitude(std::abs(pose.stamp_s)))));
  if (!before.empty() && pose.stamp_s < before.back().stamp_s)
    throw std::invalid_argument(
        fmt::format("expected timestamps that increase, found {} after {}", pose.stamp_s, before.back().stamp_s));
  if (before.empty() || pose.stamp_s != before.back().stamp_s) {
    before.push_back(pose);
  } else if (file_.num_repeated++ == 0) {
    first_repeated_ = line;
  }
}

TrajectoryFile TrajectoryBuilder::finished() {
  if (file_.num_repeated > 0)
    file_.warnings.push_back(
        fmt::format("{} poses repeat the stamp before, first in line {}: of equal stamps the first pose is kept",
                    file_.num_repeated, first_repeated_));
  return std::move(file_);
}

StampedPose pose_of_table(const PoseNumbers& numbers, double stamps_per_s) {
  return {numbers[0] / stamps_per_s, pose_of_numbers("pose", std::span(numbers).subspan<1>())};
}

double stamps_per_s_by_magnitude(double largest_stamp) {
  if (largest_stamp <= kMaxStamp_s) return 1.0;
  return largest_stamp < 1e14 ? 1e3 : largest_stamp < 1e17 ? 1e6 : 1e9;
}

std::string unit_sentence(double stamps_per_s) {
  return stamps_per_s == 1.0 ? "" : fmt::format("the stamps are read as {}", unit_name(stamps_per_s));
}

}  // namespace augicp
