// SPDX-License-Identifier: MIT
#include "augicp/io/time_field.h"

namespace augicp {
namespace {

// In the order in which they are preferred.
constexpr std::string_view kTimeNames[] = {"t", "time", "timestamp", "time_stamp", "offset_time"};

}  // namespace

const PointField* find_time_field(const CloudFile& file, std::string_view name) {
  const PointField* found = name.empty() ? nullptr : file.fields.find(lower_case(name));
  if (name.empty())
    for (const std::string_view known : kTimeNames)
      if (found = file.fields.find(known); found) break;
  return found && found->count == 1 ? found : nullptr;
}

std::vector<double> values_of_points(const CloudFile& file, const PointField& field) {
  std::vector<double> values(file.cloud.size());
  for (std::size_t row = 0; row < field.num_rows(); ++row) {
    const std::int32_t point = file.grid ? file.grid->index[row] : static_cast<std::int32_t>(row);
    if (point != IndexImage::kNone) values[static_cast<std::size_t>(point)] = field.at(row);
  }
  return values;
}

}  // namespace augicp
