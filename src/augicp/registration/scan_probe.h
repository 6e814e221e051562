// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "augicp/align/align.h"
#include "augicp/registration/prepared_pair.h"
#include "augicp/trust/motion_probe.h"

namespace augicp {

// The probe of two prepared scans, with the points that it asks: an image has far more than it needs.
class ScanProbe {
 public:
  explicit ScanProbe(const ScanPair& pair);
  ScanProbe(const ScanProbe&) = delete;  // the probe refers to the clouds
  ScanProbe& operator=(const ScanProbe&) = delete;

  const MotionProbe& probe() const { return probe_; }

 private:
  Cloud source_, target_;
  MotionProbe probe_;
};

// The same directions, those that are free first; else in their order. is_free: of each of the six.
FreeDirections free_first(const Observability& seen, const std::vector<bool>& is_free);

}  // namespace augicp
