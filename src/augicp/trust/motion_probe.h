// SPDX-License-Identifier: MIT
// Do two scans say anything of a motion? Asked of the scans themselves, not of a model of their noise.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "augicp/cloud/cloud.h"
#include "augicp/match/agreement.h"
#include "augicp/search/kd_tree.h"

namespace augicp {

// A cloud that is asked, which must outlive it. sensor_place: of the sensor whose scan it is known to be, metres,
// relative to the cloud's origin.
struct ProbedCloud {
  ProbedCloud(const Cloud& of, const std::optional<Vec3f>& seen_from = {}) : cloud(of), sensor_place(seen_from) {}
  const Cloud& cloud;
  std::optional<Vec3f> sensor_place;
};

// Moves the source a little from a pose, and counts the points of both scans that lie on the other's surface before and
// not afterwards, or the other way round. A motion that changes as many of them for the better as for the worse is
// free.
//
// The information of observability.h is the slope of surfaces. Noise gives slope to a wall, and gaps between scan lines
// look like edges. Neither moves a point off a surface. So only points count that have neighbours all around.
//
// Thread safety: const calls may run concurrently. Both clouds must outlive it.
class MotionProbe {
 public:
  // Both clouds with directions. tolerance.per_depth counts from each cloud's zero. radius: of the balls in which their
  // surfaces were estimated, metres.
  MotionProbe(const ProbedCloud& source, const ProbedCloud& target, const AgreementTolerance& tolerance, double radius);

  // Whether the surroundings of most points are known. Otherwise silence means nothing.
  bool can_tell() const;

  // Whether a pose brings clearly more points onto the other's surface than another pose does: 1, fewer: -1, else 0.
  int compared(const Rigid3& target_from_source, const Rigid3& with_target_from_source) const;

  // Of each direction, whether moving by one or three radii (RMS of the target's points) along it, or against it,
  // changes what the scans say of each other. Directions are increments (metres, radians) about the target's zero, of
  // any length above zero.
  std::vector<bool> spoken_of(const Rigid3& target_from_source, std::span<const Vec6d> directions) const;

  // Of each direction, whether one radius along it, and one against it, each takes more points off the other's surface
  // than onto it. A pose that has slid along a direction is left by a step ahead or back without loss.
  std::vector<bool> held_along(const Rigid3& target_from_source, std::span<const Vec6d> directions) const;

 private:
  enum class Answer : std::uint8_t { Agrees, Differs, None };

  struct Asked {
    explicit Asked(const ProbedCloud& of);
    const Cloud& cloud;
    KdTree tree;
    bool is_drawing;
    std::vector<std::uint32_t> witnesses;
  };

  // A witness where the pose puts it.
  struct Extended {
    Vec3d place;
    std::optional<Vec3d> normal;
    double allowed;
  };

  void choose_witnesses(Asked& scan) const;
  double allowed(const Vec3f& place) const;
  bool is_surrounded(const Asked& scan, std::uint32_t point) const;
  Answer planar_answer(const Asked& other, std::uint32_t point, const Extended& here) const;
  bool is_beyond_border(const Asked& scan, std::uint32_t point, const Vec3d& from_point) const;
  Answer answer(const Asked& scan, std::uint32_t point, const Rigid3& other_from_scan, const Asked& other) const;
  Answer answer_of(const Asked& other, std::uint32_t point, const Extended& here) const;
  std::vector<Answer> answers(const Rigid3& target_from_source) const;
  struct Change {
    std::int64_t agreeing = 0, lost = 0, gained = 0;  // of the points that answer before and after
  };
  static Change change(std::span<const Answer> before, std::span<const Answer> after);
  static int clear_change(const Change& change);
  Vec6d of_a_radius(const Vec6d& direction) const;

  AgreementTolerance tolerance_;
  double radius_;
  Asked source_, target_;
};

}  // namespace augicp
