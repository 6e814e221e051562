// SPDX-License-Identifier: MIT
#include "apps/augicp/text/align.h"

#include <fmt/core.h>

#include <cmath>

#include "apps/augicp/text/matrix_json.h"
#include "apps/augicp/text/options_json.h"
#include "augicp/core/angles.h"
#include "augicp/registration/option_table.h"
#include "augicp/trust/covariance.h"

namespace augicp::app {
namespace {

nlohmann::ordered_json history_json(const AlignResult& result) {
  nlohmann::ordered_json history = nlohmann::ordered_json::array();
  for (const AlignIteration& iteration : result.history)
    history.push_back({{"T_target_source", matrix_json(iteration.target_from_source.matrix())},
                       {"num_pairs", iteration.num_pairs},
                       {"cost", iteration.cost},
                       {"kernel_chi2", iteration.kernel_chi2},
                       {"lever", iteration.lever},
                       {"intensity_information", iteration.intensity_information}});
  return history;
}

nlohmann::ordered_json free_motions_json(const AlignResult& result) {
  nlohmann::ordered_json motions = nlohmann::ordered_json::array();
  for (const FreeMotion& motion : result.free_motions)
    motions.push_back({{"kind", name_of(motion.kind)},
                       {"axis", std::vector<double>(motion.axis.begin(), motion.axis.end())},
                       {"point", std::vector<double>(motion.point.begin(), motion.point.end())},
                       {"pitch", motion.pitch}});
  return motions;
}

std::string free_motions_text(const AlignResult& result) {
  std::string text;
  for (const FreeMotion& motion : result.free_motions) {
    const Vec3d& axis = motion.axis;
    const Vec3d& point = motion.point;
    text += fmt::format("free     {} {} ({:.3f} {:.3f} {:.3f})", name_of(motion.kind),
                        motion.kind == FreeMotion::Kind::Translation ? "along" : "about", axis.x(), axis.y(), axis.z());
    if (motion.kind != FreeMotion::Kind::Translation)
      text += fmt::format(" through ({:.3f} {:.3f} {:.3f})", point.x(), point.y(), point.z());
    text += "\n";
  }
  return text;
}

nlohmann::ordered_json testimony_json(const Testimony& testimony) {
  const Agreement& count = testimony.count;
  return {{"seen", testimony.seen()},
          {"agreeing", testimony.agreeing()},
          {"conflicting", testimony.conflicting()},
          {"knows_free_space", testimony.knows_free_space},
          {"contradicting", testimony.contradicting},
          {"off_planes", testimony.off_planes},
          {"num_points", count.total()}};
}

nlohmann::ordered_json statistics_json(const ResidualStatistics& statistics) {
  return {{"count", statistics.count}, {"median", statistics.median}};
}

nlohmann::ordered_json evidence_json(const AlignResult& result) {
  const Evidence& evidence = *result.evidence;
  nlohmann::ordered_json doubts = nlohmann::ordered_json::array();
  for (const Doubt doubt : result.doubts) doubts.push_back(name_of(doubt));
  return {{"strain", strain(evidence)},
          {"doubts", doubts},
          {"source_in_target", testimony_json(evidence.source_in_target)},
          {"target_in_source", testimony_json(evidence.target_in_source)},
          {"beyond_planes", evidence.beyond_planes},
          {"moved", evidence.moved},
          {"outvoted", evidence.outvoted},
          {"residuals",
           {{"point", statistics_json(evidence.residuals.point)},
            {"normal", statistics_json(evidence.residuals.normal)},
            {"tangent", statistics_json(evidence.residuals.tangent)}}}};
}

nlohmann::ordered_json runners_up_json(const AlignResult& result) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const RunnerUp& other : result.runners_up)
    rows.push_back({{"T_target_source", matrix_json(other.target_from_source.matrix())},
                    {"strain", strain(other.evidence)},
                    {"source_in_target", testimony_json(other.evidence.source_in_target)},
                    {"target_in_source", testimony_json(other.evidence.target_in_source)}});
  return rows;
}

