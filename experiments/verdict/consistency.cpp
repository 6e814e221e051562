// SPDX-License-Identifier: MIT
// Whether the covariance tells the errors there are: the mean of the normalised error squared over six, 1 where it
// does, for generated scenes seen with a Kinect's noise.
//
//   consistency NUM_RUNS [COLUMNS]
#include <fmt/core.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <string>
#include <vector>

#include "augicp/registration/registration.h"
#include "augicp/testing/poses.h"
#include "augicp/testing/room_pair.h"
#include "augicp/testing/scenes.h"

namespace {

using namespace augicp;

AlignResult noisy(const testing::Scene& scene, const Rigid3& motion, int num_columns, unsigned seed, bool as_clouds) {
  const Rigid3& place = scene.world_from_camera;
  const Scan source = testing::noisy_view(scene, place * motion, 2 * seed + 1, num_columns);
  const Scan target = testing::noisy_view(scene, place, 2 * seed + 2, num_columns);
  return as_clouds ? register_scans(scan_of(source.cloud), scan_of(target.cloud)).result
                   : register_scans(source, target).result;
}

struct Consistency {
  int num_runs = 0;
  double nees = 0.0;             // over six, mean
  double spread_per_told = 0.0;  // the same of the errors about their mean
  Vec6d bias = Vec6d::Zero(), deviation = Vec6d::Zero(), told = Vec6d::Zero();
};

Consistency consistency_of(const std::vector<Vec6d>& errors, const std::vector<Mat6d>& covariances) {
  Consistency sums{.num_runs = static_cast<int>(errors.size())};
  Mat6d told = Mat6d::Zero(), spread = Mat6d::Zero();
  for (std::size_t k = 0; k < errors.size(); ++k) {
    sums.nees += errors[k].dot(covariances[k].ldlt().solve(errors[k])) / 6.0 / sums.num_runs;
    sums.bias += errors[k] / sums.num_runs;
    told += covariances[k] / sums.num_runs;
  }
  for (const Vec6d& error : errors)
    spread += (error - sums.bias) * (error - sums.bias).transpose() / (sums.num_runs - 1);
  sums.spread_per_told = told.ldlt().solve(spread).trace() / 6.0;
  sums.deviation = spread.diagonal().cwiseSqrt();
  sums.told = told.diagonal().cwiseSqrt();
  return sums;
}

Consistency run(const testing::Scene& scene, const Rigid3& motion, int num_runs, int num_columns, bool as_clouds) {
  std::vector<Vec6d> errors;
  std::vector<Mat6d> covariances;
  for (int k = 0; k < num_runs; ++k) {
    const AlignResult result = noisy(scene, motion, num_columns, static_cast<unsigned>(k), as_clouds);
    if (!result.covariance) continue;
    errors.push_back(increment_between(motion, result.target_from_source));
    covariances.push_back(*result.covariance);
  }
  return consistency_of(errors, covariances);
}

void print_row(const std::string& name, bool as_clouds, const Consistency& sums) {
  constexpr double kDegrees = 180.0 / std::numbers::pi;
  const auto lengths = [](const Vec6d& of) {
    return fmt::format("{:.2f} mm, {:.3f} deg", 1e3 * of.head<3>().norm(), kDegrees * of.tail<3>().norm());
  };
  fmt::print("| {} | {} | {} | {:.2f} | {:.2f} | {} | {} | {} |\n", name, as_clouds ? "clouds" : "images",
             sums.num_runs, sums.nees, sums.spread_per_told, lengths(sums.bias), lengths(sums.deviation),
             lengths(sums.told));
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const int num_runs = argc > 1 ? std::atoi(argv[1]) : 100, num_columns = argc > 2 ? std::atoi(argv[2]) : 120;
  fmt::print(
      "| scene | as | covariances | NEES / 6 | of the spread | bias | spread | what the covariance says |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- |\n");
  const std::pair<std::string, testing::Scene> scenes[] = {{"room 1", testing::room(1)},
                                                           {"room 2", testing::room(2)},
                                                           {"room 5", testing::room(5)},
                                                           {"room 9", testing::room(9)},
                                                           {"hall", testing::room(3, {9.0, 7.0, 3.2})},
                                                           {"room's corner", testing::room_corner()}};
  std::mt19937 generator(7);
  for (const auto& [name, scene] : scenes) {
    const Rigid3 motion = testing::random_motion(generator, 0.05, 0.05);
    for (const bool as_clouds : {false, true})
      print_row(name, as_clouds, run(scene, motion, num_runs, num_columns, as_clouds));
  }
}
