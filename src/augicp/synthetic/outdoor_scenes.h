// SPDX-License-Identifier: MIT
// Scenes for a LiDAR, each with a sensible place for it. World: z up, the ground at zero, metres. Long structures run
// along x, from -kHalfLength to kHalfLength. scene.world_from_camera is the sensor's place, its x axis along the
// world's.
#pragma once

#include "augicp/testing/scene.h"

namespace augicp::synthetic {

// Beyond the range of any sensor in the middle, so that no end is visible.
inline constexpr double kHalfLength = 300.0;

// Floor, ceiling and two walls, bare: the translation along x is not constrained.
testing::Scene corridor(double width = 2.5, double height = 2.8);

// A round tube with a level floor: the translation along x is not constrained.
testing::Scene tunnel(double radius = 3.0);

// A roof on two rows of columns over a floor: a translation by the period along x changes nothing.
testing::Scene colonnade(double period = 3.0, double width = 6.0);

// Level ground and nothing else: the translations along it and the rotation about the vertical are not constrained.
testing::Scene open_field();

// Houses of random widths, depths, heights and setbacks on both sides of a street with parked cars and poles, drawn
// from the seed. All six motions are constrained.
testing::Scene street(unsigned seed);

}  // namespace augicp::synthetic
