// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/objective/linearize.h"
#include "augicp/trust/observability.h"

namespace augicp {

// Eq. (10): the increment that solves (H + Lambda) dT = -b. Lambda is `damping` times the mean diagonal of H's
// translation block for the translation, and of its rotation block for the rotation. Metres and radians differ, and a
// damping in absolute units would depend on the scene.
Vec6d damped_step(const NormalEquations& equations, double damping);

// The same if the num_free weakest directions are free: the best step without motion along them, in the metric of
// observability.h. Solution remapping (Zhang, Kaess and Singh 2016) projects the full step instead. If noise couples a
// free direction with a constrained one, the projection keeps a part of the noise; the best constrained step does not
// (X-ICP, Tuna et al. 2024). Zero if all six directions are free.
Vec6d held_step(const NormalEquations& equations, double damping, const Observability& observability, int num_free);

}  // namespace augicp
