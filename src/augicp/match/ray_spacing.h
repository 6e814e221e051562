// SPDX-License-Identifier: MIT
// A sensor's rays do not come closer to each other than its step. Seen from elsewhere, the directions to the points of
// a scan interleave, and so do those to the points of several scans, or of a model.
#pragma once

#include "augicp/cloud/cloud.h"

namespace augicp {

// Where a cloud's sensor is, if it is one sensor's scan: at its viewpoint, or else at the zero of its frame. Relative
// to its origin, metres.
inline Vec3f assumed_place(const Cloud& cloud) { return cloud.viewpoint.value_or((-cloud.origin).cast<float>()); }

// How evenly the directions from a place (relative to the cloud's origin, metres) to a cloud's points are spaced: the
// 2nd percentile of the angles to the nearest other direction, divided by their median; in [0, 1]. Directions at random
// have 0.17, the rays of most sensors 0.7 to 1. Some of the cloud's directions are asked. 0 for fewer than two. For a
// cloud as its sensor gave it: the rays of a thinned one are no longer even.
double evenness_of_rays(const Cloud& cloud, const Vec3f& place);

// Whether a cloud's points lie on the rays of a sensor at its assumed place.
bool is_one_sensors_scan(const Cloud& cloud);

}  // namespace augicp
