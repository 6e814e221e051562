// SPDX-License-Identifier: MIT
#include "python/geometry/trajectory.h"

#include <pybind11/stl/filesystem.h>

#include <cmath>
#include <stdexcept>

#include "augicp/io/cloud_file.h"
#include "augicp/io/trajectory_file.h"
#include "python/bindings.h"
#include "python/core/errors.h"
#include "python/core/numbers.h"
#include "python/core/state.h"
#include "python/core/without_gil.h"

namespace augicp::python {
namespace {

constexpr const char* kTrajectoryDoc = R"(Where a camera was, and when. It cannot be changed.

stamps: (N,) seconds, increasing. poses: (N, 4, 4), each T_world_camera: it maps camera coordinates into the world's, metres.
Iterating gives pairs (stamp, pose). Raises ArgumentError for stamps out of order and for poses that are not rigid to within 1e-3.)";

// The i-th matrix of a stack.
Rigid3 pose_at(const py::array& poses, py::ssize_t i) {
  return rigid3_from(poses[py::int_(i)], "poses[" + std::to_string(i) + "]");
}

PyTrajectory from_arrays(const py::object& given_stamps, const py::object& given_poses) {
  const py::array stamps = as_reals(as_numbers(given_stamps, "stamps")), poses = as_numbers(given_poses, "poses");
  if (stamps.ndim() != 1) throw std::invalid_argument("stamps: expected shape (N,), found " + shape_text(stamps));
  if (poses.ndim() != 3 || poses.shape(1) != 4 || poses.shape(2) != 4 || poses.shape(0) != stamps.shape(0))
    throw std::invalid_argument("poses: expected shape (" + std::to_string(stamps.shape(0)) + ", 4, 4), found " +
                                shape_text(poses));
  if (static_cast<std::uint64_t>(stamps.shape(0)) > ReadOptions{}.max_points)
    throw std::invalid_argument("stamps: too many, " + std::to_string(stamps.shape(0)));
  const Reals stamp(stamps);
  PyTrajectory made;
  for (py::ssize_t i = 0; i < stamps.shape(0); ++i) {
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    made.poses.push_back({stamp(static_cast<std::size_t>(i), 0), pose_at(poses, i)});
  }
  check_order(made.poses);
  return made;
}

py::array stamps(const PyTrajectory& trajectory) {
  py::array_t<double> array(static_cast<py::ssize_t>(trajectory.poses.size()));
  for (std::size_t i = 0; i < trajectory.poses.size(); ++i) array.mutable_at(i) = trajectory.poses[i].stamp_s;
  return array;
}

py::array poses(const PyTrajectory& trajectory) {
  py::array_t<double> array({static_cast<py::ssize_t>(trajectory.poses.size()), py::ssize_t{4}, py::ssize_t{4}});
  auto numbers = array.mutable_unchecked<3>();
  for (py::ssize_t k = 0; k < numbers.shape(0); ++k) {
    const Mat4d matrix = trajectory.poses[static_cast<std::size_t>(k)].world_from_camera.matrix();
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) numbers(k, i, j) = matrix(i, j);
  }
  return array;
}

py::tuple pair_of(const StampedPose& pose) { return py::make_tuple(pose.stamp_s, to_array(pose.world_from_camera)); }

// IndexError at the end: Python's protocol of sequences.
py::tuple item(const PyTrajectory& trajectory, py::ssize_t index) {
  const auto count = static_cast<py::ssize_t>(trajectory.poses.size());
  if (index < -count || index >= count) throw py::index_error("no pose " + std::to_string(index));
  return pair_of(trajectory.poses[static_cast<std::size_t>(index < 0 ? index + count : index)]);
}

