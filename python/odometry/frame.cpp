// SPDX-License-Identifier: MIT
#include <pybind11/stl.h>

#include "augicp/odometry/odometry.h"
#include "python/bindings.h"
#include "python/core/numbers.h"
#include "python/core/words.h"

namespace augicp::python {
namespace {

py::object pose(const FrameReport& frame) {
  return has_pose(frame.status) ? py::object(to_array(frame.world_from_camera)) : py::none();
}

py::object registration(const FrameReport& frame) {
  return frame.registration ? word_member("Status", name_of(*frame.registration)) : py::none();
}

py::object drift(const FrameReport& frame) {
  if (!frame.drift) return py::none();
  const DriftCheck& check = *frame.drift;
  py::dict numbers;
  numbers["keyframe_stamp"] = check.keyframe_stamp_s;
  numbers["distance_m"] = check.distance_m;
  numbers["drift_m"] = check.drift_m;
  numbers["drift_deg"] = check.drift_deg;
  numbers["expected_m"] = check.expected_m;
  numbers["contradicts"] = check.contradicts;
  return numbers;
}

std::string in_words(const FrameReport& frame) {
  return "<augicp.Frame at " + std::to_string(frame.stamp_s) + " s: " + std::string(name_of(frame.status)) +
         (frame.problem.empty() ? "" : " (" + frame.problem + ")") + ">";
}

}  // namespace

void bind_frame(py::module_& module) {
  py::class_<FrameReport> type(
      module, "Frame",
      "The report of a frame of odometry. bool(frame) is True if its pose may be trusted: it was "
      "tracked, or a segment starts with it.");
  type.def_readonly("stamp", &FrameReport::stamp_s, "Seconds.");
  type.def_property_readonly(
      "status", [](const FrameReport& frame) { return word_member("FrameStatus", name_of(frame.status)); },
      "A FrameStatus.");
  type.def_property_readonly("T_world_camera", &pose, "(4, 4) float64: a new array; None if there is no pose.");
  type.def_readonly("segment", &FrameReport::segment, "No motion was measured between poses of different segments.");
  type.def_readonly("is_keyframe", &FrameReport::is_keyframe, "The model is in its view from now on.");
  type.def_property_readonly("registration", &registration, "The Status of its registration, or None.");
  type.def_readonly("iterations", &FrameReport::iterations, "Iterations of its registrations.");
  type.def_readonly("num_pairs", &FrameReport::num_pairs, "Pairs at the last iteration.");
  type.def_readonly("overlap", &FrameReport::overlap, "Share of its points with a correspondence, 0 to 1.");
  type.def_readonly("rmse", &FrameReport::rmse, "Root mean square of the distances within the pairs, metres.");
  type.def_readonly("strain", &FrameReport::strain, "Strain of the evidence, see Evidence.");
  type.def_property_readonly(
      "drift", &drift,
      "Of a LiDAR scan that was also registered directly to a keyframe farther back: a new dictionary with "
      "keyframe_stamp "
      "(seconds), distance_m to it, drift_m and drift_deg between the two poses, expected_m by their covariances, and "
      "whether the direct pose contradicts. Otherwise None.");
  type.def_readonly("problem", &FrameReport::problem, "In words; empty if there is none.");
  type.def("__bool__", [](const FrameReport& frame) {
    return frame.status == FrameStatus::Tracked || frame.status == FrameStatus::Started;
  });
  type.def("__repr__", &in_words);
}

}  // namespace augicp::python
