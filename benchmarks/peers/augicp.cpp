// SPDX-License-Identifier: MIT
// augicp itself in the shape of a peer, on one thread: the library's defaults.
#include "augicp/registration/registration.h"
#include "benchmarks/peers/common/run_peer.h"

namespace augicp::peers {
namespace {

Scan scan_of_input(const Input& input, const std::optional<Pinhole>& camera) {
  return input.image ? scan_of(*input.image, camera.value()) : scan_of(input.cloud);
}

// Statuses with which the command fails as well: there is no pose to trust.
bool failed(AlignStatus status) {
  return status == AlignStatus::TooFewPairs || status == AlignStatus::NoOverlap || status == AlignStatus::Diverged;
}

Found run(const Pair& pair, const RegistrationOptions& options) {
  Found found;
  Stopwatch watch;
  const PreparedPair prepared =
      prepare_pair(scan_of_input(pair.source, pair.camera), scan_of_input(pair.target, pair.camera), options);
  found.preprocess_ms = watch.lap_ms();
  const AlignResult result = register_prepared(prepared, pair.guess, options);
  found.align_ms = watch.lap_ms();
  if (!failed(result.status)) found.target_from_source = result.target_from_source;
  found.verdict = name_of(result.status);
  found.score = result.overlap;
  found.iterations = result.iterations;
  return found;
}

RegistrationOptions one_thread(augicp::Method objective) {
  RegistrationOptions options;
  options.method = objective;
  options.num_threads = 1;
  return options;
}

Method method(std::string name, const RegistrationOptions& options) {
  return {std::move(name), [options](const Pair& pair) { return run(pair, options); }};
}

}  // namespace
}  // namespace augicp::peers

int main(int argc, char** argv) {
  using namespace augicp::peers;
  const Peer peer{
      "augicp",
      1,
      {method("augmented", one_thread(augicp::Method::Augmented)), method("gicp", one_thread(augicp::Method::Gicp))}};
  return run_peer(argc, argv, peer);
}
