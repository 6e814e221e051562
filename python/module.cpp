// SPDX-License-Identifier: MIT
#include <stdexcept>

#include "augicp/eval/option_table.h"
#include "augicp/odometry/lidar_option_table.h"
#include "augicp/odometry/option_table.h"
#include "augicp/registration/option_table.h"
#include "python/bindings.h"
#include "python/cloud/cloud.h"
#include "python/core/errors.h"
#include "python/core/options.h"
#include "python/core/signatures.h"
#include "python/core/without_gil.h"
#include "python/core/words.h"
#include "python/geometry/trajectory.h"
#include "python/registration/result.h"
#include "python/sensor/camera.h"
#include "python/sensor/depth.h"

namespace augicp::python {
namespace {

constexpr const char* kDefaultsDoc =
    R"(A new dict of every keyword option and its default, of "align" (and estimate_surface), "odometry", "lidar_odometry" or
"evaluate".

None: derived from the clouds, or the preset's.)";

// made(options) of the options that a function takes.
template <typename Make>
py::dict of_options(const std::string& function, const Make& made) {
  if (function == "align") return made(RegistrationOptions{});
  if (function == "odometry") return made(OdometryOptions{});
  if (function == "lidar_odometry") return made(LidarOptions{});
  if (function == "evaluate") return made(EvaluationOptions{});
  throw std::invalid_argument("default_options: expected align, odometry, lidar_odometry or evaluate, found '" +
                              function + "'");
}

py::dict default_options(const std::string& function) {
  return of_options(function, [](const auto& options) { return values_of(options); });
}

py::dict option_types(const std::string& function) {
  return of_options(function, [](const auto& options) { return types_of(options); });
}

// The functions with keyword options, and whose options they are.
py::dict keyword_options() {
  py::dict options;
  for (const char* name : {"align", "find_pose", "estimate_surface"}) options[name] = default_options("align");
  options["Odometry.__init__"] = default_options("odometry");
  options["LidarOdometry.__init__"] = default_options("lidar_odometry");
  options["evaluate"] = default_options("evaluate");
  return options;
}

// All public names, for `from augicp import *`.
py::list public_names(const py::module_& module) {
  py::list names;
  for (const py::handle name : py::module_::import("builtins").attr("dir")(module))
    if (!py::cast<std::string>(name).starts_with("_")) names.append(name);
  return names;
}

// In the order of use in docstrings: a type comes before the functions that take or return it.
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
  bind_scans(module);
  bind_frame(module);
  bind_odometry(module);
  bind_lidar_odometry(module);
  bind_evaluate(module);
  module.def("default_options", &default_options, py::arg("function") = "align", kDefaultsDoc);
  module.def("_option_types", &option_types, "The same with the type of each, as the stub has it.");
  set_text_signatures(module, keyword_options());
  wait_for_kept_at_exit();
}

}  // namespace
}  // namespace augicp::python

PYBIND11_MODULE(_augicp, module) {
  augicp::python::bind_all(module);
  module.attr("__version__") = AUGICP_VERSION;
  module.attr("__all__") = augicp::python::public_names(module);
}
