// SPDX-License-Identifier: MIT
// The times of the points among the fields of a file.
#pragma once

#include <string_view>
#include <vector>

#include "augicp/io/cloud_file.h"

namespace augicp {

// The field of this name, in either case, or of an empty name the first of t, time, timestamp, time_stamp and
// offset_time; null if there is none, or if it has several numbers a point. REQUIRES: the file was read with
// ReadOptions::keep_fields.
const PointField* find_time_field(const CloudFile& file, std::string_view name);

// The numbers of a field of the file, one for each point of its cloud.
std::vector<double> values_of_points(const CloudFile& file, const PointField& field);

}  // namespace augicp
