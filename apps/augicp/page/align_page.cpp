// SPDX-License-Identifier: MIT
#include "apps/augicp/page/align_page.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "apps/augicp/page/clouds.h"
#include "apps/augicp/page/length_text.h"
#include "apps/augicp/page/parts.h"
#include "apps/augicp/page/verdict.h"
#include "apps/augicp/text/matrix_json.h"
#include "augicp/core/angles.h"

namespace augicp::app {
namespace {

std::vector<Rigid3> poses_of(const AlignPicture& picture) {
  std::vector<Rigid3> poses{picture.initial};
  for (const AlignIteration& iteration : picture.report.result.history) poses.push_back(iteration.target_from_source);
  return poses;
}

// How far the points at the middle of the source move, and by how much they turn.
struct Step {
  double translation = 0.0, rotation_deg = 0.0;
};

Step step_between(const Rigid3& before, const Rigid3& after, const Vec3d& middle) {
  return {(after * middle - before * middle).norm(), kDegPerRad * angle_between(before, after)};
}

std::vector<Step> steps_of(const AlignPicture& picture) {
  const std::vector<Rigid3> poses = poses_of(picture);
  const Vec3d middle = middle_of(picture.prepared.source.cloud);
  std::vector<Step> steps;
  for (std::size_t i = 1; i < poses.size(); ++i) steps.push_back(step_between(poses[i - 1], poses[i], middle));
  return steps;
}

std::vector<std::string> step_texts(const AlignPicture& picture) {
  const auto& history = picture.report.result.history;
  std::vector<std::string> texts{fmt::format("Before: the guess (0 of {})", history.size())};
  const std::vector<Step> steps = steps_of(picture);
  for (std::size_t i = 0; i < steps.size(); ++i)
    texts.push_back(fmt::format("Iteration {} of {}: {} correspondences, moved {} and {:.2g}°", i + 1, history.size(),
                                history[i].num_pairs, length_text(steps[i].translation), steps[i].rotation_deg));
  return texts;
}

std::vector<Chart> convergence_charts(const AlignPicture& picture) {
  const std::vector<Step> steps = steps_of(picture);
  Chart cost{"Cost before the step", "iteration", "cost", true}, pairs{"Correspondences", "iteration", "count", false};
  Chart kernel{"Residuals that count in full", "iteration", "squared residual", true};
  Chart step{"Step: metres, and degrees dashed", "iteration", "m, degrees", true};
  cost.meaning = "The weighted squared residuals of all correspondences, summed. It falls as the clouds meet.";
  pairs.meaning = "Source points that were matched with a target point in each iteration.";
  kernel.meaning =
      "Squared residuals, in units of their variance, above which a correspondence loses weight as an outlier.";
  step.meaning = "How far each iteration moved the middle of the source, and by how much it rotated it.";
  cost.series = {{"cost"}};
  pairs.series = {{"correspondences"}};
  kernel.series = {{"limit"}};
  step.series = {{"translation, m"}, {"rotation, degrees"}};
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const AlignIteration& iteration = picture.report.result.history[i];
    for (Chart* chart : {&cost, &pairs, &kernel, &step}) chart->x.push_back(static_cast<double>(i + 1));
    cost.series[0].y.push_back(iteration.cost);
    pairs.series[0].y.push_back(static_cast<double>(iteration.num_pairs));
    kernel.series[0].y.push_back(iteration.kernel_chi2);
    step.series[0].y.push_back(steps[i].translation);
    step.series[1].y.push_back(steps[i].rotation_deg);
  }
  for (Chart* chart : {&cost, &kernel, &step}) choose_scale(*chart);
  const auto is_finite = [](double number) { return std::isfinite(number); };
  if (std::all_of(kernel.series[0].y.begin(), kernel.series[0].y.end(), is_finite)) return {cost, pairs, kernel, step};
  return {cost, pairs, step};  // no pair is discounted
}

nlohmann::ordered_json align_json(const AlignPicture& picture) {
  const CloudFrame frame = frame_of(picture.prepared.source, picture.prepared.target);
  const AlignReport& report = picture.report;
  nlohmann::ordered_json poses = nlohmann::ordered_json::array();
  for (const Rigid3& pose : poses_of(picture)) poses.push_back(pose_numbers(page_from_source(frame, pose)));
  const PairedClouds clouds = paired_clouds(picture, frame);
  nlohmann::ordered_json motions = nlohmann::ordered_json::array();
  for (const FreeMotion& motion : report.result.free_motions)
    motions.push_back({{"kind", name_of(motion.kind)},
                       {"axis", numbers(motion.axis)},
                       {"point", numbers(motion.point - frame.target_zero)}});
  const double extent = frame.extent;
  return {{"source", clouds.source},
          {"target", clouds.target},
          {"poses", poses},
          {"step_texts", step_texts(picture)},
          {"transform", matrix_json(report.result.target_from_source.matrix())},
          {"zero", numbers(frame.target_zero)},
          {"extent", extent},
          {"direction_length", 0.02 * extent},
          {"source_zero", numbers(picture.prepared.source.cloud.origin)},
          {"pairs", clouds.pairs},
          {"free_motions", motions}};
}

std::string matrix_html(const Rigid3& target_from_source) {
  // Without the sign of what is written as zero.
  const Mat4d matrix = target_from_source.matrix().unaryExpr([](double x) { return std::abs(x) < 5e-10 ? 0.0 : x; });
  std::string text;
  for (int i = 0; i < 4; ++i)
    text +=
        fmt::format("{:14.9f} {:14.9f} {:14.9f} {:14.9f}\n", matrix(i, 0), matrix(i, 1), matrix(i, 2), matrix(i, 3));
  return "<p>x_target = T x_source, metres</p>\n<pre id=\"matrix\" tabindex=\"0\">" + text + "</pre>\n";
}

}  // namespace

std::string align_page(const AlignPicture& picture) {
  const AlignReport& report = picture.report;
  const std::vector<Chart> charts = convergence_charts(picture);
  std::string side = section_html("Verdict", verdict_html(report));
  side += section_html("Transform from source to target", matrix_html(report.result.target_from_source));
  side += section_html("Convergence", figures_html(charts));
  side += details_html("Options", html_list(options_texts(report.in_effect)));
  const std::string body =
      "<main class=\"staged\">\n<div id=\"stage\"></div>\n<div class=\"side\">\n" + side + "</div>\n</main>\n";
  const PageHead head{"Alignment",
                      std::string(name_of(report.result.status)),
                      badge_class(report.result.status),
                      {"Source: " + report.source, "Target: " + report.target}};
  return whole_page(head, "align", body, charts, align_json(picture));
}

}  // namespace augicp::app
