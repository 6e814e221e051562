// SPDX-License-Identifier: MIT
#include "apps/augicp/text/drift.h"

#include <fmt/core.h>

#include <algorithm>

#include "augicp/core/angles.h"

namespace augicp::app {
namespace {

constexpr double kPercent = 100.0;
constexpr double kDegPer100m = 100.0 * kDegPerRad;

// Of a motion of no length there is no share.
std::string percent(double metres, double length) {
  return length > 0.0 ? fmt::format("{:.4f}", kPercent * metres / length) : "-";
}

std::string segment_row(const std::string& name, const SegmentError& error) {
  return fmt::format("{:<10} {:>9} {:>12.4f} {:>16.4f}\n", name, error.num_segments, kPercent * error.translation,
                     kDegPer100m * error.rotation);
}

nlohmann::ordered_json segment_json(const SegmentError& error) {
  return {{"num_segments", error.num_segments},
          {"translation_percent", kPercent * error.translation},
          {"rotation_deg_per_100m", kDegPer100m * error.rotation}};
}

std::string absolute_columns(const Evaluation& evaluation) {
  const auto metres = [](const std::optional<PoseStatistics>& errors) {
    return errors ? fmt::format("{:.4f}", errors->translation.rmse) : "-";
  };
  const SegmentError& segments = evaluation.segments.all;
  const bool has_segments = segments.num_segments > 0;
  return fmt::format(" {:>9} {:>11} {:>9} {:>8} {:>13}", metres(evaluation.absolute), metres(evaluation.aligned),
                     metres(evaluation.relative),
                     has_segments ? fmt::format("{:.4f}", kPercent * segments.translation) : "-",
                     has_segments ? fmt::format("{:.4f}", kDegPer100m * segments.rotation) : "-");
}

}  // namespace

std::string segments_text(const SegmentErrors& errors) {
  if (errors.all.num_segments == 0) return "";
  std::string text = fmt::format("\n{:<10} {:>9} {:>12} {:>16}\n", "segments", "count", "t_rel, %", "r_rel, deg/100m");
  for (const SegmentError& error : errors.of_length) text += segment_row(fmt::format("{:g} m", error.length), error);
  return text + segment_row("all", errors.all);
}

nlohmann::ordered_json segments_json(const SegmentErrors& errors) {
  if (errors.all.num_segments == 0) return nullptr;
  nlohmann::ordered_json json = segment_json(errors.all);
  json["lengths"] = nlohmann::ordered_json::array();
  for (const SegmentError& error : errors.of_length) {
    nlohmann::ordered_json of_length{{"length_m", error.length}};
    of_length.update(segment_json(error));
    json["lengths"].push_back(of_length);
  }
  return json;
}

std::string gaps_text(std::span<const GapError> errors, std::size_t num_pairs) {
  std::size_t num_found = 0;
  for (const GapError& error : errors) num_found += error.num_pairs;
  std::string text = fmt::format("known motions: {} of {} are within the estimate\n", num_found, num_pairs);
  text += fmt::format("{:>5} {:>6} {:>10} {:>9} {:>9} {:>9} {:>13}\n", "gap", "pairs", "length, m", "error, m",
                      "error, %", "bias, %", "rotation, deg");
  for (const GapError& error : errors)
    text += fmt::format("{:>5} {:>6} {:>10.3f} {:>9.4f} {:>9} {:>9} {:>13.4f}\n", error.gap, error.num_pairs,
                        error.length, error.translation, percent(error.translation, error.length),
                        percent(error.bias, error.length), kDegPerRad * error.rotation);
  return text;
}

nlohmann::ordered_json gaps_json(std::span<const GapError> errors) {
  auto json = nlohmann::ordered_json::array();
  for (const GapError& error : errors) {
    const auto share = [&](double metres) -> nlohmann::ordered_json {
      if (error.length > 0.0) return kPercent * metres / error.length;
      return nullptr;
    };
    json.push_back({{"gap", error.gap},
                    {"num_pairs", error.num_pairs},
                    {"length_m", error.length},
                    {"translation_m", error.translation},
                    {"translation_percent", share(error.translation)},
                    {"bias_percent", share(error.bias)},
                    {"rotation_deg", kDegPerRad * error.rotation}});
  }
  return json;
}

std::string comparison_text(std::span<const Compared> estimates) {
  std::size_t width = 8;
  for (const Compared& compared : estimates) width = std::max(width, compared.estimate.size());
  const Compared& any = estimates.front();
  std::string text = fmt::format("{:<{}}", "estimate", width);
  if (any.evaluation)
    text += fmt::format(" {:>9} {:>11} {:>9} {:>8} {:>13}", "ATE, m", "aligned, m", "RPE, m", "t_rel, %", "deg/100m");
  if (any.of_gap)
    for (const GapError& error : *any.of_gap) text += fmt::format(" {:>12}", fmt::format("gap {}, %", error.gap));
  for (const Compared& compared : estimates) {
    text += fmt::format("\n{:<{}}", compared.estimate, width);
    if (compared.evaluation) text += absolute_columns(*compared.evaluation);
    if (compared.of_gap)
      for (const GapError& error : *compared.of_gap)
        text += fmt::format(" {:>12}", percent(error.translation, error.length));
  }
  return text + "\n";
}

}  // namespace augicp::app
