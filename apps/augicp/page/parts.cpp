// SPDX-License-Identifier: MIT
#include "apps/augicp/page/parts.h"

#include <fmt/core.h>

#include <cmath>

#include "apps/augicp/page/report_bundle.h"
#include "augicp/io/parse_number.h"

namespace augicp::app {
namespace {

// Seven digits are more than a chart shows, and half the bytes.
double shortened(double value) {
  const int digits = 7;
  return std::isfinite(value) ? parse_double(fmt::format("{:.{}g}", value, digits)).value_or(value) : value;
}

std::vector<double> shortened(std::vector<double> values) {
  for (double& value : values) value = shortened(value);
  return values;
}

nlohmann::ordered_json series_json(const ChartSeries& series) {
  nlohmann::ordered_json json{{"name", series.name}, {"y", shortened(series.y)}};
  if (!series.low.empty() && !series.high.empty())
    json.update({{"low", shortened(series.low)}, {"high", shortened(series.high)}});
  return json;
}

nlohmann::ordered_json chart_json(const Chart& chart) {
  const AxisRange range = chart.y_range.value_or(y_range_of(chart));
  nlohmann::ordered_json series = nlohmann::ordered_json::array();
  for (const ChartSeries& one : chart.series) series.push_back(series_json(one));
  return {{"title", chart.title}, {"x_label", chart.x_label}, {"y_label", y_label_of(chart)},
          {"log_y", chart.log_y}, {"x", shortened(chart.x)},  {"y_range", {range.low, range.high}},
          {"series", series}};
}

// For a reader who sees no 3D view: that it is missing, and why.
std::string missing_html(bool has_script) {
  if (!has_script)
    return "<p class=\"notice\">No 3D view: this augicp was built without the script of its reports, which needs Node "
           "18. Curves and tables are complete.</p>\n";
  return "<noscript><p class=\"notice\">No 3D view: this browser, or the program that shows this file, runs no "
         "scripts. "
         "Curves and tables are complete. Opened in a browser with scripts, the file shows the "
         "clouds.</p></noscript>\n";
}

}  // namespace

std::string header_html(const PageHead& head) {
  std::string html = "<header>\n<div class=\"title\"><h1>" + escaped_html(head.title) + "</h1>";
  if (!head.badge.empty())
    html += "<span class=\"badge " + head.badge_class + "\">" + escaped_html(head.badge) + "</span>";
  html += "</div>\n";
  for (const std::string& line : head.lines) html += "<p>" + escaped_html(line) + "</p>\n";
  return html + "</header>\n";
}

std::string section_html(const std::string& title, const std::string& content) {
  return "<section>\n<h2>" + escaped_html(title) + "</h2>\n" + content + "</section>\n";
}

std::string details_html(const std::string& title, const std::string& content) {
  return "<section><details>\n<summary>" + escaped_html(title) + "</summary>\n" + content + "</details></section>\n";
}

std::string figure_html(const Chart& chart, std::size_t number) {
  return fmt::format("<figure data-chart=\"{}\"><figcaption>{}</figcaption>\n{}</figure>\n", number,
                     html_explained(chart.title, chart.meaning), chart_svg(chart));
}

std::string figures_html(std::span<const Chart> charts, std::size_t first_number) {
  std::string html = "<div class=\"grid-of-charts\">\n";
  for (std::size_t i = 0; i < charts.size(); ++i) html += figure_html(charts[i], first_number + i);
  return html + "</div>\n";
}

nlohmann::ordered_json charts_json(std::span<const Chart> charts) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const Chart& chart : charts) json.push_back(chart_json(chart));
  return json;
}

std::vector<double> pose_numbers(const Rigid3& page_from_body) {
  const Mat4d matrix = page_from_body.matrix();
  return shortened(std::vector<double>(matrix.data(), matrix.data() + matrix.size()));
}

std::vector<double> numbers(const Vec3d& vector) { return {vector.begin(), vector.end()}; }

std::string whole_page(const PageHead& head, const std::string& kind, const std::string& body,
                       std::span<const Chart> charts, nlohmann::ordered_json data) {
  const PageBundle bundle = report_bundle();
  nlohmann::ordered_json json{{"kind", kind}, {"charts", charts_json(charts)}};
  if (!data.is_null()) json[kind] = std::move(data);
  std::string text;
  if (!bundle.script.empty()) text = json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  const std::string footer = "<footer>augicp " AUGICP_VERSION "</footer>\n";
  return to_html(
      {"augicp: " + head.title, header_html(head) + missing_html(!bundle.script.empty()) + body + footer, text},
      bundle);
}

}  // namespace augicp::app
