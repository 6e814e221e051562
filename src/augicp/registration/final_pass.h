// SPDX-License-Identifier: MIT
#pragma once

#include "augicp/registration/full_resolution.h"
#include "augicp/registration/registration.h"

namespace augicp {

// `first`, or the registration that follows it. A ball smooths the creases and curves within it, so a converged pose
// has an error of its own, of which its covariance knows little. The final pass starts from that pose and has balls and
// voxels of 0.7 of the first ones. It replaces `first` if
//
//   * it converges too, and the RMS error of the points that its covariance predicts is clearly smaller, and
//   * the evidence supports its pose, by the same scans and tolerances by which `first` was judged.
//
// Without a covariance nothing can be decided. raw: the scans before prepare_pair(). guess: where the search began.
// Poses are between the clouds' points. Iterations and history are those of both; max_iterations limits their sum.
// Throws Interrupted once an end is requested.
Registration with_final_pass(Registration first, RawPair raw, const Guess& guess_target_from_source,
                             const RegistrationOptions& options);

}  // namespace augicp
