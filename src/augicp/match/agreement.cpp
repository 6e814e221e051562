// SPDX-License-Identifier: MIT
#include "augicp/match/agreement.h"

#include <cmath>

namespace augicp {
namespace {

constexpr double kMinDeviations = 4.0;

bool is_visible(PointAgreement point) { return point != PointAgreement::Hidden && point != PointAgreement::Unseen; }

}  // namespace

Agreement counted(std::span<const PointAgreement> points) {
  Agreement count;
  std::int64_t* const of[] = {&count.agree, &count.differ, &count.conflict, &count.hidden, &count.unseen};
  for (const PointAgreement point : points) ++*of[static_cast<std::size_t>(point)];
  return count;
}

bool agree_on_more(std::span<const PointAgreement> points, std::span<const PointAgreement> with) {
  std::int64_t more = 0, less = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!is_visible(points[i]) || !is_visible(with[i])) continue;
    const bool agrees = points[i] == PointAgreement::Agree, agreed = with[i] == PointAgreement::Agree;
    more += agrees && !agreed;
    less += agreed && !agrees;
  }
  return static_cast<double>(more - less) > kMinDeviations * std::sqrt(static_cast<double>(more + less));
}

}  // namespace augicp
