// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "augicp/io/cloud_builder.h"
#include "augicp/io/format.h"

namespace augicp {
namespace {

constexpr std::size_t kNormal = 3, kStructure = 6, kIntensity = 7, kTangent = 8;

struct RoleName {
  std::string_view name;
  std::size_t role;
};

constexpr RoleName kRoleNames[] = {{"x", 0},
                                   {"y", 1},
                                   {"z", 2},
                                   {"nx", 3},
                                   {"ny", 4},
                                   {"nz", 5},
                                   {"normal_x", 3},
                                   {"normal_y", 4},
                                   {"normal_z", 5},
                                   {"structure", 6},
                                   {"intensity", kIntensity},
                                   {"scalar_intensity", kIntensity},
                                   {"tangent_x", kTangent},
                                   {"tangent_y", kTangent + 1},
                                   {"tangent_z", kTangent + 2},
                                   {"normals:0", 3},
                                   {"normals:1", 4},
                                   {"normals:2", 5}};

// Coordinates under other names, if there are no x y z: ParaView, VeloView, and surveys.
constexpr std::array<std::string_view, 3> kOtherCoordinates[] = {
    {"points:0", "points:1", "points:2"},
    {"points_0", "points_1", "points_2"},
    {"points_m_xyz:0", "points_m_xyz:1", "points_m_xyz:2"},
    {"easting", "northing", "elevation"},
    {"easting", "northing", "height"},
};

// The name in lower case, without a unit of metres behind it: "X (m)", "x[m]".
std::string plain_name(std::string_view name) {
  std::string plain = lower_case(name);
  for (const std::string_view unit : {"(m)", "[m]"})
    if (plain.ends_with(unit)) plain.resize(plain.size() - unit.size());
  plain.resize(plain.find_last_not_of(' ') + 1);
  return plain;
}

std::vector<std::string> plain_names(std::span<const std::string> names) {
  std::vector<std::string> plain;
  for (const std::string& name : names) plain.push_back(plain_name(name));
  const auto has = [&](std::string_view name) { return std::find(plain.begin(), plain.end(), name) != plain.end(); };
  if (has("x") || has("y") || has("z")) return plain;
  for (const auto& others : kOtherCoordinates) {
    if (!std::all_of(others.begin(), others.end(), has)) continue;
    for (std::size_t axis = 0; axis < 3; ++axis)
      std::replace(plain.begin(), plain.end(), std::string(others[axis]), std::string(kRoleNames[axis].name));
    break;
  }
  return plain;
}

// The names for a message, those that fit into a line.
std::string among(std::span<const std::string> names) {
  constexpr std::size_t kMostNames = 12;
  if (names.empty()) return {};
  std::vector<std::string> quoted;
  for (const std::string& name : names.first(std::min(names.size(), kMostNames))) quoted.push_back(in_quotes(name));
  return fmt::format(" among {}{}", fmt::join(quoted, " "), names.size() > kMostNames ? " ..." : "");
}

void drop_vector(PointColumns& columns, std::size_t first_role) {
  for (std::size_t axis = 0; axis < 3; ++axis) columns.of_role[first_role + axis] = kNoColumn;
}

void drop_partial_vector(PointColumns& columns, std::size_t first_role) {
  const auto roles = std::span(columns.of_role).subspan(first_role, 3);
  if (std::find(roles.begin(), roles.end(), kNoColumn) != roles.end()) drop_vector(columns, first_role);
}

}  // namespace

PointColumns find_columns(const std::filesystem::path& path, std::span<const std::string> names) {
  PointColumns columns;
  const std::vector<std::string> plain = plain_names(names);
  for (std::size_t column = 0; column < names.size(); ++column) {
    const std::string& name = plain[column];
    for (const RoleName& entry : kRoleNames) {
      if (entry.name != name) continue;
      if (columns.of_role[entry.role] != kNoColumn && entry.role == kIntensity) continue;  // CloudCompare writes both
      if (columns.of_role[entry.role] != kNoColumn)
        throw io_error(path, fmt::format("expected one column {}, found a second", in_quotes(names[column])));
      columns.of_role[entry.role] = column;
    }
  }
  for (std::size_t role = 0; role < 3; ++role)
    if (columns.of_role[role] == kNoColumn)
      throw io_error(path, fmt::format("expected a column '{}', found none{}", kRoleNames[role].name, among(names)));
  drop_partial_vector(columns, kNormal);
  drop_partial_vector(columns, kTangent);
  if (!columns.has_normals()) columns.of_role[kStructure] = kNoColumn;
  if (columns.of_role[kStructure] == kNoColumn) drop_vector(columns, kTangent);
  return columns;
}

bool PointColumns::is_field(std::size_t column) const {
  const auto role = static_cast<std::size_t>(std::find(of_role.begin(), of_role.end(), column) - of_role.begin());
  return role == kNumRoles || role == kIntensity;
}

}  // namespace augicp
