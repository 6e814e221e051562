// SPDX-License-Identifier: MIT
// The outcome of one frame of an odometry: of a depth image, or of a LiDAR scan.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "augicp/core/types.h"
#include "augicp/core/words.h"
#include "augicp/geometry/rigid3.h"
#include "augicp/shutter/sweep.h"
#include "augicp/trust/free_motions.h"
#include "augicp/trust/status.h"

namespace augicp {

enum class FrameStatus {
  Started,     // a segment begins here: its pose is the last one known, or the identity
  Tracked,     // registered to the reference
  Degenerate,  // registered, but some direction of motion is not held by what is seen: that part is the prediction
  Doubtful,    // registered, but what the frame and the reference say of each other speaks against it: not merged
  Lost,        // not registered: no pose
  NoReadings,  // too few readings to register: no pose
  OutOfOrder,  // not after the frame before: ignored, no pose
  Unreadable,  // the image could not be used, see FrameReport::problem: no pose
};
template <>
inline constexpr auto kWords<FrameStatus> = std::to_array<Word<FrameStatus>>({{FrameStatus::Started, "started"},
                                                                              {FrameStatus::Tracked, "tracked"},
                                                                              {FrameStatus::Degenerate, "degenerate"},
                                                                              {FrameStatus::Doubtful, "doubtful"},
                                                                              {FrameStatus::Lost, "lost"},
                                                                              {FrameStatus::NoReadings, "no_readings"},
                                                                              {FrameStatus::OutOfOrder, "out_of_order"},
                                                                              {FrameStatus::Unreadable, "unreadable"}});

// Whether a frame of this status has a pose.
bool has_pose(FrameStatus status);

// What a LiDAR scan's direct registration to a single keyframe farther back says of its pose, which a chain of
// registrations has given: how far the chain has drifted since. See self_check.h.
struct DriftCheck {
  double keyframe_stamp_s = 0.0;
  double distance_m = 0.0;      // between the two places of the sensor
  Rigid3 keyframe_from_sensor;  // by the direct registration; both at the middle of their sweeps
  double drift_m = 0.0;         // of the chained pose from the direct one
  double drift_deg = 0.0;

  // What the covariances of the three registrations explain of the place of a typical point: three deviations, metres.
  double expected_m = 0.0;

  // The share of the scan's points on the keyframe's surfaces, by either pose.
  double share_chained = 0.0, share_direct = 0.0;

  // The drift is clearly above expected_m, and the direct pose brings more points onto the keyframe's surfaces.
  bool contradicts = false;
};

struct FrameReport {
  double stamp_s = 0.0;
  FrameStatus status = FrameStatus::Lost;
  Rigid3 world_from_camera;  // the world is the first camera; at the middle of the image's readout
  int segment = 0;           // poses of different segments have no measured motion between them
  bool is_keyframe = false;

  // Of the registration, if one was made.
  std::optional<AlignStatus> registration;
  int iterations = 0;
  std::int64_t num_pairs = 0;
  double overlap = 0.0;
  double rmse = 0.0;    // metres
  double strain = 0.0;  // of the evidence for the pose, see trust/verdict.h

  // Of a LiDAR scan alone: of its pose, as AlignResult has it, about the place of the last keyframe; and where the
  // status is Degenerate, the motions that the map leaves open.
  std::optional<Mat6d> covariance;
  std::vector<FreeMotion> free_motions;

  // Of a LiDAR scan that was straightened: the motion during its sweep, see without_skew().
  std::optional<SweepMotion> motion;

  // Of the LiDAR scans that were checked.
  std::optional<DriftCheck> drift;

  // In words, where the status is NoReadings, OutOfOrder or Unreadable, or the self-check contradicts.
  std::string problem;
};

// The report on a frame whose data could not be used, and why.
FrameReport unreadable_frame(double stamp_s, int segment, std::string problem);

// The report on a frame whose stamp is not finite, or not after the last one.
FrameReport frame_out_of_order(double stamp_s, int segment, const std::optional<double>& last_stamp_s);

}  // namespace augicp
