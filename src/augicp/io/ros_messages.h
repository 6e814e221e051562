// SPDX-License-Identifier: MIT
// Messages of ROS 2, in CDR, for recordings.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "augicp/core/types.h"
#include "augicp/geometry/rigid3.h"
#include "augicp/io/cloud_file.h"

namespace augicp {

// A type of messages: its name as "sensor_msgs/msg/PointCloud2", and its definition with those of the types within, in
// the form "ros2msg" of MCAP.
struct RosType {
  std::string_view name;
  std::string definition;
};

RosType point_cloud2_type();
RosType tf_type();
RosType odometry_type();

struct StampedFrame {
  std::int64_t stamp_ns = 0;
  std::string frame;
};

// The points with their fields as a PointCloud2: positions as float if that keeps the cloud's details and else as
// double, and a grid as rows. Integers of 64 bits become double. Throws std::invalid_argument for a cloud without
// points or with more than 4 GiB.
std::string point_cloud2_message(const StampedFrame& header, const CloudFile& file);

// One transform, as tf2_msgs/TFMessage: the child's coordinates into those of the header's frame.
std::string tf_message(const StampedFrame& parent, const std::string& child, const Rigid3& parent_from_child);

// Of a frame, in its own axes: metres and radians per second.
struct Twist {
  Vec3d linear = Vec3d::Zero(), angular = Vec3d::Zero();
};

// nav_msgs/Odometry. covariance: of an increment on the left about the child's place, order tx ty tz rx ry rz, metres
// and radians; none is written as zeros, and so is the covariance of the twist.
std::string odometry_message(const StampedFrame& parent, const std::string& child, const Rigid3& parent_from_child,
                             const std::optional<Mat6d>& covariance, const Twist& twist = {});

}  // namespace augicp
