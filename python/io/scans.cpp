// SPDX-License-Identifier: MIT
#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>
#include <optional>

#include "augicp/core/error.h"
#include "augicp/io/scan_sequence.h"
#include "augicp/io/time_field.h"
#include "python/bindings.h"
#include "python/cloud/cloud.h"
#include "python/core/without_gil.h"
#include "python/geometry/trajectory.h"

namespace augicp::python {
namespace {

namespace py = pybind11;

constexpr const char* kScansReadDoc =
    R"(The LiDAR scans of a folder (.bin, .pcd or .ply, KITTI's layouts), or the clouds of a recording (.bag, .db3, .mcap, or a
folder of rosbag2).

topic: of a recording; None: the only one of clouds. scans_per_s: for scans without stamps. No scan of a folder is opened; a
recording is read once, for its stamps. Scans that are left out, because there are more of another kind, and stamps in another
unit than seconds are a UserWarning. Stamps may have any order: LidarOdometry tells which scans are out of it. Returns a
ScanSequence. Raises FileError.

    odometry = augicp.LidarOdometry()
    for stamp, cloud, times in augicp.read_scan_sequence("drive.mcap", topic="/points"):
        T_world_sensor = odometry.add(cloud, stamp, times))";

constexpr const char* kSequenceDoc = R"(LiDAR scans of a folder or a recording, see read_scan_sequence.

Iterating gives (stamp in seconds, Cloud, times) and reads one scan at a time. times: a float64 number a point, from a field
t, time, timestamp, time_stamp or offset_time; "order" if the scan has none, or the same for all points: as
LidarOdometry.add takes them. A scan that cannot be read is a UserWarning and left out. Raises FileError for a damaged
recording. Each iterator reads the files itself; one may be used by several threads.)";

struct ScanOfSequence {
  CloudFile file;
  std::vector<double> times;  // empty: unknown
};

// The state of one iterator.
class Reading {
 public:
  explicit Reading(const ScanSequence& sequence) : scans_(sequence.scans), reader_(sequence) {}

  // (stamp, Cloud, times), or None behind the last.
  py::object next() {
    while (true) {
      std::optional<ScanFile> scan;
      std::string problem;
      ScanOfSequence read = without_gil([&](const std::stop_token&) { return read_next(scan, problem); });
      if (!scan) return py::none();
      if (!problem.empty()) {
        warn({"left out"}, problem);
        continue;
      }
      warn(read.file.report.warnings, scan->path.string());
      py::object times = py::str("order");
      if (!read.times.empty())
        times = py::array_t<double>(static_cast<py::ssize_t>(read.times.size()), read.times.data());
      return py::make_tuple(scan->stamp_s, coloured(std::move(read.file)), times);
    }
  }

 private:
  static py::object coloured(CloudFile file) {
    return py::cast(std::make_shared<ColouredScan>(coloured_scan_of(std::move(file))));
  }

  // scan: empty behind the last one. problem: of a scan that cannot be read.
  ScanOfSequence read_next(std::optional<ScanFile>& scan, std::string& problem) {
    const std::lock_guard lock(mutex_);
    if (next_ == scans_.size()) return {};
    scan = scans_[next_];
    ReadOptions options;
    options.keep_fields = true;
    ScanOfSequence read;
    try {
      read.file = reader_.read(next_++, options);
    } catch (const IoError& error) {
      problem = error.what();
      return read;
    }
    if (const PointField* field = find_time_field(read.file, "")) read.times = values_of_points(read.file, *field);
    const auto is_usable = [](double time) { return std::isfinite(time); };
    const auto [first, last] = std::minmax_element(read.times.begin(), read.times.end());
    if (!std::all_of(read.times.begin(), read.times.end(), is_usable) || first == last || *first == *last)
      read.times.clear();
    return read;
  }

  std::mutex mutex_;  // of all below
  std::vector<ScanFile> scans_;
  ScanReader reader_;
  std::size_t next_ = 0;
};

// Python's iter(callable, sentinel): called until it returns None.
py::object iterator_of(const ScanSequence& sequence) {
  const auto reading = std::make_shared<Reading>(sequence);
  return py::module_::import("builtins")
      .attr("iter")(py::cpp_function([reading] { return reading->next(); }), py::none());
}

py::array_t<double> stamps_of(const ScanSequence& sequence) {
  py::array_t<double> stamps(static_cast<py::ssize_t>(sequence.scans.size()));
  std::transform(sequence.scans.begin(), sequence.scans.end(), stamps.mutable_data(),
                 [](const ScanFile& scan) { return scan.stamp_s; });
  return stamps;
}

std::vector<std::string> paths_of(const ScanSequence& sequence) {
  std::vector<std::string> paths;
  for (const ScanFile& scan : sequence.scans) paths.push_back(scan.path.string());
  return paths;
}

ScanSequence read_sequence(const std::filesystem::path& path, const std::optional<std::string>& topic,
                           double scans_per_s) {
  ScanSequence sequence =
      without_gil([&](const std::stop_token&) { return read_scan_sequence(path, scans_per_s, topic.value_or("")); });
  warn(sequence.warnings, {});
  return sequence;
}

}  // namespace

void bind_scans(py::module_& module) {
  py::class_<ScanSequence> type(module, "ScanSequence", kSequenceDoc);
  type.def_readonly("layout", &ScanSequence::layout, "\"KITTI odometry\", \"KITTI raw\", \"scans\" or \"recording\".");
  type.def_readonly("topic", &ScanSequence::topic, "Of a recording; else empty.");
  type.def_property_readonly("stamps", &stamps_of, "(N,) float64, seconds: a new array.");
  type.def_property_readonly(
      "paths", &paths_of,
      "list of the scans' paths, which stand for clouds everywhere: \"drive.mcap#/points#12\" is "
      "the cloud 12, from 0, of a recording.");
  type.def_readonly("warnings", &ScanSequence::warnings,
                    "list of str: scans left out, and stamps in another unit than seconds.");
  type.def("__len__", [](const ScanSequence& sequence) { return sequence.scans.size(); });
  type.def("__iter__", &iterator_of);
  type.def("__repr__", [](const ScanSequence& sequence) {
    return "<augicp.ScanSequence " + sequence.layout + ", " + std::to_string(sequence.scans.size()) + " scans>";
  });
  module.def("read_scan_sequence", &read_sequence, py::arg("path"), py::arg("topic") = py::none(),
             py::arg("scans_per_s") = kUsualScansPerS, kScansReadDoc);
}

}  // namespace augicp::python
