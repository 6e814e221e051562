// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/registration/prepared_pair.h"

namespace augicp {

// Every step-th pixel of every step-th row of a scan with a view, with the directions found on the whole image; 1: the
// scan as it is.
Scan thinned(const Scan& scan, int step);

// The step that leaves about so many columns of a scan with a view.
int step_for(const Scan& scan, int num_columns);

// A prepared scan with fewer points: about num_columns columns of an image; of a cloud one point a voxel, which is
// `voxels` times as large as the one that it was downsampled to.
Scan coarser(const Scan& scan, int num_columns, double voxels, const Lengths& lengths);

// Both scans.
PreparedPair coarser(const ScanPair& pair, int num_columns, double voxels);

}  // namespace augicp
