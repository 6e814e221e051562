// SPDX-License-Identifier: MIT
#include "apps/augicp/page/verdict.h"

#include <fmt/core.h>

#include <cctype>
#include <cmath>

#include "apps/augicp/page/length_text.h"
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
          "agrees, without lines of sight, or if points are in free space far from the guess.",
          100.0 * one.seen(), 100.0 * other.seen(), 100.0 * limits.min_margin);
    case Doubt::Disagreement:
      return fmt::format("Only {:.1f} % and {:.1f} % of the visible points are on the other's surface.",
                         100.0 * one.agreeing(), 100.0 * other.agreeing());
    case Doubt::FreeSpace:
      return fmt::format(
          "{:.1f} % and {:.1f} % are in free space of the other's camera; at most {:.0f} % are allowed. "
          "Without a guess {:.0f} % are allowed on average, less if little is visible or off the large planes. The "
          "nearer the guess, the more.",
          100.0 * one.conflicting(), 100.0 * other.conflicting(), 100.0 * limits.max_conflicting,
          100.0 * limits.max_mean_conflicting);
    case Doubt::Contradiction:
      return fmt::format("A part of {:.1f} % and {:.1f} % leaves the other's surface where that goes on.",
                         100.0 * one.contradicting, 100.0 * other.contradicting);
    case Doubt::BarePlanes:
      return fmt::format(
          "Only {:.1f} % of the points that agree are off three bare planes, which fit any other three, and the guess "
          "was {:.1f} radii of gyration away.",
          100.0 * evidence.beyond_planes, evidence.moved);
    case Doubt::OnlyPlanes:
      return fmt::format(
          "The large planes agree far better than what lies off them: the share that agrees off them is {:.0f} % and "
          "{:.0f} % of that on them.",
          100.0 * one.off_planes, 100.0 * other.off_planes);
    case Doubt::Outvoted:
      return fmt::format(
          "Far from the guess. {:.1f} times as many pairs of similar points support a clearly different pose. "
          "The other evidence is too weak for that.",
          evidence.outvoted);
    case Doubt::LeftGuess:
      return "The pose is not at the guess along what is free.";
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

constexpr const char* kNoBreakSpace = "\xc2\xa0";

std::string percent(double share) { return fmt::format("{:.1f}{}%", 100.0 * share, kNoBreakSpace); }

std::string both(double source, double target) {
  return fmt::format("source{0}{1}, target{0}{2}", kNoBreakSpace, percent(source), percent(target));
}

void add_fit(std::vector<Fact>& facts, const Residuals& residuals) {
  if (residuals.point.count > 0)
    facts.push_back({"Distance from the target's surface", length_text(residuals.point.median) + " (median)",
                     "Half of the correspondences are nearer than this to the plane of their target point: noise and "
                     "misfit together."});
  if (residuals.normal.count > 0)
    facts.push_back({"Angle between normals", fmt::format("{:.2g}° (median)", kDegPerRad * residuals.normal.median),
                     "Half of the correspondences have normals that differ by less."});
}

void add_evidence(std::vector<Fact>& facts, const Evidence& evidence) {
  const Testimony &one = evidence.source_in_target, &other = evidence.target_in_source;
  facts.push_back({"In view of the other sensor", both(one.seen(), other.seen()),
                   "The part of each cloud that the other sensor should see under this pose."});
  facts.push_back({"On the other's surface", both(one.agreeing(), other.agreeing()),
                   "Of the points in view, the part that lies on the other cloud's surface with an agreeing normal. A "
                   "right pose has nearly all."});
  if (one.knows_free_space || other.knows_free_space)
    facts.push_back({"In the other's free space", both(one.conflicting(), other.conflicting()),
                     "Of the points in view, the part in front of what the other camera saw. It saw through these "
                     "points, so a right pose has few."});
  facts.push_back({"Nearest limit", fmt::format("{:.0f}{}% of it", 100.0 * strain(evidence), kNoBreakSpace),
                   "Each value above has a limit. This is the value that is closest to its limit; above 100 % the pose "
                   "is doubtful."});
}

std::vector<Fact> facts_of(const AlignReport& report) {
  const AlignResult& result = report.result;
  std::vector<Fact> facts;
  if (result.evidence) add_fit(facts, result.evidence->residuals);
  facts.push_back({"Overlap", percent(result.overlap), "The part of the source's points that have a correspondence."});
  if (const std::optional<Uncertainty> sigma = uncertainty(report))
    facts.push_back(
        {"Standard deviation of the pose",
         fmt::format("{}, {:.2g}°", length_text(sigma->translation), kDegPerRad * sigma->rotation),
         "The expected error at the target's centre, from the residuals. It does not cover wrong correspondences."});
  if (result.evidence) add_evidence(facts, *result.evidence);
  facts.push_back({"Correspondences", fmt::format("{}", result.num_pairs),
                   "Source points that were matched with a target point in the last iteration."});
  facts.push_back({"RMS distance of correspondences", length_text(result.rmse),
                   "From point to point. It is mostly the spacing of the points, not an error of the pose."});
  facts.push_back({"Iterations", fmt::format("{}", result.iterations), "Steps until the motion was below its limits."});
  return facts;
}

}  // namespace

std::string badge_class(AlignStatus status) {
  if (status == AlignStatus::Converged) return "good";
  const bool has_no_pose =
      status == AlignStatus::TooFewPairs || status == AlignStatus::NoOverlap || status == AlignStatus::Diverged;
  return has_no_pose ? "bad" : "warn";
}

std::string verdict_html(const AlignReport& report) {
  const AlignResult& result = report.result;
  std::string advice = advice_for(result);
  advice.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(advice.front())));
  std::string html = fmt::format("<p><b class=\"{}\">{}</b>. {}.</p>\n", badge_class(result.status),
                                 escaped_html(name_of(result.status)), escaped_html(advice));
  const std::vector<std::string> texts = sentences(result);
  if (!texts.empty()) html += "<ul>\n";
  for (const std::string& text : texts) html += "<li>" + escaped_html(text) + "</li>\n";
  if (!texts.empty()) html += "</ul>\n";
  return html + html_facts(facts_of(report));
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
