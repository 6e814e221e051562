// SPDX-License-Identifier: MIT
#include "apps/augicp/text/evaluation.h"

#include <fmt/core.h>

#include "apps/augicp/text/drift.h"
#include "apps/augicp/text/matrix_json.h"
#include "apps/augicp/text/options_json.h"
#include "augicp/core/angles.h"
#include "augicp/eval/option_table.h"
#include "augicp/geometry/rotation.h"

namespace augicp::app {
namespace {

Statistics in_degrees(Statistics statistics) {
  for (double Statistics::*field : {&Statistics::rmse, &Statistics::mean, &Statistics::median, &Statistics::std,
                                    &Statistics::min, &Statistics::max})
    statistics.*field *= kDegPerRad;
  statistics.sse *= kDegPerRad * kDegPerRad;
  return statistics;
}

nlohmann::ordered_json statistics_json(const Statistics& statistics) {
  return {{"rmse", statistics.rmse}, {"mean", statistics.mean},  {"median", statistics.median},
          {"std", statistics.std},   {"min", statistics.min},    {"max", statistics.max},
          {"sse", statistics.sse},   {"count", statistics.count}};
}

nlohmann::ordered_json pose_statistics_json(const std::optional<PoseStatistics>& errors) {
  if (!errors) return nullptr;
  return {{"translation", statistics_json(errors->translation)},
          {"rotation_deg", statistics_json(in_degrees(errors->rotation))}};
}

nlohmann::ordered_json alignment_json(const Evaluation& evaluation) {
  const Similarity3& truth_from_estimate = evaluation.alignment.target_from_source;
  return {{"T_truth_estimate", matrix_json(truth_from_estimate.motion.matrix())},
          {"scale", truth_from_estimate.scale},
          {"unique", evaluation.alignment.unique}};
}

std::string row(const std::string& name, const Statistics& s) {
  return fmt::format("{:<24} {:>10.6f} {:>10.6f} {:>10.6f} {:>10.6f} {:>10.6f} {:>10.6f}\n", name, s.rmse, s.mean,
                     s.median, s.std, s.min, s.max);
}

std::string rows(const std::string& name, const PoseStatistics& errors) {
  return row(name + ", m", errors.translation) + row(name + ", deg", in_degrees(errors.rotation));
}

std::string alignment_text(const Evaluation& evaluation) {
  const double scale = evaluation.alignment.target_from_source.scale;
  std::string text(name_of(evaluation.options.alignment));
  if (evaluation.options.alignment == Alignment::Similarity) text += fmt::format(", scale {:.6g}", scale);
  if (!evaluation.alignment.unique)
    text +=
        " (not unique: the positions stand still, are on a line to within the residual, or fewer than three; rotation "
        "errors after it say little)";
  return text;
}

std::string relative_text(const Evaluation& evaluation) {
  const DeltaOptions& options = evaluation.options.delta;
  const std::string delta = fmt::format("{:g} {}", options.delta, name_of(options.unit));
  if (!evaluation.relative) return fmt::format("relative   no two matched poses are {} apart\n", delta);
  return fmt::format("relative   over {}, {} pairs{}\n", delta, evaluation.relative->translation.count,
                     options.consecutive ? ", one after the other" : "");
}

// In one frame the alignment removes drift alone: at most this rotation and this multiple of what remains after it.
constexpr double kMaxRotationOfDrift_deg = 20.0;
constexpr double kMaxRatioOfDrift = 10.0;

std::string frames_text(const Evaluation& evaluation) {
  const Rigid3& motion = evaluation.alignment.target_from_source.motion;
  return fmt::format("ATE not aligned: the trajectories are in different frames, {:.3g} m and {:.3g} deg apart\n",
                     motion.translation.norm(), rotation_log(motion.rotation).norm() * kDegPerRad);
}

}  // namespace

bool shares_frame(const Evaluation& evaluation) {
  if (!evaluation.aligned || !evaluation.alignment.unique) return true;
  const double angle = rotation_log(evaluation.alignment.target_from_source.motion.rotation).norm();
  return angle * kDegPerRad < kMaxRotationOfDrift_deg ||
         evaluation.absolute.translation.rmse < kMaxRatioOfDrift * evaluation.aligned->translation.rmse;
}

std::vector<std::string> coverage_warnings(const Coverage& coverage) {
  std::vector<std::string> warnings;
  if (coverage.num_outside > 0)
    warnings.push_back(fmt::format("{} pose{} outside of the truth's time and {} not compared", coverage.num_outside,
                                   coverage.num_outside == 1 ? " lies" : "s lie",
                                   coverage.num_outside == 1 ? "is" : "are"));
  if (coverage.num_unmatched > 0)
    warnings.push_back(fmt::format("{} pose{} no true pose of the same moment, and {} not compared",
                                   coverage.num_unmatched, coverage.num_unmatched == 1 ? " has" : "s have",
                                   coverage.num_unmatched == 1 ? "is" : "are"));
  if (coverage.num_holes > 0)
    warnings.push_back(fmt::format("about {} pose{} missing in {} hole{}, the longest of {:.3g} s",
                                   coverage.num_missing, coverage.num_missing == 1 ? " is" : "s are",
                                   coverage.num_holes, coverage.num_holes == 1 ? "" : "s", coverage.longest_hole_s));
  return warnings;
}

std::string evaluation_text(const Evaluation& evaluation) {
  std::string text = fmt::format(
      "matched    {} of {} poses ({:.1f} %) with {} true ones\n"
      "time       {:.6f} .. {:.6f} s ({:.3f} s)\nalignment  {}\n",
      evaluation.num_matched, evaluation.num_estimate, 100.0 * evaluation.matched_share, evaluation.num_truth,
      evaluation.first_stamp_s, evaluation.last_stamp_s, evaluation.last_stamp_s - evaluation.first_stamp_s,
      alignment_text(evaluation));
  text += relative_text(evaluation);
  text +=
      fmt::format("\n{:<24}{:>11}{:>11}{:>11}{:>11}{:>11}{:>11}\n", "", "rmse", "mean", "median", "std", "min", "max");
  text += shares_frame(evaluation) ? rows("ATE not aligned", evaluation.absolute) : frames_text(evaluation);
  if (evaluation.aligned) text += rows("ATE aligned", *evaluation.aligned);
  if (evaluation.relative) text += rows("RPE", *evaluation.relative);
  return text + segments_text(evaluation.segments);
}

nlohmann::ordered_json evaluation_json(const Evaluation& evaluation) {
  return {{"num_estimate", evaluation.num_estimate},
          {"num_truth", evaluation.num_truth},
          {"num_matched", evaluation.num_matched},
          {"matched_share", evaluation.matched_share},
          {"num_outside", evaluation.coverage.num_outside},
          {"num_unmatched", evaluation.coverage.num_unmatched},
          {"num_holes", evaluation.coverage.num_holes},
          {"num_missing", evaluation.coverage.num_missing},
          {"longest_hole_s", evaluation.coverage.longest_hole_s},
          {"first_stamp_s", evaluation.first_stamp_s},
          {"last_stamp_s", evaluation.last_stamp_s},
          {"ate", pose_statistics_json(evaluation.absolute)},
          {"alignment", alignment_json(evaluation)},
          {"ate_aligned", pose_statistics_json(evaluation.aligned)},
          {"rpe", pose_statistics_json(evaluation.relative)},
          {"segments", segments_json(evaluation.segments)},
          {"options", options_json(evaluation.options)}};
}

}  // namespace augicp::app
