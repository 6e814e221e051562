// SPDX-License-Identifier: MIT
#include "apps/augicp/page/trust_page.h"

#include <fmt/core.h>

#include <vector>

#include "apps/augicp/page/experiment_page.h"
#include "apps/augicp/page/parts.h"

namespace augicp::app {
namespace {

using synthetic::TrustOutcome;

std::string counts_html(std::span<const TrustResults> results) {
  std::vector<std::vector<std::string>> rows;
  for (const TrustResults& of_family : results) {
    const synthetic::TrustRow row = synthetic::row_of(of_family.outcomes);
    rows.push_back({of_family.family});
    for (const std::size_t count : {row.num_pairs, row.right_converged, row.right_refused, row.wrong_converged,
                                    row.wrong_refused, row.ambiguous, row.degenerate, row.named})
      rows.back().push_back(std::to_string(count));
    rows.back().push_back(fmt::format("{:.3f}", row.largest_move));
  }
  return html_table({{"family", "Generated pairs of one kind, each from its seed."},
                     "pairs",
                     {"right, converged", "The pose is right, and the status trusts it."},
                     {"right, refused", "The pose is right, and the status does not trust it."},
                     {"wrong, converged", "The pose is wrong, and the status trusts it: what must not happen."},
                     {"wrong, refused", "The pose is wrong, and the status does not trust it."},
                     {"ambiguous", "The clouds agree on another pose as well."},
                     {"degenerate", "The data leave a motion free."},
                     {"named", "Of the degenerate ones, those whose free motions are the true ones."},
                     {"moved along free", "The farthest move along a motion that is called free, in gyration radii."}},
                    rows);
}

// Over all families: one of them has too few pairs for a curve.
Quantity limits(std::span<const TrustResults> results) {
  std::vector<TrustOutcome> all;
  for (const TrustResults& of_family : results)
    all.insert(all.end(), of_family.outcomes.begin(), of_family.outcomes.end());
  Chart chart{"Results that other limits would accept and refuse", "largest value accepted, in limits", "%"};
  chart.meaning =
      "At 1 are the limits in use. Smaller limits refuse more right poses, larger ones accept more wrong ones.";
  chart.y_range = AxisRange{0.0, 100.0};
  chart.series = {{"right, refused"}, {"wrong, accepted"}};
  for (const synthetic::TrustRocPoint& point : synthetic::trust_roc(all)) {
    chart.x.push_back(point.max_strain);
    chart.series[0].y.push_back(100.0 * point.right_refused);
    chart.series[1].y.push_back(100.0 * point.wrong_accepted);
  }
  return {"Limits of the verdict, all families", {chart}};
}

}  // namespace

std::string trust_page(std::span<const TrustResults> results) {
  return experiment_page({"How often each status is right"}, {limits(results)},
                         section_html("Pairs by family and status", counts_html(results)));
}

}  // namespace augicp::app
