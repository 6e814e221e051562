// SPDX-License-Identifier: MIT
#include <pybind11/stl.h>

#include <mutex>
#include <optional>

#include "augicp/io/depth_png.h"
#include "augicp/odometry/option_table.h"
#include "augicp/sensor/frame_source.h"
#include "python/bindings.h"
#include "python/core/numbers.h"
#include "python/core/options.h"
#include "python/core/without_gil.h"
#include "python/geometry/trajectory.h"
#include "python/sensor/camera.h"
#include "python/sensor/depth.h"

namespace augicp::python {
namespace {

constexpr const char* kDepthDoc = R"(Tracks one depth camera: give it one image after the other.

    odometry = augicp.Odometry("tum-fr1", depth_scale=5000)
    for stamp, image in images:
        T_world_camera = odometry.add(image, stamp)  # None: no pose, see odometry.last_frame

camera: a Camera, or text for Camera.read. depth_scale: for integer images, the value of one metre; see Cloud.from_depth.
The world is the frame of the first camera.

Calls from several threads run one after the other, in any order. Raises ArgumentError and ArgumentTypeError as align does.

Options, by keyword; augicp.default_options("odometry") has their defaults:
)";

constexpr const char* kDepthAddDoc =
    R"(The next image: (height, width), as in Cloud.from_depth. stamp: seconds; None: 1/30 after the one before.

Returns its pose as a new (4, 4) float64 T_world_camera, or None if it has none. last_frame has the report, and whether the
pose may be trusted. A frame without a pose is no error; the next one is tried again. Raises ArgumentError if the image's
size is not the camera's, or depth_scale is wrong. Releases the GIL. Ctrl-C ends it and leaves the object unchanged, so the
same image may be added again.)";

class DepthTracker {
 public:
  DepthTracker(const DepthCamera& camera, std::optional<double> depth_scale, const OdometryOptions& options)
      : camera_(camera), depth_scale_(depth_scale), options_(options), odometry_(options, camera.readout_s) {}

  py::object add(const py::object& given, std::optional<double> stamp) {
    const DepthImage image = depth_image_from(given, depth_scale_);
    const FrameReport report = without_gil([&](const std::stop_token& stop) { return placed(image, stamp, stop); });
    return has_pose(report.status) ? py::object(to_array(report.world_from_camera)) : py::none();
  }

  std::optional<FrameReport> last_frame() const {
    const std::lock_guard lock(mutex_);
    return last_;
  }

  PyTrajectory trajectory() const {
    const std::lock_guard lock(mutex_);
    return {trajectory_};
  }

  // ", 30 poses, last frame tracked"
  std::string state_text() const {
    const std::lock_guard lock(mutex_);
    return ", " + std::to_string(trajectory_.size()) + " poses" +
           (last_ ? ", last frame " + std::string(name_of(last_->status)) : "");
  }

  const OdometryOptions& options() const { return options_; }

 private:
  FrameReport placed(const DepthImage& image, std::optional<double> stamp, const std::stop_token& stop) {
    const std::lock_guard lock(mutex_);
    if (!scale_is_checked_ && tells_depth_scale(image)) check_scale(image, depth_scale_);
    OdometryOptions preparing = options_;
    preparing.registration.stop = stop;
    const Scan frame = prepare_frame(image, camera_, preparing);
    const double next_s = last_stamp_s_ ? *last_stamp_s_ + 1.0 / kUsualFramesPerS : 0.0;
    last_ = odometry_.add(stamp.value_or(next_s), frame, stop);
    if (last_->status != FrameStatus::OutOfOrder) last_stamp_s_ = last_->stamp_s;
    scale_is_checked_ = scale_is_checked_ || tells_depth_scale(image);
    if (has_pose(last_->status)) trajectory_.push_back({last_->stamp_s, last_->world_from_camera});
    return *last_;
  }

  const DepthCamera camera_;
  const std::optional<double> depth_scale_;
  const OdometryOptions options_;
  mutable std::mutex mutex_;  // of all below
  Odometry odometry_;
  bool scale_is_checked_ = false;
  std::optional<FrameReport> last_;
  std::optional<double> last_stamp_s_;  // of the frames in order
  Trajectory trajectory_;
};

std::unique_ptr<DepthTracker> made_depth_tracker(const py::object& camera, std::optional<double> depth_scale,
                                                 const py::kwargs& given) {
  OdometryOptions options;
  set_options(given, options);
  options.check();
  return std::make_unique<DepthTracker>(camera_from(camera), depth_scale, options);
}

}  // namespace

void bind_odometry(py::module_& module) {
  py::class_<DepthTracker> type(module, "Odometry", (kDepthDoc + options_doc<OdometryOptions>()).c_str());
  type.def(py::init(&made_depth_tracker), py::arg("camera"), py::arg("depth_scale") = py::none());
  type.def("add", &DepthTracker::add, py::arg("depth"), py::arg("stamp") = py::none(), kDepthAddDoc);
  type.def_property_readonly("last_frame", &DepthTracker::last_frame,
                             "A Frame: how the last image went; None before the first.");
  type.def_property_readonly("trajectory", &DepthTracker::trajectory, "A Trajectory of every pose so far: a copy.");
  type.def("__repr__", [](const DepthTracker& tracker) { return "<augicp.Odometry" + tracker.state_text() + ">"; });
  type.def_property_readonly(
      "options", [](const DepthTracker& tracker) { return values_of(tracker.options()); },
      "dict of every option as it took effect.");
}

}  // namespace augicp::python
