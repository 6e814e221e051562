// SPDX-License-Identifier: MIT
#include "apps/augicp/page/clouds.h"

#include <algorithm>

#include "apps/augicp/page/packing.h"
#include "apps/augicp/page/parts.h"
#include "apps/augicp/page/surface_distances.h"
#include "apps/augicp/page/thinning.h"

namespace augicp::app {
namespace {

// Limit per cloud, and of the bytes of both in a page: the rest of it, with the script, stays below a megabyte.
constexpr std::size_t kMaxPoints = 1'000'000;
constexpr std::size_t kMaxBytes = 14'000'000;

// More lines between points would be a solid block.
constexpr std::size_t kMaxPairs = 2500;

template <typename Value>
std::vector<Value> chosen(const std::vector<Value>& values, const std::vector<std::uint32_t>& indices) {
  std::vector<Value> kept;
  for (const std::uint32_t i : indices) kept.push_back(values[i]);
  return kept;
}

// All red numbers, then the green and the blue ones.
std::string packed_colours(const std::vector<Colour>& colours) {
  std::vector<std::uint8_t> planes;
  for (const std::size_t channel : {0, 1, 2})
    for (const Colour& colour : colours) planes.push_back(colour[channel]);
  return packed_bytes(planes);
}

// colours: of all points, or empty.
nlohmann::ordered_json cloud_json(const Cloud& cloud, const std::vector<Colour>& colours,
                                  const std::vector<std::uint32_t>& indices, const Vec3f& centre) {
  std::vector<Vec3f> points = chosen(cloud.points, indices);
  for (Vec3f& point : points) point -= centre;
  nlohmann::ordered_json json{{"points", packed_points(points)}};
  if (cloud.has_intensities()) json["intensities"] = packed_numbers(chosen(cloud.intensities, indices));
  if (!colours.empty()) json["colours"] = packed_colours(chosen(colours, indices));
  if (!cloud.has_directions()) return json;
  std::vector<std::uint8_t> structures;
  for (const Structure structure : chosen(cloud.structures, indices))
    structures.push_back(static_cast<std::uint8_t>(structure));
  json["directions"] = packed_directions(chosen(cloud.directions, indices));
  json["structures"] = packed_bytes(structures);
  return json;
}

std::string pairs_of(const AlignPicture& picture, const Vec3f& centre) {
  const Scan &source = picture.prepared.source, &target = picture.prepared.target;
  const std::vector<Correspondence>& pairs = picture.report.result.pairs;
  std::vector<Vec3f> ends;
  if (!has_pose(picture.report.result.status)) return {};
  for (const std::uint32_t i : thinned_indices(pairs.size(), kMaxPairs)) {
    ends.push_back(source.cloud.points[pairs[i].source]);
    ends.push_back(target.cloud.points[pairs[i].target] - centre);
  }
  return packed_points(ends);
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

namespace {

std::size_t num_bytes(const nlohmann::ordered_json& cloud) {
  std::size_t sum = 0;
  for (const auto& array : cloud) sum += array.get_ref<const std::string&>().size();
  return sum;
}

PairedClouds with_at_most(std::size_t max_points, const AlignPicture& picture, const CloudFrame& frame,
                          const SurfaceDistances& distances) {
  const Cloud &source = picture.prepared.source.cloud, &target = picture.prepared.target.cloud;
  const auto source_indices = thinned_indices(source.size(), max_points);
  PairedClouds clouds{
      cloud_json(source, picture.colours.source, source_indices, Vec3f::Zero()),
      cloud_json(target, picture.colours.target, thinned_indices(target.size(), max_points), frame.centre),
      {}};
  clouds.source["distances"] = packed_numbers(chosen(distances.metres, source_indices));
  clouds.source["distance_directions"] = packed_directions(chosen(distances.directions, source_indices));
  return clouds;
}

}  // namespace

PairedClouds paired_clouds(const AlignPicture& picture, const CloudFrame& frame) {
  const SurfaceDistances distances = surface_distances(picture);
  const std::size_t largest = std::max(picture.prepared.source.cloud.size(), picture.prepared.target.cloud.size());
  std::size_t max_points = std::min(kMaxPoints, largest);
  PairedClouds clouds = with_at_most(max_points, picture, frame, distances);
  // Fewer points take less each, or a little more: 0.95 makes a second round rare.
  for (std::size_t bytes = 0; (bytes = num_bytes(clouds.source) + num_bytes(clouds.target)) > kMaxBytes;) {
    max_points = static_cast<std::size_t>(0.95 * static_cast<double>(max_points) * static_cast<double>(kMaxBytes) /
                                          static_cast<double>(bytes));
    clouds = with_at_most(max_points, picture, frame, distances);
  }
  clouds.pairs = pairs_of(picture, frame.centre);
  return clouds;
}

}  // namespace augicp::app
