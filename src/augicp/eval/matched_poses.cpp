// SPDX-License-Identifier: MIT
#include "augicp/eval/matched_poses.h"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>

namespace augicp {
namespace {

std::vector<MatchedPose> nearest(const Trajectory& estimate, const Trajectory& truth,
                                 const AssociationOptions& options) {
  std::vector<MatchedPose> poses;
  for (const StampPair& pair : associate(estimate, truth, options))
    poses.push_back({estimate[pair.estimate].stamp_s + options.time_offset_s, estimate[pair.estimate].world_from_camera,
                     truth[pair.truth].world_from_camera});
  return poses;
}

std::vector<MatchedPose> interpolated(const Trajectory& estimate, const Trajectory& truth,
                                      const AssociationOptions& options) {
  options.check();
  std::vector<MatchedPose> poses;
  for (const StampedPose& pose : estimate) {
    const double stamp_s = pose.stamp_s + options.time_offset_s;
    if (const auto true_pose = pose_at(truth, stamp_s, 2.0 * options.max_difference_s))
      poses.push_back({stamp_s, pose.world_from_camera, *true_pose});
  }
  return poses;
}

Trajectory with_stamps_divided(Trajectory trajectory, double divisor) {
  for (StampedPose& pose : trajectory) pose.stamp_s /= divisor;
  return trajectory;
}

struct Unit {
  const char* name;
  double a_second;
};
constexpr Unit kUnits[] = {{"milliseconds", 1e3}, {"microseconds", 1e6}, {"nanoseconds", 1e9}};

// The trajectory whose stamps are not in seconds, if any: in another unit half of the shorter trajectory would match,
// and five times as many poses as now. A few milliseconds can match the truth's seconds by chance, near the zero of
// both.
std::optional<std::string> wrong_unit(const Trajectory& estimate, const Trajectory& truth,
                                      const AssociationOptions& options, std::size_t num_matched) {
  const std::size_t shorter = std::min(estimate.size(), truth.size());
  const std::size_t enough = std::max({std::size_t{2}, (shorter + 1) / 2, 5 * num_matched});
  if (enough > shorter) return std::nullopt;
  for (const Unit& unit : kUnits) {
    const auto sentence = [&](const char* whose) {
      return std::string("the stamps of the ") + whose + " are " + unit.name + ", it seems, not seconds";
    };
    if (associate(with_stamps_divided(estimate, unit.a_second), truth, options).size() >= enough)
      return sentence("estimate");
    if (associate(estimate, with_stamps_divided(truth, unit.a_second), options).size() >= enough)
      return sentence("truth");
  }
  return std::nullopt;
}

// Advice if nothing matches in any unit: the clocks differ, and perhaps the units too.
std::string advice(const Trajectory& estimate, const Trajectory& truth) {
  const auto duration = [](const Trajectory& t) { return t.empty() ? 0.0 : t.back().stamp_s - t.front().stamp_s; };
  const double ratio = duration(estimate) / duration(truth);
  const auto is_about = [](double a, double b) { return a > 0.5 * b && a < 2.0 * b; };
  for (const Unit& unit : kUnits) {
    if (is_about(ratio, unit.a_second)) return std::string("are the estimate's in ") + unit.name + "?";
    if (is_about(1.0 / ratio, unit.a_second)) return std::string("are the truth's in ") + unit.name + "?";
  }
  return "are both in seconds and of one clock, or is there a time offset?";
}

std::string span_text(const Trajectory& trajectory) {
  if (trajectory.empty()) return "has no poses";
  return "spans " + std::to_string(trajectory.front().stamp_s) + " .. " + std::to_string(trajectory.back().stamp_s) +
         " s";
}

std::string mismatch_text(const Trajectory& estimate, const Trajectory& truth, const AssociationOptions& options,
                          std::size_t num_matched, const std::optional<std::string>& unit) {
  return (num_matched == 0 ? "no" : "only " + std::to_string(num_matched)) + " common timestamps within " +
         std::to_string(options.max_difference_s) + " s: the estimate " + span_text(estimate) + ", the truth " +
         span_text(truth) + "; " + unit.value_or(advice(estimate, truth));
}

}  // namespace

std::vector<MatchedPose> match_poses(const Trajectory& estimate, const Trajectory& truth,
                                     const AssociationOptions& options, TruthReading reading) {
  check_order(estimate);
  check_order(truth);
  const bool is_nearest = reading == TruthReading::Nearest;
  std::vector<MatchedPose> poses =
      is_nearest ? nearest(estimate, truth, options) : interpolated(estimate, truth, options);
  const std::optional<std::string> unit = wrong_unit(estimate, truth, options, poses.size());
  if (poses.empty() || unit) throw std::invalid_argument(mismatch_text(estimate, truth, options, poses.size(), unit));
  return poses;
}

}  // namespace augicp
