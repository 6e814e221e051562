// SPDX-License-Identifier: MIT
// Is a pose the right one? Decided here and only here, from plain numbers.
//
// The end of the loop is no evidence: it ends in wrong minima, and between clouds that have nothing in common. The
// evidence is the comparison of the clouds: points that the other's camera saw through, points behind its surface,
// points beside it, or with another normal. A right pose has a few per cent of these in both directions, for any
// overlap. Without lines of sight, a part that leaves the other surface is one.
#pragma once

#include <limits>
#include <vector>

#include "augicp/core/words.h"
#include "augicp/geometry/rigid3.h"
#include "augicp/match/agreement.h"
#include "augicp/trust/residuals.h"
#include "augicp/trust/status.h"

namespace augicp {

// What one cloud shows of the other, as shares in [0, 1].
struct Testimony {
  Agreement count;
  bool knows_free_space = false;  // it is a depth image, so free space is known

  // Share of the largest part that contradicts the other cloud, see contradiction.h. Not asked, and 0, where free space
  // is known from a place that is more than assumed: what moved between the scans stands in it.
  double contradicting = 0.0;

  // How well points off the large planes agree, relative to those on them, see beyond_planes.h. A depth image is asked
  // only where it has readings. Not asked, and 1, where both clouds know their free space and the pose is near the
  // guess.
  double off_planes = 1.0;

  // Points behind the other's surface are excluded: the camera could not see them under a right pose either. If a wrong
  // pose hides a surface on one side, it causes conflicts on the other.
  double seen() const;         // share of all points that the other sensor should see
  double agreeing() const;     // share of those on a surface with an agreeing normal; 0 if there are none
  double conflicting() const;  // share of those in front of what the camera saw
  double margin() const;       // seen, minus the share of those that does not agree
};

// Which of the two clouds is a part of the other, which shows all of it.
enum class Part { None, Source, Target };

// All that is known about a pose.
struct Evidence {
  Testimony source_in_target, target_in_source;
  Residuals residuals;
  double last_step = std::numeric_limits<double>::infinity();           // of the loop, divided by the clouds' extent
  double last_rotation_step = std::numeric_limits<double>::infinity();  // radians
  double observability = 1.0;                                           // of the weakest direction, see observability.h
  double beyond_planes = 1.0;    // share of the points that agree off the three largest planes, see beyond_planes.h
  double moved = 0.0;            // RMS motion of the source from the guess, divided by its radius of gyration
  double outvoted = 0.0;         // by a clearly different pose, see registration/start/votes.h; 0: not asked
  Part known_part = Part::None;  // known before this pose was judged
};

// None also if each shows all of the other: then they are two scans of one whole.
Part part_of(const Evidence& evidence);

// Evidence::moved without a guess: a pose is then as far from it as a half turn takes the points, and none is nearer
// than another.
inline constexpr double kMovedFromAnywhere = 2.0;

// Limits of a trusted pose. docs/lab/verdict.md has the measurements behind each number.
struct VerdictLimits {
  // The share that should be visible, minus the share of that which does not agree: the smaller the overlap, the better
  // the fit must be; otherwise any corner of a room fits any other. Right poses with 30 % overlap have 0.25 or more in
  // 98 of 100 cases; wrong ones of clouds without common surface have less in 98 of 100.
  double min_margin = 0.246;

  // The same unless both clouds know their free space, of the mean of both sides: the share that should be visible,
  // minus this many times the share of that which does not agree. Right poses of generated rooms have 0.116 and more,
  // of fragments of real ones 0.137 and more but for one; 16 of 17 mirrored rooms that nothing else refuses have less
  // than 0.081.
  double disagreement_weight_without_camera = 5.0;
  double min_margin_without_camera = 0.1;

  // The least share of these that agrees. Right poses of depth images have 0.86 and more in 99 of 100 cases, wrong ones
  // less than 0.9 in nine of ten. Without a camera what lies far off is merely unseen, so that more must agree; but
  // right poses of two LiDAR pairs and of room fragments have no more than 0.855 to 0.89 on one side.
  double min_agreeing = 0.8;
  double min_agreeing_without_camera = 0.85;

  // The largest share of points in front of what the other camera saw. Grazing surfaces and pixels on depth jumps give
  // up to 0.05 under right poses; wrong ones have more in nine of ten cases.
  double max_conflicting = 0.05;

  // The largest share of a connected part that leaves the other's surface where that goes on. Right poses of generated
  // objects have up to 0.008, of LiDAR scans whose sensor's place is unknown up to 0.016; a mug turned so that its
  // handle is elsewhere has 0.04.
  double max_contradicting = 0.018;

  // How well, relative to the points on large planes, those off them agree at least in one of the clouds. In right
  // pairs of rooms, streets and LiDAR scans it is 0.87 and more. A mirrored room has 0.3 to 0.65: its walls fit, its
  // furniture does not.
  double min_off_planes = 0.75;

  // Three bare planes fit any other three. If less than this share of the points that agree is off them, the data show
  // only that a corner was found. The pose must then be near the guess: at most this many radii of gyration from it,
  // and with a larger share farther in proportion, so that 1 % allows any pose. Right poses that are found without a
  // guess have 2 % and more.
  double min_beyond_planes = 0.0025;
  double max_moved_on_planes = 0.5;

