// SPDX-License-Identifier: MIT
// Table 4 of the paper: known pairs are corrupted, so that only the objective and its weights are compared.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "augicp/experiment/known_pairs.h"
#include "augicp/experiment/spread.h"
#include "augicp/registration/options.h"

namespace augicp {

struct SyntheticOptions {
  std::size_t num_points = 300000;
  std::vector<double> outlier_shares{0.0, 0.5, 0.9};  // shares of the pairs, in [0, 1]
  std::vector<double> point_noises{0.0, 0.01, 0.02};  // metres, of each coordinate in both clouds
  std::vector<double> normal_noises_rad{0.0, 0.08726646259971647, 0.3490658503988659};  // 0, 5, 20 degrees
  // NDT is left out: the noise of normals, which the scene's directions have, is none of its own.
  std::vector<Method> methods{Method::Point, Method::Plane, Method::Gicp, Method::Augmented};
  int iterations = 50;
  unsigned first_seed = 1, num_seeds = 5;  // each seed gives a scene and a motion

  Preset preset = Preset::Paper;

  // K of Eq. (13) for all methods; not set: the preset's.
  std::optional<double> kernel_chi2;

  int num_threads = 0;  // 0: all of the machine; the result is bit-identical for any number

  // Throws std::invalid_argument naming the first option out of its range.
  void check() const;
};

// The errors of one method under one corruption after an iteration (0: the guess), over the seeds.
struct SyntheticRow {
  double outlier_share = 0.0, point_noise = 0.0, normal_noise_rad = 0.0;
  Method method = Method::Augmented;
  int iteration = 0;
  MeanInterval translation, rotation;  // metres, radians
};

// Every corruption with every method, from the identity. on_run is called after each num_runs()-th part, from the
// calling thread.
std::vector<SyntheticRow> run_synthetic(const SyntheticOptions& options, const std::function<void()>& on_run);
std::size_t num_runs(const SyntheticOptions& options);

}  // namespace augicp
