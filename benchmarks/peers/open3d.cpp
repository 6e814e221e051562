// SPDX-License-Identifier: MIT
// Open3D's point-to-plane and generalised ICP. README.md gives reasons for the settings.
#include <omp.h>
#include <open3d/geometry/PointCloud.h>
#include <open3d/pipelines/registration/GeneralizedICP.h>
#include <open3d/pipelines/registration/Registration.h>

#include <map>

#include "benchmarks/peers/common/pose.h"
#include "benchmarks/peers/common/run_peer.h"

namespace augicp::peers {
namespace {

namespace registration = open3d::pipelines::registration;
using Points = open3d::geometry::PointCloud;

// Lengths in metres.
struct Settings {
  double voxel;
  double max_distance;
  double max_distance_gicp;
};
const std::map<std::string, Settings> kSettings{{"depth", {0.02, 0.1, 0.1}},
                                                {"lidar", {0.25, 1.0, 5.0}},
                                                {"car", {0.25, 2.0, 5.0}},
                                                {"redkitchen", {0.05, 0.1, 0.5}},
                                                {"bunny", {0.002, 0.01, 0.01}}};

registration::ICPConvergenceCriteria criteria() {
  registration::ICPConvergenceCriteria criteria;
  criteria.max_iteration_ = 100;
  return criteria;
}

Points points_of(const Input& input) {
  Points points;
  for (const Vec3f& p : input.cloud.points) points.points_.push_back(p.cast<double>());
  return points;
}

// Generalised ICP takes its covariances from the normals.
std::shared_ptr<Points> prepared(const Points& points, double voxel) {
  std::shared_ptr<Points> thinned = points.VoxelDownSample(voxel);
  thinned->EstimateNormals();
  return thinned;
}

registration::RegistrationResult point_to_plane(const Points& source, const Points& target, const Mat4d& guess,
                                                const Settings& settings) {
  return registration::RegistrationICP(source, target, settings.max_distance, guess,
                                       registration::TransformationEstimationPointToPlane(), criteria());
}

registration::RegistrationResult gicp(const Points& source, const Points& target, const Mat4d& guess,
                                      const Settings& settings) {
  return registration::RegistrationGeneralizedICP(source, target, settings.max_distance_gicp, guess,
                                                  registration::TransformationEstimationForGeneralizedICP(),
                                                  criteria());
}

template <typename Register>
Found run(const Pair& pair, const Register& register_points) {
  const Settings& settings = kSettings.at(pair.scene);
  const Points raw_source = points_of(pair.source), raw_target = points_of(pair.target);
  Found found;
  Stopwatch watch;
  const auto source = prepared(raw_source, settings.voxel), target = prepared(raw_target, settings.voxel);
  found.preprocess_ms = watch.lap_ms();
  const auto result = register_points(*source, *target, pair.guess.matrix(), settings);
  found.align_ms = watch.lap_ms();
  found.target_from_source = rigid_or_nothing(result.transformation_);
  found.score = result.fitness_;
  return found;
}

}  // namespace
}  // namespace augicp::peers

int main(int argc, char** argv) {
  using namespace augicp::peers;
  omp_set_num_threads(1);
  const Peer peer{"open3d",
                  1,
                  {{"PointToPlane", [](const Pair& pair) { return run(pair, point_to_plane); }},
                   {"GeneralizedICP", [](const Pair& pair) { return run(pair, gicp); }}}};
  return run_peer(argc, argv, peer);
}