  // Farther than this from the guess, in radii of gyration (a rotation by 30 degrees), off_planes is asked although
  // both clouds know their free space, and poses that are found without the guess compete.
  double max_moved_near_guess = 0.5;

  // Without a guess the largest mean of both sides' shares in free space is this, if at least this share is off the
  // planes. The fewer are, the less: the walls of another room fit, and only free space contradicts. Without any it is
  // this part. With a guess the ratio to this limit is multiplied by half of the distance from it in radii of gyration,
  // at most 1. Right poses of generated rooms and LiDAR scans have up to 0.93 of the limit, and wrong ones of rooms
  // that share nothing and pass all other limits 1.08 and more. Both ratios, c of this limit and m of little_seen,
  // count together: the cube root of c^3 + m^3 is at most 1. Right poses have up to 0.93, four of six wrong ones that
  // pass all else 1.04 and more.
  double max_mean_conflicting = 0.03;
  double enough_beyond_planes = 0.1;
  double conflicting_on_planes = 0.3;

  // Without a guess, how many times as many pairs of points that look alike support a clearly different pose, times the
  // largest ratio of all other evidence to its limit, and nearer to a guess in proportion: a pose that everything else
  // supports well may have fewer than another, one near a limit must have more. Right poses of rooms, streets, objects,
  // fragments and LiDAR scans have up to 0.51 in 156 pairs, of other scenes up to 0.7 but for a street of 1.07; wrong
  // ones near the other limits have 0.83 and more.
  double max_outvoted = 0.75;

  // The loop has settled if its last step is below these, in extents and radians. Correspondences of pixels change with
  // every step, so it may move by a tenth of a millimetre for ever. Far from a minimum its steps stay above these.
  double max_last_step = 4e-4;
  double max_last_rotation_step = 1e-3;

  // Throws std::invalid_argument naming the first limit out of its range.
  void check() const;
};

// Why a pose is doubtful.
enum class Doubt {
  LittleSeen,     // the overlap is too small for the quality of the agreement
  Disagreement,   // too few of the visible points are on the other's surface
  FreeSpace,      // too many are in free space of the other's camera
  Contradiction,  // a part leaves the other's surface where that goes on
  BarePlanes,     // only three planes agree, far from the guess
  OnlyPlanes,     // large planes agree far better than what lies off them
  Outvoted,       // points that look alike speak for another pose, far from the guess
  LeftGuess,      // it has moved along what is free
};
template <>
inline constexpr auto kWords<Doubt> = std::to_array<Word<Doubt>>({{Doubt::LittleSeen, "little_seen"},
                                                                  {Doubt::Disagreement, "disagreement"},
                                                                  {Doubt::FreeSpace, "free_space"},
                                                                  {Doubt::Contradiction, "contradiction"},
                                                                  {Doubt::BarePlanes, "bare_planes"},
                                                                  {Doubt::OnlyPlanes, "only_planes"},
                                                                  {Doubt::Outvoted, "outvoted"},
                                                                  {Doubt::LeftGuess, "left_guess"}});

struct Verdict {
  AlignStatus status = AlignStatus::Doubtful;
  std::vector<Doubt> doubts;  // of the status Doubtful, or beside another; in the order above
};

// The largest ratio of a value of the evidence to its limit, over the doubts: above 1 if there is a doubt.
double strain(const Evidence& evidence, const VerdictLimits& limits = {});

// How far those ratios are above 1, by at most 2 each, summed over the doubts; 0 without a doubt. Of two poses that are
// not supported the one with less is the better one: a car that has driven on contradicts one limit of the right pose,
// a wrong pose most.
double excess(const Evidence& evidence, const VerdictLimits& limits = {});

// Whether the loop's last step was small enough.
bool has_settled(const Evidence& evidence, const VerdictLimits& limits = {});

// The status of a pose. `reached` is the status of the loop. Converged and IterationLimit become Converged,
// IterationLimit or Doubtful. All others need no evidence and stay unchanged.
Verdict decide(AlignStatus reached, const Evidence& evidence, const VerdictLimits& limits = {});

// A pose that the evidence supports beside the one that was found, and clearly different from it.
struct RunnerUp {
  Rigid3 target_from_source;  // as AlignResult::target_from_source
  Evidence evidence;
};

// Whether the evidence supports another pose as well as the best one. A rival lies far from the guess by its nature: it
// counts as if it had moved no farther than the best pose. Its strain exceeds that of the best pose by at most 0.4:
// between poses that fit alike it differs by chance. For the limit of both sides' free space its own distance counts.
bool fits_as_well(Evidence rival, const Evidence& best, const VerdictLimits& limits = {});

// Whether the pose that the guess leads to may be the right one although a limit refuses it by little, or although it
// has not settled. A pose elsewhere that is supported, such as the half-turned one among columns, is then not the only
// answer.
bool may_fit(Evidence of_guess, const Evidence& best, const VerdictLimits& limits = {});

}  // namespace augicp
