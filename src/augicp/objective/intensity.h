// SPDX-License-Identifier: MIT
// Brightness as a measurement beside position and direction. For a pair (j, i), with q = T (+) p_j and g_i the gradient
// of the target's brightness along its surface, the residual is the target's brightness at q, minus the source's:
//
//   r = I_i + g_i . (q - p_i) - I_j - offset,   J = [g_i^T, (q x g_i)^T]
//
// The idea is from J. Park, Q.-Y. Zhou, V. Koltun, "Colored Point Cloud Registration Revisited" (ICCV 2017): brightness
// is defined on the surface, not in an image, so that any cloud can have it.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "augicp/cloud/posed_pairs.h"
#include "augicp/objective/normal_equations.h"

namespace augicp {

struct IntensityModel {
  double information = 0.0;  // of r, per squared unit of intensity. 0: intensities are off
  double kernel_chi2 = std::numeric_limits<double>::infinity();  // K of Eq. (13) for this part alone, above 0
  double offset = 0.0;  // brightness of the target minus that of the source: exposure, or the angle of view

  // Throws std::invalid_argument naming the first number out of its range.
  void check() const;
};

// True if both clouds have intensities and the target has gradients.
bool compares_intensities(const Cloud& source, const Cloud& target);

// r of every pair, offset included; NaN if one of the intensities or the gradient is unknown.
std::vector<float> intensity_residuals(const PosedPairs& posed, int num_threads);

// H, b and cost of this part alone; num_intensity_pairs is the number of compared pairs. Points are without their
// origins. b is the gradient of the cost for the given offset. H is that of a pose and an unknown offset, with the
// offset eliminated (the Schur complement). So a motion that a change of exposure explains as well, such as one along
// an even ramp of brightness, is not constrained. Bit-identical for any number of threads.
NormalEquations linearize_intensity(const PosedPairs& posed, const IntensityModel& model, int num_threads);

// The information that both points of each pair share: like H, but with one J from the target's gradient and one from
// the source's. The noise of the two gradients is independent and cancels, so a bare wall stays free. For judging a
// pose, not for steps: eigenvalues may be slightly below zero. Zero if the source has no gradients.
Mat6d shared_intensity_information(const PosedPairs& posed, const IntensityModel& model, int num_threads);

}  // namespace augicp
