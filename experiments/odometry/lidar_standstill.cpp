// SPDX-License-Identifier: MIT
// LiDAR odometry while the sensor stands still, creeps and starts: the table "Standstill" of
// docs/lab/lidar_odometry.md.
//
//   lidar_standstill FIRST_SEED LAST_SEED
//
// Generated streets with 5 cm noise. The sensor stands for ten sweeps, and moves in twenty more. Prints for each case
// the RMS and the largest error of the positions of all sweeps, mm: each pose as it was found, and with means of poses.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "augicp/odometry/lidar_odometry.h"
#include "augicp/synthetic/lidar.h"
#include "augicp/synthetic/outdoor_scenes.h"

namespace {

using namespace augicp;

constexpr double kSweep_s = 0.1;
constexpr int kNumStanding = 10, kNumSweeps = 30;
constexpr double kSpeedBefore = 3.0;  // of a sensor that stops

struct Case {
  std::string name;
  std::function<double(double since_s)> distance;  // since the begin of the motion; before it, it is negative
};

double after(double since_s) { return std::max(0.0, since_s); }

const std::vector<Case>& cases() {
  static const std::vector<Case> all{{"stands", [](double) { return 0.0; }},
                                     {"creeps, 5 mm/s", [](double t) { return 0.005 * after(t); }},
                                     {"creeps, 1 cm/s", [](double t) { return 0.01 * after(t); }},
                                     {"creeps, 2 cm/s", [](double t) { return 0.02 * after(t); }},
                                     {"creeps, 5 cm/s", [](double t) { return 0.05 * after(t); }},
                                     {"creeps, 10 cm/s", [](double t) { return 0.1 * after(t); }},
                                     {"starts, 0.2 m/s^2", [](double t) { return 0.1 * after(t) * after(t); }},
                                     {"starts, 1 m/s^2", [](double t) { return 0.5 * after(t) * after(t); }},
                                     {"starts, 3 m/s^2", [](double t) { return 1.5 * after(t) * after(t); }},
                                     {"stops", [](double t) { return kSpeedBefore * std::min(t, 0.0); }}};
  return all;
}

struct Errors {
  double sum_sq = 0.0, largest = 0.0;
  int count = 0;
  double rms() const { return std::sqrt(sum_sq / count); }
};

void track(const Case& of, unsigned seed, bool averages, Errors& errors) {
  const testing::Scene street = synthetic::street(seed);
  const synthetic::Motion motion = [&](double time_s) {
    return street.world_from_camera *
           Rigid3{Eigen::Quaterniond::Identity(), {of.distance(time_s - kNumStanding * kSweep_s), 0.0, 0.0}};
  };
  synthetic::Lidar lidar;
  lidar.num_rings = 32;
  lidar.num_azimuths = 360;
  lidar.range_sigma = 0.05;
  lidar.sweep_s = kSweep_s;
  LidarOptions options;
  options.num_threads = 1;
  options.parts.averages_standstill = averages;
  LidarOdometry odometry(options);
  const Rigid3 first = motion(0.5 * kSweep_s);
  for (int k = 0; k < kNumSweeps; ++k) {
    const double begin_s = k * kSweep_s;
    const synthetic::Sweep sweep =
        synthetic::scan({street, {}}, lidar, motion, 1000 * seed + static_cast<unsigned>(k), begin_s);
    const FrameReport report = odometry.add(begin_s, sweep.cloud, shares_from_times(sweep.times_s));
    if (k == 0) continue;
    const Rigid3 truth = inverse(first) * motion(begin_s + 0.5 * kSweep_s);
    const double error = 1e3 * (report.world_from_camera.translation - truth.translation).norm();
    errors.sum_sq += error * error;
    errors.largest = std::max(errors.largest, error);
    ++errors.count;
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return std::fprintf(stderr, "usage: lidar_standstill FIRST_SEED LAST_SEED\n"), 2;
  for (const Case& of : cases()) {
    Errors single, mean;
    for (int seed = std::atoi(argv[1]); seed <= std::atoi(argv[2]); ++seed) {
      track(of, static_cast<unsigned>(seed), false, single);
      track(of, static_cast<unsigned>(seed), true, mean);
    }
    std::printf("| %s | %.1f, %.1f | %.1f, %.1f |\n", of.name.c_str(), single.rms(), single.largest, mean.rms(),
                mean.largest);
    std::fflush(stdout);
  }
  return 0;
}
