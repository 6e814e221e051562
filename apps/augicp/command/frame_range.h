// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <cstddef>
#include <string>
#include <vector>

namespace augicp::app {

// Which frames of a sequence are used.
struct FrameRange {
  static constexpr std::size_t kNoLast = std::size_t{1} << 40;
  std::size_t first = 0, last = kNoLast, every = 1;

  // The selected numbers below `count`. Throws std::invalid_argument if there is none; what: the word for a frame.
  std::vector<std::size_t> chosen(std::size_t count, const std::string& what) const;
};

void add_range_options(CLI::App& command, FrameRange& range, const std::string& group);

}  // namespace augicp::app
