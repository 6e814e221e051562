// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "augicp/cloud/correspondence.h"
#include "augicp/match/agreement.h"
#include "augicp/match/gates.h"
#include "augicp/search/kd_tree.h"
#include "augicp/sensor/depth_image.h"

namespace augicp {

// Guesses the pairs of one source under one pose after the other, and may remember from each what makes the next one
// faster: what it finds does not depend on what was asked before. For one thread at a time.
class Matching {
 public:
  virtual ~Matching() = default;

  // See Matcher::match().
  virtual std::vector<Correspondence> match(const Rigid3& target_from_source, const Gates& gates, int num_threads) = 0;
};

// Guesses pairs under a pose; made for one target, which must outlive it. Const calls may run concurrently.
class Matcher {
 public:
  virtual ~Matcher() = default;

  virtual const Cloud& target() const = 0;

  // The pairs, in an order that depends on the clouds only. target_from_source maps between the clouds' points, without
  // their origins.
  virtual std::vector<Correspondence> match(const Cloud& source, const Rigid3& target_from_source, const Gates& gates,
                                            int num_threads) const = 0;

  // For one pose after the other: what align() asks. The matcher and the source must outlive it. Unless overridden, it
  // calls match() for each; who overrides match() of a NearestMatcher must override it, too.
  virtual std::unique_ptr<Matching> matching(const Cloud& source) const;

  // What the target says of the source under a pose, whatever pairs there are. The same for any number of threads.
  virtual Agreement agreement(const Cloud& source, const Rigid3& target_from_source,
                              const AgreementTolerance& tolerance, int num_threads) const = 0;
};

// The nearest target point of every source point.
class NearestMatcher : public Matcher {
 public:
  explicit NearestMatcher(const Cloud& target);
  const Cloud& target() const override { return target_; }
  std::vector<Correspondence> match(const Cloud& source, const Rigid3& target_from_source, const Gates& gates,
                                    int num_threads) const override;
  std::unique_ptr<Matching> matching(const Cloud& source) const override;

  // What lies farther than some tolerances from every target point is unseen: a cloud does not say what was free.
  Agreement agreement(const Cloud& source, const Rigid3& target_from_source, const AgreementTolerance& tolerance,
                      int num_threads) const override;

 private:
  const Cloud& target_;
  KdTree tree_;
};

class PairFilter;

// "Line of sight" (section 4.1): the source is projected into the target's depth image, and what is seen in a pixel is
// paired with the target point of that pixel: the nearest point where there are several, but of a few points in a large
// image all.
class ProjectiveMatcher : public Matcher {
 public:
  // index: the pixel each point of the target was seen in by the camera; it must outlive the matcher too.
  ProjectiveMatcher(const Cloud& target, const IndexImage& index, const Pinhole& camera);
  const Cloud& target() const override { return target_; }
  std::vector<Correspondence> match(const Cloud& source, const Rigid3& target_from_source, const Gates& gates,
                                    int num_threads) const override;
  Agreement agreement(const Cloud& source, const Rigid3& target_from_source, const AgreementTolerance& tolerance,
                      int num_threads) const override;

 private:
  std::vector<Correspondence> match_points(const Cloud& source, const PairFilter& filter) const;

  const Cloud& target_;
  const IndexImage& index_;
  Pinhole camera_;
};

}  // namespace augicp
