// SPDX-License-Identifier: MIT
#include "benchmarks/stages/inputs.h"

#include <algorithm>

#include "augicp/io/depth_png.h"
#include "augicp/surface/window_surface.h"
#include "benchmarks/stages/limits.h"

namespace augicp::bench {

const DepthCamera& camera() {
  static const DepthCamera found = *camera_by_name("tum-fr1");
  return found;
}

std::vector<std::filesystem::path> image_files() {
  std::vector<std::filesystem::path> files;
  for (const DepthFrameFile& frame : read_depth_sequence(AUGICP_DATA_DIR "/tum_fr1_desk_30").frames)
    files.push_back(frame.path);
  return files;
}

DepthImage raw_image(std::size_t frame) { return read_depth_png(image_files().at(frame), 5000.0); }

DepthImage image(std::size_t frame, int step) { return rectify(raw_image(frame), camera(), step); }

OrganizedCloud points(std::size_t frame, int step) {
  return unproject(image(frame, step), thinned(camera().pinhole, step));
}

Scan extended(std::size_t frame, int step) {
  Scan scan = scan_of(image(frame, step), thinned(camera().pinhole, step));
  WindowOptions window;
  window.radius = kRadius;
  estimate_surface(scan.cloud, scan.view->index, window, {}, 0);
  return scan;
}

NewFrame::NewFrame(int step, int num_threads)
    : options_(iterations_alone()),
      seen_(image(3, step)),
      pinhole_(thinned(camera().pinhole, step)),
      target_(extended(0, step)),
      lengths_(derive_lengths(target_, target_)) {
  options_.num_threads = num_threads;
  options_.max_iterations = 10;
  options_.min_step = 0.0;
  options_.covariance = false;  // as in odometry, and as peers have none
}

AlignResult NewFrame::registered() const {
  const Scan source = prepare(scan_of(seen_, pinhole_), lengths_, options_);
  return register_prepared({source, target_, lengths_}, {}, options_);
}

Cloud cloud_of(std::size_t count) {
  Cloud cloud;
  for (std::size_t frame = 0; cloud.size() < count; ++frame) {
    const Cloud seen = points(frame % image_files().size()).cloud;
    const Vec3f shift = static_cast<float>(frame) * Vec3f(0.011f, 0.007f, 0.003f);
    for (const Vec3f& point : seen.points) cloud.points.push_back(point + shift);
  }
  cloud.points.resize(count);
  return cloud;
}

void set_counters(benchmark::State& state, const Work& work) {
  static const Limits limits = measure_limits();
  using benchmark::Counter;
  const double least_s = std::max(work.bytes / limits.bytes_per_s, work.float_operations / limits.floats_per_s);
  state.counters["items/s"] = Counter(work.items, Counter::kIsIterationInvariantRate);
  if (work.bytes > 0.0) state.counters["bytes/s"] = Counter(work.bytes, Counter::kIsIterationInvariantRate);
  if (least_s > 0.0) state.counters["of_limit"] = Counter(least_s, Counter::kIsIterationInvariantRate);
}

}  // namespace augicp::bench
