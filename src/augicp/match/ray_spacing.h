// SPDX-License-Identifier: MIT
// Whether a cloud is one sensor's scan from a place, known by two laws of its rays. The angles between them do not
// depend on what the rays meet. And rays do not come closer to each other than the sensor's step: seen from elsewhere,
// the directions to the points of a scan interleave, and so do those to the points of several scans, or of a model.
#pragma once

#include <optional>
#include <span>

#include "augicp/cloud/cloud.h"
#include "augicp/match/ray_patches.h"

namespace augicp {

// Where a cloud's sensor is, if it is one sensor's scan: at its viewpoint, or else at the zero of its frame. Relative
// to its origin, metres.
inline Vec3f assumed_place(const Cloud& cloud) { return cloud.viewpoint.value_or((-cloud.origin).cast<float>()); }

// How evenly rays are spaced: in a patch, the 2nd percentile of the angles to the nearest other ray, divided by their
// 20th; the median over the patches, in [0, 1]. Directions at random have 0.3. Most sensors have 0.87 and more, even if
// their lines are not in step. Sensors whose lines nearly meet have 0.4. 0 for no patch.
double evenness(std::span<const RayPatch> patches);

// The exponent p of spacing ~ range^p over the patches: 0 for rays, -1 for points that are spread evenly over a
// surface. None if the ranges hardly differ.
std::optional<double> growth_with_range(std::span<const RayPatch> patches);

// Whether a cloud's points lie on the rays of a sensor at its assumed place, with few points farther than the tolerance
// (metres) behind others. For a cloud as its sensor gave it: the rays of a thinned one are no longer even.
bool is_one_sensors_scan(const Cloud& cloud, float tolerance);

}  // namespace augicp
