// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "augicp/io/cloud_builder.h"
#include "augicp/io/format.h"
#include "augicp/io/gltf_file.h"
#include "augicp/io/mesh_samples.h"
#include "augicp/io/read_mesh.h"

namespace augicp {
namespace {

// The corners of a face, by their places in the list of corners.
std::array<std::size_t, 3> corners_of(GltfMode mode, std::size_t face) {
  if (mode == GltfMode::Triangles) return {3 * face, 3 * face + 1, 3 * face + 2};
  if (mode == GltfMode::Fan) return {0, face + 1, face + 2};
  return {face, face + 1 + face % 2, face + 2 - face % 2};  // every second face of a strip is turned
}

Vec3d vertex(const FileBytes& file, const GltfPart& part, std::size_t corner) {
  const std::size_t i = part.indices ? static_cast<std::size_t>(part.indices->at(corner, 0)) : corner;
  if (i >= part.positions.count)
    throw io_error(file.path, fmt::format("expected a vertex below {}, found {}", part.positions.count, i));
  const Vec3d in_mesh(part.positions.at(i, 0), part.positions.at(i, 1), part.positions.at(i, 2));
  return (part.world_from_mesh * in_mesh.homogeneous()).head<3>();
}

// Finds parts by the number of a face or point of the whole scene.
class PartIndex {
 public:
  template <typename Count>
  PartIndex(const GltfScene& scene, const Count& count) : scene_(scene) {
    for (const GltfPart& part : scene.parts) begins_.push_back(begins_.back() + count(part));
  }

  std::size_t total() const { return begins_.back(); }

  // The part, and the number in it.
  std::pair<const GltfPart*, std::size_t> at(std::size_t i) const {
    const auto after = std::upper_bound(begins_.begin(), begins_.end(), i);
    const auto part = static_cast<std::size_t>(after - begins_.begin()) - 1;
    return {&scene_.parts[part], i - begins_[part]};
  }

 private:
  const GltfScene& scene_;
  std::vector<std::size_t> begins_{0};
};

// A mirroring node turns its faces: they are still seen counterclockwise from outside.
Triangle face_of(const FileBytes& file, const GltfPart& part, std::size_t face) {
  auto [a, b, c] = corners_of(part.mode, face);
  if (part.world_from_mesh.topLeftCorner<3, 3>().determinant() < 0.0) std::swap(b, c);
  return {vertex(file, part, a), vertex(file, part, b), vertex(file, part, c)};
}

CloudFile cloud_of_points(const FileBytes& file, const PartIndex& points, const std::string& format,
                          const ReadOptions& options) {
  check_num_points(file.path, points.total(), options);
  PointTable table;
  table.format = format + " points";
  table.num_points = points.total();
  return build_cloud(file, table, [&](CloudBuilder& builder) {
    for (std::size_t i = 0; i < points.total(); ++i) {
      const auto [part, corner] = points.at(i);
      const Vec3d point = vertex(file, *part, corner);
      builder.add({point.x(), point.y(), point.z()});
    }
  });
}

}  // namespace

CloudFile parse_gltf(const FileBytes& file, const ReadOptions& options) {
  const GltfScene scene = read_gltf_scene(file);
  const std::string format = file.bytes.starts_with("glTF") ? "glb" : "gltf";
  const PartIndex faces(scene, [](const GltfPart& part) { return part.num_faces(); });
  const auto face = [&](std::size_t i) {
    const auto [part, number] = faces.at(i);
    return face_of(file, *part, number);
  };
  if (faces.total() > options.max_points)
    throw io_error(file.path, fmt::format("expected at most {} faces, found {}", options.max_points, faces.total()));
  const PartIndex points(
      scene, [](const GltfPart& part) { return part.mode == GltfMode::Points ? part.num_corners() : std::size_t{0}; });
  CloudFile read = faces.total() > 0 ? sampled_cloud(file, {format, faces.total(), face}, options)
                                     : cloud_of_points(file, points, format, options);
  read.report.warnings.insert(read.report.warnings.end(), scene.warnings.begin(), scene.warnings.end());
  return read;
}

}  // namespace augicp
