// SPDX-License-Identifier: MIT
// LiDAR odometry with parts of it left out, for lidar_ablation.py, which makes the table of docs/lab/lidar_odometry.md.
//
//   lidar_ablation FOLDER OUTPUT order|azimuth|none    where the times of the points come from
//
// For each variant writes OUTPUT/VARIANT.txt, a pose for each scan (TUM; one without a pose repeats the last one), and
// prints the variant, the numbers of scans and of tracked, degenerate and other ones after the first, and the median of
// the processor time of a scan in ms.
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "augicp/io/scan_sequence.h"
#include "augicp/io/trajectory_file.h"
#include "augicp/odometry/lidar_odometry.h"

namespace {

using namespace augicp;

constexpr double kScansPerSecond = 10.0;

struct Variant {
  std::string name;
  std::function<void(LidarOptions&)> change;
};

const std::vector<Variant>& variants() {
  static const std::vector<Variant> all{
      {"default", [](LidarOptions&) {}},
      {"no_edges", [](LidarOptions& options) { options.parts.has_edges = false; }},
      {"directions", [](LidarOptions& options) { options.parts.information = default_information(); }},
      {"both_sides", [](LidarOptions& options) { options.parts.information = with_both_sides(default_information()); }},
      {"points", [](LidarOptions& options) { options.parts.information = point_information(); }},
      {"last_scan_alone", [](LidarOptions& options) { options.parts.is_last_scan_alone = true; }},
      {"no_deskewing", [](LidarOptions& options) { options.deskew = false; }},
      {"no_search", [](LidarOptions& options) { options.search = false; }},
      {"no_self_check", [](LidarOptions& options) { options.check_every = 0; }}};
  return all;
}

struct TimedScan {
  double stamp_s;
  Cloud cloud;
  SweepShares shares;
};

std::vector<TimedScan> read(const std::filesystem::path& folder, const std::string& times) {
  const ScanSequence sequence = read_scan_sequence(folder, kScansPerSecond);
  ScanReader reader(sequence);
  std::vector<TimedScan> scans;
  for (std::size_t k = 0; k < sequence.scans.size(); ++k) {
    TimedScan scan{sequence.scans[k].stamp_s, reader.read(k, {}).cloud, {}};
    if (times == "order") scan.shares = shares_from_order(scan.cloud);
    if (times == "azimuth") scan.shares = shares_from_azimuth(scan.cloud);
    scans.push_back(std::move(scan));
  }
  return scans;
}

double processor_ms() { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

void run(const Variant& variant, const std::vector<TimedScan>& scans, const std::filesystem::path& output) {
  LidarOptions options;
  options.num_threads = 1;
  variant.change(options);
  LidarOdometry odometry(options);
  Trajectory trajectory;
  std::vector<double> times_ms;
  std::size_t num_tracked = 0, num_degenerate = 0;
  Rigid3 pose;
  for (const TimedScan& scan : scans) {
    const double begin_ms = processor_ms();
    const FrameReport report = odometry.add(scan.stamp_s, scan.cloud, scan.shares);
    times_ms.push_back(processor_ms() - begin_ms);
    if (has_pose(report.status)) pose = report.world_from_camera;
    trajectory.push_back({scan.stamp_s, pose});
    num_tracked += report.status == FrameStatus::Tracked;
    num_degenerate += report.status == FrameStatus::Degenerate;
  }
  write_tum_trajectory(output / (variant.name + ".txt"), trajectory);
  std::nth_element(times_ms.begin(), times_ms.begin() + static_cast<std::ptrdiff_t>(times_ms.size() / 2),
                   times_ms.end());
  const std::size_t num_others = scans.size() - 1 - num_tracked - num_degenerate;
  std::printf("%s %zu %zu %zu %zu %.1f\n", variant.name.c_str(), scans.size(), num_tracked, num_degenerate, num_others,
              times_ms[times_ms.size() / 2]);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) return std::fprintf(stderr, "usage: lidar_ablation FOLDER OUTPUT order|azimuth|none\n"), 2;
  const std::vector<TimedScan> scans = read(argv[1], argv[3]);
  for (const Variant& variant : variants()) run(variant, scans, argv[2]);
  return 0;
}
