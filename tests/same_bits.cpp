// SPDX-License-Identifier: MIT
// Prints what every function that is compiled more than once (core/vectorized.h) makes of a generated pair of images,
// bit by bit. Built twice, with and without the versions for newer machines; both must print the same.
#include <bit>
#include <cstdint>
#include <cstdio>
#include <string>

#include "augicp/cloud/voxel_grid.h"
#include "augicp/match/matcher.h"
#include "augicp/objective/linearize.h"
#include "augicp/sensor/depth_camera.h"
#include "augicp/surface/ball_neighbourhood.h"
#include "augicp/surface/estimate_surface.h"
#include "augicp/surface/window_surface.h"
#include "augicp/testing/rendering.h"
#include "augicp/testing/scenes.h"

namespace {

using namespace augicp;

// FNV-1a over the bits of numbers.
class Hash {
 public:
  void add(std::uint64_t bits) {
    for (int byte = 0; byte < 8; ++byte) hash_ = (hash_ ^ ((bits >> (8 * byte)) & 0xff)) * 0x100000001b3u;
  }
  void add(double value) { add(std::bit_cast<std::uint64_t>(value)); }
  void print(const std::string& name) const {
    std::printf("%s %016llx\n", name.c_str(), static_cast<unsigned long long>(hash_));
  }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325u;
};

void print(const std::string& name, const Cloud& cloud) {
  Hash hash;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    hash.add(static_cast<std::uint64_t>(cloud.structures[i]));
    for (const float number : cloud.directions[i]) hash.add(static_cast<double>(number));
  }
  hash.print(name);
}

void print(const std::string& name, const NormalEquations& equations) {
  Hash hash;
  for (const double number : equations.H.reshaped()) hash.add(number);
  for (const double number : equations.b) hash.add(number);
  hash.add(equations.cost);
  hash.print(name);
}

}  // namespace

int main() {
  testing::Rendering seen = testing::render(testing::box_on_table(), testing::kinect_like_camera(320));
  testing::add_depth_noise(seen.depth, testing::kKinectSigmaAt1m, 1);
  const DepthCamera camera{seen.camera, {0.26, -0.95, -0.005, 0.003, 1.16}};
  OrganizedCloud target = unproject(rectify(seen.depth, camera), seen.camera);
  OrganizedCloud source = unproject(seen.depth, seen.camera);
  WindowOptions window;
  window.radius = 0.05;
  for (OrganizedCloud* image : {&target, &source}) estimate_surface(image->cloud, image->index, window, {}, 1);
  print("target", target.cloud);
  print("source", source.cloud);
  Cloud bare = evenly_chosen(source.cloud, 5000);
  estimate_surface(bare, BallNeighbourhood(bare, {0.1}, 1), {}, 1);
  print("bare source", bare);
  const ProjectiveMatcher matcher(target.cloud, target.index, seen.camera);
  const Rigid3 pose{Eigen::Quaterniond(Eigen::AngleAxisd(0.02, Vec3d(0.6, 0.0, 0.8))), Vec3d(0.01, -0.02, 0.005)};
  const auto pairs = matcher.match(source.cloud, pose, {}, 1);
  std::printf("pairs %zu\n", pairs.size());
  const Objective objective{with_lever(default_information(), 0.05), 0.5, 0.05};
  print("equations", linearize({source.cloud, target.cloud, pairs, pose}, objective, 1));
  Hash chi2;
  for (const float part : chi2_of_pairs({source.cloud, target.cloud, pairs, pose}, objective.information, 1).position)
    chi2.add(static_cast<double>(part));
  chi2.print("chi2");
}
