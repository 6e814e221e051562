// SPDX-License-Identifier: MIT
// Is a pose that was found the right one? Decided here and only here, from plain numbers.
//
// That the loop ended says nothing: it ends in wrong minima too, and between clouds that have nothing in common. What
// speaks against a wrong pose is what each cloud says of the other: points that the other's camera saw through, points
// behind its surface, points beside it or turned against it. A right pose leaves a few per cent of these in both
// directions, whatever share of the clouds overlaps.
#pragma once

#include <limits>
#include <string_view>
#include <vector>

#include "augicp/match/agreement.h"
#include "augicp/trust/residuals.h"
#include "augicp/trust/status.h"

namespace augicp {

// What one cloud says of the other, as shares in [0, 1].
struct Testimony {
  Agreement count;
  bool knows_free_space = false;  // it is a depth image: it says what its camera saw through

  // Points behind the other's surface are left out: the camera could not see them under a right pose either. What a
  // wrong pose hides on one side conflicts on the other.
  double seen() const;         // of all points: should have been visible to the other sensor
  double agreeing() const;     // of those: found again on a surface turned alike; 0 where there are none
  double conflicting() const;  // of those: in front of what the camera saw
  double margin() const;       // seen, less the share of those that does not agree
};

// All that is known of a pose that was found.
struct Evidence {
  Testimony source_in_target, target_in_source;
  Residuals residuals;
  double last_step = std::numeric_limits<double>::infinity();           // of the loop, as a part of the clouds' extent
  double last_rotation_step = std::numeric_limits<double>::infinity();  // radians
  double observability = 1.0;                                           // of the weakest direction, see observability.h
  double beyond_planes = 1.0;  // of what agrees: the share off the three planes that hold most, see beyond_planes.h
  double moved = 0.0;          // what the pose moved the source from the guess (RMS), by its radius of gyration
};

// What a trusted pose must keep to. docs/lab/verdict.md has the measurements behind each number.
struct VerdictLimits {
  // The share that should have been visible, less the share of that which does not agree: the less two clouds have in
  // common, the better it must fit, or any corner of a room fits any other. Right poses of clouds that overlap by 30 %
  // have 0.25 and more in 98 of 100 cases, wrong ones of clouds without common surface less in 98 of 100.
  double min_margin = 0.246;

  // The least share of these that agrees. Right poses of depth images have 0.86 and more in 99 of 100 cases, wrong ones
  // less than 0.9 in nine of ten. Without a camera what lies far off is merely unseen, so that more must agree; but
  // right poses of two LiDAR pairs and of room fragments have no more than 0.855 to 0.89 on one side.
  double min_agreeing = 0.8;
  double min_agreeing_without_camera = 0.85;

  // The largest share of points in front of what the other camera saw. Grazing surfaces and pixels on depth jumps give
  // up to 0.05 under right poses; wrong ones have more in nine of ten cases.
  double max_conflicting = 0.05;

  // Three bare planes fit any other three. Where less than this share of what agrees lies off them, the pose says no
  // more than that a corner was found, and must lie where the guess says: no farther than this many radii of gyration
  // from it.
  double min_beyond_planes = 0.0025;
  double max_moved_on_planes = 0.5;

  // The loop counts as ended when its last step is below, parts of the extent and radians. Pairs of pixels change with
  // every step, so that it may go on by a tenth of a millimetre for ever; far from a minimum its steps stay above this.
  double max_last_step = 4e-4;
  double max_last_rotation_step = 1e-3;

  // Throws std::invalid_argument naming the first limit out of its range.
  void check() const;
};

// Why a pose is doubted.
enum class Doubt {
  LittleSeen,    // too few points are in reach of the other cloud for how well they agree
  Disagreement,  // too few of these are on the other's surface
  FreeSpace,     // too many lie where the other's camera saw through
  BarePlanes,    // nothing but three planes agrees, far from where they were guessed to be
};
std::string_view name_of(Doubt doubt);

struct Verdict {
  AlignStatus status = AlignStatus::Doubtful;
  std::vector<Doubt> doubts;  // of the status Doubtful, and beside others; in the order above
};

// The evidence's largest part of what is allowed it, of the doubts alone: above 1 where there is a doubt.
double strain(const Evidence& evidence, const VerdictLimits& limits = {});

// Whether the loop's last step was small enough.
bool has_settled(const Evidence& evidence, const VerdictLimits& limits = {});

// The status of a pose with which the loop ended in `reached`: Converged, or IterationLimit where it was stopped. These
// two become Converged, IterationLimit or Doubtful; all others, which are known without evidence, stay.
Verdict decide(AlignStatus reached, const Evidence& evidence, const VerdictLimits& limits = {});

}  // namespace augicp
