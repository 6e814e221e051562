// SPDX-License-Identifier: MIT
// Curves as inline SVG: what a report shows where no script runs, and what scripts replace by charts one can point at.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "augicp/report/axis_ticks.h"

namespace augicp {

struct ChartSeries {
  std::string name;
  std::vector<double> y{};            // one for each x; not finite: a hole
  std::vector<double> low{}, high{};  // a band around y; empty, or as many
};

struct Chart {
  std::string title, x_label, y_label;  // labels with their unit
  bool log_y = false;
  std::vector<double> x{};  // ascending
  std::vector<ChartSeries> series{};
  std::optional<AxisRange> y_range{};  // not set: that of the series
};

// A logarithmic axis where the values span more than a power of ten, and a linear one where they do not: there it would
// have hardly a number.
void choose_scale(Chart& chart);

// The range of all series, bands included.
AxisRange y_range_of(const Chart& chart);

std::string chart_svg(const Chart& chart);

// Lines in a plane, with one metre as long on both axes.
struct Path {
  std::string name;
  std::vector<Eigen::Vector2d> points;
};
std::string paths_svg(const std::string& title, const std::string& x_label, const std::string& y_label,
                      const std::vector<Path>& paths);

// Names of series beside the strokes that they are drawn with.
std::string legend_html(const std::vector<std::string>& names);

}  // namespace augicp
