// SPDX-License-Identifier: MIT
// Whether the covariance tells the errors there are: the mean of the normalised error squared over six, 1 where it
// does, for generated scenes seen with a Kinect's noise.
//
//   consistency NUM_RUNS [COLUMNS]
#include <fmt/core.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <cstdlib>
#include <string>

#include "augicp/registration/registration.h"
#include "augicp/testing/poses.h"
#include "augicp/testing/room_pair.h"
#include "augicp/testing/scenes.h"

namespace {

using namespace augicp;

AlignResult noisy(const testing::Scene& scene, const Rigid3& target_from_source, int num_columns, unsigned seed,
                  bool as_clouds) {
  const Rigid3& place = scene.world_from_camera;
  const Scan source = testing::noisy_view(scene, place * target_from_source, 2 * seed + 1, num_columns);
  const Scan target = testing::noisy_view(scene, place, 2 * seed + 2, num_columns);
  return as_clouds ? register_scans(scan_of(source.cloud), scan_of(target.cloud)) : register_scans(source, target);
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

Consistency consistency_of(const testing::Scene& scene, int num_runs, int num_columns, bool as_clouds) {
  std::mt19937 generator(7);
  const Rigid3 truth = testing::random_motion(generator, 0.05, 0.05);
  Consistency sums;
  for (int k = 0; k < num_runs; ++k) {
    const AlignResult result = noisy(scene, truth, num_columns, static_cast<unsigned>(k), as_clouds);
    if (result.covariance) sums.add(increment_between(truth, result.target_from_source), *result.covariance);
  }
  return sums;
}

void print_row(const std::string& name, bool as_clouds, const Consistency& sums) {
  const auto mean_root = [&](double sum) { return std::sqrt(sum / sums.num_runs); };
  constexpr double kDegrees = 180.0 / 3.14159265358979323846;
  fmt::print("| {} | {} | {} | {:.2f} | {:.2f} mm, {:.3f} deg | {:.2f} mm, {:.3f} deg |\n", name,
             as_clouds ? "clouds" : "images", sums.num_runs, sums.normalised / sums.num_runs,
             1e3 * mean_root(sums.translation_sq), kDegrees * mean_root(sums.rotation_sq),
             1e3 * mean_root(sums.told_translation_sq), kDegrees * mean_root(sums.told_rotation_sq));
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const int num_runs = argc > 1 ? std::atoi(argv[1]) : 100, num_columns = argc > 2 ? std::atoi(argv[2]) : 120;
  fmt::print(
      "| scene | as | covariances | NEES / 6 | error (RMS) | what the covariance says |\n| --- | --- | --- | --- | --- "
      "| --- |\n");
  const std::pair<std::string, testing::Scene> scenes[] = {{"room 1", testing::room(1)},
                                                           {"room 2", testing::room(2)},
                                                           {"room 5", testing::room(5)},
                                                           {"room 9", testing::room(9)},
                                                           {"hall", testing::room(3, {9.0, 7.0, 3.2})},
                                                           {"room's corner", testing::room_corner()}};
  for (const auto& [name, scene] : scenes)
    for (const bool as_clouds : {false, true})
      print_row(name, as_clouds, consistency_of(scene, num_runs, num_columns, as_clouds));
}
