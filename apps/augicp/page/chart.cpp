// SPDX-License-Identifier: MIT
#include "apps/augicp/page/chart.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "apps/augicp/page/html.h"
#include "apps/augicp/page/plot_area.h"

namespace augicp::app {
namespace {

// Strokes that people with any colour vision can distinguish, by colour and by dashes: the number of those in the
// page's style.
constexpr std::size_t kNumStrokes = 6;

bool is_whole(double value) { return std::floor(value) == value; }

std::string polyline(std::size_t series, const std::string& points) {
  return fmt::format("<path class=\"curve s{}\" d=\"{}\"/>\n", series % kNumStrokes, points);
}

std::string curve(const PlotArea& area, const std::vector<double>& x, const std::vector<double>& y,
                  std::size_t series) {
  std::string points;
  bool is_pen_down = false;
  for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
    const bool has_place = std::abs(x[i]) <= 1e300 && area.has_place(y[i]);
    if (has_place) points += fmt::format("{}{:.1f} {:.1f}", is_pen_down ? "L" : "M", area.at_x(x[i]), area.at_y(y[i]));
    is_pen_down = has_place;
  }
  return polyline(series, points);
}

std::string band(const PlotArea& area, const std::vector<double>& x, const ChartSeries& series, std::size_t number) {
  std::string there, back;
  for (std::size_t i = 0; i < std::min(series.low.size(), series.high.size()); ++i) {
    if (!area.has_place(series.low[i]) || !area.has_place(series.high[i])) continue;
    there += fmt::format("{:.1f},{:.1f} ", area.at_x(x[i]), area.at_y(series.high[i]));
    back = fmt::format("{:.1f},{:.1f} ", area.at_x(x[i]), area.at_y(series.low[i])) + back;
  }
  if (there.empty()) return {};
  return fmt::format("<polygon class=\"band s{}\" points=\"{}\"/>\n", number % kNumStrokes, there + back);
}

}  // namespace

AxisRange y_range_of(const Chart& chart) {
  std::vector<double> values;
  for (const ChartSeries& series : chart.series)
    for (const std::vector<double>* part : {&series.y, &series.low, &series.high})
      values.insert(values.end(), part->begin(), part->end());
  const AxisRange range = range_of(values, chart.log_y);
  return chart.log_y ? range : AxisRange{std::min(range.low, 0.0), std::max(range.high, 0.0)};
}

std::string y_label_of(const Chart& chart) { return chart.y_label + (chart.log_y ? ", logarithmic" : ""); }

void choose_scale(Chart& chart) {
  chart.log_y = true;
  const AxisRange range = chart.y_range.value_or(y_range_of(chart));
  chart.log_y = range.low > 0.0 && range.high > 10.0 * range.low;
}

std::string chart_svg(const Chart& chart) {
  PlotArea area{range_of(chart.x, false), chart.y_range.value_or(y_range_of(chart)), chart.log_y};
  area.whole_x = std::all_of(chart.x.begin(), chart.x.end(), is_whole);
  std::string content = axes_svg(area, chart.x_label, y_label_of(chart));
  for (std::size_t i = 0; i < chart.series.size(); ++i) content += band(area, chart.x, chart.series[i], i);
  for (std::size_t i = 0; i < chart.series.size(); ++i) content += curve(area, chart.x, chart.series[i].y, i);
  return svg(area, chart.title, content);
}

std::string paths_svg(const std::string& title, const std::string& x_label, const std::string& y_label,
                      const std::vector<Path>& paths) {
  std::vector<std::vector<double>> x(paths.size()), y(paths.size());
  std::vector<double> all_x, all_y;
  for (std::size_t i = 0; i < paths.size(); ++i)
    for (const Eigen::Vector2d& point : paths[i].points) {
      x[i].push_back(point.x());
      y[i].push_back(point.y());
      all_x.push_back(point.x());
      all_y.push_back(point.y());
    }
  PlotArea area{range_of(all_x, false), range_of(all_y, false)};
  area.height = 360.0;
  make_equal(area);
  std::string content = axes_svg(area, x_label, y_label);
  for (std::size_t i = 0; i < paths.size(); ++i) content += curve(area, x[i], y[i], i);
  // For the marker of the script: the origin and the length of a metre.
  content += fmt::format("<g class=\"marker\" data-x=\"{:.4f}\" data-y=\"{:.4f}\" data-scale=\"{:.6g}\"></g>\n",
                         area.at_x(0.0), area.at_y(0.0), area.at_x(1.0) - area.at_x(0.0));
  return svg(area, title, content);
}

std::string legend_html(const std::vector<std::string>& names) {
  std::string html = "<p class=\"legend\">";
  for (std::size_t i = 0; i < names.size(); ++i)
    html += fmt::format(
        "<span><svg viewBox=\"0 0 24 8\" aria-hidden=\"true\"><path class=\"curve s{}\" d=\"M0 4L24 "
        "4\"/></svg>{}</span>",
        i % kNumStrokes, escaped_html(names[i]));
  return html + "</p>\n";
}

}  // namespace augicp::app
