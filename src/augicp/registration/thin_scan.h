// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/registration/prepared_pair.h"

namespace augicp {

// Every step-th pixel of every step-th row of a scan with a view, with the directions estimated on the whole image.
// step 1: the scan unchanged.
Scan thinned(const Scan& scan, int step);

// The step after which about num_columns columns of a scan with a view remain.
int step_for(const Scan& scan, int num_columns);

// A prepared scan with fewer points: about num_columns columns of an image, or one point per voxel of `voxels` times
// the present voxel size.
Scan coarser(const Scan& scan, int num_columns, double voxels, const Lengths& lengths);

// Both scans.
PreparedPair coarser(const ScanPair& pair, int num_columns, double voxels, int num_threads);

}  // namespace augicp
