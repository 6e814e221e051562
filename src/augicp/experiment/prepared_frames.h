// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <vector>

#include "augicp/experiment/sequence.h"
#include "augicp/registration/registration.h"

namespace augicp {

struct PreparedFrame {
  double stamp_s = 0.0;
  std::vector<Scan> scans;  // one per preset
};

// The frames of a sequence with their surfaces, made on first use. REQUIRES: its inputs outlive it.
class PreparedFrames {
 public:
  PreparedFrames(const DepthSequence& sequence, const DepthCamera& camera, const SequenceOptions& options)
      : sequence_(sequence), camera_(camera), options_(options) {}

  // Valid until the frame is forgotten. Throws IoError if the image cannot be read.
  const PreparedFrame& at(std::size_t frame);

  void forget_before(std::size_t frame) { frames_.erase(frames_.begin(), frames_.lower_bound(frame)); }

 private:
  PreparedFrame made(std::size_t frame) const;

  const DepthSequence& sequence_;
  const DepthCamera& camera_;
  const SequenceOptions& options_;
  std::map<std::size_t, PreparedFrame> frames_;
};

// Options of single frames.
RegistrationOptions frame_options(Preset preset, const SequenceOptions& options);

}  // namespace augicp
