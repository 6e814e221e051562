// SPDX-License-Identifier: MIT
// The further columns of a cloud in the form that a format has for them.
#pragma once

#include "augicp/io/point_fields.h"

namespace augicp {

// For PLY, with a sentence in not_kept for what it has no place for: packed rgb and rgba become red green blue (alpha),
// each number of a field a property of its own (name_0, name_1), and integers of 64 bits double.
PointFields fields_for_ply(PointFields fields);

// For PCD: red green blue (alpha) of 8 bits become PCL's packed rgb or rgba.
PointFields fields_for_pcd(PointFields fields);

}  // namespace augicp
