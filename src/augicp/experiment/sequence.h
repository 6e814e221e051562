// SPDX-License-Identifier: MIT
// Table 3 of the paper: pairs of images of one sequence, some frames apart, registered from the identity.
#pragma once

#include <functional>
#include <vector>

#include "augicp/io/depth_sequence.h"
#include "augicp/registration/options.h"

namespace augicp {

// The neighbourhood for surface estimation.
enum class Surroundings {
  Window,  // the default of registration, see WindowNeighbourhood
  Square,  // see SquareNeighbourhood
  Ball,    // see ExactWindowNeighbourhood; slow
};
template <>
inline constexpr auto kWords<Surroundings> = std::to_array<Word<Surroundings>>({{Surroundings::Window, "window"},
                                                                                {Surroundings::Square, "square"},
                                                                                {Surroundings::Ball, "ball"}});

struct SequenceOptions {
  std::vector<std::size_t> gaps{1, 10, 20};  // frames from target to source, each at least 1
  std::vector<Preset> presets{Preset::Default, Preset::Paper};
  std::vector<Method> methods{Method::Point, Method::Plane, Method::Ndt, Method::Gicp, Method::Augmented};
  Surroundings surroundings = Surroundings::Window;
  int iterations = 10;  // exact number

  // Targets are every N-th of the frames that have a source at every gap, and then at most max_targets of these, evenly
  // spread. 0: all.
  std::size_t every = 1;
  std::size_t max_targets = 0;

  int pixel_step = 1;  // use every N-th pixel of every N-th row

  // Options shared by all registrations; preset, method, association, iterations and least step are not used. Without a
  // radius each frame has its own, see derive_lengths(). Bit-identical for any number of threads. The steps before the
  // iterations are off, so that methods compare iteration by iteration.
  RegistrationOptions registration = iterations_alone();

  // Start of the registrations: the motion of a trajectory, read at the stamps + an offset. Empty, or if the trajectory
  // has none: the identity.
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
  std::vector<Rigid3> path;  // target_from_source: the guess, and the pose after each iteration; a run that had to stop
                             // repeats its last pose

  std::size_t gap() const { return source - target; }
};

// The selected targets. Throws std::invalid_argument if the sequence is not longer than the largest gap.
std::vector<std::size_t> chosen_targets(std::size_t num_frames, const SequenceOptions& options);

// In the order of targets, gaps, presets, methods. Surfaces are estimated once per frame and preset, and kept while
// needed. The search for pairs is the same for all methods. on_target is called after each target. Throws IoError if an
// image cannot be read.
std::vector<SequenceCurve> run_sequence(const DepthSequence& sequence, const DepthCamera& camera,
                                        const SequenceOptions& options, const std::function<void()>& on_target);

}  // namespace augicp
