// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "augicp/geometry/rigid3.h"

namespace augicp::peers {

// The motion of a peer's matrix. Nothing where it is not rigid: not finite, or no rotation to within 1e-3.
std::optional<Rigid3> rigid_or_nothing(const Mat4d& matrix);

}  // namespace augicp::peers
