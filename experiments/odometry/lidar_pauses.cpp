// SPDX-License-Identifier: MIT
// LiDAR odometry across gaps in a recording: the table "Pauses" of docs/lab/lidar_odometry.md.
//
//   lidar_pauses FIRST_SEED LAST_SEED
//
// Generated streets. The sensor drives eight sweeps, the recording has a gap, and six sweeps follow. Prints, for each
// case and length of the gap, how many of the sweeps after it are right (tracked within 0.1 m and 0.5 degrees), wrong
// (tracked, but farther off) and without a pose or doubtful, and the most processor time of a sweep in ms.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

#include "augicp/core/angles.h"
#include "augicp/geometry/rotation.h"
#include "augicp/odometry/lidar_odometry.h"
#include "augicp/synthetic/lidar.h"
#include "augicp/synthetic/outdoor_scenes.h"

namespace {

using namespace augicp;

constexpr double kSweep_s = 0.1, kSpeed = 6.0, kBraking = 5.0, kYawRate = 0.1;
constexpr int kNumBefore = 8, kNumAfter = 6;
constexpr double kPause_s = kNumBefore * kSweep_s;  // when the gap begins

// The distance driven and the heading, over time; gap_s: how long the recording pauses.
struct Place {
  double distance, heading;
};
using Drive = std::function<Place(double time_s, double gap_s)>;

double braked(double since_s) {
  const double t = std::clamp(since_s, 0.0, kSpeed / kBraking);
  return kSpeed * t - 0.5 * kBraking * t * t;
}

Place driving(double time_s) { return {kSpeed * time_s, kYawRate * time_s}; }

// Brakes where the recording stops. moves_again: drives on when it starts again; rotation: during the pause.
Place pausing(double time_s, double gap_s, bool moves_again, double rotation) {
  if (time_s < kPause_s) return driving(time_s);
  const double since_s = time_s - kPause_s, after_s = std::max(0.0, since_s - gap_s);
  Place place = driving(kPause_s);
  place.distance += braked(since_s) + (moves_again ? kSpeed * after_s : 0.0);
  place.heading += rotation * std::clamp(since_s / gap_s, 0.0, 1.0) + (moves_again ? kYawRate * after_s : 0.0);
  return place;
}

struct Case {
  std::string name;
  Drive drive;
  bool is_clock_alone;  // the stamps jump, the sweeps follow one another
};

const std::vector<Case>& cases() {
  static const std::vector<Case> all{
      {"drives on", [](double time_s, double) { return driving(time_s); }, false},
      {"stops", [](double time_s, double gap_s) { return pausing(time_s, gap_s, false, 0.0); }, false},
      {"stops, drives on after it", [](double time_s, double gap_s) { return pausing(time_s, gap_s, true, 0.0); },
       false},
      {"stops and rotates by 60 degrees",
       [](double time_s, double gap_s) { return pausing(time_s, gap_s, false, 60.0 * kRadPerDeg); }, false},
      {"the clock jumps", [](double time_s, double) { return driving(time_s); }, true}};
  return all;
}

struct Outcome {
  int num_right = 0, num_wrong = 0, num_others = 0;
  double worst_ms = 0.0;
};

void run(const Case& tried, double gap_s, unsigned seed, Outcome& outcome) {
  const testing::Scene scene = synthetic::street(seed);
  synthetic::Lidar lidar;
  lidar.num_rings = 32;
  lidar.num_azimuths = 720;
  const synthetic::Motion motion = [&](double time_s) {
    const Place at = tried.drive(time_s, gap_s);
    return scene.world_from_camera * Rigid3{rotation_exp({0.0, 0.0, at.heading}), {at.distance, 0.0, 0.0}};
  };
  LidarOptions options;
  options.num_threads = 1;
  LidarOdometry odometry(options);
  const Rigid3 first_from_world = inverse(motion(0.5 * kSweep_s));
  for (int k = 0; k < kNumBefore + kNumAfter; ++k) {
    const double jump_s = k < kNumBefore ? 0.0 : gap_s;
    const double begin_s = k * kSweep_s + (tried.is_clock_alone ? 0.0 : jump_s);
    const synthetic::Sweep sweep =
        synthetic::scan({scene, {}}, lidar, motion, 100 * seed + static_cast<unsigned>(k), begin_s);
    const std::clock_t before = std::clock();
    const FrameReport report = odometry.add(k * kSweep_s + jump_s, sweep.cloud, shares_from_times(sweep.times_s));
    if (k < kNumBefore) continue;
    outcome.worst_ms = std::max(outcome.worst_ms, 1e3 * static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC);
    const Rigid3 off = inverse(first_from_world * motion(begin_s + 0.5 * kSweep_s)) * report.world_from_camera;
    const bool is_right = off.translation.norm() < 0.1 && angle_between(off, Rigid3{}) < 0.5 * kRadPerDeg;
    if (report.status != FrameStatus::Tracked)
      ++outcome.num_others;
    else
      ++(is_right ? outcome.num_right : outcome.num_wrong);
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return std::fprintf(stderr, "usage: lidar_pauses FIRST_SEED LAST_SEED\n"), 2;
  const unsigned first = static_cast<unsigned>(std::atoi(argv[1])), last = static_cast<unsigned>(std::atoi(argv[2]));
  std::printf(
      "| case | gap, s | right | wrong | others | slowest sweep, ms |\n| --- | ---: | ---: | ---: | ---: | ---: |\n");
  for (const Case& tried : cases())
    for (const double gap_s : {0.5, 1.0, 3.0, 10.0, 60.0}) {
      if (tried.name == "drives on" && gap_s > 3.0) continue;  // it would leave the street
      Outcome outcome;
      for (unsigned seed = first; seed <= last; ++seed) run(tried, gap_s, seed, outcome);
      std::printf("| %s | %g | %d | %d | %d | %.0f |\n", tried.name.c_str(), gap_s, outcome.num_right,
                  outcome.num_wrong, outcome.num_others, outcome.worst_ms);
      std::fflush(stdout);
    }
  return 0;
}
