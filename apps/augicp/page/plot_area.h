// SPDX-License-Identifier: MIT
// Places of values in a drawing, and its axes.
#pragma once

#include <string>

#include "apps/augicp/page/axis_ticks.h"

namespace augicp::app {

struct PlotArea {
  AxisRange x, y;
  bool log_y = false;
  bool whole_x = false;                  // x is a count
  double width = 480.0, height = 260.0;  // of the drawing, in its units
  double left = 72.0, right = 12.0, top = 10.0, bottom = 40.0;

  double at_x(double value) const;
  double at_y(double value) const;

  // Whether a value can be drawn: finite, and above 0 on a logarithmic axis.
  bool has_place(double value) const;
};

// Gives both axes the same scale, by widening one of the ranges.
void make_equal(PlotArea& area);

// Grid lines, their numbers, and the labels, which are escaped here.
std::string axes_svg(const PlotArea& area, const std::string& x_label, const std::string& y_label);

// The drawing around its content. Screen readers read the title.
std::string svg(const PlotArea& area, const std::string& title, const std::string& content);

}  // namespace augicp::app
