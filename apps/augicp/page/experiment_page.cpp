// SPDX-License-Identifier: MIT
#include "apps/augicp/page/experiment_page.h"

#include <algorithm>
#include <limits>

#include "apps/augicp/page/parts.h"

namespace augicp::app {
namespace {

// One scale for all charts of a quantity, so that they can be compared by eye.
void share_range(Quantity& quantity) {
  AxisRange all{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const Chart& chart : quantity.charts) {
    const AxisRange range = chart.y_range.value_or(y_range_of(chart));
    all = {std::min(all.low, range.low), std::max(all.high, range.high)};
  }
  for (Chart& chart : quantity.charts) {
    chart.y_range = all;
    if (chart.log_y) choose_scale(chart);
    if (!chart.log_y) chart.y_range->low = std::min(all.low, 0.0);
  }
}

std::string quantity_html(const Quantity& quantity, std::size_t first_number) {
  std::vector<std::string> names;
  if (!quantity.charts.empty())
    for (const ChartSeries& series : quantity.charts.front().series) names.push_back(series.name);
  return "<section class=\"quantity\">\n<h2>" + escaped_html(quantity.name) + "</h2>\n" + legend_html(names) +
         figures_html(quantity.charts, first_number) + "</section>\n";
}

}  // namespace

std::string confusion_html(const std::vector<ConfusionRow>& rows) {
  std::vector<std::vector<std::string>> cells;
  for (const ConfusionRow& row : rows) {
    cells.push_back({std::string(name_of(row.truth))});
    for (const std::size_t count : {row.num_pairs, row.num_converged, row.num_doubtful, row.num_degenerate,
                                    row.num_iteration_limit, row.num_failed, row.num_converged_without_verdict})
      cells.back().push_back(std::to_string(count));
  }
  return section_html("Pairs by truth and status",
                      html_table({{"truth", "Whether the pose that was found is right, by the known one."},
                                  "pairs",
                                  "converged",
                                  "doubtful",
                                  "degenerate",
                                  "iteration limit",
                                  "failed",
                                  {"converged without evidence",
                                   "Pairs whose steps became small, whatever the clouds say of the pose."}},
                                 cells));
}

std::string experiment_page(const std::vector<std::string>& lines, std::vector<Quantity> quantities,
                            const std::string& table) {
  std::string body = "<main>\n";
  std::vector<Chart> charts;
  for (Quantity& quantity : quantities) {
    share_range(quantity);
    body += quantity_html(quantity, charts.size());
    charts.insert(charts.end(), quantity.charts.begin(), quantity.charts.end());
  }
  return whole_page({"Experiment", "", "", lines}, "experiment", body + table + "</main>\n", charts);
}

}  // namespace augicp::app
