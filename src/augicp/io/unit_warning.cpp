// SPDX-License-Identifier: MIT
#include "augicp/io/unit_warning.h"

#include <algorithm>

#include "augicp/io/format.h"
#include "augicp/io/spread.h"

namespace augicp {

std::string unit_warning(const Cloud& source, const Cloud& target) {
  constexpr double kAlike = 4.0;               // two views of one place differ less
  constexpr double kAlikeInCentimetres = 2.0;  // less is known: a part and its whole may differ by a hundred, too
  if (source.empty() || target.empty()) return "";
  const auto radius = [](const Cloud& cloud) {
    return spread_of(cloud.size(), [&](std::size_t i) { return Vec3d(cloud.points[i].cast<double>()); }).radius;
  };
  const double of_source = radius(source), of_target = radius(target);
  const double ratio = std::max(of_source, of_target) / std::min(of_source, of_target);
  const auto is_near = [&](double factor, double alike) { return ratio > factor / alike && ratio < factor * alike; };
  const bool are_millimetres = is_near(1000.0, kAlike);
  if (!are_millimetres && !is_near(100.0, kAlikeInCentimetres)) return "";
  return fmt::format("the {} is about {:.0f} times as large as the {}: {} and metres?",
                     of_source > of_target ? "source" : "target", ratio, of_source > of_target ? "target" : "source",
                     are_millimetres ? "millimetres" : "centimetres");
}

}  // namespace augicp
