// SPDX-License-Identifier: MIT
#include "augicp/registration/scan_match.h"

#include <stdexcept>

#include "augicp/registration/judge.h"
#include "augicp/registration/start/hypotheses.h"

namespace augicp {
namespace {

// How far two readings of the same place may be apart: cameras err with depth, and so does a pose's rotation. Without a
// camera it is the ball in which surfaces were estimated.
constexpr double kDistancePerRadius = 0.2;
constexpr double kDistancePerDepth = 0.025;

AgreementTolerance tolerance_for(const Scan& scan, const Lengths& lengths, Association association) {
  if (is_projective(scan, association)) return {kDistancePerRadius * lengths.radius, kDistancePerDepth};
  return {lengths.radius};
}

}  // namespace

bool is_projective(const Scan& target, Association association) {
  if (association == Association::Projective && !target.view)
    throw std::invalid_argument("association = projective: the target is not a depth image with a camera");
  return target.view && association != Association::Nearest;
}

ScanMatch::ScanMatch(Scan source, Scan target, const Lengths& lengths, const RegistrationOptions& options)
    : source_(std::move(source)),
      target_(std::move(target)),
      lengths_(lengths),
      options_(options),
      in_target_(matcher_for(target_, is_projective(target_, options.association))),
      in_source_(matcher_for(source_, source_.view && options.association != Association::Nearest)) {}

AlignOptions ScanMatch::usual_options() const {
  AlignOptions options = align_options(lengths_, is_projective(target_, options_.association), options_);
  options.correlation_length = 0.0;  // nobody asks how sure a start is
  options.intensity_weight = 0.0;
  return options;
}

AlignResult ScanMatch::align(const Rigid3& guess, const AlignOptions& options) const {
  return augicp::align(source_.cloud, *in_target_, guess, options);
}

double ScanMatch::plausibility(const Rigid3& target_from_source, int num_threads) const {
  const Rigid3 pose = without_origins(target_from_source, source_.cloud, target_.cloud);
  Agreement agreement =
      in_target_->agreement(source_.cloud, pose, tolerance_for(target_, lengths_, options_.association), num_threads);
  const Association back = source_.view ? options_.association : Association::Nearest;
  agreement += in_source_->agreement(target_.cloud, inverse(pose), tolerance_for(source_, lengths_, back), num_threads);
  return augicp::plausibility(agreement);
}

std::vector<Correspondence> ScanMatch::pairs(const Rigid3& target_from_source) const {
  return in_target_->match(source_.cloud, without_origins(target_from_source, source_.cloud, target_.cloud),
                           usual_options().gates, options_.num_threads);
}

}  // namespace augicp
