// SPDX-License-Identifier: MIT
#include "apps/augicp/page/plot_area.h"

#include <fmt/core.h>

#include <cmath>

#include "apps/augicp/page/html.h"

namespace augicp::app {
namespace {

double share(double value, const AxisRange& range) { return (value - range.low) / (range.high - range.low); }

std::string text(double x, double y, const char* anchor, const std::string& words) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\">{}</text>\n", x, y, anchor, words);
}

std::string grid_line(double x1, double y1, double x2, double y2) {
  return fmt::format("<line class=\"grid\" x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\"/>\n", x1, y1, x2,
                     y2);
}

}  // namespace

bool PlotArea::has_place(double value) const { return std::abs(value) <= 1e300 && (!log_y || value > 0.0); }

double PlotArea::at_x(double value) const { return left + share(value, x) * (width - left - right); }

double PlotArea::at_y(double value) const {
  const double up = log_y ? share(std::log10(value), {std::log10(y.low), std::log10(y.high)}) : share(value, y);
  return height - bottom - up * (height - top - bottom);
}

void make_equal(PlotArea& area) {
  const double per_x = (area.x.high - area.x.low) / (area.width - area.left - area.right);
  const double per_y = (area.y.high - area.y.low) / (area.height - area.top - area.bottom);
  AxisRange& narrow = per_x < per_y ? area.x : area.y;
  const double more = per_x < per_y ? per_y / per_x : per_x / per_y;
  const double middle = 0.5 * (narrow.low + narrow.high), half = 0.5 * (narrow.high - narrow.low) * more;
  narrow = {middle - half, middle + half};
}

std::string axes_svg(const PlotArea& area, const std::string& x_label, const std::string& y_label) {
  const double bottom = area.height - area.bottom, right = area.width - area.right;
  std::string content;
  for (const double tick : axis_ticks(area.x, false, 6)) {
    if (area.whole_x && std::abs(tick - std::round(tick)) > 1e-6) continue;
    const double x = area.at_x(tick);
    content += grid_line(x, area.top, x, bottom) + text(x, bottom + 15.0, "middle", fmt::format("{:.6g}", tick));
  }
  for (const double tick : axis_ticks(area.y, area.log_y, 5)) {
    const double y = area.at_y(tick);
    content += grid_line(area.left, y, right, y) + text(area.left - 6.0, y + 4.0, "end", fmt::format("{:.6g}", tick));
  }
  content += text(0.5 * (area.left + right), area.height - 6.0, "middle", escaped_html(x_label));
  const double middle = 0.5 * (area.top + bottom);
  return content +
         fmt::format("<text transform=\"translate(13 {:.1f}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n", middle,
                     escaped_html(y_label));
}

std::string svg(const PlotArea& area, const std::string& title, const std::string& content) {
  return fmt::format("<svg viewBox=\"0 0 {:g} {:g}\" role=\"img\" aria-label=\"{}\">\n{}</svg>\n", area.width,
                     area.height, escaped_html(title), content);
}

}  // namespace augicp::app
