// SPDX-License-Identifier: MIT
// From two scans and a pose to the numbers that trust/verdict.h decides by.
#pragma once

#include <memory>

#include "augicp/align/align.h"
#include "augicp/match/matcher.h"
#include "augicp/registration/prepared_pair.h"
#include "augicp/trust/contradiction.h"

namespace augicp {

// Pairs along lines of sight, for which the scan must be a depth image, or with the nearest point. A cloud whose
// sensor's place is known also knows its free space. The scan must outlive it.
std::unique_ptr<ScanMatcher> matcher_for(const Scan& scan, bool projective, const Lengths& lengths);

// The place of a cloud's sensor, or of a depth image's camera, if it is known; relative to the cloud's origin.
std::optional<Vec3f> sensor_place(const Scan& scan, const Lengths& lengths);

// What a judge compares the target with.
std::unique_ptr<ScanMatcher> matcher_of_source(const ScanPair& pair);

// How far from a scan's surface a point of the other still is on it. Depth images are measured: a noisy one allows
// more.
AgreementTolerance tolerance_of(const Scan& scan, const Lengths& lengths);

// Judges poses between two scans, all by the same evidence: what the scans say of each other. It compares a few
// thousand points of each scan, evenly spread: they tell a share to a hundredth, in a small part of the registration's
// time. Lines of sight are those of each scan that is a depth image or has a known place of its sensor.
//
// Scans and matcher must outlive it.
// Thread safety: const calls may run concurrently.
class Judge {
 public:
  // matcher: of the target, as it is registered with. guess: where the search for the pose began; not set: anywhere.
  // source_says: that of matcher_of_source(); null: it is made.
  Judge(const ScanPair& pair, const ScanMatcher& matcher, const std::optional<Rigid3>& guess_target_from_source,
        const AlignOptions& options, std::unique_ptr<ScanMatcher> source_says = nullptr);

  // Under a pose between the scans' points.
  Evidence evidence(const Rigid3& target_from_source) const;

  // What the target says of points of the source under a pose, and then the source of points of the target. Of the same
  // points under any pose.
  std::vector<PointAgreement> agreements(const Rigid3& target_from_source) const;

  // A result of align() with its evidence, and its status by decide().
  AlignResult judged(AlignResult result) const;

 private:
  // Points of one scan, and what compares them with the other.
  struct Side {
    const Cloud& asked;
    const std::vector<bool>& on_planes;  // of the asked ones; may be empty
    const Scan& other;
    const ScanMatcher& other_says;
    const AgreementTolerance& on_other;
  };
  Side source_in_target() const;
  Side target_in_source() const;
  // other: where the compared points of the other scan lie.
  Testimony testimony(const Side& side, const PosedCloud& other, bool is_far_from_guess, int num_threads) const;

  // Fills in the part of the evidence that is about correspondences.
  void ask_pairs(const Rigid3& target_from_source, int num_threads, Evidence& evidence) const;

  ScanPair pair_;
  const ScanMatcher& matcher_;
  std::optional<Rigid3> guess_target_from_source_;
  AlignOptions options_;
  AgreementTolerance on_source_, on_target_;                     // of points on each scan
  Cloud of_source_, of_target_;                                  // the points that are compared
  std::vector<bool> on_planes_of_source_, on_planes_of_target_;  // of these; empty if not asked near the guess
  std::unique_ptr<ScanMatcher> target_says_, source_says_;       // what they are compared with; null: matcher_
};

// Whether a pose is not at the guess along what is free there. Degenerate promises that it is. Far from the guess there
// may be no way back, and the pose is doubtful.
bool has_left_along_free(const AlignResult& result, const Rigid3& guess_target_from_source);

// Whether the evidence supports the pose: it converged, or some of its motions are free and there is no doubt about the
// others.
bool is_supported(const AlignResult& judged);

// Whether the evidence prefers one of two results for the same scans: a supported one, or else the one with the lower
// strain.
bool is_better(const AlignResult& judged, const AlignResult& than_judged);

}  // namespace augicp
