// SPDX-License-Identifier: MIT
#include "apps/augicp/page/clouds.h"

#include <algorithm>
#include <limits>

#include "apps/augicp/page/packing.h"
#include "apps/augicp/page/parts.h"
#include "apps/augicp/page/thinning.h"

namespace augicp::app {
namespace {

// Limit per cloud: two are drawn smoothly on a laptop, and take about 6 MB of a file.
constexpr std::size_t kMaxPoints = 100'000;

template <typename Value>
std::vector<Value> chosen(const std::vector<Value>& values, const std::vector<std::uint32_t>& indices) {
  std::vector<Value> kept;
  for (const std::uint32_t i : indices) kept.push_back(values[i]);
  return kept;
}

nlohmann::ordered_json cloud_json(const Cloud& cloud, const std::vector<std::uint32_t>& indices, const Vec3f& centre) {
  std::vector<Vec3f> points = chosen(cloud.points, indices);
  for (Vec3f& point : points) point -= centre;
  nlohmann::ordered_json json{{"points", packed_points(points)}};
  if (!cloud.has_directions()) return json;
  std::vector<std::uint8_t> structures;
  for (const Structure structure : chosen(cloud.structures, indices))
    structures.push_back(static_cast<std::uint8_t>(structure));
  json["directions"] = packed_directions(chosen(cloud.directions, indices));
  json["structures"] = packed_bytes(structures);
  return json;
}

// In the page's frame, one per source point; NaN if there is none.
std::vector<Vec3f> partners_of(const AlignPicture& picture, const Vec3f& centre) {
  const Scan &source = picture.prepared.source, &target = picture.prepared.target;
  std::vector<Vec3f> partners(source.cloud.size(), Vec3f::Constant(std::numeric_limits<float>::quiet_NaN()));
  if (!has_pose(picture.report.result.status)) return partners;
  for (const Correspondence& pair : picture.report.result.pairs)
    partners[pair.source] = target.cloud.points[pair.target] - centre;
  return partners;
}

double sane(double length) { return length > 1e-9 && length < 1e9 ? length : 1.0; }

}  // namespace

Vec3d middle_of(const Cloud& cloud) {
  return cloud.empty() ? Vec3d::Zero() : Vec3d(cloud.origin + median_point(cloud).cast<double>());
}

CloudFrame frame_of(const Scan& source, const Scan& target) {
  CloudFrame frame{&source.cloud, &target.cloud};
  if (!target.cloud.empty()) frame.centre = median_point(target.cloud);
  frame.target_zero = target.cloud.origin + frame.centre.cast<double>();
  frame.extent = sane(std::max(robust_extent(source), robust_extent(target)));
  return frame;
}

Rigid3 page_from_source(const CloudFrame& frame, const Rigid3& target_from_source) {
  Rigid3 pose = without_origins(target_from_source, *frame.source, *frame.target);
  pose.translation -= frame.centre.cast<double>();
  return pose;
}

PairedClouds paired_clouds(const AlignPicture& picture, const CloudFrame& frame) {
  const Cloud &source = picture.prepared.source.cloud, &target = picture.prepared.target.cloud;
  const auto source_indices = thinned_indices(source.size(), kMaxPoints);
  PairedClouds clouds{cloud_json(source, source_indices, Vec3f::Zero()),
                      cloud_json(target, thinned_indices(target.size(), kMaxPoints), frame.centre)};
  clouds.source["partners"] = packed_points(chosen(partners_of(picture, frame.centre), source_indices));
  return clouds;
}

}  // namespace augicp::app
