// SPDX-License-Identifier: MIT
#include "augicp/io/cloud_builder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "augicp/core/median.h"
#include "augicp/io/format.h"

namespace augicp {
namespace {

constexpr double kFarthest = 1e18;  // the squared distance of two points within this fits into float

bool is_usable(const Vec3d& position) {
  return (position.array().abs() < kFarthest).all();  // NaN fails
}

// An infinite intensity, or one beyond float, is unknown.
float intensity_of(double value) {
  const bool known = std::abs(value) <= static_cast<double>(std::numeric_limits<float>::max());  // NaN fails
  return known ? static_cast<float>(value) : std::numeric_limits<float>::quiet_NaN();
}

// Medians of at most this many points, evenly spread over the file, suffice for an origin.
constexpr std::size_t kMaxSample = 4096;

// Medians are robust against the few points at zero or infinity that mean "no reading" in many files.
struct Spread {
  Vec3d centre = Vec3d::Zero();
  double radius = 0.0;  // median distance from the centre, along the farthest axis
};

Spread spread_of(const std::vector<Vec3f>& points) {
  const std::size_t step = (points.size() + kMaxSample - 1) / kMaxSample;
  Spread spread;
  std::vector<double> values;
  for (int axis = 0; axis < 3; ++axis) {
    values.clear();
    for (std::size_t i = 0; i < points.size(); i += step) values.push_back(static_cast<double>(points[i][axis]));
    spread.centre[axis] = upper_median(values);
  }
  values.clear();
  for (std::size_t i = 0; i < points.size(); i += step)
    values.push_back((points[i].cast<double>() - spread.centre).cwiseAbs().maxCoeff());
  spread.radius = upper_median(values);
  return spread;
}

}  // namespace

CloudBuilder::CloudBuilder(const PointTable& table, const Vec3d& origin)
    : has_intensities_(table.has_intensities), is_organised_(table.width > 0) {
  Cloud& cloud = file_.cloud;
  cloud.origin = origin;
  cloud.points.reserve(table.num_points);
  if (table.has_normals) {
    cloud.directions.reserve(table.num_points);
    cloud.structures.reserve(table.num_points);
  }
  if (has_intensities_) cloud.intensities.reserve(table.num_points);
  if (is_organised_) places_.reserve(table.num_points);
  if (table.viewpoint) cloud.viewpoint = (*table.viewpoint - origin).cast<float>();
  file_.report.format = table.format;
  file_.report.has_normals = table.has_normals;
}

void CloudBuilder::add(const PointValues& values) {
  ++file_.report.num_declared;
  const Vec3d position(values[0], values[1], values[2]);
  const bool usable = is_usable(position);
  if (is_organised_)
    places_.push_back(usable ? static_cast<std::int32_t>(file_.cloud.points.size()) : IndexImage::kNone);
  if (!usable) {
    ++file_.report.num_not_finite;
    return;
  }
  file_.cloud.points.push_back((position - file_.cloud.origin).cast<float>());
  if (file_.report.has_normals) add_direction(values);
  if (has_intensities_) file_.cloud.intensities.push_back(intensity_of(values[7]));
}

void CloudBuilder::add_direction(const PointValues& values) {
  Cloud& cloud = file_.cloud;
  const Vec3d normal(values[3], values[4], values[5]);
  const double length = normal.norm();
  const bool usable = std::isfinite(length) && length > 0.0 && values[6] != static_cast<double>(Structure::None);
  Vec3f direction = usable ? Vec3f((normal / length).cast<float>()) : Vec3f(Vec3f::Zero());
  const bool is_edge = values[6] == static_cast<double>(Structure::Edge);
  if (!is_edge && cloud.viewpoint && direction.dot(*cloud.viewpoint - cloud.points.back()) < 0.0f)
    direction = -direction;
  cloud.directions.push_back(direction);
  cloud.structures.push_back(!usable ? Structure::None : is_edge ? Structure::Edge : Structure::Planar);
}

// Float has 24 bits. Up to 8 times the cloud's radius from zero, its spacing is below a millionth of the radius, and no
// origin is needed. The origin is rounded to a power of two near the radius, so that subtracting it is exact.
Vec3d CloudBuilder::suitable_origin() const {
  constexpr double kFarInRadii = 8.0;
  const Spread spread = spread_of(file_.cloud.points);
  if (spread.centre.cwiseAbs().maxCoeff() <= kFarInRadii * spread.radius) return Vec3d::Zero();
  const double quantum = spread.radius > 0.0 ? std::exp2(std::floor(std::log2(spread.radius))) : 1.0;
  return (spread.centre / quantum).array().round().matrix() * quantum;
}

CloudFile build_any_cloud(const PointTable& table, const std::function<void(CloudBuilder&)>& decode_points) {
  std::optional<CloudBuilder> builder(std::in_place, table, Vec3d::Zero());
  decode_points(*builder);
  if (builder->file_.cloud.empty()) return std::move(builder->file_);
  if (const Vec3d origin = builder->suitable_origin(); !origin.isZero(0.0)) {
    builder.emplace(table, origin);
    decode_points(*builder);
  }
  CloudFile built = std::move(builder->file_);
  if (table.width > 0) {
    built.grid.emplace();
    built.grid->width = table.width;
    built.grid->height = static_cast<int>(builder->places_.size() / static_cast<std::size_t>(table.width));
    built.grid->index = std::move(builder->places_);
  }
  return built;
}

CloudFile build_cloud(const FileBytes& file, const PointTable& table,
                      const std::function<void(CloudBuilder&)>& decode_points) {
  CloudFile built = build_any_cloud(table, decode_points);
  const std::uint64_t num_points = built.report.num_declared;
  if (num_points == 0) throw io_error(file.path, "holds no points");
  if (built.cloud.empty()) throw io_error(file.path, fmt::format("none of its {} points is finite", num_points));
  return built;
}

void check_num_points(const std::filesystem::path& path, std::uint64_t count, const ReadOptions& options) {
  constexpr std::uint64_t kMaxIndex = std::numeric_limits<std::int32_t>::max();
  const std::uint64_t limit = std::min(options.max_points, kMaxIndex);
  if (count == 0) throw io_error(path, "holds no points");
  if (count > limit) throw io_error(path, fmt::format("expected at most {} points, found {}", limit, count));
}

}  // namespace augicp