// trajectory[2:5] is a Trajectory, trajectory[2] a pair.
PyTrajectory part(const PyTrajectory& trajectory, const py::slice& slice) {
  py::ssize_t start = 0, stop = 0, step = 0, count = 0;
  if (!slice.compute(static_cast<py::ssize_t>(trajectory.poses.size()), &start, &stop, &step, &count))
    throw py::error_already_set();
  PyTrajectory chosen;
  for (; count > 0; --count, start += step) chosen.poses.push_back(trajectory.poses[static_cast<std::size_t>(start)]);
  check_order(chosen.poses);
  return chosen;
}

py::object item_or_part(const PyTrajectory& trajectory, const py::object& index) {
  if (py::isinstance<py::slice>(index)) return py::cast(part(trajectory, index));
  const py::ssize_t number = PyNumber_AsSsize_t(index.ptr(), PyExc_IndexError);
  if (number == -1 && PyErr_Occurred()) throw py::error_already_set();
  return item(trajectory, number);
}

struct VisitTrajectory {
  void operator()(auto& archive, auto& trajectory) const {
    archive.size(trajectory.poses);
    for (auto& pose : trajectory.poses) {
      archive.number(pose.stamp_s);
      visit_pose(archive, pose.world_from_camera);
    }
  }
};

py::list all_items(const py::object& self) {
  py::list pairs;
  for (const StampedPose& pose : self.cast<const PyTrajectory&>().poses) pairs.append(pair_of(pose));
  return pairs;
}

PyTrajectory read_poses(const std::filesystem::path& path) {
  TrajectoryFile file = without_gil([&](const std::stop_token&) { return read_tum_trajectory(path); });
  warn(file.warnings, path.string());
  return {std::move(file.trajectory)};
}

}  // namespace

void bind_trajectory(py::module_& module) {
  py::class_<PyTrajectory> type(module, "Trajectory", kTrajectoryDoc);
  type.def(py::init(&from_arrays), py::arg("stamps"), py::arg("poses"));
  type.def_property_readonly("stamps", &stamps, "(N,) float64, seconds: a new array.");
  type.def_property_readonly("poses", &poses, "(N, 4, 4) float64, T_world_camera: a new array.");
  type.def("__len__", [](const PyTrajectory& trajectory) { return trajectory.poses.size(); });
  type.def("__getitem__", &item_or_part, py::arg("index"));
  type.def("__iter__",
           [](const py::object& self) { return py::module_::import("builtins").attr("iter")(all_items(self)); });
  type.def(pickled<PyTrajectory>(VisitTrajectory{}));
  type.def("__repr__", [](const PyTrajectory& trajectory) {
    return "Trajectory(" + std::to_string(trajectory.poses.size()) + " poses)";
  });
  module.def(
      "read_trajectory", &read_poses, py::arg("path"),
      "The Trajectory in a file of the TUM benchmark's form: timestamp tx ty tz qx qy qz qw a line. Raises FileError.");
  module.def(
      "write_trajectory",
      [](const std::filesystem::path& path, const PyTrajectory& trajectory) {
        without_gil([&](const std::stop_token&) { write_tum_trajectory(path, trajectory.poses); });
      },
      py::arg("path"), py::arg("trajectory"),
      "Writes a Trajectory in that form, with every digit that is needed to read it back. Raises FileError.");
}

Trajectory trajectory_from(const py::object& given, const std::string& name) {
  if (py::isinstance<PyTrajectory>(given)) return given.cast<const PyTrajectory&>().poses;
  if (py::isinstance<py::str>(given) || py::hasattr(given, "__fspath__"))
    return read_poses(given.cast<std::filesystem::path>()).poses;
  throw WrongType(name + ": expected an augicp.Trajectory or the path of a file, found " +
                  py::repr(py::type::of(given)).cast<std::string>());
}

void warn(const std::vector<std::string>& warnings, const std::string& path) {
  for (const std::string& warning : warnings)
    if (PyErr_WarnEx(PyExc_UserWarning, (path.empty() ? warning : path + ": " + warning).c_str(), 1) != 0)
      throw py::error_already_set();
}

}  // namespace augicp::python
