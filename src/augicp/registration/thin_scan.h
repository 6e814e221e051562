// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/registration/lengths.h"

namespace augicp {

// Every step-th pixel of every step-th row of a scan with a view, with the directions found on the whole image; 1: the
// scan as it is.
Scan thinned(const Scan& scan, int step);

// The step that leaves about so many columns of a scan with a view.
int step_for(const Scan& scan, int num_columns);

// The prepared scan with fewer points: about so many columns of an image, or one point a voxel of so many times the
// voxels it was thinned to.
Scan coarser(const Scan& scan, int num_columns, double voxels, const Lengths& lengths);

}  // namespace augicp
