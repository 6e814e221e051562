// SPDX-License-Identifier: MIT
#include <pybind11/stl.h>

#include <stdexcept>

#include "augicp/io/unit_warning.h"
#include "augicp/registration/option_table.h"
#include "augicp/registration/options_in_effect.h"
#include "augicp/registration/registration.h"
#include "python/bindings.h"
#include "python/cloud/cloud.h"
#include "python/core/numbers.h"
#include "python/core/options.h"
#include "python/core/without_gil.h"
#include "python/geometry/trajectory.h"
#include "python/registration/report.h"
#include "python/registration/result.h"

namespace augicp::python {
namespace {

constexpr const char* kAlignDoc = R"(Finds the rigid motion between two clouds.

source, target: the moving and the fixed cloud: (N, 3) arrays (float32, float64, anything with __array__), metres,
  Cloud, or the path of a cloud, see read().
initial: (4, 4) guess of T_target_source, rigid to within 1e-3; None: the identity; "global": there is none, and the pose
  is searched among all.
method: the objective: "augmented", "gicp", "plane", "point" or "ndt".
threads: 0: all of the machine. The result is bit-identical for any number.
progress: called as progress(stage, done, total) at the beginning and at the end of each step: a word ("surfaces",
  "search", "aligning", "verdict", ...), how many items of that stage are done, and how many there are. What it raises
  stops the work and comes out of this call. It has no influence on the result.

Returns a Result; bool(result) is True only if both clouds support the pose. Bad data never raises: empty or non-overlapping
clouds give a status. Raises ArgumentError (a ValueError) for options and shapes out of
range, ArgumentTypeError (a TypeError) for unknown options and for what are no numbers. Arrays are copied first. Works
without the GIL; may be called from several threads at once; Ctrl-C ends it. Clouds of which one is about a thousand times
as large as the other are a UserWarning: millimetres and metres? The result keeps the clouds, for its report().

Options, by keyword; augicp.default_options() has their defaults:
)";

constexpr const char* kFindDoc = R"(Finds the rigid motion between two clouds of which nothing is known.

Returns a list of Result: every pose that was found, the best first, each with its evidence. The first one is that of
align(source, target, initial="global"); the others have the status that they would have alone, but none that differs
clearly from the first one is converged. Empty if the clouds have nothing alike. source, target, threads, progress,
options and exceptions: as of align().
)";

// What a result says of its options: they are those in effect.
Result with_lengths(AlignResult found, const Scan& target, const Lengths& lengths, RegistrationOptions options,
                    std::shared_ptr<const ResultInputs> inputs) {
  options.stop = {};
  const bool are_clouds = !inputs->source->view && !inputs->target->view;
  return {std::move(found), options_in_effect(options, lengths, are_clouds), target.cloud.origin, std::move(inputs)};
}

RegistrationOptions options_from(const py::object& method, const py::object& threads, const py::kwargs& given) {
  given["method"] = method;
  given["threads"] = threads;
  RegistrationOptions options;
  set_options(given, options);
  return options;
}

Reports reports_to(const py::object& progress) {
  if (!progress.is_none() && PyCallable_Check(progress.ptr()) == 0)
    throw WrongType("progress: expected something to call as progress(stage, done, total)");
  return Reports(progress);
}

// The guess; or the word for none, which is set in the options.
Rigid3 guess_from(const py::object& initial, RegistrationOptions& options) {
  if (!py::isinstance<py::str>(initial)) return rigid3_from(initial, "initial");
  if (py::cast<std::string>(initial) != "global")
    throw std::invalid_argument("initial = \"" + py::cast<std::string>(initial) +
                                "\": must be a (4, 4) matrix, None or \"global\"");
  options.global = true;
  return {};
}

std::shared_ptr<const ResultInputs> inputs_from(const py::object& source, const py::object& target,
                                                const Rigid3& guess) {
  const auto inputs = std::make_shared<ResultInputs>();
  inputs->source = scan_from(source, "source");
  inputs->target = scan_from(target, "target");
  inputs->initial = guess;
  inputs->source_name = name_in_report(source, *inputs->source);
  inputs->target_name = name_in_report(target, *inputs->target);
  const std::string doubt = unit_warning(inputs->source->cloud, inputs->target->cloud);
  if (!doubt.empty()) warn({doubt}, "align");
  return inputs;
}

Result align(const py::object& source, const py::object& target, const py::object& initial, const py::object& method,
             const py::object& threads, const py::object& progress, const py::kwargs& given) {
  RegistrationOptions options = options_from(method, threads, given);
  Reports reports = reports_to(progress);
  const Rigid3 guess = guess_from(initial, options);
  options.check();
  const auto inputs = inputs_from(source, target, guess);
  const auto work = [inputs, options, on_stage = reports.on_stage()](const std::stop_token& stop) {
    RegistrationOptions watched = options;
    watched.stop = stop;
    watched.on_stage = on_stage;
    Registration registration = register_scans(*inputs->source, *inputs->target, inputs->initial, watched);
    return with_lengths(std::move(registration.result), registration.prepared.target, registration.prepared.lengths,
                        options, inputs);
  };
  return without_gil_or_wait(work, &reports);
}

std::vector<Result> find_pose(const py::object& source, const py::object& target, const py::object& method,
                              const py::object& threads, const py::object& progress, const py::kwargs& given) {
  RegistrationOptions options = options_from(method, threads, given);
  Reports reports = reports_to(progress);
  options.global = true;
  options.check();
  const auto inputs = inputs_from(source, target, {});
  const auto work = [inputs, options, on_stage = reports.on_stage()](const std::stop_token& stop) {
    RegistrationOptions watched = options;
    watched.stop = stop;
    watched.on_stage = on_stage;
    std::vector<Result> results;
    for (auto& [found, lengths] : augicp::find_pose(*inputs->source, *inputs->target, watched))
      results.push_back(with_lengths(std::move(found), *inputs->target, lengths, options, inputs));
    return results;
  };
  return without_gil_or_wait(work, &reports);
}

}  // namespace

void bind_align(py::module_& module) {
  const py::dict usual = values_of(RegistrationOptions{});
  module.def("align", &align, py::arg("source"), py::arg("target"), py::arg("initial") = py::none(),
             py::arg("method") = usual["method"], py::arg("threads") = usual["threads"],
             py::arg("progress") = py::none(), (kAlignDoc + options_doc<RegistrationOptions>()).c_str());
  module.def("find_pose", &find_pose, py::arg("source"), py::arg("target"), py::arg("method") = usual["method"],
             py::arg("threads") = usual["threads"], py::arg("progress") = py::none(), kFindDoc);
}

}  // namespace augicp::python
