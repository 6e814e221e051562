// SPDX-License-Identifier: MIT
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "augicp/io/depth_sequence.h"
#include "python/bindings.h"
#include "python/core/without_gil.h"
#include "python/geometry/trajectory.h"

namespace augicp::python {

namespace py = pybind11;

namespace {

constexpr const char* kSequenceReadDoc =
    R"(The content of a folder of depth images: of the TUM benchmark (depth.txt), 7-Scenes, or numbered .png.

frames_per_s: for frames without stamps. No image is opened. Images that are left out, and stamps in another unit than seconds,
are a UserWarning. Returns a DepthSequence. Raises FileError.)";

py::object truth(const DepthSequence& sequence) {
  return sequence.truth ? py::cast(PyTrajectory{*sequence.truth}) : py::none();
}

py::list frames(const DepthSequence& sequence) {
  py::list pairs;
  for (const DepthFrameFile& frame : sequence.frames) pairs.append(py::make_tuple(frame.stamp_s, frame.path));
  return pairs;
}

}  // namespace

void bind_sequence(py::module_& module) {
  py::class_<DepthSequence> type(module, "DepthSequence", "A folder of depth images, see read_depth_sequence.");
  type.def_readonly("layout", &DepthSequence::layout, "\"TUM\", \"7-Scenes\" or \"numbered\".");
  type.def_property_readonly("frames", &frames, "list of (stamp in seconds, pathlib.Path).");
  type.def_readonly("depth_scale", &DepthSequence::depth_scale, "Default of the layout: TUM 5000, others 1000.");
  type.def_readonly("camera", &DepthSequence::camera, "The folder's Camera, or None.");
  type.def_readonly("camera_problem", &DepthSequence::camera_problem,
                    "Why there is no camera although there is a file.");
  type.def_property_readonly("truth", &truth, "The true Trajectory, or None.");
  type.def_readonly("truth_problem", &DepthSequence::truth_problem, "Why there is no truth although there is a file.");
  type.def_readonly("warnings", &DepthSequence::warnings,
                    "list of str: images left out, and stamps in another unit than seconds.");
  type.def("__len__", [](const DepthSequence& sequence) { return sequence.frames.size(); });
  type.def(
      "__getitem__",
      [](const DepthSequence& sequence, const py::object& index) { return py::object(frames(sequence)[index]); },
      py::arg("index"));
  type.def("__iter__", [](const DepthSequence& sequence) {
    return py::module_::import("builtins").attr("iter")(frames(sequence));
  });
  type.def("__repr__", [](const DepthSequence& sequence) {
    return "<augicp.DepthSequence " + sequence.layout + ", " + std::to_string(sequence.frames.size()) + " frames>";
  });
  module.def(
      "read_depth_sequence",
      [](const std::filesystem::path& folder, double frames_per_s) {
        DepthSequence sequence =
            without_gil([&](const std::stop_token&) { return read_depth_sequence(folder, frames_per_s); });
        warn(sequence.warnings, {});
        return sequence;
      },
      py::arg("folder"), py::arg("frames_per_s") = kUsualFramesPerS, kSequenceReadDoc);
}

}  // namespace augicp::python
