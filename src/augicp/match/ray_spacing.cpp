// SPDX-License-Identifier: MIT
#include "augicp/match/ray_spacing.h"

#include <cmath>
#include <vector>

#include "augicp/core/median.h"
#include "augicp/match/range_image.h"

namespace augicp {
namespace {

constexpr double kLowQuantile = 0.02, kUsualQuantile = 0.2;

// Patches whose ranges differ by less say nothing of their exponent.
constexpr double kMinRangeRatio = 1.25;
constexpr std::size_t kMinSlopes = 20;

// Generated sensors have 0.99 and more, depth cameras 1, HDL-32, VLP-16 and solid-state ones 0.92 to 0.98, HDL-64 0.87
// to 0.94. Two scans in one frame have 0.36 to 0.94, random directions 0.3.
constexpr double kMinEvenness = 0.88;
// Sensors have -0.06 to 0.14. Surfaces sampled evenly have -1, fused fragments of rooms -0.66 to -0.98.
constexpr double kMaxGrowth = 0.3;
// Of sensors whose lines nearly meet. They have 0.05 to 0.09 from their place, 0.41 to 0.57 of what they have from a
// place beside it. Rooms joined from several views have 0.99 of that and more, and up to -0.24 for the growth.
constexpr double kMaxGrowthUnlessEven = 0.1, kMaxShareBehind = 0.1, kMaxOfShareBeside = 0.75;
constexpr float kBeside = 0.3f;  // of the median range, along no wall in particular

float at_quantile(const std::vector<float>& values, double quantile) {
  return value_at_rank(values, static_cast<std::size_t>(quantile * static_cast<double>(values.size())));
}

struct Logarithms {
  double range, spacing;
};

std::vector<Logarithms> medians_of(std::span<const RayPatch> patches) {
  std::vector<Logarithms> medians;
  for (const RayPatch& patch : patches) {
    std::vector<float> ranges;
    for (const Vec3f& ray : patch.rays) ranges.push_back(ray.norm());
    const float spacing = upper_median(patch.spacing);
    if (spacing > 0.0f) medians.push_back({std::log(upper_median(ranges)), std::log(spacing)});
  }
  return medians;
}

// A point behind others of the sample is behind others of the scan.
double share_behind(std::span<const RayPatch> patches, float tolerance) {
  Cloud sample;
  for (const RayPatch& patch : patches) sample.points.insert(sample.points.end(), patch.rays.begin(), patch.rays.end());
  return RangeImage(sample, Vec3f::Zero()).share_behind(tolerance);
}

float median_range(std::span<const RayPatch> patches) {
  std::vector<float> ranges;
  for (const RayPatch& patch : patches)
    for (const Vec3f& ray : patch.rays) ranges.push_back(ray.norm());
  return upper_median(std::move(ranges));
}

// Whether so few points lie behind others that this is where they were seen from.
bool is_seen_from(const Vec3f& place, const Cloud& cloud, std::span<const RayPatch> patches, float tolerance) {
  const double share = share_behind(patches, tolerance);
  if (!(share <= kMaxShareBehind)) return false;
  const Vec3f beside = place + kBeside * median_range(patches) * Vec3f::Ones().normalized();
  return share <= kMaxOfShareBeside * share_behind(ray_patches(cloud, beside), tolerance);
}

}  // namespace

double evenness(std::span<const RayPatch> patches) {
  std::vector<float> ratios;
  for (const RayPatch& patch : patches) {
    const float usual = at_quantile(patch.spacing, kUsualQuantile);
    ratios.push_back(usual > 0.0f ? at_quantile(patch.spacing, kLowQuantile) / usual : 0.0f);
  }
  return ratios.empty() ? 0.0 : static_cast<double>(upper_median(ratios));
}

// The median slope between two patches (Theil 1950, Sen 1968): a sensor's rows of different density are outliers.
std::optional<double> growth_with_range(std::span<const RayPatch> patches) {
  const std::vector<Logarithms> medians = medians_of(patches);
  std::vector<double> slopes;
  for (const Logarithms& one : medians)
    for (const Logarithms& other : medians)
      if (other.range - one.range > std::log(kMinRangeRatio))
        slopes.push_back((other.spacing - one.spacing) / (other.range - one.range));
  if (slopes.size() < kMinSlopes) return std::nullopt;
  return upper_median(slopes);
}

bool is_one_sensors_scan(const Cloud& cloud, float tolerance) {
  const Vec3f place = assumed_place(cloud);
  const std::vector<RayPatch> patches = ray_patches(cloud, place);
  const std::optional<double> growth = growth_with_range(patches);
  if (growth && std::abs(*growth) > kMaxGrowth) return false;
  if (evenness(patches) >= kMinEvenness) return true;
  return growth && std::abs(*growth) <= kMaxGrowthUnlessEven && is_seen_from(place, cloud, patches, tolerance);
}

}  // namespace augicp
