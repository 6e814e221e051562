// SPDX-License-Identifier: MIT
#include "augicp/trust/status.h"

namespace augicp {

bool has_pose(AlignStatus status) {
  return status == AlignStatus::Converged || status == AlignStatus::IterationLimit ||
         status == AlignStatus::Degenerate || status == AlignStatus::Doubtful || status == AlignStatus::Ambiguous;
}

}  // namespace augicp
