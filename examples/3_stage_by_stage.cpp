// SPDX-License-Identifier: MIT
// The stages one by one, for users who replace one: stages pass plain values.
#include <algorithm>
#include <iostream>

#include "augicp/augicp.h"

namespace {

constexpr int kNumThreads = 1;

augicp::Cloud extended_points(const char* path) {
  augicp::Cloud cloud = augicp::downsample(augicp::read_cloud(path).cloud, 0.03);
  const augicp::BallNeighbourhood balls(cloud, {.radius = 0.1}, kNumThreads);
  augicp::estimate_surface(cloud, balls, {}, kNumThreads);
  return cloud;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: example_3_stage_by_stage SOURCE TARGET\n";
    return 2;
  }
  const augicp::Cloud source = extended_points(argv[1]), target = extended_points(argv[2]);
  const augicp::NearestMatcher matcher(target);
  augicp::Gates gates{.max_distance = 1.0};
  const augicp::Objective objective{.information = augicp::default_information(), .kernel_chi2 = 100.0};

  // Between the clouds' points, without their origins; both are zero here.
  augicp::Rigid3 target_from_source;
  for (int iteration = 0; iteration < 50; ++iteration) {
    const auto pairs = matcher.match(source, target_from_source, gates, kNumThreads);
    const auto equations = augicp::linearize({source, target, pairs, target_from_source}, objective, kNumThreads);
    const augicp::Vec6d step = augicp::damped_step(equations, /*damping=*/1e-6);
    target_from_source = augicp::retract(target_from_source, step);
    gates.max_distance = std::max(0.1, 0.9 * gates.max_distance);  // closes as the clouds meet
    std::cout << pairs.size() << " pairs, cost " << equations.cost << ", step " << step.norm() << "\n";
    if (step.norm() < 1e-3) {
      std::cout << "converged\n" << target_from_source.matrix() << "\n";
      return 0;
    }
  }
  return 1;
}
