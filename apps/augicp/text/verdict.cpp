// SPDX-License-Identifier: MIT
#include "apps/augicp/text/verdict.h"

#include <fmt/core.h>

#include <limits>

#include "apps/augicp/text/evidence.h"
#include "augicp/core/angles.h"

namespace augicp::app {
namespace {

// Words without commas, for one field.
std::string doubts_csv(std::span<const Doubt> doubts) {
  std::string text;
  for (const Doubt doubt : doubts) text += (text.empty() ? "" : " ") + std::string(name_of(doubt));
  return text;
}

}  // namespace

std::string verdict_csv(std::span<const VerdictPair> pairs) {
  std::string text =
      "target_sequence,target,source_sequence,source,truth,status,without_verdict,doubts,true_overlap,"
      "translation_error_m,rotation_error_deg,point_residual_m,normal_residual_deg,last_step,last_rotation_step,nees," +
      evidence_header() + "\n";
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const VerdictPair& pair : pairs) {
    const Evidence evidence = pair.evidence.value_or(Evidence{});
    text +=
        fmt::format("{},{},{},{},{},{},{},{},{:.4f},{:.5f},{:.4f}", pair.target_sequence, pair.target,
                    pair.source_sequence, pair.source, name_of(pair.truth), name_of(pair.status),
                    name_of(pair.without_verdict), doubts_csv(pair.doubts), pair.true_overlap,
                    pair.error ? pair.error->translation : nan, pair.error ? pair.error->rotation * kDegPerRad : nan);
    text += fmt::format(",{:.6f},{:.4f},{:.3e},{:.3e},{:.4g},{}\n", evidence.residuals.point.median,
                        evidence.residuals.normal.median * kDegPerRad, evidence.last_step, evidence.last_rotation_step,
                        pair.nees.value_or(nan), evidence_csv(pair.evidence));
  }
  return text;
}

std::string confusion_text(const std::vector<ConfusionRow>& rows) {
  std::string text = fmt::format("{:<21}{:>7}{:>11}{:>10}{:>12}{:>17}{:>8}   {}\n", "pairs", "", "converged",
                                 "doubtful", "degenerate", "iteration_limit", "failed", "loop alone: converged");
  for (const ConfusionRow& row : rows)
    text += fmt::format("{:<21}{:>7}{:>11}{:>10}{:>12}{:>17}{:>8}   {}\n", name_of(row.truth), row.num_pairs,
                        row.num_converged, row.num_doubtful, row.num_degenerate, row.num_iteration_limit,
                        row.num_failed, row.num_converged_without_verdict);
  return text;
}

std::string roc_csv(const std::vector<RocPoint>& points) {
  std::string text = "max_strain,apart_accepted,wrong_accepted,right_refused\n";
  for (const RocPoint& point : points)
    text += fmt::format("{:.4f},{:.6f},{:.6f},{:.6f}\n", point.max_strain, point.apart_accepted, point.wrong_accepted,
                        point.right_refused);
  return text;
}

}  // namespace augicp::app
