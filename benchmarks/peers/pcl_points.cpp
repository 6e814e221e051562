// SPDX-License-Identifier: MIT
#include "benchmarks/peers/pcl_points.h"

#include <pcl/features/normal_3d.h>
#include <pcl/filters/voxel_grid.h>

namespace augicp::peers {

Points::Ptr points_of(const Input& input) {
  auto points = std::make_shared<Points>();
  for (const Vec3f& p : input.cloud.points) points->emplace_back(p.x(), p.y(), p.z());
  return points;
}

Points::Ptr thinned(const Points::Ptr& points, float voxel) {
  auto result = std::make_shared<Points>();
  pcl::VoxelGrid<Point> grid;
  grid.setLeafSize(voxel, voxel, voxel);
  grid.setInputCloud(points);
  grid.filter(*result);
  return result;
}

Tree::Ptr tree_of(const Points::Ptr& points) {
  auto tree = std::make_shared<Tree>();
  tree->setInputCloud(points);
  return tree;
}

void add_normals(const Points::Ptr& points, const Tree::Ptr& tree, int num_neighbours) {
  pcl::NormalEstimation<Point, Point> estimation;
  estimation.setInputCloud(points);
  estimation.setSearchMethod(tree);
  estimation.setKSearch(num_neighbours);
  estimation.compute(*points);
}

}  // namespace augicp::peers
