// SPDX-License-Identifier: MIT
// All that users of the library need. Headers that this one includes, directly or not, are the public ones: they are
// installed, and no others.
#pragma once

#include "augicp/align/align.h"
#include "augicp/align/damped_step.h"
#include "augicp/cloud/voxel_grid.h"
#include "augicp/eval/evaluate.h"
#include "augicp/eval/pair_errors.h"
#include "augicp/eval/segment_errors.h"
#include "augicp/io/camera_file.h"
#include "augicp/io/depth_png.h"
#include "augicp/io/depth_sequence.h"
#include "augicp/io/grey_png.h"
#include "augicp/io/pose_file.h"
#include "augicp/io/read_cloud.h"
#include "augicp/io/reference_pairs_file.h"
#include "augicp/io/scan_sequence.h"
#include "augicp/io/trajectory_file.h"
#include "augicp/io/transform_file.h"
#include "augicp/io/write_cloud.h"
#include "augicp/odometry/lidar_odometry.h"
#include "augicp/odometry/track.h"
#include "augicp/registration/registration.h"
#include "augicp/surface/ball_neighbourhood.h"
#include "augicp/surface/estimate_surface.h"
