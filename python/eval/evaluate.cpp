// SPDX-License-Identifier: MIT
#include <pybind11/stl.h>

#include "augicp/eval/option_table.h"
#include "python/bindings.h"
#include "python/core/numbers.h"
#include "python/core/options.h"
#include "python/core/without_gil.h"
#include "python/geometry/trajectory.h"

namespace augicp::python {
namespace {

constexpr const char* kDoc =
    R"(Errors of an estimated trajectory against the true one: ATE (APE) and RPE, as in evo and the TUM benchmark.

estimate, groundtruth: Trajectory, or the path of a file in the TUM benchmark's form. Their worlds may differ.

Returns an Evaluation. Raises ArgumentError if the trajectories cannot be compared, FileError for a file.

Options, by keyword; augicp.default_options("evaluate") has their defaults:
)";

Evaluation evaluate_given(const py::object& estimate, const py::object& truth, const py::kwargs& given) {
  EvaluationOptions options;
  set_options(given, options);
  options.check();
  const Trajectory estimated = trajectory_from(estimate, "estimate"), true_one = trajectory_from(truth, "groundtruth");
  return without_gil([&](const std::stop_token&) { return evaluate(estimated, true_one, options); });
}

void bind_statistics(py::module_& module) {
  py::class_<Statistics> type(module, "Statistics", "Statistics of a set of errors; named as in evo.");
  type.def_readonly("count", &Statistics::count, "Number of errors.");
  type.def_readonly("rmse", &Statistics::rmse, "Root mean square.");
  type.def_readonly("mean", &Statistics::mean, "Mean.");
  type.def_readonly("median", &Statistics::median, "Median.");
  type.def_readonly("std", &Statistics::std, "Standard deviation, divided by count.");
  type.def_readonly("min", &Statistics::min, "Smallest.");
  type.def_readonly("max", &Statistics::max, "Largest.");
  type.def_readonly("sse", &Statistics::sse, "Sum of squares.");
  type.def("__repr__", [](const Statistics& statistics) {
    return "<augicp.Statistics rmse " + std::to_string(statistics.rmse) + ", " + std::to_string(statistics.count) +
           " errors>";
  });
  py::class_<PoseStatistics> poses(module, "PoseStatistics", "Statistics of errors of poses.");
  poses.def_readonly("translation", &PoseStatistics::translation, "Statistics in metres.");
  poses.def_readonly("rotation", &PoseStatistics::rotation, "Statistics in radians.");
}

}  // namespace

void bind_evaluate(py::module_& module) {
  bind_statistics(module);
  py::class_<Evaluation> type(module, "Evaluation", "Errors of a trajectory against the true one, see evaluate.");
  type.def_readonly("num_estimate", &Evaluation::num_estimate, "Poses of the estimate.");
  type.def_readonly("num_truth", &Evaluation::num_truth, "Poses of the truth.");
  type.def_readonly("num_matched", &Evaluation::num_matched,
                    "Poses of the estimate with a true one of the same moment.");
  type.def_readonly("matched_share", &Evaluation::matched_share, "Share of the estimate's poses, 0 to 1.");
  type.def_readonly("first_stamp", &Evaluation::first_stamp_s,
                    "First stamp of the matched poses, in the truth's clock, seconds.");
  type.def_readonly("last_stamp", &Evaluation::last_stamp_s,
                    "Last stamp of the matched poses, in the truth's clock, seconds.");
  type.def_readonly("absolute", &Evaluation::absolute, "PoseStatistics (ATE), not aligned.");
  type.def_readonly("aligned", &Evaluation::aligned, "PoseStatistics (ATE), after the alignment; None: not requested.");
  type.def_readonly("relative", &Evaluation::relative, "PoseStatistics (RPE); None if no poses are delta apart.");
  type.def_property_readonly(
      "T_truth_estimate",
      [](const Evaluation& evaluation) { return to_array(evaluation.alignment.target_from_source.motion); },
      "(4, 4) float64: the alignment of the estimate's world with the true one, applied after the scale.");
  type.def_property_readonly(
      "scale", [](const Evaluation& evaluation) { return evaluation.alignment.target_from_source.scale; },
      "Scale of the alignment; 1 unless align is \"similarity\".");
  type.def_property_readonly(
      "is_unique", [](const Evaluation& evaluation) { return evaluation.alignment.unique; },
      "Whether the alignment is unique; False for too few positions, or all on a line.");
  type.def_property_readonly(
      "options", [](const Evaluation& evaluation) { return values_of(evaluation.options); },
      "dict of every option as it took effect.");
  type.def("__repr__", [](const Evaluation& evaluation) {
    return "<augicp.Evaluation of " + std::to_string(evaluation.num_matched) + " poses>";
  });
  module.def("evaluate", &evaluate_given, py::arg("estimate"), py::arg("groundtruth"),
             (kDoc + options_doc<EvaluationOptions>()).c_str());
}

}  // namespace augicp::python
