// SPDX-License-Identifier: MIT
#include "augicp/registration/registration.h"

#include <algorithm>
#include <stdexcept>

#include "augicp/cloud/voxel_grid.h"
#include "augicp/registration/judge.h"
#include "augicp/surface/ball_neighbourhood.h"
#include "augicp/surface/window_surface.h"

namespace augicp {
namespace {

// Spinning scanners sample a wall far away more thinly than a ball near the sensor expects.
constexpr std::size_t kMinBallPoints = 10;
constexpr double kMaxBallGrowth = 3.0;

// Far outliers (a single "no reading" at zero in a cloud of UTM coordinates) belong to no scene and would only stretch
// the grid.
constexpr double kReachPerExtent = 1000.0;
Cloud without_far_outliers(const Cloud& cloud, double extent) {
  const Vec3f centre = median_point(cloud);
  const auto reach = static_cast<float>(kReachPerExtent * extent);
  std::vector<std::uint32_t> within;
  for (std::uint32_t i = 0; i < cloud.size(); ++i)
    if ((cloud.points[i] - centre).norm() <= reach) within.push_back(i);
  return within.size() == cloud.size() ? cloud : select(cloud, within);
}

// A voxel asked for that would need more cells than a key holds becomes the finest that does not.
double feasible_voxel(const Cloud& cloud, double voxel_size) {
  constexpr double kCells = 1 << 20;
  return std::max(voxel_size, bounds(cloud).diagonal() / kCells);
}

void estimate_surface(Scan& scan, const Lengths& lengths, const RegistrationOptions& options) {
  if (scan.view) {
    WindowOptions window;
    window.radius = lengths.radius;
    estimate_surface(scan.cloud, scan.view->index, window, surface_options(options), options.num_threads);
    return;
  }
  const BallOptions ball{lengths.radius, kMinBallPoints, kMaxBallGrowth * lengths.radius};
  estimate_surface(scan.cloud, BallNeighbourhood(scan.cloud, ball, options.num_threads), surface_options(options),
                   options.num_threads);
}

bool is_projective(const Scan& target, Association association) {
  if (association == Association::Projective && !target.view)
    throw std::invalid_argument("association = projective: the target is not a depth image with a camera");
  return target.view && association != Association::Nearest;
}

}  // namespace

Scan prepare(Scan scan, const Lengths& lengths, const RegistrationOptions& options) {
  // Without extent there are no lengths and no surface: empty, or all points in one place.
  if (!(lengths.radius > 0.0) || scan.cloud.empty()) return scan;
  if (!scan.view) {
    scan.cloud = without_far_outliers(scan.cloud, lengths.extent);
    scan.cloud = downsample(scan.cloud, feasible_voxel(scan.cloud, lengths.voxel_size));
  }
  if (options.preset == Preset::Paper) scan.cloud.weights.clear();
  if (scan.cloud.has_directions()) return scan;
  estimate_surface(scan, lengths, options);
  return scan;
}

AlignResult register_prepared(const Scan& source, const Scan& target, const Rigid3& initial_target_from_source,
                              const Lengths& lengths, const RegistrationOptions& options) {
  const bool projective = is_projective(target, options.association);
  if (source.cloud.empty() || target.cloud.empty() || !(lengths.max_distance > 0.0)) {
    AlignResult nothing;
    nothing.target_from_source = initial_target_from_source;
    return nothing;
  }
  const AlignOptions align_by = align_options(lengths, projective, options);
  const std::unique_ptr<Matcher> matcher = matcher_for(target, projective);
  return judged(align(source.cloud, *matcher, initial_target_from_source, align_by), source, target, *matcher, lengths, align_by);
}

AlignResult register_scans(const Scan& source, const Scan& target, const Rigid3& initial_target_from_source,
                           const RegistrationOptions& options) {
  options.check();
  const Lengths lengths = lengths_for(source, target, options);
  return register_prepared(prepare(source, lengths, options), prepare(target, lengths, options),
                           initial_target_from_source, lengths, options);
}

}  // namespace augicp
