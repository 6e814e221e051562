// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "augicp/cloud/correspondence.h"
#include "augicp/match/agreement.h"
#include "augicp/match/gates.h"
#include "augicp/match/range_image.h"
#include "augicp/search/kd_tree.h"
#include "augicp/sensor/depth_image.h"

namespace augicp {

// Finds the pairs of one source under one pose after another. It may remember from each what makes the next one faster;
// what it finds does not depend on what was asked before.
// Thread safety: one thread at a time.
class MatchSession {
 public:
  virtual ~MatchSession() = default;

  // See Matcher::match().
  virtual std::vector<Correspondence> match(const Rigid3& target_from_source, const Gates& gates, int num_threads) = 0;
};

// Finds pairs under a pose. Made for one target, which must outlive it. Poses are between the clouds' points, without
// their origins. The result is bit-identical for any number of threads.
// Thread safety: const calls may run concurrently.
class Matcher {
 public:
  virtual ~Matcher() = default;

  virtual const Cloud& target() const = 0;

  // The pairs, in an order that depends on the clouds only.
  virtual std::vector<Correspondence> match(const Cloud& source, const Rigid3& target_from_source, const Gates& gates,
                                            int num_threads) const = 0;

  // For one pose after another, as align() needs them. The matcher and the source must outlive it. The default calls
  // match() for each.
  virtual std::unique_ptr<MatchSession> session(const Cloud& source) const;

  // The pairs under each of several poses that are near each other. The default calls match() of a session for each.
  virtual std::vector<std::vector<Correspondence>> match_each(const Cloud& source, std::span<const Rigid3> poses,
                                                              const Gates& gates, int num_threads) const;
};

// Compares a target with a source under a pose, whatever pairs there are.
// Thread safety: const calls may run concurrently. The result is the same for any number of threads.
class AgreementCounter {
 public:
  virtual ~AgreementCounter() = default;

  // What the target says of each source point.
  virtual std::vector<PointAgreement> agreements(const Cloud& source, const Rigid3& target_from_source,
                                                 const AgreementTolerance& tolerance, int num_threads) const = 0;

  // The number of points with each answer.
  Agreement agreement(const Cloud& source, const Rigid3& target_from_source, const AgreementTolerance& tolerance,
                      int num_threads) const {
    return counted(agreements(source, target_from_source, tolerance, num_threads));
  }

  // Whether the answers tell free and hidden places from those that the target did not see.
  virtual bool knows_free_space() const { return false; }
};

// What a registration needs of each of its scans.
class ScanMatcher : public Matcher, public AgreementCounter {};

// The nearest target point of every source point.
class NearestMatcher final : public ScanMatcher {
 public:
  // lines_of_sight: of the target, if its sensor's place is known.
  explicit NearestMatcher(const Cloud& target, std::optional<RangeImage> lines_of_sight = std::nullopt);
  const Cloud& target() const override { return target_; }
  std::vector<Correspondence> match(const Cloud& source, const Rigid3& target_from_source, const Gates& gates,
                                    int num_threads) const override;
  std::unique_ptr<MatchSession> session(const Cloud& source) const override;
  std::vector<std::vector<Correspondence>> match_each(const Cloud& source, std::span<const Rigid3> poses,
                                                      const Gates& gates, int num_threads) const override;

  // A source point that does not agree lies in free space or is hidden if the lines of sight say so. Otherwise it is
  // unseen if it is farther than some tolerances from every target point.
  std::vector<PointAgreement> agreements(const Cloud& source, const Rigid3& target_from_source,
                                         const AgreementTolerance& tolerance, int num_threads) const override;
  bool knows_free_space() const override { return lines_of_sight_.has_value(); }

 private:
  const Cloud& target_;
  KdTree tree_;
  std::optional<RangeImage> lines_of_sight_;
};

class PairFilter;

// "Line of sight" (section 4.1): the source is projected into the target's depth image, and what is seen in a pixel is
// paired with the target point of that pixel: the nearest point where there are several, but of a few points in a large
// image all.
class ProjectiveMatcher final : public ScanMatcher {
 public:
  // index: the pixel each point of the target was seen in by the camera; it must outlive the matcher too.
  ProjectiveMatcher(const Cloud& target, const IndexImage& index, const Pinhole& camera);
  const Cloud& target() const override { return target_; }
  std::vector<Correspondence> match(const Cloud& source, const Rigid3& target_from_source, const Gates& gates,
                                    int num_threads) const override;
  std::vector<PointAgreement> agreements(const Cloud& source, const Rigid3& target_from_source,
                                         const AgreementTolerance& tolerance, int num_threads) const override;
  bool knows_free_space() const override { return true; }

 private:
  std::vector<Correspondence> match_points(const Cloud& source, const PairFilter& filter) const;

  const Cloud& target_;
  const IndexImage& index_;
  Pinhole camera_;
};

}  // namespace augicp
