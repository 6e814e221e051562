// SPDX-License-Identifier: MIT
#include "augicp/registration/memory.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

#include "augicp/cloud/voxel_grid.h"
#include "augicp/surface/ball_neighbourhood.h"
#include "augicp/surface/ball_size.h"

namespace augicp {
namespace {

// Measured: the peak of `augicp surface` and `augicp align` on clouds of 1 to 5 million points
// (docs/lab/first_hour.md). A point that was read: itself, and its place and order while voxels are formed. A point
// that was kept: sums, shapes and directions. A neighbour: its index, in a list.
constexpr double kBytesPerReadPoint = 60.0;
constexpr double kBytesPerPoint = 350.0;
constexpr double kBytesPerNeighbour = 4.2;

constexpr double kShareOfMachine = 0.5;

// Advice leaves some room: what is estimated at its lengths is itself an estimate.
constexpr double kRoom = 0.9;
constexpr int kMaxTrials = 40;
constexpr double kLeastStep = 1.1;

// In smaller balls there are too few points for a normal.
constexpr double kMinVoxelsPerRadius = 2.0;

// Of the clouds together.
struct Need {
  double num_read = 0.0, num_points = 0.0, num_neighbours = 0.0;
  double share_of_lists = 0.0;  // of the most that the lists of one cloud may contain

  double gb() const {
    return (kBytesPerReadPoint * num_read + kBytesPerPoint * num_points + kBytesPerNeighbour * num_neighbours) /
           kBytesPerGb;
  }
  // Above 1: too much.
  double share_of(double max_gb) const { return std::max(gb() / max_gb, share_of_lists); }
};

void add(const Cloud& cloud, double ball_size, std::size_t num_read, Need& need) {
  const auto num_points = static_cast<double>(cloud.size());
  const double num_neighbours = num_points * ball_size;
  need.num_read += static_cast<double>(num_read);
  need.num_points += num_points;
  need.num_neighbours += num_neighbours;
  need.share_of_lists =
      std::max(need.share_of_lists, num_neighbours / static_cast<double>(max_neighbours(cloud.size())));
}

using Scans = std::vector<const ThinnedScan*>;

Need need_of(const Scans& scans, double radius) {
  Need need;
  for (const ThinnedScan* thinned : scans)
    if (thinned->grid)
      add(thinned->scan.cloud, mean_ball_size(thinned->scan.cloud, *thinned->grid, radius), thinned->num_read, need);
  return need;
}

// No ball has more points than 27 cells.
double largest_ball_size(const CellGrid& grid) {
  std::size_t largest_cell = 0;
  for (std::size_t cell = 0; cell < grid.num_cells(); ++cell)
    largest_cell = std::max(largest_cell, grid.points_of(cell).size());
  return 27.0 * static_cast<double>(largest_cell);
}

// An upper bound of need_of(), in a small part of its time.
Need most_need_of(const Scans& scans) {
  Need need;
  for (const ThinnedScan* thinned : scans)
    if (thinned->grid) add(thinned->scan.cloud, largest_ball_size(*thinned->grid), thinned->num_read, need);
  return need;
}

// With another voxel size, at least the present one, and another radius.
Need need_with(const Scans& scans, double voxel_size, double radius, bool is_coarser) {
  Need need;
  for (const ThinnedScan* thinned : scans) {
    if (!thinned->grid) continue;
    const Cloud& cloud = thinned->scan.cloud;
    const Cloud coarser = is_coarser ? downsample(cloud, feasible_voxel(cloud, voxel_size)) : cloud;
    add(coarser, mean_ball_size(coarser, CellGrid(coarser, radius), radius), thinned->num_read, need);
  }
  return need;
}

// To two digits, for people. direction: std::ceil or std::floor.
double two_digits(double value, double (*direction)(double)) {
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
  return direction(value / unit) * unit;
}
double up(double value) { return std::ceil(value); }
double down(double value) { return std::floor(value); }

// The radius stays where it was given, and otherwise follows the voxel size as lengths_for() has it. The need falls
// with the square of the voxel size or faster, so that steps of the fourth root do not pass what is enough by much.
std::optional<double> enough_voxel(const Scans& scans, const Lengths& lengths, const RegistrationOptions& options,
                                   double max_gb) {
  double voxel_size = lengths.voxel_size, share = need_of(scans, lengths.radius).share_of(kRoom * max_gb);
  for (int trial = 0; trial < kMaxTrials && voxel_size < lengths.extent; ++trial) {
    voxel_size = two_digits(voxel_size * std::max(kLeastStep, std::pow(share, 0.25)), up);
    const double following = std::max(lengths.radius, voxel_size * lengths.radius / lengths.voxel_size);
    share = need_with(scans, voxel_size, options.radius.value_or(following), true).share_of(kRoom * max_gb);
    if (share <= 1.0) return voxel_size;
  }
  return std::nullopt;
}

// Only if the voxel size was given: else it would follow the radius, to more points.
std::optional<double> enough_radius(const Scans& scans, const Lengths& lengths, const RegistrationOptions& options,
                                    double max_gb) {
  if (!options.voxel_size) return std::nullopt;
  double radius = lengths.radius, share = need_of(scans, radius).share_of(kRoom * max_gb);
  for (int trial = 0; trial < kMaxTrials; ++trial) {
    radius = two_digits(radius / std::max(kLeastStep, std::pow(share, 0.25)), down);
    if (radius < kMinVoxelsPerRadius * lengths.voxel_size) return std::nullopt;
    share = need_with(scans, lengths.voxel_size, radius, false).share_of(kRoom * max_gb);
    if (share <= 1.0) return radius;
  }
  return std::nullopt;
}

// The same in any locale.
std::string in_digits(double value, int digits) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, digits).ptr;
  return {text.data(), end};
}

