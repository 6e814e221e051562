// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <stop_token>

#include "augicp/align/align.h"
#include "augicp/core/words.h"
#include "augicp/registration/lengths.h"
#include "augicp/registration/stage.h"
#include "augicp/surface/estimate_surface.h"

namespace augicp {

// The objective: the same code with other numbers (objective/information.h). Under the default preset, with nearest
// neighbours, the positions of augmented and gicp have the information of both points. Along lines of sight, and under
// the paper's preset, they have that of the target's point. Ndt: the Gaussian around the target's point, Eq. (2).
enum class Method { Augmented, Gicp, Plane, Point, Ndt };
template <>
inline constexpr auto kWords<Method> = std::to_array<Word<Method>>({{Method::Augmented, "augmented"},
                                                                    {Method::Gicp, "gicp"},
                                                                    {Method::Plane, "plane"},
                                                                    {Method::Point, "point"},
                                                                    {Method::Ndt, "ndt"}});

enum class Preset {
  Default,  // weights, kernel and classifier from measured noise
  Paper,    // the paper: Table 2 as printed, structure from the points' eigenvalues, a fixed K
};
template <>
inline constexpr auto kWords<Preset> = std::to_array<Word<Preset>>({{Preset::Default, "default"},
                                                                    {Preset::Paper, "paper"}});

// How pairs are found.
enum class Association {
  Auto,        // Projective if the target is a depth image, else Nearest
  Projective,  // through the target's camera
  Nearest,     // the nearest target point
};
template <>
inline constexpr auto kWords<Association> = std::to_array<Word<Association>>({{Association::Auto, "auto"},
                                                                              {Association::Projective, "projective"},
                                                                              {Association::Nearest, "nearest"}});

struct RegistrationOptions {
  Preset preset = Preset::Default;
  Method method = Method::Augmented;
  Association association = Association::Auto;

  // Metres; if not set: derived from the clouds, see derive_lengths().
  std::optional<double> radius;
  std::optional<double> voxel_size;
  std::optional<double> max_distance;

  // Pairs whose directions differ by more are dropped, radians.
  double max_angle = 1.0471975511965976;  // 60 degrees

  // Overrides of the preset. If not set: the preset's value.
  std::optional<Classifier> classifier;
  std::optional<double> kernel_chi2;  // K of Eq. (13), the same in all iterations
  std::optional<double> lever;        // metres, the same in all iterations; see AlignOptions
  std::optional<double> damping;      // see AlignOptions

  // Beyond the paper, and off under its preset.
  bool search = true;          // if the guess does not convince, others are tried: see search_starts(), global_starts()
  bool global = false;         // there is no guess: the pose is searched among all, see global_starts()
  bool coarse_to_fine = true;  // large images are aligned at a coarse resolution first
  bool rolling_shutter = true;  // the distortion of rolling shutters is removed, see ReadoutMotion

  // Clouds are aligned once more in smaller balls, from the pose that was found; kept if that is more certain, see
  // with_final_pass(). Between clouds with derived lengths, if the covariance is computed. It takes about as long as
  // the first alignment without its search.
  bool final_pass = true;

  // A third measurement, if both inputs have intensities: their brightness, see objective/intensity.h. At full
  // resolution only, so that the search and the coarse alignments do not depend on it.
  bool intensity = false;

  // Compute AlignResult::covariance. Without it a registration takes a twentieth less time for large images, and a
  // fifth less for small ones.
  bool covariance = true;

  int max_iterations = 50;  // at full resolution

  // Steps below this share of the extent, and below this in radians, end the loop. 0: all iterations are made.
  double min_step = 1e-5;

  int num_threads = 0;  // 0: all of the machine

  // 10^9 bytes. Clouds are refused before their surfaces are estimated if that is expected to need more, see
  // require_memory(). Not set: half of the machine's memory. Infinity: no bound.
  std::optional<double> max_memory_gb;

  // Called in the thread that called the registration, at the beginning and at the end of what each stage does. What it
  // throws ends the registration and reaches the caller. Empty: nobody listens.
  StageListener on_stage{};

  // Checked before each stage of prepare(), each start and each iteration: the call throws Interrupted once any thread
  // requests an end.
  std::stop_token stop{};

  // Throws std::invalid_argument naming the first option out of its range.
  void check() const;
};

// The paper's loop alone: its iterations from the guess, at full resolution.
RegistrationOptions iterations_alone();

// The lengths to use: those that are set, the others derived.
Lengths lengths_for(const Scan& source, const Scan& target, const RegistrationOptions& options);

// The objective before a lever weighs it; epsilon: the softening of Table 2. Of Method::Ndt: discs instead of
// Gaussians, whose softening is fixed.
InformationModel information_for(const RegistrationOptions& options, double epsilon = kTable2Epsilon);

SurfaceOptions surface_options(const RegistrationOptions& options);
AlignOptions align_options(const Lengths& lengths, bool projective, const RegistrationOptions& options);

// Of pairs that no search has found and that may nearly all be false, as those of descriptors. The paper's preset has
// the same options for them.
AlignOptions known_pairs_options(const Lengths& lengths, const RegistrationOptions& options);

}  // namespace augicp
