// SPDX-License-Identifier: MIT
// Clouds in PCL's types, and what its registrations want to have of them.
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>

#include "benchmarks/peers/common/method.h"

namespace augicp::peers {

using Point = pcl::PointNormal;
using Points = pcl::PointCloud<Point>;
using Tree = pcl::search::KdTree<Point>;

Points::Ptr points_of(const Input& input);

// One point a voxel: the mean of those in it.
Points::Ptr thinned(const Points::Ptr& points, float voxel);

Tree::Ptr tree_of(const Points::Ptr& points);

// Normals from the neighbours in the tree, turned to the origin, where the sensor is.
void add_normals(const Points::Ptr& points, const Tree::Ptr& tree, int num_neighbours);

}  // namespace augicp::peers
