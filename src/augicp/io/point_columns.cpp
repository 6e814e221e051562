// SPDX-License-Identifier: MIT

#include <algorithm>
#include <string_view>

#include "augicp/io/cloud_builder.h"
#include "augicp/io/format.h"

namespace augicp {
namespace {

constexpr std::size_t kIntensity = 7;

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
                                   {"scalar_intensity", kIntensity}};

std::string lower_case(std::string_view text) {
  std::string lower(text);
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');  // not tolower: it depends on the locale
  return lower;
}

void drop_partial_normals(PointColumns& columns) {
  const auto normal = std::span(columns.of_role).subspan(3, 3);
  if (std::find(normal.begin(), normal.end(), kNoColumn) != normal.end())
    std::fill(normal.begin(), normal.end(), kNoColumn);
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
  drop_partial_normals(columns);
  return columns;
}

}  // namespace augicp
