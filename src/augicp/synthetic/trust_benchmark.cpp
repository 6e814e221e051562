// SPDX-License-Identifier: MIT
#include "augicp/synthetic/trust_benchmark.h"

#include <algorithm>
#include <cmath>

#include "augicp/core/angles.h"
#include "augicp/registration/registration.h"
#include "augicp/testing/degenerate_families.h"

namespace augicp::synthetic {
namespace {

constexpr double kMaxAxisError = 5.0 * kRadPerDeg;

bool is_named(const TrustPair& pair, const AlignResult& result) {
  if (result.free_motions.size() != pair.free_motions.size()) return false;
  const testing::DegenerateFamily truth{"", {}, pair.free_motions, 0.0};
  const Observability& seen = result.observability;
  std::vector<Vec6d> found;
  for (std::size_t k = 0; k < pair.free_motions.size(); ++k)
    found.push_back(seen.directions.col(static_cast<Eigen::Index>(k)));
  return testing::angle_to_free(truth, found, seen.gyration, seen.centroid) < kMaxAxisError;
}

// About the paired points' centroid, in gyration radii.
Vec6d in_gyrations(const Vec6d& increment, const Observability& seen) {
  Vec6d scaled = increment;
  scaled.head<3>() = (increment.head<3>() + increment.tail<3>().cross(seen.centroid)) / seen.gyration;
  return scaled;
}

}  // namespace

double move_along_free(const AlignResult& result, const Rigid3& guess, const Cloud& source, const Cloud& target) {
  const Vec6d moved = increment_between(without_origins(guess, source, target),
                                        without_origins(result.target_from_source, source, target));
  double sum_sq = 0.0;
  for (std::size_t k = 0; k < result.free_motions.size(); ++k) {
    const Vec6d direction =
        in_gyrations(result.observability.directions.col(static_cast<Eigen::Index>(k)), result.observability);
    const double along = direction.normalized().dot(in_gyrations(moved, result.observability));
    sum_sq += along * along;
  }
  return std::sqrt(sum_sq);
}

void count_pair(const TrustPair& pair, const PoseError& right, const AlignResult& result, TrustRow& row) {
  const bool is_right =
      pair.target_from_source && is_within(pose_error(result.target_from_source, *pair.target_from_source), right);
  ++row.num_pairs;
  if (result.status == AlignStatus::Degenerate) {
    ++row.degenerate;
    row.named += is_named(pair, result);
    row.largest_move =
        std::max(row.largest_move, move_along_free(result, pair.guess, pair.source.cloud, pair.target.cloud));
  } else if (name_of(result.status) == "ambiguous") {
    ++row.ambiguous;
  } else if (result.status == AlignStatus::Converged) {
    ++(is_right ? row.right_converged : row.wrong_converged);
  } else {
    ++(is_right ? row.right_refused : row.wrong_refused);
  }
}

TrustRow run_trust(const TrustFamily& family, unsigned first_seed, int num_pairs, const RegistrationOptions& options,
                   const std::function<void(unsigned seed, const AlignResult&)>& on_pair) {
  TrustRow row;
  row.family = family.name;
  for (int k = 0; k < num_pairs; ++k) {
    const unsigned seed = first_seed + static_cast<unsigned>(k);
    const TrustPair pair = family.draw(seed);
    const AlignResult result = register_scans(pair.source, pair.target, pair.guess, options).result;
    count_pair(pair, family.right, result, row);
    if (on_pair) on_pair(seed, result);
  }
  return row;
}

}  // namespace augicp::synthetic
