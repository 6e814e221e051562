// SPDX-License-Identifier: MIT
// Brightness as a measurement beside position and direction. Of a pair (j, i), with q = T (+) p_j and g_i the target's
// gradient along its surface, the error is what the target's brightness would be at q, less what the source measured:
//
//   r = I_i + g_i . (q - p_i) - I_j - offset,   J = [g_i^T, (q x g_i)^T]
//
// J. Park, Q.-Y. Zhou, V. Koltun, "Colored Point Cloud Registration Revisited" (ICCV 2017) has the idea: a brightness
// defined on the surface, not in an image, so that any cloud can have one.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "augicp/cloud/posed_pairs.h"
#include "augicp/objective/normal_equations.h"

namespace augicp {

struct IntensityModel {
  double information = 0.0;  // of r, per squared unit of intensity. 0: intensities do not count
  double kernel_chi2 = std::numeric_limits<double>::infinity();  // K of Eq. (13) for this part alone, above 0
  double offset = 0.0;  // what the target's brightness exceeds the source's by: exposure, or the angle of view

  // Throws std::invalid_argument naming the first number out of its range.
  void check() const;
};

// Are there intensities on both sides, and gradients in the target?
bool compares_intensities(const Cloud& source, const Cloud& target);

// r of every pair, offset included; NaN where the intensities are not compared: one of them or the gradient is not
// known.
std::vector<float> intensity_residuals(const PosedPairs& posed, int num_threads);

// H, b and cost of this part alone; num_intensity_pairs counts those compared. Points without their origins. b is the
// gradient of the cost under the offset given. H is that of a pose whose offset is not known but found with it (the
// Schur complement): a motion that a change of exposure explains as well, such as one along an even ramp of brightness,
// is not held. Same bits for any number of threads.
NormalEquations linearize_intensity(const PosedPairs& posed, const IntensityModel& model, int num_threads);

// The information that both points of each pair hold: as H, but with one J of the target's gradient and one of the
// source's. What the noise of one seems to hold, that of the other denies, so that a bare wall is held by neither. To
// judge a pose by, not to step by: it may have eigenvalues a little below zero. Zero where the source has no gradients.
Mat6d shared_intensity_information(const PosedPairs& posed, const IntensityModel& model, int num_threads);

}  // namespace augicp
