// SPDX-License-Identifier: MIT
#include "augicp/registration/scan_match.h"

#include <stdexcept>
#include <tuple>

#include "augicp/core/parallel.h"
#include "augicp/registration/judge.h"
#include "augicp/registration/start/hypotheses.h"

namespace augicp {
namespace {

// How far two readings of the same place may be apart: cameras err with depth, and so does a pose's rotation. Without a
// camera it is the ball in which surfaces were estimated.
constexpr double kPairDistancePerRadius = 0.2;
constexpr double kPairDistancePerDepth = 0.025;

AgreementTolerance tolerance_for(const Scan& scan, const Lengths& lengths, Association association) {
  if (is_projective(scan, association)) return {kPairDistancePerRadius * lengths.radius, kPairDistancePerDepth};
  return {lengths.radius};
}

}  // namespace

bool is_projective(const Scan& target, Association association) {
  if (association == Association::Projective && !target.view)
    throw std::invalid_argument("association = projective: the target is not a depth image with a camera");
  return target.view && association != Association::Nearest;
}

ScanMatch::ScanMatch(const ScanPair& pair, const RegistrationOptions& options) : scans_(pair), options_(options) {
  const bool in_image = is_projective(pair.target, options.association),
             back_in_image = pair.source.view && options.association != Association::Nearest;
  std::tie(in_target_, in_source_) = both(
      options.num_threads, [&] { return matcher_for(pair.target, in_image, pair.lengths); },
      [&] { return matcher_for(pair.source, back_in_image, pair.lengths); });
}

AlignOptions ScanMatch::usual_options() const {
  AlignOptions options = align_options(scans_.lengths, is_projective(scans_.target, options_.association), options_);
  options.correlation_length = 0.0;  // nobody asks how sure a start is
  options.intensity_weight = 0.0;
  return options;
}

AlignResult ScanMatch::align(const Rigid3& guess, const AlignOptions& options) const {
  return augicp::align(scans_.source.cloud, *in_target_, guess, options);
}

std::optional<Rigid3> ScanMatch::scouted(const Rigid3& guess, const AlignOptions& options,
                                         const KnowsPose& is_known) const {
  const auto session = in_target_->session(scans_.source.cloud);
  return augicp::scouted({scans_.source.cloud, *in_target_, *session}, guess, options, is_known);
}

double ScanMatch::plausibility(const Rigid3& target_from_source, int num_threads) const {
  const Scan &source = scans_.source, &target = scans_.target;
  const Association back = source.view ? options_.association : Association::Nearest;
  const AgreementTolerance in_target = tolerance_for(target, scans_.lengths, options_.association),
                           in_source = tolerance_for(source, scans_.lengths, back);
  const int half = half_of_threads(num_threads);
  auto [agreement, of_target] = both(
      num_threads, [&] { return in_target_->agreement(source.cloud, target_from_source, in_target, half); },
      [&] { return in_source_->agreement(target.cloud, inverse(target_from_source), in_source, half); });
  agreement += of_target;
  return augicp::plausibility(agreement);
}

std::vector<Correspondence> ScanMatch::pairs(const Rigid3& target_from_source) const {
  return in_target_->match(scans_.source.cloud, target_from_source, usual_options().gates, options_.num_threads);
}

}  // namespace augicp
