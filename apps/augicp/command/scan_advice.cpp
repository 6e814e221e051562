// SPDX-License-Identifier: MIT
#include "apps/augicp/command/scan_advice.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "augicp/registration/lengths.h"

namespace augicp::app {
namespace {

// No LiDAR sees most of its points farther away than half of this, metres. Millimetres make a room ten times as large.
constexpr double kMaxExtent = 2000.0;

// A sensor stands among its points, so that the nearest tenth of them is nearer than the extent of the scan.
constexpr double kMaxDistancePerExtent = 1.0;
constexpr double kNearQuantile = 0.1;

double near_distance(const Cloud& scan) {
  std::vector<double> distances;
  distances.reserve(scan.size());
  for (const Vec3f& point : scan.points) distances.push_back((scan.origin + point.cast<double>()).norm());
  const auto near = distances.begin() + static_cast<std::ptrdiff_t>(kNearQuantile * static_cast<double>(scan.size()));
  std::nth_element(distances.begin(), near, distances.end());
  return *near;
}

}  // namespace

std::string scan_advice(const Cloud& scan) {
  if (scan.points.empty()) return "";
  const double extent = robust_extent(scan_of(scan)), distance = near_distance(scan);
  if (extent > kMaxExtent) return fmt::format("scans extend over {:.0f} m: are they in millimetres?", extent);
  if (distance > kMaxDistancePerExtent * extent)
    return fmt::format(
        "scans of {:.0f} m begin {:.0f} m from their zero, where the sensor must be: points are expected "
        "in the frame of the sensor",
        extent, distance);
  return "";
}

}  // namespace augicp::app
