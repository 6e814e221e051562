// SPDX-License-Identifier: MIT
#include "augicp/match/agreement.h"

namespace augicp {

Agreement counted(std::span<const PointAgreement> points) {
  Agreement count;
  std::int64_t* const of[] = {&count.agree, &count.differ, &count.conflict, &count.hidden, &count.unseen};
  for (const PointAgreement point : points) ++*of[static_cast<std::size_t>(point)];
  return count;
}

}  // namespace augicp
