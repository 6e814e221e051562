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

// lead(start): a hypothesis, if there is one.
template <typename Lead>
std::vector<Hypothesis> each_led(std::span<const Rigid3> starts, int num_threads, const Lead& lead) {
  std::vector<std::optional<Hypothesis>> of_start(starts.size());
  const auto follow = [&](std::size_t k, std::size_t) { of_start[k] = lead(starts[k]); };
  for_each_block(starts.size(), num_threads, follow, 1);
  std::vector<Hypothesis> found;
  for (const auto& hypothesis : of_start)
    if (hypothesis) found.push_back(*hypothesis);
  return found;
}

}  // namespace

AlignOptions on_one_thread(AlignOptions options) {
  options.num_threads = 1;
  return options;
}

std::vector<Hypothesis> led_on(const ScanMatch& level, std::span<const Rigid3> starts, const AlignOptions& options) {
  const AlignOptions alone = on_one_thread(options);
  return each_led(starts, options.num_threads, [&](const Rigid3& start) { return led_on(level, start, alone); });
}

std::vector<Hypothesis> scouted(const ScanMatch& level, std::span<const Rigid3> starts, const AlignOptions& options,
                                const KnowsPose& is_known) {
  const AlignOptions alone = on_one_thread(options);
  const auto lead = [&](const Rigid3& start) -> std::optional<Hypothesis> {
    const auto pose = level.scouted(start, alone, is_known);
    if (!pose) return std::nullopt;
    return Hypothesis{*pose, level.plausibility(*pose, 1), false};
  };
  return each_led(starts, options.num_threads, lead);
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
