// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string_view>

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
                                   {"tangent_z", kTangent + 2}};

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
  for (std::size_t column = 0; column < names.size(); ++column) {
    const std::string name = lower_case(names[column]);
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
      throw io_error(path, fmt::format("expected a column '{}', found none", kRoleNames[role].name));
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
