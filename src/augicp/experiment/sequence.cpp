// SPDX-License-Identifier: MIT
#include "augicp/experiment/sequence.h"

#include <algorithm>

#include "augicp/core/check.h"
#include "augicp/experiment/prepared_frames.h"

namespace augicp {
namespace {

RegistrationOptions registration_options(Preset preset, Method method, const SequenceOptions& options) {
  RegistrationOptions registration = frame_options(preset, options);
  registration.method = method;
  registration.association = Association::Projective;
  registration.max_iterations = options.iterations;
  registration.min_step = 0.0;
  return registration;
}

Rigid3 guess_for(const SequenceCurve& curve, const SequenceOptions& options) {
  constexpr double kMaxGap_s = 0.1;
  if (!options.guess) return {};
  const auto& [trajectory, offset_s] = *options.guess;
  const auto target = pose_at(trajectory, curve.target_stamp_s + offset_s, kMaxGap_s),
             source = pose_at(trajectory, curve.source_stamp_s + offset_s, kMaxGap_s);
  return target && source ? inverse(*target) * *source : Rigid3{};
}

std::vector<Rigid3> path_of(const AlignResult& result, const Rigid3& guess, int iterations) {
  std::vector<Rigid3> path{guess};
  for (const AlignIteration& iteration : result.history) path.push_back(iteration.target_from_source);
  path.resize(static_cast<std::size_t>(iterations) + 1, path.back());
  return path;
}

SequenceCurve run_pair(const PreparedFrame& source, const PreparedFrame& target, std::size_t preset, Method method,
                       const SequenceOptions& options) {
  SequenceCurve curve;
  curve.target_stamp_s = target.stamp_s;
  curve.source_stamp_s = source.stamp_s;
  curve.preset = options.presets[preset];
  curve.method = method;
  const RegistrationOptions registration = registration_options(curve.preset, method, options);
  const Scan& from = source.scans[preset];
  const Scan& to = target.scans[preset];
  const Rigid3 guess = guess_for(curve, options);
  const AlignResult result = register_prepared({from, to, lengths_for(from, to, registration)}, guess, registration);
  curve.status = result.status;
  curve.path = path_of(result, guess, options.iterations);
  return curve;
}

void require_some(bool any, const char* name) { require(any, name, 0.0, "expected some, found none"); }

}  // namespace

void SequenceOptions::check() const {
  require_some(!gaps.empty(), "gaps");
  require_some(!presets.empty(), "presets");
  require_some(!methods.empty(), "methods");
  for (const std::size_t gap : gaps) require(gap >= 1, "gaps", static_cast<double>(gap), "must be at least 1");
  require(iterations > 0, "iterations", iterations, "must be at least 1");
  require(every >= 1, "every", static_cast<double>(every), "must be at least 1");
  require(pixel_step >= 1, "pixel_step", pixel_step, "must be at least 1");
  registration.check();
}

std::vector<std::size_t> chosen_targets(std::size_t num_frames, const SequenceOptions& options) {
  const std::size_t largest = *std::max_element(options.gaps.begin(), options.gaps.end());
  require(num_frames > largest, "gaps", static_cast<double>(largest),
          "must be less than the frames of the sequence, " + std::to_string(num_frames));
  std::vector<std::size_t> targets;
  for (std::size_t i = 0; i + largest < num_frames; i += options.every) targets.push_back(i);
  if (options.max_targets == 0 || options.max_targets >= targets.size()) return targets;
  if (options.max_targets == 1) return {targets.front()};
  std::vector<std::size_t> spread;
  for (std::size_t k = 0; k < options.max_targets; ++k)
    spread.push_back(targets[k * (targets.size() - 1) / (options.max_targets - 1)]);
  return spread;
}

std::vector<SequenceCurve> run_sequence(const DepthSequence& sequence, const DepthCamera& camera,
                                        const SequenceOptions& options, const std::function<void()>& on_target) {
  options.check();
  PreparedFrames frames(sequence, camera, options);
  std::vector<SequenceCurve> curves;
  for (const std::size_t target : chosen_targets(sequence.frames.size(), options)) {
    frames.forget_before(target);
    for (const std::size_t gap : options.gaps)
      for (std::size_t preset = 0; preset < options.presets.size(); ++preset)
        for (const Method method : options.methods) {
          curves.push_back(run_pair(frames.at(target + gap), frames.at(target), preset, method, options));
          curves.back().target = target;
          curves.back().source = target + gap;
        }
    on_target();
  }
  return curves;
}

}  // namespace augicp
