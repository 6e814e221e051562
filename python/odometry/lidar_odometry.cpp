// SPDX-License-Identifier: MIT
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <cmath>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <vector>

#include "augicp/io/scan_sequence.h"
#include "augicp/odometry/lidar_option_table.h"
#include "python/bindings.h"
#include "python/cloud/cloud.h"
#include "python/core/numbers.h"
#include "python/core/options.h"
#include "python/core/without_gil.h"
#include "python/geometry/trajectory.h"

namespace augicp::python {
namespace {

constexpr const char* kLidarDoc = R"(Tracks one LiDAR: give it one scan after the other.

    odometry = augicp.LidarOdometry()
    for stamp, points in scans:
        T_world_sensor = odometry.add(points, stamp)  # None: no pose, see odometry.last_frame

The world is the frame of the first scan. A pose refers to the middle of its sweep if the times of its points are known.

Calls from several threads run one after the other, in any order. Raises ArgumentError and ArgumentTypeError as align does.

Options, by keyword; augicp.default_options("lidar_odometry") has their defaults:
)";

constexpr const char* kLidarAddDoc =
    R"(The next scan: a Cloud, or an (N, 3) array of points in the sensor's frame, metres. Points that are not finite are
dropped, with their times.

stamp: seconds; None: 0.1 after the one before. times: when each point was measured, N numbers in any unit and from any zero;
"order": from the order of the points, if that is the firing order; "azimuth": one revolution that begins behind the sensor,
as KITTI's scans need; "none": all at once.

Returns its pose as a new (4, 4) float64 T_world_sensor, or None if it has none. last_frame has the report. A scan without a
pose is no error; the next one is tried again. Releases the GIL. Ctrl-C ends it and leaves the object unchanged, so the same
scan may be added again.)";

// The times of the points that are kept: those that are not finite are dropped, and with them their times.
std::vector<double> times_of_kept(const py::array_t<double>& times, const py::object& points) {
  std::vector<double> kept_s(times.data(), times.data() + times.size());
  if (!py::isinstance<py::array>(points)) return kept_s;
  const py::array rows = as_reals(as_numbers(points, "points"));
  if (rows.ndim() != 2 || rows.shape(0) != times.size()) return kept_s;
  const Reals at(rows);
  std::size_t num_kept = 0;
  for (py::ssize_t i = 0; i < times.size(); ++i)
    if (std::isfinite(at(i, 0)) && std::isfinite(at(i, 1)) && std::isfinite(at(i, 2))) kept_s[num_kept++] = times.at(i);
  kept_s.resize(num_kept);
  return kept_s;
}

SweepShares shares_from(const py::object& times, const py::object& points, const Cloud& cloud) {
  if (py::isinstance<py::str>(times)) {
    const auto word = py::cast<std::string>(times);
    if (word == "order") return shares_from_order(cloud);
    if (word == "azimuth") return shares_from_azimuth(cloud);
    if (word == "none") return {};
    throw std::invalid_argument("times: expected numbers, order, azimuth or none, found '" + word + "'");
  }
  const auto array = py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(times);
  if (!array) {
    PyErr_Clear();
    throw std::invalid_argument("times: expected one number a point");
  }
  const std::vector<double> of_points = array.ndim() == 1 ? times_of_kept(array, points) : std::vector<double>{};
  if (array.ndim() != 1 || of_points.size() != cloud.size())
    throw std::invalid_argument("times: expected " + std::to_string(cloud.size()) + " numbers, one a point, found " +
                                std::to_string(array.size()));
  return shares_from_times(of_points);
}

class LidarTracker {
 public:
  explicit LidarTracker(const LidarOptions& options) : options_(options), odometry_(options) {}

  py::object add(const py::object& points, std::optional<double> stamp, const py::object& times) {
    const SharedScan scan = scan_from(points, "points");
    const SweepShares shares = shares_from(times, points, scan->cloud);
    const FrameReport report =
        without_gil([&](const std::stop_token& stop) { return placed(scan->cloud, shares, stamp, stop); });
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

  Scan map() const {
    const std::lock_guard lock(mutex_);
    return scan_of(odometry_.map());
  }

  // Nothing before the first scan with points.
  std::optional<double> voxel_size() const {
    const std::lock_guard lock(mutex_);
    return odometry_.voxel_size() > 0.0 ? std::optional(odometry_.voxel_size()) : std::nullopt;
  }

  // ", 30 poses, last scan tracked"
  std::string state_text() const {
    const std::lock_guard lock(mutex_);
    return ", " + std::to_string(trajectory_.size()) + " poses" +
           (last_ ? ", last scan " + std::string(name_of(last_->status)) : "");
  }

  const LidarOptions& options() const { return options_; }

 private:
  FrameReport placed(const Cloud& cloud, const SweepShares& shares, std::optional<double> stamp,
                     const std::stop_token& stop) {
    const std::lock_guard lock(mutex_);
    const double next_s = last_stamp_s_ ? *last_stamp_s_ + 1.0 / kUsualScansPerS : 0.0;
    last_ = odometry_.add(stamp.value_or(next_s), cloud, shares, stop);
    if (last_->status != FrameStatus::OutOfOrder) last_stamp_s_ = last_->stamp_s;
    if (has_pose(last_->status)) trajectory_.push_back({last_->stamp_s, last_->world_from_camera});
    return *last_;
  }

  const LidarOptions options_;
  mutable std::mutex mutex_;  // of all below
  LidarOdometry odometry_;
  std::optional<FrameReport> last_;
  std::optional<double> last_stamp_s_;  // of the scans in order
  Trajectory trajectory_;
};

std::unique_ptr<LidarTracker> made_lidar_tracker(const py::kwargs& given) {
  LidarOptions options;
  set_options(given, options);
  return std::make_unique<LidarTracker>(options);
}

}  // namespace

void bind_lidar_odometry(py::module_& module) {
  py::class_<LidarTracker> type(module, "LidarOdometry", (kLidarDoc + options_doc<LidarOptions>()).c_str());
  type.def(py::init(&made_lidar_tracker));
  type.def("add", &LidarTracker::add, py::arg("points"), py::arg("stamp") = py::none(), py::arg("times") = "order",
           kLidarAddDoc);
  type.def_property_readonly("last_frame", &LidarTracker::last_frame,
                             "A Frame: how the last scan went; None before the first.");
  type.def_property_readonly("trajectory", &LidarTracker::trajectory, "A Trajectory of every pose so far: a copy.");
  type.def_property_readonly(
      "map", [](const LidarTracker& tracker) { return cloud_of(tracker.map()); },
      "A Cloud of the surfaces around the last pose, in the world; empty before the first scan.");
  type.def_property_readonly("voxel_size", &LidarTracker::voxel_size,
                             "Edge of the map's voxels, metres: the option, or what was derived from the first scan; "
                             "None before it.");
  type.def("__repr__",
           [](const LidarTracker& tracker) { return "<augicp.LidarOdometry" + tracker.state_text() + ">"; });
  type.def_property_readonly(
      "options", [](const LidarTracker& tracker) { return values_of(tracker.options()); },
      "dict of every option as it took effect.");
}

}  // namespace augicp::python
