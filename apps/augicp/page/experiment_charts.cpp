// SPDX-License-Identifier: MIT
#include "apps/augicp/page/experiment_charts.h"

#include <fmt/core.h>

#include "augicp/core/angles.h"

namespace augicp::app {
namespace {

// The chart with this title; if there is none yet, one made like the given chart.
Chart& chart_called(Quantity& quantity, Chart made) {
  for (Chart& chart : quantity.charts)
    if (chart.title == made.title) return chart;
  return quantity.charts.emplace_back(std::move(made));
}

ChartSeries& series_called(Chart& chart, const std::string& name) {
  for (ChartSeries& series : chart.series)
    if (series.name == name) return series;
  return chart.series.emplace_back(ChartSeries{name});
}

// Rows come by series, each with the same ascending x.
void add(Chart& chart, const std::string& name, double x, double y) {
  series_called(chart, name).y.push_back(y);
  if (chart.x.empty() || x > chart.x.back()) chart.x.push_back(x);
}

void add(Chart& chart, const std::string& name, double x, double y, double low, double high) {
  add(chart, name, x, y);
  series_called(chart, name).low.push_back(low);
  series_called(chart, name).high.push_back(high);
}

}  // namespace

std::vector<Quantity> synthetic_quantities(const std::vector<SyntheticRow>& rows) {
  std::vector<Quantity> quantities{{"Translation error, m", {}}, {"Rotation error, degrees", {}}};
  for (const SyntheticRow& row : rows) {
    const std::string title = fmt::format("{:g} % outliers, {:g} m noise, normals {:g}°", 100.0 * row.outlier_share,
                                          row.point_noise, kDegPerRad * row.normal_noise_rad);
    for (Quantity& quantity : quantities) {
      const bool is_first = &quantity == &quantities.front();
      const MeanInterval& error = is_first ? row.translation : row.rotation;
      const double unit = is_first ? 1.0 : kDegPerRad;
      Chart& chart = chart_called(quantity, {title, "iteration", is_first ? "m" : "degrees", true});
      add(chart, std::string(name_of(row.method)), row.iteration, unit * error.mean,
          unit * (error.mean - error.half_width), unit * (error.mean + error.half_width));
    }
  }
  return quantities;
}

std::vector<Quantity> sequence_quantities(std::span<const SequenceCurve> curves, const Trajectory& truth,
                                          const std::vector<double>& time_offsets_s) {
  std::vector<Quantity> quantities{{"Mean translation error, m", {}},
                                   {"Mean rotation error, degrees", {}},
                                   {"Success (5 cm, 2°), %", {}},
                                   {"Narrow success (2 cm, 1°), %", {}}};
  for (const double offset_s : time_offsets_s)
    for (const SequenceRow& row : summarize(curves, truth, offset_s)) {
      std::string title = fmt::format("gap {}, preset {}", row.gap, name_of(row.preset));
      if (time_offsets_s.size() > 1) title += fmt::format(", offset {:.1f} ms", 1000.0 * offset_s);
      const double values[] = {row.translation.mean, kDegPerRad * row.rotation.mean, 100.0 * row.success,
                               100.0 * row.success_narrow};
      const char* const units[] = {"m", "degrees", "%", "%"};
      for (std::size_t i = 0; i < quantities.size(); ++i) {
        Chart& chart = chart_called(quantities[i], {title, "iteration", units[i], i < 2});
        if (i >= 2) chart.y_range = AxisRange{0.0, 100.0};
        add(chart, std::string(name_of(row.method)), row.iteration, values[i]);
      }
    }
  return quantities;
}

std::vector<Quantity> basin_quantities(const std::vector<BasinCell>& cells) {
  Chart success{"Successful starts", "rotated by, degrees", "%"};
  Chart iterations{"Mean iterations of all starts", "rotated by, degrees", "iterations"};
  success.y_range = AxisRange{0.0, 100.0};
  for (const BasinCell& cell : cells) {
    const std::string name = fmt::format("moved by {:g} m", cell.distance);
    add(success, name, kDegPerRad * cell.angle_rad, 100.0 * cell.success);
    add(iterations, name, kDegPerRad * cell.angle_rad, cell.mean_iterations);
  }
  return {{"Success", {success}}, {"Iterations", {iterations}}};
}

std::vector<Quantity> verdict_quantities(std::span<const VerdictPair> pairs) {
  Chart chart{"Results that other limits would accept and refuse", "largest value accepted, in limits", "%"};
  chart.y_range = AxisRange{0.0, 100.0};
  // The curve has a point at each strain of a pair; beyond this limit it is constant.
  constexpr double kMaxStrain = 10.0;
  for (const RocPoint& point : roc(pairs)) {
    if (point.max_strain > kMaxStrain) continue;
    add(chart, "right, refused", point.max_strain, 100.0 * point.right_refused);
    add(chart, "wrong, accepted", point.max_strain, 100.0 * point.wrong_accepted);
    add(chart, "apart, accepted", point.max_strain, 100.0 * point.apart_accepted);
  }
  return {{"Limits of the verdict", {chart}}};
}

}  // namespace augicp::app
