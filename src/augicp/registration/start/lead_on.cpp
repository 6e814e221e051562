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

std::vector<Hypothesis> as_they_are(const ScanMatch& level, std::span<const Rigid3> starts, int num_threads) {
  std::vector<Hypothesis> found(starts.size());
  const auto judge = [&](std::size_t k, std::size_t) {
    found[k] = {starts[k], level.plausibility(starts[k], 1), false};
  };
  for_each_block(starts.size(), num_threads, judge, 1);
  return found;
}

}  // namespace augicp
