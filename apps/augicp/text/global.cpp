// SPDX-License-Identifier: MIT
#include "apps/augicp/text/global.h"

#include <fmt/core.h>

#include <limits>

#include "apps/augicp/text/evidence.h"
#include "augicp/core/angles.h"

namespace augicp::app {

std::string global_csv(std::span<const GlobalOutcome> outcomes) {
  std::string text =
      "family,source,target,status,translation_error_m,rotation_error_deg,time_ms," + evidence_header() + "\n";
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const GlobalOutcome& outcome : outcomes) {
    text += fmt::format("{},{},{},{},{:.5f},{:.4f},{:.1f},", outcome.family, outcome.source_name, outcome.target_name,
                        name_of(outcome.status), outcome.error ? outcome.error->translation : nan,
                        outcome.error ? outcome.error->rotation * kDegPerRad : nan, outcome.time_ms);
    text += evidence_csv(outcome.evidence) + "\n";
  }
  return text;
}

std::string global_text(const std::vector<GlobalRow>& rows) {
  std::string text =
      fmt::format("{:<20}{:>6}{:>8}{:>7}{:>17}{:>17}{:>11}{:>8}{:>10}{:>10}{:>9}\n", "family", "pairs", "found", "fine",
                  "right converged", "wrong converged", "ambiguous", "others", "median mm", "deg", "ms");
  for (const GlobalRow& row : rows)
    text += fmt::format("{:<20}{:>6}{:>8}{:>7}{:>17}{:>17}{:>11}{:>8}{:>10.1f}{:>10.2f}{:>9.0f}\n", row.family,
                        row.num_pairs, row.num_found, row.num_fine, row.right_converged, row.wrong_converged,
                        row.ambiguous, row.others, 1000.0 * row.median_error.translation,
                        row.median_error.rotation * kDegPerRad, row.median_ms);
  return text;
}

}  // namespace augicp::app
