// SPDX-License-Identifier: MIT
#include "augicp/registration/registration.h"
#include "augicp/registration/words.h"
#include "python/bindings.h"
#include "python/cloud.h"
#include "python/numbers.h"
#include "python/registration_options.h"
#include "python/result.h"
#include "python/without_gil.h"

namespace augicp::python {
namespace {

constexpr const char* kDoc = R"(Finds the rigid motion between two clouds.

source, target: what moves and what stays: (N, 3) arrays (float32, float64, anything with __array__), metres, or Cloud.
initial: (4, 4) guess of T_target_source, or None: the identity. It must be rigid to within 1e-3.
method: what is minimised: "augmented", "gicp", "plane" or "point".
threads: 0: all the machine's. The result has the same bits for any number.

Options, by keyword; augicp.default_options() has their defaults, and None means: derived from the clouds.
preset          "default", or "paper": the source to the letter
association     "auto", "projective" (through the target's camera) or "nearest"
radius          of the ball that surfaces are estimated in, metres
voxel_size      clouds without a depth image are thinned to one point a voxel, metres
max_distance    pairs farther apart are dropped, metres
max_angle       pairs whose directions differ by more are dropped, radians
search          other guesses are tried where the given one leads nowhere convincing
coarse_to_fine, rolling_shutter    see docs/convergence.md
max_iterations, min_step           the loop's end: a count; a part of the extent, and radians
intensity       where both clouds have intensities, brightness is compared too
covariance      Result.covariance is asked for; without it a small image takes a fifth less time
classifier ("normals", "eigenvalues"), kernel_chi2, lever, damping    instead of the preset's

Returns a Result; bool(result) is True only where both clouds speak for the pose. What the data are like is never an
error: empty clouds, or such as do not fit, give a status. Raises ArgumentError (a ValueError) for options and shapes out of
range, ArgumentTypeError (a TypeError) for unknown options and for what are no numbers. Arrays are copied first. Works
without the GIL; may be called from several threads at once; Ctrl-C ends it between two iterations or stages.)";

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
  set_options(registration_options(), given, options);
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
  const py::dict usual = values_of(registration_options(), RegistrationOptions{});
  module.def("align", &align, py::arg("source"), py::arg("target"), py::arg("initial") = py::none(),
             py::arg("method") = usual["method"], py::arg("threads") = usual["threads"], kDoc);
}

}  // namespace augicp::python
