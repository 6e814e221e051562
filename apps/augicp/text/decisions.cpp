// SPDX-License-Identifier: MIT
#include "apps/augicp/text/decisions.h"

#include <fmt/core.h>

#include <cmath>

#include "augicp/core/angles.h"

namespace augicp::app {
namespace {

std::string length_text(const char* name, double length, bool is_given, std::string_view otherwise) {
  return fmt::format("{:<13} {:.4g} m: {}\n", name, length, is_given ? std::string_view("given") : otherwise);
}

std::string radius_reason(const AlignReport& report) {
  if (report.options.voxel_size) return "follows the voxel size and the points' spacing";
  if (report.share_of_radius == 1.0) return "derived from the extent";
  return fmt::format("{:.2g} of what was derived from the extent", report.share_of_radius);
}

std::string lengths_text(const AlignReport& report) {
  const RegistrationOptions& given = report.options;
  const Lengths& lengths = report.lengths;
  return fmt::format("extent        {:.4g} m: the diameter of most of both scans\n", lengths.extent) +
         length_text("radius", lengths.radius, given.radius.has_value(), radius_reason(report)) +
         length_text("voxel size", lengths.voxel_size, given.voxel_size.has_value(), "derived from the radius") +
         length_text("max distance", lengths.max_distance, given.max_distance.has_value(), "derived from the extent");
}

std::string stop_text(const AlignResult& result) {
  if (!result.evidence || !std::isfinite(result.evidence->last_step)) return {};
  return fmt::format("last step     {:.2g} of the extent, {:.2g} deg, after {} iterations\n",
                     result.evidence->last_step, result.evidence->last_rotation_step * kDegPerRad, result.iterations);
}

std::string evidence_text(const AlignResult& result) {
  if (!result.evidence) return {};
  std::string text =
      fmt::format("strain        {:.3g}: the evidence nearest its limit, as a share of it\n", strain(*result.evidence));
  for (const Doubt doubt : result.doubts) text += fmt::format("doubt         {}\n", name_of(doubt));
  return text;
}

// Before the count, if there is one.
std::string_view begun(Stage stage) {
  switch (stage) {
    case Stage::Surfaces:
      return "downsampling both scans and estimating their surfaces";
    case Stage::Indexing:
      return "building search trees";
    case Stage::Search:
      return "trying rotations of the guess";
    case Stage::Descriptors:
      return "searching poses by points that look alike";
    case Stage::Coarse:
      return "aligning at a coarse resolution";
    case Stage::Aligning:
      return "aligning";
    case Stage::Verdict:
      return "judging the pose";
    case Stage::Rivals:
      return "searching other poses that may fit as well";
    case Stage::FinerBalls:
      return "a motion is held by little: preparing both scans in balls half as wide";
    case Stage::FinalPass:
      return "aligning once more in smaller balls";
  }
  return {};
}

}  // namespace

std::string stage_text(Stage stage, Turn turn) {
  const std::string text(begun(stage));
  return turn.total > 1 ? fmt::format("{}, start {} of {}", text, turn.done + 1, turn.total) : text;
}

std::string decisions_text(const AlignReport& report) {
  std::string text = lengths_text(report);
  const char* names[] = {"source", "target"};
  for (const std::size_t i : {0, 1})
    text += fmt::format("{:<13} {} points read, {} compared\n", names[i], report.num_read[i], report.num_prepared[i]);
  for (const auto& [step, began_ms] : report.steps) text += fmt::format("at {:>7.0f} ms {}\n", began_ms, step);
  return text + stop_text(report.result) + evidence_text(report.result);
}

}  // namespace augicp::app
