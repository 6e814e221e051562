// SPDX-License-Identifier: MIT
// Table 3 of the paper: pairs of images of one sequence, some frames apart, registered from the identity.
#pragma once

#include <functional>
#include <vector>

#include "augicp/io/depth_sequence.h"
#include "augicp/registration/options.h"

namespace augicp {

// Which points surfaces are estimated from.
enum class Surroundings {
  Window,  // registration's own, see WindowNeighbourhood
  Square,  // see SquareNeighbourhood
  Ball,    // see ExactWindowNeighbourhood; slow
};

struct SequenceOptions {
  std::vector<std::size_t> gaps{1, 10, 20};  // frames from target to source, each at least 1
  std::vector<Preset> presets{Preset::Default, Preset::Paper};
  std::vector<Method> methods{Method::Point, Method::Plane, Method::Gicp, Method::Augmented};
  Surroundings surroundings = Surroundings::Window;
  int iterations = 10;  // exactly so many

  // Targets are every so many frames of those that have a source at every gap, and then, evenly spread, at most so many
  // of these. 0: all.
  std::size_t every = 1;
  std::size_t max_targets = 0;

  int pixel_step = 1;  // every so many pixels of every so many rows

  // What all registrations share: its preset, method, association, iterations and least step are not used. Where it has
  // no radius, each frame has its own, see derive_lengths(). The result is the same for any number of threads.
  // What comes before the iterations is off, so that methods compare iteration by iteration.
  RegistrationOptions registration = iterations_alone();

  // Where registrations start: at the motion of a trajectory, read at the stamps + an offset; not set, or where it has
  // none: the identity.
  struct Guess {
    Trajectory trajectory;
    double time_offset_s = 0.0;
  };
  std::optional<Guess> guess;

  // Throws std::invalid_argument naming the first option out of its range.
  void check() const;
};

// One registration.
struct SequenceCurve {
  std::size_t target = 0, source = 0;  // numbers of the frames; the gap is their difference
  double target_stamp_s = 0.0, source_stamp_s = 0.0;
  Preset preset = Preset::Default;
  Method method = Method::Augmented;
  AlignStatus status = AlignStatus::TooFewPairs;
  std::vector<Rigid3>
      path;  // target_from_source: the guess, and after each iteration; a run that had to stop repeats its last

  std::size_t gap() const { return source - target; }
};

// The targets asked for. Throws std::invalid_argument where the sequence is not longer than the largest gap.
std::vector<std::size_t> chosen_targets(std::size_t num_frames, const SequenceOptions& options);

// In the order of targets, gaps, presets, methods. Surfaces are estimated once a frame and preset and kept while they
// are needed; the search for pairs is the same for all methods. on_target is called after each target. Throws IoError
// where an image cannot be read.
std::vector<SequenceCurve> run_sequence(const DepthSequence& sequence, const DepthCamera& camera,
                                        const SequenceOptions& options, const std::function<void()>& on_target);

}  // namespace augicp
