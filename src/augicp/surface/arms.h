// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "augicp/cloud/cloud.h"
#include "augicp/cloud/index_image.h"
#include "augicp/surface/window_neighbourhood.h"

namespace augicp {

// Half the side of the square with the area of a unit disc.
inline constexpr double kSquareHalfSide = 0.886226925452758;

// Throws std::invalid_argument if an option is out of its range.
void check(const WindowOptions& options);

// The radius of the ball around a point at this depth, metres.
double ball_radius(float depth, const WindowOptions& options);

// Whether a depth discontinuity separates two readings of a line, which are neighbours except for missing readings
// between them. Depths in metres.
inline bool is_step(float a, float b, int pixels_between, double max_step_per_depth) {
  const double allowed = max_step_per_depth * std::min(a, b) * pixels_between;
  return std::abs(static_cast<double>(a) - static_cast<double>(b)) > allowed;
}

// The pixels of one row or column that have a point, in order, cut into runs without a discontinuity.
struct Line {
  std::vector<std::int32_t> position;  // pixel along the line
  std::vector<std::int32_t> point;     // index into the cloud
  std::vector<std::int32_t> run;       // number of the run
};

// Line number `which` of the image: a row (along_rows) or a column. A missing reading does not end a run; a step in
// depth does.
Line image_line(const Cloud& cloud, const IndexImage& index, bool along_rows, int which, double max_step_per_depth);

// For every entry of the line, the reach of its run in both directions within half_side (per entry, metres). Both ends
// are within half_side; noise may put single entries between them slightly farther away.
struct Reach {
  std::vector<std::int32_t> first, last;
};
Reach reach_along(const Line& line, const Cloud& cloud, const std::vector<double>& half_side);

}  // namespace augicp
