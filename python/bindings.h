// SPDX-License-Identifier: MIT
// One function for each file that adds to the module; a type is added before what takes or returns it.
#pragma once

#include <pybind11/pybind11.h>

namespace augicp::python {

void bind_errors(pybind11::module_& module);          // augicp.Error and what derives from it
void bind_words(pybind11::module_& module);           // Status, FrameStatus, Doubt, MotionKind
void bind_camera(pybind11::module_& module);          // Camera
void bind_cloud(pybind11::module_& module);           // Cloud
void bind_depth(pybind11::module_& module);           // read_depth, write_depth
void bind_trajectory(pybind11::module_& module);      // Trajectory
void bind_evidence(pybind11::module_& module);        // Evidence and what is in it
void bind_result(pybind11::module_& module);          // Result, Iteration
void bind_align(pybind11::module_& module);           // align
void bind_surface(pybind11::module_& module);         // estimate_surface
void bind_files(pybind11::module_& module);           // read, write, transforms, trajectories
void bind_sequence(pybind11::module_& module);        // DepthSequence
void bind_scans(pybind11::module_& module);           // ScanSequence
void bind_frame(pybind11::module_& module);           // Frame
void bind_lidar_odometry(pybind11::module_& module);  // LidarOdometry
void bind_odometry(pybind11::module_& module);        // Odometry
void bind_evaluate(pybind11::module_& module);        // evaluate, Evaluation

}  // namespace augicp::python
