// SPDX-License-Identifier: MIT
// The memory that surface estimation needs, known before it begins; and the bound on memory, for odometry too.
#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "augicp/registration/options.h"
#include "augicp/search/cell_grid.h"

namespace augicp {

// A scan that was downsampled and whose surface is to be estimated in balls, which takes a grid of its points. Depth
// images, and clouds with directions, have no grid and need little.
struct ThinnedScan {
  Scan scan;
  std::size_t num_read = 0;  // points before it was downsampled
  std::optional<CellGrid> grid;
};

// What would be enough: one of these. Metres; not set: that one alone is not enough, or does not apply.
struct EnoughMemory {
  std::optional<double> voxel_size{}, radius{};
  std::optional<int> pixel_step{};  // of the images of a depth camera
};

// The names of the options that can be changed, for instance "--voxel-size".
struct MemoryOptionNames {
  std::string_view voxel_size, radius, max_memory, pixel_step = "pixel_step";
};

// The inputs need more memory than is allowed. what() is in the words of the library's options.
class TooMuchMemory : public std::invalid_argument {
 public:
  TooMuchMemory(const std::string& need, const EnoughMemory& enough);

  // The message with other names for the options.
  std::string message(const MemoryOptionNames& names) const;

 private:
  std::string need_;
  EnoughMemory enough_;
};

inline constexpr double kBytesPerGb = 1e9;

// The bound of an option max_memory_gb: half of the machine's memory if it is not set.
double allowed_gb(const std::optional<double>& max_memory_gb);

// Throws TooMuchMemory if the surfaces of these scans, estimated at the same time, are expected to need more memory
// than the options allow, or if a ball would contain more points than BallNeighbourhood takes. Lengths, metres, are
// those of the scans' grids. On the large generated clouds that were tried, the estimate
// was within a third.
void require_memory(const std::vector<const ThinnedScan*>& scans, const Lengths& lengths,
                    const RegistrationOptions& options);

}  // namespace augicp
