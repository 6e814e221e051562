// SPDX-License-Identifier: MIT
#include "augicp/experiment/prepared_frames.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "augicp/core/error.h"
#include "augicp/surface/gaussians.h"
#include "augicp/surface/square_neighbourhood.h"

namespace augicp {
namespace {

// Registration estimates only missing surfaces. This estimates the kinds that it does not.
void estimate_unusual_surface(Scan& scan, const Lengths& lengths, const RegistrationOptions& registration,
                              Surroundings surroundings) {
  if (surroundings == Surroundings::Window || scan.cloud.empty() || !(lengths.radius > 0.0)) return;
  WindowOptions window;
  window.radius = lengths.radius;
  std::unique_ptr<Neighbourhood> neighbourhood;
  if (surroundings == Surroundings::Square)
    neighbourhood = std::make_unique<SquareNeighbourhood>(scan.cloud, scan.view->index, window, scan.view->camera.fx);
  else
    neighbourhood =
        std::make_unique<ExactWindowNeighbourhood>(scan.cloud, scan.view->index, window, registration.num_threads);
  estimate_surface(scan.cloud, *neighbourhood, surface_options(registration), registration.num_threads);
  if (registration.method == Method::Ndt)
    estimate_gaussians(scan.cloud, *neighbourhood, lengths.radius, registration.num_threads);
}

}  // namespace

RegistrationOptions frame_options(Preset preset, const SequenceOptions& options) {
  RegistrationOptions registration = options.registration;
  registration.preset = preset;
  // Preparing for it suffices for all others.
  if (std::count(options.methods.begin(), options.methods.end(), Method::Ndt) > 0) registration.method = Method::Ndt;
  return registration;
}

const PreparedFrame& PreparedFrames::at(std::size_t frame) {
  const auto found = frames_.find(frame);
  return found != frames_.end() ? found->second : frames_.emplace(frame, made(frame)).first->second;
}

PreparedFrame PreparedFrames::made(std::size_t frame) const {
  DepthSequenceReader reader({sequence_.frames[frame]}, sequence_.depth_scale);
  const std::optional<DepthFrame> read = reader.next();
  if (!read->problem.empty()) throw IoError(read->problem);
  const Scan raw = scan_of(read->image, camera_, options_.pixel_step);
  PreparedFrame prepared{read->stamp_s, {}};
  for (const Preset preset : options_.presets) {
    const RegistrationOptions registration = frame_options(preset, options_);
    const Lengths lengths = lengths_for(raw, raw, registration);
    Scan scan = raw;
    estimate_unusual_surface(scan, lengths, registration, options_.surroundings);
    prepared.scans.push_back(prepare(std::move(scan), lengths, registration));
  }
  return prepared;
}

}  // namespace augicp
