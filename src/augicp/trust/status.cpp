// SPDX-License-Identifier: MIT
#include "augicp/trust/status.h"

#include <array>

namespace augicp {

std::string_view name_of(AlignStatus status) {
  constexpr std::array<std::string_view, 7> kNames{"converged",  "iteration_limit", "degenerate", "too_few_pairs",
                                                   "no_overlap", "diverged",        "doubtful"};
  return kNames[static_cast<std::size_t>(status)];
}

bool has_pose(AlignStatus status) {
  return status == AlignStatus::Converged || status == AlignStatus::IterationLimit ||
         status == AlignStatus::Degenerate || status == AlignStatus::Doubtful;
}

}  // namespace augicp
