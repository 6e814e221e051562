// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/objective/linearize.h"

namespace augicp {

// Eq. (10): the increment that solves (H + Lambda) dT = -b. Lambda is `damping` times the mean diagonal of H's
// translation block for the translation, and of its rotation block for the rotation: metres and radians differ, and a
// damping in absolute units would mean another thing for every scene.
Vec6d damped_step(const NormalEquations& equations, double damping);

}  // namespace augicp
