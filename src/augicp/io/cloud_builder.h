// SPDX-License-Identifier: MIT
// From the numbers of a file to a cloud: drops points that are not finite, chooses the origin, normalises normals. The
// only place where this is done, for every format.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>

#include "augicp/io/cloud_file.h"
#include "augicp/io/file_bytes.h"

namespace augicp {

// The numbers a point may have: x y z, nx ny nz, structure (the value of its enumerator), intensity, and the tangent of
// an edge. Without a tangent of its own, an edge's is in nx ny nz.
inline constexpr std::size_t kNumRoles = 11;
using PointValues = std::array<double, kNumRoles>;

// The column of each role.
inline constexpr std::size_t kNoColumn = static_cast<std::size_t>(-1);
struct PointColumns {
  std::array<std::size_t, kNumRoles> of_role;

  PointColumns() { of_role.fill(kNoColumn); }
  bool has_normals() const { return of_role[3] != kNoColumn; }
  bool has_intensities() const { return of_role[7] != kNoColumn; }

  // Whether the column is one of a PointField. An intensity is that too, for its type and name.
  bool is_field(std::size_t column) const;
};

// Finds columns by their names, in either case: x y z, nx ny nz or normal_x normal_y normal_z, structure, intensity or
// scalar_intensity; beside a structure tangent_x tangent_y tangent_z. The first intensity column counts. Normals and
// tangents count only if all three are present. Without any of x y z, the names of ParaView, VeloView and surveys
// (easting northing elevation) are the coordinates. A unit of metres behind a name is no part of it: "X (m)". Throws
// IoError for a missing coordinate, with the names that there are, and for a name that occurs twice.
PointColumns find_columns(const std::filesystem::path& path, std::span<const std::string> names);

// Properties of all points that a file states.
struct PointTable {
  std::string format;
  std::uint64_t num_points = 0;  // an upper bound for text without a count
  bool has_normals = false;
  int width = 0;  // row length of an organised file; 0: not organised
  std::optional<Vec3d> viewpoint;
  bool has_intensities = false;
  std::vector<PointField> fields{};  // the further columns to keep, without values
};

// Takes points in the order of the file.
class CloudBuilder {
 public:
  CloudBuilder(const PointTable& table, const Vec3d& origin);

  // Returns whether the fields have a row for this point: then one is to be appended to each of fields().
  bool add(const PointValues& values);

  std::vector<PointField>& fields() { return file_.fields.fields; }

  // Text has no number where a field should have one: the field is not kept. The sentence says which and why.
  void drop_field(std::size_t field, std::string sentence);
  bool is_dropped(std::size_t field) const { return dropped_[field]; }

 private:
  friend CloudFile build_any_cloud(const PointTable&, const std::function<void(CloudBuilder&)>&);
  void add_direction(const PointValues& values);
  Vec3d suitable_origin() const;
  CloudFile finished(int width);

  CloudFile file_;
  std::vector<bool> dropped_;          // by field
  std::uint64_t num_bad_normals_ = 0;  // zero or not finite, though the structure is not None
  bool has_intensities_;
  std::vector<std::int32_t> places_;  // organised files: the point in each grid cell
  bool is_organised_;
};

// decode_points adds every point of the file, the same ones at each call. It is called a second time if the cloud turns
// out to be far from zero. (Keeping all coordinates as double instead would take twice the memory of the cloud.) The
// cloud is empty if no point is finite.
CloudFile build_any_cloud(const PointTable& table, const std::function<void(CloudBuilder&)>& decode_points);

// The same for a file. Throws IoError if no point is finite.
CloudFile build_cloud(const FileBytes& file, const PointTable& table,
                      const std::function<void(CloudBuilder&)>& decode_points);

// Throws IoError unless 1 <= count <= max_points and the index of a point fits into 32 bits.
void check_num_points(const std::filesystem::path& path, std::uint64_t count, const ReadOptions& options);

}  // namespace augicp
