// SPDX-License-Identifier: MIT
#include "augicp/odometry/track.h"

#include <algorithm>
#include <future>
#include <stdexcept>
#include <thread>

#include "augicp/core/stop.h"
#include "augicp/registration/memory.h"

namespace augicp {
namespace {

struct PreparedFrame {
  double stamp_s = 0.0;
  Scan scan;
  std::string problem;
};

std::optional<PreparedFrame> next_prepared(FrameSource& source, const DepthCamera& camera,
                                           const OdometryOptions& options) {
  const std::optional<DepthFrame> frame = source.next();
  if (!frame) return std::nullopt;
  PreparedFrame prepared;
  prepared.stamp_s = frame->stamp_s;
  prepared.problem = frame->problem;
  if (!prepared.problem.empty()) return prepared;
  try {
    prepared.scan = prepare_frame(frame->image, camera, options);
  } catch (const TooMuchMemory&) {
    throw;  // of every frame
  } catch (const std::invalid_argument& error) {
    prepared.problem = error.what();
  }
  return prepared;
}

FrameReport report_on(const PreparedFrame& frame, Odometry& odometry, int segment) {
  if (frame.problem.empty()) return odometry.add(frame.stamp_s, frame.scan);
  return unreadable_frame(frame.stamp_s, segment, frame.problem);
}

}  // namespace

void track(FrameSource& source, const DepthCamera& camera, const OdometryOptions& options,
           const std::function<void(const FrameReport&)>& on_frame) {
  track(source, camera, options, [&](const FrameReport& report, const Odometry&) { on_frame(report); });
}

void track(FrameSource& source, const DepthCamera& camera, const OdometryOptions& options,
           const std::function<void(const FrameReport&, const Odometry&)>& on_frame) {
  camera.check();
  const int wanted = options.registration.num_threads;
  const int num_threads = wanted > 0 ? wanted : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  // Preparing a frame costs about as much as registering it.
  OdometryOptions preparing = options, registering = options;
  preparing.registration.stop = {};  // only `registering` stops: between frames and during a registration
  preparing.registration.num_threads = std::max(1, num_threads / 2);
  registering.registration.num_threads = std::max(1, num_threads - num_threads / 2);
  const auto policy = num_threads > 1 ? std::launch::async : std::launch::deferred;
  const auto prepare_next = [&] { return next_prepared(source, camera, preparing); };

  Odometry odometry(registering, camera.readout_s);
  int segment = 0;
  for (std::optional<PreparedFrame> frame = prepare_next(); frame;) {
    throw_if_stopped(options.registration.stop);
    std::future<std::optional<PreparedFrame>> following = std::async(policy, prepare_next);
    const FrameReport report = report_on(*frame, odometry, segment);
    segment = report.segment;
    on_frame(report, odometry);
    frame = following.get();
  }
}

}  // namespace augicp
