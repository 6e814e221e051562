// SPDX-License-Identifier: MIT
#include "augicp/odometry/lidar_memory.h"

#include <cmath>
#include <locale>
#include <optional>
#include <sstream>
#include <string>

#include "augicp/cloud/voxel_grid.h"

namespace augicp {
namespace {

// Measured: the peak of runs with scans of 0.1 to 3 million points and maps of 0.1 to 2.2 million voxels
// (docs/lab/first_hour.md). A point: its copies, straightened and downsampled. A voxel: its sums, its place in the
// table, its surface, and the same of a map that grows. A kept point: itself, its direction and structure.
constexpr double kBytesWithoutScans = 2e7;
constexpr double kBytesPerPoint = 200.0;
constexpr double kBytesPerVoxel = 550.0;
constexpr double kBytesPerKeptPoint = 28.0;

// Voxels that are tried as advice grow by this factor.
constexpr double kStep = 1.2;
constexpr int kMaxTrials = 40;

// To two digits, upwards.
double two_digits(double value) {
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
  return std::ceil(value / unit) * unit;
}

// In the classic locale, two digits.
std::string in_digits(double value) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(2);
  text << value;
  return text.str();
}

std::optional<double> enough_voxel(const LidarMemory& needed, const Cloud& scan, double voxel_size, double max_gb) {
  const auto num_now = static_cast<double>(count_voxels(scan, voxel_size));
  double voxel = voxel_size;
  for (int trial = 0; trial < kMaxTrials; ++trial) {
    voxel = two_digits(kStep * voxel);
    const double share = static_cast<double>(count_voxels(scan, voxel)) / num_now;
    LidarMemory then = needed;
    then.num_voxels = static_cast<std::size_t>(share * static_cast<double>(needed.num_voxels));
    if (then.gb() <= max_gb) return voxel;
  }
  return std::nullopt;
}

}  // namespace

double LidarMemory::gb() const {
  const auto times = [](double bytes, std::size_t count) { return bytes * static_cast<double>(count); };
  return (kBytesWithoutScans + times(kBytesPerPoint, num_points) + times(kBytesPerVoxel, num_voxels) +
          times(kBytesPerKeptPoint, num_kept)) /
         kBytesPerGb;
}

void require_memory(const LidarMemory& needed, const Cloud& scan, double voxel_size, double max_gb) {
  if (needed.gb() <= max_gb) return;
  const EnoughMemory enough{enough_voxel(needed, scan, voxel_size, max_gb), {}, {}};
  throw TooMuchMemory("a scan of " + std::to_string(needed.num_points) + " points and a map of about " +
                          std::to_string(needed.num_voxels) + " voxels need about " + in_digits(needed.gb()) + " GB; " +
                          in_digits(max_gb) + " GB are allowed",
                      enough);
}

}  // namespace augicp
