// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include <string>

#include "augicp/geometry/trajectory.h"

namespace augicp::python {

// Python's augicp.Trajectory. Poses keep their quaternions, so that writing gives the numbers that were read.
struct PyTrajectory {
  Trajectory poses;
};

// An augicp.Trajectory, or the path of one in TUM's form. Throws WrongType or IoError; name is that of the argument.
Trajectory trajectory_from(const pybind11::object& given, const std::string& name);

// One Python warning each, behind the path unless that is empty.
void warn(const std::vector<std::string>& warnings, const std::string& path);

}  // namespace augicp::python
