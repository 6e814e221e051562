// SPDX-License-Identifier: MIT
#include "augicp/match/pair_filter.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "augicp/core/check.h"
#include "augicp/match/agreement.h"

namespace augicp {

void Gates::check() const {
  require(max_distance > 0.0, "max_distance", max_distance, "must be above 0");
  require(max_angle > 0.0, "max_angle", max_angle, "must be above 0");
}

void AgreementTolerance::check() const {
  require_not_negative("tolerance.distance", distance);
  require_not_negative("tolerance.per_depth", per_depth);
  require(distance + per_depth > 0.0, "tolerance.distance", distance, "must be above 0 where per_depth is not");
  require(min_cosine >= -1.0 && min_cosine <= 1.0, "tolerance.min_cosine", min_cosine, "must be from -1 to 1");
}

PairFilter::PairFilter(const Cloud& source, const Cloud& target, const Rigid3& target_from_source, const Gates& gates)
    : source_(source),
      target_(target),
      rotation_(target_from_source.rotation.toRotationMatrix().cast<float>()),
      translation_(target_from_source.translation.cast<float>()),
      max_distance_sq_(static_cast<float>(gates.max_distance * gates.max_distance)),
      min_cosine_(static_cast<float>(std::cos(std::min(gates.max_angle, std::numbers::pi)))),
      compares_angles_(gates.max_angle < std::numbers::pi && source.has_directions() && target.has_directions()),
      same_structure_(gates.same_structure && source.has_directions() && target.has_directions()),
      signed_normals_(normals_have_signs(source, target)) {}

}  // namespace augicp
