// SPDX-License-Identifier: MIT
// The Point Cloud Library's ICP, ICP with normals, generalised ICP and NDT. README.md gives reasons for the settings.
#include <pcl/console/print.h>
#include <pcl/registration/gicp.h>
#include <pcl/registration/icp.h>
#include <pcl/registration/ndt.h>

#include <map>

#include "benchmarks/peers/common/pose.h"
#include "benchmarks/peers/common/run_peer.h"
#include "benchmarks/peers/pcl_points.h"

namespace augicp::peers {
namespace {

constexpr int kNeighbours = 20;  // of normals: what PCL's GICP takes for its covariances
constexpr int kMaxIterations = 100;
constexpr double kSquaredStep = 1e-8;  // PCL compares its "epsilon" with the squared step: 0.1 mm

// Lengths in metres.
struct Settings {
  float voxel;
  double max_distance;
  double max_distance_gicp;
  double gicp_gradient;  // ends its inner solver; PCL's 0.01 ends it at once on something as small as the bunny
  float ndt_cell;
  double ndt_step;
};
const std::map<std::string, Settings> kSettings{{"depth", {0.02f, 0.1, 0.1, 0.01, 0.25f, 0.3}},
                                                {"lidar", {0.25f, 1.0, 3.0, 0.01, 2.0f, 0.6}},
                                                {"car", {0.25f, 5.0, 5.0, 0.01, 4.0f, 1.0}},
                                                {"redkitchen", {0.05f, 0.1, 0.5, 0.01, 0.5f, 0.3}},
                                                {"bunny", {0.002f, 0.01, 0.05, 1e-4, 0.02f, 0.02}}};

const Settings& settings_for(const Pair& pair) { return kSettings.at(pair.scene); }

// What PCL keeps to itself.
template <typename Registration>
struct Opened : Registration {
  using Registration::nr_iterations_;
};

struct OpenedGicp : Opened<pcl::GeneralizedIterativeClosestPoint<Point, Point>> {
  // Done within align() otherwise, though it does not depend on the guess.
  void compute_both_covariances() {
    input_covariances_ = std::make_shared<MatricesVector>();
    computeCovariances<Point>(input_, tree_reciprocal_, *input_covariances_);
    target_covariances_ = std::make_shared<MatricesVector>();
    computeCovariances<Point>(target_, tree_, *target_covariances_);
  }
};

template <typename Registration>
void give_clouds(Registration& registration, const Points::Ptr& source, const Points::Ptr& target) {
  registration.setInputSource(source);
  registration.setSearchMethodSource(tree_of(source), true);
  registration.setInputTarget(target);
  registration.setSearchMethodTarget(tree_of(target), true);
  registration.setMaximumIterations(kMaxIterations);
}

template <typename Registration>
Found align(Registration& registration, const Rigid3& guess, Stopwatch& watch) {
  Found found;
  found.preprocess_ms = watch.lap_ms();
  Points moved;
  registration.align(moved, guess.matrix().cast<float>());
  found.align_ms = watch.lap_ms();
  found.target_from_source = rigid_or_nothing(registration.getFinalTransformation().template cast<double>());
  found.verdict = registration.hasConverged() ? "converged" : "not converged";
  found.score = registration.getFitnessScore();
  found.iterations = registration.nr_iterations_;
  return found;
}

template <typename Icp>
Found run_icp(const Pair& pair, bool with_normals) {
  const Settings& settings = settings_for(pair);
  const Points::Ptr raw_source = points_of(pair.source), raw_target = points_of(pair.target);
  Stopwatch watch;
  const Points::Ptr source = thinned(raw_source, settings.voxel), target = thinned(raw_target, settings.voxel);
  Opened<Icp> icp;
  give_clouds(icp, source, target);
  if (with_normals) {
    add_normals(source, icp.getSearchMethodSource(), kNeighbours);
    add_normals(target, icp.getSearchMethodTarget(), kNeighbours);
  }
  icp.setMaxCorrespondenceDistance(settings.max_distance);
  icp.setTransformationEpsilon(kSquaredStep);
  return align(icp, pair.guess, watch);
}

Found run_gicp(const Pair& pair) {
  const Settings& settings = settings_for(pair);
  const Points::Ptr raw_source = points_of(pair.source), raw_target = points_of(pair.target);
  Stopwatch watch;
  OpenedGicp gicp;
  give_clouds(gicp, thinned(raw_source, settings.voxel), thinned(raw_target, settings.voxel));
  gicp.compute_both_covariances();
  gicp.setTranslationGradientTolerance(settings.gicp_gradient);
  gicp.setRotationGradientTolerance(settings.gicp_gradient);
  gicp.setMaxCorrespondenceDistance(settings.max_distance_gicp);
  return align(gicp, pair.guess, watch);
}

// Cells want many points, so the target is not thinned.
Found run_ndt(const Pair& pair) {
  const Settings& settings = settings_for(pair);
  const Points::Ptr raw_source = points_of(pair.source), raw_target = points_of(pair.target);
  Stopwatch watch;
  Opened<pcl::NormalDistributionsTransform<Point, Point>> ndt;
  ndt.setResolution(settings.ndt_cell);
  ndt.setStepSize(settings.ndt_step);
  give_clouds(ndt, thinned(raw_source, settings.voxel), raw_target);
  ndt.setTransformationEpsilon(kSquaredStep);
  return align(ndt, pair.guess, watch);
}

Found run_point_to_point(const Pair& pair) { return run_icp<pcl::IterativeClosestPoint<Point, Point>>(pair, false); }

Found run_point_to_plane(const Pair& pair) {
  return run_icp<pcl::IterativeClosestPointWithNormals<Point, Point>>(pair, true);
}

}  // namespace
}  // namespace augicp::peers

int main(int argc, char** argv) {
  using namespace augicp::peers;
  // Far starts make it print a line for each cell.
  pcl::console::setVerbosityLevel(pcl::console::L_ALWAYS);
  const Peer peer{
      "pcl",
      1,
      {{"ICP", run_point_to_point}, {"ICPWithNormals", run_point_to_plane}, {"GICP", run_gicp}, {"NDT", run_ndt}}};
  return run_peer(argc, argv, peer);
}
