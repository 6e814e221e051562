// SPDX-License-Identifier: MIT
// A LiDAR in the hand that turns fast, with jerks: the table "Fast turns" of docs/lab/lidar_odometry.md.
//
//   lidar_fast_turns FIRST_SEED LAST_SEED
//
// Generated rooms and streets, 30 sweeps of 16 and of 32 rings. The rotation about each axis and the place are sums of
// two oscillations; the sensor stands for 0.3 s and reaches their speed within 0.7 s, or moves from the beginning.
// Prints, for each highest rate: the scans that are tracked within 10 cm and 1 degree of the truth, those that are
// tracked and are not, the others; of all that are tracked the errors of poses, and of steps from one to the next.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "augicp/core/angles.h"
#include "augicp/core/median.h"
#include "augicp/geometry/rotation.h"
#include "augicp/odometry/lidar_odometry.h"
#include "augicp/synthetic/lidar.h"
#include "augicp/synthetic/outdoor_scenes.h"
#include "augicp/testing/scenes.h"

namespace {

using namespace augicp;

constexpr double kSweep_s = 0.1;
constexpr int kNumSweeps = 30;
constexpr double kRightDistance_m = 0.1, kRightAngle_deg = 1.0;

struct Case {
  bool is_street;
  int num_rings;
  bool stands_first;
  double yaw_rate_deg;  // the highest, degrees per second
};

// Of one axis: two oscillations, each with half of the highest rate.
struct Oscillation {
  double rate = 0.0, frequency_1 = 1.0, frequency_2 = 1.0, phase_1 = 0.0, phase_2 = 0.0;

