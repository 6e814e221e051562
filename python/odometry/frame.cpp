// SPDX-License-Identifier: MIT
#include <pybind11/stl.h>

#include "augicp/odometry/odometry.h"
#include "python/bindings.h"
#include "python/core/numbers.h"
#include "python/core/state.h"
#include "python/core/words.h"
#include "python/trust/evidence_state.h"

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

std::string frame_in_words(const FrameReport& frame) {
  return "<augicp.Frame at " + std::to_string(frame.stamp_s) + " s: " + std::string(name_of(frame.status)) +
         (frame.problem.empty() ? "" : " (" + frame.problem + ")") + ">";
}

// Everything but the problem, which is text, and the motion during the sweep, which Python does not show.
struct VisitFrame {
  void operator()(auto& archive, auto& frame) const {
    archive.number(frame.stamp_s);
    archive.number(frame.status);
    visit_pose(archive, frame.world_from_camera);
    archive.number(frame.segment);
    archive.number(frame.is_keyframe);
    if (archive.has(frame.registration)) archive.number(*frame.registration);
    archive.number(frame.iterations);
    archive.number(frame.num_pairs);
    for (auto* value : {&frame.overlap, &frame.rmse, &frame.strain}) archive.number(*value);
    if (archive.has(frame.covariance)) visit_matrix(archive, *frame.covariance);
    archive.size(frame.free_motions);
    for (auto& motion : frame.free_motions) VisitFreeMotion{}(archive, motion);
    if (archive.has(frame.drift)) visit_drift(archive, *frame.drift);
  }
  static void visit_drift(auto& archive, auto& drift) {
    visit_pose(archive, drift.keyframe_from_sensor);
    for (auto* value : {&drift.keyframe_stamp_s, &drift.distance_m, &drift.drift_m, &drift.drift_deg, &drift.expected_m,
                        &drift.share_chained, &drift.share_direct})
      archive.number(*value);
    archive.number(drift.contradicts);
  }
};

FrameReport frame_of_state(const py::tuple& state) {
  FrameReport frame = value_of_state<FrameReport>(state, VisitFrame{});
  frame.problem = state[2].cast<std::string>();
  return frame;
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
  type.def("__repr__", &frame_in_words);
  type.def(
      py::pickle([](const FrameReport& frame) { return state_of_value(frame, VisitFrame{}, py::str(frame.problem)); },
                 &frame_of_state));
}

}  // namespace augicp::python