std::string testimony_text(const char* name, const Testimony& testimony) {
  std::string text = fmt::format("{} sees {:.0f} % of the other; {:.1f} % of it agree", name, 100.0 * testimony.seen(),
                                 100.0 * testimony.agreeing());
  if (testimony.knows_free_space) text += fmt::format(", {:.1f} % in free space", 100.0 * testimony.conflicting());
  if (testimony.contradicting > 0.0)
    text += fmt::format(", a part of {:.1f} % contradicts", 100.0 * testimony.contradicting);
  return text;
}

nlohmann::ordered_json uncertainty_json(const AlignReport& report) {
  const std::optional<Uncertainty> sigma = uncertainty(report);
  if (!sigma) return nullptr;
  return {{"translation_m", sigma->translation},
          {"rotation_deg", sigma->rotation * kDegPerRad},
          {"at", std::vector<double>(report.centre.begin(), report.centre.end())}};
}

// A length as a person writes it: millimetres where they are fewer than a thousand.
std::string length_text(double length_m) {
  return length_m < 1.0 ? fmt::format("{:.3g} mm", 1000.0 * length_m) : fmt::format("{:.3g} m", length_m);
}

// Why so few points are left that nothing could be aligned.
std::string few_points_text(const AlignReport& report) {
  if (report.result.status != AlignStatus::TooFewPairs) return {};
  const auto [source, target] = report.num_prepared;
  const std::size_t num_read = std::min(report.num_read[0], report.num_read[1]);
  std::string text = fmt::format("points   {} of the source and {} of the target are left of {} and {}", source, target,
                                 report.num_read[0], report.num_read[1]);
  if (num_read > 10 * std::min(source, target) && (report.options.voxel_size || report.options.radius))
    text += fmt::format(", one a voxel of {:.4g} m: use a smaller {}", report.lengths.voxel_size,
                        report.options.voxel_size ? "--voxel-size" : "--radius");
  return text + "\n";
}

// The fit of what overlaps, as a person measures it: off the surface, not from point to point, which is the spacing.
std::string fit_text(const AlignResult& result) {
  if (!result.evidence || result.evidence->residuals.point.count == 0)
    return fmt::format("pairs    {}, overlap {:.1f} %, rmse {:.4g} m\n", result.num_pairs, 100.0 * result.overlap,
                       result.rmse);
  const Residuals& residuals = result.evidence->residuals;
  std::string text = fmt::format("fit      {} off the target's surface", length_text(residuals.point.median));
  if (residuals.normal.count > 0)
    text += fmt::format(", normals {:.2g} deg apart", residuals.normal.median * kDegPerRad);
  return text + fmt::format(" (medians); overlap {:.1f} %, {} pairs\n", 100.0 * result.overlap, result.num_pairs);
}

std::string uncertainty_text(const AlignReport& report) {
  const std::optional<Uncertainty> sigma = uncertainty(report);
  if (!sigma) return {};
  return fmt::format("sigma    {}, {:.2g} deg at the target's centre\n", length_text(sigma->translation),
                     sigma->rotation * kDegPerRad);
}

}  // namespace

void refer_to(const Cloud& target, AlignReport& report) {
  report.reference_point = target.origin;
  if (!target.empty()) report.centre = target.origin + median_point(target).cast<double>();
}

std::optional<Uncertainty> uncertainty(const AlignReport& report) {
  const AlignResult& result = report.result;
  if (!result.covariance) return {};
  const Mat6d about_centre = covariance_about(*result.covariance, report.centre - report.reference_point);
  return Uncertainty{std::sqrt(about_centre.topLeftCorner<3, 3>().trace()),
                     std::sqrt(about_centre.bottomRightCorner<3, 3>().trace())};
}

// The doubts in parentheses; nothing without any.
std::string doubts_text(const AlignResult& result) {
  std::string text;
  for (const Doubt doubt : result.doubts) text += fmt::format("{}{}", text.empty() ? " (" : ", ", name_of(doubt));
  return text.empty() ? text : text + ")";
}

