// SPDX-License-Identifier: MIT
// Further columns from numbers in text.
#pragma once

#include <string_view>

#include "augicp/io/point_fields.h"

namespace augicp {

// Appends one number. A whole number keeps all its digits. A number beyond an integer type becomes the nearest one in
// it, and NaN zero. Returns false, with nothing appended, if the text is no number.
bool append_number(PointField& field, std::string_view text);

// The same for a column whose type the file does not state. It begins as Int64, and becomes Float64 at the first number
// that is not whole. Empty text is NaN.
bool append_untyped_number(PointField& field, std::string_view text);

// A column that began as Int64 in the smallest type that has all its values.
PointField narrowed(PointField field);

}  // namespace augicp
