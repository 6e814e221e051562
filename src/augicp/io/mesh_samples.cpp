// SPDX-License-Identifier: MIT
#include "augicp/io/mesh_samples.h"

#include <algorithm>
#include <cmath>

#include "augicp/io/cloud_builder.h"
#include "augicp/io/format.h"

namespace augicp {
namespace {

constexpr std::size_t kPointsPerFace = 1000, kMaxPoints = 200'000;

// Twice the area, in the direction of the normal.
Vec3d area_vector(const Triangle& face) { return (face[1] - face[0]).cross(face[2] - face[0]); }

// The same for all faces. A broken corner makes the area no number.
double total_area(const FileBytes& file, const MeshFaces& faces) {
  double total = 0.0;
  for (std::size_t i = 0; i < faces.count; ++i) {
    total += area_vector(faces.face(i)).norm();
    if (!std::isfinite(total)) throw io_error(file.path, fmt::format("face {} is not finite, or too large", i + 1));
  }
  if (!(total > 0.0)) throw io_error(file.path, fmt::format("none of its {} faces has an area", faces.count));
  return total;
}

double fraction(double x) { return x - std::floor(x); }

// The k-th of points that are spread evenly over a triangle: M. Roberts' sequence R2 in the unit square, folded along
// its diagonal.
Vec3d place_in(const Triangle& face, std::size_t k) {
  constexpr double kPlastic = 1.32471795724474602596;  // x^3 = x + 1
  double a = fraction(0.5 + static_cast<double>(k) / kPlastic);
  double b = fraction(0.5 + static_cast<double>(k) / (kPlastic * kPlastic));
  if (a + b > 1.0) {
    a = 1.0 - a;
    b = 1.0 - b;
  }
  return face[0] + a * (face[1] - face[0]) + b * (face[2] - face[0]);
}

// The k-th point is where k + 1/2 of `count` equal shares of the area are behind, face after face.
void add_samples(const MeshFaces& faces, double total, std::size_t count, CloudBuilder& builder) {
  double behind = 0.0;
  std::size_t k = 0, last_with_area = 0;
  const auto add = [&](const Triangle& face, const Vec3d& area) {
    const Vec3d place = place_in(face, k++);
    builder.add(
        {place.x(), place.y(), place.z(), area.x(), area.y(), area.z(), static_cast<double>(Structure::Planar)});
  };
  for (std::size_t i = 0; i < faces.count; ++i) {
    const Triangle face = faces.face(i);
    const Vec3d area = area_vector(face);
    if (area.norm() == 0.0) continue;
    last_with_area = i;
    behind += area.norm();
    while (k < count && (static_cast<double>(k) + 0.5) * total < behind * static_cast<double>(count)) add(face, area);
  }
  while (k < count) add(faces.face(last_with_area), area_vector(faces.face(last_with_area)));  // rounding
}

}  // namespace

CloudFile sampled_cloud(const FileBytes& file, const MeshFaces& faces, const ReadOptions& options) {
  if (faces.count == 0) throw io_error(file.path, "holds no faces");
  const double total = total_area(file, faces);
  const std::size_t count = std::min(kMaxPoints, kPointsPerFace * std::min(faces.count, kMaxPoints));
  check_num_points(file.path, count, options);
  PointTable table;
  table.format = fmt::format("{}, {} faces, sampled", faces.format, faces.count);
  table.num_points = count;
  table.has_normals = true;
  CloudFile read = build_cloud(file, table, [&](CloudBuilder& builder) { add_samples(faces, total, count, builder); });
  if (options.keep_fields) read.fields.not_kept.push_back("the faces: they were sampled");
  return read;
}

}  // namespace augicp