std::string advice_for(const AlignResult& result) {
  switch (result.status) {
    case AlignStatus::Converged:
      return "the clouds agree on this pose, in both directions";
    case AlignStatus::IterationLimit:
      return "doubtful: still moving; allow more with --max-iterations, or give a better --initial";
    case AlignStatus::Degenerate:
      if (!result.doubts.empty())
        return "the data leave a motion free, and the evidence is against the rest" + doubts_text(result);
      return "the data leave a motion free; do not rely on the pose along it";
    case AlignStatus::TooFewPairs:
      return "failed: too few points, or points without extent";
    case AlignStatus::NoOverlap:
      return "failed: hardly any source point has a correspondence; give a better --initial or a larger --max-distance";
    case AlignStatus::Diverged:
      return "failed: a number is no longer finite";
    case AlignStatus::Doubtful:
      return "a pose was found, but the evidence is against it" + doubts_text(result) +
             "; give a better --initial, or they have no common surface";
    case AlignStatus::Ambiguous:
      return "the clouds agree on this pose, and on a clearly different one as well; runners_up has those";
  }
  return {};
}

nlohmann::ordered_json to_json(const AlignReport& report) {
  const AlignResult& result = report.result;
  nlohmann::ordered_json json{
      {"status", name_of(result.status)},
      {"direction", "T_target_source maps source coordinates into the target frame"},
      {"source", report.source},
      {"target", report.target},
      {"T_target_source", matrix_json(result.target_from_source.matrix())},
      {"iterations", result.iterations},
      {"num_pairs", result.num_pairs},
      {"overlap", result.overlap},
      {"rmse", result.rmse},
      {"information", matrix_json(result.information)},
      {"covariance", result.covariance ? matrix_json(*result.covariance) : nlohmann::ordered_json(nullptr)},
      {"reference_point", std::vector<double>(report.reference_point.begin(), report.reference_point.end())},
      {"uncertainty", uncertainty_json(report)},
      {"observability",
       std::vector<double>(result.observability.information.begin(), result.observability.information.end())},
      {"timing_ms",
       {{"read", report.timing_ms.read}, {"surface", report.timing_ms.surface}, {"align", report.timing_ms.align}}}};
  if (report.options.intensity)
    json["intensity"] = {{"used", result.num_intensity_pairs > 0}, {"num_pairs", result.num_intensity_pairs}};
  json["free_motions"] = free_motions_json(result);
  if (result.evidence) json["evidence"] = evidence_json(result);
  if (!result.runners_up.empty()) json["runners_up"] = runners_up_json(result);
  if (report.with_history) json["history"] = history_json(result);
  json["version"] = AUGICP_VERSION;
  json["options"] = options_json(report.in_effect);
  return json;
}

std::string to_text(const AlignReport& report) {
  const AlignResult& result = report.result;
  std::string text =
      fmt::format("source   {}\ntarget   {}\nstatus   {} after {} iteration{}: {}\n", report.source, report.target,
                  name_of(result.status), result.iterations, result.iterations == 1 ? "" : "s", advice_for(result));
  text += few_points_text(report) + fit_text(result) + uncertainty_text(report);
  if (report.options.intensity)
    text += result.num_intensity_pairs > 0
                ? fmt::format("         {} of them compared by brightness too\n", result.num_intensity_pairs)
                : std::string("         brightness was not used: an input has none, or no gradient\n");
  text += free_motions_text(result);
  if (result.evidence) {
    text += fmt::format("evidence {}\n", testimony_text("target", result.evidence->source_in_target));
    text += fmt::format("         {}\n", testimony_text("source", result.evidence->target_in_source));
  }
  text += fmt::format("time     read {:.1f} ms, surface {:.1f} ms, align {:.1f} ms\n", report.timing_ms.read,
                      report.timing_ms.surface, report.timing_ms.align);
  text += "T_target_source (maps source coordinates into the target frame)\n";
  const Mat4d matrix = result.target_from_source.matrix();
  for (int i = 0; i < 4; ++i)
    text +=
        fmt::format("{:14.9f} {:14.9f} {:14.9f} {:14.9f}\n", matrix(i, 0), matrix(i, 1), matrix(i, 2), matrix(i, 3));
  return text;
}

}  // namespace augicp::app