  double at(double time_s) const {
    const auto part = [&](double frequency, double phase) {
      const double w = 2.0 * std::numbers::pi * frequency;
      return 0.5 * rate / w * (std::sin(w * time_s + phase) - std::sin(phase));
    };
    return part(frequency_1, phase_1) + part(frequency_2, phase_2);
  }
};

// The time of a motion that begins smoothly, from standstill: its rate goes from 0 to 1.
double after_standing(double time_s) {
  constexpr double kStanding_s = 0.3, kStarting_s = 0.7;
  const double u = std::clamp((time_s - kStanding_s) / kStarting_s, 0.0, 1.0);
  const double later_s = std::max(0.0, time_s - kStanding_s - kStarting_s);
  return kStarting_s * u * u * u * (1.0 - 0.5 * u) + later_s;
}

Oscillation drawn(double rate, std::mt19937& generator) {
  std::uniform_real_distribution<double> slow(0.4, 0.8), fast(1.2, 2.0), phase(0.0, 2.0 * std::numbers::pi);
  return {rate, slow(generator), fast(generator), phase(generator), phase(generator)};
}

synthetic::Motion motion_of(const Case& tried, unsigned seed, const Rigid3& start) {
  std::mt19937 generator(seed);
  std::vector<Oscillation> turns, shifts;
  for (const double part : {0.25, 0.25, 1.0}) turns.push_back(drawn(part * tried.yaw_rate_deg * kRadPerDeg, generator));
  for (const double speed : {0.8, 0.8, 0.3}) shifts.push_back(drawn(speed, generator));
  const bool stands_first = tried.stands_first;
  return [=](double time_s) {
    if (stands_first) time_s = after_standing(time_s);
    const auto vector = [&](const std::vector<Oscillation>& of_axes) {
      return Vec3d(of_axes[0].at(time_s), of_axes[1].at(time_s), of_axes[2].at(time_s));
    };
    const Vec3d angles = vector(turns);
    return start *
           Rigid3{rotation_exp({0.0, 0.0, angles.z()}) * rotation_exp({angles.x(), angles.y(), 0.0}), vector(shifts)};
  };
}

struct Counts {
  int num_right = 0, num_wrong = 0, num_others = 0;
  std::vector<double> distances_m, angles_deg;            // of those that are tracked
  std::vector<double> step_distances_m, step_angles_deg;  // from one that is tracked to the next
};

void run(const Case& tried, unsigned seed, Counts& counts) {
  const testing::Scene scene = tried.is_street ? synthetic::street(seed) : testing::room(seed);
  const Rigid3 upright{Eigen::Quaterniond::Identity(), {0.0, 0.0, 1.2}};
  const synthetic::Motion motion = motion_of(tried, seed, tried.is_street ? scene.world_from_camera : upright);
  synthetic::Lidar lidar;
  lidar.num_rings = tried.num_rings;
  lidar.num_azimuths = 720;
  lidar.range_sigma = 0.02;
  LidarOptions options;
  options.num_threads = 1;
  LidarOdometry odometry(options);
  const Rigid3 first_from_world = inverse(motion(0.5 * kSweep_s));
  std::optional<Rigid3> off_before;
  for (int k = 0; k < kNumSweeps; ++k) {
    const double begin_s = k * kSweep_s;
    const synthetic::Sweep sweep =
        synthetic::scan({scene, {}}, lidar, motion, 100 * seed + static_cast<unsigned>(k), begin_s);
    const FrameReport report = odometry.add(begin_s, sweep.cloud, shares_from_times(sweep.times_s));
    const Rigid3 off = inverse(first_from_world * motion(begin_s + 0.5 * kSweep_s)) * report.world_from_camera;
    if (k == 0) {
      off_before = off;
      continue;
    }
    const double distance_m = off.translation.norm(), angle_deg = angle_between(off, Rigid3{}) * kDegPerRad;
    if (report.status != FrameStatus::Tracked) {
      ++counts.num_others;
      off_before.reset();
      continue;
    }
    if (off_before) {
      const Rigid3 step = inverse(*off_before) * off;
      counts.step_distances_m.push_back(step.translation.norm());
      counts.step_angles_deg.push_back(angle_between(step, Rigid3{}) * kDegPerRad);
    }
    off_before = off;
    counts.distances_m.push_back(distance_m), counts.angles_deg.push_back(angle_deg);
    ++(distance_m <= kRightDistance_m && angle_deg <= kRightAngle_deg ? counts.num_right : counts.num_wrong);
  }
}

double median_of(const std::vector<double>& values) { return values.empty() ? 0.0 : upper_median(values); }

double largest_of(const std::vector<double>& values) {
  return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
}

void print_row(const Case& tried, unsigned first, unsigned last) {
  Counts counts;
  for (unsigned seed = first; seed <= last; ++seed) run(tried, seed, counts);
  std::printf("| %s, %d rings | %s | %.0f | %d | %d | %d | %.1f, %.2f | %.0f, %.1f | %.1f, %.2f | %.0f, %.1f |\n",
              tried.is_street ? "street" : "room", tried.num_rings, tried.stands_first ? "stands first" : "moves",
              tried.yaw_rate_deg, counts.num_right, counts.num_wrong, counts.num_others,
              1e3 * median_of(counts.distances_m), median_of(counts.angles_deg), 1e3 * largest_of(counts.distances_m),
              largest_of(counts.angles_deg), 1e3 * median_of(counts.step_distances_m),
              median_of(counts.step_angles_deg), 1e3 * largest_of(counts.step_distances_m),
              largest_of(counts.step_angles_deg));
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return std::fprintf(stderr, "usage: lidar_fast_turns FIRST_SEED LAST_SEED\n"), 2;
  std::printf(
      "| scene | begin | degrees/s | tracked, right | tracked, WRONG | others | poses: median, mm, deg | largest | "
      "steps: median, mm, deg | largest |\n| --- | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: |\n");
  const auto first = static_cast<unsigned>(std::atoi(argv[1])), last = static_cast<unsigned>(std::atoi(argv[2]));
  for (const bool is_street : {false, true}) {
    for (const int num_rings : {16, 32})
      for (const double rate : {120.0, 240.0, 360.0}) print_row({is_street, num_rings, true, rate}, first, last);
    for (const double rate : {120.0, 240.0}) print_row({is_street, 32, false, rate}, first, last);
  }
  return 0;
}
