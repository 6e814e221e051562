// SPDX-License-Identifier: MIT
// What deskewing is worth: how far the points of two scans, ten and twenty apart, are from each other's surfaces, as
// the scans came and deskewed with the motion that the odometry found. Times of points are from the azimuth, as KITTI's
// scans need.
//
//   lidar_deskewing FOLDER     a folder of .bin scans in the order of their names
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "augicp/io/read_cloud.h"
#include "augicp/odometry/lidar_odometry.h"
#include "augicp/registration/registration.h"

namespace {

using namespace augicp;

constexpr std::size_t kEvery = 10;
constexpr double kPeriod_s = 0.1, kVoxel_m = 0.5;

struct KeptScan {
  Cloud raw, straight;
  Rigid3 world_from_scan;
};

std::vector<std::string> scans_of(const std::string& folder) {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  return files;
}

std::vector<KeptScan> kept_scans(const std::vector<std::string>& files) {
  LidarOdometry odometry(LidarOptions{});
  std::vector<KeptScan> kept;
  for (std::size_t k = 0; k < files.size(); ++k) {
    const Cloud scan = read_cloud(files[k]).cloud;
    const SweepShares shares = shares_from_azimuth(scan);
    const FrameReport report = odometry.add(kPeriod_s * static_cast<double>(k), scan, shares);
    if (k % kEvery == 0)
      kept.push_back({scan, deskewed(scan, shares, report, LidarOptions{}.pose_at), report.world_from_camera});
  }
  return kept;
}

// The median distance of the points from the other scan's surface, metres.
double residual_m(const Cloud& source, const Cloud& target, const Rigid3& guess_target_from_source) {
  RegistrationOptions options;
  options.voxel_size = kVoxel_m;
  options.search = false;
  const Registration found = register_scans(scan_of(source), scan_of(target), guess_target_from_source, options);
  return found.result.evidence ? found.result.evidence->residuals.point.median : 0.0;
}

void print_gap(const std::vector<KeptScan>& kept, std::size_t steps) {
  std::array<double, 2> sums{};
  for (std::size_t i = 0; i + steps < kept.size(); ++i) {
    const KeptScan &target = kept[i], &source = kept[i + steps];
    const Rigid3 guess = inverse(target.world_from_scan) * source.world_from_scan;
    sums[0] += residual_m(source.raw, target.raw, guess);
    sums[1] += residual_m(source.straight, target.straight, guess);
  }
  const double count = static_cast<double>(kept.size() - steps);
  fmt::print("gap {}: {:.1f} mm as they came, {:.1f} mm deskewed, {:+.1f} %\n", steps * kEvery, 1e3 * sums[0] / count,
             1e3 * sums[1] / count, 100.0 * (sums[1] / sums[0] - 1.0));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "usage: lidar_deskewing FOLDER\n");
    return 2;
  }
  const std::vector<KeptScan> kept = kept_scans(scans_of(argv[1]));
  for (const std::size_t steps : {1, 2})
    if (kept.size() > steps) print_gap(kept, steps);
}
