// SPDX-License-Identifier: MIT
#include "augicp/io/cloud_builder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "augicp/io/format.h"
#include "augicp/io/spread.h"

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
  file_.fields.fields = table.fields;
  dropped_.assign(table.fields.size(), false);
  for (PointField& field : fields()) field.values.reserve(table.num_points * field.row_bytes());
}

bool CloudBuilder::add(const PointValues& values) {
  ++file_.report.num_declared;
  const Vec3d position(values[0], values[1], values[2]);
  const bool usable = is_usable(position);
  if (is_organised_)
    places_.push_back(usable ? static_cast<std::int32_t>(file_.cloud.points.size()) : IndexImage::kNone);
  if (!usable) {
    ++file_.report.num_not_finite;
    return is_organised_;
  }
  file_.cloud.points.push_back((position - file_.cloud.origin).cast<float>());
  if (file_.report.has_normals) add_direction(values);
  if (has_intensities_) file_.cloud.intensities.push_back(intensity_of(values[7]));
  return true;
}

void CloudBuilder::drop_field(std::size_t field, std::string sentence) {
  file_.fields.not_kept.push_back(std::move(sentence));
  dropped_[field] = true;
  fields()[field].values = {};
}

void CloudBuilder::add_direction(const PointValues& values) {
  Cloud& cloud = file_.cloud;
  const bool is_edge = values[6] == static_cast<double>(Structure::Edge);
  const Vec3d tangent(values[8], values[9], values[10]);
  const Vec3d normal = is_edge && tangent.norm() > 0.0 ? tangent : Vec3d(values[3], values[4], values[5]);
  const double length = normal.norm();
  const bool has_structure = values[6] != static_cast<double>(Structure::None);
  const bool usable = std::isfinite(length) && length > 0.0 && has_structure;
  if (has_structure && !usable) ++num_bad_normals_;
  Vec3f direction = usable ? Vec3f((normal / length).cast<float>()) : Vec3f(Vec3f::Zero());
  if (!is_edge && cloud.viewpoint && direction.dot(*cloud.viewpoint - cloud.points.back()) < 0.0f)
    direction = -direction;
  cloud.directions.push_back(direction);
  cloud.structures.push_back(!usable ? Structure::None : is_edge ? Structure::Edge : Structure::Planar);
}

// The origin is rounded to a power of two near the radius, so that subtracting it is exact.
Vec3d CloudBuilder::suitable_origin() const {
  const std::vector<Vec3f>& points = file_.cloud.points;
  const Spread spread = spread_of(points.size(), [&](std::size_t i) { return Vec3d(points[i].cast<double>()); });
  if (float_suffices(spread)) return Vec3d::Zero();
  const double quantum = spread.radius > 0.0 ? std::exp2(std::floor(std::log2(spread.radius))) : 1.0;
  return (spread.centre / quantum).array().round().matrix() * quantum;
}

CloudFile CloudBuilder::finished(int width) {
  if (width > 0) {
    file_.grid.emplace();
    file_.grid->width = width;
    file_.grid->height = static_cast<int>(places_.size() / static_cast<std::size_t>(width));
    file_.grid->index = std::move(places_);
  }
  if (num_bad_normals_ > 0 && num_bad_normals_ == file_.cloud.size()) {
    file_.cloud.directions.clear();
    file_.cloud.structures.clear();
    file_.report.has_normals = false;
    file_.report.warnings.push_back("no normal is of any length: they are not used");
  }
  std::vector<PointField> kept;
  for (std::size_t i = 0; i < fields().size(); ++i)
    if (!dropped_[i]) kept.push_back(std::move(fields()[i]));
  fields() = std::move(kept);
  return std::move(file_);
}

CloudFile build_any_cloud(const PointTable& table, const std::function<void(CloudBuilder&)>& decode_points) {
  std::optional<CloudBuilder> builder(std::in_place, table, Vec3d::Zero());
  decode_points(*builder);
  if (builder->file_.cloud.empty()) return std::move(builder->file_);
  if (const Vec3d origin = builder->suitable_origin(); !origin.isZero(0.0)) {
    builder.emplace(table, origin);
    decode_points(*builder);
  }
  return builder->finished(table.width);
}

CloudFile build_cloud(const FileBytes& file, const PointTable& table,
                      const std::function<void(CloudBuilder&)>& decode_points) {
  CloudFile built = build_any_cloud(table, decode_points);
  const std::uint64_t num_points = built.report.num_declared;
  if (num_points == 0) throw io_error(file.path, "holds no points");
  if (built.cloud.empty())
    throw io_error(file.path,
                   fmt::format("none of its {} points is finite and within {:g} m of zero", num_points, kFarthest));
  return built;
}

void check_num_points(const std::filesystem::path& path, std::uint64_t count, const ReadOptions& options) {
  constexpr std::uint64_t kMaxIndex = std::numeric_limits<std::int32_t>::max();
  const std::uint64_t limit = std::min(options.max_points, kMaxIndex);
  if (count == 0) throw io_error(path, "holds no points");
  if (count > limit) throw io_error(path, fmt::format("expected at most {} points, found {}", limit, count));
}

}  // namespace augicp
