// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/objective/linearize.h"
#include "augicp/trust/observability.h"

namespace augicp {

// Eq. (10): the increment that solves (H + Lambda) dT = -b. Lambda is `damping` times the mean diagonal of H's
// translation block for the translation, and of its rotation block for the rotation: metres and radians differ, and a
// damping in absolute units would mean another thing for every scene.
Vec6d damped_step(const NormalEquations& equations, double damping);

// The same where the data leave the num_free weakest directions open: the best step of those that do not move in them,
// in the metric of observability.h. Solution remapping (Zhang, Kaess and Singh 2016) projects the full step instead;
// where a free direction is coupled with a held one by noise, that keeps a part of the noise, and the best constrained
// step does not (X-ICP, Tuna et al. 2024). Zero where all six are free.
Vec6d held_step(const NormalEquations& equations, double damping, const Observability& observability, int num_free);

}  // namespace augicp
