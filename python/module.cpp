// SPDX-License-Identifier: MIT
#include <stdexcept>

#include "python/bindings.h"
#include "python/camera.h"
#include "python/cloud.h"
#include "python/depth.h"
#include "python/errors.h"
#include "python/evaluation_options.h"
#include "python/odometry_options.h"
#include "python/registration_options.h"
#include "python/result.h"
#include "python/trajectory.h"
#include "python/words.h"

namespace augicp::python {
namespace {

constexpr const char* kDefaultsDoc =
    R"(A new dict of every keyword option and its default, of "align" (and estimate_surface), "odometry" or "evaluate".

None: derived from the clouds, or the preset's.)";

py::dict default_options(const std::string& function) {
  if (function == "align") return values_of(registration_options(), RegistrationOptions{});
  if (function == "odometry") return values_of(odometry_options(), OdometryOptions{});
  if (function == "evaluate") return values_of(evaluation_options(), EvaluationOptions{});
  throw std::invalid_argument("default_options: expected align, odometry or evaluate, found '" + function + "'");
}

// All that has a name of its own, for `from augicp import *`.
py::list public_names(const py::module_& module) {
  py::list names;
  for (const py::handle name : py::module_::import("builtins").attr("dir")(module))
    if (!py::cast<std::string>(name).starts_with("_")) names.append(name);
  return names;
}

// In the order in which docstrings name them: a type comes before what takes or returns it.
void bind_all(py::module_& module) {
  bind_errors(module);
  bind_words(module);
  bind_camera(module);
  bind_cloud(module);
  bind_depth(module);
  bind_trajectory(module);
  bind_evidence(module);
  bind_result(module);
  bind_align(module);
  bind_surface(module);
  bind_files(module);
  bind_sequence(module);
  bind_odometry(module);
  bind_evaluate(module);
  module.def("default_options", &default_options, py::arg("function") = "align", kDefaultsDoc);
}

}  // namespace
}  // namespace augicp::python

PYBIND11_MODULE(_augicp, module) {
  augicp::python::bind_all(module);
  module.attr("__version__") = AUGICP_VERSION;
  module.attr("__all__") = augicp::python::public_names(module);
}
