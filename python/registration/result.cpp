// SPDX-License-Identifier: MIT
#include "python/registration/result.h"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <sstream>

#include "augicp/registration/option_table.h"
#include "python/bindings.h"
#include "python/core/numbers.h"
#include "python/core/options.h"
#include "python/core/words.h"
#include "python/registration/report.h"
#include "python/registration/result_state.h"
#include "python/registration/result_text.h"

namespace augicp::python {
namespace {

constexpr const char* kResultDoc =
    R"(The result of a registration. bool(result) is True only if status is Status.CONVERGED.

T_target_source maps source coordinates into the target's frame. After a failure it is the last pose reached, never a made-up one.
Arrays are new at each access; writing to them does not change the result.)";

template <typename Field>
auto found(Field field) {
  return [field](const Result& result) { return result.found.*field; };
}

py::object covariance(const Result& result) {
  return result.found.covariance ? py::object(to_array(*result.found.covariance)) : py::none();
}

py::list doubts(const Result& result) {
  py::list words;
  for (const Doubt doubt : result.found.doubts) words.append(word_member("Doubt", name_of(doubt)));
  return words;
}

std::string result_in_words(const Result& result) {
  std::ostringstream text;
  text << "<augicp.Result " << name_of(result.found.status) << " after " << result.found.iterations << " iterations, "
       << result.found.num_pairs << " pairs, overlap " << result.found.overlap << ", rmse " << result.found.rmse
       << " m>";
  return text.str();
}

void bind_iteration(py::module_& module) {
  py::class_<AlignIteration> type(module, "Iteration", "One iteration at full resolution.");
  type.def_property_readonly(
      "T_target_source", [](const AlignIteration& iteration) { return to_array(iteration.target_from_source); },
      "(4, 4) float64, after the iteration's step.");
  type.def_readonly("num_pairs", &AlignIteration::num_pairs, "Pairs used.");
  type.def_readonly("cost", &AlignIteration::cost, "The cost, before the step.");
  type.def_readonly("kernel_chi2", &AlignIteration::kernel_chi2, "K of the robust kernel.");
  type.def_readonly("lever", &AlignIteration::lever, "Weight of directions against positions, metres; 0: off.");
  type.def_readonly("intensity_information", &AlignIteration::intensity_information,
                    "Information of the brightness; 0: off.");
  type.def("__repr__", [](const AlignIteration& iteration) {
    return "<augicp.Iteration " + std::to_string(iteration.num_pairs) + " pairs, cost " +
           std::to_string(iteration.cost) + ">";
  });
  type.def(pickled<AlignIteration>(VisitIteration{}));
}

void bind_runner_up(py::module_& module) {
  py::class_<RunnerUp> type(module, "RunnerUp", "Another pose that the evidence supports.");
  type.def_property_readonly(
      "T_target_source", [](const RunnerUp& other) { return to_array(other.target_from_source); },
      "(4, 4) float64: x_in_target = T_target_source @ x_in_source, metres.");
  type.def_readonly("evidence", &RunnerUp::evidence, "Its Evidence.");
  type.def("__repr__", [](const RunnerUp& other) {
    return "<augicp.RunnerUp strain " + std::to_string(strain(other.evidence)) + ">";
  });
  type.def(pickled<RunnerUp>(VisitRunnerUp{}));
}

using ResultType = py::class_<Result>;

void bind_numbers(ResultType& type) {
  type.def_property_readonly(
      "T_target_source", [](const Result& result) { return to_array(result.found.target_from_source); },
      "(4, 4) float64: x_in_target = T_target_source @ x_in_source, metres.");
  type.def_property_readonly("iterations", found(&AlignResult::iterations), "Iterations made at full resolution.");
  type.def_property_readonly("num_pairs", found(&AlignResult::num_pairs), "Pairs at the last iteration.");
  type.def_property_readonly("num_intensity_pairs", found(&AlignResult::num_intensity_pairs),
                             "Pairs with compared brightness; 0: the clouds have none, or intensity is off.");
  type.def_property_readonly("overlap", found(&AlignResult::overlap),
                             "Share of source points with a correspondence, 0 to 1.");
  type.def_property_readonly("rmse", found(&AlignResult::rmse),
                             "Root mean square of the distances within the final pairs, metres.");
  type.def_property_readonly("covariance", &covariance,
                             "(6, 6) float64, or None if a direction of motion is free. Order tx ty tz rx ry rz "
                             "(metres, radians): an increment on the left, about reference_point.");
  type.def_property_readonly(
      "reference_point", [](const Result& result) { return vector_array(result.reference_point); },
      "(3,) float64, metres, in the target's frame: the point about which covariance and information rotate.");
  type.def_property_readonly(
      "information", [](const Result& result) { return to_array(result.found.information); },
      "(6, 6) float64, the last iteration's H, in the order and on the side of covariance.");
  type.def_property_readonly(
      "observability",
      [](const Result& result) {
        return py::array(py::array_t<double>(6, result.found.observability.information.data()));
      },
      "(6,) float64, ascending: information of six directions of motion, divided by the largest.");
}

}  // namespace

void bind_result(py::module_& module) {
  bind_iteration(module);
  bind_runner_up(module);
  ResultType type(module, "Result", kResultDoc);
  bind_numbers(type);
  type.def_property_readonly(
      "status", [](const Result& result) { return word_member("Status", name_of(result.found.status)); },
      "A Status; str() gives the command's word, and it equals that word.");
  type.def_property_readonly(
      "free_motions", found(&AlignResult::free_motions),
      "list of FreeMotion: the motions that the data do not constrain, if status is Status.DEGENERATE.");
  type.def_property_readonly("evidence", found(&AlignResult::evidence),
                             "An Evidence for and against the pose; None if there is no pose.");
  type.def_property_readonly("doubts", &doubts, "list of Doubt: why the pose is doubtful.");
  type.def_property_readonly("runners_up", found(&AlignResult::runners_up),
                             "list of RunnerUp: other poses that fit as well, if status is Status.AMBIGUOUS.");
  type.def_property_readonly("history", found(&AlignResult::history), "list of Iteration, at full resolution.");
  type.def_property_readonly(
      "options", [](const Result& result) { return values_of(result.options); },
      "dict of every option as it took effect, with derived lengths. align(**result.options) repeats the call.");
  type.def("__bool__", [](const Result& result) { return result.found.status == AlignStatus::Converged; });
  type.def("__repr__", &result_in_words);
  type.def("__str__", &text_of);
  type.def("_repr_html_", &html_of);
  type.def("report", &write_report, py::arg("path"),
           "Writes the page of `augicp align --report`: one HTML file with both clouds in 3D, readable offline. Raises "
           "FileError, and ArgumentError for a result that was copied or pickled: it has no clouds.");
  type.def("to_dict", &dict_of, "A new dict of lists, numbers and words, for json.dumps().");
  type.def(py::pickle(&state_of_result, &result_of_state));
}

}  // namespace augicp::python
