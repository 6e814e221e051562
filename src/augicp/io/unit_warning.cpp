// SPDX-License-Identifier: MIT
#include "augicp/io/unit_warning.h"

#include <algorithm>

#include "augicp/io/format.h"
#include "augicp/io/spread.h"

namespace augicp {

std::string unit_warning(const Cloud& source, const Cloud& target) {
  constexpr double kAlike = 4.0;  // two views of one place differ less
  if (source.empty() || target.empty()) return "";
  const auto radius = [](const Cloud& cloud) {
    return spread_of(cloud.size(), [&](std::size_t i) { return Vec3d(cloud.points[i].cast<double>()); }).radius;
  };
  const double of_source = radius(source), of_target = radius(target);
  const double ratio = std::max(of_source, of_target) / std::min(of_source, of_target);
  if (!(ratio > 1000.0 / kAlike && ratio < 1000.0 * kAlike)) return "";
  return fmt::format("the {} is about {:.0f} times as large as the {}: millimetres and metres?",
                     of_source > of_target ? "source" : "target", ratio, of_source > of_target ? "target" : "source");
}

}  // namespace augicp
