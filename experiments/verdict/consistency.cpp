// SPDX-License-Identifier: MIT
// Whether the covariance tells the errors there are: the mean of the normalised error squared over six, 1 where it does,
// for generated scenes seen with a Kinect's noise.
//
//   consistency NUM_RUNS [COLUMNS]
#include <fmt/core.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <cstdlib>
#include <string>

#include "augicp/registration/registration.h"
#include "augicp/testing/poses.h"
#include "augicp/testing/rendering.h"
#include "augicp/testing/scenes.h"

namespace {

using namespace augicp;

struct Views {
  Pinhole camera;
  DepthImage source, target;
  Rigid3 target_from_source;
};

Views views_of(const testing::Scene& scene, int num_columns) {
  Views views{testing::kinect_like_camera(num_columns), {}, {}, {}};
  std::mt19937 generator(7);
  views.target_from_source = testing::random_motion(generator, 0.05, 0.05);
  const Rigid3& place = scene.world_from_camera;
  const Pinhole& camera = views.camera;
  views.target = testing::render(scene, camera, camera.width, camera.height, place).depth;
  views.source = testing::render(scene, camera, camera.width, camera.height, place * views.target_from_source).depth;
  return views;
}

AlignResult noisy(const Views& views, unsigned seed, bool as_clouds) {
  DepthImage source = views.source, target = views.target;
  testing::add_depth_noise(source, testing::kKinectSigmaAt1m, 2 * seed + 1);
  testing::add_depth_noise(target, testing::kKinectSigmaAt1m, 2 * seed + 2);
  const Scan from = scan_of(source, views.camera), to = scan_of(target, views.camera);
  return as_clouds ? register_scans(scan_of(from.cloud), scan_of(to.cloud)) : register_scans(from, to);
}

// Sums over the runs.
struct Consistency {
  int num_runs = 0;
  double normalised = 0.0, translation_sq = 0.0, rotation_sq = 0.0, told_translation_sq = 0.0, told_rotation_sq = 0.0;

  void add(const Vec6d& error, const Mat6d& covariance) {
    ++num_runs;
    normalised += error.dot(covariance.ldlt().solve(error)) / 6.0;
    translation_sq += error.head<3>().squaredNorm();
    rotation_sq += error.tail<3>().squaredNorm();
    told_translation_sq += covariance.topLeftCorner<3, 3>().trace();
    told_rotation_sq += covariance.bottomRightCorner<3, 3>().trace();
  }
};

Consistency consistency_of(const Views& views, int num_runs, bool as_clouds) {
  Consistency sums;
  for (int k = 0; k < num_runs; ++k) {
    const AlignResult result = noisy(views, static_cast<unsigned>(k), as_clouds);
    if (result.covariance) sums.add(increment_between(views.target_from_source, result.target_from_source), *result.covariance);
  }
  return sums;
}

void print_row(const std::string& name, bool as_clouds, const Consistency& sums) {
  const auto mean_root = [&](double sum) { return std::sqrt(sum / sums.num_runs); };
  constexpr double kDegrees = 180.0 / 3.14159265358979323846;
  fmt::print("| {} | {} | {} | {:.2f} | {:.2f} mm, {:.3f} deg | {:.2f} mm, {:.3f} deg |\n", name, as_clouds ? "clouds" : "images",
             sums.num_runs, sums.normalised / sums.num_runs, 1e3 * mean_root(sums.translation_sq),
             kDegrees * mean_root(sums.rotation_sq), 1e3 * mean_root(sums.told_translation_sq),
             kDegrees * mean_root(sums.told_rotation_sq));
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const int num_runs = argc > 1 ? std::atoi(argv[1]) : 100, num_columns = argc > 2 ? std::atoi(argv[2]) : 120;
  fmt::print("| scene | as | covariances | NEES / 6 | error (RMS) | what the covariance says |\n| --- | --- | --- | --- | --- | --- |\n");
  const std::pair<std::string, testing::Scene> scenes[] = {
      {"room 1", testing::room(1)}, {"room 2", testing::room(2)},          {"room 5", testing::room(5)},
      {"room 9", testing::room(9)}, {"room's corner", testing::room_corner()}, {"box on a table", testing::box_on_table()}};
  for (const auto& [name, scene] : scenes)
    for (const bool as_clouds : {false, true})
      print_row(name, as_clouds, consistency_of(views_of(scene, num_columns), num_runs, as_clouds));
}
