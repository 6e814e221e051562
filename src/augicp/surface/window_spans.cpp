// SPDX-License-Identifier: MIT
#include "augicp/surface/window_spans.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "augicp/core/check.h"
#include "augicp/core/parallel.h"
#include "augicp/surface/arms.h"

namespace augicp {
namespace {

// Columns in the same cache lines are processed together.
constexpr std::size_t kSpanLinesPerBlock = 16;

// The largest float that compares with squared distances like the double.
float rounded_down(double value) {
  const auto rounded = static_cast<float>(value);
  return static_cast<double>(rounded) <= value ? rounded : std::nextafter(rounded, 0.0f);
}

// The pixels of one line that have a point, in order; reused for each line.
struct LinePoints {
  explicit LinePoints(int length)
      : position(length), x(length), y(length), z(length), limit_sq(length), first(length), last(length) {}
  int count = 0;
  std::vector<std::int32_t> position;  // pixel along the line
  std::vector<float> x, y, z;
  std::vector<float> limit_sq;  // squared length limit of the arms
  std::vector<std::int32_t> first, last;
};

// Whether an entry's arms may reach another. Adds in the order of Eigen's squaredNorm().
class Ball {
 public:
  Ball(const LinePoints& line, std::int32_t centre)
      : x_(line.x.data()),
        y_(line.y.data()),
        z_(line.z.data()),
        centre_x_(x_[centre]),
        centre_y_(y_[centre]),
        centre_z_(z_[centre]),
        limit_sq_(line.limit_sq[centre]) {}
  bool holds(std::int32_t k) const {
    const float x = x_[k] - centre_x_, y = y_[k] - centre_y_, z = z_[k] - centre_z_;
    return x * x + (y * y + z * z) <= limit_sq_;
  }

 private:
  const float *x_, *y_, *z_;
  float centre_x_, centre_y_, centre_z_, limit_sq_;
};

// Pixel k of the line is index[k * stride].
void read_line(const Cloud& cloud, const std::int32_t* index, int length, std::size_t stride, LinePoints& line) {
  int count = 0;
  for (int k = 0; k < length; ++k) {
    const std::int32_t i = index[k * stride];
    if (i == IndexImage::kNone) continue;
    const Vec3f& point = cloud.points[i];
    line.position[count] = k;
    line.x[count] = point.x(), line.y[count] = point.y(), line.z[count] = point.z();
    ++count;
  }
  line.count = count;
}

float arm_limit_sq(float depth, const WindowOptions& options) {
  const double half_side = kSquareHalfSide * ball_radius(depth, options);
  return rounded_down(half_side * half_side);
}

void limit_arms(const WindowOptions& options, LinePoints& line) {
  if (options.radius_per_depth == 0.0) {
    std::fill_n(line.limit_sq.begin(), line.count, arm_limit_sq(0.0f, options));
  } else {
    for (int i = 0; i < line.count; ++i) line.limit_sq[i] = arm_limit_sq(line.z[i], options);
  }
}

// Entries [begin, end) are a run without a discontinuity. See reach_along(): each search starts at the end of the
// neighbour's. If it had to move inwards, the entries farther out were just rejected.
void reach_in_run(LinePoints& line, std::int32_t begin, std::int32_t end) {
  std::int32_t reach = begin;
  for (std::int32_t i = begin; i < end; ++i) {
    const Ball ball(line, i);
    if (ball.holds(reach)) {
      while (reach > begin && ball.holds(reach - 1)) --reach;
    } else {
      do ++reach;
      while (reach < i && !ball.holds(reach));
    }
    line.first[i] = reach;
  }
  reach = end - 1;
  for (std::int32_t i = end - 1; i >= begin; --i) {
    const Ball ball(line, i);
    if (ball.holds(reach)) {
      while (reach + 1 < end && ball.holds(reach + 1)) ++reach;
    } else {
      do --reach;
      while (reach > i && !ball.holds(reach));
    }
    line.last[i] = reach;
  }
}

void reach_in_line(const WindowOptions& options, LinePoints& line) {
  limit_arms(options, line);
  const auto goes_on = [&](int k) {
    return !is_step(line.z[k - 1], line.z[k], line.position[k] - line.position[k - 1], options.max_step_per_depth);
  };
  for (int begin = 0, end = 1; begin < line.count; begin = end, ++end) {
    while (end < line.count && goes_on(end)) ++end;
    reach_in_run(line, begin, end);
  }
}

void write_spans(const LinePoints& line, std::size_t stride, Span* spans) {
  for (int i = 0; i < line.count; ++i)
    spans[line.position[i] * stride] = {static_cast<std::uint16_t>(line.position[line.first[i]]),
                                        static_cast<std::uint16_t>(line.position[line.last[i]] + 1)};
}

}  // namespace

void find_window_spans(const Cloud& cloud, const IndexImage& index, const WindowOptions& options, int num_threads,
                       const WindowSpans& spans) {
  check(options);
  for (const int side : {index.width, index.height})
    require(side <= std::numeric_limits<std::uint16_t>::max(), "image side", side, "must be at most 65535 pixels");
  std::fill(spans.in_row.begin(), spans.in_row.end(), Span{});
  std::fill(spans.in_column.begin(), spans.in_column.end(), Span{});
  for (const bool along_rows : {true, false}) {
    const int num_lines = along_rows ? index.height : index.width, length = along_rows ? index.width : index.height;
    const std::size_t stride = along_rows ? 1 : index.width, step = along_rows ? index.width : 1;
    Span* const out = along_rows ? spans.in_row.data() : spans.in_column.data();
    for_each_block(
        static_cast<std::size_t>(num_lines), num_threads,
        [&](std::size_t begin, std::size_t end) {
          LinePoints line(length);
          for (std::size_t which = begin; which < end; ++which) {
            read_line(cloud, index.index.data() + which * step, length, stride, line);
            reach_in_line(options, line);
            write_spans(line, stride, out + which * step);
          }
        },
        kSpanLinesPerBlock);
  }
}

}  // namespace augicp
