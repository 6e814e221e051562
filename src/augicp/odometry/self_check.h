// SPDX-License-Identifier: MIT
// A LiDAR odometry checks itself: a scan is registered to a single keyframe farther back, past the map.
#pragma once

#include <deque>
#include <memory>
#include <optional>

#include "augicp/align/align.h"
#include "augicp/odometry/frame_report.h"

namespace augicp {

struct SelfCheckOptions {
  // The keyframe is at least this far back, metres, or the oldest one kept.
  double distance = 10.0;

  // A point this near to a plane lies on it; a pose that is off by less than this agrees. Metres.
  double on_surface = 0.1;

  // A rotation counts as what it moves a point at this distance, metres.
  double typical_distance = 10.0;

  AlignOptions align_by;  // its gate is the last one; the first one is wider
};

// The keyframes of the last metres, and what a direct registration to one of them says of a pose. What the map has
// accumulated since does not enter, so that its drift shows.
//
// Not for concurrent use. Memory: at most kMaxKeyframes scans.
class SelfCheck {
 public:
  static constexpr std::size_t kMaxKeyframes = 24;

  // A keyframe's scan in the sensor's frame, with directions. covariance: of its pose, if known. min_distance: a
  // keyframe nearer than this to the last one kept is left out, metres.
  void remember(double stamp_s, const Cloud& scan, const Rigid3& world_from_sensor,
                const std::optional<Mat6d>& covariance, double min_distance);

  // Points of all keyframes.
  std::size_t num_points() const;

  // Forgets all keyframes.
  void clear() { keyframes_.clear(); }

  // The drift of a scan's pose since a keyframe. Empty where no keyframe is far enough back in time, or the direct
  // registration does not convince: too little overlap, or a motion that the two scans do not constrain.
  std::optional<DriftCheck> check(const Cloud& scan, const Rigid3& world_from_sensor,
                                  const std::optional<Mat6d>& covariance, const SelfCheckOptions& options) const;

 private:
  struct Keyframe {
    double stamp_s;
    Rigid3 world_from_sensor;
    std::optional<Mat6d> covariance;
    Cloud surfaces;  // points on planes and edges, in the sensor's frame
  };

  const Keyframe* chosen(const Vec3d& place_in_world, double distance) const;

  std::deque<std::shared_ptr<const Keyframe>> keyframes_;
};

}  // namespace augicp
