// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/core/option.h"
#include "augicp/odometry/lidar_odometry.h"

namespace augicp {

// Every option of LiDAR odometry, see core/option.h.
template <OptionsOf<LidarOptions> Options, typename Visit>
void for_each_option(Options& options, const Visit& visit) {
  constexpr std::string_view kGroup = "LiDAR";
  using enum Unit;
  visit({"voxel_size", Metres, kGroup, "Edge length of the map's voxels", "a part of the first scan's extent"},
        options.voxel_size);
  visit({"keyframe_distance_voxels", None, kGroup, "A scan this far from the last keyframe is the next one, voxels"},
        options.keyframe_distance_voxels);
  visit({"keyframe_angle", Radians, kGroup, "So is a scan turned this much"}, options.keyframe_angle);
  visit({"reach_voxels", None, kGroup, "The map keeps what is within this distance of the sensor, voxels"},
        options.reach_voxels);
  visit({"remove_seen_through", None, kGroup, "Surfaces that a keyframe sees through leave the map"},
        options.remove_seen_through);
  visit({"gate_voxels", None, kGroup, "Least gate on the distance between a point and a voxel's mean, voxels"},
        options.gate_voxels);
  visit({"on_surface_voxels", None, kGroup, "A point counts as on a surface that is nearer than this, voxels"},
        options.on_surface_voxels);
  visit({"deskew", None, kGroup, "Sweeps are straightened unless the first ones show that they are straight"},
        options.deskew);
  visit({"pose_at", None, kGroup, "The moment of a sweep to which its pose refers"}, options.pose_at);
  visit({"sweep_s", Seconds, kGroup, "How long a sweep takes; 0: the shortest time between two scans"},
        options.sweep_s);
  visit({"search", None, kGroup, "The pose is searched for where the prediction does not convince"}, options.search);
  visit({"min_observability", None, kGroup, "Degenerate below this part of the best direction's information"},
        options.min_observability);
  visit({"min_agreement", None, kGroup, "Doubtful below this part of the usual share of points on surfaces"},
        options.min_agreement);
  visit({"check_every", None, kGroup, "Every N-th scan is checked against a keyframe farther back; 0: none"},
        options.check_every);
  visit({"check_distance_voxels", None, kGroup, "This keyframe is about this far back, voxels"},
        options.check_distance_voxels);
  visit({"max_lost", None, kGroup, "A new segment starts after this number of lost or doubtful scans in a row"},
        options.max_lost);
  visit({"max_memory_gb", Gigabytes, kGroup, "Scans whose map would need more memory are refused beforehand",
         "half of the machine's"},
        options.max_memory_gb);
  visit({"covariance", None, kGroup, "Each tracked scan has the covariance of its pose"}, options.covariance);
  visit({"threads", None, kGroup, "Number of threads; 0: all"}, options.num_threads);
}

}  // namespace augicp
