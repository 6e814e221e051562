// SPDX-License-Identifier: MIT
#include "apps/augicp/report_result.h"

#include <fmt/core.h>

#include <array>
#include <cstdio>
#include <numbers>

#include "apps/augicp/names.h"
#include "augicp/io/atomic_file.h"

namespace augicp::app {
namespace {

nlohmann::ordered_json options_json(const AlignReport& report) {
  const RegistrationOptions& options = report.options;
  return {{"preset", word_for(kPresets, options.preset)},
          {"method", word_for(kMethods, options.method)},
          {"association", word_for(kAssociations, options.association)},
          {"radius", report.lengths.radius},
          {"voxel_size", report.lengths.voxel_size},
          {"max_distance", report.lengths.max_distance},
          {"max_angle_deg", options.max_angle * 180.0 / std::numbers::pi},
          {"search", options.search},
          {"coarse_to_fine", options.coarse_to_fine},
          {"rolling_shutter", options.rolling_shutter},
          {"max_iterations", options.max_iterations},
          {"min_step", options.min_step},
          {"threads", options.num_threads}};
}

nlohmann::ordered_json history_json(const AlignResult& result) {
  nlohmann::ordered_json history = nlohmann::ordered_json::array();
  for (const AlignIteration& iteration : result.history)
    history.push_back({{"T_target_source", matrix_json(iteration.target_from_source.matrix())},
                       {"num_pairs", iteration.num_pairs},
                       {"cost", iteration.cost},
                       {"kernel_chi2", iteration.kernel_chi2},
                       {"lever", iteration.lever}});
  return history;
}

std::string advice_for(AlignStatus status) {
  switch (status) {
    case AlignStatus::Converged:
      return "the last step was small (a minimum; look at the overlap before you trust it)";
    case AlignStatus::IterationLimit:
      return "doubtful: still moving; allow more with --max-iterations, or give a better --initial";
    case AlignStatus::Degenerate:
      return "doubtful: the data leave at least one direction of motion open";
    case AlignStatus::TooFewPairs:
      return "failed: too few points, or points without extent";
    case AlignStatus::NoOverlap:
      return "failed: hardly any source point meets the target; give a better --initial or a larger --max-distance";
    case AlignStatus::Diverged:
      return "failed: the numbers stopped being finite";
  }
  return {};
}

}  // namespace

nlohmann::ordered_json matrix_json(const Eigen::Ref<const Eigen::MatrixXd>& matrix) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    nlohmann::ordered_json row = nlohmann::ordered_json::array();
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) row.push_back(matrix(i, j));
    rows.push_back(std::move(row));
  }
  return rows;
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
      {"observability", std::vector<double>(result.observability.information.begin(), result.observability.information.end())},
      {"timing_ms",
       {{"read", report.timing_ms.read}, {"surface", report.timing_ms.surface}, {"align", report.timing_ms.align}}}};
  if (report.with_history) json["history"] = history_json(result);
  json["version"] = AUGICP_VERSION;
  json["options"] = options_json(report);
  return json;
}

std::string to_text(const AlignReport& report) {
  const AlignResult& result = report.result;
  std::string text = fmt::format("source   {}\ntarget   {}\nstatus   {} after {} iterations: {}\n", report.source,
                                 report.target, name_of(result.status), result.iterations, advice_for(result.status));
  text += fmt::format("pairs    {}, overlap {:.1f} %, rmse {:.4g} m\n", result.num_pairs, 100.0 * result.overlap, result.rmse);
  text += fmt::format("time     read {:.1f} ms, surface {:.1f} ms, align {:.1f} ms\n", report.timing_ms.read,
                      report.timing_ms.surface, report.timing_ms.align);
  text += "T_target_source (maps source coordinates into the target frame)\n";
  const Mat4d matrix = result.target_from_source.matrix();
  for (int i = 0; i < 4; ++i)
    text += fmt::format("{:14.9f} {:14.9f} {:14.9f} {:14.9f}\n", matrix(i, 0), matrix(i, 1), matrix(i, 2), matrix(i, 3));
  return text;
}

void write_json(const std::string& destination, const nlohmann::ordered_json& json) {
  const std::string text = json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
  if (destination != "-") {
    write_file(destination, text);
    return;
  }
  fmt::print("{}", text);
}

}  // namespace augicp::app
