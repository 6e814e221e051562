// SPDX-License-Identifier: MIT
#include <pybind11/stl.h>

#include <sstream>

#include "apps/augicp/text/evaluation.h"
#include "augicp/eval/option_table.h"
#include "python/bindings.h"
#include "python/core/numbers.h"
#include "python/core/options.h"
#include "python/core/state.h"
#include "python/core/without_gil.h"
#include "python/geometry/trajectory.h"

namespace augicp::python {
namespace {

constexpr const char* kEvaluationDoc =
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

struct VisitStatistics {
  void operator()(auto& archive, auto& statistics) const {
    archive.number(statistics.count);
    for (auto* value : {&statistics.rmse, &statistics.mean, &statistics.median, &statistics.std, &statistics.min,
                        &statistics.max, &statistics.sse})
      archive.number(*value);
  }
};

struct VisitPoseStatistics {
  void operator()(auto& archive, auto& errors) const {
    VisitStatistics{}(archive, errors.translation);
    VisitStatistics{}(archive, errors.rotation);
  }
};

// Everything but the options and the errors of segments, which Python does not show.
struct VisitEvaluation {
  void operator()(auto& archive, auto& evaluation) const {
    archive.number(evaluation.num_estimate);
    archive.number(evaluation.num_truth);
    archive.number(evaluation.num_matched);
    archive.number(evaluation.matched_share);
    visit_coverage(archive, evaluation.coverage);
    archive.number(evaluation.first_stamp_s);
    archive.number(evaluation.last_stamp_s);
    VisitPoseStatistics{}(archive, evaluation.absolute);
    archive.number(evaluation.alignment.target_from_source.scale);
    visit_pose(archive, evaluation.alignment.target_from_source.motion);
    archive.number(evaluation.alignment.unique);
    for (auto* errors : {&evaluation.aligned, &evaluation.relative})
      if (archive.has(*errors)) VisitPoseStatistics{}(archive, **errors);
  }
  static void visit_coverage(auto& archive, auto& coverage) {
    for (auto* count : {&coverage.num_outside, &coverage.num_unmatched, &coverage.num_holes, &coverage.num_missing})
      archive.number(*count);
    archive.number(coverage.longest_hole_s);
  }
};

py::tuple state_of_evaluation(const Evaluation& evaluation) {
  return state_of_value(evaluation, VisitEvaluation{}, values_of(evaluation.options));
}

Evaluation evaluation_of_state(const py::tuple& state) {
  Evaluation evaluation = value_of_state<Evaluation>(state, VisitEvaluation{});
  set_options(state[2].cast<py::dict>(), evaluation.options);
  return evaluation;
}

std::string errors_in_words(const PoseStatistics& errors) {
  std::ostringstream text;
  text << "rmse " << errors.translation.rmse << " m, " << errors.rotation.rmse << " rad";
  return text.str();
}

// The lines of print(): each error, and how many poses it is of.
std::string lines_of(const Evaluation& evaluation) {
  std::string text = "augicp.Evaluation of " + std::to_string(evaluation.num_matched) + " of " +
                     std::to_string(evaluation.num_estimate) +
                     " poses\nATE, not aligned: " + errors_in_words(evaluation.absolute);
  for (const std::string& warning : app::coverage_warnings(evaluation.coverage)) text += "\n" + warning;
  if (evaluation.aligned) text += "\nATE, aligned: " + errors_in_words(*evaluation.aligned);
  if (evaluation.relative) text += "\nRPE: " + errors_in_words(*evaluation.relative);
  return text;
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
  type.def(pickled<Statistics>(VisitStatistics{}));
  py::class_<PoseStatistics> poses(module, "PoseStatistics", "Statistics of errors of poses.");
  poses.def_readonly("translation", &PoseStatistics::translation, "Statistics in metres.");
  poses.def_readonly("rotation", &PoseStatistics::rotation, "Statistics in radians.");
  poses.def("__repr__",
            [](const PoseStatistics& errors) { return "<augicp.PoseStatistics " + errors_in_words(errors) + ">"; });
  poses.def(pickled<PoseStatistics>(VisitPoseStatistics{}));
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
  const auto of_coverage = [&](const char* name, auto Coverage::*field, const char* doc) {
    type.def_property_readonly(
        name, [field](const Evaluation& evaluation) { return evaluation.coverage.*field; }, doc);
  };
  of_coverage("num_outside", &Coverage::num_outside, "Poses of the estimate outside of the truth's time.");
  of_coverage("num_unmatched", &Coverage::num_unmatched,
              "Poses of the estimate within the truth's time that have no true one of the same moment.");
  of_coverage("num_holes", &Coverage::num_holes, "Times between two poses of the estimate that are longer than usual.");
  of_coverage("num_missing", &Coverage::num_missing, "Poses that would fill these holes.");
  of_coverage("longest_hole", &Coverage::longest_hole_s, "Time between the poses around the longest, seconds.");
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
  type.def("__str__", &lines_of);
  type.def(py::pickle(&state_of_evaluation, &evaluation_of_state));
  module.def("evaluate", &evaluate_given, py::arg("estimate"), py::arg("groundtruth"),
             (kEvaluationDoc + options_doc<EvaluationOptions>()).c_str());
}

}  // namespace augicp::python
