// SPDX-License-Identifier: MIT
// Curves as inline SVG: shown if no script runs, and otherwise replaced by interactive charts.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "apps/augicp/page/axis_ticks.h"

namespace augicp::app {

struct ChartSeries {
  std::string name;
  std::vector<double> y{};            // one per x; not finite: a hole
  std::vector<double> low{}, high{};  // a band around y; empty, or one per x
};

struct Chart {
  std::string title, x_label, y_label;  // labels with their unit
  bool log_y = false;
  std::vector<double> x{};  // ascending
  std::vector<ChartSeries> series{};
  std::optional<AxisRange> y_range{};  // empty: the range of the series
  std::string meaning{};               // a sentence on what is drawn
};

// Makes the axis logarithmic if the values span more than a power of ten, else linear: a logarithmic axis would then
// have hardly a number.
void choose_scale(Chart& chart);

// The range of all series, bands included. A linear axis includes zero.
AxisRange y_range_of(const Chart& chart);

// The label of the axis, which says so if the axis has no zero.
std::string y_label_of(const Chart& chart);

std::string chart_svg(const Chart& chart);

// Lines in a plane, with the same scale on both axes.
struct Path {
  std::string name;
  std::vector<Eigen::Vector2d> points;
};
std::string paths_svg(const std::string& title, const std::string& x_label, const std::string& y_label,
                      const std::vector<Path>& paths);

// Names of series with the strokes that they are drawn with.
std::string legend_html(const std::vector<std::string>& names);

}  // namespace augicp::app