std::string need_text(const Need& need, const Lengths& lengths, double max_gb) {
  const auto ball_size = std::llround(need.num_neighbours / need.num_points);
  return "surfaces of " + std::to_string(std::llround(need.num_points)) + " points with about " +
         std::to_string(ball_size) + " in a ball of " + in_digits(lengths.radius, 3) + " m need about " +
         in_digits(need.gb(), 2) + " GB; " + in_digits(max_gb, 3) + " GB and " +
         std::to_string(max_neighbours(1 << 20) >> 20) + " points in a ball are allowed";
}

std::string message_of(const std::string& need, const EnoughMemory& enough, const MemoryOptionNames& names) {
  std::string advice;
  const auto add = [&](std::string_view name, const std::string& value) {
    advice += (advice.empty() ? "" : " or ") + std::string(name) + " " + value;
  };
  if (enough.voxel_size) add(names.voxel_size, in_digits(*enough.voxel_size, 2));
  if (enough.radius) add(names.radius, in_digits(*enough.radius, 2));
  if (enough.pixel_step) add(names.pixel_step, std::to_string(*enough.pixel_step));
  if (advice.empty()) advice = "larger lengths, fewer points";
  return need + ": use " + advice + ", or a larger " + std::string(names.max_memory);
}

}  // namespace

TooMuchMemory::TooMuchMemory(const std::string& need, const EnoughMemory& enough)
    : std::invalid_argument(message_of(need, enough, {"voxel_size", "radius", "max_memory_gb"})),
      need_(need),
      enough_(enough) {}

std::string TooMuchMemory::message(const MemoryOptionNames& names) const { return message_of(need_, enough_, names); }

double allowed_gb(const std::optional<double>& max_memory_gb) {
  if (max_memory_gb) return *max_memory_gb;
  const long num_pages = ::sysconf(_SC_PHYS_PAGES), page = ::sysconf(_SC_PAGESIZE);
  if (num_pages <= 0 || page <= 0) return std::numeric_limits<double>::infinity();
  return kShareOfMachine * static_cast<double>(num_pages) * static_cast<double>(page) / kBytesPerGb;
}

void require_memory(const std::vector<const ThinnedScan*>& scans, const Lengths& lengths,
                    const RegistrationOptions& options) {
  const double max_gb = allowed_gb(options.max_memory_gb);
  if (most_need_of(scans).share_of(max_gb) <= 1.0) return;
  const Need need = need_of(scans, lengths.radius);
  if (need.share_of(max_gb) <= 1.0) return;
  throw TooMuchMemory(need_text(need, lengths, max_gb),
                      {enough_voxel(scans, lengths, options, max_gb), enough_radius(scans, lengths, options, max_gb)});
}

}  // namespace augicp
