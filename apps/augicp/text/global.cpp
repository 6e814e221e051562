// SPDX-License-Identifier: MIT
#include "apps/augicp/text/global.h"

#include <fmt/core.h>

#include <limits>

#include "augicp/core/angles.h"

namespace augicp::app {

namespace {

std::string whole_testimony_csv(const Testimony& testimony) {
  return fmt::format(",{:d},{:.4f},{:.4f},{:.4f},{:.4f},{:.4f}", testimony.knows_free_space, testimony.seen(),
                     testimony.agreeing(), testimony.conflicting(), testimony.contradicting, testimony.off_planes);
}

std::string evidence_csv(const Evidence& evidence) {
  return fmt::format(",{:.4f}", strain(evidence)) + whole_testimony_csv(evidence.source_in_target) +
         whole_testimony_csv(evidence.target_in_source) +
         fmt::format(",{:.4f},{:.3e},{:.3f}", evidence.beyond_planes, evidence.observability, evidence.outvoted);
}

}  // namespace

std::string global_csv(std::span<const GlobalOutcome> outcomes) {
  std::string text =
      "family,source,target,status,translation_error_m,rotation_error_deg,time_ms,strain,free_space_1,seen_1,"
      "agreeing_1,conflicting_1,contradicting_1,off_planes_1,free_space_2,seen_2,agreeing_2,conflicting_2,"
      "contradicting_2,off_planes_2,beyond_planes,observability,outvoted\n";
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const GlobalOutcome& outcome : outcomes) {
    text += fmt::format("{},{},{},{},{:.5f},{:.4f},{:.1f}", outcome.family, outcome.source_name, outcome.target_name,
                        name_of(outcome.status), outcome.error ? outcome.error->translation : nan,
                        outcome.error ? outcome.error->rotation * kDegPerRad : nan, outcome.time_ms);
    text += (outcome.evidence ? evidence_csv(*outcome.evidence) : std::string(16, ',')) + "\n";
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
