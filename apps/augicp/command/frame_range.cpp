// SPDX-License-Identifier: MIT
#include "apps/augicp/command/frame_range.h"

#include <fmt/core.h>

#include <algorithm>
#include <stdexcept>

namespace augicp::app {

std::vector<std::size_t> FrameRange::chosen(std::size_t count, const std::string& what) const {
  std::vector<std::size_t> numbers;
  const std::size_t end = std::min(last, count);
  for (std::size_t i = first; i < end; i += std::min(every, end - i)) numbers.push_back(i);
  const std::string and_last = last < kNoLast ? fmt::format(" --last {}", last) : "";
  if (numbers.empty())
    throw std::invalid_argument(
        fmt::format("--first {}{}: no {} of the sequence's {} is chosen", first, and_last, what, count));
  return numbers;
}

void add_range_options(CLI::App& command, FrameRange& range, const std::string& group) {
  command.add_option("--first", range.first, "The first frame, counted from 0")->capture_default_str()->group(group);
  command.add_option("--last", range.last, "The frame to stop before (default: all)")->group(group);
  command.add_option("--every", range.every, "Use every N-th frame")
      ->check(CLI::Range(1, 1'000'000'000))
      ->capture_default_str()
      ->group(group);
}

}  // namespace augicp::app
