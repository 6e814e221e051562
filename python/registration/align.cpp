// SPDX-License-Identifier: MIT
#include "augicp/registration/option_table.h"
#include "augicp/registration/registration.h"
#include "python/bindings.h"
#include "python/cloud/cloud.h"
#include "python/core/numbers.h"
#include "python/core/options.h"
#include "python/core/without_gil.h"
#include "python/registration/result.h"

namespace augicp::python {
namespace {

constexpr const char* kDoc = R"(Finds the rigid motion between two clouds.

source, target: the moving and the fixed cloud: (N, 3) arrays (float32, float64, anything with __array__), metres, or
  Cloud.
initial: (4, 4) guess of T_target_source, or None: the identity. It must be rigid to within 1e-3.
method: the objective: "augmented", "gicp", "plane" or "point".
threads: 0: all of the machine. The result is bit-identical for any number.

Returns a Result; bool(result) is True only if both clouds support the pose. Bad data never raises: empty or non-overlapping
clouds give a status. Raises ArgumentError (a ValueError) for options and shapes out of
range, ArgumentTypeError (a TypeError) for unknown options and for what are no numbers. Arrays are copied first. Works
without the GIL; may be called from several threads at once; Ctrl-C ends it between two iterations or stages.

Options, by keyword; augicp.default_options() has their defaults:
)";

// The result, with the derived lengths among its options.
Result register_pair(const Scan& source, const Scan& target, const Rigid3& initial, RegistrationOptions options) {
  Registration registration = register_scans(source, target, initial, options);
  const Lengths& lengths = registration.prepared.lengths;
  Result result;
  result.found = std::move(registration.result);
  options.stop = {};
  if (lengths.radius > 0.0) {
    options.radius = lengths.radius;
    options.voxel_size = lengths.voxel_size;
    options.max_distance = lengths.max_distance;
  }
  result.options = options;
  return result;
}

Result align(const py::object& source, const py::object& target, const py::object& initial, const py::object& method,
             const py::object& threads, const py::kwargs& given) {
  given["method"] = method;
  given["threads"] = threads;
  RegistrationOptions options;
  set_options(given, options);
  options.check();
  const Rigid3 guess = rigid3_from(initial, "initial");
  const SharedScan source_scan = scan_from(source, "source"), target_scan = scan_from(target, "target");
  return without_gil([&](const std::stop_token& stop) {
    options.stop = stop;
    return register_pair(*source_scan, *target_scan, guess, options);
  });
}

}  // namespace

void bind_align(py::module_& module) {
  const py::dict usual = values_of(RegistrationOptions{});
  module.def("align", &align, py::arg("source"), py::arg("target"), py::arg("initial") = py::none(),
             py::arg("method") = usual["method"], py::arg("threads") = usual["threads"],
             (kDoc + options_doc<RegistrationOptions>()).c_str());
}

}  // namespace augicp::python
