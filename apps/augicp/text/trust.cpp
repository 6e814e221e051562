// SPDX-License-Identifier: MIT
#include "apps/augicp/text/trust.h"

#include <fmt/core.h>

#include "apps/augicp/text/evidence.h"
#include "augicp/align/align.h"
#include "augicp/core/angles.h"

namespace augicp::app {

std::string trust_csv(std::span<const TrustResults> results) {
  std::string text = "family,seed,status,right,translation_error,rotation_error_deg,named,moved_along_free," +
                     evidence_header() + "\n";
  for (const TrustResults& of_family : results)
    for (const synthetic::TrustOutcome& pair : of_family.outcomes) {
      const std::string error =
          pair.error ? fmt::format("{},{}", pair.error->translation, kDegPerRad * pair.error->rotation) : ",";
      text += fmt::format("{},{},{},{:d},{},{:d},{},{}\n", of_family.family, pair.seed, name_of(pair.status),
                          pair.is_right, error, pair.is_named, pair.moved_along_free, evidence_csv(pair.evidence));
    }
  return text;
}

std::string trust_roc_csv(std::span<const TrustResults> results) {
  std::string text = "family,max_strain,wrong_accepted,right_refused\n";
  for (const TrustResults& of_family : results)
    for (const synthetic::TrustRocPoint& point : synthetic::trust_roc(of_family.outcomes))
      text +=
          fmt::format("{},{},{},{}\n", of_family.family, point.max_strain, point.wrong_accepted, point.right_refused);
  return text;
}

std::string trust_text(std::span<const TrustResults> results) {
  std::string text = fmt::format("{:<24}{:>6}{:>11}{:>9}{:>11}{:>9}{:>11}{:>12}{:>7}{:>8}\n", "", "", "right", "right",
                                 "WRONG", "wrong", "", "", "", "moved");
  text += fmt::format("{:<24}{:>6}{:>11}{:>9}{:>11}{:>9}{:>11}{:>12}{:>7}{:>8}\n", "family", "pairs", "converged",
                      "refused", "converged", "refused", "ambiguous", "degenerate", "named", "free");
  for (const TrustResults& of_family : results) {
    const synthetic::TrustRow row = synthetic::row_of(of_family.outcomes);
    text += fmt::format("{:<24}{:>6}{:>11}{:>9}{:>11}{:>9}{:>11}{:>12}{:>7}{:>8.3f}\n", of_family.family, row.num_pairs,
                        row.right_converged, row.right_refused, row.wrong_converged, row.wrong_refused, row.ambiguous,
                        row.degenerate, row.named, row.largest_move);
  }
  return text;
}

}  // namespace augicp::app
