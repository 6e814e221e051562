// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "augicp/cloud/cloud.h"

namespace augicp {

// A sentence if one of two clouds of the same place is about a thousand times as large as the other, as one in
// millimetres beside one in metres is; else empty.
std::string unit_warning(const Cloud& source, const Cloud& target);

}  // namespace augicp
