// SPDX-License-Identifier: MIT
#include "fuzz/promises.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "augicp/io/read_cloud.h"

namespace augicp::fuzz {
namespace {

void expect_sound_directions(const Cloud& cloud) {
  expect(cloud.structures.size() == cloud.directions.size(), "as many structures as directions");
  expect(cloud.directions.empty() || cloud.directions.size() == cloud.size(), "a direction a point, or none");
  for (std::size_t i = 0; i < cloud.directions.size(); ++i) {
    const float length = cloud.structures[i] == Structure::None ? 0.0f : 1.0f;
    expect(std::abs(cloud.directions[i].norm() - length) < 1e-5f, "directions of unit length");
  }
}

void expect_sound_grid(const CloudFile& file) {
  const IndexImage& grid = *file.grid;
  expect(grid.width > 0 && grid.height > 0, "a grid has a size");
  expect(grid.index.size() == std::size_t(grid.width) * std::size_t(grid.height), "a place a pixel");
  expect(grid.index.size() == file.report.num_declared, "a place a declared point");
  std::int32_t next = 0;
  for (const std::int32_t index : grid.index) expect(index == IndexImage::kNone || index == next++, "places in order");
  expect(std::size_t(next) == file.cloud.size(), "every point has its place");
}

void expect_sound_fields(const std::vector<PointField>& fields, std::size_t num_rows) {
  for (const PointField& field : fields)
    expect(field.values.size() == num_rows * field.row_bytes(), "a row of each field for each point or cell");
}

// The further columns change nothing else.
void expect_fields_beside(const CloudFile& plain, const FileBytes& file, ReadOptions options) {
  options.keep_fields = true;
  const CloudFile kept = parse_cloud(file, options);
  expect(plain.fields.fields.empty(), "no fields unless they are asked for");
  expect(kept.cloud.points == plain.cloud.points, "the same points with and without their fields");
  expect_sound_fields(kept.las ? fields_of(*kept.las).fields : kept.fields.fields,
                      kept.grid ? kept.grid->index.size() : kept.cloud.size());
}

bool is_refused(const FileBytes& file, const ReadOptions& options) {
  try {
    parse_cloud(file, options);
  } catch (const IoError&) {
    return true;
  }
  return false;
}

}  // namespace

void expect(bool holds, std::string_view promise) {
  if (holds) return;
  std::fprintf(stderr, "broken promise: %.*s\n", static_cast<int>(promise.size()), promise.data());
  std::abort();
}

void expect_sound(const CloudFile& file) {
  const Cloud& cloud = file.cloud;
  expect(!cloud.empty(), "a cloud that was read has points");
  expect(cloud.origin.allFinite(), "a finite origin");
  for (const Vec3f& point : cloud.points) expect(point.allFinite(), "every point finite");
  expect(cloud.size() + file.report.num_not_finite == file.report.num_declared, "every point kept or counted");
  expect(cloud.intensities.empty() || cloud.intensities.size() == cloud.size(), "an intensity a point, or none");
  for (const float intensity : cloud.intensities) expect(!std::isinf(intensity), "no infinite intensity");
  expect_sound_directions(cloud);
  if (file.grid) expect_sound_grid(file);
}

void expect_rigid(const Rigid3& pose) {
  expect(pose.translation.allFinite(), "a finite translation");
  expect(std::abs(pose.rotation.norm() - 1.0) < 1e-12, "a unit quaternion");
}

void expect_sound(const Trajectory& trajectory) {
  expect(!trajectory.empty(), "a trajectory that was read has poses");
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    expect_rigid(trajectory[i].world_from_camera);
    expect(std::isfinite(trajectory[i].stamp_s), "a finite stamp");
    expect(i == 0 || trajectory[i - 1].stamp_s < trajectory[i].stamp_s, "stamps increase");
  }
}

FileBytes file_of(const std::filesystem::path& name, const std::uint8_t* data, std::size_t size) {
  return {name, std::string(data, data + size)};
}

void check_cloud_reader(const std::filesystem::path& name, const std::uint8_t* data, std::size_t size,
                        const ReadOptions& options) {
  const FileBytes file = file_of(name, data, size);
  expect_read_or_refused(name, [&] {
    const CloudFile read = parse_cloud(file, options);
    expect_sound(read);
    expect_fields_beside(read, file, options);
    ReadOptions fewer = options;
    fewer.max_points = read.report.num_declared - 1;
    expect(is_refused(file, fewer), "a cloud with more points than allowed is refused");
  });
}

}  // namespace augicp::fuzz
