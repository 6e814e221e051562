// SPDX-License-Identifier: MIT
// How often shapes that leave a motion open are called degenerate, with which motions, and how well the rest is found.
//
//   degenerate NUM_RUNS
#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "augicp/registration/registration.h"
#include "augicp/testing/degenerate_families.h"
#include "augicp/testing/poses.h"

namespace {

using namespace augicp;
using testing::DegenerateFamily;

constexpr std::size_t kNumPoints = 8000;
constexpr double kDegree = 3.14159265358979323846 / 180.0;

struct Run {
  bool is_degenerate = false, right_number = false;
  double angle_rad = 0.0;   // of the free motions found to those there are
  double held_error = 0.0;  // metres: what is left of the motion along the held directions, turns by the gyration
};

Run run(const DegenerateFamily& family, double noise, unsigned seed) {
  std::mt19937 generator(seed);
  const Rigid3 motion = testing::random_motion(generator, 0.03, 0.03);
  const Cloud target = testing::draw(family, kNumPoints, noise, generator);
  const Cloud source = transform(testing::draw(family, kNumPoints, noise, generator), inverse(motion));
  const AlignResult result = register_scans(scan_of(source), scan_of(target)).result;
  Run run{result.status == AlignStatus::Degenerate, result.free_motions.size() == family.free_motions.size()};
  const Observability& seen = result.observability;
  std::vector<Vec6d> found;
  for (std::size_t k = 0; k < result.free_motions.size(); ++k)
    found.push_back(seen.directions.col(static_cast<Eigen::Index>(k)));
  run.angle_rad = testing::angle_to_free(family, found, seen.gyration, seen.centroid);
  // What is left, without its part along the free motions there are.
  run.held_error =
      testing::held_part(family, increment_between(motion, result.target_from_source), seen.gyration, seen.centroid);
  return run;
}

void print_row(const DegenerateFamily& family, double noise, int num_runs) {
  int num_degenerate = 0, num_right = 0, num_within = 0;
  std::vector<double> errors;
  for (int k = 0; k < num_runs; ++k) {
    const Run one = run(family, noise, static_cast<unsigned>(k) + 1);
    num_degenerate += one.is_degenerate;
    num_right += one.right_number;
    num_within += one.right_number && one.angle_rad < 5.0 * kDegree;
    errors.push_back(one.held_error);
  }
  std::sort(errors.begin(), errors.end());
  fmt::print("| {} | {} | {} | {} | {} | {:.2f} mm |\n", family.name, noise > 0.0 ? "noisy" : "exact", num_degenerate,
             num_right, num_within, 1000.0 * errors[errors.size() / 2]);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const int num_runs = argc > 1 ? std::atoi(argv[1]) : 100;
  fmt::print(
      "| shape | points | degenerate | right number of motions | and within 5 deg | median error of the rest |\n"
      "| --- | --- | --- | --- | --- | --- |\n");
  for (const DegenerateFamily& family : testing::degenerate_families())
    for (const double noise : {0.0, family.noise}) print_row(family, noise, num_runs);
}
