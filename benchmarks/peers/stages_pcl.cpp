// SPDX-License-Identifier: MIT
// Stages of the Point Cloud Library (whose trees are FLANN's) beside those of augicp, in one run and on one thread.
#include <pcl/features/integral_image_normal.h>
#include <pcl/features/normal_3d.h>
#include <pcl/kdtree/kdtree_flann.h>

#include "augicp/search/kd_tree.h"
#include "benchmarks/stages/inputs.h"

namespace augicp::bench {
namespace {

using Points = pcl::PointCloud<pcl::PointXYZ>;

constexpr auto kMs = benchmark::kMillisecond;
constexpr std::size_t kPoints = 300000;       // in the images' raster order
const Vec3f kShift(0.004f, -0.003f, 0.005f);  // of the queries from the points

Points::Ptr in_pcl(const Cloud& cloud) {
  auto points = pcl::make_shared<Points>();
  for (const Vec3f& point : cloud.points) points->emplace_back(point.x(), point.y(), point.z());
  return points;
}

void build_augicp(benchmark::State& state) {
  const Cloud cloud = cloud_of(kPoints);
  for (auto _ : state) benchmark::DoNotOptimize(KdTree(cloud));
}
BENCHMARK(build_augicp)->Unit(kMs);

void build_flann(benchmark::State& state) {
  const Points::Ptr points = in_pcl(cloud_of(kPoints));
  for (auto _ : state) {
    pcl::KdTreeFLANN<pcl::PointXYZ> tree;
    tree.setInputCloud(points);
    benchmark::DoNotOptimize(tree);
  }
}
BENCHMARK(build_flann)->Unit(kMs);

void query_augicp(benchmark::State& state) {
  const Cloud cloud = cloud_of(kPoints);
  const KdTree tree(cloud);
  const auto count = static_cast<std::size_t>(state.range(0));
  for (auto _ : state)
    for (const Vec3f& point : cloud.points) benchmark::DoNotOptimize(tree.nearest_k(point + kShift, count));
}
BENCHMARK(query_augicp)->ArgName("neighbours")->Arg(1)->Arg(20)->Unit(kMs);

void query_flann(benchmark::State& state) {
  const Points::Ptr points = in_pcl(cloud_of(kPoints));
  pcl::KdTreeFLANN<pcl::PointXYZ> tree;
  tree.setInputCloud(points);
  pcl::Indices indices;
  std::vector<float> distances_sq;
  for (auto _ : state)
    for (pcl::PointXYZ query : *points) {
      query.getVector3fMap() += kShift;
      benchmark::DoNotOptimize(tree.nearestKSearch(query, static_cast<int>(state.range(0)), indices, distances_sq));
    }
}
BENCHMARK(query_flann)->ArgName("neighbours")->Arg(1)->Arg(20)->Unit(kMs);

// From points in a grid to normals and curvatures.
void normals_pcl(benchmark::State& state) {
  const OrganizedCloud seen = points(0);
  Points::Ptr organized = pcl::make_shared<Points>(seen.index.width, seen.index.height);
  for (std::size_t pixel = 0; pixel < seen.index.index.size(); ++pixel) {
    constexpr float kNothing = std::numeric_limits<float>::quiet_NaN();
    const std::int32_t i = seen.index.index[pixel];
    const Vec3f point = i == IndexImage::kNone ? Vec3f::Constant(kNothing) : seen.cloud.points[i];
    (*organized)[pixel].getVector3fMap() = point;
  }
  pcl::IntegralImageNormalEstimation<pcl::PointXYZ, pcl::Normal> normals;
  normals.setNormalEstimationMethod(normals.COVARIANCE_MATRIX);
  normals.setNormalSmoothingSize(10.0f);
  normals.setInputCloud(organized);
  pcl::PointCloud<pcl::Normal> found;
  for (auto _ : state) {
    normals.setInputCloud(organized);  // its integral images are part of the work
    normals.compute(found);
  }
}
BENCHMARK(normals_pcl)->Unit(kMs);

}  // namespace
}  // namespace augicp::bench
