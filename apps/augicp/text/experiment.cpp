// SPDX-License-Identifier: MIT
#include "apps/augicp/text/experiment.h"

#include <fmt/core.h>

#include "augicp/core/angles.h"

namespace augicp::app {
namespace {

std::string numbers(const Spread& spread, double unit) {
  return fmt::format("{},{},{},{}", unit * spread.mean, unit * spread.median, unit * spread.p10, unit * spread.p90);
}

std::string kind(double time_offset_s, std::size_t gap, Preset preset, Method method) {
  return fmt::format("{},{},{},{}", time_offset_s, gap, name_of(preset), name_of(method));
}

}  // namespace

std::string synthetic_csv(const std::vector<SyntheticRow>& rows) {
  std::string text =
      "outliers_percent,point_noise,normal_noise_deg,method,iteration,translation_mean,translation_interval,"
      "rotation_deg_mean,rotation_deg_interval\n";
  for (const SyntheticRow& row : rows)
    text +=
        fmt::format("{:g},{},{:g},{},{},{},{},{},{}\n", 100.0 * row.outlier_share, row.point_noise,
                    kDegPerRad * row.normal_noise_rad, name_of(row.method), row.iteration, row.translation.mean,
                    row.translation.half_width, kDegPerRad * row.rotation.mean, kDegPerRad * row.rotation.half_width);
  return text;
}

std::string sequence_csv(std::span<const SequenceCurve> curves, const Trajectory& truth,
                         const std::vector<double>& time_offsets_s) {
  std::string text =
      "time_offset_s,gap,preset,method,iteration,pairs,translation_mean,translation_median,translation_p10,"
      "translation_p90,rotation_deg_mean,rotation_deg_median,rotation_deg_p10,rotation_deg_p90,success,success_"
      "narrow\n";
  for (const double offset_s : time_offsets_s)
    for (const SequenceRow& row : summarize(curves, truth, offset_s))
      text += fmt::format("{},{},{},{},{},{},{}\n", kind(row.time_offset_s, row.gap, row.preset, row.method),
                          row.iteration, row.num_pairs, numbers(row.translation, 1.0),
                          numbers(row.rotation, kDegPerRad), row.success, row.success_narrow);
  return text;
}

std::string curves_csv(std::span<const SequenceCurve> curves, const Trajectory& truth,
                       const std::vector<double>& time_offsets_s) {
  std::string text = "time_offset_s,gap,preset,method,target,source,status,iteration,translation,rotation_deg\n";
  for (const double offset_s : time_offsets_s)
    for (const SequenceCurve& curve : curves) {
      const auto motion = true_motion(curve, truth, offset_s);
      for (std::size_t i = 0; motion && i < curve.path.size(); ++i) {
        const PoseError error = pose_error(curve.path[i], *motion);
        text +=
            fmt::format("{},{},{},{},{},{},{}\n", kind(offset_s, curve.gap(), curve.preset, curve.method), curve.target,
                        curve.source, name_of(curve.status), i, error.translation, kDegPerRad * error.rotation);
      }
    }
  return text;
}

std::string basin_csv(const std::vector<BasinCell>& cells) {
  std::string text = "angle_deg,distance,success,mean_iterations\n";
  for (const BasinCell& cell : cells)
    text +=
        fmt::format("{:g},{},{},{}\n", kDegPerRad * cell.angle_rad, cell.distance, cell.success, cell.mean_iterations);
  return text;
}

std::string time_offset_text(const TimeOffset& found) {
  return fmt::format(
      "time offset {:.1f} ms (thirds of the {} pairs differ by {:.1f} ms); median rotation error {:.3f} deg with it, "
      "{:.3f} deg without\n",
      1000.0 * found.offset_s, found.num_pairs, 1000.0 * found.spread_s, kDegPerRad * found.median_rotation,
      kDegPerRad * found.median_rotation_at_0);
}

std::string basin_text(const std::vector<BasinCell>& cells, const BasinOptions& options) {
  return fmt::format("success within {:.4g} m and {:.4g} deg, mean over the surface: {:.4f}\n",
                     options.limit->translation, kDegPerRad * options.limit->rotation, area_under(cells, options));
}

}  // namespace augicp::app
