// SPDX-License-Identifier: MIT
#include <stdexcept>

#include "augicp/registration/option_table.h"
#include "augicp/registration/registration.h"
#include "python/bindings.h"
#include "python/cloud/cloud.h"
#include "python/core/options.h"
#include "python/core/without_gil.h"

namespace augicp::python {
namespace {

constexpr const char* kSurfaceDoc = R"(Estimates normals, tangents and structures as a registration does.

cloud: (N, 3) array, metres, or Cloud; directions that it has are replaced.
threads: 0: all of the machine. The result is bit-identical for any number.
Options, by keyword: radius, voxel_size, preset, classifier and the others of align.

Returns a new Cloud with directions and structures. Without a depth image it has one point per voxel, ordered along a curve:
not the points that were given. Raises ArgumentError if all points are equal, and like align. Releases the GIL; may be
called from several threads at once; Ctrl-C ends it between two stages.)";

Scan extended(Scan scan, const RegistrationOptions& options) {
  scan.cloud.directions.clear();  // the cloud's own directions are not used
  scan.cloud.structures.clear();
  const Lengths lengths = lengths_for(scan, scan, options);
  if (!(lengths.radius > 0.0)) throw std::invalid_argument("cloud: all points are equal, so there is no surface");
  return prepare(std::move(scan), lengths, options);
}

py::object estimate_surface(const py::object& cloud, const py::object& threads, const py::kwargs& given) {
  given["threads"] = threads;
  RegistrationOptions options;
  set_options(given, options);
  options.check();
  const SharedScan scan = scan_from(cloud, "cloud");
  return cloud_of(without_gil_or_wait([scan, options](const std::stop_token& stop) {
    RegistrationOptions stoppable = options;
    stoppable.stop = stop;
    return extended(*scan, stoppable);
  }));
}

}  // namespace

void bind_surface(py::module_& module) {
  const py::dict usual = values_of(RegistrationOptions{});
  module.def("estimate_surface", &estimate_surface, py::arg("cloud"), py::arg("threads") = usual["threads"],
             kSurfaceDoc);
}

}  // namespace augicp::python
