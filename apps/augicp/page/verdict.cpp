// SPDX-License-Identifier: MIT
#include "apps/augicp/page/verdict.h"

#include <fmt/core.h>

#include <cctype>
#include <cmath>

#include "apps/augicp/text/options_json.h"
#include "augicp/core/angles.h"
#include "augicp/registration/option_table.h"

namespace augicp::app {
namespace {

std::string doubt_text(Doubt doubt, const Evidence& evidence) {
  const VerdictLimits limits;
  const Testimony &one = evidence.source_in_target, &other = evidence.target_in_source;
  switch (doubt) {
    case Doubt::LittleSeen:
      return fmt::format(
          "Small overlap: {:.1f} % and {:.1f} % are visible to the other sensor; {:.0f} % are required, more if less "
          "agrees.",
          100.0 * one.seen(), 100.0 * other.seen(), 100.0 * limits.min_margin);
    case Doubt::Disagreement:
      return fmt::format("Only {:.1f} % and {:.1f} % of the visible points are on the other's surface.",
                         100.0 * one.agreeing(), 100.0 * other.agreeing());
    case Doubt::FreeSpace:
      return fmt::format("{:.1f} % and {:.1f} % are in free space of the other's camera; at most {:.0f} % are allowed.",
                         100.0 * one.conflicting(), 100.0 * other.conflicting(), 100.0 * limits.max_conflicting);
    case Doubt::Contradiction:
      return fmt::format("A part of {:.1f} % and {:.1f} % leaves the other's surface where that goes on.",
                         100.0 * one.contradicting, 100.0 * other.contradicting);
    case Doubt::BarePlanes:
      return fmt::format(
          "Only {:.1f} % of the points that agree are off three bare planes, which fit any other three, and the guess "
          "was {:.1f} radii of gyration away.",
          100.0 * evidence.beyond_planes, evidence.moved);
  }
  return {};
}

std::string free_text(const FreeMotion& motion) {
  const Vec3d &axis = motion.axis, &point = motion.point;
  std::string text =
      fmt::format("Free: {} {} ({:.3f} {:.3f} {:.3f})", name_of(motion.kind),
                  motion.kind == FreeMotion::Kind::Translation ? "along" : "about", axis.x(), axis.y(), axis.z());
  if (motion.kind != FreeMotion::Kind::Translation)
    text += fmt::format(" through ({:.3f} {:.3f} {:.3f}) m", point.x(), point.y(), point.z());
  return text + ".";
}

std::vector<std::string> sentences(const AlignResult& result) {
  std::vector<std::string> texts;
  if (result.evidence)
    for (const Doubt doubt : result.doubts) texts.push_back(doubt_text(doubt, *result.evidence));
  for (const FreeMotion& motion : result.free_motions) texts.push_back(free_text(motion));
  return texts;
}

std::string both(double one, double other) { return fmt::format("{:.1f} % / {:.1f} %", 100.0 * one, 100.0 * other); }

void add_evidence(NamedTexts& rows, const Evidence& evidence) {
  const Testimony &one = evidence.source_in_target, &other = evidence.target_in_source;
  rows.emplace_back("Seen by the other (source / target)", both(one.seen(), other.seen()));
  rows.emplace_back("On its surface (of those seen)", both(one.agreeing(), other.agreeing()));
  if (one.knows_free_space || other.knows_free_space)
    rows.emplace_back("In its free space (of those seen)", both(one.conflicting(), other.conflicting()));
  rows.emplace_back("Strain (above 1: doubtful)", fmt::format("{:.2f}", strain(evidence)));
}

void add_deviations(NamedTexts& rows, const Mat6d& covariance) {
  const double translation = std::sqrt(covariance.topLeftCorner<3, 3>().trace());
  const double rotation = std::sqrt(covariance.bottomRightCorner<3, 3>().trace());
  rows.emplace_back("Standard deviation", fmt::format("{:.2g} m, {:.2g}°", translation, kDegPerRad * rotation));
}

}  // namespace

std::string badge_class(AlignStatus status) {
  if (status == AlignStatus::Converged) return "good";
  const bool has_no_pose =
      status == AlignStatus::TooFewPairs || status == AlignStatus::NoOverlap || status == AlignStatus::Diverged;
  return has_no_pose ? "bad" : "warn";
}

std::string verdict_html(const AlignResult& result) {
  std::string advice = advice_for(result.status);
  advice.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(advice.front())));
  std::string html = fmt::format("<p><b class=\"{}\">{}</b>. {}.</p>\n", badge_class(result.status),
                                 escaped_html(name_of(result.status)), escaped_html(advice));
  const std::vector<std::string> texts = sentences(result);
  if (!texts.empty()) html += "<ul>\n";
  for (const std::string& text : texts) html += "<li>" + escaped_html(text) + "</li>\n";
  if (!texts.empty()) html += "</ul>\n";
  NamedTexts rows{{"Iterations", fmt::format("{}", result.iterations)},
                  {"Pairs", fmt::format("{}", result.num_pairs)},
                  {"Source points with a partner", fmt::format("{:.1f} %", 100.0 * result.overlap)},
                  {"RMS distance of the pairs", fmt::format("{:.4g} m", result.rmse)}};
  if (result.evidence) add_evidence(rows, *result.evidence);
  if (result.covariance) add_deviations(rows, *result.covariance);
  return html + html_list(rows);
}

NamedTexts options_texts(const RegistrationOptions& options) {
  NamedTexts rows;
  for_each_option(options, [&](const OptionText& option, const auto& field) {
    const nlohmann::ordered_json value = field_json(option.unit, field);
    if (option.name == "threads" || value.is_null()) return;  // the first changes nothing in the result
    const std::string text = value.is_string()    ? value.get<std::string>()
                             : value.is_boolean() ? (value.get<bool>() ? "on" : "off")
                                                  : fmt::format("{:.6g}", value.get<double>());
    rows.emplace_back(outer_name(option), option.unit == Unit::Metres ? text + " m" : text);
  });
  return rows;
}

}  // namespace augicp::app
