// SPDX-License-Identifier: MIT
#include "augicp/experiment/global.h"

#include <algorithm>

#include "augicp/core/check.h"
#include "augicp/core/median.h"
#include "augicp/experiment/random.h"
#include "augicp/match/ray_spacing.h"
#include "augicp/registration/registration.h"

namespace augicp {
namespace {

constexpr double kOverlapDistance = 0.05;  // metres
constexpr double kLittleOverlap = 0.1, kOverlap = 0.3;

Rigid3 motion_anywhere(std::mt19937& generator, double distance_m) {
  Rigid3 motion;
  motion.rotation =
      Eigen::Quaterniond(gaussian(generator), gaussian(generator), gaussian(generator), gaussian(generator))
          .normalized();
  motion.translation = uniform(generator, 0.0, distance_m) * random_direction(generator);
  return motion;
}

GlobalOutcome registered(const GlobalPair& pair, std::mt19937& generator, const GlobalOptions& options,
                         const std::function<double()>& now_ms) {
  const Rigid3 motion = motion_anywhere(generator, robust_extent(scan_of(*pair.target)));
  Cloud placed = *pair.source;
  placed.viewpoint = assumed_place(placed);
  Cloud source = transform(placed, motion);
  const double begin_ms = now_ms();
  const AlignResult result =
      register_scans(scan_of(std::move(source)), scan_of(*pair.target), {}, options.registration).result;
  GlobalOutcome outcome{pair.family,   pair.source_name,    pair.target_name,  {},
                        result.status, now_ms() - begin_ms, pair.length_scale, result.evidence};
  if (pair.target_from_source) outcome.error = pose_error(result.target_from_source * motion, *pair.target_from_source);
  return outcome;
}

bool is_within_scaled(const GlobalOutcome& outcome, const PoseError& limit) {
  return outcome.error && is_within(*outcome.error, {outcome.length_scale * limit.translation, limit.rotation});
}

void add(const GlobalOutcome& outcome, const GlobalOptions& options, GlobalRow& row) {
  const bool is_found = is_within_scaled(outcome, options.found);
  ++row.num_pairs;
  row.num_found += is_found;
  row.num_fine += is_within_scaled(outcome, options.fine);
  if (outcome.status == AlignStatus::Converged)
    ++(is_found ? row.right_converged : row.wrong_converged);
  else
    ++(outcome.status == AlignStatus::Ambiguous ? row.ambiguous : row.others);
}

}  // namespace

void GlobalOptions::check() const {
  require(num_rotations >= 1, "num_rotations", num_rotations, "must be at least 1");
  registration.check();
}

std::vector<GlobalOutcome> run_global(std::span<const GlobalPair> pairs, const GlobalOptions& options,
                                      const std::function<double()>& now_ms, const std::function<void()>& on_pair) {
  options.check();
  std::mt19937 generator(options.seed);
  std::vector<GlobalOutcome> outcomes;
  for (const GlobalPair& pair : pairs)
    for (int k = 0; k < options.num_rotations; ++k) {
      outcomes.push_back(registered(pair, generator, options, now_ms));
      on_pair();
    }
  return outcomes;
}

std::vector<GlobalRow> summary(std::span<const GlobalOutcome> outcomes, const GlobalOptions& options) {
  std::vector<GlobalRow> rows;
  for (const GlobalOutcome& first : outcomes) {
    const auto is_known = [&](const GlobalRow& row) { return row.family == first.family; };
    if (std::any_of(rows.begin(), rows.end(), is_known)) continue;
    GlobalRow row;
    row.family = first.family;
    std::vector<double> distances, angles, times;
    for (const GlobalOutcome& outcome : outcomes) {
      if (outcome.family != first.family) continue;
      add(outcome, options, row);
      times.push_back(outcome.time_ms);
      if (!is_within_scaled(outcome, options.found)) continue;
      distances.push_back(outcome.error->translation);
      angles.push_back(outcome.error->rotation);
    }
    row.median_ms = upper_median(std::move(times));
    if (!distances.empty()) row.median_error = {upper_median(std::move(distances)), upper_median(std::move(angles))};
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<GlobalPair> pairs_of_fragments(const std::string& name, const std::vector<Fragment>& fragments,
                                           std::size_t frames_each) {
  std::vector<GlobalPair> pairs;
  for (const Fragment& target : fragments)
    for (const Fragment& source : fragments) {
      if (source.first_frame < target.first_frame + frames_each) continue;
      const Rigid3 truth = inverse(target.world_from_fragment) * source.world_from_fragment;
      const double overlap = overlap_of(source.cloud, target.cloud, truth, kOverlapDistance);
      if (overlap < kLittleOverlap) continue;
      pairs.push_back({name + (overlap < kOverlap ? " 10-30 %" : " 30 %"), std::to_string(source.first_frame),
                       std::to_string(target.first_frame), &source.cloud, &target.cloud, truth, 1.0});
    }
  return pairs;
}

}  // namespace augicp
