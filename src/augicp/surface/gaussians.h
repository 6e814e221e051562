// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/cloud/cloud.h"
#include "augicp/surface/neighbourhood.h"
#include "augicp/surface/shape.h"

namespace augicp {

// The smallest variance of a Gaussian as a part of its largest: that of Biber and Strasser (IROS 2003), and epsilon of
// Table 2. Without it, exact planes would have infinite information.
inline constexpr double kLeastVariance = 1e-3;

// Estimates the Gaussian around every point, Eq. (15), for Eq. (2). Their information is in units of 4 / radius^2, the
// inverse variance of a disc of that radius (metres, above 0) along itself. Such a disc has the information of Table 2,
// across 1 and along 1000, so that K of Eq. (13) means the same for all methods. Points with fewer than eight
// neighbours, and points whose neighbours are all in one place, have no information. Existing Gaussians are replaced.
// Bit-identical for any number of threads.
void estimate_gaussians(Cloud& cloud, const Neighbourhood& neighbourhood, double radius, int num_threads);

// The Gaussian of some points relative to a disc of that radius.
PointGaussian relative_gaussian(const Gaussian& points, double radius);

}  // namespace augicp
