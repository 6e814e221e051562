// SPDX-License-Identifier: MIT
// LiDAR scans that have times of points, and are skewed as these say or not: the table "Scans that are not skewed" of
// docs/lab/lidar_odometry.md.
//
//   lidar_skew FIRST_SEED LAST_SEED
//
// Generated streets and rooms, 16 sweeps of 32 rings. Prints, for each kind of scan and motion, the largest error of a
// step from one scan to the next and of a pose, mm, each as the median and the largest of the seeds.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

#include "augicp/core/angles.h"
#include "augicp/geometry/rotation.h"
#include "augicp/odometry/lidar_odometry.h"
#include "augicp/synthetic/lidar.h"
#include "augicp/synthetic/outdoor_scenes.h"
#include "augicp/testing/scenes.h"

namespace {

using namespace augicp;

constexpr double kSweep_s = 0.1;
constexpr int kNumSweeps = 16;

enum class Kind { AsMeasured, AtOnce, Deskewed };
constexpr std::pair<Kind, const char*> kKinds[] = {
    {Kind::AsMeasured, "as measured"}, {Kind::AtOnce, "taken at once"}, {Kind::Deskewed, "deskewed"}};

struct Case {
  std::string name;
  bool is_street;
  double speed, yaw_rate_deg, standing_s;  // m/s, degrees per second; how long it stands at first
};
const std::vector<Case> kCases{{"street, 3 m/s", true, 3.0, 0.0, 0.0},
                               {"street, 12 m/s", true, 12.0, 5.0, 0.0},
                               {"street, stands, then 6 m/s", true, 6.0, 0.0, 0.65},
                               {"room, 1 m/s", false, 1.0, 20.0, 0.0},
                               {"room, stands, then turns", false, 0.5, 90.0, 0.65}};

synthetic::Motion motion_of(const Case& tried, const Rigid3& start) {
  return [=](double time_s) {
    const double moving_s = std::max(0.0, time_s - tried.standing_s);
    const Rigid3 moved{rotation_exp({0.0, 0.0, tried.yaw_rate_deg * kRadPerDeg * moving_s}),
                       {tried.speed * moving_s, 0.0, 0.0}};
    return start * moved;
  };
}

synthetic::Sweep scan_of(Kind kind, const synthetic::World& world, const synthetic::Motion& motion, unsigned seed,
                         double begin_s) {
  synthetic::Lidar lidar;
  lidar.num_rings = 32;
  lidar.num_azimuths = 720;
  lidar.range_sigma = 0.02;
  const Rigid3 middle = motion(begin_s + 0.5 * kSweep_s);
  if (kind == Kind::AtOnce) return synthetic::scan(world, lidar, synthetic::standing_at(middle), seed, begin_s);
  synthetic::Sweep sweep = synthetic::scan(world, lidar, motion, seed, begin_s);
  if (kind == Kind::AsMeasured) return sweep;
  for (std::size_t i = 0; i < sweep.cloud.size(); ++i) {
    const Rigid3 middle_from_point = inverse(middle) * motion(begin_s + sweep.times_s[i]);
    sweep.cloud.points[i] = (middle_from_point * sweep.cloud.points[i].cast<double>()).cast<float>();
  }
  return sweep;
}

struct Errors {
  double step_mm = 0.0, pose_mm = 0.0;
};

Errors run(const Case& tried, Kind kind, unsigned seed) {
  const testing::Scene scene = tried.is_street ? synthetic::street(seed) : testing::room(seed);
  const Rigid3 upright{Eigen::Quaterniond::Identity(), {0.0, 0.0, 1.2}};
  const synthetic::Motion motion = motion_of(tried, tried.is_street ? scene.world_from_camera : upright);
  LidarOptions options;
  options.num_threads = 1;
  LidarOdometry odometry(options);
  Errors errors;
  Rigid3 off_before;
  const Rigid3 first_from_world = inverse(motion(0.5 * kSweep_s));
  for (int k = 0; k < kNumSweeps; ++k) {
    const double begin_s = k * kSweep_s;
    const synthetic::Sweep sweep = scan_of(kind, {scene, {}}, motion, 100 * seed + static_cast<unsigned>(k), begin_s);
    const FrameReport report = odometry.add(begin_s, sweep.cloud, shares_from_times(sweep.times_s));
    const Rigid3 off = inverse(first_from_world * motion(begin_s + 0.5 * kSweep_s)) * report.world_from_camera;
    errors.pose_mm = std::max(errors.pose_mm, 1e3 * off.translation.norm());
    errors.step_mm = std::max(errors.step_mm, 1e3 * (off.translation - off_before.translation).norm());
    off_before = off;
  }
  return errors;
}

double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

void print_row(const Case& tried, const std::pair<Kind, const char*>& kind, unsigned first, unsigned last) {
  std::vector<double> steps, poses;
  for (unsigned seed = first; seed <= last; ++seed) {
    const Errors errors = run(tried, kind.first, seed);
    steps.push_back(errors.step_mm), poses.push_back(errors.pose_mm);
  }
  std::printf("| %s | %s | %.0f | %.0f | %.0f | %.0f |\n", tried.name.c_str(), kind.second, median_of(steps),
              *std::max_element(steps.begin(), steps.end()), median_of(poses),
              *std::max_element(poses.begin(), poses.end()));
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return std::fprintf(stderr, "usage: lidar_skew FIRST_SEED LAST_SEED\n"), 2;
  std::printf(
      "| motion | scans | step: median, mm | largest | pose: median, mm | largest |\n"
      "| --- | --- | ---: | ---: | ---: | ---: |\n");
  for (const Case& tried : kCases)
    for (const auto& kind : kKinds)
      print_row(tried, kind, static_cast<unsigned>(std::atoi(argv[1])), static_cast<unsigned>(std::atoi(argv[2])));
  return 0;
}
