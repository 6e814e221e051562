// SPDX-License-Identifier: MIT
// From depth images, one after the other, to where the camera was.
//
//   depth image --prepare_frame--> extended points --Odometry::add--> FrameReport (pose, status)
#pragma once

#include <optional>
#include <stop_token>

#include "augicp/core/words.h"
#include "augicp/geometry/trajectory.h"
#include "augicp/odometry/frame_report.h"
#include "augicp/odometry/local_model.h"
#include "augicp/registration/registration.h"

namespace augicp {

// What a frame is registered to.
enum class Reference {
  Model,          // what the frames since some keyframe saw, averaged (local_model.h): the least drift
  PreviousFrame,  // the last tracked frame
};
template <>
inline constexpr auto kWords<Reference> = std::to_array<Word<Reference>>({{Reference::Model, "model"},
                                                                          {Reference::PreviousFrame, "previous"}});

// Options of registration for frames that follow one another closely: see odometry.cpp for the reasons.
RegistrationOptions tracking_options();

struct OdometryOptions {
  RegistrationOptions registration = tracking_options();
  Reference reference = Reference::Model;

  // Every so many pixels of every so many rows are used. 0: as leaves 160 to 319 columns.
  int pixel_step = 0;

  DepthRange range;

  // A frame of which less finds a partner is lost; one of which less does becomes the next keyframe. Shares in [0, 1].
  double min_overlap = 0.35;
  double keyframe_overlap = 0.7;

  // A frame is doubtful above this strain, see trust/verdict.h. 1 is what a pair of images must keep to, whose pose may
  // be anywhere; a camera that is followed is where it is expected. Of the frames of fr1/desk, which are all tracked
  // well, one reaches 2.2.
  double max_strain = 3.0;

  // After so many lost or doubtful frames on end, the next one starts a new segment of the trajectory.
  int max_lost = 10;

  // The camera is taken to go on as it moved for no longer than this, seconds; after a longer gap the last pose is the
  // guess.
  double max_extrapolation_s = 0.2;

  // Throws std::invalid_argument naming the first field out of its range.
  void check() const;
};

// The extended points of a frame. Throws std::invalid_argument where the image is not of the camera's size, and
// TooMuchMemory beyond options.registration.max_memory_gb.
Scan prepare_frame(const DepthImage& image, const DepthCamera& camera, const OdometryOptions& options);

// Tracks one camera. Its memory does not grow with the number of frames. Not for concurrent use; independent objects
// may be used concurrently.
class Odometry {
 public:
  // Throws std::invalid_argument for options out of range. readout_s: see DepthCamera.
  explicit Odometry(const OdometryOptions& options = {}, double readout_s = 0.0);

  // The next frame, prepared. Never throws for what frames or stamps are like; a frame that cannot be placed gets a
  // status and no pose, and the next one is tried again. Throws Interrupted once an end is requested through stop or
  // through the options; everything then is as before the call, and the same frame may be added again.
  FrameReport add(double stamp_s, const Scan& frame, const std::stop_token& stop = {});

  // What the next frame will be registered to, and where that lies; nothing before the first frame with readings. Valid
  // until the next add().
  const LocalModel* reference() const { return reference_ ? &*reference_ : nullptr; }
  const Rigid3& world_from_reference() const { return world_from_reference_; }

 private:
  FrameReport placed(double stamp_s, const Scan& frame, const std::stop_token& stop);
  Rigid3 predicted(double stamp_s) const;
  Scan straightened(const Scan& frame, double stamp_s, const Rigid3& world_from_camera) const;
  Scan register_frame(const Scan& frame, const RegistrationOptions& options, FrameReport& report);
  void update_reference(const Scan& frame, const FrameReport& report);
  void start_segment(const Scan& frame, FrameReport& report);

  OdometryOptions options_;
  double readout_s_;
  std::optional<LocalModel> reference_;
  std::optional<Scan> start_frame_;  // as it came, until a second one tells how the camera moved
  Rigid3 world_from_reference_;
  std::optional<StampedPose> before_last_, last_;  // of this segment
  std::optional<double> last_stamp_s_;             // of any frame
  int num_lost_ = 0;
  int segment_ = 0;
};

}  // namespace augicp
