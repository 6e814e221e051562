// SPDX-License-Identifier: MIT
#include "augicp/registration/start/lead_on.h"

#include <optional>

#include "augicp/core/parallel.h"

namespace augicp {
namespace {

std::optional<Hypothesis> led_on(const ScanMatch& level, const Rigid3& start, const AlignOptions& options) {
  const AlignResult result = level.align(start, options);
  if (!has_pose(result.status)) return std::nullopt;
  return Hypothesis{result.target_from_source, level.plausibility(result.target_from_source, options.num_threads),
                    result.status == AlignStatus::Degenerate};
}

}  // namespace

AlignOptions on_one_thread(AlignOptions options) {
  options.num_threads = 1;
  return options;
}

std::vector<Hypothesis> led_on(const ScanMatch& level, std::span<const Rigid3> starts, const AlignOptions& options) {
  std::vector<std::optional<Hypothesis>> of_start(starts.size());
  const AlignOptions alone = on_one_thread(options);
  const auto follow = [&](std::size_t k, std::size_t) { of_start[k] = led_on(level, starts[k], alone); };
  for_each_block(starts.size(), options.num_threads, follow, 1);
  std::vector<Hypothesis> found;
  for (const auto& hypothesis : of_start)
    if (hypothesis) found.push_back(*hypothesis);
  return found;
}

}  // namespace augicp
